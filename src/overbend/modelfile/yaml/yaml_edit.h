/// Edits single keys of a YAML text; comments and layout are unchanged.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "base/yaml_document.h"

namespace overbend {

struct YamlChange {
  enum class Kind { scalar, flow, remove };
  std::string path;  ///< "pipe.coatings[1].thickness", indices from 0; the index after the last appends.
  Kind kind = Kind::scalar;
  std::string value;  ///< Scalar ("260 kN"), or YAML in flow style ("{x: 1 m, z: 2 m}").
};

/// Error of an impossible change; the message names the change and the reason.
class YamlEditError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the text with the changes applied in order. A missing key is inserted after the others of its group; missing
/// groups are created; a group that loses its last key is removed. Removing a missing key has no effect. Throws
/// YamlEditError if the text is not YAML, a path passes through something other than groups and lists, or a value
/// extends over several lines.
std::string edit_yaml(const std::string& text, const std::vector<YamlChange>& changes);

/// Applies the changes to the tree, for scalars and for keys missing in a group. Returns false, with the tree in an
/// undefined state, if a change is of another kind.
bool edit_tree(YamlNode& root, const std::vector<YamlChange>& changes);

/// Returns a scalar as written in flow style to be read as this text: quoted where necessary.
std::string yaml_scalar(const std::string& text);

}  // namespace overbend
