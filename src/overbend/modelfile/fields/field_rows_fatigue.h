/// Part of the field table: fatigue of welds during laying. Include modelfile/fields/field_table.h instead.
#pragma once

#include "modelfile/fields/field_rows.h"

namespace overbend::field_rows {

std::vector<Field> fatigue();

}  // namespace overbend::field_rows
