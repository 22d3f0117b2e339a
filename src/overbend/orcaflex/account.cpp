#include "orcaflex/account.h"

#include <algorithm>

namespace overbend::orcaflex {
namespace {

void add_lines(std::string& text, const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  text += title + "\n";
  for (const std::string& line : lines) text += "  - " + line + "\n";
}

}  // namespace

bool Account::is_complete() const {
  return std::none_of(left_out.begin(), left_out.end(), [](const Omission& omission) { return omission.matters; });
}

std::string Account::text() const {
  std::vector<std::string> serious, harmless;
  for (const Omission& omission : left_out) (omission.matters ? serious : harmless).push_back(omission.text);
  std::string text;
  add_lines(text, "Translated", translated);
  add_lines(text, "Approximated", approximated);
  add_lines(text, "Left out, and it matters", serious);
  add_lines(text, "Left out; loads and motions do not depend on it", harmless);
  return text;
}

}  // namespace overbend::orcaflex
