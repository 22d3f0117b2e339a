/// Parts of the field table, split by subject to keep the files short. Include modelfile/field_table.h instead.
#pragma once

#include <numbers>
#include <vector>

#include "modelfile/field.h"

namespace overbend::field_rows {

inline Range friction_range() {
  return {.low = 0.0, .high = 5.0};
}
inline Range azimuth() {
  return {.low = -2.0 * std::numbers::pi, .high = 2.0 * std::numbers::pi};
}

std::vector<Field> environment();
std::vector<Field> waves();
std::vector<Field> pipe();
std::vector<Field> vessel();
std::vector<Field> motion_convention();
std::vector<Field> tensioner();
std::vector<Field> rollers();
std::vector<Field> supports();
std::vector<Field> analysis();
std::vector<Field> checks();

}  // namespace overbend::field_rows
