/// Results of a study: a row for every case, and statistics over the cases. Plain data, values in SI.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "results/verdict.h"

namespace overbend {

/// Estimate with its 95 % confidence interval.
struct StudyEstimate {
  double value = 0.0, low = 0.0, high = 0.0;
};

/// A key that varies between cases: an axis, or a sampled key.
struct StudyInput {
  std::string key;   ///< "environment.waves.hs"
  std::string unit;  ///< SI unit of its numbers; empty for text values.
  std::string show;  ///< Unit in which it is shown; empty for plain numbers and texts.
  std::string with;  ///< Key that varies together with this one; empty: all combinations.
  bool sampled = false;
  std::vector<std::string> value_texts;  ///< For an axis: its values as in the model file.
  std::vector<double> values;            ///< For an axis: its values as numbers [SI]; empty for text values.
};

/// A collected result.
struct StudyOutput {
  std::string name;   ///< Name in summary.json: "dynamic.overbend.max_von_mises".
  std::string unit;   ///< SI; empty for a text.
  bool text = false;  ///< "checks.governing" names a check.
};

enum class StudyCaseState { open, done, failed };

struct StudyCase {
  std::size_t number = 0;                  ///< From 0, in the order of the study.
  std::size_t group = 0;                   ///< Group of the cases that differ only in their seed.
  std::string folder;                      ///< Relative to the folder of the study.
  std::vector<std::size_t> value_indices;  ///< Index of the value of every axis; empty in a sample.
  std::vector<std::string> value_texts;    ///< Value of every input as in the model file.
  std::vector<double> inputs;              ///< Value of every input as a number [SI]; NaN for a text.
  std::optional<std::uint64_t> seed;
  StudyCaseState state = StudyCaseState::open;
  std::vector<std::optional<double>> values;  ///< Value of every output; none for a text or a missing value.
  std::vector<std::string> texts;             ///< Text of every output; empty for a number.
  VerdictKind verdict = VerdictKind::not_judged;
  std::string governing;              ///< Governing check with the maximum utilisation; empty if none is judged.
  std::optional<double> utilisation;  ///< Its utilisation.
  std::string reason;                 ///< Reason for the failure, in one line.
  Findings findings;
  double wall_time = 0.0;  ///< [s]

  /// True if the case passes: nothing exceeded, no serious finding.
  bool passed() const { return verdict == VerdictKind::passed; }
  /// Returns the reason why the case does not pass: the exceeded check, or the codes of its serious findings; empty if
  /// it passes.
  std::string failure_reason() const {
    return verdict == VerdictKind::exceeded ? governing : passed() ? std::string() : serious_codes(findings);
  }
};

/// Three-hour extreme of an output over the seeds of one group.
struct StudyExtreme {
  std::size_t group = 0, output = 0;
  int runs = 0;
  bool is_maximum = true;                     ///< True for a maximum, false for a minimum.
  double mean = 0.0, std = 0.0, worst = 0.0;  ///< Statistics of the extremes of the runs.
  bool enough = false;                        ///< False: too few runs for the fits below, or a non-stationary run.
  StudyEstimate gumbel;                       ///< Most probable extreme of three hours, 95 % confidence.
  std::optional<StudyEstimate> acer;          ///< The same by average conditional exceedance rates of the histories.
};

/// One combination of the other axes.
struct OperabilityCell {
  std::vector<std::size_t> value_indices;  ///< Index of the value of each of OperabilityResults::axes.
  std::optional<double> limit;             ///< Maximum passing value; none if the minimum value does not pass.
  bool beyond = false;                     ///< The maximum value passes: the limit is above it.
  bool decided = true;                     ///< False if failed cases leave the limit undetermined, see reason.
  std::string governing;                   ///< Criterion exceeded at the next value above the limit.
  double below = 0.0, above = 0.0;  ///< Maximum utilisation over the seeds at the limit and at the next value above.
  int runs = 0;                     ///< Number of analyses.
  std::string reason;               ///< Reason if undetermined; otherwise a remark on the limit.
};

struct Workability {
  std::vector<double> months;  ///< Fraction of time with seas below the limit, by month from January.
  double year = 0.0;
  double outside = 0.0;  ///< Fraction of time with seas outside the chart, counted as not workable.
};

struct OperabilityResults {
  std::string over, unit, show;  ///< Key whose maximum is searched for, its SI unit and the unit shown.
  std::vector<StudyInput> axes;  ///< The other axes.
  double min_value = 0.0, max_value = 0.0, resolution = 0.0;
  std::vector<std::uint64_t> seeds;
  std::vector<OperabilityCell> cells;
  std::optional<double> alpha;
  std::optional<Workability> workability;
  int runs = 0;
  double wall_time = 0.0;  ///< [s]
  /// For forecast seas: with alpha times the limits.
  std::optional<Workability> forecast_workability;
  std::vector<std::string> remarks;  ///< Remarks on the search and on the workability.
};

struct StudyResults {
  std::string title, version, analysis;
  std::vector<StudyInput> inputs;
  std::vector<StudyOutput> outputs;
  std::vector<StudyCase> cases;
  std::vector<StudyExtreme> extremes;
  std::optional<OperabilityResults> operability;
  Assumptions assumptions;
  Findings findings;
  double wall_time = 0.0;  ///< Total wall time over all runs of the study [s].
  int threads = 0;
  std::string command{};  ///< Command line of the study, for a rerun of a single case: "overbend study STUDY.yaml -o
                          ///< DIR".
};

}  // namespace overbend
