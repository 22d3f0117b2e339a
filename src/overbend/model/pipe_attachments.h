/// Attachments of the laid pipe: clumps, buoys and free lines.
#pragma once

#include <vector>

#include "model/description/description.h"

namespace overbend {

/// Attachment in the line; points into the description.
struct PipeAttachment {
  double from_top = 0.0;                        ///< Unstressed length from the top of the line [m].
  const LinePointDescription* point = nullptr;  ///< Clump or buoy; otherwise
  const FreeLineDescription* line = nullptr;    ///< a line, attached by one of its ends.
};

/// Returns all attachments in the line, from the top down. They move with the pipe at an operation stage: those not yet
/// paid out, or at the position of head or cable, are omitted.
std::vector<PipeAttachment> pipe_attachments(const Description& description);

/// Returns true if this line end is on the laid pipe.
bool is_on_pipe(const Description& description, const LineEndDescription& end);

}  // namespace overbend
