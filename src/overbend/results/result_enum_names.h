/// Names of the enumerators of results.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "results/static_results.h"
#include "results/verdict.h"

namespace overbend {

template <class Enum>
struct ResultEnumNames;  // `list`: every enumerator with its name

template <class Enum, std::size_t N>
using ResultEnumNameList = std::array<std::pair<Enum, const char*>, N>;

template <>
struct ResultEnumNames<Region> {
  static constexpr ResultEnumNameList<Region, 4> list = {{{Region::tower, "tower"},
                                                          {Region::overbend, "overbend"},
                                                          {Region::sagbend, "sagbend"},
                                                          {Region::seabed, "seabed"}}};
};

template <>
struct ResultEnumNames<CheckStatus> {
  static constexpr ResultEnumNameList<CheckStatus, 4> list = {{{CheckStatus::passed, "passed"},
                                                               {CheckStatus::exceeded, "exceeded"},
                                                               {CheckStatus::outside_validity, "outside validity"},
                                                               {CheckStatus::not_done, "not done"}}};
};

template <>
struct ResultEnumNames<Confirmation> {
  static constexpr ResultEnumNameList<Confirmation, 4> list = {{{Confirmation::not_needed, "not needed"},
                                                                {Confirmation::two_sources, "two or more sources"},
                                                                {Confirmation::one_source, "one source"},
                                                                {Confirmation::unconfirmed, "unconfirmed"}}};
};

template <>
struct ResultEnumNames<CheckRegion> {
  static constexpr ResultEnumNameList<CheckRegion, 6> list = {{{CheckRegion::line, "line"},
                                                               {CheckRegion::overbend, "overbend"},
                                                               {CheckRegion::tip, "stinger tip"},
                                                               {CheckRegion::sagbend, "sagbend"},
                                                               {CheckRegion::seabed, "seabed"},
                                                               {CheckRegion::tower, "tower"}}};
};

template <>
struct ResultEnumNames<RollerPosition> {
  static inline const ResultEnumNameList<RollerPosition, 3> list = {
      {{RollerPosition::bottom, word(RollerPosition::bottom)},
       {RollerPosition::port, word(RollerPosition::port)},
       {RollerPosition::starboard, word(RollerPosition::starboard)}}};
};

template <>
struct ResultEnumNames<Structure> {
  static constexpr ResultEnumNameList<Structure, 2> list = {
      {{Structure::ramp, "ramp"}, {Structure::stinger, "stinger"}}};
};

template <>
struct ResultEnumNames<VerdictKind> {
  static constexpr ResultEnumNameList<VerdictKind, 4> list = {{{VerdictKind::passed, "passed"},
                                                               {VerdictKind::reserved, "reserved"},
                                                               {VerdictKind::exceeded, "exceeded"},
                                                               {VerdictKind::not_judged, "not judged"}}};
};

template <class Enum>
concept HasResultEnumNames = requires {
  ResultEnumNames<Enum>::list;
};

template <HasResultEnumNames Enum>
const char* word(Enum value) {
  for (const auto& [known, text] : ResultEnumNames<Enum>::list) {
    if (known == value) return text;
  }
  return "";
}

/// Sets the enumerator by its name; returns false if there is no such name.
template <HasResultEnumNames Enum>
bool from_enum_name(std::string_view text, Enum& value) {
  for (const auto& [known, its_word] : ResultEnumNames<Enum>::list) {
    if (text == its_word) {
      value = known;
      return true;
    }
  }
  return false;
}

}  // namespace overbend
