#include "results/passage_results.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Returns true, and keeps the value, if it is the maximum so far.
bool update_peak(PassagePeak& peak, double value, const LayStageDescription& stage) {
  if (value <= peak.value) return false;
  peak = {value, stage.name, stage.passed.value_or(0.0)};
  return true;
}

double max_roller_reaction(const SupportResult& box) {
  double max_reaction = 0.0;
  for (const RowResult& row : box.rows) {
    for (const RollerResult& roller : row.rollers) max_reaction = std::max(max_reaction, roller.reaction);
  }
  return max_reaction;
}

PassageBox& box_named(std::vector<PassageBox>& boxes, const std::string& name) {
  const auto found = std::find_if(boxes.begin(), boxes.end(), [&](const PassageBox& box) { return box.name == name; });
  if (found != boxes.end()) return *found;
  boxes.emplace_back().name = name;
  return boxes.back();
}

void take_boxes(const StaticResults& lay, const LayStageDescription& stage, std::vector<PassageBox>& boxes) {
  for (const SupportResult& support : lay.supports) {
    PassageBox& box = box_named(boxes, support.name);
    update_peak(box.roller, max_roller_reaction(support), stage);
    update_peak(box.reaction, support.reaction, stage);
    update_peak(box.strain, support.strain, stage);
  }
}

void take_structure(const StructureResult& found, const LayStageDescription& stage, PassageResults& passage) {
  if (update_peak(passage.reaction, found.reaction, stage)) passage.support = found.support;
  update_peak(passage.bending_moment, found.bending_moment, stage);
  for (const StructureEndResult* end : {&found.upper, &found.lower}) {
    update_peak(passage.strain, end->strain, stage);
    update_peak(passage.von_mises, end->von_mises, stage);
  }
}

/// Returns the structure at the position given by the stage; near the tensioner a part of it is not in the line yet,
/// and its middle is elsewhere.
const StructureResult* passing(const StageResult& stage) {
  if (!stage.lay || !stage.stage.passed) return nullptr;
  for (const StructureResult& structure : stage.lay->structures) {
    if (std::abs(structure.from_top - *stage.stage.passed) < 1e-6) return &structure;
  }
  return nullptr;
}

std::string name_of_passing(const OperationResults& operation) {
  for (const StageResult& stage : operation.stages) {
    if (const StructureResult* structure = passing(stage)) return structure->name;
  }
  return "";
}

}  // namespace

std::optional<PassageResults> find_passage_maxima(const OperationResults& operation) {
  if (operation.type != OperationType::passage) return std::nullopt;
  PassageResults passage;
  passage.structure = name_of_passing(operation);
  if (passage.structure.empty()) return std::nullopt;
  for (const StageResult& stage : operation.stages) {
    if (!stage.lay) continue;
    take_boxes(*stage.lay, stage.stage, passage.boxes);
    for (const StructureResult& found : stage.lay->structures) {
      if (found.name == passage.structure) take_structure(found, stage.stage, passage);
    }
  }
  return passage;
}

}  // namespace overbend
