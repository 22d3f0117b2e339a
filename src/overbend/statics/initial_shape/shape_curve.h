/// Pieces of first guesses: points over the supports, curves between them, the laid tail.
#pragma once

#include "statics/initial_shape/lay_shape.h"

namespace overbend {

/// A point that the guess passes through, in the lay plane.
struct GuidePoint {
  double distance, z, dip;
};

/// Weight per length of a section at height z, buoyancy by the wetted share [N/m].
double weight_at(const Model& model, const Section& section, double z);

/// The line's axis at the tensioner and over every row of rollers, from there astern.
std::vector<GuidePoint> support_points(const Model& model, const LayPlane& plane, const VesselPose& pose);

/// The next point of the shape; lengths are those of chords.
void append_point(LayShape& shape, double distance, double z, double dip);

/// Cubic Hermite from the last point to the next, in steps of about a quarter of a metre.
void append_curve(LayShape& shape, const GuidePoint& to);

/// Laid line of a length behind the last point [m]; sets `total`.
void append_tail(LayShape& shape, const LayPlane& plane, double tail);

/// Laid length that is long enough for the bending of touchdown to have died out at its end, with some of the laid line
/// besides [m]. `suspended`: length of the free span.
double tail_length(const Model& model, double bottom_tension, double suspended);

/// The laid length that leaves as much behind what is fixed to the pipe [m]. `touchdown`: length from the top.
double tail_beyond_attachments(const Model& model, double touchdown, double tail);

}  // namespace overbend
