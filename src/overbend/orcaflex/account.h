/// Account of an import or export: data translated, approximated and left out.
#pragma once

#include <string>
#include <vector>

namespace overbend::orcaflex {

struct Account {
  struct Omission {
    std::string text;
    bool matters = false;  ///< Results may differ for it.
  };
  std::vector<std::string> translated;
  std::vector<std::string> approximated;  ///< With how, and by how much.
  std::vector<Omission> left_out;

  bool is_complete() const;  ///< False if something that matters was left out.
  /// The account as lines of text for terminal and file.
  std::string text() const;
};

}  // namespace overbend::orcaflex
