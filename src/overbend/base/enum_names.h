/// Names of the enumerators of an enumeration, each declared once next to its enumerator.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/require.h"

namespace overbend {

/// An enumerator and its name in files, schemas and messages.
template <typename Enum>
struct Word {
  Enum value;
  const char* word;
};
template <typename Enum>
Word(Enum, const char*) -> Word<Enum>;

/// An array of `Word<Enum>`, in display order; specialised for each enumeration that has names.
template <typename Enum>
inline constexpr int kEnumNames = 0;

template <typename Enum>
concept HasEnumNames = requires {
  kEnumNames<Enum>.size();
};

template <HasEnumNames Enum>
const char* enum_name(Enum value) {
  for (const Word<Enum>& entry : kEnumNames<Enum>) {
    if (entry.value == value) return entry.word;
  }
  broken_promise("every enumerator has a name");
}

/// Returns the enumerator of a name; empty for any other text.
template <HasEnumNames Enum>
std::optional<Enum> from_enum_name(std::string_view word) {
  for (const Word<Enum>& entry : kEnumNames<Enum>) {
    if (entry.word == word) return entry.value;
  }
  return std::nullopt;
}

template <HasEnumNames Enum>
std::vector<std::string> enum_names() {
  std::vector<std::string> names;
  for (const Word<Enum>& entry : kEnumNames<Enum>) names.emplace_back(entry.word);
  return names;
}

}  // namespace overbend
