#include "dynamics/integrator/tension_watches.h"

#include <algorithm>
#include <limits>

namespace overbend {
namespace {

constexpr double kFarShorter = 0.3;  ///< Than the step taken, the one that its tension asks for: it is taken again.
constexpr std::size_t kNumbers = 4;  ///< Of a watch, in a checkpoint.

/// Ends that give way take the force of jerks themselves, and settle in steps of usual length only; what impacts put on
/// the pipe at a tensioner is not followed further either.
bool follows_snaps(const System& system) {
  return std::ranges::none_of(system.attachments, [](const Attachment& held) {
    return held.tensioner || held.winch || held.holding < std::numeric_limits<double>::infinity();
  });
}

}  // namespace

std::vector<TensionWatches::Watched> TensionWatches::watched_of(const System& system) {
  std::vector<Watched> all;
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

TensionWatches::TensionWatches(const System& system, double time_scale)
    : watched_(watched_of(system)),
      shortest_{kShortStep * time_scale, kShortStep * time_scale},
      follows_snaps_(follows_snaps(system)),
      watches_(watched_.size()) {
  if (follows_snaps_) shortest_.snap = kEventStep * time_scale;
}

double TensionWatches::tension(const Assembly& assembly, std::size_t watch) const {
  const Watched& of = watched_[watch];
  if (of.tensioner >= 0) return assembly.tension(static_cast<std::size_t>(of.tensioner));
  if (of.wire >= 0) return assembly.wires()[static_cast<std::size_t>(of.wire)].tension;
  return Eigen::Map<const Vec3>(assembly.line(static_cast<std::size_t>(of.line)).end_force(of.end).data()).norm();
}

void TensionWatches::start(const Assembly& assembly) {
  for (std::size_t i = 0; i < watches_.size(); ++i) watches_[i].start(tension(assembly, i));
}

double TensionWatches::longest_step(const Assembly& assembly, double h) const {
  double longest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    longest = std::min(longest, watches_[i].longest_step(tension(assembly, i), h, shortest_));
  }
  return longest;
}

bool TensionWatches::snapped(double h, double longest) const {
  return follows_snaps_ && longest < kFarShorter * h;
}

void TensionWatches::took(const Assembly& assembly, double h) {
  for (std::size_t i = 0; i < watches_.size(); ++i) watches_[i].took(tension(assembly, i), h);
}

void TensionWatches::renew(const Assembly& assembly) {
  for (std::size_t i = 0; i < watches_.size(); ++i) watches_[i].last = tension(assembly, i);
}

std::vector<double> TensionWatches::save() const {
  std::vector<double> saved;
  for (const TensionWatch& watch : watches_) {
    saved.insert(saved.end(), {watch.last, watch.slope, watch.least, watch.most});
  }
  return saved;
}

void TensionWatches::restore(const std::vector<double>& saved) {
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    const double* const v = &saved.at(kNumbers * i);
    watches_[i] = {v[0], v[1], v[2], v[3]};
  }
}

}  // namespace overbend
