#include "study/run/case.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/ranges.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

bool same_change(const YamlChange& a, const YamlChange& b) {
  return a.path == b.path && a.kind == b.kind && a.value == b.value;
}

Description edited(const Description& base, const Case& study_case) {
  ModelReading reading = read_model_text(edit_yaml(base.source_text, study_case.changes), base.source_file);
  if (!reading.description) {
    const std::vector<std::string> errors = reading.diagnostics.lines(Severity::error);
    throw std::runtime_error("the case " + study_case.name + ": " + (errors.empty() ? "" : errors.front()));
  }
  return std::move(*reading.description);
}

}  // namespace

void require_seeds(const std::vector<std::uint64_t>& seeds) {
  for (const std::uint64_t seed : seeds) {
    if (seed <= kMaxSeed) continue;
    throw std::invalid_argument(fmt::format("seeds: found {}, expected whole numbers from 0 to {}", seed, kMaxSeed));
  }
}

void set_duration(Description& description, const std::optional<double>& duration) {
  if (!duration) return;
  if (!(*duration >= kMinDuration && *duration <= kMaxDuration)) {
    throw std::invalid_argument(fmt::format("duration: found {:.6g} s, expected a time from {} s to {:g} s", *duration,
                                            kMinDuration, kMaxDuration));
  }
  if (!description.dynamics) description.dynamics.emplace();
  description.dynamics->duration = *duration;
}

Description describe(const Description& base, const Case& study_case) {
  Description description = study_case.changes.empty() ? base : edited(base, study_case);
  set_duration(description, study_case.duration);
  return description;
}

bool same_model(const Case& a, const Case& b) {
  return a.controllers.empty() && b.controllers.empty() && a.duration == b.duration &&
         ranges::equal(a.changes, b.changes, same_change);
}

}  // namespace overbend
