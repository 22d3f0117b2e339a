/// The vessel of a model as a body: its rollers with their laws.
#pragma once

#include "mechanics/roller_rub.h"
#include "mechanics/vessel_motion.h"
#include "system/body.h"
#include "system/line_mesh.h"

namespace overbend {

/// Normal penalty of `default_stiffness: penalty`: EI / D^3 with the outside diameter of the steel, what a piece of
/// pipe as long as it is thick resists across with, whatever the mesh [N/m].
double penalty_stiffness(const Section& pipe);

/// Rollers of the supports in the vessel's frame.
///
/// Damping follows from the coefficient of restitution and the mass that an impact moves (impact_mass.h), with added
/// mass under water in the mean pose, against a rigid roller ([silva2009] equations 16 to 18; Schwager & Poeschel 2007
/// for contacts that never pull, or the textbook's formula, as the roller asks). Tangential stiffness, where the roller
/// has none of its own, is a tenth of the normal one.
std::vector<BodyRoller> vessel_rollers(const Model& model);

/// With the cells that find the elements of a line with this largest outer radius [m].
Body vessel_body(const Model& model, double pipe_radius);

/// Friction of the rollers on the pipe at rest. Paid out, it slides astern over them, and they hold it back towards the
/// tensioner.
RollerRub static_rub(const Model& model);

/// The body in its mean pose, at rest.
RigidMotion resting(const VesselPose& pose);

}  // namespace overbend
