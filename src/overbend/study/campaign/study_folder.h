/// The folder of a study: what it was made from, and a record of every case.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/study_results.h"
#include "study/cases/case_evaluation.h"
#include "study/cases/study_cases.h"

namespace overbend {

/// The results that the study gathers.
std::vector<StudyOutput> study_outputs(const CaseBase& base);

/// Begins a study in the folder, or goes on with the one there: writes study.json where there is none. Throws
/// UnusableFolder where the folder holds another study, naming what differs, or results of something else, or cannot be
/// written. Several processes may call it at once.
void open_study(const CaseBase& base, const StudyCases& cases, const std::filesystem::path& folder);

/// A case with its inputs from its number, as its record says; open where there is none.
StudyCase recorded_case(const StudyCases& cases, const std::vector<StudyOutput>& outputs,
                        const std::filesystem::path& folder, std::size_t number);

/// Whether a case has its record, and of what state.
StudyCaseState recorded_state(const std::filesystem::path& folder, std::size_t number);

/// Puts the answer of a case into its row.
void take_answer(const CaseAnswer& answer, StudyAnalysis analysis, const std::vector<StudyOutput>& outputs,
                 StudyCase& one);

/// Writes the record of a case, beside first and then renamed, with the peaks of its histories where they are wanted
/// for extremes over seeds. Throws FileFault.
void write_case_record(const StudyCase& one, const std::vector<StudyInput>& inputs,
                       const std::vector<StudyOutput>& outputs, const std::filesystem::path& folder,
                       const std::vector<HistoryPeaks>& peaks = {});

/// The peaks of a case's histories, from its record or its results.h5; empty where there are none.
std::vector<HistoryPeaks> recorded_peaks(const std::filesystem::path& folder, const StudyCase& one);

/// Simulated time of the cases' dynamic analyses, as study.json has it [s]; 0 of others.
double recorded_duration(const std::filesystem::path& folder);

/// "overbend study FILE -o FOLDER" as people type it in a shell.
std::string study_words(const std::string& file, const std::string& folder);

/// All that the folder of a study holds: its cases by their records, those without one open. Throws std::runtime_error
/// where it is no folder of a study.
StudyResults read_study(const std::filesystem::path& folder);

}  // namespace overbend
