/// The vessel of a model as a body: its rollers with their laws.
#pragma once

#include "mechanics/mobilised_friction.h"
#include "mechanics/vessel_motion.h"
#include "system/body.h"
#include "system/line_mesh.h"

namespace overbend {

/// Returns the normal penalty stiffness of `default_stiffness: penalty`: EI / D^3 with the outside diameter of the
/// steel, the transverse stiffness of a pipe one diameter long, independent of the mesh [N/m].
double penalty_stiffness(const Section& pipe);

/// Returns the rollers of the supports in the vessel's frame.
/// || Damping follows from the coefficient of restitution and the mass moved by an impact (impact_mass.h), with added
/// mass under water in the mean pose, against a rigid roller ([silva2009] equations 16 to 18; Schwager & Poeschel 2007
/// for contacts without tension, or the textbook formula, as the roller specifies). The default tangential stiffness is
/// a tenth of the normal one.
std::vector<BodyRoller> vessel_rollers(const Model& model);

/// Returns the vessel with contact cells for a line of this maximum outer radius [m].
Body vessel_body(const Model& model, double pipe_radius);

/// Returns the friction of the rollers on the pipe at rest. Paid out, the pipe slides astern over them, and they hold
/// it back towards the tensioner.
MobilisedFriction static_rub(const Model& model);

/// Returns the motion of a body at rest in a pose.
RigidMotion resting(const VesselPose& pose);

}  // namespace overbend
