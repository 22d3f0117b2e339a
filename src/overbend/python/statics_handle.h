/// Statics of a model as Python holds them.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "python/model_handle.h"
#include "resultfiles/result_tree.h"
#include "study/model_statics.h"

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

  const ModelStatics& statics() const { return statics_; }
  const std::shared_ptr<ModelHandle>& model() const { return model_; }
  /// As summary.json.
  nlohmann::ordered_json summary() const;
  /// As results.h5, without the model.
  std::shared_ptr<ResultTree> tree() const;
  /// Writes the files of `overbend static`. Throws UnusableFolder.
  void save(const std::filesystem::path& folder) const;

 private:
  std::shared_ptr<ModelHandle> model_;
  std::string stage_;
  ModelStatics statics_;
};

}  // namespace overbend
