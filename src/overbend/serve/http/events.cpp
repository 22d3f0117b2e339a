#include "serve/http/events.h"

#include <chrono>

namespace overbend {
namespace {

constexpr std::size_t kMaxKeptEvents = 200;

}  // namespace

void EventHub::send(const std::string& name, const Json& data, const std::string& topic) {
  const std::string text = "event: " + name + "\ndata: " + json_text(data) + "\n\n";
  const std::lock_guard<std::mutex> hold(mutex_);
  if (!topic.empty()) std::erase_if(events_, [&](const Event& event) { return event.topic == topic; });
  events_.push_back({++newest_, topic, text});
  if (events_.size() > kMaxKeptEvents) events_.pop_front();
  changed_.notify_all();
}

std::uint64_t EventHub::newest() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return newest_;
}

std::string EventHub::wait(std::uint64_t& last) {
  std::unique_lock<std::mutex> hold(mutex_);
  changed_.wait_for(hold, std::chrono::seconds(1), [&] { return closed_ || newest_ > last; });
  return unread(last);
}

std::string EventHub::since(std::uint64_t& last) const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return unread(last);
}

std::string EventHub::unread(std::uint64_t& last) const {
  std::string text;
  for (const Event& event : events_) {
    if (event.number > last) text += event.text;
  }
  last = newest_;
  return text;
}

void EventHub::close() {
  const std::lock_guard<std::mutex> hold(mutex_);
  closed_ = true;
  changed_.notify_all();
}

bool EventHub::closed() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return closed_;
}

}  // namespace overbend
