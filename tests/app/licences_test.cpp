// Every part of the program comes with its licence.
#include <gtest/gtest.h>

#include "app/program.h"
#include "report/page/assets.h"
#include "serve/http/page_files.h"

namespace overbend {
namespace {

TEST(licences, of_everything_bundled_are_reported) {
  const testing::ProgramRun run = testing::run_program("licences");
  EXPECT_EQ(run.code, 0);
  for (const char* package : {"Overbend", "preact 10", "@preact/signals ", "three 0", "uplot 1", "@codemirror/view 6",
                              "@lezer/lr ", "style-mod "}) {
    EXPECT_NE(run.out.find(package), std::string::npos) << package;
  }
  EXPECT_NE(run.out.find("Copyright © 2010-"), std::string::npos) << "three";
  EXPECT_EQ(run.out, licence_texts());
}

TEST(licences, of_what_is_bundled_go_with_every_report) {
  const std::string_view script = report_asset("script");
  EXPECT_EQ(script.find("/*!\npreact 10"), 0U);
  EXPECT_NE(script.find("Permission is hereby granted, free of charge"), std::string_view::npos);
  EXPECT_EQ(script.find("three 0"), std::string_view::npos);
}

}  // namespace
}  // namespace overbend
