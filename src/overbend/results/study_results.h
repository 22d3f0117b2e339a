/// What a study gave: a row for every case, and what the cases say together. Plain data, values in SI.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "results/verdict.h"

namespace overbend {

/// With the ends of its 95 % confidence interval.
struct StudyEstimate {
  double value = 0.0, low = 0.0, high = 0.0;
};

/// A key that changes from case to case: an axis, or a key that is drawn.
struct StudyInput {
  std::string key;   ///< "environment.waves.hs"
  std::string unit;  ///< SI unit of its numbers; empty where it takes words.
  std::string show;  ///< Unit that it is shown in; empty for plain numbers and words.
  std::string with;  ///< Key with which it changes together; empty: crossed.
  bool sampled = false;
  std::vector<std::string> words;  ///< Of an axis: its values as the model file has them,
  std::vector<double> values;      ///< and as numbers [SI]; empty where it takes words.
};

/// A result that is gathered.
struct StudyOutput {
  std::string name;   ///< In summary.json: "dynamic.overbend.max_von_mises".
  std::string unit;   ///< SI; empty for a text.
  bool text = false;  ///< "checks.governing" names a check.
};

enum class StudyCaseState { open, done, failed };

struct StudyCase {
  std::size_t number = 0;          ///< From 0, in the order of the study.
  std::size_t group = 0;           ///< Cases that differ in the seed alone have one.
  std::string folder;              ///< Within the study's.
  std::vector<std::size_t> at;     ///< Index of the value of every axis; empty in a sample.
  std::vector<std::string> words;  ///< Value of every input as the model file has it,
  std::vector<double> inputs;      ///< and as a number [SI]; NaN where it is a word.
  std::optional<std::uint64_t> seed;
  StudyCaseState state = StudyCaseState::open;
  std::vector<std::optional<double>> values;  ///< Of every output; none of a text and where it does not apply.
  std::vector<std::string> texts;             ///< Of every output; empty of a number.
  VerdictKind verdict = VerdictKind::not_judged;
  std::string governing;              ///< The check that is used most; empty where none is judged.
  std::optional<double> utilisation;  ///< Its utilisation.
  std::string reason;                 ///< Why it failed, in one line.
  Findings findings;
  double wall_time = 0.0;  ///< [s]

  bool passed() const { return verdict == VerdictKind::passed; }
  /// What keeps it from passing: the check that is exceeded, or the codes of its serious findings; empty where it does.
  std::string obstacle() const {
    return verdict == VerdictKind::exceeded ? governing : passed() ? std::string() : serious_codes(findings);
  }
};

/// An output over the seeds of one group, for three hours.
struct StudyExtreme {
  std::size_t group = 0, output = 0;
  int runs = 0;
  bool largest = true;                        ///< False: the smallest value is looked for.
  double mean = 0.0, std = 0.0, worst = 0.0;  ///< Of the extremes of the runs.
  bool enough = false;                ///< Otherwise too few runs for the fits below, or one that is not stationary.
  StudyEstimate gumbel;               ///< Most probable extreme of three hours, 95 % confidence.
  std::optional<StudyEstimate> acer;  ///< The same by average conditional exceedance rates of the histories.
};

/// One combination of the other axes.
struct OperabilityCell {
  std::vector<std::size_t> at;      ///< Index of the value of each of OperabilityResults::axes.
  std::optional<double> limit;      ///< Largest value that passes; none where not even the least does.
  bool beyond = false;              ///< The largest value of all passes: the limit lies above it.
  bool decided = true;              ///< False: cases that had no answer leave it open, see reason.
  std::string governing;            ///< What is exceeded at the next value above the limit.
  double below = 0.0, above = 0.0;  ///< Largest utilisation over the seeds at the limit and at the next value above.
  int runs = 0;                     ///< Analyses that it took.
  std::string reason;               ///< Where it is open, why; else what has to be known of the limit.
};

struct Workability {
  std::vector<double> months;  ///< Fraction of the time in which the sea is below the limit, from January.
  double year = 0.0;
  double outside = 0.0;  ///< Fraction of the time with seas outside of the chart, counted as not workable.
};

struct OperabilityResults {
  std::string over, unit, show;  ///< Key whose largest value is looked for, its SI unit and the one shown.
  std::vector<StudyInput> axes;  ///< The others.
  double least = 0.0, largest = 0.0, resolution = 0.0;
  std::vector<std::uint64_t> seeds;
  std::vector<OperabilityCell> cells;
  std::optional<double> alpha;
  std::optional<Workability> workability;
  int runs = 0;
  double wall_time = 0.0;  ///< [s]
  /// With alpha times the limits: of the seas as they are forecast.
  std::optional<Workability> forecast_workability;
  std::vector<std::string> remarks;  ///< Of the search and of the workability.
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
  double wall_time = 0.0;  ///< Of all sittings together [s].
  int threads = 0;
  std::string command{};  ///< That ran it, for people to run a case alone: "overbend study STUDY.yaml -o DIR".
};

}  // namespace overbend
