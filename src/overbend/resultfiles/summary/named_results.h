/// Results by the names that they have in summary.json: "static.sagbend.max_bending_stress",
/// "static.supports[stinger 7].reaction", "static.supports[3].separation", "checks.worst.utilisation".
///
/// Behind a list stands an item in brackets: its index from 0, a range of indices "0..4", its name, or a pattern in
/// which `*` stands for any letters: "static.supports[stinger *].reaction". A name of several values may stand in one
/// of the functions below. Lines and davits of a lift stand in brackets or behind a point, by their names or a pattern:
/// "operation.stages[welded].davits[davit *].tension_upper". The same results have names by object,
/// "lines[pipe].static.lay_back", see results/fields/object_names.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.h"

namespace overbend {

/// What may stand around a name: "spread(static.supports[stinger *].reaction)".
enum class ResultFunction {
  none,
  spread,  ///< Standard deviation of the values, 0 where they are even.
  mean,
  least,    ///< min(...)
  largest,  ///< max(...)
};

struct ResultName {
  ResultFunction function = ResultFunction::none;
  std::string path;  ///< Without the function.
};

/// The function and the path of a name.
ResultName parsed_result_name(const std::string& name);

/// The values that the path stands for, in the order of the summary; numbers only. Empty where it names nothing, or
/// what does not apply to the model at hand.
std::vector<double> named_values(const Json& summary, const std::string& path);

/// The one value of a name [SI]. Nothing where the summary has none, or several without a function around them.
std::optional<double> named_result(const Json& summary, const std::string& name);

/// The SI unit of the quantity, whatever the model: "N", "N/m^2", "1" for plain numbers. Nothing where no result has
/// that name, or where its unit hangs on the row.
std::optional<std::string> result_unit(const std::string& name);

/// The path as the table of results has it, "static.supports[].reaction"; every result there is.
std::vector<std::string> result_paths();

}  // namespace overbend
