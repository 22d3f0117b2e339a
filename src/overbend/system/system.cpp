#include "system/system.h"

#include "mechanics/build_up.h"

namespace overbend {

EndMotion attached_to(const RigidMotion& body, const Vec3& place_V, const Vec3& direction_V) {
  const PointMotion place = point_motion(body, place_V);
  const DirectionMotion direction = direction_motion(body, direction_V);
  return {place.place, place.velocity, place.acceleration, direction.direction, direction.rate, direction.acceleration};
}

void lead_attachments(const System& system, Surroundings& now) {
  lead_attachments(system.attachments, now);
}

void lead_attachments(const std::vector<Attachment>& attachments, Surroundings& now) {
  for (std::size_t i = 0; i < attachments.size(); ++i) {
    const Attachment& attachment = attachments[i];
    EndMotion& end = now.ends[i];
    if (attachment.body == kGround) {
      end = EndMotion{};
      end.place = attachment.place;
      end.direction = attachment.direction;
    } else {
      end = attached_to(now.bodies[static_cast<std::size_t>(attachment.body)], attachment.place, attachment.direction);
    }
  }
}

double tensioner_authority(const System& system, double time) {
  return half_cosine(time, system.build_up).value;
}

const TensionerLaw& tensioner_of(const System& system) {
  static const TensionerLaw kBrake;
  return system.machine < 0 ? kBrake : system.attachments[static_cast<std::size_t>(system.machine)].tensioner;
}

}  // namespace overbend
