/// Statics while a value is being dragged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/yaml_document.h"
#include "serve/http.h"
#include "serve/open_model.h"
#include "statics/statics.h"

namespace overbend {

struct StaticWish {
  bool full = false;                              ///< From nothing.
  std::optional<std::vector<std::string>> lists;  ///< Of `pipe`; all when not said.
};

/// Keeps the last solution, from which the next one, a little further on, is found in few iterations. One solution at a
/// time; may be called from any thread.
class LiveStatics {
 public:
  /// The answer of POST /api/static: the model with changes on top, from the last solution or (`full`) from nothing.
  Json solve(const ModelText& model, const std::vector<YamlChange>& changes, const StaticWish& wish);

 private:
  Json solve(Model model, const StaticWish& wish);
  bool close_to_last(const Model& model) const;
  std::optional<Description> read_changed(const ModelText& model, const std::vector<YamlChange>& changes);
  void parse(const ModelText& model);

  std::mutex mutex_;
  std::string parsed_text_;  ///< What `parsed_` is the tree of.
  std::optional<YamlNode> parsed_;
  std::optional<CoupledHullDescription> hull_;  ///< Of that text, with the contents of its files.
  /// Of these files as they were read: another program may write them while this one runs.
  std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>> hull_stamps_;
  std::optional<StaticSolution> last_;
  std::string last_file_;         ///< Of the model that it is a solution of.
  std::size_t last_rollers_ = 0;  ///< Likewise.
};

/// GET /api/scene of a model's text.
Json scene_of(const ModelText& model);

/// Adds both routes; what they are given must outlive them.
void add_static_routes(std::vector<HttpRoute>& routes, OpenModel& model, LiveStatics& statics);

}  // namespace overbend
