/// Statics for the page while the user edits values.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/yaml_document.h"
#include "serve/http/http.h"
#include "serve/model/open_model.h"
#include "statics/solver/statics.h"

namespace overbend {

struct StaticRequest {
  bool full = false;                              ///< Solve without a warm start.
  std::optional<std::vector<std::string>> lists;  ///< Lists of `pipe` to return; default: all.
  bool probe = false;                             ///< Background request: any newer request ends it.
};

/// Keeps the last solution as a warm start for the next one. May be called from any thread; threads do not wait for
/// each other.
class LiveStatics {
 public:
  /// Returns the answer to POST /api/static: solves the model with changes, from the last solution or, with `full`,
  /// without a warm start.
  Json solve(const ModelText& model, const std::vector<YamlChange>& changes, const StaticRequest& request);

 private:
  /// The text parsed last.
  struct Parsed {
    std::string text;
    std::shared_ptr<const YamlNode> tree;        ///< Null if the text is not YAML.
    Diagnostics errors;                          ///< Errors of parsing.
    std::optional<CoupledHullDescription> hull;  ///< Coupled hull of the text, with the contents of its files.
    /// Time and size of these files when they were read, because another program may change them.
    std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>> hull_stamps;
  };
  /// A solution with the data to decide whether it is a suitable warm start.
  struct LastSolution {
    StaticSolution solution;
    std::string file;  ///< Model file of the solution.
    std::size_t rollers = 0;
  };

  Json answer(const ModelText& model, const std::vector<YamlChange>& changes, const StaticRequest& request);
  Json probe(const ModelText& model, const std::vector<YamlChange>& changes, const StaticRequest& request,
             std::uint64_t number);
  Json solve(Model model, const StaticRequest& request);
  static bool is_suitable_warm_start(const LastSolution& last, const Model& model);
  static bool is_valid_tree(const Parsed& text);
  static std::optional<Description> read_changed(const Parsed& text, const ModelText& model,
                                                 const std::vector<YamlChange>& changes);
  std::shared_ptr<const Parsed> parsed(const ModelText& model);

  std::mutex mutex_;  ///< Guards the pointers.
  std::shared_ptr<const Parsed> parsed_;
  std::shared_ptr<const LastSolution> last_;
  std::shared_ptr<const LastSolution>
      last_probe_;                        ///< Separate warm start, because probes may be far from the state shown.
  std::atomic<std::uint64_t> newest_{0};  ///< Number of the newest request.
};

/// Returns the answer to GET /api/scene for a model text.
Json make_scene_answer(const ModelText& model);

/// Adds both routes; `model` and `statics` must outlive them.
void add_static_routes(std::vector<HttpRoute>& routes, OpenModel& model, LiveStatics& statics);

}  // namespace overbend
