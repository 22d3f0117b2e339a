#include "platform/socket.h"

namespace overbend {

bool wait_for_socket(Socket /*socket*/, SocketEvent /*event*/, std::chrono::steady_clock::time_point /*until*/) {
  return false;
}

std::ptrdiff_t receive_bytes(Socket /*socket*/, std::span<char> /*bytes*/) {
  return -1;
}

std::ptrdiff_t send_bytes(Socket /*socket*/, std::span<const char> /*bytes*/) {
  return -1;
}

void shut_down_sending(Socket /*socket*/) {}

void shut_down(Socket /*socket*/) {}

void close_socket(Socket /*socket*/) {}

std::optional<SocketAddress> remote_address(Socket /*socket*/) {
  return std::nullopt;
}

std::optional<SocketAddress> local_address(Socket /*socket*/) {
  return std::nullopt;
}

void set_exclusive_port(Socket /*socket*/) {}

void set_max_backlog(Socket /*socket*/) {}

bool is_own_connection(int /*from*/, int /*to*/) {
  return false;
}

}  // namespace overbend
