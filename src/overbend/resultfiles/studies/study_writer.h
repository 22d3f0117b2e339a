/// What a study gave, in files: one row for every case.
#pragma once

#include <filesystem>

#include "base/shown_unit.h"
#include "resultfiles/hdf5/dataset_sink.h"
#include "results/study_results.h"
#include "results/tables/table.h"

namespace overbend {

/// The unit that an output is shown in.
ShownUnit shown_output(const StudyOutput& output);

/// Case, folder, inputs, seed, outputs, verdict, state, reason and time, in the units that are shown.
Table study_table(const StudyResults& results);

/// The groups case, inputs and outputs, a dataset per column with its SI unit; extremes over the seeds; limits of
/// operability. NaN stands where a case has no value.
void write_study_groups(DatasetSink& file, const StudyResults& results);

/// The same as a file.
void write_study_hdf5(const StudyResults& results, const std::filesystem::path& file);

/// Writes study.csv, study.xlsx, study.h5 and summary.json into the folder, each whole or not at all. Throws FileFault.
void write_study_files(const StudyResults& results, const std::filesystem::path& folder);

}  // namespace overbend
