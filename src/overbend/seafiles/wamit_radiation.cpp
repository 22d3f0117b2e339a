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

constexpr double kSameFrequency = 1e-5;  ///< Relative: files print seven digits.

/// Block of `.1` of one frequency while it is read.
struct Block {
  RadiationPoint point;
  double column = 0.0;  ///< As its rows have it in the first column.
  Eigen::Matrix<bool, 6, 6> given = Eigen::Matrix<bool, 6, 6>::Constant(false);
  int line = 0;  ///< Of its first row.
};

/// ULEN^(least + 1 for every rotation).
double length_power(double length, int least, int i, int j) {
  return std::pow(length, least + (i > 2 ? 1 : 0) + (j > 2 ? 1 : 0));
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
  bool refuse(int line, std::string found, std::string expected) {
    diagnostics_.add({Severity::error, file_, line, 0, "", std::move(found), std::move(expected), ""});
    return false;
  }

  bool take(const Row& row) {
    const double omega = column_frequency(column_, row.values[0]);
    const bool finite = omega > 0.0 && std::isfinite(omega);
    const int i = mode_index(row.values[1]), j = mode_index(row.values[2]);
    if (i < 0 || j < 0) {
      return refuse(row.line, format_number(row.values[1]) + " " + format_number(row.values[2]),
                    "two modes from 1 to 6, of one body");
    }
    if (finite && row.columns != 5) {
      return refuse(row.line, "4 columns", "5 columns at a finite frequency: PER I J A B");
    }
    Block& block = blocks_[omega];
    if (block.line == 0) {
      block.line = row.line;
      block.column = row.values[0];
    }
    if (block.given(i, j)) {
      return refuse(row.line, "the pair " + pair(i, j) + " a second time", "each pair once for a frequency");
    }
    block.given(i, j) = true;
    block.point.omega = finite ? omega : 0.0;
    const double unit = source_.water_density * length_power(source_.length_scale, 3, i, j);
    block.point.added_mass(i, j) = unit * row.values[3];
    block.point.damping(i, j) = finite ? unit * block.point.omega * row.values[4] : 0.0;
    return true;
  }

  static std::string pair(int i, int j) { return std::to_string(i + 1) + " " + std::to_string(j + 1); }

  std::string words(const Block& block) const { return column_words(column_, block.column); }

  /// Every frequency, the infinite and zero one too, must list what the first finite one lists.
  bool check_pairs() {
    const auto first = blocks_.upper_bound(0.0), last = blocks_.lower_bound(kInfinity);
    if (first == last) {
      return refuse(0, "no finite frequency", "added mass and damping at four frequencies or more");
    }
    for (const auto& [omega, block] : blocks_) {
      if (block.given != first->second.given) {
        return refuse(block.line, "other pairs of modes than at " + words(first->second),
                      "the same pairs at every frequency");
      }
    }
    for (auto before = first, at = std::next(first); at != last; before = at++) {
      if (at->first - before->first < kSameFrequency * at->first) {
        const bool in_order = at->second.line > before->second.line;
        const Block &first_read = (in_order ? before : at)->second, &second_read = (in_order ? at : before)->second;
        return refuse(second_read.line, words(second_read) + " beside " + words(first_read), "each frequency once");
      }
    }
    return true;
  }

  /// Without forward speed the matrices are symmetric: a pair that stands once stands for both.
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
    for (auto at = blocks_.upper_bound(0.0); at != blocks_.lower_bound(kInfinity); ++at) {
      data.radiation.push_back(at->second.point);
    }
    if (const auto at = blocks_.find(kInfinity); at != blocks_.end()) {
      data.has_infinite = true;
      data.added_mass_infinite = at->second.point.added_mass;
    }
    if (const auto at = blocks_.find(0.0); at != blocks_.end()) {
      data.has_zero = true;
      data.added_mass_zero = at->second.point.added_mass;
    }
    if (data.radiation.size() < 4) {
      return refuse(0, std::to_string(data.radiation.size()) + " finite frequencies", "four or more");
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
    const int i = mode_index(row.values[0]), j = mode_index(row.values[1]);
    if (i < 0 || j < 0) {
      diagnostics.add({Severity::error, file, row.line, 0, "",
                       format_number(row.values[0]) + " " + format_number(row.values[1]), "two modes from 1 to 6", ""});
      return false;
    }
    data.hydrostatic_stiffness(i, j) = weight_density * length_power(source.length_scale, 2, i, j) * row.values[2];
  }
  return true;
}

}  // namespace overbend::wamit
