/// From the lines of a model that stand by themselves to a system and a first guess of its shape.
#pragma once

#include <memory>
#include <vector>

#include "hull/hull.h"
#include "statics/initial_shape/cable_start.h"
#include "statics/solver/lines_statics.h"
#include "system/system.h"

namespace overbend {

/// Lines with what holds their ends; `system.surroundings` is that of rest: bodies in their mean poses, ends at their
/// mean places. Attachments 2 i and 2 i + 1 are the first and the second end of line i; the vessel is body 0, the other
/// bodies of the model follow in their order. Where
/// lines are attached to lines, points of System::bodies are where they meet, and lines without weight are wires of the
/// system. Points into `model`, which must outlive it.
struct LinesSetup {
  System system;
  std::vector<std::vector<double>> start;  ///< First guess, six per node, line by line.
  std::vector<int> lines;                  ///< By the lines of the model: the line of the system, -1 where it is none.
  std::vector<int> wires;                  ///< The same of its wires.
  std::shared_ptr<Hull> hull;  ///< Of a vessel that floats free, to which `system` points; see float_vessel().
};

/// Of lines on lines the first guess is pipe that lies on the bed, with wires long enough to be slack.
LinesSetup lines_setup(const Model& model);

/// Whether lines of a model hold each other, or have a free end.
bool has_linked_lines(const Description& description);

/// Such lines at rest: what a run in time starts from.
struct LinesAtRest {
  LinesSetup setup;
  SystemState state;
  LinesRest rest;
};

/// What the mesh of a line is made for: pipe by what it has to show on the bed, others by the rule of cables.
CableMesh wanted_mesh(const Model& model, const FreeLineDescription& line, const CableParts& parts);

/// A state with the shapes of the first guess, at rest at `time`.
SystemState start_of(const LinesSetup& setup, double time);

/// What stands around lines at rest: the first bodies of their system in poses, ends where they or the ground have
/// them.
SurroundingsAt resting_surroundings(const std::vector<VesselPose>& poses, const std::vector<Attachment>& attachments);

}  // namespace overbend
