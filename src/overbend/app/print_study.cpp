#include "app/print_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>

#include "app/interruption.h"
#include "app/print_findings.h"
#include "app/print_operability.h"
#include "base/ranges.h"
#include "model/description/study_enum_names.h"
#include "resultfiles/studies/study_writer.h"
#include "results/result_enum_names.h"

namespace overbend {
namespace {

constexpr std::size_t kShownCases = 10;  ///< Maximum number of cases listed at the beginning, and of failed cases.
constexpr std::size_t kLastCases = 3;

std::string plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string case_inputs_text(const StudyCase& study_case, const std::vector<StudyInput>& inputs) {
  std::string text;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    text += fmt::format("{}{} = {}", i == 0 ? "" : ", ", inputs[i].key, study_case.value_texts[i]);
  }
  if (study_case.seed) text += fmt::format("{}seed {}", text.empty() ? "" : ", ", *study_case.seed);
  return text;
}

std::string value_text(const StudyOutput& output, double value) {
  const ShownUnit unit = shown_output(output);
  return fmt::format("{:.{}f}{}{}", value * unit.factor, unit.digits, unit.name.empty() ? "" : " ", unit.name);
}

std::string range_line(const StudyResults& results, std::size_t i) {
  double min_value = std::numeric_limits<double>::infinity(), max_value = -min_value;
  for (const StudyCase& study_case : results.cases) {
    if (study_case.state != StudyCaseState::done || !study_case.values[i]) continue;
    min_value = std::min(min_value, *study_case.values[i]);
    max_value = std::max(max_value, *study_case.values[i]);
  }
  if (min_value > max_value) return fmt::format("  {:<40} none\n", results.outputs[i].name);
  return fmt::format("  {:<40} {} to {}\n", results.outputs[i].name, value_text(results.outputs[i], min_value),
                     value_text(results.outputs[i], max_value));
}

std::string failed_lines(const StudyResults& results, const std::string& study_file, const std::string& folder) {
  std::string text;
  std::size_t listed = 0, failed = 0;
  for (const StudyCase& study_case : results.cases) {
    if (study_case.state != StudyCaseState::failed) continue;
    ++failed;
    if (listed == kShownCases) continue;
    ++listed;
    text += fmt::format("  case {}: {}\n    {}\n    {} --case {}\n", study_case.number,
                        case_inputs_text(study_case, results.inputs), study_case.reason,
                        make_study_command(study_file, folder), study_case.number);
  }
  if (failed > listed) text += fmt::format("  and {} more, see study.csv\n", failed - listed);
  return text;
}

std::string duration_text(double seconds) {
  if (seconds < 120.0) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  if (seconds < 7200.0) return fmt::format("{:.0f} minutes", seconds / 60.0);
  return seconds < 172800.0 ? fmt::format("{:.1f} hours", seconds / 3600.0)
                            : fmt::format("{:.1f} days", seconds / 86400.0);
}

/// Returns a text such as "2 passed, 1 reserved, 1 exceeded".
std::string verdict_counts(const StudyResults& results) {
  std::string text;
  for (const auto& [kind, name] : ResultEnumNames<VerdictKind>::list) {
    const auto number = ranges::count_if(results.cases, [kind = kind](const StudyCase& study_case) {
      return study_case.state == StudyCaseState::done && study_case.verdict == kind;
    });
    if (number > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, name);
  }
  return text.empty() ? "none" : text;
}

}  // namespace

std::string study_head(const CaseBase& base, const StudyCases& cases) {
  const std::string what =
      base.study().operability ? limits_to_search(OperabilityPlan(base.study())) : plural(cases.count(), "case");
  return fmt::format("{}\n  {}, analysis: {}\n", base.study().title, what, enum_name(base.study().analysis));
}

std::string case_list(const StudyCases& cases, const CaseBase& base) {
  std::string text;
  const std::size_t count = cases.count();
  const bool all = count <= kShownCases + kLastCases;
  for (std::size_t number = 0; number < count; ++number) {
    if (!all && number == kShownCases) {
      text += "  ...\n";
      number = count - kLastCases;
    }
    text += fmt::format("  case {}: {}\n", number, case_inputs_text(cases.at(number), cases.inputs()));
  }
  text += "  results:";
  for (const StudyOutput& output : study_outputs(base)) text += " " + output.name;
  return text + "\n";
}

std::string probe_lines(const StudyProbe& probe, std::size_t cases, std::size_t cores) {
  std::string text;
  for (const std::string& failure : probe.failures) text += "  " + failure + "\n";
  if (probe.seconds <= 0.0) return text + "  no case of the probe has a solution; the run time cannot be estimated\n";
  const double total = probe.before + probe.seconds * static_cast<double>(cases) / static_cast<double>(cores);
  return text + fmt::format("  about {:.3g} s per case, {} for all on {}\n", probe.seconds, duration_text(total),
                            plural(cores, "core"));
}

std::string search_probe_lines(const StudyProbe& probe, const OperabilityPlan& plan, std::size_t cores) {
  std::string text;
  for (const std::string& failure : probe.failures) text += "  " + failure + "\n";
  if (probe.seconds <= 0.0) {
    return text + "  no analysis of the probe has a solution; the run time cannot be estimated\n";
  }
  const std::size_t analyses = plan.cells() * (plan.seeds().size() + std::bit_width(plan.values().size()));
  const std::size_t at_once = std::min(cores, operability_chains(plan.grid()));
  const double total = probe.before + probe.seconds * static_cast<double>(analyses) / static_cast<double>(at_once);
  return text + fmt::format(
                    "  about {:.3g} s per analysis, {} for about {} analyses on {}; less if checks are "
                    "exceeded early\n",
                    probe.seconds, duration_text(total), analyses, plural(at_once, "core"));
}

std::string case_lines(const StudyCase& study_case, const std::vector<StudyInput>& inputs,
                       const std::vector<StudyOutput>& outputs) {
  std::string text = fmt::format("case {}: {}\n", study_case.number, case_inputs_text(study_case, inputs));
  for (std::size_t i = 0; i < outputs.size() && study_case.state == StudyCaseState::done; ++i) {
    const std::string value = outputs[i].text        ? study_case.texts[i]
                              : study_case.values[i] ? value_text(outputs[i], *study_case.values[i])
                                                     : std::string("none");
    text += fmt::format("  {:<40} {}\n", outputs[i].name, value);
  }
  return text;
}

std::string study_lines(const StudyResults& results, const std::string& study_file, const std::string& folder) {
  std::size_t done = 0, open = 0;
  for (const StudyCase& study_case : results.cases) {
    done += study_case.state == StudyCaseState::done ? 1 : 0;
    open += study_case.state == StudyCaseState::open ? 1 : 0;
  }
  std::string text =
      fmt::format("  {} of {} solved: {}\n", done, plural(results.cases.size(), "case"), verdict_counts(results));
  if (open > 0) text += fmt::format("  {} not run yet\n", open);
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    if (!results.outputs[i].text) text += range_line(results, i);
  }
  if (const std::size_t failed = results.cases.size() - done - open; failed > 0) {
    text += fmt::format("  {} failed:\n", plural(failed, "case")) + failed_lines(results, study_file, folder);
  }
  return text + finding_lines(results.findings) + "Results are in " + folder + "\n";
}

std::string tally_line(const StudyTally& tally) {
  std::string text = fmt::format("{} run, {} of them failed", plural(tally.done + tally.failed, "case"), tally.failed);
  if (tally.before > 0) text += fmt::format("; {} finished before", tally.before);
  if (tally.elsewhere > 0) text += fmt::format("; {} running in other processes", tally.elsewhere);
  return text + "\n";
}

CaseProgressPrinter::CaseProgressPrinter(const StudyDescription& study) {
  if (study.operability) plan_.emplace(study);
}

void CaseProgressPrinter::tried(const TrialReport& trial) {
  const std::string line = trial_line(*plan_, trial);
  const std::lock_guard<std::mutex> hold(mutex_);
  std::cerr << line;
}

bool CaseProgressPrinter::stop() {
  return Interruption::wanted();
}

void CaseProgressPrinter::begin(std::size_t open, std::size_t finished) {
  if (finished > 0) std::cerr << fmt::format("{} finished before.\n", plural(finished, "case"));
  open_ = open;
  begun_ = std::chrono::steady_clock::now();
  if (open > 0) progress_.emplace(0.0, static_cast<double>(open));
}

void CaseProgressPrinter::ended(const StudyCase& study_case) {
  const std::lock_guard<std::mutex> hold(mutex_);
  ++done_;
  failed_ += study_case.state == StudyCaseState::failed ? 1 : 0;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  const double rate = static_cast<double>(done_) / std::max(seconds, 1e-3);
  const std::string speed = rate >= 1.0 ? fmt::format("{:.3g} per s", rate) : fmt::format("{:.3g} s each", 1.0 / rate);
  progress_->show(static_cast<double>(done_), fmt::format("{} of {} cases, {}{}", done_, open_, speed,
                                                          failed_ > 0 ? fmt::format(", {} failed", failed_) : ""));
}

}  // namespace overbend
