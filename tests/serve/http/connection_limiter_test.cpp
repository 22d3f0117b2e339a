#include "serve/http/connection_limiter.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <vector>

namespace overbend {
namespace {

/// A connection and its visit.
class Guest {
 public:
  Guest(ConnectionLimiter& keeper, std::uint64_t arrival) {
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0);
    visit_ = std::make_unique<ConnectionLimiter::Registration>(keeper, ends_[0], arrival);
  }
  ~Guest() {
    visit_.reset();
    ::close(ends_[0]);
    ::close(ends_[1]);
  }
  Guest(const Guest&) = delete;
  Guest& operator=(const Guest&) = delete;

  ConnectionLimiter::Registration& registration() { return *visit_; }
  bool sent_away() const {
    char byte = 0;
    return ::recv(ends_[1], &byte, 1, MSG_DONTWAIT) == 0;
  }

 private:
  std::array<int, 2> ends_{};
  std::unique_ptr<ConnectionLimiter::Registration> visit_;
};

TEST(connection_limiter, sends_away_who_came_first_even_where_others_are_heard_of_before) {
  ConnectionLimiter keeper;
  Guest last(keeper, 1000);  // its thread began before those of all others
  std::vector<std::unique_ptr<Guest>> crowd;
  for (std::uint64_t arrival = 1; arrival <= ConnectionLimiter::kMaxUnauthenticated + 2; ++arrival) {
    crowd.push_back(std::make_unique<Guest>(keeper, arrival));
  }
  EXPECT_FALSE(last.sent_away());
  for (std::size_t i = 0; i < crowd.size(); ++i) EXPECT_EQ(crowd[i]->sent_away(), i < 3) << i;
}

TEST(connection_limiter, keeps_who_is_known) {
  ConnectionLimiter keeper;
  Guest known(keeper, 0);
  known.registration().set_authenticated();
  std::vector<std::unique_ptr<Guest>> crowd;
  for (std::uint64_t arrival = 1; arrival <= ConnectionLimiter::kMaxUnauthenticated + 1; ++arrival) {
    crowd.push_back(std::make_unique<Guest>(keeper, arrival));
  }
  EXPECT_FALSE(known.sent_away());
  EXPECT_TRUE(crowd.front()->sent_away());
  EXPECT_FALSE(crowd.back()->sent_away());
}

}  // namespace
}  // namespace overbend
