// The page is opened in a browser without showing its token to the whole machine.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "app/program.h"
#include "support/program_path.h"

namespace overbend {
namespace {

TEST(serve_command, the_command_line_of_the_browser_does_not_hold_the_token) {
  const testing::Scratch folder;
  const std::string browser =
      folder.write("xdg-open", "#!/bin/sh\necho \"$@\" > \"$0.new\"; mv \"$0.new\" \"$0.asked\"\n");
  ASSERT_EQ(::chmod(browser.c_str(), 0700), 0);
  const std::string home = std::filesystem::path(browser).parent_path().string();
  const std::string command = "cd " + home + " && DISPLAY=:9 PATH=\"" + home + ":$PATH\" exec " +
                              testing::program_path() + " serve >out 2>err </dev/null & echo $! >" + home + "/id";
  ASSERT_EQ(std::system(command.c_str()), 0);
  for (int i = 0; i < 3000 && folder.read("xdg-open.asked").empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const std::string asked = folder.read("xdg-open.asked"), out = folder.read("out");
  ::kill(std::stoi(folder.read("id")), SIGINT);
  EXPECT_NE(asked.find("http://127.0.0.1:"), std::string::npos) << asked;
  const std::size_t index = out.find("token=");
  ASSERT_NE(index, std::string::npos) << out;
  EXPECT_EQ(asked.find(out.substr(index + 6, 32)), std::string::npos) << asked;
}

}  // namespace
}  // namespace overbend
