#include "platform/socket.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <sstream>

namespace overbend {
namespace {

int descriptor(Socket socket) {
  return static_cast<int>(socket);
}

/// Returns the address that `find` (getpeername, getsockname) reports.
std::optional<SocketAddress> find_address(Socket socket, decltype(::getpeername)& find) {
  sockaddr_in address{};
  socklen_t length = sizeof address;
  if (find(descriptor(socket), reinterpret_cast<sockaddr*>(&address), &length) != 0) return std::nullopt;
  std::array<char, INET_ADDRSTRLEN> text{};
  if (::inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size()) == nullptr) text = {};
  return SocketAddress{text.data(), ntohs(address.sin_port)};
}

/// Returns an endpoint as written in the list: the address as a number in host byte order, then the port. An
/// IPv4-mapped IPv6 address has a longer prefix.
std::string endpoint_text(int port) {
  return fmt::format("{:08X}:{:04X}", htonl(INADDR_LOOPBACK), port);
}

std::optional<unsigned> find_listed_owner(const char* list, const std::string& from, const std::string& to) {
  std::ifstream lines(list);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string number, local, remote, state, queues, timer, retries;
    unsigned owner = 0;
    if (!(fields >> number >> local >> remote >> state >> queues >> timer >> retries >> owner)) continue;
    if (local.ends_with(from) && remote.ends_with(to)) return owner;
  }
  return std::nullopt;
}

}  // namespace

bool wait_for_socket(Socket socket, SocketEvent event, std::chrono::steady_clock::time_point until) {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
    pollfd asked{descriptor(socket), static_cast<short>(event == SocketEvent::readable ? POLLIN : POLLOUT), 0};
    const int found = ::poll(&asked, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (found < 0 && errno == EINTR) continue;
    return found > 0;
  }
}

std::ptrdiff_t receive_bytes(Socket socket, std::span<char> bytes) {
  return ::recv(descriptor(socket), bytes.data(), bytes.size(), 0);
}

std::ptrdiff_t send_bytes(Socket socket, std::span<const char> bytes) {
  return ::send(descriptor(socket), bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

void shut_down_sending(Socket socket) {
  ::shutdown(descriptor(socket), SHUT_WR);
}

void shut_down(Socket socket) {
  ::shutdown(descriptor(socket), SHUT_RDWR);
}

void close_socket(Socket socket) {
  ::close(descriptor(socket));
}

std::optional<SocketAddress> remote_address(Socket socket) {
  return find_address(socket, ::getpeername);
}

std::optional<SocketAddress> local_address(Socket socket) {
  return find_address(socket, ::getsockname);
}

void set_exclusive_port(Socket socket) {
  const int yes = 1;
  ::setsockopt(descriptor(socket), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

void set_max_backlog(Socket socket) {
  ::listen(descriptor(socket), SOMAXCONN);
}

bool is_own_connection(int from, int to) {
  for (const char* list : {"/proc/net/tcp", "/proc/net/tcp6"}) {
    const auto owner = find_listed_owner(list, endpoint_text(from), endpoint_text(to));
    if (owner) return *owner == ::geteuid();
  }
  return false;
}

}  // namespace overbend
