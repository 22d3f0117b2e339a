#include "report/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>

#include "report/html.h"

namespace overbend {
namespace {

struct Unit {
  const char *si, *shown;
  double factor;
  int digits;
};

constexpr std::array<Unit, 8> kUnits = {{{"N", "kN", 1e-3, 1},
                                         {"Pa", "MPa", 1e-6, 1},
                                         {"rad", "deg", 180.0 / std::numbers::pi, 2},
                                         {"N m", "kN m", 1e-3, 1},
                                         {"N*m", "kN m", 1e-3, 1},
                                         {"s", "s", 1.0, 4},
                                         {"1", "", 1.0, 6},
                                         {"-", "", 1.0, 6}}};

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at != std::string::npos) text.replace(at, from.size(), to);
}

/// The peak since the row before is the quantity itself, seen without gaps.
std::string base_name(const std::string& name) {
  constexpr const char* kPeak = "_peak";
  return ends_with(name, kPeak) ? name.substr(0, name.size() - std::string(kPeak).size()) : name;
}

std::string words(const std::string& name) {
  const std::size_t open = name.find('/');
  const std::size_t close = name.rfind('/');
  if (open != std::string::npos && close > open) {  // kind/whose/what; whose name is the user's
    return words(name.substr(close + 1)) + ", " + name.substr(open + 1, close - open - 1);
  }
  constexpr const char* kTensioner = "tensioner/";
  if (name.rfind(kTensioner, 0) == 0) {
    return words(name.substr(std::string(kTensioner).size())) + " of the tensioner";
  }
  std::string text = base_name(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  if (text == "elevation") text = "wave elevation";
  if (text == "lay back") text = "lay-back";
  if (text.rfind("von mises", 0) != 0 && !text.empty()) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  }
  replace(text, "von mises", "von Mises stress");
  return text;
}

}  // namespace

std::string Quantity::text(double si) const {
  return html::fixed(shown(si), digits);
}

Quantity quantity(const std::string& name, const std::string& units) {
  Quantity q{words(name), units, 1.0, 3};
  if (base_name(name).find("strain") != std::string::npos) {
    q.unit = "%";
    q.factor = 1e2;
    q.digits = 4;
    return q;
  }
  const auto* unit = std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return units == u.si; });
  if (unit != kUnits.end()) {
    q.unit = unit->shown;
    q.factor = unit->factor;
    q.digits = unit->digits;
  }
  return q;
}

std::string duration_words(double seconds) {
  if (seconds >= 7200.0) return fmt::format("{:.4g} h", seconds / 3600.0);
  if (seconds >= 300.0) return fmt::format("{:.4g} min", seconds / 60.0);
  return fmt::format("{:.4g} s", seconds);
}

}  // namespace overbend
