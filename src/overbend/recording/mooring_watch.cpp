#include "recording/mooring_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "statics/lines_recovery.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

constexpr double kSlackShare = 0.1;      ///< Of the tension at the start: below it a line is called slack [-].
constexpr double kTautShare = 0.2;       ///< Likewise: above it a slack line is taut again [-].
constexpr std::size_t kMostEvents = 50;  ///< Kept of a line.
/// What can happen to a line.
constexpr std::array<const char*, 2> kHappenings = {"slack", "taut"};

/// Least of the segments; none where none says.
std::optional<double> breaking_load(const MooringLineDescription& line) {
  std::optional<double> least;
  for (const LineSegmentDescription& segment : line.segments) {
    if (const auto& load = segment.type.breaking_load; load && (!least || *load < *least)) least = load;
  }
  return least;
}

std::optional<double> brake_of(const MooringsDescription& moorings, const std::string& winch) {
  for (const WinchDescription& one : moorings.winches) {
    if (one.name == winch) return one.brake;
  }
  return std::nullopt;
}

double tension_at(const LineAssembly& line, LineEnd end) {
  const std::array<double, 6>& force = line.end_force(end);
  return Vec3(force[0], force[1], force[2]).norm();
}

/// Pull of the line on its anchor, upwards [N].
double uplift_at(const LineAssembly& line) {
  return -line.end_force(LineEnd::first)[2];
}

/// The anchor itself stands on the bed: where no other node does, no length does.
double bearing_length(const Line& line, const LineState& state) {
  const double length = length_on_bed(line, state.q);
  return length > 0.75 * line.mesh.length.front() ? length : 0.0;
}

/// Place and tension at a node.
Eigen::Vector4d node_of(const LineAssembly& line, const std::vector<double>& q, std::size_t node) {
  const Vec3 place = Eigen::Map<const Vec3>(q.data() + 6 * node);
  const Vec3 tangent = Eigen::Map<const Vec3>(q.data() + 6 * node + 3).normalized();
  return {place.x(), place.y(), place.z(), cut_at_node(line.cuts(), q, node).force.dot(tangent)};
}

/// At a share of the length, straight between nodes.
Eigen::Vector4d point_of(const LineAssembly& line, const std::vector<double>& q, double share) {
  const std::vector<double>& s = line.line().mesh.s;
  const double at = s.front() + share * line.line().mesh.total_length();
  const auto after = std::upper_bound(s.begin() + 1, s.end() - 1, at);
  const auto node = static_cast<std::size_t>(after - s.begin());
  const double part = std::clamp((at - s[node - 1]) / (s[node] - s[node - 1]), 0.0, 1.0);
  return (1.0 - part) * node_of(line, q, node - 1) + part * node_of(line, q, node);
}

}  // namespace

MooringWatch::MooringWatch(const std::optional<MooringsDescription>& moorings, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto described = std::find_if(moorings->lines.begin(), moorings->lines.end(),
                                        [&](const MooringLineDescription& line) { return line.name == name; });
    lines_.push_back({name,
                      breaking_load(*described),
                      moorings->working_load,
                      brake_of(*moorings, described->winch),
                      described->anchor_holding.holding,
                      {},
                      {},
                      {},
                      0.0,
                      {},
                      false,
                      {}});
    lines_.back().events.reserve(kMostEvents);
  }
  sample_.resize(kQuantities * lines_.size());
  statistics_ = RunningStatistics(sample_.size());
}

void MooringWatch::look(const SystemState& state, const Assembly& assembly) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const LineAssembly& line = assembly.line(i + 1);
    double* const now = sample_.data() + kQuantities * i;
    now[kFairlead] = tension_at(line, LineEnd::last);
    now[kAnchor] = tension_at(line, LineEnd::first);
    now[kOnBed] = bearing_length(line.line(), state.lines[i + 1]);
    now[kUplift] = now[kOnBed] > 0.0 ? 0.0 : std::max(0.0, uplift_at(line));
    now[kSlack] = now[kFairlead] < kSlackShare * lines_[i].start ? 1.0 : 0.0;
    now[kLength] = line.line().mesh.total_length();
  }
}

void MooringWatch::start(const SystemState& state, const Assembly& assembly) {
  look(state, assembly);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const LineMesh& mesh = assembly.line(i + 1).line().mesh;
    lines_[i].start = sample(i, kFairlead);
    lines_[i].points.clear();
    for (const double s : mesh.s) lines_[i].points.push_back((s - mesh.s.front()) / mesh.total_length());
  }
}

int MooringWatch::points() const {
  std::size_t sum = 0;
  for (const Watched& line : lines_) sum += line.points.size();
  return static_cast<int>(sum);
}

double* MooringWatch::film(const SystemState& state, const Assembly& assembly, double* out) const {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const LineAssembly& line = assembly.line(i + 1);
    for (const double share : lines_[i].points) {
      const Eigen::Vector4d point = point_of(line, state.lines[i + 1].q, share);
      out = std::copy_n(point.data(), 4, out);
    }
  }
  return out;
}

void MooringWatch::add(const SystemState& state, const Assembly& assembly, double step) {
  look(state, assembly);
  if (state.time <= 0.0) return;
  statistics_.add(sample_, step);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto keep = [&](Quantity quantity, Peak& peak) {
      if (sample(i, quantity) > peak.value) peak = {sample(i, quantity), state.time};
    };
    keep(kFairlead, lines_[i].fairlead);
    keep(kAnchor, lines_[i].anchor);
    keep(kUplift, lines_[i].uplift);
    watch_slack(i, state.time);
  }
}

void MooringWatch::note(std::size_t line, const char* what, double time) {
  std::vector<Happening>& events = lines_[line].events;
  if (events.size() < kMostEvents) events.push_back({time, what});
}

void MooringWatch::watch_slack(std::size_t line, double time) {
  Watched& one = lines_[line];
  const double tension = sample(line, kFairlead);
  if (!one.slack && tension < kSlackShare * one.start) {
    one.slack = true;
    note(line, kHappenings[0], time);
  } else if (one.slack && tension > kTautShare * one.start) {
    one.slack = false;
    note(line, kHappenings[1], time);
  }
}

std::vector<std::string> MooringWatch::warnings() const {
  std::vector<std::string> list;
  const auto warn = [&](const Watched& line, const Peak& peak, const std::optional<double>& limit, const char* of) {
    if (!limit || peak.value <= *limit) return false;
    list.push_back(fmt::format("mooring line \"{}\" had {:.1f} kN at t = {:.1f} s, more than {} of {:.1f} kN",
                               line.name, 1e-3 * peak.value, peak.time, of, 1e-3 * *limit));
    return true;
  };
  for (const Watched& line : lines_) {
    if (!warn(line, line.fairlead, line.breaking, "its breaking load")) {
      warn(line, line.fairlead, line.working, "the working load");
    }
    warn(line, line.fairlead, line.brake, "what its winch's brake holds, which does not render here,");
    warn(line, line.anchor, line.holding, "its anchor's holding power, which does not drag here,");
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) warn_of_shape(i, list);
  return list;
}

/// Anchor lifted, or nothing left on the bed; slack.
void MooringWatch::warn_of_shape(std::size_t line, std::vector<std::string>& list) const {
  const Watched& one = lines_[line];
  if (statistics_.weight() <= 0.0) return;
  const auto of = [&](Quantity quantity) { return kQuantities * line + quantity; };
  if (one.uplift.value > 0.0) {
    list.push_back(fmt::format(
        "mooring line \"{}\" lifted its anchor with {:.1f} kN at t = {:.1f} s: no length of it was left on the bed",
        one.name, 1e-3 * one.uplift.value, one.uplift.time));
  } else if (statistics_.min()[of(kOnBed)] <= 0.0) {
    list.push_back(fmt::format("mooring line \"{}\" had no length on the bed at times", one.name));
  }
  const double slack = statistics_.mean()[of(kSlack)] * statistics_.weight();
  if (slack > 0.0) {
    list.push_back(
        fmt::format("mooring line \"{}\" was slack for {:.1f} s in all: less than a tenth of its tension at the start; "
                    "it tightens with a jerk",
                    one.name, slack));
  }
}

std::vector<MooringLineDynamics> MooringWatch::results() const {
  std::vector<MooringLineDynamics> results;
  const std::vector<double> deviation = statistics_.standard_deviation();
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto spread = [&](Quantity quantity) {
      const std::size_t k = kQuantities * i + quantity;
      return Spread{statistics_.min()[k], statistics_.max()[k], statistics_.mean()[k], deviation[k]};
    };
    MooringLineDynamics line;
    line.name = lines_[i].name;
    line.fairlead_tension.whole = spread(kFairlead);
    line.anchor_tension.whole = spread(kAnchor);
    line.start_fairlead_tension = lines_[i].start;
    if (lines_[i].breaking) line.utilisation = line.fairlead_tension.whole.max / *lines_[i].breaking;
    if (lines_[i].holding) line.anchor_utilisation = line.anchor_tension.whole.max / *lines_[i].holding;
    line.least_on_bed = spread(kOnBed).min;
    line.largest_uplift = lines_[i].uplift.value;
    line.time_slack = spread(kSlack).mean * statistics_.weight();
    line.length = spread(kLength);
    line.points = lines_[i].points;
    for (const Happening& event : lines_[i].events) line.events.push_back({event.time, event.what});
    results.push_back(line);
  }
  return results;
}

std::vector<double> MooringWatch::save() const {
  const std::vector<double> statistics = statistics_.save();
  std::vector<double> out{static_cast<double>(statistics.size())};
  out.insert(out.end(), statistics.begin(), statistics.end());
  for (const Watched& line : lines_) {
    for (const Peak& peak : {line.fairlead, line.anchor, line.uplift}) out.insert(out.end(), {peak.value, peak.time});
    out.insert(out.end(), {line.slack ? 1.0 : 0.0, static_cast<double>(line.events.size())});
    for (const Happening& event : line.events) {
      const auto kind = std::find(kHappenings.begin(), kHappenings.end(), event.what) - kHappenings.begin();
      out.insert(out.end(), {event.time, static_cast<double>(kind)});
    }
  }
  return out;
}

void MooringWatch::restore(const std::vector<double>& saved) {
  const std::size_t own = static_cast<std::size_t>(saved.at(0));
  statistics_.restore(std::span(saved).subspan(1, own));
  std::size_t at = 1 + own;
  const auto next = [&] { return saved.at(at++); };
  for (Watched& line : lines_) {
    for (Peak* peak : {&line.fairlead, &line.anchor, &line.uplift}) {
      peak->value = next();
      peak->time = next();
    }
    line.slack = next() != 0.0;
    line.events.clear();
    for (std::size_t left = static_cast<std::size_t>(next()); left > 0; --left) {
      const double time = next();
      line.events.push_back({time, kHappenings.at(static_cast<std::size_t>(next()))});
    }
  }
}

}  // namespace overbend
