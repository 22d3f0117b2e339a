/// Limits the number of open connections, so that slow unauthenticated clients cannot block the page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <mutex>

#include "platform/socket.h"

namespace overbend {

/// A connection is unauthenticated until a request with the token has arrived on it. If there are too many, the oldest
/// unauthenticated connection is closed, because requests of the page complete quickly. All functions may be called
/// from any thread.
class ConnectionLimiter {
 public:
  static constexpr std::size_t kMaxUnauthenticated = 64;
  static constexpr std::size_t kMaxConnections = 256;  ///< Maximum number of all connections.

  /// Registers a connection during its lifetime; the socket must stay open as long.
  class Registration {
   public:
    /// `arrival` is the order of acceptance, because threads may start in any order.
    Registration(ConnectionLimiter& keeper, Socket socket, std::uint64_t arrival);
    ~Registration();
    Registration(const Registration&) = delete;
    Registration& operator=(const Registration&) = delete;

    /// Marks the connection as authenticated.
    void set_authenticated();

   private:
    struct Entry {
      Socket socket = kNoSocket;
      std::uint64_t arrival = 0;
      bool unauthenticated = true;
    };
    friend class ConnectionLimiter;

    ConnectionLimiter& limiter_;
    std::list<Entry>::iterator place_;
  };

  /// Closes all connections, including later ones.
  void close();

  /// Returns the number of open connections.
  std::size_t connection_count() const;

 private:
  void close_oldest();

  mutable std::mutex mutex_;
  std::list<Registration::Entry> connections_;  ///< In order of arrival.
  bool closed_ = false;
};

}  // namespace overbend
