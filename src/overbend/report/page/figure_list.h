/// Figures of a page, chosen by what there is to show.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/page/blocks.h"

namespace overbend {

/// The figures with those of their parts that pass `makes_sense`; a figure without any part is left out.
Blocks figure_list(const std::vector<Figure>& figures,
                   const std::function<bool(const Figure&, const std::string& part)>& makes_sense);

/// All of them.
Blocks figure_list(const std::vector<Figure>& figures);

}  // namespace overbend
