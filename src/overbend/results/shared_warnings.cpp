#include "results/shared_warnings.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace overbend {
namespace {

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// A text cut at its numbers: words.size() is numbers.size() + 1.
struct Cut {
  std::vector<std::string> words, numbers;
};

/// Where the number that begins at `first` ends; `first` where none does.
std::size_t end_of_number(const std::string& text, std::size_t first) {
  std::size_t at = first + (text[first] == '-' ? 1 : 0);
  if (at >= text.size() || !is_digit(text[at])) return first;
  char* end = nullptr;
  std::strtod(text.c_str() + first, &end);
  const auto behind = static_cast<std::size_t>(end - text.c_str());
  const bool full_stop = text[behind - 1] == '.';
  return behind < text.size() && in_word(text[behind]) ? first : behind - (full_stop ? 1 : 0);
}

Cut cut(const std::string& text) {
  Cut out;
  out.words.emplace_back();
  char quote = 0;  // which is open
  for (std::size_t i = 0; i < text.size();) {
    const char before = i == 0 ? ' ' : text[i - 1];
    if (quote != 0) {
      if (text[i] == quote) quote = 0;
    } else if ((text[i] == '\'' || text[i] == '"') && !in_word(before)) {  // else an apostrophe
      quote = text[i];
    }
    const bool may_begin = quote == 0 && !in_word(before) && before != '-' && before != '.';
    const std::size_t end = may_begin ? end_of_number(text, i) : i;
    if (end == i) {
      out.words.back() += text[i++];
      continue;
    }
    out.numbers.push_back(text.substr(i, end - i));
    out.words.emplace_back();
    i = end;
  }
  return out;
}

double value_of(const std::string& number) {
  return std::strtod(number.c_str(), nullptr);
}

/// One warning of all the runs that have it.
struct Gathered {
  Cut least;
  std::vector<std::string> largest;  ///< As many as `least` has numbers.
  int runs = 0;
  std::size_t last_run = 0;  ///< Counted from 1; 0: none yet.

  void take(const Cut& one) {
    for (std::size_t i = 0; i < largest.size(); ++i) {
      if (value_of(one.numbers[i]) < value_of(least.numbers[i])) least.numbers[i] = one.numbers[i];
      if (value_of(one.numbers[i]) > value_of(largest[i])) largest[i] = one.numbers[i];
    }
  }

  std::string text() const {
    std::string all = least.words.front();
    for (std::size_t i = 0; i < largest.size(); ++i) {
      all += least.numbers[i];
      if (least.numbers[i] != largest[i]) all += " .. " + largest[i];
      all += least.words[i + 1];
    }
    return all;
  }
};

}  // namespace

std::vector<SharedWarning> shared_warnings(const std::vector<std::vector<std::string>>& of_runs) {
  std::vector<Gathered> gathered;
  for (std::size_t run = 1; run <= of_runs.size(); ++run) {
    for (const std::string& warning : of_runs[run - 1]) {
      const Cut one = cut(warning);
      auto known = std::find_if(gathered.begin(), gathered.end(),
                                [&](const Gathered& other) { return other.least.words == one.words; });
      if (known == gathered.end()) known = gathered.insert(known, {one, one.numbers, 0, 0});
      known->take(one);
      known->runs += known->last_run == run ? 0 : 1;
      known->last_run = run;
    }
  }
  std::vector<SharedWarning> shared;
  for (const Gathered& one : gathered) shared.push_back({one.text(), one.runs});
  return shared;
}

}  // namespace overbend
