#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

const std::vector<std::string>& end_kinds() {
  static const std::vector<std::string> kKinds = {"fixed", "body", "bed", "water"};
  return kKinds;
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

void check_end(Checker& check, const FieldValue& end) {
  std::vector<std::string> given;
  for (const std::string& kind : end_kinds()) {
    if (end.mentions(kind)) given.push_back(kind);
  }
  if (given.size() != 1) {
    check.error(end, given.empty() ? "none of fixed, body, bed and water" : join_words(given, "and"),
                one_of(end_kinds()));
    return;
  }
  const bool body = given.front() == "body";
  const FieldValue* at = end.find("at");
  if (body && !end.mentions("at")) check.missing(end, "at", "the point of the body that holds the end: x, y and z");
  if (!body && at != nullptr) check.error(*at, "a point of a body", "no 'at' for an end that is on no body");
  if (body && end.find("motion") != nullptr && end.find("motion")->given) {
    check.error(*end.find("motion"), "a prescribed motion", "none for an end on a body", "it moves with the body");
  }
  if (body && !is_given(check.root(), "vessel")) {
    check.missing(check.root(), "vessel", "a group of keys", "an end of a line is on it");
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
    for (const FieldValue& end : Checker::items(line, "ends")) check_end(check, end);
  }
}

}  // namespace overbend
