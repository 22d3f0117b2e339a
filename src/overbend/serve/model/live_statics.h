/// Statics while a value is being dragged.
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

struct StaticWish {
  bool full = false;                              ///< From nothing.
  std::optional<std::vector<std::string>> lists;  ///< Of `pipe`; all when not said.
  bool probe = false;                             ///< Background request: any newer request ends it.
};

/// Keeps the last solution, from which the next one, a little further on, is found in few iterations. May be called
/// from any thread: none waits for another.
class LiveStatics {
 public:
  /// The answer of POST /api/static: the model with changes on top, from the last solution or (`full`) from nothing.
  Json solve(const ModelText& model, const std::vector<YamlChange>& changes, const StaticWish& wish);

 private:
  /// A text as it was parsed last.
  struct Parsed {
    std::string text;
    std::shared_ptr<const YamlNode> tree;        ///< Null where the text is no YAML.
    Diagnostics faults;                          ///< Of parsing.
    std::optional<CoupledHullDescription> hull;  ///< Of that text, with the contents of its files.
    /// Of these files as they were read: another program may write them while this one runs.
    std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>> hull_stamps;
  };
  /// A solution with what tells whether another lay is close by.
  struct Last {
    StaticSolution solution;
    std::string file;  ///< Of the model that it is a solution of.
    std::size_t rollers = 0;
  };

  Json answer(const ModelText& model, const std::vector<YamlChange>& changes, const StaticWish& wish);
  Json probe(const ModelText& model, const std::vector<YamlChange>& changes, const StaticWish& wish,
             std::uint64_t number);
  Json solve(Model model, const StaticWish& wish);
  static bool close_by(const Last& last, const Model& model);
  static bool is_sound(const Parsed& text);
  static std::optional<Description> read_changed(const Parsed& text, const ModelText& model,
                                                 const std::vector<YamlChange>& changes);
  std::shared_ptr<const Parsed> parsed(const ModelText& model);

  std::mutex mutex_;  ///< On the pointers.
  std::shared_ptr<const Parsed> parsed_;
  std::shared_ptr<const Last> last_;
  std::shared_ptr<const Last> last_probe_;  ///< Probes may be far from the state shown, which has a start of its own.
  std::atomic<std::uint64_t> newest_{0};    ///< Number of the newest request.
};

/// GET /api/scene of a model's text.
Json scene_of(const ModelText& model);

/// Adds both routes; what they are given must outlive them.
void add_static_routes(std::vector<HttpRoute>& routes, OpenModel& model, LiveStatics& statics);

}  // namespace overbend
