/// Results of the code checks: plain data, SI units.
#pragma once

#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "base/vec.h"

namespace overbend {

enum class CheckStatus {
  passed,
  exceeded,          ///< Utilisation above 1.
  outside_validity,  ///< The formula is not valid for this pipe or load: neither passed nor failed.
  not_done,          ///< An input is missing, see `remark`.
};

enum class CheckRegion {
  line,      ///< The whole line, or the equipment.
  overbend,  ///< Tensioner to the last support in contact.
  tip,       ///< Free end of the overbend: last support contact to the inflection; the pipe is suspended but still
             ///< hogging.
  sagbend,   ///< Inflection to touchdown.
  seabed,
  tower,  ///< Clamped guide that bends a pipe without support contact.
};

/// An input of a check.
struct CheckInput {
  std::string symbol;   ///< "M_F"
  std::string meaning;  ///< "functional moment"
  double value = 0.0;
  std::string units;  ///< SI
};

/// Extent to which a code formula or coefficient has been compared with public texts that restate it.
enum class Confirmation {
  not_needed,   ///< An input of the analysis, or a definition.
  two_sources,  ///< Two or more independent public restatements agree.
  one_source,
  unconfirmed,  ///< From memory: no public restatement was found.
};

/// A line of a calculation sheet: an input, or a formula in the symbols of the preceding lines.
struct SheetLine {
  std::string symbol;   ///< "M_p"
  std::string meaning;  ///< "plastic moment"
  std::string formula;  ///< "f_y (D - t_2)^2 t_2", or an equation that the value solves; empty for an input.
  double value = 0.0;   ///< As used by the check.
  std::string units;    ///< SI
  std::string origin;   ///< Clause of a formula; key of the model file or analysis that an input comes from.
  Confirmation confirmation = Confirmation::not_needed;
  std::string sources;  ///< Public texts that it was compared with.
};

/// One check at the station and time of its maximum utilisation.
struct CheckRow {
  CheckRow();  // These six are defined in the source file: the member-wise copy is long, and many sources would
               // instantiate it.
  CheckRow(const CheckRow&);
  CheckRow(CheckRow&&) noexcept;
  CheckRow& operator=(const CheckRow&);
  CheckRow& operator=(CheckRow&&) noexcept;
  ~CheckRow();

  std::string id;      ///< For scripts: "dnv_load_controlled".
  std::string name;    ///< "Local buckling, load controlled"
  std::string code;    ///< With its edition: "DNV-ST-F101 (2021)".
  std::string clause;  ///< "5.4.6"
  CheckRegion region = CheckRegion::line;
  CheckStatus status = CheckStatus::not_done;
  bool governing = true;  ///< False: informational, not part of the verdict.
  std::string quantity;   ///< Quantity of demand and capacity: "design strain".
  std::string units;      ///< SI unit of both.
  double demand = 0.0, capacity = 0.0;
  double utilisation = 0.0;
  double reserve = 0.0;     ///< Factor on the load effects that brings the utilisation to 1 [-].
  std::string line;         ///< Name of the checked stand-alone line; empty for the laid pipe, equipment and moorings.
  double s = 0.0;           ///< Arc length from the anchor; for a stand-alone line from its first end [m].
  double from_top = 0.0;    ///< Along the laid pipe from the tensioner [m].
  Vec3 p_W = Vec3::Zero();  ///< Position in the static state [m].
  bool in_time = false;     ///< True if the maximum occurs in the time-domain simulation; false for the static state.
  double time = 0.0;        ///< Time of the maximum if in_time [s].
  std::string remark;
  std::vector<CheckInput> inputs;
  std::vector<SheetLine> sheet;  ///< Calculation of the utilisation, which is its last line; empty if there is none.

  /// True if the check has a verdict: passed or exceeded.
  bool judged() const { return status == CheckStatus::passed || status == CheckStatus::exceeded; }
};

/// Maximum utilisations at every station, arrays of one length; 0 where a check does not apply.
struct CheckAlong {
  std::vector<double> s;          ///< Arc length from the anchor [m].
  std::vector<double> load;       ///< DNV load-controlled local buckling.
  std::vector<double> strain;     ///< DNV displacement-controlled local buckling, over the supports.
  std::vector<double> stress;     ///< Equivalent stress over 0.87 f_y, where the pipe is suspended or on the seabed.
  std::vector<double> laying;     ///< Simplified laying criteria on the strain, over the supports.
  std::vector<double> api;        ///< API bending and external pressure.
  std::vector<double> governing;  ///< Maximum over the governing checks at the station.
};

struct CheckTable {
  std::vector<CheckRow> rows;
  CheckAlong along;
  Assumptions assumptions;
};

/// Returns a finding for every governing check outside the validity of its formula: an unchecked criterion must not
/// read as passed.
Findings find_invalid_checks(const CheckTable& table);

/// Returns the judged, governing row with the maximum utilisation; null if there is none.
inline const CheckRow* find_governing_check(const CheckTable& table) {
  const CheckRow* worst = nullptr;
  for (const CheckRow& row : table.rows) {
    if (row.governing && row.judged() && (worst == nullptr || row.utilisation > worst->utilisation)) worst = &row;
  }
  return worst;
}

}  // namespace overbend
