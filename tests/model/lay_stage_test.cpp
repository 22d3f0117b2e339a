#include "model/lay_stage.h"

#include <gtest/gtest.h>

#include "model/model.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

/// A lay whose first 12 m of pipe are a segment, with an arrestor of 3 m in it.
Description lay_with_segment() {
  Description d = testing::plain_description();
  d.pipe.segments = {{"thick end", 12.0, d.pipe.section}};
  StructureDescription arrestor;
  arrestor.name = "arrestor";
  arrestor.at = 6.0;
  arrestor.length = 3.0;
  arrestor.weight_in_air = 30e3;
  arrestor.weight_submerged = 18e3;
  d.pipe.structures = {arrestor};
  CableDescription& cable = d.operation.lay.cable.emplace();
  cable.diameter = 0.076;
  cable.weight_in_air = 240.0;
  cable.weight_submerged = 205.0;
  cable.axial_stiffness = 270e6;
  cable.length = 300.0;
  HeadDescription& head = d.operation.lay.head.emplace();
  head.length = 5.0;
  head.weight_in_air = 30e3;
  head.weight_submerged = 24e3;
  d.operation.lay.anchor.emplace().depth = 88.9;
  return d;
}

LayStageDescription with_cable_out(double length) {
  LayStageDescription stage;
  stage.cable_out = length;
  return stage;
}

LayStageDescription with_pipe_out(double length) {
  LayStageDescription stage;
  stage.pipe_out = length;
  return stage;
}

const std::string& name_at(const Model& model, double from_top) {
  return model.sections[static_cast<std::size_t>(model.section_at(from_top))].name;
}

/// Segment and arrestor as they lie when the pipe's end is `out` from the top.
void expect_segment(const Model& model, double out) {
  EXPECT_EQ(name_at(model, out + 4.4), "thick end");
  EXPECT_EQ(name_at(model, out + 4.6), "arrestor");
  EXPECT_EQ(name_at(model, out + 7.4), "arrestor");
  EXPECT_EQ(name_at(model, out + 7.6), "thick end");
  EXPECT_EQ(name_at(model, out + 11.9), "thick end");
  EXPECT_EQ(name_at(model, out + 12.1), "pipe");
}

TEST(lay_stage, segments_and_structures_are_suspended_below_cable_and_head) {
  Description d = lay_with_segment();
  for (const OperationType type : {OperationType::abandonment, OperationType::lay_down, OperationType::recovery}) {
    d.operation.type = type;
    const Model model = build_model(make_stage_description(d, with_cable_out(60.0)));
    EXPECT_EQ(model.kind_at(59.9), SectionKind::cable);
    EXPECT_EQ(model.kind_at(64.9), SectionKind::head);
    EXPECT_EQ(name_at(model, 65.1), "thick end");
    expect_segment(model, 65.0);
  }
}

TEST(lay_stage, no_structure_takes_the_place_of_the_head) {
  Description d = lay_with_segment();
  d.operation.type = OperationType::abandonment;
  d.pipe.structures[0].at = 0.5;
  const Model model = build_model(make_stage_description(d, with_cable_out(60.0)));
  EXPECT_EQ(model.kind_at(64.9), SectionKind::head);
  EXPECT_EQ(name_at(model, 65.1), "arrestor");
  EXPECT_EQ(name_at(model, 66.9), "arrestor");
  EXPECT_EQ(name_at(model, 67.1), "thick end");
}

// The lay as described is what a start-up leads to.
TEST(lay_stage, pipe_of_a_start_up_comes_out_of_the_tensioner_as_it_lies_at_the_last_stage) {
  Description d = lay_with_segment();
  d.operation.type = OperationType::start_up;
  d.pipe.segments.push_back({"first pipe", 20.0, d.pipe.section});
  d.operation.lay.stages = {with_pipe_out(80.0), with_pipe_out(95.0), with_pipe_out(100.0)};
  const Model last = build_model(make_stage_description(d, d.operation.lay.stages[2]));
  EXPECT_EQ(name_at(last, 3.0), "thick end");
  EXPECT_EQ(name_at(last, 6.0), "arrestor");
  EXPECT_EQ(name_at(last, 31.0), "first pipe");
  EXPECT_EQ(name_at(last, 33.0), "pipe");
  const Model before = build_model(make_stage_description(d, d.operation.lay.stages[1]));
  EXPECT_EQ(name_at(before, 0.1), "arrestor");  // half of it is out
  EXPECT_EQ(name_at(before, 2.4), "arrestor");
  EXPECT_EQ(name_at(before, 6.9), "thick end");
  EXPECT_EQ(name_at(before, 26.9), "first pipe");
  EXPECT_EQ(name_at(before, 27.1), "pipe");
  const Model first = build_model(make_stage_description(d, d.operation.lay.stages[0]));
  EXPECT_EQ(name_at(first, 0.1), "first pipe");
  EXPECT_EQ(name_at(first, 12.1), "pipe");
  EXPECT_EQ(first.kind_at(80.1), SectionKind::head);
}

TEST(lay_stage, segments_longer_than_the_pipe_of_a_start_up_end_at_its_head) {
  Description d = lay_with_segment();
  d.operation.type = OperationType::start_up;
  d.pipe.segments[0].length = 150.0;
  d.operation.lay.stages = {with_pipe_out(80.0), with_pipe_out(100.0)};
  for (const LayStageDescription& stage : d.operation.lay.stages) {
    const Model model = build_model(make_stage_description(d, stage));
    EXPECT_EQ(name_at(model, *stage.pipe_out - 0.1), "thick end");
    EXPECT_EQ(model.kind_at(*stage.pipe_out + 0.1), SectionKind::head);
    EXPECT_EQ(model.kind_at(*stage.pipe_out + 5.1), SectionKind::cable);
  }
}

// Joints of 12 m, 0.6 m of each bare; the first is 2 m from the tensioner in the lay as described.
TEST(lay_stage, field_joints_go_with_the_pipe) {
  Description d = lay_with_segment();
  d.pipe.segments.clear();
  d.pipe.structures.clear();
  d.pipe.section.joint = JointDescription{12.0, 0.6, 0.0, 1.3};
  d.pipe.section.joint->first = 2.0;
  d.supports.boxes.push_back({});
  d.supports.boxes.back().x = d.tensioner.x + 120.0;
  const std::string coated = "coated pipe between field joints";
  const auto expect_joint = [&](const Model& model, double middle) {
    EXPECT_EQ(name_at(model, middle - 0.4), coated) << middle;
    EXPECT_EQ(name_at(model, middle), "pipe") << middle;
    EXPECT_EQ(name_at(model, middle + 0.4), coated) << middle;
  };
  d.operation.type = OperationType::abandonment;
  const Model below = build_model(make_stage_description(d, with_cable_out(55.0)));
  EXPECT_EQ(name_at(below, 60.1), coated);
  for (const double middle : {62.0, 74.0, 86.0}) expect_joint(below, middle);
  d.operation.type = OperationType::start_up;
  d.operation.lay.stages = {with_pipe_out(93.0), with_pipe_out(100.0)};
  const Model last = build_model(make_stage_description(d, d.operation.lay.stages[1]));
  for (const double middle : {2.0, 14.0, 26.0}) expect_joint(last, middle);
  const Model before = build_model(make_stage_description(d, d.operation.lay.stages[0]));
  for (const double middle : {7.0, 19.0}) expect_joint(before, middle);
}

}  // namespace
}  // namespace overbend
