/// Checkpoints of the pipe recorder.
#include <algorithm>
#include <iterator>

#include "dynamics/integrator/dynamic_checkpoint.h"
#include "recording/pipe_recorder.h"

namespace overbend {
namespace {

constexpr std::size_t kImpactNumbers = 8;

}  // namespace

void PipeRecorder::save(DynamicCheckpoint& checkpoint) const {
  const auto put = [&](const char* name, std::vector<double> values) {
    checkpoint.arrays.push_back({name, std::move(values)});
  };
  put("record/nodes", node_statistics_.save());
  put("record/supports", support_statistics_.save());
  put("record/reactions", reaction_quantiles_.save());
  put("record/key", key_statistics_.save());
  put("record/tensioner", tensioner_.save());
  put("record/stinger", stinger_.save());
  put("record/start", start_.save());
  put("record/design", design_.save());
  if (fatigue_) put("record/fatigue", fatigue_->save());
  std::vector<double> peaks, impacts{impact_count_}, hardest;
  const auto put_peak = [&](const RegionPeak& peak) { peaks.insert(peaks.end(), {peak.maximum, peak.s, peak.time}); };
  for (const auto* region : {&key_.upper, &key_.sagbend}) {
    std::for_each(std::begin(*region), std::end(*region), put_peak);
  }
  put_peak(key_.slack);
  for (const RollerImpacts& i : impacts_) {
    impacts.insert(impacts.end(), {i.count, i.velocity, i.force, i.impulse, i.of_box});
  }
  for (const Impact& i : hardest_) {
    hardest.insert(hardest.end(), {static_cast<double>(i.roller), i.time, i.approach_velocity, i.peak_force, i.duration,
                                   i.impulse, i.dent_depth, i.line_load});
  }
  std::vector<double> left;
  for (const BoxDeparture& box : departures_) {
    left.insert(left.end(), {box.time, box.side});
  }
  put("record/left", std::move(left));
  put("record/crossing", crossing_.save());
  put("record/peaks", std::move(peaks));
  put("record/impacts", std::move(impacts));
  put("record/hardest", std::move(hardest));
}

void PipeRecorder::restore(const DynamicCheckpoint& checkpoint) {
  const auto get = [&](const char* name) -> const std::vector<double>& { return checkpoint_array(checkpoint, name); };
  reset_interval();  // checkpoints are written right after a row
  node_statistics_.restore(get("record/nodes"));
  support_statistics_.restore(get("record/supports"));
  reaction_quantiles_.restore(get("record/reactions"));
  key_statistics_.restore(get("record/key"));
  tensioner_.restore(get("record/tensioner"));
  stinger_.restore(get("record/stinger"));
  start_.restore(get("record/start"));
  crossing_.restore(get("record/crossing"));
  design_.restore(get("record/design"));
  if (fatigue_) fatigue_->restore(get("record/fatigue"));
  std::size_t i = 0;
  const std::vector<double>& peaks = get("record/peaks");
  const auto get_peak = [&](RegionPeak& peak) {
    peak.maximum = peaks.at(i++);
    peak.s = peaks.at(i++);
    peak.time = peaks.at(i++);
  };
  for (auto* region : {&key_.upper, &key_.sagbend}) {
    std::for_each(std::begin(*region), std::end(*region), get_peak);
  }
  get_peak(key_.slack);
  const std::vector<double>& impacts = get("record/impacts");
  impact_count_ = impacts.at(0);
  for (std::size_t r = 0; r < impacts_.size(); ++r) {
    const double* v = &impacts.at(5 * r + 1);
    impacts_[r] = {v[0], v[1], v[2], v[3], v[4]};
  }
  const std::vector<double>& left = get("record/left");
  for (std::size_t box = 0; box < boxes_; ++box) {
    departures_[box] = {left.at(2 * box), left.at(2 * box + 1)};
  }
  const std::vector<double>& hardest = get("record/hardest");
  hardest_.clear();
  for (std::size_t k = 0; k + kImpactNumbers <= hardest.size(); k += kImpactNumbers) {
    hardest_.push_back({static_cast<int>(hardest[k]), hardest[k + 1], hardest[k + 2], hardest[k + 3], hardest[k + 4],
                        hardest[k + 5], hardest[k + 6], hardest[k + 7]});
  }
}

}  // namespace overbend
