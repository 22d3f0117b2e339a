/// Changes single keys of a YAML text and leaves the rest of it, comments and layout, as it stands.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "base/yaml_document.h"

namespace overbend {

struct YamlChange {
  enum class Kind { scalar, flow, remove };
  std::string path;  ///< "pipe.coatings[1].thickness", indices from 0; one behind the end of a list appends.
  Kind kind = Kind::scalar;
  std::string value;  ///< A scalar as it is meant ("260 kN"), or YAML in flow style ("{x: 1 m, z: 2 m}").
};

/// A change that cannot be made; says which and why.
class YamlEditFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The text with the changes made, one after the other. A key that is missing is put behind the others of its group;
/// groups that are missing are made; a group that loses its last key goes with it. Removing what is not there changes
/// nothing. Throws YamlEditFault where the text is no YAML, a path leads through something else than groups and lists,
/// or a value runs over several lines.
std::string edit_yaml(const std::string& text, const std::vector<YamlChange>& changes);

/// The same in the tree instead of the text, for values that are scalars now or keys yet missing in a group. False,
/// with the tree in an unknown state, where a change is none of these.
bool edit_tree(YamlNode& root, const std::vector<YamlChange>& changes);

/// A scalar as it has to be written within flow style to be read as this text: in quotes where it would mislead.
std::string yaml_scalar(const std::string& text);

}  // namespace overbend
