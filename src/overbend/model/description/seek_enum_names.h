/// Texts of the relations of a goal seek in the model file.
#pragma once

#include <array>

#include "base/enum_names.h"
#include "model/description/seek_description.h"

namespace overbend {

template <>
inline constexpr std::array kEnumNames<SeekRelation> = {
    Word{SeekRelation::equals, "equals"},
    Word{SeekRelation::at_most, "at_most"},
    Word{SeekRelation::at_least, "at_least"},
};

}  // namespace overbend
