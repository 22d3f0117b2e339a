#include "serve/model/open_model.h"

#include <fmt/format.h>

#include "serve/model/diagnose.h"
#include "serve/model/model_fields.h"

namespace overbend {
namespace {

/// Converts JSON to YAML in flow style, quoting scalars only if needed.
std::string flow_text(const Json& value) {
  if (value.is_string()) return yaml_scalar(value.get<std::string>());
  if (!value.is_structured()) return json_text(value);
  std::string text;
  for (const auto& [key, part] : value.items()) {
    text += (text.empty() ? "" : ", ") + (value.is_object() ? yaml_scalar(key) + ": " : std::string());
    text += flow_text(part);
  }
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

YamlChange read_change(const Json& request) {
  const std::string path = request.at("path").get<std::string>();
  const Json& value = request.at("value");
  if (value.is_null()) return {path, YamlChange::Kind::remove, ""};
  if (value.is_structured()) return {path, YamlChange::Kind::flow, flow_text(value)};
  return {path, YamlChange::Kind::scalar, value.is_string() ? value.get<std::string>() : json_text(value)};
}

/// True if the text equals its file, also after undo.
bool is_saved(const ModelText& model) {
  return model.disk && *model.disk == ModelFolder::version(model.text);
}

}  // namespace

OpenModel::OpenModel(ModelFolder folder, std::function<void(std::int64_t)> changed)
    : folder_(std::move(folder)), changed_(std::move(changed)) {
  model_.path = (folder_.path() / "model.yaml").string();
}

ModelText OpenModel::snapshot() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return model_;
}

/// To be called with the mutex held. On error, the mutex is released before the answer is made.
void OpenModel::require(std::int64_t revision, std::unique_lock<std::mutex>& hold) const {
  if (revision == model_.revision) return;
  const ModelText model = model_;
  hold.unlock();
  HttpError error(409, "the model has been changed elsewhere", "use the newer version, or replace it with yours");
  error.more["reason"] = "revision";
  error.top_level = model_json(model);
  throw error;
}

/// To be called with the mutex held.
ModelText OpenModel::take(ModelText next) {
  next.revision = model_.revision + 1;
  next.path = (folder_.path() / (next.name.empty() ? "model.yaml" : next.name)).string();
  folder_.provide_data(next.text);
  model_ = std::move(next);
  changed_(model_.revision);
  return model_;
}

ModelText OpenModel::put(const std::string& text, std::int64_t revision, const std::string* name) {
  std::unique_lock<std::mutex> hold(mutex_);
  require(revision, hold);
  ModelText next = model_;
  next.text = text;
  if (name != nullptr && *name != next.name) {
    next.name = *name;
    next.disk.reset();
  }
  next.saved = is_saved(next);
  return take(std::move(next));
}

ModelText OpenModel::set(const std::vector<YamlChange>& changes, std::int64_t revision) {
  std::unique_lock<std::mutex> hold(mutex_);
  require(revision, hold);
  ModelText next = model_;
  hold.unlock();  // many changes of a long text may take seconds
  try {
    next.text = edit_yaml(next.text, changes);
  } catch (const YamlEditError& error) {
    throw HttpError(422, error.what());
  }
  hold.lock();
  require(revision, hold);
  next.saved = is_saved(next);
  return take(std::move(next));
}

ModelText OpenModel::open(const std::string& name) {
  std::string text = folder_.read(name);
  const std::string version = ModelFolder::version(text);
  const std::lock_guard<std::mutex> hold(mutex_);
  return take({std::move(text), name, true, 0, version, ""});
}

ModelText OpenModel::save(const SaveRequest& request) {
  const std::lock_guard<std::mutex> hold(mutex_);
  const bool same_file = request.name == model_.name;
  if (request.force) {
    folder_.overwrite(request.name, model_.text);
  } else {
    folder_.write(request.name, model_.text, request.knows ? request.disk : same_file ? model_.disk : std::nullopt);
  }
  return take({model_.text, request.name, true, 0, ModelFolder::version(model_.text), ""});
}

Json model_json(const ModelText& model) {
  const ModelReading reading = read_model_text(model.text, model.path);
  return {{"text", model.text},
          {"name", model.name},
          {"saved", model.saved},
          {"revision", model.revision},
          {"disk", model.disk ? Json(*model.disk) : Json()},
          {"diagnostics", diagnostics_json(reading, model.text)},
          {"fields", model_fields(reading.tree.get())}};
}

std::vector<YamlChange> read_changes(const Json& request) {
  constexpr std::size_t kMaxChanges = 1000;
  if (request.size() > kMaxChanges) {
    throw HttpError(422, fmt::format("found {} changes, expected at most {}", request.size(), kMaxChanges));
  }
  std::vector<YamlChange> changes;
  for (const Json& change : request) changes.push_back(read_change(change));
  return changes;
}

}  // namespace overbend
