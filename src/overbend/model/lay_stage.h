/// A stage of an operation on the line as a model of its own.
#pragma once

#include <vector>

#include "model/description/lay_operation.h"

namespace overbend {

struct Description;

/// The stages of the operation, generated ones made: those whose tension is sought or follows from the bottom tension
/// or from the place of the anchor have none yet. In the order in which they are done.
std::vector<LayStageDescription> lay_stages(const Description& description);

/// The lay at that stage: a description whose equilibrium, results, checks and runs in time are found as of any other.
/// The tensioner stands where the line is held, at the winch where the cable is, and pulls with the tension of the
/// stage; a cable may turn in its guide.
Description at_stage(const Description& description, const LayStageDescription& stage);

/// Whether a cable, and not the pipe, is held at the top at this stage.
bool cable_at_top(const Description& description);
/// Whether a cable is in the line at all.
bool has_cable(const Description& description);
/// Unstressed length from the top to where the pipe begins: at the head, below a cable that is held there [m].
double pipe_begins(const Description& description);
/// Unstressed length from the top to where the pipe ends: at the head of a start-up; infinite where it goes on to the
/// far end of the line [m].
double pipe_ends(const Description& description);
/// How much further from the top the pipe lies at this stage than it does as described, where segments, structures and
/// field joints count from the tensioner [m]. A start-up leads to the lay as described: before its last stage the pipe
/// lies less far out, and what is then inboard of the tensioner is not in the line yet.
double pipe_gone(const Description& description);
/// Whether the far end of the line is pinned to an anchor by a cable at this stage.
bool cable_at_far_end(const Description& description);
/// Whether the line is dragged along the bed at this stage, by a winch that holds the cable at its far end: how long
/// the cable is follows from the tension.
bool is_dragged(const Description& description);
/// Which way it is dragged: 1 away from the vessel, -1 towards it, 0 not at all.
double dragging_direction(const Description& description);

}  // namespace overbend
