#include "statics/solver/lines_statics.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

constexpr double kRounding = 1e-15;  ///< Of the axial stiffness: a tangent of length 1 knows its strain no better.

constexpr int kFirstTry = 60;  ///< Iterations from the first guess, before a way from soft to hard is taken.

/// A second way to look at rest: so slow a motion from the laid shape that neither water nor mass notice, but the bed's
/// friction, which stretches by what was moved [s].
constexpr double kSlowly = 1e9;

double stiffest(const LineAssembly& line) {
  const LineElements& elements = line.elements();
  return *std::max_element(elements.EA.begin(), elements.EA.begin() + elements.count);
}

NewtonReport come_to_rest(Equilibrium& resting, SystemState& state, const LineRestSettings& settings) {
  const double rounding = kRounding * stiffest(resting.line()) / resting.line().line().force_scale;
  NewtonSettings newton;
  newton.tolerance = std::max(settings.tolerance, rounding);
  newton.max_iterations = settings.max_iterations;
  newton.singular_damping = 1.0;  // as light as a cable that resists nothing across
  return solve_equilibrium(resting, state, newton);
}

/// From soft to hard: a cable that stretches finds its shape in large steps, where a stiff one has to keep its length
/// in every turn. Each shape is the start of the next.
NewtonReport harden_and_rest(Equilibrium& resting, LineAssembly& line, SystemState& state,
                             const LineRestSettings& settings) {
  constexpr double kSoftest = 20.0, kHarder = 8.0;  // EA over the weight in air, and by how much it grows
  constexpr double kRoughly = 1e-5;
  const Continuation hard = line.continuation();
  Continuation soft = hard;
  int iterations = 0;
  const double full = stiffest(line);
  double most = kSoftest * line.line().force_scale;
  while (most < full) {
    soft.max_axial_stiffness = most;
    line.set(soft);
    iterations += come_to_rest(resting, state, {kRoughly, settings.max_iterations}).iterations;
    most *= kHarder;
  }
  line.set(hard);
  NewtonReport report = come_to_rest(resting, state, settings);
  report.iterations += iterations;
  return report;
}

/// From the shape in `state`, at once or from soft to hard.
NewtonReport rest_from_here(Equilibrium& resting, Assembly& assembly, std::size_t line, SystemState& state,
                            const LineRestSettings& settings, int first_try) {
  const LineState start = state.lines[line];
  const NewtonReport report = come_to_rest(resting, state, {settings.tolerance, first_try});
  if (report.converged()) return report;
  state.lines[line] = start;
  return harden_and_rest(resting, assembly.line(line), state, settings);
}

}  // namespace

NewtonReport rest_line(Assembly& assembly, std::size_t line, const SystemState& laid, double slowly, SystemState& state,
                       const LineRestSettings& settings) {
  Equilibrium resting(assembly, {LayHistory::monotonic, &laid, slowly}, static_cast<int>(line));
  return rest_from_here(resting, assembly, line, state, settings, settings.max_iterations);
}

double rounding_residual(const Line& line, const std::vector<double>& q) {
  constexpr double kOfPlace = 1e-15;  // of the furthest coordinate
  double furthest = 1.0, stiffest = 0.0;
  for (std::size_t node = 0; node < line.mesh.s.size(); ++node) {
    for (std::size_t k = 0; k < 3; ++k) furthest = std::max(furthest, std::abs(q[6 * node + k]));
  }
  for (std::size_t e = 0; e < line.mesh.length.size(); ++e) {
    stiffest = std::max(stiffest, line.elements.EA[e] / line.mesh.length[e]);
  }
  return kOfPlace * furthest * stiffest / line.force_scale;
}

bool LinesRest::converged() const {
  return std::all_of(lines.begin(), lines.end(), [](const NewtonReport& line) { return line.converged(); });
}

LinesRest rest_lines(Assembly& assembly, SystemState& state, const LineRestSettings& settings) {
  assembly.set_time(state.time, state);
  assembly.impose_ends(state);
  const SystemState laid = state;
  LinesRest rest;
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    Equilibrium straight(assembly, {}, static_cast<int>(i));
    Equilibrium bow(assembly, {LayHistory::monotonic, &laid, kSlowly}, static_cast<int>(i));
    NewtonReport report = rest_from_here(straight, assembly, i, state, settings, kFirstTry);
    rest.in_bows.push_back(!report.converged());
    if (rest.in_bows.back()) {
      state.lines[i] = laid.lines[i];
      report = harden_and_rest(bow, assembly.line(i), state, settings);
    }
    rest.lines.push_back(report);
    (rest.in_bows.back() ? bow : straight).evaluate(state, false);
    std::fill(state.lines[i].v.begin(), state.lines[i].v.end(), 0.0);
    state.lines[i].low.clear();
  }
  return rest;
}

}  // namespace overbend
