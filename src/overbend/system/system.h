/// Lines, bodies and attachments of a system: constant during a run.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/mobilised_friction.h"
#include "mechanics/tensioner.h"
#include "mechanics/vessel_motion.h"
#include "mechanics/winch.h"
#include "system/body.h"
#include "system/line.h"
#include "system/wire.h"

namespace overbend {

/// Connection of a line end to a body or the ground. A pipe is moved along `direction` by a tensioner, regardless of
/// whether the guide holds the pipe's direction or lets it rotate.
struct Attachment {
  int line = 0;
  LineEnd end = LineEnd::first;
  int node = 0;  ///< Node of an inner attachment.
  bool hold_place = false;
  std::optional<Vec3> free_along;  ///< For a held position: unit vector (W) along which it may move nevertheless.
  bool hold_direction = false;     ///< The tangent keeps the guide's direction; its length stays free.
  int body = kGround;
  Vec3 place = Vec3::Zero(), direction = Vec3::UnitX();  ///< In the body's frame; W on the ground [m].
  std::optional<TensionerLaw> tensioner;                 ///< Moves the end along the guide, if held by a tensioner.
  std::optional<WinchLaw> winch;  ///< If the end is on a winch, which changes the length of the last element.
  /// Holding capacity of an anchor on the ground; beyond it drags along the line [N].
  double holding = std::numeric_limits<double>::infinity();
  double parts_at = std::numeric_limits<double>::infinity();  ///< Time of the line failure at this end [s].
};

/// Returns the node of a line that an attachment holds.
inline int held_node(const Attachment& held, const Line& line) {
  if (held.end == LineEnd::inner) return held.node;
  return held.end == LineEnd::first ? 0 : line.mesh.nodes() - 1;
}

/// Motion of an attachment: position and direction of the guide with their rates, W.
struct EndMotion {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(), acceleration = Vec3::Zero();
  Vec3 direction = Vec3::UnitX(), direction_rate = Vec3::Zero(), direction_acceleration = Vec3::Zero();
};

/// Time-dependent surroundings: everything that depends on time only.
struct Surroundings {
  std::vector<RigidMotion> bodies;  ///< Free bodies, and the ends they hold, are set from the state by Assembly.
  std::vector<EndMotion> ends;      ///< Per attachment.
  /// Per line: waves at its nodes, kWaterValues each; empty in calm water.
  std::vector<std::vector<double>> water;
};

/// Sets the surroundings, which have their sizes, at a time. Called once per step; must not allocate after the first
/// call.
using SurroundingsAt = std::function<void(double time, Surroundings& surroundings)>;

/// Constant data of a system.
struct System {
  std::vector<Line> lines;
  std::vector<Body> bodies;
  std::vector<Attachment> attachments;
  std::vector<Wire> wires;
  std::vector<int> far_forces;  ///< Lines whose first end slides under an unknown force, LineState::far_force.
  double build_up = 0.0;        ///< Duration before t = 0 over which the tensioner is ramped up [s].
  MobilisedFriction rub;        ///< Friction of the rollers at rest, the initial state of a run.
  SurroundingsAt surroundings;
};

/// Returns the motion of an attachment on a body with this motion.
EndMotion attached_to(const RigidMotion& body, const Vec3& place_V, const Vec3& direction_V);

/// Sets the motion of every attachment from that of its body; on the ground it is at rest.
void set_attachment_motions(const System& system, Surroundings& surroundings);
void set_attachment_motions(const std::vector<Attachment>& attachments, Surroundings& surroundings);

/// Returns the ramp factor of the tensioner's response velocity: it is ramped up with the sea.
double tensioner_ramp_factor(const System& system, double time);

/// Index of the vessel among the bodies of a system.
inline constexpr std::size_t kVessel = 0;

/// Returns the attachments moved by a tensioner.
std::vector<std::size_t> find_tensioners(const System& system);

/// The laid pipe: its line and the attachment of its tensioner.
struct LaidPipe {
  std::size_t line = 0, tensioner = 0;
};
std::optional<LaidPipe> find_laid_pipe(const System& system);

/// Returns the lines of a role, in the order of the system.
std::vector<std::size_t> find_lines(const System& system, LineRole role);
/// Returns the first of them; the number of lines if there is none.
std::size_t first_line(const System& system, LineRole role);

/// Returns the attachment that holds an end of a line; empty if there is none.
std::optional<std::size_t> find_attachment(const System& system, std::size_t line, LineEnd end);

}  // namespace overbend
