/// A model with varying keys, and its statics or those of the stages of its lift or pull.
#pragma once

#include <functional>
#include <list>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/interruption.h"
#include "base/yaml_document.h"
#include "modelfile/yaml/yaml_edit.h"
#include "resultfiles/summary/summary_json.h"
#include "results/seek_results.h"
#include "study/goal_seek/seek_stages.h"
#include "study/run/static_analysis.h"

namespace overbend {

/// A goal seek that cannot begin; one-line message for the user.
class SeekError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One set of values and the results there.
struct SeekPoint {
  std::vector<double> values;
  Json summary;                            ///< Contents of summary.json; null without an equilibrium.
  std::optional<StaticSolution> solution;  ///< Start of neighbouring points.
  std::string failure;
  bool probe = false;  ///< Point for a derivative; not a step of the search.
  bool serves = true;  ///< Other points may start from it.

  bool solved() const { return failure.empty(); }
};

class SeekModel {
 public:
  /// Selects the keys that `seek` varies, each item of a pattern separately. Throws SeekError if one has no initial
  /// value. `stop`, if given, is called before every model.
  SeekModel(const Description& description, const SeekDescription& seek, std::function<bool()> stop = {});

  const std::vector<SeekUnknown>& unknowns() const { return unknowns_; }

  /// Solves the statics with the keys at these values, from the neighbouring solution `start` if not null. Several
  /// threads may call it.
  SeekPoint solve(const std::vector<double>& values, const StaticSolution* start) const;

  /// Throws Interrupted if the search shall end.
  void throw_if_cancelled() const {
    if (stop_ && stop_()) throw Interrupted();
  }

  /// Stages of a lift or a pull, to which the results belong; else null.
  const SeekStages* stages() const { return stages_ ? &*stages_ : nullptr; }

  /// Returns the changes that put the values into the model text, in the units of its keys and with so many significant
  /// digits.
  std::vector<YamlChange> changes(const std::vector<double>& values, int digits = kDigits) const;

 private:
  static constexpr int kDigits = 9;  ///< Number of digits written: beyond the accuracy of statics.

  Description described(const std::vector<double>& values) const;

  Description base_;
  YamlNode tree_;
  std::vector<SeekUnknown> unknowns_;
  std::optional<SeekStages> stages_;
  std::function<bool()> stop_;
};

/// All points of a search in order; a new one starts from the nearest point that has an equilibrium.
class SeekHistory {
 public:
  explicit SeekHistory(const SeekModel& model) : model_(model) {}

  /// Solves a point, or returns it if already solved. Throws Interrupted, like at_all().
  const SeekPoint& at(const std::vector<double>& values);
  /// Solves several points concurrently, one thread per core. All start from the point nearest to `around`.
  std::vector<const SeekPoint*> at_all(const std::vector<std::vector<double>>& values,
                                       const std::vector<double>& around);

  /// Sets whether the following points serve as starts. A start passes on its mesh, and results on two meshes differ by
  /// their discretisation errors: for small differences all points should start from the same one.
  void set_warm_start_source(bool serve) { serve_ = serve; }

  const SeekModel& model() const { return model_; }
  const std::list<SeekPoint>& points() const { return points_; }

 private:
  const SeekPoint* nearest(const std::vector<double>& values) const;

  const SeekModel& model_;
  std::list<SeekPoint> points_;  ///< A list, so that addresses remain valid.
  bool serve_ = true;
};

}  // namespace overbend
