/// Writes the report of made-up dynamic results of the example: dynamic_page FILE.html [calm]
#include <iostream>

#include "report/bgl1_results.h"
#include "report/report.h"
#include "report/synthetic_dynamics.h"

int main(int count, char** words) {
  if (count < 2) {
    std::cerr << "dynamic_page FILE.html [calm]\n";
    return 2;
  }
  const auto& example = overbend::testing::bgl1();
  const bool calm = count > 2;
  overbend::write_report(example.results, overbend::testing::synthetic_dynamics(example.results, calm),
                         example.model_text, words[1]);
  return 0;
}
