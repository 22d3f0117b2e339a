#include "recording/design_recorder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace overbend {
namespace {

/// Maximum fibre strain as a vector along the bending moment, so that strains of opposite bending have opposite
/// directions.
Vec3 strain_vector(double strain, const Vec3& moment) {
  const double size = moment.norm();
  return size > 0.0 ? Vec3((strain / size) * moment) : Vec3(strain * Vec3::UnitZ());
}

/// Capacities for each safety class, regardless of the model's class.
std::array<std::vector<CheckSection>, kSafetyClasses> sections_by_class(const Model& model) {
  std::array<std::vector<CheckSection>, kSafetyClasses> all;
  for (std::size_t i = 0; i < kSafetyClasses; ++i) {
    CheckSettings settings = model.description.checks;
    settings.safety_class = static_cast<SafetyClass>(i);
    for (std::size_t section = 0; section < model.sections.size(); ++section) {
      all[i].push_back(make_check_section(model.find_section_description(section), settings));
    }
  }
  return all;
}

}  // namespace

DesignRecorder::DesignRecorder(const Model& model, const std::vector<int>& section_of_node)
    : model_(&model),
      sections_(sections_by_class(model)),
      combinations_(load_combinations(model.description.checks)),
      section_(section_of_node),
      first_supported_(section_of_node.size()),
      functional_(section_of_node.size()),
      screen_(section_of_node.size(), combinations_),
      roller_(section_of_node.size(), 0.0),
      overpressure_(section_of_node.size(), 0.0),
      peaks_(section_of_node.size()),
      max_force_(section_of_node.size(), 0.0),
      von_mises_(section_of_node.size(), -1.0),
      fibre_strain_(section_of_node.size(), -1.0),
      tension_(section_of_node.size(), -1e300) {
  runs_.reserve(section_.size());
  find_section_runs(section_, runs_);
}

void DesignRecorder::set_sections(const std::vector<int>& section_of_node) {
  bool moved = false;
  for (std::size_t node = 0; node < section_.size(); ++node) {
    if (section_[node] == section_of_node[node]) continue;
    section_[node] = section_of_node[node];
    set_limits(node);
    moved = true;
  }
  if (moved) find_section_runs(section_, runs_);
}

SectionOfClasses DesignRecorder::section_of_classes(std::size_t section) const {
  SectionOfClasses of_classes{};
  for (std::size_t i = 0; i < kSafetyClasses; ++i) of_classes[i] = &sections_[i][section];
  return of_classes;
}

/// Updates the screening limits with the peaks of a node.
void DesignRecorder::set_limits(std::size_t node) {
  for (std::size_t i = 0; i < kSafetyClasses; ++i) {
    const Peak& peak = peaks_[node][i];
    const CheckSection& section = sections_[i][static_cast<std::size_t>(section_[node])];
    screen_.keep_load(i, node, peak.load);
    screen_.keep_strain(i, node, peak.strain, peak.design_strain, section.strain);
  }
}

void DesignRecorder::find_overpressure(const DesignInstant& instant) {
  const double* z = instant.nodes.z.data();
  const double* external = instant.nodes.external_pressure.data();
  double* over = overpressure_.data();
  for (const SectionRun& run : runs_) {
    const Section& section = model_->sections[run.section];
    const double at_zero = section.internal_pressure, by_height = section.contents_weight_density;
    const double min_internal = min_pressure_on_bore(section);
#pragma GCC ivdep
    for (std::size_t node = run.first; node < run.last; ++node) {
      over[node] = external[node] - std::max(at_zero - by_height * z[node], min_internal);
    }
  }
}

void DesignRecorder::start(const DesignInstant& instant) {
  for (std::size_t node = 0; node < section_.size(); ++node) {
    Vec3 moment = instant.moments[node], strain = strain_vector(instant.nodes.strain[node], moment);
    double force = instant.nodes.effective_tension[node];
    if (node < current_.size()) {
      const Vec3 added = current_[node].moment(instant.tangents[node]);
      const Section& section = model_->sections[static_cast<std::size_t>(section_[node])];
      moment -= added;
      strain -= 0.5 * section.steel_diameter / section.EI * added;
      force -= current_[node].tension;
    }
    functional_.moment.set(node, moment);
    functional_.strain.set(node, strain);
    functional_.tangent.set(node, instant.tangents[node]);
    functional_.force[node] = force;
  }
  for (const RollerContact& contact : instant.contacts) {
    if (contact.normal > 0.0) {
      first_supported_ = std::min(first_supported_, static_cast<std::size_t>(contact.closest.element));
    }
  }
}

void DesignRecorder::find_rollers(const DesignInstant& instant) {
  std::fill(roller_.begin(), roller_.end(), 0.0);
  for (const RollerContact& contact : instant.contacts) {
    if (contact.normal > 0.0) {
      const std::size_t node = static_cast<std::size_t>(contact.closest.element + (contact.closest.xi < 0.5 ? 0 : 1));
      double& force = roller_[static_cast<std::size_t>(instant.station_of_node[node])];
      force = std::max(force, contact.normal);
    }
  }
}

/// The utilisation increases with each load effect: if none exceeds the peak's, it need not be evaluated.
bool DesignRecorder::keep_load(Peak& peak, const CheckSection& section, const LoadEffect& effect) {
  if (effect.pressure >= 0.0 && effect.moment <= peak.moment && std::abs(effect.force) <= std::abs(peak.force) &&
      effect.pressure <= peak.load_pressure && effect.share >= peak.share) {
    return false;
  }
  const double used =
      load_terms(section.load, effect.moment, effect.force, effect.pressure, 0.0, effect.share).utilisation();
  if (!(used > peak.load)) return false;
  peak.load = used;
  peak.load_time = effect.time;
  peak.moment = effect.moment;
  peak.force = effect.force;
  peak.load_pressure = effect.pressure;
  peak.share = effect.share;
  return true;
}

bool DesignRecorder::keep_strain(Peak& peak, const CheckSection& section, const StrainEffect& effect) {
  if (effect.pressure >= 0.0 && effect.strain <= peak.design_strain && effect.pressure <= peak.strain_pressure) {
    return false;
  }
  const double used = strain_terms(section.strain, effect.strain, effect.pressure, 0.0).utilisation();
  if (!(used > peak.strain)) return false;
  peak.strain = used;
  peak.strain_time = effect.time;
  peak.design_strain = effect.strain;
  peak.strain_pressure = effect.pressure;
  return true;
}

void DesignRecorder::step_load(const DesignInstant& instant, std::size_t node) {
  const std::size_t of_node = static_cast<std::size_t>(section_[node]);
  const CheckSection& section = sections_[0][of_node];  // the members used here are the same for every class
  const Vec3 static_part = transported(functional_.moment[node], functional_.tangent[node], instant.tangents[node]);
  const double added_force = instant.nodes.effective_tension[node] - functional_.force[node];
  LoadEffect effect{};
  effect.time = instant.time;
  effect.pressure = overpressure_[node];
  effect.share = roller_[node] > 0.0 ? point_load_factor(section.wall, section.fy, roller_[node]) : 1.0;
  for (const LoadFactors& factors : combinations_) {
    effect.moment = design_size(factors, static_part, instant.moments[node] - static_part);
    effect.force = design_value(factors, functional_.force[node], added_force);
    for (std::size_t i = 0; i < kSafetyClasses; ++i) {
      Peak& peak = peaks_[node][i];
      if (keep_load(peak, sections_[i][of_node], effect)) screen_.keep_load(i, node, peak.load);
    }
  }
}

void DesignRecorder::step_strain(const DesignInstant& instant, std::size_t node) {
  const std::size_t of_node = static_cast<std::size_t>(section_[node]);
  const Vec3 static_part = transported(functional_.strain[node], functional_.tangent[node], instant.tangents[node]);
  const Vec3 added = strain_vector(instant.nodes.strain[node], instant.moments[node]) - static_part;
  StrainEffect effect{0.0, overpressure_[node], instant.time};
  for (const LoadFactors& factors : combinations_) {
    effect.strain = sections_[0][of_node].strain_factor * design_size(factors, static_part, added);
    for (std::size_t i = 0; i < kSafetyClasses; ++i) {
      const CheckSection& section = sections_[i][of_node];
      Peak& peak = peaks_[node][i];
      if (keep_strain(peak, section, effect)) {
        screen_.keep_strain(i, node, peak.strain, peak.design_strain, section.strain);
      }
    }
  }
}

void DesignRecorder::RunningMaximum::keep(const std::vector<double>& values, double present_time) {
  const std::size_t n = value.size();
  const double* v = values.data();
  double* max = value.data();
  double* when = time.data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) {
    const bool more = v[i] > max[i];
    when[i] = more ? present_time : when[i];
    max[i] = more ? v[i] : max[i];
  }
}

void DesignRecorder::keep_times(const DesignInstant& instant) {
  von_mises_.keep(instant.nodes.von_mises, instant.time);
  fibre_strain_.keep(instant.nodes.strain, instant.time);
  tension_.keep(instant.nodes.effective_tension, instant.time);
}

void DesignRecorder::step_run(const DesignInstant& instant, const SectionRun& run) {
  const PresentEffects present{instant.moments, instant.tangents, instant.nodes.strain,
                               instant.nodes.effective_tension};
  const SectionOfClasses sections = section_of_classes(run.section);
  if (sections[0]->load.known) {
    screen_.find_loads(run, sections, functional_, present, overpressure_);
    screen_.raise_forces(run, max_force_);
    for (std::size_t node = run.first; node < run.last; ++node) {
      if (roller_[node] > 0.0 || screen_.loads_more(node)) step_load(instant, node);
    }
  }
  const SectionRun supported{run.section, std::max(run.first, first_supported_), run.last};
  if (sections[0]->strain.holds && supported.first < supported.last) {
    screen_.find_strains(supported, sections, functional_, present, overpressure_);
    for (std::size_t node = supported.first; node < supported.last; ++node) {
      if (screen_.strains_more(node)) step_strain(instant, node);
    }
  }
}

void DesignRecorder::step(const DesignInstant& instant) {
  if (model_->description.checks.point_load) find_rollers(instant);
  keep_times(instant);
  find_overpressure(instant);
  for (const SectionRun& run : runs_) {
    // pipe codes do not apply to cables
    if (model_->sections[run.section].kind != SectionKind::cable) step_run(instant, run);
  }
}

void DesignRecorder::fill_peaks(DesignPeaks& out, std::size_t of_class, std::size_t first) const {
  const auto column = [&](std::vector<double>& values, double Peak::*member) {
    values.clear();
    for (std::size_t node = first; node < peaks_.size(); ++node) {
      values.push_back(peaks_[node][of_class].*member);
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
  const auto column = [&](std::vector<double>& values, const std::vector<double>& all) {
    values.assign(all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
  };
  column(design.max_force, max_force_);
  column(design.von_mises_time, von_mises_.time);
  column(design.fibre_strain_time, fibre_strain_.time);
  column(design.tension_time, tension_.time);
}

std::vector<double> DesignRecorder::save() const {
  static_assert(sizeof(Peaks) == kPeakNumbers * sizeof(double));
  std::vector<double> out;
  out.reserve(kStationNumbers * peaks_.size());
  for (std::size_t node = 0; node < peaks_.size(); ++node) {
    const std::size_t offset = out.size();
    out.resize(offset + kPeakNumbers);
    std::memcpy(out.data() + offset, &peaks_[node], sizeof(Peaks));
    out.insert(out.end(), {max_force_[node], von_mises_.value[node], von_mises_.time[node], fibre_strain_.value[node],
                           fibre_strain_.time[node], tension_.value[node], tension_.time[node]});
  }
  return out;
}

void DesignRecorder::restore(std::span<const double> saved) {
  if (saved.size() != kStationNumbers * peaks_.size()) {
    throw std::runtime_error("the checkpoint's checks do not fit");
  }
  const double* from = saved.data();
  for (std::size_t node = 0; node < peaks_.size(); ++node) {
    std::memcpy(static_cast<void*>(&peaks_[node]), from, sizeof(Peaks));
    from += kPeakNumbers;
    for (std::vector<double>* column : {&max_force_, &von_mises_.value, &von_mises_.time, &fibre_strain_.value,
                                        &fibre_strain_.time, &tension_.value, &tension_.time}) {
      (*column)[node] = *from++;
    }
    set_limits(node);
  }
}

}  // namespace overbend
