/// Results of the pipe recorder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/shown_unit.h"
#include "mechanics/contact_damage.h"
#include "model/site/wave_groups.h"
#include "recording/dynamic_findings.h"
#include "recording/pipe_recorder.h"
#include "recording/pipe_recorder_layout.h"

namespace overbend {
namespace {

/// Statistics over the times at which the quantity had a value; NaN if it never had one.
SummaryStatistics compute_spread(const RunningStatistics& statistics, const std::vector<double>& deviation,
                                 std::size_t i) {
  if (statistics.min()[i] > statistics.max()[i]) {
    constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();
    return {kAbsent, kAbsent, kAbsent, kAbsent};
  }
  return {statistics.min()[i], statistics.max()[i], statistics.mean()[i], deviation[i]};
}

Envelope make_envelope(const RunningStatistics& statistics, const std::vector<double>& deviation, std::size_t first,
                       std::size_t count) {
  const auto part = [&](std::span<const double> all) {
    return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(first),
                               all.begin() + static_cast<std::ptrdiff_t>(first + count));
  };
  return {part(statistics.min()), part(statistics.max()), part(statistics.mean()), part(deviation)};
}

}  // namespace

void PipeRecorder::fill_supports(DynamicResults& results) const {
  const std::vector<double> deviation = support_statistics_.standard_deviation();
  std::size_t roller = 0;
  const bool captured = model_->description.dynamics.value_or(DynamicSettings{}).impacts == ImpactTreatment::captured;
  for (std::size_t box = 0; box < boxes_; ++box) {
    const SupportBox& support = model_->supports.boxes[box];
    const std::size_t offset = kBoxQuantities * box;
    const auto spread = [&](std::size_t i) { return compute_spread(support_statistics_, deviation, i); };
    SupportDynamics out;
    out.name = support.name;
    out.s = statics_->supports.at(box).s;
    out.stinger = support.structure == Structure::stinger;
    out.reaction = spread(offset);
    out.reaction_over_time = {reaction_quantiles_.at(box, 0.5), reaction_quantiles_.at(box, 0.9),
                              reaction_quantiles_.at(box, 0.99)};
    out.vertical = spread(offset + 1);
    out.longitudinal = spread(offset + 2);
    out.lateral = spread(offset + 3);
    out.separation = spread(offset + 4);
    out.contact_share = spread(offset + 5).mean;
    out.static_reaction = static_supports_[offset];
    out.static_separation = static_supports_[offset + 4];
    if (departures_[box].time < kNever) {
      (departures_[box].side > 0.0 ? out.left_to_port : out.left_to_starboard) = departures_[box].time;
    }
    for (; roller < rollers_ && model_->supports.rollers[roller].box == static_cast<int>(box); ++roller) {
      const Roller& placed = model_->supports.rollers[roller];
      const Section& pipe = model_->section_over(placed);
      const std::size_t i = kBoxQuantities * boxes_ + kRollerQuantities * roller;
      RollerDynamics r;
      r.roller = static_cast<int>(roller);
      r.box = placed.box;
      r.row = placed.row - support.first_row;
      r.position = placed.position;
      r.reaction = spread(i);
      r.separation = spread(i + 1);
      r.contact_share = spread(i + 2).mean;
      r.static_reaction = static_supports_[i];
      r.static_separation = static_supports_[i + 1];
      r.impact_count = static_cast<std::int64_t>(impacts_[roller].count);
      r.max_approach_velocity = impacts_[roller].velocity;
      r.max_impact_force = impacts_[roller].force;
      r.max_impulse = impacts_[roller].impulse;
      if (captured) {  // their peaks occur between two steps
        r.reaction.max = std::max(r.reaction.max, r.max_impact_force);
        out.reaction.max = std::max(out.reaction.max, impacts_[roller].of_box);
      }
      r.dent_depth = dent_depth(r.reaction.max, pipe);
      r.line_load = line_load(r.reaction.max, contact_length(placed.face, pipe.outer_diameter, pipe.steel_diameter));
      out.impact_count += r.impact_count;
      out.rollers.push_back(r);
    }
    results.supports.push_back(out);
  }
}

DynamicExtreme PipeRecorder::make_extreme(const RegionPeak& peak, const SummaryStatistics& over_time) const {
  DynamicExtreme out;
  out.over_time = over_time;
  out.s = peak.s;
  out.time = peak.time;
  const auto node = std::lower_bound(places().begin(), places().end(), peak.s - 1e-9);
  const std::size_t n = static_cast<std::size_t>(node - places().begin());
  out.p_W = Vec3(static_nodes_.x[n], static_nodes_.y[n], static_nodes_.z[n]);
  return out;
}

void PipeRecorder::fill_regions(DynamicResults& results) const {
  const std::vector<double> deviation = key_statistics_.standard_deviation();
  const auto extreme = [&](const RegionPeak& peak, std::size_t i) {
    return make_extreme(peak, compute_spread(key_statistics_, deviation, i));
  };
  const auto region = [&](const RegionPeak(&peaks)[4], std::size_t first) {
    return DynamicRegion{extreme(peaks[0], first), extreme(peaks[1], first + 1), extreme(peaks[2], first + 2),
                         extreme(peaks[3], first + 3)};
  };
  (static_departure_ ? results.overbend : results.tower) = region(key_.upper, kUpper);
  results.sagbend = region(key_.sagbend, kSagbend);
  results.min_effective_tension = extreme(key_.slack, kMinLineTension);
  SummaryStatistics* const spreads[5] = {&results.top_tension, &results.bottom_tension, &results.lay_back,
                                         &results.departure_angle, &results.stinger_tip_clearance};
  for (std::size_t i = 0; i < 5; ++i) {
    *spreads[i] = compute_spread(key_statistics_, deviation, i);
  }
}

void PipeRecorder::fill_tensioner_findings(DynamicResults& results) const {
  const TensionerDynamics& t = results.tensioner;
  if (t.time_at_limit > 0.0) {
    results.findings.push_back(
        Finding{FindingCode::tensioner_at_travel_limit,
                fmt::format("the tensioner was at its travel limit for {:.1f} s, with the tension uncontrolled",
                            t.time_at_limit)}
            .on("tensioner")
            .with("duration", t.time_at_limit, "s"));
  }
  const TensionerDescription& machine = model_->description.tensioner;
  const double max_travel = std::max(t.travel.max, -t.travel.min);
  if (machine.mode == TensionerMode::constant && machine.travel && max_travel > *machine.travel && move_ == nullptr) {
    results.findings.push_back(Finding{
        FindingCode::tensioner_at_travel_limit,
        fmt::format("the ideal tensioner of constant tension travels up to {} from the start, more than its "
                    "tensioner.travel of {}, which it ignores: a real machine would reach its limit, and the tension "
                    "would not be constant",
                    shown(max_travel, "m", 2), shown(*machine.travel, "m", 2))}
                                   .on("tensioner")
                                   .with("travel", max_travel, "m"));
  }
  if (!model_->supports.boxes.empty() && model_->supports.boxes.front().structure == Structure::ramp) {
    const double free = model_->supports.boxes.front().point_S.x() - model_->description.tensioner.x;
    if (t.travel.max > free && move_ == nullptr) {
      results.findings.push_back(
          Finding{FindingCode::pipe_end_past_first_box,
                  fmt::format("the tensioner paid out {}, more than the distance of {} to the first box: "
                              "the end of the pipe, which moves with the travel, passed it",
                              shown(t.travel.max, "m", 2), shown(free, "m", 2))}
              .on("tensioner")
              .with("travel", t.travel.max, "m"));
    }
  }
}

void PipeRecorder::fill_findings(DynamicResults& results) const {
  warn_of_left_boxes(results);
  std::optional<YieldingStation> worst;
  for (std::size_t node = 0; node < results.von_mises.max.size(); ++node) {
    const Section& pipe = model_->sections[static_cast<std::size_t>(recovery_.sections()[first_ + node])];
    if (pipe.yield_stress <= 0.0 || pipe.bending) continue;
    const YieldingStation place{results.station_s[node], results.von_mises.max[node], pipe.yield_stress};
    if (place.share() > (worst ? worst->share() : 1.0)) worst = place;
  }
  if (worst) warn_of_yield(*statics_, *worst, results);
  fill_tensioner_findings(results);
  append(results.findings, stinger_.findings());
  if (const std::optional<InitialStateMonitor::Departure> departure = start_.departure()) {
    warn_of_departure(*statics_, departure->distance, places()[departure->node], departure->time, results);
  }
}

/// Reports the sensitivity of impact forces to the contact stiffness, which is uncertain by a factor.
void PipeRecorder::fill_assumptions(DynamicResults& results) const {
  if (hardest_.empty()) return;
  const double force = hardest_.front().peak_force;
  const double stiffness = (*body_rollers_)[static_cast<std::size_t>(hardest_.front().roller)].law.stiffness;
  results.assumptions.push_back(
      {AssumptionRank::governing,
       fmt::format(
           "The hardest impact of {} was on a contact stiffness of {}; with half that stiffness it would be {}, with "
           "twice {} (the force is proportional to its cube root at the same approach velocity).",
           shown(force, "N", 1), shown_digits(stiffness, contact_stiffness_unit(), 3),
           shown(force * std::cbrt(0.5), "N", 1), shown(force * std::cbrt(2.0), "N", 1))});
}

/// Reports the slamming load, which the equations of motion neglect, at the fastest water entry.
void PipeRecorder::fill_slamming(DynamicResults& results) const {
  if (crossing_.speed() <= 0.0 || is_calm(model_->description.environment.waves)) return;
  const double from_top = places().back() - crossing_.s();
  const Section& pipe = model_->sections[static_cast<std::size_t>(model_->section_at(from_top))];
  const double force = slamming_force(model_->water_density, pipe.outer_diameter, crossing_.speed());
  const std::string size = fmt::format(
      "the fastest entry into the water, {} across the pipe {} from the tensioner at t = {:.1f} s, would give a "
      "slamming load of {} at first contact (rho/2 C_s D v^2, C_s = 5.15 of DNV-RP-C205; {} at {})",
      shown(crossing_.speed(), "m/s", 2), shown(from_top, "m", 1), crossing_.time(), shown(force, "N/m", 2),
      shown(slamming_force(model_->water_density, pipe.outer_diameter, 1.0), "N/m", 2), shown_digits(1.0, "m/s", 3));
  results.assumptions.push_back(
      {AssumptionRank::other,
       "Slamming and the rate of change of added mass at the surface are neglected; " + size + "."});
}

void PipeRecorder::fill(DynamicResults& results) const {
  const std::size_t n = nodes_.x.size() - first_;
  const std::vector<double> deviation = node_statistics_.standard_deviation();
  Envelope* const envelopes[kNodeQuantities] = {&results.effective_tension,
                                                &results.bending_moment,
                                                &results.bending_stress,
                                                &results.von_mises,
                                                &results.strain,
                                                &results.x,
                                                &results.y,
                                                &results.z};
  for (std::size_t i = 0; i < kNodeQuantities; ++i) {
    *envelopes[i] = make_envelope(node_statistics_, deviation, i * n, n);
  }
  const auto recorded = [&](const std::vector<double>& all) {
    return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(first_), all.end());
  };
  results.station_s = recorded(places());
  results.static_tension = recorded(static_nodes_.effective_tension);
  results.static_moment = recorded(static_nodes_.bending_moment);
  results.static_bending_stress = recorded(static_nodes_.bending_stress);
  results.static_von_mises = recorded(static_nodes_.von_mises);
  results.static_strain = recorded(static_nodes_.strain);
  for (std::size_t i = first_; i < nodes_.x.size(); ++i) {
    results.static_place.emplace_back(static_nodes_.x[i], static_nodes_.y[i], static_nodes_.z[i]);
  }
  design_.fill(results.design, first_);
  fill_regions(results);
  fill_supports(results);
  results.hardest_impacts = hardest_;
  results.impact_count = static_cast<std::int64_t>(impact_count_);
  results.tensioner = tensioner_.results();
  results.stinger = stinger_.results();
  fill_assumptions(results);
  fill_slamming(results);
  fill_findings(results);
  warn_of_slack(*statics_, results);
  if (fatigue_) fatigue_->fill(results);
}

}  // namespace overbend
