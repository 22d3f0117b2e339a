#include "statics/solver/floating_hull.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/ranges.h"
#include "base/text.h"
#include "hull/make_hull.h"
#include "model/site/wave_groups.h"
#include "model/vessel/mooring_queries.h"
#include "statics/solver/coupled_equilibrium.h"

namespace overbend {
namespace {

using Freedoms = std::array<bool, 6>;
constexpr Freedoms kAllHeld = {true, true, true, true, true, true};
constexpr Freedoms kUprightHeld = {false, false, true, true, true, false};
constexpr Freedoms kFree{};

constexpr double kLongTime =
    1e6;  ///< As in solve_coupled_equilibrium(): pseudo time step without inertia, for friction [s].
constexpr double kSoft = 100.0;  ///< Stiffness of the springs used to measure the stiffness [N/m].
constexpr double kMinHeldStiffness =
    1.0;  ///< Minimum stiffness of a held direction [N/m]; rotations at half the length.

/// Waves of the mean drift in statics: those of the model's own seed.
Sea drifting_sea(const Description& d) {
  if (!d.statics.mean_drift.value_or(false)) return {};
  return make_sea(d.environment.waves, d.environment.water_depth, default_seed(d.environment.waves));
}

/// Force scale of the equilibrium: weight of the lines, but at least 0.1 % of the displacement.
double compute_force_scale(const System& system, const Hull& hull, const VesselDescription& vessel) {
  double weight = 1e-3 * hull.hydrostatics(2, 2) * vessel.draught;
  for (const Line& line : system.lines) weight = std::max(weight, line.force_scale);
  return weight;
}

/// Vessel of a system in equilibrium, with auxiliary springs.
class Vessel {
 public:
  Vessel(const Model& model, const LinesSetup& setup)
      : model_(model), setup_(setup), half_length_(0.5 * model.description.vessel.length) {}

  /// Finds the equilibrium with two springs of this stiffness, at bow and stern, to their positions in `drawn`.
  bool solve(double stiffness, const Freedoms& held, const HullState& drawn, SystemState& state) const {
    const System system = held_by_springs(stiffness, held, drawn);
    Assembly assembly(system);
    assembly.set_time(state.time, state);
    assembly.impose_ends(state);
    CoupledSolveSettings settings;
    settings.max_iterations = 300;
    settings.body_step = {5.0, 0.2};
    for (std::size_t i = 0; i < state.lines.size(); ++i) {
      settings.tolerance = std::max(settings.tolerance, rounding_residual(system.lines[i], state.lines[i].q));
    }
    SystemState found = state;
    if (!solve_coupled_equilibrium(assembly, found, settings).converged) return false;
    state = std::move(found);
    reset_rates(state);
    return true;
  }

  /// Unbalanced forces on the vessel, J^T F.
  Vec6 unbalanced(SystemState state) const {
    Assembly assembly(setup_.system);
    const SystemState laid = state;
    Equilibrium equilibrium(assembly, {LayHistory::monotonic, &laid, kLongTime});
    equilibrium.evaluate(state, false);
    return Eigen::Map<const Vec6>(assembly.body_residual().data());
  }

  /// Total stiffness in its coordinates, horizontal ones along the hull; nullopt if the equations are singular.
  std::optional<Mat6> stiffness(SystemState state) const {
    const HullState& hull = state.bodies.front();
    const System system = held_by_springs(kSoft, kFree, hull);
    const BodyPose pose = make_pose(hull.h);
    Assembly assembly(system);
    const SystemState laid = state;
    Equilibrium equilibrium(assembly, {LayHistory::monotonic, &laid, kLongTime});
    equilibrium.evaluate(state, true);
    equilibrium.hold(true);
    if (!assembly.factor()) return std::nullopt;
    Mat6 flexibility, springs = Mat6::Zero();
    for (Eigen::Index k = 0; k < 6; ++k) {
      Increments unit = assembly.increments();
      unit.back()[static_cast<std::size_t>(k)] = 1.0;
      assembly.apply_factors(unit);
      flexibility.col(k) = Eigen::Map<const Vec6>(unit.back().data());
    }
    for (const Vec3& place : ends()) {
      const Mat36 rows = point_jacobian(pose, pose.R * (place - setup_.hull->reference_V));
      springs += kSoft * rows.transpose() * rows;
    }
    Mat6 turn = Mat6::Identity();
    turn.topLeftCorner<3, 3>() = turned_about_z(hull.h(5));
    return turn.transpose() * (flexibility.inverse() - springs) * turn;
  }

  double half_length() const { return half_length_; }

 private:
  /// Bow and stern at the height of the reference point, V.
  std::array<Vec3, 2> ends() const {
    const Vec3& middle = setup_.hull->reference_V;
    return {middle + half_length_ * Vec3::UnitX(), middle - half_length_ * Vec3::UnitX()};
  }

  System held_by_springs(double stiffness, const Freedoms& held, const HullState& fixed_at) const {
    System system = setup_.system;
    FreeBody& body = *system.bodies[kVessel].free;
    body.held = held;
    if (stiffness == 0.0) return system;
    const BodyPose pose = make_pose(fixed_at.h);
    for (const Vec3& place_V : ends()) {
      const Vec3 fixed = pose.place + pose.R * (place_V - body.reference_V);
      const auto pull = [=](const Vec3& place, double, const LineEndForces&) {
        PlaceForce spring;
        spring.force = stiffness * (fixed - place);
        spring.stiffness = stiffness * Mat3::Identity();
        return spring;
      };
      body.springs.push_back({place_V, pull});
    }
    return system;
  }

  static void reset_rates(SystemState& state) {
    state.bodies.front().slow = slow_motion_at_rest(state.bodies.front().h);
    state.bodies.front().lines.clear();
  }

  const Model& model_;
  const LinesSetup& setup_;
  double half_length_;
};

/// Directions without restoring force against small motions, from the softest modes.
std::vector<std::string> unheld_directions(const Mat6& stiffness, double arm) {
  Vec6 scale = Vec6::Ones();
  scale.tail<3>().setConstant(1.0 / arm);
  const Eigen::EigenSolver<Mat6> modes(scale.asDiagonal() * stiffness * scale.asDiagonal());
  std::vector<std::string> names;
  for (Eigen::Index k = 0; k < 6; ++k) {
    if (modes.eigenvalues()(k).real() >= kMinHeldStiffness) continue;
    Eigen::Index max_index = 0;
    modes.eigenvectors().col(k).cwiseAbs().maxCoeff(&max_index);
    const std::string name = kFreedomNames[static_cast<std::size_t>(max_index)];
    if (ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

StaticFailure not_held_failure(const std::vector<std::string>& directions) {
  return {"nothing holds the free-floating vessel in " + join_items(directions, "and"), "vessel",
          "add lines that act there or dynamic positioning (station_keeping), or hold the vessel: leave out "
          "vessel.hydrostatics or vessel.motion.coupled",
          true, "lines"};
}

StaticFailure no_equilibrium_failure() {
  return {"no equilibrium was found", "", "no common equilibrium of lines and vessel was found"};
}

/// With soft springs that are removed in steps, for lines that are slack in the nominal pose.
bool solve_with_fading_springs(const Vessel& vessel, double stiffest, const Freedoms& held, SystemState& state) {
  constexpr double kSofter = 0.1, kMinStiffness = 1e-2;  // [N/m]
  const HullState drawn = state.bodies.front();
  double stiffness = stiffest;
  while (stiffness > kMinStiffness) {
    if (!vessel.solve(stiffness, held, drawn, state)) return false;
    stiffness *= kSofter;
  }
  return vessel.solve(0.0, held, drawn, state);
}

std::optional<StaticFailure> find_vessel_equilibrium(const Vessel& vessel, double scale, const Freedoms& held,
                                                     SystemState& state) {
  if (vessel.solve(0.0, held, state.bodies.front(), state)) return std::nullopt;
  if (solve_with_fading_springs(vessel, scale, held, state)) return std::nullopt;
  if (const std::optional<Mat6> stiffness = vessel.stiffness(state)) {
    const std::vector<std::string> unheld = unheld_directions(*stiffness, vessel.half_length());
    if (!unheld.empty()) return not_held_failure(unheld);
  }
  return no_equilibrium_failure();
}

}  // namespace

void float_vessel(const Model& model, LinesSetup& setup) {
  const Description& d = model.description;
  if (!hull_is_free(d)) return;
  setup.hull = std::make_shared<Hull>(make_hull_at_rest(model, drifting_sea(d)));
  setup.hull->mean_drift_from_start = true;
  FreeBody& body = setup.system.bodies[kVessel].free.emplace(
      free_hull(*setup.hull, compute_force_scale(setup.system, *setup.hull, d.vessel), d.vessel.length));
  body.held = kAllHeld;
}

HeldVessel find_vessel_stiffness(const Model& model, const LinesSetup& setup, const SystemState& state) {
  HeldVessel held;
  const Vessel vessel(model, setup);
  const std::optional<Mat6> stiffness = vessel.stiffness(state);
  if (!stiffness) {
    held.failure = no_equilibrium_failure();
    return held;
  }
  const std::vector<std::string> unheld = unheld_directions(*stiffness, vessel.half_length());
  if (!unheld.empty()) held.failure = not_held_failure(unheld);
  held.stiffness = *stiffness - setup.hull->hydrostatics;
  return held;
}

HeldVessel release_vessel(const Model& model, LinesSetup& setup, SystemState& state) {
  HeldVessel held;
  const Vessel vessel(model, setup);
  FreeBody& body = *setup.system.bodies[kVessel].free;
  const std::optional<CoupledHullDescription>& coupled = model.description.vessel.coupled;
  if (coupled && coupled->ballast == Ballast::trim) {
    held.failure = find_vessel_equilibrium(vessel, body.force_scale, kUprightHeld, state);
    if (held.failure) return held;
    setup.hull->ballast.segment<3>(2) += vessel.unbalanced(state).segment<3>(2);
  }
  held.failure = find_vessel_equilibrium(vessel, body.force_scale, kFree, state);
  if (held.failure) return held;
  held = find_vessel_stiffness(model, setup, state);
  if (!held.failure) body.held = kFree;
  return held;
}

}  // namespace overbend
