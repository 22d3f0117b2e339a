#include "base/require.h"

#include <stdexcept>
#include <string_view>

namespace overbend {
namespace {

/// The path below the sources, so that messages do not depend on where the program was built.
std::string_view below_sources(std::string_view file) {
  constexpr std::string_view kSources = "src/overbend/";
  const std::size_t at = file.rfind(kSources);
  return at == std::string_view::npos ? file : file.substr(at + kSources.size());
}

}  // namespace

void broken_promise(const std::string& promise, const char* file, int line) {
  throw std::logic_error("broken promise: " + promise + " (" + std::string(below_sources(file)) + ":" +
                         std::to_string(line) + ")");
}

}  // namespace overbend
