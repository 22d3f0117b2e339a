#include "model/description/seek_enum_names.h"
#include "modelfile/fields/row_makers.h"
#include "modelfile/fields/seek_values.h"

namespace overbend::field_rows {
namespace {

Field text_row(std::string path, Member member, std::string text) {
  return row_of_kind(FieldKind::text, std::move(path), std::move(member), std::move(text));
}

/// check_seek has checked the text against the row; a stored model is not checked again.
double read_value(const FieldValue& value, const Field* row) {
  const ScalarReading reading = row != nullptr ? read_row_value(value.text, *row) : ScalarReading{};
  return reading.value ? reading.value->number : 0.0;
}

Member takes_key() {
  return taken_by<SeekVariable>([](SeekVariable& variable, const FieldValue& value) {
    variable.key = value.text;
    if (const Field* row = varied_row(value.text)) {
      variable.unit = row_unit(*row);
      variable.show = row->kind == FieldKind::quantity ? row->show : "";
    }
  });
}

Member takes_bound(std::optional<double> SeekVariable::*bound) {
  return taken_by<SeekVariable>([bound](SeekVariable& variable, const FieldValue& value) {
    const Field* row = varied_row(variable.key);
    Field free = row != nullptr ? *row : Field{};
    free.range = {};
    variable.*bound = read_value(value, row != nullptr ? &free : nullptr);
  });
}

std::vector<Field> variable_rows(const std::string& p) {
  return {
      required(
          text_row(p + ".key", takes_key(),
                   "Key of the model file with a quantity or a number, such as tensioner.tension. An item of a list is "
                   "selected by its index from 0, its name or a pattern: boxes[stinger *].z is one unknown for every "
                   "box that it matches. For a lift also entries of stages: operation.stages[NAME].lengths[davit *].")),
      otherwise(text_row(p + ".from", takes_bound(&SeekVariable::from), "Lower bound, with the unit of the key."),
                "within is given"),
      otherwise(text_row(p + ".to", takes_bound(&SeekVariable::to), "Upper bound, with the unit of the key."),
                "within is given"),
      otherwise(text_row(p + ".within", takes_bound(&SeekVariable::within),
                         "Alternative to from and to: largest change either way from the value in the model."),
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
    condition.value = read_value(value, row ? &*row : nullptr);
  });
}

std::vector<Field> condition_rows(const std::string& p) {
  const auto goal = [&](SeekRelation relation, const char* text) {
    return otherwise(text_row(p + "." + std::string(enum_name(relation)), takes_goal(relation), text),
                     "no such condition");
  };
  return {
      required(text_row(
          p + ".result", takes_result(),
          "Result by its path in summary.json, such as static.sagbend.max_bending_stress or static.supports[stinger "
          "7].reaction, or by object, such as lines[pipe].static.lay_back; min(), max(), mean() and spread() of a path "
          "with a pattern. For a lift results of stages: operation.stages[NAME].lines.pipe.first_end.z.")),
      goal(SeekRelation::equals, "Target value of the result, with its unit."),
      goal(SeekRelation::at_most, "Upper limit of the result. A single key gets the minimum value that satisfies it."),
      goal(SeekRelation::at_least, "Lower limit of the result. A single key gets the minimum value that satisfies it."),
  };
}

}  // namespace

std::vector<Field> seek() {
  const Member one_key = opened_by<SeekDescription>(
      [](SeekDescription& seek, const FieldValue&) -> SeekVariable& { return seek.vary.emplace_back(); });
  const Member one_goal = opened_by<SeekDescription>(
      [](SeekDescription& seek, const FieldValue&) -> SeekCondition& { return seek.until.emplace_back(); });
  std::vector<Field> rows = {
      otherwise(group_row("seek", read_elsewhere(),  // read by modelfile/reading/seek_reader.h
                          "Goal seek: variables and conditions for `overbend seek`."),
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
      text_row("seek.minimise", fills(&SeekDescription::minimise), "Result to minimise within the conditions."),
      "not minimised"));
  return rows;
}

}  // namespace overbend::field_rows
