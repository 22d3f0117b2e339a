/// Results of several folders beside each other. Plain data, values in SI.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"

namespace overbend {

enum class ResultsKind { statics, dynamics, seeds, operation };

/// Of results that are compared.
struct ComparedFolder {
  std::string name;  ///< Shown: the folder's, or as much of its path as tells it from the others.
  std::string path;
  ResultsKind kind = ResultsKind::statics;
  std::string title, version, governing;  ///< Check that is used most; empty where none is judged.
  Findings findings;
};

/// A key of the model files that not all have alike.
struct ComparedKey {
  std::string key;
  std::vector<std::string> values;  ///< Of every folder; empty where it is not given.
};

struct ComparedResult {
  std::string name;                           ///< In summary.json: "static.sagbend.max_von_mises".
  std::string text;                           ///< "Sagbend: largest von Mises stress".
  std::string unit;                           ///< SI.
  bool key = false;                           ///< One of those that are looked at first.
  std::vector<std::optional<double>> values;  ///< Of every folder.

  /// Of a folder against the first, in parts of the first; none where one of both is missing or the first is zero.
  std::optional<double> change(std::size_t folder) const {
    if (!values.at(folder) || !values.front() || *values.front() == 0.0) return std::nullopt;
    return (*values[folder] - *values.front()) / std::abs(*values.front());
  }
  /// Largest magnitude of the changes.
  double largest_change() const {
    double largest = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) largest = std::max(largest, std::abs(change(i).value_or(0.0)));
    return largest;
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
  std::vector<ComparedResult> results;  ///< Those that differ most first; equal ones in the order of the summary.
  std::vector<OverlaidFigure> figures;
  std::vector<std::string> notes;  ///< What is not compared and why.
};

}  // namespace overbend
