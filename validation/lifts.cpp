/// Lifts, tie-ins and pulls along the seabed compared with two formulations without common code.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/constants.h"
#include "base/json.h"
#include "groups.h"
#include "modelfile/reading/yaml_reader.h"
#include "resultfiles/static/case_summary.h"
#include "study/stages/lay_operation.h"

namespace overbend::validation {
namespace {

/// Unit and scale of a printed quantity, with its tolerance: a fraction of the reference, at least `floor` in SI.
struct Quantity {
  const char* unit;
  double scale;
  double fraction, floor;
  const char* allowed;
};

constexpr Quantity kHeight{"m", 1.0, 0.0, 0.02, "0.02 m"};
constexpr Quantity kPlace{"m", 1.0, 0.0, 0.3, "0.3 m"};
constexpr Quantity kAngle{"deg", kToDegrees, 0.0, 0.05 * kDegree, "0.05 deg"};
constexpr Quantity kHeldForce{"kN", 1e-3, 0.0, 200.0, "0.2 kN"};
constexpr Quantity kTension{"kN", 1e-3, 3e-3, 100.0, "0.3 % or 0.1 kN"};
constexpr Quantity kMoment{"kN m", 1e-3, 5e-3, 0.0, "0.5 %"};
constexpr Quantity kMomentAtWire{"kN m", 1e-3, 5e-3, 500.0, "0.5 % or 0.5 kN m"};
constexpr Quantity kGap{"m", 1.0, 0.0, 0.01, "0.01 m"};
constexpr Quantity kJoinForce{"kN", 1e-3, 5e-3, 300.0, "0.5 % or 0.3 kN"};
constexpr Quantity kJoinMoment{"kN m", 1e-3, 5e-3, 100.0, "0.5 % or 0.1 kN m"};
constexpr Quantity kPull{"kN", 1e-3, 2e-3, 0.0, "0.2 %"};
constexpr Quantity kMinTension{"kN", 1e-3, 0.0, 100.0, "0.1 kN"};
constexpr Quantity kPullMoment{"kN m", 1e-3, 3e-3, 0.0, "0.3 %"};
constexpr Quantity kLiftOff{"m", 1.0, 0.0, 1.0, "1 m"};

/// Rows of one stage, by the names of summary.json.
class StageRows {
 public:
  StageRows(const std::string& stage, const Json& found, const Json& expected, std::vector<Row>& rows)
      : stage_(stage), found_(found), expected_(expected), rows_(rows) {}

  void add_lift() {
    for (const auto& [name, line] : expected_["lines"].items()) add_line(name, line);
    for (const auto& [name, wire] : expected_["davits"].items()) {
      const std::string path = "/davits/" + name;
      add(name + ", tension", wire.contains("tension_upper") ? path + "/tension_upper" : path + "/tension", kTension);
      add("pipe at " + name + ", moment", path + "/attachment/moment", kMomentAtWire);
    }
    add("gap, dx", "/gap/dx", kGap);
    add("gap, dz", "/gap/dz", kGap);
    add("gap, angle", "/gap/angle", kAngle);
    add("weld, tension", "/join/tension", kJoinForce);
    add("weld, shear", "/join/shear", kJoinForce);
    add("weld, moment", "/join/moment", kJoinMoment);
  }

  void add_pull() {
    for (const char* place : {"touchdown", "pipe_end", "head", "winch"}) {
      std::string title = place;
      std::ranges::replace(title, '_', ' ');
      add("tension, " + title, std::string("/tension/") + place, kPull);
    }
    add("least tension", "/least_tension", kMinTension);
    add("wire out", "/wire_out", kPlace);
    add("touchdown, astern of the shoe", "/touchdown/x", kPlace);
    add("head, height", "/head/z", kHeight);
    add("head, inclination", "/head/inclination", kAngle);
    add("largest moment, sagbend", "/sagbend/moment", kPullMoment);
    add("wire leaves the bed, before the winch", "/lift_off/arc_length_before_winch", kLiftOff);
  }

 private:
  void add_line(const std::string& name, const Json& line) {
    const std::string path = "/lines/" + name;
    add(name + ", end, height", path + "/first_end/z", kHeight);
    add(name + ", end, inclination", path + "/first_end/inclination", kAngle);
    add(name + ", largest sagging moment", path + "/largest_sagging_moment/value", kMoment);
    add(name + ", largest hogging moment", path + "/largest_hogging_moment/value", kMoment);
    if (line["held_end"].contains("horizontal_force")) {
      add(name + ", held end, horizontal force", path + "/held_end/horizontal_force", kHeldForce);
    }
    add(name + ", lift-off, from the end", path + "/lift_off/arc_length", kPlace);
  }

  /// Nothing where the reference does not have the value.
  void add(const std::string& quantity, const std::string& path, const Quantity& how) {
    const Json::json_pointer pointer(path);
    if (!expected_.contains(pointer) || !expected_[pointer].is_number()) return;
    const double reference = expected_[pointer].get<double>(), ours = found_.at(pointer).get<double>();
    rows_.push_back({stage_, quantity, how.unit, how.scale * ours, how.scale * reference,
                     how.scale * relative_tolerance(reference, how.fraction, how.floor), how.allowed});
  }

  std::string stage_;
  const Json &found_, &expected_;
  std::vector<Row>& rows_;
};

Table make_stage_table(const std::string& file, const Json& expected, const std::string& text, bool lift) {
  const OperationResults found = solve_operation(read_model(file).description.value());
  const Json stages = operation_summary_json(found)["operation"]["stages"];
  const std::size_t slash = file.rfind('/');
  Table table{file.substr(slash + 1, file.rfind('.') - slash - 1), found.title + text, {}};
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (!found.stages[i].lay) throw std::runtime_error(file + ": " + found.stages[i].failure->what);
    StageRows rows(found.stages[i].stage.name, stages[i], expected[i], table.rows);
    lift ? rows.add_lift() : rows.add_pull();
  }
  return table;
}

Table lift(const std::string& name, const std::string& text = "", const std::string& reference = "") {
  const std::string front = OVERBEND_SOURCE_DIR "/validation/lift_cases/" + name;
  Table table = make_stage_table(front + ".yaml", read_json_file(front + ".json")["stages"], text, true);
  table.reference = reference;
  return table;
}

Table pull(const std::string& name) {
  const std::string front = OVERBEND_SOURCE_DIR "/validation/operation_cases/" + name;
  return make_stage_table(front + ".yaml", read_json_file(front + ".expected.json")["operation"]["stages"], "", false);
}

}  // namespace

Group lifts() {
  return {
      "Lifts and tie-ins",
      "collocation of the elastica, chain of links",
      "Davit lifts and above-water tie-ins ([guide](guide/lifts.md)) stage by stage, compared with a collocation of "
      "the "
      "differential equations of the extensible elastica, confirmed by the minimum of the energy of a chain of "
      "links; CB3 is compared with the closed form of a beam on elastic wires. Planar, at rest, without friction.",
      {lift("DL8-one"), lift("DL12-three"), lift("DL20-two"),
       lift("DL20-three",
            ". The two formulations agree to 0.3 % of a moment, 0.5 % at an attachment. Of this case some differ by "
            "more here: the hogging moment at davit 2 with the end above the water by 0.46 %, and moments near an "
            "inflection, the small difference of large ones, by up to 2.2 %, none by more than 0.5 kN m, 0.04 % of "
            "the largest moment. Shorter elements change nothing; a difference in the model of the water line is "
            "likely (the reference has a sharp one on the axis, here a circular section goes under bit by bit), but "
            "not established."),
       lift("DL10-heavy-wire"), lift("CB3-wires", "", "closed form of a beam on elastic wires"), lift("TI12-mitre"),
       lift("TI12-closed")}};
}

Group pulls() {
  return {"Pulls along the seabed",
          "collocation of the elastica, chain of links",
          "Shore pulls ([guide](guide/shore-pull.md)) stage by stage, compared with a collocation of the elastica and, "
          "without "
          "common code, the balance of a chain of links; friction is fully mobilised.",
          {pull("SP12"), pull("SP16")}};
}

}  // namespace overbend::validation
