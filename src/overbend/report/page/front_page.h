/// The first page: document control, verdict, findings, contents.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/finding.h"
#include "model/description/description.h"
#include "results/static_results.h"
#include "results/verdict.h"

namespace overbend {

/// One bar of the card of utilisations.
struct Utilisation {
  std::string title;         ///< Plain text: "Sagbend", "Mooring lines".
  double utilisation = 0.0;  ///< 1 is the full capacity, with its safety factor.
  std::string what;          ///< Plain text: of what, where, when.
};

struct FrontPage {
  std::string kind;   ///< "Static pipelay analysis"
  std::string title;  ///< Plain text, as all here.
  ReportDescription control;
  std::vector<std::pair<std::string, std::string>> entries;  ///< Names with values below the title.
  Findings findings;
  std::string reach;  ///< A sentence on what the verdict is of: the static state, a run of so many seconds.
};

/// HTML of the first page; `rest` is the HTML of what follows, whose sections the contents list.
std::string front_page(const FrontPage& page, const StaticResults& statics, const CheckTable& checks,
                       const std::string& rest);

/// The same with a verdict and bars of its own; `note` says below the card what its marks are, plain text.
std::string front_page(const FrontPage& page, const Verdict& verdict, const std::vector<Utilisation>& bars,
                       const std::string& note, const std::string& rest);

/// The findings by severity; empty without any.
std::string findings_section(const Findings& findings);

/// Links to the sections of a page, in their order.
std::string contents(const std::string& sections);

}  // namespace overbend
