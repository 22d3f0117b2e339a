/// Results of a study in files: one row for every case.
#pragma once

#include <filesystem>

#include "base/shown_unit.h"
#include "resultfiles/hdf5/dataset_sink.h"
#include "results/study_results.h"
#include "results/tables/table.h"

namespace overbend {

/// Returns the display unit of an output.
ShownUnit shown_output(const StudyOutput& output);

/// Returns case, folder, inputs, seed, outputs, verdict, state, reason and time, in display units.
Table study_table(const StudyResults& results);

/// Writes the groups case, inputs and outputs, a dataset per column with its SI unit; extremes over the seeds; limits
/// of operability. NaN for a missing value.
void write_study_groups(DatasetSink& file, const StudyResults& results);

/// Writes the same to a file.
void write_study_hdf5(const StudyResults& results, const std::filesystem::path& file);

/// Writes study.csv, study.xlsx, study.h5 and summary.json into the folder, each completely or not at all. Throws
/// FileError.
void write_study_files(const StudyResults& results, const std::filesystem::path& folder);

}  // namespace overbend
