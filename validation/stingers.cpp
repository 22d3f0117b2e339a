/// Stingers on a hinge compared with solutions of the planar extensible elastica on frictionless rigid rollers.
#include <optional>
#include <stdexcept>

#include "base/constants.h"
#include "base/json.h"
#include "groups.h"
#include "model/lay_stage.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"
#include "statics/recovery/recovery.h"

namespace overbend::validation {
namespace {

constexpr const char* kFolder = OVERBEND_SOURCE_DIR "/validation/operation_cases/";

Json read_expected(const std::string& name) {
  return read_json_file(kFolder + name + ".expected.json");
}

void add_rows(const std::string& subject, const StaticResults& r, const Json& expected, std::vector<Row>& rows) {
  const auto add = [&](const char* quantity, const char* unit, double scale, double ours, double reference,
                       double share, double min_value, const char* allowed) {
    rows.push_back({subject, quantity, unit, scale * ours, scale * reference,
                    scale * relative_tolerance(reference, share, min_value), std::string("elastica, ") + allowed});
  };
  const StingerSectionResult& stinger = r.stinger.at(0);
  const Json& e = expected["stinger"];
  add("angle", "deg", 1.0 / kDegree, stinger.angle, e["angle"], 0.0, 5e-4, "5e-4 rad");
  add("moment of the rollers about the hinge", "kN m", 1e-3, stinger.roller_moment, e["roller_moment"], 0.01, 10e3,
      "1 % or 10 kN m");
  add("hinge force", "kN", 1e-3, stinger.hinge_force, e["hinge_force"]["magnitude"], 0.01, 1e3, "1 % or 1 kN");
  add("moment of the stop", "kN m", 1e-3, stinger.stop_moment, e["stop_moment"], 0.01, 10e3, "1 % or 10 kN m");
  for (std::size_t i = 0; i < stinger.tanks.size(); ++i) {
    add(i == 0 ? "tank 1, buoyancy" : "tank 2, buoyancy", "kN", 1e-3, stinger.tanks[i].buoyancy,
        e["tanks"][i]["buoyancy"], 0.005, 0.0, "0.5 %");
  }
  add("tension on the bed", "kN", 1e-3, r.bottom_tension, expected["bottom_tension"], 1e-3, 0.0, "0.1 %");
  add("lay-back", "m", 1.0, r.lay_back, expected["lay_back"], 0.0, 0.1, "0.10 m");
}

/// From the stage before, where there is one.
StaticResults solved(const Description& description, std::optional<StaticSolution>& last) {
  Model model = build_model(description);
  ModelEquilibrium outcome = solve_lay(model, last ? &*last : nullptr);
  if (outcome.failure) throw std::runtime_error(description.title + ": " + outcome.failure->what);
  last = std::move(outcome.solution);
  return recover_state(model, *last);
}

Table make_static_table(const std::string& name) {
  const Description description = read_model(kFolder + name + ".yaml").description.value();
  std::optional<StaticSolution> none;
  Table table{name, description.title, {}};
  add_rows(name, solved(description, none), read_expected(name)["static"], table.rows);
  return table;
}

Table make_stage_table(const std::string& name) {
  const Description description = read_model(kFolder + name + ".yaml").description.value();
  const Json expected = read_expected(name)["operation"]["stages"];
  std::optional<StaticSolution> last;
  Table table{name, description.title, {}};
  std::size_t i = 0;
  for (const LayStageDescription& stage : lay_stages(description)) {
    add_rows(stage.name, solved(make_stage_description(description, stage), last), expected[i++], table.rows);
  }
  return table;
}

}  // namespace

Group stingers() {
  return {
      "Stingers on a hinge",
      "elastica by spectral collocation",
      "A stinger that turns until the moments of rollers, weight and buoyancy about its hinge balance, or that rests "
      "on its stop ([theory](theory/stinger.md)), compared with a spectral collocation of the planar elastica with "
      "frictionless rigid rollers.",
      {make_static_table("HS16-float"), make_static_table("HS16-stop"), make_static_table("HS16-tanks"),
       make_stage_table("HS16-ballast")}};
}

}  // namespace overbend::validation
