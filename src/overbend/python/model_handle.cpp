#include "python/model_handle.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/ranges.h"
#include "base/require.h"
#include "base/text.h"
#include "modelfile/fields/field_table.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/yaml/chosen_keys.h"
#include "modelfile/yaml/yaml_path.h"

namespace overbend {
namespace {

/// True if the key may refer to files, which need a complete reading.
bool names_files(const YamlChange& change) {
  return change.path.starts_with("vessel") || change.path.starts_with("environment.waves") ||
         change.path.find("bathymetry") != std::string::npos;
}

std::string no_item_message(const YamlNode& tree, const std::string& key, const std::vector<PathPart>& parts) {
  std::string sentence = "the key '" + for_display(key) + "' selects no item of the model";
  std::string list;
  for (const std::string& name : names_to_choose(tree, parts)) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? sentence : sentence + "; available: " + list;
}

/// Throws if the key does not exist in any model; otherwise, removing a misspelt key would have no effect.
void require_key(const std::string& key, const std::vector<PathPart>& parts) {
  const FieldNode* place = &field_tree();
  std::string prefix;
  for (const PathPart& part : parts) {
    const FieldNode* next = part.item ? place->item.get() : place->member(part.text);
    if (next == nullptr) {
      const std::string near = part.item ? "" : nearest_word(part.text, place->member_names());
      const std::string hint = near.empty() ? "" : fmt::format("; did you mean '{}{}'?", prefix, near);
      throw std::invalid_argument(fmt::format("'{}' is not a key of a model{}", key, hint));
    }
    if (!part.item) prefix.append(part.text).append(".");
    place = next;
  }
}

/// Appends the change for every key selected by its pattern.
void select_changes(const YamlNode& tree, const YamlChange& change, std::vector<YamlChange>& list) {
  const auto parts = split_result_path(change.path);
  if (!parts) throw std::invalid_argument("'" + for_display(change.path) + "' is no key of a model");
  if (change.kind == YamlChange::Kind::remove) require_key(change.path, *parts);
  const std::vector<ChosenKey> keys = chosen_keys(tree, *parts);
  // An index one past the end of a list appends to it.
  if (keys.empty() && change.kind != YamlChange::Kind::remove && change.path.ends_with(']')) {
    list.push_back(change);
    return;
  }
  if (keys.empty()) throw std::invalid_argument(no_item_message(tree, change.path, *parts));
  for (const ChosenKey& key : keys) list.push_back({key.path, change.kind, change.value});
}

YamlNode parse_tree(const std::string& text, const std::string& file) {
  Diagnostics errors;
  std::optional<YamlNode> tree = parse_yaml(text, file, errors);
  if (!tree || errors.has_errors()) throw UnreadableModel(std::move(errors));
  return std::move(*tree);
}

Description taken(ModelReading reading) {
  if (!reading.description) throw UnreadableModel(std::move(reading.diagnostics));
  return std::move(*reading.description);
}

}  // namespace

std::shared_ptr<ModelHandle> ModelHandle::read(const std::string& path) {
  std::shared_ptr<ModelHandle> model(new ModelHandle);
  model->full_description_ = taken(read_model(path));
  model->file_ = path;
  model->text_ = model->full_description_->source_text;
  model->tree_ = parse_tree(model->text_, path);
  return model;
}

std::shared_ptr<ModelHandle> ModelHandle::from_text(const std::string& text, const std::string& file) {
  std::shared_ptr<ModelHandle> model(new ModelHandle);
  model->full_description_ = taken(read_model_text(text, file));
  model->file_ = file;
  model->text_ = text;
  model->tree_ = parse_tree(text, file);
  return model;
}

std::shared_ptr<ModelHandle> ModelHandle::changed(const std::vector<YamlChange>& changes) const {
  std::vector<YamlChange> list;
  for (const YamlChange& change : changes) select_changes(tree_, change, list);
  const bool needs_full_reading = statics_description().vessel.coupled || ranges::any_of(list, names_files);
  if (YamlNode tree = tree_; !needs_full_reading && edit_tree(tree, list)) {
    if (ModelReading reading = read_statics_inputs(tree, file_); reading.description) {
      std::shared_ptr<ModelHandle> model(new ModelHandle);
      model->file_ = file_;
      model->tree_ = std::move(tree);
      model->statics_description_ = std::move(*reading.description);
      const std::lock_guard<std::mutex> hold(mutex_);
      model->text_ = text_;
      model->pending_ = pending_;
      if (text_is_new_) model->pending_.clear();
      model->pending_.insert(model->pending_.end(), list.begin(), list.end());
      model->text_is_new_ = false;
      return model;
    }
  }
  return from_text(edit_yaml(text(), list), file_);
}

const std::string& ModelHandle::text() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (!text_is_new_) {
    text_ = edit_yaml(text_, pending_);
    text_is_new_ = true;
  }
  return text_;
}

const Description& ModelHandle::description() const {
  const std::string& whole_text = text();
  const std::lock_guard<std::mutex> hold(mutex_);
  if (!full_description_) full_description_ = taken(read_model_text(whole_text, file_));
  return *full_description_;
}

const YamlNode* ModelHandle::find(const std::string& key) const {
  const auto parts = split_result_path(key);
  if (!parts) throw std::invalid_argument("'" + for_display(key) + "' is no key of a model");
  const std::vector<ChosenKey> keys = chosen_keys(tree_, *parts);
  if (keys.empty()) return nullptr;
  std::string rest;
  const std::vector<YamlSpot> spots = follow_path(tree_, keys.front().path, rest);
  return rest.empty() ? spots.back().node : nullptr;
}

}  // namespace overbend
