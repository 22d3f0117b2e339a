/// Builds a table by frequency and heading from values in any order.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "model/description/hydrodynamic_data.h"

namespace overbend {

class HeadingTableBuilder {
 public:
  /// Table with six complex values (surge to yaw) per pair, indexed by HeadingTable::index.
  struct Built {
    HeadingTable table;
    std::vector<CVec6> values;
  };

  /// Adds a value at `omega` [rad/s] and `heading` [rad], which is wrapped to [0, 2 pi); `mode` is 0 (surge) to 5
  /// (yaw).
  void add(double omega, double heading, int mode, std::complex<double> value);
  bool empty() const { return entries_.empty(); }
  /// Returns the sorted table. If values are missing or contradictory, returns nothing and sets `error`. With `mirror`,
  /// missing headings are completed by symmetry about the centreline: surge, heave and pitch are even, sway, roll and
  /// yaw odd. A heading present on both sides gets the mean of its value and the mirrored one if they agree within 2 %
  /// of the mode's maximum; otherwise the hull is not symmetric and an error is reported.
  std::optional<Built> build(bool mirror, std::string& error) const;

 private:
  struct Entry {
    double omega = 0.0, heading = 0.0;
    int mode = 0;
    std::complex<double> value;
    bool image = false;  ///< Mirrored from the other side, not in the file.
  };
  /// Returns tolerances by mode: the fraction `of_mode` of the mode's maximum, and at least the fraction `of_kind` of
  /// the maximum force or moment.
  Vec6 tolerances(double of_mode, double of_kind) const;
  std::vector<Entry> with_mirrored_entries() const;

  std::vector<Entry> entries_;
};

}  // namespace overbend
