#include "results/warnings.h"

#include <algorithm>

namespace overbend {

std::vector<std::string> together(std::vector<std::string> all, const std::vector<std::string>& more) {
  for (const std::string& text : more) {
    if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
  }
  return all;
}

const std::vector<std::string>& static_warnings(const StaticResults& results) {
  return results.has_pipe() ? results.warnings : results.moorings->warnings;
}

std::vector<std::string> all_warnings(const StaticResults& statics, const DynamicResults& results) {
  return together(results.warnings, static_warnings(statics));
}

}  // namespace overbend
