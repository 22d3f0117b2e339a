#include "study/run/history_peaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/constants.h"

namespace overbend {
namespace {

std::vector<double> times(int count, double step, double from) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(from + step * i);
  return all;
}

/// Period 10 s, amplitude growing by one each time.
std::vector<double> growing(const std::vector<double>& time) {
  std::vector<double> all;
  for (const double t : time) all.push_back(std::floor(1.0 + std::abs(t) / 10.0) * std::sin(2.0 * kPi * t / 10.0));
  return all;
}

TEST(find_peaks, peaks_are_those_after_the_build_up_with_the_time_they_cover) {
  const std::vector<double> time = times(1001, 0.5, -100.0);
  const PeakRecord record = find_peaks(time, growing(time), false);
  ASSERT_GE(record.peaks.size(), 38u);  // 40 periods, the first and last not whole
  EXPECT_NEAR(record.duration, 10.0 * static_cast<double>(record.peaks.size()), 1.0);
  EXPECT_NEAR(record.peaks[1] - record.peaks[0], 1.0, 1e-9);
}

TEST(find_peaks, smallest_values_are_peaks_of_the_negative) {
  const std::vector<double> time = times(801, 0.5, 0.0);
  std::vector<double> values = growing(time);
  const PeakRecord max_magnitude = find_peaks(time, values, false);
  for (double& value : values) value = -value;
  EXPECT_EQ(find_peaks(time, values, true).peaks, max_magnitude.peaks);
}

TEST(find_peaks, a_history_with_gaps_has_none) {
  const std::vector<double> time = times(100, 0.5, 0.0);
  std::vector<double> values = growing(time);
  values[50] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(find_peaks(time, values, false).peaks.empty());
}

TEST(find_peaks, roller_loads_are_those_of_the_box_that_has_most_at_the_instant) {
  const std::vector<double> time = times(400, 0.5, 0.0);
  std::vector<std::vector<double>> data = {time, growing(time), growing(time)};
  for (double& value : data[2]) value = 3.0 * value;
  const std::vector<HistoryColumn> columns = {
      {"time", "s", ""}, {"support/a/reaction", "N", ""}, {"support/b/reaction", "N", ""}};
  const std::vector<HistoryPeaks> peaks = find_run_peaks(columns, [&](std::size_t i) { return data[i]; });
  const HistoryPeaks* load = find_result_peaks(peaks, "largest_reaction");
  ASSERT_NE(load, nullptr);
  std::vector<double> max_value;
  for (std::size_t i = 0; i < time.size(); ++i) max_value.push_back(std::max(data[1][i], data[2][i]));
  EXPECT_EQ(load->record.peaks, find_peaks(time, max_value, false).peaks);
  EXPECT_NEAR(load->record.peaks.back(), *std::max_element(data[2].begin(), data[2].end()), 10.0);
}

TEST(find_peaks, a_result_finds_its_history_by_either_of_its_names) {
  const std::vector<HistoryPeaks> peaks = {{"top_tension_low", true, {}}, {"overbend_von_mises_peak", false, {}}};
  EXPECT_EQ(find_result_peaks(peaks, "top_tension_min"), &peaks[0]);
  EXPECT_EQ(find_result_peaks(peaks, "dynamic.top_tension.min"), &peaks[0]);
  EXPECT_EQ(find_result_peaks(peaks, "dynamic.overbend.max_von_mises"), &peaks[1]);
  EXPECT_EQ(find_result_peaks(peaks, "dynamic.sagbend.max_von_mises"), nullptr);
  EXPECT_EQ(find_result_peaks(peaks, "dynamic.lay_back.max"), nullptr);
}

}  // namespace
}  // namespace overbend
