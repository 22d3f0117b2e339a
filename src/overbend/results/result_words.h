/// The words of the enumerations of results, each beside its enumerator.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "results/static_results.h"
#include "results/verdict.h"

namespace overbend {

template <class Enum>
struct Words;  // `list`: every enumerator with its word

template <class Enum, std::size_t N>
using WordList = std::array<std::pair<Enum, const char*>, N>;

template <>
struct Words<Region> {
  static constexpr WordList<Region, 4> list = {{{Region::tower, "tower"},
                                                {Region::overbend, "overbend"},
                                                {Region::sagbend, "sagbend"},
                                                {Region::seabed, "seabed"}}};
};

template <>
struct Words<CheckStatus> {
  static constexpr WordList<CheckStatus, 4> list = {{{CheckStatus::passed, "passed"},
                                                     {CheckStatus::exceeded, "exceeded"},
                                                     {CheckStatus::outside_validity, "outside validity"},
                                                     {CheckStatus::not_done, "not done"}}};
};

template <>
struct Words<Confirmation> {
  static constexpr WordList<Confirmation, 4> list = {{{Confirmation::not_needed, "not needed"},
                                                      {Confirmation::two_sources, "two or more sources"},
                                                      {Confirmation::one_source, "one source"},
                                                      {Confirmation::unconfirmed, "unconfirmed"}}};
};

template <>
struct Words<CheckRegion> {
  static constexpr WordList<CheckRegion, 6> list = {{{CheckRegion::line, "line"},
                                                     {CheckRegion::overbend, "overbend"},
                                                     {CheckRegion::tip, "stinger tip"},
                                                     {CheckRegion::sagbend, "sagbend"},
                                                     {CheckRegion::seabed, "seabed"},
                                                     {CheckRegion::tower, "tower"}}};
};

template <>
struct Words<RollerPosition> {
  static inline const WordList<RollerPosition, 3> list = {
      {{RollerPosition::bottom, word(RollerPosition::bottom)},
       {RollerPosition::port, word(RollerPosition::port)},
       {RollerPosition::starboard, word(RollerPosition::starboard)}}};
};

template <>
struct Words<Structure> {
  static constexpr WordList<Structure, 2> list = {{{Structure::ramp, "ramp"}, {Structure::stinger, "stinger"}}};
};

template <>
struct Words<VerdictKind> {
  static constexpr WordList<VerdictKind, 4> list = {{{VerdictKind::passed, "passed"},
                                                     {VerdictKind::reserved, "reserved"},
                                                     {VerdictKind::exceeded, "exceeded"},
                                                     {VerdictKind::not_judged, "not judged"}}};
};

template <class Enum>
concept HasResultWords = requires {
  Words<Enum>::list;
};

template <HasResultWords Enum>
const char* word(Enum value) {
  for (const auto& [known, text] : Words<Enum>::list) {
    if (known == value) return text;
  }
  return "";
}

/// Back from the word; false where there is no such word.
template <HasResultWords Enum>
bool from_word(std::string_view text, Enum& value) {
  for (const auto& [known, its_word] : Words<Enum>::list) {
    if (text == its_word) {
      value = known;
      return true;
    }
  }
  return false;
}

}  // namespace overbend
