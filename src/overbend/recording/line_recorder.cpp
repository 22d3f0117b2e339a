#include "recording/line_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/shown_unit.h"
#include "model/pipe/line_types.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

constexpr double kSlack = 0.01;   ///< Of the largest tension at rest: less is slack.
constexpr double kPushed = 0.01;  ///< Compression, of the largest tension: worth a finding [-].

Vec3 tangent_at(const std::vector<double>& q, std::size_t node) {
  return Eigen::Map<const Vec3>(q.data() + 6 * node + 3).normalized();
}

/// Of a force at a node, as it is recorded: where only elements that pull meet, a push is the inertia of half an
/// element and goes with its length.
double recorded(const LineElements& elements, std::size_t node, double tension) {
  const std::size_t last = static_cast<std::size_t>(elements.count) - 1;
  const bool pushed =
      elements.compression[std::min(node, last)] == 1.0 || elements.compression[node > 0 ? node - 1 : 0] == 1.0;
  return pushed ? tension : std::max(tension, 0.0);
}

double node_tension(const LineAssembly& line, const std::vector<double>& q, std::size_t node) {
  const CutForces cut = cut_at_node(line.cuts(), q, node);
  return recorded(line.line().elements, node, cut.force.dot(tangent_at(q, node)));
}

}  // namespace

double end_tension(const Assembly& assembly, const SystemState& state, std::size_t line, LineEnd end) {
  const LineAssembly& of = assembly.line(line);
  const std::size_t node = static_cast<std::size_t>(of.end_node(end));
  const Vec3 force(Eigen::Map<const Vec3>(of.end_force(end).data()));
  const double along = force.dot(tangent_at(state.lines[line].q, node));
  return recorded(of.line().elements, node, end == LineEnd::last ? along : -along);
}

LineRecorder::LineRecorder(const Model& model, const System& system, std::size_t first, std::size_t count)
    : model_(&model), first_(first) {
  for (std::size_t i = 0; i < count; ++i) {
    const LineMesh& mesh = system.lines[first + i].mesh;
    arc_.push_back(&mesh.s);
    Followed line;
    line.least.assign(static_cast<std::size_t>(mesh.nodes()), 1e300);
    line.most.assign(static_cast<std::size_t>(mesh.nodes()), -1e300);
    lines_.push_back(std::move(line));
  }
}

void LineRecorder::add(const SystemState& state, const Assembly& assembly) {
  if (state.time < 0.0) return;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    Followed& line = lines_[i];
    const double first = end_tension(assembly, state, first_ + i, LineEnd::first);
    const double last = end_tension(assembly, state, first_ + i, LineEnd::last);
    line.least_first = std::min(line.least_first, first);
    line.most_first = std::max(line.most_first, first);
    line.least_last = std::min(line.least_last, last);
    line.most_last = std::max(line.most_last, last);
    // A step stands for the time that it took: rows may all fall on one phase of a swing.
    if (state.time > 0.0) line.ends.add(std::array{first, last}, state.last_step);
    // Of every step: a slack line's snatch is over between two rows.
    const std::vector<double>& q = state.lines[first_ + i].q;
    for (std::size_t node = 0; node < line.least.size(); ++node) {
      const double tension = node_tension(assembly.line(first_ + i), q, node);
      line.least[node] = std::min(line.least[node], tension);
      line.most[node] = std::max(line.most[node], tension);
    }
  }
}

int LineRecorder::points() const {
  std::size_t points = 0;
  for (const Followed& line : lines_) points += line.least.size();
  return static_cast<int>(points);
}

double* LineRecorder::film(const SystemState& state, const Assembly& assembly, double* out) const {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const std::vector<double>& q = state.lines[first_ + i].q;
    for (std::size_t node = 0; node < lines_[i].least.size(); ++node) {
      out = std::copy_n(q.data() + 6 * node, 3, out);
      *out++ = node_tension(assembly.line(first_ + i), q, node);
    }
  }
  return out;
}

/// Largest share of a breaking load over the run, each segment by its own: not that used most at rest need be the one.
/// None where no segment says.
std::optional<double> LineRecorder::utilisation(std::size_t line) const {
  std::optional<double> use;
  double from = 0.0;
  for (const LineSegmentDescription& segment : model_->description.lines[line].segments) {
    const double to = from + segment.length.value_or(0.0);
    for (std::size_t node = 0; node < arc_[line]->size(); ++node) {
      const double s = (*arc_[line])[node];
      if (!segment.type.breaking_load || s < from - 1e-9 || s > to + 1e-9) continue;
      use = std::max(use.value_or(0.0), lines_[line].most[node] / *segment.type.breaking_load);
    }
    from = to;
  }
  return use;
}

std::vector<LineDynamics> LineRecorder::results() const {
  std::vector<LineDynamics> results;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Followed& line = lines_[i];
    const std::vector<double> deviation = line.ends.standard_deviation();
    LineDynamics out;
    out.name = model_->description.lines[i].name;
    out.first_tension = {line.least_first, line.most_first, line.ends.mean()[0], deviation[0]};
    out.second_tension = {line.least_last, line.most_last, line.ends.mean()[1], deviation[1]};
    out.least_tension = *std::min_element(line.least.begin(), line.least.end());
    out.largest_tension = *std::max_element(line.most.begin(), line.most.end());
    out.utilisation = utilisation(i);
    out.least_at_nodes = line.least;
    out.largest_at_nodes = line.most;
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
    const auto& segments = model.description.lines[i].segments;
    const bool only_pulls =
        std::ranges::none_of(segments, [](const auto& segment) { return bears_compression(segment.type); });
    if (only_pulls && line.least_tension < kSlack * rest[i].largest_tension) {
      findings.push_back(
          Finding{FindingCode::line_snaps,
                  fmt::format("line \"{}\": falls slack and snaps tight, with up to {}: how hard hangs on its internal "
                              "damping, which is taken as 1 % of critical; do not let it fall slack",
                              line.name, shown_digits(line.largest_tension, "N", 3))}
              .on(object)
              .with("tension", line.largest_tension, "N"));
    } else if (line.least_tension < -kPushed * line.largest_tension) {
      findings.push_back(
          Finding{FindingCode::line_compressed,
                  fmt::format("line \"{}\": falls slack, and where it is pushed bears {} of compression at most: it "
                              "may buckle, which the model represents only as far as its elements allow",
                              line.name, shown_digits(-line.least_tension, "N", 3))}
              .on(object)
              .with("tension", line.least_tension, "N"));
    }
  }
  return findings;
}

std::vector<double> LineRecorder::save() const {
  std::vector<double> saved;
  for (const Followed& line : lines_) {
    saved.insert(saved.end(), {line.least_first, line.most_first, line.least_last, line.most_last});
    const std::vector<double> ends = line.ends.save();
    saved.insert(saved.end(), ends.begin(), ends.end());
    saved.insert(saved.end(), line.least.begin(), line.least.end());
    saved.insert(saved.end(), line.most.begin(), line.most.end());
  }
  return saved;
}

void LineRecorder::restore(const std::vector<double>& saved) {
  auto from = saved.begin();
  const auto take = [&](std::vector<double>& values) {
    std::copy_n(from, values.size(), values.begin());
    from += static_cast<std::ptrdiff_t>(values.size());
  };
  for (Followed& line : lines_) {
    for (double* value : {&line.least_first, &line.most_first, &line.least_last, &line.most_last}) *value = *from++;
    std::vector<double> ends = line.ends.save();
    take(ends);
    line.ends.restore(ends);
    take(line.least);
    take(line.most);
  }
}

}  // namespace overbend
