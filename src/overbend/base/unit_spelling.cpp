#include "base/unit_spelling.h"

#include <algorithm>
#include <iterator>
#include <span>

namespace overbend {
namespace {

struct Spelling {
  std::string_view written, replacement;
};

/// A replacement of several units followed by a power ends in the unit that takes the power: "kNm2" is kN m^2.
constexpr Spelling kSpellings[] = {{"deg", "degree"},
                                   {"degs", "degree"},
                                   {"te", "tonne"},
                                   {"Te", "tonne"},
                                   {"mt", "tonne"},
                                   {"mT", "tonne"},
                                   {"MT", "tonne"},
                                   {"tf", "(9806.65 N)"},
                                   {"tef", "(9806.65 N)"},
                                   {"mtf", "(9806.65 N)"},
                                   {"tonf", "(9806.65 N)"},
                                   {"klbf", "kip"},
                                   {"lbs", "lb"},
                                   {"klbs", "klb"},
                                   {"psf", "(lbf/ft^2)"},
                                   {"pcf", "(lbf/ft^3)"},
                                   {"ksf", "(kip/ft^2)"},
                                   {"kn", "knot"},
                                   {"nmi", "nautical_mile"},
                                   {"NM", "nautical_mile"},
                                   {"hrs", "h"},
                                   {"mins", "min"},
                                   {"Nm", "N.m"},
                                   {"kNm", "kN.m"},
                                   {"MNm", "MN.m"},
                                   {"Ns", "N.s"},
                                   {"kNs", "kN.s"},
                                   {"nm", "?"}};

struct Remark {
  std::string_view unit, text;
};

constexpr Remark kAmbiguous[] = {
    {"ton", "'ton' is taken as the US short ton of 907.18 kg; write t for the metric tonne"},
    {"tons", "'tons' is taken as the US short ton of 907.18 kg; write t for the metric tonne"},
    {"tonf", "'tonf' is taken as the metric tonne-force of 9.80665 kN; write kip or lbf for a short ton-force"}};

constexpr Remark kHints[] = {{"nm", "nm is a nanometre; write nmile for nautical miles"},
                             {"\"", "write in for inches"},
                             {"'", "write ft for feet"},
                             {"\u2033", "write in for inches"},
                             {"\u2032", "write ft for feet"},
                             {"T", "T is a tesla; write t for tonnes, tf for their weight"},
                             {"M", "write m for metres"}};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

std::string_view replacement(std::string_view name) {
  const auto known =
      std::find_if(std::begin(kSpellings), std::end(kSpellings), [&](const Spelling& s) { return s.written == name; });
  return known == std::end(kSpellings) ? name : known->replacement;
}

/// Calls `take` with every run of letters and with the text between them.
template <typename Take>
void for_each_part(std::string_view unit, const Take& take) {
  for (std::size_t from = 0, to = 0; from < unit.size(); from = to) {
    const bool letters = is_letter(unit[from]);
    while (to < unit.size() && is_letter(unit[to]) == letters) ++to;
    take(unit.substr(from, to - from), letters);
  }
}

std::string_view text_for(std::span<const Remark> remarks, std::string_view part) {
  const auto known = std::find_if(remarks.begin(), remarks.end(), [&](const Remark& r) { return r.unit == part; });
  return known == remarks.end() ? std::string_view() : known->text;
}

}  // namespace

std::string udunits_spelling(std::string_view unit) {
  std::string spelled;
  for_each_part(unit, [&](std::string_view part, bool letters) { spelled += letters ? replacement(part) : part; });
  constexpr std::string_view kDot = "\u22c5";  // the dot operator, which UDUNITS-2 does not support
  for (std::size_t i = spelled.find(kDot); i != std::string::npos; i = spelled.find(kDot)) {
    spelled.replace(i, kDot.size(), ".");
  }
  return spelled;
}

std::string ambiguity_remark(std::string_view unit) {
  std::string remark;
  for_each_part(unit, [&](std::string_view part, bool letters) {
    if (letters && remark.empty()) remark = text_for(kAmbiguous, part);
  });
  return remark;
}

std::string spelling_hint(std::string_view unit) {
  return std::string(text_for(kHints, unit));
}

}  // namespace overbend
