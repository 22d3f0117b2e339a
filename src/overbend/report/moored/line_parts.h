/// Division of a line with a cable into pipe, head and cable.
#pragma once

#include <optional>

#include "model/pipe/section.h"
#include "results/static_results.h"

namespace overbend {

/// Arc lengths from the far end [m].
struct LineParts {
  double head_from = 0.0, head_to = 0.0;
  bool cable_at_far_end = false;  ///< True if the cable is between the far end and the head; false between the head and
                                  ///< the tensioner.

  /// Returns the kind of section at arc length s from the far end [m].
  SectionKind at(double s) const {
    if (s >= head_from && s <= head_to) return SectionKind::head;
    return (s < head_from) == cable_at_far_end ? SectionKind::cable : SectionKind::pipe;
  }
};

/// Returns none for a line without a cable. The cable is attached to one end of the head; `head_length` [m] extends to
/// the other side.
inline std::optional<LineParts> line_parts(const StaticResults& results, double head_length) {
  if (!results.head) return std::nullopt;
  const double s = results.head->s;
  return results.far_anchor ? LineParts{s, s + head_length, true} : LineParts{s - head_length, s, false};
}

/// Returns the head length of an operation [m]; 0 if unknown.
inline double find_head_length(const LayOperationDescription& lay) {
  return lay.head ? lay.head->length : 0.0;
}

}  // namespace overbend
