/// Helpers to fill rows of the check table.
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
  const char* quantity;  ///< Quantity of demand and capacity.
  const char* units;
};

inline CheckRow make_row(const CheckTitle& title, CheckRegion region) {
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

/// Sets the location of a row, and the time of a value from a dynamic run.
inline void set_row_location(CheckRow& row, const CheckStation& station) {
  row.s = station.s;
  row.from_top = station.from_top;
  row.p_W = station.p_W;
}
inline void set_row_time(CheckRow& row, double time) {
  row.in_time = true;
  row.time = time;
}

/// Sets passed or exceeded from the utilisation.
inline void set_row_verdict(CheckRow& row) {
  row.status = row.utilisation > 1.0 ? CheckStatus::exceeded : CheckStatus::passed;
}

/// Sets utilisation and reserve factor of a demand proportional to its load effect, and the verdict.
inline void set_utilisation(CheckRow& row, double demand, double capacity) {
  row.demand = demand;
  row.capacity = capacity;
  row.utilisation = demand / capacity;
  row.reserve = row.utilisation > 0.0 ? std::min(1.0 / row.utilisation, kMaxReserve) : kMaxReserve;
  set_row_verdict(row);
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

/// Returns the station of a region (any for `line`) with the maximum of `used`; null if the region has no station.
template <class Used>
const CheckStation* find_governing_station(const CheckStations& all, CheckRegion region, Used used) {
  const CheckStation* worst = nullptr;
  double max_value = 0.0;
  for (const CheckStation& station : all.stations) {
    if (!counts_in(station, region)) continue;
    const double value = used(station);
    if (worst == nullptr || value > max_value) {
      worst = &station;
      max_value = value;
    }
  }
  return worst;
}

/// True if any pipe of a region has a section for which `of_section` is true.
template <class OfSection>
bool any_section(const CheckStations& all, CheckRegion region, OfSection of_section) {
  return std::any_of(all.stations.begin(), all.stations.end(), [&](const CheckStation& station) {
    return counts_in(station, region) && of_section(all.section_for(station));
  });
}

/// Returns the regions checked individually: those of a laid pipe, or a single region for a standalone line.
inline std::span<const CheckRegion> checked_regions(const CheckStations& all) {
  static constexpr std::array kOfPipe = {CheckRegion::tower, CheckRegion::overbend, CheckRegion::tip,
                                         CheckRegion::sagbend, CheckRegion::seabed};
  static constexpr std::array kOfLine = {CheckRegion::line};
  return all.line.empty() ? std::span<const CheckRegion>(kOfPipe) : kOfLine;
}

}  // namespace overbend
