#include <iostream>

#include "app/commands.h"
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

}  // namespace overbend
