#include "serve/http/connection.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace overbend {
namespace {

constexpr std::chrono::milliseconds kDrained{2000};
constexpr std::size_t kMaxDrained = 8U << 20U;  // [bytes]

void read_address(const sockaddr_in& address, std::string& ip, int& port) {
  std::array<char, INET_ADDRSTRLEN> text{};
  if (inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size()) != nullptr) ip = text.data();
  port = ntohs(address.sin_port);
}

}  // namespace

Connection::Connection(int socket, const RequestBounds& bounds) : socket_(socket), bounds_(bounds) {}

bool Connection::wait(short event, Clock::time_point until) const {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
    pollfd asked{socket_, event, 0};
    const int found = ::poll(&asked, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (found < 0 && errno == EINTR) continue;
    return found > 0;
  }
}

bool Connection::wait_for_request() {
  if (next_ == filled_ && !wait(POLLIN, Clock::now() + bounds_.idle)) return false;
  until_ = Clock::now() + bounds_.head;
  allowed_ = bounds_.max_head;
  return true;
}

void Connection::expect_body(std::uint64_t size) {
  until_ = Clock::now() + bounds_.body;
  allowed_ = size;
}

void Connection::drain() {
  ::shutdown(socket_, SHUT_WR);
  const Clock::time_point until = Clock::now() + kDrained;
  std::size_t taken = 0;
  while (taken < kMaxDrained && wait(POLLIN, until)) {
    const ssize_t count = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    if (count <= 0) return;
    taken += static_cast<std::size_t>(count);
  }
}

bool Connection::is_readable() const {
  return next_ < filled_ || wait(POLLIN, until_);
}

bool Connection::is_writable() const {
  return wait(POLLOUT, Clock::now() + bounds_.write);
}

ssize_t Connection::read(char* to, std::size_t size) {
  size = static_cast<std::size_t>(std::min<std::uint64_t>(size, allowed_));
  if (size == 0) return -1;
  if (next_ == filled_) {
    if (!wait(POLLIN, until_)) return -1;
    const ssize_t count = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    if (count <= 0) return count;
    next_ = 0;
    filled_ = static_cast<std::size_t>(count);
  }
  const std::size_t count = std::min(size, filled_ - next_);
  std::memcpy(to, buffer_.data() + next_, count);
  next_ += count;
  allowed_ -= count;
  return static_cast<ssize_t>(count);
}

ssize_t Connection::write(const char* from, std::size_t size) {
  if (!is_writable()) return -1;
  return ::send(socket_, from, size, MSG_NOSIGNAL);
}

void Connection::get_remote_ip_and_port(std::string& ip, int& port) const {
  sockaddr_in address{};
  socklen_t length = sizeof address;
  if (getpeername(socket_, reinterpret_cast<sockaddr*>(&address), &length) == 0) read_address(address, ip, port);
}

void Connection::get_local_ip_and_port(std::string& ip, int& port) const {
  sockaddr_in address{};
  socklen_t length = sizeof address;
  if (getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &length) == 0) read_address(address, ip, port);
}

}  // namespace overbend
