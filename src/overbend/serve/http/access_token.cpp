#include "serve/http/access_token.h"

#include <fmt/format.h>

#include <random>

namespace overbend {

std::string random_token() {
  std::random_device source;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", source());
  return token;
}

bool same_token(const std::string& candidate, const std::string& token) {
  if (candidate.size() != token.size()) return false;
  unsigned different = 0;
  for (std::size_t i = 0; i < token.size(); ++i) {
    different |= static_cast<unsigned char>(candidate[i]) ^ static_cast<unsigned char>(token[i]);
  }
  return different == 0;
}

bool own_host(const std::string& host, int port) {
  return host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
}

bool own_origin(const std::string& origin, int port) {
  return origin.empty() || origin == fmt::format("http://127.0.0.1:{}", port) ||
         origin == fmt::format("http://localhost:{}", port);
}

std::string OneTimeCode::make() {
  const std::lock_guard<std::mutex> hold(mutex_);
  code_ = random_token();
  until_ = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  return code_;
}

bool OneTimeCode::take(const std::string& candidate, bool own_connection) {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (code_.empty() || !same_token(candidate, code_) || !own_connection) return false;
  code_.clear();
  return std::chrono::steady_clock::now() < until_;
}

}  // namespace overbend
