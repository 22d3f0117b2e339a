// Spoilt files by the thousand: the reader must answer, not fall.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "modelfile/model_texts.h"
#include "modelfile/moored_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

/// Nothing of a line is left open once it is read.
template <typename Line>
void expect_whole(const Line& line, const std::string& text) {
  EXPECT_FALSE(line.segments.empty()) << text;
  for (const LineSegmentDescription& segment : line.segments) {
    EXPECT_GT(segment.type.axial_stiffness, 0.0) << text;
    EXPECT_GT(segment.type.drag_diameter, 0.0) << text;
    EXPECT_TRUE(std::isfinite(segment.type.weight_submerged)) << text;
  }
  for (const LinePointDescription& point : line.points) {
    EXPECT_TRUE(std::isfinite(point.net_force + point.volume + point.added_mass)) << text;
  }
}

/// A description is either rejected or made of sensible numbers.
void expect_an_answer(const std::string& text) {
  const ModelReading reading = read_model_text(text, "fuzz.yaml");
  EXPECT_NE(reading.description.has_value(), reading.diagnostics.has_errors()) << text;
  if (!reading.description) return;
  const Description& d = *reading.description;
  for (const double value : {d.environment.water_depth, d.pipe.section.steel.wall_thickness, d.tensioner.x,
                             d.tensioner.tension.value_or(0.0), d.vessel.stern_shoe_z}) {
    EXPECT_TRUE(std::isfinite(value) && std::abs(value) < 1e16) << text;
  }
  if (d.moorings) {
    for (const MooringLineDescription& line : d.moorings->lines) expect_whole(line, text);
  }
  for (const FreeLineDescription& line : d.lines) expect_whole(line, text);
}

TEST(yaml_reader_fuzz, a_file_cut_anywhere_gets_an_answer) {
  for (const std::string& good : {testing::kGoodModel, testing::kLines}) {
    for (std::size_t length = 0; length <= good.size(); ++length) expect_an_answer(good.substr(0, length));
  }
}

TEST(yaml_reader_fuzz, a_file_with_a_line_lost_or_doubled_gets_an_answer) {
  for (const std::string& good : {testing::kGoodModel, testing::kMoored, testing::kLines}) {
    std::size_t start = 0;
    while (start < good.size()) {
      const std::size_t end = good.find('\n', start) + 1;
      expect_an_answer(good.substr(0, start) + good.substr(end));
      expect_an_answer(good.substr(0, end) + good.substr(start));
      start = end;
    }
  }
}

TEST(yaml_reader_fuzz, random_changes_get_an_answer) {
  constexpr int kTrials = 3000;
  const std::string characters = "{}[]:,#&*!|>'\"%@`-?~ \n\t0129.eEnaif\x01\xc3\xff";
  std::mt19937 random(20090301);
  const auto below = [&](std::size_t n) { return random() % n; };
  for (int trial = 0; trial < kTrials; ++trial) {
    std::string text = trial % 3 == 0 ? testing::kMoored : trial % 3 == 1 ? testing::kLines : testing::kGoodModel;
    const std::size_t changes = 1 + below(4);
    for (std::size_t k = 0; k < changes; ++k) {
      const std::size_t index = below(text.size());
      switch (below(4)) {
        case 0:
          text[index] = characters[below(characters.size())];
          break;
        case 1:
          text.insert(index, 1, characters[below(characters.size())]);
          break;
        case 2:
          text.erase(index, 1 + below(12));
          break;
        default:
          text.insert(index, text.substr(below(text.size()), below(40)));
          break;
      }
    }
    expect_an_answer(text);
  }
}

}  // namespace
}  // namespace overbend
