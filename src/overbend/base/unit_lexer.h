/// Tokens of a unit's text by the rules of UDUNITS-2: the longest match counts, and the first of equally long ones.
#pragma once

#include <string_view>

namespace overbend {

struct UnitToken {
  enum class Kind { end, name, integer, real, exponent, multiply, divide, shift, log_reference, character };
  Kind kind = Kind::end;
  std::string_view text;
  double number = 0.0;  ///< Value of an integer, real or exponent.
};

/// Splits the text of a unit into tokens. What is no other token is a character: a parenthesis or an error.
class UnitLexer {
 public:
  explicit UnitLexer(std::string_view text) : rest_(text) {}

  /// Returns the next token; of kind `end` after the last one.
  UnitToken next();

  bool finished() const { return rest_.empty(); }

 private:
  /// The preceding token restricts the next one: after a name no other name, after a shift only a number.
  enum class State { start, after_name, after_shift };

  std::string_view rest_;
  State state_ = State::start;
};

}  // namespace overbend
