#include "modelfile/yaml/model_differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/ranges.h"
#include "base/units.h"
#include "base/yaml_document.h"

namespace overbend {
namespace {

constexpr double kRelativeTolerance = 1e-9;  ///< Relative tolerance for rounding of converted numbers.

/// Keys with their values, in the order of the file.
using Flat = std::vector<std::pair<std::string, std::string>>;

std::string find_item_name(const YamlNode& node) {
  for (const YamlEntry& entry : node.entries) {
    if (entry.key == "name" && entry.value.kind == YamlNode::Kind::scalar) return entry.value.text;
  }
  return "";
}

void flatten(const YamlNode& node, const std::string& path, Flat& flat) {
  if (node.kind == YamlNode::Kind::scalar) flat.emplace_back(path, node.text);
  if (node.kind == YamlNode::Kind::null && !path.empty()) flat.emplace_back(path, "null");
  for (const YamlEntry& entry : node.entries) {
    flatten(entry.value, path.empty() ? entry.key : path + "." + entry.key, flat);
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    std::string item = find_item_name(node.items[i]);
    const auto same = [&](const YamlNode& sibling) { return find_item_name(sibling) == item; };
    if (item.empty() || ranges::count_if(node.items, same) > 1) item = std::to_string(i);
    flatten(node.items[i], fmt::format("{}[{}]", path, item), flat);
  }
}

Flat flatten_text(const std::string& text) {
  Diagnostics ignored;
  Flat flat;
  if (const std::optional<YamlNode> root = parse_yaml(text, "", ignored)) flatten(*root, "", flat);
  return flat;
}

/// "406.4 mm" -> 406.4 and "mm".
std::optional<std::pair<double, std::string>> number_with_unit(const std::string& text) {
  const std::size_t blank = text.find(' ');
  const std::optional<double> number = parse_number(text.substr(0, blank));
  if (!number) return std::nullopt;
  return std::pair{*number, blank == std::string::npos ? std::string() : text.substr(blank + 1)};
}

bool close(double a, double b) {
  return std::abs(a - b) <= kRelativeTolerance * std::max(std::abs(a), std::abs(b));
}

}  // namespace

bool same_quantity(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const auto x = number_with_unit(a), y = number_with_unit(b);
  if (!x || !y) return false;
  if (x->second == y->second) return close(x->first, y->first);
  if (x->second.empty() || y->second.empty()) return false;
  const std::optional<double> factor = unit_factor(x->second, y->second);
  return factor && close(x->first * *factor, y->first);
}

std::vector<DifferingKey> differing_keys(std::span<const std::string> texts) {
  std::vector<DifferingKey> all;
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (const auto& [key, value] : flatten_text(texts[i])) {
      const auto [place, added] = places.try_emplace(key, all.size());
      if (added) all.push_back({key, std::vector<std::string>(texts.size())});
      all[place->second].values[i] = value;
    }
  }
  std::erase_if(all, [](const DifferingKey& key) {
    return ranges::all_of(key.values, [&](const std::string& value) {
      return value.empty() == key.values.front().empty() && same_quantity(value, key.values.front());
    });
  });
  return all;
}

}  // namespace overbend
