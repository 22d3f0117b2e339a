#include "statics/solver/lines_statics.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

constexpr double kRounding = 1e-15;  ///< Relative to the axial stiffness: resolution of the strain of a tangent of
                                     ///< length 1.

constexpr int kDirectIterations = 60;  ///< Iterations from the initial shape before continuation in axial stiffness.

/// Pseudo time step of the quasi-static formulation with seabed friction: so long that inertia and drag vanish, and
/// only friction depends on the displacement [s].
constexpr double kPseudoTimeStep = 1e9;

double find_max_axial_stiffness(const LineAssembly& line) {
  const LineElements& elements = line.elements();
  return *std::max_element(elements.EA.begin(), elements.EA.begin() + elements.count);
}

NewtonReport solve_with_newton(Equilibrium& resting, SystemState& state, const LineSolveSettings& settings) {
  const double rounding = kRounding * find_max_axial_stiffness(resting.line()) / resting.line().line().force_scale;
  NewtonSettings newton;
  newton.tolerance = std::max(settings.tolerance, rounding);
  newton.max_iterations = settings.max_iterations;
  newton.singular_damping = 1.0;  // as small as for a cable without lateral stiffness
  return solve_equilibrium(resting, state, newton);
}

/// Continuation in axial stiffness: a soft cable reaches its shape in large steps, whereas a stiff one has to keep its
/// length in every rotation.
NewtonReport continue_in_axial_stiffness(Equilibrium& resting, LineAssembly& line, SystemState& state,
                                         const LineSolveSettings& settings) {
  constexpr double kSoftest = 20.0, kHarder = 8.0;  // EA over the weight in air, and its growth factor
  constexpr double kRoughly = 1e-5;
  const Continuation hard = line.continuation();
  Continuation soft = hard;
  int iterations = 0;
  const double full = find_max_axial_stiffness(line);
  double axial_stiffness = kSoftest * line.line().force_scale;
  while (axial_stiffness < full) {
    soft.max_axial_stiffness = axial_stiffness;
    line.set(soft);
    iterations += solve_with_newton(resting, state, {kRoughly, settings.max_iterations}).iterations;
    axial_stiffness *= kHarder;
  }
  line.set(hard);
  NewtonReport report = solve_with_newton(resting, state, settings);
  report.iterations += iterations;
  return report;
}

/// Solves from the shape in `state`, directly or by continuation in axial stiffness.
NewtonReport solve_line_from_shape(Equilibrium& resting, Assembly& assembly, std::size_t line, SystemState& state,
                                   const LineSolveSettings& settings, int first_try) {
  const LineState start = state.lines[line];
  const NewtonReport report = solve_with_newton(resting, state, {settings.tolerance, first_try});
  if (report.converged()) return report;
  state.lines[line] = start;
  return continue_in_axial_stiffness(resting, assembly.line(line), state, settings);
}

}  // namespace

NewtonReport solve_line_equilibrium(Assembly& assembly, std::size_t line, const SystemState& laid,
                                    double pseudo_time_step, SystemState& state, const LineSolveSettings& settings) {
  Equilibrium resting(assembly, {LayHistory::monotonic, &laid, pseudo_time_step}, static_cast<int>(line));
  return solve_line_from_shape(resting, assembly, line, state, settings, settings.max_iterations);
}

double rounding_residual(const Line& line, const std::vector<double>& q) {
  constexpr double kOfPlace = 1e-15;  // relative to the largest coordinate
  double furthest = 1.0, max_stiffness = 0.0;
  for (std::size_t node = 0; node < line.mesh.s.size(); ++node) {
    for (std::size_t k = 0; k < 3; ++k) furthest = std::max(furthest, std::abs(q[6 * node + k]));
  }
  for (std::size_t e = 0; e < line.mesh.length.size(); ++e) {
    max_stiffness = std::max(max_stiffness, line.elements.EA[e] / line.mesh.length[e]);
  }
  return kOfPlace * furthest * max_stiffness / line.force_scale;
}

bool LinesEquilibriumReport::converged() const {
  return std::all_of(lines.begin(), lines.end(), [](const NewtonReport& line) { return line.converged(); });
}

LinesEquilibriumReport solve_lines_one_by_one(Assembly& assembly, SystemState& state,
                                              const LineSolveSettings& settings) {
  assembly.set_time(state.time, state);
  assembly.impose_ends(state);
  const SystemState laid = state;
  LinesEquilibriumReport rest;
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    Equilibrium straight(assembly, {}, static_cast<int>(i));
    Equilibrium bow(assembly, {LayHistory::monotonic, &laid, kPseudoTimeStep}, static_cast<int>(i));
    NewtonReport report = solve_line_from_shape(straight, assembly, i, state, settings, kDirectIterations);
    rest.lies_in_bow.push_back(!report.converged());
    if (rest.lies_in_bow.back()) {
      state.lines[i] = laid.lines[i];
      report = continue_in_axial_stiffness(bow, assembly.line(i), state, settings);
    }
    rest.lines.push_back(report);
    (rest.lies_in_bow.back() ? bow : straight).evaluate(state, false);
    std::fill(state.lines[i].v.begin(), state.lines[i].v.end(), 0.0);
    state.lines[i].low.clear();
  }
  return rest;
}

}  // namespace overbend
