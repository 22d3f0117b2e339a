#include "report/synthetic_study.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace overbend::testing {
namespace {

StudyInput axis(const std::string& key, const std::string& unit, const std::string& show, double factor,
                const std::vector<double>& shown) {
  StudyInput input{key, unit, show, "", false, {}, {}};
  for (const double value : shown) {
    input.value_texts.push_back(fmt::format("{:g} {}", value, show));
    input.values.push_back(value * factor);
  }
  return input;
}

StudyInput hs() {
  return axis("environment.waves.hs", "m", "m", 1.0, {1.0, 1.5, 2.0, 2.5, 3.0, 3.5});
}
StudyInput tp() {
  return axis("environment.waves.tp", "s", "s", 1.0, {6, 7, 8, 9, 10, 11, 12, 14});
}
StudyInput heading() {
  return axis("environment.waves.from", "rad", "deg", std::numbers::pi / 180.0,
              {0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330});
}

StudyResults headed(const std::string& title) {
  StudyResults results;
  results.title = title;
  results.version = "0.0";
  results.analysis = "dynamic";
  results.outputs = {{"dynamic.overbend.max_von_mises", "Pa"},
                     {"dynamic.top_tension.min", "N"},
                     {"dynamic.sagbend.max_strain", "1"},
                     {"checks.governing", "", true}};
  results.command = "overbend study waves.yaml -o waves.study";
  results.assumptions = {{AssumptionRank::other, "The sea is that of a JONSWAP spectrum."}};
  results.wall_time = 5400.0;
  results.threads = 8;
  return results;
}

/// A response that grows with the wave height and has a period of resonance.
void fill(StudyCase& study_case, double height, double period, double noise) {
  study_case.state = StudyCaseState::done;
  const double answer = height / (1.0 + 0.2 * (period - 9.0) * (period - 9.0)) + 0.3 * height + noise;
  study_case.values = {(250.0 + 60.0 * answer) * 1e6, (200.0 - 35.0 * answer) * 1e3, 0.0014 + 2e-4 * answer,
                       std::nullopt};
  study_case.texts = {"", "", "", "laying criterion I, overbend"};
  study_case.utilisation = (250.0 + 60.0 * answer) / 400.0;
  study_case.governing = "laying criterion I, overbend";
  study_case.verdict = *study_case.utilisation <= 1.0 ? VerdictKind::passed : VerdictKind::exceeded;
}

void fail(StudyCase& study_case) {
  study_case.state = StudyCaseState::failed;
  study_case.verdict = VerdictKind::not_judged;
  study_case.values.assign(4, std::nullopt);
  study_case.texts.assign(4, "");
  study_case.reason = "no equilibrium: the tension 150 kN is below the suspended weight, 163 kN";
}

/// All combinations of the inputs, each with so many seeds.
void cross(StudyResults& results, std::size_t seeds) {
  std::size_t all = 1;
  for (const StudyInput& input : results.inputs) all *= input.value_texts.size();
  for (std::size_t group = 0; group < all; ++group) {
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      StudyCase study_case;
      study_case.number = results.cases.size();
      study_case.group = group;
      std::size_t rest = group;
      study_case.value_indices.resize(results.inputs.size());
      for (std::size_t i = results.inputs.size(); i-- > 0;) {
        study_case.value_indices[i] = rest % results.inputs[i].value_texts.size();
        rest /= results.inputs[i].value_texts.size();
      }
      for (std::size_t i = 0; i < study_case.value_indices.size(); ++i) {
        study_case.value_texts.push_back(results.inputs[i].value_texts[study_case.value_indices[i]]);
        study_case.inputs.push_back(results.inputs[i].values[study_case.value_indices[i]]);
      }
      if (seeds > 1) study_case.seed = seed;
      const double noise = 0.08 * std::sin(12.9 * static_cast<double>(study_case.number));
      fill(study_case, study_case.inputs[0], study_case.inputs.size() > 1 ? study_case.inputs[1] : 9.0, noise);
      if (study_case.value_indices.size() > 1 && study_case.value_indices[0] == 5 && study_case.value_indices[1] == 3)
        fail(study_case);
      results.cases.push_back(study_case);
    }
  }
}

StudyResults swings() {
  StudyResults results = headed("Sensitivity of the lay to what is not known");
  results.inputs = {axis("tensioner.tension", "N", "kN", 1e3, {180, 200, 220}),
                    axis("environment.water_depth", "m", "m", 1.0, {48, 50, 52}),
                    axis("pipe.coating.concrete.density", "kg/m^3", "kg/m^3", 1.0, {2950, 3040, 3130})};
  for (std::size_t i = 0; i < 7; ++i) {
    StudyCase study_case;
    study_case.number = study_case.group = i;
    study_case.value_indices = {1, 1, 1};
    if (i > 0) study_case.value_indices[(i - 1) / 2] = i % 2 == 1 ? 0 : 2;
    for (std::size_t k = 0; k < 3; ++k) {
      study_case.value_texts.push_back(results.inputs[k].value_texts[study_case.value_indices[k]]);
      study_case.inputs.push_back(results.inputs[k].values[study_case.value_indices[k]]);
    }
    const double change = 0.9 * (1.0 - static_cast<double>(study_case.value_indices[0])) +
                          0.4 * static_cast<double>(study_case.value_indices[1]) +
                          0.1 * static_cast<double>(study_case.value_indices[2]);
    fill(study_case, 1.0 + change, 9.0, 0.0);
    results.cases.push_back(study_case);
  }
  return results;
}

StudyResults sample() {
  StudyResults results = headed("Spread of a lay whose inputs are drawn");
  results.inputs = {{"tensioner.tension", "N", "kN", "", true, {}, {}},
                    {"environment.waves.hs", "m", "m", "", true, {}, {}},
                    {"seabed.friction.lateral", "1", "", "", true, {}, {}}};
  for (std::size_t i = 0; i < 120; ++i) {
    const double a = std::fmod(0.618034 * static_cast<double>(i), 1.0),
                 b = std::fmod(0.754878 * static_cast<double>(i), 1.0),
                 c = std::fmod(0.569840 * static_cast<double>(i), 1.0);
    StudyCase study_case;
    study_case.number = study_case.group = i;
    study_case.inputs = {180e3 + 60e3 * a, 0.5 + 2.5 * b, 0.4 + 0.4 * c};
    study_case.value_texts = {fmt::format("{:.1f} kN", study_case.inputs[0] / 1e3),
                              fmt::format("{:.3f} m", study_case.inputs[1]),
                              fmt::format("{:.3f}", study_case.inputs[2])};
    fill(study_case, study_case.inputs[1], 9.0, 1.2 * (0.5 - a));
    if (i == 77) fail(study_case);
    results.cases.push_back(study_case);
  }
  return results;
}

StudyResults operability() {
  StudyResults results = headed("Operability of a barge");
  results.outputs.clear();
  OperabilityResults all;
  all.over = "environment.waves.hs";
  all.unit = all.show = "m";
  all.axes = {heading(), axis("environment.waves.tp", "s", "s", 1.0, {6, 8, 10, 12})};
  all.min_value = 0.5;
  all.max_value = 4.0;
  all.resolution = 0.25;
  all.seeds = {1, 2, 3};
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      OperabilityCell cell;
      cell.value_indices = {i, j};
      const double beam = std::abs(std::sin(all.axes[0].values[i])), period = all.axes[1].values[j];
      const double limit = std::floor(4.0 * (4.9 - 2.4 * beam - 0.25 * (period - 6.0))) / 4.0;
      cell.beyond = limit >= all.max_value;
      if (limit >= all.min_value && !cell.beyond) cell.limit = limit;
      if (cell.beyond) cell.limit = all.max_value;
      cell.governing = cell.beyond ? "" : beam > 0.6 ? "clearance at the stinger tip" : "laying criterion I, overbend";
      cell.below = 0.96;
      cell.above = 1.04;
      cell.runs = 12;
      all.runs += cell.runs;
      all.cells.push_back(cell);
    }
  }
  all.cells[13].decided = false;
  all.cells[13].limit.reset();
  all.cells[13].reason = "two seeds had no result";
  all.cells[20].reason = "at the limit the pipe left 'stinger 8' over its side to port";
  Workability workability;
  for (int i = 0; i < 12; ++i) workability.months.push_back(0.62 - 0.3 * std::cos(2.0 * std::numbers::pi * i / 12.0));
  workability.year = 0.62;
  workability.outside = 0.013;
  all.workability = workability;
  results.operability = all;
  return results;
}

void add_extremes(StudyResults& results) {
  for (std::size_t group = 0; group < 6; ++group) {
    StudyExtreme extreme;
    extreme.group = group;
    extreme.output = group % 2;
    extreme.runs = 12;
    extreme.mean = group % 2 == 0 ? 300e6 : 150e3;
    extreme.std = 0.03 * extreme.mean;
    extreme.worst = extreme.is_maximum ? 1.05 * extreme.mean : 0.95 * extreme.mean;
    extreme.enough = group < 4;
    extreme.gumbel = {1.06 * extreme.mean, 1.02 * extreme.mean, 1.11 * extreme.mean};
    if (group != 1) extreme.acer = StudyEstimate{1.05 * extreme.mean, 1.03 * extreme.mean, 1.08 * extreme.mean};
    results.extremes.push_back(extreme);
  }
}

}  // namespace

StudyResults synthetic_study(const std::string& shape) {
  if (shape == "swings") return swings();
  if (shape == "sample") return sample();
  if (shape == "operability") return operability();
  StudyResults results = headed("A barge in waves");
  results.inputs = {hs()};
  if (shape != "curves") results.inputs.push_back(tp());
  if (shape == "facets") results.inputs.push_back(axis("tensioner.tension", "N", "kN", 1e3, {180, 200, 220}));
  cross(results, shape == "facets" ? 1 : 3);
  if (shape == "maps") add_extremes(results);
  return results;
}

}  // namespace overbend::testing
