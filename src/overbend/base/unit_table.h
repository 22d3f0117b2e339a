/// Names, symbols and definitions of the units of UDUNITS-2. tools/unit_table.py writes the tables at build time.
#pragma once

#include <cstdint>
#include <span>

namespace overbend {

/// Base units of the database in its order: m, kg, s, A, K, mol, cd, rad.
constexpr int kBaseUnits = 8;
constexpr int kSecond = 2;
constexpr int kRadian = 7;

/// Name or symbol of a unit. The texts are arrays, not pointers, so that loading the program has nothing to relocate.
struct UnitName {
  char text[32];
  std::uint16_t unit;  ///< A base unit, or kBaseUnits plus the index of a definition.
};

struct UnitDefinition {
  char text[40];  ///< In other units: "m.kg/s2".
};

struct UnitPrefix {
  char text[8];
  double value;
};

extern const std::span<const UnitName> kUnitNames;    ///< In lower case, sorted: capitals do not matter in names.
extern const std::span<const UnitName> kUnitSymbols;  ///< Sorted.
extern const std::span<const UnitDefinition> kUnitDefinitions;
extern const std::span<const UnitPrefix> kNamePrefixes;  ///< In lower case.
extern const std::span<const UnitPrefix> kSymbolPrefixes;

}  // namespace overbend
