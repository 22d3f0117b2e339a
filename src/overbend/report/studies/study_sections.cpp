#include "report/studies/study_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/page/html.h"
#include "report/studies/study_data.h"

#include "results/result_words.h"
namespace overbend {
namespace {

constexpr std::size_t kMostRows = 300;
constexpr std::size_t kMostFailed = 100;

struct Counts {
  std::size_t& of(VerdictKind kind) {
    return kind == VerdictKind::passed     ? passed
           : kind == VerdictKind::reserved ? reserved
           : kind == VerdictKind::exceeded ? exceeded
                                           : unjudged;
  }

  std::size_t passed = 0, reserved = 0, exceeded = 0, unjudged = 0, failed = 0, open = 0;
};

Counts counts_of(const StudyResults& results) {
  Counts counts;
  for (const StudyCase& one : results.cases) {
    if (one.state == StudyCaseState::open) {
      ++counts.open;
    } else if (one.state == StudyCaseState::failed) {
      ++counts.failed;
    } else {
      ++counts.of(one.verdict);
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

std::string value_words(const StudyOutput& output, const StudyCase& one, std::size_t k) {
  if (output.text) return k < one.texts.size() && !one.texts[k].empty() ? one.texts[k] : "-";
  return k < one.values.size() && one.values[k] ? four_digits(*one.values[k] * shown_unit_of(output).factor) : "-";
}

std::string result_words(const StudyCase& one) {
  switch (one.state) {
    case StudyCaseState::open:
      return "not run";
    case StudyCaseState::failed:
      return "no result";
    default:
      return one.verdict == VerdictKind::reserved ? "reserved: " + serious_codes(one.findings) : word(one.verdict);
  }
}

html::Head head(const std::string& name, const StudyShown& unit, bool text = false) {
  return {heading_of(name, {}), unit.name, text};
}

/// A value and its unit stay on one line.
std::string unbroken(std::string text) {
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at)) text.replace(at, 1, "\u00a0");
  return text;
}

/// "1 exceeds", "2 exceed".
std::string counted(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

/// Values of the inputs as the model file has them: "hs 2 m, tp 8 s".
std::string where(const StudyResults& results, const StudyCase& one) {
  std::string text;
  for (std::size_t i = 0; i < results.inputs.size() && i < one.words.size(); ++i) {
    const std::string& key = results.inputs[i].key;
    text += (text.empty() ? "" : ", ") + unbroken(key.substr(key.find_last_of('.') + 1) + " " + one.words[i]);
  }
  return text.empty() ? "the model as it is" : text;
}

const StudyCase* first_of(const StudyResults& results, std::size_t group) {
  const auto found = std::ranges::find(results.cases, group, &StudyCase::group);
  return found == results.cases.end() ? nullptr : &*found;
}

std::string estimate_words(const StudyEstimate& estimate, double factor) {
  return fmt::format("{} ({} to {})", four_digits(estimate.value * factor), four_digits(estimate.low * factor),
                     four_digits(estimate.high * factor));
}

std::string limit_words(const OperabilityResults& all, const OperabilityCell& cell, const StudyShown& unit) {
  if (!cell.decided) return "open";
  if (cell.beyond) return "over " + four_digits(all.largest * unit.factor);
  if (!cell.limit) return "below " + four_digits(all.least * unit.factor);
  return four_digits(*cell.limit * unit.factor);
}

std::string workability_table(const Workability& workability) {
  static const char* const kMonths[] = {"January", "February", "March",     "April",   "May",      "June",
                                        "July",    "August",   "September", "October", "November", "December"};
  html::Table table("Workability", {{"Month", "", true}, {"Workable", "% of the time"}}, "plain");
  if (workability.months.size() == 12) {
    for (std::size_t i = 0; i < 12; ++i) table.row({kMonths[i], html::fixed(100.0 * workability.months[i], 1)});
  }
  table.row({"Year", html::fixed(100.0 * workability.year, 1)}, "total");
  return table.str() + fmt::format(
                           "<p class=\"small\">Seas outside of the chart, {} % of the time, count as not "
                           "workable.</p>\n",
                           html::fixed(100.0 * workability.outside, 1));
}

}  // namespace

std::string study_verdict(const StudyResults& results) {
  const Counts n = counts_of(results);
  const std::size_t all = results.cases.size();
  const char* kind = n.exceeded > 0 ? "exceeded" : n.passed < all ? "reserved" : "passed";
  std::string because;
  if (n.exceeded > 0) because += counted(n.exceeded, "exceeds", "exceed") + " a governing check. ";
  if (n.reserved > 0) {
    because += counted(n.reserved, "passes", "pass") + " with reservations: see the serious findings below. ";
  }
  if (n.failed > 0) because += counted(n.failed, "has", "have") + " no result; reasons are listed below. ";
  if (n.open > 0) because += counted(n.open, "has", "have") + " not been run yet.";
  const bool unchecked = n.unjudged > 0 && n.unjudged + n.failed + n.open == all;
  if (n.unjudged > 0) because += (because.empty() ? "" : " ") + counted(n.unjudged, "is", "are") + " not judged.";
  if (because.empty()) because = "Every case has a result with every governing check passed.";
  return fmt::format(
      "<div class=\"verdict {}\">\n<div class=\"words\">{} of {} cases {}</div>\n<div "
      "class=\"because\">{}</div>\n</div>\n",
      kind, unchecked ? n.unjudged : n.passed, all, unchecked ? "solved" : "pass", because);
}

std::string study_inputs_section(const StudyResults& results) {
  if (results.inputs.empty()) return "";
  html::Table table("", {{"Key", "", true}, {"Values", "", true}, {"Number", ""}, {"Changes", "", true}}, "plain");
  const char* alone = study_shape(results) == StudyShape::one_at_a_time ? "alone" : "crossed";
  for (const StudyInput& input : results.inputs) {
    std::string values = "drawn at random";
    if (!input.words.empty()) {
      values = unbroken(input.words.front());
      const std::size_t count = input.words.size();
      for (std::size_t i = 1; i < count; ++i) {
        if (count > 8 && i == 3) values += ", ...";
        if (count <= 8 || i < 3 || i + 1 == count) values += ", " + unbroken(input.words[i]);
      }
    }
    const std::string with = input.sampled ? "from case to case" : input.with.empty() ? alone : "with " + input.with;
    table.row({input.key, values, input.words.empty() ? "-" : std::to_string(input.words.size()), with});
  }
  return html::section("inputs", "What changes", table.str());
}

std::string study_extremes_section(const StudyResults& results) {
  if (results.extremes.empty()) return "";
  html::Table table("",
                    {{"Case", "", true},
                     {"Result", "", true},
                     {"Runs", ""},
                     {"Mean", ""},
                     {"Std", ""},
                     {"Extreme seen", ""},
                     {"Gumbel, 3 h", ""},
                     {"ACER, 3 h", ""},
                     {"Unit", "", true}},
                    "dense");
  for (std::size_t i = 0; i < std::min(results.extremes.size(), kMostRows); ++i) {
    const StudyExtreme& e = results.extremes[i];
    const StudyOutput& output = results.outputs.at(e.output);
    const StudyShown unit = shown_unit_of(output);
    const StudyCase* first = first_of(results, e.group);
    table.row({first == nullptr ? "-" : where(results, *first), heading_of(output.name, {}), std::to_string(e.runs),
               four_digits(e.mean * unit.factor), four_digits(e.std * unit.factor), four_digits(e.worst * unit.factor),
               e.enough ? estimate_words(e.gumbel, unit.factor) : "-",
               e.acer ? estimate_words(*e.acer, unit.factor) : "-", unit.name.empty() ? "-" : unit.name});
  }
  std::string note =
      "Most probable extreme of three hours, in brackets its 95 % confidence interval. Gumbel: from the extremes of at "
      "least ten runs. ACER: average conditional exceedance rates of the histories of all runs (Naess and Gaidai "
      "2009).";
  if (results.extremes.size() > kMostRows) {
    note += fmt::format(" The first {} of {} rows.", kMostRows, results.extremes.size());
  }
  return html::section("extremes", "Extremes over the seeds", table.str() + "<p class=\"small\">" + note + "</p>\n");
}

/// What has to be known of limits, cell by cell.
std::string limit_remarks(const OperabilityResults& all) {
  std::string items;
  std::size_t told = 0, others = 0;
  for (const OperabilityCell& cell : all.cells) {
    if (!cell.decided || cell.reason.empty()) continue;
    if (told == kMostRows) {
      ++others;
      continue;
    }
    ++told;
    std::string place;
    for (std::size_t k = 0; k < all.axes.size(); ++k) {
      place += (k == 0 ? "" : ", ") + heading_of(all.axes[k].key, {}) + " " + all.axes[k].words.at(cell.at.at(k));
    }
    items += "<li><b>" + html::escape(place) + "</b>: " + html::escape(cell.reason) + "</li>\n";
  }
  if (items.empty()) return "";
  const std::string more =
      others > 0 ? fmt::format("<p class=\"small\">And {} more; operability.csv has all.</p>\n", others) : "";
  return "<h3>Remarks on limits marked *</h3>\n<ul class=\"small\">\n" + items + "</ul>\n" + more;
}

std::string operability_section(const StudyResults& results) {
  if (!results.operability) return "";
  const OperabilityResults& all = *results.operability;
  const StudyShown unit = shown_unit_of(all.unit, all.show);
  std::vector<html::Head> heads;
  for (const StudyInput& axis : all.axes) heads.push_back({heading_of(axis.key, {}), ""});
  heads.push_back({"Limit of " + heading_of(all.over, {}), unit.name});
  heads.push_back({"Governing above it", "", true});
  heads.push_back({"Utilisation at it", ""});
  heads.push_back({"above it", ""});
  heads.push_back({"Analyses", ""});
  html::Table table("", heads, "dense");
  for (std::size_t i = 0; i < std::min(all.cells.size(), kMostRows); ++i) {
    const OperabilityCell& cell = all.cells[i];
    std::vector<std::string> cells;
    for (std::size_t k = 0; k < all.axes.size(); ++k) cells.push_back(all.axes[k].words.at(cell.at.at(k)));
    cells.push_back(limit_words(all, cell, unit) + (cell.decided && !cell.reason.empty() ? " *" : ""));
    cells.push_back(cell.decided ? cell.governing : cell.reason);
    cells.push_back(cell.limit ? html::fixed(cell.below, 3) : "-");
    cells.push_back(cell.beyond ? "-" : html::fixed(cell.above, 3));
    cells.push_back(std::to_string(cell.runs));
    table.row(cells, cell.limit ? "" : "over");
  }
  std::string note = fmt::format(
      "Largest value with the criterion met for every one of {} seeds, to {} {}. {} analyses.",
      std::max<std::size_t>(1, all.seeds.size()), four_digits(all.resolution * unit.factor), unit.name, all.runs);
  if (all.alpha) note += fmt::format(" Limits are to be multiplied by the alpha factor {}.", four_digits(*all.alpha));
  return html::section("operability", "Operability",
                       table.str() + "<p class=\"small\">" + html::escape(note) + "</p>\n" + limit_remarks(all) +
                           (all.workability ? workability_table(*all.workability) : ""));
}

std::string failed_cases_section(const StudyResults& results) {
  const std::size_t failed = counts_of(results).failed;
  if (failed == 0) return "";
  const std::string command = results.command.empty() ? "overbend study STUDY.yaml -o DIR" : results.command;
  html::Table table("", {{"Case", ""}, {"At", "", true}, {"Reason", "", true}, {"Command", "", true}}, "checks");
  std::size_t rows = 0;
  for (const StudyCase& one : results.cases) {
    if (one.state != StudyCaseState::failed || rows == kMostFailed) continue;
    ++rows;
    table.row({std::to_string(one.number), where(results, one), one.reason,
               fmt::format("{} --case {}", command, one.number)});
  }
  const std::string note =
      failed > kMostFailed
          ? fmt::format("<p class=\"small\">The first {} of {}; study.csv has all.</p>\n", kMostFailed, failed)
          : "";
  return html::section("failed", "Cases without a result", table.str() + note);
}

std::string study_cases_section(const StudyResults& results) {
  std::vector<html::Head> heads = {{"Case", ""}};
  for (const StudyInput& input : results.inputs) heads.push_back(head(input.key, {}, input.values.empty()));
  const bool seeds = std::ranges::any_of(results.cases, [](const StudyCase& one) { return one.seed.has_value(); });
  if (seeds) heads.push_back({"Seed", ""});
  for (const StudyOutput& output : results.outputs) {
    heads.push_back(head(output.name, shown_unit_of(output), output.text));
  }
  heads.push_back({"Result", "", true});
  html::Table table("", heads, "dense");
  for (std::size_t i = 0; i < std::min(results.cases.size(), kMostRows); ++i) {
    const StudyCase& one = results.cases[i];
    std::vector<std::string> cells = {std::to_string(one.number)};
    for (std::size_t k = 0; k < results.inputs.size(); ++k) cells.push_back(k < one.words.size() ? one.words[k] : "-");
    if (seeds) cells.push_back(one.seed ? std::to_string(*one.seed) : "-");
    for (std::size_t k = 0; k < results.outputs.size(); ++k) {
      cells.push_back(value_words(results.outputs[k], one, k));
    }
    cells.push_back(result_words(one));
    table.row(cells, one.state == StudyCaseState::open ? "soft" : one.passed() ? "" : "over");
  }
  std::string note = "The same rows are in study.csv, study.xlsx and study.h5.";
  if (results.cases.size() > kMostRows) {
    note = fmt::format("The first {} of {} cases; all are in study.csv, study.xlsx and study.h5.", kMostRows,
                       results.cases.size());
  }
  return html::section("cases", "Cases", table.str() + "<p class=\"small\">" + note + "</p>\n");
}

}  // namespace overbend
