#include "recording/dynamic_findings.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "base/shown_unit.h"
#include "statics/recovery/static_findings.h"

namespace overbend {

void warn_of_slack(const StaticResults& statics, DynamicResults& results) {
  const DynamicExtreme& minimum = results.min_effective_tension;
  if (minimum.over_time.min >= 0.0) return;
  results.findings.push_back(
      Finding{FindingCode::compression,
              fmt::format("compression: the effective tension falls to {} at t = {:.1f} s, {}{}; a pipe in compression "
                          "may buckle, which the model represents only as far as its mesh allows",
                          shown(minimum.over_time.min, "N", 2), minimum.time, pipe_place(statics, minimum.s),
                          results.top_tension.min < 0.0 ? ", and below zero at the tensioner" : "")}
          .on("pipe")
          .at_place(statics.total_length - minimum.s)
          .at_time(minimum.time)
          .with("effective_tension", minimum.over_time.min, "N"));
}

void warn_of_yield(const StaticResults& statics, const YieldingStation& worst, DynamicResults& results) {
  std::string time;
  for (const DynamicRegion* region : {&results.overbend, &results.tower, &results.sagbend}) {
    const DynamicExtreme& extreme = region->von_mises;
    if (extreme.s == worst.s && extreme.over_time.max == worst.von_mises) {
      time = fmt::format(" at t = {:.1f} s,", extreme.time);
    }
  }
  results.findings.push_back(Finding{
      FindingCode::yield_with_linear_steel,
      fmt::format("the von Mises stress of {}{} {} exceeds the yield stress of {} in the dynamic analysis; the "
                  "steel is linear elastic here, so that stresses and moments beyond yield are those of a pipe that "
                  "does not yield (see pipe.steel.material)",
                  shown(worst.von_mises, "Pa", 0), time, pipe_place(statics, worst.s),
                  shown(worst.yield_stress, "Pa", 0))}
                                 .on("pipe")
                                 .at_place(statics.total_length - worst.s)
                                 .with("von_mises", worst.von_mises, "Pa"));
}

void warn_of_left_boxes(DynamicResults& results) {
  const auto warn = [&](std::optional<double> SupportDynamics::*left, const char* side) {
    const SupportDynamics *first = nullptr, *last = nullptr;
    int count = 0;
    for (const SupportDynamics& box : results.supports) {
      if (!(box.*left)) continue;
      ++count;
      if (first == nullptr || *(box.*left) < *(first->*left)) first = &box;
      if (last == nullptr || *(box.*left) > *(last->*left)) last = &box;
    }
    if (count == 1) {
      results.findings.push_back(Finding{
          FindingCode::pipe_off_rollers,
          fmt::format("the pipe left '{}' over its side to {} at t = {:.1f} s", first->name, side, *(first->*left))}
                                     .on(first->name)
                                     .at_time(*(first->*left)));
    } else if (count > 1) {
      results.findings.push_back(
          Finding{FindingCode::pipe_off_rollers,
                  fmt::format("the pipe left '{}' and {} more box{} over their sides to {}, the first at t = {:.1f} s, "
                              "the last at t = {:.1f} s",
                              first->name, count - 1, count > 2 ? "es" : "", side, *(first->*left), *(last->*left))}
              .on(first->name)
              .at_time(*(first->*left))
              .with("boxes", count, "1"));
    }
  };
  warn(&SupportDynamics::left_to_port, "port");
  warn(&SupportDynamics::left_to_starboard, "starboard");
}

void warn_of_departure(const StaticResults& statics, double distance, double s, double time, DynamicResults& results) {
  results.findings.push_back(Finding{
      FindingCode::run_not_at_rest,
      fmt::format("the run does not start in equilibrium: by t = {:.1f} s, before the sea and the motions "
                  "build up, the pipe has moved by {} {}; its static state is not a stable equilibrium, and the run "
                  "shows another lay",
                  time, shown(distance, "m", 2), pipe_place(statics, s))}
                                 .on("pipe")
                                 .at_place(statics.total_length - s)
                                 .at_time(time)
                                 .with("distance", distance, "m"));
}

}  // namespace overbend
