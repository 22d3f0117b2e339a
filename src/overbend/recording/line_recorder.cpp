#include "recording/line_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/pipe/line_types.h"

namespace overbend {
namespace {

constexpr double kSlack = 0.01;   ///< Fraction of the maximum static tension below which a line is slack [-].
constexpr double kPushed = 0.01;  ///< Compression relative to the maximum tension that is reported [-].

const FreeLineDescription& described(const Model& model, const std::string& name) {
  return *ranges::find(model.description.lines, name, &FreeLineDescription::name);
}

bool bends(const FreeLineDescription& line) {
  return has_pipe_section(line) || ranges::any_of(line.segments, [](const LineSegmentDescription& segment) {
           return segment.type.bending_stiffness > 0.0;
         });
}

}  // namespace

LineRecorder::LineRecorder(const Model& model, const System& system, const std::vector<FollowedLine>& lines)
    : model_(&model) {
  for (const FollowedLine& followed : lines) {
    const FreeLineDescription& description = described(model, followed.name);
    RecordedLine line;
    line.line = followed;
    line.arc = followed.is_wire() ? std::vector<double>{0.0, unstressed_length(description)}
                                  : system.lines[static_cast<std::size_t>(followed.line)].mesh.s;
    line.min_tension.assign(line.arc.size(), 1e300);
    line.max_tension.assign(line.arc.size(), -1e300);
    if (bends(description)) line.moment.assign(line.arc.size(), 0.0);
    lines_.push_back(std::move(line));
  }
}

void LineRecorder::add(const SystemState& state, const Assembly& assembly) {
  if (state.time < 0.0) return;
  for (RecordedLine& line : lines_) {
    const double first = end_tension(assembly, state, line.line, LineEnd::first);
    const double last = end_tension(assembly, state, line.line, LineEnd::last);
    line.min_first = std::min(line.min_first, first);
    line.max_first = std::max(line.max_first, first);
    line.min_last = std::min(line.min_last, last);
    line.max_last = std::max(line.max_last, last);
    // Weighted by the step length: output rows could all have the same phase of an oscillation.
    if (state.time > 0.0) line.ends.add(std::array{first, last}, state.last_step);
    // At every step: the snap load of a slack line may end between two rows.
    for (std::size_t node = 0; node < line.min_tension.size(); ++node) {
      const double tension = node_tension(assembly, state, line.line, node);
      line.min_tension[node] = std::min(line.min_tension[node], tension);
      line.max_tension[node] = std::max(line.max_tension[node], tension);
    }
    for (std::size_t node = 0; node < line.moment.size(); ++node) {
      line.moment[node] = std::max(line.moment[node], node_moment(assembly, state, line.line, node));
    }
  }
}

int LineRecorder::points() const {
  std::size_t points = 0;
  for (const RecordedLine& line : lines_) points += line.min_tension.size();
  return static_cast<int>(points);
}

double* LineRecorder::append_snapshot(const SystemState& state, const Assembly& assembly, double* out) const {
  for (const RecordedLine& line : lines_) {
    for (std::size_t node = 0; node < line.min_tension.size(); ++node) {
      const Vec3 place = node_place(assembly, state, line.line, node);
      out = std::copy_n(place.data(), 3, out);
      *out++ = node_tension(assembly, state, line.line, node);
    }
  }
  return out;
}

/// Maximum ratio of tension to breaking load over the run, each segment with its own: the segment with the highest
/// static ratio need not govern. Empty if no segment has a breaking load.
std::optional<double> LineRecorder::utilisation(const RecordedLine& line) const {
  std::optional<double> use;
  double from = 0.0;
  for (const LineSegmentDescription& segment : described(*model_, line.line.name).segments) {
    const double to = from + segment.length.value_or(0.0);
    for (std::size_t node = 0; node < line.arc.size(); ++node) {
      const double s = line.arc[node];
      if (!segment.type.breaking_load || s < from - 1e-9 || s > to + 1e-9) continue;
      use = std::max(use.value_or(0.0), line.max_tension[node] / *segment.type.breaking_load);
    }
    from = to;
  }
  return use;
}

std::vector<LineDynamics> LineRecorder::results() const {
  std::vector<LineDynamics> results;
  for (const RecordedLine& line : lines_) {
    const std::vector<double> deviation = line.ends.standard_deviation();
    LineDynamics out;
    out.name = line.line.name;
    out.first_tension = {line.min_first, line.max_first, line.ends.mean()[0], deviation[0]};
    out.second_tension = {line.min_last, line.max_last, line.ends.mean()[1], deviation[1]};
    out.min_tension = *std::min_element(line.min_tension.begin(), line.min_tension.end());
    out.max_tension = *std::max_element(line.max_tension.begin(), line.max_tension.end());
    out.utilisation = utilisation(line);
    out.moment_at_nodes = line.moment;
    out.min_tension_at_nodes = line.min_tension;
    out.max_tension_at_nodes = line.max_tension;
    results.push_back(std::move(out));
  }
  return results;
}

Findings line_findings(const Model& model, const std::vector<LineResult>& rest,
                       const std::vector<LineDynamics>& lines) {
  Findings findings;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const LineDynamics& line = lines[i];
    const std::string object = "line " + line.name;
    if (const double use = line.utilisation.value_or(0.0); use > 1.0) {
      findings.push_back(Finding{
          FindingCode::breaking_load_exceeded,
          fmt::format("line \"{}\": its largest tension of the run is {:.2f} times its breaking load", line.name, use)}
                             .on(object)
                             .with("utilisation", use, "1"));
    }
    const FreeLineDescription& description = described(model, line.name);
    const bool only_pulls =
        ranges::none_of(description.segments, [](const auto& segment) { return bears_compression(segment.type); });
    const bool wire = is_weightless(description) && !has_pipe_section(description);
    if (only_pulls && wire && line.min_tension <= 0.0) {
      findings.push_back(Finding{FindingCode::line_snaps,
                                 fmt::format("line \"{}\": falls slack and snaps tight, with up to {}: a wire without "
                                             "weight and damping; keep it taut",
                                             line.name, shown_digits(line.max_tension, "N", 3))}
                             .on(object)
                             .with("tension", line.max_tension, "N"));
    } else if (only_pulls && !wire && line.min_tension < kSlack * rest[i].max_tension) {
      findings.push_back(Finding{
          FindingCode::line_snaps,
          fmt::format("line \"{}\": falls slack and snaps tight, with up to {}: the snap load depends on its internal "
                      "damping, assumed as 1 % of critical; keep it taut",
                      line.name, shown_digits(line.max_tension, "N", 3))}
                             .on(object)
                             .with("tension", line.max_tension, "N"));
    } else if (!has_pipe_section(description) && line.min_tension < -kPushed * line.max_tension) {
      findings.push_back(Finding{FindingCode::line_compressed,
                                 fmt::format("line \"{}\": falls slack and is compressed by up to {}: it "
                                             "may buckle, which the model represents only as far as its elements allow",
                                             line.name, shown_digits(-line.min_tension, "N", 3))}
                             .on(object)
                             .with("tension", line.min_tension, "N"));
    }
  }
  return findings;
}

std::vector<double> LineRecorder::save() const {
  std::vector<double> saved;
  for (const RecordedLine& line : lines_) {
    saved.insert(saved.end(), {line.min_first, line.max_first, line.min_last, line.max_last});
    const std::vector<double> ends = line.ends.save();
    saved.insert(saved.end(), ends.begin(), ends.end());
    saved.insert(saved.end(), line.min_tension.begin(), line.min_tension.end());
    saved.insert(saved.end(), line.max_tension.begin(), line.max_tension.end());
    saved.insert(saved.end(), line.moment.begin(), line.moment.end());
  }
  return saved;
}

void LineRecorder::restore(const std::vector<double>& saved) {
  auto from = saved.begin();
  const auto take = [&](std::vector<double>& values) {
    std::copy_n(from, values.size(), values.begin());
    from += static_cast<std::ptrdiff_t>(values.size());
  };
  for (RecordedLine& line : lines_) {
    for (double* value : {&line.min_first, &line.max_first, &line.min_last, &line.max_last}) *value = *from++;
    std::vector<double> ends = line.ends.save();
    take(ends);
    line.ends.restore(ends);
    take(line.min_tension);
    take(line.max_tension);
    take(line.moment);
  }
}

}  // namespace overbend
