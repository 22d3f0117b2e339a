/// Verdict of the code checks, in one line.
#pragma once

#include <string>
#include <vector>

#include "report/warning_weight.h"
#include "results/check_results.h"

namespace overbend {

enum class VerdictKind {
  passed,
  reserved,  ///< Nothing exceeded, but with reservations.
  exceeded,
  open,  ///< Nothing could be judged.
};

struct Verdict {
  VerdictKind kind = VerdictKind::open;
  std::string words;    ///< "PASSED", "EXCEEDED 1.43, clearance at the stinger tip"
  std::string because;  ///< Sentences: how many, which is the largest.
};

/// Exceeded by the governing check that is used most; reserved where a governing check lies outside the validity of its
/// formula or a warning is serious.
Verdict verdict_of(const CheckTable& table, const std::vector<WeighedWarning>& warnings);

/// The governing and judged check of a region that is used most; null without one.
const CheckRow* governing_check(const CheckTable& table, CheckRegion region);

/// The regions from the tensioner on, the line as a whole last.
const std::vector<CheckRegion>& check_regions();

/// "laying criterion I, static strain, overbend"; a check of the line or of the tip that says so needs no place.
std::string check_words(const CheckRow& row);

/// "Overbend", "Stinger tip", "Line and equipment".
std::string region_title(CheckRegion region);

}  // namespace overbend
