#include "model/description/seek_words.h"
#include "modelfile/fields/row_makers.h"
#include "modelfile/fields/seek_values.h"

namespace overbend::field_rows {
namespace {

Field text_row(std::string path, Member member, std::string text) {
  return row_of_kind(FieldKind::text, std::move(path), std::move(member), std::move(text));
}

/// check_seek has held the text to the row; a stored model is not checked again.
double value_of(const FieldValue& value, const Field* row) {
  const ScalarReading reading = row != nullptr ? read_value_of(value.text, *row) : ScalarReading{};
  return reading.value ? reading.value->number : 0.0;
}

Member takes_key() {
  return taken_by<SeekVariable>([](SeekVariable& variable, const FieldValue& value) {
    variable.key = value.text;
    if (const Field* row = varied_row(value.text)) {
      variable.unit = unit_of(*row);
      variable.show = row->kind == FieldKind::quantity ? row->show : "";
    }
  });
}

Member takes_bound(std::optional<double> SeekVariable::*bound) {
  return taken_by<SeekVariable>([bound](SeekVariable& variable, const FieldValue& value) {
    const Field* row = varied_row(variable.key);
    Field free = row != nullptr ? *row : Field{};
    free.range = {};
    variable.*bound = value_of(value, row != nullptr ? &free : nullptr);
  });
}

std::vector<Field> variable_rows(const std::string& p) {
  return {
      required(text_row(p + ".key", takes_key(),
                        "Key of the model file with a quantity or a number, such as tensioner.tension. An item of a "
                        "list is chosen by its index from 0, its name or a pattern: boxes[stinger *].z is one unknown "
                        "for every box that it matches. Of a lift also entries of stages: "
                        "operation.stages[NAME].lengths[davit *].")),
      otherwise(text_row(p + ".from", takes_bound(&SeekVariable::from), "Lower bound, with the unit of the key."),
                "within is given"),
      otherwise(text_row(p + ".to", takes_bound(&SeekVariable::to), "Upper bound, with the unit of the key."),
                "within is given"),
      otherwise(text_row(p + ".within", takes_bound(&SeekVariable::within),
                         "Instead of from and to: largest change either way from the value in the model."),
                "from and to are given"),
  };
}

Member takes_result() {
  return taken_by<SeekCondition>([](SeekCondition& condition, const FieldValue& value) {
    condition.result = value.text;
    if (const std::optional<Field> row = result_row(value.text)) condition.unit = row->unit;
  });
}

Member takes_goal(SeekRelation relation) {
  return taken_by<SeekCondition>([relation](SeekCondition& condition, const FieldValue& value) {
    const std::optional<Field> row = result_row(condition.result);
    condition.relation = relation;
    condition.value = value_of(value, row ? &*row : nullptr);
  });
}

std::vector<Field> condition_rows(const std::string& p) {
  const auto goal = [&](SeekRelation relation, const char* text) {
    return otherwise(text_row(p + "." + std::string(word_of(relation)), takes_goal(relation), text), "not asked for");
  };
  return {
      required(text_row(p + ".result", takes_result(),
                        "Result by its path in summary.json, such as static.sagbend.max_bending_stress or "
                        "static.supports[stinger 7].reaction, or by object, such as lines[pipe].static.lay_back; "
                        "min(), max(), mean() and spread() of a path with a pattern. Of a lift results of stages: "
                        "operation.stages[NAME].lines.pipe.first_end.z.")),
      goal(SeekRelation::equals, "Value that the result is to have, with its unit."),
      goal(SeekRelation::at_most, "Upper limit of the result. A single key gets the least value that holds it."),
      goal(SeekRelation::at_least, "Lower limit of the result. A single key gets the least value that holds it."),
  };
}

}  // namespace

std::vector<Field> seek() {
  const Member one_key = opened_by<SeekDescription>(
      [](SeekDescription& seek, const FieldValue&) -> SeekVariable& { return seek.vary.emplace_back(); });
  const Member one_goal = opened_by<SeekDescription>(
      [](SeekDescription& seek, const FieldValue&) -> SeekCondition& { return seek.until.emplace_back(); });
  std::vector<Field> rows = {
      otherwise(group_row("seek", read_elsewhere(),  // by modelfile/reading/seek_reader.h
                          "What `overbend seek` looks for."),
                "nothing"),
      required(group_row("seek.vary", one_key, "The key that may change; or a list of such groups."))};
  append(rows, variable_rows("seek.vary"));
  rows.push_back(list_row("seek.vary", enters(&SeekDescription::vary), "Several keys that may change.", "one group"));
  rows.push_back(group_row("seek.vary[]", appends<SeekVariable>(), "A key, or those that a pattern matches."));
  append(rows, variable_rows("seek.vary[]"));
  rows.push_back(
      otherwise(group_row("seek.until", one_goal, "The condition; or a list of such groups."), "minimise is given"));
  append(rows, condition_rows("seek.until"));
  rows.push_back(list_row("seek.until", enters(&SeekDescription::until), "Several conditions.", "one group"));
  rows.push_back(group_row("seek.until[]", appends<SeekCondition>(), "A condition."));
  append(rows, condition_rows("seek.until[]"));
  rows.push_back(otherwise(
      text_row("seek.minimise", fills(&SeekDescription::minimise), "Result to make as small as the conditions allow."),
      "not asked for"));
  return rows;
}

}  // namespace overbend::field_rows
