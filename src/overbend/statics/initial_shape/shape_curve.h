/// Parts of initial shapes: points over the supports, curves between them, the laid pipe.
#pragma once

#include "statics/initial_shape/lay_shape.h"

namespace overbend {

/// Point of the initial shape in the lay plane: distance, height [m], dip [rad].
struct GuidePoint {
  double distance, z, dip;
};

/// Weight per length of a section at height z, with buoyancy of its wetted share [N/m].
double weight_at(const Model& model, const Section& section, double z);

/// Axis of the line at the tensioner and over every row of rollers, from there astern.
std::vector<GuidePoint> support_points(const Model& model, const LayPlane& plane, const VesselPose& pose);

/// Appends a point to the shape; lengths are sums of chords.
void append_point(LayShape& shape, double distance, double z, double dip);

/// Appends a cubic Hermite curve from the last point to `to`, in steps of about 0.25 m.
void append_curve(LayShape& shape, const GuidePoint& to);

/// Appends laid line of length `tail` behind the last point [m]; sets `total`.
void append_tail(LayShape& shape, const LayPlane& plane, double tail);

/// Laid length at whose end the bending of the touchdown has decayed, with some additional laid pipe [m]. `suspended`:
/// length of the free span [m].
double tail_length(const Model& model, double bottom_tension, double suspended);

/// Laid length that leaves the same length behind the last structure fixed to the pipe [m]. `touchdown`: length from
/// the top [m].
double tail_beyond_attachments(const Model& model, double touchdown, double tail);

}  // namespace overbend
