/// Hinged stinger in dynamics: its sections become bodies on hinges at the vessel.
#pragma once

#include "mechanics/sea.h"
#include "model/model.h"
#include "system/assembly.h"

namespace overbend {

/// True if the angle of a section follows from the forces on it. A stinger held by the vessel stays part of it.
bool stinger_floats(const Model& model);

/// Returns a section in its static position: inertia, strips of its tanks, springs. Frame V.
SectionBody section_body(const Model& model, std::size_t section);

/// Moves the stinger's rollers from the vessel, body 0 of the system, to hinged sections at their static angles; see
/// docs/theory/stinger-motion.md. `build_up` [s].
void add_hinged_stinger(const Model& model, const Sea& sea, double build_up, System& system);

/// Shifts the stops that carry a moment in statics, so that their springs carry it initially. The assembly, of this
/// system, must be at the time of `state`, which is at rest.
void preload_hinge_stops(Assembly& assembly, const SystemState& state, System& system);

}  // namespace overbend
