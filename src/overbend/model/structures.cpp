#include "model/structures.h"

#include <algorithm>

#include "model/lay_stage.h"

namespace overbend {
namespace {

/// Removes the range from `from` to `to` from the spans.
void remove_range(std::vector<SectionSpan>& spans, double from, double to) {
  std::vector<SectionSpan> kept;
  for (const SectionSpan& span : spans) {
    if (span.from < std::min(span.to, from)) kept.push_back({span.from, std::min(span.to, from), span.section});
    if (std::max(span.from, to) < span.to) kept.push_back({std::max(span.from, to), span.to, span.section});
  }
  spans = std::move(kept);
}

}  // namespace

void add_structures(Model& model) {
  const double gone = pipe_shift(model.description);
  const double first = pipe_start_distance(model.description), last = pipe_end_distance(model.description);
  for (const StructureDescription& structure : model.description.pipe.structures) {
    if (!structure.at) continue;
    const double middle = *structure.at + gone;
    const double from = std::max(middle - 0.5 * structure.length, first);
    const double to = std::min(middle + 0.5 * structure.length, last);
    if (to <= from) continue;
    const auto around = static_cast<std::size_t>(model.section_at(0.5 * (from + to)));
    const SectionDescription described = model.find_section_description(around);
    model.sections.push_back(structure_section(structure, model.sections[around], model.water_weight_density));
    model.described.push_back(described);
    remove_range(model.spans, from, to);
    model.spans.push_back({from, to, static_cast<int>(model.sections.size()) - 1});
  }
  std::sort(model.spans.begin(), model.spans.end(),
            [](const SectionSpan& a, const SectionSpan& b) { return a.from < b.from; });
}

}  // namespace overbend
