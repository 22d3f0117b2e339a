#include "base/require.h"

#include <stdexcept>
#include <string_view>

namespace overbend {
namespace {

/// Returns the path below the sources, so that messages do not depend on the build folder.
std::string_view below_sources(std::string_view file) {
  constexpr std::string_view kSources = "src/overbend/";
  const std::size_t position = file.rfind(kSources);
  return position == std::string_view::npos ? file : file.substr(position + kSources.size());
}

}  // namespace

void broken_promise(const std::string& promise, const char* file, int line) {
  throw std::logic_error("broken promise: " + promise + " (" + std::string(below_sources(file)) + ":" +
                         std::to_string(line) + ")");
}

}  // namespace overbend
