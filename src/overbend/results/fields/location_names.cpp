#include "results/fields/location_names.h"

#include <algorithm>
#include <cmath>

#include "results/fields/static_tables.h"
#include "results/regions.h"
#include "results/verdict.h"

namespace overbend {
namespace {

/// Collects the addresses of the numbers of a station.
struct StationNumbers {
  std::vector<double*> numbers;
  void operator()(const ResultField&, double& value) { numbers.push_back(&value); }
  void operator()(const ResultField&, Vec3& value) {
    for (double& number : value) numbers.push_back(&number);
  }
  void operator()(const ResultField&, Region&) {}
};

std::vector<double*> station_numbers(Station& station) {
  StationNumbers visit;
  visit_station(station, visit);
  return visit.numbers;
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

Vec3 midship(const StaticResults& results) {
  if (!results.moorings) return Vec3::Zero();  // nominal position: the origin of W
  const VesselResult& vessel = results.moorings->rest.vessel;
  const Vec3 bow = results.R_WV.col(0);
  const double heading = std::atan2(bow.y(), bow.x()) - vessel.yaw;  // nominal heading
  const Vec3 ahead(std::cos(heading), std::sin(heading), 0.0);
  return vessel.surge * ahead + vessel.sway * Vec3::UnitZ().cross(ahead) + vessel.heave * Vec3::UnitZ();
}

Vec3 ship_direction(const StaticResults& results, const Vec3& d_W) {
  const Vec3 d = ship_point(results, results.stern_shoe_W + d_W);
  return {d.x(), d.y(), d_W.z()};
}

Station station_at(const StaticResults& results, double s) {
  const std::vector<Station>& all = results.stations;
  const auto above =
      std::lower_bound(all.begin(), all.end(), s, [](const Station& a, double arc_length) { return a.s < arc_length; });
  if (above == all.begin()) {
    return all.front();
  }
  if (above == all.end()) {
    return all.back();
  }
  Station a = *(above - 1), b = *above;
  const double t = b.s > a.s ? (s - a.s) / (b.s - a.s) : 0.0;
  Station interpolated = t < 0.5 ? a : b;
  const double yield_stress = interpolated.yield_stress;  // of one section or the other
  const std::vector<double*> of_a = station_numbers(a), of_b = station_numbers(b),
                             of_it = station_numbers(interpolated);
  for (std::size_t i = 0; i < of_it.size(); ++i) *of_it[i] = (1.0 - t) * *of_a[i] + t * *of_b[i];
  interpolated.s = s;
  interpolated.yield_stress = yield_stress;
  return interpolated;
}

double from_tensioner(const StaticResults& results, double s) {
  return results.stations.back().s - s;
}

double yield_percent(const StaticResults& results, double s, double stress) {
  const double yield = station_at(results, s).yield_stress;
  return yield > 0.0 ? 100.0 * stress / yield : 0.0;
}

std::string location_name(const StaticResults& results, double s) {
  constexpr double kBoxTolerance =
      0.5;  // Tolerance by which an extreme beyond the end of a box still belongs to the box [m].
  for (const SupportResult& box : results.supports) {
    if (std::abs(s - box.s) <= 0.5 * box.length + kBoxTolerance) {
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

std::string location_name(const StaticResults& results, const CheckRow& row) {
  if (results.has_pipe() && is_on_pipe(row)) return location_name(results, row.s);
  const std::string place = check_place(row);
  return place.substr(0, place.find(": "));  // The name; the rest explains the capacity.
}

std::optional<double> along_pipe(const StaticResults& results, const CheckRow& row) {
  if (!results.has_pipe() || !is_on_pipe(row)) return {};
  return row.from_top;
}

}  // namespace overbend
