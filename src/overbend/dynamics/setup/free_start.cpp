#include "dynamics/setup/free_start.h"

#include "dynamics/setup/mooring_lines.h"
#include "statics/solver/rest_together.h"

#include <algorithm>
#include <utility>

namespace overbend {
namespace {

constexpr double kLongestMove = 0.25, kLargestTurn = 0.0087;  ///< Of the hull between two equilibria [m], [rad].
constexpr double kSmallestShare = 1e-2;  ///< Of the first move, to which moves are halved where lines find no rest.

/// Share of an offset that one move may make.
double first_share(const Vec6& offset) {
  return std::min(
      {1.0, kLongestMove / (offset.head<3>().norm() + 1e-300), kLargestTurn / (offset.tail<3>().norm() + 1e-300)});
}

void hold_hull(Assembly& assembly, bool held) {
  for (int freedom = 0; freedom < 6; ++freedom) {
    assembly.hold_body(0, freedom, held);
  }
}

StaticFailure no_rest(const char* what, const RestReport& report, const char* remedy) {
  return {what,
          report.worst_place.first == kBodyPlace ? "the forces on the hull do not balance"
                                                 : "the forces on a line do not balance",
          remedy};
}

/// An offset along and about the axes of the hull as drawn, of its coordinates.
Vec6 in_world(Vec6 offset, const Vec6& drawn) {
  offset.head<3>() = turned_about_z(drawn(5)) * offset.head<3>();
  return offset;
}

}  // namespace

std::optional<StaticFailure> rest_afloat(Assembly& assembly, Ballast ballast, Hull& hull, SystemState& state) {
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
  const RestReport report = rest_together(assembly, state);
  for (HullState& body : state.bodies) {
    body.slow = slow_rest(body.h);
  }
  if (report.converged) {
    return std::nullopt;
  }
  return no_rest("hull and lines do not come to rest together", report,
                 "look whether anything holds the hull in surge, sway and yaw");
}

std::optional<StaticFailure> displace_hull(Assembly& assembly, const Vec6& offset, SystemState& state) {
  const Vec6 from = state.bodies.front().h;
  const double first = first_share(offset);
  hold_hull(assembly, true);
  RestReport report;
  for (double done = 0.0, share = first; done < 1.0 && share > kSmallestShare * first;) {
    SystemState moved = state;
    const double next = std::min(1.0, done + share);
    moved.bodies.front().h = from + next * offset;
    report = rest_together(assembly, moved);
    share = report.converged ? std::min(first, 2.0 * share) : 0.5 * share;
    if (report.converged) {
      state = std::move(moved);
      done = next;
    }
  }
  hold_hull(assembly, false);
  state.bodies.front().slow = slow_rest(state.bodies.front().h);
  if (report.converged) {
    return std::nullopt;
  }
  return no_rest("pipe and lines do not come to rest where the hull is let go", report, "let it go nearer to its rest");
}

std::optional<StaticFailure> let_hull_go(const System& system, Ballast ballast, Hull& hull, const Vec6& release,
                                         SystemState& state) {
  const System pulled = pulled_in(system, state);
  Assembly pulling(pulled);
  if (std::optional<StaticFailure> failure = rest_afloat(pulling, ballast, hull, state)) return failure;
  Assembly lying(system);
  std::optional<StaticFailure> failure = rest_afloat(lying, Ballast::as_given, hull, state);
  if (!failure && !release.isZero()) failure = displace_hull(lying, in_world(release, hull.drawn), state);
  return failure;
}

}  // namespace overbend
