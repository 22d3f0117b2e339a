#include "statics/recovery/recovery_bed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "mechanics/rod_element.h"
#include "model/site/seabed_shape.h"
#include "statics/equations/bed_contacts.h"
#include "statics/recovery/sample_peak.h"

namespace overbend {
namespace {

constexpr int kSamplesPerElement = 4;

double compute_astern(const StaticSystem& system, const LineState& state, const ElementPlace& place) {
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * place.element));
  const Vec3 r = centreline(q, place.xi, system.mesh().length[static_cast<std::size_t>(place.element)]).r;
  return (r - point_from_ramp(system.model(), system.model().mean_pose, Vec3::Zero())).dot(system.plane().astern_W);
}

/// Calls `look(place)` along the line between two arc lengths, from the far end up.
template <class Look>
void sample_line(const StaticSystem& system, double from, double to, Look look) {
  for (int e = 0; e < system.mesh().elements(); ++e) {
    const std::size_t i = static_cast<std::size_t>(e);
    if (system.mesh().s[i + 1] < from || system.mesh().s[i] > to) continue;
    for (int k = 0; k < kSamplesPerElement; ++k) {
      const double xi = (k + 0.5) / kSamplesPerElement, s = system.mesh().s[i] + xi * system.mesh().length[i];
      if (s >= from && s <= to) look(ElementPlace{e, xi, s});
    }
  }
}

/// Results of a contact; updates the maximum penetration of all contacts in `bed`.
BedContactResult contact_result(BedResults& bed, const StaticSystem& system, const LineState& state,
                                const BedContact& contact) {
  BedContactResult result;
  result.x_from = compute_astern(system, state, contact.from);
  result.x_to = compute_astern(system, state, contact.to);
  result.s_from = contact.from.s;
  result.s_to = contact.to.s;
  std::vector<Sample> depths;
  sample_line(system, contact.to.s, contact.from.s, [&](const ElementPlace& place) {
    depths.push_back({compute_astern(system, state, place), -bed_clearance(system, state, place.element, place.xi)});
  });
  const Sample deepest = peak(depths);
  result.max_penetration = deepest.value;
  if (deepest.value > bed.max_penetration) {
    bed.max_penetration = deepest.value;
    bed.penetration_x = deepest.x;
  }
  return result;
}

FreeSpanResult span_result(const StaticResults& results, const StaticSystem& system, const LineState& state,
                           const BedContactResult& before, const BedContactResult& behind) {
  FreeSpanResult span{before.x_to, behind.x_from, before.s_to, behind.s_from};
  span.length = span.s_from - span.s_to;
  std::vector<Sample> gaps, moments;
  sample_line(system, span.s_to, span.s_from, [&](const ElementPlace& place) {
    gaps.push_back({compute_astern(system, state, place), bed_clearance(system, state, place.element, place.xi)});
  });
  for (const Station& station : results.stations) {
    if (station.s < span.s_to || station.s > span.s_from) continue;
    span.bending_stress = std::max(span.bending_stress, station.bending_stress);
    moments.push_back({station.astern, station.vertical_moment});
  }
  const Sample gap = peak(gaps), moment = peak(moments);
  span.max_gap = gap.value;
  span.gap_x = gap.x;
  span.sagging_moment = std::max(moment.value, 0.0);
  span.moment_x = moment.x;
  return span;
}

void find_extremes(BedResults& bed, const StaticResults& results) {
  std::vector<Sample> sagging, hogging;
  for (const Station& station : results.stations) {
    if (station.s > results.touchdown.s || station.kind == SectionKind::cable) continue;
    bed.bending_stress = std::max(bed.bending_stress, station.bending_stress);
    sagging.push_back({station.astern, station.vertical_moment});
    hogging.push_back({station.astern, -station.vertical_moment});
  }
  const Sample sag = peak(sagging), hog = peak(hogging);
  bed.sagging_moment = std::max(sag.value, 0.0);
  bed.sagging_x = sag.x;
  bed.hogging_moment = std::max(hog.value, 0.0);
  bed.hogging_x = hog.x;
  bed.tail_tension = results.stations.front().effective_tension;
}

/// Heights of the bed below the line from the stern shoe to the far end, every 2 m, at most 2,000 of them.
std::vector<BedHeight> bed_heights(const Model& model, const LayPlane& plane, double length) {
  constexpr double kStep = 2.0, kMaxCount = 2000.0;
  const Vec3 shoe = point_from_ramp(model, model.mean_pose, Vec3::Zero());
  const double first = plane.route.distance(shoe);
  const int count = 2 + static_cast<int>(std::min(length / kStep, kMaxCount));
  std::vector<BedHeight> heights;
  for (int i = 0; i < count; ++i) {
    const double x = length * i / (count - 1);
    heights.push_back({x, plane.bed(first + x) - plane.radius});
  }
  return heights;
}

bool outside(const SeabedShape& shape, const Vec3& p_W) {
  return !shape.y.empty() && (p_W.x() < shape.x.front() || p_W.x() > shape.x.back() || p_W.y() < shape.y.front() ||
                              p_W.y() > shape.y.back());
}

}  // namespace

void recover_bed(StaticResults& results, const StaticSystem& system, const LineState& state) {
  if (!may_span(system.model())) return;
  BedResults bed;
  for (const BedContact& contact : bed_contacts(system, state)) {
    bed.contacts.push_back(contact_result(bed, system, state, contact));
  }
  if (bed.contacts.empty()) return;
  for (std::size_t i = 1; i < bed.contacts.size(); ++i) {
    bed.spans.push_back(span_result(results, system, state, bed.contacts[i - 1], bed.contacts[i]));
  }
  find_extremes(bed, results);
  bed.heights = bed_heights(system.model(), system.plane(), results.stations.front().astern);
  results.bed = std::move(bed);
}

void warn_of_uneven_bed(const Model& model, StaticResults& results) {
  constexpr double kWorthSaying = 0.05;  // smaller gaps depend on the soil model [m]
  if (!results.bed) return;
  std::vector<FreeSpanResult> spans = results.bed->spans;
  const double pipe_end = results.far_anchor && results.head ? results.head->s : 0.0;  // cable beyond it
  std::erase_if(
      spans, [&](const FreeSpanResult& span) { return span.max_gap < kWorthSaying || span.s_from <= pipe_end + 1e-6; });
  if (!spans.empty()) {
    const FreeSpanResult max_span =
        *ranges::max_element(spans, {}, [](const FreeSpanResult& span) { return span.length; });
    results.findings.push_back(Finding{
        FindingCode::free_spans,
        fmt::format(
            "the laid pipe has {} free span{}: the longest is {}, from {} astern of the stern shoe, with a gap of {}",
            spans.size(), spans.size() == 1 ? "" : "s", shown(max_span.length, "m", 1), shown(max_span.x_from, "m", 1),
            shown(max_span.max_gap, "m", 2))}
                                   .on("pipe")
                                   .with("length", max_span.length, "m")
                                   .with("gap", max_span.max_gap, "m"));
  }
  if (results.bed->hogging_moment > std::abs(results.sagbend.bending_moment.value)) {
    results.findings.push_back(
        Finding{FindingCode::moment_over_crest,
                fmt::format("the seabed bends the laid pipe more than the sagbend: {} hogging over the crest at {} "
                            "astern of the stern shoe, {} in the sagbend",
                            shown(results.bed->hogging_moment, "N m", 0), shown(results.bed->hogging_x, "m", 1),
                            shown(std::abs(results.sagbend.bending_moment.value), "N m", 0))}
            .on("pipe")
            .with("moment", results.bed->hogging_moment, "N m"));
  }
  const SeabedShape* const shape = model.seabed.surface.shape();
  const bool leaves = shape != nullptr && ranges::any_of(results.stations, [&](const Station& station) {
                        return station.s <= results.touchdown.s && outside(*shape, station.p_W);
                      });
  if (leaves) {
    results.findings.push_back({FindingCode::outside_bathymetry,
                                "the laid pipe leaves the area of environment.seabed.bathymetry; the depth beyond its "
                                "edge is that of the edge"});
  }
}

}  // namespace overbend
