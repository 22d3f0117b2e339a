/// Stages of a lift or of a pull as the model of a goal seek.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "model/description/description.h"
#include "results/seek_results.h"
#include "study/stages/lift.h"

namespace overbend {

/// Range of stages from the first that a seek changes to the last whose results it uses. Stages of a lift before the
/// first are solved once: every model of the search continues from there, as the operation itself does.
class SeekStages {
 public:
  /// Throws std::invalid_argument, with a message for the user, if a key changes nothing that is requested.
  SeekStages(const Description& description, const SeekDescription& seek, const std::vector<SeekUnknown>& unknowns);

  /// Returns the results of the stages, as in summary.json, with the moments along lines that max_along() names.
  /// Throws std::runtime_error if a stage has no solution. Several threads may call it.
  Json solve(const Description& description) const;

  /// True if a model is solved in milliseconds.
  bool are_quick() const { return lift_; }

  /// Name of the values along lines, node by node and the same nodes in every model, whose maximum is the result; empty
  /// if it is not such a maximum.
  std::string max_along(const std::string& result) const;

 private:
  Json solve_lift_stages(const Description& description) const;

  bool lift_;
  std::size_t first_ = 0, last_ = 0;
  std::shared_ptr<const Lift> before_;  ///< At the stage before `first_`; null if keys change more than stages.
  Json stages_ = Json::array();         ///< Results of the stages before `first_`.
};

/// Returns the previous length of a line whose length is not given at the stage; empty if that follows from a tension.
/// `path` as in SeekUnknown, "operation.stages[2].lengths.davit 1".
std::optional<double> kept_length(const Description& description, const std::string& path);

/// True if the key is the length of a line that is slack at its stage.
bool is_slack_length(const Json& summary, const std::string& path);

/// Returns the stages that the answer changes, each as a line of a model file.
std::vector<std::string> stage_lines(const Description& answer, const std::vector<SeekUnknown>& unknowns);

}  // namespace overbend
