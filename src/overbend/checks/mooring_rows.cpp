#include "checks/mooring_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "checks/check_row.h"

namespace overbend {
namespace {

constexpr const char* kRp2sk = "API RP 2SK (3rd, 2005)";
constexpr CheckTitle kBreaking = {
    "mooring_load", "Mooring line, breaking load over safety factor", kRp2sk, "7.2", "tension at the fairlead", "N"};
constexpr CheckTitle kWorking = {
    "mooring_working_load", "Mooring line, working load", "project limit", "", "tension at the fairlead", "N"};
constexpr CheckTitle kHolding = {
    "anchor_load", "Anchor, holding power over safety factor", kRp2sk, "7.4", "tension at the anchor", "N"};
constexpr CheckTitle kLine = {
    "line_load", "Line, breaking load over safety factor", "safety factor", "", "effective tension", "N"};

/// Tension and its utilisation of a strength without safety factor.
struct Load {
  double tension = 0.0;
  double use = 0.0;   ///< Tension over strength [-].
  std::string where;  ///< "port bow, stage 2"
};

CheckRow row_with(const CheckTitle& title, const Load& load, const SafetyFactor& factor) {
  CheckRow row = make_row(title, CheckRegion::line);
  const double strength = load.tension / load.use;
  set_utilisation(row, load.tension, strength / factor.value);
  row.remark = fmt::format("{}: {} over a safety factor of {:.3g} ({})", load.where, shown(strength, "N", 1),
                           factor.value, factor.source);
  row.inputs = {{"T", "tension", load.tension, "N"},
                {"R", "breaking load or holding power", strength, "N"},
                {"n", "safety factor", factor.value, "1"}};
  return row;
}

/// Keeps the row of one kind with the maximum utilisation.
class WorstRow {
 public:
  void add(const CheckTitle& title, const std::optional<double>& use, double tension, const std::string& where,
           const SafetyFactor& factor) {
    if (!use || !(*use > 0.0) || !(tension > 0.0)) return;
    CheckRow row = row_with(title, {tension, *use, where}, factor);
    if (&title == &kLine) row.line = where;
    if (!row_ || row.utilisation > row_->utilisation) row_ = std::move(row);
  }
  void put(std::vector<CheckRow>& rows, bool in_time) {
    if (!row_) return;
    if (in_time) row_->remark += "; maximum of the run";
    rows.push_back(std::move(*row_));
  }

 private:
  std::optional<CheckRow> row_;
};

bool is_damaged(const MooredState& state) {
  return ranges::any_of(state.moorings, &MooringLineResult::parted);
}

bool is_damaged(const DynamicResults& dynamics) {
  return ranges::any_of(dynamics.moorings, [](const auto& line) { return line.parted_at.has_value(); });
}

struct MooringWorst {
  WorstRow breaking, working, holding;

  void put(std::vector<CheckRow>& rows, bool in_time) {
    breaking.put(rows, in_time);
    working.put(rows, in_time);
    holding.put(rows, in_time);
  }
};

std::optional<double> over(double tension, const std::optional<double>& limit) {
  return limit ? std::optional(tension / *limit) : std::nullopt;
}

void add_state(MooringWorst& worst, const Description& description, const MooredState& state) {
  const SafetyFactors& factors = description.checks.safety_factors;
  const bool damaged = is_damaged(state);
  const SafetyFactor line_factor = mooring_safety_factor(factors, damaged, TensionAnalysis::quasi_static);
  const SafetyFactor anchor_factor = anchor_safety_factor(factors, damaged);
  for (const MooringLineResult& line : state.moorings) {
    if (line.parted) continue;
    const std::string where = line.name + ", " + state.name;
    const double tension = line.fairlead_tension;
    worst.breaking.add(kBreaking, line.utilisation, tension, where, line_factor);
    worst.working.add(kWorking, over(tension, description.moorings->working_load), tension, where,
                      {1.0, "moorings.working_load"});
    worst.holding.add(kHolding, line.anchor_utilisation, line.anchor_tension, where, anchor_factor);
  }
}

/// Adds the maximum tensions of a line, of the whole run or of its intact part.
void add_line(MooringWorst& worst, const Description& description, const MooringLineDynamics& line, bool damaged) {
  const SafetyFactors& factors = description.checks.safety_factors;
  const bool elements = description.moorings->model == MooringModel::elements;
  const SafetyFactor line_factor =
      mooring_safety_factor(factors, damaged, elements ? TensionAnalysis::dynamic : TensionAnalysis::quasi_static);
  const double max_tension = line.fairlead_tension.whole.max, max_anchor_tension = line.anchor_tension.whole.max;
  const double tension = damaged ? max_tension : line.intact_fairlead_tension;
  const double anchor = damaged ? max_anchor_tension : line.intact_anchor_tension;
  const auto share = [](const std::optional<double>& use, double part, double total) {
    return use && total > 0.0 ? std::optional(*use * part / total) : std::nullopt;
  };
  worst.breaking.add(kBreaking, share(line.utilisation, tension, max_tension), tension, line.name, line_factor);
  worst.working.add(kWorking, over(tension, description.moorings->working_load), tension, line.name,
                    {1.0, "moorings.working_load"});
  worst.holding.add(kHolding, share(line.anchor_utilisation, anchor, max_anchor_tension), anchor, line.name,
                    anchor_safety_factor(factors, damaged));
}

/// Uses the factor of the intact mooring while all lines hold, then that of the damaged one.
void add_run(MooringWorst& worst, const Description& description, const DynamicResults& dynamics) {
  for (const MooringLineDynamics& line : dynamics.moorings) {
    add_line(worst, description, line, false);
    if (is_damaged(dynamics)) add_line(worst, description, line, true);
  }
}

/// Returns the names of the wires on other lines without a given breaking load.
std::string wires_without_strength(const Description& description) {
  std::string names;
  for (const FreeLineDescription& line : description.lines) {
    const bool on_another = line.first.kind == LineEndKind::line || line.second.kind == LineEndKind::line;
    const bool known =
        ranges::any_of(line.segments, [](const auto& segment) { return segment.type.breaking_load.has_value(); });
    if (on_another && !known && !has_pipe_section(line)) names += (names.empty() ? "" : ", ") + line.name;
  }
  return names;
}

}  // namespace

SafetyFactor mooring_safety_factor(const SafetyFactors& factors, bool damaged, TensionAnalysis analysis) {
  const std::optional<double>& own_factor = damaged ? factors.mooring_damaged : factors.mooring_intact;
  const std::string state = damaged ? "damaged" : "intact";
  if (own_factor) return {*own_factor, "checks.safety_factors.mooring_" + state};
  const bool dynamic = analysis == TensionAnalysis::dynamic;
  const double value = damaged ? (dynamic ? 1.25 : 1.43) : (dynamic ? 1.67 : 2.0);
  return {value, fmt::format("API RP 2SK, {}, {} tension", state, dynamic ? "dynamic" : "quasi-static")};
}

SafetyFactor anchor_safety_factor(const SafetyFactors& factors, bool damaged) {
  const std::optional<double>& own_factor = damaged ? factors.anchor_damaged : factors.anchor_intact;
  if (own_factor) return {*own_factor, std::string("checks.safety_factors.anchor_") + (damaged ? "damaged" : "intact")};
  return damaged ? SafetyFactor{1.0, "drag anchor, damaged, assumed"}
                 : SafetyFactor{1.5, "drag anchor, intact, assumed"};
}

SafetyFactor cable_safety_factor(const SafetyFactors& factors) {
  if (factors.cable) return {*factors.cable, "checks.safety_factors.cable"};
  return {3.0, "assumed; no public source"};
}

std::vector<CheckRow> mooring_rows(const Description& description, const MooringResults& rest,
                                   const DynamicResults* dynamics) {
  std::vector<CheckRow> rows;
  if (!description.moorings) return rows;
  MooringWorst worst;
  if (dynamics != nullptr) {
    add_run(worst, description, *dynamics);
  } else {
    add_state(worst, description, rest.rest);
    for (const MooredState& stage : rest.stages) add_state(worst, description, stage);
  }
  worst.put(rows, dynamics != nullptr);
  return rows;
}

std::vector<CheckRow> line_rows(const Description& description, const std::vector<LineResult>& lines,
                                const std::vector<LineDynamics>* in_time) {
  const std::optional<double>& own_factor = description.checks.safety_factors.line;
  const SafetyFactor factor =
      own_factor ? SafetyFactor{*own_factor, "checks.safety_factors.line"}
                 : SafetyFactor{in_time != nullptr ? 1.67 : 2.0, "assumed as for a mooring line, API RP 2SK"};
  WorstRow worst;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const LineResult& line = lines[i];
    const LineDynamics* const moved = in_time != nullptr ? &in_time->at(i) : nullptr;
    if (moved != nullptr && moved->utilisation) {
      worst.add(kLine, moved->utilisation, std::max(moved->max_tension, line.max_tension), line.name, factor);
    } else {
      worst.add(kLine, line.utilisation, line.max_tension, line.name, factor);
    }
  }
  std::vector<CheckRow> rows;
  worst.put(rows, in_time != nullptr);
  if (const std::string wires = wires_without_strength(description); !wires.empty()) {
    rows.push_back(not_done(make_row(kLine, CheckRegion::line), "no breaking load is given for " + wires));
  }
  return rows;
}

}  // namespace overbend
