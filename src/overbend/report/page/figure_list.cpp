#include "report/page/figure_list.h"

#include <algorithm>

namespace overbend {

Blocks figure_list(const std::vector<Figure>& figures,
                   const std::function<bool(const Figure&, const std::string& part)>& is_applicable) {
  Blocks blocks;
  for (Figure figure : figures) {
    std::erase_if(figure.parts, [&](const std::string& part) { return !is_applicable(figure, part); });
    blocks += block::figure(figure);
  }
  return blocks;
}

Blocks figure_list(const std::vector<Figure>& figures) {
  return figure_list(figures, [](const Figure&, const std::string&) { return true; });
}

}  // namespace overbend
