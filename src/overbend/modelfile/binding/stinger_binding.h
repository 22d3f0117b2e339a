/// Values that follow from the keys of ramp and stinger once all are bound: positions of generated boxes, angles of the
/// selected setting.
#pragma once

#include <optional>

#include "model/description/description.h"
#include "model/vessel/box_row.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Returns the end of the ramp's curve at its last box, which a stinger's row continues: the box's own inclination,
/// otherwise the tangent of the curve through the ramp's boxes. Empty without a ramp.
std::optional<BoxPlace> ramp_end(const Description& description);

/// Places the boxes of ramp_row and stinger_row, which are in `boxes` without positions. If `first` gives no
/// inclination, it follows from the curve before; if it gives no position, the stinger continues one spacing behind the
/// ramp's last box.
void place_box_rows(const FieldValue& root, Description& description);

/// Assigns the angles of the selected setting to the stinger's sections.
void choose_stinger_setting(SupportsDescription& supports);

}  // namespace overbend
