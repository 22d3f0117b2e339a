/// Writes the report of made-up dynamic results of the example: dynamic_page FILE.html rough|calm|jlay
#include <iostream>
#include <string>

#include "report/bgl1_results.h"
#include "report/report.h"
#include "report/synthetic_dynamics.h"

int main(int count, char** words) {
  if (count != 3) {
    std::cerr << "dynamic_page FILE.html rough|calm|jlay\n";
    return 2;
  }
  const auto& example = overbend::testing::bgl1();
  overbend::StaticResults statics = example.results;
  if (std::string(words[2]) == "jlay") {  // not the statics of one, but all that the page looks at
    statics.supports.clear();
    statics.overbend.reset();
    statics.stinger_tip_clearance.reset();
    statics.last_support.clear();
  }
  const bool calm = std::string(words[2]) == "calm";
  overbend::write_report(statics, overbend::testing::synthetic_dynamics(statics, calm), example.model_text, words[1]);
  return 0;
}
