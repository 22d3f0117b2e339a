/// Files that the build puts into the program (serve/embedded/CMakeLists.txt).
#pragma once

#include <string_view>
#include <vector>

namespace overbend {

struct EmbeddedFile {
  std::string_view path;   ///< "page/index.html", "examples/bgl1.yaml", "data/bgl1/rao.csv".
  std::string_view bytes;  ///< Lives as long as the program.
};

const std::vector<EmbeddedFile>& embedded_files();

}  // namespace overbend
