#include "system/line.h"

#include <algorithm>

#include "base/constants.h"
#include "base/ranges.h"
#include "model/bodies.h"
#include "model/pipe_attachments.h"
#include "moorings/catenary_line.h"
#include "system/cable_line.h"

namespace overbend {
namespace {

LineWire line_wire(const Model& model, const FreeLineDescription& line, int node) {
  const LineEndDescription& far = is_on_pipe(model.description, line.first) ? line.second : line.first;
  LineWire wire;
  wire.node = node;
  wire.reversed = is_on_pipe(model.description, line.first);
  wire.wire.name = line.name;
  wire.wire.first_body = is_on_vessel(far) ? 0 : kGround;
  wire.wire.first = is_on_vessel(far) ? far.at : end_place(model, far);
  wire.wire.length = unstressed_length(line);
  wire.wire.axial_stiffness = axial_stiffness(line);
  if (is_weightless(line)) return wire;
  wire.catenary = catenary_line(line.segments, {}, 0.0, kGravity);
  if (wire.reversed) ranges::reverse(wire.catenary->pieces);
  return wire;
}

void attach(const Model& model, Line& line) {
  for (const PipeAttachment& attachment : pipe_attachments(model.description)) {
    const double s = line.mesh.total_length() - attachment.from_top;
    if (s <= 0.0) continue;
    const int node = node_at(line.mesh, s);
    if (attachment.point != nullptr) {
      line.points.push_back(line_point(model, *attachment.point, node));
    } else {
      line.wires.push_back(line_wire(model, *attachment.line, node));
    }
  }
}

}  // namespace

Vec3 end_place(const Model& model, const LineEndDescription& end) {
  switch (end.kind) {
    case LineEndKind::body: {
      const VesselPose pose = body_poses(model)[body_index(model.description, end.body)];
      return pose.p_WV + pose.R_WV * end.at;
    }
    case LineEndKind::bed:
      return {end.at.x(), end.at.y(), model.seabed.surface.height(end.at.x(), end.at.y())};
    case LineEndKind::fixed:
    case LineEndKind::water:
    case LineEndKind::free:
    case LineEndKind::line:
      break;
  }
  return end.at;
}

double weight_from(const LineMesh& mesh, const LineElements& elements, double from) {
  double weight = 0.0;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    if (mesh.s[e] >= from) weight += elements.weight[e] * mesh.length[e];
  }
  return weight;
}

Line pipe_line(const Model& model, LineMesh mesh, const LayRoute& route) {
  Line line;
  line.mesh = std::move(mesh);
  line.elements = line_elements(model, line.mesh.length, line.mesh.section);
  line.environment = line_environment(model, route);
  line.route = route.pieces();
  line.yielding = yielding_elements(model, line.mesh);
  line.force_scale = weight_from(line.mesh, line.elements, line.mesh.s.front());
  attach(model, line);
  return line;
}

}  // namespace overbend
