#include "platform/process.h"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdlib>

namespace overbend {
namespace {

namespace fs = std::filesystem;

TEST(process, differs_from_others_by_number_and_start) {
  const std::string start = process_start(process_number());
  EXPECT_FALSE(start.empty());
  EXPECT_EQ(process_start(process_number()), start);
  EXPECT_EQ(process_start(0x7ffffff0), "");
  const std::string name = process_namespace();
  EXPECT_FALSE(name.empty());
  EXPECT_EQ(name.find_first_of("./\\: "), std::string::npos) << name;  // part of the name of a file
}

TEST(process, knows_its_program) {
  EXPECT_TRUE(fs::is_regular_file(executable_path())) << executable_path();
  EXPECT_NE(executable_path().filename().string().find("test"), std::string::npos) << executable_path();
}

TEST(process, has_an_environment) {
  EXPECT_FALSE(environment_variable("PATH").empty());
  EXPECT_EQ(environment_variable("OVERBEND_NO_SUCH_VARIABLE"), "");
}

#ifndef _WIN32

TEST(process, the_first_interruption_calls_the_handler_and_the_second_is_left_to_the_system) {
  static std::atomic<int> calls{0};
  calls = 0;
  set_interrupt_handler([] { ++calls; });
  std::raise(SIGINT);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_DFL);
  EXPECT_NE(std::signal(SIGTERM, SIG_DFL), SIG_DFL);
  set_interrupt_handler(nullptr);
  EXPECT_EQ(std::signal(SIGTERM, SIG_DFL), SIG_DFL);
}

TEST(process, finds_programs_on_the_path_alone) {
  EXPECT_TRUE(find_program("sh").is_absolute());
  EXPECT_EQ(find_program("no-such-program-of-ours"), "");
}

TEST(run_program, reports_code_output_and_complaints_of_a_program_and_that_there_is_none) {
  const auto finished = run_program({"sh", "-c", "echo out; echo err >&2; exit 7"});
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->code, 7);
  EXPECT_EQ(finished->out, "out\n");
  EXPECT_EQ(finished->err, "err\n");
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"})->code, 128 + 9);
  EXPECT_FALSE(run_program({"no-such-program-of-ours"}));
  EXPECT_FALSE(run_program({}));
  // More than a pipe holds on both.
  const auto much = run_program({"sh", "-c", "head -c 300000 /dev/zero >&2; head -c 300000 /dev/zero"});
  EXPECT_EQ(much->out.size(), 300000U);
  EXPECT_EQ(much->err.size(), 300000U);
}

TEST(run_program, passes_arguments_unchanged_and_no_input) {
  const auto finished = run_program({"printf", "%s|", "a b", "\"c\\", "", "$HOME"});
  EXPECT_EQ(finished->out, "a b|\"c\\||$HOME|");
  EXPECT_EQ(run_program({"cat"})->out, "");
}

TEST(run_program, silently_returns_the_code_alone) {
  EXPECT_EQ(run_program_silently({"sh", "-c", "echo out; echo err >&2; exit 7"}), 7);
  EXPECT_EQ(run_program_silently({"true"}), 0);
  EXPECT_FALSE(run_program_silently({"no-such-program-of-ours"}));
}

#else

TEST(run_program, passes_arguments_unchanged_and_reports_code_and_output) {
  EXPECT_EQ(find_program("no-such-program-of-ours"), "");
  EXPECT_FALSE(find_program("cmd").empty());
  EXPECT_EQ(run_program({"cmd", "/c", "exit", "7"})->code, 7);
  EXPECT_EQ(run_program({"cmd", "/c", "echo", "out"})->out, "out\r\n");
  EXPECT_EQ(run_program({"cmd", "/c", "echo", "a b\\"})->out, "\"a b\\\\\"\r\n");  // quoted for CommandLineToArgvW()
  EXPECT_EQ(run_program_silently({"cmd", "/c", "exit", "3"}), 3);
  EXPECT_FALSE(run_program({"no-such-program-of-ours"}));
}

#endif

}  // namespace
}  // namespace overbend
