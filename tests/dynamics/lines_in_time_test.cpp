/// Lines by themselves in motion, against other programs and closed forms.
#include <gtest/gtest.h>

#include "support/allocation_count.h"
#include "support/dynamic_benchmarks.h"
#include "support/line_cases.h"

namespace overbend {
namespace {

DynamicOptions options_for(double duration, double build_up, double max_value = 0.1) {
  DynamicOptions options;
  options.duration = duration;
  options.build_up = build_up;
  options.output_step = 0.1;
  options.max_step = max_value;
  return options;
}

struct Extremes {
  double min_value = 1e300, max_magnitude = -1e300;
};

Extremes find_value_extremes(const std::vector<double>& values) {
  Extremes e;
  for (const double value : values) {
    e.min_value = std::min(e.min_value, value);
    e.max_magnitude = std::max(e.max_magnitude, value);
  }
  return e;
}

struct ChainCase {
  const char* file;
  double depth, amplitude;
};

class chain : public ::testing::TestWithParam<ChainCase> {};

TEST_P(chain, whose_fairlead_heaves_has_the_extremes_of_orcaflex) {
  const ChainCase& chain_case = GetParam();
  const std::vector<LineHistory> lines =
      testing::run_lines(testing::chain_case(chain_case.depth, chain_case.amplitude), options_for(20.0, 10.0));
  const std::vector<std::vector<double>> reference = testing::number_columns(std::string("moordyn/") + chain_case.file);
  const Extremes fairlead = find_value_extremes(reference.at(3)), anchor = find_value_extremes(reference.at(4));
  // 3 % of the largest.
  EXPECT_NEAR(1e-3 * lines[0].max_last_tension, fairlead.max_magnitude, 0.03 * fairlead.max_magnitude);
  EXPECT_NEAR(1e-3 * lines[0].min_last_tension, fairlead.min_value, 0.03 * fairlead.max_magnitude);
  EXPECT_NEAR(1e-3 * lines[0].max_first_tension, anchor.max_magnitude, 0.03 * anchor.max_magnitude);
  EXPECT_NEAR(1e-3 * lines[0].min_first_tension, anchor.min_value, 0.03 * anchor.max_magnitude);
}

INSTANTIATE_TEST_SUITE_P(of_moordyn, chain,
                         ::testing::Values(ChainCase{"WD0050_Chain_ZZP1_A1.txt", 50.0, 2.0},
                                           ChainCase{"WD0050_Chain_ZZP1_A2.txt", 50.0, 5.0},
                                           ChainCase{"WD0200_Chain_ZZP1_A1.txt", 200.0, 2.0},
                                           ChainCase{"WD0200_Chain_ZZP1_A2.txt", 200.0, 5.0}));

/// The same in lengths of `scale`, by Froude's law: in the same water, under the same gravity.
Description scaled(Description d, double scale) {
  d.environment.water_depth *= scale;
  d.environment.seabed.stiffness *= scale;
  d.environment.seabed.damping *= std::pow(scale, 1.5);
  d.dynamics->duration *= std::sqrt(scale);
  d.dynamics->build_up *= std::sqrt(scale);
  d.dynamics->output_step *= std::sqrt(scale);
  FreeLineDescription& line = d.lines[0];
  LineTypeDescription& type = line.segments[0].type;
  for (double* size : {&type.diameter, &type.drag_diameter, &type.volume_diameter}) *size *= scale;
  for (double* weight : {&type.weight_in_air, &type.weight_submerged}) *weight *= scale * scale;
  type.axial_stiffness *= std::pow(scale, 3);
  line.segments[0].length.value() *= scale;
  for (LineEndDescription* end : {&line.first, &line.second}) {
    end->at *= scale;
    end->amplitude *= scale;
    end->period *= std::sqrt(scale);
  }
  return d;
}

LineHistory of_own_steps(const Description& d) {
  return testing::run_lines(d, dynamic_options(build_model(d)))[0];
}

TEST(chain_of_a_fiftieth_of_the_size, has_the_tensions_of_froudes_law) {
  constexpr double kScale = 1.0 / 50.0;
  Description d = testing::chain_case(50.0, 5.0);
  d.dynamics.emplace();
  d.dynamics->duration = d.dynamics->build_up = 10.0;
  d.dynamics->output_step = 0.1;
  d.environment.seabed.stiffness = 1e6;  // on a softer one the chain would sink by more than the model lets it, 1 cm
  const LineHistory whole = of_own_steps(d), small = of_own_steps(scaled(d, kScale));
  const double force = std::pow(kScale, 3);
  EXPECT_NEAR(small.max_last_tension / force, whole.max_last_tension, 0.005 * whole.max_last_tension);
  EXPECT_NEAR(small.min_last_tension / force, whole.min_last_tension, 0.005 * whole.max_last_tension);
  EXPECT_NEAR(small.max_first_tension / force, whole.max_first_tension, 0.005 * whole.max_last_tension);
}

struct JumperCase {
  const char* file;
  Vec3 amplitude;
};

class jumper : public ::testing::TestWithParam<JumperCase> {};

TEST_P(jumper, whose_top_moves_has_the_published_tension) {
  const std::vector<LineHistory> lines =
      testing::run_lines(testing::jumper_case(GetParam().amplitude), options_for(27.0, 27.0, 0.2));
  const std::vector<std::vector<double>> reference =
      testing::number_columns(std::string("lowe_langley/") + GetParam().file);
  double sum = 0.0;
  for (std::size_t i = 0; i < reference[0].size(); ++i) {
    const std::size_t row = static_cast<std::size_t>(std::lround(std::fmod(reference[0][i] + 270.0, 27.0) / 0.1));
    sum += std::pow(1e-3 * lines[0].last.at(row) - reference[1][i], 2);
  }
  const Extremes range = find_value_extremes(reference[1]);
  // Digitised to 0.2 kN; 0.5 kN is 1 % of the tension.
  EXPECT_LT(std::sqrt(sum / static_cast<double>(reference[0].size())), 0.5);
  EXPECT_NEAR(1e-3 * lines[0].max_last_tension, range.max_magnitude, 0.02 * range.max_magnitude);
  EXPECT_NEAR(1e-3 * lines[0].min_last_tension, range.min_value, 0.02 * range.min_value);
}

INSTANTIATE_TEST_SUITE_P(of_lowe_and_langley, jumper,
                         ::testing::Values(JumperCase{"case1.csv", Vec3(10.0, 0.0, 0.0)},
                                           JumperCase{"case2.csv", Vec3(0.0, 10.0, 0.0)}));

/// Unstressed length of a cable that hangs level over `span` with this horizontal force: elastic catenary.
double level_length(double span, double force, double weight, double EA) {
  double length = span;
  for (int i = 0; i < 50; ++i) {
    const double half = weight * length / (2.0 * force);
    const double reach = 2.0 * force / weight * std::asinh(half) + force * length / EA;
    length += (span - reach) / (1.0 / std::sqrt(1.0 + half * half) + force / EA);
  }
  return length;
}

/// Angular frequencies of small vibration about rest, rising, of the freedoms asked for [rad/s].
std::vector<double> frequencies(const testing::RestingLines& lines, const std::vector<int>& axes) {
  Assembly assembly(lines.setup.system);
  const testing::StiffnessAndMass full =
      testing::stiffness_and_mass(assembly, lines.start(options_for(1.0, 0.0)).state);
  std::vector<int> free;
  const int last = lines.line().mesh.nodes() - 1;
  for (int node = 0; node <= last; ++node) {
    for (const int axis : axes) {
      if (node > 0 && node < last) free.push_back(6 * node + axis);
      free.push_back(6 * node + 3 + axis);
    }
  }
  const Eigen::MatrixXd k = full.stiffness(free, free), m = full.mass(free, free);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(k, m, Eigen::EigenvaluesOnly);
  std::vector<double> all;
  for (const double square : modes.eigenvalues()) all.push_back(std::sqrt(square));
  return all;
}

// Irvine and Caughey (1974), linear theory of small sag: 500 m, 300 kN, lambda^2 39.03.
TEST(sagging_cable, vibrates_with_the_frequencies_of_irvine_and_caughey) {
  Description d = testing::water_alone(1025.0, 100.0);
  LineTypeDescription type = testing::cable_type(16.342, 0.0, 165.48e6, 10.0, 1025.0);
  type.diameter = 0.05;
  const double length = level_length(500.0, 300e3, type.weight_in_air, type.axial_stiffness);
  d.lines = {testing::free_line(type, length, Vec3(0.0, 0.0, 100.0), Vec3(500.0, 0.0, 100.0))};
  d.lines[0].element = 500.0 / 24.0;
  const testing::RestingLines lines(d);
  ASSERT_TRUE(lines.rest.converged());
  ASSERT_NEAR(lines.last[0].x(), 300e3, 100.0);
  const std::vector<double> in_plane = frequencies(lines, {0, 2}), out_of_plane = frequencies(lines, {1});
  const double expected_in[] = {1.6962, 1.7026, 2.6321, 3.4052, 4.2694};
  const double expected_out[] = {0.8513, 1.7026, 2.5539};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(in_plane[i], expected_in[i], 0.01 * expected_in[i]) << i;
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(out_of_plane[i], expected_out[i], 0.01 * expected_out[i]) << i;
}

TEST(lines_in_time, at_rest_stay_at_rest) {
  Description d = testing::chain_case(50.0, 0.0);
  d.environment.current = {{0.0, 0.5, 0.0}, {50.0, 0.5, 0.0}};
  const std::vector<LineHistory> lines = testing::run_lines(d, options_for(5.0, 0.0));
  const testing::RestingLines rest(d);
  // Steps balance to 1e-6 of the weight.
  EXPECT_NEAR(lines[0].min_last_tension, rest.last[0].norm(), 2e-5 * rest.last[0].norm());
  EXPECT_NEAR(lines[0].max_last_tension, rest.last[0].norm(), 2e-5 * rest.last[0].norm());
}

/// A line with a clump and a buoy in a wave, its top swinging.
Description busy_line() {
  Description d = testing::water_alone(1025.0, 100.0);
  LineTypeDescription type = testing::cable_type(16.3418, 0.0512, 165.48e6, 2e3, 1025.0);
  d.lines = {testing::free_line(type, 330.0, Vec3(0.0, 0.0, -80.0), Vec3(300.0, 0.0, -5.0))};
  LinePointDescription clump, buoy;
  clump.net_force = -10e3;
  clump.at = 100.0;
  buoy.kind = PointKind::buoy;
  buoy.net_force = 8e3;
  buoy.mass = 500.0;
  buoy.added_mass = 600.0;
  buoy.drag_area = 1.0;
  buoy.at = 250.0;
  d.lines[0].points = {clump, buoy};
  d.lines[0].second.amplitude = Vec3(1.0, 0.5, 1.0);
  d.lines[0].second.period = 9.0;
  d.environment.waves.front().type = WaveType::airy;
  d.environment.waves.front().height = 3.0;
  d.environment.waves.front().period = 9.0;
  return d;
}

TEST(lines_in_time, with_points_and_waves_keep_their_energy_to_second_order) {
  const testing::RestingLines rest(busy_line());
  ASSERT_TRUE(rest.rest.converged());
  const auto drift = [&](double h) {
    DynamicOptions options = options_for(4.0, 9.0);
    options.fixed_step = h;
    Simulation run(rest.model, rest.start(options), options);
    EXPECT_TRUE(run.advance(run.end())) << run.failure()->what;
    return run.energy().drift();
  };
  const double coarse = drift(0.05), fine = drift(0.025);
  EXPECT_LT(fine, 2e-3);
  EXPECT_LT(fine, 0.4 * coarse + 1e-5);
}

TEST(lines_in_time, on_a_heaving_vessel_swing_as_if_their_end_motion_were_prescribed) {
  const LineHistory prescribed = testing::run_lines(testing::chain_case(50.0, 2.0), options_for(10.0, 10.0)).front();
  Description d = testing::chain_case(50.0, 0.0);
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.harmonic["heave"] = {2.0, 10.0, 0.0};
  d.vessel.heading = 0.5 * std::numbers::pi;  // the bow to the east: V along W
  d.lines[0].second.kind = LineEndKind::body;
  const LineHistory transported = testing::run_lines(d, options_for(10.0, 10.0)).front();
  // The phase of the build-up differs where sine and cosine do; a period later little is left of that.
  EXPECT_NEAR(transported.max_last_tension, prescribed.max_last_tension, 0.01 * prescribed.max_last_tension);
  EXPECT_NEAR(transported.min_last_tension, prescribed.min_last_tension, 0.01 * prescribed.max_last_tension);
}

TEST(lines_in_time, have_their_extremes_along_the_line_whatever_the_output_step) {
  DynamicOptions rare = options_for(9.0, 9.0);
  rare.output_step = 9.0;
  const LineHistory often = testing::run_lines(busy_line(), options_for(9.0, 9.0)).front();
  const LineHistory seldom = testing::run_lines(busy_line(), rare).front();
  for (const LineHistory* line : {&often, &seldom}) {
    // The node of the end bears what holds it.
    EXPECT_NEAR(line->max_node_tension.back(), line->max_last_tension, 0.01 * line->max_last_tension);
    EXPECT_NEAR(line->min_tension.back(), line->min_last_tension, 0.01 * line->max_last_tension);
  }
  for (std::size_t node = 0; node < often.max_node_tension.size(); ++node) {
    EXPECT_NEAR(seldom.max_node_tension[node], often.max_node_tension[node], 0.05 * often.max_last_tension) << node;
    EXPECT_NEAR(seldom.min_tension[node], often.min_tension[node], 0.05 * often.max_last_tension) << node;
  }
}

/// A cable that lies a little slack on a bed that rubs, and is moved along it with both ends.
TEST(lines_in_time, that_are_pushed_along_the_bed_have_a_negative_tension_at_the_end_that_pushes) {
  Description d = testing::water_alone(1025.0, 100.0);
  d.environment.seabed.stiffness = 200e3;
  d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = 0.5;
  d.lines = {testing::free_line(testing::cable_type(60.0, 0.1, 1e8, 10.0, 1025.0), 100.0, Vec3(0.0, 0.0, -100.0),
                                Vec3(99.9, 0.0, -100.0))};
  for (LineEndDescription* end : {&d.lines[0].first, &d.lines[0].second}) {
    end->kind = LineEndKind::bed;
    end->amplitude = Vec3(3.0, 0.0, 0.0);
    end->period = 120.0;
  }
  const LineHistory line = testing::run_lines(d, options_for(60.0, 60.0)).front();
  const double rub = 0.5 * 100.0 * d.lines[0].segments[0].type.weight_submerged;
  EXPECT_LT(line.min_first_tension, -0.5 * rub);
  EXPECT_NEAR(line.min_first_tension, line.min_tension.front(), 0.05 * rub);
  for (std::size_t i = 0; i < line.first.size(); ++i) {
    EXPECT_NEAR(std::abs(line.last[i] - line.first[i]), rub, 0.05 * rub) << line.time[i];
    if (line.time[i] > 25.0) break;  // it turns at 30 s
  }
}

/// A hose clamped level at both ends, which bear its weight across it, while it is now pulled, now pushed a little.
TEST(lines_in_time, that_are_suspended_from_level_clamps_do_not_leap_from_a_pull_to_a_push) {
  Description d = testing::water_alone(1025.0, 100.0);
  d.lines = {testing::free_line(testing::cable_type(165.0, 0.3, 500e6, 300e3, 1025.0), 36.0, Vec3(0.0, 0.0, -30.0),
                                Vec3(30.0, 0.0, -30.0))};
  for (LineEndDescription* end : {&d.lines[0].first, &d.lines[0].second}) {
    end->clamped = true;
    end->direction = Vec3::UnitX();
  }
  d.lines[0].second.amplitude = Vec3(1.5, 0.0, 0.0);
  d.lines[0].second.period = 8.0;
  const LineHistory line = testing::run_lines(d, options_for(16.0, 16.0)).front();
  EXPECT_NEAR(line.max_first_tension, line.max_node_tension.front(), 300.0);
  EXPECT_NEAR(line.min_first_tension, line.min_tension.front(), 300.0);
  for (std::size_t i = 1; i < line.first.size(); ++i) {
    EXPECT_NEAR(line.first[i], line.first[i - 1], 2e3) << line.time[i];  // of 16 kN across
  }
}

void add_wave_along_x(Description& d, double height, double period) {
  d.environment.waves.front().type = WaveType::airy;
  d.environment.waves.front().height = height;
  d.environment.waves.front().period = period;
  d.environment.waves.front().from = 1.5 * std::numbers::pi;
}

/// A long line whose upper end stands out of the water between two that are held still: waves are felt over a
/// fifteenth of it.
TEST(lines_in_time, in_waves_swing_as_with_a_fine_mesh) {
  Description d = testing::water_alone(1025.0, 500.0);
  d.lines = {testing::free_line(testing::cable_type(25.0, 0.15, 20e6, 0.1, 1025.0), 600.0, Vec3(0.0, 0.0, -250.0),
                                Vec3(150.0, 0.0, 5.0))};
  add_wave_along_x(d, 6.0, 7.0);
  const LineHistory usual = testing::run_lines(d, options_for(28.0, 28.0)).front();
  d.lines[0].element = 1.0;
  const LineHistory fine = testing::run_lines(d, options_for(28.0, 28.0)).front();
  const double swing = fine.max_last_tension - fine.min_last_tension;
  EXPECT_NEAR(swing, 2.8e3, 0.3e3);  // 2.9 kN by a chain of point masses
  EXPECT_NEAR(usual.max_last_tension - usual.min_last_tension, swing, 0.15 * swing);  // 5.8 kN with elements of 30 m
}

/// A lazy wave: its buoyancy lifts the middle to the surface, from where the catenary of its mean weight is far.
TEST(lines_in_time, whose_buoyancy_lifts_them_into_the_waves_swing_as_with_a_fine_mesh) {
  Description d = testing::water_alone(1025.0, 120.0);
  d.environment.seabed.stiffness = 100e3;
  const LineTypeDescription heavy = testing::cable_type(60.0, 0.2, 2e8, 1e4, 1025.0);
  const LineTypeDescription light = testing::cable_type(80.0, 0.4, 2e8, 1e4, 1025.0);
  d.lines = {testing::free_line(heavy, 150.0, Vec3(-250.0, 0.0, -120.0), Vec3(0.0, 0.0, -5.0))};
  d.lines[0].first.kind = LineEndKind::bed;
  d.lines[0].segments.push_back({"", 90.0, light});
  d.lines[0].segments.push_back({"", 120.0, heavy});
  add_wave_along_x(d, 4.0, 8.0);
  const LineHistory usual = testing::run_lines(d, options_for(32.0, 32.0)).front();
  d.lines[0].element = 1.0;
  const LineHistory fine = testing::run_lines(d, options_for(32.0, 32.0)).front();
  const double swing = fine.max_first_tension - fine.min_first_tension;
  EXPECT_NEAR(usual.max_first_tension - usual.min_first_tension, swing, 0.2 * swing);
}

TEST(lines_in_time, allocate_nothing_in_a_step) {
  testing::RestingLines rest(busy_line());
  const DynamicOptions options = options_for(4.0, 9.0);
  Simulation run(rest.model, rest.start(options), options);
  run.advance(-8.0);
  const long before = testing::allocation_count();
  run.advance(-6.0);
  EXPECT_EQ(testing::allocation_count(), before);
}

}  // namespace
}  // namespace overbend
