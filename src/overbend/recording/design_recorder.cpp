#include "recording/design_recorder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace overbend {
namespace {

/// The largest fibre strain as a vector along the bending moment, so that strains of opposite bending oppose each
/// other.
Vec3 strain_vector(double strain, const Vec3& moment) {
  const double size = moment.norm();
  return size > 0.0 ? Vec3((strain / size) * moment) : Vec3(strain * Vec3::UnitZ());
}

/// Capacities for each safety class, whatever the model's is.
std::array<std::vector<CheckSection>, kSafetyClasses> sections_by_class(const Model& model) {
  std::array<std::vector<CheckSection>, kSafetyClasses> all;
  for (std::size_t i = 0; i < kSafetyClasses; ++i) {
    CheckSettings settings = model.description.checks;
    settings.safety_class = static_cast<SafetyClass>(i);
    for (std::size_t section = 0; section < model.sections.size(); ++section) {
      all[i].push_back(make_check_section(model.description_of(section), settings));
    }
  }
  return all;
}

}  // namespace

DesignRecorder::DesignRecorder(const Model& model, const std::vector<int>& section_of_node)
    : model_(&model),
      sections_(sections_by_class(model)),
      combinations_(load_combinations(model.description.checks)),
      section_(section_of_node.begin(), section_of_node.end()),
      first_supported_(section_of_node.size()),
      functional_(section_of_node.size()),
      roller_(section_of_node.size(), 0.0),
      stations_(section_of_node.size()) {}

double DesignRecorder::overpressure(const DesignInstant& at, std::size_t node) const {
  const Section& section = model_->sections[section_[node]];
  const double internal = section.internal_pressure - section.contents_weight_density * at.nodes.z[node];
  return at.nodes.external_pressure[node] - std::max(internal, 0.0);
}

void DesignRecorder::start(const DesignInstant& at) {
  for (std::size_t node = 0; node < functional_.size(); ++node) {
    functional_[node] = {at.moments[node], strain_vector(at.nodes.strain[node], at.moments[node]), at.tangents[node],
                         at.nodes.effective_tension[node]};
  }
  for (std::size_t node = 0; node < current_.size(); ++node) {
    const Vec3 moment = current_[node].moment(at.tangents[node]);
    const Section& section = model_->sections[section_[node]];
    functional_[node].moment -= moment;
    functional_[node].strain -= 0.5 * section.steel_diameter / section.EI * moment;
    functional_[node].force -= current_[node].tension;
  }
  for (const RollerContact& contact : at.contacts) {
    if (contact.normal > 0.0) {
      first_supported_ = std::min(first_supported_, static_cast<std::size_t>(contact.at.element));
    }
  }
}

void DesignRecorder::find_rollers(const DesignInstant& at) {
  std::fill(roller_.begin(), roller_.end(), 0.0);
  for (const RollerContact& contact : at.contacts) {
    if (contact.normal > 0.0) {
      const std::size_t node = static_cast<std::size_t>(contact.at.element + (contact.at.xi < 0.5 ? 0 : 1));
      double& force = roller_[static_cast<std::size_t>(at.station_of_node[node])];
      force = std::max(force, contact.normal);
    }
  }
}

/// Utilisation grows with each load effect: where none is above the peak's it need not be looked at.
void DesignRecorder::keep_load(Peak& peak, const CheckSection& section, const LoadEffect& effect) {
  if (effect.pressure >= 0.0 && effect.moment <= peak.moment && std::abs(effect.force) <= std::abs(peak.force) &&
      effect.pressure <= peak.load_pressure && effect.share >= peak.share) {
    return;
  }
  const double used =
      load_terms(section.load, effect.moment, effect.force, effect.pressure, 0.0, effect.share).utilisation();
  if (used > peak.load) {
    peak.load = used;
    peak.load_time = effect.time;
    peak.moment = effect.moment;
    peak.force = effect.force;
    peak.load_pressure = effect.pressure;
    peak.share = effect.share;
  }
}

void DesignRecorder::keep_strain(Peak& peak, const CheckSection& section, const StrainEffect& effect) {
  if (effect.pressure >= 0.0 && effect.strain <= peak.design_strain && effect.pressure <= peak.strain_pressure) return;
  const double used = strain_terms(section.strain, effect.strain, effect.pressure, 0.0).utilisation();
  if (used > peak.strain) {
    peak.strain = used;
    peak.strain_time = effect.time;
    peak.design_strain = effect.strain;
    peak.strain_pressure = effect.pressure;
  }
}

void DesignRecorder::step_load(const DesignInstant& at, std::size_t node) {
  const CheckSection& section = sections_[0][section_[node]];  // what is used of it here is that of every class
  if (!section.load.known) return;
  const Functional& functional = functional_[node];
  Station& station = stations_[node];
  const Vec3 still = carried(functional.moment, functional.tangent, at.tangents[node]);
  const double added_force = at.nodes.effective_tension[node] - functional.force;
  LoadEffect effect{};
  effect.time = at.time;
  effect.pressure = overpressure(at, node);
  effect.share = roller_[node] > 0.0 && model_->description.checks.point_load
                     ? point_load_factor(section.wall, section.fy, roller_[node])
                     : 1.0;
  for (const LoadFactors& factors : combinations_) {
    effect.moment = design_size(factors, still, at.moments[node] - still);
    effect.force = design_value(factors, functional.force, added_force);
    station.largest_force = std::max(station.largest_force, std::abs(effect.force));
    for (std::size_t i = 0; i < kSafetyClasses; ++i) {
      keep_load(station.peaks[i], sections_[i][section_[node]], effect);
    }
  }
}

void DesignRecorder::step_strain(const DesignInstant& at, std::size_t node) {
  const CheckSection& section = sections_[0][section_[node]];
  if (!section.strain.holds) return;
  const Functional& functional = functional_[node];
  const Vec3 still = carried(functional.strain, functional.tangent, at.tangents[node]);
  const Vec3 added = strain_vector(at.nodes.strain[node], at.moments[node]) - still;
  StrainEffect effect{0.0, overpressure(at, node), at.time};
  for (const LoadFactors& factors : combinations_) {
    effect.strain = section.strain_factor * design_size(factors, still, added);
    for (std::size_t i = 0; i < kSafetyClasses; ++i) {
      keep_strain(stations_[node].peaks[i], sections_[i][section_[node]], effect);
    }
  }
}

void DesignRecorder::step_times(const DesignInstant& at, std::size_t node) {
  Station& station = stations_[node];
  const auto keep = [&](double value, double& largest, double& time) {
    if (value > largest) {
      largest = value;
      time = at.time;
    }
  };
  keep(at.nodes.von_mises[node], station.von_mises, station.von_mises_time);
  keep(at.nodes.strain[node], station.fibre_strain, station.fibre_strain_time);
  keep(at.nodes.effective_tension[node], station.tension, station.tension_time);
}

void DesignRecorder::step(const DesignInstant& at) {
  if (model_->description.checks.point_load) find_rollers(at);
  for (std::size_t node = 0; node < stations_.size(); ++node) {
    step_times(at, node);
    if (model_->sections[section_[node]].kind == SectionKind::cable) continue;  // no code for pipes is about it
    step_load(at, node);
    if (node >= first_supported_) step_strain(at, node);
  }
}

void DesignRecorder::fill_peaks(DesignPeaks& out, std::size_t of_class, std::size_t first) const {
  const auto column = [&](std::vector<double>& values, double Peak::*member) {
    values.clear();
    for (std::size_t node = first; node < stations_.size(); ++node) {
      values.push_back(stations_[node].peaks[of_class].*member);
    }
  };
  column(out.load, &Peak::load);
  column(out.load_time, &Peak::load_time);
  column(out.moment, &Peak::moment);
  column(out.force, &Peak::force);
  column(out.load_pressure, &Peak::load_pressure);
  column(out.share, &Peak::share);
  column(out.strain, &Peak::strain);
  column(out.strain_time, &Peak::strain_time);
  column(out.design_strain, &Peak::design_strain);
  column(out.strain_pressure, &Peak::strain_pressure);
}

void DesignRecorder::fill(StationDesign& design, std::size_t first) const {
  fill_peaks(design, static_cast<std::size_t>(model_->description.checks.safety_class), first);
  for (std::size_t i = 0; i < kSafetyClasses; ++i) fill_peaks(design.of_class[i], i, first);
  const auto column = [&](std::vector<double>& values, double Station::*member) {
    values.clear();
    for (std::size_t node = first; node < stations_.size(); ++node) values.push_back(stations_[node].*member);
  };
  column(design.largest_force, &Station::largest_force);
  column(design.von_mises_time, &Station::von_mises_time);
  column(design.fibre_strain_time, &Station::fibre_strain_time);
  column(design.tension_time, &Station::tension_time);
}

std::vector<double> DesignRecorder::save() const {
  static_assert(sizeof(Station) == kStationNumbers * sizeof(double));
  std::vector<double> out(kStationNumbers * stations_.size());
  std::memcpy(out.data(), stations_.data(), out.size() * sizeof(double));
  return out;
}

void DesignRecorder::restore(std::span<const double> saved) {
  if (saved.size() != kStationNumbers * stations_.size()) {
    throw std::runtime_error("the checkpoint's checks do not fit");
  }
  std::memcpy(static_cast<void*>(stations_.data()), saved.data(), saved.size() * sizeof(double));
}

}  // namespace overbend
