#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {

std::vector<Field> sensitivities() {
  const std::string t = "sensitivities.tolerances";
  return {
      otherwise(group_row("sensitivities", {}, "What the results hang on: overbend static --sensitivities."),
                "usual tolerances"),
      otherwise(group_row(t, {},
                          "How far inputs may be off, either way. Each entry is a key of this file, in which '*' "
                          "stands for any letters, such as supports.*.boxes[*].z; of several that match the last "
                          "counts."),
                "10 mm for places, 0.1 deg for angles, 1 % of anything else"),
      row_of_kind(FieldKind::text, t + ".*", read_elsewhere(),
                  "In the unit of the key, or per cent of its value: 2 %."),
  };
}

}  // namespace overbend::field_rows
