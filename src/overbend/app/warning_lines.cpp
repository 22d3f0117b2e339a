#include "app/warning_lines.h"

#include "report/warning_weight.h"

namespace overbend {

std::string warning_lines(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) text += "  warning: " + without_mark(warning) + "\n";
  return text;
}

}  // namespace overbend
