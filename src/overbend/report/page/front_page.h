/// The first page as data: document control, verdict, utilisations, findings.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/finding.h"
#include "base/json.h"
#include "model/description/description.h"
#include "results/static_results.h"
#include "results/verdict.h"

namespace overbend {

/// One bar of the card of utilisations.
struct Utilisation {
  std::string title;         ///< "Sagbend", "Mooring lines".
  double utilisation = 0.0;  ///< 1 is the full capacity, with its safety factor.
  std::string what;          ///< Of what, where, when.
};

struct FrontPage {
  std::string kind;  ///< "Static pipelay analysis"
  std::string title;
  ReportDescription control;
  std::vector<std::pair<std::string, std::string>> entries;  ///< Names with values below the title.
  Findings findings;
  std::string reach;  ///< A sentence on what the verdict is of: the static state, a run of so many seconds.
};

/// The first page with the verdict of the checks and a bar for each region.
Json front_page(const FrontPage& page, const StaticResults& statics, const CheckTable& checks);

/// The same with a verdict and bars of its own; `note` says below the bars what their marks are.
Json front_page(const FrontPage& page, const Verdict& verdict, const std::vector<Utilisation>& bars,
                const std::string& note);

/// The same without a verdict.
Json front_page(const FrontPage& page);

}  // namespace overbend
