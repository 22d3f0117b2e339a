#include "modelfile/study_file/study_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>

#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "model/description/seek_operations.h"
#include "model/description/study_enum_names.h"
#include "modelfile/binding/binding.h"
#include "modelfile/fields/seek_values.h"
#include "modelfile/reading/seek_reader.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/study_file/study_axes.h"
#include "modelfile/study_file/study_rows.h"
#include "resultfiles/summary/study_outputs.h"
#include "seafiles/scatter_reader.h"

namespace overbend {
namespace {

class StudyBinder {
 public:
  StudyBinder(const FieldValue& root, const std::string& file, const Description& base, const YamlNode& model,
              Diagnostics& diagnostics)
      : check_(root, file, diagnostics), diagnostics_(diagnostics), root_(root), base_(base), keys_(model) {
    study_.file = file;
  }

  StudyDescription bind() {
    study_.title = root_.get_text("title").value_or(base_.title);
    study_.base = base_.source_file;
    study_.analysis = root_.get_word<StudyAnalysis>("analysis").value_or(StudyAnalysis::statics);
    if (study_.analysis == StudyAnalysis::statics && is_seek_over_stages(base_.operation.type)) {
      study_.analysis = StudyAnalysis::operation;  // static results of a lift or a pull are those of its stages
    }
    study_.keep = root_.get_text("keep") == "true";
    study_.axes = read_axes(check_, keys_);
    study_.sample = read_sample(check_, keys_);
    study_.duration = root_.get_number("duration");
    bind_seeds();
    bind_gather();
    bind_operability();
    check_analysis();
    check_count();
    return std::move(study_);
  }

 private:
  void bind_seeds() {
    const FieldValue* seeds = root_.find("seeds");
    if (seeds == nullptr) return;
    if (study_.analysis != StudyAnalysis::dynamic) {
      check_.error(*seeds, "seeds of waves", "analysis: dynamic", "static analysis has no waves");
      return;
    }
    if (seeds->kind == FieldValue::Kind::integer) {
      study_.seeds.resize(static_cast<std::size_t>(seeds->integer));
      std::iota(study_.seeds.begin(), study_.seeds.end(), std::uint64_t{1});
      return;
    }
    for (const FieldValue& seed : seeds->children) {
      const auto value = static_cast<std::uint64_t>(seed.integer);
      if (ranges::find(study_.seeds, value) != study_.seeds.end()) {
        check_.error(seed, seed.shown + ", which is given twice", "each seed once");
      }
      study_.seeds.push_back(value);
    }
  }

  void bind_gather() {
    const std::optional<SeekDescription> seek = read_seek(base_);
    for (const FieldValue& name : Checker::items(root_, "gather")) {
      if (!study_output(study_.analysis, name.text, seek)) {
        check_.error(
            name, name.shown,
            fmt::format("a number in summary.json of a {} analysis, or checks.governing", enum_name(study_.analysis)),
            gather_hint(name.text));
      } else if (ranges::find(study_.gather, name.text) != study_.gather.end()) {
        check_.error(name, name.shown + ", which is given twice", "each result once");
      }
      study_.gather.push_back(name.text);
    }
  }

  std::string gather_hint(const std::string& name) const {
    if (study_.analysis == StudyAnalysis::seek && name == "seek.slope") {
      return "a slope is defined for a single key only";
    }
    const std::string near = nearest_output(study_.analysis, name);
    return near.empty() ? "paths are those of summary.json, such as static.sagbend.max_bending_stress"
                        : "did you mean '" + near + "'?";
  }

  void bind_operability() {
    const FieldValue* group = root_.find("operability");
    if (group == nullptr || !group->given) return;
    OperabilityDescription& wanted = study_.operability.emplace();
    if (const FieldValue* over = group->find("over")) wanted.over = over->text;
    const auto axis = ranges::find(study_.axes, wanted.over, &StudyAxis::key);
    const Field* row = varied_row(wanted.over);
    if (axis == study_.axes.end() || row == nullptr || !axis->with.empty()) {
      const FieldValue& value = group->find("over") != nullptr ? *group->find("over") : *group;
      check_.error(value, "'" + wanted.over + "'",
                   "the key of an axis with quantities or numbers that is not `with` another");
    } else {
      if (study_.sample) check_.error(*group, "a sample", "axes alone", "limits are found over a grid");
      for (const StudyAxis& partner : study_.axes) {
        if (partner.with == wanted.over) {
          check_.error(*group, partner.key + " with " + wanted.over, "crossed axes");
        }
      }
      if (axis->values.size() == 1) check_.error(*group, "one value of " + axis->key, "a minimum and a maximum value");
      bind_resolution(*group, *row, *axis, wanted);
    }
    for (const FieldValue& condition : Checker::items(*group, "criterion")) bind_condition(condition, wanted);
    bind_scatter(*group, wanted);
    wanted.alpha = group->get_number("alpha");
  }

  void bind_scatter(const FieldValue& group, OperabilityDescription& wanted) {
    const auto scatter = group.get_text("scatter");
    if (!scatter) return;
    wanted.scatter_file = resolved_file(*scatter, study_.file);
    const std::vector<WavesDescription>& waves = base_.environment.waves;  // a diagram is of one group
    wanted.scatter =
        read_scatter(wanted.scatter_file, diagnostics_,
                     {group.get_word<ScatterPeriod>("scatter_period"), waves.size() == 1 ? &waves.front() : nullptr});
  }

  /// Default resolution: 0.25 m for lengths, such as wave heights, otherwise a hundredth of the range.
  void bind_resolution(const FieldValue& group, Field row, const StudyAxis& axis, OperabilityDescription& wanted) {
    if (const FieldValue* resolution = group.find("resolution")) {
      row.range = {.low = 0.0, .low_open = true};
      if (const auto value = checked_number(check_, *resolution, row)) wanted.resolution = *value;
    } else if (row.unit != "m") {
      std::vector<double> values;
      for (const std::string& text : axis.values) {
        if (const ScalarReading reading = read_row_value(text, row); reading.value) {
          values.push_back(reading.value->number);
        }
      }
      if (values.size() > 1) wanted.resolution = 0.01 * (ranges::max(values) - ranges::min(values));
    }
  }

  /// A list of conditions replaces the checks, unless it contains them.
  void bind_condition(const FieldValue& item, OperabilityDescription& wanted) {
    if (&item == &Checker::items(*root_.find("operability"), "criterion").front()) wanted.checks = false;
    if (item.kind != FieldValue::Kind::map) {
      wanted.checks = true;
      return;
    }
    const FieldValue *upper = item.find("at_most"), *lower = item.find("at_least"), *result = item.find("result");
    if (result == nullptr) return;
    const auto output = study_output(study_.analysis, result->text, read_seek(base_));
    if (!output || output->text) {
      check_.error(*result, result->shown, "a number in summary.json of this analysis",
                   nearest_output(study_.analysis, result->text));
      return;
    }
    if ((upper == nullptr) == (lower == nullptr)) {
      check_.error(item, upper != nullptr ? "two limits" : "no limit", "either at_most or at_least");
      return;
    }
    Field row;
    row.kind = output->unit == "1" ? FieldKind::number : FieldKind::quantity;
    row.unit = output->unit;
    row.show = usual_units(output->unit).empty() ? "" : usual_units(output->unit).front();
    const FieldValue& limit = upper != nullptr ? *upper : *lower;
    if (const auto value = checked_number(check_, limit, row)) {
      wanted.criterion.push_back(
          {result->text, output->unit, upper != nullptr ? SeekRelation::at_most : SeekRelation::at_least, *value});
    }
  }

  void check_analysis() {
    const FieldValue& value = root_.find("analysis") != nullptr ? *root_.find("analysis") : root_;
    if (study_.analysis == StudyAnalysis::dynamic && !base_.dynamics && !study_.duration) {
      check_.error(value, "'dynamic'", "a base model with analysis.dynamic, or the key duration");
    }
    if (study_.analysis == StudyAnalysis::operation && !is_lay_operation(base_.operation.type)) {
      check_.error(value, "'operation'", "a base model with an operation on the line");
    }
    if (study_.analysis == StudyAnalysis::seek && !read_seek(base_)) {
      check_.error(value, "'seek'", "a base model with the key seek");
    }
    if (const FieldValue* duration = root_.find("duration");
        duration != nullptr && duration->given && study_.analysis != StudyAnalysis::dynamic) {
      check_.error(*duration, duration->shown, "analysis: dynamic");
    }
    if (study_.axes.empty() && !study_.sample && study_.seeds.empty()) {
      check_.missing(root_, "axes", "axes, a sample or seeds");
    }
  }

  /// Reports an excessive number of cases with its factors.
  void check_count() {
    double count = 1.0;
    std::string product;
    const auto times = [&](std::size_t factor) {
      count *= static_cast<double>(factor);
      product += (product.empty() ? "" : " x ") + std::to_string(factor);
    };
    for (const StudyAxis& axis : study_.axes) {
      if (axis.with.empty() && !axis.values.empty()) times(axis.values.size());
    }
    if (study_.sample) times(static_cast<std::size_t>(study_.sample->count));
    if (!study_.seeds.empty()) times(study_.seeds.size());
    if (count <= kMaxStudyCases) return;
    const FieldValue& value = root_.find("axes") != nullptr ? *root_.find("axes") : root_;
    check_.error(value, fmt::format("{} = {:.0f} cases", product, count),
                 fmt::format("at most {:.0f}", kMaxStudyCases));
  }

  Checker check_;
  Diagnostics& diagnostics_;
  const FieldValue& root_;
  const Description& base_;
  StudyKeys keys_;
  StudyDescription study_;
};

void copy_errors(const Diagnostics& from, Diagnostics& to) {
  for (const Diagnostic& diagnostic : from.sorted()) {
    if (diagnostic.severity == Severity::error) to.add(diagnostic);
  }
}

}  // namespace

namespace {

/// Returns the keys of a study file; empty if the text is not YAML of that kind.
std::optional<FieldValue> study_keys(const std::string& text, const std::string& path, Diagnostics& diagnostics) {
  const std::optional<YamlNode> root = parse_yaml(text, path, diagnostics);
  if (root && root->kind == YamlNode::Kind::map) return read_fields(*root, study_tree(), path, diagnostics);
  if (!diagnostics.has_errors()) {
    diagnostics.add(
        {Severity::error, path, 0, 0, "", "a text that is not a study file", "keys such as 'overbend_study: 1'", ""});
  }
  return std::nullopt;
}

void bind_study(const FieldValue& values, const std::string& text, const std::string& path, Description&& base,
                StudyReading& reading) {
  Diagnostics none;  // not reported: the text was read before without errors
  const std::optional<YamlNode> tree = parse_yaml(base.source_text, base.source_file, none);
  StudyDescription study = StudyBinder(values, path, base, *tree, reading.diagnostics).bind();
  if (reading.diagnostics.has_errors()) return;
  study.text = text;
  reading.study = std::move(study);
  reading.base = std::move(base);
}

}  // namespace

StudyReading read_study_text(const std::string& text, const std::string& path) {
  StudyReading reading;
  const std::optional<FieldValue> values = study_keys(text, path, reading.diagnostics);
  const std::optional<std::string> base = values ? values->get_text("base") : std::nullopt;
  if (!base) return reading;
  ModelReading model = read_model(resolved_file(*base, path));
  if (model.description) {
    bind_study(*values, text, path, std::move(*model.description), reading);
  } else {
    copy_errors(model.diagnostics, reading.diagnostics);
  }
  return reading;
}

StudyReading read_study_with_base(const std::string& text, const std::string& path, Description base) {
  StudyReading reading;
  if (const std::optional<FieldValue> values = study_keys(text, path, reading.diagnostics)) {
    bind_study(*values, text, path, std::move(base), reading);
  }
  return reading;
}

StudyReading read_study_file(const std::string& path) {
  StudyReading reading;
  std::error_code code;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, code)) {
    const char* why = !std::filesystem::exists(path, code)        ? "there is no such file"
                      : std::filesystem::is_directory(path, code) ? "this is a folder, not a study file"
                                                                  : "the file cannot be read";
    reading.diagnostics.add({Severity::error, path, 0, 0, "", why, "", ""});
    return reading;
  }
  return read_study_text({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}, path);
}

}  // namespace overbend
