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

/// What the seeds asked so far said of one value.
struct ValueAnswer {
  TrialEnd end = TrialEnd::passed;
  std::vector<std::optional<TrialResult>> seeds;  ///< By seed.
  std::optional<double> utilisation;              ///< The largest.
  std::string governing, reason;
};

/// Utilisations that fall by less are those of a response that does not change.
constexpr double kFall = 0.02;

/// The search in one cell after the other of a chain.
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
    // The value above the neighbour's limit first: what fails is over soon.
    if (begin_) gallop(std::min(*begin_ + 1, above_ - 1));
    do {
      bisect();
    } while (found_.decided && below_ >= 0 && !confirmed());
    conclude();
    return std::move(found_);
  }

 private:
  /// Signed, so that -1 stands for "not even the least": below_ passes (or is -1), above_ does not (or is one beyond
  /// the last).
  using Index = std::ptrdiff_t;

  void bisect() {
    while (found_.decided && above_ - below_ > 1) put(below_ + (above_ - below_) / 2);
  }

  /// From a value between both sides outwards in growing steps until they are known.
  void gallop(Index at) {
    for (Index step = 1; found_.decided && above_ - below_ > 1; step *= 2) {
      const bool passed = put(at);
      const bool other_side_known = passed ? above_ < static_cast<Index>(grid_.values) : below_ >= 0;
      if (other_side_known) return;
      at = passed ? std::min(at + step, static_cast<Index>(grid_.values) - 1) : std::max(at - step, Index{0});
    }
  }

  /// Tries a value between the two sides, with the seed that failed last, and moves one of them there; whether it
  /// passes. The other seeds are asked at the limit alone.
  bool put(Index value) {
    const bool passed = passes(value, 0);
    if (found_.decided) (passed ? below_ : above_) = value;
    return passed;
  }

  /// Whether the value below passes with all seeds. If not, it is the one above, and another one below is looked for.
  bool confirmed() {
    for (std::size_t place = 0; place < order_.size(); ++place) {
      if (passes(below_, place)) continue;
      if (!found_.decided) return false;
      above_ = below_;
      while (--below_ >= 0) {
        const auto known = known_.find(below_);
        if (known != known_.end() && known->second.end == TrialEnd::passed) break;
      }
      if (below_ < 0 && above_ > 0) gallop(above_ - 1);
      return false;
    }
    return true;
  }

  /// Asks one seed, unless it was asked; the one that fails becomes the first.
  bool passes(Index value, std::size_t place) {
    ValueAnswer& answer = known_[value];
    answer.seeds.resize(grid_.seeds);
    const std::size_t seed = order_[place];
    if (answer.seeds[seed]) return answer.end == TrialEnd::passed;
    const TrialResult one = trial_(cell_, static_cast<std::size_t>(value), seed);
    if (one.end == TrialEnd::open) {
      found_.decided = false;
      found_.reason = one.reason;
      return false;
    }
    ++found_.runs;
    answer.seeds[seed] = one;
    const bool worse = !answer.utilisation || (one.utilisation && *one.utilisation > *answer.utilisation);
    if (worse || one.end != TrialEnd::passed) {
      answer.utilisation = one.utilisation;
      answer.governing = one.governing;
    }
    if (one.end == TrialEnd::passed) return true;
    answer.end = one.end;
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
    for (std::size_t seed = 0; seed < grid_.seeds; ++seed) tell_falls(seed);
  }

  /// Only runs that pass went to their end, so only their utilisations can be compared.
  void tell_falls(std::size_t seed) {
    const TrialResult* before = nullptr;
    for (const auto& [value, answer] : known_) {
      if (!answer.seeds[seed] || answer.seeds[seed]->end != TrialEnd::passed) continue;
      const TrialResult& now = *answer.seeds[seed];
      if (!now.utilisation) continue;
      if (before != nullptr && *now.utilisation < (1.0 - kFall) * *before->utilisation) {
        found_.remark = fmt::format(
            "the utilisation falls from {:.3f} to {:.3f} with a larger value: the limit may not "
            "be the only one",
            *before->utilisation, *now.utilisation);
      }
      before = &now;
    }
  }

  const OperabilityGrid& grid_;
  const OperabilityTrial& trial_;
  std::vector<std::size_t> order_;  ///< Of the seeds: the one that failed last first.
  std::optional<Index> begin_;      ///< Limit of the cell before; -1 where not even the least passed there.
  std::size_t cell_ = 0;
  Index below_ = -1, above_ = 0;
  std::map<Index, ValueAnswer> known_;
  SearchedCell found_;
};

std::size_t cells_of(const OperabilityGrid& grid) {
  return std::accumulate(grid.axes.begin(), grid.axes.end(), std::size_t{1}, std::multiplies<>());
}

/// Cells of one chain.
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
  return cells_of(grid) / std::max<std::size_t>(1, chain_length(grid));
}

std::size_t chain_of_cell(const OperabilityGrid& grid, std::size_t cell) {
  return cell / chain_length(grid);
}

std::vector<SearchedCell> search_operability(const OperabilityGrid& grid, const OperabilityTrial& trial, int threads) {
  std::vector<SearchedCell> cells(cells_of(grid));
  const std::size_t chains = operability_chains(grid);
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> faults(chains);
  const auto work = [&] {
    for (std::size_t i = next++; i < chains; i = next++) {
      try {
        search_chain(grid, trial, i, cells);
      } catch (...) {
        faults[i] = std::current_exception();
      }
    }
  };
  work_in_threads(useful_threads(threads, chains), work);
  for (const std::exception_ptr& fault : faults) {
    if (fault) std::rethrow_exception(fault);
  }
  return cells;
}

}  // namespace overbend
