/// Checked model file: the values of the field table with their positions, defaults filled in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/enum_names.h"
#include "base/yaml_document.h"
#include "modelfile/schema/field_tree.h"

namespace overbend {

/// Checked value. Values that failed their check are absent; the diagnostics contain the reason.
struct FieldValue {
  enum class Kind { number, integer, text, list, map };
  Kind kind = Kind::map;
  std::string key;           ///< Key in its group; empty for items of lists.
  std::string path;          ///< Full path, with indices from 0: "supports.ramp.boxes[2].x".
  int line = 0, column = 0;  ///< Position of the key in the file; of the group for defaults.
  bool given = true;         ///< False for a default.
  std::string shown;         ///< As written, for messages.
  double number = 0.0;       ///< SI.
  std::int64_t integer = 0;
  std::string text;
  std::vector<FieldValue> children;        ///< Members or items.
  std::vector<std::string> rejected_keys;  ///< Keys given in the group, possibly misspelt, that have been reported.

  /// Returns the member of a group at a path below it, "steel.wall_thickness"; null if absent or rejected.
  const FieldValue* find(const std::string& below) const;
  /// Returns true if a member was given, valid or not, so that it must not be reported as missing.
  bool mentions(const std::string& member) const;
  /// Return a number, integer or text below; empty if absent.
  std::optional<double> get_number(const std::string& below) const;
  std::optional<std::int64_t> get_integer(const std::string& below) const;
  std::optional<std::string> get_text(const std::string& below) const;
  /// Returns a choice below as an enumerator.
  template <HasEnumNames Enum>
  std::optional<Enum> get_word(const std::string& below) const {
    const std::optional<std::string> word = get_text(below);
    return word ? from_enum_name<Enum>(*word) : std::nullopt;
  }
};

/// Checks a YAML tree against the field table: shapes, units, ranges, unknown and missing keys. Errors are added to
/// `diagnostics`; returns all valid values.
FieldValue read_fields(const YamlNode& root, const FieldNode& tree, const std::string& file, Diagnostics& diagnostics);

}  // namespace overbend
