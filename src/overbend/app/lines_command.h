/// The commands static and dynamic on a model that is lines by themselves.
#pragma once

#include <filesystem>
#include <optional>

#include "model/description.h"

namespace overbend {

int run_static_lines(const Description& description, const std::filesystem::path& folder);
/// One run of the model's first seed; `duration` in place of the model's [s]. It is not gone on from when interrupted.
int run_dynamic_lines(const Description& description, std::optional<double> duration,
                      const std::filesystem::path& folder);

}  // namespace overbend
