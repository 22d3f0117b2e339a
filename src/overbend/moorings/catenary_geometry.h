/// Shape of a line for a given horizontal force at its fairlead: suspended spans that touch the bed without entering
/// it, and the parts on the bed between them. Derived in docs/theory/moorings.md.
#pragma once

#include <array>

#include "base/constants.h"
#include "moorings/catenary_integration.h"

namespace overbend {

/// Ends and seabed of a line in its vertical plane.
struct CatenarySite {
  double fairlead_z = 0.0;   ///< Height over mean water level [m].
  double anchor_z = 0.0;     ///< Height over mean water level; on a sloping bed the anchor lies on the bed [m].
  bool has_bed = true;       ///< If false, the line is suspended freely.
  double bed_z = 0.0;        ///< Height of the bed under the fairlead [m].
  double bed_descent = 0.0;  ///< Fall of the bed per metre towards the anchor [-].

  /// Height of the bed at a distance from the fairlead; far below if there is no bed [m].
  Dual bed_at(const Dual& x) const { return has_bed ? bed_z - bed_descent * x : Dual(-kInfinity); }
};

/// Position on a line: piece, and unstressed length into it.
struct LinePosition {
  std::size_t piece = 0;
  Dual into;  ///< [m]
};

/// Suspended span, and the state at its start.
struct CatenarySpan {
  CatenaryState start;
  LinePosition from, to;
};

/// Maximum number of suspended spans of a line.
inline constexpr std::size_t kMaxSpans = 6;

enum class GeometryError { none, no_shape, floats, too_many_spans };

/// Derivatives of the duals are with respect to force, height and first length; those with respect to the span start
/// are zero.
struct CatenaryGeometry {  // NOLINT(clang-analyzer-optin.performance.Padding): in the order of subjects
  GeometryError error = GeometryError::none;
  CatenarySite site;     ///< Site of the line.
  Dual reach;            ///< Horizontal distance from the fairlead to the end of the line [m].
  Dual sink;             ///< Vertical force of the line at the fairlead, positive downwards [N].
  CatenaryState end;     ///< State at the anchor; `sink` is negative where the line approaches it from below.
  double on_bed = 0.0;   ///< Unstressed length on the bed [m].
  bool touches = false;  ///< The line reaches the bed before its end.
  double touchdown_s = 0.0, touchdown_x = 0.0;  ///< Unstressed length and horizontal distance from the fairlead to the
                                                ///< touchdown point [m].
  bool ends_on_bed = false;                     ///< The part next to the anchor lies on the bed.
  std::array<CatenarySpan, kMaxSpans> spans;
  std::size_t span_count = 0;
};

/// Computes the line for a horizontal force above 0 [N]. `sink_guess`: initial vertical force at the fairlead [N].
CatenaryGeometry compute_catenary_geometry(const CatenaryLine& line, const CatenarySite& site, double pull,
                                           double sink_guess);

}  // namespace overbend
