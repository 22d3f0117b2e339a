#include "report/stages/hold_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "report/stages/stage_labels.h"
#include "results/fields/location_names.h"
#include "results/verdict.h"

namespace overbend {
namespace {

/// Distance of the head beyond an object, negative before it [m]; none without such an object.
using Beyond = std::function<std::optional<double>(const StaticResults& lay)>;

struct Passing {
  Beyond beyond;
  const char* out;   ///< Event on the way out.
  const char* back;  ///< Event on the way back.
};

/// The support farthest astern; null in J-lay.
const SupportResult* last_box(const StaticResults& lay, bool of_stinger) {
  const SupportResult* last = nullptr;
  for (const SupportResult& box : lay.supports) {
    if ((!of_stinger || box.stinger) && (last == nullptr || box.astern > last->astern)) last = &box;
  }
  return last;
}

std::optional<double> beyond_last_roller(const StaticResults& lay) {
  const SupportResult* box = last_box(lay, false);
  if (box == nullptr || box->rows.empty()) return std::nullopt;
  double last = ship_point(lay, box->rows.front().p_W).x();
  for (const RowResult& row : box->rows) last = std::max(last, ship_point(lay, row.p_W).x());
  return lay.head->astern - last;
}

std::optional<double> beyond_tip(const StaticResults& lay) {
  const SupportResult* box = last_box(lay, true);
  if (box == nullptr) return std::nullopt;
  return lay.head->astern - (ship_point(lay, box->p_W).x() + 0.5 * box->length * std::cos(box->inclination));
}

const std::array<Passing, 4>& passings() {
  static const std::array<Passing, 4> kAll = {
      {{beyond_last_roller, "the head leaves the last roller", "the head comes onto the last roller"},
       {beyond_tip, "the head leaves the stinger tip", "the head comes to the stinger tip"},
       {[](const StaticResults& lay) { return std::optional(-lay.head->p_W.z()); }, "the head goes under water",
        "the head comes out of the water"},
       {[](const StaticResults& lay) { return std::optional(-lay.head->clearance); }, "the head touches the seabed",
        "the head lifts off the seabed"}}};
  return kAll;
}

std::optional<double> between(const StageResult& before, const StageResult& after, double share) {
  const std::optional<double> from = stage_progress(before.stage), to = stage_progress(after.stage);
  if (!from || !to) return std::nullopt;
  return *from + share * (*to - *from);
}

/// Adds the points passed between two stages, in their order.
void add_passings(const StageResult& before, const StageResult& after, std::size_t stage,
                  std::vector<HoldPoint>& points) {
  std::multimap<double, HoldPoint> passed;  // by the fraction of the way
  for (const Passing& passing : passings()) {
    const std::optional<double> was = passing.beyond(*before.lay), is = passing.beyond(*after.lay);
    if (!was || !is || (*was > 0.0) == (*is > 0.0)) continue;
    const double share = *was / (*was - *is);
    passed.emplace(share, HoldPoint{stage, *is > 0.0 ? passing.out : passing.back, between(before, after, share)});
  }
  for (const auto& [share, point] : passed) points.push_back(point);
}

bool has_head(const StageResult& stage) {
  return stage.lay && stage.lay->head;
}

}  // namespace

std::optional<StageUtilisation> find_max_utilisation(const StageResult& stage) {
  if (!stage.lay) return std::nullopt;
  std::optional<StageUtilisation> use;
  if (const CheckRow* worst = find_governing_check(stage.lay->checks)) use = {worst->utilisation, check_label(*worst)};
  return use;
}

std::optional<std::size_t> find_governing_stage_index(const OperationResults& results) {
  std::optional<std::size_t> hardest;
  double max_utilisation = 0.0;
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    const std::optional<StageUtilisation> use = find_max_utilisation(results.stages[i]);
    if (!use || (hardest && use->utilisation <= max_utilisation)) continue;
    hardest = i;
    max_utilisation = use->utilisation;
  }
  return hardest;
}

std::vector<HoldPoint> hold_points(const OperationResults& results) {
  const std::optional<std::size_t> hardest = find_governing_stage_index(results);
  std::vector<HoldPoint> points;
  const StageResult* before = nullptr;
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    const StageResult& stage = results.stages[i];
    if (before != nullptr && has_head(stage)) add_passings(*before, stage, i, points);
    if (hardest == i) points.push_back({i, "highest utilisation of the operation", {}});
    if (has_head(stage)) before = &stage;
  }
  return points;
}

}  // namespace overbend
