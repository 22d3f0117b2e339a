/// Goal seek: values of keys of the model with which its results are what is wanted.
#pragma once

#include "study/goal_seek/seek_model.h"

namespace overbend {

/// What was found, and the equilibrium closest to it to start its full statics from.
struct SeekOutcome {
  SeekResults results;
  std::optional<StaticSolution> start;
};

/// Finds what `wanted` asks for. One key with one condition is searched over all its bounds, so that every
/// answer and every jump on the way is told; several keys, several conditions or something to minimise are searched
/// from the model's own values to the nearest optimum, and where the conditions are not met there from the best of
/// places over the bounds. Throws SeekFault where the search cannot begin, Interrupted
/// once `stop` says so, which is asked before every model.
SeekOutcome seek(const Description& description, const SeekDescription& wanted, const std::function<bool()>& stop = {});

/// The answer as changes of the model's keys, in the order of the unknowns.
std::vector<YamlChange> answer_changes(const Description& description, const SeekDescription& wanted,
                                       const SeekResults& results);

// Parts of it.

/// Numbers of a condition at a solved point: one, or one for each item that its name matches. Empty where the result
/// does not apply.
std::vector<double> goal_values(const SeekPoint& point, const std::string& result);

/// The values of a condition as one number: the one farthest from holding.
std::optional<double> decisive_value(const SeekPoint& point, const SeekCondition& condition);

SeekOutcome seek_one(const SeekModel& model, const SeekCondition& condition);
SeekOutcome seek_many(const SeekModel& model, const SeekDescription& seek);

/// Unknowns and goals before the search.
SeekResults started_results(const SeekModel& model, const SeekDescription& seek);

/// The path of the search and the number of models on it.
void tell_path(const SeekHistory& history, SeekResults& results);

/// Puts the answer in, and says how the conditions hold there.
void tell_answer(const SeekPoint& point, SeekResults& results);

}  // namespace overbend
