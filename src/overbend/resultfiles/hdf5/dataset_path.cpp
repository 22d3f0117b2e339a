#include "resultfiles/hdf5/dataset_path.h"

#include <algorithm>

namespace overbend {

std::string dataset_path(const std::string& name) {
  std::string path;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string part = name.substr(begin, end - begin);
    if (begin > 0) path += '/';
    path += (part.empty() || part == ".") ? "_" : part;
    begin = end + 1;
  }
  return path;
}

void make_groups_above(Hdf5Writer& file, const std::string& path, const std::string& description) {
  for (std::size_t end = path.find('/', 1); end != std::string::npos; end = path.find('/', end + 1)) {
    const std::string group = path.substr(0, end);
    if (!file.has(group)) file.group(group, description);
  }
}

}  // namespace overbend
