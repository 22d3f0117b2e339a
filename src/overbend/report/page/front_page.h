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

/// One bar of the chart of utilisations.
struct Utilisation {
  std::string title;         ///< "Sagbend", "Mooring lines".
  double utilisation = 0.0;  ///< 1 is the full capacity, including its safety factor.
  std::string what;          ///< Check, position, time.
};

struct FrontPage {
  std::string kind;  ///< "Static pipelay analysis"
  std::string title;
  ReportDescription control;
  std::vector<std::pair<std::string, std::string>> entries;  ///< Names and values below the title.
  Findings findings;
  std::string reach;  ///< Sentence on the scope of the verdict: the static state, a run of a given duration.
};

/// Returns the first page with the verdict of the checks and a bar for each region.
Json front_page(const FrontPage& page, const StaticResults& statics, const CheckTable& checks);

/// Returns the same with another verdict and other bars; `note` explains their marks.
Json front_page(const FrontPage& page, const Verdict& verdict, const std::vector<Utilisation>& bars,
                const std::string& note);

/// Returns the same without a verdict.
Json front_page(const FrontPage& page);

}  // namespace overbend
