#include "statics/recovery/recovery_structures.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// How far from an end of the structure the pipe's bending counts as made by it, in outer diameters of the pipe.
constexpr double kBesideDiameters = 2.0;

void keep_larger(double& largest, double value) {
  largest = std::max(largest, std::abs(value));
}

/// Of two stations around `s` that nearer to it.
const Station& nearest_station(const std::vector<Station>& stations, double s) {
  return *std::min_element(stations.begin(), stations.end(),
                           [s](const Station& a, const Station& b) { return std::abs(a.s - s) < std::abs(b.s - s); });
}

/// The pipe from `from` to `to`, arc lengths from the anchor; `end` is one of them.
StructureEndResult pipe_beside(const StaticResults& results, double end, double from, double to) {
  StructureEndResult beside;
  beside.s = end;
  beside.bending_moment = nearest_station(results.stations, end).bending_moment;
  for (const Station& at : results.stations) {
    const bool within = at.s > from && at.s < to;
    if (!within || at.kind != SectionKind::pipe) continue;
    keep_larger(beside.bending_stress, at.bending_stress);
    keep_larger(beside.von_mises, at.von_mises);
    keep_larger(beside.strain, at.strain);
  }
  return beside;
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

StructureResult recovered(const Model& model, const SectionSpan& span, const StaticResults& results) {
  StructureResult structure;
  structure.name = model.sections[static_cast<std::size_t>(span.section)].name;
  structure.from_top = 0.5 * (span.from + span.to);
  const double to = results.total_length - span.from, from = results.total_length - span.to;
  const double reach = kBesideDiameters * model.pipe_section().outer_diameter;
  const Station& middle = nearest_station(results.stations, 0.5 * (from + to));
  structure.p_W = middle.p_W;
  structure.astern = middle.astern;
  structure.inclination = middle.inclination;
  for (const Station& at : results.stations) {
    if (at.s < from - 1e-9 || at.s > to + 1e-9) continue;
    keep_larger(structure.bending_moment, at.bending_moment);
    structure.effective_tension = std::max(structure.effective_tension, at.effective_tension);
  }
  add_reaction(results, from, to, structure);
  structure.upper = pipe_beside(results, to, to, to + reach);
  structure.lower = pipe_beside(results, from, from - reach, from);
  return structure;
}

}  // namespace

std::vector<StructureResult> recover_structures(const Model& model, const StaticResults& results) {
  std::vector<StructureResult> all;
  for (const SectionSpan& span : model.spans) {
    const bool structure = model.sections[static_cast<std::size_t>(span.section)].kind == SectionKind::structure;
    if (structure && span.to < results.total_length) all.push_back(recovered(model, span, results));
  }
  return all;
}

}  // namespace overbend
