#include "statics/recovery/recovery_cable.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/lay_stage.h"

namespace overbend {
namespace {

const SectionSpan& find_span(const Model& model, SectionKind kind) {
  return *std::find_if(model.spans.begin(), model.spans.end(), [&](const SectionSpan& span) {
    return model.sections[static_cast<std::size_t>(span.section)].kind == kind;
  });
}

/// Station of the cable nearest to an arc length.
const Station& cable_station(const std::vector<Station>& stations, double s) {
  const Station* found = &stations.front();
  double min_distance = std::numeric_limits<double>::infinity();
  for (const Station& station : stations) {
    if (station.kind != SectionKind::cable || std::abs(station.s - s) >= min_distance) continue;
    min_distance = std::abs(station.s - s);
    found = &station;
  }
  return *found;
}

/// `joint`: arc length of the node at which head and cable meet.
HeadResult head_result(const StaticResults& results, const StaticSystem& system, const LineState& state, double joint) {
  const Model& model = system.model();
  const std::vector<double>& s = system.mesh().s;
  const std::size_t node = static_cast<std::size_t>(std::lower_bound(s.begin(), s.end(), joint - 1e-6) - s.begin());
  const Vec3 tangent(Eigen::Map<const Vec3>(state.q.data() + 6 * node + 3));
  const Station& of_cable = cable_station(results.stations, joint);
  HeadResult head;
  head.p_W = Vec3(Eigen::Map<const Vec3>(state.q.data() + 6 * node));
  head.astern = (head.p_W - results.stern_shoe_W).dot(system.plane().astern_W);
  head.inclination = std::atan2(tangent.z(), std::hypot(tangent.x(), tangent.y()));
  head.cable_inclination = of_cable.inclination;
  head.tension = of_cable.effective_tension;
  head.s = joint;
  const SectionSpan& span = find_span(model, SectionKind::head);
  head.clearance =
      model.seabed.surface.clearance(head.p_W) - model.sections[static_cast<std::size_t>(span.section)].outer_radius();
  return head;
}

}  // namespace

void recover_cable(StaticResults& results, const StaticSystem& system, const LineState& state) {
  const Model& model = system.model();
  const bool above = cable_at_top(model.description);
  if (!above && !cable_at_far_end(model.description)) return;
  const SectionSpan& cable = find_span(model, SectionKind::cable);
  const double joint = results.total_length - (above ? cable.to : cable.from);
  results.head = head_result(results, system, state, joint);
  CableResult& result = results.cable.emplace();
  result.length = above ? cable.to - cable.from : joint;
  for (const Station& station : results.stations) {
    if (station.kind == SectionKind::cable) {
      result.max_tension = std::max(result.max_tension, station.effective_tension);
    }
  }
  if (const std::optional<double>& breaking = model.description.operation.lay.cable->breaking_load) {
    result.utilisation = result.max_tension / *breaking;
  }
  if (above) {
    result.winch_inclination = results.stations.back().inclination;
    return;
  }
  const Vec3& pull = results.anchor_reaction;  // force on the line
  results.far_anchor = StartUpAnchorResult{results.stations.front().astern, pull.head<2>().norm(), -pull.z()};
}

}  // namespace overbend
