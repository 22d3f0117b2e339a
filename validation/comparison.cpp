#include "comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <sstream>

namespace overbend::validation {
namespace {

constexpr int kOursColumn = 3, kDifferenceColumn = 5,
              kAllowedColumn = 6;  ///< Columns of a table line split at its bars.

std::string table_line(const Row& row) {
  return fmt::format("| {} | {}{} | {:.6g} | {:.6g} | {:.2g} | {:.2g} | {} | {} |\n", row.subject, row.quantity,
                     row.unit.empty() ? "" : " [" + row.unit + "]", row.ours, row.reference, row.ours - row.reference,
                     row.allowed, row.holds() ? "yes" : "**no**", row.basis);
}

/// A paragraph with line breaks at most 120 columns apart.
std::string wrapped_paragraph(const std::string& text) {
  constexpr std::size_t kColumns = 120;
  std::string out, word;
  std::size_t column = 0;
  for (std::istringstream message(text); message >> word;) {
    const bool fits = column + 1 + word.size() <= kColumns;
    out += column == 0 ? "" : fits ? " " : "\n";
    column = (fits && column > 0 ? column + 1 : 0) + word.size();
    out += word;
  }
  return out;
}

/// Paragraphs wrapped; those that begin with '|' are tables and stay as they are.
std::string wrapped(const std::string& text) {
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find("\n\n", begin), text.size());
    const std::string paragraph = text.substr(begin, end - begin);
    out += (out.empty() ? "" : "\n\n") + (paragraph.front() == '|' ? paragraph : wrapped_paragraph(paragraph));
    begin = end + 2;
  }
  return out;
}

/// Used fraction of the tolerance: 1 at its limit, 0 for an exact value, infinite for NaN.
double tolerance_use(const Row& row) {
  const double difference = std::abs(row.ours - row.reference);
  if (std::isnan(difference)) return std::numeric_limits<double>::infinity();
  return difference == 0.0 ? 0.0 : difference / row.allowed;
}

/// Tolerance use of a candidate for the governing row. Values that follow from the inputs by arithmetic have the
/// rounding of the reference as tolerance: they govern only if they are wrong.
double governing_use(const Row& row) {
  return row.holds() && row.basis.starts_with("arithmetic") ? -1.0 : tolerance_use(row);
}

const Row& governing_row(const std::vector<Row>& rows) {
  return *std::max_element(rows.begin(), rows.end(),
                           [](const Row& a, const Row& b) { return governing_use(a) < governing_use(b); });
}

/// Names of the headings' anchors as GitHub makes them.
class Anchors {
 public:
  std::string add(const std::string& heading) {
    std::string name;
    for (const char letter : heading) {
      const auto code = static_cast<unsigned char>(letter);
      if (letter == ' ') name += '-';
      if (std::isalnum(code) || letter == '-' || letter == '_') name += static_cast<char>(std::tolower(code));
    }
    const int earlier = count_[name]++;
    return earlier == 0 ? name : name + "-" + std::to_string(earlier);
  }

 private:
  std::map<std::string, int> count_;
};

std::string overview_line(const Group& group, const Table& table, const std::string& anchor) {
  const Row& row = governing_row(table.rows);
  const std::string& source = table.reference.empty() ? group.reference : table.reference;
  const std::string where = row.subject == table.heading ? "" : row.subject + ": ";
  return fmt::format("| [{}: {}](#{}) | {} | {}{}{} | {:.6g} | {:.6g} | {:.2g} | {} | {:.0f} % |\n", group.heading,
                     table.heading, anchor, source, where, row.quantity, row.unit.empty() ? "" : " [" + row.unit + "]",
                     row.ours, row.reference, row.ours - row.reference, table.rows.size(), 100.0 * tolerance_use(row));
}

/// One line for every table that compares values.
std::string overview(const std::vector<Group>& groups) {
  Anchors anchors;
  for (const char* heading : {"Validation", "Overview"}) anchors.add(heading);
  std::string out =
      "| comparison | reference | governing quantity | ours | reference value | difference | values | tolerance used "
      "|\n"
      "|---|---|---|---:|---:|---:|---:|---:|\n";
  for (const Group& group : groups) {
    anchors.add(group.heading);
    for (const Table& table : group.tables) {
      const std::string anchor = anchors.add(table.heading);
      if (!table.rows.empty()) out += overview_line(group, table, anchor);
    }
  }
  return out;
}

std::string table_text(const Table& table) {
  std::string out = table.heading.empty() ? "" : "### " + table.heading + "\n\n";
  out += table.text.empty() ? "" : wrapped(table.text) + "\n\n";
  if (table.rows.empty()) {
    return out;
  }
  out += "| case | quantity | ours | reference | difference | allowed | holds | reference and tolerance |\n";
  out += "|---|---|---:|---:|---:|---:|---|---|\n";
  for (const Row& row : table.rows) {
    out += table_line(row);
  }
  return out + "\n";
}

std::vector<std::string> split(const std::string& text, char sample) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, sample);) {
    parts.push_back(part);
  }
  return parts;
}

/// Cells that both hold numbers within `slack`.
bool same_number(const std::string& a, const std::string& b, double share, double min_value) {
  char *end_a = nullptr, *end_b = nullptr;
  const double x = std::strtod(a.c_str(), &end_a), y = std::strtod(b.c_str(), &end_b);
  return end_a != a.c_str() && end_b != b.c_str() && std::abs(x - y) <= std::max(share * std::abs(y), min_value);
}

bool same_line(const std::string& written, const std::string& fresh) {
  const std::vector<std::string> a = split(written, '|'), b = split(fresh, '|');
  if (a.size() != b.size()) {
    return false;
  }
  if (a.size() > 2 && a[1].find("](#") != std::string::npos) {  // of the overview
    return a[1] == b[1] && a[2] == b[2];
  }
  const bool comparison = a.size() > kAllowedColumn;  // else one of the small tables of errors, or prose
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool difference = comparison && i == kDifferenceColumn;
    const bool ours = comparison && i == kOursColumn;
    const bool error = !comparison && a.size() > 1;
    if (a[i] == b[i] || difference) {
      continue;
    }
    if (ours && same_number(a[i], b[i], 1e-4, 0.1 * std::atof(b[kAllowedColumn].c_str()))) {
      continue;
    }
    if (error && same_number(a[i], b[i], 0.2, 0.0)) {
      continue;
    }
    return false;
  }
  return true;
}

}  // namespace

bool Row::holds() const {
  return std::abs(ours - reference) <= allowed;  // false for NaN
}

double relative_tolerance(double reference, double share, double min_value) {
  return std::max(share * std::abs(reference), min_value);
}

std::string page(const std::vector<Group>& groups) {
  std::size_t count = 0, outside = 0;
  std::string body;
  for (const Group& group : groups) {
    body += "## " + group.heading + "\n\n" + (group.text.empty() ? "" : wrapped(group.text) + "\n\n");
    for (const Table& table : group.tables) {
      body += table_text(table);
      count += table.rows.size();
      outside += static_cast<std::size_t>(
          std::count_if(table.rows.begin(), table.rows.end(), [](const Row& row) { return !row.holds(); }));
    }
  }
  while (body.size() > 1 && body[body.size() - 2] == '\n') {
    body.pop_back();
  }
  return fmt::format(
      "# Validation\n\n"
      "<!-- Generated: `build/release/overbend_validate > docs/validation.md`. Do not edit. -->\n\n"
      "Results of the program compared with independent references: closed forms, tables from the literature, results "
      "of\nother programs, and solutions computed with other methods ([origin](../validation/README.md)). {} values "
      "are "
      "compared,\n{} of them {} outside the tolerance.\n\n"
      "## Overview\n\n"
      "One row per comparison, with the number of its values and its governing quantity: the one that uses most of "
      "its\ntolerance. Section properties, which follow from the inputs by arithmetic, are not considered.\n\n{}\n"
      "Our values are computed when this page is generated, with the elements, contacts and solver of the program. The "
      "test\nsuite checks each value against its tolerance, and that this page is up to date. To regenerate it:\n\n"
      "```sh\ncmake --preset release\ncmake --build --preset release --target overbend_validate\n"
      "build/release/overbend_validate > docs/validation.md\n```\n\n"
      "`overbend_validate --check` prints only the values outside their tolerance, and fails if there are any.\n\n{}",
      count, outside, outside == 1 ? "is" : "are", overview(groups), body);
}

std::vector<std::string> failures(const std::vector<Group>& groups) {
  std::vector<std::string> lines;
  for (const Group& group : groups) {
    for (const Table& table : group.tables) {
      for (const Row& row : table.rows) {
        if (!row.holds()) {
          lines.push_back(fmt::format("{}, {}: {} [{}] is {:.8g}, reference {:.8g}, difference {:.2g}, allowed {:.2g}",
                                      group.heading, row.subject, row.quantity, row.unit, row.ours, row.reference,
                                      row.ours - row.reference, row.allowed));
        }
      }
    }
  }
  return lines;
}

std::vector<std::string> stale_lines(const std::string& written, const std::string& fresh) {
  const std::vector<std::string> a = split(written, '\n'), b = split(fresh, '\n');
  std::vector<std::string> stale;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const std::string was = i < a.size() ? a[i] : "(nothing)", is = i < b.size() ? b[i] : "(nothing)";
    if (!same_line(was, is)) {
      stale.push_back(fmt::format("line {}: {}\n    should be: {}", i + 1, was, is));
    }
  }
  return stale;
}

}  // namespace overbend::validation
