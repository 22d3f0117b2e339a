/// A YAML text as a plain tree that records the position of every value. Only the part of YAML that a model file needs:
/// one document of maps, lists and scalars; no anchors, aliases or tags.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"

namespace overbend {

struct YamlEntry;

struct YamlNode {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  std::string text;  ///< Text of a scalar.
  bool quoted = false;
  int line = 0, column = 0;  ///< Counted from 1.
  std::vector<YamlNode> items;
  std::vector<YamlEntry> entries;  ///< In the order of the file.
};

struct YamlEntry {
  std::string key;
  int line = 0, column = 0;  ///< Position of the key.
  YamlNode value;
};

/// Parses `text`. Syntax errors, repeated keys, anchors, aliases, tags and further documents go to `diagnostics`; the
/// readable part is returned nevertheless, nothing if the text is not YAML at all.
std::optional<YamlNode> parse_yaml(const std::string& text, const std::string& file, Diagnostics& diagnostics);

}  // namespace overbend
