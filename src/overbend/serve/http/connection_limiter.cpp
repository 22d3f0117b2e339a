#include "serve/http/connection_limiter.h"

#include <algorithm>
#include <utility>

namespace overbend {

ConnectionLimiter::Registration::Registration(ConnectionLimiter& keeper, Socket socket, std::uint64_t arrival)
    : limiter_(keeper) {
  const std::lock_guard<std::mutex> hold(limiter_.mutex_);
  std::list<Entry>& all = limiter_.connections_;
  const auto before = std::find_if(all.rbegin(), all.rend(), [&](const Entry& v) { return v.arrival < arrival; });
  place_ = all.insert(before.base(), {socket, arrival, true});
  if (limiter_.closed_) {
    shut_down(socket);
  } else {
    limiter_.close_oldest();
  }
}

ConnectionLimiter::Registration::~Registration() {
  const std::lock_guard<std::mutex> hold(limiter_.mutex_);
  limiter_.connections_.erase(place_);
}

void ConnectionLimiter::Registration::set_authenticated() {
  const std::lock_guard<std::mutex> hold(limiter_.mutex_);
  place_->unauthenticated = false;
}

/// To be called with the mutex held. Connections that are being closed do not count.
void ConnectionLimiter::close_oldest() {
  const auto waiting = [](const Registration::Entry& visitor) {
    return visitor.unauthenticated && visitor.socket != kNoSocket;
  };
  const auto unauthenticated =
      static_cast<std::size_t>(std::count_if(connections_.begin(), connections_.end(), waiting));
  if (unauthenticated <= kMaxUnauthenticated && connections_.size() <= kMaxConnections) return;
  const auto first = std::find_if(connections_.begin(), connections_.end(), waiting);
  if (first != connections_.end()) shut_down(std::exchange(first->socket, kNoSocket));
}

void ConnectionLimiter::close() {
  const std::lock_guard<std::mutex> hold(mutex_);
  closed_ = true;
  for (const Registration::Entry& visitor : connections_) {
    if (visitor.socket != kNoSocket) shut_down(visitor.socket);
  }
}

std::size_t ConnectionLimiter::connection_count() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return connections_.size();
}

}  // namespace overbend
