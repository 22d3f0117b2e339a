#include "base/child_work.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <utility>

#include "base/interruption.h"

#if defined(_WIN32) || defined(__EMSCRIPTEN__)
#define OVERBEND_HAS_FORK 0
#else
#define OVERBEND_HAS_FORK 1
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#endif

namespace overbend {
namespace {

/// Message of the child: kind, length of the text, and text.
enum class Answer : char { result = 'r', error = 'f' };
constexpr std::size_t kHead = 1 + sizeof(std::uint64_t);

std::string answer_text(Answer kind, const std::string& text) {
  const std::uint64_t length = text.size();
  std::string message(kHead, static_cast<char>(kind));
  std::memcpy(message.data() + 1, &length, sizeof length);
  return message + text;
}

std::string answer_to(const std::function<std::string()>& work) {
  try {
    return answer_text(Answer::result, work());
  } catch (const std::bad_alloc&) {
    return answer_text(Answer::error, "reading it takes too much memory");
  } catch (const std::exception& error) {
    return answer_text(Answer::error, error.what());
  } catch (...) {
    return answer_text(Answer::error, "reading it failed");
  }
}

bool is_complete_message(const std::string& message) {
  if (message.size() < kHead) return false;
  std::uint64_t length = 0;
  std::memcpy(&length, message.data() + 1, sizeof length);
  return message.size() - kHead == length;
}

/// Text of a complete message.
std::string message_text(const std::string& message) {
  const bool is_error = message[0] == static_cast<char>(Answer::error);
  std::string text = message.substr(kHead);
  if (is_error) throw std::runtime_error(text);
  return text;
}

#if OVERBEND_HAS_FORK

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

void apply_limits(const ChildLimits& limits, std::size_t in_use) {
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

[[noreturn]] void run_child(const std::function<std::string()>& work, const ChildLimits& limits, std::size_t in_use,
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
  write_all(pipe, answer_to(work));
  ::_exit(0);
}

#endif

}  // namespace

#if OVERBEND_HAS_FORK

ChildWork::ChildWork(const std::function<std::string()>& work, const ChildLimits& limits)
    : until_(std::chrono::steady_clock::now() + limits.wall_time) {
  int ends[2];
  if (::pipe(ends) != 0) throw ChildError("no process can be started: " + std::generic_category().message(errno));
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  const std::size_t in_use = memory_in_use();
  const int parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) run_child(work, limits, in_use, ends[1], parent);
  const int why = errno;
  ::close(ends[1]);
  pipe_ = ends[0];
  if (pid_ > 0) return;
  ::close(pipe_);
  throw ChildError("no process can be started: " + std::generic_category().message(why));
}

ChildWork::~ChildWork() {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
  end();
}

/// Waits for the end of the process and returns its status, 0 if it was already collected.
int ChildWork::end() {
  if (pipe_ >= 0) ::close(std::exchange(pipe_, -1));
  const int pid = std::exchange(pid_, -1);
  int status = 0;
  while (pid > 0 && ::waitpid(pid, &status, 0) < 0) {
    if (errno != EINTR) return 0;
  }
  return status;
}

void ChildWork::throw_end_reason() {
  const int status = end();
  const int number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (number == SIGXCPU) throw ChildError("reading it takes too long");
  throw ChildError("reading it ended with signal " + std::to_string(number));
}

std::string ChildWork::result() {
  constexpr int kPatience = 100;  // poll interval [ms]
  constexpr std::size_t kPiece = 1U << 16U;
  for (;;) {
    check_interruption();
    pollfd ready{pipe_, POLLIN, 0};
    const int found = ::poll(&ready, 1, kPatience);
    if (found <= 0) {
      if (std::chrono::steady_clock::now() < until_) continue;
      throw ChildError("reading it takes too long");
    }
    const std::size_t before = received_.size();
    received_.resize(before + kPiece);
    const ssize_t count = ::read(pipe_, received_.data() + before, kPiece);
    received_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count == 0 || (count < 0 && errno != EINTR)) break;
  }
  if (!is_complete_message(received_)) throw_end_reason();
  end();
  return message_text(received_);
}

#else

ChildWork::ChildWork(const std::function<std::string()>& work, const ChildLimits& /*limits*/)
    : received_(answer_to(work)) {}

ChildWork::~ChildWork() = default;

std::string ChildWork::result() {
  return message_text(received_);
}

#endif

}  // namespace overbend
