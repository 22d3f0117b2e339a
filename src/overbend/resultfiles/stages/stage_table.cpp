#include "resultfiles/stages/stage_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "resultfiles/tables/csv_fields.h"
#include "results/fields/dragging_fields.h"
#include "results/fields/lay_operation_fields.h"
#include "results/findings.h"
#include "results/lift_brief.h"
#include "results/result_enum_names.h"
#include "results/sagbend.h"

namespace overbend {
namespace {

/// Collects visited fields in columns, stage by stage; every stage visits the same fields in the same order.
class ColumnGatherer {
 public:
  /// Until the next call, visited fields are examples whose cells stay empty.
  void absent(bool absent) { absent_ = absent; }
  void end_row() { next_ = 0; }
  std::vector<StageTableColumn> take() { return std::move(columns_); }

  void operator()(const ResultField& f, double value) {
    if (f.heading.empty()) return;
    const ShownUnit unit = shown_unit(f);
    StageTableColumn& column = next(f, false);
    column.unit = unit.name;
    column.digits = unit.digits;
    column.numbers.push_back(absent_ ? std::numeric_limits<double>::quiet_NaN() : value * unit.factor);
  }
  void operator()(const ResultField& f, const std::optional<double>& value) {
    (*this)(f, value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  void operator()(const ResultField& f, const std::string& value) {
    if (!f.heading.empty()) next(f, true).texts.push_back(absent_ ? "" : value);
  }
  template <class Other>
  void operator()(const ResultField&, const Other&) {}

 private:
  StageTableColumn& next(const ResultField& f, bool text) {
    if (next_ == columns_.size()) {
      columns_.emplace_back().heading = f.heading;
      columns_.back().text = text;
    }
    return columns_[next_++];
  }

  std::vector<StageTableColumn> columns_;
  std::size_t next_ = 0;
  bool absent_ = false;
};

/// Key results of a lay, in reading order: tension, shape, stresses, contacts.
template <class Visit>
void visit_lay_in_brief(const StaticResults& r, Visit& visit) {
  const auto nothing = std::numeric_limits<double>::quiet_NaN();
  visit(ResultField{"top_tension", "N"}.csv("top tension"), r.top_tension);
  visit(ResultField{"bottom_tension", "N"}.csv("bottom tension"), r.bottom_tension);
  visit(ResultField{"lay_back", "m"}.csv("lay-back"), r.lay_back);
  visit(ResultField{"top_inclination", "rad"}.csv("top inclination"), r.top_inclination);
  visit(ResultField{"departure_angle", "rad"}.csv("departure angle"), r.departure_angle);
  visit(ResultField{"von_mises", "Pa"}.csv("overbend von Mises stress"),
        r.overbend ? r.overbend->von_mises.value : nothing);
  visit(ResultField{"strain", "1"}.csv("overbend strain"), r.overbend ? r.overbend->strain.value : nothing);
  visit(ResultField{"von_mises", "Pa"}.csv("sagbend von Mises stress"),
        has_sagbend(r) ? r.sagbend.von_mises.value : nothing);
  visit(ResultField{"strain", "1"}.csv("sagbend strain"), has_sagbend(r) ? r.sagbend.strain.value : nothing);
  visit(ResultField{"bending_moment", "N m"}.csv("sagbend moment"),
        has_sagbend(r) ? r.sagbend.bending_moment.value : nothing);
  visit(ResultField{"tip_clearance", "m"}.csv("tip clearance"), r.stinger_tip_clearance);
  const StingerSectionResult* stinger = r.stinger.empty() ? nullptr : &r.stinger.front();
  visit(ResultField{"stinger_angle", "rad"}.csv("stinger angle"), stinger != nullptr ? stinger->angle : nothing);
  visit(ResultField{"hinge_force", "N"}.csv("hinge force"), stinger != nullptr ? stinger->hinge_force : nothing);
  visit(ResultField{"stop_moment", "N m"}.csv("stop moment"), stinger != nullptr ? stinger->stop_moment : nothing);
  visit(ResultField{"reaction", "N"}.csv("largest reaction"), r.supports.empty() ? nothing : r.max_reaction);
  visit(ResultField{"support", "1"}.csv("at"), r.max_reaction_support);
  const CheckRow* worst = find_governing_check(r.checks);
  visit(ResultField{"check", "1"}.csv("decisive check"), worst != nullptr ? worst->name : std::string());
  visit(ResultField{"utilisation", "1"}.csv("utilisation"), worst != nullptr ? worst->utilisation : nothing);
}

/// Visits a part, or an example of it with empty cells.
template <class Part, class VisitPart>
void visit_or_absent(const std::optional<Part>& part, ColumnGatherer& columns, VisitPart visit_part) {
  columns.absent(!part);
  const Part example{};
  visit_part(part ? *part : example);
  columns.absent(false);
}

/// Key results of a lift: maxima over all its lines, and the tension of every davit cable.
template <class Visit>
void visit_lift_in_brief(const StaticResults& r, Visit& visit) {
  const LiftResults& lift = *r.lift;
  const LiftBrief brief = in_brief(lift);
  visit(ResultField{"moment", "N m"}.csv("largest moment"), brief.moment);
  visit(ResultField{"stress", "Pa"}.csv("largest bending stress"), brief.stress);
  for (const LiftedLine& line : lift.lines) {
    const LiftedEnd& end = line.first.free || !line.second.free ? line.first : line.second;
    visit(ResultField{"z", "m"}.csv("end of " + line.name + ", z"), end.location.place.z());
    visit(ResultField{"inclination", "rad"}.csv("end of " + line.name + ", inclination"), end.location.inclination);
  }
  for (const LiftedWire& wire : lift.davits) {
    visit(ResultField{"length", "m"}.csv(wire.name + ", length"), wire.length);
    visit(ResultField{"tension", "N"}.csv(wire.name + ", tension"), wire.tension_upper);
  }
  const CheckRow* worst = find_governing_check(r.checks);
  visit(ResultField{"check", "1"}.csv("decisive check"), worst != nullptr ? worst->name : std::string());
  visit(ResultField{"utilisation", "1"}.csv("utilisation"),
        worst != nullptr ? worst->utilisation : std::numeric_limits<double>::quiet_NaN());
}

/// `like`: a solved stage of a lift, whose fields replace those of a failed one; null for other operations.
void gather(const StageResult& stage, const StaticResults* like, ColumnGatherer& columns) {
  visit_lay_stage(stage.stage, columns);
  columns(ResultField{"status"}.csv("status"), std::string(stage.lay ? "converged" : "no equilibrium"));
  columns(ResultField{"verdict"}.csv("verdict"), std::string(stage.lay ? word(stage_verdict(stage).kind) : ""));
  if (like != nullptr) {
    columns.absent(!stage.lay);
    visit_lift_in_brief(stage.lay ? *stage.lay : *like, columns);
    columns.absent(false);
    columns(ResultField{"why"}.csv("why not"),
            stage.failure ? stage.failure->what + ": " + stage.failure->why : std::string());
    columns.end_row();
    return;
  }
  visit_stage_result(stage, columns);
  visit_or_absent(stage.lay, columns, [&](const StaticResults& lay) { visit_lay_in_brief(lay, columns); });
  const StaticResults none{};
  const StaticResults& lay = stage.lay ? *stage.lay : none;
  visit_or_absent(lay.head, columns, [&](const HeadResult& head) {
    visit_head(head, columns);
    columns(ResultField{"z", "m"}.csv("head height"), head.p_W.z());
  });
  visit_or_absent(lay.cable, columns, [&](const CableResult& cable) { visit_cable(cable, columns); });
  visit_or_absent(lay.far_anchor, columns,
                  [&](const StartUpAnchorResult& anchor) { visit_far_anchor(anchor, columns); });
  visit_or_absent(lay.dragging, columns, [&](const DraggingResults& dragging) {
    columns(ResultField{"wire_out", "m"}.csv("wire out"), lay.cable ? lay.cable->length : 0.0);
    visit_dragging(dragging, columns);
    columns(ResultField{"least_tension", "N"}.csv("least tension along the line"), lay.min_effective_tension.value);
  });
  const std::optional<LiftOffResult> no_lift_off;
  visit_or_absent(lay.dragging ? lay.dragging->lift_off : no_lift_off, columns,
                  [&](const LiftOffResult& lift_off) { visit_lift_off(lift_off, columns); });
  const std::string why = stage.failure ? stage.failure->what + ": " + stage.failure->why : "";
  columns(ResultField{"why"}.csv("why not"), why);
  columns(ResultField{"least_tension", "N"}.csv("least tension"),
          stage.failure ? stage.failure->min_tension : std::nullopt);
  columns.end_row();
}

bool is_empty(const StageTableColumn& column) {
  if (column.text) {
    return std::all_of(column.texts.begin(), column.texts.end(), [](const std::string& cell) { return cell.empty(); });
  }
  return std::all_of(column.numbers.begin(), column.numbers.end(), [](double cell) { return std::isnan(cell); });
}

}  // namespace

std::vector<StageTableColumn> stage_table_columns(const OperationResults& results) {
  ColumnGatherer gatherer;
  const StaticResults* lift = nullptr;
  for (const StageResult& stage : results.stages) {
    if (stage.lay && stage.lay->lift) lift = &*stage.lay;
  }
  for (const StageResult& stage : results.stages) gather(stage, lift, gatherer);
  std::vector<StageTableColumn> columns = gatherer.take();
  std::erase_if(columns, is_empty);
  return columns;
}

Table stages_table(const OperationResults& results) {
  Table table{"Stages", {}};
  table.rows.resize(results.stages.size());
  for (const StageTableColumn& column : stage_table_columns(results)) {
    table.column(column.text ? TableColumn(column.heading)
                             : TableColumn(column.heading, ShownUnit{"", column.unit}, column.digits));
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const bool none = !column.text && std::isnan(column.numbers[i]);
      table.rows[i].cells.push_back(none          ? TableCell()
                                    : column.text ? TableCell(column.texts[i])
                                                  : TableCell(column.numbers[i]));
    }
  }
  return table;
}

}  // namespace overbend
