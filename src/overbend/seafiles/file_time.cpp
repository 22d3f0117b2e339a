#include "seafiles/file_time.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace overbend {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::vector<std::string_view> digit_groups(std::string_view text) {
  std::vector<std::string_view> groups;
  for (std::size_t from = 0, to = 0; from < text.size(); from = to) {
    while (from < text.size() && !is_digit(text[from])) ++from;
    for (to = from; to < text.size() && is_digit(text[to]); ++to) continue;
    if (to > from) groups.push_back(text.substr(from, to - from));
  }
  return groups;
}

/// Splits 20260601.094000.
std::vector<std::string_view> split_compact(const std::vector<std::string_view>& groups) {
  if (groups.empty() || groups.size() > 2 || groups[0].size() != 8) return groups;
  std::vector<std::string_view> parts = {groups[0].substr(0, 4), groups[0].substr(4, 2), groups[0].substr(6, 2)};
  if (groups.size() == 1) return parts;
  for (std::size_t from = 0; from + 2 <= groups[1].size() && from < 6; from += 2) {
    parts.push_back(groups[1].substr(from, 2));
  }
  return parts;
}

int number(std::string_view digits) {
  int value = 0;
  for (const char c : digits) value = 10 * value + (c - '0');
  return value;
}

}  // namespace

std::optional<FileTime> parse_file_time(std::string_view text) {
  const std::vector<std::string_view> parts = split_compact(digit_groups(text));
  FileTime time{};
  if (parts.size() < 3 || parts.size() > time.size()) return std::nullopt;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].size() > 4) return std::nullopt;
    time[i] = number(parts[i]);
  }
  if (parts[0].size() == 2) time[0] += time[0] < 70 ? 2000 : 1900;
  constexpr FileTime kLowest = {1000, 1, 1, 0, 0, 0}, kHighest = {9999, 12, 31, 24, 59, 60};
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] < kLowest[i] || time[i] > kHighest[i]) return std::nullopt;
  }
  return time;
}

std::string file_time_label(const FileTime& time) {
  std::string text = fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", time[0], time[1], time[2], time[3], time[4]);
  return time[5] == 0 ? text : text + fmt::format(":{:02}", time[5]);
}

std::optional<std::size_t> choose_time(const std::vector<FileTime>& times, const TimeChoice& choice,
                                       Diagnostics& diagnostics) {
  const auto reject = [&](std::string found, std::string expected, std::string hint = {}) {
    diagnostics.add(
        {Severity::error, choice.path, 0, 0, choice.key, std::move(found), std::move(expected), std::move(hint)});
    return std::nullopt;
  };
  if (times.empty()) return reject("no row with a time", "at least one");
  const auto [first, last] = std::minmax_element(times.begin(), times.end());
  const std::string range = times.size() == 1 ? "the only one, " + file_time_label(*first)
                                              : fmt::format("one of {} times, {} to {}", times.size(),
                                                            file_time_label(*first), file_time_label(*last));
  if (choice.wanted.empty()) {
    if (times.size() == 1) return 0;
    return reject(
        fmt::format("{} times, {} to {}, and no choice", times.size(), file_time_label(*first), file_time_label(*last)),
        "one of them", "for example time: " + file_time_label(*first));
  }
  const std::optional<FileTime> wanted = parse_file_time(choice.wanted);
  if (!wanted) return reject("'" + for_display(choice.wanted) + "'", "a time such as " + file_time_label(*last));
  const auto found = std::find(times.begin(), times.end(), *wanted);
  if (found == times.end()) return reject("no row of " + file_time_label(*wanted), range);
  return static_cast<std::size_t>(found - times.begin());
}

}  // namespace overbend
