#include "app/warning_lines.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(warning_lines, say_once_that_they_are_warnings) {
  EXPECT_EQ(warning_lines({"lay.yaml:12: warning: pipe.steel.wall_thickness: 1 mm is unusual", "the pipe runs off"}),
            "  warning: lay.yaml:12: pipe.steel.wall_thickness: 1 mm is unusual\n  warning: the pipe runs off\n");
}

}  // namespace
}  // namespace overbend
