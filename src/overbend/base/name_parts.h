/// Names of keys and results such as "supports.stinger.boxes[stinger 3].z".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace overbend {

/// A part of such a name: a key, or what stands in brackets behind a list.
struct NamePart {
  std::string text;
  bool item = false;  ///< In brackets: chooses items of a list.
};

/// "a.b[stinger 3].c" -> a, b, [stinger 3], c. Points within brackets belong to the text there. Nothing where a part is
/// empty or a bracket is left open, and where the name is longer than any key's.
std::optional<std::vector<NamePart>> name_parts(std::string_view name);

/// The parts as a name again.
std::string joined_name(const std::vector<NamePart>& parts);

/// The index that the text of an item is, counted from 0; nothing where it is a name or a pattern.
std::optional<std::size_t> item_index(const std::string& text);

/// Whether the pattern stands for that text: `*` in it for any letters, also none.
bool matches_pattern(std::string_view pattern, std::string_view text);

/// Whether the text in brackets chooses an item: by its index, a range of indices "0..4", its name, or a pattern.
bool chooses_item(const std::string& text, std::size_t index, const std::string& name);

}  // namespace overbend
