#include "app/pdf.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "app/program.h"

namespace overbend {
namespace {

using testing::Scratch;

class Browser : public ::testing::Test {
 protected:
  void TearDown() override { unsetenv("OVERBEND_BROWSER"); }

  /// A program that does what a browser would with the last of its arguments but one.
  void use(const std::string& script) {
    const std::string program = scratch_.write("browser", "#!/bin/sh\n" + script);
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    setenv("OVERBEND_BROWSER", program.c_str(), 1);
  }

  const Scratch scratch_;
};

TEST_F(Browser, prints_the_page_whose_address_it_is_given) {
  use("for word; do case \"$word\" in --print-to-pdf=*) out=${word#--print-to-pdf=};; esac; done\n"
      "echo \"$word\" > \"$out\"\n");
  const std::string html = scratch_.write("my report #1.html", "<p>page</p>");
  print_pdf(html, scratch_.file("report.pdf"));
  const std::string printed = scratch_.read("report.pdf");
  EXPECT_NE(printed.find("file:///"), std::string::npos) << printed;
  EXPECT_NE(printed.find("my%20report%20%231.html"), std::string::npos) << printed;
  EXPECT_FALSE(std::filesystem::exists(scratch_.file("report.pdf.part")));
}

TEST_F(Browser, that_prints_nothing_leaves_the_earlier_file) {
  use("exit 0\n");
  scratch_.write("report.pdf", "earlier");
  EXPECT_THROW(print_pdf(scratch_.write("report.html", ""), scratch_.file("report.pdf")), PdfError);
  EXPECT_EQ(scratch_.read("report.pdf"), "earlier");
}

TEST_F(Browser, that_does_not_exist_is_an_error_that_says_what_to_do) {
  setenv("OVERBEND_BROWSER", "no-such-browser", 1);
  try {
    print_pdf(scratch_.write("report.html", ""), scratch_.file("report.pdf"));
    FAIL();
  } catch (const PdfError& error) {
    EXPECT_NE(std::string(error.what()).find("OVERBEND_BROWSER"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace overbend
