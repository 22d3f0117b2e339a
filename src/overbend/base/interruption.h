/// Cancellation of long work: a scope holds the request, loops deep in the engine poll it.
#pragma once

#include <exception>
#include <functional>

namespace overbend {

/// Cancelled work: neither an error of the input nor of the program.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

/// Work of this thread within its lifetime is cancelled once `stop` returns true, or the enclosing scope is. Threads
/// started within need scopes of their own: see caller_interruption().
class InterruptionScope {
 public:
  explicit InterruptionScope(std::function<bool()> stop);
  virtual ~InterruptionScope();
  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

  virtual bool wanted() const;

 private:
  std::function<bool()> stop_;
  const InterruptionScope* around_;
};

/// Nothing is cancelled within its lifetime: for saving cancelled work.
class UninterruptedScope : public InterruptionScope {
 public:
  UninterruptedScope() : InterruptionScope({}) {}
  bool wanted() const override { return false; }
};

/// True once the work of this thread is cancelled.
bool interruption_wanted();

/// Throws Interrupted once the work of this thread is cancelled. Long loops call it several times a second.
void check_interruption();

/// Returns interruption_wanted() of this thread for the scopes of threads that it starts and waits for.
std::function<bool()> caller_interruption();

}  // namespace overbend
