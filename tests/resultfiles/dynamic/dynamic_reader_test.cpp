#include "resultfiles/dynamic/dynamic_reader.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/static/results_writer.h"
#include "results/fields/dynamic_scalars.h"
#include "support/dynamic_case.h"
#include "support/result_visitors.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::BitsVisitor;
using testing::filled_dynamics;
using testing::filled_run;
using testing::kListBytes;
using testing::SizeVisitor;
using testing::solved_case;
using testing::TemporaryFolder;

TEST(dynamic_field_lists, hold_every_member_of_the_tables) {
  SizeVisitor support, roller, impact, estimate;
  visit_dynamic_support<const SupportDynamics>(SupportDynamics{}, support);
  visit_dynamic_roller<const RollerDynamics>(RollerDynamics{}, roller);
  visit_impact<const Impact>(Impact{}, impact);
  visit_estimate<const ExtremeEstimate>(ExtremeEstimate{}, estimate);
  constexpr std::size_t kPadding = 4;  // after an int that stands alone before a double
  EXPECT_EQ(support.bytes + kListBytes, sizeof(SupportDynamics));
  EXPECT_EQ(roller.bytes - kPadding, sizeof(RollerDynamics));  // the word shares eight bytes with an int
  EXPECT_EQ(impact.bytes + kPadding, sizeof(Impact));
  EXPECT_EQ(estimate.bytes - kPadding, sizeof(ExtremeEstimate));  // a flag shares eight bytes with an int
  SizeVisitor section;
  visit_stinger_dynamics<const StingerSectionDynamics>(StingerSectionDynamics{}, section);
  EXPECT_EQ(section.bytes, sizeof(StingerSectionDynamics));
}

TEST(dynamic_field_lists, hold_every_single_value) {
  const DynamicResults results;
  SizeVisitor keys, energy, tensioner, run, stations, extreme;
  visit_dynamic_keys(results, keys, true);
  visit_energy(results.energy, energy);
  visit_tensioner(results.tensioner, tensioner);
  visit_dynamic_run(results.run, run);
  visit_dynamic_stations(results, stations);
  visit_dynamic_extreme<const DynamicExtreme>(ResultField{}, DynamicExtreme{}, extreme);
  int extremes = 0;
  visit_dynamic_region(results.sagbend, [&](const ResultField&, const DynamicExtreme&) { ++extremes; });
  EXPECT_EQ(energy.bytes, sizeof(EnergyBalance));
  EXPECT_EQ(tensioner.bytes, sizeof(TensionerDynamics));
  EXPECT_EQ(run.bytes, sizeof(DynamicRunReport));
  EXPECT_EQ(extreme.bytes, sizeof(DynamicExtreme));
  EXPECT_EQ(extremes * sizeof(DynamicExtreme), sizeof(DynamicRegion));
  // supports, hardest_impacts, histories, spectra, extremes
  EXPECT_EQ(keys.bytes + energy.bytes + tensioner.bytes + run.bytes + stations.bytes + 3 * sizeof(DynamicRegion) +
                sizeof(results.min_effective_tension) + 5 * kListBytes + sizeof(results.design) +
                sizeof(results.checks) + sizeof(results.vessel) + sizeof(results.thrust) + sizeof(results.moorings) +
                sizeof(results.lines) + sizeof(results.bodies) + sizeof(results.stinger) + sizeof(results.fatigue),
            sizeof(DynamicResults));
}

std::string result_bits(const DynamicResults& r) {
  BitsVisitor bits;
  visit_dynamic_keys(r, bits, true);
  visit_energy(r.energy, bits);
  visit_tensioner(r.tensioner, bits);
  visit_dynamic_run(r.run, bits);
  const auto extreme = [&](const ResultField& f, const DynamicExtreme& e) { visit_dynamic_extreme(f, e, bits); };
  visit_dynamic_region(r.overbend, extreme);
  visit_dynamic_region(r.tower, extreme);
  visit_dynamic_extreme(ResultField{}, r.min_effective_tension, bits);
  visit_dynamic_region(r.sagbend, extreme);
  visit_dynamic_stations(r, bits);
  for (const SupportDynamics& support : r.supports) {
    visit_dynamic_support(support, bits);
    for (const RollerDynamics& roller : support.rollers) visit_dynamic_roller(roller, bits);
  }
  for (const Impact& impact : r.hardest_impacts) visit_impact(impact, bits);
  for (const StingerSectionDynamics& section : r.stinger) visit_stinger_dynamics(section, bits);
  for (const ExtremeEstimate& estimate : r.extremes) visit_estimate(estimate, bits);
  for (const HistorySummary& history : r.histories) {
    for (const std::string& text : {history.name, history.units, history.description}) bits(ResultField{"text"}, text);
    visit_spread(ResultField{}, history.over_time, bits);
    bits(ResultField{"low"}, history.low);
    bits(ResultField{"high"}, history.high);
  }
  for (const Spectrum& spectrum : r.spectra) {
    bits(ResultField{spectrum.name + spectrum.units + "frequency"}, spectrum.frequency);
    bits(ResultField{spectrum.name + spectrum.units + "density"}, spectrum.density);
  }
  visit_station_design(r.design, bits);
  testing::visit_checks(r.checks, bits);
  return bits.text;
}

void expect_round_trip(const std::string& name) {
  const TemporaryFolder folder;
  const auto& [description, statics] = solved_case(name);
  DynamicResults results = filled_dynamics(statics);
  const RunStore store = filled_run(folder.path(), 5000);
  results.histories = summarise_histories(store);
  results.checks = statics.checks;
  write_dynamic_hdf5(statics, results, store, description, folder / "results.h5");
  EXPECT_TRUE(has_dynamic(folder / "results.h5"));
  const StoredDynamics stored = read_dynamic_results(folder / "results.h5");
  EXPECT_EQ(result_bits(stored.results), result_bits(results));
  EXPECT_GT(std::ranges::count(result_bits(results), '\n'),
            17'000);  // 4 histories of 2,000 stretches twice, 46 columns of 40
  EXPECT_EQ(stored.results.supports.size(), statics.supports.size());
  EXPECT_EQ(stored.statics.results.top_tension, statics.top_tension);
  EXPECT_EQ(stored.statics.model_text, description.source_text);
}

TEST(dynamic_reader, gives_back_an_s_lay_bit_for_bit) {
  expect_round_trip("BGL1-T250");
}

TEST(dynamic_reader, gives_back_a_j_lay_without_supports_and_overbend) {
  expect_round_trip("J12-D400-T560");
}

TEST(dynamic_reader, gives_back_a_run_without_histories_spectra_and_impacts) {
  const TemporaryFolder folder;
  const auto& [description, statics] = solved_case("BGL1-T250");
  DynamicResults results = filled_dynamics(statics);
  results.spectra.clear();
  results.extremes.clear();
  results.hardest_impacts.clear();
  RunStore store = RunStore::create(folder.path(), "", 1);
  store.begin({{"time", "s", "Time", false, false}}, {40, 0});
  write_dynamic_hdf5(statics, results, store, description, folder / "results.h5");
  EXPECT_EQ(result_bits(read_dynamic_results(folder / "results.h5").results), result_bits(results));
}

TEST(dynamic_reader, distinguishes_a_static_file_from_a_dynamic_one) {
  const TemporaryFolder folder;
  const auto& [description, statics] = solved_case("J12-D400-T560");
  write_static_hdf5(statics, description, folder / "results.h5");
  EXPECT_FALSE(has_dynamic(folder / "results.h5"));
  EXPECT_THROW(read_dynamic_results(folder / "results.h5"), std::runtime_error);
  EXPECT_THROW(has_dynamic(folder / "missing.h5"), std::runtime_error);
}

}  // namespace
}  // namespace overbend
