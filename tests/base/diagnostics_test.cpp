#include "base/diagnostics.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(diagnostics, an_error_reads_as_place_key_found_expected_and_hint) {
  EXPECT_EQ(render({Severity::error, "a.yaml", 12, 3, "pipe.length", "'3 kN'", "a length", "write m"}),
            "a.yaml:12: pipe.length: found '3 kN', expected a length; write m");
  EXPECT_EQ(render({Severity::error, "a.yaml", 0, 0, "", "there is no such file", "", ""}),
            "a.yaml: there is no such file");
  EXPECT_EQ(render({Severity::warning, "a.yaml", 4, 0, "x", "odd", "", ""}), "a.yaml:4: x: odd");
}

TEST(diagnostics, errors_come_in_the_order_of_the_file) {
  Diagnostics diagnostics;
  diagnostics.add({Severity::error, "a", 9, 0, "", "late", "", ""});
  diagnostics.add({Severity::warning, "a", 5, 0, "", "odd", "", ""});
  diagnostics.add({Severity::error, "a", 2, 0, "", "early", "", ""});
  EXPECT_EQ(diagnostics.lines(Severity::error), (std::vector<std::string>{"a:2: early", "a:9: late"}));
  EXPECT_EQ(diagnostics.error_count(), 2);
}

TEST(diagnostics, what_is_quoted_of_files_becomes_valid_utf8) {
  Diagnostics diagnostics;
  diagnostics.add({Severity::error, "a\xff", 2, 0, "k\xc6", "'\xc6'", "a\xc6", "b\xc6"});
  EXPECT_EQ(diagnostics.lines(Severity::error).front(), "a\\xff:2: k\\xc6: found '\\xc6', expected a\\xc6; b\\xc6");
}

TEST(diagnostics, warnings_alone_are_no_error) {
  Diagnostics diagnostics;
  diagnostics.add({Severity::warning, "a", 5, 0, "", "odd", "", ""});
  EXPECT_FALSE(diagnostics.has_errors());
}

TEST(diagnostics, a_million_errors_are_counted_and_not_kept) {
  Diagnostics diagnostics;
  diagnostics.add({Severity::warning, "a", 1, 0, "", "odd", "", ""});
  for (int i = 0; i < 1000000; ++i) diagnostics.add({Severity::error, "a", i, 0, "", "wrong", "", ""});
  EXPECT_EQ(diagnostics.error_count(), 1000000);
  EXPECT_EQ(diagnostics.lines(Severity::error).size(), 1000U);
  EXPECT_EQ(diagnostics.lines(Severity::warning).size(), 1U);
}

}  // namespace
}  // namespace overbend
