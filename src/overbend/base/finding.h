/// Findings: records about a result for the engineer, shown in every output.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding_code.h"
#include "base/json.h"

namespace overbend {

/// Number of a finding, in SI.
struct FindingNumber {
  std::string name;  ///< "effective_tension"
  double value = 0.0;
  std::string unit;  ///< SI; "1" for plain numbers.

  bool operator==(const FindingNumber&) const = default;
};

struct Finding {
  FindingCode code = FindingCode::unknown;
  std::string message;                      ///< One sentence, with numbers in display units.
  std::string object = {};                  ///< "stinger 8", "bow port"; empty: the whole analysis.
  std::optional<double> from_top = {};      ///< Location on the pipe: arc length from the tensioner [m].
  std::optional<double> time = {};          ///< [s]
  std::vector<FindingNumber> numbers = {};  ///< The number that measures the severity comes first.
  bool accepted = false;  ///< Accepted by checks.accepted_findings: no reservation in the overall check result.

  Finding on(std::string name) && {
    object = std::move(name);
    return std::move(*this);
  }
  Finding at_place(double distance) && {
    from_top = distance;
    return std::move(*this);
  }
  Finding at_time(double seconds) && {
    time = seconds;
    return std::move(*this);
  }
  Finding with(std::string name, double value, std::string unit) && {
    numbers.push_back({std::move(name), value, std::move(unit)});
    return std::move(*this);
  }

  /// Returns the severity of its code; an accepted finding is at most a caution.
  FindingSeverity severity() const;
  bool operator==(const Finding&) const = default;
};

using Findings = std::vector<Finding>;

/// Returns `all`, then those of `more` that are not in it.
Findings merge(Findings all, const Findings& more);
void append(Findings& all, Findings more);

/// Marks findings whose code is named in `codes` as accepted.
void accept(Findings& findings, const std::vector<std::string>& codes);

/// Sorts by severity, otherwise in the given order; of serious findings the first of each code precedes the others, so
/// that six boxes with the same finding do not hide compression.
Findings sorted_by_severity(const Findings& findings);

/// Returns the serious findings, in their order.
Findings serious_findings(const Findings& findings);

/// Returns the number of findings of a severity.
std::size_t count(const Findings& findings, FindingSeverity severity);
bool has_code(const Findings& findings, FindingCode code);

/// Returns "1 serious, 2 caution, 1 note"; empty without any.
std::string severity_counts(const Findings& findings);

/// Returns the messages only.
std::vector<std::string> messages(const Findings& findings);

/// Returns `{code, severity, message, object?, from_top?, time?, numbers?: [{name, value, unit}], accepted?}`;
/// positions in m, times in s.
Json finding_json(const Finding& finding);
Json findings_json(const Findings& findings);
Finding read_finding(const Json& json);
Findings read_findings(const Json& list);

/// Finding shared by several runs of a model.
struct SharedFinding {
  Finding worst;                            ///< The finding whose first number has the maximum magnitude.
  std::vector<std::size_t> runs = {};       ///< Indices of the runs with the finding.
  std::vector<double> low = {}, high = {};  ///< Minimum and maximum of each number.

  /// Returns the message of the worst finding, with the ranges of its numbers where they differ.
  std::string text() const;
};

/// Merges findings of the same code and object, in order of occurrence.
std::vector<SharedFinding> shared_findings(const std::vector<Findings>& runs);

}  // namespace overbend
