#include "statics/solver/static_ways.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/shown_unit.h"
#include "mechanics/plastic_bending.h"
#include "model/lay_stage.h"
#include "statics/initial_shape/stage_shape.h"
#include "statics/solver/newton.h"
#include "statics/solver/relaxation.h"
#include "statics/solver/static_start.h"

namespace overbend {
namespace {

constexpr int kRememberingMore = 3;   ///< Times as many iterations where steel remembers: they converge linearly.
constexpr double kMostWork = 2.3e6;   ///< What a case may cost, in Newton steps times elements: 3 s or so.
constexpr double kOfRoller = 0.25;    ///< Time of a roller over that of an element,
constexpr double kOfSearch = 1e-3;    ///< and of its search along an element: as measured.
constexpr double kMostLooks = 150.0;  ///< Newton steps that it may cost in any case, however fine its mesh.
constexpr double kLookWithout = 0.2;  ///< What a look at the residual alone costs beside a Newton step.
constexpr double kShareOfRelaxation =
    0.75;                               ///< Of what is left when all else has failed; the rest is Newton's, to finish.
constexpr double kHigherTension = 3.0;  ///< Times the wanted tension, at which the line is nearly straight.

/// Roller stiffness that lets a pipe sink by decimetres: weight and curvature load of ten metres of pipe over 0.3 m.
double soft_roller(const StaticCase& at, double tension) {
  return 40.0 * std::max(at.model.pipe_section().weight_in_air, tension / 150.0);
}

/// Stiffness of a bed in which the pipe sinks by half its diameter [N/m2].
double soft_bed(const StaticCase& at) {
  const Section& pipe = at.model.pipe_section();
  return pipe.weight_submerged / (0.5 * pipe.outer_diameter);
}

/// Changes parameters of the continuation; the others stay.
template <class Change>
void ease(StaticCase& at, const Change& change) {
  Continuation continuation = at.system.continuation();
  change(continuation);
  at.system.set(continuation);
}

/// One stage of a way: how much easier than the model it is, and how it is solved.
bool run_newton(StaticCase& at, const Continuation& continuation, NewtonSettings settings, const char* stage) {
  at.system.set(continuation);
  if (at.spent()) return false;
  settings.remembers = at.system.remembers();
  settings.max_iterations = at.model.description.statics.max_iterations * (settings.remembers ? kRememberingMore : 1);
  const NewtonReport r = solve_equilibrium(at.system, at.state, settings);
  at.work += at.size() * (r.iterations + kLookWithout * r.trials);
  at.report.iterations += r.iterations;
  at.report.force_residual = r.residual;
  at.report.history.push_back(fmt::format("{}: {} iterations, residual {:.2e}{}", stage, r.iterations, r.residual,
                                          r.converged() ? "" : ", not converged"));
  if (r.end == NewtonEnd::slack && settings.tolerance <= at.model.description.statics.tolerance) {
    at.least_found = at.target.value + at.system.target_error(at.state, at.target);
  }
  return r.converged();
}

NewtonSettings to_tolerance(const StaticCase& at, double tolerance) {
  NewtonSettings settings;
  settings.tolerance = tolerance;
  settings.target = at.target;
  return settings;
}

NewtonSettings loosely(const StaticCase& at) {
  return to_tolerance(at, 1e-3);
}

/// So that no roller is struck hard.
NewtonSettings gently(NewtonSettings settings, const StaticCase& at) {
  settings.entering = 0.25 * at.model.pipe_section().outer_diameter;
  return settings;
}

/// Of the stiffest roller [N/m].
double hardest_roller(const StaticCase& at) {
  double hardest = 0.0;
  for (int i = 0; i < at.system.rollers().count(); ++i) {
    hardest = std::max(hardest, at.system.rollers().roller(i).law.stiffness);
  }
  return hardest;
}

/// What the last digit of a place does to the force of a roller, over the weight. It matters to a light line, most of
/// it cable, on rollers as good as rigid.
double rounding(const StaticCase& at) {
  constexpr double kLastDigit = 2e-14;  // of a hundred metres [m]
  return has_cable(at.model.description) ? kLastDigit * hardest_roller(at) / at.system.total_weight() : 0.0;
}

NewtonSettings finally(const StaticCase& at) {
  return gently(to_tolerance(at, std::max(at.model.description.statics.tolerance, rounding(at))), at);
}

/// For one of several steps towards an end.
NewtonSettings nearly(const StaticCase& at) {
  NewtonSettings settings = finally(at);
  settings.tolerance = std::max(settings.tolerance, 1e-6);
  return settings;
}

/// How a continuation from 0 to 1 chooses its steps.
struct Steps {
  double first = 0.25, growth = 1.5, least = 1e-3;
};

/// Follows the solutions from where `reached` of 0 was solved to 1, `ease` being how the parameters follow it: a step
/// that fails is taken back and halved, one that works lets the next be longer.
bool follow_in_steps(StaticCase& at, const char* stage, const Steps& steps,
                     const std::function<void(double reached, Continuation&)>& ease) {
  Continuation continuation = at.system.continuation();
  double reached = 0.0, step = steps.first;
  while (reached < 1.0 && step > steps.least && !at.spent()) {
    const LineState before = at.state;
    const double next = std::min(1.0, reached + step);
    ease(next, continuation);
    if (run_newton(at, continuation, next < 1.0 ? nearly(at) : finally(at), stage)) {
      reached = next;
      step *= steps.growth;
    } else {
      at.state = before;
      step *= 0.5;
    }
  }
  return reached >= 1.0;
}

/// Whether bottom rollers lean, so that the pipe slides off them unless side rollers hold it.
bool rollers_lean(const StaticCase& at) {
  constexpr double kLevel = 1e-6;
  return std::abs(at.model.mean_pose.R_WV.col(1).z()) > kLevel;
}

/// Soft rollers, then harder ones, in the vertical plane: no current, and no side rollers but where the vessel heels.
bool settle_in_plane(StaticCase& at) {
  Continuation in_plane = at.system.continuation();
  in_plane.side_rollers = rollers_lean(at);
  in_plane.current = 0.0;
  in_plane.max_roller_stiffness = soft_roller(at, at.target.value);
  NewtonSettings at_given_force = loosely(at);
  at_given_force.target.reset();
  run_newton(at, in_plane, at_given_force, "soft rollers");
  in_plane.max_roller_stiffness *= 10.0;
  return run_newton(at, in_plane, loosely(at), "harder rollers");
}

/// Whether any roller carries the pipe; a line without supports needs none.
bool carried(const StaticCase& at) {
  return !check_supports(at.model, at.system);
}

bool spatial(const StaticCase& at) {
  return !at.model.current.z.empty() ||
         std::any_of(at.model.supports.rollers.begin(), at.model.supports.rollers.end(),
                     [](const Roller& r) { return r.position != RollerPosition::bottom; });
}

constexpr double kNoLimit = 1e300;

/// Side rollers and current act as the model says it; rollers are this stiff at most.
Continuation in_space(const StaticCase& at, double max_roller_stiffness = kNoLimit) {
  Continuation continuation = at.system.continuation();
  continuation.side_rollers = true;
  continuation.current = 1.0;
  continuation.max_roller_stiffness = max_roller_stiffness;
  return continuation;
}

/// The bed acts as the model says it, too, where it is not softened.
Continuation whole(const StaticCase& at, double max_roller_stiffness = kNoLimit, double max_bed_stiffness = kNoLimit) {
  Continuation continuation = in_space(at, max_roller_stiffness);
  continuation.max_bed_stiffness = max_bed_stiffness;
  return continuation;
}

/// Rollers from soft to hard, first in the vertical plane, then with side rollers and current.
bool harden(StaticCase& at) {
  if (!settle_in_plane(at)) {
    return false;
  }
  run_newton(at, in_space(at, 100.0 * soft_roller(at, at.target.value)), gently(loosely(at), at),
             spatial(at) ? "side rollers and current" : "hard rollers");
  return run_newton(at, in_space(at), finally(at), "full stiffness") && carried(at);
}

/// A cable, which does not bend, turns sharply on each roller: from soft rollers to hard ones it takes steps.
bool cable_on_rollers(const Model& model) {
  if (!has_cable(model.description) || model.supports.rollers.empty()) return false;
  return !is_dragged(model.description) || pipe_ends(model.description) < model.supports.rows.back().from_top;
}

/// The current rises step by step on hard rollers, so that the pipe finds its side rollers gently. A step that fails is
/// halved: given up, it would leave the lay to softer ways, on which a pipe that its rollers can hold may slip off
/// them.
bool ease_in_current(StaticCase& at) {
  if (at.model.current.z.empty() || cable_on_rollers(at.model) || !settle_in_plane(at)) {
    return false;
  }
  constexpr double kFirst = 0.02, kGrowth = 1.5;
  Continuation first = in_space(at);
  first.current = kFirst;
  if (!run_newton(at, first, finally(at), "rising current")) {
    return false;
  }
  const Steps steps{.first = std::log(kGrowth) / -std::log(kFirst), .growth = 1.0, .least = 2e-3};
  const auto raise = [](double reached, Continuation& c) { c.current = std::pow(kFirst, 1.0 - reached); };
  return follow_in_steps(at, "rising current", steps, raise) && follow(at, "full current") && carried(at);
}

/// Rollers and bed from ten times a soft roller and a soft bed, which the state is the solution of, to what they are.
bool harden_in_steps(StaticCase& at) {
  const double soft = 10.0 * soft_roller(at, at.target.value), bed = soft_bed(at);
  const double rollers = std::max(hardest_roller(at) / soft, 1.0),
               beds = std::max(at.model.seabed.stiffness / bed, 1.0);
  return follow_in_steps(at, "hardening in steps", Steps{}, [&](double reached, Continuation& continuation) {
    continuation.max_roller_stiffness = reached < 1.0 ? soft * std::pow(rollers, reached) : kNoLimit;
    continuation.max_bed_stiffness = reached < 1.0 ? bed * std::pow(beds, reached) : kNoLimit;
  });
}

/// On soft rollers and a soft bed, which no step strikes hard, the current rises in steps; then both harden in steps.
bool ease_in_everything(StaticCase& at) {
  ease(at, [&](Continuation& c) { c.max_bed_stiffness = soft_bed(at); });
  if (!settle_in_plane(at)) {
    return false;
  }
  const auto raise = [](double reached, Continuation& continuation) {
    continuation.side_rollers = true;
    continuation.current = reached;
  };
  return follow_in_steps(at, "rising current on soft rollers", Steps{}, raise) && harden_in_steps(at) && carried(at);
}

/// The bed rises from a level one at the height where the first guess lands to its shape.
bool raise_bed(StaticCase& at) {
  LayPlane level = at.system.plane();
  const LayShape landing = lay_shape(at.model, level, at.target.value);
  if (!landing.problem.empty() || has_cable(at.model.description)) return false;
  const auto touchdown = std::ranges::lower_bound(landing.length, landing.touchdown);
  const double height = landing.z[static_cast<std::size_t>(touchdown - landing.length.begin())] - level.radius;
  level.surface = BedSurface(height * Vec3::UnitZ(), Vec3::UnitZ());
  at.state = sample_shape(at.system, lay_shape(at.model, level, at.target.value));
  ease(at, [&](Continuation& c) {
    c.bed_relief = 0.0;
    c.bed_level = height;
  });
  const auto raise = [](double reached, Continuation& c) { c.bed_relief = reached; };
  const bool risen = harden(at) && follow_in_steps(at, "bed raised to its shape", Steps{}, raise);
  ease(at, [](Continuation& c) {
    c.bed_relief = 1.0;
    c.bed_level = 0.0;
  });
  return risen && carried(at);
}

/// From a much larger tension, where the line is nearly straight, down to the wanted one.
bool descend(StaticCase& at) {
  const double wanted = at.target.value;
  const double higher = kHigherTension * wanted;
  const LayShape high = has_cable(at.model.description) ? stage_shape(at.model, at.system.plane(), higher)
                                                        : lay_shape(at.model, at.system.plane(), higher);
  at.state = sample_shape(at.system, high);
  at.target.value = higher;
  bool solved = cable_on_rollers(at.model) ? ease_in_everything(at) : harden(at);
  double ratio = 0.8;
  while (solved && at.target.value > wanted) {
    const LineState before = at.state;
    const double tension_before = at.target.value;
    at.target.value = std::max(wanted, tension_before * ratio);
    if (!follow(at, "lower tension")) {
      at.state = before;
      at.target.value = tension_before;
      ratio = std::sqrt(ratio);
      solved = ratio <= 0.99;
    }
  }
  at.target.value = wanted;  // whatever became of it: no other way may look for three times the tension
  return solved;
}

bool relax_and_finish(StaticCase& at) {
  const Continuation hard = whole(at, 100.0 * soft_roller(at, at.target.value));
  at.system.set(hard);
  RelaxationSettings settings;
  if (at.model.description.statics.method == StaticMethod::newton) {  // one who asks for relaxation shall have it all
    const double step = kLookWithout * at.size();
    const double steps = kShareOfRelaxation * (at.most_work() - at.work) / step;
    settings.max_steps = static_cast<int>(std::clamp(steps, 0.0, 1.0 * settings.max_steps));
    at.work += step * settings.max_steps;
  }
  const RelaxationReport r = relax(at.system, at.state, settings);
  at.report.relaxation_steps += r.steps;
  at.report.history.push_back(fmt::format("dynamic relaxation: {} steps, residual {:.2e}{}", r.steps, r.residual,
                                          r.diverged ? ", diverged" : ""));
  if (r.diverged || !std::isfinite(r.residual)) {
    return false;
  }
  run_newton(at, hard, gently(loosely(at), at), "Newton after relaxation");
  return follow(at, "full stiffness");
}

void note_left(StaticCase& at) {
  if (const std::optional<std::string> box = box_above_pipe(at.model, at.system, at.state)) {
    at.left = fmt::format(". In an attempt the pipe lay below the rollers of '{}', through which it cannot pass", *box);
  } else if (const std::optional<BoxLeft> left = first_box_left(at.model, at.system)) {
    at.left = fmt::format(". In an attempt the pipe lay beside '{}', {}", left->name, off_end_words(*left));
  }
}

/// A solution with the pipe beside some of its boxes is one of several: a pipe that lies on them in still water stays
/// there while the current rises, if its rollers can hold it. That solution, where there is one, is taken instead.
void look_on_rollers(StaticCase& at, const LayShape& shape) {
  if (at.model.current.z.empty() || cable_on_rollers(at.model) || boxes_left(at.model, at.system) == 0) return;
  const LineState beside = at.state;
  const double residual = at.report.force_residual, least = at.least_found;
  at.state = sample_shape(at.system, shape);
  if (ease_in_current(at) && boxes_left(at.model, at.system) == 0) {
    at.report.method = "newton, current raised in steps";
    return;
  }
  at.state = beside;
  at.report.force_residual = residual;
  at.least_found = least;
  at.system.set(whole(at));
  at.system.evaluate(at.state, true);
}

/// Where no way ends better: a solution with the pipe beside most of its boxes, which is hardly the lay that is meant.
struct Resort {
  std::optional<LineState> state;
  std::string method;
  double residual = 0.0;

  /// Whether the solution at hand is one; the first is kept.
  bool is_that(const StaticCase& at) {
    const auto boxes = static_cast<int>(at.model.supports.boxes.size());
    if (2 * boxes_left(at.model, at.system) <= boxes) return false;
    if (!state) {
      state = at.state;
      method = at.report.method;
      residual = at.report.force_residual;
    }
    return true;
  }
  bool take(StaticCase& at) const {
    if (!state) return false;
    at.state = *state;
    at.report.method = method + ", for want of a better end";
    at.report.force_residual = residual;
    at.system.set(whole(at));
    at.system.evaluate(at.state, true);
    return true;
  }
};

/// One way after another from the guess, with linear steel.
bool try_ways(StaticCase& at, const LayShape& shape, Resort& resort) {
  const auto works = [&](bool found) {
    if (found && !box_above_pipe(at.model, at.system, at.state)) return !resort.is_that(at);
    note_left(at);
    return false;
  };
  const StaticMethod wanted = at.model.description.statics.method;
  at.state = sample_shape(at.system, shape);
  if (wanted == StaticMethod::newton) {
    at.report.method = "newton";
    if (!cable_on_rollers(at.model) && works(harden(at))) {
      look_on_rollers(at, shape);
      return true;
    }
    if (at.model.seabed.surface.shape() != nullptr && at.target.kind == EquilibriumTarget::Kind::top_tension) {
      at.report.method = "newton, bed raised to its shape";
      if (works(raise_bed(at))) {
        look_on_rollers(at, shape);
        return true;
      }
    }
    at.report.method = "newton, current raised in steps";
    at.state = sample_shape(at.system, shape);
    if (works(ease_in_current(at))) {
      return true;
    }
    at.report.method = "newton, hardened in steps";
    at.state = sample_shape(at.system, shape);
    at.least_found = 0.0;
    if (works(ease_in_everything(at))) {
      return true;
    }
    if (at.least_found > 0.0) {
      return false;  // the gentlest way, too, ends in a line that lies slack: no other tells more
    }
    ease(at, [](Continuation& c) { c.max_bed_stiffness = kNoLimit; });
    at.report.method = "newton, tension lowered in steps";
    if (at.target.kind == EquilibriumTarget::Kind::top_tension && works(descend(at))) {
      return true;
    }
    at.state = sample_shape(at.system, shape);
  }
  at.report.method = "dynamic relaxation, then newton";
  return works(relax_and_finish(at));
}

}  // namespace

double StaticCase::size() const {
  const double elements = system.mesh().elements(), rollers = static_cast<double>(system.contacts().size());
  return elements + rollers * (kOfRoller + kOfSearch * elements);
}

double StaticCase::most_work() const {
  return std::max(kMostWork, kMostLooks * size());
}

bool follow(StaticCase& at, const char* stage) {
  return run_newton(at, whole(at), finally(at), stage);
}

bool follow_softly(StaticCase& at) {
  const Continuation soft = whole(at, 10.0 * soft_roller(at, at.target.value), soft_bed(at));
  return run_newton(at, soft, nearly(at), "softened") && harden_in_steps(at);
}

namespace {

bool solve_by_ways(StaticCase& at, const LayShape& shape) {
  Resort resort;
  return try_ways(at, shape, resort) || resort.take(at);
}

/// The bare pipe first; what is fixed to it then pulls more and more, at first very little: a wire may be much too
/// short for where the bare pipe is.
bool attach_in_steps(StaticCase& at, const LayShape& shape) {
  constexpr double kFirst = 1e-6;
  ease(at, [](Continuation& c) { c.attached = 0.0; });
  const bool solved = solve_by_ways(at, shape) && follow_in_steps(at, "clumps, buoys and wires in steps", Steps{},
                                                                  [](double reached, Continuation& c) {
                                                                    c.attached = std::pow(kFirst, 1.0 - reached);
                                                                  });
  ease(at, [](Continuation& c) { c.attached = 1.0; });
  return solved && carried(at);
}

}  // namespace

bool solve_elastic(StaticCase& at, const LayShape& shape) {
  const bool attached = !at.system.line().points.empty() || !at.system.line().wires.empty();
  if (attached && attach_in_steps(at, shape)) return true;
  at.least_found = 0.0;
  return solve_by_ways(at, shape);
}

namespace {

/// Name of the box whose roller is nearest to an element, where one is within a box length; else empty.
std::string box_at(const StaticCase& at, int element) {
  const std::vector<RollerContact>& contacts = at.system.contacts();
  int nearest = -1, distance = 4;  // elements
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const int off = std::abs(contacts[i].at.element - element);
    if (contacts[i].normal <= 0.0 || off >= distance) continue;
    distance = off;
    nearest = at.model.supports.rollers[i].box;
  }
  return nearest < 0 ? "" : at.model.supports.boxes[static_cast<std::size_t>(nearest)].name;
}

/// Where the equilibrium of linear steel bends pipe most beyond first yield.
std::string most_bent(StaticCase& at) {
  make_elastic(at);
  at.system.evaluate(at.state, false);
  const LineMesh& mesh = at.system.mesh();
  double ratio = 0.0;
  int worst = 0;
  for (int e = 0; e < mesh.elements(); ++e) {
    const auto i = static_cast<std::size_t>(e);
    const Section& section = at.model.sections[static_cast<std::size_t>(mesh.section[i])];
    if (!section.bending) continue;
    const ElementVector q(Eigen::Map<const ElementVector>(at.state.q.data() + 6 * i));
    const double first = 2.0 * section.yield_stress / (section.youngs_modulus * section.steel_diameter);
    for (const double xi : {0.0, 1.0}) {
      const double here = curvature_vector(centreline(q, xi, mesh.length[i])).norm() / first;
      if (here > ratio) {
        ratio = here;
        worst = e;
      }
    }
  }
  const std::string box = box_at(at, worst);
  return fmt::format(
      "{} from the tensioner{} pipe of linear steel would bend to {:.1f} times the curvature of first yield",
      shown(mesh.total_length() - mesh.s[static_cast<std::size_t>(worst)], "m", 1),
      box.empty() ? "" : ", at box '" + box + "',", ratio);
}

}  // namespace

void make_elastic(StaticCase& at) {
  ease(at, [](Continuation& c) { c.yielding = 0.0; });
}

bool let_yield(StaticCase& at) {
  ease(at, [](Continuation& c) { c.yielding = 1.0; });
  const LineState elastic = at.state;
  if (!at.system.line().yielding.any || follow(at, "yielding steel")) {
    return true;
  }
  at.state = elastic;
  const bool solved = follow_in_steps(at, "yielding in steps", Steps{.first = 0.25, .growth = 1.0, .least = 0.0025},
                                      [](double reached, Continuation& c) { c.yielding = reached; });
  if (!solved) {
    at.state = elastic;
    at.yielded = most_bent(at);
  }
  return solved;
}

}  // namespace overbend
