/// Values by frequency and heading, collected one by one in any order.
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
  /// Six complex values by HeadingTable::index.
  struct Built {
    HeadingTable table;
    std::vector<CVec6> values;
  };

  /// `heading` [rad] is turned into [0, 2 pi). `mode` 0 to 5.
  void add(double omega, double heading, int mode, std::complex<double> value);
  bool empty() const { return entries_.empty(); }
  /// The sorted table. Where it has holes or contradictory values `fault` says so and nothing is returned. With
  /// `mirror` headings that the file lacks are those of the other side of a hull that is symmetric about its
  /// centreline: surge, heave and pitch even, sway, roll and yaw odd. A heading that the file has on both sides is the
  /// mean of its value and of the image of the other within a per cent of the mode's largest; beyond, the hull is not
  /// symmetric.
  std::optional<Built> build(bool mirror, std::string& fault) const;

 private:
  struct Entry {
    double omega = 0.0, heading = 0.0;
    int mode = 0;
    std::complex<double> value;
    bool image = false;  ///< Of the other side, not in the file.
  };
  /// By mode: a share of its largest value, at least one of the largest force or moment.
  Vec6 tolerances(double of_mode, double of_kind) const;
  std::vector<Entry> with_other_side() const;

  std::vector<Entry> entries_;
};

}  // namespace overbend
