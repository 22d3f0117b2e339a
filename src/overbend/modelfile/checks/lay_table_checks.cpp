#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

/// Returns a limit of the varied quantity [SI]; reports an error if it has another dimension.
std::optional<double> checked_limit(Checker& check, const FieldValue& table, const char* key, const std::string& unit) {
  const FieldValue* value = table.find(key);
  if (value == nullptr || !value->given) return std::nullopt;
  const QuantityReading reading = parse_quantity(value->text, unit);
  if (!reading.value) {
    check.error(*value, reading.found, dimension_phrase(unit) + " with its unit", reading.hint);
  } else if (*reading.value <= 0.0) {
    check.error(*value, value->shown, "more than 0");
    return std::nullopt;
  }
  return reading.value;
}

void check_profile(Checker& check, const FieldValue& table) {
  const FieldValue* before = nullptr;
  for (const FieldValue& point : Checker::items(table, "profile")) {
    const FieldValue* distance = point.find("distance");
    if (distance == nullptr) continue;
    if (before != nullptr && distance->number <= before->number) {
      check.error(*distance, distance->shown, "more than the distance before it, " + before->shown);
    }
    before = distance;
  }
}

}  // namespace

void check_lay_table(Checker& check) {
  const FieldValue* table = check.root().find("lay_table");
  if (table == nullptr || !table->given) return;
  if (!is_given(check.root(), "pipe")) check.error(*table, "a lay table", "no lay table in a model without a pipe");
  const bool tension = table->get_word<LayTableVary>("vary") == LayTableVary::tension;
  const auto from = checked_limit(check, *table, "from", tension ? "N" : "m");
  const auto to = checked_limit(check, *table, "to", tension ? "N" : "m");
  if (from && to && *from == *to) {
    check.error(*table->find("to"), table->find("to")->shown, "a value other than `from`");
  }
  check_profile(check, *table);
  const FieldValue* profile = table->find("profile");
  if (profile == nullptr || !profile->given) return;
  for (const char* key : {"vary", "from", "to", "steps"}) {
    const FieldValue* conflicting = table->find(key);
    if (conflicting != nullptr && conflicting->given) {
      check.error(*conflicting, "`profile` and `" + std::string(key) + "`", "one of them");
    }
  }
}

}  // namespace overbend
