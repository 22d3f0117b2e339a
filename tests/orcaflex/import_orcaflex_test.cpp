#include "orcaflex/import_orcaflex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

namespace overbend::orcaflex {
namespace {

std::string case_file(const std::string& name) {
  return std::string(OVERBEND_SOURCE_DIR) + "/validation/orcaflex_cases/" + name;
}

std::string case_text(const std::string& name) {
  return read_file_text(case_file(name)).value();
}

/// Model from files in memory; the first is imported.
struct Attempt {
  std::optional<ImportedModel> model;
  std::string message;  ///< The first error.
};

Attempt import_texts(const std::map<std::string, std::string>& texts, const std::string& first = "model.yml") {
  Diagnostics diagnostics;
  Attempt attempt;
  attempt.model =
      import_orcaflex(first, {}, diagnostics, [&](const std::filesystem::path& file) -> std::optional<std::string> {
        const auto found = texts.find(file.generic_string());
        return found == texts.end() ? std::nullopt : std::optional(found->second);
      });
  for (const Diagnostic& diagnostic : diagnostics.sorted()) {
    if (attempt.message.empty() && diagnostic.severity == Severity::error) attempt.message = render(diagnostic);
  }
  return attempt;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t index = text.find(from);
  EXPECT_NE(index, std::string::npos) << from;
  return index == std::string::npos ? text : text.replace(index, from.size(), to);
}

std::string find_message(const std::string& text) {
  const Attempt attempt = import_texts({{"model.yml", text}});
  EXPECT_FALSE(attempt.model);
  return attempt.message;
}

bool mentions(const std::vector<std::string>& lines, const std::string& wanted) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(wanted) != std::string::npos; });
}

TEST(import_orcaflex, damaged_files_are_rejected_with_line_what_was_found_and_what_would_do) {
  const auto expect = [](const std::string& file, const std::string& place, const std::string& found,
                         const std::string& remedy) {
    const std::string message = find_message(case_text(file));
    EXPECT_NE(message.find("model.yml:" + place + ":"), std::string::npos) << message;
    EXPECT_NE(message.find(found), std::string::npos) << message;
    EXPECT_NE(message.find(remedy), std::string::npos) << message;
  };
  expect("of-unit-unknown.yml", "12", "'cubit'", "m, mm, cm, km, ft, in");
  expect("of-row-too-long.yml", "162", "4 values", "3 columns: SupportType, SupportArclength, SupportzOffset");
  expect("of-variable-data.yml", "101", "'Stiffening rollers'", "a number");
}

TEST(import_orcaflex, two_seas_in_a_file_in_parts_become_a_list_with_the_directions_they_come_from) {
  Diagnostics diagnostics;
  const std::optional<ImportedModel> model = import_orcaflex(case_file("slay-two-seas.yml"), {}, diagnostics);
  ASSERT_TRUE(model) << diagnostics.lines(Severity::error).front();
  EXPECT_NE(model->text.find("  waves:\n    - {type: jonswap, hs: 2.2 m, tp: 7.4 s, gamma: 3, from: 120 deg}\n"
                             "    - {type: jonswap, hs: 1.1 m, tp: 13.5 s, gamma: 6, from: 65 deg}\n"),
            std::string::npos)
      << model->text;
  EXPECT_NE(model->account.text().find("waves Wind sea, Swell: 2 groups at once"), std::string::npos)
      << model->account.text();
  EXPECT_NE(model->text.find("- {depth: 50 m, speed: 0.405 m/s, towards: 15 deg}"), std::string::npos);
}

TEST(import_orcaflex, a_stokes_wave_among_several_trains_becomes_linear) {
  const std::string train = "WaveType: Airy\n      WaveDirection: 180\n      WaveHeight: 0";
  const std::string two =
      "WaveType: Stokes' 5th\n      WaveDirection: 180\n      WaveHeight: 2\n      WavePeriod: 8\n"
      "    - Name: Swell\n      WaveType: Airy\n      WaveDirection: 90\n      WaveHeight: 1\n";
  const Attempt attempt = import_texts({{"model.yml", with(case_text("slay-simple.yml"), train, two)}});
  ASSERT_TRUE(attempt.model) << attempt.message;
  EXPECT_NE(attempt.model->text.find("- {type: airy, height: 2 m, period: 8 s, from: 90 deg}"), std::string::npos)
      << attempt.model->text;
  EXPECT_NE(attempt.model->account.text().find("those of Stokes cannot be added to others"), std::string::npos);
}

TEST(import_orcaflex, files_that_include_each_other_or_are_missing_are_rejected) {
  const Attempt circle = import_texts({{"model.yml", "includefile: b.yml\n"}, {"b.yml", "includefile: model.yml\n"}});
  EXPECT_NE(circle.message.find("b.yml:1: includefile: found 'model.yml', which includes this file again"),
            std::string::npos)
      << circle.message;
  EXPECT_NE(import_texts({{"model.yml", "includefile: parts/none.yml\n"}})
                .message.find("parts/none.yml', which cannot be read"),
            std::string::npos);
}

TEST(import_orcaflex, files_of_changes_are_rejected_by_line) {
  EXPECT_NE(find_message("BaseFile: lay.dat\n").find("model.yml:1: BaseFile"), std::string::npos);
  EXPECT_NE(find_message("General:\n  UnitsSystem: SI\nLay barge:\n  InitialX: 3\n").find("model.yml:3: Lay barge"),
            std::string::npos);
  EXPECT_NE(find_message("Lines[1]:\n  Length: 3\n").find("an index in brackets"), std::string::npos);
}

TEST(import_orcaflex, a_name_that_is_not_in_the_file_is_rejected) {
  const std::string text = case_text("slay-simple.yml");
  EXPECT_NE(find_message(with(text, "- [Pipe 12 in, 110, 2]", "- [Pipe 14 in, 110, 2]")).find("'Pipe 14 in'"),
            std::string::npos);
  EXPECT_NE(find_message(with(text, "- [Roller U, 6, 0.8]", "- [Roller V, 6, 0.8]")).find("'Roller V'"),
            std::string::npos);
  EXPECT_NE(find_message(with(text, "VesselType: Lay barge type", "VesselType: Ferry")).find("'Ferry'"),
            std::string::npos);
}

TEST(import_orcaflex, us_units_are_feet_and_kips) {
  const std::string text = case_text("slay-simple.yml");
  const Attempt us = import_texts({{"model.yml", with(text, "UnitsSystem: SI", "UnitsSystem: US")}});
  ASSERT_TRUE(us.model) << us.message;
  EXPECT_NE(us.model->text.find("water_depth: 23.7744 m"), std::string::npos) << us.model->text;  // 78 ft
  EXPECT_NE(us.model->text.find("anchor: 195.425568 m"), std::string::npos);                      // 641.16 ft
  EXPECT_NE(us.model->text.find("water_weight_density: 161.01465"), std::string::npos)
      << us.model->text;  // 1.025 kip/ft^3
}

TEST(import_orcaflex, a_v_support_is_one_roller_and_reported_as_approximated) {
  std::string text =
      with(case_text("slay-simple.yml"), "Geometry: U shaped", "Geometry: V shaped\n    VSupportWallAngle: 30");
  const Attempt attempt = import_texts({{"model.yml", text}});
  ASSERT_TRUE(attempt.model) << attempt.message;
  EXPECT_NE(attempt.model->text.find("stiffness: 18000 kN/m"), std::string::npos)
      << attempt.model->text;  // 2 12000 cos^2
  EXPECT_TRUE(mentions(attempt.model->account.approximated, "V of 30 deg"));
}

TEST(import_orcaflex, a_line_from_anchor_to_vessel_is_the_same_as_one_from_vessel_to_anchor) {
  const std::string text = case_text("slay-simple.yml");
  std::string turned = with(
      text, "- [Lay barge, -38, 0, 8.64195, 180, 90, 0, ~]\n      - [Anchored, -656.16, 0, 0.16195, 180, 90, 0, ~]",
      "- [Anchored, -656.16, 0, 0.16195, 0, 90, 0, ~]\n      - [Lay barge, -38, 0, 8.64195, 0, 90, 0, ~]");
  turned = with(turned, "- [Pipe 12 in, 110, 2]\n      - [Pipe 12 in, 130, 8]\n      - [Pipe 12 in, 430, 5]",
                "- [Pipe 12 in, 430, 5]\n      - [Pipe 12 in, 130, 8]\n      - [Pipe 12 in, 110, 2]");
  const Attempt ours = import_texts({{"model.yml", turned}}), theirs = import_texts({{"model.yml", text}});
  ASSERT_TRUE(ours.model) << ours.message;
  EXPECT_EQ(ours.model->text, theirs.model->text);
}

TEST(import_orcaflex, a_bed_that_slopes_has_its_depth_at_the_stern_shoe) {
  const Attempt attempt =
      import_texts({{"model.yml", with(case_text("slay-simple.yml"), "SeabedOriginDepth: 78",
                                       "SeabedOriginDepth: 78\n  SeabedSlope: 2\n  SeabedSlopeDirection: 180")}});
  ASSERT_TRUE(attempt.model) << attempt.message;
  // The shoe is at X = 40 - 55 = -15 m, the bed rises astern.
  EXPECT_NE(attempt.model->text.find("water_depth: 77.4761884"), std::string::npos) << attempt.model->text;
  EXPECT_NE(attempt.model->text.find("slope: 2 deg, slope_towards: 90 deg"), std::string::npos);
}

TEST(import_orcaflex, a_bare_section_in_a_coated_pipe_stays_bare) {
  std::string text = with(case_text("slay-explicit.yml"), "LineTypes:\n",
                          "LineTypes:\n  - Name: Bare\n    Category: Homogeneous pipe\n    OD: 0.4064\n    ID: 0.37\n"
                          "    MaterialDensity: 7.85\n    E: 207e6\n    Cdn: 0.9\n");
  text = with(text, "- [Pipe 16 in, 130, 2]", "- [Bare, 130, 2]");
  const Attempt attempt = import_texts({{"model.yml", text}});
  ASSERT_TRUE(attempt.model) << attempt.message;
  const std::string segment = attempt.model->text.substr(attempt.model->text.find("segments:"));
  EXPECT_NE(segment.find("wall_thickness: 18.2 mm"), std::string::npos) << segment;
  EXPECT_NE(segment.find("coatings: []"), std::string::npos) << segment;
  EXPECT_NE(segment.find("drag_normal: 0.9"), std::string::npos) << segment;
}

TEST(import_orcaflex, spreading_keeps_its_first_circular_moment) {
  const std::string text =
      with(case_text("slay-simple.yml"), "WaveType: Airy\n      WaveDirection: 180\n      WaveHeight: 0",
           "WaveType: JONSWAP\n      WaveDirection: 180\n      WaveJONSWAPParameters: Partially specified\n"
           "      WaveHs: 2\n      WaveGamma: 3.3\n      WaveTz: 6\n      WaveNumberOfSpectralDirections: 7\n"
           "      WaveDirectionSpreadingExponent: 2");
  const Attempt attempt = import_texts({{"model.yml", text}});
  ASSERT_TRUE(attempt.model) << attempt.message;
  // The moment of cos^2 is 8 / (3 pi) = 0.848826; s = r / (1 - r).
  EXPECT_NE(attempt.model->text.find("tz: 6 s, gamma: 3.3, spreading: 5.61"), std::string::npos) << attempt.model->text;
}

/// `text` with one change at random: a byte, a line cut out, doubled or moved, or a number replaced.
std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&random](std::size_t size) {
    return std::uniform_int_distribution<std::size_t>(0, size - 1)(random);
  };
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const std::size_t i = below(lines.size());
  switch (below(6)) {
    case 0:
      lines[i].insert(below(lines[i].size() + 1), 1, static_cast<char>(below(256)));
      break;
    case 1:
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    case 2:
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(i), lines[below(lines.size())]);
      break;
    case 3:
      std::swap(lines[i], lines[below(lines.size())]);
      break;
    case 4:
      lines[i] = lines[i].substr(0, below(lines[i].size() + 1));
      break;
    default: {
      constexpr std::array<const char*, 8> kValues = {"-1e300", "0", "~", "Infinity", "[]", "{}", "Yes", "1e-300"};
      const std::size_t colon = lines[i].find(": ");
      if (colon != std::string::npos) lines[i] = lines[i].substr(0, colon + 2) + kValues[below(kValues.size())];
    }
  }
  std::string result;
  for (const std::string& line : lines) result += line + "\n";
  return result;
}

TEST(import_orcaflex, a_file_with_random_damage_is_translated_or_rejected) {
  const char* count = std::getenv("OVERBEND_MUTATIONS");
  const int mutations = count != nullptr ? std::atoi(count) : 300;
  std::mt19937 random(7);
  for (const char* name :
       {"slay-simple.yml", "slay-explicit.yml", "moored-chain-wire.yml", "jumper-general.yml", "slay-winch.yml"}) {
    const std::string text = case_text(name);
    for (int i = 0; i < mutations / 5; ++i) {
      const Attempt attempt = import_texts({{"model.yml", mutated(text, random)}});
      ASSERT_TRUE(attempt.model.has_value() != !attempt.message.empty()) << name << " " << i;
    }
  }
}

TEST(import_orcaflex, a_vessel_type_with_loads_alone_is_offered_as_hull_data) {
  const std::string hull =
      read_file_text(std::string(OVERBEND_SOURCE_DIR) + "/validation/hull_files/orcaflex-loads/barge.yml").value();
  const std::size_t from = hull.find("        Mass: 12915"), to = hull.find("\n...", from);
  const std::string lay = case_text("slay-simple.yml");
  const std::size_t raos = lay.find("        DisplacementRAOs:"), after = lay.find("\nSupportTypes:", raos);
  ASSERT_TRUE(from != std::string::npos && raos != std::string::npos && after != std::string::npos);
  const Attempt attempt =
      import_texts({{"model.yml", lay.substr(0, raos) + hull.substr(from, to - from) + lay.substr(after)}});
  ASSERT_TRUE(attempt.model) << attempt.message;
  for (const char* line :
       {"  #     hydrodynamics: ", "model.yml", "  #     mass: 12915 t", "z: 1.5 m}", "gyration: {roll: 9.8000"}) {
    EXPECT_NE(attempt.model->text.find(line), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace overbend::orcaflex
