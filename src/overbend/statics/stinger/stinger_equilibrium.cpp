#include "statics/stinger/stinger_equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "model/vessel/stinger_rotation.h"
#include "statics/stinger/stinger_search.h"

namespace overbend {
namespace {

constexpr double kScan = 1.0 * kDegree;  ///< Interval of angles in the scan for other equilibria.

std::vector<double> initial_angles(const SupportsDescription& supports, const StaticSolution* start) {
  std::vector<double> angles = prescribed_angles(supports);
  if (start == nullptr || start->stinger.angles.size() != angles.size()) return angles;
  for (const std::size_t i : floating_sections(supports)) angles[i] = start->stinger.angles[i];
  return angles;
}

/// Angle at which a section's moment is `wanted` with all others held; a stop if that is reached first.
std::optional<double> angle_with_moment(const Model& model, const StaticSolution& solution, std::size_t section,
                                        double wanted) {
  Model turned = model;
  StingerSearch search(turned, solution.past, {section}, {wanted});
  StaticOutcome outcome = search.find(solution.stinger.angles, &solution, {});
  if (outcome.failure) return std::nullopt;
  return outcome.solution->stinger.angles[section];
}

void find_friction_range(const Model& model, StaticSolution& solution, std::size_t section) {
  const StingerSectionDescription& described = model.description.supports.sections[section];
  if (!(described.hinge_friction > 0.0)) return;
  const std::optional<double> up = angle_with_moment(model, solution, section, described.hinge_friction);
  const std::optional<double> down = angle_with_moment(model, solution, section, -described.hinge_friction);
  if (up) solution.stinger.angle_up[section] = *up;
  if (down) solution.stinger.angle_down[section] = *down;
  if (!up || !down) {
    solution.stinger.findings.push_back(
        {FindingCode::stinger_friction_range,
         fmt::format("hinge friction may hold the stinger further {} than the range found", up ? "down" : "up")});
  }
}

/// Moment of the section about its hinge at an angle without the pipe, with the other sections held.
double moment_alone(const Model& model, std::vector<double> angles, std::size_t section, double angle) {
  Model turned = model;
  angles[section] = angle;
  rotate_stinger(turned.supports, angles);
  return hinge_moments(turned, {})[section];
}

/// Next equilibrium angle further down without the pipe; nullopt if there is none before the stop.
std::optional<double> find_equilibrium_without_pipe(const Model& model, const StaticSolution& solution,
                                                    std::size_t section) {
  const std::vector<double>& angles = solution.stinger.angles;
  const std::optional<StingerLimits>& limits = model.description.supports.sections[section].limits;
  const double stop = limits ? limits->down : kMaxStingerAngle;
  bool sinks = false;
  for (int step = 1; angles[section] + step * kScan < stop; ++step) {
    const double angle = angles[section] + step * kScan;
    const double moment = moment_alone(model, angles, section, angle);
    if (sinks && moment <= 0.0) return angle;
    sinks = moment > 0.0;
  }
  return sinks && limits ? std::optional(stop) : std::nullopt;
}

bool pipe_is_off(const Model& model, const StaticSolution& solution, std::size_t section, double angle) {
  Model turned = model;
  std::vector<double> angles = solution.stinger.angles;
  angles[section] = angle;
  rotate_stinger(turned.supports, angles);
  const StaticOutcome outcome = solve_statics(turned, nullptr, solution.past);
  if (outcome.failure) return false;
  StaticSystem system = system_with_history(turned, outcome.solution->mesh, solution.past);
  system.evaluate(outcome.solution->state, false);
  const std::vector<std::vector<PointForce>> pipe = pipe_on_sections(system);
  return std::all_of(pipe.begin() + static_cast<std::ptrdiff_t>(section), pipe.end(),
                     [](const std::vector<PointForce>& forces) { return forces.empty(); });
}

/// A stinger pressed down by the pipe may have another equilibrium, further down and without the pipe.
void find_other_equilibrium(const Model& model, StaticSolution& solution, std::size_t section) {
  const std::optional<double> below = find_equilibrium_without_pipe(model, solution, section);
  if (!below || !pipe_is_off(model, solution, section, *below)) return;
  solution.stinger.findings.push_back(
      Finding{FindingCode::other_equilibrium_possible,
              fmt::format("the stinger has another equilibrium near an angle of {:.1f} deg, where the pipe does not "
                          "touch it; the one found is reached from the nominal angle",
                          *below / kDegree)}
          .on("stinger")
          .with("angle", *below, "rad"));
}

}  // namespace

std::vector<std::size_t> floating_sections(const SupportsDescription& supports) {
  std::vector<std::size_t> floating;
  for (std::size_t i = 0; i < supports.sections.size(); ++i) {
    if (supports.sections[i].floats() && !supports.sections[i].angle) floating.push_back(i);
  }
  return floating;
}

std::vector<std::vector<PointForce>> pipe_on_sections(const StaticSystem& system) {
  const Supports& supports = system.model().supports;
  std::vector<std::vector<PointForce>> forces(supports.sections.size());
  for (std::size_t i = 0; i < supports.rollers.size(); ++i) {
    const RollerContact& contact = system.contacts()[i];
    const int section = supports.boxes[static_cast<std::size_t>(supports.rollers[i].box)].section;
    if (section < 0 || !(contact.normal > 0.0)) continue;
    forces[static_cast<std::size_t>(section)].push_back({-contact.force(), contact.closest.place});
  }
  return forces;
}

std::vector<double> hinge_moments(const Model& model, const std::vector<std::vector<PointForce>>& pipe) {
  const std::size_t n = model.supports.sections.size();
  std::vector<std::vector<PointForce>> forces;
  for (std::size_t i = 0; i < n; ++i) {
    forces.push_back(section_forces(model, i));
    if (!pipe.empty()) forces.back().insert(forces.back().end(), pipe[i].begin(), pipe[i].end());
  }
  std::vector<double> moments(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const HingeAxis hinge = hinge_axis(model, i);
    for (std::size_t behind = i; behind < n; ++behind) moments[i] += moment_about(hinge, forces[behind]);
  }
  return moments;
}

StaticOutcome solve_with_stinger(Model& model, const StaticSolution* start, const LoadHistory& past) {
  const SupportsDescription& supports = model.description.supports;
  if (supports.sections.empty()) return solve_statics(model, start, past);
  const std::vector<double> angles = initial_angles(supports, start);
  const std::vector<std::size_t> floating = floating_sections(supports);
  if (floating.empty()) {
    rotate_stinger(model.supports, angles);
    StaticOutcome outcome = solve_statics(model, start, past);
    if (outcome.solution) outcome.solution->stinger.angles = angles;
    return outcome;
  }
  StingerSearch search(model, past, floating);
  return search.find(angles, start, start == nullptr ? std::vector<double>() : start->stinger.stiffness);
}

void measure_stinger(const Model& model, StaticSolution& solution) {
  const SupportsDescription& supports = model.description.supports;
  if (supports.sections.empty()) return;
  StingerEquilibrium& stinger = solution.stinger;
  stinger.findings.clear();
  stinger.angle_up = stinger.angle_down = stinger.angles;
  const std::vector<std::size_t> floating = floating_sections(supports);
  if (floating.empty()) return;
  Model turned = model;
  StingerSearch search(turned, solution.past, floating);
  if (const auto falls = search.stiffness(stinger.angles, solution)) {
    stinger.stiffness.assign(falls->data(), falls->data() + falls->size());
    const Eigen::MatrixXd even = 0.5 * (*falls + falls->transpose());
    if (floating.size() > 1 && Eigen::LLT<Eigen::MatrixXd>(even).info() != Eigen::Success) {
      stinger.findings.push_back(
          Finding{FindingCode::stinger_unstable,
                  "the equilibrium of the stinger is unstable: a small rotation of its sections grows"}
              .on("stinger"));
    }
  }
  for (const std::size_t section : floating) find_friction_range(model, solution, section);
  if (floating.size() == 1) find_other_equilibrium(model, solution, floating[0]);
}

}  // namespace overbend
