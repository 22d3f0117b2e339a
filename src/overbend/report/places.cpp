#include "report/places.h"

#include <algorithm>
#include <cmath>

#include "results/regions.h"

namespace overbend {
namespace {

double mix(double a, double b, double t) {
  return (1.0 - t) * a + t * b;
}

}  // namespace

Vec3 ship_point(const StaticResults& results, const Vec3& p_W) {
  const Vec3 d = p_W - results.stern_shoe_W;
  Vec3 astern = -results.R_WV.col(0);
  astern.z() = 0.0;
  astern.normalize();
  const Vec3 port = astern.cross(Vec3::UnitZ());
  return {d.dot(astern), d.dot(port), p_W.z()};
}

Station station_at(const StaticResults& results, double s) {
  const std::vector<Station>& all = results.stations;
  const auto above = std::lower_bound(all.begin(), all.end(), s, [](const Station& a, double at) { return a.s < at; });
  if (above == all.begin()) {
    return all.front();
  }
  if (above == all.end()) {
    return all.back();
  }
  const Station& a = *(above - 1);
  const Station& b = *above;
  const double t = b.s > a.s ? (s - a.s) / (b.s - a.s) : 0.0;
  Station at = t < 0.5 ? a : b;
  at.s = s;
  at.p_W = (1.0 - t) * a.p_W + t * b.p_W;
  for (double Station::*member :
       {&Station::astern, &Station::inclination, &Station::effective_tension, &Station::wall_tension,
        &Station::bending_moment, &Station::vertical_moment, &Station::lateral_moment, &Station::curvature,
        &Station::axial_stress, &Station::bending_stress, &Station::hoop_stress, &Station::von_mises, &Station::strain,
        &Station::seabed_reaction, &Station::penetration}) {
    at.*member = mix(a.*member, b.*member, t);
  }
  return at;
}

double from_tensioner(const StaticResults& results, double s) {
  return results.stations.back().s - s;
}

double yield_percent(const StaticResults& results, double s, double stress) {
  const double yield = station_at(results, s).yield_stress;
  return yield > 0.0 ? 100.0 * stress / yield : 0.0;
}

std::string place_name(const StaticResults& results, double s) {
  constexpr double kSlack = 0.5;  // an extreme just off the end of a box is still that box's [m]
  for (const SupportResult& box : results.supports) {
    if (std::abs(s - box.s) <= 0.5 * box.length + kSlack) {
      return box.name;
    }
  }
  const SupportResult* before = nullptr;  // towards the tensioner
  const SupportResult* behind = nullptr;
  for (const SupportResult& box : results.supports) {
    if (box.s > s && (before == nullptr || box.s < before->s)) {
      before = &box;
    }
    if (box.s < s && (behind == nullptr || box.s > behind->s)) {
      behind = &box;
    }
  }
  if (before != nullptr && behind != nullptr) {
    return before->name + " to " + behind->name;
  }
  if (s <= results.touchdown.s) {
    return "seabed";
  }
  if (behind != nullptr || s >= results.stations.back().s) {
    return "tensioner";
  }
  if (regions(results).of(s) == Region::tower) {
    return "tower";
  }
  return before != nullptr && before->s - s < 10.0 ? "below " + before->name : "sagbend";
}

}  // namespace overbend
