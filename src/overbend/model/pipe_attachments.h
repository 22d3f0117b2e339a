/// What is fixed to the pipe that is laid: clumps and buoys, and the lines beside it.
#pragma once

#include <vector>

#include "model/description/description.h"

namespace overbend {

/// One of them, where it is on the line; points into the description.
struct PipeAttachment {
  double from_top = 0.0;                        ///< Unstressed length from the top of the line [m].
  const LinePointDescription* point = nullptr;  ///< A clump or buoy; else
  const FreeLineDescription* line = nullptr;    ///< a line, by one of its ends.
};

/// All that are in the line, from the top down. They go with the pipe at a stage of an operation: what is not out yet,
/// or would be where head and cable are, is left out.
std::vector<PipeAttachment> pipe_attachments(const Description& description);

/// Whether this end of a line is on the pipe that is laid.
bool is_on_pipe(const Description& description, const LineEndDescription& end);

}  // namespace overbend
