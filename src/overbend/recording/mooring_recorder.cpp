#include "recording/mooring_recorder.h"

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

constexpr double kSlackFraction = 0.1;  ///< Fraction of the initial tension below which a line is called slack [-].
constexpr double kTautFraction = 0.2;   ///< Fraction of the initial tension above which a slack line is taut again
                                        ///< [-].
constexpr std::size_t kMaxEvents = 50;  ///< Maximum number of events stored per line.
/// Kinds of line events.
enum Kind : std::size_t { kSlackens, kTightens, kParts, kRenders, kSlips };
constexpr std::array<const char*, 5> kEventNames = {"slack", "taut", "parted", "brake renders", "anchor slips"};

/// Minimum over the segments; empty if no segment has one.
std::optional<double> breaking_load(const MooringLineDescription& line) {
  std::optional<double> min_load;
  for (const LineSegmentDescription& segment : line.segments) {
    if (const auto& load = segment.type.breaking_load; load && (!min_load || *load < *min_load)) min_load = load;
  }
  return min_load;
}

WinchDescription find_winch(const MooringsDescription& moorings, const std::string& winch) {
  for (const WinchDescription& candidate : moorings.winches) {
    if (candidate.name == winch) return candidate;
  }
  return {};
}

/// Force of the line on its anchor, upwards [N].
double uplift_at(const LineAssembly& line) {
  return -line.end_force(LineEnd::first)[2];
}

/// The anchor node itself is on the seabed: its length does not count if no other node is.
double bearing_length(const Line& line, const LineState& state) {
  const double length = length_on_bed(line, state.q);
  return length > 0.75 * line.mesh.length.front() ? length : 0.0;
}

/// Finds the indices of the attachments of the ends of a line.
void find_attachments(const std::vector<Attachment>& attachments, int line, std::size_t& fairlead,
                      std::size_t& anchor) {
  for (std::size_t i = 0; i < attachments.size(); ++i) {
    if (attachments[i].line == line) (attachments[i].end == LineEnd::last ? fairlead : anchor) = i;
  }
}

/// Unstressed length, including the payout of a winch [m].
double unstressed_length_with_payout(const LineMesh& mesh, const AttachmentState& fairlead) {
  const double paid_out = fairlead.payout.last_element > 0.0 ? fairlead.payout.last_element - mesh.length.back() : 0.0;
  return mesh.total_length() + paid_out;
}

/// Position and tension at a node.
Eigen::Vector4d node_values(const LineAssembly& line, const std::vector<double>& q, std::size_t node) {
  const Vec3 place = Eigen::Map<const Vec3>(q.data() + 6 * node);
  const Vec3 tangent = Eigen::Map<const Vec3>(q.data() + 6 * node + 3).normalized();
  return {place.x(), place.y(), place.z(), cut_at_node(line.cuts(), q, node).force.dot(tangent)};
}

/// Position and tension at a fraction of the length, linear between nodes.
Eigen::Vector4d point_values(const LineAssembly& line, const std::vector<double>& q, double share) {
  const std::vector<double>& s = line.line().mesh.s;
  const double arc_length = s.front() + share * line.line().mesh.total_length();
  const auto after = std::upper_bound(s.begin() + 1, s.end() - 1, arc_length);
  const auto node = static_cast<std::size_t>(after - s.begin());
  const double part = std::clamp((arc_length - s[node - 1]) / (s[node] - s[node - 1]), 0.0, 1.0);
  return (1.0 - part) * node_values(line, q, node - 1) + part * node_values(line, q, node);
}

}  // namespace

MooringRecorder::MooringRecorder(const std::optional<MooringsDescription>& moorings,
                                 const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto described = std::find_if(moorings->lines.begin(), moorings->lines.end(),
                                        [&](const MooringLineDescription& line) { return line.name == name; });
    const WinchDescription winch = find_winch(*moorings, described->winch);
    RecordedLine line;
    line.name = name;
    line.breaking = breaking_load(*described);
    line.working = moorings->working_load;
    line.brake = winch.brake;
    line.stall = winch.stall ? winch.stall : winch.haul;  // as in the winch itself
    line.holding = described->anchor_holding.holding;
    line.slides = described->anchor_holding.slides;
    lines_.push_back(std::move(line));
    lines_.back().events.reserve(kMaxEvents);
  }
  sample_.resize(kQuantities * lines_.size());
  statistics_ = RunningStatistics(sample_.size());
}

void MooringRecorder::evaluate(const SystemState& state, const Assembly& assembly) {
  const bool quasi_static = moored_quasi_statically(assembly);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    double* const values = sample_.data() + kQuantities * i;
    values[kFairlead] = mooring_tension(assembly, state, i, LineEnd::last);
    values[kAnchor] = mooring_tension(assembly, state, i, LineEnd::first);
    if (quasi_static) {
      const LineEndForces& line = state.bodies.front().lines[i];
      values[kOnBed] = line.on_bed;
      values[kUplift] = line.anchor_uplift;
      values[kLength] = line.length;
    } else {
      const LineAssembly& line = mooring_line(assembly, i);
      values[kOnBed] = bearing_length(line.line(), state.lines[first_ + i]);
      values[kUplift] = values[kOnBed] > 0.0 ? 0.0 : uplift_at(line);
      values[kLength] = unstressed_length_with_payout(line.line().mesh, state.attachments[lines_[i].fairlead_end]);
    }
    values[kUplift] = std::max(0.0, values[kUplift]);
    const bool is_attached =
        !lines_[i].parted_at && (quasi_static || !state.attachments[lines_[i].fairlead_end].parted);
    values[kSlack] = is_attached && values[kFairlead] < kSlackFraction * lines_[i].start ? 1.0 : 0.0;
  }
}

void MooringRecorder::start(const SystemState& state, const Assembly& assembly) {
  quasi_static_ = moored_quasi_statically(assembly);
  first_ = first_line(assembly.system(), LineRole::mooring);
  for (std::size_t i = 0; i < (quasi_static_ ? 0 : lines_.size()); ++i) {
    find_attachments(assembly.system().attachments, static_cast<int>(first_ + i), lines_[i].fairlead_end,
                     lines_[i].anchor_end);
    const LineMesh& mesh = mooring_line(assembly, i).line().mesh;
    lines_[i].points.clear();
    for (const double s : mesh.s) lines_[i].points.push_back((s - mesh.s.front()) / mesh.total_length());
    lines_[i].last_element = mesh.length.back();
    lines_[i].length = mesh.total_length();
  }
  evaluate(state, assembly);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].start = sample(i, kFairlead);
    if (quasi_static_) lines_[i].length = sample(i, kLength);
  }
}

int MooringRecorder::points() const {
  std::size_t sum = 0;
  for (const RecordedLine& line : lines_) sum += line.points.size();
  return static_cast<int>(sum);
}

double* MooringRecorder::append_snapshot(const SystemState& state, const Assembly& assembly, double* out) const {
  for (std::size_t i = 0; i < (quasi_static_ ? 0 : lines_.size()); ++i) {
    const LineAssembly& line = mooring_line(assembly, i);
    for (const double share : lines_[i].points) {
      const Eigen::Vector4d point = point_values(line, state.lines[first_ + i].q, share);
      out = std::copy_n(point.data(), 4, out);
    }
  }
  return out;
}

void MooringRecorder::add(const SystemState& state, const Assembly& assembly, double step) {
  evaluate(state, assembly);
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
      watch_element(i, state.attachments[lines_[i].fairlead_end].payout, mooring_line(assembly, i).line().mesh);
    }
    if (!lines_[i].parted_at) watch_slack(i, state.time);
  }
}

bool MooringRecorder::is_intact(const SystemState& state) const {
  return std::none_of(lines_.begin(), lines_.end(), [&](const RecordedLine& line) {
    return line.parted_at || (!quasi_static_ && (state.attachments[line.fairlead_end].parted ||
                                                 state.attachments[line.anchor_end].parted));
  });
}

void MooringRecorder::note(std::size_t line, const char* what, double time) {
  std::vector<LineEvent>& events = lines_[line].events;
  if (events.size() < kMaxEvents) events.push_back({time, what});
}

void MooringRecorder::watch_ends(std::size_t line, const SystemState& state) {
  RecordedLine& watched = lines_[line];
  const AttachmentState &fairlead = state.attachments[watched.fairlead_end],
                        &anchor = state.attachments[watched.anchor_end];
  if (!watched.parted_at && (fairlead.parted || anchor.parted)) {
    watched.parted_at = state.time;
    note(line, kEventNames[kParts], state.time);
  }
  const auto update = [&](const PayoutState& payout, bool& is_active, double& sum, Kind kind) {
    const bool yields = payout.mode == PayoutMode::rendering && payout.rendered_length > sum;
    if (yields && !is_active) note(line, kEventNames[kind], state.time);
    is_active = yields;
    sum = payout.rendered_length;
  };
  update(fairlead.payout, watched.renders, watched.rendered, kRenders);
  update(anchor.payout, watched.slips, watched.slipped, kSlips);
}

void MooringRecorder::watch_element(std::size_t line, const PayoutState& payout, const LineMesh& mesh) {
  RecordedLine& watched = lines_[line];
  watched.stalled_time = payout.stalled_time;
  if (payout.last_element > 0.0) {
    const double share = payout.last_element / mesh.length.back();
    watched.min_element_ratio = std::min(watched.min_element_ratio, share);
    watched.max_element_ratio = std::max(watched.max_element_ratio, share);
  }
}

void MooringRecorder::watch_slack(std::size_t line, double time) {
  RecordedLine& watched = lines_[line];
  const double tension = sample(line, kFairlead);
  if (!watched.slack && tension < kSlackFraction * watched.start) {
    watched.slack = true;
    note(line, kEventNames[kSlackens], time);
  } else if (watched.slack && tension > kTautFraction * watched.start) {
    watched.slack = false;
    note(line, kEventNames[kTightens], time);
  }
}

bool MooringRecorder::hauled_in(std::size_t line) const {
  constexpr double kMinChange = 0.01;  // minimum change that is reported [m]
  return statistics_.weight() > 0.0 &&
         statistics_.min()[kQuantities * line + kLength] < lines_[line].length - kMinChange;
}

Findings MooringRecorder::findings() const {
  Findings list;
  const auto warn = [&](FindingCode code, const RecordedLine& line, const Peak& peak,
                        const std::optional<double>& limit, const char* limit_name) {
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
  for (const RecordedLine& line : lines_) {
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

/// Warns of a lifted anchor, of no length on the seabed and of slack.
void MooringRecorder::warn_of_shape(std::size_t line, Findings& list) const {
  const RecordedLine& watched = lines_[line];
  if (statistics_.weight() <= 0.0) return;
  const auto index = [&](Quantity quantity) { return kQuantities * line + quantity; };
  if (watched.uplift.value > 0.0) {
    list.push_back(Finding{
        FindingCode::anchor_lifted,
        fmt::format(
            "mooring line \"{}\" lifted its anchor with {} at t = {:.1f} s: no length of it remained on the seabed",
            watched.name, shown(watched.uplift.value, "N", 1), watched.uplift.time)}
                       .on("mooring line " + watched.name)
                       .at_time(watched.uplift.time)
                       .with("uplift", watched.uplift.value, "N"));
  } else if (statistics_.min()[index(kOnBed)] <= 0.0) {
    list.push_back(Finding{FindingCode::no_length_on_seabed,
                           fmt::format("mooring line \"{}\" had no length on the seabed at times", watched.name)}
                       .on("mooring line " + watched.name));
  }
  warn_of_winch(watched, list);
  const double slack = statistics_.mean()[index(kSlack)] * statistics_.weight();
  if (slack > 0.0) {
    list.push_back(Finding{FindingCode::line_slack,
                           fmt::format("mooring line \"{}\" was slack for a total of {:.1f} s, with less than a "
                                       "tenth of its initial tension; snap loads occur when it tightens",
                                       watched.name, slack)}
                       .on("mooring line " + watched.name)
                       .with("duration", slack, "s"));
  }
}

void MooringRecorder::warn_of_winch(const RecordedLine& line, Findings& list) {
  constexpr double kMinElement = 0.5, kMaxElement = 1.5;
  constexpr double kLongElement = 0.075;  // 1.5 times the maximum element length of a cable by its rule
  constexpr double kMinReported = 0.01;   // minimum that is reported [m], [s]
  if (line.rendered > kMinReported) {
    list.push_back(
        Finding{FindingCode::winch_rendered,
                fmt::format("the winch of mooring line \"{}\" rendered: its brake, set to {}, slipped by {}", line.name,
                            shown(line.brake.value_or(0.0), "N", 1), shown(line.rendered, "m", 2))}
            .on("mooring line " + line.name)
            .with("length", line.rendered, "m"));
  }
  if (line.stalled_time > kMinReported) {
    list.push_back(
        Finding{FindingCode::winch_stalled,
                fmt::format("the winch of mooring line \"{}\" could not haul in for {:.1f} s: it stalls at {}",
                            line.name, line.stalled_time, shown(line.stall.value_or(0.0), "N", 1))}
            .on("mooring line " + line.name)
            .with("duration", line.stalled_time, "s"));
  }
  if (line.slipped > kMinReported) {
    list.push_back(Finding{
        FindingCode::anchor_dragged,
        fmt::format("the anchor of mooring line \"{}\" dragged by {}: its holding power is {}, reduced by the uplift",
                    line.name, shown(line.slipped, "m", 2), shown(line.holding.value_or(0.0), "N", 1))}
                       .on("mooring line " + line.name)
                       .with("distance", line.slipped, "m"));
  }
  if (line.min_element_ratio < kMinElement || line.max_element_ratio > kMaxElement) {
    list.push_back(
        Finding{FindingCode::winch_element_stretched,
                fmt::format("the winch of mooring line \"{}\" changed the length of the line's last element to {:.2f} "
                            "to {:.2f} times its initial length: forces are less accurate outside 0.5 to 1.5",
                            line.name, line.min_element_ratio, line.max_element_ratio)}
            .on("mooring line " + line.name));
  }
  if (line.last_element > kLongElement * line.length) {
    list.push_back(Finding{FindingCode::winch_element_stretched,
                           fmt::format("the last element of mooring line \"{}\" is {} long, as the payout of its winch "
                                       "requires: its shape and tension are less accurate",
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

std::vector<MooringLineDynamics> MooringRecorder::results() const {
  std::vector<MooringLineDynamics> results;
  const std::vector<double> deviation = statistics_.standard_deviation();
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto spread = [&](Quantity quantity) {
      const std::size_t k = kQuantities * i + quantity;
      return SummaryStatistics{statistics_.min()[k], statistics_.max()[k], statistics_.mean()[k], deviation[k]};
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
    line.min_on_seabed = spread(kOnBed).min;
    line.max_uplift = lines_[i].uplift.value;
    line.time_slack = spread(kSlack).mean * statistics_.weight();
    line.length = spread(kLength);
    line.points = lines_[i].points;
    line.parted_at = lines_[i].parted_at;
    line.brake_rendered = lines_[i].rendered;
    line.anchor_slip = lines_[i].slipped;
    for (const LineEvent& event : lines_[i].events) line.events.push_back({event.time, event.what});
    results.push_back(line);
  }
  return results;
}

std::vector<double> MooringRecorder::save() const {
  const std::vector<double> statistics = statistics_.save();
  std::vector<double> out{static_cast<double>(statistics.size())};
  out.insert(out.end(), statistics.begin(), statistics.end());
  for (const RecordedLine& line : lines_) {
    for (const Peak& peak : {line.fairlead, line.anchor, line.uplift, line.intact_fairlead, line.intact_anchor}) {
      out.insert(out.end(), {peak.value, peak.time});
    }
    const double parted = line.parted_at.value_or(std::numeric_limits<double>::quiet_NaN());
    out.insert(out.end(), {line.slack ? 1.0 : 0.0, line.renders ? 1.0 : 0.0, line.slips ? 1.0 : 0.0, parted,
                           line.rendered, line.slipped, line.stalled_time, line.min_element_ratio,
                           line.max_element_ratio, static_cast<double>(line.events.size())});
    for (const LineEvent& event : line.events) {
      const auto kind = std::find(kEventNames.begin(), kEventNames.end(), event.what) - kEventNames.begin();
      out.insert(out.end(), {event.time, static_cast<double>(kind)});
    }
  }
  return out;
}

void MooringRecorder::restore(const std::vector<double>& saved) {
  const std::size_t statistics_size = static_cast<std::size_t>(saved.at(0));
  statistics_.restore(std::span(saved).subspan(1, statistics_size));
  std::size_t index = 1 + statistics_size;
  const auto next = [&] { return saved.at(index++); };
  for (RecordedLine& line : lines_) {
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
    line.stalled_time = next();
    line.min_element_ratio = next();
    line.max_element_ratio = next();
    line.events.clear();
    for (std::size_t left = static_cast<std::size_t>(next()); left > 0; --left) {
      const double time = next();
      line.events.push_back({time, kEventNames.at(static_cast<std::size_t>(next()))});
    }
  }
}

}  // namespace overbend
