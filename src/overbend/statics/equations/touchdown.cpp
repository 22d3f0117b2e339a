#include "statics/equations/touchdown.h"

#include <algorithm>

#include "model/lay_stage.h"

namespace overbend {
namespace {

ElementVector element_dofs(const LineState& state, int element) {
  return ElementVector(Eigen::Map<const ElementVector>(state.q.data() + 6 * element));
}

/// First crossing of `value(element, xi)` from above to below zero, from the tensioner down; by bisection to rounding.
template <class Function>
std::optional<ElementPlace> first_passage(const StaticSystem& system, const Function& value) {
  const LineMesh& mesh = system.mesh();
  bool was_above = false;
  for (int e = mesh.elements() - 1; e >= 0; --e) {
    const bool starts_above = value(e, 1.0) > 0.0;
    if (!starts_above && was_above) {  // the radius of the line increases between two elements
      return ElementPlace{e, 1.0, mesh.s[static_cast<std::size_t>(e) + 1]};
    }
    was_above = starts_above;
    if (!starts_above || value(e, 0.0) > 0.0) {
      continue;
    }
    double below = 0.0, above = 1.0;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (below + above);
      (value(e, middle) > 0.0 ? above : below) = middle;
    }
    return ElementPlace{e, above,
                        mesh.s[static_cast<std::size_t>(e)] + above * mesh.length[static_cast<std::size_t>(e)]};
  }
  return std::nullopt;
}

}  // namespace

double bed_clearance(const StaticSystem& system, const LineState& state, int element, double xi) {
  const std::size_t e = static_cast<std::size_t>(element);
  const Vec3 r = centreline(element_dofs(state, element), xi, system.mesh().length[e]).r;
  return system.model().seabed.surface.clearance(r) - system.elements().radius[e];
}

std::optional<ElementPlace> find_touchdown(const StaticSystem& system, const LineState& state) {
  return first_passage(system, [&](int e, double xi) { return bed_clearance(system, state, e, xi); });
}

std::optional<ElementPlace> landing(const StaticSystem& system, const LineState& state) {
  const std::optional<ElementPlace> touchdown = find_touchdown(system, state);
  if (touchdown || !cable_at_far_end(system.model().description)) return touchdown;
  return ElementPlace{};
}

std::optional<ElementPlace> find_waterline(const StaticSystem& system, const LineState& state) {
  return first_passage(system, [&](int e, double xi) {
    return centreline(element_dofs(state, e), xi, system.mesh().length[static_cast<std::size_t>(e)]).r.z();
  });
}

}  // namespace overbend
