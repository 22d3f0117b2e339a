/// Order of convergence of the element.
#include <fmt/core.h>

#include <cmath>

#include "base/json.h"
#include "benchmarks.h"
#include "groups.h"
#include "rod.h"

namespace overbend::validation {
namespace {

/// Rows of a series of meshes, each half as long as the one before: ours is the order seen between the two.
Table orders(const std::string& heading, const std::string& text, const std::vector<int>& meshes,
             const std::vector<double>& errors, const std::string& quantity) {
  Table table{heading, text + "\n\n| elements | error |\n|---|---|\n", {}};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    table.text += fmt::format("| {} | {:.1e} |\n", meshes[i], errors[i]);
  }
  table.text.pop_back();
  for (std::size_t i = 1; i < meshes.size(); ++i) {
    table.rows.push_back({fmt::format("{} to {} elements", meshes[i - 1], meshes[i]), "order of " + quantity, "",
                          std::log2(errors[i - 1] / errors[i]), 4.0, 0.5,
                          "cubic shapes, second derivatives in the energy: 4 once the mesh is fine enough"});
  }
  return table;
}

Vec3 tip_of_cantilever(int elements) {
  Rod rod({1e9, 1.0, 0.0, 0.01}, equal_lengths(1.0, elements), Vec3::Zero(), Vec3::UnitX());
  rod.clamp(0);
  rod.hold_in_plane();
  const int tip = rod.nodes() - 1;
  for (int load = 1; load <= 5; ++load) {
    rod.dead[static_cast<std::size_t>(6 * tip + kRz)] = load;
    rod.settle();
  }
  return rod.position(tip);
}

Table cantilever_order() {
  const std::vector<int> meshes{4, 8, 16, 32};
  const Json row = benchmark("B01-elastica-end-force")[4];
  const Vec3 exact(1.0 - row[2].get<double>(), 0.0, row[1]);
  std::vector<double> errors;
  for (const int n : meshes) {
    errors.push_back((tip_of_cantilever(n) - exact).norm());
  }
  return orders("Cantilever with P L2/EI = 5", "Distance of the tip from that of the elastica, divided by L.", meshes,
                errors, "the tip");
}

/// A 16-inch pipe of 200 m in water, hung between two pins 160 m apart: middle of the sag.
Vec3 middle_of_sag(int elements) {
  Rod rod({2859694.1e3, 55894.9e3, 368.493, 0.2445}, equal_lengths(200.0, elements), Vec3::Zero(), Vec3::UnitX());
  rod.hold_in_plane();
  const int last = rod.nodes() - 1;
  rod.hold(0, kRx);
  rod.hold(0, kRz);
  rod.hold(last, kRz);
  rod.dead[static_cast<std::size_t>(6 * last + kRx)] = 40e3;
  rod.settle();
  return rod.position(last / 2);
}

Table suspended_pipe_order() {
  const std::vector<int> meshes{8, 16, 32, 64};
  const Vec3 fine = middle_of_sag(512);
  std::vector<double> errors;
  for (const int n : meshes) {
    errors.push_back((middle_of_sag(n) - fine).norm());
  }
  return orders("Hanging pipe",
                "200 m of the 16-inch pipe in water between two pins, tension 40 kN: distance of its midpoint from "
                "that with 512 elements [m].",
                meshes, errors, "the middle");
}

}  // namespace

Group convergence() {
  return {"Order of convergence",
          "order of the element",
          "Each mesh halves the element length of the previous one; the order is the binary logarithm of the ratio of "
          "the errors.",
          {cantilever_order(), suspended_pipe_order()}};
}

}  // namespace overbend::validation
