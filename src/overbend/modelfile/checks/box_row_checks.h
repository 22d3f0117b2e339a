/// Checks of rows of boxes and of the table of stinger settings.
#pragma once

#include <optional>

#include "model/vessel/box_row.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {

/// Returns the group of a row of boxes in a structure's group; null if its boxes are listed or missing.
const FieldValue* find_box_row(const FieldValue& structure);

/// Returns the end of a row, if the keys of its structure determine its beginning.
std::optional<BoxPlace> end_of_row(const FieldValue& root, const FieldValue& structure);

/// Checks that a row has a radius and a beginning, and does not bend beyond the vertical.
void check_box_row(Checker& check, const FieldValue& structure);

/// Hint for a variation of the radius of listed boxes.
inline constexpr const char* kListedBoxesHint =
    "listed boxes are placed by their coordinates and have no radius: replace the list by a row of boxes, boxes: "
    "{count, spacing, first}, or vary the boxes' x and z";

/// Checks that settings have unique names and an angle for each section, and that the selected one exists.
void check_stinger_settings(Checker& check);

}  // namespace overbend
