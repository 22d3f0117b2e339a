/// Selection of the figures of a page.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/page/blocks.h"

namespace overbend {

/// Returns the figures with those of their parts that pass `is_applicable`; a figure without parts is omitted.
Blocks figure_list(const std::vector<Figure>& figures,
                   const std::function<bool(const Figure&, const std::string& part)>& is_applicable);

/// Returns all figures.
Blocks figure_list(const std::vector<Figure>& figures);

}  // namespace overbend
