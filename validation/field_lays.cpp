/// Published cases rebuilt from their inputs and compared with their results.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/constants.h"
#include "base/json.h"
#include "groups.h"
#include "modelfile/reading/yaml_reader.h"
#include "recording/run_dynamics.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/summary/named_results.h"
#include "study/run/static_analysis.h"
#include "study/stages/lay_operation.h"
#include "support/memory_sink.h"

namespace overbend::validation {
namespace {

constexpr const char* kFolder = OVERBEND_SOURCE_DIR "/validation/field_cases/";
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();  ///< Fails every tolerance.

Description field_description(const std::string& name) {
  const ModelReading reading = read_model(kFolder + name + ".yaml");
  if (!reading.description) throw std::runtime_error("cannot read the case " + name);
  return *reading.description;
}

/// Unit and scale of a printed quantity, with its tolerance: a fraction of the reference, at least `floor` in the unit.
struct Quantity {
  const char* name;
  const char* unit;
  double scale;
  double fraction;
  double floor = 0.0;
};

/// Rows of one case from its summary.json.
class CaseRows {
 public:
  CaseRows(std::string subject, Json summary) : subject_(std::move(subject)), summary_(std::move(summary)) {}

  /// The result `path`, as a goal seek names it; `reference` in the printed unit.
  void add(const Quantity& quantity, const std::string& path, double reference, const std::string& basis) {
    add_value(quantity, named_result(summary_, path).value_or(kMissing), reference, basis);
  }
  /// `ours` in SI.
  void add_value(const Quantity& quantity, double ours, double reference, const std::string& basis) {
    rows_.push_back({subject_, quantity.name, quantity.unit, quantity.scale * ours, reference,
                     relative_tolerance(reference, quantity.fraction, quantity.floor), basis});
  }

  double value(const std::string& path) const { return named_result(summary_, path).value_or(kMissing); }
  const Json& summary() const { return summary_; }
  std::vector<Row> rows() const { return rows_; }

 private:
  std::string subject_;
  Json summary_;
  std::vector<Row> rows_;
};

StaticResults field_statics(const std::string& name) {
  Model model = build_model(field_description(name));
  StaticRun run = run_statics(model);
  if (!run.results) throw std::runtime_error(name + ": " + run.failure->what);
  return std::move(*run.results);
}

Table plain_pipe() {
  CaseRows rows("16 inch, R 70 m, 120 t", static_summary_json(field_statics("ABQ-plain-R70-120t")));
  rows.add({"largest strain, overbend", "%", 100.0, 0.10}, "static.overbend.max_strain", 0.46,
           "Abaqus; 10 %: two published programs differ by 19 %");
  rows.add({"largest strain, overbend", "%", 100.0, 0.15}, "static.overbend.max_strain", 0.5468,
           "J2 beam code, maximum of a passage on elements of two diameters; 15 %");
  rows.add({"largest bending moment, overbend", "kN m", 1e-3, 0.02}, "static.overbend.max_bending_moment", 1258.0,
           "J2 beam code; 2 %");
  return {"Plain pipe over a stinger of 70 m",
          "406.4 x 21 mm, Ramberg-Osgood steel of 450 MPa, on rollers 9 m apart in air; 120 t "
          "at the tensioner, loading history of laying. The J2 code reports the maximum of a passage.",
          rows.rows(), "Abaqus, J2 beam code (published)"};
}

Table thick_component() {
  CaseRows rows("53 mm, R 70 m, 100 t",
                operation_summary_json(solve_operation(field_description("ABQ-thick-R70-53mm"))));
  rows.add({"largest strain, neighbouring pipe", "%", 100.0, 0.10}, "operation.passage.max_strain_beside.value", 0.727,
           "Abaqus; 10 %: ours are -4 to +15 % off in its nine published cases");
  rows.add({"largest bending moment, component", "kN m", 1e-3, 0.08}, "operation.passage.max_bending_moment.value",
           1366.0, "Abaqus; 8 %: ours are 5 to 11 % above its nine published moments, for an unknown reason");
  return {"Thick component over a stinger of 70 m",
          "A component of 1 m and 53 mm wall in the same pipe passes over the second stinger roller, in stages of 0.5 "
          "m that carry the plastic strain of the pipe on. A single static analysis has a lower strain: the "
          "concentration travels with the component.",
          rows.rows(), "Abaqus (published)"};
}

Table catenary_hose() {
  const StaticResults results = field_statics("OF-catenary-hose");
  CaseRows rows("hose, 130 m", static_summary_json(results));
  double curvature = 0.0;
  for (const Station& station : results.stations) curvature = std::max(curvature, station.curvature);
  rows.add({"top tension", "kN", 1e-3, 1e-3}, "static.top_tension", 132.379, "OrcaFlex; 0.1 %");
  rows.add({"minimum tension", "kN", 1e-3, 5e-3}, "static.smallest_tension.value", 11.776,
           "OrcaFlex; 0.5 %: drag and friction are assumed");
  rows.add_value({"tension at the anchor", "kN", 1e-3, 0.01}, results.stations.front().effective_tension, 11.877,
                 "OrcaFlex; 1 %: friction there, none in ours");
  rows.add({"largest bending moment", "kN m", 1e-3, 5e-3}, "static.structures[hose].max_bending_moment", 9.502,
           "OrcaFlex; 0.5 %: 0.4 % between two of its meshes");
  rows.add_value({"largest curvature", "1/m", 1.0, 5e-3}, curvature, 0.07610, "OrcaFlex; 0.5 %, as the moment");
  return {"Catenary hose in a current",
          "130 m of hose between a vessel and an anchor in 100 m of water, both ends pinned, in a sheared current. The "
          "drag coefficient is assumed to be 1.2; 0.9 changes the top tension by 0.5 %.",
          rows.rows(), "OrcaFlex (published)"};
}

/// A line of the calculation sheet of a check [SI].
double sheet_value(const Json& summary, const std::string& check, const std::string& symbol) {
  for (const Json& row : summary["checks"]["list"]) {
    if (row["id"] != check) continue;
    for (const Json& line : row["sheet"]) {
      if (line["symbol"] == symbol) return line["value"].get<double>();
    }
  }
  return kMissing;
}

Table collapse() {
  CaseRows rows("660 mm, 410 m", static_summary_json(field_statics("DNV-collapse-660")));
  const auto sheet = [&](const char* check, const char* symbol) { return sheet_value(rows.summary(), check, symbol); };
  const std::string digits = "worked example; digits printed";
  const std::string depth = "worked example; 0.2 %: pressure at the axis of the pipe, 409.6 m";
  rows.add_value({"collapse p_c", "MPa", 1e-6, 0.0, 5e-6}, sheet("dnv_collapse", "p_c"), 10.8311641, digits);
  rows.add_value({"collapse, utilisation", "", 1.0, 2e-3}, sheet("dnv_collapse", "U"), 0.500, depth);
  rows.add_value({"propagation p_pr", "MPa", 1e-6, 0.0, 5e-6}, sheet("dnv_propagation", "p_pr"), 2.3011025, digits);
  rows.add_value({"propagation, utilisation", "", 1.0, 2e-3}, sheet("dnv_propagation", "U"), 2.353, depth);
  return {"Collapse and propagation of a 660 mm pipe",
          "DNV-ST-F101 for 660 x 21.2 mm X65 with a corrosion allowance of 0.5 mm in 410 m of water, medium safety "
          "class. A concrete coating is added so that the pipe sinks; the checks do not depend on it.",
          rows.rows(), "PDover2t, worked example (published)"};
}

Table shallow_lay() {
  CaseRows rows("42 inch, 18 m", static_summary_json(field_statics("bigfoot-18m")));
  const std::string solver = "collocation of the elastica";
  rows.add({"tension on the seabed", "kN", 1e-3, 1e-3}, "static.bottom_tension", 1466.16, solver + ", 0.1 %");
  rows.add({"lay-back", "m", 1.0, 0.0, 0.1}, "static.lay_back", 201.317, solver + ", 0.10 m");
  rows.add({"departure angle", "deg", kToDegrees, 0.0, 0.05}, "static.departure_angle", 12.082, solver + ", 0.05 deg");
  rows.add({"largest bending moment, overbend", "kN m", 1e-3, 1e-3}, "static.overbend.max_bending_moment", 5411.1,
           solver + ", 0.1 %");
  rows.add({"largest bending moment, sagbend", "kN m", 1e-3, 3e-3}, "static.sagbend.max_bending_moment", 3525.6,
           solver + ", 0.3 %");
  constexpr double kReactions[] = {403.0, 367.5, 228.9, 148.0, 102.5, 103.5, 123.8, 170.2, 235.8, 393.5, 219.5, 0, 0};
  const Json& supports = rows.summary()["static"]["supports"];
  for (std::size_t i = 0; i < std::size(kReactions); ++i) {
    const std::string name = supports.at(i)["name"].get<std::string>() + ": reaction";
    rows.add_value({name.c_str(), "kN", 1e-3, 1e-2, 0.5}, supports.at(i)["reaction"].get<double>(), kReactions[i],
                   solver + ", the larger of 1 % and 0.5 kN");
  }
  return {"42-inch concrete coated pipe, 18 m",
          "Input of a shallow lay barge as published for OrcaFlex; its results are not stored, so the reference is a "
          "solution of the planar extensible elastica. V-shaped rollers are one spring of 16.4 MN/m; the pipe is "
          "pinned where the lay curve begins.",
          rows.rows(), "elastica by spectral collocation"};
}

Table jlay_in_heave() {
  Model model = build_model(field_description("JL-heave"));
  const StaticRun start = run_statics(model);
  if (!start.results) throw std::runtime_error("JL-heave: " + start.failure->what);
  testing::EmptySink sink;
  const auto control = [](const DynamicProgress&) { return DynamicControl::go_on; };
  const DynamicOutcome run =
      run_dynamics(model, *start.solution, *start.results, dynamic_options(model), sink, nullptr, control);
  if (!run.results) throw std::runtime_error("JL-heave: " + run.failure->what);
  CaseRows rows("12 inch, 150 m", dynamic_summary_json(*start.results, *run.results));
  const std::string chain = "lumped-mass chain; 1 %: its links are 4.2 m long";
  rows.add_value({"range of the top tension", "kN", 1e-3, 0.01},
                 rows.value("dynamic.top_tension.max") - rows.value("dynamic.top_tension.min"), 173.98, chain);
  rows.add({"minimum tension of the line", "kN", 1e-3, 0.01}, "dynamic.smallest_tension.min", 66.03, chain);
  rows.add({"bending moment of the sagbend, maximum", "kN m", 1e-3, 0.01}, "dynamic.sagbend.max_bending_moment.max",
           218.97, chain);
  rows.add({"bending moment of the sagbend, minimum", "kN m", 1e-3, 0.01}, "dynamic.sagbend.max_bending_moment.min",
           141.27, chain);
  return {"J-lay in regular heave",
          "323.9 x 19.1 mm in 150 m of still water, 237 kN, top pinned at the surface, heave of 1.5 m in 9 s. The "
          "reference is an explicit lumped-mass chain without common code; the extremes are those of six cycles.",
          rows.rows(), "lumped-mass chain"};
}

}  // namespace

Group field_lays() {
  return {
      "Field cases",
      "published results",
      "Published cases rebuilt from their inputs ([models and sources](../validation/README.md#field_cases)). Inputs "
      "that the publications do not give are assumed and named there. Two references are our own: the 42-inch lay is "
      "published without results, and no dynamic lay with complete inputs and results was found.",
      {plain_pipe(), thick_component(), catenary_hose(), collapse(), shallow_lay(), jlay_in_heave()}};
}

}  // namespace overbend::validation
