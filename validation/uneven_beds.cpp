/// Lays over uneven beds compared with solutions of the planar extensible elastica.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/json.h"
#include "groups.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"

namespace overbend::validation {
namespace {

constexpr const char* kFolder = OVERBEND_SOURCE_DIR "/validation/bed_cases/";
constexpr double kWorthComparing = 0.05;  ///< Smaller gaps depend on the soil model [m].

class BedRows {
 public:
  BedRows(const StaticResults& results, const Json& expected, std::vector<Row>& rows)
      : results_(results), bed_(results.bed.value()), expected_(expected), rows_(rows) {}

  void add_all() {
    const Json& e = expected_["seabed"];
    subject_ = "line";
    add("tension on the bed", "kN", 1e-3, results_.bottom_tension, expected_["bottom_tension"], 1e-3, 0.0, "0.1 %");
    add("tension at the far end", "kN", 1e-3, bed_.tail_tension, e["tail_tension"], 1e-3, 0.0, "0.1 %");
    add("lay-back", "m", 1.0, results_.lay_back, expected_["lay_back"], 0.0, 0.1, "0.10 m");
    add("largest moment, sagbend", "kN m", 1e-3, results_.sagbend.bending_moment.value,
        expected_["sagbend"]["max_bending_moment"], 3e-3, 0.0, "0.3 %");
    add("largest moment, overbend", "kN m", 1e-3, results_.overbend.value().bending_moment.value,
        expected_["overbend"]["max_bending_moment"], 1.5e-2, 0.0, "1.5 %");
    add("largest penetration", "mm", 1e3, bed_.max_penetration, e["max_penetration"], 1e-2, 0.0, "1 %");
    add("largest hogging moment on the bed", "kN m", 1e-3, bed_.hogging_moment, e["max_hogging_moment"]["value"], 5e-3,
        1e3, "0.5 % or 1 kN m");
    add("largest sagging moment on the bed", "kN m", 1e-3, bed_.sagging_moment, e["max_sagging_moment"]["value"], 5e-3,
        1e3, "0.5 % or 1 kN m");
    add_spans();
  }

 private:
  void add_spans() {
    int number = 0;
    for (const Json& span : expected_["seabed"]["free_spans"]) {
      if (span["max_gap"] < kWorthComparing) continue;
      const FreeSpanResult& ours = nearest(span);
      subject_ = "span " + std::to_string(++number);
      add("from, astern of the shoe", "m", 1.0, ours.x_from, span["x_from"], 0.0, 0.3, "0.3 m");
      add("to, astern of the shoe", "m", 1.0, ours.x_to, span["x_to"], 0.0, 0.3, "0.3 m");
      add("largest gap", "mm", 1e3, ours.max_gap, span["max_gap"], 0.0, 5e-3, "5 mm");
      add("largest sagging moment", "kN m", 1e-3, ours.sagging_moment, span["max_sagging_moment"], 5e-3, 1e3,
          "0.5 % or 1 kN m");
    }
  }

  const FreeSpanResult& nearest(const Json& span) const {
    if (bed_.spans.empty()) throw std::runtime_error("no free span was found");
    const double position = span["max_gap_x"];
    return *std::min_element(bed_.spans.begin(), bed_.spans.end(),
                             [position](const FreeSpanResult& a, const FreeSpanResult& b) {
                               return std::abs(a.gap_x - position) < std::abs(b.gap_x - position);
                             });
  }

  void add(const std::string& quantity, const std::string& unit, double scale, double ours, double reference,
           double share, double min_value, const std::string& allowed) {
    rows_.push_back({subject_, quantity, unit, scale * ours, scale * reference,
                     scale * relative_tolerance(reference, share, min_value), "elastica on an uneven bed, " + allowed});
  }

  const StaticResults& results_;
  const BedResults& bed_;
  const Json& expected_;
  std::vector<Row>& rows_;
  std::string subject_;
};

Table make_lay_table(const std::string& name) {
  const Model model = build_model(read_model(kFolder + name + ".yaml").description.value());
  const StaticOutcome outcome = solve_statics(model);
  if (!outcome.solution) throw std::runtime_error(name + ": " + outcome.failure->what);
  const StaticResults results = recover_statics(model, *outcome.solution);
  const Json expected = read_json_file(kFolder + name + ".expected.json")["static"];
  Table table{name, results.title, {}};
  BedRows(results, expected, table.rows).add_all();
  return table;
}

}  // namespace

Group uneven_beds() {
  return {
      "Uneven seabeds",
      "elastica by spectral collocation",
      "Pipes over a bump, down a slope, across a depression and over a sleeper ([theory](theory/uneven-seabeds.md)) "
      "compared with a spectral collocation of the planar elastica on the same profile; rollers and seabed are "
      "frictionless.",
      {make_lay_table("BP16-bump"), make_lay_table("BP16-slope"), make_lay_table("BP24-depression"),
       make_lay_table("BP24-sleeper")}};
}

}  // namespace overbend::validation
