#include "dynamics/integrator/tension_monitors.h"

#include <algorithm>
#include <limits>

#include "base/ranges.h"

namespace overbend {
namespace {

/// If a tension requires a step shorter than this share of the step taken, the step is repeated.
constexpr double kRepeatStepShare = 0.3;
constexpr std::size_t kNumbers = 4;  ///< Numbers per monitored tension in a checkpoint.

/// Ends that pay out, render or drag absorb jerks themselves and converge in steps of usual length only. Tension
/// changes by impacts on the pipe at a tensioner are not resolved further either.
bool follows_snaps(const System& system) {
  return ranges::none_of(system.attachments, [](const Attachment& held) {
    return held.tensioner || held.winch || held.holding < std::numeric_limits<double>::infinity();
  });
}

}  // namespace

std::vector<TensionMonitors::MonitoredTension> TensionMonitors::find_monitored_tensions(const System& system) {
  std::vector<MonitoredTension> all;
  const int tensioners = static_cast<int>(find_tensioners(system).size());
  for (int i = 0; i < tensioners; ++i) all.push_back({.tensioner = i});
  if (tensioners > 0) return all;
  for (std::size_t line = 0; line < system.lines.size(); ++line) {
    for (const LineEnd end : {LineEnd::first, LineEnd::last}) {
      const std::optional<std::size_t> held = find_attachment(system, line, end);
      if (held && system.attachments[*held].hold_place) all.push_back({.line = static_cast<int>(line), .end = end});
    }
  }
  for (std::size_t i = 0; i < system.wires.size(); ++i) all.push_back({.wire = static_cast<int>(i)});
  return all;
}

TensionMonitors::TensionMonitors(const System& system, double time_scale)
    : monitored_(find_monitored_tensions(system)),
      min_steps_{kShortStep * time_scale, kShortStep * time_scale},
      follows_snaps_(follows_snaps(system)),
      monitors_(monitored_.size()) {
  if (follows_snaps_) min_steps_.snap = kEventStep * time_scale;
}

double TensionMonitors::tension(const Assembly& assembly, std::size_t watch) const {
  const MonitoredTension& of = monitored_[watch];
  if (of.tensioner >= 0) return assembly.tension(static_cast<std::size_t>(of.tensioner));
  if (of.wire >= 0) return assembly.wires()[static_cast<std::size_t>(of.wire)].tension;
  return Eigen::Map<const Vec3>(assembly.line(static_cast<std::size_t>(of.line)).end_force(of.end).data()).norm();
}

void TensionMonitors::start(const Assembly& assembly) {
  for (std::size_t i = 0; i < monitors_.size(); ++i) monitors_[i].start(tension(assembly, i));
}

double TensionMonitors::max_allowed_step(const Assembly& assembly, double h) const {
  double max_step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < monitors_.size(); ++i) {
    max_step = std::min(max_step, monitors_[i].max_allowed_step(tension(assembly, i), h, min_steps_));
  }
  return max_step;
}

bool TensionMonitors::snapped(double h, double max_step) const {
  return follows_snaps_ && max_step < kRepeatStepShare * h;
}

void TensionMonitors::took(const Assembly& assembly, double h) {
  for (std::size_t i = 0; i < monitors_.size(); ++i) monitors_[i].took(tension(assembly, i), h);
}

void TensionMonitors::renew(const Assembly& assembly) {
  for (std::size_t i = 0; i < monitors_.size(); ++i) monitors_[i].last = tension(assembly, i);
}

std::vector<double> TensionMonitors::save() const {
  std::vector<double> saved;
  for (const TensionMonitor& watch : monitors_) {
    saved.insert(saved.end(), {watch.last, watch.slope, watch.min_tension, watch.max_tension});
  }
  return saved;
}

void TensionMonitors::restore(const std::vector<double>& saved) {
  for (std::size_t i = 0; i < monitors_.size(); ++i) {
    const double* const v = &saved.at(kNumbers * i);
    monitors_[i] = {v[0], v[1], v[2], v[3]};
  }
}

}  // namespace overbend
