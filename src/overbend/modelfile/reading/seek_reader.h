/// Goal seek of a model file.
#pragma once

#include <optional>

#include "model/description/description.h"
#include "model/description/seek_description.h"

namespace overbend {

/// Returns the key `seek` of the text of a model that has been read and checked; empty if the key is left out.
std::optional<SeekDescription> read_seek(const Description& description);

}  // namespace overbend
