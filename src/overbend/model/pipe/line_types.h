/// Mooring lines by type and diameter, for models that give no numbers of their own. Mass, axial stiffness and breaking
/// load are fits to makers' tables (ddjokic/Mooring-Line-Properties; the chains also in the library of NREL/MoorPy);
/// drag and added mass of chain are those of MoorPy, of rope those of DNV-OS-E301. Other ropes, such as spiral strand,
/// differ by up to 40 %: give their numbers instead.
#pragma once

#include "model/description/line_description.h"

namespace overbend {

/// Text of `made_from` for a type with numbers given in the model.
inline constexpr const char* kGivenNumbers = "numbers of the model";

/// Returns six-strand wire rope of a nominal diameter [m] with all numbers except the bending stiffness and the
/// submerged weight.
LineTypeDescription wire_rope(double diameter, RopeCore core);

/// The same for chain; the diameter is that of the bar.
LineTypeDescription chain(double diameter, ChainLink link);

/// Returns true if a line of this type carries compression: as stated, otherwise if it has a bending stiffness of its
/// own, as flexibles and umbilicals do. Wire ropes and chains do not, regardless of their bending stiffness.
bool bears_compression(const LineTypeDescription& type);

/// Returns the submerged weight from weight in air and displaced volume, all per length [N/m].
double submerged_weight(const LineTypeDescription& type, double water_weight_density);

}  // namespace overbend
