#include "base/unit_lexer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "base/read_double.h"
#include "base/text.h"

namespace overbend {
namespace {

constexpr std::string_view kMiddleDot = "\u00b7";
constexpr std::string_view kSuperscriptPlus = "\u207a", kSuperscriptMinus = "\u207b";
constexpr std::string_view kSuperscripts[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                              "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::size_t count_digits(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
}

std::size_t count_spaces(std::string_view text) {
  return std::min(text.find_first_not_of(" \t\r\f\v"), text.size());
}

/// Length of a letter: ASCII, the letters of Latin-1, most others up to U+FFFF; superscripts are letters too.
std::size_t letter_length(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const auto within = [&](std::size_t i, unsigned from, unsigned to) { return byte(i) >= from && byte(i) <= to; };
  if (within(0, 'a', 'z') || within(0, 'A', 'Z') || byte(0) == '_') return 1;
  if (byte(0) == 0xc2) return byte(1) == 0xa0 || byte(1) == 0xad || byte(1) == 0xb0 || byte(1) == 0xb5 ? 2 : 0;
  if (byte(0) == 0xc3) return within(1, 0x80, 0xbf) && byte(1) != 0x97 && byte(1) != 0xb7 ? 2 : 0;
  if (within(0, 0xc8, 0xdf)) return within(1, 0x80, 0xbf) ? 2 : 0;
  return within(0, 0xe0, 0xef) && within(1, 0x80, 0xbf) && within(2, 0x80, 0xbf) ? 3 : 0;
}

/// Length of a name: letters, and digits between them ("H2O").
std::size_t name_length(std::string_view text) {
  if (text.front() == '%' || text.front() == '\'' || text.front() == '"') return 1;
  std::size_t length = 0;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t letter = letter_length(text.substr(i));
    if (letter == 0 && (i == 0 || !is_digit(text[i]))) break;
    i += std::max<std::size_t>(letter, 1);
    if (letter > 0) length = i;
  }
  return length;
}

/// True if the text starts with the word, given in small letters, in capitals or not.
bool starts_with_word(std::string_view text, std::string_view word) {
  const auto same = [](char letter, char c) {
    return letter == c || (c >= 'A' && c <= 'Z' && letter == c - 'A' + 'a');
  };
  return text.size() >= word.size() && std::equal(word.begin(), word.end(), text.begin(), same);
}

/// Length of one of the words, in capitals or not, with the spaces around it.
std::size_t word_length(std::string_view text, std::initializer_list<std::string_view> choices) {
  const std::size_t start = count_spaces(text);
  for (const std::string_view word : choices) {
    if (!starts_with_word(text.substr(start), word)) continue;
    const std::size_t end = start + word.size();
    return end + count_spaces(text.substr(end));
  }
  return 0;
}

/// Length of a multiplication sign; a minus and white space are such signs too.
std::size_t multiply_length(std::string_view text) {
  if (text.starts_with(kMiddleDot)) return kMiddleDot.size();
  return text.find_first_of("-.*") == 0 ? 1 : count_spaces(text);
}

std::size_t integer_length(std::string_view text) {
  const std::size_t sign = text.find_first_of("+-") == 0 ? 1 : 0;
  const std::size_t digits = count_digits(text.substr(sign));
  return digits == 0 ? 0 : sign + digits;
}

/// Length of a number with a decimal point or an exponent.
std::size_t real_length(std::string_view text) {
  const std::size_t length = number_length(text);
  return length > integer_length(text) ? length : 0;
}

/// Length of the integer that follows a shift. UDUNITS may read it as a year, which spaces or a T may end.
std::size_t shift_integer_length(std::string_view text) {
  const std::size_t length = integer_length(text);
  if (length == 0) return 0;
  const std::string_view rest = text.substr(length);
  return length + (rest.starts_with('T') ? 1 : count_spaces(rest));
}

/// Length of an exponent written as ^2 or **2.
std::size_t caret_exponent_length(std::string_view text) {
  const std::size_t sign = text.starts_with('^') ? 1 : text.starts_with("**") ? 2 : 0;
  const std::size_t length = sign == 0 ? 0 : integer_length(text.substr(sign));
  return length == 0 ? 0 : sign + length;
}

/// Integer in superscripts: its digits as plain text, and the length of the superscripts; empty if there is none.
struct Superscripts {
  std::string plain;
  std::size_t length = 0;
};

Superscripts read_superscripts(std::string_view text) {
  Superscripts read;
  if (text.starts_with(kSuperscriptPlus) || text.starts_with(kSuperscriptMinus)) {
    read = {text.starts_with(kSuperscriptMinus) ? "-" : "", kSuperscriptPlus.size()};
  }
  const std::size_t sign = read.length;
  const auto is_next = [&](std::string_view digit) { return text.substr(read.length).starts_with(digit); };
  for (;;) {
    const auto digit = std::find_if(std::begin(kSuperscripts), std::end(kSuperscripts), is_next);
    if (digit == std::end(kSuperscripts)) return read.length == sign ? Superscripts() : read;
    read.plain += static_cast<char>('0' + (digit - std::begin(kSuperscripts)));
    read.length += digit->size();
  }
}

/// Length of the beginning of a logarithmic unit: "lg(re ".
std::size_t log_reference_length(std::string_view text) {
  std::size_t length = 0;
  for (const std::string_view name : {"log", "lg", "ln", "lb"}) length = text.starts_with(name) ? name.size() : length;
  if (length == 0) return 0;
  length += count_spaces(text.substr(length));
  if (!text.substr(length).starts_with('(')) return 0;
  ++length;
  length += count_spaces(text.substr(length));
  if (!starts_with_word(text.substr(length), "re")) return 0;
  length += 2;
  if (text.substr(length).starts_with(':') && count_spaces(text.substr(length + 1)) > 0) ++length;
  return length + count_spaces(text.substr(length));
}

/// Value of a number; empty if it overflows or is too small for full precision, as strtod() has it.
template <typename Number>
std::optional<double> read_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value = 0;
  const char *first = text.data(), *last = first + text.size();
  std::from_chars_result read{};
  if constexpr (std::is_floating_point_v<Number>) {
    read = read_double(first, last, value);
  } else {
    read = std::from_chars(first, last, value);
  }
  if (read.ec != std::errc()) return std::nullopt;
  const auto number = static_cast<double>(value);
  if (number != 0.0 && std::abs(number) < std::numeric_limits<double>::min()) return std::nullopt;
  return number;
}

/// Value of a token that is a number, 0 for others; empty if it is out of range.
std::optional<double> token_value(const UnitToken& token) {
  using Kind = UnitToken::Kind;
  if (token.kind == Kind::real) return read_number<double>(token.text);
  if (token.kind == Kind::integer) return read_number<std::int64_t>(token.text);
  if (token.kind != Kind::exponent) return 0.0;
  const std::size_t sign = token.text.find_first_not_of("^*");
  const Superscripts superscripts = read_superscripts(token.text);
  return read_number<std::int64_t>(superscripts.length > 0 ? std::string_view(superscripts.plain)
                                                           : token.text.substr(sign));
}

}  // namespace

UnitToken UnitLexer::next() {
  using Kind = UnitToken::Kind;
  if (rest_.empty()) return {};
  UnitToken token = {Kind::character, rest_.substr(0, 1)};
  std::size_t length = 0;
  State next_state = State::start;
  const auto offer = [&](Kind kind, std::size_t candidate, State state) {
    if (candidate <= length) return;
    length = candidate;
    token = {kind, rest_.substr(0, length)};
    next_state = state;
  };
  if (state_ != State::after_shift) {
    offer(Kind::shift, word_length(rest_, {"@", "after", "from", "ref", "since"}), State::after_shift);
    offer(Kind::divide, word_length(rest_, {"per", "/"}), State::start);
    offer(Kind::multiply, multiply_length(rest_), State::start);
    offer(Kind::exponent, caret_exponent_length(rest_), state_);
    offer(Kind::exponent, read_superscripts(rest_).length, State::start);
  }
  if (state_ != State::after_name) offer(Kind::real, real_length(rest_), State::start);
  const bool shifted = state_ == State::after_shift;
  offer(Kind::integer, shifted ? shift_integer_length(rest_) : integer_length(rest_), State::start);
  offer(Kind::log_reference, log_reference_length(rest_), state_);
  if (state_ == State::start) offer(Kind::name, name_length(rest_), State::after_name);
  rest_.remove_prefix(token.text.size());
  state_ = next_state;
  const std::optional<double> value = token_value(token);
  token.number = value.value_or(0.0);
  if (!value) token.kind = Kind::character;
  return token;
}

}  // namespace overbend
