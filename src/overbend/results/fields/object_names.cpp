#include "results/fields/object_names.h"

#include <algorithm>
#include <array>

#include "base/ranges.h"
#include "base/result_path.h"

namespace overbend {
namespace {

using Parts = std::vector<PathPart>;

constexpr std::string_view kSolveMembers = "balance iterations relaxation_steps wall_time method history";
constexpr std::string_view kRunMembers =
    "duration build_up output_step seed assumptions assumption_ranks findings warnings non_stationary extremes "
    "energy_drift steps rejected_steps newton_iterations factorisations smallest_step largest_step wall_time "
    "real_time_ratio integrator verdict";
constexpr std::string_view kStageMembers =
    "name status cable_out pipe_out passed ahead weight ballast tension wanted_bottom_tension barge_ahead governing "
    "findings warnings verdict failure lay_warnings lay_findings winch_lengths";

constexpr std::array kRows = {
    ObjectRow{"lines[pipe].static", "static", "", "pipe"},
    ObjectRow{"lines[pipe].dynamic", "dynamic", "", "pipe"},
    ObjectRow{"lines[*].static", "static.moorings[*]", "", "mooring"},
    ObjectRow{"lines[*].dynamic", "dynamic.moorings[*]", "", "mooring"},
    ObjectRow{"lines[*].static", "static.lines[*]", "", "line"},
    ObjectRow{"lines[*].dynamic", "dynamic.lines[*]", "", "line"},
    ObjectRow{"bodies[*].static", "static.bodies[*]"},
    ObjectRow{"bodies[*].dynamic", "dynamic.bodies[*]"},
    ObjectRow{"bodies[vessel].static", "static.vessel"},
    ObjectRow{"bodies[vessel].static", "static", "mooring_force mooring_stiffness thrust hull"},
    ObjectRow{"bodies[vessel].dynamic", "dynamic.vessel"},
    ObjectRow{"bodies[vessel].dynamic", "dynamic", "thrust"},
    ObjectRow{"bodies[stinger].static", "static.stinger"},
    ObjectRow{"bodies[stinger].dynamic", "dynamic.stinger"},
    ObjectRow{"supports[*].static", "static.supports[*]"},
    ObjectRow{"supports[*].dynamic", "dynamic.supports[*]"},
    ObjectRow{"supports[*].dynamic.hardest_impact", "dynamic.impacts[*]"},
    ObjectRow{"seabed", "static.seabed"},
    ObjectRow{"stages[*]", "operation.stages[*]", kStageMembers},
    ObjectRow{"run.static", "static", kSolveMembers},
    ObjectRow{"run.dynamic", "dynamic", kRunMembers},
    ObjectRow{"", "dynamic", "checks"},
    ObjectRow{"", "operation.stages[*]", "checks"},
};

constexpr std::array kLinks = {
    ObjectLink{"lines/pipe/static", "/static"},
    ObjectLink{"lines/pipe/dynamic", "/dynamic"},
    ObjectLink{"lines/<line>/static", "/lines/<number>"},
    ObjectLink{"lines/<line>/dynamic", "/dynamic/lines/<number>"},
    ObjectLink{"lines/<line>/histories", "/dynamic/histories/line/<line>"},
    ObjectLink{"lines/<mooring>/histories", "/dynamic/histories/mooring/<mooring>"},
    ObjectLink{"bodies/<body>/static", "/bodies/<number>"},
    ObjectLink{"bodies/<body>/histories", "/dynamic/histories/body/<body>"},
    ObjectLink{"bodies/vessel/static/offset", "/moorings/vessel"},
    ObjectLink{"bodies/vessel/static/periods", "/moorings/periods"},
    ObjectLink{"bodies/vessel/static/hull", "/hull"},
    ObjectLink{"bodies/vessel/dynamic/motions", "/dynamic/vessel"},
    ObjectLink{"bodies/vessel/dynamic/thrust", "/dynamic/thrust"},
    ObjectLink{"bodies/vessel/histories", "/dynamic/histories/vessel"},
    ObjectLink{"bodies/stinger/static", "/static/stinger"},
    ObjectLink{"bodies/stinger/dynamic", "/dynamic/stinger"},
    ObjectLink{"supports/<support>/histories", "/dynamic/histories/support/<support>"},
    ObjectLink{"seabed", "/static/bed"},
    ObjectLink{"run/energy", "/dynamic/energy"},
    ObjectLink{"run/steps", "/dynamic/run"},
};

/// A row with its paths split into parts.
struct ParsedRow {
  const ObjectRow* row;
  Parts object, path;
  std::vector<std::string_view> members;
};

std::vector<std::string_view> split_names(std::string_view text) {
  std::vector<std::string_view> member_names;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    member_names.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return member_names;
}

const std::vector<ParsedRow>& parsed_rows() {
  static const std::vector<ParsedRow> kParsed = [] {
    std::vector<ParsedRow> rows;
    for (const ObjectRow& row : kRows) {
      rows.push_back({&row, split_result_path(row.object).value_or(Parts{}),
                      split_result_path(row.path).value_or(Parts{}), split_names(row.members)});
    }
    return rows;
  }();
  return kParsed;
}

/// True if an item of a pattern matches the part; in a path by object the item may also follow a dot.
bool matches_item(const PathPart& pattern, const PathPart& part) {
  if (!pattern.item) return !part.item && part.text == pattern.text;
  if (pattern.text == "*") return true;
  return part.item ? chooses_item(part.text, 0, pattern.text) : part.text == pattern.text;
}

bool begins_with(const Parts& parts, const Parts& pattern) {
  return parts.size() >= pattern.size() &&
         std::equal(pattern.begin(), pattern.end(), parts.begin(),
                    [](const PathPart& expected, const PathPart& part) { return matches_item(expected, part); });
}

/// True if the path is the list itself of a row of items.
bool is_list_path(const ParsedRow& row, const Parts& path) {
  return row.path.back().item && path.size() + 1 == row.path.size() && begins_with(row.path, path);
}

bool holds(const ParsedRow& row, const Parts& path) {
  if (is_list_path(row, path)) return true;
  if (!begins_with(path, row.path)) return false;
  if (row.members.empty()) return true;
  return path.size() > row.path.size() && ranges::find(row.members, path[row.path.size()].text) != row.members.end();
}

const ParsedRow* find_row(const Parts& path) {
  const auto length = [](const ParsedRow& row) { return row.path.size() + (row.members.empty() ? 0 : 1); };
  const ParsedRow* found = nullptr;
  for (const ParsedRow& row : parsed_rows()) {
    if (holds(row, path) && (found == nullptr || length(row) > length(*found))) found = &row;
  }
  return found;
}

/// Returns the path with `from` replaced by `to`; an item in both is kept.
Parts replaced(const Parts& path, const Parts& from, const Parts& to) {
  std::string item;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i].item && from[i].text == "*") item = path[i].text;
  }
  Parts result = to;
  for (PathPart& part : result) {
    if (part.item && part.text == "*") part.text = item;
  }
  result.insert(result.end(), path.begin() + static_cast<std::ptrdiff_t>(from.size()), path.end());
  return result;
}

const Parts& stage_pattern() {
  static const Parts kPattern = *split_result_path("operation.stages[*]");
  return kPattern;
}

/// A stage has the members of `static`, and in the tree the objects of these members.
std::optional<Parts> by_object(const Parts& path) {
  const ParsedRow* row = find_row(path);
  if (row != nullptr && (row->object.empty() || is_list_path(*row, path))) return std::nullopt;
  if (row != nullptr) return replaced(path, row->path, row->object);
  if (!begins_with(path, stage_pattern()) || path.size() == stage_pattern().size()) return std::nullopt;
  const std::optional<Parts> below = by_object(replaced(path, stage_pattern(), {{"static"}}));
  if (!below) return std::nullopt;
  Parts full = {{"stages"}, path[2]};
  full.insert(full.end(), below->begin(), below->end());
  return full;
}

bool is_root(const std::string& name) {
  return ranges::any_of(parsed_rows(),
                        [&](const ParsedRow& row) { return !row.object.empty() && row.object.front().text == name; });
}

std::vector<Parts> by_kind(const Parts& object);

/// Paths below a stage: the objects of a static analysis and the stage's own members.
std::vector<Parts> by_kind_in_stage(const Parts& object) {
  const Parts full = replaced(object, {{"stages"}, {"*", true}}, stage_pattern());
  if (object.size() == 2 || !is_root(object[2].text)) return {full};
  std::vector<Parts> paths;
  for (const Parts& path : by_kind({object.begin() + 2, object.end()})) {
    if (path.front().text == "static") {
      paths.push_back(replaced(path, {{"static"}}, {full.begin(), full.begin() + 3}));
    }
  }
  return paths;
}

std::vector<Parts> by_kind(const Parts& object) {
  if (object.front().text == "stages" && object.size() > 1) return by_kind_in_stage(object);
  std::vector<Parts> paths;
  for (const ParsedRow& row : parsed_rows()) {
    if (row.object.empty() || !begins_with(object, row.object)) continue;
    Parts path = replaced(object, row.object, row.path);
    if (find_row(path) == &row) paths.push_back(std::move(path));
  }
  return paths;
}

/// Converts "static.supports[].reaction" to "static.supports[*].reaction", and back.
std::string with_items(std::string path, std::string_view from, std::string_view to) {
  for (std::size_t place = path.find(from); place != std::string::npos; place = path.find(from, place)) {
    path.replace(place, from.size(), to);
  }
  return path;
}

}  // namespace

std::span<const ObjectRow> object_rows() {
  return kRows;
}

std::span<const ObjectLink> object_links() {
  return kLinks;
}

const ObjectRow* object_row(const std::string& path) {
  const std::optional<Parts> parts = split_result_path(path);
  const ParsedRow* row = parts ? find_row(*parts) : nullptr;
  return row != nullptr ? row->row : nullptr;
}

std::optional<std::string> object_path(const std::string& path) {
  const bool lists = path.find("[]") != std::string::npos;
  const std::optional<Parts> parts = split_result_path(lists ? with_items(path, "[]", "[*]") : path);
  const std::optional<Parts> object = parts ? by_object(*parts) : std::nullopt;
  if (!object) return std::nullopt;
  return lists ? with_items(join_result_path(*object), "[*]", "[]") : join_result_path(*object);
}

std::vector<std::string> summary_paths(const std::string& path) {
  std::optional<Parts> parts = split_result_path(path);
  if (parts && parts->size() > 1 && parts->front().text == "objects") parts->erase(parts->begin());
  if (!parts || !is_root(parts->front().text)) return {path};
  std::vector<std::string> names;
  for (const Parts& found : by_kind(*parts)) names.push_back(join_result_path(found));
  return names;
}

}  // namespace overbend
