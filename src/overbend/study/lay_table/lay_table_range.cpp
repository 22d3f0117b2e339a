#include "study/lay_table/lay_table_range.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/text.h"
#include "base/units.h"

namespace overbend {
namespace {

constexpr double kMaxSteps = 1000.0;

/// Returns the unit after the number.
std::string unit_text(const std::string& text) {
  const std::size_t letter = text.find_first_not_of("0123456789.+- \t");
  return letter == std::string::npos ? "" : text.substr(letter);
}

double parse_limit(const std::string& text, const std::string& si) {
  const QuantityReading reading = parse_quantity(text, si);
  if (!reading.value) throw std::invalid_argument(reading.found + " is not " + dimension_phrase(si) + " with its unit");
  if (*reading.value <= 0.0) throw std::invalid_argument("'" + text + "' is not more than 0");
  return *reading.value;
}

}  // namespace

void take_range(LayTableVary vary, const std::string& range, LayTableDescription& table) {
  const std::size_t dots = range.find(".."), slash = range.rfind('/');
  if (dots == std::string::npos) {
    throw std::invalid_argument("'" + for_display(range) + "' is not a range such as '200 kN..400 kN/20'");
  }
  const bool counted = slash != std::string::npos && slash > dots &&
                       range.find_first_not_of(" 0123456789", slash + 1) == std::string::npos;
  if (counted) {
    const std::optional<double> steps = parse_number(trim(range.substr(slash + 1)));
    if (!steps || *steps < 1.0 || *steps > kMaxSteps) {
      throw std::invalid_argument("steps must be a number from 1 to 1000");
    }
    table.steps = static_cast<int>(std::lround(*steps));
  }
  const std::string si = vary == LayTableVary::tension ? "N" : "m";
  const std::size_t end = counted ? slash : range.size();
  std::string from(trim(std::string_view(range).substr(0, dots)));
  const std::string to(trim(std::string_view(range).substr(dots + 2, end - dots - 2)));
  if (unit_text(from).empty()) from += " " + unit_text(to);
  table.vary = vary;
  table.from = parse_limit(from, si);
  table.to = parse_limit(to, si);
  if (*table.from == *table.to) throw std::invalid_argument("the range ends where it begins");
  table.profile.clear();
}

}  // namespace overbend
