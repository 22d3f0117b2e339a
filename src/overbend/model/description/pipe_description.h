/// The pipe as the model file has it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/line_description.h"
#include "model/description/section_description.h"
#include "model/description/structure_description.h"

namespace overbend {

/// A stretch of line with a section of its own, counted from the tensioner astern.
struct SegmentDescription {
  std::string name;
  double length = 0.0;  ///< Unstressed length [m].
  SectionDescription section;
};

struct PipeDescription {
  SectionDescription section;                    ///< Of the line where no segment says otherwise.
  std::vector<SegmentDescription> segments;      ///< From the tensioner astern; the rest has `section`.
  std::vector<StructureDescription> structures;  ///< Built in, over segments and all.
  std::vector<LinePointDescription> points;      ///< Clumps and buoys; lengths from the tensioner.
  std::optional<double> length;                  ///< Unstressed length from tensioner to anchor [m].
  std::optional<double> anchor;                  ///< Horizontal distance of the anchor astern of the stern shoe [m].
};

}  // namespace overbend
