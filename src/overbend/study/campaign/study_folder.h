/// The folder of a study: its origins, and a record of every case.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/study_results.h"
#include "study/cases/case_evaluation.h"
#include "study/cases/study_cases.h"

namespace overbend {

/// Returns the results that the study collects.
std::vector<StudyOutput> study_outputs(const CaseBase& base);

/// Starts a study in the folder or continues the one in it: writes study.json if there is none. Throws UnusableFolder
/// if the folder holds another study, naming the difference, or other results, or cannot be written. Several processes
/// may call it concurrently.
void open_study(const CaseBase& base, const StudyCases& cases, const std::filesystem::path& folder);

/// Returns a case with its inputs from its number and its results from its record; open if there is no record.
StudyCase recorded_case(const StudyCases& cases, const std::vector<StudyOutput>& outputs,
                        const std::filesystem::path& folder, std::size_t number);

/// Returns the state of a case from its record; open if there is none.
StudyCaseState recorded_state(const std::filesystem::path& folder, std::size_t number);

/// Copies the result of a case into its row.
void store_result(const CaseResult& answer, StudyAnalysis analysis, const std::vector<StudyOutput>& outputs,
                  StudyCase& study_case);

/// Writes the record of a case to a temporary file that is then renamed, with the peaks of its histories if given for
/// extremes over seeds. Throws FileError.
void write_case_record(const StudyCase& study_case, const std::vector<StudyInput>& inputs,
                       const std::vector<StudyOutput>& outputs, const std::filesystem::path& folder,
                       const std::vector<HistoryPeaks>& peaks = {});

/// Returns the peaks of a case's histories, from its record or its results.h5; empty if there are none.
std::vector<HistoryPeaks> recorded_peaks(const std::filesystem::path& folder, const StudyCase& study_case);

/// Simulated time of the cases' dynamic analyses from study.json [s]; 0 for other analyses.
double recorded_duration(const std::filesystem::path& folder);

/// Returns the command "overbend study FILE -o FOLDER", quoted for a shell.
std::string make_study_command(const std::string& file, const std::string& folder);

/// Reads all cases of a study's folder from their records; cases without a record are open. Throws std::runtime_error
/// if it is not the folder of a study.
StudyResults read_study(const std::filesystem::path& folder);

}  // namespace overbend
