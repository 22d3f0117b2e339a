#include <gtest/gtest.h>

#include <regex>

#include "app/program.h"

namespace overbend {
namespace {

using testing::ProgramRun;
using testing::run_program;
using testing::Scratch;

TEST(command_line, a_slip_in_a_command_is_answered_with_the_one_meant) {
  const ProgramRun run = run_program("sttic model.yaml");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "overbend: there is no command 'sttic'; did you mean 'static'?\n");
  const ProgramRun far = run_program("nonsense");
  EXPECT_EQ(far.code, 2);
  EXPECT_NE(far.err.find("the commands are check, static"), std::string::npos) << far.err;
}

/// Completions of bash for the last argument, one a line.
std::string offered(const std::string& message) {
  const Scratch scratch;
  scratch.write("completion", run_program("completion bash").out);
  scratch.write("lay.yaml", "");
  scratch.write("notes.txt", "");
  const std::string script = "cd " + scratch.file("") + " && . ./completion && COMP_WORDS=(" + message +
                             ") && COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) && _overbend && printf '%s\\n' "
                             "\"${COMPREPLY[@]}\"";
  const std::string command = "bash -c '" + std::regex_replace(script, std::regex("'"), "'\\''") + "' > " +
                              scratch.file("out") + " 2> " + scratch.file("err");
  const int status = std::system(command.c_str());
  return status == 0 ? scratch.read("out") : "failed: " + scratch.read("err");
}

TEST(bash_completion, offers_commands_options_values_and_model_files) {
  EXPECT_EQ(offered("overbend st"), "static\nstudy\n");
  EXPECT_EQ(offered("overbend dynamic --re"), "--resume\n--restart\n");
  EXPECT_EQ(offered("overbend new --lay ''"), "s\nj\n");
  EXPECT_EQ(offered("overbend compare --of t"), "tensioner\n");
  EXPECT_EQ(offered("overbend static l"), "lay.yaml\n");
  EXPECT_EQ(offered("overbend static n"), "\n");  // no model file
  EXPECT_EQ(offered("overbend dynamic lay.yaml --duration ''"), "\n");
}

/// Every command and every option of the program's own help.
TEST(completion, knows_every_option_of_the_help) {
  const std::string bash = run_program("completion bash").out;
  const std::string zsh = run_program("completion zsh").out;
  const std::string man = run_program("completion man").out;
  const std::regex option("--[a-z][a-z-]+");
  std::size_t options = 0;
  for (const char* command :
       {"check", "static", "dynamic", "compare", "report", "check-results", "new", "serve", "schema"}) {
    EXPECT_NE(bash.find("'" + std::string(command) + "') options="), std::string::npos) << command;
    EXPECT_NE(zsh.find("    '" + std::string(command) + ":"), std::string::npos) << command;
    const std::string in_roff = std::regex_replace(command, std::regex("-"), "\\-");
    EXPECT_NE(man.find(".SS " + in_roff + "\n"), std::string::npos) << command;
    const std::string help = run_program(std::string(command) + " --help").out;
    for (auto sample = std::sregex_iterator(help.begin(), help.end(), option); sample != std::sregex_iterator();
         ++sample) {
      const std::string name = sample->str();
      ++options;
      EXPECT_NE(bash.find(name), std::string::npos) << command << " " << name;
      EXPECT_NE(zsh.find("'" + name + "["), std::string::npos) << command << " " << name;
      EXPECT_NE(man.find(std::regex_replace(name, std::regex("-"), "\\-")), std::string::npos)
          << command << " " << name;
    }
  }
  EXPECT_GT(options, 30u);
}

TEST(manual_page, has_the_sections_that_a_manual_page_has_and_no_stray_request) {
  const std::string man = run_program("completion man").out;
  std::size_t before = 0;
  for (const char* section : {".TH OVERBEND 1 ", ".SH NAME\n", ".SH SYNOPSIS\n", ".SH DESCRIPTION\n", ".SH COMMANDS\n",
                              ".SH EXIT STATUS\n"}) {
    const std::size_t index = man.find(section);
    ASSERT_NE(index, std::string::npos) << section;
    EXPECT_GE(index, before) << section;
    before = index;
  }
  std::istringstream lines(man);
  const std::regex request(R"(\.(TH|SH|SS|TP|br|nf|fi|\\")( .*)?)");
  for (std::string line; std::getline(lines, line);) {
    EXPECT_FALSE(line.empty());
    EXPECT_TRUE((line[0] != '.' && line[0] != '\'') || std::regex_match(line, request)) << line;
  }
}

}  // namespace
}  // namespace overbend
