#include "modelfile/binding/binding.h"

#include <filesystem>

#include "modelfile/binding/line_resolution.h"
#include "modelfile/binding/stinger_binding.h"
#include "modelfile/binding/wave_resolution.h"
#include "modelfile/fields/field_table.h"

namespace overbend {
namespace {

const Field& find_row(const FieldNode& node, const FieldValue& value) {
  const Field* row = node.scalar;
  if (value.kind == FieldValue::Kind::map) row = node.map;
  if (value.kind == FieldValue::Kind::list) row = node.list;
  require(row != nullptr, "a checked value has the shape of one of its rows");
  return *row;
}

Target put(const Field& row, const FieldValue& value, Target& owner, const std::string& source_file) {
  if (!row.file) return row.member.put(owner, value);
  FieldValue file = value;
  file.text = resolved_file(value.text, source_file);
  return row.member.put(owner, file);
}

void bind_value(const FieldNode& node, const FieldValue& value, Target& target, const std::string& source_file) {
  if (!value.given) return;
  const Field& row = find_row(node, value);
  Target below = row.member.put ? put(row, value, target, source_file) : target;
  if (!below.has_value()) return;
  if (value.kind == FieldValue::Kind::map) bind_members(node, value, below, source_file);
  if (value.kind == FieldValue::Kind::list) {
    for (const FieldValue& item : value.children) bind_value(*node.item, item, below, source_file);
  }
}

/// The head's section defaults to that of the pipe, which is outside the group of the operation.
void bind_head_section(const FieldValue& root, const std::string& source_file, Description& description) {
  const FieldValue* section = root.find("operation.head.section");
  std::optional<HeadDescription>& head = description.operation.lay.head;
  if (section == nullptr || section->kind != FieldValue::Kind::map || !section->given || !head) return;
  head->section = description.pipe.section;
  head->section->joint.reset();
  bind_members(field_node("operation.head.section"), *section, &*head->section, source_file);
}

}  // namespace

// Binds in the order of the table, not of the file: a row may depend on rows above it.
void bind_members(const FieldNode& node, const FieldValue& group, Target target, const std::string& source_file) {
  for (const auto& member : node.members) {
    for (const FieldValue& value : group.children) {
      if (member->key == value.key || member->key == "*") bind_value(*member, value, target, source_file);
    }
  }
}

/// Sets the default mode of the tensioner; a brake must be chosen explicitly.
void choose_tensioner_mode(const FieldValue& root, TensionerDescription& tensioner) {
  const FieldValue* group = root.find("tensioner");
  if (group == nullptr || group->mentions("mode") || group->mentions("range")) return;
  tensioner.mode = TensionerMode::constant;
  tensioner.mode_assumed = true;
}

Description bind_model(const FieldValue& root, const std::string& source_file) {
  Description description;
  description.source_file = source_file;
  description.title = std::filesystem::path(source_file).stem().string();
  description.has_pipe = root.find("pipe") != nullptr;
  bind_members(field_tree(), root, &description, source_file);
  bind_head_section(root, source_file, description);
  place_box_rows(root, description);
  choose_stinger_setting(description.supports);
  choose_tensioner_mode(root, description.tensioner);
  resolve_lines(description);
  resolve_waves(description);
  return description;
}

std::string resolved_file(const std::string& file, const std::string& source_file) {
  const std::filesystem::path path(file);
  if (path.is_absolute()) return file;
  return (std::filesystem::path(source_file).parent_path() / path).lexically_normal().string();
}

}  // namespace overbend
