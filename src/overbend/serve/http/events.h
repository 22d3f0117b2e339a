/// Events sent by the server to open pages.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>

#include "serve/http/http.h"

namespace overbend {

/// Keeps the latest events for any number of independent listeners. All functions may be called from any thread.
class EventHub {
 public:
  /// Sends an event. With a `topic`, it replaces pending events of the same topic: only the latest progress matters.
  void send(const std::string& name, const Json& data, const std::string& topic = "");

  /// Returns the number of the newest event, from which a new listener starts.
  std::uint64_t newest() const;

  /// Returns the events after number `last` as text of an event stream. Updates `last`.
  std::string since(std::uint64_t& last) const;
  /// The same, waiting up to 1 s for an event.
  std::string wait(std::uint64_t& last);

  /// Ends all waits, including later ones.
  void close();
  bool closed() const;

 private:
  struct Event {
    std::uint64_t number = 0;
    std::string topic, text;
  };
  std::string unread(std::uint64_t& last) const;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Event> events_;
  std::uint64_t newest_ = 0;
  bool closed_ = false;
};

}  // namespace overbend
