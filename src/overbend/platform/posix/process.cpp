#include "platform/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

namespace overbend {
namespace fs = std::filesystem;
namespace {

std::atomic<void (*)()> interrupt_handler{nullptr};
static_assert(std::atomic<void (*)()>::is_always_lock_free, "a signal handler must not block");

void handle_interrupt(int signal) {
  if (void (*handler)() = interrupt_handler) handler();
  std::signal(signal, SIG_DFL);  // a second signal ends the program
}

/// Both ends of a pipe, closed by the destructor.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) ends_ = {-1, -1};
  }
  ~Pipe() {
    for (const int end : ends_) {
      if (end >= 0) ::close(end);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  bool is_open() const { return ends_[0] >= 0; }
  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void close_write_end() { ::close(std::exchange(ends_[1], -1)); }

 private:
  std::array<int, 2> ends_{};
};

/// Starts a program, found on the PATH. An output of -1 is discarded.
std::optional<pid_t> start_program(const std::vector<std::string>& command, int out, int err) {
  if (command.empty()) return std::nullopt;
  std::vector<char*> arguments;  // posix_spawnp only reads them
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const auto& [stream, end] : {std::pair(STDOUT_FILENO, out), std::pair(STDERR_FILENO, err)}) {
    if (end >= 0) {
      ::posix_spawn_file_actions_adddup2(&actions, end, stream);
    } else {
      ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
    }
  }
  pid_t id = 0;
  const int error = ::posix_spawnp(&id, arguments.front(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? std::optional(id) : std::nullopt;
}

/// Waits for a program and returns its exit code; empty if it cannot be waited for.
std::optional<int> wait_for_program(pid_t id) {
  int status = 0;
  while (::waitpid(id, &status, 0) < 0) {
    if (errno != EINTR) return std::nullopt;
  }
  constexpr int kSignalled = 128;
  return WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status);
}

/// Returns false at the end.
bool read_some(const Pipe& from, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(from.read_end(), buffer.data(), buffer.size());
  if (count < 0) return errno == EINTR;
  text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0;
}

/// Reads both at once: neither pipe may fill up while the other is waited for.
void read_both(const Pipe& out, const Pipe& err, ProgramOutput& into) {
  bool out_open = true, err_open = true;
  while (out_open || err_open) {
    std::array<pollfd, 2> ends = {pollfd{out_open ? out.read_end() : -1, POLLIN, 0},
                                  pollfd{err_open ? err.read_end() : -1, POLLIN, 0}};
    if (::poll(ends.data(), ends.size(), -1) < 0 && errno != EINTR) return;
    if (out_open && ends[0].revents != 0) out_open = read_some(out, into.out);
    if (err_open && ends[1].revents != 0) err_open = read_some(err, into.err);
  }
}

}  // namespace

std::vector<std::string> prepare_process(int count, char** arguments) {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) == -1) ::open("/dev/null", O_RDWR);  // uses the lowest free descriptor
  }
  std::signal(SIGXFSZ, SIG_IGN);  // it would end the program without a message
  return {arguments, arguments + count};
}

void set_interrupt_handler(void (*handler)()) {
  interrupt_handler = handler;
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, handler != nullptr ? handle_interrupt : SIG_DFL);
}

bool is_terminal(StandardStream stream) {
  return ::isatty(stream == StandardStream::input    ? STDIN_FILENO
                  : stream == StandardStream::output ? STDOUT_FILENO
                                                     : STDERR_FILENO) == 1;
}

bool has_own_console() {
  return false;
}

bool is_superuser() {
  return ::geteuid() == 0;
}

std::string environment_variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

fs::path executable_path() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

long process_number() {
  return ::getpid();
}

std::string process_start(long number) {
  std::ifstream stream("/proc/" + std::to_string(number) + "/stat");
  std::string line;
  if (!std::getline(stream, line)) return {};
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream rest(line.substr(name_end + 1));
  std::string word;
  constexpr int kStart = 20;  // field 22 of the line, proc(5), in ticks since the boot
  for (int i = 0; i < kStart; ++i) rest >> word;
  return word;
}

std::string process_namespace() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  std::ifstream boot("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(boot, id);
  std::array<char, 64> view{};
  const ssize_t length = ::readlink("/proc/self/ns/pid", view.data(), view.size() - 1);
  std::string text = std::string(host.data()) + "_" + id.substr(0, 8) + "_" +
                     (length > 0 ? std::string(view.data(), static_cast<std::size_t>(length)) : "");
  for (char& c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  }
  return text;
}

fs::path find_program(const std::string& name) {
  std::istringstream folders(environment_variable("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');) {
    fs::path file = fs::path(folder) / name;
    if (::access(file.c_str(), X_OK) == 0) return file;
  }
  return {};
}

std::optional<ProgramOutput> run_program(const std::vector<std::string>& command) {
  Pipe out, err;
  if (!out.is_open() || !err.is_open()) return std::nullopt;
  const std::optional<pid_t> id = start_program(command, out.write_end(), err.write_end());
  out.close_write_end();
  err.close_write_end();
  if (!id) return std::nullopt;
  ProgramOutput result;
  read_both(out, err, result);
  const std::optional<int> code = wait_for_program(*id);
  if (!code) return std::nullopt;
  result.code = *code;
  return result;
}

std::optional<int> run_program_silently(const std::vector<std::string>& command) {
  const std::optional<pid_t> id = start_program(command, -1, -1);
  return id ? wait_for_program(*id) : std::nullopt;
}

void open_browser(const std::string& url) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  const pid_t child = ::fork();
  if (child > 0) ::waitpid(child, nullptr, 0);
  if (child != 0) return;
  // A grandchild process, so that the browser is not waited for.
  if (::fork() == 0) ::execlp("xdg-open", "xdg-open", url.c_str(), static_cast<char*>(nullptr));
  ::_exit(0);
}

}  // namespace overbend
