#include "modelfile/binding/model_inputs.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/ranges.h"
#include "base/yaml_document.h"
#include "modelfile/binding/binding.h"
#include "modelfile/fields/field_table.h"

namespace overbend {
namespace {

/// Keys without effect on the static equilibrium of a lay with a held vessel, and the position of a bathymetry, whose
/// depths are read once.
constexpr std::array kExcludedKeys = {"overbend",
                                      "analysis",
                                      "environment.waves",
                                      "environment.seabed.bathymetry_origin",
                                      "environment.seabed.bathymetry_midship",
                                      "seek",
                                      "sensitivities",
                                      "moorings",
                                      "lines",
                                      "bodies",
                                      "station_keeping",
                                      "vessel.motion",
                                      "vessel.loads",
                                      "vessel.hydrostatics"};

/// Keys without effect on a lay whose stinger is held at its equilibrium angle, below the stinger or one of its
/// sections.
constexpr std::array kStingerKeys = {"body", "tanks", "limits", "springs", "stop_stiffness", "hinge_friction"};

bool is_or_below(const std::string& path, const std::string& key) {
  return path == key || path.starts_with(key + ".") || path.starts_with(key + "[");
}

bool is_of_the_rest(const std::string& path) {
  const std::string stinger = "supports.stinger.";
  if (!path.starts_with(stinger)) return false;
  std::string below = path.substr(stinger.size());
  if (below.starts_with("sections[")) below.erase(0, std::min(below.find("]."), below.size() - 2) + 2);
  return ranges::any_of(kStingerKeys, [&](const char* key) { return is_or_below(below, key); });
}

bool left_out(const std::string& path) {
  return is_of_the_rest(path) ||
         ranges::any_of(kExcludedKeys, [&](const std::string& key) { return is_or_below(path, key); });
}

/// Returns the label of a list item: its name, the default name of a box, or its index.
std::string item_name(const FieldValue& list, std::size_t index) {
  if (const auto name = list.children[index].get_text("name")) return *name;
  for (const char* structure : {"ramp", "stinger"}) {
    if (list.path == std::string("supports.") + structure + ".boxes") {
      return std::string(structure) + " " + std::to_string(index + 1);
    }
  }
  return std::to_string(index);
}

class Collector {
 public:
  explicit Collector(std::vector<ModelInput>& inputs) : inputs_(inputs) {}

  void visit(const FieldValue& value, const FieldNode& node, const std::string& name) {
    if (!value.given || left_out(value.path)) return;
    if (value.kind == FieldValue::Kind::number && node.scalar != nullptr) add(value, *node.scalar, name);
    for (std::size_t i = 0; i < value.children.size(); ++i) {
      const FieldValue& child = value.children[i];
      const bool list = value.kind == FieldValue::Kind::list;
      const FieldNode* below = list ? node.item.get() : node.member(child.key);
      if (below == nullptr) continue;
      place_.push_back(i);
      const std::string suffix = list ? "[" + item_name(value, i) + "]" : (name.empty() ? "" : ".") + child.key;
      visit(child, *below, name + suffix);
      place_.pop_back();
    }
  }

 private:
  void add(const FieldValue& value, const Field& row, const std::string& name) {
    const bool quantity = !row.unit.empty() && value.kind == FieldValue::Kind::number;
    if (!quantity && row.kind != FieldKind::number) return;
    inputs_.push_back(
        {value.path, name, row.text, quantity ? row.unit : "1", quantity ? row.show : "", value.number, place_});
  }

  std::vector<ModelInput>& inputs_;
  std::vector<std::size_t> place_;
};

FieldValue parse_values(const std::string& text, const std::string& file) {
  Diagnostics diagnostics;
  const std::optional<YamlNode> root = parse_yaml(text, file, diagnostics);
  if (!root || root->kind != YamlNode::Kind::map) throw std::runtime_error("the model's text cannot be read: " + file);
  return read_fields(*root, field_tree(), file, diagnostics);
}

}  // namespace

std::vector<ModelInput> numeric_inputs(const FieldValue& root) {
  std::vector<ModelInput> inputs;
  Collector(inputs).visit(root, field_tree(), "");
  return inputs;
}

ModelValues::ModelValues(const Description& description)
    : source_file_(description.source_file),
      root_(parse_values(description.source_text, description.source_file)),
      inputs_(numeric_inputs(root_)),
      bathymetry_(description.environment.seabed.bathymetry) {}

std::optional<std::size_t> ModelValues::find(const std::string& key_or_name) const {
  const auto found = ranges::find_if(
      inputs_, [&](const ModelInput& input) { return input.key == key_or_name || input.name == key_or_name; });
  if (found == inputs_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - inputs_.begin());
}

Description ModelValues::with(const ModelInput& input, double value) {
  FieldValue* node = &root_;
  for (const std::size_t i : input.place) node = &node->children[i];
  const double before = node->number;
  node->number = value;
  Description description = bind_model(root_, source_file_);
  node->number = before;
  description.environment.seabed.bathymetry = bathymetry_;
  return description;
}

}  // namespace overbend
