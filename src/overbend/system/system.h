/// The system: lines, the bodies they meet, and what holds their ends. Constant during a run.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/roller_rub.h"
#include "mechanics/tensioner.h"
#include "mechanics/vessel_motion.h"
#include "mechanics/winch.h"
#include "system/body.h"
#include "system/line.h"
#include "system/wire.h"

namespace overbend {

/// What holds an end of a line to a body, or to the ground. A pipe is moved along `direction` by a machine, whether the
/// guide holds the pipe's direction or lets it turn.
struct Attachment {
  int line = 0;
  LineEnd end = LineEnd::first;
  int node = 0;  ///< Of an inner one.
  bool hold_place = false;
  std::optional<Vec3> free_along;  ///< Of a held place: the unit vector (W) along which it may move all the same.
  bool hold_direction = false;     ///< The tangent keeps the guide's direction; its length stays free.
  int body = kGround;
  Vec3 place = Vec3::Zero(), direction = Vec3::UnitX();  ///< In the body's frame; W on the ground [m].
  std::optional<TensionerLaw> tensioner;  ///< That moves the end along the guide, where it is held by one.
  std::optional<WinchLaw> winch;  ///< Where the end leaves a winch, which changes the length of its last element.
  /// Of an anchor on the ground: more than this drags it along the line [N].
  double holding = std::numeric_limits<double>::infinity();
  double parts_at = std::numeric_limits<double>::infinity();  ///< Lets the line go then [s].
};

/// The node of a line that an attachment holds.
inline int held_node(const Attachment& held, const Line& line) {
  if (held.end == LineEnd::inner) return held.node;
  return held.end == LineEnd::first ? 0 : line.mesh.nodes() - 1;
}

/// Motion of an attachment: place and direction of the guide with their rates, W.
struct EndMotion {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(), acceleration = Vec3::Zero();
  Vec3 direction = Vec3::UnitX(), direction_rate = Vec3::Zero(), direction_acceleration = Vec3::Zero();
};

/// The surroundings that move: everything that depends on time alone.
struct Surroundings {
  std::vector<RigidMotion> bodies;  ///< Free ones, and the ends they hold, are brought to the state by Assembly.
  std::vector<EndMotion> ends;      ///< Of the attachments.
  /// Line by line: waves at its nodes, kWaterValues each; empty in calm water.
  std::vector<std::vector<double>> water;
};

/// Sets the surroundings, which have their sizes, for a time. Called once per step, must not allocate after the first
/// call.
using SurroundingsAt = std::function<void(double time, Surroundings& now)>;

struct System {
  std::vector<Line> lines;
  std::vector<Body> bodies;
  std::vector<Attachment> attachments;
  std::vector<Wire> wires;
  std::vector<int> far_forces;  ///< Lines whose first end slides under a force of unknown size, LineState::far_force.
  double build_up = 0.0;        ///< Before t = 0, over which the tensioner is brought in [s].
  RollerRub rub;                ///< Friction of the rollers at rest, from which a run starts.
  SurroundingsAt surroundings;
};

/// Motion of an attachment whose body moves so.
EndMotion attached_to(const RigidMotion& body, const Vec3& place_V, const Vec3& direction_V);

/// Sets the motion of every attachment from that of its body; on the ground it stands still.
void lead_attachments(const System& system, Surroundings& now);
void lead_attachments(const std::vector<Attachment>& attachments, Surroundings& now);

/// Share of its response velocity that the tensioner may use: it is brought in with the sea.
double tensioner_authority(const System& system, double time);

/// The vessel among the bodies of a system.
inline constexpr std::size_t kVessel = 0;

/// The attachments that a tensioner moves.
std::vector<std::size_t> find_tensioners(const System& system);

/// The pipe that is laid: its line and the attachment of its tensioner.
struct LaidPipe {
  std::size_t line = 0, tensioner = 0;
};
std::optional<LaidPipe> find_laid_pipe(const System& system);

/// Lines of a role, in the order of the system.
std::vector<std::size_t> find_lines(const System& system, LineRole role);
/// The first of them; the number of lines where there is none.
std::size_t first_line(const System& system, LineRole role);

/// The attachment that holds an end of a line; nothing where none does.
std::optional<std::size_t> find_attachment(const System& system, std::size_t line, LineEnd end);

}  // namespace overbend
