#include "modelfile/checks/fatigue_checks.h"

#include "model/description/description_words.h"
#include "modelfile/checks/line_checks.h"

namespace overbend {

void check_fatigue(Checker& check) {
  const FieldValue* fatigue = check.root().find("fatigue");
  if (fatigue == nullptr || !fatigue->given) return;
  if (!is_given(check.root(), "pipe")) {
    check.error(*fatigue, "fatigue of welds", "none in a model without a pipe");
  }
  const FieldValue* operation = check.root().find("operation");
  if (operation != nullptr && operation->get_word<OperationType>("type") == OperationType::pull_ahead) {
    check.error(*fatigue, "fatigue in a pull-ahead", "no group `fatigue`",
                "cycles are counted at stations, past which the pipe moves in this operation");
  }
  const auto weld = fatigue->get_number("weld_time"), move = fatigue->get_number("move_time");
  if (weld && move && *weld + *move <= 0.0) {
    const FieldValue* at = fatigue->find("weld_time");
    check.error(at != nullptr ? *at : *fatigue, "no time for a joint", "weld_time or move_time of more than 0 s");
  }
  check_unique_names(check, Checker::items(*fatigue, "spots"), "spot");
}

}  // namespace overbend
