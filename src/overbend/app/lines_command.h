/// The commands static and dynamic on a model that is lines by themselves.
#pragma once

#include <filesystem>
#include <optional>

#include "app/unfinished_run.h"
#include "model/description/description.h"

namespace overbend {

int run_static_lines(const Description& description, const std::filesystem::path& folder);
/// A run for every seed of the model; `duration` in place of the model's [s]. Interrupted, it leaves a checkpoint and
/// returns kInterrupted. `checkpoint_every` [s].
int run_dynamic_lines(const Description& described, std::optional<double> duration, const std::filesystem::path& folder,
                      const TakeUp& take_up, double checkpoint_every);

}  // namespace overbend
