/// Warnings of several runs of one model, told once.
#pragma once

#include <string>
#include <vector>

namespace overbend {

/// What several runs warn of.
struct SharedWarning {
  std::string text;
  int runs = 0;  ///< How many of them.
};

/// Warnings that differ in their numbers alone are one, with the least and the largest of each number that differs:
/// "the tension falls to -155.9 .. -6.9 kN". Numbers in quotes and in words are names. In the order in which they
/// occur; one vector for each run.
std::vector<SharedWarning> shared_warnings(const std::vector<std::vector<std::string>>& of_runs);

}  // namespace overbend
