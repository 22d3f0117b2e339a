/// Study file: keys of a base model that change from case to case, and the results collected from each case.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/description/seek_description.h"

namespace overbend {

enum class StudyAnalysis { statics, dynamic, operation, seek };

/// Axis: a key of the model and its values.
struct StudyAxis {
  std::string key;                  ///< Key of the model file: "environment.waves.hs".
  std::vector<std::string> values;  ///< Values as written in a model file: "1.5 m".
  std::string with;                 ///< Key of the axis that varies together with this one; empty: crossed.
  int line = 0;                     ///< Line in the study file.
};

enum class Distribution { uniform, normal, lognormal, triangular, weibull };

/// Randomly sampled key of the model. Numbers in SI.
struct SampledKey {
  std::string key;
  Distribution distribution = Distribution::uniform;
  std::string unit;                 ///< SI unit of its dimension, "1" for plain numbers.
  std::string show;                 ///< Display unit; empty for plain numbers.
  double from = 0.0, to = 0.0;      ///< Range of a uniform or triangular distribution; truncation bounds of the others
  bool bounded = false;             ///< if this is true.
  double mode = 0.0;                ///< Mode of a triangular distribution.
  double mean = 0.0, std = 0.0;     ///< Normal or lognormal (of the key itself, not of its logarithm).
  double scale = 0.0, shape = 0.0;  ///< Weibull.
  int line = 0;
};

/// Latin hypercube (McKay, Beckman and Conover 1979) with `count` draws: each key has one draw in each of `count`
/// equally probable ranges.
struct StudySample {
  int count = 0;
  std::uint64_t seed = 1;
  std::vector<SampledKey> keys;
};

/// Period of the seas of a scatter diagram.
enum class ScatterPeriod {
  tp,  ///< Peak period.
  tz,  ///< Mean zero up-crossing period, 2 pi sqrt(m0 / m2).
};

/// Scatter diagram: frequency of sea states by month.
struct ScatterDiagram {
  struct Sea {
    double hs = 0.0, tp = 0.0;     ///< Centre of the cell [m], [s].
    std::optional<double> from;    ///< Direction from which the waves come [rad]; empty: all directions.
    std::vector<double> fraction;  ///< Fraction of time by month from January; one entry: whole year.
    double hs_width = 0.0;         ///< Height of the cell [m].
  };
  std::vector<Sea> seas;
  std::string remark = {};  ///< Interpretation of the file: periods, values, conversion to Tp; empty for a plain file.
};

/// Maximum value of one axis that satisfies a criterion, for every combination of the other axes.
struct OperabilityDescription {
  std::string over = "environment.waves.hs";  ///< Key of an axis: its first and last values are the bounds.
  double resolution = 0.25;                   ///< Resolution of the limit [SI unit of the key].
  std::vector<SeekCondition> criterion;       ///< Conditions in addition to the code checks, or instead of them
  bool checks = true;                         ///< if this is false.
  std::string scatter_file;                   ///< File with the scatter diagram, for workability.
  std::optional<ScatterDiagram> scatter;      ///< Contents of the file.
  std::optional<double> alpha;                ///< alpha factor of DNV-ST-N001 on the limit.
};

struct StudyDescription {
  std::string file, text;  ///< Path and text of the study file.
  std::string title;
  std::string base;  ///< Path of the model file, resolved against the study's folder.
  StudyAnalysis analysis = StudyAnalysis::statics;
  std::vector<StudyAxis> axes;
  std::optional<StudySample> sample;
  std::vector<std::uint64_t> seeds;  ///< Wave seeds; each case is run with every one. Empty: the model's first.
  std::vector<std::string> gather;   ///< Results by their names in summary.json; empty: default set of the analysis.
  std::optional<OperabilityDescription> operability;
  std::optional<double> duration;  ///< Duration of dynamic analyses, replaces the model's [s].
  bool keep = false;               ///< Keeps all result files of every case, not only its row of the table.
};

}  // namespace overbend
