/// Files embedded in the program at build time (serve/embedded/CMakeLists.txt).
#pragma once

#include <string_view>
#include <vector>

namespace overbend {

struct EmbeddedFile {
  std::string_view path;   ///< "page/index.html", "examples/bgl1.yaml", "data/bgl1/rao.csv".
  std::string_view bytes;  ///< Valid for the lifetime of the program.
};

const std::vector<EmbeddedFile>& embedded_files();

}  // namespace overbend
