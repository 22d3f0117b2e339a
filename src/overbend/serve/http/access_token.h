/// Access control: only the page opened by this session may use the server.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace overbend {

/// Returns 128 random bits as 32 hexadecimal digits.
std::string random_token();

/// Compares in constant time.
bool same_token(const std::string& candidate, const std::string& token);

/// True if the Host header names this server. Other names that resolve to this machine indicate DNS rebinding.
bool own_host(const std::string& host, int port);

/// True if the Origin header is that of the server's page, or empty (not sent by another page).
bool own_origin(const std::string& origin, int port);

/// Code that opens the page once, within a minute, for a program of the same user. The token is not part of the
/// browser's command line, which all users of the machine can see in the process list.
class OneTimeCode {
 public:
  /// Returns a new code and invalidates earlier ones. May be called from any thread, like take().
  std::string make();
  /// True if `candidate` is the code and the connection belongs to this user. Uses up the code.
  bool take(const std::string& candidate, bool own_connection);

 private:
  std::mutex mutex_;
  std::string code_;
  std::chrono::steady_clock::time_point until_;
};

}  // namespace overbend
