// Spoilt files by the thousand: the reader must answer, not fall.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "modelfile/model_texts.h"
#include "modelfile/yaml_reader.h"

namespace overbend {
namespace {

/// A description is either refused or made of sensible numbers.
void expect_an_answer(const std::string& text) {
  const ModelReading reading = read_model_text(text, "fuzz.yaml");
  EXPECT_NE(reading.description.has_value(), reading.diagnostics.has_errors()) << text;
  if (!reading.description) return;
  const Description& d = *reading.description;
  for (const double value : {d.environment.water_depth, d.pipe.section.steel.wall_thickness, d.tensioner.x,
                             d.tensioner.tension.value_or(0.0), d.vessel.stern_shoe_z}) {
    EXPECT_TRUE(std::isfinite(value) && std::abs(value) < 1e16) << text;
  }
}

TEST(yaml_reader_fuzz, a_file_cut_anywhere_gets_an_answer) {
  const std::string& good = testing::kGoodModel;
  for (std::size_t length = 0; length <= good.size(); ++length) expect_an_answer(good.substr(0, length));
}

TEST(yaml_reader_fuzz, a_file_with_a_line_lost_or_doubled_gets_an_answer) {
  const std::string& good = testing::kGoodModel;
  std::size_t start = 0;
  while (start < good.size()) {
    const std::size_t end = good.find('\n', start) + 1;
    expect_an_answer(good.substr(0, start) + good.substr(end));
    expect_an_answer(good.substr(0, end) + good.substr(start));
    start = end;
  }
}

TEST(yaml_reader_fuzz, random_changes_get_an_answer) {
  constexpr int kTrials = 3000;
  const std::string characters = "{}[]:,#&*!|>'\"%@`-?~ \n\t0129.eEnaif\x01\xc3\xff";
  std::mt19937 random(20090301);
  const auto below = [&](std::size_t n) { return random() % n; };
  for (int trial = 0; trial < kTrials; ++trial) {
    std::string text = testing::kGoodModel;
    const std::size_t changes = 1 + below(4);
    for (std::size_t k = 0; k < changes; ++k) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text[at] = characters[below(characters.size())];
          break;
        case 1:
          text.insert(at, 1, characters[below(characters.size())]);
          break;
        case 2:
          text.erase(at, 1 + below(12));
          break;
        default:
          text.insert(at, text.substr(below(text.size()), below(40)));
          break;
      }
    }
    expect_an_answer(text);
  }
}

}  // namespace
}  // namespace overbend
