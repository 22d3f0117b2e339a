#include "statics/lines_setup.h"

#include "system/vessel_body.h"

namespace overbend {
namespace {

Attachment attachment_of(const Model& model, const LineEndDescription& end, int line, LineEnd which) {
  Attachment attachment;
  attachment.line = line;
  attachment.end = which;
  attachment.hold_place = true;
  attachment.hold_direction = end.clamped;
  attachment.direction = end.clamped ? Vec3(end.direction.normalized()) : Vec3::UnitX();
  attachment.body = end.kind == LineEndKind::body ? 0 : kGround;
  attachment.place = end.kind == LineEndKind::body ? end.at : end_place(model, end);
  return attachment;
}

}  // namespace

Vec3 end_place(const Model& model, const LineEndDescription& end) {
  switch (end.kind) {
    case LineEndKind::body:
      return model.mean_pose.p_WV + model.mean_pose.R_WV * end.at;
    case LineEndKind::bed:
      return {end.at.x(), end.at.y(), model.seabed.surface.height(end.at.x(), end.at.y())};
    case LineEndKind::fixed:
    case LineEndKind::water:
      break;
  }
  return end.at;
}

LinesSetup lines_setup(const Model& model) {
  LinesSetup setup;
  System& system = setup.system;
  system.bodies.resize(1);
  int number = 0;
  for (const FreeLineDescription& line : model.description.lines) {
    const CableParts parts{line.segments, line.points};
    const Vec3 first = end_place(model, line.first), second = end_place(model, line.second);
    const CableStart start = cable_start(model, parts, first, second);
    system.lines.push_back(cable_line(model, parts, {start.touchdown(), line.element}, first, second));
    setup.start.push_back(start.shape(system.lines.back().mesh));
    system.attachments.push_back(attachment_of(model, line.first, number, LineEnd::first));
    system.attachments.push_back(attachment_of(model, line.second, number, LineEnd::last));
    ++number;
  }
  // By value: the system may be moved.
  system.surroundings = [vessel = resting(model.mean_pose), ends = system.attachments](double, Surroundings& now) {
    now.bodies.front() = vessel;
    lead_attachments(ends, now);
  };
  return setup;
}

SystemState start_of(const LinesSetup& setup, double time) {
  return state_at_rest(setup.system, setup.start, time);
}

}  // namespace overbend
