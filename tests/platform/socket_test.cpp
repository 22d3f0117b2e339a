#include "platform/socket.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>

namespace overbend {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// Two connected sockets.
class SocketPair {
 public:
  SocketPair() { EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0); }
  ~SocketPair() {
    for (const int end : ends_) close_socket(end);
  }
  SocketPair(const SocketPair&) = delete;
  SocketPair& operator=(const SocketPair&) = delete;

  Socket operator[](std::size_t index) const { return ends_[index]; }

 private:
  std::array<int, 2> ends_{};
};

bool is_readable(Socket socket, milliseconds patience = milliseconds(0)) {
  return wait_for_socket(socket, SocketEvent::readable, steady_clock::now() + patience);
}

TEST(socket, bytes_that_are_sent_arrive) {
  const SocketPair sockets;
  EXPECT_FALSE(is_readable(sockets[1]));
  EXPECT_TRUE(wait_for_socket(sockets[0], SocketEvent::writable, steady_clock::now()));
  EXPECT_EQ(send_bytes(sockets[0], std::string_view("text")), 4);
  EXPECT_TRUE(is_readable(sockets[1], milliseconds(5000)));
  std::array<char, 8> bytes{};
  EXPECT_EQ(receive_bytes(sockets[1], bytes), 4);
  EXPECT_STREQ(bytes.data(), "text");
}

TEST(socket, waiting_ends_at_its_time) {
  const SocketPair sockets;
  const auto begin = steady_clock::now();
  EXPECT_FALSE(is_readable(sockets[0], milliseconds(20)));
  EXPECT_GE(steady_clock::now() - begin, milliseconds(20));
}

TEST(socket, after_the_end_of_sending_the_stream_ends_and_the_other_way_stays_open) {
  const SocketPair sockets;
  std::array<char, 8> bytes{};
  shut_down_sending(sockets[0]);
  EXPECT_TRUE(is_readable(sockets[1]));
  EXPECT_EQ(receive_bytes(sockets[1], bytes), 0);
  EXPECT_EQ(send_bytes(sockets[1], std::string_view("x")), 1);
  EXPECT_EQ(receive_bytes(sockets[0], bytes), 1);
}

TEST(socket, sending_on_a_closed_connection_is_an_error_and_no_signal) {
  const SocketPair sockets;
  shut_down(sockets[1]);
  EXPECT_LT(send_bytes(sockets[0], std::string_view("x")), 0);
}

TEST(socket, a_missing_connection_belongs_to_another_user) {
  EXPECT_FALSE(is_own_connection(1, 2));
  EXPECT_FALSE(remote_address(kNoSocket));
}

}  // namespace
}  // namespace overbend
