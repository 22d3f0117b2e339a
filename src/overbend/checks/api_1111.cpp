#include "checks/api_1111.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {

double api_yield_pressure(const ApiPipe& pipe) {
  return 2.0 * pipe.yield_stress * pipe.wall / pipe.diameter;
}

double api_elastic_pressure(const ApiPipe& pipe) {
  const double ratio = pipe.wall / pipe.diameter;
  return 2.0 * pipe.youngs_modulus * ratio * ratio * ratio / (1.0 - pipe.poissons_ratio * pipe.poissons_ratio);
}

double api_collapse_pressure(const ApiPipe& pipe) {
  const double yielding = api_yield_pressure(pipe), elastic = api_elastic_pressure(pipe);
  return yielding * elastic / std::hypot(yielding, elastic);
}

double api_buckling_strain(const ApiPipe& pipe) {
  return pipe.wall / (2.0 * pipe.diameter);
}

double api_ovality_factor(double delta) {
  return 1.0 / (1.0 + 20.0 * delta);
}

double api_bending_utilisation(const ApiPipe& pipe, double strain, double overpressure, double collapse_factor,
                               double delta) {
  const double pressure = std::max(overpressure, 0.0) / (collapse_factor * api_collapse_pressure(pipe));
  return (strain / api_buckling_strain(pipe) + pressure) / api_ovality_factor(delta);
}

double api_propagation_pressure(const ApiPipe& pipe) {
  return 24.0 * pipe.yield_stress * std::pow(pipe.wall / pipe.diameter, 2.4);
}

double api_yield_tension(const ApiPipe& pipe) {
  return pipe.yield_stress * std::numbers::pi * (pipe.diameter - pipe.wall) * pipe.wall;
}

double api_burst_pressure(const ApiPipe& pipe, double tensile_strength) {
  return 0.45 * (pipe.yield_stress + tensile_strength) * std::log(pipe.diameter / (pipe.diameter - 2.0 * pipe.wall));
}

double api_combined_load(const ApiPipe& pipe, double tensile_strength, double overpressure, double tension) {
  return std::hypot(overpressure / api_burst_pressure(pipe, tensile_strength), tension / api_yield_tension(pipe));
}

}  // namespace overbend
