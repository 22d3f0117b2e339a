#include "recording/mooring_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/shown_unit.h"
#include "dynamics/machines/mooring_tension.h"
#include "statics/recovery/lines_recovery.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

constexpr double kSlackShare = 0.1;      ///< Of the tension at the start: below it a line is called slack [-].
constexpr double kTautShare = 0.2;       ///< Likewise: above it a slack line is taut again [-].
constexpr std::size_t kMostEvents = 50;  ///< Kept of a line.
/// What can happen to a line.
enum Kind : std::size_t { kSlackens, kTightens, kParts, kRenders, kSlips };
constexpr std::array<const char*, 5> kHappenings = {"slack", "taut", "parted", "brake renders", "anchor slips"};

/// Least of the segments; none where none says.
std::optional<double> breaking_load(const MooringLineDescription& line) {
  std::optional<double> least;
  for (const LineSegmentDescription& segment : line.segments) {
    if (const auto& load = segment.type.breaking_load; load && (!least || *load < *least)) least = load;
  }
  return least;
}

WinchDescription winch_named(const MooringsDescription& moorings, const std::string& winch) {
  for (const WinchDescription& one : moorings.winches) {
    if (one.name == winch) return one;
  }
  return {};
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

/// Where the attachments of the ends of a line stand.
void find_ends(const std::vector<Attachment>& attachments, int line, std::size_t& fairlead, std::size_t& anchor) {
  for (std::size_t i = 0; i < attachments.size(); ++i) {
    if (attachments[i].line == line) (attachments[i].end == LineEnd::last ? fairlead : anchor) = i;
  }
}

/// Unstressed, with what a winch has paid out.
double length_of(const LineMesh& mesh, const AttachmentState& fairlead) {
  const double paid_out = fairlead.way.last_element > 0.0 ? fairlead.way.last_element - mesh.length.back() : 0.0;
  return mesh.total_length() + paid_out;
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
    const WinchDescription winch = winch_named(*moorings, described->winch);
    Watched line;
    line.name = name;
    line.breaking = breaking_load(*described);
    line.working = moorings->working_load;
    line.brake = winch.brake;
    line.stall = winch.stall ? winch.stall : winch.haul;  // as the winch itself has it
    line.holding = described->anchor_holding.holding;
    line.slides = described->anchor_holding.slides;
    lines_.push_back(std::move(line));
    lines_.back().events.reserve(kMostEvents);
  }
  sample_.resize(kQuantities * lines_.size());
  statistics_ = RunningStatistics(sample_.size());
}

void MooringWatch::look(const SystemState& state, const Assembly& assembly) {
  const bool quasi_static = moored_quasi_statically(assembly);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    double* const now = sample_.data() + kQuantities * i;
    now[kFairlead] = mooring_tension(assembly, state, i, LineEnd::last);
    now[kAnchor] = mooring_tension(assembly, state, i, LineEnd::first);
    if (quasi_static) {
      const LineEndForces& line = state.bodies.front().lines[i];
      now[kOnBed] = line.on_bed;
      now[kUplift] = line.anchor_uplift;
      now[kLength] = line.length;
    } else {
      const LineAssembly& line = line_of(assembly, i);
      now[kOnBed] = bearing_length(line.line(), state.lines[first_ + i]);
      now[kUplift] = now[kOnBed] > 0.0 ? 0.0 : uplift_at(line);
      now[kLength] = length_of(line.line().mesh, state.attachments[lines_[i].fairlead_end]);
    }
    now[kUplift] = std::max(0.0, now[kUplift]);
    const bool there = !lines_[i].parted_at && (quasi_static || !state.attachments[lines_[i].fairlead_end].parted);
    now[kSlack] = there && now[kFairlead] < kSlackShare * lines_[i].start ? 1.0 : 0.0;
  }
}

void MooringWatch::start(const SystemState& state, const Assembly& assembly) {
  quasi_static_ = moored_quasi_statically(assembly);
  first_ = first_line(assembly.system(), LineRole::mooring);
  for (std::size_t i = 0; i < (quasi_static_ ? 0 : lines_.size()); ++i) {
    find_ends(assembly.system().attachments, static_cast<int>(first_ + i), lines_[i].fairlead_end,
              lines_[i].anchor_end);
    const LineMesh& mesh = line_of(assembly, i).line().mesh;
    lines_[i].points.clear();
    for (const double s : mesh.s) lines_[i].points.push_back((s - mesh.s.front()) / mesh.total_length());
    lines_[i].last_element = mesh.length.back();
    lines_[i].length = mesh.total_length();
  }
  look(state, assembly);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].start = sample(i, kFairlead);
    if (quasi_static_) lines_[i].length = sample(i, kLength);
  }
}

int MooringWatch::points() const {
  std::size_t sum = 0;
  for (const Watched& line : lines_) sum += line.points.size();
  return static_cast<int>(sum);
}

double* MooringWatch::film(const SystemState& state, const Assembly& assembly, double* out) const {
  for (std::size_t i = 0; i < (quasi_static_ ? 0 : lines_.size()); ++i) {
    const LineAssembly& line = line_of(assembly, i);
    for (const double share : lines_[i].points) {
      const Eigen::Vector4d point = point_of(line, state.lines[first_ + i].q, share);
      out = std::copy_n(point.data(), 4, out);
    }
  }
  return out;
}

void MooringWatch::add(const SystemState& state, const Assembly& assembly, double step) {
  look(state, assembly);
  if (state.time <= 0.0) return;
  statistics_.add(sample_, step);
  const bool intact = is_intact(state);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto keep = [&](Quantity quantity, Peak& peak) {
      if (sample(i, quantity) > peak.value) peak = {sample(i, quantity), state.time};
    };
    keep(kFairlead, lines_[i].fairlead);
    keep(kAnchor, lines_[i].anchor);
    keep(kUplift, lines_[i].uplift);
    if (intact) {
      keep(kFairlead, lines_[i].intact_fairlead);
      keep(kAnchor, lines_[i].intact_anchor);
    }
    if (!quasi_static_) {
      watch_ends(i, state);
      watch_element(i, state.attachments[lines_[i].fairlead_end].way, line_of(assembly, i).line().mesh);
    }
    if (!lines_[i].parted_at) watch_slack(i, state.time);
  }
}

bool MooringWatch::is_intact(const SystemState& state) const {
  return std::none_of(lines_.begin(), lines_.end(), [&](const Watched& line) {
    return line.parted_at || (!quasi_static_ && (state.attachments[line.fairlead_end].parted ||
                                                 state.attachments[line.anchor_end].parted));
  });
}

void MooringWatch::note(std::size_t line, const char* what, double time) {
  std::vector<Happening>& events = lines_[line].events;
  if (events.size() < kMostEvents) events.push_back({time, what});
}

void MooringWatch::watch_ends(std::size_t line, const SystemState& state) {
  Watched& one = lines_[line];
  const AttachmentState &fairlead = state.attachments[one.fairlead_end], &anchor = state.attachments[one.anchor_end];
  if (!one.parted_at && (fairlead.parted || anchor.parted)) {
    one.parted_at = state.time;
    note(line, kHappenings[kParts], state.time);
  }
  const auto gives = [&](const GivenWay& way, bool& now, double& sum, Kind kind) {
    const bool yields = way.how == Giving::yielding && way.gave_way > sum;
    if (yields && !now) note(line, kHappenings[kind], state.time);
    now = yields;
    sum = way.gave_way;
  };
  gives(fairlead.way, one.renders, one.rendered, kRenders);
  gives(anchor.way, one.slips, one.slipped, kSlips);
}

void MooringWatch::watch_element(std::size_t line, const GivenWay& way, const LineMesh& mesh) {
  Watched& one = lines_[line];
  one.held_up_for = way.held_up_for;
  if (way.last_element > 0.0) {
    const double share = way.last_element / mesh.length.back();
    one.least_element = std::min(one.least_element, share);
    one.most_element = std::max(one.most_element, share);
  }
}

void MooringWatch::watch_slack(std::size_t line, double time) {
  Watched& one = lines_[line];
  const double tension = sample(line, kFairlead);
  if (!one.slack && tension < kSlackShare * one.start) {
    one.slack = true;
    note(line, kHappenings[kSlackens], time);
  } else if (one.slack && tension > kTautShare * one.start) {
    one.slack = false;
    note(line, kHappenings[kTightens], time);
  }
}

bool MooringWatch::hauled_in(std::size_t line) const {
  constexpr double kLeast = 0.01;  // less is not worth a word [m]
  return statistics_.weight() > 0.0 && statistics_.min()[kQuantities * line + kLength] < lines_[line].length - kLeast;
}

Findings MooringWatch::findings() const {
  Findings list;
  const auto warn = [&](FindingCode code, const Watched& line, const Peak& peak, const std::optional<double>& limit,
                        const char* limit_name) {
    if (!limit || peak.value <= *limit) return false;
    list.push_back(
        Finding{code, fmt::format("mooring line \"{}\" had {} at t = {:.1f} s, more than {} of {}", line.name,
                                  shown(peak.value, "N", 1), peak.time, limit_name, shown(*limit, "N", 1))}
            .on("mooring line " + line.name)
            .at_time(peak.time)
            .with("tension", peak.value, "N"));
    return true;
  };
  using enum FindingCode;
  for (const Watched& line : lines_) {
    if (!warn(breaking_load_exceeded, line, line.fairlead, line.breaking, "its breaking load")) {
      warn(working_load_exceeded, line, line.fairlead, line.working, "the working load");
    }
    if (!line.slides) {
      warn(anchor_holding_exceeded, line, line.anchor, line.holding, "its anchor's holding power (anchor_slides: no)");
    }
    if (quasi_static_) {
      warn(winch_limit_exceeded, line, line.fairlead, line.brake,
           "its winch's brake (quasi-static lines: not rendered)");
    }
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (quasi_static_ && hauled_in(i)) {
      warn(winch_limit_exceeded, lines_[i], lines_[i].fairlead, lines_[i].stall,
           "its winch's stall (quasi-static lines: not obeyed)");
    }
    warn_of_shape(i, list);
  }
  return list;
}

/// Anchor lifted, or nothing left on the bed; slack.
void MooringWatch::warn_of_shape(std::size_t line, Findings& list) const {
  const Watched& one = lines_[line];
  if (statistics_.weight() <= 0.0) return;
  const auto of = [&](Quantity quantity) { return kQuantities * line + quantity; };
  if (one.uplift.value > 0.0) {
    list.push_back(Finding{
        FindingCode::anchor_lifted,
        fmt::format(
            "mooring line \"{}\" lifted its anchor with {} at t = {:.1f} s: no length of it was left on the bed",
            one.name, shown(one.uplift.value, "N", 1), one.uplift.time)}
                       .on("mooring line " + one.name)
                       .at_time(one.uplift.time)
                       .with("uplift", one.uplift.value, "N"));
  } else if (statistics_.min()[of(kOnBed)] <= 0.0) {
    list.push_back(Finding{FindingCode::no_length_on_seabed,
                           fmt::format("mooring line \"{}\" had no length on the bed at times", one.name)}
                       .on("mooring line " + one.name));
  }
  warn_of_winch(one, list);
  const double slack = statistics_.mean()[of(kSlack)] * statistics_.weight();
  if (slack > 0.0) {
    list.push_back(
        Finding{FindingCode::line_slack, fmt::format("mooring line \"{}\" was slack for {:.1f} s in all: less than a "
                                                     "tenth of its tension at the start; it tightens with a jerk",
                                                     one.name, slack)}
            .on("mooring line " + one.name)
            .with("duration", slack, "s"));
  }
}

void MooringWatch::warn_of_winch(const Watched& line, Findings& list) {
  constexpr double kLeastElement = 0.5, kMostElement = 1.5;
  constexpr double kLongElement = 0.075;  // half as long again as a cable's longest by its rule
  constexpr double kLeast = 0.01;         // less is not worth a word [m], [s]
  if (line.rendered > kLeast) {
    list.push_back(
        Finding{FindingCode::winch_rendered,
                fmt::format("the winch of mooring line \"{}\" rendered: its brake, set to {}, paid out {}", line.name,
                            shown(line.brake.value_or(0.0), "N", 1), shown(line.rendered, "m", 2))}
            .on("mooring line " + line.name)
            .with("length", line.rendered, "m"));
  }
  if (line.held_up_for > kLeast) {
    list.push_back(
        Finding{FindingCode::winch_stalled,
                fmt::format("the winch of mooring line \"{}\" could not haul in for {:.1f} s: it stalls at {}",
                            line.name, line.held_up_for, shown(line.stall.value_or(0.0), "N", 1))}
            .on("mooring line " + line.name)
            .with("duration", line.held_up_for, "s"));
  }
  if (line.slipped > kLeast) {
    list.push_back(
        Finding{FindingCode::anchor_dragged,
                fmt::format("the anchor of mooring line \"{}\" dragged by {}: its holding power is {}, less the uplift",
                            line.name, shown(line.slipped, "m", 2), shown(line.holding.value_or(0.0), "N", 1))}
            .on("mooring line " + line.name)
            .with("distance", line.slipped, "m"));
  }
  if (line.least_element < kLeastElement || line.most_element > kMostElement) {
    list.push_back(
        Finding{FindingCode::winch_element_stretched,
                fmt::format("the winch of mooring line \"{}\" changed the length of the line's last element to {:.2f} "
                            "to {:.2f} times its own: forces are less accurate beyond a half and one and a half",
                            line.name, line.least_element, line.most_element)}
            .on("mooring line " + line.name));
  }
  if (line.last_element > kLongElement * line.length) {
    list.push_back(Finding{FindingCode::winch_element_stretched,
                           fmt::format("the last element of mooring line \"{}\" is {} long, as the way of its winch "
                                       "asks for: its shape and tension are less accurate",
                                       line.name, shown(line.last_element, "m", 0))}
                       .on("mooring line " + line.name));
  }
  if (line.parted_at) {
    list.push_back(
        Finding{FindingCode::line_parted,
                fmt::format("mooring line \"{}\" parted at its fairlead at t = {:.1f} s", line.name, *line.parted_at)}
            .on("mooring line " + line.name)
            .at_time(*line.parted_at));
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
    line.intact_fairlead_tension = lines_[i].intact_fairlead.value;
    line.intact_anchor_tension = lines_[i].intact_anchor.value;
    line.least_on_bed = spread(kOnBed).min;
    line.largest_uplift = lines_[i].uplift.value;
    line.time_slack = spread(kSlack).mean * statistics_.weight();
    line.length = spread(kLength);
    line.points = lines_[i].points;
    line.parted_at = lines_[i].parted_at;
    line.brake_rendered = lines_[i].rendered;
    line.anchor_slip = lines_[i].slipped;
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
    for (const Peak& peak : {line.fairlead, line.anchor, line.uplift, line.intact_fairlead, line.intact_anchor}) {
      out.insert(out.end(), {peak.value, peak.time});
    }
    const double parted = line.parted_at.value_or(std::numeric_limits<double>::quiet_NaN());
    out.insert(out.end(), {line.slack ? 1.0 : 0.0, line.renders ? 1.0 : 0.0, line.slips ? 1.0 : 0.0, parted,
                           line.rendered, line.slipped, line.held_up_for, line.least_element, line.most_element,
                           static_cast<double>(line.events.size())});
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
    for (Peak* peak : {&line.fairlead, &line.anchor, &line.uplift, &line.intact_fairlead, &line.intact_anchor}) {
      peak->value = next();
      peak->time = next();
    }
    line.slack = next() != 0.0;
    line.renders = next() != 0.0;
    line.slips = next() != 0.0;
    const double parted = next();
    line.parted_at = std::isnan(parted) ? std::nullopt : std::optional(parted);
    line.rendered = next();
    line.slipped = next();
    line.held_up_for = next();
    line.least_element = next();
    line.most_element = next();
    line.events.clear();
    for (std::size_t left = static_cast<std::size_t>(next()); left > 0; --left) {
      const double time = next();
      line.events.push_back({time, kHappenings.at(static_cast<std::size_t>(next()))});
    }
  }
}

}  // namespace overbend
