#include "model/vessel/station.h"

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

const MooringsDescription& moorings_of(const Description& description) {
  static const MooringsDescription none;
  return description.moorings ? *description.moorings : none;
}

}  // namespace overbend
