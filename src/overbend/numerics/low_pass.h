/// Slow and fast part of a record: a low-pass without delay.
#pragma once

#include <span>
#include <vector>

namespace overbend {

/// The part of equally spaced values, `step` [s] apart, with periods longer than `cut_off` [s]. A Butterworth filter of
/// sixth order by the bilinear transform [oppenheim1989, 7.1] runs forwards and then backwards over the record, so that
/// nothing is delayed; a sine of frequency f keeps the share
///
///     1 / (1 + (tan(pi f step) / tan(pi step / cut_off))^12)
///
/// of its amplitude: 0.998 at a frequency of 0.6 of the cut-off's, a half there, 0.05 at 1.28 times. Constants pass
/// unchanged. The record is continued beyond its ends by its image turned about the end's value; within about four
/// cut-off periods of the ends the parts are told apart less sharply for that. A cut-off shorter than four steps
/// returns the values. Throws std::invalid_argument unless step and cut_off are positive.
std::vector<double> low_pass(std::span<const double> values, double step, double cut_off);

}  // namespace overbend
