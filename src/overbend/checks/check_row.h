/// Helpers to fill rows of the table of checks.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "checks/check_station.h"

namespace overbend {

inline constexpr const char* kDnv = "DNV-ST-F101 (2021)";

/// Constant texts of a row.
struct CheckTitle {
  const char* id;
  const char* name;
  const char* code;
  const char* clause;
  const char* quantity;  ///< What demand and capacity are.
  const char* units;
};

inline CheckRow row_of(const CheckTitle& title, CheckRegion region) {
  CheckRow row;
  row.id = title.id;
  row.name = title.name;
  row.code = title.code;
  row.clause = title.clause;
  row.quantity = title.quantity;
  row.units = title.units;
  row.region = region;
  return row;
}

/// Its location; and its time, for a value of a dynamic run.
inline void place_row(CheckRow& row, const CheckStation& station) {
  row.s = station.s;
  row.from_top = station.from_top;
  row.p_W = station.p_W;
}
inline void time_row(CheckRow& row, double time) {
  row.in_time = true;
  row.time = time;
}

/// Passed or exceeded by the utilisation.
inline void judge(CheckRow& row) {
  row.status = row.utilisation > 1.0 ? CheckStatus::exceeded : CheckStatus::passed;
}

/// Utilisation and reserve factor of a demand that is in proportion to its load effect; judges.
inline void judge_ratio(CheckRow& row, double demand, double capacity) {
  row.demand = demand;
  row.capacity = capacity;
  row.utilisation = demand / capacity;
  row.reserve = row.utilisation > 0.0 ? std::min(1.0 / row.utilisation, kLargestReserve) : kLargestReserve;
  judge(row);
}

inline CheckRow not_done(CheckRow row, std::string why) {
  row.status = CheckStatus::not_done;
  row.remark = std::move(why);
  return row;
}

inline void outside(CheckRow& row, std::string why) {
  row.status = CheckStatus::outside_validity;
  row.remark = std::move(why);
}

/// The station of a region (any for `line`) where `used` is largest; null where the region has no station.
template <class Used>
const CheckStation* most_used(const CheckStations& all, CheckRegion region, Used used) {
  const CheckStation* worst = nullptr;
  double largest = 0.0;
  for (const CheckStation& station : all.stations) {
    if (!counts_in(station, region)) continue;
    const double value = used(station);
    if (worst == nullptr || value > largest) {
      worst = &station;
      largest = value;
    }
  }
  return worst;
}

/// Whether any pipe of a region is of a section for which `of_section` is true.
template <class OfSection>
bool any_section(const CheckStations& all, CheckRegion region, OfSection of_section) {
  return std::any_of(all.stations.begin(), all.stations.end(), [&](const CheckStation& station) {
    return counts_in(station, region) && of_section(all.section_of(station));
  });
}

/// The regions that are judged one by one: those of a laid pipe, a line by itself as a whole.
inline std::span<const CheckRegion> judged_regions(const CheckStations& all) {
  static constexpr std::array kOfPipe = {CheckRegion::tower, CheckRegion::overbend, CheckRegion::tip,
                                         CheckRegion::sagbend, CheckRegion::seabed};
  static constexpr std::array kOfLine = {CheckRegion::line};
  return all.line.empty() ? std::span<const CheckRegion>(kOfPipe) : kOfLine;
}

}  // namespace overbend
