// Units are compared with UDUNITS-2 itself: what is a unit, its definition in base units, the bits of its scale.
#include "base/unit_parser.h"

#include <gtest/gtest.h>
#include <udunits2.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/text.h"

namespace overbend {
namespace {

/// Unit in base units, "0.3048 m" or "K @ 273.15", and its exact scale if it has no offset. A unit relative to a date
/// is as good as unknown: no value has it.
struct UnitMeaning {
  std::string definition = "none";
  double scale = 1.0;
};

std::string base_units(const ParsedUnit& unit) {
  constexpr std::array<const char*, kBaseUnits> kSymbols = {"m", "kg", "s", "A", "K", "mol", "cd", "rad"};
  std::string text;
  for (int base = 0; base < kBaseUnits; ++base) {
    if (unit.powers[base] == 0) continue;
    text += (text.empty() ? "" : ".") + std::string(kSymbols[base]);
    if (unit.powers[base] != 1) text += std::to_string(unit.powers[base]);
  }
  return text.empty() ? "1" : text;
}

std::string number_text(const char* format, double number) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, number);
  return buffer.data();
}

UnitMeaning parsed_meaning(const std::string& text) {
  const std::optional<ParsedUnit> unit = parse_unit(text);
  if (!unit || std::isnan(unit->offset)) return {};
  if (unit->logarithmic) return {"logarithmic"};
  const std::string scale = unit->scale == 1.0 ? "" : number_text("%.15g ", unit->scale);
  const std::string offset = unit->offset == 0.0 ? "" : number_text(" @ %.15g", unit->offset);
  return {scale + base_units(*unit) + offset, unit->is_scale() ? unit->scale : 1.0};
}

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
  void operator()(ut_system* system) const { ut_free_system(system); }
  void operator()(cv_converter* converter) const { cv_free(converter); }
};

class Udunits {
 public:
  Udunits() {
    ut_set_error_message_handler(ut_ignore);
    system_.reset(ut_read_xml((std::string(OVERBEND_UNIT_FILES) + "/udunits2.xml").c_str()));
  }

  UnitMeaning meaning(const std::string& text) {
    const std::unique_ptr<ut_unit, FreeUnit> unit(ut_parse(system_.get(), text.c_str(), UT_UTF8));
    if (!unit) return {};
    std::array<char, 1024> buffer{};
    ut_format(unit.get(), buffer.data(), buffer.size() - 1, UT_DEFINITION | UT_ASCII);
    const std::string definition = buffer.data();
    if (definition.ends_with(" UTC")) return {};
    if (definition.find("(re ") != std::string::npos) return {"logarithmic"};
    if (definition.find('@') != std::string::npos) return {definition};
    return {definition, scale(unit.get(), definition.substr(definition.find(' ') + 1))};
  }

 private:
  double scale(ut_unit* unit, const std::string& base) {
    auto& target = targets_[base];
    if (!target) target.reset(ut_parse(system_.get(), base.c_str(), UT_ASCII));
    const std::unique_ptr<cv_converter, FreeUnit> converter(ut_get_converter(unit, target.get()));
    return converter ? cv_convert_double(converter.get(), 1.0) : std::nan("");
  }

  std::unique_ptr<ut_system, FreeUnit> system_;
  std::map<std::string, std::unique_ptr<ut_unit, FreeUnit>> targets_;  // by their base units
};

/// Compares texts and counts them.
class Comparison {
 public:
  explicit Comparison(int min_texts) : min_texts_(min_texts) {}
  ~Comparison() {
    EXPECT_EQ(different_, 0) << "of " << texts_;
    EXPECT_GE(texts_, min_texts_);
  }
  Comparison(const Comparison&) = delete;
  Comparison& operator=(const Comparison&) = delete;

  void add(const std::string& text) {
    ++texts_;
    const UnitMeaning expected = library_.meaning(text), parsed = parsed_meaning(text);
    const bool same_scale = parsed.scale == expected.scale || std::isnan(expected.scale);
    if (parsed.definition == expected.definition && same_scale) return;
    if (++different_ > 20) return;
    ADD_FAILURE() << "'" << text << "': " << parsed.definition << " for " << expected.definition << ", scale "
                  << number_text("%.17g", parsed.scale) << " for " << number_text("%.17g", expected.scale);
  }

 private:
  Udunits library_;
  int texts_ = 0, different_ = 0, min_texts_;
};

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t i = text.find(from); i != std::string::npos; i = text.find(from, i + to.size())) {
    text.replace(i, from.size(), to);
  }
}

/// Texts of the elements of a file, read without an XML parser.
std::set<std::string> element_texts(const std::string& file, const std::vector<std::string>& elements) {
  std::ifstream stream(std::string(OVERBEND_UNIT_FILES) + "/udunits2-" + file + ".xml");
  std::stringstream content;
  content << stream.rdbuf();
  std::string xml = content.str();
  const std::map<std::string, std::string> kCharacters = {
      {"&#xB0;", "\u00b0"},   {"&#xB5;", "\u00b5"},   {"&#xC5;", "\u00c5"},   {"&#xE5;", "\u00e5"},
      {"&#xF6;", "\u00f6"},   {"&#x3A9;", "\u03a9"},  {"&#x3BC;", "\u03bc"},  {"&#x3c0;", "\u03c0"},
      {"&#x2032;", "\u2032"}, {"&#x2033;", "\u2033"}, {"&#x2103;", "\u2103"}, {"&#x2109;", "\u2109"},
      {"&#x2126;", "\u2126"}, {"&#x212B;", "\u212b"}};
  for (const auto& [entity, character] : kCharacters) replace_all(xml, entity, character);
  std::set<std::string> texts;
  for (const std::string& element : elements) {
    for (std::size_t i = xml.find("<" + element); i != std::string::npos; i = xml.find("<" + element, i + 1)) {
      const std::size_t start = xml.find('>', i) + 1;
      const std::string text(trim(std::string_view(xml).substr(start, xml.find('<', start) - start)));
      if (!text.empty()) texts.insert(text);
    }
  }
  return texts;
}

/// Names and symbols of all units of the database.
std::vector<std::string> unit_names() {
  std::set<std::string> names;
  for (const char* file : {"base", "derived", "accepted", "common"}) {
    names.merge(element_texts(file, {"singular", "plural", "symbol"}));
  }
  return {names.begin(), names.end()};
}

std::vector<std::string> prefixes() {
  const std::set<std::string> texts = element_texts("prefixes", {"name", "symbol"});
  return {texts.begin(), texts.end()};
}

std::string upper_case(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

/// A name, its plurals, right and wrong, in capitals, and with no-break spaces.
std::set<std::string> forms(const std::string& name) {
  std::string spaced = name;
  replace_all(spaced, "_", "\u00a0");
  std::set<std::string> forms;
  for (const std::string& text : {name, spaced}) {
    forms.insert({text, text + "s", text + "es", text.substr(0, text.size() - 1) + "ies", upper_case(text)});
  }
  return forms;
}

TEST(unit_parser, agrees_with_udunits_on_every_name_with_every_prefix) {
  Comparison comparison(170000);
  for (const std::string& name : unit_names()) {
    for (const std::string& form : forms(name)) {
      comparison.add(form);
      for (const std::string& prefix : prefixes()) comparison.add(prefix + form);
    }
    for (const char* prefix : {"kilomega", "KILOk", "kk", "kmilli", "dam", "dak", "mM"}) comparison.add(prefix + name);
  }
}

TEST(unit_parser, agrees_with_udunits_on_powers) {
  Comparison comparison(20000);
  for (const std::string& name : unit_names()) {
    for (const char* power : {"0",    "1",    "2",      "-3",     "+2",           "^2",     "^-1",    "**3", "**-2",
                              "^255", "^256", "\u00b2", "\u00b3", "\u207b\u00b9", "\u2074", " 2",     "2.5", "e2",
                              "_2",   "(2)",  "^^2",    "^",      "2s",           "^2s",    "\u00b2s"}) {
      comparison.add(name + power);
      comparison.add("(k" + name + ")" + power);
    }
  }
}

TEST(unit_parser, agrees_with_udunits_on_products_and_quotients) {
  constexpr std::array<const char*, 8> kSigns = {".", "/", " ", "*", "\u00b7", " per ", "-", " / "};
  Comparison comparison(160000);
  const std::vector<std::string> names = unit_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = i % 2; j < names.size(); j += 2) comparison.add(names[i] + kSigns[(i + j) % 8] + names[j]);
    comparison.add(names[i] + "/" + names[i]);
    comparison.add("k" + names[i] + "2/(0.001 " + names[i] + ")3");
  }
}

TEST(unit_parser, agrees_with_udunits_on_shifts_and_logarithms) {
  Comparison comparison(20000);
  for (const std::string& name : unit_names()) {
    for (const char* shift : {" @ 273.15", " from 5", "@-3", " SINCE 1e3", " after 0", " ref .5 ", " since 1990", "@",
                              " @ 5T", " from 5 m", " from 5)", " @ 1e-16", " @ 459.67 K"}) {
      comparison.add(name + shift);
      comparison.add("1.8 (" + name + shift + ")");
    }
    for (const char* logarithm : {"lg(re ", "LOG(re ", "ln ( RE: 1e-3 ", "lb(re", "lg(re 20e-6 ", "log(re:", "lg("}) {
      comparison.add(logarithm + name + ")");
      comparison.add("0.1 " + (logarithm + name) + ") m");
    }
  }
}

TEST(unit_parser, agrees_with_udunits_on_malformed_texts) {
  Comparison comparison(120);
  for (const char* text : {"",
                           " ",
                           "m ",
                           " m",
                           "()",
                           "(m",
                           "m)",
                           "m))",
                           "(m))",
                           "((m))",
                           ")m",
                           "m()",
                           "m(",
                           "m//s",
                           "m/ /s",
                           "m..s",
                           "m.",
                           ".m",
                           "/m",
                           "m/",
                           "1/m",
                           "per m",
                           "m per",
                           "mper s",
                           "m per.s",
                           "mpers",
                           "2",
                           "0",
                           "0 m",
                           "1",
                           "-1 m",
                           "+2m",
                           "1e3m",
                           "1e3",
                           "1.e2m",
                           ".5m",
                           "5.m",
                           ".",
                           "..",
                           "1e400 m",
                           "1e-400 m",
                           "1e-310 m",
                           "0^0",
                           "m^0",
                           "(degC)^0",
                           "dBm^0",
                           "dBm dBm",
                           "2 dBm",
                           "dBm m",
                           "dBm rad",
                           "1/dBm",
                           "dBm^2",
                           "degC",
                           "degC m",
                           "degC/s",
                           "degC2",
                           "2 degC",
                           "mdegC",
                           "degC 1",
                           "1 degC",
                           "degF",
                           "degC from -273.15",
                           "'",
                           "\"",
                           "k'",
                           "m'",
                           "''",
                           "%",
                           "k%",
                           "%%",
                           "m%",
                           "m,s",
                           "m;s",
                           "m=s",
                           "m?",
                           "$",
                           "#m",
                           "m\t",
                           "m\ts",
                           "m  s",
                           "m * s",
                           "m ** s",
                           "m**2",
                           "m***2",
                           "m^+2",
                           "m^ 2",
                           "m 2 3",
                           "m2 3",
                           "m2+3",
                           "2+3",
                           "2-3",
                           "m-s",
                           "m-2",
                           "m--2",
                           "m+s",
                           "1e200 1e200 m",
                           "1e-200 1e-200 m",
                           "ym^20",
                           "km^255",
                           "m^255 m^255",
                           "\u00b5m",
                           "\u03bcm",
                           "m\u00b2",
                           "m\u2074",
                           "(m)\u2074",
                           "m\u207b\u00b9",
                           "\u00d7",
                           "m\u00d7s",
                           "m\u22c5s",
                           "m\u00b7s",
                           "\u0101",
                           "\u00e9m",
                           "\u00c5",
                           "\u03a9",
                           "\U0001f600",
                           "m\U0001f600",
                           "_m",
                           "m_",
                           "H2O",
                           "cmH2O",
                           "inH2O2",
                           "2H2O",
                           "lg",
                           "log(m)"}) {
    comparison.add(text);
  }
}

TEST(unit_parser, agrees_with_udunits_on_random_texts) {
  const std::vector<std::string> kParts = {"m",       "kg",      "s",
                                           "K",       "degC",    "N",
                                           "kN",      "Pa",      "ft",
                                           "lbf",     "foot",    "FEET",
                                           "rad",     "H2O",     "inH2O",
                                           "dBm",     "bel",     "min",
                                           "h",       "k",       "da",
                                           "milli",   "kilo",    "e",
                                           "E",       "T",       "_",
                                           "%",       "'",       "\"",
                                           "(",       ")",       "(",
                                           ")",       " ",       " ",
                                           ".",       "*",       "/",
                                           "/",       " per ",   "per",
                                           "PER",     "-",       "^",
                                           "**",      "^2",      "^-3",
                                           "**2",     "2",       "-3",
                                           "+4",      "0",       "1",
                                           "1.5",     ".5",      "5.",
                                           "1e3",     "1e400",   "1e-310",
                                           "007",     " from ",  "@",
                                           "since",   "REF",     "lg(re ",
                                           "ln(re: ", "LG(re ",  "lb (RE 1 mW)",
                                           ",",       ":",       "?",
                                           "\u00b2",  "\u207b",  "\u00b9",
                                           "\u2074",  "\u00b7",  "\u00b5",
                                           "\u03bc",  "\u00b0F", "\u00e9",
                                           "\u00d7",  "\u00a0",  "\u0101"};
  const auto count_shifts = [](const std::string& text) {
    int count = 0;
    for (const char* shift : {"@", "from", "since", "after", "ref"}) {
      for (std::size_t i = text.find(shift); i != std::string::npos; i = text.find(shift, i + 1)) ++count;
    }
    return count;
  };
  Comparison comparison(75000);
  Random random(1);
  for (int i = 0; i < 80000; ++i) {
    std::string text;
    for (std::uint64_t n = 1 + random.below(8); n > 0; --n) text += kParts[random.below(kParts.size())];
    if (count_shifts(lower_case(text)) < 2) comparison.add(text);  // two shifts may end the program within the library
  }
}

// Texts of no use in a model. Some of them are errors of the library.
TEST(unit_parser, differs_from_udunits_only_in_these) {
  struct Difference {
    const char *text, *library, *reason;
  };
  Udunits library;
  for (const Difference& d : {
           Difference{"m (s since 1990-01-01)", "m.s", "a date with hyphens; its origin is dropped in products"},
           Difference{"m (K from 99000 )", "none", "spaces that may follow a year may follow any integer here"},
           Difference{"m^4294967298", "m2", "exponents keep their last 32 bits"},
           Difference{"m^99999999999999999999", "m-1", "exponents keep their last 32 bits"},
           Difference{"((m^128)^128)^4", "m0", "powers keep their last 16 bits"},
           Difference{"m\xc2", "m", "a broken character ends the text"},
           Difference{"((((((((((((((((((((((((((((((((((((((((((m))))))))))))))))))))))))))))))))))))))))))", "m",
                      "more parentheses than 40"},
       }) {
    EXPECT_EQ(library.meaning(d.text).definition, d.library) << d.text << ": " << d.reason;
    EXPECT_NE(parsed_meaning(d.text).definition, d.library) << d.text << ": " << d.reason;
  }
  EXPECT_FALSE(parse_unit(std::string_view("m\0s", 3)).has_value()) << "ends a text of the library";
  EXPECT_FALSE(parse_unit("m\ns").has_value()) << "printed by the library";
}

TEST(unit_parser, temperatures_have_an_offset) {
  EXPECT_EQ(parse_unit("degC")->offset, 273.15);
  EXPECT_NEAR(parse_unit("degF")->offset, 459.67, 1e-12);  // the product of rounded numbers
  EXPECT_FALSE(parse_unit("degC")->is_scale());
  EXPECT_TRUE(parse_unit("W/degC")->is_scale());
}

TEST(unit_parser, any_bytes_are_a_unit_or_none) {
  Random random(2);
  int units = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string text;
    for (std::uint64_t n = random.below(12); n > 0; --n) {
      text += random.below(3) == 0 ? static_cast<char>(random.below(256)) : "mNs2-.(/ ^@)e"[random.below(13)];
    }
    units += parse_unit(text) ? 1 : 0;
  }
  EXPECT_GT(units, 1000);
}

}  // namespace
}  // namespace overbend
