/// The model that is open: kept by the program, so that it outlives a reload of the page.
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
  std::string text, name;  ///< `name` is that of its file, empty where it has none.
  bool saved = true;
  std::int64_t revision = 0;
  std::optional<std::string> disk;  ///< Version of the file as last read or written; none for one that has no file.
  std::string path;  ///< Of the file, or where it would lie: in messages, and the folder of the files it mentions.
};

/// Text that a page wants to save, and the content it expects in the file.
struct SaveRequest {
  std::string name;
  bool force = false;                              ///< Whatever the file holds.
  bool knows = false;                              ///< Whether `disk` is the page's word; else what was last read.
  std::optional<std::string> disk = std::nullopt;  ///< Version of the file; nothing: it is not there yet.
};

/// All functions may be called from any thread.
class OpenModel {
 public:
  /// `changed` is called with the new revision after every change.
  OpenModel(ModelFolder folder, std::function<void(std::int64_t)> changed);

  ModelText now() const;
  const ModelFolder& folder() const { return folder_; }

  /// Puts a text in the place of the open one. A `revision` that is not the open one's is 409.
  ModelText put(const std::string& text, std::int64_t revision, const std::string* name);
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

/// The open model as GET /api/model gives it, with diagnostics and fields.
Json model_json(const ModelText& model);

/// Changes as the page sends them: `[{path, value}]`.
std::vector<YamlChange> changes_of(const Json& request);

}  // namespace overbend
