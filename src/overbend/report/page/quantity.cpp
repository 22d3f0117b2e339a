#include "report/page/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "report/page/history_name.h"

namespace overbend {
namespace {

void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t position = text.find(from);
  if (position != std::string::npos) text.replace(position, from.size(), to);
}

ShownUnit in_use(const ShownUnit& metric, const ShownUnit& us) {
  return units_in_use() == UnitSystem::us ? us : metric;
}

std::string readable_name(const std::string& name) {
  const std::size_t open = name.find('/');
  const std::size_t close = name.rfind('/');
  if (open != std::string::npos && close > open) {  // type/object/quantity; the object's name is the user's
    return readable_name(name.substr(close + 1)) + ", " + name.substr(open + 1, close - open - 1);
  }
  constexpr const char* kTensioner = "tensioner/";
  if (name.rfind(kTensioner, 0) == 0) {
    return readable_name(name.substr(std::string(kTensioner).size())) + " of the tensioner";
  }
  std::string text = history_quantity(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  if (text == "elevation") text = "wave elevation";
  if (text == "lay back") text = "lay-back";
  if (text == "first tension") text = "tension at the first end";
  if (text == "second tension") text = "tension at the second end";
  if (text.rfind("von mises", 0) != 0 && !text.empty()) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  }
  replace(text, "von mises", "von Mises stress");
  return text;
}

}  // namespace

std::string Quantity::text(double si, int decimals) const {
  return fixed(shown(si), std::max(0, decimals + more));
}

Quantity quantity(const std::string& name, const std::string& units) {
  const ShownUnit unit = shown_unit(history_quantity(name), units);
  constexpr int kPlain = 4;  // decimals of plain numbers, mostly shares
  const int digits = unit.name.empty() ? std::min(unit.digits, kPlain) : unit.digits;
  return {readable_name(name), std::string(unit.name), unit.factor, digits, unit.more};
}

Quantity clearances() {
  const ShownUnit unit = section_length();
  return {"clearance", std::string(unit.name), unit.factor, unit.digits, unit.more};
}

ShownUnit line_weight() {
  return in_use({"N/m", "N/m", 1.0, 1}, {"N/m", "lbf/ft", shown_unit("N/m").factor, 2, 1});
}

ShownUnit impulse() {
  return in_use({"N s", "N s", 1.0, 1}, {"N s", "lbf s", 1e3 * shown_unit("N s").factor, 2, 1});
}

ShownUnit rope_stiffness() {
  return in_use({"N", "MN", 1e-6, 1}, {"N", "kip", shown_unit("N").factor, 0, -1});
}

ShownUnit steel_area() {
  return in_use({"m2", "mm2", 1e6, 1}, {"m2", "in2", std::pow(section_length().factor, 2), 4, 3});
}

ShownUnit steel_inertia() {
  return in_use({"m4", "cm4", 1e8, 1}, {"m4", "in4", std::pow(section_length().factor, 4), 3, 2});
}

std::string unit_of_key(const std::string& si, const std::string& metric) {
  if (metric.empty() || units_in_use() == UnitSystem::metric) return metric;
  if (metric == "mm") return std::string(section_length().name);
  std::string spelled = si == "N/m^2" ? "Pa" : si;
  std::replace(spelled.begin(), spelled.end(), '*', ' ');
  std::erase(spelled, '^');
  const std::span<const ShownUnit> all = shown_units(UnitSystem::us);
  const auto known = std::find_if(all.begin(), all.end(), [&](const ShownUnit& unit) { return unit.si == spelled; });
  return known != all.end() ? std::string(known->name) : metric;
}

std::string name_with_unit(const std::string& name, std::string_view si) {
  return name + " [" + shown_name(si) + "]";
}

std::string readable_duration(double seconds) {
  if (seconds >= 7200.0) return fmt::format("{:.4g} h", seconds / 3600.0);
  if (seconds >= 300.0) return fmt::format("{:.4g} min", seconds / 60.0);
  return fmt::format("{:.4g} s", seconds);
}

}  // namespace overbend
