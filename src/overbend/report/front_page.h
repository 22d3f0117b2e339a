/// The first page: document control, verdict, warnings, contents.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/description.h"
#include "report/warning_weight.h"
#include "results/static_results.h"

namespace overbend {

struct FrontPage {
  std::string kind;   ///< "Static pipelay analysis"
  std::string title;  ///< Plain text, as all here.
  ReportDescription control;
  std::vector<std::pair<std::string, std::string>> entries;  ///< Names with values below the title.
  std::vector<WeighedWarning> warnings;
  std::string reach;  ///< A sentence on what the verdict is of: the static state, a run of so many seconds.
};

/// HTML of the first page; `rest` is the HTML of what follows, whose sections the contents list.
std::string front_page(const FrontPage& page, const StaticResults& statics, const CheckTable& checks,
                       const std::string& rest);

/// The warnings by weight; empty without any.
std::string warnings_section(const std::vector<WeighedWarning>& warnings);

/// Links to the sections of a page, in their order.
std::string contents(const std::string& sections);

}  // namespace overbend
