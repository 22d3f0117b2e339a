#include "report/page/formula_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "base/shown_unit.h"
#include "resultfiles/static/check_tables.h"

namespace overbend {
namespace {

constexpr const char* kTimes = " \u00b7 ";

enum class TokenKind { number, name, function, open, close, sign };

struct Token {
  TokenKind kind;
  std::string text;
};

bool is_function(const std::string& name) {
  constexpr std::array kFunctions = {"sqrt", "exp", "ln", "log10", "max", "min"};
  return std::find(kFunctions.begin(), kFunctions.end(), name) != kFunctions.end();
}

TokenKind find_kind(char c) {
  const auto letter = static_cast<unsigned char>(c);
  if (std::isalpha(letter)) return TokenKind::name;
  if (std::isdigit(letter)) return TokenKind::number;
  return c == '(' ? TokenKind::open : c == ')' ? TokenKind::close : TokenKind::sign;
}

bool continues(TokenKind kind, char c) {
  const auto letter = static_cast<unsigned char>(c);
  if (kind == TokenKind::name) return std::isalnum(letter) || c == '_';
  return kind == TokenKind::number && (std::isdigit(letter) || c == '.');
}

std::vector<Token> split_tokens(const std::string& formula) {
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < formula.size();) {
    if (formula[i] == ' ') {
      ++i;
      continue;
    }
    Token token{find_kind(formula[i]), std::string(1, formula[i])};
    while (++i < formula.size() && continues(token.kind, formula[i])) token.text += formula[i];
    if (is_function(token.text)) token.kind = TokenKind::function;
    tokens.push_back(std::move(token));
  }
  return tokens;
}

/// True if two consecutive tokens are factors of a product.
bool multiplies(const Token& left, const Token& right) {
  const auto ends = [](TokenKind k) { return k == TokenKind::number || k == TokenKind::name || k == TokenKind::close; };
  return ends(left.kind) && right.kind != TokenKind::close && right.kind != TokenKind::sign;
}

/// A sign between two terms; a sign of a number, or after an opening bracket, has no blanks.
std::string sign_text(const std::vector<Token>& tokens, std::size_t i) {
  const std::string& sign = tokens[i].text;
  if (sign == ",") return ", ";
  if (sign == "/" || sign == "^") return sign;
  const bool leads = i == 0 || tokens[i - 1].kind == TokenKind::open;
  const std::string shown = sign == "-" ? "\u2212" : sign;
  return leads ? shown : " " + shown + " ";
}

std::string greek(const std::string& word) {
  constexpr std::array<std::pair<const char*, const char*>, 10> kLetters = {{{"alpha", "\u03b1"},
                                                                             {"beta", "\u03b2"},
                                                                             {"gamma", "\u03b3"},
                                                                             {"delta", "\u03b4"},
                                                                             {"eps", "\u03b5"},
                                                                             {"nu", "\u03bd"},
                                                                             {"sigma", "\u03c3"},
                                                                             {"pi", "\u03c0"},
                                                                             {"dp", "\u0394p"},
                                                                             {"log10", "log"}}};
  const auto* letter =
      std::find_if(kLetters.begin(), kLetters.end(), [&](const auto& each) { return word == each.first; });
  return letter != kLetters.end() ? letter->second : word;
}

const SheetLine* find_line(const std::vector<SheetLine>& lines, std::size_t before, const std::string& symbol) {
  for (std::size_t i = before; i-- > 0;) {
    if (lines[i].symbol == symbol) return &lines[i];
  }
  return nullptr;
}

/// Value in place of a name; in brackets if its sign or unit would be ambiguous.
std::string substituted_value(const SheetLine& line, bool powered) {
  const std::string text = value_text(line);
  const bool unit = text.find('\u0020') != std::string::npos || text.find("\u00a0") != std::string::npos;
  return line.value < 0.0 || (powered && unit) ? "(" + text + ")" : text;
}

}  // namespace

std::string six_digits(double value) {
  if (value == 0.0 || !std::isfinite(value)) return fixed(value, 0);
  const int power = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (power < -5) return fmt::format("{:.5e}", value);
  std::string text = fmt::format("{:.{}f}", value, std::max(0, 5 - power));
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string value_text(const SheetLine& line) {
  const ShownUnit unit = check_unit(CheckInput{line.symbol, line.meaning, line.value, line.units});
  std::string text = six_digits(line.value * unit.factor);
  if (!unit.name.empty()) text += "\u00a0" + std::string(unit.name);
  return text;
}

std::string substituted_formula(const std::vector<SheetLine>& lines, std::size_t line) {
  const std::vector<Token> tokens = split_tokens(lines[line].formula);
  std::string out;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (i > 0 && multiplies(tokens[i - 1], tokens[i])) out += kTimes;
    const bool powered = i + 1 < tokens.size() && tokens[i + 1].text == "^";
    const SheetLine* known = tokens[i].kind == TokenKind::name ? find_line(lines, line, tokens[i].text) : nullptr;
    const bool name = tokens[i].kind == TokenKind::name || tokens[i].kind == TokenKind::function;
    out += known != nullptr                    ? substituted_value(*known, powered)
           : tokens[i].kind == TokenKind::sign ? sign_text(tokens, i)
           : name                              ? greek(tokens[i].text)
                                               : tokens[i].text;
  }
  return out;
}

}  // namespace overbend
