#include "platform/temporary.h"

#include <cerrno>
#include <cstdlib>

namespace overbend {

std::filesystem::path make_unique_folder(const std::filesystem::path& parent, const std::string& stem,
                                         std::error_code& error) {
  std::string name = (parent / (stem + "XXXXXX")).string();
  error.clear();
  if (::mkdtemp(name.data()) != nullptr) return name;
  error = {errno, std::generic_category()};
  return {};
}

}  // namespace overbend
