#include "dynamics/run/conveyor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overbend {
namespace {

constexpr double kTooLong = 1.5;  ///< Element length over the planned length at its position above which it is split.
/// Combined length of two elements over the planned length below which they are merged.
constexpr double kTooShort = 0.75;
constexpr double kStraight = 1e-6;  ///< Maximum deviation from the cubic of the merged element [m]; of rates [m/s].

double node_strain(const LineState& state, int node) {
  const double* t = state.q.data() + 6 * static_cast<std::ptrdiff_t>(node) + 3;
  return std::hypot(t[0], t[1], t[2]);
}

Vec3 part(const std::vector<double>& values, int node, int first) {
  return Vec3(Eigen::Map<const Vec3>(values.data() + 6 * static_cast<std::ptrdiff_t>(node) + first));
}

/// Sets a guide's unknown from the tangent of the node that it now holds.
void follow_tangent(const LineState& state, int node, MotionValues& guide) {
  const Vec3 t = part(state.q, node, 3), direction = t.normalized();
  guide = {t.norm(), part(state.v, node, 3).dot(direction), part(state.acc, node, 3).dot(direction),
           part(state.algorithmic_acceleration, node, 3).dot(direction)};
}

/// True if a node's position and motion agree with the cubic through its neighbours, to rounding.
bool is_nearly_straight(const Line& line, const LineState& state, int node) {
  const std::size_t e = static_cast<std::size_t>(node) - 1;
  const double lower = line.mesh.length[e], whole = lower + line.mesh.length[e + 1], x = lower / whole;
  const HermiteValues n = hermite(x, whole);
  const auto off = [&](const std::vector<double>& values, const Eigen::Vector4d& weights, int first) {
    const Vec3 sum = weights(0) * part(values, node - 1, 0) + weights(1) * part(values, node - 1, 3) +
                     weights(2) * part(values, node + 1, 0) + weights(3) * part(values, node + 1, 3);
    return (sum - part(values, node, first)).norm();
  };
  return off(state.q, n.value, 0) < kStraight && off(state.v, n.value, 0) < kStraight &&
         whole * off(state.q, n.first, 3) < kStraight;
}

}  // namespace

PieceAbove piece_above(const Model& model, double above) {
  const std::optional<JointDescription>& joint = model.description.pipe.section.joint;
  if (!joint || joint->coated_stiffness <= 1.0) {
    return {0, 0.0, std::numeric_limits<double>::infinity()};
  }
  const double first = joint->first.value_or(0.5 * joint->length) + 0.5 * joint->field_joint;
  const double begun = std::floor((above + first) / joint->length) * joint->length - first;  // field joint
  const double bare = begun + joint->field_joint;
  return above < bare ? PieceAbove{0, begun, bare} : PieceAbove{model.coated, bare, begun + joint->length};
}

Conveyor::Conveyor(const Model& model, const System& system, std::optional<double> element)
    : model_(&model), pipe_(find_laid_pipe(system).value()) {
  const LineMesh& mesh = system.lines[pipe_.line].mesh;
  element_ = element.value_or(mesh.length.back());
  for (std::size_t e = mesh.length.size(); e-- > 0;) {
    plan_from_.push_back(mesh.s.back() - mesh.s[e + 1]);
    plan_length_.push_back(mesh.length[e]);
  }
  // Beyond the last position where elements still shorten, towards the touchdown.
  for (std::size_t i = 1; i < plan_length_.size(); ++i) {
    if (plan_length_[i] < plan_length_[i - 1] * (1.0 - 1e-9)) fine_until_ = plan_from_[i];
  }
}

double Conveyor::planned(double from_top) const {
  const auto after = std::upper_bound(plan_from_.begin() + 1, plan_from_.end(), from_top);
  return plan_length_[static_cast<std::size_t>(after - plan_from_.begin()) - 1];
}

/// Equal parts of the next piece of pipe, so that nodes coincide with section boundaries.
double Conveyor::next_length() const {
  constexpr double kSame = 1e-6;  // [m]
  const PieceAbove piece = piece_above(*model_, fed_ + kSame);
  if (!std::isfinite(piece.to)) return element_;
  const double length = piece.to - std::max(piece.from, std::min(fed_, 0.0));
  return length / std::max(1.0, std::ceil(length / element_ - kSame));
}

bool Conveyor::due(const System& system, const SystemState& state) const {
  const Line& line = system.lines[pipe_.line];
  const double travel = state.attachments[pipe_.tensioner].travel.q;
  const double stretch = node_strain(state.lines[pipe_.line], line.mesh.nodes() - 1);
  return travel >= stretch * next_length() || travel <= -stretch * line.mesh.length.back();
}

ElementKind Conveyor::element_kind(int section) const {
  const Section& of = model_->sections[static_cast<std::size_t>(section)];
  return {section, pipe_constants(*model_, of), of.bending ? &*of.bending : nullptr};
}

/// Adds pipe between the previous top node and the guide: straight, stretched and rotating as the tangent of that node.
void Conveyor::feed(System& system, SystemState& state, const EndMotion& guide) {
  Line& line = system.lines[pipe_.line];
  LineState& pipe = state.lines[pipe_.line];
  AttachmentState& held = state.attachments[pipe_.tensioner];
  const int top = line.mesh.nodes() - 1;
  const double length = next_length(), stretch = node_strain(pipe, top);
  const bool clamped = system.attachments[pipe_.tensioner].hold_direction;
  NodeMotion node = node_motion(pipe, top);
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Index k = static_cast<Eigen::Index>(i);
    node.q[i] += length * (clamped ? node.q[3 + i] : stretch * guide.direction(k));
    node.v[i] += length * (clamped ? node.v[3 + i] : stretch * guide.direction_rate(k));
    node.acc[i] += length * (clamped ? node.acc[3 + i] : stretch * guide.direction_acceleration(k));
    node.algorithmic_acceleration[i] +=
        length * (clamped ? node.algorithmic_acceleration[3 + i] : stretch * guide.direction_acceleration(k));
  }
  append_element(line, pipe, node, length, element_kind(piece_above(*model_, fed_ + 0.5 * length).section));
  held.travel.q -= stretch * length;
  travelled_ += stretch * length;
  fed_ += length;
}

void Conveyor::haul(System& system, SystemState& state) {
  Line& line = system.lines[pipe_.line];
  LineState& pipe = state.lines[pipe_.line];
  AttachmentState& held = state.attachments[pipe_.tensioner];
  const double length = line.mesh.length.back(), stretch = node_strain(pipe, line.mesh.nodes() - 1);
  drop_element(line, pipe, LineEnd::last);
  follow_tangent(pipe, line.mesh.nodes() - 1, held.guide);
  held.travel.q += stretch * length;
  travelled_ -= stretch * length;
  fed_ -= length;
}

/// Drops as much at the anchor end as was added at the top. The force at the anchor is taken over by the seabed
/// friction, or by the anchor at its new position.
void Conveyor::drop_laid(System& system, SystemState& state) {
  if (model_->description.pipe.length) return;  // a real anchor
  Line& line = system.lines[pipe_.line];
  LineState& pipe = state.lines[pipe_.line];
  while (line.mesh.elements() > 2 && fed_ - dropped_ >= line.mesh.length.front()) {
    dropped_ += line.mesh.length.front();
    drop_element(line, pipe, LineEnd::first);
    for (std::vector<double>* rates : {&pipe.v, &pipe.acc, &pipe.algorithmic_acceleration}) {
      std::fill_n(rates->begin(), 6, 0.0);
    }
    Attachment& anchor = system.attachments.front();
    anchor.place = part(pipe.q, 0, 0);
    anchor.direction = part(pipe.q, 0, 3).normalized();
    state.attachments.front().guide = {node_strain(pipe, 0), 0.0, 0.0, 0.0};
  }
}

void Conveyor::refine(Line& line, LineState& state) const {
  const double top = line.mesh.s.back();
  for (int e = line.mesh.elements() - 1; e >= 0; --e) {
    const std::size_t i = static_cast<std::size_t>(e);
    while (line.mesh.length[i] > kTooLong * planned(top - line.mesh.s[i] - 0.5 * line.mesh.length[i])) {
      split_element(line, state, e, 0.5);
    }
  }
}

void Conveyor::coarsen(Line& line, LineState& state) const {
  const double top = line.mesh.s.back();
  for (int node = line.mesh.nodes() - 2; node > 0; --node) {
    const std::size_t i = static_cast<std::size_t>(node);
    const double from_top = top - line.mesh.s[i], both = line.mesh.length[i - 1] + line.mesh.length[i];
    if (from_top > fine_until_ && line.mesh.section[i - 1] == line.mesh.section[i] &&
        both <= kTooShort * planned(from_top) && is_nearly_straight(line, state, node)) {
      merge_elements(line, state, node);
    }
  }
}

void Conveyor::act(System& system, SystemState& state, const EndMotion& guide) {
  while (due(system, state)) {
    if (state.attachments[pipe_.tensioner].travel.q > 0.0) {
      feed(system, state, guide);
    } else {
      haul(system, state);
    }
  }
  Line& line = system.lines[pipe_.line];
  LineState& pipe = state.lines[pipe_.line];
  drop_laid(system, state);
  refine(line, pipe);
  coarsen(line, pipe);
  if (line.yielding.any) choose_levels(line.yielding, pipe.q.data());
}

std::vector<double> Conveyor::save(const System& system) const {
  const LineMesh& mesh = system.lines[pipe_.line].mesh;
  const Attachment& anchor = system.attachments.front();
  std::vector<double> out{fed_, travelled_, dropped_};
  for (const Vec3* v : {&anchor.place, &anchor.direction}) out.insert(out.end(), v->begin(), v->end());
  out.push_back(static_cast<double>(mesh.elements()));
  out.insert(out.end(), mesh.s.begin(), mesh.s.end());
  out.insert(out.end(), mesh.length.begin(), mesh.length.end());
  for (const int section : mesh.section) out.push_back(static_cast<double>(section));
  for (const LevelMix& mix : system.lines[pipe_.line].yielding.mix) {
    out.insert(out.end(), {static_cast<double>(mix.lower), mix.share});
  }
  return out;
}

void Conveyor::restore(const std::vector<double>& saved, System& system) {
  std::size_t next = 0;
  const auto take = [&] { return saved.at(next++); };
  const auto take_vector = [&] {
    Vec3 v;
    for (double& value : v) value = take();
    return v;
  };
  fed_ = take();
  travelled_ = take();
  dropped_ = take();
  system.attachments.front().place = take_vector();
  system.attachments.front().direction = take_vector();
  Line& line = system.lines[pipe_.line];
  const std::size_t elements = static_cast<std::size_t>(take());
  line.mesh.s.resize(elements + 1);
  line.mesh.length.resize(elements);
  line.mesh.section.resize(elements);
  for (double& s : line.mesh.s) s = take();
  for (double& length : line.mesh.length) length = take();
  for (int& section : line.mesh.section) section = static_cast<int>(take());
  line.elements = line_elements(*model_, line.mesh.length, line.mesh.section);
  line.yielding = yielding_elements(*model_, line.mesh);
  for (LevelMix& mix : line.yielding.mix) {
    mix.lower = static_cast<int>(take());
    mix.share = take();
  }
}

}  // namespace overbend
