/// What a stored quantity is: one description that the writer, the reader and the check for finite numbers share.
#pragma once

#include <string>

#include "results/static_results.h"

namespace overbend {

inline constexpr const char* kNoFrame = "none";
inline constexpr const char* kWorldFrame = "W: x east, y north, z up; origin midship at the mean water level";
inline constexpr const char* kBoxFrame =
    "box: longitudinal along the box axis astern, lateral to port, vertical is W z";

/// Name, unit, meaning and frame of a quantity.
struct ResultField {
  std::string name;
  std::string units = "1";
  std::string description = {};
  const char* frame = kNoFrame;
};

/// The name of one component of a vector: "normal_x"; a vector without a name gives "x".
inline std::string component_name(const ResultField& field, int axis) {
  const std::string letter(1, "xyz"[axis]);
  return field.name.empty() ? letter : field.name + "_" + letter;
}

inline const char* word(Region region) {
  switch (region) {
    case Region::tower:
      return "tower";
    case Region::overbend:
      return "overbend";
    case Region::sagbend:
      return "sagbend";
    case Region::seabed:
      break;
  }
  return "seabed";
}

inline const char* word(CheckStatus status) {
  constexpr const char* kWords[] = {"passed", "exceeded", "outside validity", "not done"};
  return kWords[static_cast<int>(status)];
}

inline const char* word(CheckRegion region) {
  constexpr const char* kWords[] = {"line", "overbend", "stinger tip", "sagbend", "seabed", "tower"};
  return kWords[static_cast<int>(region)];
}

/// Back from the word; false where there is no such word.
inline bool from_word(const std::string& text, Region& region) {
  for (const Region candidate : {Region::tower, Region::overbend, Region::sagbend, Region::seabed}) {
    if (text == word(candidate)) {
      region = candidate;
      return true;
    }
  }
  return false;
}

inline bool from_word(const std::string& text, RollerPosition& position) {
  for (const RollerPosition candidate : {RollerPosition::bottom, RollerPosition::port, RollerPosition::starboard}) {
    if (text == word(candidate)) {
      position = candidate;
      return true;
    }
  }
  return false;
}

inline bool from_word(const std::string& text, CheckStatus& status) {
  for (const CheckStatus candidate :
       {CheckStatus::passed, CheckStatus::exceeded, CheckStatus::outside_validity, CheckStatus::not_done}) {
    if (text == word(candidate)) {
      status = candidate;
      return true;
    }
  }
  return false;
}

inline bool from_word(const std::string& text, CheckRegion& region) {
  for (const CheckRegion candidate : {CheckRegion::line, CheckRegion::overbend, CheckRegion::tip, CheckRegion::sagbend,
                                      CheckRegion::seabed, CheckRegion::tower}) {
    if (text == word(candidate)) {
      region = candidate;
      return true;
    }
  }
  return false;
}

}  // namespace overbend
