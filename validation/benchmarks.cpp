#include "benchmarks.h"

#include "base/json.h"

namespace overbend::validation {

Json benchmark(const char* name) {
  return read_json_file(OVERBEND_SOURCE_DIR "/validation/cases_public.json").at("benchmarks").at(name).at("expected");
}

}  // namespace overbend::validation
