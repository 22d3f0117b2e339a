/// Rows of a stinger on hinges, and the object that the rows of ramp and stinger fill.
#pragma once

#include <string>
#include <vector>

#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {

/// Ramp or stinger while its keys are read: the supports hold all boxes in one list, and the sections of the stinger
/// in another.
struct StructureKeys {
  SupportsDescription* supports = nullptr;
  Structure structure = Structure::ramp;
  std::string roller = {};           ///< Of the boxes that name none.
  int rows = BoxDescription{}.rows;  ///< Likewise.
  int section = -1;                  ///< On which the boxes below stand; -1 before any is told.
};

/// What turns about the hinge at `path`. Its rows stand under the stinger itself where that is of one section: they
/// make it.
std::vector<Field> stinger_section_rows(const std::string& path);

/// The list of sections, without the boxes of each.
std::vector<Field> stinger_section_list();

}  // namespace overbend::field_rows
