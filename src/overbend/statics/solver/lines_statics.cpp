#include "statics/solver/lines_statics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/interruption.h"
#include "statics/equations/step_search.h"

namespace overbend {
namespace {

constexpr double kRounding = 1e-15;  ///< Of the axial stiffness: a tangent of length 1 knows its strain no better.

constexpr int kFirstTry = 60;  ///< Iterations from the first guess, before a way from soft to hard is taken.

/// A second way to look at rest: so slow a motion from the laid shape that neither water nor mass notice, but the bed's
/// friction, which stretches by what was moved [s].
constexpr double kSlowly = 1e9;

/// One line with what it is evaluated and held by.
struct RestingLine {
  LineAssembly& line;
  const std::vector<RigidMotion>& bodies;
  const HeldDirections &first, &last;
  const LineState* laid;  ///< Where friction began to hold; null: on the straight course.
  double slowly = kSlowly;

  void balance(LineState& state, bool with_tangent) {
    static const std::vector<double> kCalm;
    if (laid == nullptr) {
      line.evaluate_at_rest(bodies, state, LayHistory::monotonic, with_tangent);
      return;
    }
    for (std::size_t i = 0; i < state.q.size(); ++i) state.v[i] = (state.q[i] - laid->q[i]) / slowly;
    line.evaluate(state, *laid, {1.0 / slowly, 0.0, slowly}, kCalm, with_tangent, ContactMode::free);
  }

  void evaluate(LineState& state, bool with_tangent) {
    balance(state, with_tangent);
    line.hold(line.end_node(LineEnd::first), first, with_tangent);
    line.hold(line.end_node(LineEnd::last), last, with_tangent);
  }

  double work(const std::vector<double>& dq) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < dq.size(); ++i) sum += line.residual()[i] * dq[i];
    return sum;
  }

  /// Of the equations evaluated last; false where they are singular.
  bool solve_step(double damping, std::vector<double>& dq) {
    BlockTridiagonal& tangent = line.tangent();
    add_step_damping(line.line().mesh, damping, tangent);
    for (int node = 0; node < tangent.nodes(); ++node) {
      for (int i = 0; i < kNodeDofs; ++i) {
        tangent.rhs(node, i, 0) = -line.residual()[static_cast<std::size_t>(kNodeDofs * node + i)];
        tangent.rhs(node, i, 1) = 0.0;
      }
    }
    if (solve(tangent).singular_node >= 0) return false;
    for (int node = 0; node < tangent.nodes(); ++node) {
      for (int i = 0; i < kNodeDofs; ++i) dq[static_cast<std::size_t>(kNodeDofs * node + i)] = tangent.rhs(node, i, 0);
    }
    return true;
  }
};

NewtonReport come_to_rest(RestingLine resting, LineState& state, const LineRestSettings& settings) {
  NewtonReport report;
  LineAssembly& line = resting.line;
  std::vector<double> dq(state.q.size());
  LineState trial = state;
  double damping = 0.0;
  const LineElements& elements = line.line().elements;
  const double stiffest = *std::max_element(elements.EA.begin(), elements.EA.begin() + elements.count);
  const double move = largest_move(line.line().mesh);
  for (; report.iterations <= settings.max_iterations; ++report.iterations) {
    check_interruption();
    resting.evaluate(state, true);
    report.residual = line.unbalance().force / line.line().force_scale;
    const double rounding = kRounding * stiffest / line.line().force_scale;
    if (!std::isfinite(report.residual)) {
      report.end = NewtonEnd::lost;
      return report;
    }
    if (report.residual < std::max(settings.tolerance, rounding)) {
      report.end = NewtonEnd::converged;
      return report;
    }
    if (!resting.solve_step(damping, dq) || (resting.work(dq) >= 0.0 && damping < kMostDamping)) {
      if (damping > kMostDamping) {
        report.end = NewtonEnd::singular;
        return report;
      }
      damping = std::max(kDampingStep * damping, 1.0);
      continue;
    }
    const double share = search_along(
        [&](double at) {
          ++report.trials;
          advance(trial, state, dq, at);
          resting.evaluate(trial, false);
          return resting.work(dq);
        },
        resting.work(dq), step_limit(dq, move));
    damping = share < 0.05 ? std::max(kDampingStep * damping, 1.0) : damping < 1.0 ? 0.0 : damping / kDampingStep;
    std::swap(state, trial);
  }
  return report;
}

/// From soft to hard: a cable that stretches finds its shape in large steps, where a stiff one has to keep its length
/// in every turn. Each shape is the start of the next.
NewtonReport harden_and_rest(const RestingLine& resting, LineState& state, const LineRestSettings& settings) {
  constexpr double kSoftest = 20.0, kHarder = 8.0;  // EA over the weight in air, and by how much it grows
  constexpr double kRoughly = 1e-5;
  const Line& line = resting.line.line();
  const double stiffest = *std::max_element(line.elements.EA.begin(), line.elements.EA.begin() + line.elements.count);
  int iterations = 0;
  double most = kSoftest * line.force_scale;
  while (most < stiffest) {
    Line soft = line;
    for (double& EA : soft.elements.EA) EA = std::min(EA, most);
    BlockTridiagonal tangent(line.mesh.nodes());
    const std::vector<Body> none;
    LineAssembly assembly(soft, none, tangent);
    const RestingLine trial{assembly, resting.bodies, resting.first, resting.last, resting.laid, resting.slowly};
    iterations += come_to_rest(trial, state, {kRoughly, settings.max_iterations}).iterations;
    most *= kHarder;
  }
  NewtonReport report = come_to_rest(resting, state, settings);
  report.iterations += iterations;
  return report;
}

HeldDirections held_by(const Attachment& attachment, const EndMotion& end) {
  HeldDirections held;
  if (attachment.hold_place) held.position = all_directions();
  if (attachment.hold_direction) held.tangent = across(end.direction);
  return held;
}

/// What holds the ends of a line: the first, the last.
std::pair<HeldDirections, HeldDirections> held_ends(const Assembly& assembly, std::size_t line) {
  const System& system = assembly.system();
  std::pair<HeldDirections, HeldDirections> held;
  for (std::size_t a = 0; a < system.attachments.size(); ++a) {
    const Attachment& attachment = system.attachments[a];
    if (attachment.line != static_cast<int>(line)) continue;
    (attachment.end == LineEnd::first ? held.first : held.second) =
        held_by(attachment, assembly.surroundings().ends[a]);
  }
  return held;
}

}  // namespace

NewtonReport rest_line(Assembly& assembly, std::size_t line, const LineState& laid, double slowly, LineState& state,
                       const LineRestSettings& settings) {
  const auto [first, last] = held_ends(assembly, line);
  RestingLine resting{assembly.line(line), assembly.surroundings().bodies, first, last, &laid, slowly};
  const LineState start = state;
  NewtonReport report = come_to_rest(resting, state, settings);
  if (report.converged()) return report;
  state = start;
  return harden_and_rest(resting, state, settings);
}

bool LinesRest::converged() const {
  return std::all_of(lines.begin(), lines.end(), [](const NewtonReport& line) { return line.converged(); });
}

LinesRest rest_lines(Assembly& assembly, SystemState& state, const LineRestSettings& settings) {
  const System& system = assembly.system();
  assembly.set_time(state.time, state);
  assembly.impose_ends(state);
  LinesRest rest;
  for (std::size_t i = 0; i < system.lines.size(); ++i) {
    const auto [first, last] = held_ends(assembly, i);
    LineState& line = state.lines[i];
    const LineState start = line;
    const std::vector<RigidMotion>& bodies = assembly.surroundings().bodies;
    RestingLine resting{assembly.line(i), bodies, first, last, nullptr};
    rest.lines.push_back(come_to_rest(resting, line, {settings.tolerance, kFirstTry}));
    if (!rest.lines.back().converged()) {
      line = start;
      rest.lines.back() = harden_and_rest(resting, line, settings);
    }
    rest.in_bows.push_back(!rest.lines.back().converged());
    if (rest.in_bows.back()) {
      line = start;
      resting.laid = &start;
      rest.lines.back() = harden_and_rest(resting, line, settings);
    }
    resting.balance(line, false);
    std::fill(line.v.begin(), line.v.end(), 0.0);
    line.low.clear();
  }
  return rest;
}

}  // namespace overbend
