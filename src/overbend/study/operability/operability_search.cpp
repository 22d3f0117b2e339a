#include "study/operability/operability_search.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "base/finding.h"
#include "base/threads.h"

namespace overbend {
namespace {

/// Results of one value for the seeds evaluated so far.
struct ValueAnswer {
  TrialStatus end = TrialStatus::passed;
  std::vector<std::optional<TrialResult>> seeds;  ///< By seed; empty if not evaluated.
  std::optional<double> utilisation;              ///< Maximum over the seeds.
  std::string governing, reason;
};

/// Smaller decreases of the utilisation count as no change [-].
constexpr double kFall = 0.02;

/// Searches the cells of a chain in sequence.
class ChainSearch {
 public:
  ChainSearch(const OperabilityGrid& grid, const OperabilityTrial& trial) : grid_(grid), trial_(trial) {
    order_.resize(grid.seeds);
    std::iota(order_.begin(), order_.end(), std::size_t{0});
  }

  SearchedCell search(std::size_t cell) {
    cell_ = cell;
    known_.clear();
    found_ = SearchedCell{};
    below_ = -1;
    above_ = static_cast<Index>(grid_.values);
    // The value above the neighbour's limit first: failing runs end early.
    if (begin_) gallop(std::min(*begin_ + 1, above_ - 1));
    do {
      bisect();
    } while (found_.decided && below_ >= 0 && !confirmed());
    conclude();
    return std::move(found_);
  }

 private:
  /// Signed, so that -1 means that not even the minimum passes: below_ passes (or is -1), above_ does not (or is one
  /// past the last).
  using Index = std::ptrdiff_t;

  void bisect() {
    while (found_.decided && above_ - below_ > 1) put(below_ + (above_ - below_) / 2);
  }

  /// Searches outwards from a value between both sides in growing steps until they are known.
  void gallop(Index value) {
    for (Index step = 1; found_.decided && above_ - below_ > 1; step *= 2) {
      const bool passed = put(value);
      const bool other_side_known = passed ? above_ < static_cast<Index>(grid_.values) : below_ >= 0;
      if (other_side_known) return;
      value = passed ? std::min(value + step, static_cast<Index>(grid_.values) - 1) : std::max(value - step, Index{0});
    }
  }

  /// Evaluates a value between the two sides with the most recent failing seed, and moves one side there; returns true
  /// if it passes. The other seeds are evaluated at the limit only.
  bool put(Index value) {
    const bool passed = passes(value, 0);
    if (found_.decided) (passed ? below_ : above_) = value;
    return passed;
  }

  /// Returns true if the value below passes with all seeds. If not, it becomes the value above, and another value below
  /// is searched.
  bool confirmed() {
    for (std::size_t place = 0; place < order_.size(); ++place) {
      if (passes(below_, place)) continue;
      if (!found_.decided) return false;
      above_ = below_;
      while (--below_ >= 0) {
        const auto known = known_.find(below_);
        if (known != known_.end() && known->second.end == TrialStatus::passed) break;
      }
      if (below_ < 0 && above_ > 0) gallop(above_ - 1);
      return false;
    }
    return true;
  }

  /// Evaluates one seed, unless known; a failing seed becomes the first.
  bool passes(Index value, std::size_t place) {
    ValueAnswer& answer = known_[value];
    answer.seeds.resize(grid_.seeds);
    const std::size_t seed = order_[place];
    if (answer.seeds[seed]) return answer.end == TrialStatus::passed;
    const TrialResult result = trial_(cell_, static_cast<std::size_t>(value), seed);
    if (result.end == TrialStatus::open) {
      found_.decided = false;
      found_.reason = result.reason;
      return false;
    }
    ++found_.runs;
    answer.seeds[seed] = result;
    const bool worse = !answer.utilisation || (result.utilisation && *result.utilisation > *answer.utilisation);
    if (worse || result.end != TrialStatus::passed) {
      answer.utilisation = result.utilisation;
      answer.governing = result.governing;
    }
    if (result.end == TrialStatus::passed) return true;
    answer.end = result.end;
    const auto failed = order_.begin() + static_cast<Index>(place);
    std::rotate(order_.begin(), failed, failed + 1);
    return false;
  }

  void conclude() {
    if (!found_.decided) return;
    begin_ = below_;
    if (below_ >= 0) {
      found_.limit = static_cast<std::size_t>(below_);
      found_.below = known_.at(below_).utilisation;
      found_.beyond = below_ + 1 == static_cast<Index>(grid_.values);
    }
    if (!found_.beyond) {
      found_.governing = known_.at(above_).governing;
      found_.above = known_.at(above_).utilisation;
    }
    for (std::size_t seed = 0; seed < grid_.seeds; ++seed) add_decrease_remarks(seed);
  }

  /// Remarks on decreasing utilisation. Only passing runs are complete, so only these can be compared.
  void add_decrease_remarks(std::size_t seed) {
    const TrialResult* before = nullptr;
    for (const auto& [value, answer] : known_) {
      if (!answer.seeds[seed] || answer.seeds[seed]->end != TrialStatus::passed) continue;
      const TrialResult& current = *answer.seeds[seed];
      if (!current.utilisation) continue;
      if (before != nullptr && *current.utilisation < (1.0 - kFall) * *before->utilisation) {
        found_.remark = fmt::format(
            "the utilisation decreases from {:.3f} to {:.3f} with a larger value: the limit may not "
            "be the only one",
            *before->utilisation, *current.utilisation);
      }
      before = &current;
    }
  }

  const OperabilityGrid& grid_;
  const OperabilityTrial& trial_;
  std::vector<std::size_t> order_;  ///< Order of the seeds: the most recent failing one first.
  std::optional<Index> begin_;      ///< Limit of the previous cell; -1 if not even the minimum passed there.
  std::size_t cell_ = 0;
  Index below_ = -1, above_ = 0;
  std::map<Index, ValueAnswer> known_;
  SearchedCell found_;
};

std::size_t count_cells(const OperabilityGrid& grid) {
  return std::accumulate(grid.axes.begin(), grid.axes.end(), std::size_t{1}, std::multiplies<>());
}

/// Number of cells of one chain.
std::size_t chain_length(const OperabilityGrid& grid) {
  return grid.axes.size() > 1 ? grid.axes.back() : 1;
}

void search_chain(const OperabilityGrid& grid, const OperabilityTrial& trial, std::size_t chain,
                  std::vector<SearchedCell>& cells) {
  const std::size_t length = chain_length(grid);
  ChainSearch search(grid, trial);
  for (std::size_t i = chain * length; i < (chain + 1) * length; ++i) cells[i] = search.search(i);
}

}  // namespace

std::size_t operability_chains(const OperabilityGrid& grid) {
  return count_cells(grid) / std::max<std::size_t>(1, chain_length(grid));
}

std::size_t chain_of_cell(const OperabilityGrid& grid, std::size_t cell) {
  return cell / chain_length(grid);
}

std::vector<SearchedCell> search_operability(const OperabilityGrid& grid, const OperabilityTrial& trial, int threads) {
  std::vector<SearchedCell> cells(count_cells(grid));
  const std::size_t chains = operability_chains(grid);
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> errors(chains);
  const auto work = [&] {
    for (std::size_t i = next++; i < chains; i = next++) {
      try {
        search_chain(grid, trial, i, cells);
      } catch (...) {
        errors[i] = std::current_exception();
      }
    }
  };
  work_in_threads(useful_threads(threads, chains), work);
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
  return cells;
}

}  // namespace overbend
