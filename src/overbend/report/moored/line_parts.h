/// Which stretches of a line with a cable are pipe, head and cable.
#pragma once

#include <optional>

#include "model/pipe/section.h"
#include "results/static_results.h"

namespace overbend {

/// Arc lengths from the far end [m].
struct LineParts {
  double head_from = 0.0, head_to = 0.0;
  bool cable_at_far_end = false;  ///< From the far end to the head; else from the head to the tensioner.

  SectionKind at(double s) const {
    if (s >= head_from && s <= head_to) return SectionKind::head;
    return (s < head_from) == cable_at_far_end ? SectionKind::cable : SectionKind::pipe;
  }
};

/// None for a line without a cable. The cable takes the head at one end; `head_length` [m] lies on the other side.
inline std::optional<LineParts> line_parts(const StaticResults& results, double head_length) {
  if (!results.head) return std::nullopt;
  const double s = results.head->s;
  return results.far_anchor ? LineParts{s, s + head_length, true} : LineParts{s - head_length, s, false};
}

/// Of an operation; 0 where its head is not known.
inline double head_length_of(const LayOperationDescription& lay) {
  return lay.head ? lay.head->length : 0.0;
}

}  // namespace overbend
