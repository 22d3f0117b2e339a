/// What follows from the keys of ramp and stinger once all of them are bound: places of boxes told as a row, angles of
/// the setting that was chosen.
#pragma once

#include <optional>

#include "model/description/description.h"
#include "model/vessel/box_row.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// The end of the ramp's curve at its last box, which a stinger's row continues: by the box's own incline, else the
/// tangent of the curve through the ramp's boxes. Empty without a ramp.
std::optional<BoxPlace> ramp_end(const Description& description);

/// Places the boxes of ramp_row and stinger_row, which stand in `boxes` without places. What `first` leaves out
/// follows: the incline from the curve before, and of a stinger the place, one spacing behind the ramp's last box.
void place_box_rows(const FieldValue& root, Description& description);

/// Gives the stinger's sections the angles of the setting that was chosen.
void choose_stinger_setting(SupportsDescription& supports);

}  // namespace overbend
