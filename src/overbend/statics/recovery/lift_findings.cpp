#include "statics/recovery/lift_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "base/shown_unit.h"

namespace overbend {
namespace {

const FreeLineDescription& described(const Model& model, const std::string& name) {
  return *ranges::find(model.description.lines, name, &FreeLineDescription::name);
}

/// Horizontal distance by which a free end has been drawn back by the lift [m].
std::optional<double> free_end_displacement(const Model& model, const LiftedLine& line) {
  const FreeLineDescription& description = described(model, line.name);
  if (line.first.free == line.second.free) return std::nullopt;
  const LiftedEnd &free = line.first.free ? line.first : line.second,
                  &held = line.first.free ? line.second : line.first;
  double length = 0.0;
  for (const LineSegmentDescription& segment : description.segments) length += segment.length.value();
  return length - (free.location.place - held.location.place).head<2>().norm();
}

void warn_of_ends(const Model& model, const LiftedLine& line, Findings& findings) {
  constexpr double kFar = 1.0;  // [m]
  const std::optional<double> back = free_end_displacement(model, line);
  if (!back || *back < kFar) return;
  findings.push_back(
      Finding{FindingCode::lifted_end_drawn_back,
              fmt::format("line \"{}\": its free end has drawn back by {}", line.name, shown(*back, "m", 1))}
          .on("line " + line.name)
          .with("distance", *back, "m"));
}

void warn_of_wire(const LiftResults& lift, const LiftedWire& wire, Findings& findings) {
  constexpr double kLeans = 0.2618;  // 15 deg
  constexpr double kSlack = 0.05;    // relative to the most loaded davit
  double max_tension = 0.0;
  for (const LiftedWire& davit : lift.davits) {
    if (davit.on == wire.on) max_tension = std::max(max_tension, davit.tension_upper);
  }
  if (wire.tension_upper <= kSlack * max_tension) {
    findings.push_back(
        Finding{FindingCode::davit_slack,
                fmt::format("line \"{}\": {}, its tension is {}", wire.name,
                            wire.tension_upper > 0.0 ? "nearly slack" : "slack", shown(wire.tension_upper, "N", 1))}
            .on("line " + wire.name)
            .with("tension", wire.tension_upper, "N"));
    return;
  }
  if (wire.from_vertical_upper <= kLeans) return;
  findings.push_back(Finding{
      FindingCode::davit_wire_leans,
      fmt::format("line \"{}\": leans by {} from the vertical", wire.name, shown(wire.from_vertical_upper, "rad", 1))}
                         .on("line " + wire.name)
                         .with("angle", wire.from_vertical_upper, "rad"));
}

void warn_of_yield(const LiftedLine& line, const LiftResults& lift, Findings& findings) {
  for (const LiftedWire& wire : lift.davits) {
    if (wire.on != line.name) continue;
    const auto node = ranges::min_element(line.nodes, {}, [&](const LiftedNode& node_of_line) {
      return std::abs(node_of_line.location.arc_length - wire.location.arc_length);
    });
    if (node->stress <= node->yield_stress) continue;
    findings.push_back(
        Finding{FindingCode::yield_at_davit,
                fmt::format("line \"{}\": its bending stress at \"{}\" is {}, its yield stress {}", line.name,
                            wire.name, shown(node->stress, "Pa", 0), shown(node->yield_stress, "Pa", 0))}
            .on("line " + line.name)
            .with("stress", node->stress, "Pa"));
  }
}

void warn_of_weld(const LiftResults& lift, Findings& findings) {
  if (!lift.join || lift.join->tension >= 0.0) return;
  findings.push_back(
      Finding{FindingCode::welded_line_pushed,
              fmt::format("the welded line has a compression of {} at the weld: it would buckle sideways",
                          shown(-lift.join->tension, "N", 1))}
          .with("tension", lift.join->tension, "N"));
}

}  // namespace

void warn_of_lift(const Model& model, const LiftResults& lift, Findings& findings) {
  for (const LiftedLine& line : lift.lines) {
    warn_of_ends(model, line, findings);
    warn_of_yield(line, lift, findings);
  }
  for (const LiftedWire& wire : lift.davits) warn_of_wire(lift, wire, findings);
  warn_of_weld(lift, findings);
}

void warn_of_wires(const Model& model, const std::vector<LineResult>& lines, Findings& findings) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const FreeLineDescription& description = model.description.lines[i];
    const LineResult& line = lines[i];
    const std::string object = "line " + line.name;
    if (line.utilisation && *line.utilisation > 1.0) {
      findings.push_back(Finding{FindingCode::breaking_load_exceeded,
                                 fmt::format("line \"{}\": its largest tension is {:.2f} times its breaking load",
                                             line.name, *line.utilisation)}
                             .on(object)
                             .with("utilisation", *line.utilisation, "1"));
    }
    const bool wire = !has_pipe_section(description) && is_weightless(description) && !is_linked(description);
    if (!wire || line.max_tension > 0.0) continue;
    findings.push_back(
        Finding{FindingCode::line_slack, fmt::format("line \"{}\": slack, it carries no load", line.name)}.on(object));
  }
}

Assumptions lift_assumptions(const Model& model) {
  Assumptions assumptions = {{AssumptionRank::other,
                              "Lines on lines: an attachment is a hinge on the axis of the line that carries it; pipe "
                              "is linear elastic, without torsion; the bed supports it along its underside."}};
  const bool wires = ranges::any_of(model.description.lines, [](const FreeLineDescription& line) {
    return !has_pipe_section(line) && is_weightless(line);
  });
  if (wires) {
    assumptions.push_back(
        {AssumptionRank::other,
         "Lines without weight are straight wires without compression, drag or contact with the bed."});
  }
  const bool welds = ranges::any_of(model.description.operation.lay.stages,
                                    [](const LayStageDescription& stage) { return stage.join.has_value(); });
  if (welds) {
    assumptions.push_back(
        {AssumptionRank::other,
         "A weld keeps the angle between its ends, in the vertical plane of the first line; the ends are "
         "brought together before they are welded."});
  }
  return assumptions;
}

}  // namespace overbend
