/// The one table of results by object: lines, bodies, supports, seabed, stages and the run, and the names that these
/// results have by kind in summary.json and results.h5.
///
/// "lines[pipe].static.lay_back" is "static.lay_back", "supports[stinger 3].static.reaction" is
/// "static.supports[stinger 3].reaction". Both names stand for the same number wherever a result is named.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace overbend {

/// Members of summary.json that belong to an object. Of several rows that hold a member the longest path counts.
struct ObjectRow {
  std::string_view object;        ///< "lines[*].static"; empty for what belongs to no object.
  std::string_view path;          ///< In summary.json: "static.moorings[*]".
  std::string_view members = {};  ///< Names of the members of `path` that are meant, by spaces; empty: all of them.
  std::string_view kind = {};     ///< Of a line: pipe, mooring or line.
};
std::span<const ObjectRow> object_rows();

/// A group of results.h5 and its name below /objects. <line>, <mooring> and <support> stand for each by its name,
/// <number> for the number of the line in the model, from 0.
struct ObjectLink {
  std::string_view link;
  std::string_view group;
};
std::span<const ObjectLink> object_links();

/// The row that a path of summary.json belongs to; null where there is none.
const ObjectRow* object_row(const std::string& path);

/// The path by object of a path of summary.json; nothing where it belongs to no object. Of a list with an empty item,
/// "static.supports[].reaction", the item stays empty.
std::optional<std::string> object_path(const std::string& path);

/// The paths of summary.json that a path by object may stand for: a line may be a pipe, a mooring or a line by itself.
/// A path of summary.json stands for itself. A leading "objects." is that of the file and may be left out.
std::vector<std::string> summary_paths(const std::string& path);

}  // namespace overbend
