/// Goal seek: values of keys of the model for which its results meet given conditions.
#pragma once

#include "study/goal_seek/seek_model.h"

namespace overbend {

/// Result of the search, and the nearest equilibrium as the start of the final statics.
struct SeekOutcome {
  SeekResults results;
  std::optional<StaticSolution> start;
};

/// Finds values that meet `wanted`. One key with one condition is searched over its whole interval, so that every
/// answer and every jump is reported. Several keys, several conditions or an objective are searched from the model's
/// own values to the nearest optimum, and if the conditions are not met there, from the best of several points within
/// the bounds. Throws SeekError if the search cannot begin, and Interrupted once `stop` returns true, which is called
/// before every model.
SeekOutcome seek(const Description& description, const SeekDescription& wanted, const std::function<bool()>& stop = {});

/// Returns the answer as changes of the model's keys, in the order of the unknowns.
std::vector<YamlChange> answer_changes(const Description& description, const SeekDescription& wanted,
                                       const SeekResults& results);

// Functions shared by the searches.

/// Values of a condition at a solved point: one, or one for each item that its name matches. Empty if the result does
/// not apply.
std::vector<double> goal_values(const SeekPoint& point, const std::string& result);

/// Returns the value of a condition that is farthest from meeting it.
std::optional<double> decisive_value(const SeekPoint& point, const SeekCondition& condition);

/// Searches one key with one condition over its whole interval.
SeekOutcome seek_one(const SeekModel& model, const SeekCondition& condition);
/// Searches several keys, several conditions or an objective; see seek().
SeekOutcome seek_many(const SeekModel& model, const SeekDescription& seek);

/// Returns the results before the search, with unknowns and goals.
SeekResults started_results(const SeekModel& model, const SeekDescription& seek);

/// Adds the path of the search and its number of models to the results.
void add_path(const SeekHistory& history, SeekResults& results);

/// Adds the answer and the values of the conditions there to the results.
void add_answer(const SeekPoint& point, SeekResults& results);

}  // namespace overbend
