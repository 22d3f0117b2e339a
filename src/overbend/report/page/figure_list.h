/// How figures of the page are passed to its scripts.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace overbend {

/// `id` chooses what is drawn; `parts` are the panels below one caption.
struct Figure {
  const char* id;
  const char* caption;
  std::vector<const char*> parts;
  bool small = false;  ///< Its panels hold small multiples, side by side.
};

/// The figures whose parts pass `makes_sense`, numbered on from `number`, which is left at the last; a figure without
/// any part is left out.
std::string figure_list(const std::vector<Figure>& figures,
                        const std::function<bool(const Figure&, const std::string& part)>& makes_sense, int& number);

/// A section of figures: nothing where there are none.
std::string figure_section(const std::string& id, const std::string& heading, const std::string& figures);

}  // namespace overbend
