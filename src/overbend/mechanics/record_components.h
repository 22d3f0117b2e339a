/// Linear waves whose sum is a measured elevation.
#pragma once

#include <vector>

#include "model/description/waves_description.h"

namespace overbend {

/// Elevation at the point of the measurement: amplitude cos(phase - omega t).
struct RecordComponent {
  double amplitude = 0.0;  ///< [m]
  double omega = 0.0;      ///< [rad/s]
  double phase = 0.0;      ///< [rad]
};

/// Time over which the sea after the end of a record leads back to its beginning: 20 s, or a quarter of a shorter
/// record, rounded up to a length that is quick to transform. The components of a record have the period of its
/// duration plus this time [s].
double record_bridge(const ElevationRecord& record);

/// Returns the Fourier components of a record by increasing frequency; empty for fewer than two rows.
///
/// Their sum passes through the record at every instant, from t = 0 to its end. Outside, it is periodic: the gap
/// between the end and the next beginning is bridged by reflections of both, faded into each other, so that no jump
/// adds energy at high frequencies. Waves shorter than 0.5 s, and the smallest ones with 1e-7 of the variance together,
/// are left out.
std::vector<RecordComponent> record_components(const ElevationRecord& record);

}  // namespace overbend
