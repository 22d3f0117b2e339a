/// Connection of the HTTP library with limits on time and size.
#pragma once

#include <httplib.h>
#undef _res  // a macro in <resolv.h> and a name in Eigen

#include <array>
#include <chrono>
#include <cstdint>

#include "platform/socket.h"

namespace overbend {

/// Limits of a request.
struct RequestBounds {
  std::chrono::milliseconds idle{5000};   ///< Maximum time between requests.
  std::chrono::milliseconds head{10000};  ///< Maximum time from the first byte to the end of the headers.
  std::chrono::milliseconds body{30000};
  std::chrono::milliseconds write{5000};  ///< Maximum time for the client to accept part of an answer.
  std::size_t max_head = 64U << 10U;      ///< [bytes]
};

/// A socket as a stream of the library. Reading fails if the request takes too long or is too large.
class Connection : public httplib::Stream {
 public:
  /// Does not own the socket.
  Connection(Socket socket, const RequestBounds& bounds);

  /// Waits for the first byte of a request, after which the head may be read. Returns false if none arrives.
  bool wait_for_request();
  /// To be called after the head: allows reading a body of this size [bytes].
  void expect_body(std::uint64_t size);
  /// Returns the number of bytes of the body that have not been read.
  std::uint64_t unread() const { return allowed_; }
  /// Reads remaining input for up to 2 s: closing the socket earlier would discard the answer in transit.
  void drain();

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return static_cast<socket_t>(socket_); }

 private:
  using Clock = std::chrono::steady_clock;

  Socket socket_;
  RequestBounds bounds_;
  std::array<char, 4096> buffer_{};
  std::size_t next_ = 0, filled_ = 0;  ///< Range of the buffer that has not been read.
  Clock::time_point until_;
  std::uint64_t allowed_ = 0;  ///< Number of bytes that may still be read.
};

}  // namespace overbend
