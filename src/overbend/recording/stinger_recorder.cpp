#include "recording/stinger_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "dynamics/setup/stinger_setup.h"

namespace overbend {
namespace {

/// Visits the varying numbers of a section, in a fixed order.
template <class Section, class Visit>
void visit_numbers(Section& s, const Visit& visit) {
  visit(s.start);
  visit(s.fastest);
  visit(s.at_stop);
  visit(s.hits);
  visit(s.hardest);
  visit(s.hardest_at);
  visit(s.stopped);
}

}  // namespace

std::vector<std::string> moving_sections(const Model& model) {
  std::vector<std::string> names;
  if (!stinger_floats(model)) return names;
  for (const StingerSectionDescription& section : model.description.supports.sections) {
    names.push_back(section.name.empty() ? "stinger" : section.name);
  }
  return names;
}

HingeForce hinge_force(const HingeReading& reading, const Vec3& astern_W) {
  return {reading.force.dot(astern_W), reading.force.z()};
}

StingerRecorder::StingerRecorder(const Model& model) : astern_W_(astern_direction(model.mean_pose)) {
  for (std::string& name : moving_sections(model)) {
    sections_.emplace_back().name = std::move(name);
  }
  sample_.resize(kQuantities * sections_.size());
  statistics_ = RunningStatistics(sample_.size());
}

void StingerRecorder::start(const Assembly& assembly) {
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    sections_[i].start = assembly.hinged().reading(i).angle;
  }
}

void StingerRecorder::add(const Assembly& assembly, double time, double step) {
  if (sections_.empty() || time <= 0.0) return;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    RecordedSection& section = sections_[i];
    const HingeReading reading = assembly.hinged().reading(i);
    const HingeForce force = hinge_force(reading, astern_W_);
    const double values[kQuantities] = {reading.angle,        force.longitudinal,  force.vertical,
                                        reading.force.norm(), reading.stop_moment, reading.draught};
    std::copy_n(values, std::size_t{kQuantities}, sample_.begin() + static_cast<std::ptrdiff_t>(kQuantities * i));
    section.fastest = std::max(section.fastest, std::abs(reading.rate));
    const bool stopped = reading.stop_moment != 0.0;
    section.hits += stopped && section.stopped == 0.0 ? 1.0 : 0.0;
    section.at_stop += stopped ? step : 0.0;
    section.stopped = stopped ? 1.0 : 0.0;
    if (std::abs(reading.stop_moment) > section.hardest) {
      section.hardest = std::abs(reading.stop_moment);
      section.hardest_at = time;
    }
  }
  statistics_.add(sample_, step);
}

std::vector<StingerSectionDynamics> StingerRecorder::results() const {
  std::vector<StingerSectionDynamics> list;
  const std::vector<double> deviation = statistics_.standard_deviation();
  for (std::size_t i = 0; i < sections_.size() && statistics_.weight() > 0.0; ++i) {
    const RecordedSection& section = sections_[i];
    const auto spread = [&](std::size_t quantity) {
      const std::size_t k = kQuantities * i + quantity;
      return SummaryStatistics{statistics_.min()[k], statistics_.max()[k], statistics_.mean()[k], deviation[k]};
    };
    StingerSectionDynamics& r = list.emplace_back();
    r.name = section.name;
    r.angle = spread(kAngle);
    r.hinge_longitudinal = spread(kLongitudinal);
    r.hinge_vertical = spread(kVertical);
    r.hinge_force = spread(kForce);
    r.stop_moment = spread(kStop);
    r.draught = spread(kDraught);
    r.start_angle = section.start;
    r.fastest = section.fastest;
    r.time_at_stop = section.at_stop;
    r.stop_hits = std::llround(section.hits);
  }
  return list;
}

Findings StingerRecorder::findings() const {
  Findings list;
  for (const RecordedSection& section : sections_) {
    if (section.hits > 0.0) {
      list.push_back(Finding{
          FindingCode::stinger_stop_impacts,
          fmt::format(
              "the stinger section '{}' hit a stop {:.0f} times; the largest stop moment, {}, was at t = {:.1f} s",
              section.name, section.hits, shown(section.hardest, "N m", 0), section.hardest_at)}
                         .on(section.name)
                         .at_time(section.hardest_at)
                         .with("moment", section.hardest, "N m"));
    }
  }
  return list;
}

std::vector<double> StingerRecorder::save() const {
  std::vector<double> out;
  for (const RecordedSection& section : sections_) {
    visit_numbers(section, [&](double value) { out.push_back(value); });
  }
  const std::vector<double> statistics = statistics_.save();
  out.insert(out.end(), statistics.begin(), statistics.end());
  return out;
}

void StingerRecorder::restore(const std::vector<double>& saved) {
  std::size_t i = 0;
  for (RecordedSection& section : sections_) {
    visit_numbers(section, [&](double& value) { value = saved.at(i++); });
  }
  statistics_.restore(std::span<const double>(saved).subspan(i));
}

}  // namespace overbend
