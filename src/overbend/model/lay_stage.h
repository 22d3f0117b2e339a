/// Operation stages as models of their own.
#pragma once

#include <vector>

#include "model/description/lay_operation_description.h"

namespace overbend {

struct Description;

/// Returns the stages of the operation in order, including generated ones. Tensions that are found by search, or follow
/// from the bottom tension or the anchor position, are still empty.
std::vector<LayStageDescription> lay_stages(const Description& description);

/// Returns the description of the lay at a stage; its equilibrium, results, checks and dynamic runs are computed as for
/// any other model. The tensioner is placed where the line is held, for a cable at the winch, and has the tension of
/// the stage; a cable is free to rotate in its guide.
Description make_stage_description(const Description& description, const LayStageDescription& stage);

/// Returns true if a cable, not the pipe, is held at the top at this stage.
bool cable_at_top(const Description& description);
/// Returns true if the line contains a cable.
bool has_cable(const Description& description);
/// Returns the unstressed length from the top to the beginning of the pipe: the head, below a cable that is held there
/// [m].
double pipe_start_distance(const Description& description);
/// Returns the unstressed length from the top to the end of the pipe: the head of a start-up; infinite if the pipe
/// continues to the far end of the line [m].
double pipe_end_distance(const Description& description);
/// Returns the distance from the top by which the pipe is shifted at this stage, relative to the description, in which
/// segments, structures and field joints count from the tensioner [m]. A start-up ends with the lay as described:
/// before its last stage the shift is negative, and parts inboard of the tensioner are not yet in the line.
double pipe_shift(const Description& description);
/// Returns true if a cable pins the far end of the line to an anchor at this stage.
bool cable_at_far_end(const Description& description);
/// Returns true if a winch pulls the line along the seabed at this stage by a cable at its far end; the cable length
/// then follows from the tension.
bool is_dragged(const Description& description);
/// Returns the direction of the pull: 1 away from the vessel, -1 towards it, 0 none.
double dragging_direction(const Description& description);

}  // namespace overbend
