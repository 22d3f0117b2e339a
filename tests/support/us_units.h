/// US customary units in what is printed, as long as the object lives.
#pragma once

#include "base/shown_unit.h"

namespace overbend {

class UsUnits {
 public:
  UsUnits() { use_units(UnitSystem::us); }
  ~UsUnits() { use_units(UnitSystem::metric); }
  UsUnits(const UsUnits&) = delete;
  UsUnits& operator=(const UsUnits&) = delete;
};

}  // namespace overbend
