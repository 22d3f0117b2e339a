#include "system/line_resize.h"

#include <algorithm>
#include <cmath>

#include "base/require.h"
#include "base/simd.h"
#include "mechanics/quadrature.h"

namespace overbend {
namespace {

/// A number with its first and second time derivative.
struct Jet {
  double value = 0.0, rate = 0.0, acceleration = 0.0;
};

Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.rate + b.rate, a.acceleration + b.acceleration};
}

Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.acceleration * b.value + 2.0 * a.rate * b.rate + a.value * b.acceleration};
}

Jet operator*(double a, const Jet& b) {
  return {a * b.value, a * b.rate, a * b.acceleration};
}

Jet inverse(const Jet& a) {
  const double i = 1.0 / a.value;
  return {i, -a.rate * i * i, (2.0 * a.rate * a.rate * i - a.acceleration) * i * i};
}

constexpr Jet constant(double value) {
  return {value, 0.0, 0.0};
}

/// Shape functions of r1, t1, r2, t2 at a point of an element for position and tangent, with their rates.
struct PointWeights {
  std::array<Jet, 4> place, tangent;
};

PointWeights point_weights(double share, double length, const LengthRate& length_rate) {
  const Jet h{length, length_rate.rate, length_rate.acceleration};
  const Jet x = share * length * inverse(h);  // the material point is fixed, the length grows
  const Jet x2 = x * x, x3 = x2 * x;
  PointWeights w;
  w.place = {constant(1.0) + -3.0 * x2 + 2.0 * x3, h * (x + -2.0 * x2 + x3), 3.0 * x2 + -2.0 * x3,
             h * (x3 + -1.0 * x2)};
  w.tangent = {inverse(h) * (-6.0 * x + 6.0 * x2), constant(1.0) + -4.0 * x + 3.0 * x2,
               inverse(h) * (6.0 * x + -6.0 * x2), 3.0 * x2 + -2.0 * x};
  return w;
}

/// Position, rate and acceleration of one component from the unknowns of an element, with true or algorithmic
/// accelerations `acc`.
Jet weighted(const std::array<Jet, 4>& weights, const LineState& state, const std::vector<double>& acc,
             std::size_t first) {
  Jet sum;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t index = first + 3 * k;
    sum = sum + weights[k] * Jet{state.q[index], state.v[index], acc[index]};
  }
  return sum;
}

// Rearranging ------------------------------------------------------------------------------------------------------

/// Old nodes and elements from which the new ones come.
struct Arrangement {
  std::vector<int> nodes, elements;
};

Arrangement make_identity_arrangement(const Line& line) {
  Arrangement a;
  for (int node = 0; node < line.mesh.nodes(); ++node) a.nodes.push_back(node);
  for (int e = 0; e < line.mesh.elements(); ++e) a.elements.push_back(e);
  return a;
}

template <class Values>
void gather(Values& values, const std::vector<int>& from, std::size_t width = 1) {
  if (values.empty()) return;
  const Values old = values;
  values.resize(width * from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto first = old.begin() + static_cast<std::ptrdiff_t>(width) * from[i];
    std::copy_n(first, width, values.begin() + static_cast<std::ptrdiff_t>(width * i));
  }
}

std::size_t padded(std::size_t count) {
  constexpr std::size_t kBatch = kLanes;
  return (count + kBatch - 1) / kBatch * kBatch;
}

/// Rearranges a padded array of `rows` consecutive rows.
void gather_padded(AlignedDoubles& values, const std::vector<int>& from, std::size_t rows, double beyond) {
  const AlignedDoubles old = values;
  const std::size_t before = old.size() / rows, after = padded(from.size());
  values.assign(rows * after, beyond);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      values[row * after + i] = old[row * before + static_cast<std::size_t>(from[i])];
    }
  }
}

/// Visits every array of the elements' constants except their lengths, with its member of ElementConstants and its
/// padding value.
template <class Elements, class Visit>
void visit_constants(Elements& e, const Visit& visit) {
  visit(e.EA, &ElementConstants::EA, 0.0);
  visit(e.EI, &ElementConstants::EI, 0.0);
  visit(e.compression, &ElementConstants::compression, 1.0);
  visit(e.damping, &ElementConstants::damping, 0.0);
  visit(e.weight, &ElementConstants::weight, 0.0);
  visit(e.buoyancy, &ElementConstants::buoyancy, 0.0);
  visit(e.radius, &ElementConstants::radius, 1.0);
  visit(e.drag_normal, &ElementConstants::drag_normal, 0.0);
  visit(e.drag_axial, &ElementConstants::drag_axial, 0.0);
  visit(e.pressure_constant, &ElementConstants::pressure_constant, 0.0);
  visit(e.pressure_slope, &ElementConstants::pressure_slope, 0.0);
  visit(e.pressure_external, &ElementConstants::pressure_external, 0.0);
  visit(e.mass, &ElementConstants::mass, 0.0);
  visit(e.displaced_mass, &ElementConstants::displaced_mass, 0.0);
  visit(e.added_normal, &ElementConstants::added_normal, 0.0);
  visit(e.added_axial, &ElementConstants::added_axial, 0.0);
  visit(e.drag_on_bed, &ElementConstants::drag_on_bed, 0.0);
}

/// Rearranges everything that a line stores by node and by element.
void rearrange(Line& line, LineState& state, const Arrangement& a) {
  constexpr std::size_t kBedRows = static_cast<std::size_t>(kGaussPoints * kBedDirections);
  gather(line.mesh.s, a.nodes);
  gather(line.mesh.length, a.elements);
  gather(line.mesh.section, a.elements);
  gather_padded(line.elements.length, a.elements, 1, 1.0);
  visit_constants(line.elements, [&](AlignedDoubles& values, double ElementConstants::*, double beyond) {
    gather_padded(values, a.elements, 1, beyond);
  });
  line.elements.count = static_cast<int>(a.elements.size());
  gather(line.yielding.law, a.elements);
  gather(line.yielding.mix, a.elements);
  for (std::vector<double>* of_nodes : {&state.q, &state.low, &state.v, &state.acc, &state.algorithmic_acceleration}) {
    gather(*of_nodes, a.nodes, 6);
  }
  gather_padded(state.bed_slip, a.elements, kBedRows, 0.0);
  std::vector<BendingMemory> bending = state.bending.all();
  gather(bending, a.elements, kGaussPoints);
  state.bending = BendingMemories(bending);
}

void put_node(LineState& state, int node, const NodeMotion& motion) {
  const std::ptrdiff_t first = 6 * static_cast<std::ptrdiff_t>(node);
  std::copy(motion.q.begin(), motion.q.end(), state.q.begin() + first);
  std::copy(motion.v.begin(), motion.v.end(), state.v.begin() + first);
  std::copy(motion.acc.begin(), motion.acc.end(), state.acc.begin() + first);
  std::copy(motion.algorithmic_acceleration.begin(), motion.algorithmic_acceleration.end(),
            state.algorithmic_acceleration.begin() + first);
  if (!state.low.empty()) std::fill_n(state.low.begin() + first, 6, 0.0);
}

// Memories at the Gauss points of the parts of an element ------------------------------------------------------------

/// Value within an element from its values at the Gauss points: linear between points, also beyond them.
double between_points(const std::array<double, kGaussPoints>& values, double share) {
  if (share <= kGaussXi[0]) return values.front();
  for (std::size_t i = 1; i < kGaussPoints; ++i) {
    if (share <= kGaussXi[i]) {
      const double part = (share - kGaussXi[i - 1]) / (kGaussXi[i] - kGaussXi[i - 1]);
      return values[i - 1] + part * (values[i] - values[i - 1]);
    }
  }
  return values.back();
}

std::size_t nearest_point(double share) {
  const auto nearer = [&](double a, double b) { return std::abs(a - share) < std::abs(b - share); };
  return static_cast<std::size_t>(std::min_element(kGaussXi, kGaussXi + kGaussPoints, nearer) - kGaussXi);
}

/// Part of an element that becomes a new one: its start and length as shares of the element.
struct Part {
  std::size_t element = 0;
  double from = 0.0, size = 1.0;
};

/// Gives the elements `parts`, which come from one element, its memories at the positions of their own points.
void spread_memories(const Line& line, LineState& state, const std::array<Part, 2>& parts) {
  const std::size_t stride = line.elements.padded(), source = parts.front().element;
  for (std::size_t direction = 0; direction < kBedDirections; ++direction) {
    const auto slip = [&](std::size_t point, std::size_t element) -> double& {
      return state.bed_slip[(point * kBedDirections + direction) * stride + element];
    };
    std::array<double, kGaussPoints> old{};
    for (std::size_t i = 0; i < kGaussPoints; ++i) old[i] = slip(i, source);
    for (const Part& part : parts) {
      for (std::size_t i = 0; i < kGaussPoints; ++i) {
        slip(i, part.element) = between_points(old, part.from + kGaussXi[i] * part.size);
      }
    }
  }
  if (state.bending.empty()) return;
  std::array<BendingMemory, kGaussPoints> old;
  for (std::size_t i = 0; i < kGaussPoints; ++i) old[i] = state.bending.at(kGaussPoints * source + i);
  for (const Part& part : parts) {
    for (std::size_t i = 0; i < kGaussPoints; ++i) {
      state.bending.set(kGaussPoints * part.element + i, old[nearest_point(part.from + kGaussXi[i] * part.size)]);
    }
  }
}

/// Transfers the memories of two elements in `before` to the points of the merged element.
void join_memories(const Line& line, LineState& state, const LineState& before, std::size_t stride_before,
                   std::size_t element, double lower_share) {
  const std::size_t stride = line.elements.padded();
  for (std::size_t i = 0; i < kGaussPoints; ++i) {
    const bool lower = kGaussXi[i] < lower_share;
    const double share = lower ? kGaussXi[i] / lower_share : (kGaussXi[i] - lower_share) / (1.0 - lower_share);
    const std::size_t source = element + (lower ? 0 : 1);
    for (std::size_t direction = 0; direction < kBedDirections; ++direction) {
      std::array<double, kGaussPoints> old{};
      for (std::size_t k = 0; k < kGaussPoints; ++k) {
        old[k] = before.bed_slip[(k * kBedDirections + direction) * stride_before + source];
      }
      state.bed_slip[(i * kBedDirections + direction) * stride + element] = between_points(old, share);
    }
    if (!state.bending.empty()) {
      state.bending.set(kGaussPoints * element + i, before.bending.at(kGaussPoints * source + nearest_point(share)));
    }
  }
}

/// Axes for the points of a new, unbent element.
void unbend(LineState& state, std::size_t element, const Vec3& tangent) {
  for (std::size_t i = 0; i < kGaussPoints; ++i) {
    state.bending.set(kGaussPoints * element + i, make_bending_memory(tangent));
  }
}

/// Prepares a line without plastic elements for one.
void begin_yielding(Line& line, LineState& state) {
  line.yielding.any = true;
  if (state.bending.empty()) state.bending = BendingMemories(fresh_memories(line.mesh, state.q.data()));
}

}  // namespace

NodeMotion node_motion(const LineState& state, int node) {
  NodeMotion motion;
  const std::size_t first = 6 * static_cast<std::size_t>(node);
  for (std::size_t i = 0; i < 6; ++i) {
    motion.q[i] = state.q[first + i];
    motion.v[i] = state.v[first + i];
    motion.acc[i] = state.acc[first + i];
    motion.algorithmic_acceleration[i] = state.algorithmic_acceleration[first + i];
  }
  return motion;
}

NodeMotion motion_within(const Line& line, const LineState& state, int element, double share,
                         const LengthRate& length_rate) {
  const PointWeights w = point_weights(share, line.mesh.length[static_cast<std::size_t>(element)], length_rate);
  NodeMotion motion;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::array<Jet, 4>& weights = i < 3 ? w.place : w.tangent;
    const std::size_t first = 6 * static_cast<std::size_t>(element) + i % 3;
    const Jet jet = weighted(weights, state, state.acc, first);
    motion.q[i] = jet.value;
    motion.v[i] = jet.rate;
    motion.acc[i] = jet.acceleration;
    motion.algorithmic_acceleration[i] = weighted(weights, state, state.algorithmic_acceleration, first).acceleration;
  }
  return motion;
}

void split_element(Line& line, LineState& state, int element, double share, const LengthRate& length_rate) {
  require(share > 0.0 && share < 1.0, "a node can only be inserted inside an element");
  const NodeMotion motion = motion_within(line, state, element, share, length_rate);
  const std::size_t e = static_cast<std::size_t>(element);
  const double element_length = line.mesh.length[e], below = line.mesh.s[e];
  Arrangement a = make_identity_arrangement(line);
  a.nodes.insert(a.nodes.begin() + element + 1, element);
  a.elements.insert(a.elements.begin() + element + 1, element);
  rearrange(line, state, a);
  line.mesh.s[e + 1] = below + share * element_length;
  line.mesh.length[e] = line.elements.length[e] = share * element_length;
  line.mesh.length[e + 1] = line.elements.length[e + 1] = (1.0 - share) * element_length;
  put_node(state, element + 1, motion);
  spread_memories(line, state, {Part{e, 0.0, share}, Part{e + 1, share, 1.0 - share}});
  for (LinePoint& point : line.points) {
    if (point.node > element) ++point.node;
  }
  for (ContactMemory& contact : state.contacts) {
    if (contact.element > element || (contact.element == element && contact.xi > share)) {
      contact.xi = contact.element == element ? (contact.xi - share) / (1.0 - share) : contact.xi;
      ++contact.element;
    } else if (contact.element == element) {
      contact.xi /= share;
    }
  }
}

void merge_elements(Line& line, LineState& state, int node) {
  require(node > 0 && node + 1 < line.mesh.nodes(), "only an inner node can be removed");
  const std::size_t e = static_cast<std::size_t>(node) - 1;
  const double lower = line.mesh.length[e], whole = lower + line.mesh.length[e + 1], share = lower / whole;
  const LineState before = state;
  const std::size_t stride_before = line.elements.padded();
  Arrangement a = make_identity_arrangement(line);
  a.nodes.erase(a.nodes.begin() + node);
  a.elements.erase(a.elements.begin() + node);
  rearrange(line, state, a);
  line.mesh.length[e] = line.elements.length[e] = whole;
  join_memories(line, state, before, stride_before, e, share);
  for (LinePoint& point : line.points) {
    require(point.node != node, "a node with a clump or buoy cannot be removed");
    if (point.node > node) --point.node;
  }
  for (ContactMemory& contact : state.contacts) {
    if (contact.element == node - 1) {
      contact.xi *= share;
    } else if (contact.element >= node) {
      contact.xi = contact.element == node ? share + contact.xi * (1.0 - share) : contact.xi;
      --contact.element;
    }
  }
}

void append_element(Line& line, LineState& state, const NodeMotion& node, double length, const ElementKind& kind) {
  const std::size_t e = line.mesh.length.size();
  if (kind.law != nullptr) begin_yielding(line, state);
  Arrangement a = make_identity_arrangement(line);
  a.nodes.push_back(static_cast<int>(e));
  a.elements.push_back(static_cast<int>(e) - 1);
  rearrange(line, state, a);
  put_node(state, static_cast<int>(e) + 1, node);
  line.mesh.s[e + 1] = line.mesh.s[e] + length;
  line.mesh.length[e] = line.elements.length[e] = length;
  if (!line.mesh.section.empty()) line.mesh.section[e] = kind.section;
  visit_constants(line.elements, [&](AlignedDoubles& values, double ElementConstants::*member, double) {
    values[e] = kind.constants.*member;
  });
  for (std::size_t i = 0; i < static_cast<std::size_t>(kGaussPoints * kBedDirections); ++i) {
    state.bed_slip[i * line.elements.padded() + e] = 0.0;
  }
  if (!line.yielding.law.empty()) line.yielding.law[e] = kind.law;
  const double* q = state.q.data() + 6 * e;
  if (kind.law != nullptr) line.yielding.mix[e] = level_at(*kind.law, 0.5 * (q[2] + q[8]));
  if (!state.bending.empty()) unbend(state, e, (Vec3(q[6], q[7], q[8]) - Vec3(q[0], q[1], q[2])).normalized());
}

void drop_element(Line& line, LineState& state, LineEnd end) {
  require(line.mesh.elements() > 1, "the only element of a line cannot be removed");
  const bool first = end == LineEnd::first;
  const int node = first ? 0 : line.mesh.nodes() - 1, element = first ? 0 : line.mesh.elements() - 1;
  Arrangement a = make_identity_arrangement(line);
  a.nodes.erase(a.nodes.begin() + node);
  a.elements.erase(a.elements.begin() + element);
  rearrange(line, state, a);
  for (LinePoint& point : line.points) {
    require(point.node != node, "a node with a clump or buoy cannot be removed");
    if (first) --point.node;
  }
  for (ContactMemory& contact : state.contacts) {
    if (contact.element == element) {
      contact = ContactMemory{};
      contact.element = first ? 0 : element - 1;
    } else if (first) {
      --contact.element;
    }
  }
}

}  // namespace overbend
