/// Small helpers on text for messages, keys and commands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace overbend {

/// The text without white space at its ends.
std::string_view trim(std::string_view text);

/// ASCII lower case.
std::string lower_case(std::string_view text);

/// "a, b or c" with `last` = "or".
std::string join_words(const std::vector<std::string>& words, const std::string& last);

/// "'a'" for a single word, "one of a, b or c" for several.
std::string one_of(const std::vector<std::string>& words);

/// Text shortened for a message: one line, at most `most` characters, control characters shown as '?'.
std::string for_display(std::string_view text, std::size_t most = 60);

/// A word as a POSIX shell has to read it to take it letter for letter, in quotes only where they are needed.
std::string shell_word(std::string_view text);

/// Number of letters to insert, delete, replace or swap with a neighbour to turn one word into the other.
int edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to `word`, empty when none is near enough to be meant.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace overbend
