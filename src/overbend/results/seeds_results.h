/// What several realisations of the same sea state gave: a run with several seeds. Plain data, SI units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"
#include "results/verdict.h"

namespace overbend {

/// How a value of each run is looked at over the runs.
enum class SeedExtreme {
  largest,   ///< The largest of a run; larger is worse.
  smallest,  ///< The smallest of a run; smaller is worse.
  none,      ///< A count or a measure of quality.
};

/// A key value of a run.
struct SeedQuantity {
  std::string name;         ///< For scripts: "overbend_max_von_mises".
  std::string units;        ///< SI.
  std::string description;  ///< One line.
  SeedExtreme extreme = SeedExtreme::none;
};

/// A run that came to its end.
struct SeedRun {
  std::uint64_t seed = 0;
  std::string folder;          ///< Within the folder of results: "seed-3".
  std::vector<double> values;  ///< As many as there are quantities.
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
  int order = 1;                                 ///< One more than the peaks before, that condition an exceedance.
  int peaks = 0;                                 ///< Of all runs.
};

/// A quantity over the runs.
struct SeedStatistics {
  double mean = 0.0, std = 0.0, min = 0.0, max = 0.0;  ///< `std` of a sample: divided by the number less one.
  bool enough = false;  ///< False: too few runs for a fit, all the same, or one that is not stationary.
  // Gumbel distribution of a run's extreme (of its negative, turned back, for a smallest one).
  double mode = 0.0, scale = 0.0;
  double estimate = 0.0, low = 0.0, high = 0.0;  ///< Most probable extreme of three hours, 95 % confidence.
  std::optional<SeedAcer> acer{};                ///< None where no history belongs to it, or too few peaks.
};

struct SeedsResults {
  double duration = 0.0, build_up = 0.0;  ///< Of each run [s].
  std::vector<SeedQuantity> quantities;
  std::vector<SeedRun> runs;               ///< In the order of the model's list.
  std::vector<SeedStatistics> statistics;  ///< As many as quantities; empty without runs.
  std::vector<FailedSeed> failed;
  Findings findings;
};

}  // namespace overbend
