#include "dynamics/setup/floating_initial_state.h"

#include "dynamics/setup/mooring_lines.h"
#include "statics/solver/coupled_equilibrium.h"

#include <algorithm>
#include <utility>

namespace overbend {
namespace {

/// Maximum move of the hull between two equilibria [m], [rad].
constexpr double kMaxHullMove = 0.25, kMaxHullRotation = 0.0087;
/// Minimum share of the first move; moves are halved when the lines do not converge.
constexpr double kMinMoveShare = 1e-2;

/// Share of an offset for the first move.
double first_share(const Vec6& offset) {
  return std::min(
      {1.0, kMaxHullMove / (offset.head<3>().norm() + 1e-300), kMaxHullRotation / (offset.tail<3>().norm() + 1e-300)});
}

void hold_hull(Assembly& assembly, bool held) {
  for (int freedom = 0; freedom < 6; ++freedom) {
    assembly.hold_body(0, freedom, held);
  }
}

StaticFailure no_equilibrium(const char* what, const CoupledSolveReport& report, const char* remedy) {
  return {what,
          report.worst_place.first == kBodyPlace ? "the forces on the hull do not balance"
                                                 : "the forces on a line do not balance",
          remedy};
}

/// Converts an offset along and about the axes of the hull in its nominal pose to its coordinates.
Vec6 in_world(Vec6 offset, const Vec6& drawn) {
  offset.head<3>() = turned_about_z(drawn(5)) * offset.head<3>();
  return offset;
}

}  // namespace

std::optional<StaticFailure> solve_floating_equilibrium(Assembly& assembly, Ballast ballast, Hull& hull,
                                                        SystemState& state) {
  assembly.set_time(state.time, state);
  for (std::size_t i = 0; i < assembly.tensioners().size(); ++i) {
    const Attachment& held = assembly.system().attachments[assembly.tensioners()[i].attachment];
    const bool locked = held.tensioner->mode == TensionerMode::locked;
    assembly.set_drive(i, locked ? TensionerDrive::brake : TensionerDrive::governor);
  }
  assembly.impose_ends(state);
  if (ballast == Ballast::trim) {
    SystemState held = state;
    assembly.evaluate(held, state, {}, false);
    for (Eigen::Index freedom = 2; freedom < 5; ++freedom) {  // heave, roll, pitch
      hull.ballast(freedom) += assembly.body_residual()[static_cast<std::size_t>(freedom)];
    }
  }
  const CoupledSolveReport report = solve_coupled_equilibrium(assembly, state);
  for (HullState& body : state.bodies) {
    body.slow = slow_motion_at_rest(body.h);
  }
  if (report.converged) {
    return std::nullopt;
  }
  return no_equilibrium("no equilibrium of hull and lines was found", report,
                        "check that the hull is held in surge, sway and yaw");
}

std::optional<StaticFailure> offset_hull(Assembly& assembly, const Vec6& offset, SystemState& state) {
  const Vec6 from = state.bodies.front().h;
  const double first = first_share(offset);
  hold_hull(assembly, true);
  CoupledSolveReport report;
  for (double done = 0.0, share = first; done < 1.0 && share > kMinMoveShare * first;) {
    SystemState moved = state;
    const double next = std::min(1.0, done + share);
    moved.bodies.front().h = from + next * offset;
    report = solve_coupled_equilibrium(assembly, moved);
    share = report.converged ? std::min(first, 2.0 * share) : 0.5 * share;
    if (report.converged) {
      state = std::move(moved);
      done = next;
    }
  }
  hold_hull(assembly, false);
  state.bodies.front().slow = slow_motion_at_rest(state.bodies.front().h);
  if (report.converged) {
    return std::nullopt;
  }
  return no_equilibrium("no equilibrium of pipe and lines was found at the release position of the hull", report,
                        "release it closer to its equilibrium");
}

std::optional<StaticFailure> release_hull(const System& system, Ballast ballast, Hull& hull, const Vec6& release,
                                          SystemState& state) {
  const System pulled = with_mobilised_friction(system, state);
  Assembly pulling(pulled);
  if (std::optional<StaticFailure> failure = solve_floating_equilibrium(pulling, ballast, hull, state)) return failure;
  Assembly lying(system);
  std::optional<StaticFailure> failure = solve_floating_equilibrium(lying, Ballast::as_given, hull, state);
  if (!failure && !release.isZero()) failure = offset_hull(lying, in_world(release, hull.drawn), state);
  return failure;
}

}  // namespace overbend
