#include "study/cluster/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "runstore/append_file.h"

namespace overbend {
namespace {

struct Pipe {
  FileDescriptor read, write;
};

std::optional<Pipe> open_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  return Pipe{FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

std::optional<pid_t> spawned(const std::vector<std::string>& command, const Pipe& out, const Pipe& err) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.write.id(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.write.id(), STDERR_FILENO);
  pid_t id = 0;
  const int error = ::posix_spawnp(&id, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? std::optional(id) : std::nullopt;
}

/// Returns false at the end.
bool take(const FileDescriptor& from, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(from.id(), buffer.data(), buffer.size());
  if (count < 0) return errno == EINTR;
  text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0;
}

/// Reads both at once: neither pipe may fill up while the other is waited for.
void read_both(const Pipe& out, const Pipe& err, ProgramOutput& into) {
  bool out_open = true, err_open = true;
  while (out_open || err_open) {
    std::array<pollfd, 2> ends = {pollfd{out_open ? out.read.id() : -1, POLLIN, 0},
                                  pollfd{err_open ? err.read.id() : -1, POLLIN, 0}};
    if (::poll(ends.data(), ends.size(), -1) < 0 && errno != EINTR) return;
    if (out_open && ends[0].revents != 0) out_open = take(out.read, into.out);
    if (err_open && ends[1].revents != 0) err_open = take(err.read, into.err);
  }
}

}  // namespace

std::optional<ProgramOutput> run_program(const std::vector<std::string>& command) {
  std::optional<Pipe> out = open_pipe(), err = open_pipe();
  if (!out || !err || command.empty()) return std::nullopt;
  const std::optional<pid_t> id = spawned(command, *out, *err);
  out->write = FileDescriptor();
  err->write = FileDescriptor();
  if (!id) return std::nullopt;
  ProgramOutput result;
  read_both(*out, *err, result);
  int status = 0;
  while (::waitpid(*id, &status, 0) < 0) {
    if (errno != EINTR) return std::nullopt;
  }
  constexpr int kSignalled = 128;
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status);
  return result;
}

}  // namespace overbend
