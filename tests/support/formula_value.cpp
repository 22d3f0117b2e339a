#include "support/formula_value.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace overbend::testing {
namespace {

/// Recursive descent over sum, product, power and the things between them.
class Parser {
 public:
  Parser(const std::string& text, const std::map<std::string, double>& values) : text_(text), values_(values) {}

  double whole() {
    const double value = sum();
    if (next() != '\0') fail("rest of the text");
    return value;
  }

 private:
  double sum() {
    double value = product();
    while (next() == '+' || next() == '-') {
      const char sign = take();
      value += sign == '+' ? product() : -product();
    }
    return value;
  }

  double product() {
    const double sign = next() == '-' ? (take(), -1.0) : 1.0;
    double value = power();
    while (next() == '*' || next() == '/' || begins_factor()) {
      const char operation = begins_factor() ? '*' : take();
      value = operation == '*' ? value * power() : value / power();
    }
    return sign * value;
  }

  double power() {
    const double base = atom();
    if (next() != '^') return base;
    take();
    return std::pow(base, atom());
  }

  double atom() {
    if (next() == '(') {
      take();
      const double value = sum();
      close();
      return value;
    }
    if (std::isdigit(static_cast<unsigned char>(next()))) return number();
    return name();
  }

  double number() {
    std::size_t length = 0;
    const double value = std::stod(text_.substr(place_), &length);
    place_ += length;
    return value;
  }

  double name() {
    std::string word;
    while (place_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[place_])) || text_[place_] == '_')) {
      word += text_[place_++];
    }
    if (word == "pi") return std::numbers::pi;
    const auto known = values_.find(word);
    if (known != values_.end()) return known->second;
    if (word.empty() || next() != '(') fail("symbol '" + word + "'");
    return function(word);
  }

  double function(const std::string& word) {
    take();
    std::vector<double> arguments = {sum()};
    while (next() == ',') {
      take();
      arguments.push_back(sum());
    }
    close();
    if (word == "sqrt") return std::sqrt(arguments.at(0));
    if (word == "exp") return std::exp(arguments.at(0));
    if (word == "ln") return std::log(arguments.at(0));
    if (word == "log10") return std::log10(arguments.at(0));
    if (word == "max") return std::max(arguments.at(0), arguments.at(1));
    if (word == "min") return std::min(arguments.at(0), arguments.at(1));
    fail("function '" + word + "'");
  }

  bool begins_factor() { return next() == '(' || std::isalnum(static_cast<unsigned char>(next())); }
  void close() {
    if (take() != ')') fail("bracket");
  }
  char next() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
    return place_ < text_.size() ? text_[place_] : '\0';
  }
  char take() {
    const char found = next();
    ++place_;
    return found;
  }
  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(what + " in '" + text_ + "'"); }

  const std::string& text_;
  const std::map<std::string, double>& values_;
  std::size_t place_ = 0;
};

}  // namespace

double formula_value(const std::string& formula, const std::map<std::string, double>& values) {
  return Parser(formula, values).whole();
}

}  // namespace overbend::testing
