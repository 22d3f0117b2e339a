/// Statics of a model in Python.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include "base/json.h"
#include "python/model_handle.h"
#include "resultfiles/hdf5/result_tree.h"
#include "study/run/static_analysis.h"

namespace overbend {

/// Returns the description of the model, or of a stage of its operation by name or number from 1. With an empty
/// `stage`, returns the normal lay, for a model with an operation with a warning. Throws EndedRun if there is no such
/// stage, and the exceptions of ModelHandle.
Description chosen_description(const ModelHandle& model, const std::string& stage);

/// A static equilibrium; immutable.
class StaticsHandle {
 public:
  /// Solves the model, or the stage of its operation with this name or number. `start` is a warm start from a similar
  /// lay. Throws SolveError if there is no equilibrium, and the exceptions of ModelHandle.
  StaticsHandle(std::shared_ptr<ModelHandle> model, const std::string& stage, const StaticsHandle* start);
  /// Wraps existing complete results.
  StaticsHandle(std::shared_ptr<ModelHandle> model, std::string stage, StaticRun found)
      : model_(std::move(model)), stage_(std::move(stage)), is_complete_(true), statics_(std::move(found)) {}

  /// Returns the complete results. On first use, computes what may take longer than the equilibrium: code checks with
  /// the lay in still water, limits of roller friction, radiation and damping of the hull. May be called by several
  /// threads.
  const StaticRun& complete_run() const;
  const std::shared_ptr<ModelHandle>& model() const { return model_; }
  /// Returns the contents of summary.json; without `all`, omits the parts that only complete_run() computes.
  Json summary(bool all) const;
  /// Returns the datasets of results.h5, without the model.
  std::shared_ptr<ResultTree> tree() const;
  /// Writes the files of `overbend static`. Throws UnusableFolder.
  void save(const std::filesystem::path& folder) const;

 private:
  bool take(ModelEquilibrium equilibrium);
  std::optional<StaticSolution> still_water_solution() const;

  std::shared_ptr<ModelHandle> model_;
  std::string stage_;
  std::optional<Model> made_;
  mutable std::mutex mutex_;  ///< Guards the members below.
  mutable bool is_complete_ = false;
  mutable StaticRun statics_;
  mutable std::optional<StaticSolution> still_water_solution_;  ///< Lay in still water: warm start and solution.
};

}  // namespace overbend
