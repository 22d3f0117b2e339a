/// J-lays of given horizontal tension.
#include <fmt/core.h>

#include <cmath>

#include "base/constants.h"
#include "groups.h"
#include "lay.h"

namespace overbend::validation {
namespace {

/// The lay whose tension on the bed is `H`: the top tension is sought by secants.
Lay lay_with_bottom_tension(const Model& model, double H, double guess) {
  const auto sample = [&](double tension) {
    Model m = model;
    m.description.tensioner.tension = tension;
    return m;
  };
  double a = guess, fa = Lay(sample(a)).solution().state.far_force - H;
  double b = guess - fa, fb = Lay(sample(b)).solution().state.far_force - H;
  for (int i = 0; i < 10 && std::abs(fb) > 1e-6 * H; ++i) {
    const double next = b - fb * (b - a) / (fb - fa);
    a = b;
    fa = fb;
    b = next;
    fb = Lay(sample(b)).solution().state.far_force - H;
  }
  return Lay(sample(b));
}

Description bare_jlay(double diameter, double wall, double density) {
  Description d = case_description("J12-D400-T560");
  d.pipe.section.coatings.clear();
  d.pipe.section.steel.outside_diameter = diameter;
  d.pipe.section.steel.wall_thickness = wall;
  d.pipe.section.steel.weight_density = density;
  return d;
}

/// Only values on which catenary and rod agree are compared with the catenary: bending changes the others.
Table deep_water() {
  Description d = bare_jlay(0.3239, 0.0191, 7850.0 * kGravity);
  d.title = "1000 m";
  d.environment.water_depth = 1000.0;
  d.environment.water_weight_density = 1025.0 * kGravity;
  d.environment.seabed.stiffness = 100e3;
  d.tensioner.z = 0.0;
  Model model = build_model(d);
  model.sections.front().poissons_ratio = 0.5;  // the reference stretches by T/EA alone
  const Lay lay = lay_with_bottom_tension(model, 200e3, 779.6e3);
  const StaticResults& r = lay.results();
  const DerivedSection& s = r.sections.front();
  const Station top = lay.station_at(0.0);
  const std::string name = "1000 m, H = 200 kN", solver = "planar beam solver";
  const double w = s.weight_submerged, h = 1000.0 - 0.5 * 0.3239;
  return {"Deep water",
          "323.9 x 19.1 mm, empty, steel 7850 kg/m3, water 1025 kg/m3, bed 100 kN/m2, top pinned at the surface; the "
          "top tension is adjusted to give a bottom tension of 200 kN.",
          {{name, "submerged weight", "kN/m", 1e-3 * w, 0.579714, 1e-6, "arithmetic"},
           {name, "tension at the top", "kN", 1e-3 * top.effective_tension, 779.62, 0.78,
            "catenary T = H + w h, which also holds for the rod; 0.1 %"},
           {name, "tension at the top, with our weight", "kN", 1e-3 * top.effective_tension, 200.0 + 1e-3 * w * h, 0.78,
            "catenary T = H + w h; 0.1 %"},
           {name, "angle at the top", "deg", top.inclination * 180.0 / kPi, 75.051, 0.05, solver + "; 0.05 deg"},
           {name, "largest moment", "kN m", 1e-3 * r.sagbend.bending_moment.value, 123.28, 0.003 * 123.28,
            solver + "; 0.3 %"},
           {name, "place of the largest moment, z", "m", r.sagbend.bending_moment.p_W.z(), -995.77, 0.5,
            solver + "; flat maximum"},
           {name, "top to touchdown, unstressed", "m", r.length_top_to_touchdown, 1308.0, 0.25,
            solver + "; its nodes there are 0.5 m apart"},
           {name, "top to touchdown, horizontal", "m", r.top_to_touchdown, 711.26, 0.25,
            solver + "; its nodes there are 0.5 m apart"}}};
}

/// The case of a rigid bed and no stretch, ten metres deeper so that no part of the pipe is at the surface.
Table rigid_bed() {
  Description d = case_description("J12-D400-T560");
  constexpr double kDeeper = 10.0;
  d.title = "rigid";
  d.environment.water_depth = 150.0 + kDeeper + 0.16515;
  d.environment.seabed.stiffness = 1e9;
  d.tensioner.z = -kDeeper;
  d.mesh.touchdown_element = 0.1;
  Model model = build_model(d);
  model.sections.front().EA = 1e11;
  model.sections.front().poissons_ratio = 0.5;  // pressure does not lengthen the pipe
  const Lay lay = lay_with_bottom_tension(model, 80e3, 182.14e3);
  const StaticResults& r = lay.results();
  const Station top = lay.station_at(0.0);
  const double soil = std::pow(4.0 * r.sections.front().EI / d.environment.seabed.stiffness, 0.25);
  const std::string name = "J12-D150-H80-rigid-inext", basis = "elastica";
  return {
      "Rigid bed, no stretch",
      fmt::format(
          "In the reference the seabed is rigid and the pipe inextensible; touchdown is where the bending moment "
          "vanishes. Ours: seabed 1e6 kN/m2 and EA 1e8 kN. On a spring the first contact is one soil length (4 "
          "EI/k)^(1/4) = {:.3f} m before that point: there w = C e^(-x/l) sin(x/l),\nso that M(0) = -l M'(0) "
          "and the moment extrapolates to zero at x = l. The value compared is first contact plus l.",
          soil),
      {{name, "tension at the top", "kN", 1e-3 * top.effective_tension, 182.136761384, 0.182, basis + ", 0.1 %"},
       {name, "angle at the top", "deg", top.inclination * 180.0 / kPi, 62.2212106776, 0.05, basis + ", 0.05 deg"},
       {name, "vertical force at the top", "kN", 1e-3 * r.top_reaction.z(), 163.720198757, 0.164, basis + ", 0.1 %"},
       {name, "top to touchdown, unstressed", "m", r.length_top_to_touchdown + soil, 264.112460732, 0.1,
        basis + ", 0.10 m"},
       {name, "top to touchdown, horizontal", "m", r.top_to_touchdown + soil, 197.361891125, 0.1, basis + ", 0.10 m"},
       {name, "largest moment", "kN m", 1e-3 * r.sagbend.bending_moment.value, 319.995202146, 0.96, basis + ", 0.3 %"},
       {name, "largest bending stress", "MPa", 1e-6 * r.sagbend.bending_stress.value, 228.550018108, 0.69,
        basis + ", 0.3 %"}}};
}

}  // namespace

Group jlays() {
  return {"J-lay at a given bottom tension", "independent beam solver", "", {deep_water(), rigid_bed()}};
}

}  // namespace overbend::validation
