/// The search for limits of operation: for every cell of a chart the largest value of a grid that passes.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

enum class TrialEnd {
  passed,
  exceeded,     ///< The criterion does not hold.
  no_solution,  ///< Buckled, ran away, no equilibrium: counts as not passed.
  open,         ///< No answer: interrupted, or it could not be run.
};

/// What one analysis said: one value of one cell with one seed.
struct TrialResult {
  TrialEnd end = TrialEnd::open;
  std::optional<double> utilisation;  ///< Largest of the criterion; of a run that was stopped, up to there.
  std::string governing;              ///< The check or result it belongs to; of no_solution what went wrong.
  std::string reason;                 ///< Of `open`.
};

/// Cell (index over all other axes, the last one fastest), index of the value, index of the seed. Called from several
/// threads, never twice with the same arguments.
using OperabilityTrial = std::function<TrialResult(std::size_t cell, std::size_t value, std::size_t seed)>;

struct OperabilityGrid {
  std::vector<std::size_t> axes;  ///< Number of values of each of the other axes; none of them: one cell.
  std::size_t values = 0;         ///< Of the key searched, ascending.
  std::size_t seeds = 1;
};

struct SearchedCell {
  std::optional<std::size_t> limit;  ///< Index of the largest value that passes with every seed.
  bool beyond = false;               ///< The largest of all passes.
  bool decided = true;
  std::string governing;               ///< At the value above the limit.
  std::optional<double> below, above;  ///< Largest utilisation at the limit and at the value above it.
  int runs = 0;                        ///< Analyses with an answer.
  std::string reason;                  ///< Why it is not decided.
  std::string remark;                  ///< Where the utilisation falls with a rising value.
};

/// Finds for every cell a value that passes with every seed while the next one does not. Where the response is
/// monotone that is the largest that passes. Values are searched with the seed that failed last, and all seeds are
/// asked at the limit it leads to; where one fails there, the search goes on below with that one. Cells along the last
/// axis are searched one after the other, each from the limit of the one before, those of a single axis by themselves;
/// so neither the answers nor the analyses depend on the number of threads (0: as many as there are cores).
std::vector<SearchedCell> search_operability(const OperabilityGrid& grid, const OperabilityTrial& trial, int threads);

/// Number of chains of cells that are searched side by side, and the chain of a cell.
std::size_t operability_chains(const OperabilityGrid& grid);
std::size_t chain_of_cell(const OperabilityGrid& grid, std::size_t cell);

}  // namespace overbend
