#include "modelfile/reading/mooring_reach.h"

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "base/units.h"

namespace overbend {
namespace {

constexpr double kMostStretch = 0.1;  ///< Of a line whose breaking load is not known [-].

/// Way from the fairlead to the anchor, the vessel upright and as drawn [m].
double way_to_anchor(const Description& d, const MooringLineDescription& line) {
  const double height = line.fairlead.z() + d.environment.water_depth;
  if (!line.anchor) return std::hypot(line.anchor_distance.value_or(0.0), height);
  const double s = std::sin(d.vessel.heading), c = std::cos(d.vessel.heading);
  const double x = s * line.fairlead.x() - c * line.fairlead.y(), y = c * line.fairlead.x() + s * line.fairlead.y();
  return std::hypot((*line.anchor)[0] - x, (*line.anchor)[1] - y, height);
}

/// Stretched until a segment breaks [m]; endless where a length is open.
double longest(const MooringLineDescription& line) {
  double least = 1e300, length = 0.0;
  for (const LineSegmentDescription& segment : line.segments) {
    const LineTypeDescription& type = segment.type;
    least = std::min(least, type.breaking_load.value_or(kMostStretch * type.axial_stiffness));
  }
  for (const LineSegmentDescription& segment : line.segments) {
    if (!segment.length) return 1e300;
    length += *segment.length * (1.0 + least / segment.type.axial_stiffness);
  }
  return length;
}

}  // namespace

void check_reach(const FieldValue& root, const Description& description, Diagnostics& diagnostics) {
  const FieldValue* lines = root.find("moorings.lines");
  const SeabedDescription& bed = description.environment.seabed;
  const bool level = bed.slope == 0.0 && bed.profile.empty() && bed.bathymetry_file.empty();
  if (!description.moorings || lines == nullptr || !level) return;
  for (std::size_t i = 0; i < std::min(lines->children.size(), description.moorings->lines.size()); ++i) {
    const MooringLineDescription& line = description.moorings->lines[i];
    const double way = way_to_anchor(description, line), reach = longest(line);
    if (line.segments.empty() || reach >= way) continue;
    const FieldValue* own = lines->children[i].find("length");
    const FieldValue& at = own != nullptr ? *own : *lines->children[i].find("segments");
    diagnostics.add({Severity::error, description.source_file, at.line, 0, at.path,
                     "a line too short to reach: " + shown_digits(reach, "m", 6) + " when it breaks",
                     "at least the " + shown_digits(way, "m", 6) + " from its fairlead to its anchor",
                     "with the vessel as drawn"});
  }
}

}  // namespace overbend
