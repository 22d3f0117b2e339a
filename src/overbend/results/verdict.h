/// The verdict on results, from code checks and findings; the same in every output.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "results/check_results.h"

namespace overbend {

enum class VerdictKind {
  passed,
  reserved,  ///< Nothing exceeded, but at least one serious finding.
  exceeded,
  not_judged,  ///< No check could be judged.
};

struct Verdict {
  VerdictKind kind = VerdictKind::not_judged;
  std::string headline;  ///< "PASSED", "EXCEEDED 1.43, clearance at the stinger tip"
  std::string because;   ///< Sentences: number of checks, maximum utilisation.
};

/// Returns exceeded if a governing check is; otherwise reserved if a finding is serious; not judged without a judged
/// check. Findings accepted by code do not count.
VerdictKind verdict_kind(const CheckTable& table, const Findings& findings);
Verdict make_verdict(const CheckTable& table, const Findings& findings);

/// Returns `{kind, words, because}`.
Json verdict_json(const Verdict& verdict);

/// Returns the serious findings for a table cell: "pipe-off-rollers, compression"; empty without any.
std::string serious_codes(const Findings& findings);

/// Returns "2 serious findings: pipe-off-rollers, compression"; empty without any.
std::string serious_findings_text(const Findings& findings);

/// Returns false for checks of mooring lines, anchors and stand-alone lines, which have no position on the laid pipe.
bool is_on_pipe(const CheckRow& row);

/// Returns "12.3 m from the tensioner"; "line "west pipe", 33.0 m from its first end"; for moorings and wires the
/// remark, which names them.
std::string check_place(const CheckRow& row);

/// Returns the judged, governing check of a region with the maximum utilisation; null if there is none.
const CheckRow* governing_check(const CheckTable& table, CheckRegion region);

/// Returns the regions from the tensioner on; the line as a whole is last.
const std::vector<CheckRegion>& check_regions();

/// Returns "laying criterion I, static strain, overbend"; without the region for a check of the line, or if the name
/// contains the tip.
std::string check_label(const CheckRow& row);

/// Returns "Overbend", "Stinger tip", "Line and equipment".
std::string region_title(CheckRegion region);

}  // namespace overbend
