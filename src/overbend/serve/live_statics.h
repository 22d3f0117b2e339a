/// Statics while a value is being dragged.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "analysis/statics.h"
#include "serve/http.h"
#include "serve/open_model.h"

namespace overbend {

/// Keeps the last solution, from which the next one, a little further on, is found in few iterations. One solution at a
/// time; may be called from any thread.
class LiveStatics {
 public:
  /// The answer of POST /api/static: the model with changes on top, from the last solution or (`full`) from nothing.
  Json solve(const ModelText& model, const std::vector<YamlChange>& changes, bool full);

 private:
  Json solve(const Model& model, bool full);
  bool close_to_last(const Model& model) const;

  std::mutex mutex_;
  std::optional<StaticSolution> last_;
  std::string last_file_;         ///< Of the model that it is a solution of.
  std::size_t last_rollers_ = 0;  ///< Likewise.
};

/// GET /api/scene of a model's text.
Json scene_of(const ModelText& model);

/// Adds both routes; what they are given must outlive them.
void add_static_routes(std::vector<HttpRoute>& routes, OpenModel& model, LiveStatics& statics);

}  // namespace overbend
