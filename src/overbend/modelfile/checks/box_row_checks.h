/// Checks of boxes told as a row and of the table of stinger settings.
#pragma once

#include <optional>

#include "model/vessel/box_row.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {

/// The group of a row of boxes under a structure's group; null where its boxes are listed, or not there.
const FieldValue* box_row_of(const FieldValue& structure);

/// Where a row ends, as far as the keys of its structure say by themselves where it begins.
std::optional<BoxPlace> end_of_row(const FieldValue& root, const FieldValue& structure);

/// A row has a radius, a begin, and does not bend beyond the vertical.
void check_box_row(Checker& check, const FieldValue& structure);

/// What there is to do for who wants the radius of listed boxes to be another.
inline constexpr const char* kVaryListedBoxes =
    "listed boxes stand by their coordinates and have no radius: replace the list by a row of boxes on it, boxes: "
    "{count, "
    "spacing, first}, or vary the boxes' x and z";

/// Settings have names of their own and an angle for each section; the one chosen is among them.
void check_stinger_settings(Checker& check);

}  // namespace overbend
