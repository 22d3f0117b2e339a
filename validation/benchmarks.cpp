#include "benchmarks.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace overbend::validation {

nlohmann::json benchmark(const char* name) {
  std::ifstream stream(OVERBEND_SOURCE_DIR "/validation/cases_public.json");
  return nlohmann::json::parse(stream).at("benchmarks").at(name).at("expected");
}

}  // namespace overbend::validation
