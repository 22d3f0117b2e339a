/// Cantilevers with an end force and with an end moment.
#include <fmt/core.h>

#include <cmath>

#include "base/constants.h"
#include "base/json.h"
#include "benchmarks.h"
#include "groups.h"
#include "rod.h"

namespace overbend::validation {
namespace {

constexpr RodPipe kUnitRod{1e10, 1.0, 0.0, 0.01};  ///< EA L2/EI = 1e10 for a length of 1 m: stretches by 1e-9.

/// A cantilever that stands askew in space, so that no direction is special.
struct Askew {
  Vec3 along = Vec3(2.0, 3.0, 6.0) / 7.0;
  Vec3 across = Vec3(6.0, 2.0, -3.0) / 7.0;
};

Rod cantilever(int elements, const Vec3& along) {
  Rod rod(kUnitRod, equal_lengths(1.0, elements), Vec3(3.0, -2.0, 1.0), along);
  rod.clamp(0);
  return rod;
}

Table end_force() {
  Table table{
      "Cantilever with a dead end force",
      "The elastica of Mattiasson (1981): EA L2/EI = 1e10, 32 elements, the rod at a general orientation in space.",
      {}};
  const std::string basis = "elliptic integrals; 1e-4 L asked";
  const Askew axes;
  Rod rod = cantilever(32, axes.along);
  const int tip = rod.nodes() - 1;
  for (const auto& row : benchmark("B01-elastica-end-force")) {
    const double load = row[0];
    for (int i = 0; i < 3; ++i) {
      rod.dead[static_cast<std::size_t>(6 * tip + i)] = load * axes.across(i);
    }
    rod.settle();
    const Vec3 moved = rod.position(tip) - rod.position(0);
    const Vec3 t = rod.tangent(tip);
    const std::string name = fmt::format("P L2/EI = {:g}", load);
    table.rows.push_back({name, "w/L", "", moved.dot(axes.across), row[1], 1e-4, basis});
    table.rows.push_back({name, "u/L", "", 1.0 - moved.dot(axes.along), row[2], 1e-4, basis});
    table.rows.push_back(
        {name, "tip angle", "rad", std::atan2(t.dot(axes.across), t.dot(axes.along)), row[3], 1e-4, basis});
    table.rows.push_back({name, "clamp moment L/EI", "", rod.moment_at(0).norm(), load * (1.0 - row[2].get<double>()),
                          1e-4 * load, "balance: P (L - u)"});
  }
  return table;
}

Table roll_up() {
  Table table{"Roll-up of a cantilever by an end moment",
              "The moment acts on the rotation of the last tangent; 64 elements, so that each element rotates by 0.2 "
              "rad when the rod is rolled up twice. The rod is held in its plane: under a moment about a fixed axis a "
              "rod without torsion also has equilibria out of the plane.",
              {},
              "closed form"};
  Rod rod = cantilever(64, Vec3::UnitX());
  const int tip = rod.nodes() - 1;
  const Vec3 axis = -Vec3::UnitY();
  rod.hold_in_plane();
  double angle = 0.0;
  for (const auto& row : benchmark("B02-end-moment-rollup")) {
    const double wanted = 2.0 * kPi * row[0].get<double>();
    while (angle < wanted - 1e-12) {
      angle = std::min(wanted, angle + kPi / 16.0);
      rod.end_moment = angle * axis;
      rod.settle();
    }
    double turned = 0.0;
    for (int node = 0; node < tip; ++node) {
      const Vec3 a = rod.tangent(node), b = rod.tangent(node + 1);
      turned += std::atan2(a.cross(b).dot(axis), a.dot(b));
    }
    const Vec3 moved = rod.position(tip) - rod.position(0);
    const std::string name = fmt::format("M L/(2 pi EI) = {:g}", row[0].get<double>());
    const std::string basis = "closed form; 0.2 rad to the fourth is 1.6e-3, over 720";
    table.rows.push_back({name, "x/L", "", moved.x(), row[1], 1e-5, basis});
    table.rows.push_back({name, "z/L", "", moved.z(), row[2], 1e-5, basis});
    table.rows.push_back({name, "tip angle", "rad", turned, row[3], 1e-5 * wanted, basis});
  }
  return table;
}

}  // namespace

Group cantilevers() {
  return {"Large bending",
          "elliptic integrals",
          "Single rods using the element kernel and the block solver, with their own boundary conditions and loads and "
          "a plain Newton iteration.\n\nNot compared: the 45-degree bend of Bathe and Bolourchi (1979). Its rod is "
          "initially curved and responds in torsion as well as in bending; the torsion-free element has neither "
          "initial curvature nor torsional stiffness and represents straight rods under loads that cause no torsion "
          "(Meier, Popp and Wall, 2015), such as pipes during laying.",
          {end_force(), roll_up()}};
}

}  // namespace overbend::validation
