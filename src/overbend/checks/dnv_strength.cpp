#include "checks/dnv_strength.h"

#include <algorithm>

namespace overbend {

double safety_class_factor(SafetyClass safety) {
  switch (safety) {
    case SafetyClass::low:
      return 1.04;
    case SafetyClass::medium:
      return 1.14;
    case SafetyClass::high:
      break;
  }
  return 1.26;
}

double strain_safety_factor(SafetyClass safety) {
  switch (safety) {
    case SafetyClass::low:
      return 2.0;
    case SafetyClass::medium:
      return 2.5;
    case SafetyClass::high:
      break;
  }
  return 3.3;
}

double fabrication_factor(Manufacture manufacture) {
  switch (manufacture) {
    case Manufacture::seamless:
      return 1.0;
    case Manufacture::erw:
    case Manufacture::hfw:
    case Manufacture::trb:
    case Manufacture::uo:
      return 0.93;
    case Manufacture::uoe:
      break;
  }
  return 0.85;
}

double burst_strength(double fy, double fu) {
  return std::min(fy, fu / 1.15);
}

}  // namespace overbend
