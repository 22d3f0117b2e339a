/// Beams of small slope: on an elastic foundation, tied, on a support that sinks.
#include <fmt/core.h>

#include <cmath>

#include "base/json.h"
#include "benchmarks.h"
#include "groups.h"
#include "rod.h"

namespace overbend::validation {
namespace {

constexpr double kEI = 55894.90e3;      ///< Bending stiffness of the 16-inch pipe [N m2].
constexpr double kEA = 2859694.1e3;     ///< [N]
constexpr double kWeight = 2.255935e3;  ///< [N/m]

/// Half-infinite either way for the load at the middle; the bed holds only upwards, so a weight presses the beam in.
class WinklerBeam {
 public:
  WinklerBeam(double EI, double k, double N)
      : preload_(0.05 * k), k_(k), middle_(kHalf), rod_(pipe(EI), lengths(EI, k), Vec3(0.0, 0.0, 0.0), Vec3::UnitX()) {
    rod_.surrounds.bed_stiffness = k;
    rod_.surrounds.bed_offset = -kRadius + preload_ / k;  // in balance where it stands
    rod_.hold_in_plane();
    rod_.hold(0, kRx);
    rod_.dead[static_cast<std::size_t>(6 * (rod_.nodes() - 1) + kRx)] = N;
    rod_.settle();
    level_ = rod_.position(middle_).z();
  }

  void load(double P) {
    rod_.dead[static_cast<std::size_t>(6 * middle_ + kRz)] = -P;
    rod_.settle();
  }
  double deflection() const { return level_ - rod_.position(middle_).z(); }
  double moment() const { return -rod_.moment_at(middle_).y(); }

 private:
  static constexpr double kRadius = 0.2;
  static constexpr int kHalf = 60;
  RodPipe pipe(double EI) const { return {kEA, EI, preload_, kRadius}; }
  /// A fifth of the soil length 1/lambda each, as the benchmark's tolerance is stated for: 12 soil lengths either way.
  static std::vector<double> lengths(double EI, double k) {
    return equal_lengths(2.0 * kHalf * 0.2 / std::pow(k / (4.0 * EI), 0.25), 2 * kHalf);
  }

  double preload_, k_, level_ = 0.0;
  int middle_;
  Rod rod_;
};

Table winkler() {
  Table table{
      "Beam on an elastic foundation, point load",
      "A long beam on the seabed spring, loaded at its middle. The seabed has no tension; a weight that presses the "
      "beam in by 50 mm keeps it in contact everywhere, and the deflection is measured from there, so that the spring "
      "acts in both directions as in the reference. The element length is a fifth of the soil length.",
      {},
      "Hetenyi (1946)"};
  for (const auto& row : benchmark("B09-infinite-beam-on-winkler-point-load")) {
    const double EI = 1e3 * row[0].get<double>(), k = 1e3 * row[1].get<double>(), N = 1e3 * row[2].get<double>();
    WinklerBeam beam(EI, k, N);
    beam.load(1e3 * row[3].get<double>());
    const std::string name =
        fmt::format("EI {:g} kN m2, k {:g} kN/m2, N {:g} kN", row[0].get<double>(), row[1].get<double>(), 1e-3 * N);
    const double w = 1e3 * row[4].get<double>(), M = row[5];
    table.rows.push_back(
        {name, "deflection", "mm", 1e3 * beam.deflection(), w, relative_tolerance(w, 2e-3), "Hetenyi (1946); 0.2 %"});
    table.rows.push_back(
        {name, "moment", "kN m", 1e-3 * beam.moment(), M, relative_tolerance(M, 2e-3), "Hetenyi (1946); 0.2 %"});
  }
  return table;
}

/// A span of 24 elements with its own weight under a pull.
Rod tie_beam(double length, double tension, bool clamped) {
  Rod rod({kEA, kEI, kWeight, 0.2}, equal_lengths(length, 24), Vec3::Zero(), Vec3::UnitX());
  const int last = rod.nodes() - 1;
  rod.hold_in_plane();
  rod.hold(0, kRx);
  for (const int end : {0, last}) {
    rod.hold(end, kRz);
    if (clamped) {
      rod.hold(end, kTz);
    }
  }
  rod.dead[static_cast<std::size_t>(6 * last + kRx)] = tension;
  rod.settle();
  return rod;
}

Table tie_beams() {
  Table table{"Span under its own weight and tension", "16-inch pipe, 2.256 kN/m, 24 elements.", {}, "Timoshenko"};
  for (const auto& row : benchmark("B13-tie-beam-span")) {
    const double T = row[0], L = row[1], pinned = row[2], clamped = row[3];
    const std::string name = fmt::format("T {:g} kN, L {:g} m", T, L);
    const char* basis = "beam-column theory (Timoshenko); 0.2 %";
    const Rod free_ends = tie_beam(L, 1e3 * T, false), fixed_ends = tie_beam(L, 1e3 * T, true);
    table.rows.push_back({name, "midspan moment, pinned", "kN m", 1e-3 * free_ends.moment_at(12).norm(), pinned,
                          relative_tolerance(pinned, 2e-3), basis});
    table.rows.push_back({name, "end moment, clamped", "kN m", 1e-3 * fixed_ends.moment_at(0).norm(), clamped,
                          relative_tolerance(clamped, 2e-3), basis});
  }
  return table;
}

/// Two spans of 10 m; the middle roller stands `settlement` below the ends.
Rod two_spans(double settlement) {
  const RodPipe pipe{kEA, kEI, kWeight, 0.2};
  Rod rod(pipe, equal_lengths(20.0, 40), Vec3::Zero(), Vec3::UnitX());
  const int last = rod.nodes() - 1;
  rod.hold_in_plane();
  rod.hold(0, kRx);
  rod.hold(0, kRz);
  rod.hold(last, kRz);
  PlacedRoller roller;
  roller.radius = 0.1;
  roller.center = Vec3(10.0, 0.0, -settlement - pipe.radius - roller.radius);
  roller.axis = Vec3::UnitY();
  roller.normal = Vec3::UnitZ();
  roller.half_face = 1.0;
  roller.stiffness = 1e11;
  rod.rollers = {roller};
  rod.settle();
  return rod;
}

Table lift_off() {
  const Json expected = benchmark("B14-two-span-middle-support-lift-off");
  Table table{"Two spans with settlement of the middle roller",
              "Spans of 10 m, no tension; the roller is a contact of 1e8 kN/m, the ends are pinned and free to slide.",
              {}};
  const char* basis = "beam theory; 0.2 %";
  const auto add = [&](const char* name, const char* what, const char* unit, double ours, double reference) {
    table.rows.push_back({name, what, unit, ours, reference, relative_tolerance(reference, 2e-3), basis});
  };
  const Json& level = expected["level"];
  Rod rod = two_spans(0.0);
  add("level", "end reaction", "kN", 1e-3 * rod.reaction(0).z(), level["R_end"]);
  add("level", "middle reaction", "kN", 1e-3 * rod.roller_force(0), level["R_mid"]);
  add("level", "middle moment", "kN m", -1e-3 * rod.moment_at_roller(0).norm(), level["M_mid"]);
  const double d0 = expected["settlement_for_zero_mid_reaction_m"];
  add("half the settlement", "middle reaction", "kN", 1e-3 * two_spans(0.5 * d0).roller_force(0),
      expected["at_half_that_settlement"]["R_mid"]);
  const Rod clear = two_spans(2.0 * d0);
  add("twice the settlement", "gap", "mm", 1e3 * clear.roller_gap(0),
      1e3 * expected["at_twice"]["gap_mid"].get<double>());
  // Settlement without reaction: between two settlements on its straight line.
  const double a = 0.90 * d0, b = 0.95 * d0;
  const double ra = two_spans(a).roller_force(0), rb = two_spans(b).roller_force(0);
  add("lift-off", "settlement", "mm", 1e3 * (a + (b - a) * ra / (ra - rb)), 1e3 * d0);
  return table;
}

}  // namespace

Group beams() {
  return {"Beams of small slope",
          "beam theory",
          "Cases for which small-slope theory is exact to the digits compared.",
          {winkler(), tie_beams(), lift_off()}};
}

}  // namespace overbend::validation
