#include "modelfile/fields/field_rows_fatigue.h"

#include "model/description/fatigue_words.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

constexpr double kWeldTime = 300.0, kMoveTime = 60.0;  ///< Of a joint where the file says nothing [s].
constexpr Shown kSmallLength = {"m", "mm"};

/// Which wall is one word in the file.
Member takes_surface() {
  Member row = taken_by<FatigueSpotDescription>([](FatigueSpotDescription& spot, const FieldValue& value) {
    spot.inside = from_word<FatigueSurface>(value.text) == FatigueSurface::inside;
  });
  row.words = words_of<FatigueSurface>();
  return with_default(row, std::string(word_of(FatigueSurface::outside)));
}

std::vector<Field> spots() {
  const std::string p = "fatigue.spots[]";
  return {
      list_row("fatigue.spots", enters(&FatigueDescription::spots),
               "Places of a weld that are looked at, each with its S-N curve.",
               "outside with curve D and inside with curve F1"),
      group_row(p, appends<FatigueSpotDescription>(), "A place of the weld: its cap, its root."),
      required(row_of_kind(FieldKind::text, p + ".name", fills(&FatigueSpotDescription::name),
                           "Name of the place; must be unique.")),
      row_of_kind(FieldKind::choice, p + ".surface", takes_surface(), "Surface of the wall on which it is."),
      row_of_kind(FieldKind::choice, p + ".curve", defaults(&FatigueSpotDescription::curve),
                  "S-N curve of DNV-RP-C203."),
      otherwise(row_of_kind(FieldKind::choice, p + ".medium", fills(&FatigueSpotDescription::medium),
                            "What the steel stands in there: chooses the S-N curve."),
                "outside: air above the mean water level and seawater_protected below; inside: air, in a pipe with "
                "contents seawater_free"),
      otherwise(row_of_kind(FieldKind::number, p + ".stress_factor", fills(&FatigueSpotDescription::stress_factor),
                            "Stress at the place over the nominal stress of the wall.", {.low = 0.1, .high = 20.0}),
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
                       "How long the pipe rests before each move.", kTime, kNotNegative),
          quantity_row("fatigue.move_time", with_default(fills(&FatigueDescription::move_time), kMoveTime),
                       "How long a move takes.", kTime, kNotNegative),
          otherwise(quantity_row("fatigue.joint", fills(&FatigueDescription::joint), "Length of a move.", kLength,
                                 {.low = 0.1, .high = 1000.0}),
                    "length of the pipe's joints, 12.2 m where it has none"),
          row_of_kind(FieldKind::number, "fatigue.budget", defaults(&FatigueDescription::budget),
                      "Damage that laying may use up, with the design fatigue factor.",
                      {.low = 0.0, .high = 1.0, .low_open = true}),
          row_of_kind(FieldKind::number, "fatigue.design_factor", defaults(&FatigueDescription::design_factor),
                      "Design fatigue factor, by which damage is multiplied.", {.low = 1.0, .high = 100.0})});
  return rows;
}

}  // namespace overbend::field_rows
