/// Stages of a lift or of a pull as what a goal seek looks at.
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

/// The first stage that a seek changes and the last whose results it asks for. Of a lift what lies before the first is
/// solved once: every model of the search goes on from there, the way that the operation itself goes.
class SeekStages {
 public:
  /// Throws std::invalid_argument, with a sentence for the user, where a key changes nothing that is asked for.
  SeekStages(const Description& description, const SeekDescription& seek, const std::vector<SeekUnknown>& unknowns);

  /// The results of the stages, as in summary.json, with the moments along lines that largest_along() names. Throws
  /// std::runtime_error where a stage cannot be. Several threads may call it.
  Json solve(const Description& description) const;

  /// Whether a model is solved in milliseconds.
  bool are_quick() const { return lift_; }

  /// Values along lines, node by node and the same nodes in every model, the largest of which is the result; empty
  /// where it is none of these.
  std::string largest_along(const std::string& result) const;

 private:
  Json solve_lift_stages(const Description& description) const;

  bool lift_;
  std::size_t first_ = 0, last_ = 0;
  std::shared_ptr<const Lift> before_;  ///< At the stage before `first_`; null where keys change more than stages.
  Json stages_ = Json::array();         ///< Up to there.
};

/// Where the value of a stage's key stays as it was, the one that it has by then; nothing where that follows from a
/// tension. `path` as of a SeekUnknown, "operation.stages[2].lengths.davit 1".
std::optional<double> kept_length(const Description& description, const std::string& path);

/// Whether the key is the length of a line that is slack at its stage.
bool is_slack_length(const Json& summary, const std::string& path);

/// The stages that the answer changes, each as a line for a model file.
std::vector<std::string> stage_lines(const Description& answer, const std::vector<SeekUnknown>& unknowns);

}  // namespace overbend
