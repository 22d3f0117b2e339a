/// One connection of the HTTP library, with bounds on time and size.
#pragma once

#include <httplib.h>
#undef _res  // <resolv.h> has it as a macro, Eigen as a name

#include <array>
#include <chrono>
#include <cstdint>

namespace overbend {

/// Limits of a request.
struct RequestBounds {
  std::chrono::milliseconds idle{5000};   ///< Between requests.
  std::chrono::milliseconds head{10000};  ///< From the first byte to the end of the headers.
  std::chrono::milliseconds body{30000};
  std::chrono::milliseconds write{5000};  ///< For the other side to take some of an answer.
  std::size_t largest_head = 64U << 10U;  ///< [bytes]
};

/// A socket as the library's stream. Reading ends with a fault when the request takes longer or is larger than it may.
class Connection : public httplib::Stream {
 public:
  /// Does not own the socket.
  Connection(int socket, const RequestBounds& bounds);

  /// Waits for the first byte of a request; false when none comes. The head may be read then.
  bool wait_for_request();
  /// The head is read; a body of that size may be read now.
  void expect_body(std::uint64_t size);
  /// What of the body has not been read [bytes].
  std::uint64_t unread() const { return allowed_; }
  /// Takes what the other side still sends, for a while: closing before would destroy the answer on its way.
  void drain();

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  int socket() const override { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool wait(short event, Clock::time_point until) const;

  int socket_;
  RequestBounds bounds_;
  std::array<char, 4096> buffer_{};
  std::size_t next_ = 0, filled_ = 0;  ///< What of the buffer is not read yet.
  Clock::time_point until_;
  std::uint64_t allowed_ = 0;  ///< That may still be read [bytes].
};

}  // namespace overbend
