#include "statics/solver/floating_hull.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "hull/make_hull.h"
#include "model/vessel/station.h"
#include "statics/solver/rest_together.h"

namespace overbend {
namespace {

using Freedoms = std::array<bool, 6>;
constexpr Freedoms kAllHeld = {true, true, true, true, true, true};
constexpr Freedoms kUprightHeld = {false, false, true, true, true, false};
constexpr Freedoms kFree{};

constexpr double kLongTime = 1e6;  ///< As in rest_together(): without inertia, friction goes with the way [s].
constexpr double kSoft = 100.0;    ///< Of the springs behind which the stiffness is measured [N/m].
constexpr double kLeastStiffness =
    1.0;  ///< What gives way more easily is not held [N/m], at half the length for turns.

/// The waves whose mean drift acts in statics: those of the model's own seed.
Sea drifting_sea(const Description& d) {
  if (!d.statics.mean_drift.value_or(false)) return {};
  return make_sea(d.environment.waves, d.environment.water_depth, d.environment.waves.seed);
}

/// Of the balance: the weight of the lines, but no less than a thousandth of the water that the hull displaces.
double scale_of(const System& system, const Hull& hull, const VesselDescription& vessel) {
  double weight = 1e-3 * hull.hydrostatics(2, 2) * vessel.draught;
  for (const Line& line : system.lines) weight = std::max(weight, line.force_scale);
  return weight;
}

/// The vessel of a system at rest, with what may hold it besides.
class Vessel {
 public:
  Vessel(const Model& model, const LinesSetup& setup)
      : model_(model), setup_(setup), half_length_(0.5 * model.description.vessel.length) {}

  /// Rest with two springs of this stiffness, at bow and stern, to where they were in `drawn`.
  bool rest(double stiffness, const Freedoms& held, const HullState& drawn, SystemState& state) const {
    const System system = held_by_springs(stiffness, held, drawn);
    Assembly assembly(system);
    assembly.set_time(state.time, state);
    assembly.impose_ends(state);
    RestSettings settings;
    settings.max_iterations = 300;
    settings.body_step = {5.0, 0.2};
    for (std::size_t i = 0; i < state.lines.size(); ++i) {
      settings.tolerance = std::max(settings.tolerance, rounding_residual(system.lines[i], state.lines[i].q));
    }
    SystemState found = state;
    if (!rest_together(assembly, found, settings).converged) return false;
    state = std::move(found);
    put_at_rest(state);
    return true;
  }

  /// Forces left on the vessel where it is, J^T F.
  Vec6 unbalanced(SystemState state) const {
    Assembly assembly(setup_.system);
    const SystemState laid = state;
    Equilibrium equilibrium(assembly, {LayHistory::monotonic, &laid, kLongTime});
    equilibrium.evaluate(state, false);
    return Eigen::Map<const Vec6>(assembly.body_residual().data());
  }

  /// Of all that acts, by its coordinates, horizontal ones along the hull; nothing where it cannot be told.
  std::optional<Mat6> stiffness(SystemState state) const {
    const HullState& hull = state.bodies.front();
    const System system = held_by_springs(kSoft, kFree, hull);
    const BodyPose pose = pose_of(hull.h);
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

  System held_by_springs(double stiffness, const Freedoms& held, const HullState& at) const {
    System system = setup_.system;
    FreeBody& body = *system.bodies[kVessel].free;
    body.held = held;
    if (stiffness == 0.0) return system;
    const BodyPose pose = pose_of(at.h);
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

  static void put_at_rest(SystemState& state) {
    state.bodies.front().slow = slow_rest(state.bodies.front().h);
    state.bodies.front().lines.clear();
  }

  const Model& model_;
  const LinesSetup& setup_;
  double half_length_;
};

/// Directions in which no force comes up against a small move, by the modes that are softest.
std::vector<std::string> unheld_directions(const Mat6& stiffness, double arm) {
  Vec6 scale = Vec6::Ones();
  scale.tail<3>().setConstant(1.0 / arm);
  const Eigen::EigenSolver<Mat6> modes(scale.asDiagonal() * stiffness * scale.asDiagonal());
  std::vector<std::string> names;
  for (Eigen::Index k = 0; k < 6; ++k) {
    if (modes.eigenvalues()(k).real() >= kLeastStiffness) continue;
    Eigen::Index most = 0;
    modes.eigenvectors().col(k).cwiseAbs().maxCoeff(&most);
    const std::string name = kFreedomNames[static_cast<std::size_t>(most)];
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

StaticFailure not_held(const std::vector<std::string>& directions) {
  return {"nothing holds the vessel, which floats free, in " + join_words(directions, "and"), "vessel",
          "give it lines that pull there, dynamic positioning (station_keeping), or hold it: leave out "
          "vessel.hydrostatics or vessel.motion.coupled",
          true, "lines"};
}

StaticFailure not_at_rest() {
  return {"no equilibrium was found", "", "lines and the vessel do not come to rest together"};
}

/// With soft springs that are taken away step by step, where lines are slack as drawn.
bool rest_by_way_of_springs(const Vessel& vessel, double stiffest, const Freedoms& held, SystemState& state) {
  constexpr double kSofter = 0.1, kLeast = 1e-2;  // [N/m]
  const HullState drawn = state.bodies.front();
  double stiffness = stiffest;
  while (stiffness > kLeast) {
    if (!vessel.rest(stiffness, held, drawn, state)) return false;
    stiffness *= kSofter;
  }
  return vessel.rest(0.0, held, drawn, state);
}

std::optional<StaticFailure> find_rest(const Vessel& vessel, double scale, const Freedoms& held, SystemState& state) {
  if (vessel.rest(0.0, held, state.bodies.front(), state)) return std::nullopt;
  if (rest_by_way_of_springs(vessel, scale, held, state)) return std::nullopt;
  if (const std::optional<Mat6> stiffness = vessel.stiffness(state)) {
    const std::vector<std::string> unheld = unheld_directions(*stiffness, vessel.half_length());
    if (!unheld.empty()) return not_held(unheld);
  }
  return not_at_rest();
}

}  // namespace

void float_vessel(const Model& model, LinesSetup& setup) {
  const Description& d = model.description;
  if (!hull_is_free(d)) return;
  setup.hull = std::make_shared<Hull>(make_hull_at_rest(model, drifting_sea(d)));
  setup.hull->mean_drift_from_start = true;
  FreeBody& body = setup.system.bodies[kVessel].free.emplace(
      free_hull(*setup.hull, scale_of(setup.system, *setup.hull, d.vessel), d.vessel.length));
  body.held = kAllHeld;
}

HeldVessel find_what_holds_vessel(const Model& model, const LinesSetup& setup, const SystemState& state) {
  HeldVessel held;
  const Vessel vessel(model, setup);
  const std::optional<Mat6> stiffness = vessel.stiffness(state);
  if (!stiffness) {
    held.failure = not_at_rest();
    return held;
  }
  const std::vector<std::string> unheld = unheld_directions(*stiffness, vessel.half_length());
  if (!unheld.empty()) held.failure = not_held(unheld);
  held.stiffness = *stiffness - setup.hull->hydrostatics;
  return held;
}

HeldVessel let_vessel_float(const Model& model, LinesSetup& setup, SystemState& state) {
  HeldVessel held;
  const Vessel vessel(model, setup);
  FreeBody& body = *setup.system.bodies[kVessel].free;
  const std::optional<CoupledHullDescription>& coupled = model.description.vessel.coupled;
  if (coupled && coupled->ballast == Ballast::trim) {
    held.failure = find_rest(vessel, body.force_scale, kUprightHeld, state);
    if (held.failure) return held;
    setup.hull->ballast.segment<3>(2) += vessel.unbalanced(state).segment<3>(2);
  }
  held.failure = find_rest(vessel, body.force_scale, kFree, state);
  if (held.failure) return held;
  held = find_what_holds_vessel(model, setup, state);
  if (!held.failure) body.held = kFree;
  return held;
}

}  // namespace overbend
