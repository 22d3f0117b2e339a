#include "seafiles/heading_table_builder.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"

namespace overbend {
namespace {

constexpr double kSameHeading = 1e-6;  // [rad]
constexpr double kSameValue = 1e-4;    // relative to the maximum force or moment: files print six digits
constexpr double kSameSide = 2e-2;     // relative, between both sides: panel meshes are not exactly symmetric
constexpr std::array<double, 6> kMirrored = {1.0, -1.0, 1.0, -1.0, 1.0, -1.0};

double wrapped(double heading) {
  const double turned = heading - kTurn * std::floor(heading / kTurn);
  return turned > kTurn - kSameHeading ? 0.0 : turned;
}

/// Returns the sorted values without those that are equal within `tolerance`.
std::vector<double> distinct(std::vector<double> values, double tolerance) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(), [&](double a, double b) { return b - a <= tolerance; }),
               values.end());
  return values;
}

/// Returns the index of a value that is present within `tolerance`.
std::size_t place(const std::vector<double>& sorted, double value, double tolerance) {
  const auto found = std::lower_bound(sorted.begin(), sorted.end(), value - tolerance);
  return static_cast<std::size_t>(found - sorted.begin());
}

std::string pair_label(double omega, double heading) {
  return "period " + format_number(kTurn / omega) + " s, heading " + format_number(heading * 360.0 / kTurn) + " deg";
}

}  // namespace

void HeadingTableBuilder::add(double omega, double heading, int mode, std::complex<double> value) {
  entries_.push_back({omega, wrapped(heading), mode, value});
}

Vec6 HeadingTableBuilder::tolerances(double of_mode, double of_kind) const {
  Vec6 max_magnitude = Vec6::Zero();
  for (const Entry& entry : entries_) {
    max_magnitude(entry.mode) = std::max(max_magnitude(entry.mode), std::abs(entry.value));
  }
  const double force = max_magnitude.head<3>().maxCoeff(), moment = max_magnitude.tail<3>().maxCoeff();
  Vec6 tolerance = of_mode * max_magnitude;
  tolerance.head<3>() = tolerance.head<3>().cwiseMax(of_kind * force);
  tolerance.tail<3>() = tolerance.tail<3>().cwiseMax(of_kind * moment);
  return tolerance;
}

std::vector<HeadingTableBuilder::Entry> HeadingTableBuilder::with_mirrored_entries() const {
  std::vector<Entry> entries = entries_;
  for (const Entry& entry : entries_) {
    const double sign = kMirrored[static_cast<std::size_t>(entry.mode)];
    entries.push_back({entry.omega, wrapped(-entry.heading), entry.mode, sign * entry.value, true});
  }
  return entries;
}

std::optional<HeadingTableBuilder::Built> HeadingTableBuilder::build(bool mirror, std::string& error) const {
  const std::vector<Entry> entries = mirror ? with_mirrored_entries() : entries_;
  Built built;
  for (const Entry& entry : entries) {
    built.table.omega.push_back(entry.omega);
    built.table.heading.push_back(entry.heading);
  }
  built.table.omega = distinct(std::move(built.table.omega), 0.0);
  built.table.heading = distinct(std::move(built.table.heading), kSameHeading);
  constexpr std::size_t kMaxPairs = 4'000'000;
  if (built.table.omega.size() > kMaxPairs / std::max<std::size_t>(built.table.heading.size(), 1)) {
    error = std::to_string(built.table.omega.size()) + " periods and " + std::to_string(built.table.heading.size()) +
            " headings, more than a table of 4 million pairs";
    return std::nullopt;
  }
  built.values.assign(built.table.omega.size() * built.table.heading.size(), CVec6::Zero());
  const Vec6 repeated = tolerances(kSameValue, kSameValue), alike = tolerances(kSameSide, kSameValue);
  std::vector<std::array<bool, 6>> given(built.values.size(), std::array<bool, 6>{}), mirrored = given;
  std::array<bool, 6> any{};
  for (const Entry& entry : entries) {
    const std::size_t index = built.table.index(place(built.table.omega, entry.omega, 0.0),
                                                place(built.table.heading, entry.heading, kSameHeading));
    const auto mode = static_cast<std::size_t>(entry.mode);
    std::complex<double>& value = built.values[index](entry.mode);
    const double difference = given[index][mode] ? std::abs(value - entry.value) : 0.0;
    if (difference > (entry.image ? alike : repeated)(entry.mode)) {
      error = (entry.image ? "a hull that is not symmetric although headings is mirrored: the two sides differ by " +
                                 format_number(100.0 * difference / (alike(entry.mode) / kSameSide), 2) +
                                 " % of the maximum at "
                           : "two different values at ") +
              pair_label(entry.omega, entry.heading) + ", mode " + std::to_string(mode + 1);
      return std::nullopt;
    }
    if (!given[index][mode]) {
      value = entry.value;
    } else if (entry.image && !mirrored[index][mode]) {
      value = 0.5 * (value + entry.value);  // mean of both sides; odd modes vanish on the centreline
    }
    given[index][mode] = any[mode] = true;
    mirrored[index][mode] = entry.image;
  }
  for (std::size_t i = 0; i < built.table.omega.size(); ++i) {
    for (std::size_t j = 0; j < built.table.heading.size(); ++j) {
      if (given[built.table.index(i, j)] != any) {
        error = "values missing for some or all modes at " + pair_label(built.table.omega[i], built.table.heading[j]);
        return std::nullopt;
      }
    }
  }
  return built;
}

}  // namespace overbend
