#include "system/system.h"

#include "mechanics/build_up.h"

namespace overbend {

EndMotion attached_to(const RigidMotion& body, const Vec3& place_V, const Vec3& direction_V) {
  const PointMotion place = point_motion(body, place_V);
  const DirectionMotion direction = direction_motion(body, direction_V);
  return {place.place, place.velocity, place.acceleration, direction.direction, direction.rate, direction.acceleration};
}

void set_attachment_motions(const System& system, Surroundings& surroundings) {
  set_attachment_motions(system.attachments, surroundings);
}

void set_attachment_motions(const std::vector<Attachment>& attachments, Surroundings& surroundings) {
  for (std::size_t i = 0; i < attachments.size(); ++i) {
    const Attachment& attachment = attachments[i];
    EndMotion& end = surroundings.ends[i];
    if (attachment.body == kGround) {
      end = EndMotion{};
      end.place = attachment.place;
      end.direction = attachment.direction;
    } else {
      end = attached_to(surroundings.bodies[static_cast<std::size_t>(attachment.body)], attachment.place,
                        attachment.direction);
    }
  }
}

double tensioner_ramp_factor(const System& system, double time) {
  return half_cosine(time, system.build_up).value;
}

std::vector<std::size_t> find_tensioners(const System& system) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    if (system.attachments[i].tensioner) found.push_back(i);
  }
  return found;
}

std::optional<LaidPipe> find_laid_pipe(const System& system) {
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    const Attachment& held = system.attachments[i];
    if (held.tensioner) return LaidPipe{static_cast<std::size_t>(held.line), i};
  }
  return std::nullopt;
}

std::vector<std::size_t> find_lines(const System& system, LineRole role) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < system.lines.size(); ++i) {
    if (system.lines[i].role == role) found.push_back(i);
  }
  return found;
}

std::size_t first_line(const System& system, LineRole role) {
  std::size_t line = 0;
  while (line < system.lines.size() && system.lines[line].role != role) ++line;
  return line;
}

std::optional<std::size_t> find_attachment(const System& system, std::size_t line, LineEnd end) {
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    if (system.attachments[i].line == static_cast<int>(line) && system.attachments[i].end == end) return i;
  }
  return std::nullopt;
}

}  // namespace overbend
