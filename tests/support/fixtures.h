/// Small models and lines that several tests share.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "mechanics/line_elements.h"
#include "mechanics/rod_element.h"
#include "model/model.h"
#include "numerics/block_tridiagonal.h"

namespace overbend::testing {

/// The 16-inch pipe of [silva2009] table 4.
inline SectionDescription sixteen_inch_pipe() {
  SectionDescription pipe;
  pipe.steel = {0.4064, 0.011125, 207e9, 0.3, 414e6, std::nullopt, 77e3, {}};
  pipe.coatings = {{"corrosion coating", 0.0032, 9.32e3}, {"concrete", 0.0381, 21.974e3}};
  pipe.joint = JointDescription{12.0, 0.6, 10.065e3};
  pipe.hydrodynamics = {1.2, 0.03, 1.0, 0.0};
  return pipe;
}

/// That pipe, a barge heading east and a plain seabed; no supports.
inline Description plain_description() {
  Description d;
  d.title = "test";
  d.environment.water_depth = 89.0;
  d.environment.water_weight_density = 10.05e3;
  d.environment.seabed.stiffness = 100e3;
  d.pipe.section = sixteen_inch_pipe();
  d.vessel.heading = 0.5 * 3.14159265358979323846;
  d.vessel.stern_shoe_x = -60.0;
  d.tensioner.tension = 250e3;
  return d;
}

/// A bent, stretched and twisted chain of `nodes` nodes through `start`, for derivative and symmetry tests.
inline std::vector<double> wavy_line(int nodes, double h, const Vec3& start, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal(0.0, 0.05);
  std::vector<double> q;
  for (int i = 0; i < nodes; ++i) {
    const double s = i * h;
    const Vec3 r = start + Vec3(s, 0.3 * std::sin(0.7 * s), 0.2 * s + 0.4 * std::cos(0.5 * s));
    Vec3 t(1.0 + normal(generator), 0.21 * std::cos(0.7 * s) + normal(generator),
           0.2 - 0.2 * std::sin(0.5 * s) + normal(generator));
    for (int k = 0; k < 3; ++k) {
      q.push_back(r(k) + normal(generator));
    }
    for (int k = 0; k < 3; ++k) {
      q.push_back(t(k));
    }
  }
  return q;
}

/// Hummocks around the depth of 89 m, a grid of metres over the places of a wavy line.
inline Bathymetry hummocks() {
  Bathymetry bed;
  bed.columns = 9;
  bed.rows = 7;
  for (int row = 0; row < bed.rows; ++row) {
    for (int column = 0; column < bed.columns; ++column) {
      const double east = 2.5 * column - 3.0, north = 1.5 * row - 4.3;
      bed.east.push_back(east);
      bed.north.push_back(north);
      bed.depth.push_back(89.0 + 0.8 * std::sin(0.9 * east + 0.4 * north) + 0.3 * std::cos(1.3 * north));
    }
  }
  return bed;
}

inline ElementVector element_dofs(const std::vector<double>& q, int element) {
  return ElementVector(Eigen::Map<const ElementVector>(q.data() + 6 * element));
}

/// The blocks as a dense matrix.
inline Eigen::MatrixXd dense(const BlockTridiagonal& blocks) {
  const int n = blocks.nodes();
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(6 * n, 6 * n);
  for (int node = 0; node < n; ++node) {
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        m(6 * node + i, 6 * node + j) = blocks.diag(node)[8 * i + j];
        if (node + 1 < n) {
          m(6 * node + i, 6 * node + 6 + j) = blocks.upper(node)[8 * i + j];
          m(6 * node + 6 + i, 6 * node + j) = blocks.lower(node)[8 * i + j];
        }
      }
    }
  }
  return m;
}

}  // namespace overbend::testing
