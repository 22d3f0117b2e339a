/// Text helpers for messages, keys and commands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace overbend {

/// Returns the text without white space at its ends.
std::string_view trim(std::string_view text);

/// Returns the text in ASCII lower case.
std::string lower_case(std::string_view text);

/// Length of the decimal number at the start of the text: "-1.5e3"; 0 if there is none.
std::size_t number_length(std::string_view text);

/// Returns "a, b or c" with `last` = "or".
std::string join_items(const std::vector<std::string>& items, const std::string& last);

/// Returns "'a'" for a single item, "one of a, b or c" for several.
std::string join_choices(const std::vector<std::string>& items);

/// Shortens text for a message: one line, at most `max_length` characters, control characters shown as '?'.
std::string for_display(std::string_view text, std::size_t max_length = 60);

/// Quotes a word for a POSIX shell if necessary.
std::string shell_word(std::string_view text);

/// Returns the number of insertions, deletions, replacements or swaps of neighbouring letters that turn one word into
/// the other.
int edit_distance(std::string_view a, std::string_view b);

/// Returns the known word nearest to `word`, empty if none is near enough.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace overbend
