#include "modelfile/schema/field.h"

#include <cmath>
#include <map>

#include "base/text.h"
#include "base/units.h"

namespace overbend {
namespace {

std::string bound_label(const Field& field, double value) {
  if (!field.unit.empty()) return format_quantity(value, field.unit, field.show);
  return format_number(value);
}

/// Formats "1e-9", not "1e-09", as a user would write it.
std::string plain_number(double value) {
  std::string text = format_number(value);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  const std::size_t digits = exponent + (text[exponent + 1] == '-' || text[exponent + 1] == '+' ? 2 : 1);
  text.erase(digits, text.find_first_not_of('0', digits) - digits);
  return text;
}

std::string written(const Field& field, const Member::Default& standard) {
  if (const auto* text = std::get_if<std::string>(&standard)) return *text;
  if (const auto* integer = std::get_if<std::int64_t>(&standard)) return std::to_string(*integer);
  const double number = std::get<double>(standard);
  if (field.kind != FieldKind::quantity) return plain_number(number);
  return format_quantity(number, field.unit, field.show);
}

}  // namespace

void complete_from_member(Field& field) {
  if (field.member.standard) field.fallback = written(field, *field.member.standard);
  if (field.choices.empty()) field.choices = field.member.choice_names;
}

std::string field_range_label(const Field& field, const Range& range) {
  const bool low = std::isfinite(range.low), high = std::isfinite(range.high);
  if (!low && !high) return {};
  if (range.low == range.high) return "exactly " + bound_label(field, range.low);
  if (low && !high) return (range.low_open ? "above " : "at least ") + bound_label(field, range.low);
  if (!low) return (range.high_open ? "below " : "at most ") + bound_label(field, range.high);
  if (!range.low_open && !range.high_open) {
    return "from " + bound_label(field, range.low) + " to " + bound_label(field, range.high);
  }
  return (range.low_open ? "above " : "at least ") + bound_label(field, range.low) +
         (range.high_open ? " and below " : " and at most ") + bound_label(field, range.high);
}

std::string field_kind_label(const Field& field) {
  switch (field.kind) {
    case FieldKind::map:
      return "a group of keys";
    case FieldKind::list:
      return "a list";
    case FieldKind::quantity:
      return dimension_phrase(field.unit) + " with its unit";
    case FieldKind::number:
      return "a plain number";
    case FieldKind::integer:
      return "a whole number";
    case FieldKind::text:
      return "text";
    case FieldKind::choice:
      return join_choices(field.choices) +
             (field.unit.empty() ? "" : ", or " + dimension_phrase(field.unit) + " with its unit");
  }
  return {};
}

double max_sensible_value(const std::string& si_unit) {
  static const std::map<std::string, double> kMaxSensible = {
      {"m", 1e6},  {"rad", 1e3},  {"s", 1e9},      {"m/s", 1e3},   {"m/s^2", 1e4},
      {"N", 1e12}, {"N/m", 1e15}, {"N/m^2", 1e15}, {"N/m^3", 1e8}, {"N*s/m^2", 1e15},
  };
  const auto found = kMaxSensible.find(si_unit);
  return found != kMaxSensible.end() ? found->second : 1e15;
}

}  // namespace overbend
