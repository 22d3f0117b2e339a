#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "base/units.h"
#include "modelfile/field.h"
#include "modelfile/yaml_reader.h"

namespace overbend {

std::optional<Description> load_model(const std::string& path) {
  constexpr std::size_t kMostShown = 50;
  ModelReading reading = read_model(path);
  const std::vector<std::string> errors = reading.diagnostics.lines(Severity::error);
  for (std::size_t i = 0; i < errors.size() && i < kMostShown; ++i) std::cerr << errors[i] << "\n";
  const auto count = static_cast<std::size_t>(reading.diagnostics.error_count());
  if (count > kMostShown) std::cerr << "... and " << count - kMostShown << " more\n";
  return std::move(reading.description);
}

std::optional<double> duration_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const QuantityReading duration = parse_quantity(text, "s");
  if (duration.value && *duration.value > 0.0 && *duration.value <= largest_sensible("s")) return *duration.value;
  throw std::invalid_argument("--duration: found " + duration.found + ", expected a time such as '600 s'");
}

}  // namespace overbend
