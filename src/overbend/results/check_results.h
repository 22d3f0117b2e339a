/// What the code checks found: plain data, SI units.
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
  outside_validity,  ///< The formula does not hold for this pipe or load: neither passed nor failed.
  not_done,          ///< Something is missing, see `remark`.
};

enum class CheckRegion {
  line,      ///< All of the line, or the equipment.
  overbend,  ///< Tensioner to the last support in contact.
  tip,       ///< The rest of the overbend: from there to the inflection, where the pipe hangs free and still hogs.
  sagbend,   ///< From there to touchdown.
  seabed,
  tower,  ///< Where a clamped guide bends a pipe that no support carries.
};

/// A number that went into a check.
struct CheckInput {
  std::string symbol;   ///< "M_F"
  std::string meaning;  ///< "functional moment"
  double value = 0.0;
  std::string units;  ///< SI
};

/// How far the formula of a code, or a number that it prints, has been compared with public texts that restate it.
enum class Confirmation {
  not_needed,   ///< An input of the analysis, or a definition.
  two_sources,  ///< Two or more independent public restatements agree.
  one_source,
  unconfirmed,  ///< Recalled: no public restatement was found.
};

/// A line of a calculation sheet: a number that goes in, or a formula in the symbols of the lines before it.
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

/// One check at the station and moment where it is used most.
struct CheckRow {
  CheckRow();  // These six are compiled once: a copy of all members is long, and many sources make one.
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
  bool governing = true;  ///< False: for information, does not decide.
  std::string quantity;   ///< What demand and capacity are: "design strain".
  std::string units;      ///< SI, of both.
  double demand = 0.0, capacity = 0.0;
  double utilisation = 0.0;
  double reserve = 0.0;     ///< Factor on the load effects that brings the utilisation to 1 [-].
  std::string line;         ///< Name of the line by itself that is judged; empty: the laid pipe, equipment, moorings.
  double s = 0.0;           ///< Arc length from the anchor, of a line by itself from its first end [m].
  double from_top = 0.0;    ///< Along the laid pipe from the tensioner [m].
  Vec3 p_W = Vec3::Zero();  ///< Place in the static state [m].
  bool in_time = false;     ///< False: of the static state.
  double time = 0.0;        ///< When, where in_time [s].
  std::string remark;
  std::vector<CheckInput> inputs;
  std::vector<SheetLine> sheet;  ///< Calculation of the utilisation, which is its last line; empty where none is made.

  bool judged() const { return status == CheckStatus::passed || status == CheckStatus::exceeded; }
};

/// Largest utilisations at every station, arrays of one length; 0 where a check is not made.
struct CheckAlong {
  std::vector<double> s;          ///< From the anchor [m].
  std::vector<double> load;       ///< DNV load controlled.
  std::vector<double> strain;     ///< DNV displacement controlled, over the supports.
  std::vector<double> stress;     ///< Equivalent stress over 0.87 f_y, where the pipe hangs free and on the seabed.
  std::vector<double> laying;     ///< Simplified laying criteria on the strain, over the supports.
  std::vector<double> api;        ///< API bending and external pressure.
  std::vector<double> governing;  ///< Largest of those that decide at the station.
};

struct CheckTable {
  std::vector<CheckRow> rows;
  CheckAlong along;
  Assumptions assumptions;
};

/// A finding for every governing check whose formula does not hold: "passed" alone would hide that nobody looked.
Findings unjudged_checks(const CheckTable& table);

/// The judged and governing row that is used most; null without one.
inline const CheckRow* worst_check(const CheckTable& table) {
  const CheckRow* worst = nullptr;
  for (const CheckRow& row : table.rows) {
    if (row.governing && row.judged() && (worst == nullptr || row.utilisation > worst->utilisation)) worst = &row;
  }
  return worst;
}

}  // namespace overbend
