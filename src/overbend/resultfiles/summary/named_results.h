/// Results by their names in summary.json: "static.sagbend.max_bending_stress", "static.supports[stinger 7].reaction",
/// "static.supports[3].separation", "checks.worst.utilisation".
///
/// A list is followed by an item in brackets: its index from 0, a range of indices "0..4", its name, or a pattern in
/// which `*` stands for any letters: "static.supports[stinger *].reaction". A name of several values may be the
/// argument of one of the functions below. Lines and davits of a lift follow in brackets or after a dot, by their names
/// or a pattern: "operation.stages[welded].davits[davit *].tension_upper". The same results have names by object,
/// "lines[pipe].static.lay_back", see results/fields/object_names.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.h"

namespace overbend {

/// Function of a name: "spread(static.supports[stinger *].reaction)".
enum class ResultFunction {
  none,
  spread,  ///< Standard deviation of the values, 0 for equal values.
  mean,
  minimum,  ///< min(...)
  maximum,  ///< max(...)
};

struct ResultName {
  ResultFunction function = ResultFunction::none;
  std::string path;  ///< Without the function.
};

/// Splits a name into function and path.
ResultName parsed_result_name(const std::string& name);

/// Returns the values of the path, in the order of the summary; numbers only. Empty for an unknown path, or one that
/// does not apply to the model.
std::vector<double> named_values(const Json& summary, const std::string& path);

/// Returns the value of a name [SI]. Nothing if the summary has none, or several without a function.
std::optional<double> named_result(const Json& summary, const std::string& name);

/// Returns the SI unit of the quantity, for any model: "N", "N/m^2", "1" for plain numbers. Nothing for an unknown
/// result, or a unit that depends on the row.
std::optional<std::string> result_unit(const std::string& name);

/// Returns the paths of all results, "static.supports[].reaction".
std::vector<std::string> result_paths();

}  // namespace overbend
