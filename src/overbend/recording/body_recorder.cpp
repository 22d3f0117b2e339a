#include "recording/body_recorder.h"

#include <cmath>

#include "base/ranges.h"
#include "model/bodies.h"
#include "system/body_forces.h"

namespace overbend {
namespace {

constexpr std::size_t kQuantities = kVesselFreedoms + 1;

}  // namespace

BodyRecorder::BodyRecorder(const Model& model, std::size_t first) : model_(&model), first_(first) {
  for (const BodyDescription& body : model.description.bodies) {
    nominal_.push_back(body_pose(body));
    statistics_.emplace_back(kQuantities);
  }
}

void BodyRecorder::add(const SystemState& state, const Assembly& assembly) {
  if (state.time <= 0.0) return;
  for (std::size_t i = 0; i < nominal_.size(); ++i) {
    const auto shift = shift_between(nominal_[i], assembly.surroundings().bodies[first_ + i].pose);
    const Vec3 force = force_on_body(assembly, state, static_cast<int>(first_ + i)).force;
    std::array<double, kQuantities> sample{};
    ranges::copy(shift, sample.begin());
    sample.back() = force.head<2>().norm();
    statistics_[i].add(sample, state.last_step);
  }
}

std::vector<BodyDynamics> BodyRecorder::results() const {
  std::vector<BodyDynamics> results;
  for (std::size_t i = 0; i < nominal_.size(); ++i) {
    const RunningStatistics& statistics = statistics_[i];
    const std::vector<double> deviation = statistics.standard_deviation();
    BodyDynamics body;
    body.name = model_->description.bodies[i].name;
    SummaryStatistics* const spreads[kQuantities] = {&body.surge, &body.sway, &body.heave, &body.roll,
                                                     &body.pitch, &body.yaw,  &body.pull};
    for (std::size_t k = 0; k < kQuantities; ++k) {
      *spreads[k] = {statistics.min()[k], statistics.max()[k], statistics.mean()[k], deviation[k]};
    }
    results.push_back(std::move(body));
  }
  return results;
}

std::vector<double> BodyRecorder::save() const {
  std::vector<double> saved;
  for (const RunningStatistics& statistics : statistics_) {
    const std::vector<double> values = statistics.save();
    saved.push_back(static_cast<double>(values.size()));
    saved.insert(saved.end(), values.begin(), values.end());
  }
  return saved;
}

void BodyRecorder::restore(const std::vector<double>& saved) {
  auto from = saved.begin();
  for (RunningStatistics& statistics : statistics_) {
    const auto count = static_cast<std::ptrdiff_t>(*from++);
    statistics.restore(std::vector<double>(from, from + count));
    from += count;
  }
}

void add_body_columns(const Model& model, std::size_t first, std::vector<RecordedColumn>& columns) {
  constexpr std::array<const char*, kVesselFreedoms> kMeanings = {
      "Shift forward from the nominal position", "Shift to port from the nominal position",
      "Shift upwards from the nominal position", "Starboard down, from the nominal pose",
      "Bow down, from the nominal pose",         "Bow to port, from the nominal pose"};
  for (std::size_t i = 0; i < model.description.bodies.size(); ++i) {
    const std::string name = "body/" + model.description.bodies[i].name + "/";
    const VesselPose drawn = body_pose(model.description.bodies[i]);
    const std::size_t index = first + i;
    const auto add = [&](const char* key, const char* units, const char* meaning, bool of_force, auto value) {
      RecordedColumn& made = columns.emplace_back();
      made.column = {name + key, units, meaning, of_force, of_force};
      made.value = value;
    };
    for (std::size_t k = 0; k < kVesselFreedoms; ++k) {
      add(kFreedomNames[k], k < 3 ? "m" : "rad", kMeanings[k], false, [=](const RowSource& row) {
        return shift_between(drawn, row.instant.assembly->surroundings().bodies[index].pose)[k];
      });
    }
    add("pull", "N", "Horizontal force of all lines on it", true, [=](const RowSource& row) {
      return force_on_body(*row.instant.assembly, *row.instant.state, static_cast<int>(index)).force.head<2>().norm();
    });
  }
}

}  // namespace overbend
