/// Long work that can be ended from outside, wherever it is: it asks now and then, deep within as well.
#pragma once

#include <exception>
#include <functional>

namespace overbend {

/// Work was ended from outside: neither an error of the input nor of the program.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

/// While it lives, the work of this thread ends where `stop` says so, or where the work around it shall end. Threads
/// that the work starts need their own.
class InterruptionScope {
 public:
  explicit InterruptionScope(std::function<bool()> stop);
  ~InterruptionScope();
  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

  bool wanted() const;

 private:
  std::function<bool()> stop_;
  const InterruptionScope* around_;
};

/// Whether the work of this thread shall end.
bool interruption_wanted();

/// Throws Interrupted where it shall. To be called several times a second.
void check_interruption();

/// Says of all threads of the process that their work shall end; also from a signal handler.
void interrupt_process(bool wanted) noexcept;

}  // namespace overbend
