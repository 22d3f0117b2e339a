/// Lines by themselves with answers of other programs or a closed form. Tests and the validation page share them.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "dynamics/run/simulation.h"
#include "recording/recorder.h"
#include "statics/solver/lines_setup.h"
#include "support/fixtures.h"
#include "support/memory_sink.h"

namespace overbend::testing {

/// Water of a density [kg/m3] and a depth [m], a hard bed without friction, no current.
inline Description water_alone(double density, double depth) {
  Description d = plain_description();
  d.has_pipe = false;
  d.environment.water_weight_density = density * kGravity;
  d.environment.water_depth = depth;
  d.environment.seabed.stiffness = 0.0;
  return d;
}

/// By what it has of mass, and of a round section of `volume_diameter` that is displaced.
inline LineTypeDescription cable_type(double mass, double volume_diameter, double EA, double EI, double density) {
  LineTypeDescription type;
  type.diameter = type.drag_diameter = volume_diameter;
  type.weight_in_air = mass * kGravity;
  const double area = 0.25 * std::numbers::pi * volume_diameter * volume_diameter;
  type.weight_submerged = type.weight_in_air - density * kGravity * area;
  type.axial_stiffness = EA;
  type.bending_stiffness = EI;
  return type;
}

inline FreeLineDescription free_line(const LineTypeDescription& type, double length, const Vec3& first,
                                     const Vec3& second) {
  FreeLineDescription line;
  line.name = "line";
  line.first.at = first;
  line.second.at = second;
  line.segments = {{"", length, type}};
  return line;
}

/// The chains of validation/moordyn: from the anchor to the fairlead.
inline Description chain_case(double depth, double amplitude) {
  Description d = water_alone(1025.0, depth);
  LineTypeDescription chain = cable_type(390.0, 0.252, 1.674e9, 0.0, 1025.0);
  chain.drag_normal = 1.37;
  // The program that made the records takes the drag along a chain on the diameter alone, ours on the circumference;
  // and its chain stands on the bed with the width of a link, 3.35 diameters of the bar, where the volume's is 1.89.
  chain.drag_axial = 0.64 / std::numbers::pi;
  d.environment.seabed.stiffness = 1e5 * 0.252 * 3.35 / 1.89;
  d.environment.seabed.damping = 1e4 * 0.252;
  d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = 0.5;
  const double across = depth == 50.0 ? 400.0 : depth == 200.0 ? 700.0 : 1500.0;
  const double length = depth == 50.0 ? 410.0 : depth == 200.0 ? 760.0 : 1700.0;
  d.lines = {free_line(chain, length, Vec3(across, 0.0, -depth), Vec3::Zero())};
  d.lines[0].second.amplitude = Vec3(0.0, 0.0, amplitude);
  d.lines[0].second.period = 10.0;
  return d;
}

/// The jumper of validation/lowe_langley, its upper end the second.
inline Description jumper_case(const Vec3& amplitude) {
  Description d = water_alone(1000.0, 100.0);
  LineTypeDescription type = cable_type(165.0, 0.396, 500e6, 120.8e3, 1000.0);
  type.drag_normal = 1.0;
  d.lines = {free_line(type, 170.0, Vec3(-100.0, 0.0, -55.0), Vec3(0.0, 0.0, -5.0))};
  d.lines[0].second.amplitude = amplitude;
  d.lines[0].second.period = 27.0;
  return d;
}

/// The lines of a description at rest.
struct RestingLines {
  Model model;
  LinesSetup setup;
  SystemState state;
  LinesEquilibriumReport rest;
  std::vector<Vec3> first, last;  ///< Forces on the ends by what holds them [N].

  explicit RestingLines(const Description& description) : model(build_model(description)), setup(lines_setup(model)) {
    Assembly assembly(setup.system);
    state = make_initial_state(setup, 0.0);
    rest = solve_lines_one_by_one(assembly, state);
    for (std::size_t i = 0; i < setup.system.lines.size(); ++i) {
      const auto force = [&](LineEnd end) {
        return Vec3(Eigen::Map<const Vec3>(assembly.line(i).end_force(end).data()));
      };
      first.push_back(force(LineEnd::first));
      last.push_back(force(LineEnd::last));
    }
  }
  RestingLines(const RestingLines&) = delete;
  RestingLines& operator=(const RestingLines&) = delete;
  /// Initial state of a run.
  RunStart start(const DynamicOptions& options) const {
    StaticSolution solution;
    solution.lines = std::make_shared<StaticLines>(StaticLines{setup, state, rest});
    return make_run_start(model, solution, 0.0, options);
  }
  Vec3 place(std::size_t line, int node) const { return Eigen::Map<const Vec3>(state.lines[line].q.data() + 6 * node); }
  const Line& line(std::size_t i = 0) const { return setup.system.lines[i]; }
};

/// Tensions of a line in a run [N]: rows of t >= 0, and the least and largest of all steps.
struct LineHistory {
  std::vector<double> time, first, last;
  double min_first_tension = 0.0, max_first_tension = 0.0, min_last_tension = 0.0, max_last_tension = 0.0;
  std::vector<double> min_tension, max_node_tension;  ///< At the nodes.
};

/// A run from that rest.
inline std::vector<LineHistory> run_lines(const Description& description, const DynamicOptions& options) {
  const RestingLines rest(description);
  Simulation run(rest.model, rest.start(options), options);
  StaticResults statics;
  statics.lines.resize(description.lines.size());
  MemorySink sink;
  Recorder recorder(rest.model, statics, run, sink);
  run.observe(recorder);
  recorder.row(run.present(), run.row_number());
  if (!run.advance(run.end())) throw std::runtime_error(run.failure()->what);
  DynamicResults results;
  recorder.fill(results);
  const std::vector<double> time = sink.column("time");
  const auto first_row = std::lower_bound(time.begin(), time.end(), 0.0) - time.begin();
  const auto counted = [&](const std::vector<double>& all) { return std::vector(all.begin() + first_row, all.end()); };
  std::vector<LineHistory> histories;
  for (const LineDynamics& line : results.lines) {
    histories.push_back({counted(time), counted(sink.column("line/" + line.name + "/first_tension")),
                         counted(sink.column("line/" + line.name + "/second_tension")), line.first_tension.min,
                         line.first_tension.max, line.second_tension.min, line.second_tension.max,
                         line.min_tension_at_nodes, line.max_tension_at_nodes});
  }
  return histories;
}

/// Columns of numbers, separated by blanks or commas.
inline std::vector<std::vector<double>> number_columns(const std::string& file) {
  std::ifstream in(std::string(OVERBEND_SOURCE_DIR) + "/validation/" + file);
  std::vector<std::vector<double>> columns;
  for (std::string text; std::getline(in, text);) {
    for (char& c : text) c = c == ',' ? ' ' : c;
    std::istringstream row(text);
    double value = 0.0;
    for (std::size_t i = 0; row >> value; ++i) {
      if (i == columns.size()) columns.emplace_back();
      columns[i].push_back(value);
    }
  }
  return columns;
}

}  // namespace overbend::testing
