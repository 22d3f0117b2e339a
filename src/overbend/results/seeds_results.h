/// Results of several realisations of the same sea state: a run with several seeds. Plain data, SI units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"
#include "results/verdict.h"

namespace overbend {

/// Type of extreme of a value over the runs.
enum class SeedExtreme {
  maximum,  ///< The maximum of a run; larger is worse.
  minimum,  ///< The minimum of a run; smaller is worse.
  none,     ///< A count or a measure of quality.
};

/// A key value of a run.
struct SeedQuantity {
  std::string name;         ///< Identifier for scripts: "overbend_max_von_mises".
  std::string units;        ///< SI.
  std::string description;  ///< One line.
  SeedExtreme extreme = SeedExtreme::none;
};

/// A completed run.
struct SeedRun {
  std::uint64_t seed = 0;
  std::string folder;          ///< Within the folder of results: "seed-3".
  std::vector<double> values;  ///< One value for each quantity.
  Findings findings;
  VerdictKind verdict = VerdictKind::not_judged;
};

struct FailedSeed {
  std::uint64_t seed = 0;
  std::string why;
};

/// Most probable extreme of three hours by average conditional exceedance rates of the histories of all runs.
struct SeedAcer {
  double estimate = 0.0, low = 0.0, high = 0.0;  ///< 95 % confidence.
  int order = 1;                                 ///< Order of the conditioning: number of preceding peaks plus one.
  int peaks = 0;                                 ///< Number of peaks in all runs.
};

/// A quantity over the runs.
struct SeedStatistics {
  double mean = 0.0, std = 0.0, min = 0.0, max = 0.0;  ///< `std` is the sample standard deviation: divided by the
                                                       ///< number minus one.
  bool enough = false;  ///< False: too few runs for a fit, equal values, or a non-stationary run.
  // Gumbel distribution of a run's extreme (for a minimum: fitted to its negative, with the sign restored).
  double mode = 0.0, scale = 0.0;
  double estimate = 0.0, low = 0.0, high = 0.0;  ///< Most probable extreme of three hours, 95 % confidence.
  std::optional<SeedAcer> acer{};                ///< None without a history of the quantity, or with too few peaks.
};

struct SeedsResults {
  double duration = 0.0, build_up = 0.0;  ///< Duration and build-up of each run [s].
  std::vector<SeedQuantity> quantities;
  std::vector<SeedRun> runs;               ///< In the order of the model's list.
  std::vector<SeedStatistics> statistics;  ///< One for each quantity; empty without runs.
  std::vector<FailedSeed> failed;
  Findings findings;
};

}  // namespace overbend
