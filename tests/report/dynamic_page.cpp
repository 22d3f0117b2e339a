/// Writes the report of made-up results: dynamic_page FILE.html
/// rough|calm|jlay|moored|moored_in_time|moorings|pull_ahead|lines|abandonment|start_up|study_SHAPE
#include <functional>
#include <iostream>
#include <map>
#include <string>

#include "report/bgl1_results.h"
#include "report/report.h"
#include "report/stages/operation_report.h"
#include "report/studies/study_page.h"
#include "report/synthetic_dynamics.h"
#include "report/synthetic_moorings.h"
#include "report/synthetic_operation.h"
#include "report/synthetic_study.h"

namespace {

using namespace overbend;
using namespace overbend::testing;

void write_lay(const std::string& kind, const std::string& file) {
  StaticResults statics = bgl1().results;
  if (kind == "jlay") {  // not the statics of one, but all that the page looks at
    statics.supports.clear();
    statics.overbend.reset();
    statics.stinger_tip_clearance.reset();
    statics.last_support.clear();
  }
  DynamicResults results = synthetic_dynamics(statics, kind == "calm");
  if (kind == "moored") {
    statics.moorings = synthetic_moorings();
    statics.hull = synthetic_hull();
    add_moored_dynamics(results);
  }
  write_report(statics, results, bgl1().model_text, file);
}

void write_moorings(MooringResults moorings, const std::string& file) {
  StaticResults results = synthetic_hull_alone(std::move(moorings));
  results.hull = synthetic_hull();
  write_report(results, example_text("moored-barge"), file);
}

}  // namespace

int main(int count, char** arguments) {
  const std::map<std::string, std::function<void(const std::string&)>> kinds = {
      {"rough", [](const std::string& file) { write_lay("rough", file); }},
      {"calm", [](const std::string& file) { write_lay("calm", file); }},
      {"jlay", [](const std::string& file) { write_lay("jlay", file); }},
      {"moored", [](const std::string& file) { write_lay("moored", file); }},
      {"moorings", [](const std::string& file) { write_moorings(synthetic_stages(), file); }},
      {"moored_in_time", [](const std::string& file) { write_page(moored_document_in_time(), file); }},
      {"pull_ahead", [](const std::string& file) { write_moorings(synthetic_pull_ahead(), file); }},
      {"lines",
       [](const std::string& file) {
         write_report(synthetic_lines(), synthetic_lines_in_time(), example_text("jumper"), file);
       }},
      {"abandonment",
       [](const std::string& file) { write_operation_report(synthetic_abandonment(), abandonment_text(), file); }},
      {"start_up",
       [](const std::string& file) { write_operation_report(synthetic_start_up(), bgl1().model_text, file); }}};
  const std::string study = "study_";
  if (count == 3 && std::string(arguments[2]).starts_with(study)) {
    write_study_report(synthetic_study(std::string(arguments[2]).substr(study.size())), arguments[1]);
    return 0;
  }
  if (count != 3 || kinds.count(arguments[2]) == 0) {
    std::cerr << "dynamic_page FILE.html "
                 "rough|calm|jlay|moored|moored_in_time|moorings|pull_ahead|lines|abandonment|start_up|"
                 "study_SHAPE\n";
    return 2;
  }
  kinds.at(arguments[2])(arguments[1]);
  return 0;
}
