/// Motions with a closed form or a computed reference.
#include <fmt/core.h>

#include <numbers>

#include "base/json.h"
#include "benchmarks.h"
#include "groups.h"
#include "mechanics/restitution.h"
#include "support/dynamic_benchmarks.h"

namespace overbend::validation {
namespace {

Table frequencies() {
  const Json expected = benchmark("B06-tensioned-beam-frequencies");
  Table table{
      "Vibration of a tensioned beam",
      "16-inch pipe of 0.8 t/m over 60 m under 250 kN, 40 elements. Frequencies from the element's stiffness and mass, "
      "and from the record of the middle of the pinned beam, released in its first mode shape, in steps of 0.02 s.",
      {}};
  for (const bool clamped : {false, true}) {
    const Json& exact = expected[clamped ? "clamped_clamped_Hz" : "pinned_pinned_Hz"];
    const std::vector<double> ours = testing::beam_frequencies(clamped, 40);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const double f = exact[i];
      table.rows.push_back({clamped ? "clamped" : "pinned", fmt::format("frequency {}", i + 1), "Hz", ours[i], f,
                            relative_tolerance(f, 2e-3), "closed form; 0.2 %"});
    }
  }
  const double first = expected["pinned_pinned_Hz"][0];
  table.rows.push_back({"pinned, from time history", "frequency 1", "Hz", testing::first_frequency_in_time(40, 0.02),
                        first, relative_tolerance(first, 2e-3), "closed form; 0.2 %"});
  return table;
}

Table rotations() {
  Table table{"Beam spun up, pendulums",
              "Spin-up to 6 rad/s in 15 s (10 elements, steps of 5 ms): extension of the end, mean over one turn. "
              "Stiff bar released at an angle (one element, steps of 1/400 of the period). Flexible pendulum released "
              "horizontally (20 elements, steps of 2.5 ms).",
              {}};
  const double extension = benchmark("B07a-spin-up-steady-stretch")["tip_extension"];
  table.rows.push_back({"spin-up", "extension", "mm", 1e3 * testing::spin_up_extension(10, 0.005), 1e3 * extension,
                        1e-3, "tan(kL)/k - L; 1e-6 m"});
  for (const auto& row : benchmark("B07b-stiff-bar-pendulum")) {
    const double degrees = row[0], period = row[1];
    table.rows.push_back({fmt::format("bar from {:g} deg", degrees), "period", "s",
                          testing::bar_pendulum_period(degrees * std::numbers::pi / 180.0, period), period,
                          relative_tolerance(period, 1e-3), "elliptic integral; 0.1 %"});
  }
  const Json flexible = benchmark("B07d-flexible-pendulum");
  const std::vector<Vec3> tip = testing::flexible_pendulum_tip(20, 0.0025);
  for (std::size_t i = 0; i < tip.size(); ++i) {
    const double t = flexible["t"][i];
    const double allowed = t <= 1.0 ? 2e-3 : 5e-3;
    const std::string basis = fmt::format("computed reference; {:g} mm", 1e3 * allowed);
    const std::string name = fmt::format("flexible pendulum, {:g} s", t);
    table.rows.push_back({name, "x of the tip", "m", tip[i].x(), flexible["tip_x_z"][i][0], allowed, basis});
    table.rows.push_back({name, "z of the tip", "m", tip[i].z(), flexible["tip_x_z"][i][1], allowed, basis});
  }
  return table;
}

Table impacts() {
  Table table{"Impact on a roller",
              "A mass of 0.5 t hits a roller of 5e4 kN/m at 1 m/s, without gravity; steps of 10 us, a thousandth of "
              "the contact time. First rows: damping by the textbook formula on a roller without tension; the rebound "
              "is faster than specified. Last rows: damping for such a roller (restitution as in the model file).",
              {}};
  constexpr double kStep = 1e-5;
  const auto add = [&](const std::string& name, const char* what, const char* unit, double ours, double reference) {
    table.rows.push_back(
        {name, what, unit, ours, reference, relative_tolerance(reference, 5e-3), "closed form; 0.5 %"});
  };
  const Json rows = benchmark("B11-impact-restitution");
  for (const auto& row : rows) {
    const testing::RollerImpact impact = testing::roller_impact(1e3 * row[2].get<double>(), kStep);
    const std::string name = fmt::format("textbook, e = {:g}", row[0].get<double>());
    add(name, "rebound", "m/s", impact.rebound, -row[6].get<double>());
    add(name, "contact time", "ms", 1e3 * impact.duration, 1e3 * row[5].get<double>());
    add(name, "largest penetration", "mm", 1e3 * impact.penetration, 1e3 * row[7].get<double>());
    add(name, "largest force", "kN", 1e-3 * impact.force, row[8]);
  }
  for (const auto& row : rows) {
    const double e = row[0];
    const double ratio = damping_ratio(e, RestitutionForm::clipped);
    const double c = 2.0 * ratio * std::sqrt(5e7 * 500.0);
    table.rows.push_back({fmt::format("no tension, e = {:g}", e), "rebound", "m/s",
                          testing::roller_impact(c, kStep).rebound, e, relative_tolerance(e, 5e-3, 1e-3),
                          "as specified; 0.5 %, 0.001 m/s"});
  }
  return table;
}

Table sinking() {
  const Json expected = benchmark("B16-falling-horizontal-pipe");
  Table table{"Horizontal pipe sinking from rest", "Drag, added mass and submerged weight; steps of 0.01 s.", {}};
  const testing::SinkingPipe ours = testing::sinking_pipe(0.01);
  const auto add = [&](const char* what, const char* unit, double value, double reference) {
    table.rows.push_back(
        {"16-inch pipe", what, unit, value, reference, relative_tolerance(reference, 2e-3), "tanh law; 0.2 %"});
  };
  add("speed after 1 s", "m/s", ours.speed_1s, expected["v_after_1s"]);
  add("speed after 5 s", "m/s", ours.speed_5s, expected["v_after_5s"]);
  add("distance after 5 s", "m", ours.drop_5s, expected["drop_after_5s"]);
  return table;
}

}  // namespace

Group dynamic() {
  return {
      "Dynamic analysis",
      "closed form",
      "Time integration with the element's inertia, water and rollers, on problems with a single effect each; spectral "
      "radius 0.8 unless a\nfrequency is measured.",
      {frequencies(), rotations(), impacts(), sinking()}};
}

}  // namespace overbend::validation
