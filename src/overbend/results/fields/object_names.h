/// Table of results by object (lines, bodies, supports, seabed, stages and the run) with the names of these results by
/// kind in summary.json and results.h5.
///
/// "lines[pipe].static.lay_back" is "static.lay_back", "supports[stinger 3].static.reaction" is
/// "static.supports[stinger 3].reaction". Both names are accepted wherever a result is named.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace overbend {

/// Members of summary.json that belong to an object. If several rows hold a member, the longest path applies.
struct ObjectRow {
  std::string_view object;        ///< "lines[*].static"; empty for members without an object.
  std::string_view path;          ///< In summary.json: "static.moorings[*]".
  std::string_view members = {};  ///< Names of the members of `path`, separated by spaces; empty: all of them.
  std::string_view kind = {};     ///< Kind of a line: pipe, mooring or line.
};
std::span<const ObjectRow> object_rows();

/// A group of results.h5 and its name below /objects. <line>, <mooring> and <support> are placeholders of each name,
/// <number> of the number of the line in the model, from 0.
struct ObjectLink {
  std::string_view link;
  std::string_view group;
};
std::span<const ObjectLink> object_links();

/// Returns the row that a path of summary.json belongs to; null if there is none.
const ObjectRow* object_row(const std::string& path);

/// Returns the path by object of a path of summary.json; nothing if it belongs to no object. For a list with an empty
/// item, "static.supports[].reaction", the item stays empty.
std::optional<std::string> object_path(const std::string& path);

/// Returns the paths of summary.json that a path by object may refer to: a line may be a pipe, a mooring line or a
/// stand-alone line. A path of summary.json refers to itself. A leading "objects." is that of the file and optional.
std::vector<std::string> summary_paths(const std::string& path);

}  // namespace overbend
