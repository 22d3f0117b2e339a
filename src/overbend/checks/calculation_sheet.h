/// Calculation sheets of the code checks: lines of a check, each an input value or a formula with its value.
///
/// A formula is plain text in the symbols of the lines before it: a space multiplies, `*` and `/` are evaluated from
/// left to right, `^` is a power. Values are those used by the check; tests evaluate the formulas and compare.
#pragma once

#include <string>
#include <vector>

#include "results/check_results.h"

namespace overbend {

/// Formula of a code, or a constant printed in the code (then without formula).
struct CodeFormula {
  const char *symbol, *meaning;
  std::string formula;
  const char* units;   ///< SI
  std::string clause;  ///< Clause, including a key that selects a value from a table.
  Confirmation confirmation = Confirmation::not_needed;
  const char* sources = "";
};

struct CalculationSheet {
  std::vector<SheetLine> lines;

  /// Adds an input value. `origin`: key of the model file, or the analysis.
  void given(const char* symbol, const char* meaning, double value, const char* units, std::string origin);
  void computed(const CodeFormula& formula, double value);
};

/// Returns the sheet of a row with demand over capacity; empty if there is no capacity.
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
