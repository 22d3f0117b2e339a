/// Stages of lay operations compared with solutions of the planar extensible elastica with a string in the line.
#include <cmath>
#include <stdexcept>

#include "base/constants.h"
#include "base/json.h"
#include "groups.h"
#include "modelfile/reading/yaml_reader.h"
#include "study/stages/lay_operation.h"

namespace overbend::validation {
namespace {

constexpr const char* kFolder = OVERBEND_SOURCE_DIR "/validation/operation_cases/";

/// Rows of one stage.
class StageRows {
 public:
  StageRows(const StageResult& stage, const Json& expected, std::vector<Row>& rows)
      : stage_(stage), expected_(expected), rows_(rows) {}

  void add_all() {
    const StaticResults& r = stage_.lay.value();
    const HeadResult& head = r.head.value();
    const Json& e = expected_["head"];
    add("tension on the bed", "kN", 1e-3, r.bottom_tension, expected_["bottom_tension"], 2e-3, 0.0, "0.2 %");
    add("lay-back", "m", 1.0, r.lay_back, expected_["lay_back"], 0.0, 0.1, "0.10 m");
    add("head, astern of the shoe", "m", 1.0, head.astern, e["x"], 0.0, 0.1, "0.10 m");
    add("head, height", "m", 1.0, head.p_W.z(), e["z"], 0.0, 0.1, "0.10 m");
    add("head, inclination", "deg", 1.0 / kDegree, head.inclination, e["inclination"], 0.0, 0.1 * kDegree, "0.1 deg");
    add("cable at the head, inclination", "deg", 1.0 / kDegree, head.cable_inclination, e["cable_inclination"], 0.0,
        0.1 * kDegree, "0.1 deg");
    add("cable at the head, tension", "kN", 1e-3, head.tension, e["tension"], 2e-3, 0.0, "0.2 %");
    add_sagbend(r);
    if (r.far_anchor) {
      add("anchor, astern of the shoe", "m", 1.0, r.far_anchor->distance, expected_["anchor"]["distance"], 0.0, 0.1,
          "0.10 m");
    }
  }

 private:
  /// Adds the sagbend of a suspended pipe; a head that barely touches the seabed has a moment of its own.
  void add_sagbend(const StaticResults& r) {
    constexpr double kWorthComparing = 20e3;  // [N m]
    if (!expected_.contains("sagbend")) return;
    const double moment = expected_["sagbend"].value("max_bending_moment", 0.0);
    if (moment < kWorthComparing) return;
    add("largest moment, sagbend", "kN m", 1e-3, r.sagbend.bending_moment.value, moment, 5e-3, 0.0, "0.5 %");
  }

  void add(const std::string& quantity, const std::string& unit, double scale, double ours, double reference,
           double share, double min_value, const std::string& allowed) {
    rows_.push_back({stage_.stage.name, quantity, unit, scale * ours, scale * reference,
                     scale * relative_tolerance(reference, share, min_value), "elastica and string, " + allowed});
  }

  const StageResult& stage_;
  const Json& expected_;
  std::vector<Row>& rows_;
};

Table make_stage_table(const std::string& name) {
  const OperationResults found = solve_operation(read_model(kFolder + name + ".yaml").description.value());
  const Json expected = read_json_file(kFolder + name + ".expected.json")["operation"]["stages"];
  Table table{name, found.title, {}};
  for (std::size_t i = 0; i < found.stages.size(); ++i) {
    if (!found.stages[i].lay) throw std::runtime_error(name + ": " + found.stages[i].failure->what);
    StageRows(found.stages[i], expected[i], table.rows).add_all();
  }
  return table;
}

}  // namespace

Group lay_operations() {
  return {
      "Lay operations",
      "elastica by spectral collocation",
      "Abandonment and start-up ([theory](theory/lay-operations.md)) stage by stage, compared with a spectral "
      "collocation of "
      "the planar elastica; the cable is a string without bending stiffness; rollers are frictionless and rigid.",
      {make_stage_table("AR12-J"), make_stage_table("AR16-S"), make_stage_table("SU10-J"), make_stage_table("SU16")}};
}

}  // namespace overbend::validation
