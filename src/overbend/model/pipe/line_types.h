/// Mooring lines by their kind and diameter, where a model gives no numbers of its own.
///
/// Mass, axial stiffness and breaking load are fits to makers' tables (ddjokic/Mooring-Line-Properties; the chains also
/// in the library of NREL/MoorPy); drag and added mass of chain are MoorPy's, of rope as in DNV-OS-E301. Another rope,
/// such as a spiral strand, differs by up to 40 %: give its numbers instead.
#pragma once

#include "model/description/line_description.h"

namespace overbend {

/// What `made_from` says of a type with numbers of its own.
inline constexpr const char* kGivenNumbers = "numbers of the model";

/// Six-strand wire rope of a nominal diameter [m], all numbers of it filled in but the bending stiffness and the weight
/// under water.
LineTypeDescription wire_rope(double diameter, RopeCore core);

/// The same for chain; the diameter is that of the bar.
LineTypeDescription chain(double diameter, ChainLink link);

/// Whether a line of a type bears compression: by what it says, else where it has a bending stiffness of its own, as
/// flexibles and umbilicals do. Wire ropes and chains do not, whatever their bending stiffness.
bool bears_compression(const LineTypeDescription& type);

/// Weight under water from weight in air and displaced volume, all per length [N/m].
double submerged_weight(const LineTypeDescription& type, double water_weight_density);

}  // namespace overbend
