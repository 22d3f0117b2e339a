/// Collects the coefficients of a hull from a file in any order.
#pragma once

#include <complex>
#include <map>
#include <string>

#include "model/description/hydrodynamic_data.h"
#include "seafiles/heading_table_builder.h"

namespace overbend {

/// All values are in SI; frequencies [rad/s] of 0 and infinity are the limits of the added mass. Modes are 0 (surge) to
/// 5 (yaw), headings the direction of travel of the waves [rad], anticlockwise from the hull's x axis. Values that are
/// not finite, twice there with different values or missing throw HullFileError.
class HullDataBuilder {
 public:
  void add_added_mass(double omega, int i, int j, double value, int line);
  void add_damping(double omega, int i, int j, double value, int line);
  /// Wave force per amplitude, as HydrodynamicData::force: phases lead.
  void add_force(double omega, double heading, int mode, std::complex<double> force, int line);
  /// Mean drift per squared amplitude; modes other than surge, sway and yaw are ignored.
  void add_drift(double omega, double heading, int mode, double force, int line);

  bool has_forces() const { return !forces_.empty(); }
  bool has_drift() const { return !drift_.empty(); }

  /// Moves radiation, excitation and drift into `data`. With `mirror`, missing headings are completed by symmetry about
  /// the centreline.
  void build(HydrodynamicData& data, bool mirror) const;

 private:
  struct Radiation {
    Mat6 added_mass = Mat6::Zero(), damping = Mat6::Zero();
    Eigen::Matrix<bool, 6, 6> has_mass = Eigen::Matrix<bool, 6, 6>::Constant(false), has_damping = has_mass;
    int line = 0;
  };

  Radiation& radiation(double omega, int i, int j, double value, int line);
  void build_radiation(HydrodynamicData& data) const;

  std::map<double, Radiation> radiation_;
  HeadingTableBuilder forces_, drift_;
};

}  // namespace overbend
