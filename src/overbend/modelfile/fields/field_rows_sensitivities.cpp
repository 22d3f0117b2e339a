#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {

std::vector<Field> sensitivities() {
  const std::string t = "sensitivities.tolerances";
  return {
      otherwise(group_row("sensitivities", {}, "Sensitivity analysis of the results: overbend static --sensitivities."),
                "default tolerances"),
      otherwise(group_row(t, {},
                          "Tolerances of inputs, either way. Each entry is a key of this file, in which '*' matches "
                          "any characters, such as supports.*.boxes[*].z; if several match, the last counts."),
                "10 mm for positions, 0.1 deg for angles, 1 % of anything else"),
      row_of_kind(FieldKind::text, t + ".*", read_elsewhere(),
                  "In the unit of the key, or per cent of its value: 2 %."),
  };
}

}  // namespace overbend::field_rows
