/// Layout of summary.json as functions of a style, so that the page's types come from the same lines; see
/// resultfiles/summary/json_fields.h.
#pragma once

#include <algorithm>

#include "resultfiles/summary/json_fields.h"
#include "results/fields/attachment_fields.h"
#include "results/fields/check_fields.h"
#include "results/fields/dynamic_scalars.h"
#include "results/fields/ground_fields.h"
#include "results/fields/lay_operation_fields.h"
#include "results/fields/route_fields.h"
#include "results/fields/static_tables.h"
#include "results/fields/stinger_fields.h"

namespace overbend {

/// Returns the members written by one visit.
template <class Style, class Visit>
auto make_object(const Style& style, Visit visit_members) {
  JsonWriter<Style> json(style);
  visit_members(json);
  return json.take();
}

template <class Style>
auto summary_region(const Style& style, const RegionResult& region) {
  JsonWriter<Style> json(style);
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) { json(field, extreme.value); });
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) {
    json[field.place] =
        style.named("Place", make_object(style, [&](auto& visitor) { visit_place_of_extreme(extreme, visitor); }));
  });
  return style.named("StaticRegion", json.take());
}

template <class Style>
auto summary_support(const Style& style, const SupportResult& support) {
  JsonWriter<Style> json(style);
  visit_support(support, json);
  json["structure"] = style.word(support.stinger ? Structure::stinger : Structure::ramp);
  json.or_null("separation_lateral", support.has_sides);
  json["rows"] = style.rows(support.rows, [&](const RowResult& row) {
    JsonWriter<Style> rollers(style);
    for (const RollerResult& roller : row.rollers) {
      rollers[word(roller.position)] = make_object(style, [&](auto& visitor) { visit_roller(roller, visitor); });
    }
    return rollers.take();
  });
  return style.named("StaticSupport", json.take());
}

/// Numbers of a check; omitted if it was not done.
template <class Style>
void put_check_numbers(const Style& style, const CheckRow& row, JsonWriter<Style>& json) {
  json.part(row.status != CheckStatus::not_done, [&](auto& numbers) {
    visit_check_numbers(row, numbers);
    numbers["time"] = style.maybe(row.in_time, [&] { return style.number(row.time); });
  });
}

/// The lines of a calculation sheet.
template <class Style>
auto summary_sheet(const Style& style, const CheckRow& row) {
  return style.rows(row.sheet, [&](const SheetLine& line) {
    return style.named("SheetLine", make_object(style, [&](auto& members) { visit_sheet_line(line, members); }));
  });
}

template <class Style>
auto summary_check(const Style& style, const CheckRow& row) {
  JsonWriter<Style> json(style);
  visit_check_head(row, json);
  put_check_numbers(style, row, json);
  json["remark"] = style.text(row.remark);
  json["line"] = style.text(row.line);
  json["inputs"] = style.rows(row.inputs, [&](const CheckInput& input) {
    return make_object(style, [&](auto& visitor) { visit_check_input(input, visitor); });
  });
  json["sheet"] = summary_sheet(style, row);
  return style.named("CheckInFull", json.take());
}

template <class Style>
auto summary_checks(const Style& style, const CheckTable& table) {
  JsonWriter<Style> json(style);
  const CheckRow* worst = find_governing_check(table);
  json["worst"] =
      style.maybe(worst != nullptr, [&] { return summary_check(style, worst != nullptr ? *worst : CheckRow{}); });
  json["list"] = style.rows(table.rows, [&](const CheckRow& row) { return summary_check(style, row); });
  return json.take();
}

/// Head, cable and anchor of a line with a cable. The values of the anchor are members next to its position.
template <class Style>
void put_cable_parts(const Style& style, const StaticResults& r, JsonWriter<Style>& json) {
  json.part(r.head.has_value(), [&](auto& members) {
    const HeadResult head = r.head.value_or(HeadResult{});
    JsonWriter<Style> item(style);
    visit_head(head, item);
    item(ResultField{"z", "m", "Height of the head above the mean water level"}.summary(), head.p_W.z());
    members["head"] = item.take();
  });
  json.part(r.cable.has_value(), [&](auto& members) {
    const CableResult cable = r.cable.value_or(CableResult{});
    members["cable"] = make_object(style, [&](auto& visitor) { visit_cable(cable, visitor); });
  });
  json.part(r.far_anchor.has_value(), [&](auto& members) {
    const StartUpAnchorResult anchor = r.far_anchor.value_or(StartUpAnchorResult{});
    const auto anchor_json = make_object(style, [&](auto& visitor) { visit_far_anchor(anchor, visitor); });
    for (const auto& [key, value] : anchor_json.items()) members["anchor"][key] = value;
  });
}

/// The laid pipe on an uneven seabed.
template <class Style>
auto summary_bed(const Style& style, const BedResults& bed) {
  JsonWriter<Style> json(style);
  visit_laid_pipe(bed, json);
  json["contacts"] = style.rows(bed.contacts, [&](const BedContactResult& contact) {
    return style.named("BedContact", make_object(style, [&](auto& visitor) { visit_bed_contact(contact, visitor); }));
  });
  json["free_spans"] = style.rows(bed.spans, [&](const FreeSpanResult& span) {
    return style.named("FreeSpan", make_object(style, [&](auto& visitor) { visit_free_span(span, visitor); }));
  });
  return style.named("LaidPipe", json.take());
}

/// Position of the pipe on its route, and the limit cases of friction.
template <class Style>
void put_route_parts(const Style& style, const StaticResults& r, JsonWriter<Style>& json) {
  json.part(r.route.has_value(), [&](auto& members) {
    const RouteResults route = r.route.value_or(RouteResults{});
    members["route"] =
        style.named("RouteSummary", make_object(style, [&](auto& visitor) { visit_route(route, visitor); }));
  });
  json.part(!r.roller_friction.empty(), [&](auto& members) {
    members["roller_friction"] = style.rows(r.roller_friction, [&](const RollerFrictionCase& answer) {
      return style.named("FrictionCase",
                         make_object(style, [&](auto& visitor) { visit_friction_case(answer, visitor); }));
    });
  });
}

template <class Style>
auto summary_structure(const Style& style, const StructureResult& structure) {
  return style.named("StructureSummary",
                     make_object(style, [&](auto& visitor) { visit_structure(structure, visitor); }));
}

/// Clumps, buoys and wires on the pipe.
template <class Style>
void put_attachments(const Style& style, const StaticResults& r, JsonWriter<Style>& json) {
  json.part(!r.points.empty(), [&](auto& members) {
    members["points"] = style.rows(r.points, [&](const PipePointResult& point) {
      return style.named("PointSummary", make_object(style, [&](auto& visitor) { visit_pipe_point(point, visitor); }));
    });
  });
  json.part(!r.wires.empty(), [&](auto& members) {
    members["wires"] = style.rows(r.wires, [&](const PipeWireResult& wire) {
      return style.named("WireSummary", make_object(style, [&](auto& visitor) { visit_pipe_wire(wire, visitor); }));
    });
  });
}

/// A section of a stinger on hinges; the position of its tip from the stern shoe, in the frame of ramp and stinger.
template <class Style>
auto summary_stinger_section(const Style& style, const StaticResults& r, const StingerSectionResult& section) {
  JsonWriter<Style> json(style);
  visit_stinger_section(section, json);
  const Vec3 tip_V = r.R_WV.transpose() * (section.tip_W - r.stern_shoe_W);
  json(ResultField{"tip_x", "m", "Last roller astern of the stern shoe"}.summary("tip_roller/x"), -tip_V.x());
  json(ResultField{"tip_z", "m", "Last roller above the stern shoe"}.summary("tip_roller/z"), tip_V.z());
  json["tanks"] = style.rows(section.tanks, [&](const StingerTankResult& tank) {
    return style.named("StingerTank", make_object(style, [&](auto& visitor) { visit_stinger_tank(tank, visitor); }));
  });
  return json.take();
}

/// The stinger's first section, and a list of all sections if there are several.
template <class Style>
void put_stinger(const Style& style, const StaticResults& r, JsonWriter<Style>& json) {
  json.part(!r.stinger.empty(), [&](auto& members) {
    auto stinger = summary_stinger_section(style, r, r.stinger.empty() ? StingerSectionResult{} : r.stinger.front());
    if (r.stinger.size() > 1 || Style::kWhole) {
      stinger[Style::kTypes ? "sections?" : "sections"] =
          style.rows(r.stinger, [&](const StingerSectionResult& section) {
            return style.named("StingerSection", summary_stinger_section(style, r, section));
          });
    }
    members["stinger"] = std::move(stinger);
  });
}

/// The key `static`.
template <class Style>
auto static_part(const Style& style, const StaticResults& r) {
  JsonWriter<Style> json(style);
  visit_lay(r, json);
  json["smallest_tension"] = make_object(style, [&](auto& extreme_json) {
    const ResultField field = min_effective_tension_field();
    extreme_json(ResultField{"value", field.units, field.description}.summary(), r.min_effective_tension.value);
    extreme_json[field.place] =
        make_object(style, [&](auto& visitor) { visit_place_of_extreme(r.min_effective_tension, visitor); });
  });
  json.or_null("last_support", !r.last_support.empty());
  json["touchdown"] = make_object(style, [&](auto& touchdown) { visit_touchdown(r.touchdown, touchdown); });
  json["overbend"] =
      style.maybe(r.overbend.has_value(), [&] { return summary_region(style, r.overbend.value_or(RegionResult{})); });
  json["tower"] =
      style.maybe(r.tower.has_value(), [&] { return summary_region(style, r.tower.value_or(RegionResult{})); });
  json["sagbend"] = summary_region(style, r.sagbend);
  put_cable_parts(style, r, json);
  json.part(r.bed.has_value(),
            [&](auto& members) { members["seabed"] = summary_bed(style, r.bed.value_or(BedResults{})); });
  put_stinger(style, r, json);
  put_route_parts(style, r, json);
  json["supports"] = style.rows(r.supports, [&](const SupportResult& box) { return summary_support(style, box); });
  json["structures"] =
      style.rows(r.structures, [&](const StructureResult& structure) { return summary_structure(style, structure); });
  put_attachments(style, r, json);
  visit_contacts(r, json);
  for (const char* key : {"largest_reaction", "smallest_separation"}) json.or_null(key, !r.supports.empty());
  visit_balance(r, json);
  visit_solve(r.solve, json);
  return json.take();
}

template <class Style>
auto dynamic_region(const Style& style, const DynamicRegion& region) {
  JsonWriter<Style> json(style);
  visit_dynamic_region(region, [&](const ResultField& field, const DynamicExtreme& extreme) {
    json[*field.key(Style::kOutput)] = style.named(
        "ExtremeOverTime", make_object(style, [&](auto& visitor) { visit_dynamic_extreme(field, extreme, visitor); }));
  });
  return style.named("RegionSummary", json.take());
}

template <class Style>
auto dynamic_support(const Style& style, const SupportDynamics& support) {
  JsonWriter<Style> json(style);
  visit_dynamic_support(support, json);
  json["structure"] = style.word(support.stinger ? Structure::stinger : Structure::ramp);
  Json rows = Json::array();
  for (const RollerDynamics& roller : support.rollers) {
    while (static_cast<int>(rows.size()) <= roller.row) rows.push_back(Json::object());
    rows[static_cast<std::size_t>(roller.row)][word(roller.position)] =
        make_object(style, [&](auto& visitor) { visit_dynamic_roller(roller, visitor); });
  }
  json["rows"] = std::move(rows);
  return style.named("SupportSummary", json.take());
}

/// Maxima over the rollers of a support.
template <class Style>
auto support_impacts(const Style& style, const SupportDynamics& support) {
  RollerDynamics max_values;
  for (const RollerDynamics& roller : support.rollers) {
    for (double RollerDynamics::*member :
         {&RollerDynamics::max_impact_force, &RollerDynamics::max_approach_velocity, &RollerDynamics::max_impulse,
          &RollerDynamics::dent_depth, &RollerDynamics::line_load}) {
      max_values.*member = std::max(max_values.*member, roller.*member);
    }
  }
  JsonWriter<Style> json(style);
  json["name"] = style.text(support.name);
  json["count"] = style.count(support.impact_count);
  visit_hardest(max_values, json);
  return json.take();
}

/// Parts that exist only with a laid pipe.
template <class Style>
void put_pipe_over_time(const Style& style, const StaticResults& statics, const DynamicResults& r,
                        JsonWriter<Style>& json) {
  visit_pipe_over_time(r, json, true);
  json.or_null("stinger_tip_clearance", statics.stinger_tip_clearance.has_value());
  const ResultField min_tension = min_effective_tension_field();
  json[min_tension.name] = style.named("ExtremeOverTime", make_object(style, [&](auto& visitor) {
                                         visit_dynamic_extreme(min_tension, r.min_effective_tension, visitor);
                                       }));
  json["overbend"] = style.maybe(statics.overbend.has_value(), [&] { return dynamic_region(style, r.overbend); });
  json["tower"] = style.maybe(statics.tower.has_value(), [&] { return dynamic_region(style, r.tower); });
  json["sagbend"] = dynamic_region(style, r.sagbend);
  json["supports"] = style.rows(r.supports, [&](const SupportDynamics& box) { return dynamic_support(style, box); });
  json["impacts"] = style.rows(r.supports, [&](const SupportDynamics& box) { return support_impacts(style, box); });
  json["tensioner"] = make_object(style, [&](auto& visitor) { visit_tensioner(r.tensioner, visitor); });
}

/// The key `dynamic`.
template <class Style>
auto dynamic_part(const Style& style, const StaticResults& statics, const DynamicResults& r) {
  JsonWriter<Style> json(style);
  visit_dynamic_settings(r, json);
  if (Style::kWhole || statics.has_pipe()) put_pipe_over_time(style, statics, r, json);
  json["extremes"] = style.rows(r.extremes, [&](const ExtremeEstimate& e) {
    return make_object(style, [&](auto& visitor) { visit_estimate(e, visitor); });
  });
  json(ResultField{"energy_drift", "1", "Error of the energy balance relative to the energy exchanged"}.summary(),
       r.energy.drift());
  visit_dynamic_run(r.run, json);
  json["checks"] = summary_checks(style, r.checks);
  return json.take();
}

}  // namespace overbend
