#include "recording/dynamic_warnings.h"

#include <fmt/format.h>

#include "statics/static_warnings.h"

namespace overbend {

void warn_of_slack(const StaticResults& statics, DynamicResults& results) {
  const DynamicExtreme& least = results.smallest_tension;
  if (least.over_time.min >= 0.0) return;
  results.warnings.push_back(
      fmt::format("compression: the effective tension falls to {:.2f} kN at t = {:.1f} s, {}{}; a pipe in compression "
                  "may buckle, which the model represents only as far as its mesh allows",
                  1e-3 * least.over_time.min, least.time, pipe_place(statics, least.s),
                  results.top_tension.min < 0.0 ? ", and below zero at the tensioner" : ""));
}

}  // namespace overbend
