#include "python/study_handle.h"

#include <fstream>

#include "modelfile/reading/yaml_reader.h"
#include "modelfile/study_file/study_reader.h"
#include "modelfile/yaml/moved_text.h"
#include "runstore/replace_file.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr const char *kStudyFile = "study.yaml", *kModelFile = "model.yaml";

StudyReading sound(StudyReading reading) {
  if (!reading.study) throw UnreadableModel(std::move(reading.diagnostics));
  return reading;
}

Description moved_model(const ModelHandle& model, const fs::path& folder) {
  const std::string text = moved_text(model.text(), model.file(), folder);
  ModelReading reading = read_model_text(text, (folder / kModelFile).string());
  if (!reading.description) throw UnreadableModel(std::move(reading.diagnostics));
  return std::move(*reading.description);
}

void keep_file(const fs::path& file, const std::string& text) {
  std::error_code error;
  if (!fs::exists(file, error)) replace_file(file, text);
}

}  // namespace

std::shared_ptr<StudyHandle> StudyHandle::read(const std::string& file) {
  StudyReading reading = sound(read_study_file(file));
  return std::shared_ptr<StudyHandle>(new StudyHandle(std::move(*reading.base), std::move(*reading.study)));
}

std::shared_ptr<StudyHandle> StudyHandle::of(const ModelHandle& model, const std::string& text,
                                             const fs::path& folder) {
  StudyReading reading = sound(read_study_with_base(text, (folder / kStudyFile).string(), moved_model(model, folder)));
  std::shared_ptr<StudyHandle> study(new StudyHandle(std::move(*reading.base), std::move(*reading.study)));
  study->keeps_files_ = true;
  return study;
}

void StudyHandle::open(const fs::path& folder) const {
  open_study(base_, cases_, folder);
  if (!keeps_files_) return;
  keep_file(folder / kModelFile, base_.model().source_text);
  keep_file(folder / kStudyFile, base_.study().text);
}

void CaseCounter::begin(std::size_t open, std::size_t finished) {
  const std::lock_guard<std::mutex> hold(mutex_);
  tally_.cases = open + finished;
  tally_.done = finished;
}

void CaseCounter::ended(const StudyCase& study_case) {
  const std::lock_guard<std::mutex> hold(mutex_);
  ++tally_.done;
  if (study_case.state == StudyCaseState::failed) ++tally_.failed;
}

void CaseCounter::tried(const TrialReport& /*trial*/) {
  const std::lock_guard<std::mutex> hold(mutex_);
  ++tally_.done;
}

CaseCounter::Tally CaseCounter::tally() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return tally_;
}

}  // namespace overbend
