#include "recording/fatigue_recorder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "model/description/fatigue_enum_names.h"
#include "recording/fatigue_findings.h"

namespace overbend {
namespace {

/// Horizontal direction across the pipe; the y axis for an upright pipe.
Vec3 level_across(const Vec3& tangent) {
  const Vec3 level = Vec3::UnitZ().cross(tangent);
  const double size = level.norm();
  return size > 1e-6 ? Vec3(level / size) : Vec3(Vec3::UnitY());
}

/// Axial stress of the wall [Pa].
double axial_stress(const Section& section, const NodeValues& nodes, std::size_t node) {
  const double internal = section.internal_pressure - section.contents_weight_density * nodes.z[node];
  const double wall = nodes.effective_tension[node] - nodes.external_pressure[node] * section.pressure_area +
                      internal * section.internal_area;
  return wall / section.steel_area;
}

}  // namespace

FatigueRecorder::FatigueRecorder(const Model& model, const std::vector<int>& section_of_station, std::size_t first)
    : model_(&model), fatigue_(&*model.description.fatigue), first_(first), spots_(fatigue_spots(*fatigue_)) {
  for (const FatigueSpotDescription& spot : spots_) {
    const auto known = std::find(surfaces_.begin(), surfaces_.end(), spot.inside);
    surface_of_spot_.push_back(static_cast<std::size_t>(known - surfaces_.begin()));
    if (known == surfaces_.end()) surfaces_.push_back(spot.inside);
  }
  for (std::size_t node = first; node < section_of_station.size(); ++node) {
    const std::size_t number = static_cast<std::size_t>(section_of_station[node]);
    const Section& section = model.sections[number];
    Station& station = stations_.emplace_back();
    if (section.kind == SectionKind::cable) continue;
    const double outer = 0.5 * section.steel_diameter;
    const double field_joint =
        make_check_section(model.find_section_description(number), model.description.checks).strain_factor;
    station.section = &section;
    station.per_moment = section.youngs_modulus / section.EI * field_joint;
    station.radius = {outer, outer - section.wall_thickness};
  }
  stress_.assign(surfaces_.size() * stations() * kPoints, 0.0);
  counter_ = RainflowCounter(stress_.size(), kMinStressRange);
  sums_.cycles.assign(stress_.size(), 0.0);
  sums_.damage.assign(spots_.size(), std::vector<double>(stations() * kPoints, 0.0));
}

/// The medium of a spot at a station is that of the station's position in the static state.
void FatigueRecorder::place_spots(const DesignInstant& instant) {
  places_.assign(spots_.size(), std::vector<FatiguePlace>(stations()));
  for (std::size_t spot = 0; spot < spots_.size(); ++spot) {
    for (std::size_t i = 0; i < stations(); ++i) {
      const Section* section = stations_[i].section;
      if (section == nullptr) continue;
      places_[spot][i] = fatigue_place(*fatigue_, spots_[spot], *section, instant.nodes.z[first_ + i]);
    }
  }
}

void FatigueRecorder::start(const DesignInstant& instant) {
  for (std::size_t i = 0; i < stations(); ++i) stations_[i].aside = level_across(instant.tangents[first_ + i]);
  place_spots(instant);
}

/// Bending stress follows from the moment; for yielding steel it is that of elastic steel at the same curvature.
void FatigueRecorder::find_stress(const DesignInstant& instant) {
  for (std::size_t i = 0; i < stations(); ++i) {
    const Station& station = stations_[i];
    if (station.section == nullptr) continue;
    const std::size_t node = first_ + i;
    const Vec3& t = instant.tangents[node];
    const Vec3 first = (station.aside - station.aside.dot(t) * t).normalized();
    double per_moment = station.per_moment;
    if (station.section->bending) {
      const double moment = instant.moments[node].norm();
      per_moment *= moment > 0.0 ? instant.nodes.curvature[node] * station.section->EI / moment : 0.0;
    }
    // The moment vector points to the centre of curvature, where the wall is compressed.
    const double across = -per_moment * instant.moments[node].dot(first);
    const double upward = -per_moment * instant.moments[node].dot(t.cross(first));
    constexpr double kHalf = 0.5 * std::numbers::sqrt2;
    const double bends[4] = {across, kHalf * (across + upward), upward, kHalf * (upward - across)};
    const double axial = axial_stress(*station.section, instant.nodes, node);
    for (std::size_t surface = 0; surface < surfaces_.size(); ++surface) {
      const double radius = station.radius[surfaces_[surface] ? 1 : 0];
      double* out = &stress_[(surface * stations() + i) * kPoints];
      for (std::size_t k = 0; k < 4; ++k) {
        out[k] = axial + radius * bends[k];
        out[k + 4] = axial - radius * bends[k];
      }
    }
  }
}

void FatigueRecorder::count(Sums& sums, std::size_t record, const RainflowCycle& cycle) const {
  const std::size_t surface = record / (stations() * kPoints), point = record % (stations() * kPoints);
  sums.cycles[record] += cycle.count;
  for (std::size_t spot = 0; spot < spots_.size(); ++spot) {
    if (surface_of_spot_[spot] != surface) continue;
    const FatiguePlace& place = places_[spot][point / kPoints];
    sums.damage[spot][point] += cycle.count * place.curve.damage(place.factor() * cycle.range);
  }
}

void FatigueRecorder::step(const DesignInstant& instant) {
  find_stress(instant);
  counter_.add(stress_, [&](std::size_t record, const RainflowCycle& cycle) { count(sums_, record, cycle); });
  time_ = instant.time;
}

/// Results of the worst point at each station.
FatigueSpot FatigueRecorder::make_spot(std::size_t spot, const Sums& sums) const {
  FatigueSpot out;
  out.name = spots_[spot].name;
  out.curve = enum_name(spots_[spot].curve);
  for (std::size_t i = 0; i < stations(); ++i) {
    const double* of_points = &sums.damage[spot][i * kPoints];
    const std::size_t worst = static_cast<std::size_t>(std::max_element(of_points, of_points + kPoints) - of_points);
    const FatiguePlace& place = places_[spot][i];
    const double cycles = sums.cycles[(surface_of_spot_[spot] * stations() + i) * kPoints + worst];
    out.rate.push_back(of_points[worst] / time_);
    out.cycles.push_back(cycles / time_);
    out.range.push_back(cycles > 0.0 ? place.curve.find_range(of_points[worst] / cycles) / place.factor() : 0.0);
  }
  const auto worst = std::max_element(out.rate.begin(), out.rate.end());
  out.worst_rate = *worst;
  out.stress_factor = places_[spot][static_cast<std::size_t>(worst - out.rate.begin())].stress_factor;
  return out;
}

void FatigueRecorder::fill(DynamicResults& results) const {
  if (time_ <= 0.0) return;
  Sums sums = sums_;
  counter_.residue([&](std::size_t record, const RainflowCycle& cycle) { count(sums, record, cycle); });
  FatigueResults& out = results.fatigue.emplace();
  for (std::size_t spot = 0; spot < spots_.size(); ++spot) out.spots.push_back(make_spot(spot, sums));
  add_weld_damage(*model_, results);
  assume_of_fatigue(*model_, results);
  warn_of_fatigue(*model_, results);
}

std::vector<double> FatigueRecorder::save() const {
  std::vector<double> out = {time_};
  out.insert(out.end(), sums_.cycles.begin(), sums_.cycles.end());
  for (const std::vector<double>& damage : sums_.damage) out.insert(out.end(), damage.begin(), damage.end());
  const std::vector<double> counter = counter_.save();
  out.insert(out.end(), counter.begin(), counter.end());
  return out;
}

void FatigueRecorder::restore(std::span<const double> saved) {
  const std::size_t points = stations() * kPoints;
  const std::size_t sums = 1 + sums_.cycles.size() + spots_.size() * points;
  if (saved.size() < sums) throw std::runtime_error("the checkpoint's fatigue does not fit");
  time_ = saved[0];
  auto from = saved.begin() + 1;
  const auto take = [&](std::vector<double>& into) {
    const auto end = from + static_cast<std::ptrdiff_t>(into.size());
    std::copy(from, end, into.begin());
    from = end;
  };
  take(sums_.cycles);
  for (std::vector<double>& damage : sums_.damage) take(damage);
  counter_.restore(saved.subspan(sums));
}

}  // namespace overbend
