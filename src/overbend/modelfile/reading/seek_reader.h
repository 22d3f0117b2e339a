/// The goal seek that a model file asks for.
#pragma once

#include <optional>

#include "model/description/description.h"
#include "model/description/seek_description.h"

namespace overbend {

/// What stands under `seek` in the text of a model that has been read and checked; nothing where the key is left out.
std::optional<SeekDescription> read_seek(const Description& description);

}  // namespace overbend
