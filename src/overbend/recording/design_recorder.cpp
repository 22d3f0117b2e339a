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

}  // namespace

DesignRecorder::DesignRecorder(const Model& model, const std::vector<int>& section_of_node)
    : model_(&model),
      sections_(check_sections(model)),
      combinations_(load_combinations(model.description.checks)),
      section_(section_of_node.begin(), section_of_node.end()),
      first_supported_(section_of_node.size()),
      functional_(section_of_node.size()),
      roller_(section_of_node.size(), 0.0),
      peaks_(section_of_node.size()) {}

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
      double& force = roller_[static_cast<std::size_t>(contact.at.element + (contact.at.xi < 0.5 ? 0 : 1))];
      force = std::max(force, contact.normal);
    }
  }
}

void DesignRecorder::step_load(const DesignInstant& at, std::size_t node) {
  const CheckSection& section = sections_[section_[node]];
  if (!section.load.known) return;
  const Functional& functional = functional_[node];
  Peak& peak = peaks_[node];
  const Vec3 still = carried(functional.moment, functional.tangent, at.tangents[node]);
  const double added_force = at.nodes.effective_tension[node] - functional.force;
  const double pressure = overpressure(at, node);
  const double share = roller_[node] > 0.0 && model_->description.checks.point_load
                           ? point_load_factor(section.wall, section.fy, roller_[node])
                           : 1.0;
  for (const LoadFactors& factors : combinations_) {
    const double moment = design_size(factors, still, at.moments[node] - still);
    const double force = design_value(factors, functional.force, added_force);
    const double used = load_terms(section.load, moment, force, pressure, 0.0, share).utilisation();
    peak.largest_force = std::max(peak.largest_force, std::abs(force));
    if (used > peak.load) {
      peak.load = used;
      peak.load_time = at.time;
      peak.moment = moment;
      peak.force = force;
      peak.load_pressure = pressure;
      peak.share = share;
    }
  }
}

void DesignRecorder::step_strain(const DesignInstant& at, std::size_t node) {
  const CheckSection& section = sections_[section_[node]];
  if (!section.strain.holds) return;
  const Functional& functional = functional_[node];
  Peak& peak = peaks_[node];
  const Vec3 still = carried(functional.strain, functional.tangent, at.tangents[node]);
  const Vec3 added = strain_vector(at.nodes.strain[node], at.moments[node]) - still;
  const double pressure = overpressure(at, node);
  for (const LoadFactors& factors : combinations_) {
    const double strain = section.strain_factor * design_size(factors, still, added);
    const double used = strain_terms(section.strain, strain, pressure, 0.0).utilisation();
    if (used > peak.strain) {
      peak.strain = used;
      peak.strain_time = at.time;
      peak.design_strain = strain;
      peak.strain_pressure = pressure;
    }
  }
}

void DesignRecorder::step_times(const DesignInstant& at, std::size_t node) {
  Peak& peak = peaks_[node];
  const auto keep = [&](double value, double& largest, double& time) {
    if (value > largest) {
      largest = value;
      time = at.time;
    }
  };
  keep(at.nodes.von_mises[node], peak.von_mises, peak.von_mises_time);
  keep(at.nodes.strain[node], peak.fibre_strain, peak.fibre_strain_time);
  keep(at.nodes.effective_tension[node], peak.tension, peak.tension_time);
}

void DesignRecorder::step(const DesignInstant& at) {
  if (model_->description.checks.point_load) find_rollers(at);
  for (std::size_t node = 0; node < peaks_.size(); ++node) {
    step_load(at, node);
    if (node >= first_supported_) step_strain(at, node);
    step_times(at, node);
  }
}

void DesignRecorder::fill(StationDesign& design, std::size_t first) const {
  const auto column = [&](std::vector<double>& out, double Peak::*member) {
    out.clear();
    for (std::size_t node = first; node < peaks_.size(); ++node) out.push_back(peaks_[node].*member);
  };
  column(design.load, &Peak::load);
  column(design.load_time, &Peak::load_time);
  column(design.moment, &Peak::moment);
  column(design.force, &Peak::force);
  column(design.load_pressure, &Peak::load_pressure);
  column(design.share, &Peak::share);
  column(design.largest_force, &Peak::largest_force);
  column(design.strain, &Peak::strain);
  column(design.strain_time, &Peak::strain_time);
  column(design.design_strain, &Peak::design_strain);
  column(design.strain_pressure, &Peak::strain_pressure);
  column(design.von_mises_time, &Peak::von_mises_time);
  column(design.fibre_strain_time, &Peak::fibre_strain_time);
  column(design.tension_time, &Peak::tension_time);
}

std::vector<double> DesignRecorder::save() const {
  static_assert(sizeof(Peak) == kPeakNumbers * sizeof(double));
  std::vector<double> out(kPeakNumbers * peaks_.size());
  std::memcpy(out.data(), peaks_.data(), out.size() * sizeof(double));
  return out;
}

void DesignRecorder::restore(std::span<const double> saved) {
  if (saved.size() != kPeakNumbers * peaks_.size()) throw std::runtime_error("the checkpoint's checks do not fit");
  std::memcpy(static_cast<void*>(peaks_.data()), saved.data(), saved.size() * sizeof(double));
}

}  // namespace overbend
