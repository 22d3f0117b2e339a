/// Data of a study for the scripts of its page.
#pragma once

#include <string>

#include "base/json.h"
#include "base/shown_unit.h"
#include "report/studies/study_shape.h"
#include "results/study_results.h"

namespace overbend {

/// What an input's or an output's numbers are shown in.
struct StudyShown {
  std::string name;  ///< Of the unit; empty for plain numbers.
  double factor = 1.0;
};
StudyShown shown_unit_of(const StudyInput& input);
StudyShown shown_unit_of(const StudyOutput& output);
/// Unit `show` of a key whose numbers are in SI `unit`; the usual one of that where the text is no unit.
StudyShown shown_unit_of(const std::string& unit, const std::string& show);

/// With the values of the keys in words in the units in use.
StudyResults in_shown_units(StudyResults results);

/// Name of a result or key for people: the last parts of its path, with its unit in brackets where it has one.
std::string heading_of(const std::string& name, const StudyShown& unit);

/// {shape, inputs: [{name, values, words}], outputs: [{name, at}], groups: [{at, x, words, mean, low, high, state,
/// governing, utilisation, seeds}], axes, base, tornado}; values in shown units, null for what is not there.
/// `operability` where the study has one.
Json study_data(const StudyResults& results);

}  // namespace overbend
