/// The words of a goal seek's relations, as the model file writes them.
#pragma once

#include <array>

#include "base/words.h"
#include "model/description/seek_description.h"

namespace overbend {

template <>
inline constexpr std::array kWords<SeekRelation> = {
    Word{SeekRelation::equals, "equals"},
    Word{SeekRelation::at_most, "at_most"},
    Word{SeekRelation::at_least, "at_least"},
};

}  // namespace overbend
