#include "platform/socket.h"

#include <algorithm>
#include <vector>

#include "platform/windows/system.h"

namespace overbend {
namespace {

SOCKET system_socket(Socket socket) {
  return static_cast<SOCKET>(socket);
}

/// Length of a part for the system, which counts in int.
int part_length(std::size_t size) {
  return static_cast<int>(std::min<std::size_t>(size, std::size_t{1} << 30U));
}

/// Returns the address that `find` (getpeername, getsockname) reports.
std::optional<SocketAddress> find_address(Socket socket, int(WSAAPI* find)(SOCKET, sockaddr*, int*)) {
  sockaddr_in address{};
  int length = sizeof address;
  if (find(system_socket(socket), reinterpret_cast<sockaddr*>(&address), &length) != 0) return std::nullopt;
  char text[INET_ADDRSTRLEN] = {};
  ::inet_ntop(AF_INET, &address.sin_addr, text, sizeof text);
  return SocketAddress{text, ntohs(address.sin_port)};
}

/// Returns the number of the process with the end `from` of a connection between these loopback ports; 0 if none.
DWORD find_process(int from, int to) {
  ULONG size = 0;
  std::vector<std::byte> bytes;
  while (::GetExtendedTcpTable(bytes.data(), &size, FALSE, AF_INET, TCP_TABLE_OWNER_PID_CONNECTIONS, 0) ==
         ERROR_INSUFFICIENT_BUFFER) {
    bytes.resize(size);
  }
  if (bytes.empty()) return 0;
  const auto& table = *reinterpret_cast<const MIB_TCPTABLE_OWNER_PID*>(bytes.data());
  const u_long loopback = htonl(INADDR_LOOPBACK);
  for (DWORD i = 0; i < table.dwNumEntries; ++i) {
    const MIB_TCPROW_OWNER_PID& row = table.table[i];
    const int local = ntohs(static_cast<u_short>(row.dwLocalPort));
    const int remote = ntohs(static_cast<u_short>(row.dwRemotePort));
    if (row.dwLocalAddr == loopback && row.dwRemoteAddr == loopback && local == from && remote == to) {
      return row.dwOwningPid;
    }
  }
  return 0;
}

/// Returns the user of a process as the system stores it; empty if this process may not know.
std::vector<std::byte> find_user(HANDLE process) {
  Handle token;
  DWORD size = 0;
  if (::OpenProcessToken(process, TOKEN_QUERY, token.address()) == FALSE) return {};
  ::GetTokenInformation(token.get(), TokenUser, nullptr, 0, &size);
  std::vector<std::byte> user(size);
  if (::GetTokenInformation(token.get(), TokenUser, user.data(), size, &size) == FALSE) return {};
  return user;
}

}  // namespace

bool wait_for_socket(Socket socket, SocketEvent event, std::chrono::steady_clock::time_point until) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
  WSAPOLLFD asked{system_socket(socket), static_cast<SHORT>(event == SocketEvent::readable ? POLLIN : POLLOUT), 0};
  return ::WSAPoll(&asked, 1, static_cast<INT>(std::max<std::int64_t>(left.count(), 0))) > 0;
}

std::ptrdiff_t receive_bytes(Socket socket, std::span<char> bytes) {
  return ::recv(system_socket(socket), bytes.data(), part_length(bytes.size()), 0);
}

std::ptrdiff_t send_bytes(Socket socket, std::span<const char> bytes) {
  return ::send(system_socket(socket), bytes.data(), part_length(bytes.size()), 0);
}

void shut_down_sending(Socket socket) {
  ::shutdown(system_socket(socket), SD_SEND);
}

void shut_down(Socket socket) {
  ::shutdown(system_socket(socket), SD_BOTH);
}

void close_socket(Socket socket) {
  ::closesocket(system_socket(socket));
}

std::optional<SocketAddress> remote_address(Socket socket) {
  return find_address(socket, ::getpeername);
}

std::optional<SocketAddress> local_address(Socket socket) {
  return find_address(socket, ::getsockname);
}

void set_exclusive_port(Socket socket) {
  const BOOL yes = TRUE;  // SO_REUSEADDR would let two programs share the port here
  ::setsockopt(system_socket(socket), SOL_SOCKET, SO_EXCLUSIVEADDRUSE, reinterpret_cast<const char*>(&yes), sizeof yes);
}

void set_max_backlog(Socket socket) {
  ::listen(system_socket(socket), SOMAXCONN);
}

bool is_own_connection(int from, int to) {
  const DWORD number = find_process(from, to);
  if (number == 0) return false;
  const Handle process(::OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, number));
  if (!process) return false;
  const std::vector<std::byte> owner = find_user(process.get()), user = find_user(::GetCurrentProcess());
  if (owner.empty() || user.empty()) return false;
  return ::EqualSid(reinterpret_cast<const TOKEN_USER*>(owner.data())->User.Sid,
                    reinterpret_cast<const TOKEN_USER*>(user.data())->User.Sid) != FALSE;
}

}  // namespace overbend
