#include "modelfile/schema/scalar_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/text.h"
#include "base/units.h"

namespace overbend {
namespace {

std::string shown(const YamlNode& node) {
  return "'" + for_display(node.text) + "'";
}

/// Closed bounds have a rounding tolerance, so that 90 deg is not above 90 deg. An absent bound is infinite; no value
/// is near it.
bool within(const Range& range, double value) {
  const auto close = [&](double bound) {
    return std::isfinite(bound) && std::abs(value - bound) <= 1e-12 * std::abs(bound);
  };
  if (close(range.low)) return !range.low_open;
  if (close(range.high)) return !range.high_open;
  return range.contains(value);
}

std::string expected_value(const Field& field) {
  const std::string range = field_range_label(field, field.range);
  return range.empty() ? field_kind_label(field) : field_kind_label(field) + ", " + range;
}

ScalarReading reject_value(std::string found, const Field& field, std::string hint = {}) {
  return {std::nullopt, std::move(found), expected_value(field), std::move(hint), {}};
}

FieldValue valued(FieldValue::Kind kind, const YamlNode& node) {
  FieldValue value;
  value.kind = kind;
  value.shown = shown(node);
  return value;
}

/// Returns the max. accepted number of a field; integers are exact up to 2^53.
double max_value(const Field& field) {
  if (field.kind == FieldKind::quantity && !std::isfinite(field.range.high)) return max_sensible_value(field.unit);
  if (field.kind == FieldKind::quantity) return std::max(max_sensible_value(field.unit), std::abs(field.range.high));
  return field.kind == FieldKind::integer ? 9e15 : 1e15;
}

ScalarReading accept_number(double number, FieldValue value, const Field& field) {
  const double limit = max_value(field);
  if (!within(field.range, number)) return reject_value(value.shown, field);
  if (!(std::abs(number) <= limit)) return reject_value(value.shown + ", which exceeds any sensible value", field);
  value.number = number;
  ScalarReading reading{std::move(value), {}, {}, {}, {}};
  if (!within(field.usual, number)) reading.unusual = field_range_label(field, field.usual);
  return reading;
}

std::string bare_number_hint(const std::string& number, const Field& field) {
  const std::string written = "write it as '" + number + " " + field.show + "'";
  return field.unit != "1" ? written + " or in another unit" : written + ", or a fraction given in per cent";
}

ScalarReading read_quantity(const YamlNode& node, const Field& field) {
  const QuantityReading quantity = parse_quantity(trim(for_display(node.text, 200)), field.unit);
  if (!quantity.value) {
    const bool bare = parse_number(trim(node.text)).has_value();
    return reject_value(quantity.found, field,
                        bare ? bare_number_hint(std::string(trim(node.text)), field) : quantity.hint);
  }
  ScalarReading reading = accept_number(*quantity.value, valued(FieldValue::Kind::number, node), field);
  reading.remark = quantity.remark;
  return reading;
}

/// Parses a fraction as written in results, "0.5 %".
std::optional<double> parse_percent(std::string_view text) {
  if (!text.ends_with('%')) return std::nullopt;
  const std::optional<double> number = parse_number(trim(text.substr(0, text.size() - 1)));
  return number ? std::optional(1e-2 * *number) : std::nullopt;
}

std::string number_hint(const std::string& text) {
  const bool digit = !text.empty() && text[0] >= '0' && text[0] <= '9';
  if (digit && text.find(',') != std::string::npos) return "the decimal sign is a point";
  if (text.size() > 1 && text[0] == '0' && digit && text[1] != '.') return "write it without a leading zero";
  if (digit && text.find_first_not_of("0123456789.eE+-") != std::string::npos) return "it takes no unit";
  return {};
}

/// Explains NaN and infinity in YAML's own spelling.
std::string number_found(const YamlNode& node) {
  const std::string lower = lower_case(node.text);
  if (lower.find(".nan") != std::string::npos || lower.find(".inf") != std::string::npos) {
    return shown(node) + ", which is not a finite number";
  }
  return node.quoted ? shown(node) + ", a text in quotes" : shown(node);
}

ScalarReading read_number(const YamlNode& node, const Field& field) {
  std::optional<double> number = node.quoted ? std::nullopt : parse_number(node.text);
  if (!number) number = parse_percent(trim(node.text));
  if (!number) {
    return reject_value(number_found(node), field, node.quoted ? "leave out the quotes" : number_hint(node.text));
  }
  return accept_number(*number, valued(FieldValue::Kind::number, node), field);
}

ScalarReading read_integer(const YamlNode& node, const Field& field) {
  const std::optional<double> number = node.quoted ? std::nullopt : parse_number(node.text);
  if (!number) {
    return reject_value(number_found(node), field, node.quoted ? "leave out the quotes" : number_hint(node.text));
  }
  std::int64_t integer = 0;
  const std::size_t skip = node.text.front() == '+' ? 1 : 0;
  const char* end = node.text.data() + node.text.size();
  const auto [stop, code] = std::from_chars(node.text.data() + skip, end, integer);
  if (code != std::errc() || stop != end) return reject_value(shown(node), field);
  ScalarReading reading = accept_number(*number, valued(FieldValue::Kind::integer, node), field);
  if (reading.value) reading.value->integer = integer;
  return reading;
}

ScalarReading read_text(const YamlNode& node, const Field& field) {
  constexpr std::size_t kMaxTextLength = 500;
  const bool control = std::any_of(node.text.begin(), node.text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
  });
  if (trim(node.text).empty()) return reject_value("an empty text", field);
  if (control || node.text.size() > kMaxTextLength) {
    return reject_value(shown(node), field, "one line of at most 500 characters");
  }
  FieldValue value = valued(FieldValue::Kind::text, node);
  value.text = node.text;
  return {std::move(value), {}, {}, {}, {}};
}

ScalarReading read_choice(const YamlNode& node, const Field& field) {
  if (std::find(field.choices.begin(), field.choices.end(), node.text) == field.choices.end()) {
    const std::string text(trim(node.text));
    const bool number = !text.empty() && text.find_first_of("0123456789") != std::string::npos;
    if (!field.unit.empty() && number) return read_quantity(node, field);
    const std::string near = nearest_word(node.text, field.choices);
    return reject_value(shown(node), field, near.empty() ? "" : "did you mean '" + near + "'?");
  }
  FieldValue value = valued(FieldValue::Kind::text, node);
  value.text = node.text;
  return {std::move(value), {}, {}, {}, {}};
}

}  // namespace

ScalarReading read_scalar(const YamlNode& node, const Field& field) {
  switch (field.kind) {
    case FieldKind::quantity:
      return read_quantity(node, field);
    case FieldKind::number:
      return read_number(node, field);
    case FieldKind::integer:
      return read_integer(node, field);
    case FieldKind::choice:
      return read_choice(node, field);
    case FieldKind::text:
    case FieldKind::map:
    case FieldKind::list:
      break;
  }
  return read_text(node, field);
}

}  // namespace overbend
