#include "modelfile/study_file/study_rows.h"

#include "base/enum_names.h"
#include "model/description/study_enum_names.h"
#include "modelfile/fields/row_makers.h"
#include "modelfile/schema/make_field_tree.h"

namespace overbend {
namespace {

using namespace field_rows;

Field text_row(std::string path, std::string text, std::string fallback_text = "") {
  return otherwise(row_of_kind(FieldKind::text, std::move(path), read_elsewhere(), std::move(text)),
                   std::move(fallback_text));
}

Field word_row(std::string path, std::vector<std::string> names, std::string fallback, std::string text) {
  Field row = row_of_kind(FieldKind::choice, std::move(path), read_elsewhere(), std::move(text));
  row.choices = std::move(names);
  row.fallback = std::move(fallback);
  return row;
}

Field count_row(std::string path, std::string text, Range range) {
  return row_of_kind(FieldKind::integer, std::move(path), read_elsewhere(), std::move(text), range);
}

Field group(std::string path, std::string text) {
  return group_row(std::move(path), read_elsewhere(), std::move(text));
}

Field list(std::string path, std::string text, std::string fallback_text, int min_items = 1) {
  Field row = list_row(std::move(path), read_elsewhere(), std::move(text), std::move(fallback_text));
  row.min_items = min_items;
  return row;
}

std::vector<Field> head() {
  Field base = required(text_row("base", "Model file that the cases are made from, in the folder of the study file."));
  base.file = true;
  return {
      required(count_row("overbend_study", "Version of the study file's format.", {.low = 1, .high = 1})),
      text_row("title", "Title of tables and report.", "that of the model"),
      std::move(base),
      word_row("analysis", enum_names<StudyAnalysis>(), "static",
               "Analysis of each case: static, dynamic, every stage of the operation, or the goal seek."),
      otherwise(quantity_row("duration", read_elsewhere(), "Simulated time of dynamic analyses.", kTime,
                             {.low = kMinDuration, .high = kMaxDuration}),
                "that of the model"),
      word_row("keep", {"true", "false"}, "false", "Keeps all result files of each case, not only its record."),
  };
}

std::vector<Field> axes() {
  return {
      list("axes", "Keys and their values. Each value of one is combined with each value of the others.", "none"),
      group("axes[]", "A key and its values."),
      required(text_row("axes[].key",
                        "Key of the model file with a single value. An item of a list is selected by its index from 0, "
                        "its name or a pattern: supports.stinger.boxes[stinger 3].z.")),
      list("axes[].values", "List of values.", "from and to are given"),
      text_row("axes[].values[]", "A value as written in a model file."),
      text_row("axes[].from", "First value of a range, with the unit of the key.", "values are given"),
      text_row("axes[].to", "Last value of the range.", "values are given"),
      text_row("axes[].step", "Difference between successive values.", "steps is given"),
      otherwise(count_row("axes[].steps", "Number of values of the range, both ends included.",
                          {.low = 2, .high = kMaxStudyCases}),
                "step is given"),
      text_row("axes[].with", "Key of the axis that this one varies together with, value by value.", "crossed"),
  };
}

std::vector<Field> sample() {
  const std::string k = "sample.keys.*";
  const auto number = [&](const char* key, const char* text) { return text_row(k + key, text, "see distribution"); };
  Field seed = count_row("sample.seed", "Seed of the random draws.", {.low = 0});
  seed.fallback = "1";
  return {
      otherwise(group("sample",
                      "Keys drawn at random by a Latin hypercube. With axes, each draw is combined with each "
                      "combination of their values."),
                "none"),
      required(count_row("sample.count", "Number of draws.", {.low = 1, .high = kMaxStudyCases})),
      std::move(seed),
      required(group("sample.keys", "Keys of the model file with their distributions.")),
      group(k, "A key with its distribution."),
      word_row(k + ".distribution", enum_names<Distribution>(), "uniform",
               "uniform and triangular need from and to, the latter also mode; normal and lognormal need mean and std; "
               "weibull needs scale and shape."),
      number(".from", "Minimum value; for normal, lognormal and weibull a lower truncation bound."),
      number(".to", "Maximum value; for normal, lognormal and weibull an upper truncation bound."),
      number(".mode", "Most probable value of the triangular distribution."),
      number(".mean", "Mean of the normal or lognormal distribution."),
      number(".std", "Standard deviation of the normal or lognormal distribution, of the key itself."),
      number(".scale", "Scale of the Weibull distribution."),
      row_of_kind(FieldKind::number, k + ".shape", read_elsewhere(), "Shape of the Weibull distribution.", kPositive),
  };
}

std::vector<Field> seeds_and_results() {
  const Range seed = {.low = 0};
  return {
      otherwise(count_row("seeds", "Number of seeds of the waves: 1, 2, ... up to this; or a list of seeds.",
                          {.low = 1, .high = 1000}),
                "the model's first seed"),
      list("seeds", "Seeds of the waves: each case is run with each seed.", "the model's first seed"),
      count_row("seeds[]", "A seed.", seed),
      list("gather", "Results that become columns of the table.", "default set of the analysis"),
      text_row("gather[]",
               "Result by its path in summary.json, such as static.sagbend.max_bending_stress, dynamic.top_tension.max "
               "or checks.governing; min(), max(), mean() and spread() of a path with a pattern."),
  };
}

std::vector<Field> condition(const std::string& p) {
  return {
      required(text_row(p + ".result", "Result by its path in summary.json.")),
      text_row(p + ".at_most", "Upper limit, with its unit.", "no upper limit"),
      text_row(p + ".at_least", "Lower limit, with its unit.", "no lower limit"),
  };
}

std::vector<Field> operability() {
  const std::string p = "operability";
  std::vector<Field> rows = {
      otherwise(group(p, "Finds the maximum value of one axis that satisfies a criterion."), "no search"),
      text_row(p + ".over", "Key of the axis; its minimum and maximum values are the bounds.", "environment.waves.hs"),
      text_row(p + ".resolution", "Resolution of the limit, with the unit of the key.",
               "0.25 m for lengths, otherwise a hundredth of the range"),
      word_row(p + ".criterion", {"checks"}, "", "Pass of every governing check; or a list of conditions."),
      list(p + ".criterion", "Conditions on results, all of which must hold.", "checks"),
      word_row(p + ".criterion[]", {"checks"}, "", "Pass of every governing check."),
      group(p + ".criterion[]", "A condition."),
  };
  append(rows, condition(p + ".criterion[]"));
  Field scatter = text_row(p + ".scatter", "Scatter diagram of the sea (a table), for workability.", "none");
  scatter.file = true;
  rows.push_back(std::move(scatter));
  rows.push_back(otherwise(
      word_row(p + ".scatter_period", enum_names<ScatterPeriod>(), "",
               "Periods of the scatter diagram: tp, or tz, which becomes Tp by the spectrum of the base model."),
      "as its header states"));
  rows.push_back(otherwise(
      row_of_kind(FieldKind::number, p + ".alpha", read_elsewhere(),
                  "alpha factor of DNV-ST-N001 applied to the limit.", {.low = 0.0, .high = 1.0, .low_open = true}),
      "none"));
  return rows;
}

}  // namespace

const std::vector<Field>& study_table() {
  static const std::vector<Field> kTable = [] {
    std::vector<Field> table;
    for (const auto part : {head, axes, sample, seeds_and_results, operability}) append(table, part());
    return table;
  }();
  return kTable;
}

const FieldNode& study_tree() {
  static const FieldNode kTree = [] {
    static const Field kRoot{.path = "", .kind = FieldKind::map, .text = "The study file."};
    return make_field_tree(study_table(), kRoot);
  }();
  return kTree;
}

}  // namespace overbend
