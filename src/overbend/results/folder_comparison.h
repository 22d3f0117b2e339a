/// Comparison of the results of several folders. Plain data, values in SI.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"

namespace overbend {

enum class ResultsKind { statics, dynamics, seeds, operation };

/// One of the compared result folders.
struct ComparedFolder {
  std::string name;  ///< Displayed name: that of the folder, or the part of its path that distinguishes it from the
                     ///< others.
  std::string path;
  ResultsKind kind = ResultsKind::statics;
  std::string title, version, governing;  ///< Governing check with the maximum utilisation; empty if none is judged.
  Findings findings;
};

/// A key of the model files whose values differ.
struct ComparedKey {
  std::string key;
  std::vector<std::string> values;  ///< Value in every folder; empty if not given.
};

struct ComparedResult {
  std::string name;                           ///< In summary.json: "static.sagbend.max_von_mises".
  std::string text;                           ///< "Sagbend: largest von Mises stress".
  std::string unit;                           ///< SI.
  bool key = false;                           ///< True for key results.
  std::vector<std::optional<double>> values;  ///< Value in every folder.

  /// Returns the change of a folder relative to the first [-]; none if either value is missing or the first is zero.
  std::optional<double> change(std::size_t folder) const {
    if (!values.at(folder) || !values.front() || *values.front() == 0.0) return std::nullopt;
    return (*values[folder] - *values.front()) / std::abs(*values.front());
  }
  /// Returns the maximum magnitude of the changes [-].
  double max_relative_change() const {
    double max_change = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) {
      max_change = std::max(max_change, std::abs(change(i).value_or(0.0)));
    }
    return max_change;
  }
};

struct OverlaidCurve {
  std::size_t folder = 0;
  std::vector<double> x, y;  ///< In the units of the figure.
};

struct OverlaidFigure {
  std::string title, x_label, y_label;
  std::vector<OverlaidCurve> curves;
};

struct FolderComparison {
  std::vector<ComparedFolder> folders;
  std::vector<ComparedKey> keys;
  std::vector<ComparedResult> results;  ///< In descending order of the change; equal ones in the order of the summary.
  std::vector<OverlaidFigure> figures;
  std::vector<std::string> notes;  ///< Omitted comparisons with their reasons.
};

}  // namespace overbend
