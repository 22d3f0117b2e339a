#include "modelfile/reading/mooring_reach.h"

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "base/units.h"

namespace overbend {
namespace {

constexpr double kMaxStrain = 0.1;  ///< Strain of a line with unknown breaking load [-].

/// Distance from the fairlead to the anchor, the vessel upright in its nominal pose [m].
double distance_to_anchor(const Description& d, const MooringLineDescription& line) {
  const double height = line.fairlead.z() + d.environment.water_depth;
  if (!line.anchor) return std::hypot(line.anchor_distance.value_or(0.0), height);
  const double s = std::sin(d.vessel.heading), c = std::cos(d.vessel.heading);
  const double x = s * line.fairlead.x() - c * line.fairlead.y(), y = c * line.fairlead.x() + s * line.fairlead.y();
  return std::hypot((*line.anchor)[0] - x, (*line.anchor)[1] - y, height);
}

/// Length of a line stretched until a segment breaks [m]; infinite if a length is open.
double compute_max_length(const MooringLineDescription& line) {
  double min_load = 1e300, length = 0.0;
  for (const LineSegmentDescription& segment : line.segments) {
    const LineTypeDescription& type = segment.type;
    min_load = std::min(min_load, type.breaking_load.value_or(kMaxStrain * type.axial_stiffness));
  }
  for (const LineSegmentDescription& segment : line.segments) {
    if (!segment.length) return 1e300;
    length += *segment.length * (1.0 + min_load / segment.type.axial_stiffness);
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
    const double distance = distance_to_anchor(description, line), reach = compute_max_length(line);
    if (line.segments.empty() || reach >= distance) continue;
    const FieldValue* length_key = lines->children[i].find("length");
    const FieldValue& key = length_key != nullptr ? *length_key : *lines->children[i].find("segments");
    diagnostics.add({Severity::error, description.source_file, key.line, 0, key.path,
                     "a line too short to reach: " + shown_digits(reach, "m", 6) + " at its breaking load",
                     "at least the " + shown_digits(distance, "m", 6) + " from its fairlead to its anchor",
                     "with the vessel as drawn"});
  }
}

}  // namespace overbend
