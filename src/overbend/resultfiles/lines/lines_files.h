/// Stand-alone lines in the result files: the groups /lines and /dynamic/lines of results.h5, static.lines and
/// dynamic.lines of summary.json, lines.csv.
#pragma once

#include <string>
#include <vector>

#include "resultfiles/hdf5/dataset_sink.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "results/line_results.h"
#include "results/moored_dynamics.h"

namespace overbend {

/// Writes the group /lines, or `front`: a group for every line, by its number in the model from 0. Nothing without
/// lines.
void write_lines(DatasetSink& file, const std::vector<LineResult>& lines, const std::string& front = "/lines");
/// Returns the data of write_lines, bit for bit.
std::vector<LineResult> read_lines(const Hdf5Reader& file, const std::string& front = "/lines");

/// Writes the group /dynamic/lines. Nothing without lines.
void write_lines_in_time(DatasetSink& file, const std::vector<LineDynamics>& lines);
std::vector<LineDynamics> read_lines_in_time(const Hdf5Reader& file);
/// Adds names under /lines of the histories in /dynamic/histories: /lines/time, /lines/0/first_tension.
void link_line_histories(Hdf5Writer& file, const std::vector<LineDynamics>& lines);

/// Returns the text of lines.csv: a row per node of every line, engineering units. `in_time`: results of a run; without
/// them the static values are repeated.
std::string lines_table(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time = {});

/// The lines of a stage of an operation.
struct StageLines {
  std::string stage;
  const std::vector<LineResult>& lines;
};
/// Returns the same text for all stages, with the name of the stage in the first column.
std::string lines_table(const std::vector<StageLines>& stages);

/// Throw std::runtime_error that names the first quantity that is not finite.
void require_finite(const std::vector<LineResult>& lines);
void require_finite(const std::vector<LineDynamics>& lines);

}  // namespace overbend
