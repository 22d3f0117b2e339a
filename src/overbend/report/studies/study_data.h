/// Data of a study for the scripts of its page.
#pragma once

#include <string>

#include "base/json.h"
#include "base/shown_unit.h"
#include "report/studies/study_shape.h"
#include "results/study_results.h"

namespace overbend {

/// Display unit of an input or an output.
struct StudyUnit {
  std::string name;  ///< Name of the unit; empty for plain numbers.
  double factor = 1.0;
};
StudyUnit find_study_unit(const StudyInput& input);
StudyUnit find_study_unit(const StudyOutput& output);
/// Returns the unit `show` of a key whose numbers are in SI `unit`; the usual display unit if `show` is not a unit.
StudyUnit find_study_unit(const std::string& unit, const std::string& show);

/// Returns the results with the texts of the key values converted to display units.
StudyResults convert_to_shown_units(StudyResults results);

/// Returns the name of a result or key for readers: the last parts of its path, with its unit in brackets if it has
/// one.
std::string make_heading(const std::string& name, const StudyUnit& unit);

/// Returns {shape, inputs: [{name, values, words}], outputs: [{name, at}], groups: [{at, x, words, mean, low, high,
/// state, governing, utilisation, seeds}], axes, base, tornado}; values in display units, null for missing values.
/// `operability` if the study has one.
Json study_data(const StudyResults& results);

}  // namespace overbend
