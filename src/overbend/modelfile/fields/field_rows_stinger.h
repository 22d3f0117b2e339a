/// Rows of a hinged stinger, and the object that the rows of ramp and stinger fill.
#pragma once

#include <string>
#include <vector>

#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {

/// Ramp or stinger while its keys are read: the supports contain all boxes in one list, and the sections of the stinger
/// in another.
struct StructureKeys {
  SupportsDescription* supports = nullptr;
  Structure structure = Structure::ramp;
  std::string roller = {};           ///< Default of the boxes.
  int rows = BoxDescription{}.rows;  ///< Default of the boxes.
  int section = -1;                  ///< Section of the boxes below; -1 before the first section.
};

/// Keys of the section that rotates about the hinge at `path`. For a single section they are directly under the
/// stinger, and the first of them creates the section.
std::vector<Field> stinger_section_rows(const std::string& path);

/// List of sections, without the boxes of each.
std::vector<Field> stinger_section_list();

}  // namespace overbend::field_rows
