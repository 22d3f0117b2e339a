/// Comparisons and their page.
#pragma once

#include <string>
#include <vector>

namespace overbend::validation {

/// One value of ours and its reference.
struct Row {
  std::string subject;  ///< Case or load step.
  std::string quantity;
  std::string unit;  ///< Empty for pure numbers.
  double ours = 0.0;
  double reference = 0.0;
  double allowed = 0.0;  ///< Largest difference, in the unit.
  std::string basis;     ///< Source of reference and tolerance.

  bool holds() const;
};

/// A table of the page.
struct Table {
  std::string heading;
  std::string text;  ///< Markdown above the table.
  std::vector<Row> rows;
  std::string reference{};  ///< Source of the reference values in a few words; empty: that of the group.
};

/// Tables under one heading of the page.
struct Group {
  std::string heading;
  std::string reference;  ///< Source of the reference values in a few words, for the overview.
  std::string text;
  std::vector<Table> tables;
};

/// `share` of the size of the reference, but not less than `least`.
double relative_tolerance(double reference, double share, double min_value = 0.0);

/// The whole page as Markdown: an overview with the governing value of every table, then the tables.
std::string page(const std::vector<Group>& groups);

/// Rows outside their tolerance, one line each; empty when all hold.
std::vector<std::string> failures(const std::vector<Group>& groups);

/// Lines in which `written` says something else than `fresh`. Digits in which two machines may differ do not count: our
/// values may differ by a tenth of what the row allows or by 1e-4, errors of the meshes by a fifth; differences are not
/// compared, and neither are the values of the overview, which are those of the tables.
std::vector<std::string> stale_lines(const std::string& written, const std::string& fresh);

}  // namespace overbend::validation
