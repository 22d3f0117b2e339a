#include "report/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/shown_unit.h"
#include "report/history_name.h"
#include "report/html.h"

namespace overbend {
namespace {

void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at != std::string::npos) text.replace(at, from.size(), to);
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
  std::string text = quantity_of(name);
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

std::string Quantity::text(double si, int decimals) const {
  return html::fixed(shown(si), decimals);
}

Quantity quantity(const std::string& name, const std::string& units) {
  const ShownUnit unit = shown_unit(quantity_of(name), units);
  return {words(name), std::string(unit.name), unit.factor, unit.digits};
}

std::string duration_words(double seconds) {
  if (seconds >= 7200.0) return fmt::format("{:.4g} h", seconds / 3600.0);
  if (seconds >= 300.0) return fmt::format("{:.4g} min", seconds / 60.0);
  return fmt::format("{:.4g} s", seconds);
}

}  // namespace overbend
