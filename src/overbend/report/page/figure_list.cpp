#include "report/page/figure_list.h"

#include <fmt/format.h>

#include "report/page/html.h"

namespace overbend {

std::string figure_list(const std::vector<Figure>& figures,
                        const std::function<bool(const Figure&, const std::string& part)>& makes_sense, int& number) {
  std::string out;
  for (const Figure& figure : figures) {
    std::string panels;
    for (const char* part : figure.parts) {
      if (makes_sense(figure, part)) {
        panels += fmt::format("<div class=\"{}\" data-figure=\"{}\" data-part=\"{}\"></div>\n",
                              figure.small ? "panel multiples" : "panel", figure.id, part);
      }
    }
    if (!panels.empty()) {
      out += fmt::format("<figure>\n{}<figcaption>Figure {}. {}</figcaption>\n</figure>\n", panels, ++number,
                         html::escape(figure.caption));
    }
  }
  return out;
}

std::string figure_section(const std::string& id, const std::string& heading, const std::string& figures) {
  return figures.empty() ? ""
                         : html::section(id, heading,
                                         "<noscript><p>The figures are drawn by scripts, which are disabled in this "
                                         "browser. The tables contain the same results.</p></noscript>\n" +
                                             figures);
}

}  // namespace overbend
