#include "dynamics/mooring_lines.h"

#include <algorithm>

#include "statics/cable_start.h"

namespace overbend {
namespace {

/// Segments and points from the anchor to the fairlead: the description counts from the fairlead.
CableParts from_the_anchor(const MooringsDescription& moorings, const MooringLineDescription& described,
                           const MooredLine& moored) {
  CableParts parts{described.segments, described.points};
  parts.segments.front().length = moored.line.first_segment();
  for (LineSegmentDescription& segment : parts.segments) {
    if (!segment.type.friction) {
      segment.type.friction = moorings.bed_friction;
    }
  }
  std::reverse(parts.segments.begin(), parts.segments.end());
  const double length = parts.length();
  for (LinePointDescription& point : parts.points) {
    point.at = length - point.at;
  }
  std::reverse(parts.points.begin(), parts.points.end());
  return parts;
}

Attachment anchor(int line, const Vec3& place_W) {
  Attachment held;
  held.line = line;
  held.end = LineEnd::first;
  held.hold_place = true;
  held.place = place_W;
  return held;
}

Attachment fairlead(int line, const Vec3& place_V) {
  Attachment held;
  held.line = line;
  held.end = LineEnd::last;
  held.hold_place = true;
  held.body = 0;
  held.place = place_V;
  return held;
}

}  // namespace

LineShapes add_mooring_lines(const Model& model, const MooringSpread& spread, System& system) {
  LineShapes shapes;
  const MooringsDescription& moorings = *model.description.moorings;
  const double pipe_scale = system.lines.empty() ? 0.0 : system.lines.front().force_scale;
  for (std::size_t i = 0; i < spread.lines.size(); ++i) {
    const MooredLine& moored = spread.lines[i];
    if (moored.parted) continue;
    const CableParts parts = from_the_anchor(moorings, moorings.lines[i], moored);
    const Vec3 fairlead_W = model.mean_pose.p_WV + model.mean_pose.R_WV * moored.fairlead_V;
    const CableStart start = cable_start(model, parts, moored.anchor_W, fairlead_W);
    const int line = static_cast<int>(system.lines.size());
    system.lines.push_back(cable_line(model, parts, {start.touchdown(), std::nullopt}, moored.anchor_W, fairlead_W));
    // What may be left unbalanced at a node of the pipe may be at one of a wire, which pulls as hard as the pipe.
    system.lines.back().force_scale = std::max(system.lines.back().force_scale, pipe_scale);
    system.attachments.push_back(anchor(line, moored.anchor_W));
    system.attachments.push_back(fairlead(line, moored.fairlead_V));
    shapes.push_back(start.shape(system.lines.back().mesh));
  }
  return shapes;
}

std::vector<std::string> mooring_names(const MooringSpread& spread) {
  std::vector<std::string> names;
  for (const MooredLine& line : spread.lines) {
    if (!line.parted) names.push_back(line.name);
  }
  return names;
}

}  // namespace overbend
