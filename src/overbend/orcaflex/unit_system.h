/// Units of an OrcaFlex file.
#pragma once

#include <optional>

#include "orcaflex/object.h"

namespace overbend::orcaflex {

/// Factors that turn values of the file into SI, and the acceleration of gravity with which it turns masses into
/// weights. SI of OrcaFlex is m, te, kN; US is ft, kip of mass, kip of force; User names its units (OrcaFlex help,
/// "General data", Units).
struct UnitSystemOfFile {
  double length = 1.0;       ///< [m]
  double mass = 1000.0;      ///< [kg]
  double force = 1000.0;     ///< [N]
  double gravity = 9.80665;  ///< [m/s^2]

  double density() const { return mass / (length * length * length); }         ///< [kg/m^3]
  double weight_density() const { return density() * gravity; }                ///< [N/m^3] per mass density.
  double weight_per_length() const { return mass / length * gravity; }         ///< [N/m] per mass per length.
  double pressure() const { return force / (length * length); }                ///< [Pa]
  double stiffness() const { return force / length; }                          ///< [N/m]
  double bed_stiffness() const { return force / (length * length * length); }  ///< [N/m^3]
};

/// Reads the units of General; those of SI if there is none. Unknown units are errors.
UnitSystemOfFile read_units(const std::optional<Object>& general);

}  // namespace overbend::orcaflex
