#include "seafiles/heading_table_builder.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"

namespace overbend {
namespace {

constexpr double kSameHeading = 1e-6;  // [rad]
constexpr double kSameValue = 1e-4;    // of the mode's largest: files print six digits
constexpr std::array<double, 6> kMirrored = {1.0, -1.0, 1.0, -1.0, 1.0, -1.0};

double wrapped(double heading) {
  const double turned = heading - kTurn * std::floor(heading / kTurn);
  return turned > kTurn - kSameHeading ? 0.0 : turned;
}

/// Sorted, without those that are the same within `tolerance`.
std::vector<double> distinct(std::vector<double> values, double tolerance) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(), [&](double a, double b) { return b - a <= tolerance; }),
               values.end());
  return values;
}

/// Index of the value, which is there, within `tolerance`.
std::size_t place(const std::vector<double>& sorted, double value, double tolerance) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), value - tolerance);
  return static_cast<std::size_t>(at - sorted.begin());
}

std::string words(double omega, double heading) {
  return "period " + format_number(kTurn / omega) + " s, heading " + format_number(heading * 360.0 / kTurn) + " deg";
}

}  // namespace

void HeadingTableBuilder::add(double omega, double heading, int mode, std::complex<double> value) {
  entries_.push_back({omega, wrapped(heading), mode, value});
}

std::optional<HeadingTableBuilder::Built> HeadingTableBuilder::build(bool mirror, std::string& fault) const {
  std::vector<Entry> entries = entries_;
  if (mirror) {
    for (const Entry& entry : entries_) {
      const double sign = kMirrored[static_cast<std::size_t>(entry.mode)];
      entries.push_back({entry.omega, wrapped(-entry.heading), entry.mode, sign * entry.value});
    }
  }
  Built built;
  for (const Entry& entry : entries) {
    built.table.omega.push_back(entry.omega);
    built.table.heading.push_back(entry.heading);
  }
  built.table.omega = distinct(std::move(built.table.omega), 0.0);
  built.table.heading = distinct(std::move(built.table.heading), kSameHeading);
  built.values.assign(built.table.omega.size() * built.table.heading.size(), CVec6::Zero());
  Vec6 largest = Vec6::Zero();
  for (const Entry& entry : entries) {
    largest(entry.mode) = std::max(largest(entry.mode), std::abs(entry.value));
  }
  std::vector<std::array<bool, 6>> given(built.values.size(), std::array<bool, 6>{});
  std::array<bool, 6> any{};
  for (const Entry& entry : entries) {
    const std::size_t at = built.table.index(place(built.table.omega, entry.omega, 0.0),
                                             place(built.table.heading, entry.heading, kSameHeading));
    const auto mode = static_cast<std::size_t>(entry.mode);
    if (given[at][mode] && std::abs(built.values[at](entry.mode) - entry.value) > kSameValue * largest(entry.mode)) {
      fault = "two different values at " + words(entry.omega, entry.heading) + ", mode " + std::to_string(mode + 1);
      return std::nullopt;
    }
    if (!given[at][mode]) {
      built.values[at](entry.mode) = entry.value;
    }
    given[at][mode] = any[mode] = true;
  }
  for (std::size_t i = 0; i < built.table.omega.size(); ++i) {
    for (std::size_t j = 0; j < built.table.heading.size(); ++j) {
      if (given[built.table.index(i, j)] != any) {
        fault = "no values, or not of every mode, at " + words(built.table.omega[i], built.table.heading[j]);
        return std::nullopt;
      }
    }
  }
  return built;
}

}  // namespace overbend
