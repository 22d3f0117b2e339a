/// Lines that stand by themselves in the files of results: the groups /lines and /dynamic/lines of results.h5,
/// static.lines and dynamic.lines of summary.json, lines.csv.
#pragma once

#include <string>
#include <vector>

#include "resultfiles/hdf5/dataset_sink.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "results/line_results.h"
#include "results/moored_dynamics.h"

namespace overbend {

/// The group /lines, or `front`: a group for every line, by its number in the model from 0. Nothing without lines.
void write_lines(DatasetSink& file, const std::vector<LineResult>& lines, const std::string& front = "/lines");
/// Gives back what write_lines wrote, bit for bit.
std::vector<LineResult> read_lines(const Hdf5Reader& file, const std::string& front = "/lines");

/// The group /dynamic/lines. Nothing without lines.
void write_lines_in_time(DatasetSink& file, const std::vector<LineDynamics>& lines);
std::vector<LineDynamics> read_lines_in_time(const Hdf5Reader& file);
/// Names under /lines of histories that stand in /dynamic/histories: /lines/time, /lines/0/first_tension.
void link_line_histories(Hdf5Writer& file, const std::vector<LineDynamics>& lines);

/// The text of lines.csv: a row per node of every line, engineering units. `in_time`: of a run, in whose place the
/// values at rest stand without one.
std::string lines_table(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time = {});

/// The lines of a stage of an operation.
struct StageLines {
  std::string stage;
  const std::vector<LineResult>& lines;
};
/// The same text of all stages, the name of the stage in the first column.
std::string lines_table(const std::vector<StageLines>& stages);

/// Throw std::runtime_error that names the quantity which is no number.
void require_finite(const std::vector<LineResult>& lines);
void require_finite(const std::vector<LineDynamics>& lines);

}  // namespace overbend
