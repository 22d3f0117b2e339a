/// Low-frequency and wave-frequency part of a record: a low-pass filter without delay.
#pragma once

#include <span>
#include <vector>

namespace overbend {

/// Returns the part of equally spaced values, `step` [s] apart, with periods longer than `cut_off` [s]. A Butterworth
/// filter of sixth order by the bilinear transform [oppenheim1989, 7.1] runs forwards and then backwards over the
/// record, so that there is no delay; a sine of frequency f keeps the fraction
///
///     1 / (1 + (tan(pi f step) / tan(pi step / cut_off))^12)
///
/// of its amplitude: 0.998 at 0.6 of the cut-off frequency, 0.5 at the cut-off, 0.05 at 1.28 times. Constants pass
/// unchanged. The record is extended beyond its ends by point reflection about the end values; separation is less sharp
/// within about four cut-off periods of the ends. A cut-off shorter than four steps returns the values. Throws
/// std::invalid_argument unless step and cut_off are positive.
std::vector<double> low_pass(std::span<const double> values, double step, double cut_off);

}  // namespace overbend
