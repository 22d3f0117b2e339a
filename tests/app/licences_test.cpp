// Whatever goes into the program comes with its licence.
#include <gtest/gtest.h>

#include "app/program.h"
#include "report/page/assets.h"
#include "serve/http/page_files.h"

namespace overbend {
namespace {

TEST(licences, of_everything_bundled_are_told) {
  const testing::ProgramRun run = testing::run_program("licences");
  EXPECT_EQ(run.code, 0);
  for (const char* package : {"Overbend", "d3 7", "d3-scale 4", "delaunator ", "preact 10", "@preact/signals ",
                              "three 0", "uplot 1", "@codemirror/view 6", "@lezer/lr ", "style-mod "}) {
    EXPECT_NE(run.out.find(package), std::string::npos) << package;
  }
  EXPECT_NE(run.out.find("Permission to use, copy, modify, and/or distribute"), std::string::npos);  // ISC
  EXPECT_NE(run.out.find("Copyright © 2010-"), std::string::npos) << "three";
  EXPECT_EQ(run.out, licence_texts());
}

TEST(licences, of_the_charting_library_go_with_every_report) {
  const std::string_view d3 = report_asset("d3");
  EXPECT_LT(d3.find("Permission to use, copy, modify, and/or distribute"), d3.find("https://d3js.org"));
}

}  // namespace
}  // namespace overbend
