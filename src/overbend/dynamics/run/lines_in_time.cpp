#include "dynamics/run/lines_in_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/setup/bed_stretch.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

/// Displacement of an end with its rates.
struct Swing {
  Vec3 amplitude = Vec3::Zero();
  double omega = 0.0, phase = 0.0;
};

Swing swing_of(const LineEndDescription& end) {
  if (end.kind == LineEndKind::body || end.period <= 0.0) return {};
  return {end.amplitude, 2.0 * std::numbers::pi / end.period, end.phase};
}

void add_swing(const Swing& swing, double time, const BuildUp& b, EndMotion& end) {
  const double angle = swing.omega * time + swing.phase;
  const double s = std::sin(angle), rate = swing.omega * std::cos(angle), bend = -swing.omega * swing.omega * s;
  end.place += b.value * s * swing.amplitude;
  end.velocity += (b.rate * s + b.value * rate) * swing.amplitude;
  end.acceleration += (b.acceleration * s + 2.0 * b.rate * rate + b.value * bend) * swing.amplitude;
}

/// Of a force at a node, as it is told: where only elements that pull meet, a push is the inertia of half an element
/// and goes with its length.
double borne(const LineElements& elements, std::size_t node, double tension) {
  const std::size_t last = static_cast<std::size_t>(elements.count) - 1;
  const bool pushed =
      elements.compression[std::min(node, last)] == 1.0 || elements.compression[node > 0 ? node - 1 : 0] == 1.0;
  return pushed ? tension : std::max(tension, 0.0);
}

/// The part along the line of the force that holds an end, negative where it pushes: a line that is stiff bears some
/// compression. Not the force's size with a sign: at a clamped end that bears a weight across the line, it would leap
/// from one side of zero to the other with every small push.
double end_tension(const SystemRun& run, std::size_t line, LineEnd which) {
  const LineAssembly& at = run.assembly().line(line);
  const std::size_t node = static_cast<std::size_t>(at.end_node(which));
  const Vec3 along = Eigen::Map<const Vec3>(run.state().lines[line].q.data() + 6 * node + 3);
  const double tension = (which == LineEnd::last ? 1.0 : -1.0) * run.end_force(line, which).dot(along.normalized());
  return borne(at.line().elements, node, tension);
}

}  // namespace

LeadEnds moving_ends(const Model& model, VesselMotionModel vessel, double build_up) {
  std::vector<Swing> swings;
  for (const FreeLineDescription& line : model.description.lines) {
    swings.push_back(swing_of(line.first));
    swings.push_back(swing_of(line.second));
  }
  return [swings, vessel = std::move(vessel), build_up](const System& system, double time, Surroundings& now) {
    const BuildUp b = half_cosine(time, build_up);
    now.bodies.front() = vessel_motion(vessel, time, b);
    lead_attachments(system, now);
    for (std::size_t i = 0; i < swings.size(); ++i) add_swing(swings[i], time, b, now.ends[i]);
  };
}

SystemState resting_lines(const System& system, const SystemState& at_rest, const LinesRest& rest, double time) {
  std::vector<std::vector<double>> q;
  for (const LineState& line : at_rest.lines) q.push_back(line.q);
  SystemState state = state_at_rest(system, q, time);
  for (std::size_t i = 0; i < system.lines.size(); ++i) {
    if (rest.in_bows[i]) {
      state.lines[i].bed_slip = at_rest.lines[i].bed_slip;
    } else {
      stretch_bed(system.lines[i], state.lines[i]);
    }
  }
  return state;
}

LineRecorder::LineRecorder(const System& system) {
  for (const Line& line : system.lines) {
    LineHistory history;
    history.least_tension.assign(static_cast<std::size_t>(line.mesh.nodes()), 1e300);
    history.most_tension.assign(static_cast<std::size_t>(line.mesh.nodes()), -1e300);
    lines_.push_back(std::move(history));
  }
}

void LineRecorder::stepped(const SystemRun& run) {
  if (run.time() < 0.0) return;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    LineHistory& line = lines_[i];
    const double first = end_tension(run, i, LineEnd::first), last = end_tension(run, i, LineEnd::last);
    line.least_first = std::min(line.least_first, first);
    line.most_first = std::max(line.most_first, first);
    line.least_last = std::min(line.least_last, last);
    line.most_last = std::max(line.most_last, last);
    // A step stands for the time that it took: rows may all fall on one phase of a swing.
    if (run.time() > 0.0) line.ends.add(std::array{first, last}, run.state().last_step);
    // Of every step: a slack line's snatch is over between two rows.
    const std::vector<double>& q = run.state().lines[i].q;
    for (std::size_t node = 0; node < line.least_tension.size(); ++node) {
      const CutForces cut = cut_at_node(run.assembly().line(i).cuts(), q, node);
      const Vec3 tangent = Eigen::Map<const Vec3>(q.data() + 6 * node + 3).normalized();
      const double tension = borne(run.assembly().line(i).line().elements, node, cut.force.dot(tangent));
      line.least_tension[node] = std::min(line.least_tension[node], tension);
      line.most_tension[node] = std::max(line.most_tension[node], tension);
    }
  }
}

void LineRecorder::save(DynamicCheckpoint& checkpoint) const {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const LineHistory& line = lines_[i];
    const std::string name = "history/" + std::to_string(i) + "/";
    const auto put = [&](const char* part, std::vector<double> values) {
      checkpoint.arrays.push_back({name + part, std::move(values)});
    };
    put("time", line.time);
    put("first", line.first);
    put("last", line.last);
    put("ends", {line.least_first, line.most_first, line.least_last, line.most_last});
    put("statistics", line.ends.save());
    put("least", line.least_tension);
    put("most", line.most_tension);
  }
}

void LineRecorder::restore(const DynamicCheckpoint& checkpoint) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    LineHistory& line = lines_[i];
    const std::string name = "history/" + std::to_string(i) + "/";
    const auto get = [&](const char* part) -> const std::vector<double>& {
      return checkpoint_array(checkpoint, name + part);
    };
    line.time = get("time");
    line.first = get("first");
    line.last = get("last");
    const std::vector<double>& ends = get("ends");
    line.least_first = ends.at(0);
    line.most_first = ends.at(1);
    line.least_last = ends.at(2);
    line.most_last = ends.at(3);
    line.ends.restore(get("statistics"));
    line.least_tension = get("least");
    line.most_tension = get("most");
  }
}

void LineRecorder::row(const SystemRun& run) {
  if (run.time() < 0.0) return;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    LineHistory& line = lines_[i];
    line.time.push_back(run.time());
    line.first.push_back(end_tension(run, i, LineEnd::first));
    line.last.push_back(end_tension(run, i, LineEnd::last));
  }
}

}  // namespace overbend
