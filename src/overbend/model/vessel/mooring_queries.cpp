#include "model/vessel/mooring_queries.h"

#include <algorithm>

#include "base/ranges.h"

namespace overbend {

bool has_mooring_lines(const Description& description) {
  return description.moorings && !description.moorings->lines.empty();
}

bool hull_is_free(const Description& description) {
  return description.vessel.hydrostatics || description.vessel.coupled;
}

bool is_positioned(const Description& description) {
  return description.station_keeping && hull_is_free(description);
}

bool has_vessel(const Description& description) {
  const auto held = [](const FreeLineDescription& line) {
    return is_on_vessel(line.first) || is_on_vessel(line.second);
  };
  return description.has_pipe || description.moorings || description.lines.empty() ||
         ranges::any_of(description.lines, held);
}

const MooringsDescription& find_moorings(const Description& description) {
  static const MooringsDescription none;
  return description.moorings ? *description.moorings : none;
}

}  // namespace overbend
