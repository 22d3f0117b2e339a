#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "model/description/study_enum_names.h"
#include "modelfile/fields/seek_values.h"
#include "modelfile/study_file/study_axes.h"

namespace overbend {
namespace {

/// Parameter of a distribution and the check of its values.
struct Parameter {
  const char* key;
  double SampledKey::*member;
  enum class Holds { value, width } holds;  ///< Range of the key itself, or a positive number.
};

constexpr std::array<Parameter, 6> kParameters = {{
    {"from", &SampledKey::from, Parameter::Holds::value},
    {"to", &SampledKey::to, Parameter::Holds::value},
    {"mode", &SampledKey::mode, Parameter::Holds::value},
    {"mean", &SampledKey::mean, Parameter::Holds::value},
    {"std", &SampledKey::std, Parameter::Holds::width},
    {"scale", &SampledKey::scale, Parameter::Holds::width},
}};

enum class Use { none, may, must };

Use find_use(Distribution of, std::string_view key) {
  const bool bound = key == "from" || key == "to";
  switch (of) {
    case Distribution::uniform:
      return bound ? Use::must : Use::none;
    case Distribution::triangular:
      return bound || key == "mode" ? Use::must : Use::none;
    case Distribution::normal:
    case Distribution::lognormal:
      return key == "mean" || key == "std" ? Use::must : bound ? Use::may : Use::none;
    case Distribution::weibull:
      return key == "scale" || key == "shape" ? Use::must : bound ? Use::may : Use::none;
  }
  return Use::none;
}

class SampleReader {
 public:
  SampleReader(Checker& check, const FieldValue& item, const Field& row) : check_(check), item_(item), row_(row) {}

  SampledKey read() {
    SampledKey key;
    key.key = item_.key;
    key.line = item_.line;
    key.unit = row_unit(row_);
    key.show = row_.kind == FieldKind::quantity ? row_.show : "";
    key.distribution = item_.get_word<Distribution>("distribution").value_or(Distribution::uniform);
    key.from = -std::numeric_limits<double>::infinity();
    key.to = std::numeric_limits<double>::infinity();
    for (const Parameter& parameter : kParameters) take(parameter, key);
    if (wanted(key.distribution, "shape")) key.shape = item_.get_number("shape").value_or(0.0);
    key.bounded = std::isfinite(key.from) || std::isfinite(key.to);
    check_order(key);
    return key;
  }

 private:
  /// Reports missing parameters and those that the distribution does not have.
  bool wanted(Distribution of, const char* name) {
    const Use use = find_use(of, name);
    const FieldValue* value = item_.find(name);
    if (use == Use::must && !item_.mentions(name)) {
      check_.missing(item_, name, fmt::format("a parameter of a {} distribution", enum_name(of)));
    }
    if (use == Use::none && value != nullptr) {
      check_.error(*value, value->shown, fmt::format("no such parameter of a {} distribution", enum_name(of)));
    }
    return use != Use::none && value != nullptr;
  }

  void take(const Parameter& parameter, SampledKey& key) {
    if (!wanted(key.distribution, parameter.key)) return;
    Field row = row_;
    if (parameter.holds == Parameter::Holds::width) row.range = {.low = 0.0, .low_open = true};
    if (const auto value = checked_number(check_, *item_.find(parameter.key), row)) key.*parameter.member = *value;
  }

  void check_order(const SampledKey& key) {
    const FieldValue *to = item_.find("to"), *mode = item_.find("mode"), *mean = item_.find("mean");
    if (to != nullptr && !(key.from < key.to)) check_.error(*to, to->shown, "more than the lower bound");
    if (key.distribution == Distribution::triangular && mode != nullptr && to != nullptr &&
        !(key.from <= key.mode && key.mode <= key.to)) {
      check_.error(*mode, mode->shown, "a value between from and to");
    }
    if (key.distribution == Distribution::lognormal && mean != nullptr && !(key.mean > 0.0)) {
      check_.error(*mean, mean->shown, "a mean above zero");
    }
  }

  Checker& check_;
  const FieldValue& item_;
  const Field& row_;
};

}  // namespace

std::optional<StudySample> read_sample(Checker& check, StudyKeys& keys) {
  const FieldValue* group = check.root().find("sample");
  if (group == nullptr) return std::nullopt;
  StudySample sample;
  sample.count = static_cast<int>(group->get_integer("count").value_or(0));
  sample.seed = static_cast<std::uint64_t>(group->get_integer("seed").value_or(1));
  const FieldValue* drawn = group->find("keys");
  if (drawn == nullptr) return sample;
  for (const FieldValue& item : drawn->children) {
    const Field* row = keys.take(check, item, item.key);
    if (row == nullptr) continue;
    if (row->kind != FieldKind::quantity && row->kind != FieldKind::number) {
      check.error(item, "'" + item.key + "'", "a key with a quantity or a number, to be drawn at random");
      continue;
    }
    sample.keys.push_back(SampleReader(check, item, *row).read());
  }
  if (drawn->children.empty()) check.error(*drawn, "an empty group", "at least one key to draw");
  return sample;
}

}  // namespace overbend
