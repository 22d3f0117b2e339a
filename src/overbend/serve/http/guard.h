/// Access to the server: only the page opened by this session.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

namespace overbend {

/// 128 random bits as 32 hexadecimal digits.
std::string random_token();

/// Compares in a time independent of how much of the token is right.
bool same_token(const std::string& given, const std::string& token);

/// Whether a request's Host names this server: another name that leads to this machine is some page's trick.
bool own_host(const std::string& host, int port);

/// Whether an Origin is the server's own page. None at all (empty) is no other page's.
bool own_origin(const std::string& origin, int port);

/// A word that opens the page once, within a minute, for a program of the same user. The address of a browser is seen
/// by all users of the machine in the list of processes, so the token is not part of it.
class OneTimeCode {
 public:
  /// A new one; an earlier one opens nothing any more. May be called from any thread, as take().
  std::string make();
  /// Whether `given` is the word, asked for over a connection of user `owner`. It is spent then.
  bool take(const std::string& given, std::optional<unsigned> owner);

 private:
  std::mutex mutex_;
  std::string code_;
  std::chrono::steady_clock::time_point until_;
};

}  // namespace overbend
