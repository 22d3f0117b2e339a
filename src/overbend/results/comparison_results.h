/// Results of variants of one model in the same dynamic run. Plain data, SI units.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "results/dynamic_results.h"
#include "results/seeds_results.h"

namespace overbend {

enum class ComparisonType { tensioner, contact, impacts };

template <>
inline constexpr std::array kEnumNames<ComparisonType> = {
    Word{ComparisonType::tensioner, "tensioner"},
    Word{ComparisonType::contact, "contact"},
    Word{ComparisonType::impacts, "impacts"},
};

/// Interval in which the tensioner was in one state without interruption.
struct TensionerSpan {
  double from = 0.0, to = 0.0;  ///< [s]
  int state = 0;                ///< 0 holds, 1 delay, 2 pays out, 3 hauls in, 4 at its limit.
};

/// Histories of the tensioner at every output step from a given time on.
struct DetailHistories {
  std::vector<double> time, tension, travel;  ///< [s], [N], [m]
};

struct ComparedRun {
  std::string name;              ///< Identifier for scripts and of the folder: "off".
  std::string label;             ///< Label for readers: "off, held by the brake".
  DynamicResults results{};      ///< Histories thinned.
  std::vector<double> values{};  ///< One value for each quantity.
  std::vector<TensionerSpan> states{};
  DetailHistories close{};
};

/// Statistics of a roller box in one variant.
struct ComparedBox {
  double contact_share = 0.0;                   ///< Share of time in contact [-].
  double static_reaction = 0.0;                 ///< Resultant [N].
  double mean_reaction = 0.0;                   ///< [N]
  double peak_reaction = 0.0;                   ///< [N]
  double peak_force = 0.0;                      ///< Maximum normal force of one roller [N].
  double dent_depth = 0.0;                      ///< Under that force [m].
  double line_load = 0.0;                       ///< Under that force, on the coating [N/m].
  std::vector<double> row_share{}, row_peak{};  ///< Bottom rollers by row: [-], [N]; a single value for a gap spring.
};

struct ComparedBoxes {
  std::string name;
  bool stinger = false;
  std::vector<ComparedBox> runs;  ///< In the order of the runs.
};

struct Comparison {
  ComparisonType of = ComparisonType::tensioner;
  double duration = 0.0, build_up = 0.0;  ///< [s]
  double detail_start = 0.0;              ///< Start of the interval stored at full resolution [s].
  std::vector<SeedQuantity> quantities;
  std::vector<ComparedRun> runs;
  std::vector<ComparedBoxes> boxes;  ///< Only in a comparison of contact or impacts.
};

}  // namespace overbend
