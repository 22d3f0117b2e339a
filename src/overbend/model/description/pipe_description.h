/// Pipe as given in the model file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/line_description.h"
#include "model/description/section_description.h"
#include "model/description/structure_description.h"

namespace overbend {

/// Length of line with its own section, counted from the tensioner astern.
struct SegmentDescription {
  std::string name;
  double length = 0.0;  ///< Unstressed length [m].
  SectionDescription section;
};

struct PipeDescription {
  SectionDescription section;                    ///< Main section, used outside the segments.
  std::vector<SegmentDescription> segments;      ///< From the tensioner astern; the remaining line has `section`.
  std::vector<StructureDescription> structures;  ///< In-line structures; they replace the segments at their position.
  std::vector<LinePointDescription> points;      ///< Clumps and buoys; lengths from the tensioner.
  std::optional<double> length;                  ///< Unstressed length from tensioner to anchor [m].
  std::optional<double> anchor;                  ///< Horizontal distance of the anchor astern of the stern shoe [m].
};

}  // namespace overbend
