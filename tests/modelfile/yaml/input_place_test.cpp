#include "modelfile/yaml/input_place.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

const std::string kText =
    "overbend: 1\nvessel:\n  motion: fixed\nmoorings:\n  lines:\n    - {name: bow}\n    - name: stern\n";

TEST(input_place, is_file_line_and_key) {
  EXPECT_EQ(input_place("a.yaml", kText, "vessel.motion"), "a.yaml:3: vessel.motion");
  EXPECT_EQ(input_place("a.yaml", kText, "moorings.lines[1].name"), "a.yaml:7: moorings.lines[1].name");
}

TEST(input_place, of_a_key_that_is_not_there_is_its_group) {
  EXPECT_EQ(input_place("a.yaml", kText, "moorings.model"), "a.yaml:4: moorings.model");
  EXPECT_EQ(input_place("a.yaml", kText, "moorings.lines[1].length"), "a.yaml:7: moorings.lines[1].length");
  EXPECT_EQ(input_place("a.yaml", kText, "analysis.dynamic"), "a.yaml:1: analysis.dynamic");
}

TEST(input_place, without_a_text_is_the_key_alone) {
  EXPECT_EQ(input_place("a.yaml", "", "vessel"), "vessel");
  EXPECT_EQ(input_place("a.yaml", "{", "vessel"), "vessel");
}

}  // namespace
}  // namespace overbend
