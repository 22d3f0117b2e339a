#include "seafiles/wamit_radiation.h"

#include <cmath>
#include <iterator>
#include <map>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/wamit_table.h"

namespace overbend::wamit {
namespace {

constexpr double kSameFrequency = 1e-5;  ///< Relative tolerance: files print seven digits.

/// Block of a `.1` file for one frequency.
struct Block {
  RadiationPoint point;
  double column = 0.0;  ///< Value of the first column.
  Eigen::Matrix<bool, 6, 6> given = Eigen::Matrix<bool, 6, 6>::Constant(false);
  int line = 0;  ///< Line of its first row.
};

/// Returns ULEN^(power + 1 for every rotation).
double length_power(double length, int power, int i, int j) {
  return std::pow(length, power + (i > 2 ? 1 : 0) + (j > 2 ? 1 : 0));
}

class RadiationReader {
 public:
  RadiationReader(const HydrodynamicsSource& source, std::string file, Diagnostics& diagnostics)
      : source_(source), file_(std::move(file)), diagnostics_(diagnostics) {}

  bool read(HydrodynamicData& data) {
    const std::optional<Table> table = read_table(file_, 4, 5, diagnostics_);
    if (!table || !check_wave_column(source_, first_column(*table), file_, diagnostics_)) {
      return false;
    }
    for (const Row& row : table->rows) {
      if (!take(row)) {
        return false;
      }
    }
    if (!check_pairs()) {
      return false;
    }
    complete_pairs();
    return hand_over(data);
  }

 private:
  bool reject(int line, std::string found, std::string expected, std::string hint = {}) {
    diagnostics_.add({Severity::error, file_, line, 0, "", std::move(found), std::move(expected), std::move(hint)});
    return false;
  }

  bool take(const Row& row) {
    const double omega = column_frequency(column_, row.values[0]);
    const bool finite = omega > 0.0 && std::isfinite(omega);
    const int i = mode_index(row.values[1], source_.body), j = mode_index(row.values[2], source_.body);
    if (i == kOtherBody || j == kOtherBody) return true;
    if (i < 0 || j < 0) {
      return reject(row.line, format_number(row.values[1]) + " " + format_number(row.values[2]),
                    "two modes from 1 to 6, of one body", kBodyHint);
    }
    if (finite && row.columns != 5) {
      return reject(row.line, "4 columns", "5 columns at a finite frequency: PER I J A B");
    }
    Block& block = blocks_[omega];
    if (block.line == 0) {
      block.line = row.line;
      block.column = row.values[0];
    }
    if (block.given(i, j)) {
      return reject(row.line, "the pair " + pair(i, j) + " twice", "each pair once per frequency");
    }
    block.given(i, j) = true;
    block.point.omega = finite ? omega : 0.0;
    const double unit = source_.water_density * length_power(source_.length_scale, 3, i, j);
    block.point.added_mass(i, j) = unit * row.values[3];
    block.point.damping(i, j) = finite ? unit * block.point.omega * row.values[4] : 0.0;
    return true;
  }

  static std::string pair(int i, int j) { return std::to_string(i + 1) + " " + std::to_string(j + 1); }

  std::string block_label(const Block& block) const { return column_label(column_, block.column); }

  /// Checks that every frequency, including zero and infinite, lists the same pairs, and that frequencies are distinct.
  bool check_pairs() {
    const auto first = blocks_.upper_bound(0.0), last = blocks_.lower_bound(kInfinity);
    if (first == last) {
      return reject(0, "no finite frequency", "added mass and damping at four frequencies or more");
    }
    for (const auto& [omega, block] : blocks_) {
      if (block.given != first->second.given) {
        return reject(block.line, "pairs of modes that differ from those at " + block_label(first->second),
                      "the same pairs at every frequency");
      }
    }
    for (auto before = first, after = std::next(first); after != last; before = after++) {
      if (after->first - before->first < kSameFrequency * after->first) {
        const bool in_order = after->second.line > before->second.line;
        const Block &first_read = (in_order ? before : after)->second,
                    &second_read = (in_order ? after : before)->second;
        return reject(second_read.line, block_label(second_read) + " and " + block_label(first_read),
                      "each frequency once");
      }
    }
    return true;
  }

  /// Completes pairs by symmetry, which holds without forward speed.
  void complete_pairs() {
    for (auto& [omega, block] : blocks_) {
      for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
          if (block.given(i, j) || !block.given(j, i)) continue;
          block.point.added_mass(i, j) = block.point.added_mass(j, i);
          block.point.damping(i, j) = block.point.damping(j, i);
        }
      }
    }
  }

  bool hand_over(HydrodynamicData& data) {
    for (auto entry = blocks_.upper_bound(0.0); entry != blocks_.lower_bound(kInfinity); ++entry) {
      data.radiation.push_back(entry->second.point);
    }
    if (const auto entry = blocks_.find(kInfinity); entry != blocks_.end()) {
      data.has_infinite = true;
      data.added_mass_infinite = entry->second.point.added_mass;
    }
    if (const auto entry = blocks_.find(0.0); entry != blocks_.end()) {
      data.has_zero = true;
      data.added_mass_zero = entry->second.point.added_mass;
    }
    if (data.radiation.size() < 4) {
      return reject(0, std::to_string(data.radiation.size()) + " finite frequencies", "four or more");
    }
    return true;
  }

  const HydrodynamicsSource& source_;
  std::string file_;
  Diagnostics& diagnostics_;
  const WaveColumnSettings column_ = wave_column(source_);
  std::map<double, Block> blocks_;  ///< By frequency, zero and infinite included.
};

}  // namespace

bool read_radiation(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                    Diagnostics& diagnostics) {
  return RadiationReader(source, file, diagnostics).read(data);
}

bool read_hydrostatics(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                       Diagnostics& diagnostics) {
  const std::optional<Table> table = read_table(file, 3, 3, diagnostics);
  if (!table) {
    return false;
  }
  const double weight_density = source.water_density * source.gravity;
  for (const Row& row : table->rows) {
    const int i = mode_index(row.values[0], source.body), j = mode_index(row.values[1], source.body);
    if (i == kOtherBody || j == kOtherBody) continue;
    if (i < 0 || j < 0) {
      diagnostics.add({Severity::error, file, row.line, 0, "",
                       format_number(row.values[0]) + " " + format_number(row.values[1]), "two modes from 1 to 6",
                       kBodyHint});
      return false;
    }
    data.hydrostatic_stiffness(i, j) = weight_density * length_power(source.length_scale, 2, i, j) * row.values[2];
  }
  return true;
}

}  // namespace overbend::wamit
