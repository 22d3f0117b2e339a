#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

/// Limit of the varied quantity, a force or a length; check_lay_table has checked the dimension.
Member takes_limit(std::optional<double> LayTableDescription::*member) {
  return taken_by<LayTableDescription>([member](LayTableDescription& table, const FieldValue& value) {
    table.*member = parse_quantity(value.text, table.vary == LayTableVary::tension ? "N" : "m").value;
  });
}

std::vector<Field> profile() {
  const std::string s = "lay_table.profile[]";
  return {list_row("lay_table.profile", enters(&LayTableDescription::profile),
                   "Alternative to vary: points of a route by increasing distance, with a row for each.",
                   "the quantity of `vary` is varied"),
          group_row(s, appends<RouteDepth>(), "One point."),
          required(quantity_row(s + ".distance", fills(&RouteDepth::distance), "Distance along the route (KP).",
                                {"m", "km"}, kNotNegative)),
          required(quantity_row(s + ".depth", fills(&RouteDepth::depth), "Water depth at the stern shoe.", kLength,
                                kPositive))};
}

}  // namespace

std::vector<Field> lay_table() {
  using Table = LayTableDescription;
  std::vector<Field> rows = {
      otherwise(group_row("lay_table", enters(&Description::lay_table),
                          "Quantity varied by `overbend lay-table`, unless its options state otherwise."),
                "tension from half to twice tensioner.tension"),
      row_of_kind(FieldKind::choice, "lay_table.vary", defaults(&Table::vary),
                  "tension: at the tensioner; lay_back: stern shoe to touchdown, the tension follows; depth: water "
                  "depth, at a constant tension."),
      otherwise(row_of_kind(FieldKind::text, "lay_table.from", takes_limit(&Table::from),
                            "First value: a force for tension, a length for lay_back and depth."),
                "half the tension of the model; 0.8 times its lay-back or depth"),
      otherwise(row_of_kind(FieldKind::text, "lay_table.to", takes_limit(&Table::to), "Last value."),
                "twice the tension of the model; 1.2 times its lay-back or depth"),
      row_of_kind(FieldKind::integer, "lay_table.steps", defaults(&Table::steps),
                  "Number of steps from the first to the last value; there is one more row.",
                  {.low = 1.0, .high = 1000.0}),
      row_of_kind(
          FieldKind::choice, "lay_table.tension", defaults(&Table::tension),
          "For profile. hold: tensioner.tension; least: the minimum tension that passes every governing check.")};
  append(rows, profile());
  return rows;
}

}  // namespace overbend::field_rows
