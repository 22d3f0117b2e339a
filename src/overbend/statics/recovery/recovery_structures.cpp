#include "statics/recovery/recovery_structures.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Distance from the end of a structure within which the bending of the pipe is attributed to it, in outer diameters.
constexpr double kEndReachDiameters = 2.0;

void update_maximum(double& maximum, double value) {
  maximum = std::max(maximum, std::abs(value));
}

/// Nearer of the two stations around `s`.
const Station& nearest_station(const std::vector<Station>& stations, double s) {
  return *std::min_element(stations.begin(), stations.end(),
                           [s](const Station& a, const Station& b) { return std::abs(a.s - s) < std::abs(b.s - s); });
}

/// Extremes of the pipe between arc lengths `from` and `to` from the anchor; `end` is one of them.
StructureEndResult pipe_next_to_end(const StaticResults& results, double end, double from, double to) {
  StructureEndResult result;
  result.s = end;
  result.bending_moment = nearest_station(results.stations, end).bending_moment;
  for (const Station& station : results.stations) {
    const bool within = station.s > from && station.s < to;
    if (!within || station.kind != SectionKind::pipe) continue;
    update_maximum(result.bending_stress, station.bending_stress);
    update_maximum(result.von_mises, station.von_mises);
    update_maximum(result.strain, station.strain);
  }
  return result;
}

void add_reaction(const StaticResults& results, double from, double to, StructureResult& structure) {
  for (const SupportResult& box : results.supports) {
    for (const RowResult& row : box.rows) {
      if (row.s < from || row.s > to) continue;
      for (const RollerResult& roller : row.rollers) {
        if (roller.reaction <= structure.reaction) continue;
        structure.reaction = roller.reaction;
        structure.support = box.name;
      }
    }
  }
}

StructureResult recover_structure(const Model& model, const SectionSpan& span, const StaticResults& results) {
  StructureResult structure;
  structure.name = model.sections[static_cast<std::size_t>(span.section)].name;
  structure.from_top = 0.5 * (span.from + span.to);
  const double to = results.total_length - span.from, from = results.total_length - span.to;
  const double reach = kEndReachDiameters * model.pipe_section().outer_diameter;
  const Station& middle = nearest_station(results.stations, 0.5 * (from + to));
  structure.p_W = middle.p_W;
  structure.astern = middle.astern;
  structure.inclination = middle.inclination;
  for (const Station& station : results.stations) {
    if (station.s < from - 1e-9 || station.s > to + 1e-9) continue;
    update_maximum(structure.bending_moment, station.bending_moment);
    structure.effective_tension = std::max(structure.effective_tension, station.effective_tension);
  }
  add_reaction(results, from, to, structure);
  structure.upper = pipe_next_to_end(results, to, to, to + reach);
  structure.lower = pipe_next_to_end(results, from, from - reach, from);
  return structure;
}

}  // namespace

std::vector<StructureResult> recover_structures(const Model& model, const StaticResults& results) {
  std::vector<StructureResult> all;
  for (const SectionSpan& span : model.spans) {
    const bool structure = model.sections[static_cast<std::size_t>(span.section)].kind == SectionKind::structure;
    if (structure && span.to < results.total_length) all.push_back(recover_structure(model, span, results));
  }
  return all;
}

}  // namespace overbend
