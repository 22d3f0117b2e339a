/// The verdict on results: of the code checks and the findings together, the same in every output.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "results/check_results.h"

namespace overbend {

enum class VerdictKind {
  passed,
  reserved,  ///< Nothing exceeded, but a finding is serious.
  exceeded,
  not_judged,  ///< Nothing could be judged.
};

struct Verdict {
  VerdictKind kind = VerdictKind::not_judged;
  std::string words;    ///< "PASSED", "EXCEEDED 1.43, clearance at the stinger tip"
  std::string because;  ///< Sentences: how many, which is the largest.
};

/// Exceeded where a governing check is; otherwise reserved where a finding is serious; not judged without any judged
/// check. Findings that are accepted by name are no reservation.
VerdictKind verdict_kind(const CheckTable& table, const Findings& findings);
Verdict make_verdict(const CheckTable& table, const Findings& findings);

/// `{kind, words, because}`
Json verdict_json(const Verdict& verdict);

/// What reserves a verdict, for a cell of a table: "pipe-off-rollers, compression"; empty without serious findings.
std::string serious_codes(const Findings& findings);

/// "2 serious findings: pipe-off-rollers, compression"; empty without.
std::string reservation(const Findings& findings);

/// False of checks of mooring lines, anchors and lines by themselves, which have no place on the laid pipe.
bool is_on_pipe(const CheckRow& row);

/// "12.3 m from the tensioner"; "line "west pipe", 33.0 m from its first end"; of moorings and wires the remark, which
/// names them.
std::string check_place(const CheckRow& row);

/// The governing and judged check of a region that is used most; null without one.
const CheckRow* governing_check(const CheckTable& table, CheckRegion region);

/// The regions from the tensioner on, the line as a whole last.
const std::vector<CheckRegion>& check_regions();

/// "laying criterion I, static strain, overbend"; a check of the line or of the tip that says so needs no place.
std::string check_words(const CheckRow& row);

/// "Overbend", "Stinger tip", "Line and equipment".
std::string region_title(CheckRegion region);

}  // namespace overbend
