/// The first page: document control, verdict, warnings, contents.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/description.h"
#include "report/verdict.h"
#include "report/warning_weight.h"
#include "results/static_results.h"

namespace overbend {

/// One bar of the card of utilisations.
struct UtilisationBar {
  std::string title;         ///< Plain text: "Sagbend", "Mooring lines".
  double utilisation = 0.0;  ///< 1 is the full capacity.
  std::string what;          ///< Plain text: of what, where, when.
};

struct FrontPage {
  std::string kind;   ///< "Static pipelay analysis"
  std::string title;  ///< Plain text, as all here.
  ReportDescription control;
  std::vector<std::pair<std::string, std::string>> entries;  ///< Names with values below the title.
  std::vector<WeighedWarning> warnings;
  std::string reach;  ///< A sentence on what the verdict is of: the static state, a run of so many seconds.
  std::vector<UtilisationBar> more;  ///< Of what is no check of the pipe.
};

/// HTML of the first page; `rest` is the HTML of what follows, whose sections the contents list.
std::string front_page(const FrontPage& page, const StaticResults& statics, const CheckTable& checks,
                       const std::string& rest);

/// The same for a model without a pipe, whose utilisations are `page.more`; `note` tells of the card what its marks
/// are, plain text.
std::string front_page(const FrontPage& page, const Verdict& verdict, const std::string& note, const std::string& rest);

/// The warnings by weight; empty without any.
std::string warnings_section(const std::vector<WeighedWarning>& warnings);

/// Links to the sections of a page, in their order.
std::string contents(const std::string& sections);

}  // namespace overbend
