#include "resultfiles/summary/result_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/result_path.h"
#include "results/fields/object_names.h"

namespace overbend {
namespace {

/// Returns the value at the path, up to a list; null without one.
const Json* find_value(const Json& summary, const std::vector<PathPart>& path) {
  const Json* value = &summary;
  for (const PathPart& part : path) {
    if (part.item) break;
    const auto member = value->is_object() ? value->find(part.text) : value->end();
    if (!value->is_object() || member == value->end()) return nullptr;
    value = &*member;
  }
  return value;
}

std::string name_of_item(const Json& item, const ObjectRow& row) {
  const auto name = item.find("name");
  if (name != item.end() && name->is_string()) return name->get<std::string>();
  return row.kind.empty() ? "*" : std::string(row.kind);
}

/// Returns the key of an item, made distinct from an equal name earlier in the list or of an object of another kind.
std::string item_key(const Json& list, std::size_t index, const ObjectRow& row, Json& group) {
  std::string key = name_of_item(list[index], row);
  const auto same = std::count_if(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(index),
                                  [&](const Json& item) { return name_of_item(item, row) == key; });
  if (same > 0) key += " (" + std::to_string(same + 1) + ")";
  const auto taken = group.find(key);
  if (taken != group.end() && taken->value("kind", "") != row.kind) key.append(" (").append(row.kind).append(")");
  return key;
}

/// Returns the members of a value that belong to the row.
Json members_in(const Json& value, const ObjectRow& row) {
  Json members = Json::object();
  for (const auto& [key, member] : value.items()) {
    if (object_row(fmt::format("{}.{}", row.path, key)) == &row) members[key] = member;
  }
  return members;
}

/// Adds the members of a value to the object: `key` is the name of the item in place of "*".
void add_members(const Json& value, const ObjectRow& row, const std::string& key, Json& objects) {
  if (!value.is_object()) return;
  const Json members = members_in(value, row);
  if (members.empty()) return;
  const std::vector<PathPart> path = *split_result_path(row.object);
  Json* place = &objects;
  for (const PathPart& part : path) {
    place = &(*place)[part.item && part.text == "*" ? key : part.text];
    if (part.item && !row.kind.empty()) (*place)["kind"] = row.kind;
  }
  place->update(members);
}

void add_row(const Json& summary, const ObjectRow& row, Json& objects) {
  const std::vector<PathPart> path = *split_result_path(row.path);
  const Json* value = find_value(summary, path);
  if (value == nullptr) return;
  if (!path.back().item) return add_members(*value, row, "", objects);
  if (!value->is_array()) return;
  const std::string group = split_result_path(row.object)->front().text;
  for (std::size_t i = 0; i < value->size(); ++i) {
    add_members((*value)[i], row, item_key(*value, i, row, objects[group]), objects);
  }
}

/// Adds the objects of every stage, which has the members of `static`, and the stage's own members.
void add_stages(const Json& summary, Json& objects) {
  const Json* stages = find_value(summary, *split_result_path("operation.stages"));
  if (stages == nullptr || !stages->is_array()) return;
  for (const Json& stage : *stages) {
    Json lay = Json::object();
    for (const auto& [key, member] : stage.items()) {
      if (object_row("operation.stages[0]." + key) == nullptr) lay[key] = member;
    }
    objects["stages"][stage.value("name", "")].update(result_objects(Json{{"static", lay}}));
  }
}

}  // namespace

Json result_objects(const Json& summary) {
  Json objects = Json::object();
  for (const ObjectRow& row : object_rows()) {
    if (!row.object.empty()) add_row(summary, row, objects);
  }
  add_stages(summary, objects);
  return objects;
}

Json with_objects(Json summary) {
  Json objects = result_objects(summary);
  if (!objects.empty()) summary["objects"] = std::move(objects);
  return summary;
}

}  // namespace overbend
