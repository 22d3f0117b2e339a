#include "dynamics/integrator/water_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace overbend {
namespace {

constexpr double kMomentsPerPeriod = 8.0;
constexpr double kMaxTableInterval = 0.5;   ///< [s]
constexpr double kClosestStations = 1.5;    ///< [m]
constexpr double kFarthestStations = 15.0;  ///< [m]
constexpr double kSpacingByDepth = 0.1;     ///< Waves that reach depth z are longer than about 2 z.

double spacing_at(double z) {
  return std::clamp(kSpacingByDepth * std::abs(z), kClosestStations, kFarthestStations);
}

/// Cubic in time through values and rates at both times; the build-up is included in both.
Vec3 between(const Vec3& v0, const Vec3& a0, const Vec3& v1, const Vec3& a1, double x, double h) {
  const double x2 = x * x, x3 = x2 * x;
  return (1.0 - 3.0 * x2 + 2.0 * x3) * v0 + (h * (x - 2.0 * x2 + x3)) * a0 + (3.0 * x2 - 2.0 * x3) * v1 +
         (h * (x3 - x2)) * a1;
}

}  // namespace

double water_interval(const Sea& sea, double output_step) {
  if (sea.calm()) {
    return output_step;
  }
  const double wanted =
      std::min(kMaxTableInterval, 2.0 * std::numbers::pi / highest_frequency(sea) / kMomentsPerPeriod);
  return output_step / std::ceil(output_step / wanted - 1e-9);
}

WaterField::WaterField(const Sea& sea, const LineMesh& mesh, const std::vector<double>& q, double build_up,
                       double interval)
    : sea_(&sea), build_up_(build_up), interval_(interval) {
  if (sea.calm()) {
    return;
  }
  const int nodes = mesh.nodes();
  const auto node_z = [&](int node) { return q[static_cast<std::size_t>(6 * node + 2)]; };
  stations_.push_back(0);
  for (int node = 1; node < nodes; ++node) {
    const double since = mesh.s[static_cast<std::size_t>(node)] - mesh.s[static_cast<std::size_t>(stations_.back())];
    const double next = node + 1 < nodes ? mesh.length[static_cast<std::size_t>(node)] : 0.0;
    if (node == nodes - 1 || since + next > spacing_at(node_z(node))) {
      stations_.push_back(node);
    }
  }
  place_between(mesh);
}

WaterField::WaterField(const Sea& sea, const LineMesh& mesh, std::vector<int> stations, double build_up,
                       double interval)
    : sea_(&sea), build_up_(build_up), interval_(interval), stations_(std::move(stations)) {
  if (!stations_.empty()) place_between(mesh);
}

/// Sets the stations before and after every node.
void WaterField::place_between(const LineMesh& mesh) {
  std::size_t below = 0;
  for (int node = 0; node < mesh.nodes(); ++node) {
    while (below + 2 < stations_.size() && stations_[below + 1] <= node) {
      ++below;
    }
    const double s0 = mesh.s[static_cast<std::size_t>(stations_[below])];
    const double s1 = mesh.s[static_cast<std::size_t>(stations_[below + 1])];
    station_below_.push_back(static_cast<int>(below));
    share_.push_back((mesh.s[static_cast<std::size_t>(node)] - s0) / (s1 - s0));
  }
  points_.resize(stations_.size());
  now_.resize(stations_.size());
}

void WaterField::evaluate(double time, const std::vector<double>& q, const std::vector<double>& v, double ahead,
                          std::vector<WaterState>& out) {
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const std::size_t first = 6 * static_cast<std::size_t>(stations_[i]);
    points_[i] = Vec3(q[first], q[first + 1], q[first + 2]) + ahead * Vec3(v[first], v[first + 1], v[first + 2]);
  }
  water_state(*sea_, time, half_cosine(time, build_up_), points_, out);
}

void WaterField::start(WaterMemory& memory, double time, const std::vector<double>& q, const std::vector<double>& v) {
  memory.time = time;
  memory.first.resize(stations_.size());
  memory.second.resize(stations_.size());
  evaluate(time, q, v, 0.0, memory.first);
  evaluate(time + interval_, q, v, interval_, memory.second);
}

void WaterField::renew(WaterMemory& memory, double time, const std::vector<double>& q, const std::vector<double>& v) {
  memory.first.resize(stations_.size());
  memory.second.resize(stations_.size());
  evaluate(memory.time, q, v, memory.time - time, memory.first);
  evaluate(memory.time + interval_, q, v, memory.time + interval_ - time, memory.second);
}

void WaterField::advance(WaterMemory& memory, const std::vector<double>& q, const std::vector<double>& v) {
  memory.time += interval_;
  std::swap(memory.first, memory.second);
  evaluate(memory.time + interval_, q, v, interval_, memory.second);
}

void WaterField::nodes_at(const WaterMemory& memory, double time, std::vector<double>& water) {
  const double x = (time - memory.time) / interval_;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const WaterState &a = memory.first[i], &b = memory.second[i];
    WaterValues& values = now_[i];
    values.head<3>() = between(a.velocity, a.acceleration, b.velocity, b.acceleration, x, interval_);
    values.segment<3>(3) = (1.0 - x) * a.acceleration + x * b.acceleration;
    values(6) = (1.0 - x) * a.elevation + x * b.elevation;
    values(7) = (1.0 - x) * a.pressure_head + x * b.pressure_head;
  }
  double* out = water.data();
  for (std::size_t node = 0; node < share_.size(); ++node) {
    const std::size_t below = static_cast<std::size_t>(station_below_[node]);
    const double f = share_[node];
    Eigen::Map<WaterValues>(out + kWaterValues * node) = (1.0 - f) * now_[below] + f * now_[below + 1];
  }
}

WaterOnLines::WaterOnLines(const Sea& sea, const System& system, const SystemState& state, double build_up,
                           double interval)
    : sea_(&sea), build_up_(build_up), interval_(interval), memories_(system.lines.size()) {
  for (std::size_t i = 0; i < system.lines.size(); ++i) {
    fields_.emplace_back(sea, system.lines[i].mesh, state.lines[i].q, build_up, interval);
  }
}

void WaterOnLines::start(const SystemState& state) {
  if (calm()) return;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    fields_[i].start(memories_[i], state.time, state.lines[i].q, state.lines[i].v);
  }
}

void WaterOnLines::advance(const SystemState& state) {
  if (calm()) return;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    fields_[i].advance(memories_[i], state.lines[i].q, state.lines[i].v);
  }
}

void WaterOnLines::fill(double time, std::vector<std::vector<double>>& water) {
  if (calm()) return;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    water[i].resize(static_cast<std::size_t>(kWaterValues) * fields_[i].nodes());
    fields_[i].nodes_at(memories_[i], time, water[i]);
  }
}

void WaterOnLines::renew(std::size_t line, const LineMesh& mesh, const SystemState& state) {
  if (calm()) return;
  const LineState& shape = state.lines[line];
  fields_[line] = WaterField(*sea_, mesh, shape.q, build_up_, interval_);
  fields_[line].renew(memories_[line], state.time, shape.q, shape.v);
}

void WaterOnLines::place_stations(std::size_t line, const LineMesh& mesh, std::vector<int> nodes) {
  fields_[line] = WaterField(*sea_, mesh, std::move(nodes), build_up_, interval_);
}

}  // namespace overbend
