/// Sockets of a server on the loopback address.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace overbend {

using Socket = std::intptr_t;  ///< Handle of the system.
inline constexpr Socket kNoSocket = -1;

enum class SocketEvent { readable, writable };

/// Waits until the event, or the end or an error of the connection, has occurred; false if it has not by `until`.
bool wait_for_socket(Socket socket, SocketEvent event, std::chrono::steady_clock::time_point until);

/// Returns the number of bytes received; 0 at the end of the stream, negative after an error.
std::ptrdiff_t receive_bytes(Socket socket, std::span<char> bytes);

/// Returns the number of bytes sent, negative after an error. A closed connection is an error, not a signal.
std::ptrdiff_t send_bytes(Socket socket, std::span<const char> bytes);

/// Ends sending; the other end reads the end of the stream.
void shut_down_sending(Socket socket);

/// Ends sending and receiving; threads that wait for the socket wake up.
void shut_down(Socket socket);

void close_socket(Socket socket);

struct SocketAddress {
  std::string ip;
  int port = 0;
};
std::optional<SocketAddress> remote_address(Socket socket);
std::optional<SocketAddress> local_address(Socket socket);

/// Lets a server bind a port that an ended one has used just now, but no two servers the same port. To be called before
/// it is bound.
void set_exclusive_port(Socket socket);

/// Sets the number of waiting connections of a listening socket to the system's maximum.
void set_max_backlog(Socket socket);

/// True if the end `from` of the connection between the loopback ports `from` and `to` belongs to a process of the user
/// of this process.
bool is_own_connection(int from, int to);

}  // namespace overbend
