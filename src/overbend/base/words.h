/// Words for the enumerators of an enumeration, each declared once beside its enumerator.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/require.h"

namespace overbend {

/// An enumerator and the word that stands for it in files, schemas and messages.
template <typename Enum>
struct Word {
  Enum value;
  const char* word;
};
template <typename Enum>
Word(Enum, const char*) -> Word<Enum>;

/// An array of `Word<Enum>`, in the order in which the words are listed; specialised for each enumeration that has
/// words.
template <typename Enum>
inline constexpr int kWords = 0;

template <typename Enum>
concept HasWords = requires {
  kWords<Enum>.size();
};

template <HasWords Enum>
const char* word_of(Enum value) {
  for (const Word<Enum>& entry : kWords<Enum>) {
    if (entry.value == value) return entry.word;
  }
  broken_promise("every enumerator has a word");
}

/// The enumerator of a word; empty for any other text.
template <HasWords Enum>
std::optional<Enum> from_word(std::string_view word) {
  for (const Word<Enum>& entry : kWords<Enum>) {
    if (entry.word == word) return entry.value;
  }
  return std::nullopt;
}

template <HasWords Enum>
std::vector<std::string> words_of() {
  std::vector<std::string> words;
  for (const Word<Enum>& entry : kWords<Enum>) words.emplace_back(entry.word);
  return words;
}

}  // namespace overbend
