/// A study: the keys of a base model that change from case to case, and what is gathered of each case.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/description/seek_description.h"

namespace overbend {

enum class StudyAnalysis { statics, dynamic, operation, seek };

/// A key of the model and the values that it takes, one after the other.
struct StudyAxis {
  std::string key;                  ///< Of the model file: "environment.waves.hs".
  std::vector<std::string> values;  ///< As they would stand in the model file: "1.5 m".
  std::string with;                 ///< Key of the axis with which it changes together; empty: it is crossed.
  int line = 0;                     ///< Of the study file.
};

enum class Distribution { uniform, normal, lognormal, triangular, weibull };

/// A key of the model that is drawn at random. Numbers in SI.
struct SampledKey {
  std::string key;
  Distribution distribution = Distribution::uniform;
  std::string unit;              ///< SI unit of its dimension, "1" for plain numbers.
  std::string show;              ///< Unit that it is written in; empty for plain numbers.
  double from = 0.0, to = 0.0;   ///< Of a uniform or triangular one; of the others bounds beyond which none is drawn,
  bool bounded = false;          ///< where this says so.
  double mode = 0.0;             ///< Of a triangular one.
  double mean = 0.0, std = 0.0;  ///< Of a normal or log-normal one (of the key itself, not of its logarithm).
  double scale = 0.0, shape = 0.0;  ///< Of a Weibull one.
  int line = 0;
};

/// Latin hypercube (McKay, Beckman and Conover 1979): `count` draws, of every key one from each of so many equally
/// probable ranges.
struct StudySample {
  int count = 0;
  std::uint64_t seed = 1;
  std::vector<SampledKey> keys;
};

/// Cells of a scatter diagram: how often a sea comes in a month.
struct ScatterDiagram {
  struct Sea {
    double hs = 0.0, tp = 0.0;     ///< Middle of the cell [m], [s].
    std::optional<double> from;    ///< Azimuth that the waves come from [rad]; none: all directions.
    std::vector<double> fraction;  ///< Of the time, by month from January; one entry: of the whole year.
  };
  std::vector<Sea> seas;
  double hs_step = 0.0, tp_step = 0.0;  ///< Widths of the cells [m], [s].
};

/// The largest value of one axis with which a criterion holds, for every combination of the other axes.
struct OperabilityDescription {
  std::string over = "environment.waves.hs";  ///< Key of an axis: its first and last value are the bounds.
  double resolution = 0.25;                   ///< Of the largest value [SI unit of the key].
  std::vector<SeekCondition> criterion;       ///< Beside the checks, or instead of them,
  bool checks = true;                         ///< where this does not ask for every governing check to be passed.
  std::string scatter_file;                   ///< Scatter diagram, from which workability follows.
  std::optional<ScatterDiagram> scatter;      ///< Its contents.
  std::optional<double> alpha;                ///< alpha factor of DNV-ST-N001 on the limit.
};

struct StudyDescription {
  std::string file, text;  ///< The study file itself.
  std::string title;
  std::string base;  ///< Model file, resolved against the study's folder.
  StudyAnalysis analysis = StudyAnalysis::statics;
  std::vector<StudyAxis> axes;
  std::optional<StudySample> sample;
  std::vector<std::uint64_t> seeds;  ///< Of the waves, each case once with every one; empty: the model's first.
  std::vector<std::string> gather;   ///< Results by their names in summary.json; empty: a choice for the analysis.
  std::optional<OperabilityDescription> operability;
  std::optional<double> duration;  ///< Of dynamic analyses instead of the model's [s].
  bool keep = false;               ///< All result files of every case stay, not its row of the table alone.
};

}  // namespace overbend
