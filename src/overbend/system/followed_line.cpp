#include "system/followed_line.h"

#include <algorithm>

#include "system/cut_forces.h"

namespace overbend {
namespace {

std::size_t to_size(int i) {
  return static_cast<std::size_t>(i);
}

Vec3 tangent_at(const std::vector<double>& q, std::size_t node) {
  return Eigen::Map<const Vec3>(q.data() + 6 * node + 3).normalized();
}

/// Reported tension of a nodal force: where only tension elements meet, a compression is the inertia of half an element
/// and depends on its length.
double recorded(const LineElements& elements, std::size_t node, double tension) {
  const std::size_t last = to_size(elements.count) - 1;
  const bool pushed =
      elements.compression[std::min(node, last)] == 1.0 || elements.compression[node > 0 ? node - 1 : 0] == 1.0;
  return pushed ? tension : std::max(tension, 0.0);
}

}  // namespace

std::size_t node_count(const System& system, const FollowedLine& followed) {
  return followed.is_wire() ? 2 : to_size(system.lines[to_size(followed.line)].mesh.nodes());
}

const WirePull& find_wire_pull(const Assembly& assembly, const FollowedLine& wire) {
  return wire.line < 0 ? assembly.wires()[to_size(wire.wire)]
                       : assembly.line(to_size(wire.line)).wire_pulls()[to_size(wire.wire)];
}

Vec3 node_place(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, std::size_t node) {
  if (followed.is_wire()) {
    const WirePull& pull = find_wire_pull(assembly, followed);
    return (node == 0) != followed.reversed ? pull.first : pull.second;
  }
  return Eigen::Map<const Vec3>(state.lines[to_size(followed.line)].q.data() + 6 * node);
}

double node_tension(const Assembly& assembly, const SystemState& state, const FollowedLine& followed,
                    std::size_t node) {
  if (followed.is_wire()) return find_wire_pull(assembly, followed).tension;
  const LineAssembly& line = assembly.line(to_size(followed.line));
  const std::vector<double>& q = state.lines[to_size(followed.line)].q;
  return recorded(line.line().elements, node, cut_at_node(line.cuts(), q, node).force.dot(tangent_at(q, node)));
}

double node_moment(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, std::size_t node) {
  if (followed.is_wire()) return 0.0;
  const LineAssembly& line = assembly.line(to_size(followed.line));
  return cut_at_node(line.cuts(), state.lines[to_size(followed.line)].q, node).moment.norm();
}

double end_tension(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, LineEnd end) {
  if (followed.is_wire()) return find_wire_pull(assembly, followed).tension;
  const LineAssembly& line = assembly.line(to_size(followed.line));
  const std::size_t node = to_size(line.end_node(end));
  const Vec3 force(Eigen::Map<const Vec3>(line.end_force(end).data()));
  const double along = force.dot(tangent_at(state.lines[to_size(followed.line)].q, node));
  return recorded(line.line().elements, node, end == LineEnd::last ? along : -along);
}

}  // namespace overbend
