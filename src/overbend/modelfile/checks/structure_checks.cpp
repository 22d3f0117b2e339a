#include <cmath>

#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

void check_weight(Checker& check, const FieldValue& structure) {
  const FieldValue* submerged = structure.find("weight_submerged");
  const auto in_air = structure.get_number("weight_in_air");
  if (submerged != nullptr && in_air && submerged->number > *in_air) {
    check.error(*submerged, submerged->shown, "at most its weight in air");
  }
}

/// Checks that two structures do not overlap; they may touch.
void check_apart(Checker& check, const FieldValue& first, const FieldValue& second, const std::string& second_name) {
  const FieldValue* position = first.find("at");
  const auto other_at = second.get_number("at");
  if (position == nullptr || !other_at) return;
  const double lengths = first.get_number("length").value_or(0.0) + second.get_number("length").value_or(0.0);
  if (std::abs(position->number - *other_at) < 0.5 * lengths * (1.0 - 1e-9)) {
    check.error(*position, position->shown, "a position that does not overlap '" + second_name + "'");
  }
}

/// Checks that clumps and buoys are between the tensioner and the end of the pipe.
void check_points(Checker& check, const FieldValue& pipe) {
  const std::vector<FieldValue>& points = Checker::items(pipe, "points");
  check_unique_names(check, points, "point");
  const auto length = pipe.get_number("length");
  for (const FieldValue& point : points) {
    const FieldValue* place = point.find("arc_length");
    if (place == nullptr) continue;
    if (place->number <= 0.0) check.error(*place, place->shown, "more than 0 m", "the tensioner holds the pipe there");
    if (length && place->number >= *length) {
      check.error(*place, place->shown, "less than the length of the pipe, " + format_quantity(*length, "m", "m"));
    }
  }
}

void check_passage(Checker& check, const std::vector<std::string>& names) {
  const FieldValue* operation = check.root().find("operation");
  if (operation == nullptr) return;
  const FieldValue* structure = operation->find("structure");
  const bool passage = operation->get_word<OperationType>("type") == OperationType::passage;
  if (structure != nullptr && structure->given) {
    if (!passage) check.error(*structure, "a key of passage", "none in this type of operation");
    check_name(check, *structure, names, "pipe.structures");
  } else if (passage) {
    check.missing(*operation, "structure", "the name of a structure under pipe.structures",
                  "the structure that moves along the line");
  }
}

}  // namespace

void check_structures(Checker& check) {
  const FieldValue* pipe = check.root().find("pipe");
  if (pipe == nullptr) return;
  const std::vector<FieldValue>& structures = Checker::items(*pipe, "structures");
  check_unique_names(check, structures, "structure");
  std::vector<std::string> names;
  for (const FieldValue& structure : structures) {
    names.push_back(structure.get_text("name").value_or("structure " + std::to_string(names.size() + 1)));
    check_weight(check, structure);
    for (std::size_t i = 0; i + 1 < names.size(); ++i) check_apart(check, structure, structures[i], names[i]);
  }
  check_passage(check, names);
  check_points(check, *pipe);
}

}  // namespace overbend
