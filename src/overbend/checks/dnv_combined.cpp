#include "checks/dnv_combined.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "checks/dnv_strength.h"

namespace overbend {

double slenderness_factor(double slenderness) {
  if (slenderness < 15.0) return 0.5;
  return slenderness > 60.0 ? 0.0 : (60.0 - slenderness) / 90.0;
}

double flow_stress_factor(double slenderness, double fy, double fu) {
  const double beta = slenderness_factor(slenderness);
  return 1.0 - beta + beta * fu / fy;
}

double plastic_axial_force(const Wall& wall, double fy) {
  return fy * std::numbers::pi * (wall.diameter - wall.thickness) * wall.thickness;
}

double plastic_moment(const Wall& wall, double fy) {
  const double mean = wall.diameter - wall.thickness;
  return fy * mean * mean * wall.thickness;
}

double point_load_factor(const Wall& wall, double fy, double roller_force) {
  const double yielding = 3.9 * fy * wall.thickness * wall.thickness;
  return std::max(0.05, 1.0 - wall.slenderness() / 130.0 * roller_force / yielding);
}

LoadCapacity load_capacity(const Wall& wall, double fy, double fu, double collapse, double factor) {
  LoadCapacity capacity;
  capacity.alpha_c = flow_stress_factor(wall.slenderness(), fy, fu);
  capacity.beta = slenderness_factor(wall.slenderness());
  capacity.moment_factor = factor / (capacity.alpha_c * plastic_moment(wall, fy));
  capacity.tension_factor = factor / (capacity.alpha_c * plastic_axial_force(wall, fy));
  capacity.collapse_factor = factor / collapse;
  capacity.burst = burst_pressure(wall, burst_strength(fy, fu));
  capacity.axial_limit = 0.4 * plastic_axial_force(wall, fy);
  capacity.slender_enough = wall.slenderness() >= 15.0 && wall.slenderness() <= 45.0;
  capacity.known = true;
  return capacity;
}

LoadTerms load_terms(const LoadCapacity& capacity, double moment, double force, double external, double internal,
                     double plastic_share) {
  LoadTerms terms;
  terms.moment = capacity.moment_factor * moment / plastic_share;
  terms.axial = capacity.tension_factor * force;
  if (external >= internal) {
    const double share = capacity.collapse_factor * (external - internal);
    terms.pressure = share * share;
    return terms;
  }
  const double ratio = (internal - external) / capacity.burst;
  const double share = burst_share_factor(capacity.beta, ratio) * ratio / capacity.alpha_c;
  terms.pressure = share * share;
  return terms;
}

double burst_share_factor(double beta, double ratio) {
  return ratio < 2.0 / 3.0 ? 1.0 - beta : 1.0 - 3.0 * beta * std::max(0.0, 1.0 - ratio);
}

double load_reserve(const LoadTerms& terms) {
  if (terms.pressure >= 1.0) return 0.0;
  const double bracket = std::sqrt(1.0 - terms.pressure);  // lambda m + lambda^2 q = bracket
  const double q = terms.axial * terms.axial;
  const double below = terms.moment + std::sqrt(terms.moment * terms.moment + 4.0 * q * bracket);
  return below > 0.0 ? std::min(2.0 * bracket / below, kMaxReserve) : kMaxReserve;
}

}  // namespace overbend
