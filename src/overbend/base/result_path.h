/// Names of keys and results such as "supports.stinger.boxes[stinger 3].z".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace overbend {

/// Part of such a name: a key, or a selection in brackets after a list.
struct PathPart {
  std::string text;
  bool item = false;  ///< True if in brackets: selects items of a list.
};

/// Splits "a.b[stinger 3].c" into a, b, [stinger 3], c. Points within brackets belong to the selection. Returns nothing
/// if a part is empty or a bracket is open, or if the name is longer than any key.
std::optional<std::vector<PathPart>> split_result_path(std::string_view name);

/// Joins parts to a name.
std::string join_result_path(const std::vector<PathPart>& parts);

/// Returns the index given by the text, counted from 0; nothing for a name or a pattern.
std::optional<std::size_t> item_index(const std::string& text);

/// True if the text matches the pattern: `*` in it matches any characters, also none.
bool matches_pattern(std::string_view pattern, std::string_view text);

/// True if the text in brackets selects an item: by its index, a range of indices "0..4", its name, or a pattern.
bool chooses_item(const std::string& text, std::size_t index, const std::string& name);

}  // namespace overbend
