#include "seafiles/capytaine_reader.h"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <map>

#include "hull/made_radiation.h"

namespace overbend {
namespace {

constexpr const char* kDofs[] = {"Heave", "Pitch", "Roll", "Surge", "Sway", "Yaw"};  // as xarray sorts them
constexpr int kModeOfDof[] = {2, 4, 3, 0, 1, 5};

/// Writes a netCDF-4 file with the layout of Capytaine's exports.
class Writer {
 public:
  explicit Writer(const std::string& path) : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { H5Fclose(file_); }

  void numbers(const std::string& name, const std::vector<std::string>& dimensions,
               const std::vector<std::size_t>& sizes, const std::vector<double>& values) const {
    const std::vector<hsize_t> extent(sizes.begin(), sizes.end());
    H5LTmake_dataset_double(file_, name.c_str(), static_cast<int>(extent.size()), extent.data(), values.data());
    if (dimensions == std::vector{name}) {
      scale(name);
    }
    for (unsigned k = 0; k < dimensions.size() && dimensions[k] != name; ++k) {
      attach(name, dimensions[k], k);
    }
  }
  void write_texts(const std::string& name, const std::vector<const char*>& texts) const {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    const hsize_t count = texts.size();
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t set = H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data());
    H5Dclose(set);
    H5Sclose(space);
    H5Tclose(type);
    scale(name);
  }

 private:
  void scale(const std::string& name) const {
    const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    H5DSset_scale(set, name.c_str());
    H5Dclose(set);
  }
  void attach(const std::string& name, const std::string& dimension, unsigned k) const {
    const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    const hid_t of = H5Dopen2(file_, dimension.c_str(), H5P_DEFAULT);
    H5DSattach_scale(set, of, k);
    H5Dclose(of);
    H5Dclose(set);
  }
  hid_t file_;
};

/// The barge's first frequencies, two headings, in Capytaine's convention, and infinite frequency.
void write_barge(const std::string& path, double density, const std::map<std::string, std::vector<double>>& more = {}) {
  const HydrodynamicData& data = testing::bgl1_data();
  const std::size_t count = 6, headings = 2;
  const Writer writer(path);
  std::vector<double> omega, mass, damping, force(2 * (count + 1) * headings * 6), zero(force.size()), stiffness;
  for (std::size_t k = 0; k <= count; ++k) {
    const bool infinite = k == count;
    omega.push_back(infinite ? std::numeric_limits<double>::infinity() : data.radiation[k].omega);
    for (const int j : kModeOfDof) {
      for (const int i : kModeOfDof) {
        mass.push_back(infinite ? data.added_mass_infinite(i, j) : data.radiation[k].added_mass(i, j));
        damping.push_back(infinite ? 0.0 : data.radiation[k].damping(i, j));
      }
    }
    for (std::size_t b = 0; b < headings && !infinite; ++b) {
      for (std::size_t d = 0; d < 6; ++d) {
        const std::complex<double> value = data.force[data.excitation.index(k, b)](kModeOfDof[d]);
        const std::size_t index = (k * headings + b) * 6 + d;
        force[index] = value.real();
        force[index + (count + 1) * headings * 6] = -value.imag();  // exp(-i omega t)
      }
    }
  }
  for (const int i : kModeOfDof) {
    for (const int j : kModeOfDof) {
      stiffness.push_back(data.hydrostatic_stiffness(i, j));
    }
  }
  writer.write_texts("radiating_dof", {std::begin(kDofs), std::end(kDofs)});
  writer.write_texts("influenced_dof", {std::begin(kDofs), std::end(kDofs)});
  writer.write_texts("complex", {"re", "im"});
  writer.numbers("omega", {"omega"}, {count + 1}, omega);
  writer.numbers("wave_direction", {"wave_direction"}, {headings},
                 {data.excitation.heading.begin(), data.excitation.heading.begin() + headings});
  writer.numbers("rho", {}, {}, {density});
  writer.numbers("added_mass", {"omega", "radiating_dof", "influenced_dof"}, {count + 1, 6, 6}, mass);
  writer.numbers("radiation_damping", {"omega", "radiating_dof", "influenced_dof"}, {count + 1, 6, 6}, damping);
  const std::vector<std::string> of_force = {"complex", "omega", "wave_direction", "influenced_dof"};
  writer.numbers("diffraction_force", of_force, {2, count + 1, headings, 6}, force);
  writer.numbers("Froude_Krylov_force", of_force, {2, count + 1, headings, 6}, zero);
  writer.numbers("hydrostatic_stiffness", {"influenced_dof", "radiating_dof"}, {6, 6}, stiffness);
  for (const auto& [name, values] : more) {
    const bool matrix = values.size() == 36;
    writer.numbers(name,
                   matrix ? std::vector<std::string>{"influenced_dof", "radiating_dof"} : std::vector<std::string>{},
                   matrix               ? std::vector<std::size_t>{6, 6}
                   : values.size() == 1 ? std::vector<std::size_t>{}
                                        : std::vector{values.size()},
                   values);
  }
}

std::string scratch_file() {
  return (std::filesystem::temp_directory_path() / ("overbend_" + std::to_string(getpid()) + ".nc")).string();
}

TEST(capytaine_reader, a_file_says_what_wamits_files_of_the_same_hull_say) {
  HydrodynamicsSource source;
  source.path = scratch_file();
  write_barge(source.path, 1025.0);
  Diagnostics diagnostics;
  const auto data = read_hydrodynamics(source, diagnostics);
  std::filesystem::remove(source.path);
  ASSERT_TRUE(data) << diagnostics.lines(Severity::error)[0];
  const HydrodynamicData& wamit = testing::bgl1_data();
  ASSERT_EQ(data->radiation.size(), 6U);
  EXPECT_TRUE(data->has_infinite);
  EXPECT_EQ(data->added_mass_infinite, wamit.added_mass_infinite);
  EXPECT_EQ(data->radiation[3].added_mass, wamit.radiation[3].added_mass);
  EXPECT_EQ(data->radiation[3].damping, wamit.radiation[3].damping);
  EXPECT_EQ(data->hydrostatic_stiffness, wamit.hydrostatic_stiffness);
  ASSERT_EQ(data->excitation.heading.size(), 2U);
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_EQ(data->force[data->excitation.index(k, b)], wamit.force[wamit.excitation.index(k, b)]) << k << b;
    }
  }
  EXPECT_TRUE(data->drift.omega.empty());
}

TEST(capytaine_reader, errors_name_what_was_found_and_expected) {
  HydrodynamicsSource source;
  source.path = scratch_file();
  write_barge(source.path, 1000.0);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_hydrodynamics(source, diagnostics));
  std::filesystem::remove(source.path);
  ASSERT_EQ(diagnostics.error_count(), 1);
  EXPECT_NE(diagnostics.lines(Severity::error)[0].find("rho = 1000, expected that of the model, 1025"),
            std::string::npos)
      << diagnostics.lines(Severity::error)[0];
  { const Writer empty(source.path); }
  EXPECT_FALSE(read_hydrodynamics(source, diagnostics));
  std::filesystem::remove(source.path);
  EXPECT_FALSE(read_hydrodynamics(source, diagnostics));  // no file at all
  EXPECT_EQ(diagnostics.error_count(), 3);
}

struct StatedReading {
  std::optional<HydrodynamicData> data;
  std::vector<std::string> warnings, errors;
};

/// The barge's file with more variables, for a model with its centre of gravity at z = 0.818 m in 89 m of water.
StatedReading read_with(const std::map<std::string, std::vector<double>>& more, HydrodynamicsSource source = {}) {
  source.path = scratch_file();
  source.origin_V = Vec3(0.0, 0.0, 0.818);
  source.water_depth = 89.0;
  source.mass = 19121.58e3;
  write_barge(source.path, 1025.0, more);
  Diagnostics diagnostics;
  StatedReading reading{read_hydrodynamics(source, diagnostics), {}, {}};
  std::filesystem::remove(source.path);
  reading.warnings = diagnostics.lines(Severity::warning);
  reading.errors = diagnostics.lines(Severity::error);
  return reading;
}

TEST(capytaine_reader, values_about_a_rotation_centre_are_moved_to_the_centre_of_gravity) {
  const HydrodynamicData& given = testing::bgl1_data();
  const StatedReading same = read_with({{"rotation_center", {0.0, 0.0, 0.818}}, {"center_of_mass", {0.0, 0.0, 0.818}}});
  ASSERT_TRUE(same.data);
  EXPECT_FALSE(same.data->file_origin_V);
  const StatedReading moved = read_with({{"rotation_center", {0.0, 0.0, -5.182}}});
  ASSERT_TRUE(moved.data);
  EXPECT_EQ(moved.data->file_origin_V.value(), Vec3(0.0, 0.0, -5.182));
  // Sway and roll, 6 m above: A44' = A44 + 2 * 6 A24 + 36 A22 with the roll of the new point positive to starboard
  // down.
  const Mat6 &a = given.radiation[2].added_mass, &b = moved.data->radiation[2].added_mass;
  EXPECT_NEAR(b(3, 3), a(3, 3) + 12.0 * a(1, 3) + 36.0 * a(1, 1), 1e-9 * b(3, 3));
  EXPECT_NEAR(b(1, 3), a(1, 3) + 6.0 * a(1, 1), 1e-9 * std::abs(b(1, 3)));
  EXPECT_EQ(moved.data->hydrostatic_stiffness(3, 3), given.hydrostatic_stiffness(3, 3));
}

TEST(capytaine_reader, another_centre_of_mass_than_the_models_is_rejected_with_both_points) {
  const std::map<std::string, std::vector<double>> aft = {{"rotation_center", {-60.0, 0.0, -5.182}},
                                                          {"center_of_mass", {-60.0, 0.0, -5.0}}};
  const StatedReading rejected = read_with(aft);
  EXPECT_FALSE(rejected.data);
  ASSERT_EQ(rejected.errors.size(), 1U);
  for (const char* arguments :
       {"center_of_mass (-60, 0, -5) m", "rotation_center (-60, 0, -5.182) m", "(0, 0, 0.818) m"}) {
    EXPECT_NE(rejected.errors[0].find(arguments), std::string::npos) << rejected.errors[0];
  }
  HydrodynamicsSource source;
  source.file_origin = Vec3(60.0, 0.0, 5.818);
  EXPECT_TRUE(read_with(aft, source).data);
}

TEST(capytaine_reader, a_file_of_another_condition_is_rejected_or_warned_of) {
  EXPECT_NE(read_with({{"forward_speed", {2.0}}}).errors.at(0).find("forward_speed = 2 m/s"), std::string::npos);
  EXPECT_TRUE(read_with({{"forward_speed", {0.0}}, {"water_depth", {89.0}}}).warnings.empty());
  EXPECT_NE(read_with({{"water_depth", {400.0}}}).warnings.at(0).find("a water depth of 400 m, the model has 89 m"),
            std::string::npos);
  EXPECT_EQ(read_with({{"water_depth", {std::numeric_limits<double>::infinity()}}}).warnings.size(), 1U);
  std::vector<double> inertia(36, 0.0);
  for (std::size_t i = 0; i < 6; ++i) inertia[7 * i] = 15e6;
  EXPECT_NE(read_with({{"inertia_matrix", inertia}}).warnings.at(0).find("a mass of 15000 t"), std::string::npos);
}

}  // namespace
}  // namespace overbend
