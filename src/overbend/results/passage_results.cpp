#include "results/passage_results.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// True where the value is the largest so far, and is kept.
bool keep(PassagePeak& peak, double value, const LayStageDescription& stage) {
  if (value <= peak.value) return false;
  peak = {value, stage.name, stage.passed.value_or(0.0)};
  return true;
}

double largest_roller(const SupportResult& box) {
  double largest = 0.0;
  for (const RowResult& row : box.rows) {
    for (const RollerResult& roller : row.rollers) largest = std::max(largest, roller.reaction);
  }
  return largest;
}

PassageBox& box_named(std::vector<PassageBox>& boxes, const std::string& name) {
  const auto at = std::find_if(boxes.begin(), boxes.end(), [&](const PassageBox& box) { return box.name == name; });
  if (at != boxes.end()) return *at;
  boxes.emplace_back().name = name;
  return boxes.back();
}

void take_boxes(const StaticResults& lay, const LayStageDescription& stage, std::vector<PassageBox>& boxes) {
  for (const SupportResult& support : lay.supports) {
    PassageBox& box = box_named(boxes, support.name);
    keep(box.roller, largest_roller(support), stage);
    keep(box.reaction, support.reaction, stage);
    keep(box.strain, support.strain, stage);
  }
}

void take_structure(const StructureResult& found, const LayStageDescription& stage, PassageResults& passage) {
  if (keep(passage.reaction, found.reaction, stage)) passage.support = found.support;
  keep(passage.bending_moment, found.bending_moment, stage);
  for (const StructureEndResult* end : {&found.upper, &found.lower}) {
    keep(passage.strain, end->strain, stage);
    keep(passage.von_mises, end->von_mises, stage);
  }
}

/// The structure that lies where the stage says; at the tensioner a part of it is not there yet, and its middle
/// elsewhere.
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

std::optional<PassageResults> passage_of(const OperationResults& operation) {
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
