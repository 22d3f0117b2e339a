#include "base/unit_parser.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/text.h"
#include "base/unit_lexer.h"

namespace overbend {
namespace {

using Unit = std::optional<ParsedUnit>;
using Kind = UnitToken::Kind;

bool has_powers(const ParsedUnit& unit, bool (*allowed)(int base, int power)) {
  for (int base = 0; base < kBaseUnits; ++base) {
    if (unit.powers[base] != 0 && !allowed(base, unit.powers[base])) return false;
  }
  return true;
}

bool is_dimensionless(const ParsedUnit& unit) {
  return has_powers(unit, [](int base, int) { return base == kRadian; });
}

/// True for a time or its inverse, whose origin may be a date.
bool is_time(const ParsedUnit& unit) {
  return unit.powers[kSecond] != 0 && has_powers(unit, [](int base, int power) {
           return base == kRadian || (base == kSecond && (power == 1 || power == -1));
         });
}

/// Rejects what is out of range. As in UDUNITS, a scale and an offset that differ from 1 and 0 by rounding are those.
Unit checked(ParsedUnit unit) {
  constexpr int kMaxPower = 32767;
  constexpr double kRounding = 10.0 * std::numeric_limits<double>::epsilon();
  const auto fits = [](int power) { return power >= -kMaxPower && power <= kMaxPower; };
  if (unit.scale == 0.0 || !std::all_of(unit.powers.begin(), unit.powers.end(), fits)) return std::nullopt;
  if (std::abs(1.0 - unit.scale) < kRounding && std::abs(unit.offset) < kRounding) {
    unit.scale = 1.0;
    unit.offset = 0.0;
  }
  return unit;
}

Unit scaled(double factor, const ParsedUnit& unit) {
  if (factor == 1.0) return unit;
  ParsedUnit result = unit;
  result.scale = factor * unit.scale;
  result.offset = (unit.scale * unit.offset) / result.scale;
  return checked(result);
}

/// Unit with another origin. An integer after a time is a date, which has no offset in that unit: NaN.
Unit shifted(const ParsedUnit& unit, const UnitToken& origin) {
  ParsedUnit result = unit;
  if (is_time(unit) && origin.kind == Kind::integer) {
    result.offset = std::numeric_limits<double>::quiet_NaN();
  } else if (origin.number != 0.0) {
    result.offset = origin.number + (unit.scale * unit.offset) / unit.scale;
  }
  return checked(result);
}

/// Product without the offsets. A logarithmic unit has products with plain numbers only.
Unit product(const ParsedUnit& a, const ParsedUnit& b) {
  ParsedUnit result;
  result.logarithmic = a.logarithmic || b.logarithmic;
  const ParsedUnit& factor = a.logarithmic ? b : a;
  if (result.logarithmic && (factor.logarithmic || !is_dimensionless(factor))) return std::nullopt;
  result.scale = a.scale * b.scale;
  for (int base = 0; base < kBaseUnits; ++base) result.powers[base] = a.powers[base] + b.powers[base];
  return checked(result);
}

/// Power without the offset.
Unit raised(const ParsedUnit& unit, double exponent) {
  constexpr double kMaxExponent = 255.0;
  if (exponent == 0.0) return ParsedUnit();
  if (exponent == 1.0) return unit;
  if (unit.logarithmic || std::abs(exponent) > kMaxExponent) return std::nullopt;
  ParsedUnit result;
  result.scale = std::pow(unit.scale, exponent);
  for (int base = 0; base < kBaseUnits; ++base) result.powers[base] = unit.powers[base] * static_cast<int>(exponent);
  return checked(result);
}

const UnitName* find_name(std::span<const UnitName> names, std::string_view name) {
  const auto before = [](const UnitName& row, std::string_view text) { return row.text < text; };
  const auto row = std::lower_bound(names.begin(), names.end(), name, before);
  return row != names.end() && row->text == name ? &*row : nullptr;
}

/// Finds the prefix at the start of the name. As in UDUNITS the search follows the letters as far as any prefix has
/// them, and finds nothing if it ends within a prefix.
const UnitPrefix* find_prefix(std::span<const UnitPrefix> prefixes, std::string_view name) {
  const UnitPrefix* found = nullptr;
  std::size_t agreed = 0;
  for (const UnitPrefix& prefix : prefixes) {
    const std::string_view text = prefix.text;
    const auto length = static_cast<std::size_t>(
        std::mismatch(text.begin(), text.end(), name.begin(), name.end()).first - text.begin());
    if (length > agreed) found = nullptr;
    agreed = std::max(agreed, length);
    if (length == agreed && length == text.size()) found = &prefix;
  }
  return found;
}

ParsedUnit base_unit(int base) {
  ParsedUnit unit;
  unit.powers[base] = 1;
  return unit;
}

/// The unit of a name or symbol with prefixes: any number of names, of symbols a single one.
Unit named_unit(std::string_view name) {
  const std::string lower = lower_case(name);
  double prefixes = 1.0;
  bool symbol_seen = false;
  for (std::size_t start = 0; start < name.size();) {
    const std::string_view rest = name.substr(start), lower_rest = std::string_view(lower).substr(start);
    const UnitName* row = find_name(kUnitNames, lower_rest);
    if (row == nullptr) row = find_name(kUnitSymbols, rest);
    if (row != nullptr) {
      const Unit unit =
          row->unit < kBaseUnits ? base_unit(row->unit) : parse_unit(kUnitDefinitions[row->unit - kBaseUnits].text);
      return unit ? scaled(prefixes, *unit) : std::nullopt;
    }
    const UnitPrefix* prefix = find_prefix(kNamePrefixes, lower_rest);
    if (prefix == nullptr && !symbol_seen) {
      prefix = find_prefix(kSymbolPrefixes, rest);
      symbol_seen = true;
    }
    if (prefix == nullptr) return std::nullopt;
    prefixes *= prefix->value;
    start += std::string_view(prefix->text).size();
  }
  return std::nullopt;
}

/// Recursive descent: a unit is a product with an optional shift, a product is made of powers, a power of a basic unit.
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : lexer_(text) { advance(); }

  Unit parse() {
    if (token_.kind == Kind::end) return ParsedUnit();
    Unit unit = parse_product();
    if (is_character(')') && lexer_.finished()) {
      advance();  // UDUNITS ignores a parenthesis too many
    } else if (unit) {
      unit = parse_shift(*unit);
    }
    return token_.kind == Kind::end ? unit : std::nullopt;
  }

 private:
  static constexpr int kMaxNesting = 40;

  void advance() { token_ = lexer_.next(); }
  bool is_character(char c) const { return token_.kind == Kind::character && token_.text.front() == c; }

  Unit parse_shifted() {
    const Unit unit = parse_product();
    return unit ? parse_shift(*unit) : std::nullopt;
  }

  /// Reads the shift that may follow a product.
  Unit parse_shift(const ParsedUnit& unit) {
    if (token_.kind != Kind::shift) return unit;
    advance();
    const UnitToken origin = token_;
    if (origin.kind != Kind::integer && origin.kind != Kind::real) return std::nullopt;
    advance();
    return shifted(unit, origin);
  }

  Unit parse_product() {
    Unit unit = parse_power();
    while (unit && continues_product()) {
      const bool divide = token_.kind == Kind::divide;
      if (divide || token_.kind == Kind::multiply) advance();
      Unit factor = parse_power();
      if (factor && divide) factor = raised(*factor, -1.0);
      unit = factor ? product(*unit, *factor) : std::nullopt;
    }
    return unit;
  }

  bool continues_product() const {
    if (token_.kind == Kind::character) return is_character('(');
    return token_.kind != Kind::end && token_.kind != Kind::shift && token_.kind != Kind::exponent;
  }

  Unit parse_power() {
    Unit unit = parse_basic();
    if (!unit || (token_.kind != Kind::integer && token_.kind != Kind::exponent)) return unit;
    unit = raised(*unit, token_.number);
    advance();
    return unit;
  }

  Unit parse_basic() {
    const UnitToken token = token_;
    const bool parenthesis = is_character('(');
    advance();
    switch (token.kind) {
      case Kind::name:
        return named_unit(token.text);
      case Kind::integer:
      case Kind::real:
        return scaled(token.number, ParsedUnit());
      case Kind::log_reference:
        return parse_reference();
      default:
        return parenthesis ? parse_closed(&UnitParser::parse_shifted) : std::nullopt;
    }
  }

  Unit parse_reference() {
    Unit unit = parse_closed(&UnitParser::parse_product);
    if (unit) *unit = {1.0, 0.0, true, unit->powers};
    return unit;
  }

  /// Reads a unit and the parenthesis that closes it.
  Unit parse_closed(Unit (UnitParser::*parse_inner)()) {
    if (++nesting_ > kMaxNesting) return std::nullopt;
    const Unit unit = (this->*parse_inner)();
    --nesting_;
    if (!unit || !is_character(')')) return std::nullopt;
    advance();
    return unit;
  }

  UnitLexer lexer_;
  UnitToken token_;
  int nesting_ = 0;
};

}  // namespace

Unit parse_unit(std::string_view text) {
  return UnitParser(text).parse();
}

}  // namespace overbend
