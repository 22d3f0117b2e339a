#include "base/child_work.h"

#include <cstdint>
#include <cstring>

#include "base/interruption.h"

namespace overbend {
namespace {

/// Message of the child: kind, length of the text, and text.
enum class Answer : char { result = 'r', error = 'f' };
constexpr std::size_t kHead = 1 + sizeof(std::uint64_t);

std::string answer_text(Answer kind, const std::string& text) {
  const std::uint64_t length = text.size();
  std::string message(kHead, static_cast<char>(kind));
  std::memcpy(message.data() + 1, &length, sizeof length);
  return message + text;
}

std::string answer_to(const std::function<std::string()>& work) {
  try {
    return answer_text(Answer::result, work());
  } catch (const std::bad_alloc&) {
    return answer_text(Answer::error, "reading it takes too much memory");
  } catch (const std::exception& error) {
    return answer_text(Answer::error, error.what());
  } catch (...) {
    return answer_text(Answer::error, "reading it failed");
  }
}

bool is_complete_message(const std::string& message) {
  if (message.size() < kHead) return false;
  std::uint64_t length = 0;
  std::memcpy(&length, message.data() + 1, sizeof length);
  return message.size() - kHead == length;
}

/// Text of a complete message.
std::string message_text(const std::string& message) {
  const bool is_error = message[0] == static_cast<char>(Answer::error);
  std::string text = message.substr(kHead);
  if (is_error) throw std::runtime_error(text);
  return text;
}

}  // namespace

ChildWork::ChildWork(const std::function<std::string()>& work, const ChildLimits& limits)
    : until_(std::chrono::steady_clock::now() + limits.wall_time),
      process_([&] { return answer_to(work); }, {limits.cpu_time, limits.memory}, error_) {
  if (error_) throw ChildError("no process can be started: " + error_.message());
}

void ChildWork::throw_end_reason() {
  const ProcessEnd end = process_.wait();
  if (end.out_of_time) throw ChildError("reading it takes too long");
  throw ChildError("reading it ended with signal " + std::to_string(end.signal));
}

std::string ChildWork::result() {
  constexpr std::chrono::milliseconds kPatience{100};
  for (;;) {
    check_interruption();
    const ProcessCopy::Arrival arrival = process_.read(received_, kPatience);
    if (arrival == ProcessCopy::Arrival::end) break;
    if (arrival == ProcessCopy::Arrival::none && std::chrono::steady_clock::now() >= until_) {
      throw ChildError("reading it takes too long");
    }
  }
  if (!is_complete_message(received_)) throw_end_reason();
  process_.wait();
  return message_text(received_);
}

}  // namespace overbend
