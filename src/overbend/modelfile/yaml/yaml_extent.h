/// Positions of the parts of a YAML tree in its text.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "base/yaml_document.h"

namespace overbend {

/// Offsets of a tree's nodes in the text from which it was parsed. All functions throw std::runtime_error for an
/// unsupported layout: a value of several lines, an explicit key.
class YamlExtent {
 public:
  explicit YamlExtent(const std::string& text);

  std::size_t offset(int line, int column) const;
  std::size_t begin(const YamlNode& node) const { return offset(node.line, node.column); }
  std::size_t begin(const YamlEntry& entry) const { return offset(entry.line, entry.column); }
  /// Returns the offset after the last character of a value, excluding comments.
  std::size_t end(const YamlNode& node) const;
  /// The same for key and value together.
  std::size_t end(const YamlEntry& entry) const;
  /// Returns the offset after the colon of a key.
  std::size_t after_colon(const YamlEntry& entry) const;
  /// Returns true for {a: 1} and [1, 2].
  bool flow(const YamlNode& node) const;
  /// Returns the offset of the closing bracket of a group or list in flow style.
  std::size_t closing(const YamlNode& node) const;

  std::size_t line_begin(std::size_t offset) const;
  /// Returns the offset of the line break that ends the line, or the end of the text.
  std::size_t line_end(std::size_t offset) const;

 private:
  std::size_t scalar_end(const YamlNode& node) const;
  std::size_t quoted_end(std::size_t offset) const;

  const std::string& text_;
  std::vector<std::size_t> lines_;  ///< Offset of the beginning of each line.
};

}  // namespace overbend
