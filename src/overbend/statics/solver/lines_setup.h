/// Builds a system and its initial shape from the lines of a model without a lay.
#pragma once

#include <memory>
#include <vector>

#include "hull/hull.h"
#include "statics/initial_shape/cable_shape.h"
#include "statics/solver/lines_statics.h"
#include "system/system.h"

namespace overbend {

/// Lines with their attachments. `system.surroundings` is that of statics: bodies in their mean poses, ends at their
/// mean positions. Attachments 2 i and 2 i + 1 are the first and the second end of line i; the vessel is body 0, the
/// other bodies of the model follow in their order. If lines are attached to lines, the junctions are points of
/// System::bodies, and lines without weight are wires of the system. Points into `model`, which must outlive it.
struct LinesSetup {
  System system;
  std::vector<std::vector<double>> start;  ///< Initial shape, six per node, per line.
  std::vector<int> lines;                  ///< Per line of the model: index of the line in the system, -1 if none.
  std::vector<int> wires;                  ///< Same for wires of the system.
  std::shared_ptr<Hull> hull;  ///< Hull of a free-floating vessel, to which `system` points; see float_vessel().
};

/// For lines attached to lines, the initial shape is pipe on the bed, with wires long enough to be slack.
LinesSetup lines_setup(const Model& model);

/// True if lines of a model are attached to each other, or have a free end.
bool has_linked_lines(const Description& description);

/// Such lines in equilibrium: initial state of a time-domain simulation.
struct StaticLines {
  LinesSetup setup;
  SystemState state;
  LinesEquilibriumReport rest;
};

/// Mesh requirements of a line: pipe by the results needed on the bed, others by the rule for cables.
CableMesh make_mesh_requirements(const Model& model, const FreeLineDescription& line, const CableParts& parts);

/// State with the initial shapes, at rest at `time` [s].
SystemState make_initial_state(const LinesSetup& setup, double time);

/// Surroundings of lines in statics: the first bodies of their system in given poses, ends where bodies or the ground
/// hold them.
SurroundingsAt static_surroundings(const std::vector<VesselPose>& poses, const std::vector<Attachment>& attachments);

}  // namespace overbend
