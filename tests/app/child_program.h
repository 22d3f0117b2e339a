/// The program in a process of its own, which a test can interrupt or kill at work.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "runstore/run_store.h"
#include "support/program_path.h"

namespace overbend::testing {

class ChildProgram {
 public:
  /// Starts `overbend WORDS...` in `folder`, its output thrown away.
  ChildProgram(const std::filesystem::path& folder, const std::vector<std::string>& command_line) {
    const std::string program = program_path();
    std::vector<char*> arguments{const_cast<char*>(program.c_str())};
    for (const std::string& word : command_line) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    id_ = fork();
    if (id_ < 0) throw std::runtime_error("no process");
    if (id_ == 0) {
      const int nowhere = open("/dev/null", O_RDWR);
      for (const int stream : {0, 1, 2}) dup2(nowhere, stream);
      if (chdir(folder.c_str()) != 0) _exit(127);
      execv(program.c_str(), arguments.data());
      _exit(127);
    }
  }
  ~ChildProgram() {
    if (id_ > 0) {
      kill(id_, SIGKILL);
      waitpid(id_, nullptr, 0);
    }
  }
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  /// Waits for a checkpoint at `time` or later in the folder of results, then sends the signal. False where the program
  /// ended before.
  bool signal_after(const std::filesystem::path& results, double time, int signal) {
    for (;;) {
      if (const auto stored = RunStore::find(results); stored && stored->error.empty() && stored->time >= time) break;
      if (waitpid(id_, &status_, WNOHANG) == id_) {
        id_ = -1;
        return false;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(id_, signal);
    return true;
  }

  void send(int signal) const { kill(id_, signal); }

  /// Waits for its end: the exit code, or minus the signal that ended it.
  int end() {
    if (id_ > 0) waitpid(id_, &status_, 0);
    id_ = -1;
    return WIFSIGNALED(status_) ? -WTERMSIG(status_) : WEXITSTATUS(status_);
  }

 private:
  pid_t id_ = -1;
  int status_ = 0;
};

}  // namespace overbend::testing
