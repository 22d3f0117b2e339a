/// What an engineer should know of a result, as a record: every output shows findings, none has texts of its own.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding_code.h"
#include "base/json.h"

namespace overbend {

/// A number of a finding. SI.
struct FindingNumber {
  std::string name;  ///< "effective_tension"
  double value = 0.0;
  std::string unit;  ///< SI; "1" for plain numbers.

  bool operator==(const FindingNumber&) const = default;
};

struct Finding {
  FindingCode code = FindingCode::unknown;
  std::string message;                      ///< One sentence, with its numbers in the units that people read.
  std::string object = {};                  ///< "stinger 8", "bow port"; empty: of the whole.
  std::optional<double> from_top = {};      ///< Place on the pipe: arc length from the tensioner [m].
  std::optional<double> time = {};          ///< [s]
  std::vector<FindingNumber> numbers = {};  ///< The one that says how bad it is first.
  bool accepted = false;                    ///< By checks.accepted_findings: no reservation of the verdict.

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

  /// Of its code; that of an accepted one is a caution.
  FindingSeverity severity() const;
  bool operator==(const Finding&) const = default;
};

using Findings = std::vector<Finding>;

/// All, then those of `more` that are not among them.
Findings merge(Findings all, const Findings& more);
void append(Findings& all, Findings more);

/// Marks those whose code has one of the names.
void accept(Findings& findings, const std::vector<std::string>& codes);

/// By severity, otherwise in the order given; of serious ones the first of each code before the others, so that six
/// boxes that the pipe left do not stand before compression.
Findings sorted_by_severity(const Findings& findings);

/// Those that are serious, in their order.
Findings serious_findings(const Findings& findings);

/// Number of findings of that severity.
std::size_t count(const Findings& findings, FindingSeverity severity);
bool has_code(const Findings& findings, FindingCode code);

/// "1 serious, 2 caution, 1 note"; empty without any.
std::string severity_counts(const Findings& findings);

/// The messages alone.
std::vector<std::string> messages(const Findings& findings);

/// `{code, severity, message, object?, from_top?, time?, numbers?: [{name, value, unit}], accepted?}`; places in m,
/// times in s.
Json finding_json(const Finding& finding);
Json findings_json(const Findings& findings);
Finding read_finding(const Json& json);
Findings read_findings(const Json& list);

/// A finding that several runs of a model have.
struct SharedFinding {
  Finding worst;                            ///< The one whose first number is the largest in magnitude.
  std::vector<std::size_t> runs = {};       ///< Indices of the runs that have it.
  std::vector<double> low = {}, high = {};  ///< Least and largest of each of its numbers.

  /// The message of the worst, with the ranges of its numbers where they differ.
  std::string text() const;
};

/// Findings of the same code and object are one. In the order in which they occur.
std::vector<SharedFinding> shared_findings(const std::vector<Findings>& runs);

}  // namespace overbend
