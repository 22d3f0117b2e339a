#include "resultfiles/static/results_reader.h"

#include <gtest/gtest.h>

#include "resultfiles/static/results_writer.h"
#include "results/fields/ground_fields.h"
#include "results/fields/lay_operation_fields.h"
#include "results/fields/route_fields.h"
#include "results/fields/static_scalars.h"
#include "results/fields/static_tables.h"
#include "results/operation_results.h"
#include "support/lay_bits.h"
#include "support/result_visitors.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::kListBytes;
using testing::result_bits;
using testing::SizeVisitor;
using testing::solved_case;
using testing::TemporaryFolder;

TEST(field_lists, hold_every_member_of_the_tables) {
  SizeVisitor station, roller, row, support, section, structure;
  visit_station<const Station>(Station{}, station);
  visit_roller<const RollerResult>(RollerResult{}, roller);
  visit_row<const RowResult>(RowResult{}, row);
  visit_support<const SupportResult>(SupportResult{}, support);
  visit_section<const DerivedSection>(DerivedSection{}, section);
  EXPECT_EQ(station.bytes, sizeof(Station));
  EXPECT_EQ(roller.bytes, sizeof(RollerResult));
  EXPECT_EQ(row.bytes + kListBytes, sizeof(RowResult));
  EXPECT_EQ(support.bytes + kListBytes, sizeof(SupportResult));
  EXPECT_EQ(section.bytes, sizeof(DerivedSection));
  visit_structure<const StructureResult>(StructureResult{}, structure);
  EXPECT_EQ(structure.bytes, sizeof(StructureResult));
}

TEST(field_lists, hold_every_member_of_a_route_and_of_a_limit_of_friction) {
  SizeVisitor route, limit;
  visit_route<const RouteResults>(RouteResults{}, route);
  visit_friction_case<const RollerFrictionCase>(RollerFrictionCase{}, limit);
  EXPECT_EQ(route.bytes, sizeof(RouteResults));
  EXPECT_EQ(limit.bytes, sizeof(RollerFrictionCase));
}

TEST(field_lists, hold_every_member_of_a_check) {
  SizeVisitor row, input, line, along, design;
  visit_check<const CheckRow>(CheckRow{}, row);
  visit_check_input<const CheckInput>(CheckInput{}, input);
  visit_sheet_line<const SheetLine>(SheetLine{}, line);
  visit_check_along<const CheckAlong>(CheckAlong{}, along);
  visit_station_design<const StationDesign>(StationDesign{}, design);
  constexpr std::size_t kShared = 8;  // region and status, two words, share eight bytes
  EXPECT_EQ(row.bytes + 2 * kListBytes - kShared, sizeof(CheckRow));
  EXPECT_EQ(line.bytes, sizeof(SheetLine));
  EXPECT_EQ(input.bytes, sizeof(CheckInput));
  EXPECT_EQ(along.bytes, sizeof(CheckAlong));
  EXPECT_EQ(design.bytes, sizeof(StationDesign));
}

TEST(field_lists, hold_every_single_value) {
  const StaticResults results;
  SizeVisitor all, touchdown, solve, extreme;
  visit_key_results(results, all);
  visit_sums(results, all);
  visit_scene(results, all);
  visit_touchdown(results.touchdown, touchdown);
  visit_solve(results.solve, solve);
  visit_extreme_fields<const Extreme>(ResultField{}, Extreme{}, extreme);
  int extremes = 0;
  visit_region(results.sagbend, [&](const ResultField&, const Extreme&) { ++extremes; });
  EXPECT_EQ(all.bytes + sizeof(results.touchdown) + sizeof(results.solve) + sizeof(results.overbend) +
                sizeof(results.tower) + sizeof(results.min_effective_tension) + sizeof(results.sagbend) + kListBytes +
                kListBytes + kListBytes + kListBytes + sizeof(results.points) + sizeof(results.wires) +
                sizeof(results.sum_attached) + sizeof(results.checks) + sizeof(results.moorings) +
                sizeof(results.hull) + sizeof(results.head) + sizeof(results.cable) + sizeof(results.far_anchor) +
                sizeof(results.stinger) + sizeof(results.bed) + sizeof(results.route) +
                sizeof(results.roller_friction) + sizeof(results.lines) + sizeof(results.bodies) +
                sizeof(results.lift) + sizeof(results.dragging),
            sizeof(StaticResults));
  EXPECT_EQ(touchdown.bytes, sizeof(Touchdown));
  EXPECT_EQ(solve.bytes, sizeof(SolveReport));
  EXPECT_EQ(extreme.bytes, sizeof(Extreme));
  EXPECT_EQ(extremes * sizeof(Extreme), sizeof(RegionResult));
}

StoredStatics through_file(const StaticResults& results, const Description& description) {
  const TemporaryFolder folder;
  write_static_hdf5(results, description, folder / "results.h5");
  return read_static_results(folder / "results.h5");
}

TEST(results_reader, gives_back_an_s_lay_bit_for_bit) {
  const auto& [description, results] = solved_case("BGL1-T250");
  const StoredStatics stored = through_file(results, description);
  EXPECT_EQ(result_bits(stored.results), result_bits(results));
  EXPECT_EQ(stored.model_text, testing::file_text(testing::case_file("BGL1-T250")));
  EXPECT_GT(stored.results.checks.rows.size(), 10U);
}

TEST(results_reader, gives_back_a_j_lay_without_supports_and_overbend) {
  const auto& [description, results] = solved_case("J12-D400-T560");
  const StoredStatics stored = through_file(results, description);
  EXPECT_EQ(result_bits(stored.results), result_bits(results));
  EXPECT_FALSE(stored.results.overbend);
  EXPECT_FALSE(stored.results.stinger_tip_clearance);
  EXPECT_TRUE(stored.results.supports.empty());
}

TEST(results_reader, gives_back_the_tower_of_a_j_lay_and_the_part_of_the_current) {
  auto [description, results] = solved_case("J12-D400-T560");
  results.tower = results.sagbend;
  results.tower->von_mises.value = 1.5e9;
  results.stations.back().region = Region::tower;
  results.stations.back().current_lateral_moment = -7.0;
  EXPECT_EQ(result_bits(through_file(results, description).results), result_bits(results));
}

TEST(field_lists, hold_every_member_of_head_cable_anchor_and_stage) {
  SizeVisitor head, cable, anchor, stage, failure;
  visit_head<const HeadResult>(HeadResult{}, head);
  visit_cable<const CableResult>(CableResult{}, cable);
  visit_far_anchor<const StartUpAnchorResult>(StartUpAnchorResult{}, anchor);
  visit_lay_stage<const LayStageDescription>(LayStageDescription{}, stage);
  visit_stage_failure<const StageFailure>(StageFailure{}, failure);
  EXPECT_EQ(head.bytes, sizeof(HeadResult));
  EXPECT_EQ(cable.bytes, sizeof(CableResult));
  EXPECT_EQ(anchor.bytes, sizeof(StartUpAnchorResult));
  const LayStageDescription none;  // what a lift asks of its lines is in the model's text
  EXPECT_EQ(stage.bytes + sizeof(none.lengths) + sizeof(none.tensions) + sizeof(none.vessel) + sizeof(none.bodies) +
                sizeof(none.join),
            sizeof(LayStageDescription));
  EXPECT_EQ(failure.bytes, sizeof(StageFailure));
}

TEST(results_reader, gives_back_head_cable_and_anchor_and_the_stage_they_are_of) {
  auto [description, results] = solved_case("J12-D400-T560");
  results.head = HeadResult{Vec3(-400.0, 1.0, -380.25), 340.0, 0.3, 0.4, 95e3, 19.5, 812.0};
  results.cable = CableResult{430.0, 200e3, 0.05, 1.2};
  results.far_anchor = StartUpAnchorResult{900.0, 205e3, -0.0};
  description.stage = LayStageDescription{"bed", 430.0, {}, {}, {}, 200e3, {}, {}, {}};
  const StoredStatics stored = through_file(results, description);
  EXPECT_EQ(result_bits(stored.results), result_bits(results));
  ASSERT_TRUE(stored.results.head && stored.results.cable && stored.results.far_anchor && stored.stage);
  EXPECT_EQ(stored.stage->name, "bed");
  EXPECT_EQ(stored.stage->cable_out, 430.0);
  EXPECT_FALSE(stored.stage->pipe_out);
  EXPECT_FALSE(through_file(results, {}).stage);
}

TEST(results_reader, gives_back_structures_in_the_line) {
  StaticResults results = solved_case("BGL1-T250").results;
  StructureResult& tee = results.structures.emplace_back();
  tee.name = "tee";
  tee.from_top = 51.25;
  tee.lower.strain = 1.5e-3;
  tee.upper.bending_moment = -7.0;
  results.structures.push_back(tee);
  results.structures.back().support = "ramp 1";
  EXPECT_EQ(result_bits(through_file(results, {}).results), result_bits(results));
}

TEST(field_lists, hold_every_member_of_the_laid_pipe) {
  SizeVisitor contact, span, height, all;
  visit_bed_contact<const BedContactResult>(BedContactResult{}, contact);
  visit_free_span<const FreeSpanResult>(FreeSpanResult{}, span);
  visit_bed_height<const BedHeight>(BedHeight{}, height);
  visit_laid_pipe<const BedResults>(BedResults{}, all);
  EXPECT_EQ(contact.bytes, sizeof(BedContactResult));
  EXPECT_EQ(span.bytes, sizeof(FreeSpanResult));
  EXPECT_EQ(height.bytes, sizeof(BedHeight));
  EXPECT_EQ(all.bytes + 3 * kListBytes, sizeof(BedResults));
}

TEST(results_reader, gives_back_the_laid_pipe_on_an_uneven_bed) {
  StaticResults results = solved_case("S16-T300").results;
  BedResults& bed = results.bed.emplace();
  bed.heights = {{0.0, -89.0}, {2.0, -89.25}};
  bed.contacts = {{350.0, 360.5, 400.0, 389.0, 0.03}, {380.0, 500.0, 368.0, 1.0, 0.02}};
  bed.spans = {{360.5, 380.0, 389.0, 368.0, 19.75, 0.5, 371.0, 44e3, 370.0, 12e6}};
  bed.max_penetration = 0.03;
  bed.hogging_moment = 91e3;
  bed.tail_tension = 251e3;
  EXPECT_EQ(result_bits(through_file(results, {}).results), result_bits(results));
  EXPECT_EQ(through_file(results, {}).results.bed.value().spans.size(), 1U);
  EXPECT_FALSE(through_file(solved_case("S16-T300").results, {}).results.bed);
}

TEST(results_reader, gives_back_the_route_and_the_limits_of_friction) {
  StaticResults results = solved_case("BGL1-T250").results;
  results.route = RouteResults{1500.0, 1116.5, false, -3.25, 402.0, 64.5, 11.1, 40.0, 43.3e3};
  results.roller_friction = {{"lay", 250e3, 206e3, 335.0, 0.21, 0.071, 330e6, 74e6, 48e3},
                             {"haul", 250e3, 205e3, 334.0, 0.22, 0.0, 331e6, 75e6, 49e3}};
  const StaticResults back = through_file(results, {}).results;
  EXPECT_EQ(result_bits(back), result_bits(results));
  ASSERT_TRUE(back.route);
  EXPECT_FALSE(back.route->holds);
  EXPECT_EQ(back.route->side_load_supports, 43.3e3);
  ASSERT_EQ(back.roller_friction.size(), 2U);
  EXPECT_EQ(back.roller_friction[1].name, "haul");
}

TEST(results_reader, keeps_rollers_with_their_rows_and_boxes) {
  StaticResults results = solved_case("BGL1-T250").results;
  RollerResult port;
  port.position = RollerPosition::port;
  port.lateral = -3.25;
  results.supports.at(1).rows.at(0).rollers.push_back(port);
  RowResult second;
  second.rollers.resize(3);
  second.rollers[2].position = RollerPosition::starboard;
  results.supports.at(1).rows.push_back(second);
  results.supports.at(1).has_sides = true;
  results.title = "Größe \"A\", 16\xe2\x80\xb3";
  EXPECT_EQ(result_bits(through_file(results, {}).results), result_bits(results));
}

TEST(results_reader, rejects_a_file_that_is_none_of_ours) {
  const TemporaryFolder folder;
  testing::write_file(folder / "a.h5", "not HDF5");
  EXPECT_THROW(read_static_results(folder / "a.h5"), std::runtime_error);
  EXPECT_THROW(read_static_results(folder / "missing.h5"), std::runtime_error);
}

}  // namespace
}  // namespace overbend
