/// Warnings as the terminal shows them.
#pragma once

#include <string>
#include <vector>

namespace overbend {

/// A line each, "  warning: model.yaml:12: key: ..."; what the reader has marked as a warning is not marked again.
std::string warning_lines(const std::vector<std::string>& warnings);

}  // namespace overbend
