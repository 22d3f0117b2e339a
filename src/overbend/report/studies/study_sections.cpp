#include "report/studies/study_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "report/studies/study_data.h"
#include "results/result_enum_names.h"

namespace overbend {
namespace {

constexpr std::size_t kMaxRows = 300;
constexpr std::size_t kMaxFailedCases = 100;

struct Counts {
  std::size_t& of(VerdictKind kind) {
    return kind == VerdictKind::passed     ? passed
           : kind == VerdictKind::reserved ? reserved
           : kind == VerdictKind::exceeded ? exceeded
                                           : unjudged;
  }

  std::size_t passed = 0, reserved = 0, exceeded = 0, unjudged = 0, failed = 0, open = 0;
};

Counts count_cases(const StudyResults& results) {
  Counts counts;
  for (const StudyCase& study_case : results.cases) {
    if (study_case.state == StudyCaseState::open) {
      ++counts.open;
    } else if (study_case.state == StudyCaseState::failed) {
      ++counts.failed;
    } else {
      ++counts.of(study_case.verdict);
    }
  }
  return counts;
}

std::string four_digits(double value) {
  if (!std::isfinite(value)) return "-";
  const double size = std::abs(value);
  if (size >= 1e4) return fmt::format("{:.0f}", value);
  return size > 0.0 && size < 1e-3 ? fmt::format("{:.2e}", value) : fmt::format("{:.4g}", value);
}

std::string output_value_text(const StudyOutput& output, const StudyCase& study_case, std::size_t k) {
  if (output.text) return k < study_case.texts.size() && !study_case.texts[k].empty() ? study_case.texts[k] : "-";
  return k < study_case.values.size() && study_case.values[k]
             ? four_digits(*study_case.values[k] * find_study_unit(output).factor)
             : "-";
}

std::string case_result_text(const StudyCase& study_case) {
  switch (study_case.state) {
    case StudyCaseState::open:
      return "not run";
    case StudyCaseState::failed:
      return "no result";
    default:
      return study_case.verdict == VerdictKind::reserved ? "reserved: " + serious_codes(study_case.findings)
                                                         : word(study_case.verdict);
  }
}

TableColumn column(const std::string& name, const StudyUnit& unit, bool is_text) {
  return is_text ? TableColumn(make_heading(name, {})) : TableColumn::texts(make_heading(name, {}), unit.name);
}

/// Replaces blanks so that a value and its unit stay on one line.
std::string unbroken(std::string text) {
  for (std::size_t position = text.find(' '); position != std::string::npos; position = text.find(' ', position)) {
    text.replace(position, 1, "\u00a0");
  }
  return text;
}

/// "1 exceeds", "2 exceed".
std::string counted(std::size_t count, const char* singular, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? singular : several);
}

/// Values of the inputs as in the model file: "hs 2 m, tp 8 s".
std::string inputs_text(const StudyResults& results, const StudyCase& study_case) {
  std::string text;
  for (std::size_t i = 0; i < results.inputs.size() && i < study_case.value_texts.size(); ++i) {
    const std::string& key = results.inputs[i].key;
    text +=
        (text.empty() ? "" : ", ") + unbroken(key.substr(key.find_last_of('.') + 1) + " " + study_case.value_texts[i]);
  }
  return text.empty() ? "the base model" : text;
}

const StudyCase* find_first_case(const StudyResults& results, std::size_t group) {
  const auto found = ranges::find(results.cases, group, &StudyCase::group);
  return found == results.cases.end() ? nullptr : &*found;
}

std::string estimate_text(const StudyEstimate& estimate, double factor) {
  return fmt::format("{} ({} to {})", four_digits(estimate.value * factor), four_digits(estimate.low * factor),
                     four_digits(estimate.high * factor));
}

std::string cell_limit_text(const OperabilityResults& all, const OperabilityCell& cell, const StudyUnit& unit) {
  if (!cell.decided) return "open";
  if (cell.beyond) return "over " + four_digits(all.max_value * unit.factor);
  if (!cell.limit) return "below " + four_digits(all.min_value * unit.factor);
  return four_digits(*cell.limit * unit.factor);
}

Blocks workability_part(const Workability& workability) {
  static const char* const kMonths[] = {"January", "February", "March",     "April",   "May",      "June",
                                        "July",    "August",   "September", "October", "November", "December"};
  Table table{"Workability", {TableColumn("Month"), {"Workable", ShownUnit{"1", "% of the time", 100.0}, 1}}};
  if (workability.months.size() == 12) {
    for (std::size_t i = 0; i < 12; ++i) table.row({kMonths[i], workability.months[i]});
  }
  table.row({"Year", workability.year}, RowMark::total);
  return table + block::remark(fmt::format("Seas outside the chart, {} % of the time, count as not workable.",
                                           fixed(100.0 * workability.outside, 1)));
}

/// Remarks on limits, cell by cell.
Blocks limit_remarks(const OperabilityResults& all) {
  std::vector<std::string> remarks;
  for (const OperabilityCell& cell : all.cells) {
    if (!cell.decided || cell.reason.empty()) continue;
    std::string place;
    for (std::size_t k = 0; k < all.axes.size(); ++k) {
      place += (k == 0 ? "" : ", ") + make_heading(all.axes[k].key, {}) + " " +
               all.axes[k].value_texts.at(cell.value_indices.at(k));
    }
    remarks.push_back(place + ": " + cell.reason);
  }
  if (remarks.empty()) return {};
  const std::size_t others = remarks.size() - std::min(remarks.size(), kMaxRows);
  remarks.resize(remarks.size() - others);
  Blocks blocks = block::subheading("Remarks on limits marked *") + block::list(remarks);
  if (others > 0) blocks += block::remark(fmt::format("And {} more; operability.csv has all.", others));
  return blocks;
}

}  // namespace

Verdict study_verdict(const StudyResults& results) {
  const Counts n = count_cases(results);
  const std::size_t all = results.cases.size();
  Verdict verdict;
  verdict.kind = n.exceeded > 0 ? VerdictKind::exceeded : n.passed < all ? VerdictKind::reserved : VerdictKind::passed;
  std::string& because = verdict.because;
  if (n.exceeded > 0) because += counted(n.exceeded, "exceeds", "exceed") + " a governing check. ";
  if (n.reserved > 0) {
    because += counted(n.reserved, "passes", "pass") + " with reservations: see the serious findings below. ";
  }
  if (n.failed > 0) because += counted(n.failed, "has", "have") + " no result; reasons are listed below. ";
  if (n.open > 0) because += counted(n.open, "has", "have") + " not been run yet.";
  const bool unchecked = n.unjudged > 0 && n.unjudged + n.failed + n.open == all;
  if (n.unjudged > 0) because += (because.empty() ? "" : " ") + counted(n.unjudged, "is", "are") + " not judged.";
  if (because.empty()) because = "Every case has a result with every governing check passed.";
  verdict.headline =
      fmt::format("{} of {} cases {}", unchecked ? n.unjudged : n.passed, all, unchecked ? "solved" : "pass");
  return verdict;
}

Blocks study_inputs_section(const StudyResults& results) {
  Table table{"", {TableColumn("Key"), TableColumn("Values"), TableColumn::texts("Number"), TableColumn("Changes")}};
  const char* alone = study_shape(results) == StudyShape::one_at_a_time ? "alone" : "crossed";
  for (const StudyInput& input : results.inputs) {
    std::string values = "sampled at random";
    if (!input.value_texts.empty()) {
      values = unbroken(input.value_texts.front());
      const std::size_t count = input.value_texts.size();
      for (std::size_t i = 1; i < count; ++i) {
        if (count > 8 && i == 3) values += ", ...";
        if (count <= 8 || i < 3 || i + 1 == count) values += ", " + unbroken(input.value_texts[i]);
      }
    }
    const std::string with = input.sampled ? "from case to case" : input.with.empty() ? alone : "with " + input.with;
    table.row({input.key, values, input.value_texts.empty() ? "-" : std::to_string(input.value_texts.size()), with});
  }
  return block::section("inputs", "Varied inputs", table);
}

Blocks study_extremes_section(const StudyResults& results) {
  if (results.extremes.empty()) return {};
  Table table{"", {TableColumn("Case"), TableColumn("Result"), {"Runs", "", 0}}, "dense"};
  for (const char* title : {"Mean", "Std", "Observed extreme", "Gumbel, 3 h", "ACER, 3 h"}) {
    table.column(TableColumn::texts(title));
  }
  table.column(TableColumn("Unit"));
  for (std::size_t i = 0; i < std::min(results.extremes.size(), kMaxRows); ++i) {
    const StudyExtreme& e = results.extremes[i];
    const StudyOutput& output = results.outputs.at(e.output);
    const StudyUnit unit = find_study_unit(output);
    const StudyCase* first = find_first_case(results, e.group);
    table.row({first == nullptr ? "-" : inputs_text(results, *first), make_heading(output.name, {}), e.runs,
               four_digits(e.mean * unit.factor), four_digits(e.std * unit.factor), four_digits(e.worst * unit.factor),
               e.enough ? estimate_text(e.gumbel, unit.factor) : "-",
               e.acer ? estimate_text(*e.acer, unit.factor) : "-", unit.name.empty() ? "-" : unit.name});
  }
  std::string note =
      "Most probable extreme of three hours, in brackets its 95 % confidence interval. Gumbel: from the extremes of at "
      "least ten runs. ACER: average conditional exceedance rates of the histories of all runs (Naess and Gaidai "
      "2009).";
  if (results.extremes.size() > kMaxRows) {
    note += fmt::format(" The first {} of {} rows.", kMaxRows, results.extremes.size());
  }
  return block::section("extremes", "Extremes over the seeds", table + block::remark(note));
}

Blocks operability_section(const StudyResults& results) {
  if (!results.operability) return {};
  const OperabilityResults& all = *results.operability;
  const StudyUnit unit = find_study_unit(all.unit, all.show);
  Table table{"", {}, "dense"};
  for (const StudyInput& axis : all.axes) table.column(column(axis.key, {}, false));
  table.column(TableColumn::texts("Limit of " + make_heading(all.over, {}), unit.name))
      .column(TableColumn("Governing above it"))
      .column({"Utilisation at it", "", 3})
      .column({"above it", "", 3})
      .column({"Analyses", "", 0});
  for (std::size_t i = 0; i < std::min(all.cells.size(), kMaxRows); ++i) {
    const OperabilityCell& cell = all.cells[i];
    std::vector<TableCell> cells;
    for (std::size_t k = 0; k < all.axes.size(); ++k) {
      cells.emplace_back(all.axes[k].value_texts.at(cell.value_indices.at(k)));
    }
    cells.insert(cells.end(), {cell_limit_text(all, cell, unit) + (cell.decided && !cell.reason.empty() ? " *" : ""),
                               cell.decided ? cell.governing : cell.reason, cell.limit ? TableCell(cell.below) : "-",
                               cell.beyond ? "-" : TableCell(cell.above), cell.runs});
    table.row(cells, cell.limit ? RowMark::none : RowMark::over);
  }
  std::string note = fmt::format(
      "Largest value with the criterion met for every one of {} seeds, to {} {}. {} analyses.",
      std::max<std::size_t>(1, all.seeds.size()), four_digits(all.resolution * unit.factor), unit.name, all.runs);
  if (all.alpha) note += fmt::format(" Limits are to be multiplied by the alpha factor {}.", four_digits(*all.alpha));
  return block::section("operability", "Operability",
                        table + block::remark(note) + limit_remarks(all) +
                            (all.workability ? workability_part(*all.workability) : Blocks()));
}

Blocks failed_cases_section(const StudyResults& results) {
  const std::string command = results.command.empty() ? "overbend study STUDY.yaml -o DIR" : results.command;
  Table table{"", {{"Case", "", 0}, TableColumn("At"), TableColumn("Reason"), TableColumn("Command")}, "checks"};
  for (const StudyCase& failed : results.cases) {
    if (failed.state != StudyCaseState::failed || table.rows.size() == kMaxFailedCases) continue;
    table.row({failed.number, inputs_text(results, failed), failed.reason,
               fmt::format("{} --case {}", command, failed.number)});
  }
  Blocks body = table;
  if (const std::size_t all = count_cases(results).failed; all > kMaxFailedCases) {
    body += block::remark(fmt::format("The first {} of {}; study.csv has all.", kMaxFailedCases, all));
  }
  return block::section("failed", "Cases without a result", body);
}

Blocks study_cases_section(const StudyResults& results) {
  if (results.cases.empty()) return {};
  Table table{"", {{"Case", "", 0}}, "dense"};
  for (const StudyInput& input : results.inputs) table.column(column(input.key, {}, input.values.empty()));
  const bool seeds = ranges::any_of(results.cases, [](const StudyCase& solved) { return solved.seed.has_value(); });
  if (seeds) table.column({"Seed", "", 0});
  for (const StudyOutput& output : results.outputs) {
    table.column(column(output.name, find_study_unit(output), output.text));
  }
  table.column(TableColumn("Result"));
  for (std::size_t i = 0; i < std::min(results.cases.size(), kMaxRows); ++i) {
    const StudyCase& row = results.cases[i];
    std::vector<TableCell> cells = {row.number};
    for (std::size_t k = 0; k < results.inputs.size(); ++k) {
      cells.emplace_back(k < row.value_texts.size() ? row.value_texts[k] : "-");
    }
    if (seeds) cells.push_back(row.seed ? TableCell(*row.seed) : "-");
    for (std::size_t k = 0; k < results.outputs.size(); ++k) {
      cells.emplace_back(output_value_text(results.outputs[k], row, k));
    }
    cells.emplace_back(case_result_text(row));
    table.row(cells, row.state == StudyCaseState::open ? RowMark::soft : row.passed() ? RowMark::none : RowMark::over);
  }
  std::string note = "The same rows are in study.csv, study.xlsx and study.h5.";
  if (results.cases.size() > kMaxRows) {
    note = fmt::format("The first {} of {} cases; all are in study.csv, study.xlsx and study.h5.", kMaxRows,
                       results.cases.size());
  }
  return block::section("cases", "Cases", table + block::remark(note));
}

}  // namespace overbend
