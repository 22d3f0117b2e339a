/// Open model, kept by the program so that it survives a reload of the page.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "modelfile/yaml/yaml_edit.h"
#include "serve/http/http.h"
#include "serve/model/model_folder.h"

namespace overbend {

/// Snapshot of the open model.
struct ModelText {
  std::string text, name;  ///< `name`: name of its file; empty if it has none.
  bool saved = true;
  std::int64_t revision = 0;
  std::optional<std::string> disk;  ///< Version of the file as last read or written; nothing without a file.
  std::string path;                 ///< Path of the file, or of a new file: for messages and for relative paths.
};

/// Request to save the open model, with the expected contents of the file.
struct SaveRequest {
  std::string name;
  bool force = false;  ///< Overwrite the file regardless of its contents.
  bool knows = false;  ///< True if the page sent `disk`; otherwise the version last read is expected.
  std::optional<std::string> disk = std::nullopt;  ///< Expected version of the file; nothing: no file expected.
};

/// All functions may be called from any thread.
class OpenModel {
 public:
  /// `changed` is called with the new revision after every change.
  OpenModel(ModelFolder folder, std::function<void(std::int64_t)> changed);

  /// Returns a snapshot of the open model.
  ModelText snapshot() const;
  const ModelFolder& folder() const { return folder_; }

  /// Replaces the open text. HttpError 409 if `revision` is not that of the open model.
  ModelText put(const std::string& text, std::int64_t revision, const std::string* name);
  /// Sets keys of the open model. HttpError 409 likewise, 422 if a key cannot be set.
  ModelText set(const std::vector<YamlChange>& changes, std::int64_t revision);
  ModelText open(const std::string& name);
  ModelText save(const SaveRequest& request);

 private:
  ModelText take(ModelText next);
  void require(std::int64_t revision, std::unique_lock<std::mutex>& hold) const;

  ModelFolder folder_;
  std::function<void(std::int64_t)> changed_;
  mutable std::mutex mutex_;
  ModelText model_;
};

/// Returns the model as answered by GET /api/model, with diagnostics and fields.
Json model_json(const ModelText& model);

/// Parses changes sent by the page: `[{path, value}]`.
std::vector<YamlChange> read_changes(const Json& request);

}  // namespace overbend
