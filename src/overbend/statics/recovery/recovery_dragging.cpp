#include "statics/recovery/recovery_dragging.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "mechanics/rod_element.h"
#include "model/lay_stage.h"
#include "statics/equations/bed_contacts.h"
#include "statics/recovery/sample_peak.h"

namespace overbend {
namespace {

constexpr double kSamePlace = 1e-6;  ///< [m]

Vec3 axis_at(const StaticSystem& system, const LineState& state, const ElementPlace& place) {
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * place.element));
  return centreline(q, place.xi, system.mesh().length[static_cast<std::size_t>(place.element)]).r;
}

/// Nearest station to an arc length, among cable stations or among the others.
const Station& nearest_station(const StaticResults& results, double s, bool cable) {
  const auto distance = [&](const Station& station) {
    return (station.kind == SectionKind::cable) == cable ? std::abs(station.s - s) : 1e30;
  };
  return *ranges::min_element(results.stations, {}, distance);
}

std::vector<BedContactResult> contacts(const StaticResults& results, const StaticSystem& system,
                                       const LineState& state) {
  std::vector<BedContactResult> found;
  const auto astern = [&](const ElementPlace& place) {
    return (axis_at(system, state, place) - results.stern_shoe_W).dot(system.plane().astern_W);
  };
  for (const BedContact& contact : bed_contacts(system, state)) {
    BedContactResult& result = found.emplace_back();
    result = {astern(contact.from), astern(contact.to), contact.from.s, contact.to.s, 0.0};
    for (const Station& station : results.stations) {
      if (station.s < result.s_to || station.s > result.s_from) continue;
      result.max_penetration = std::max(result.max_penetration, station.penetration);
    }
  }
  return found;
}

std::optional<LiftOffResult> lift_off(const StaticResults& results, const StaticSystem& system,
                                      const LineState& state) {
  const std::vector<BedContact> contacts = bed_contacts(system, state);
  if (contacts.empty() || contacts.back().to.s <= kSamePlace) return std::nullopt;
  const ElementPlace& place = contacts.back().to;
  const Vec3 axis = axis_at(system, state, place);
  return LiftOffResult{(axis - results.stern_shoe_W).dot(system.plane().astern_W), axis.z(), place.s,
                       place.s < results.head->s - kSamePlace};
}

/// Finds the place of the maximum moment of the sagbend, between stations.
void find_sagbend(DraggingResults& dragging, const StaticResults& results) {
  std::vector<Sample> by_place, by_length;
  for (const Station& station : results.stations) {
    if (station.region != Region::sagbend || station.kind == SectionKind::cable) continue;
    by_place.push_back({station.astern, station.bending_moment});
    by_length.push_back({results.total_length - station.s, station.bending_moment});
  }
  dragging.sagbend_x = peak(by_place).x;
  dragging.sagbend_from_top = peak(by_length).x;
}

}  // namespace

void recover_dragging(StaticResults& results, const StaticSystem& system, const LineState& state) {
  const Description& d = system.model().description;
  if (!is_dragged(d)) return;
  DraggingResults& dragging = results.dragging.emplace();
  dragging.touchdown_tension = nearest_station(results, results.touchdown.s, false).effective_tension;
  const double pipe_end = results.total_length - pipe_end_distance(d);
  dragging.pipe_end_tension = nearest_station(results, pipe_end, false).effective_tension;
  dragging.winch_tension = results.stations.front().effective_tension;
  dragging.winch_inclination = results.stations.front().inclination;
  find_sagbend(dragging, results);
  dragging.contacts = contacts(results, system, state);
  dragging.lift_off = lift_off(results, system, state);
}

void warn_of_dragging(StaticResults& results) {
  if (!results.dragging) return;
  const DraggingResults& dragging = *results.dragging;
  if (dragging.contacts.empty()) {
    results.findings.push_back(Finding{FindingCode::dragged_line_clear_of_bed,
                                       "the pulled line hangs clear of the seabed all along: no friction "
                                       "resists the pull"}
                                   .on("pipe"));
    return;
  }
  if (dragging.contacts.back().s_to <= kSamePlace) {
    results.findings.push_back(
        Finding{FindingCode::dragged_cable_on_bed,
                "the cable lies on the seabed all the way to its winch, with friction over its whole length"}
            .on("cable"));
  }
  // a head of given weight rests on its whole length; if that is off the bed, the cable carries it
  if (dragging.contacts.front().s_from > results.head->s && results.head->clearance > 0.0) {
    results.findings.push_back(
        Finding{FindingCode::dragged_head_lifted,
                fmt::format("the head does not lie on the seabed, the cable carries it: its underside is {} above it",
                            shown(results.head->clearance, "m", 3))}
            .on("head")
            .with("clearance", results.head->clearance, "m"));
  }
}

}  // namespace overbend
