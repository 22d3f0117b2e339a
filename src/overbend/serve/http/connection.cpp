#include "serve/http/connection.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace overbend {
namespace {

constexpr std::chrono::milliseconds kDrained{2000};
constexpr std::size_t kMaxDrained = 8U << 20U;  // [bytes]

void read_address(const std::optional<SocketAddress>& address, std::string& ip, int& port) {
  if (!address) return;
  ip = address->ip;
  port = address->port;
}

}  // namespace

Connection::Connection(Socket socket, const RequestBounds& bounds) : socket_(socket), bounds_(bounds) {}

bool Connection::wait_for_request() {
  if (next_ == filled_ && !wait_for_socket(socket_, SocketEvent::readable, Clock::now() + bounds_.idle)) return false;
  until_ = Clock::now() + bounds_.head;
  allowed_ = bounds_.max_head;
  return true;
}

void Connection::expect_body(std::uint64_t size) {
  until_ = Clock::now() + bounds_.body;
  allowed_ = size;
}

void Connection::drain() {
  shut_down_sending(socket_);
  const Clock::time_point until = Clock::now() + kDrained;
  std::size_t taken = 0;
  while (taken < kMaxDrained && wait_for_socket(socket_, SocketEvent::readable, until)) {
    const std::ptrdiff_t count = receive_bytes(socket_, buffer_);
    if (count <= 0) return;
    taken += static_cast<std::size_t>(count);
  }
}

bool Connection::is_readable() const {
  return next_ < filled_ || wait_for_socket(socket_, SocketEvent::readable, until_);
}

bool Connection::is_writable() const {
  return wait_for_socket(socket_, SocketEvent::writable, Clock::now() + bounds_.write);
}

ssize_t Connection::read(char* to, std::size_t size) {
  size = static_cast<std::size_t>(std::min<std::uint64_t>(size, allowed_));
  if (size == 0) return -1;
  if (next_ == filled_) {
    if (!wait_for_socket(socket_, SocketEvent::readable, until_)) return -1;
    const std::ptrdiff_t count = receive_bytes(socket_, buffer_);
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
  return send_bytes(socket_, {from, size});
}

void Connection::get_remote_ip_and_port(std::string& ip, int& port) const {
  read_address(remote_address(socket_), ip, port);
}

void Connection::get_local_ip_and_port(std::string& ip, int& port) const {
  read_address(local_address(socket_), ip, port);
}

}  // namespace overbend
