/// From checked values of a model file to members of the description. What the file does not give stays as it is.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "modelfile/field_value.h"

namespace overbend {

inline void take(const FieldValue& group, const std::string& key, double& target) {
  if (const auto number = group.get_number(key)) target = *number;
}

inline void take(const FieldValue& group, const std::string& key, std::optional<double>& target) {
  if (const auto number = group.get_number(key)) target = *number;
}

inline void take(const FieldValue& group, const std::string& key, int& target) {
  if (const auto integer = group.get_integer(key)) target = static_cast<int>(*integer);
}

inline void take(const FieldValue& group, const std::string& key, std::string& target) {
  if (const auto text = group.get_text(key)) target = *text;
}

/// Position of a word in the list of names of an enum, in its order. `Target` is the enum or an optional of it.
template <typename Enum, typename Target, std::size_t count>
void take_word(const FieldValue& group, const std::string& key, const std::array<const char*, count>& names,
               Target& target) {
  const auto text = group.get_text(key);
  for (std::size_t i = 0; text && i < count; ++i) {
    if (*text == names[i]) target = static_cast<Enum>(i);
  }
}

template <typename Enum, std::size_t count>
void take_choice(const FieldValue& group, const std::string& key, const std::array<const char*, count>& names,
                 Enum& target) {
  take_word<Enum>(group, key, names, target);
}

}  // namespace overbend
