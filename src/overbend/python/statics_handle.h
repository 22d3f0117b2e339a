/// Statics of a model as Python holds them.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include "base/json.h"
#include "python/model_handle.h"
#include "resultfiles/hdf5/result_tree.h"
#include "study/run/static_run.h"

namespace overbend {

/// The description of the model; of an operation on the line that of one stage, by its name or its number from 1. With
/// an empty `stage` the lay as such, which then has a warning that it is. Throws EndedRun where there is no such stage,
/// and what ModelHandle throws.
Description chosen_description(const ModelHandle& model, const std::string& stage);

/// An equilibrium. Constant from here on.
class StaticsHandle {
 public:
  /// The equilibrium of the model; of an operation on the line that of the stage with this name or number. `start`: of
  /// a lay close by. Throws SolveFault where there is none, and what ModelHandle throws.
  StaticsHandle(std::shared_ptr<ModelHandle> model, const std::string& stage, const StaticsHandle* start);
  /// One that was found otherwise, with all that is told of it.
  StaticsHandle(std::shared_ptr<ModelHandle> model, std::string stage, StaticRun found)
      : model_(std::move(model)), stage_(std::move(stage)), told_(true), statics_(std::move(found)) {}

  /// With everything that is told beside the equilibrium itself and may take longer than that: code checks with the lay
  /// in still water, the limits of roller friction, the hull's radiation and damping. Found when they are asked for.
  /// May be called by several threads.
  const StaticRun& whole() const;
  const std::shared_ptr<ModelHandle>& model() const { return model_; }
  /// As summary.json; with `all` false without what only whole() has.
  Json summary(bool all) const;
  /// As results.h5, without the model.
  std::shared_ptr<ResultTree> tree() const;
  /// Writes the files of `overbend static`. Throws UnusableFolder.
  void save(const std::filesystem::path& folder) const;

 private:
  bool take(ModelEquilibrium equilibrium);
  std::optional<StaticSolution> still() const;

  std::shared_ptr<ModelHandle> model_;
  std::string stage_;
  std::optional<Model> made_;
  mutable std::mutex mutex_;  ///< On what follows.
  mutable bool told_ = false;
  mutable StaticRun statics_;
  mutable std::optional<StaticSolution> still_;  ///< The lay in still water, to start from and as found.
};

}  // namespace overbend
