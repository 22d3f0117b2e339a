/// The system: lines, the bodies they meet, and what holds their ends. Constant during a run.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "mechanics/roller_rub.h"
#include "mechanics/tensioner.h"
#include "mechanics/vessel_motion.h"
#include "mechanics/winch.h"
#include "system/body.h"
#include "system/line.h"

namespace overbend {

inline constexpr int kGround = -1;  ///< In place of a body: the world.

/// What holds an end of a line to a body, or to the ground. A pipe is moved along `direction` by a machine, whether the
/// guide holds the pipe's direction or lets it turn.
struct Attachment {
  int line = 0;
  LineEnd end = LineEnd::first;
  bool hold_place = false;
  bool hold_direction = false;  ///< The tangent keeps the guide's direction; its length stays free.
  int body = kGround;
  Vec3 place = Vec3::Zero(), direction = Vec3::UnitX();  ///< In the body's frame; W on the ground [m].
  TensionerLaw tensioner;         ///< Moves the end along the guide, where it is held; the default is a locked brake.
  std::optional<WinchLaw> winch;  ///< Where the end leaves a winch, which changes the length of its last element.
  /// Of an anchor on the ground: more than this drags it along the line [N].
  double holding = std::numeric_limits<double>::infinity();
  double parts_at = std::numeric_limits<double>::infinity();  ///< Lets the line go then [s].
};

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
  std::vector<int> far_forces;  ///< Lines whose first end slides under a force of unknown size, LineState::far_force.
  int machine = -1;             ///< The attachment whose tensioner acts; -1: none.
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

/// The law of the tensioner that acts; a locked brake where there is none.
const TensionerLaw& tensioner_of(const System& system);

/// Which of the lines is the first mooring line: they follow the pipe, where there is one.
inline std::size_t first_mooring(const System& system) {
  return system.machine < 0 ? 0 : 1;
}

}  // namespace overbend
