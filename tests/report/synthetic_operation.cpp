#include "report/synthetic_operation.h"

#include <cmath>

#include "report/bgl1_results.h"
#include "results/fields/location_names.h"

namespace overbend::testing {
namespace {

constexpr double kBreakingLoad = 900e3;

/// The line hangs flatter by `factor` behind the stinger.
void stretch(StaticResults& lay, double factor) {
  const Vec3 astern = -lay.R_WV.col(0);
  const double tip = ship_point(lay, lay.supports.back().p_W).x();
  const auto moved = [&](double x) { return x > tip ? (factor - 1.0) * (x - tip) : 0.0; };
  for (Station& station : lay.stations) {
    const double by = moved(station.astern);
    station.p_W += by * astern;
    station.astern += by;
  }
  const double by = moved(lay.touchdown.astern);
  lay.touchdown.p_W += by * astern;
  lay.touchdown.astern += by;
  lay.lay_back += by;
}

HeadResult head_at(const StaticResults& lay, double s) {
  const Station station = station_at(lay, s);
  HeadResult head;
  head.p_W = station.p_W;
  head.astern = ship_point(lay, station.p_W).x();
  head.inclination = station.inclination;
  head.cable_inclination = station.inclination + 0.02;
  head.tension = station.effective_tension;
  head.clearance = station.p_W.z() - 0.5 * lay.pipe_outer_diameter + lay.water_depth;
  head.s = s;
  return head;
}

StageResult make_stage(double cable_out, double share) {
  StageResult stage;
  stage.stage.cable_out = cable_out;
  stage.lay = bgl1().results;
  StaticResults& lay = *stage.lay;
  stretch(lay, 1.0 + 0.3 * share);
  lay.top_tension *= 1.0 - 0.25 * share;
  lay.bottom_tension *= 1.0 - 0.25 * share;
  lay.sagbend.von_mises.value *= 1.0 + 0.3 * share;
  lay.sagbend.strain.value *= 1.0 + 0.3 * share;
  *lay.stinger_tip_clearance += 0.4 * share;
  stage.stage.tension = lay.top_tension;
  lay.head = head_at(lay, lay.total_length - cable_out);
  lay.cable = CableResult{cable_out, lay.top_tension, lay.top_tension / kBreakingLoad, 0.04};
  stage.barge_ahead = 40.0 * share;
  return stage;
}

}  // namespace

OperationResults synthetic_abandonment() {
  OperationResults results;
  results.title = "BGL-1, abandonment of the pipe";
  results.version = "1.0";
  results.assumptions = {{AssumptionRank::other, "the cable has no bending stiffness"}};
  for (const double out : {40.0, 75.0, 110.0, 160.0, 260.0}) {
    results.stages.push_back(make_stage(out, (out - 40.0) / 220.0));
  }
  StageResult& failed = results.stages.emplace_back();
  failed.stage.cable_out = 300.0;
  failed.stage.tension = 20e3;
  failed.failure = StageFailure{"no equilibrium", "at the winch", "the tension is below the suspended weight", 61.5e3};
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    results.stages[i].stage.name = "stage " + std::to_string(i + 1);
  }
  results.stages[1].stage.name = "head on the stinger";
  results.stages[3].governing = "strain of the sagbend";
  return results;
}

OperationResults synthetic_start_up() {
  OperationResults results = synthetic_abandonment();
  results.type = OperationType::start_up;
  for (StageResult& stage : results.stages) {
    stage.stage.pipe_out = stage.stage.cable_out;
    stage.stage.cable_out.reset();
    if (stage.lay) stage.lay->far_anchor = StartUpAnchorResult{420.0, 180e3, 2e3};
  }
  return results;
}

std::string abandonment_text() {
  return bgl1().model_text + R"(
operation:
  type: abandonment
  head: {length: 6 m, weight_in_air: 40 kN, weight_submerged: 33 kN}
  cable: {diameter: 76 mm, weight_in_air: 240 N/m, weight_submerged: 205 N/m, axial_stiffness: 2.7e5 kN, breaking_load: 900 kN}
  stages:
    - {cable_out: 40 m, tension: 260 kN}
    - {name: head on the stinger, cable_out: 75 m, tension: 250 kN}
    - {cable_out: 110 m, tension: 240 kN}
    - {cable_out: 160 m, tension: 220 kN}
    - {cable_out: 260 m, tension: 200 kN}
    - {cable_out: 300 m, tension: 20 kN}
)";
}

}  // namespace overbend::testing
