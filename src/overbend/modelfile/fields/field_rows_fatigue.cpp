#include "modelfile/fields/field_rows_fatigue.h"

#include "model/description/fatigue_enum_names.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

constexpr double kWeldTime = 300.0, kMoveTime = 60.0;  ///< Default times per joint [s].
constexpr Shown kSmallLength = {"m", "mm"};

/// Reads the wall surface as a text.
Member takes_surface() {
  Member row = taken_by<FatigueSpotDescription>([](FatigueSpotDescription& spot, const FieldValue& value) {
    spot.inside = from_enum_name<FatigueSurface>(value.text) == FatigueSurface::inside;
  });
  row.choice_names = enum_names<FatigueSurface>();
  return with_default(row, std::string(enum_name(FatigueSurface::outside)));
}

std::vector<Field> spots() {
  const std::string p = "fatigue.spots[]";
  return {
      list_row("fatigue.spots", enters(&FatigueDescription::spots), "Hot spots of a weld, each with its S-N curve.",
               "outside with curve D and inside with curve F1"),
      group_row(p, appends<FatigueSpotDescription>(), "Hot spot of the weld: its cap, its root."),
      required(row_of_kind(FieldKind::text, p + ".name", fills(&FatigueSpotDescription::name),
                           "Name of the hot spot; must be unique.")),
      row_of_kind(FieldKind::choice, p + ".surface", takes_surface(), "Surface of the wall."),
      row_of_kind(FieldKind::choice, p + ".curve", defaults(&FatigueSpotDescription::curve),
                  "S-N curve of DNV-RP-C203."),
      otherwise(row_of_kind(FieldKind::choice, p + ".medium", fills(&FatigueSpotDescription::medium),
                            "Environment of the steel, which selects the S-N curve."),
                "outside: air above the mean water level and seawater_protected below; inside: air, in a pipe with "
                "contents seawater_free"),
      otherwise(row_of_kind(FieldKind::number, p + ".stress_factor", fills(&FatigueSpotDescription::stress_factor),
                            "Stress at the hot spot over the nominal stress of the wall.", {.low = 0.1, .high = 20.0}),
                "from hi_lo"),
  };
}

FatigueDescription& open_fatigue(Description& description, const FieldValue&) {
  FatigueDescription& fatigue = description.fatigue.emplace();
  fatigue.weld_time = kWeldTime;
  fatigue.move_time = kMoveTime;
  return fatigue;
}

}  // namespace

std::vector<Field> fatigue() {
  std::vector<Field> rows = {otherwise(
      group_row("fatigue", opened_by<Description>(open_fatigue),
                "Fatigue of girth welds while the pipe is laid, counted in a dynamic analysis. An empty group "
                "is enough."),
      "not counted")};
  append(rows, spots());
  append(rows,
         {row_of_kind(FieldKind::choice, "fatigue.edition", defaults(&FatigueDescription::edition),
                      "Edition of DNV-RP-C203 whose S-N curves count: April 2016 or October 2024. They differ "
                      "for B1 to C2; C to C2 of 2024 give more damage for ranges above 100 to 125 MPa in air, 240 to "
                      "300 MPa in protected seawater, and less below."),
          quantity_row("fatigue.hi_lo", defaults(&FatigueDescription::hi_lo),
                       "Misalignment of the walls at a weld, for the stress factor.", kSmallLength,
                       {.low = 0.0, .high = 0.05}),
          otherwise(quantity_row("fatigue.thickness", fills(&FatigueDescription::thickness),
                                 "Wall thickness for the thickness effect of the S-N curves.", kSmallLength,
                                 {.low = 0.0, .high = 1.0, .low_open = true}),
                    "the wall's"),
          quantity_row("fatigue.weld_time", with_default(fills(&FatigueDescription::weld_time), kWeldTime),
                       "Waiting time of the pipe before each move.", kTime, kNotNegative),
          quantity_row("fatigue.move_time", with_default(fills(&FatigueDescription::move_time), kMoveTime),
                       "Duration of a move.", kTime, kNotNegative),
          otherwise(quantity_row("fatigue.joint", fills(&FatigueDescription::joint), "Length of a move.", kLength,
                                 {.low = 0.1, .high = 1000.0}),
                    "length of the pipe's joints, or 12.2 m without joints"),
          row_of_kind(FieldKind::number, "fatigue.budget", defaults(&FatigueDescription::budget),
                      "Allowed damage during laying, with the design fatigue factor.",
                      {.low = 0.0, .high = 1.0, .low_open = true}),
          row_of_kind(FieldKind::number, "fatigue.design_factor", defaults(&FatigueDescription::design_factor),
                      "Design fatigue factor, which multiplies the damage.", {.low = 1.0, .high = 100.0})});
  return rows;
}

}  // namespace overbend::field_rows
