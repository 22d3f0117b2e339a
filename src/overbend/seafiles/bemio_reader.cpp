#include "seafiles/bemio_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/body_number.h"
#include "seafiles/hull_data_builder.h"
#include "seafiles/hull_statements.h"
#include "seafiles/hull_text.h"
#include "seafiles/netcdf_arrays.h"

namespace overbend {
namespace {

constexpr std::size_t kModeCount = 6, kMaxBodies = 50;

/// Array of three dimensions, or a scalar or list of the file.
NetcdfArray require_array(const NetcdfFile& file, const std::string& name) {
  const auto array = file.numbers(name);
  if (!array) throw HullFileError("no numbers in " + name, "a file of BEMIO with this variable");
  return *array;
}

class Cube {
 public:
  Cube(const NetcdfFile& file, const std::string& name, const std::vector<std::size_t>& sizes)
      : array_(require_array(file, name)) {
    if (array_.sizes == sizes) return;
    std::vector<std::string> found, expected;
    for (const std::size_t size : array_.sizes) found.push_back(std::to_string(size));
    for (const std::size_t size : sizes) expected.push_back(std::to_string(size));
    throw HullFileError(name + " of " + join_items(found, "by") + " numbers", join_items(expected, "by"));
  }
  double at(std::size_t i, std::size_t j, std::size_t k = 0) const {
    const std::size_t last = array_.sizes.size() > 2 ? array_.sizes[2] : 1;
    return array_.values[(i * array_.sizes[1] + j) * last + k];
  }

 private:
  NetcdfArray array_;
};

class BemioReader {
 public:
  BemioReader(const HydrodynamicsSource& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics), file_(source.path) {}

  HydrodynamicData read() {
    select_body();
    data_.source = source_.path;
    data_.origin_V = source_.origin_V;
    settle_constants();
    omega_ = require_array(file_, "simulation_parameters/w").values;
    for (const double omega : omega_) {
      if (!(omega > 0.0) || std::isinf(omega)) {
        throw HullFileError("simulation_parameters/w with " + format_number(omega) + " rad/s",
                            "finite frequencies above 0");
      }
    }
    read_radiation();
    read_excitation();
    builder_.build(data_, source_.mirror_headings);
    read_stiffness();
    add_statements();
    check_same_frequencies(data_, source_.path, source_.path, diagnostics_);
    complete_hull(data_, statements_, source_, diagnostics_);
    return std::move(data_);
  }

 private:
  void select_body() {
    std::vector<std::string> names;
    while (names.size() < kMaxBodies && file_.has(body_path(names.size()) + "properties/cg")) {
      const std::vector<std::string> texts = file_.texts(body_path(names.size()) + "properties/name");
      names.push_back(texts.empty() ? "" : for_display(texts.front()));
    }
    index_ = find_body(source_.body, names);
    path_ = body_path(index_);
    bodies_ = names.size();
  }

  static std::string body_path(std::size_t index) { return "body" + std::to_string(index + 1) + "/"; }

  std::optional<double> single(const std::string& name) const {
    const auto array = file_.numbers(name);
    return array && array->values.size() == 1 ? std::optional(array->values[0]) : std::nullopt;
  }

  void settle_constants() {
    const HydrodynamicsSource defaults;
    const auto density = single("simulation_parameters/rho"), gravity = single("simulation_parameters/g");
    data_.water_density =
        density ? settled_constant("water_density", source_.water_density, defaults.water_density, *density)
                : source_.water_density;
    data_.gravity =
        gravity ? settled_constant("gravity", source_.gravity, defaults.gravity, *gravity) : source_.gravity;
    scaled_ = single("simulation_parameters/scaled").value_or(0.0) != 0.0;
    if (!scaled_ && !density) {
      data_.notes.push_back(
          fmt::format("{} does not state the density of the water: its values are made dimensional "
                      "with {:.6g} kg/m^3.",
                      file_name(source_.path), data_.water_density));
    }
  }

  void read_radiation() {
    const std::size_t count = omega_.size(), motions = kModeCount * bodies_, first = kModeCount * index_;
    const Cube mass(file_, path_ + "hydro_coeffs/added_mass/all", {kModeCount, motions, count});
    const Cube damping(file_, path_ + "hydro_coeffs/radiation_damping/all", {kModeCount, motions, count});
    std::optional<Cube> infinite;
    if (file_.has(path_ + "hydro_coeffs/added_mass/inf_freq")) {
      infinite.emplace(file_, path_ + "hydro_coeffs/added_mass/inf_freq",
                       std::vector<std::size_t>{kModeCount, motions});
    }
    const double unit = scaled_ ? 1.0 : data_.water_density;
    for (std::size_t i = 0; i < kModeCount; ++i) {
      for (std::size_t j = 0; j < kModeCount; ++j) {
        const int row = static_cast<int>(i), column = static_cast<int>(j);
        for (std::size_t k = 0; k < count; ++k) {
          builder_.add_added_mass(omega_[k], row, column, unit * mass.at(i, first + j, k), 0);
          builder_.add_damping(omega_[k], row, column, (scaled_ ? 1.0 : unit * omega_[k]) * damping.at(i, first + j, k),
                               0);
        }
        if (infinite) builder_.add_added_mass(kInfinity, row, column, unit * infinite->at(i, first + j), 0);
      }
    }
  }

  /// Directions are in degrees. Some programs write radians.
  static void check_headings(const std::vector<double>& headings) {
    bool fractions = false, small = true;
    for (const double heading : headings) {
      if (!(std::abs(heading) <= 360.0)) {
        throw HullFileError("the wave direction " + format_number(heading), "-360 to 360 deg");
      }
      fractions = fractions || heading != std::round(heading);
      small = small && std::abs(heading) < kTurn + 0.01;
    }
    if (!fractions || !small) return;
    throw HullFileError("wave directions that are fractions below 6.3", "directions in degrees",
                        "are they in radians? Write simulation_parameters/wave_dir in degrees");
  }

  void read_excitation() {
    const std::vector<double> headings = require_array(file_, "simulation_parameters/wave_dir").values;
    const std::vector<std::size_t> sizes = {kModeCount, headings.size(), omega_.size()};
    const Cube real(file_, path_ + "hydro_coeffs/excitation/re", sizes);
    const Cube imaginary(file_, path_ + "hydro_coeffs/excitation/im", sizes);
    const double unit = scaled_ ? 1.0 : data_.water_density * data_.gravity;
    check_headings(headings);
    for (std::size_t i = 0; i < kModeCount; ++i) {
      for (std::size_t b = 0; b < headings.size(); ++b) {
        for (std::size_t k = 0; k < omega_.size(); ++k) {
          builder_.add_force(omega_[k], headings[b] * kDegree, static_cast<int>(i),
                             unit * std::complex<double>(real.at(i, b, k), imaginary.at(i, b, k)), 0);
        }
      }
    }
  }

  void read_stiffness() {
    const Cube stiffness(file_, path_ + "hydro_coeffs/linear_restoring_stiffness", {kModeCount, kModeCount});
    const double unit = scaled_ ? 1.0 : data_.water_density * data_.gravity;
    for (std::size_t i = 0; i < kModeCount; ++i) {
      for (std::size_t j = 0; j < kModeCount; ++j) {
        data_.hydrostatic_stiffness(static_cast<int>(i), static_cast<int>(j)) = unit * stiffness.at(i, j);
      }
    }
    if (!data_.hydrostatic_stiffness.allFinite()) {
      throw HullFileError("a stiffness that is not finite", "finite numbers");
    }
  }

  /// The place of one body among several is not that of the model's vessel: its centre of gravity is taken for the
  /// model's, in plan.
  void add_statements() {
    const NetcdfArray numbers = require_array(file_, path_ + "properties/cg");
    if (numbers.values.size() != 3) throw HullFileError("properties/cg without three numbers", "the centre of gravity");
    const Vec3 global(numbers.values[0], numbers.values[1], numbers.values[2]);
    check_point(global, 0, "the centre of gravity, properties/cg");
    Vec3 centre_V = source_.file_origin + global;
    if (bodies_ > 1) {
      centre_V.head<2>() = source_.origin_V.head<2>();
      data_.notes.push_back(fmt::format(
          "Body {} of {} in {} is used, with its centre of gravity in plan at that of the vessel; the forces "
          "that motions of the others cause on it are left out.",
          index_ + 1, bodies_, file_name(source_.path)));
    }
    statements_.centre_of_gravity = statements_.reference = centre_V;
    statements_.centre_in_file = "cg " + point_text(global);
    statements_.wave_origin = centre_V - global;
    const auto depth = single("simulation_parameters/water_depth");
    const std::vector<std::string> text = file_.texts("simulation_parameters/water_depth");
    if (depth) {
      statements_.water_depth = *depth;
    } else if (!text.empty() && lower_case(text.front()) == "infinite") {
      statements_.water_depth = kInfinity;
    }
    if (const auto volume = single(path_ + "properties/disp_vol")) statements_.displaced_volume = *volume;
  }

  const HydrodynamicsSource& source_;
  Diagnostics& diagnostics_;
  NetcdfFile file_;
  HydrodynamicData data_;
  HullStatements statements_;
  HullDataBuilder builder_;
  std::vector<double> omega_;
  std::string path_;
  std::size_t index_ = 0, bodies_ = 0;
  bool scaled_ = false;
};

}  // namespace

bool is_bemio(const std::string& path) {
  const NetcdfFile file(path);
  return file.has("simulation_parameters/w") && file.has("body1/properties/cg");
}

std::optional<HydrodynamicData> read_bemio(const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  try {
    return BemioReader(source, diagnostics).read();
  } catch (const HullFileError& error) {
    add_error(error, source.path, diagnostics);
  } catch (const std::runtime_error& error) {
    add_error(HullFileError(error.what(), "an HDF5 file of BEMIO"), source.path, diagnostics);
  }
  return std::nullopt;
}

}  // namespace overbend
