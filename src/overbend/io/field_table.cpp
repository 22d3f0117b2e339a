#include "io/field_table.h"

#include <iterator>

#include "io/field_rows.h"

namespace overbend {
namespace {

using namespace field_rows;

std::vector<Field> head() {
  return {
      {.path = "overbend",
       .kind = FieldKind::integer,
       .text = "Version of the model file's format.",
       .required = true,
       .range = {.low = kFormatVersion, .high = kFormatVersion}},
      {.path = "title", .kind = FieldKind::text, .text = "Heads the report.", .fallback_text = "name of the file"},
  };
}

}  // namespace

const std::vector<Field>& field_table() {
  static const std::vector<Field> kTable = [] {
    std::vector<Field> table;
    for (auto* part :
         {head, environment, waves, pipe, vessel, motion_convention, tensioner, rollers, supports, analysis, checks}) {
      const std::vector<Field> rows = part();
      table.insert(table.end(), rows.begin(), rows.end());
    }
    return table;
  }();
  return kTable;
}

}  // namespace overbend
