#include "app/terminal_text.h"

#include <gtest/gtest.h>

#include <sstream>

namespace overbend {
namespace {

TEST(terminal_text, bytes_that_are_no_utf8_come_out_as_their_numbers) {
  std::ostringstream stream;
  {
    const TerminalText text(stream);
    stream << "f.csv:3: '1,\xc6" << 5 << '\'' << " \u20ac" << std::endl;
    EXPECT_TRUE(stream);
  }
  EXPECT_EQ(stream.str(), "f.csv:3: '1,\\xc65' \u20ac\n");
  stream << "\xc6";
  EXPECT_EQ(stream.str().back(), '\xc6');
}

}  // namespace
}  // namespace overbend
