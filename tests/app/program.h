/// Runs the program as a user does.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/program_path.h"

namespace overbend::testing {

struct ProgramRun {
  int code = -1;
  std::string out, err;
};

/// A folder of its own for one test, removed at its end.
class Scratch {
 public:
  Scratch() {
    std::string pattern = (std::filesystem::temp_directory_path() / "overbend_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) std::abort();
    path_ = pattern;
  }
  ~Scratch() { std::filesystem::remove_all(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return file(name);
  }
  std::string read(const std::string& name) const {
    std::ifstream in(path_ / name, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }

 private:
  std::filesystem::path path_;
};

/// Runs `overbend ARGUMENTS` (shell words) without a terminal, after the shell's `before` ("ulimit -f 1 && ").
inline ProgramRun run_program(const std::string& arguments, const std::string& before = "") {
  const Scratch scratch;
  const std::string command =
      before + program_path() + " " + arguments + " </dev/null >" + scratch.file("out") + " 2>" + scratch.file("err");
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, scratch.read("out"), scratch.read("err")};
}

inline std::string example(const std::string& name) {
  return std::string(OVERBEND_SOURCE_DIR) + "/examples/" + name;
}

}  // namespace overbend::testing
