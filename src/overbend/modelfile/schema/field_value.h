/// A checked model file: the values of the field table with their places, defaults filled in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/words.h"
#include "base/yaml_document.h"
#include "modelfile/schema/field_tree.h"

namespace overbend {

/// One value. A value that failed its check is not there at all; the complaint is in the diagnostics.
struct FieldValue {
  enum class Kind { number, integer, text, list, map };
  Kind kind = Kind::map;
  std::string key;           ///< In its group; empty for items of lists.
  std::string path;          ///< Full, with indices from 0: "supports.ramp.boxes[2].x".
  int line = 0, column = 0;  ///< Of the key in the file; of the group for defaults.
  bool given = true;         ///< False for a default.
  std::string shown;         ///< As written, for messages.
  double number = 0.0;       ///< SI.
  std::int64_t integer = 0;
  std::string text;
  std::vector<FieldValue> children;  ///< Members or items.
  std::vector<std::string> refused;  ///< Keys that stand in the group, or were meant, but were complained about.

  /// Member of a group at a path below it, "steel.wall_thickness"; null when absent or refused.
  const FieldValue* find(const std::string& below) const;
  /// True when a member was given in any form, right or wrong: no use in telling it as missing.
  bool mentions(const std::string& member) const;
  /// Number, whole number or text below; empty when absent.
  std::optional<double> get_number(const std::string& below) const;
  std::optional<std::int64_t> get_integer(const std::string& below) const;
  std::optional<std::string> get_text(const std::string& below) const;
  /// Choice below as the enumerator that it names.
  template <HasWords Enum>
  std::optional<Enum> get_word(const std::string& below) const {
    const std::optional<std::string> word = get_text(below);
    return word ? from_word<Enum>(*word) : std::nullopt;
  }
};

/// Checks a YAML tree against the field table: shapes, units, ranges, unknown and missing keys. Everything found wrong
/// goes to `diagnostics`; the result holds all that was right.
FieldValue read_fields(const YamlNode& root, const FieldNode& tree, const std::string& file, Diagnostics& diagnostics);

}  // namespace overbend
