#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

const std::vector<std::string>& end_kinds() {
  static const std::vector<std::string> kKinds = {"fixed", "body", "bed", "water", "free", "line"};
  return kKinds;
}

const FieldValue* find_line(const FieldValue& root, const std::string& name) {
  const std::vector<FieldValue>& lines = Checker::items(root, "lines");
  const std::vector<std::string> names = line_names(lines);
  const auto found = ranges::find(names, name);
  return found == names.end() ? nullptr : &lines[static_cast<std::size_t>(found - names.begin())];
}

/// Returns true if a line is attached to another, directly or through other lines.
bool is_attached_to(const FieldValue& root, const FieldValue& line, const FieldValue& target, int depth = 0) {
  constexpr int kMaxDepth = 100;
  for (const FieldValue& end : Checker::items(line, "ends")) {
    const FieldValue* name = end.find("line");
    const FieldValue* on = name == nullptr ? nullptr : find_line(root, name->text);
    if (on == &target) return true;
    if (on != nullptr && on != &line && depth < kMaxDepth && is_attached_to(root, *on, target, depth + 1)) return true;
  }
  return false;
}

void check_place(Checker& check, const FieldValue& end) {
  const auto depth = level_bed(check.root());
  const FieldValue* fixed = end.find("fixed.z");
  if (fixed != nullptr && depth && fixed->number < -*depth * (1.0 + 1e-12)) {
    check.error(*fixed, fixed->shown, "at or above the seabed, " + format_quantity(-*depth, "m", "m"));
  }
  const FieldValue* water = end.find("water.z");
  if (water != nullptr && depth && (water->number >= 0.0 || water->number <= -*depth)) {
    check.error(*water, water->shown, "below 0 m and above the seabed, " + format_quantity(-*depth, "m", "m"),
                "use fixed for an end in the air, bed for one on the seabed");
  }
}

/// Returns the length of a line if all its segments have one.
std::optional<double> compute_line_length(const FieldValue& line) {
  if (const auto length = line.get_number("length")) return length;
  double sum = 0.0;
  const std::vector<FieldValue>& segments = Checker::items(line, "segments");
  for (const FieldValue& segment : segments) {
    const auto length = segment.get_number("length");
    if (!length) return std::nullopt;
    sum += *length;
  }
  return segments.empty() ? std::nullopt : std::optional(sum);
}

/// Returns true if a line has a single type without weight.
bool is_wire(const FieldValue& root, const FieldValue& line) {
  const FieldValue* type = line.find("type");
  const FieldValue* numbers = type == nullptr ? nullptr : root.find("moorings.types." + type->text);
  return numbers != nullptr && numbers->get_number("weight_in_air") == 0.0;
}

/// Checks that an attachment is not at an end of the line that is held.
void check_not_held(Checker& check, const FieldValue& line, const FieldValue& place, std::optional<double> length) {
  constexpr double kSameNode = 0.02;  // [m]
  const std::vector<FieldValue>& ends = Checker::items(line, "ends");
  for (std::size_t i = 0; i < ends.size() && ends.size() == 2; ++i) {
    const bool at_end = i == 0 ? place.number < kSameNode : length && std::abs(*length - place.number) < kSameNode;
    if (!at_end || ends[i].mentions("free")) continue;
    check.error(place, place.shown + ", which is the held end of that line", "a point between its ends, or a free end");
  }
}

/// Checks that a point on the laid pipe is between the tensioner and the pipe's end.
void check_on_pipe(Checker& check, const FieldValue& end) {
  const FieldValue* place = end.find("arc_length");
  if (place == nullptr) return;
  const auto length = check.root().get_number("pipe.length");
  if (place->number <= 0.0) check.error(*place, place->shown, "more than 0 m", "the tensioner holds the pipe there");
  if (length && place->number >= *length) {
    check.error(*place, place->shown, "less than the length of the pipe, " + format_quantity(*length, "m", "m"));
  }
}

/// Checks an end on another line: the line exists, is a different one, is not attached to this line in turn, and is
/// long enough.
void check_link(Checker& check, const FieldValue& line, const FieldValue& end) {
  const FieldValue* name = end.find("line");
  const FieldValue* place = end.find("arc_length");
  if (!end.mentions("arc_length")) {
    check.missing(end, "arc_length", "a length with its unit", "arc length on the other line");
  }
  if (name == nullptr) return;
  if (name->text == "pipe" && is_given(check.root(), "pipe")) return check_on_pipe(check, end);
  const FieldValue* target = find_line(check.root(), name->text);
  if (target == nullptr) {
    std::vector<std::string> known = line_names(Checker::items(check.root(), "lines"));
    if (is_given(check.root(), "pipe")) known.emplace_back("pipe");
    check_name(check, *name, known, "lines");
    return;
  }
  if (target == &line) {
    check.error(*name, "the line itself, " + name->shown, "the name of another line");
    return;
  }
  if (is_attached_to(check.root(), *target, line)) {
    check.error(*name, name->shown + ", which is attached to this line in turn",
                "a line that is not attached to this one");
  }
  if (is_wire(check.root(), *target)) {
    check.error(*name, name->shown + ", a straight wire without weight", "a line with weight",
                "nothing can be attached between its ends");
  }
  const auto length = compute_line_length(*target);
  if (place != nullptr) check_not_held(check, *target, *place, length);
  if (place != nullptr && length && place->number > *length) {
    check.error(*place, place->shown,
                "at most the length of '" + name->text + "', " + format_quantity(*length, "m", "m"));
  }
}

bool is_free(const FieldValue& end) {
  return end.mentions("free");
}

/// Checks that a line with two free ends has a start position, since only its attachments hold it.
void check_free_ends(Checker& check, const FieldValue& line) {
  const std::vector<FieldValue>& ends = Checker::items(line, "ends");
  if (ends.size() != 2 || !is_free(ends[0]) || !is_free(ends[1]) || line.mentions("start")) return;
  check.missing(line, "start", "x and y of its first end", "both its ends are free, so its position is not determined");
}

void check_body_name(Checker& check, const FieldValue& name) {
  std::vector<std::string> known = body_names(check.root());
  known.insert(known.begin(), kVesselName);
  check_name(check, name, known, "bodies");
}

void check_end(Checker& check, const FieldValue& line, const FieldValue& end) {
  std::vector<std::string> kinds;
  for (const std::string& kind : end_kinds()) {
    if (end.mentions(kind)) kinds.push_back(kind);
  }
  if (kinds.size() != 1) {
    check.error(end, kinds.empty() ? "none of " + join_items(end_kinds(), "and") : join_items(kinds, "and"),
                join_choices(end_kinds()));
    return;
  }
  if (kinds.front() == "line") check_link(check, line, end);
  const bool body = kinds.front() == "body";
  const FieldValue* point = end.find("at");
  if (body && !end.mentions("at")) check.missing(end, "at", "the point of the body that holds the end: x, y and z");
  if (!body && point != nullptr) check.error(*point, "a point of a body", "no 'at' for an end that is not on a body");
  if (body && end.find("motion") != nullptr && end.find("motion")->given) {
    check.error(*end.find("motion"), "a prescribed motion", "none for an end on a body", "it moves with the body");
  }
  const FieldValue* name = end.find("body");
  const bool vessel = name != nullptr && name->text == kVesselName;
  if (body && name != nullptr && !vessel) check_body_name(check, *name);
  if (vessel && !is_given(check.root(), "vessel")) {
    check.missing(check.root(), "vessel", "a group of keys", "line ends are attached to it");
  }
  const FieldValue* direction = end.find("direction");
  if (direction != nullptr && direction->given) {
    double size = 0.0;
    for (const char* key : {"x", "y", "z"}) size += std::abs(direction->get_number(key).value_or(0.0));
    if (size == 0.0) check.error(*direction, "a direction of no length", "x, y or z other than 0");
  }
  check_place(check, end);
}

}  // namespace

void check_free_lines(Checker& check, std::set<std::string>& used_types) {
  const std::vector<FieldValue>& lines = Checker::items(check.root(), "lines");
  check_unique_names(check, lines, "line");
  for (const FieldValue& line : lines) {
    check_line_body(check, line, "", used_types);
    for (const FieldValue& end : Checker::items(line, "ends")) check_end(check, line, end);
    check_free_ends(check, line);
  }
}

}  // namespace overbend
