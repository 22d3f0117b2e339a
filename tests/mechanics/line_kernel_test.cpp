#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/ground.h"
#include "mechanics/point_load.h"
#include "mechanics/quadrature.h"
#include "mechanics/slack_law.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

/// Height of the line, and what it may meet there.
struct Place {
  double z = 0.0;
  bool uneven = false;
  SoilModel soil = SoilModel::linear;
};

using testing::dense;

struct Setting {
  Model model;
  LineElements elements;
  LineEnvironment env;
  std::vector<double> q;
  int nodes;
};

/// A line that crosses the surface or lies on the bed, in a turning current, with contents under pressure and Poisson's
/// ratio.
Setting setting(const Place& place, bool loads) {
  Description d = testing::plain_description();
  if (loads) {
    d.environment.seabed.slope = 0.05;
    if (place.uneven) d.environment.seabed.bathymetry = testing::hummocks();
    d.environment.seabed.soil = place.soil;
    d.environment.seabed.bearing_force = 40e3;
    d.environment.seabed.slope_towards = 1.0;
    d.environment.seabed.friction_lateral = 0.5;
    d.environment.seabed.friction_axial = 0.3;
    d.environment.current = {{0.0, 1.0, 0.3}, {20.0, 0.7, 1.0}, {89.0, 0.3, 2.0}};
    d.pipe.section.contents_weight_density = 5e3;
    d.pipe.section.internal_pressure = 2e6;
    d.pipe.section.steel.youngs_modulus = 2e4;  // a soft pipe, so that rounding of stiff terms does not hide the loads
  }
  Setting s{build_model(d), {}, {}, {}, 12};
  if (!loads) {
    Section& section = s.model.sections[0];
    section.weight_in_air = section.external_area = section.drag_normal = section.drag_axial = 0.0;
    s.model.seabed.stiffness = 0.0;
  }
  std::vector<double> lengths;
  for (int i = 0; i + 1 < s.nodes; ++i) {
    lengths.push_back(1.0 + 0.05 * i);
  }
  s.elements = line_elements(s.model, lengths, std::vector<int>(lengths.size(), 0));
  s.env = line_environment(s.model, LayRoute(Vec3(0.0, 0.01, 0.0), -Vec3::UnitX()));
  s.q = testing::wavy_line(s.nodes, 1.1, Vec3(0.0, 0.0, place.z), 5);
  return s;
}

std::vector<double> residual(const Setting& s, const std::vector<double>& q, BlockTridiagonal* tangent, Isa isa) {
  std::vector<double> r(q.size(), 0.0);
  LineTarget target{r.data(), nullptr, nullptr, nullptr};
  if (tangent != nullptr) {
    target = {r.data(), tangent->diag(0), tangent->upper(0), tangent->lower(0)};
  }
  add_line_forces(s.elements, s.env, {q.data(), nullptr}, target, isa);
  return r;
}

/// Against the scalar form, to `rounding` of the largest entry.
void expect_rods(const Setting& s, double rounding = 1e-12) {
  BlockTridiagonal tangent(s.nodes);
  const std::vector<double> force = residual(s, s.q, &tangent, best_isa());
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(6 * s.nodes);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(6 * s.nodes, 6 * s.nodes);
  for (int e = 0; e + 1 < s.nodes; ++e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const RodForce rod =
        rod_force({s.elements.length[i], s.elements.EA[i], s.elements.EI[i], s.elements.compression[i]},
                  testing::element_dofs(s.q, e));
    expected.segment<12>(6 * e) += rod.force;
    stiffness.block<12, 12>(6 * e, 6 * e) += rod.stiffness;
  }
  const Eigen::Map<const Eigen::VectorXd> got(force.data(), 6 * s.nodes);
  EXPECT_LT((got - expected).cwiseAbs().maxCoeff(), rounding * expected.cwiseAbs().maxCoeff());
  EXPECT_LT((dense(tangent) - stiffness).cwiseAbs().maxCoeff(), rounding * stiffness.cwiseAbs().maxCoeff());
}

TEST(line_kernel, agrees_with_the_scalar_rod_element) {
  expect_rods(setting({50.0}, false));
}

// Batches of elements that only pull, of pipe, and of both.
TEST(line_kernel, agrees_with_the_scalar_rod_element_where_lines_go_slack) {
  for (const std::size_t every : {1u, 2u, 3u}) {
    Setting s = setting({50.0}, false);
    for (std::size_t i = 0; i < s.elements.compression.size(); i += every) s.elements.compression[i] = kSlackShare;
    for (std::size_t node = 0; node < static_cast<std::size_t>(s.nodes); ++node) {
      const double strain = node % 3 == 0 ? 1e-3 : node % 3 == 1 ? -1e-3 : 0.4 * kSlackStrain;
      Eigen::Map<Vec3> tangent(s.q.data() + 6 * node + 3);
      tangent *= (1.0 + strain) / tangent.norm();
    }
    expect_rods(s, 1e-16 / kSlackStrain);  // of strains, in the transition
    const std::vector<double> at_rest(s.q.size(), 0.0);
    const double energy =
        line_energy(s.elements, s.env, {s.q.data(), nullptr}, {at_rest.data(), at_rest.data()}, best_isa()).strain;
    double expected = 0.0;
    for (int e = 0; e + 1 < s.nodes; ++e) {
      const std::size_t i = static_cast<std::size_t>(e);
      expected += rod_force({s.elements.length[i], s.elements.EA[i], s.elements.EI[i], s.elements.compression[i]},
                            testing::element_dofs(s.q, e))
                      .energy;
    }
    EXPECT_NEAR(energy, expected, 1e-12 * expected);
  }
}

class line_kernel_loads : public ::testing::TestWithParam<Place> {};

/// Against central differences of forces.
void expect_exact_tangent(const Setting& s) {
  BlockTridiagonal tangent(s.nodes);
  residual(s, s.q, &tangent, best_isa());
  const Eigen::MatrixXd exact = dense(tangent);
  const double step = 1e-6;
  Eigen::MatrixXd difference(exact.rows(), exact.cols());
  for (int j = 0; j < exact.cols(); ++j) {
    std::vector<double> up = s.q, down = s.q;
    up[static_cast<std::size_t>(j)] += step;
    down[static_cast<std::size_t>(j)] -= step;
    const std::vector<double> r1 = residual(s, up, nullptr, best_isa());
    const std::vector<double> r0 = residual(s, down, nullptr, best_isa());
    for (int i = 0; i < exact.rows(); ++i) {
      difference(i, j) = (r1[static_cast<std::size_t>(i)] - r0[static_cast<std::size_t>(i)]) / (2.0 * step);
    }
  }
  for (int i = 0; i < exact.rows(); ++i) {
    for (int j = 0; j < exact.cols(); ++j) {
      // Central difference of forces up to 1e5 N that carry 1e-11 N of rounding, over 1e-6.
      ASSERT_NEAR(exact(i, j), difference(i, j), 1e-6 * std::abs(exact(i, j)) + 2e-3) << i << " " << j;
    }
  }
}

TEST_P(line_kernel_loads, tangent_is_the_derivative_of_the_force) {
  expect_exact_tangent(setting(GetParam(), true));
}

INSTANTIATE_TEST_SUITE_P(from_air_to_seabed, line_kernel_loads,
                         ::testing::Values(Place{3.0}, Place{-1.2}, Place{-30.0}, Place{-90.0}, Place{-90.0, true},
                                           Place{-90.0, true, SoilModel::hyperbolic},
                                           Place{-90.0, false, SoilModel::bilinear}));

/// Parts of the route are 6 m long arcs, so that its bend matters relative to the stiffness of the bed.
Setting on_bent_route(const LayRoute& route, double friction) {
  Setting s = setting({-92.5}, true);  // partly in the bed, which slopes
  s.env = line_environment(s.model, route);
  s.env.bed_friction_lateral = friction;
  return s;
}

TEST(line_kernel, tangent_on_a_bent_route_is_the_derivative_of_the_force_sticking_and_sliding) {
  const LayRoute route(Vec3(-4.0, 0.3, 0.0), Vec3::UnitX(), 4.0, {{0.0, 9.0, 0.6}, {2.0, 0.0, 0.0}, {0.0, 7.0, -0.5}});
  expect_exact_tangent(on_bent_route(route, 0.5));
  expect_exact_tangent(on_bent_route(route, 1e3));
}

TEST(line_kernel, friction_on_a_bent_route_is_that_of_the_point_load) {
  const LayRoute route(Vec3(-4.0, 0.3, 0.0), Vec3::UnitX(), 4.0, {{0.0, 9.0, 0.6}, {2.0, 0.0, 0.0}, {0.0, 7.0, -0.5}});
  Setting s = on_bent_route(route, 0.5), none = on_bent_route(route, 0.0);
  const std::vector<double> with = residual(s, s.q, nullptr, best_isa()),
                            without = residual(none, s.q, nullptr, best_isa());
  Vec3 kernel = Vec3::Zero(), points = Vec3::Zero();
  for (int node = 0; node < s.nodes; ++node) {
    for (int i = 0; i < 3; ++i) {
      const std::size_t dof = static_cast<std::size_t>(6 * node + i);
      kernel(i) -= with[dof] - without[dof];
    }
  }
  for (int e = 0; e + 1 < s.nodes; ++e) {
    const double h = s.elements.length[static_cast<std::size_t>(e)];
    for (int i = 0; i < kGaussPoints; ++i) {
      const CentrelinePoint point = centreline(testing::element_dofs(s.q, e), kGaussXi[i], h);
      points += kGaussWeight[i] * h *
                (point_load(s.elements, s.env, e, point.r, point.a).seabed -
                 point_load(none.elements, none.env, e, point.r, point.a).seabed);
    }
  }
  EXPECT_GT(points.norm(), 1e3);
  EXPECT_LT((kernel - points).norm(), 1e-9 * points.norm());
}

/// Dragged along a bed, plane or uneven, half against the route and half with it.
Setting dragged(bool uneven) {
  Setting s = setting({-92.5, uneven}, true);  // partly in the bed
  s.env.dragged = true;
  for (std::size_t e = 0; e < s.elements.drag_on_bed.size(); ++e) s.elements.drag_on_bed[e] = e < 6 ? -0.45 : 0.6;
  return s;
}

TEST(line_kernel, tangent_of_a_dragged_line_is_the_derivative_of_the_force) {
  for (const bool uneven : {false, true}) expect_exact_tangent(dragged(uneven));
}

TEST(line_kernel, friction_of_a_dragged_line_is_its_share_of_the_normal_force_along_the_bed) {
  for (const bool uneven : {false, true}) {
    Setting s = dragged(uneven);
    s.env.bed_friction_lateral = 0.0;  // level, so that it has a part along a bed that slopes across
    for (const int e : {2, 8}) {
      const CentrelinePoint point =
          centreline(testing::element_dofs(s.q, e), 0.5, s.elements.length[static_cast<std::size_t>(e)]);
      const PointLoad load = point_load(s.elements, s.env, e, point.r, point.a);
      const GroundPoint ground = ground_at(s.env, point.r);
      if (load.seabed_normal == 0.0) continue;
      const double drag = s.elements.drag_on_bed[static_cast<std::size_t>(e)];
      EXPECT_NEAR(load.seabed.dot(ground.along_route), drag * load.seabed_normal, 1e-9 * load.seabed_normal);
    }
  }
}

TEST(line_kernel, friction_of_a_dragged_line_in_the_kernel_is_that_of_the_point_load) {
  for (const bool uneven : {false, true}) {
    const Setting s = dragged(uneven);
    Setting none = dragged(uneven);
    std::fill(none.elements.drag_on_bed.begin(), none.elements.drag_on_bed.end(), 0.0);
    const std::vector<double> with = residual(s, s.q, nullptr, best_isa()),
                              without = residual(none, none.q, nullptr, best_isa());
    Vec3 kernel = Vec3::Zero(), points = Vec3::Zero();
    for (int node = 0; node < s.nodes; ++node) {
      for (int i = 0; i < 3; ++i) {
        const std::size_t dof = static_cast<std::size_t>(6 * node + i);
        kernel(i) -= with[dof] - without[dof];
      }
    }
    for (int e = 0; e + 1 < s.nodes; ++e) {
      const double h = s.elements.length[static_cast<std::size_t>(e)];
      for (int i = 0; i < kGaussPoints; ++i) {
        const CentrelinePoint point = centreline(testing::element_dofs(s.q, e), kGaussXi[i], h);
        points += kGaussWeight[i] * h *
                  (point_load(s.elements, s.env, e, point.r, point.a).seabed -
                   point_load(none.elements, none.env, e, point.r, point.a).seabed);
      }
    }
    EXPECT_GT(points.norm(), 1e3);
    EXPECT_LT((kernel - points).norm(), 1e-9 * points.norm());
  }
}

TEST(line_kernel, gives_the_same_on_every_instruction_set) {
  const Setting s = setting({-1.2}, true);
  BlockTridiagonal reference(s.nodes);
  const std::vector<double> expected = residual(s, s.q, &reference, Isa::baseline);
  const double max_value = dense(reference).cwiseAbs().maxCoeff();
  for (const Isa isa : {Isa::avx2, Isa::avx512}) {
    if (isa > best_isa()) {
      continue;
    }
    BlockTridiagonal tangent(s.nodes);
    const std::vector<double> got = residual(s, s.q, &tangent, isa);
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_NEAR(got[i], expected[i], 1e-13 * max_value);  // rounding of fused multiply-adds
    }
    EXPECT_LT((dense(tangent) - dense(reference)).cwiseAbs().maxCoeff(), 1e-13 * max_value);
  }
}

TEST(line_kernel, rigid_rotation_of_a_bent_line_makes_no_other_force) {
  const Setting s = setting({50.0}, false);
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  std::vector<double> turned = s.q;
  for (std::size_t i = 0; i < turned.size(); i += 3) {
    Eigen::Map<Vec3> v(turned.data() + i);
    v = (turn * v).eval();
  }
  const std::vector<double> before = residual(s, s.q, nullptr, best_isa());
  const std::vector<double> after = residual(s, turned, nullptr, best_isa());
  double max_value = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < before.size(); i += 3) {
    const Vec3 f0 = Eigen::Map<const Vec3>(before.data() + i);
    const Vec3 f1 = Eigen::Map<const Vec3>(after.data() + i);
    max_value = std::max(max_value, f0.norm());
    worst = std::max(worst, (f1 - turn * f0).norm());
  }
  EXPECT_LT(worst, 1e-12 * max_value);
}

TEST(line_kernel, a_line_described_from_its_other_end_feels_the_same_forces) {
  const Setting s = setting({-1.2}, true);
  Setting reversed = setting({-1.2}, true);
  const std::size_t n = static_cast<std::size_t>(s.nodes);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      reversed.q[6 * i + k] = s.q[6 * (n - 1 - i) + k];
      reversed.q[6 * i + 3 + k] = -s.q[6 * (n - 1 - i) + 3 + k];
    }
  }
  std::vector<double> lengths(s.elements.length.begin(), s.elements.length.begin() + s.elements.count);
  std::reverse(lengths.begin(), lengths.end());
  reversed.elements = line_elements(reversed.model, lengths, std::vector<int>(lengths.size(), 0));
  const std::vector<double> a = residual(s, s.q, nullptr, best_isa());
  const std::vector<double> b = residual(reversed, reversed.q, nullptr, best_isa());
  double max_value = 0.0;
  for (const double f : a) {
    max_value = std::max(max_value, std::abs(f));
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(b[6 * i + k], a[6 * (n - 1 - i) + k], 1e-12 * max_value);
      EXPECT_NEAR(b[6 * i + 3 + k], -a[6 * (n - 1 - i) + 3 + k], 1e-12 * max_value);
    }
  }
}

}  // namespace
}  // namespace overbend
