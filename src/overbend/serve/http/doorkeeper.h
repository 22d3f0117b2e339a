/// Who is at the door: all open connections, so that slow strangers cannot keep the page out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <mutex>

namespace overbend {

/// A connection is a stranger's until a request with the token has come over it. When too many strangers are there, the
/// one that came first is sent away: a page's request is complete in an instant, what has dallied longest is not one.
/// All functions may be called from any thread.
class Doorkeeper {
 public:
  static constexpr std::size_t kMostStrangers = 64;
  static constexpr std::size_t kMostVisitors = 256;  ///< Strangers and others.

  /// A connection is known while this lives; the socket must stay open as long.
  class Visit {
   public:
    /// `arrival`: of two the smaller came first, whichever is heard of first: threads begin in any order.
    Visit(Doorkeeper& keeper, int socket, std::uint64_t arrival);
    ~Visit();
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

    /// Its requests bear the token.
    void trust();

   private:
    struct Visitor {
      int socket = -1;
      std::uint64_t arrival = 0;
      bool stranger = true;
    };
    friend class Doorkeeper;

    Doorkeeper& keeper_;
    std::list<Visitor>::iterator place_;
  };

  /// Sends everybody away, and whoever comes later.
  void close();

  std::size_t visitors() const;

 private:
  void make_room();

  mutable std::mutex mutex_;
  std::list<Visit::Visitor> visitors_;  ///< In the order they came.
  bool closed_ = false;
};

}  // namespace overbend
