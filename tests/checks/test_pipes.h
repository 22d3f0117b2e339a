/// Three pipes with the values that the code formulas give for them, computed apart from the program: 16" X60 in 89 m,
/// 24" X65 in 1000 m, 12.75" X65 in 2000 m; alpha_U 0.96, low safety class, O_0 0.005, alpha_h 0.93, load factors 1.
#pragma once

#include <array>

#include "checks/api_1111.h"
#include "checks/dnv_pressure.h"

namespace overbend {

struct TestPipe {
  const char* name;
  double diameter, wall, smys, smts, alpha_fab, depth;           // m, Pa
  double external;                                               // MPa
  double elastic, plastic, collapse, propagation;                // MPa
  double beta, alpha_c, plastic_force, plastic_moment;           // -, -, kN, kN m
  double force, moment, lcc, collapse_share, propagation_share;  // kN, kN m, -
  double strain_capacity, girth_weld, dcc;                       // at 0.2 %
  double api_collapse, api_collapse_share, api_buckling, api_propagation, api_bending_third, api_bending_fourth;

  Wall geometry() const { return {diameter, wall, 207e9, 0.3}; }
  ApiPipe api() const { return {diameter, wall, smys, 207e9, 0.3}; }
  double fy() const { return 0.96 * smys; }
  double fu() const { return 0.96 * smts; }
  double pressure() const { return 1025.0 * 9.81 * depth; }
};

inline constexpr double kGammas = 1.15 * 1.04;

inline constexpr std::array<TestPipe, 3> kTestPipes = {{
    {"16in X60", 0.4064,  0.011125, 414e6,   517e6,   0.85,    89.0,    0.8949, 9.3325,  18.4955,
     8.3636,     1.4660,  0.26077,  1.06488, 5490.61, 690.829, 250.0,   150.0,  0.07713, 0.12797,
     0.73011,    0.01261, 0.8347,   0.52700, 8.6296,  0.14815, 0.01369, 1.7654, 0.51550, 0.57427},
    {"24in X65", 0.6096,  0.0254, 448e6,   531e6,    0.85,     1000.0,  10.0552, 32.9098, 30.4640,
     24.2805,    4.5343,  0.4,    1.07411, 20049.08, 3728.259, 1000.0,  900.0,   0.31924, 0.49530,
     2.65226,    0.02644, 0.96,   0.71602, 24.6873,  0.58186,  0.02083, 5.2358,  0.71177, 0.94258},
    {"12in X65", 0.32385, 0.01905, 448e6,   531e6,   1.0,     2000.0,  20.1105, 92.6003, 50.5976,
     46.4652,    12.6327, 0.47778, 1.08852, 7845.29, 761.157, 1200.0,  150.0,   0.32786, 0.51764,
     1.90397,    0.04246, 1.0,     0.66873, 45.8059, 0.62720, 0.02941, 11.9788, 0.66975, 0.91854},
}};

}  // namespace overbend
