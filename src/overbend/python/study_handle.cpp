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
  std::error_code fault;
  if (!fs::exists(file, fault)) replace_file(file, text);
}

}  // namespace

std::shared_ptr<StudyHandle> StudyHandle::read(const std::string& file) {
  StudyReading reading = sound(read_study_file(file));
  return std::shared_ptr<StudyHandle>(new StudyHandle(std::move(*reading.base), std::move(*reading.study)));
}

std::shared_ptr<StudyHandle> StudyHandle::of(const ModelHandle& model, const std::string& text,
                                             const fs::path& folder) {
  StudyReading reading = sound(read_study_of(text, (folder / kStudyFile).string(), moved_model(model, folder)));
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

void CaseCount::begin(std::size_t open, std::size_t finished) {
  const std::lock_guard<std::mutex> hold(mutex_);
  told_.cases = open + finished;
  told_.done = finished;
}

void CaseCount::ended(const StudyCase& one) {
  const std::lock_guard<std::mutex> hold(mutex_);
  ++told_.done;
  if (one.state == StudyCaseState::failed) ++told_.failed;
}

void CaseCount::tried(const TrialTold& /*trial*/) {
  const std::lock_guard<std::mutex> hold(mutex_);
  ++told_.done;
}

CaseCount::Told CaseCount::told() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return told_;
}

}  // namespace overbend
