/// Results of variants of one model in the same dynamic run. Plain data, SI units.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/words.h"
#include "results/dynamic_results.h"
#include "results/seeds_results.h"

namespace overbend {

enum class ComparisonOf { tensioner, contact, impacts };

template <>
inline constexpr std::array kWords<ComparisonOf> = {
    Word{ComparisonOf::tensioner, "tensioner"},
    Word{ComparisonOf::contact, "contact"},
    Word{ComparisonOf::impacts, "impacts"},
};

/// How long the tensioner was in one state without a break.
struct TensionerSpan {
  double from = 0.0, to = 0.0;  ///< [s]
  int state = 0;                ///< 0 holds, 1 delay, 2 pays out, 3 hauls in, 4 at its limit.
};

/// The tensioner's histories at every row of output from some time on.
struct CloseHistories {
  std::vector<double> time, tension, travel;  ///< [s], [N], [m]
};

struct ComparedRun {
  std::string name;              ///< For scripts, and of its folder: "off".
  std::string words;             ///< For people: "off, held by the brake".
  DynamicResults results{};      ///< Histories thinned.
  std::vector<double> values{};  ///< As many as there are quantities.
  std::vector<TensionerSpan> states{};
  CloseHistories close{};
};

/// What a support box saw in one variant.
struct ComparedBox {
  double contact_share = 0.0;                   ///< Share of time in which it carries [-].
  double static_reaction = 0.0;                 ///< Resultant [N].
  double mean_reaction = 0.0;                   ///< [N]
  double peak_reaction = 0.0;                   ///< [N]
  double peak_force = 0.0;                      ///< Largest normal force of one of its rollers [N].
  double dent_depth = 0.0;                      ///< Under that force [m].
  double line_load = 0.0;                       ///< Under that force, on the coating [N/m].
  std::vector<double> row_share{}, row_peak{};  ///< Of its bottom rollers, row by row: [-], [N]; one for a gap spring.
};

struct ComparedBoxes {
  std::string name;
  bool stinger = false;
  std::vector<ComparedBox> runs;  ///< In the order of the runs.
};

struct Comparison {
  ComparisonOf of = ComparisonOf::tensioner;
  double duration = 0.0, build_up = 0.0;  ///< [s]
  double close_from = 0.0;                ///< Where the close look begins [s].
  std::vector<SeedQuantity> quantities;
  std::vector<ComparedRun> runs;
  std::vector<ComparedBoxes> boxes;  ///< Of a comparison of contact or impacts.
};

}  // namespace overbend
