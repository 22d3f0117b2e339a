/// Search for operational limits: the maximum value of a grid that passes, for every cell of a chart.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

enum class TrialStatus {
  passed,
  exceeded,     ///< The criterion is not met.
  no_solution,  ///< Buckled, diverged or no equilibrium: counts as not passed.
  open,         ///< No result: interrupted, or it could not be run.
};

/// Result of one analysis: one value of one cell with one seed.
struct TrialResult {
  TrialStatus end = TrialStatus::open;
  std::optional<double> utilisation;  ///< Maximum utilisation of the criterion; of a stopped run, up to that time.
  std::string governing;              ///< Governing check or result; for no_solution the failure.
  std::string reason;                 ///< Reason of `open`.
};

/// Arguments: cell (index over all other axes, the last one fastest), index of the value, index of the seed. Called
/// from several threads, never twice with the same arguments.
using OperabilityTrial = std::function<TrialResult(std::size_t cell, std::size_t value, std::size_t seed)>;

struct OperabilityGrid {
  std::vector<std::size_t> axes;  ///< Numbers of values of the other axes; without any: one cell.
  std::size_t values = 0;         ///< Number of values of the searched key, ascending.
  std::size_t seeds = 1;
};

struct SearchedCell {
  std::optional<std::size_t> limit;  ///< Index of the maximum value that passes with every seed.
  bool beyond = false;               ///< True if the maximum of the grid passes.
  bool decided = true;
  std::string governing;               ///< Governing check at the value above the limit.
  std::optional<double> below, above;  ///< Maximum utilisation at the limit and at the value above it.
  int runs = 0;                        ///< Number of analyses with a result.
  std::string reason;                  ///< Reason that it is not decided.
  std::string remark;                  ///< Remark if the utilisation decreases with increasing value.
};

/// Finds for every cell a value that passes with every seed while the next one does not; for a monotonic response that
/// is the maximum that passes. The search uses the most recent failing seed, then checks the limit with all seeds; if
/// one fails there, the search continues below with that one. Cells along the last axis are searched in sequence, each
/// from the limit of the previous one, those of a single axis independently; so neither the results nor the analyses
/// depend on the number of threads (0: the number of cores).
std::vector<SearchedCell> search_operability(const OperabilityGrid& grid, const OperabilityTrial& trial, int threads);

/// Number of chains of cells that are searched concurrently, and the chain of a cell.
std::size_t operability_chains(const OperabilityGrid& grid);
std::size_t chain_of_cell(const OperabilityGrid& grid, std::size_t cell);

}  // namespace overbend
