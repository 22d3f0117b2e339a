/// A stinger on hinges in motion: its sections become bodies that hang on the vessel.
#pragma once

#include "mechanics/sea.h"
#include "model/model.h"
#include "system/assembly.h"

namespace overbend {

/// Whether a section finds its angle by the forces on it. A stinger that the ship holds stays part of the vessel.
bool stinger_floats(const Model& model);

/// A section as it rests: inertia, strips of its tanks, springs. Frame V.
SectionBody section_body(const Model& model, std::size_t section);

/// Takes the stinger's rollers off the vessel, body 0 of the system, and hangs its sections there; see
/// docs/theory/stinger-motion.md. They begin where statics left them. `build_up` [s].
void hang_stinger(const Model& model, const Sea& sea, double build_up, System& system);

/// Shifts the stops that statics left carrying a moment, so that their springs carry it at the start. The assembly, of
/// this system, has been brought to the time of `state`, which is at rest.
void lean_on_stops(Assembly& assembly, const SystemState& state, System& system);

}  // namespace overbend
