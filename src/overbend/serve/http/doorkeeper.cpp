#include "serve/http/doorkeeper.h"

#include <sys/socket.h>

#include <algorithm>
#include <utility>

namespace overbend {
namespace {

/// Ends the connection for both sides; the thread that waits on it wakes up and closes the socket.
void send_away(int socket) {
  ::shutdown(socket, SHUT_RDWR);
}

}  // namespace

Doorkeeper::Visit::Visit(Doorkeeper& keeper, int socket, std::uint64_t arrival) : keeper_(keeper) {
  const std::lock_guard<std::mutex> hold(keeper_.mutex_);
  std::list<Visitor>& all = keeper_.visitors_;
  const auto before = std::find_if(all.rbegin(), all.rend(), [&](const Visitor& v) { return v.arrival < arrival; });
  place_ = all.insert(before.base(), {socket, arrival, true});
  if (keeper_.closed_) {
    send_away(socket);
  } else {
    keeper_.make_room();
  }
}

Doorkeeper::Visit::~Visit() {
  const std::lock_guard<std::mutex> hold(keeper_.mutex_);
  keeper_.visitors_.erase(place_);
}

void Doorkeeper::Visit::trust() {
  const std::lock_guard<std::mutex> hold(keeper_.mutex_);
  place_->stranger = false;
}

/// Called with the mutex held. Who was sent away already counts no more.
void Doorkeeper::make_room() {
  const auto waiting = [](const Visit::Visitor& visitor) { return visitor.stranger && visitor.socket >= 0; };
  const auto strangers = static_cast<std::size_t>(std::count_if(visitors_.begin(), visitors_.end(), waiting));
  if (strangers <= kMostStrangers && visitors_.size() <= kMostVisitors) return;
  const auto first = std::find_if(visitors_.begin(), visitors_.end(), waiting);
  if (first != visitors_.end()) send_away(std::exchange(first->socket, -1));
}

void Doorkeeper::close() {
  const std::lock_guard<std::mutex> hold(mutex_);
  closed_ = true;
  for (const Visit::Visitor& visitor : visitors_) {
    if (visitor.socket >= 0) send_away(visitor.socket);
  }
}

std::size_t Doorkeeper::visitors() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return visitors_.size();
}

}  // namespace overbend
