/// Events that the server sends to its pages.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>

#include "serve/http/http.h"

namespace overbend {

/// The last events, for any number of listeners, each at its own pace. All functions may be called from any thread.
class EventHub {
 public:
  /// Sends an event; `topic`, where given, takes the place of earlier ones of the same topic that a listener has not
  /// heard yet: progress is worth telling only as it is now.
  void send(const std::string& name, const Json& data, const std::string& topic = "");

  /// Number of the newest event: where a new listener begins.
  std::uint64_t newest() const;

  /// Events after number `last` as text of an event stream, waiting up to a second for one. Moves `last` on.
  std::string wait(std::uint64_t& last);

  /// Nobody waits any more, and whoever comes leaves at once.
  void close();
  bool closed() const;

 private:
  struct Event {
    std::uint64_t number = 0;
    std::string topic, text;
  };
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Event> events_;
  std::uint64_t newest_ = 0;
  bool closed_ = false;
};

}  // namespace overbend
