#include "platform/process_copy.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <utility>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace overbend {
namespace {

void limit(decltype(RLIMIT_CPU) what, rlim_t max_value) {
  rlimit present{};
  if (::getrlimit(what, &present) != 0) return;
  present.rlim_cur = std::min({max_value, present.rlim_cur, present.rlim_max});
  ::setrlimit(what, &present);
}

/// Returns the memory of this process [bytes]; 0 if the system does not report it.
std::size_t memory_in_use() {
  std::ifstream stream("/proc/self/statm");
  std::size_t pages = 0;
  stream >> pages;
  return stream ? pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

/// Resets signal handling in the child; Ctrl-C is handled by the waiting process.
void reset_signals() {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU, SIGALRM}) {
    ::signal(number, SIG_DFL);
  }
  ::signal(SIGINT, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

void apply_limits(const ProcessLimits& limits, std::size_t in_use) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu_time.count()));
  if (in_use > 0) limit(RLIMIT_AS, in_use + limits.memory);
}

void write_all(int pipe, const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = ::write(pipe, text.data() + sent, text.size() - sent);
    if (count < 0 && errno != EINTR) return;
    sent += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
  }
}

[[noreturn]] void run_child(const std::function<std::string()>& work, const ProcessLimits& limits, std::size_t in_use,
                            int pipe, int parent) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
#else
  static_cast<void>(parent);
#endif
  reset_signals();
  apply_limits(limits, in_use);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);  // discards error output of the C library
  write_all(pipe, work());
  ::_exit(0);
}

}  // namespace

ProcessCopy::ProcessCopy(const std::function<std::string()>& work, const ProcessLimits& limits,
                         std::error_code& error) {
  error.clear();
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) {
    error = {errno, std::generic_category()};
    return;
  }
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  const std::size_t in_use = memory_in_use();
  const int parent = ::getpid();
  process_ = ::fork();
  if (process_ == 0) run_child(work, limits, in_use, ends[1], parent);
  if (process_ < 0) error = {errno, std::generic_category()};
  ::close(ends[1]);
  pipe_ = ends[0];
}

ProcessCopy::~ProcessCopy() {
  if (process_ > 0) ::kill(process_, SIGKILL);
  wait();
}

ProcessCopy::Arrival ProcessCopy::read(std::string& text, std::chrono::milliseconds patience) {
  constexpr std::size_t kPiece = 1U << 16U;
  pollfd ready{pipe_, POLLIN, 0};
  if (::poll(&ready, 1, static_cast<int>(patience.count())) <= 0) return Arrival::none;
  const std::size_t before = text.size();
  text.resize(before + kPiece);
  const ssize_t count = ::read(pipe_, text.data() + before, kPiece);
  text.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return count == 0 || (count < 0 && errno != EINTR) ? Arrival::end : Arrival::bytes;
}

ProcessEnd ProcessCopy::wait() {
  if (pipe_ >= 0) ::close(std::exchange(pipe_, -1));
  const int process = std::exchange(process_, -1);
  int status = 0;
  while (process > 0 && ::waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) return {};
  }
  const int number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return {number, number == SIGXCPU};
}

}  // namespace overbend
