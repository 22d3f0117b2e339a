/// A model whose keys are set anew and again, and its statics, or those of the stages of its lift or pull.
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
#include "study/run/static_run.h"

namespace overbend {

/// A seek that cannot be begun; one sentence for the user.
class SeekFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One set of values and what they lead to.
struct SeekPoint {
  std::vector<double> values;
  Json summary;                            ///< As summary.json; null where there is no equilibrium.
  std::optional<StaticSolution> solution;  ///< What points close by start from.
  std::string failure;
  bool probe = false;  ///< For a derivative: no step of the search.
  bool serves = true;  ///< Others may start from it.

  bool solved() const { return failure.empty(); }
};

class SeekModel {
 public:
  /// The keys that `seek` varies, each item of a pattern by itself. Throws SeekFault where one has no value
  /// to start from. `stop`, where given, is asked before every model.
  SeekModel(const Description& description, const SeekDescription& seek, std::function<bool()> stop = {});

  const std::vector<SeekUnknown>& unknowns() const { return unknowns_; }

  /// Statics with the keys at these values; from `start`, where given, of a model close by. Several threads may call
  /// it.
  SeekPoint solve(const std::vector<double>& values, const StaticSolution* start) const;

  /// Throws Interrupted where the search shall end.
  void go_on() const {
    if (stop_ && stop_()) throw Interrupted();
  }

  /// Of a lift or a pull: its stages, which the results are of; else null.
  const SeekStages* stages() const { return stages_ ? &*stages_ : nullptr; }

  /// What puts the values into the text of the model, in the units of its keys and with so many significant digits.
  std::vector<YamlChange> changes(const std::vector<double>& values, int digits = kDigits) const;

 private:
  static constexpr int kDigits = 9;  ///< Of what is written: beyond the accuracy of statics.

  Description described(const std::vector<double>& values) const;

  Description base_;
  YamlNode tree_;
  std::vector<SeekUnknown> unknowns_;
  std::optional<SeekStages> stages_;
  std::function<bool()> stop_;
};

/// All points of a search, in its order; a new one starts from the nearest that has an equilibrium.
class SeekHistory {
 public:
  explicit SeekHistory(const SeekModel& model) : model_(model) {}

  /// Solves, or finds among what was solved already. Both throw Interrupted.
  const SeekPoint& at(const std::vector<double>& values);
  /// Several at once, on as many threads as there are cores. All start from the point nearest to `around`.
  std::vector<const SeekPoint*> at_all(const std::vector<std::vector<double>>& values,
                                       const std::vector<double>& around);

  /// Whether the points to come serve as starts. A start hands on its mesh, and results on two meshes differ by their
  /// errors: where small differences count, all points should start from the same one.
  void hand_on(bool serve) { serve_ = serve; }

  const SeekModel& model() const { return model_; }
  const std::list<SeekPoint>& points() const { return points_; }

 private:
  const SeekPoint* nearest(const std::vector<double>& values) const;

  const SeekModel& model_;
  std::list<SeekPoint> points_;  ///< Addresses stay.
  bool serve_ = true;
};

}  // namespace overbend
