#include "modelfile/checks/fatigue_checks.h"

#include "model/description/description_enum_names.h"
#include "modelfile/checks/line_checks.h"

namespace overbend {

void check_fatigue(Checker& check) {
  const FieldValue* fatigue = check.root().find("fatigue");
  if (fatigue == nullptr || !fatigue->given) return;
  if (!is_given(check.root(), "pipe")) {
    check.error(*fatigue, "fatigue of welds", "no fatigue group in a model without a pipe");
  }
  const FieldValue* operation = check.root().find("operation");
  if (operation != nullptr && operation->get_word<OperationType>("type") == OperationType::pull_ahead) {
    check.error(*fatigue, "fatigue in a pull-ahead", "no group `fatigue`",
                "cycles are counted at fixed stations, past which the pipe moves in this operation");
  }
  const auto weld = fatigue->get_number("weld_time"), move = fatigue->get_number("move_time");
  if (weld && move && *weld + *move <= 0.0) {
    const FieldValue* key = fatigue->find("weld_time");
    check.error(key != nullptr ? *key : *fatigue, "no time per joint", "a weld_time or move_time of more than 0 s");
  }
  check_unique_names(check, Checker::items(*fatigue, "spots"), "spot");
}

}  // namespace overbend
