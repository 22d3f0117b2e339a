#include <algorithm>
#include <cmath>
#include <map>

#include "base/ranges.h"
#include "base/text.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

const FieldValue* find_end(const FieldValue& line, std::size_t which) {
  const std::vector<FieldValue>& ends = Checker::items(line, "ends");
  return which < ends.size() ? &ends[which] : nullptr;
}

bool is_pipe(const FieldValue& line) {
  return ranges::any_of(Checker::items(line, "segments"),
                        [](const FieldValue& segment) { return segment.mentions("steel"); });
}

/// Checks that lines whose length or tension a stage gives exist and are not pipe.
void check_values(Checker& check, const FieldValue& stage, const char* key) {
  const FieldValue* values = stage.find(key);
  if (values == nullptr) return;
  const std::vector<FieldValue>& lines = Checker::items(check.root(), "lines");
  const std::vector<std::string> names = line_names(lines);
  for (const FieldValue& value : values->children) {
    const auto found = ranges::find(names, value.key);
    if (found == names.end()) {
      const std::string near = nearest_word(value.key, names);
      check.error(value, "the unknown line '" + for_display(value.key) + "'", join_choices(names),
                  near.empty() ? "" : "did you mean '" + near + "'?");
    } else if (is_pipe(lines[static_cast<std::size_t>(found - names.begin())])) {
      check.error(value, "a " + std::string(key == std::string("lengths") ? "length" : "tension") + " of pipe",
                  "one of a line without steel", "pipe has no winch of its own");
    }
  }
}

/// Checks that bodies moved by a stage exist, and that the vessel does not float freely.
void check_moves(Checker& check, const FieldValue& stage) {
  const FieldValue* vessel = stage.find("vessel");
  if (vessel != nullptr && vessel->given && hull_floats(check.root())) {
    check.error(*vessel, "a position of a free-floating vessel", "none: lines and water determine it",
                "or hold it: omit vessel.hydrostatics or vessel.motion.coupled");
  }
  const FieldValue* bodies = stage.find("bodies");
  if (bodies == nullptr) return;
  const std::vector<std::string> names = body_names(check.root());
  for (const FieldValue& body : bodies->children) {
    if (ranges::find(names, body.key) != names.end()) continue;
    const std::string near = nearest_word(body.key, names);
    check.error(body, "the unknown body '" + for_display(body.key) + "'",
                names.empty() ? "a name under bodies" : join_choices(names),
                near.empty() ? "" : "did you mean '" + near + "'?");
  }
}

void check_one_way(Checker& check, const FieldValue& stage) {
  const FieldValue *lengths = stage.find("lengths"), *tensions = stage.find("tensions");
  if (lengths == nullptr || tensions == nullptr) return;
  for (const FieldValue& tension : tensions->children) {
    for (const FieldValue& length : lengths->children) {
      if (length.key == tension.key) {
        check.error(tension, "a length and a tension of '" + for_display(tension.key) + "'", "one of them");
      }
    }
  }
}

/// Returns the outside diameter of the steel at the first end of a line.
const FieldValue* first_diameter(const FieldValue& line) {
  const std::vector<FieldValue>& segments = Checker::items(line, "segments");
  return segments.empty() ? nullptr : segments.front().find("steel.outside_diameter");
}

/// Checks that pipes welded end to end have the same diameter.
void check_sections(Checker& check, const FieldValue& join, const FieldValue& first, const FieldValue& second) {
  constexpr double kSame = 0.02;
  for (const FieldValue* line : {&first, &second}) {
    const std::vector<FieldValue>& segments = Checker::items(*line, "segments");
    if (segments.empty() || segments.front().mentions("steel")) continue;
    check.error(join, "the first segment of '" + line->get_text("name").value_or("") + "', which is not pipe",
                "lines whose first segments are pipe", "only pipe can be welded");
  }
  const FieldValue *a = first_diameter(first), *b = first_diameter(second);
  if (a == nullptr || b == nullptr || std::abs(a->number - b->number) <= kSame * a->number) return;
  check.error(join, "pipes of " + a->shown + " and " + b->shown, "pipes of one outside diameter",
              "reducers are not supported");
}

/// Checks that nothing else is attached at the welded end of a line.
void check_weld_attachments(Checker& check, const FieldValue& name) {
  constexpr double kSameNode = 0.02;  // [m]
  for (const FieldValue& other_line : Checker::items(check.root(), "lines")) {
    for (const FieldValue& end : Checker::items(other_line, "ends")) {
      const auto place = end.get_number("arc_length");
      if (end.get_text("line") != name.text || !place || *place >= kSameNode) continue;
      check.error(name,
                  name.shown + ", at whose first end '" + other_line.get_text("name").value_or("another line") +
                      "' is attached",
                  "a line with nothing attached at its first end", "attach it next to the weld");
    }
  }
}

/// Checks a weld: the free first ends of two pipes that are not welded yet.
void check_join(Checker& check, const FieldValue& stage, std::map<std::string, int>& joined) {
  const FieldValue* join = stage.find("join");
  if (join == nullptr || !join->given) return;
  const std::vector<FieldValue>& names = Checker::items(*join, "lines");
  if (names.size() != 2) {
    check.error(*join, std::to_string(names.size()) + " lines", "the names of two lines");
    return;
  }
  const std::vector<FieldValue>& lines = Checker::items(check.root(), "lines");
  const std::vector<std::string> known = line_names(lines);
  if (names[0].text == names[1].text) check.error(names[1], "the same line again", "the name of another line");
  std::vector<const FieldValue*> welded;
  for (const FieldValue& name : names) {
    const auto found = ranges::find(known, name.text);
    if (found == known.end()) {
      check_name(check, name, known, "lines");
      continue;
    }
    const FieldValue& line = lines[static_cast<std::size_t>(found - known.begin())];
    welded.push_back(&line);
    const FieldValue* end = find_end(line, 0);
    if (!is_pipe(line)) {
      check.error(name, "a line without steel, " + name.shown, "pipe", "only pipe can be welded");
    } else if (end != nullptr && !end->mentions("free")) {
      check.error(name, name.shown + ", whose first end is held", "a line whose first end is free");
    }
    check_weld_attachments(check, name);
    const auto [before, fresh] = joined.emplace(name.text, name.line);
    if (!fresh) {
      check.error(name, name.shown + " again", "a line that is not welded yet",
                  "it was joined in line " + std::to_string(before->second));
    }
  }
  if (welded.size() == 2) check_sections(check, *join, *welded[0], *welded[1]);
}

}  // namespace

void check_lift(Checker& check, const FieldValue& operation) {
  if (Checker::items(check.root(), "lines").empty()) {
    check.missing(check.root(), "lines", "a list of lines", "a lift acts on lines");
  }
  const FieldValue* stages = operation.find("stages");
  if (!operation.mentions("stages") || (stages != nullptr && !stages->given)) {
    check.missing(operation, "stages", "a list of stages", "a lift requires it");
    return;
  }
  if (stages == nullptr) return;
  if (stages->kind == FieldValue::Kind::map) {
    check.error(*stages, "evenly spaced stages", "a list of stages",
                "stages are generated from lengths of a laid line only");
    return;
  }
  if (stages->children.empty()) check.error(*stages, "an empty list", "at least one stage");
  std::map<std::string, int> joined;
  for (const FieldValue& stage : stages->children) {
    check_values(check, stage, "lengths");
    check_values(check, stage, "tensions");
    check_one_way(check, stage);
    check_moves(check, stage);
    check_join(check, stage, joined);
  }
}

}  // namespace overbend
