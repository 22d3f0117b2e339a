#include "seafiles/capytaine_reader.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/heading_table_builder.h"
#include "seafiles/hull_file_error.h"
#include "seafiles/hull_statements.h"
#include "seafiles/netcdf_arrays.h"

namespace overbend {
namespace {

constexpr const char* kModes[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

/// A variable addressed by the names of its dimensions, independent of their order in the file.
class Variable {
 public:
  Variable(NetcdfArray array, const std::string& name, const std::vector<std::string>& dimensions)
      : array_(std::move(array)),
        name_(name),
        dimensions_(dimensions),
        strides_(dimensions.size(), 0),
        counts_(dimensions.size(), 0) {
    std::size_t stride = 1, known = 0;
    for (std::size_t k = array_.sizes.size(); k-- > 0;) {
      const auto found = std::find(dimensions.begin(), dimensions.end(), array_.dimensions[k]);
      if (found != dimensions.end()) {
        strides_[static_cast<std::size_t>(found - dimensions.begin())] = stride;
        counts_[static_cast<std::size_t>(found - dimensions.begin())] = array_.sizes[k];
        ++known;
      } else if (array_.sizes[k] != 1) {
        throw HullFileError("the dimension '" + for_display(array_.dimensions[k]) + "' of " + name,
                            "only " + join_items(dimensions, "and"));
      }
      stride *= array_.sizes[k];
    }
    if (known != dimensions.size()) {
      throw HullFileError(std::to_string(known) + " of the dimensions of " + name, join_items(dimensions, "and"));
    }
  }
  /// Returns the value at `indices`, in the order of the dimension names passed to the constructor.
  double at(std::initializer_list<std::size_t> indices) const {
    std::size_t place = 0, k = 0;
    for (const std::size_t index : indices) {
      if (index >= counts_[k]) {
        throw HullFileError(std::to_string(counts_[k]) + " values of " + name_ + " along " + dimensions_[k],
                            "one for each entry of that dimension");
      }
      place += index * strides_[k++];
    }
    return array_.values[place];
  }

 private:
  NetcdfArray array_;
  std::string name_;
  std::vector<std::string> dimensions_;
  std::vector<std::size_t> strides_, counts_;
};

NetcdfArray require_numbers(const NetcdfFile& file, const std::string& name) {
  auto array = file.numbers(name);
  if (!array && file.has(name)) {
    throw HullFileError(name + " without real numbers", "a Capytaine file with complex values separated");
  }
  if (!array) throw HullFileError("no variable " + name, "a Capytaine file with this variable");
  return *array;
}

Variable variable(const NetcdfFile& file, const std::string& name, const std::vector<std::string>& dimensions) {
  return {require_numbers(file, name), name, dimensions};
}

/// Returns the mode indices (0 surge to 5 yaw) of degrees of freedom such as "Heave" or "hull__Heave".
std::vector<int> read_modes(const NetcdfFile& file, const std::string& name) {
  std::vector<int> modes;
  for (const std::string& word : file.texts(name)) {
    const std::size_t body = word.rfind("__");
    const std::string plain = lower_case(body == std::string::npos ? word : word.substr(body + 2));
    const auto found = std::find(std::begin(kModes), std::end(kModes), plain);
    const int mode = static_cast<int>(found - std::begin(kModes));
    if (found == std::end(kModes) || std::find(modes.begin(), modes.end(), mode) != modes.end()) {
      throw HullFileError("'" + for_display(word) + "' in " + name, "surge to yaw of one body, each once");
    }
    modes.push_back(mode);
  }
  if (modes.empty()) {
    throw HullFileError("no text in " + name, "names of degrees of freedom");
  }
  return modes;
}

void check_constant(const NetcdfFile& file, const std::string& name, double expected) {
  const auto array = file.numbers(name);
  if (array && array->values.size() == 1 && std::abs(array->values[0] / expected - 1.0) > 1e-3) {
    throw HullFileError(name + " = " + format_number(array->values[0]),
                        "that of the model, " + format_number(expected));
  }
}

/// Returns a variable that holds a single number.
std::optional<double> single(const NetcdfFile& file, const std::string& name) {
  const auto array = file.numbers(name);
  return array && array->values.size() == 1 ? std::optional(array->values[0]) : std::nullopt;
}

/// Returns a variable that holds three finite numbers, as a point [m].
std::optional<Vec3> point(const NetcdfFile& file, const std::string& name) {
  const auto array = file.numbers(name);
  if (!array || array->values.size() != 3) return std::nullopt;
  const Vec3 p(array->values[0], array->values[1], array->values[2]);
  return p.allFinite() ? std::optional(p) : std::nullopt;
}

class CapytaineReader {
 public:
  CapytaineReader(const HydrodynamicsSource& source, Diagnostics& diagnostics)
      : source_(source),
        diagnostics_(diagnostics),
        file_(source.path),
        omega_(require_numbers(file_, "omega").values),
        radiating_(read_modes(file_, "radiating_dof")),
        influenced_(read_modes(file_, "influenced_dof")) {}

  HydrodynamicData read() {
    check_constant(file_, "rho", source_.water_density);
    check_constant(file_, "g", source_.gravity);
    data_.source = source_.path;
    data_.origin_V = source_.origin_V;
    data_.water_density = source_.water_density;
    data_.gravity = source_.gravity;
    read_statements();
    read_radiation();
    read_excitation();
    const bool stiffness = file_.has("hydrostatic_stiffness");
    if (stiffness) read_hydrostatics();
    check_same_frequencies(data_, source_.path, source_.path, diagnostics_);
    complete_hull(data_, statements_, source_, diagnostics_);
    if (!stiffness) use_stated_stiffness(data_, source_);
    return std::move(data_);
  }

 private:
  /// Checks the forward speed, and collects the statements about the hull.
  void read_statements() {
    if (const auto speed = single(file_, "forward_speed"); speed && std::abs(*speed) > 1e-6) {
      throw HullFileError("forward_speed = " + format_number(*speed) + " m/s", "a hull without forward speed");
    }
    statements_.water_depth = single(file_, "water_depth");
    statements_.mass = mass();
    const auto rotation = point(file_, "rotation_center"), centre = point(file_, "center_of_mass");
    if (centre) {
      statements_.centre_of_gravity = source_.file_origin + *centre;
      statements_.centre_in_file =
          "center_of_mass " + point_text(*centre) + (rotation ? " and rotation_center " + point_text(*rotation) : "");
    }
    if (rotation) {
      statements_.reference = source_.file_origin + *rotation;
      statements_.wave_origin = source_.file_origin;
    } else if (stated_reference(source_)) {
      statements_.wave_origin = source_.file_origin;
    }
  }

  std::optional<double> mass() const {
    const auto heave = std::find(influenced_.begin(), influenced_.end(), 2);
    const auto radiating = std::find(radiating_.begin(), radiating_.end(), 2);
    if (heave == influenced_.end() || radiating == radiating_.end() || !file_.numbers("inertia_matrix")) {
      return std::nullopt;
    }
    const Variable inertia = variable(file_, "inertia_matrix", {"influenced_dof", "radiating_dof"});
    const double mass = inertia.at({static_cast<std::size_t>(heave - influenced_.begin()),
                                    static_cast<std::size_t>(radiating - radiating_.begin())});
    return std::isfinite(mass) && mass > 0.0 ? std::optional(mass) : std::nullopt;
  }

  void read_radiation() {
    const std::vector<std::string> dimensions = {"omega", "radiating_dof", "influenced_dof"};
    const Variable mass = variable(file_, "added_mass", dimensions);
    const Variable damping = variable(file_, "radiation_damping", dimensions);
    for (std::size_t k = 0; k < omega_.size(); ++k) {
      RadiationPoint point;
      point.omega = omega_[k];
      for (std::size_t i = 0; i < influenced_.size(); ++i) {
        for (std::size_t j = 0; j < radiating_.size(); ++j) {
          point.added_mass(influenced_[i], radiating_[j]) = mass.at({k, j, i});
          point.damping(influenced_[i], radiating_[j]) = damping.at({k, j, i});
        }
      }
      sort_in(point);
    }
    if (data_.radiation.size() < 4) {
      throw HullFileError(std::to_string(data_.radiation.size()) + " finite frequencies", "four or more");
    }
    std::sort(data_.radiation.begin(), data_.radiation.end(),
              [](const RadiationPoint& a, const RadiationPoint& b) { return a.omega < b.omega; });
    for (std::size_t k = 1; k < data_.radiation.size(); ++k) {
      const double before = data_.radiation[k - 1].omega, omega = data_.radiation[k].omega;
      if (omega - before < 1e-5 * omega) {
        throw HullFileError("omega " + format_number(omega, 9) + " twice", "each frequency once");
      }
    }
  }

  void sort_in(const RadiationPoint& point) {
    if (std::isinf(point.omega)) {
      data_.has_infinite = true;
      data_.added_mass_infinite = point.added_mass;
    } else if (point.omega == 0.0) {
      data_.has_zero = true;
      data_.added_mass_zero = point.added_mass;
    } else if (point.omega > 0.0 && point.added_mass.allFinite() && point.damping.allFinite()) {
      data_.radiation.push_back(point);
    } else if (point.omega < 0.0) {
      throw HullFileError("omega " + format_number(point.omega), "frequencies of 0 or more");
    } else {
      throw HullFileError("added mass or damping that is not finite at omega " + format_number(point.omega),
                          "finite numbers");
    }
  }

  /// Reads the wave excitation. The dimension "complex" holds real and imaginary parts; zero and infinite frequency are
  /// skipped.
  void read_excitation() {
    const std::vector<std::string> dimensions = {"complex", "omega", "wave_direction", "influenced_dof"};
    const std::vector<double> headings = require_numbers(file_, "wave_direction").values;
    std::vector<Variable> parts;
    if (file_.numbers("diffraction_force")) {
      parts.push_back(variable(file_, "diffraction_force", dimensions));
      parts.push_back(variable(file_, "Froude_Krylov_force", dimensions));
    } else {
      parts.push_back(variable(file_, "excitation_force", dimensions));
    }
    HeadingTableBuilder values;
    for (std::size_t k = 0; k < omega_.size(); ++k) {
      if (!(omega_[k] > 0.0) || std::isinf(omega_[k])) {
        continue;
      }
      for (std::size_t b = 0; b < headings.size(); ++b) {
        for (std::size_t i = 0; i < influenced_.size(); ++i) {
          std::complex<double> force;
          for (const Variable& part : parts) {
            force += std::complex<double>(part.at({0, k, b, i}), -part.at({1, k, b, i}));
          }
          if (!std::isfinite(force.real()) || !std::isfinite(force.imag())) {
            throw HullFileError("an excitation that is not finite at omega " + format_number(omega_[k]),
                                "finite numbers");
          }
          values.add(omega_[k], headings[b], influenced_[i], force);
        }
      }
    }
    std::string error;
    auto built = values.build(source_.mirror_headings, error);
    if (!built) {
      throw HullFileError(error, "one value for every pair of frequency and heading");
    }
    data_.excitation = std::move(built->table);
    data_.force = std::move(built->values);
  }

  void read_hydrostatics() {
    const Variable stiffness = variable(file_, "hydrostatic_stiffness", {"influenced_dof", "radiating_dof"});
    for (std::size_t i = 0; i < influenced_.size(); ++i) {
      for (std::size_t j = 0; j < radiating_.size(); ++j) {
        data_.hydrostatic_stiffness(influenced_[i], radiating_[j]) = stiffness.at({i, j});
      }
    }
    if (!data_.hydrostatic_stiffness.allFinite()) {
      throw HullFileError("a stiffness that is not finite", "finite numbers");
    }
  }

  const HydrodynamicsSource& source_;
  Diagnostics& diagnostics_;
  NetcdfFile file_;
  std::vector<double> omega_;
  std::vector<int> radiating_, influenced_;
  HullStatements statements_;
  HydrodynamicData data_;
};

}  // namespace

std::optional<HydrodynamicData> read_capytaine(const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  try {
    return CapytaineReader(source, diagnostics).read();
  } catch (const HullFileError& error) {
    add_error(error, source.path, diagnostics);
  } catch (const std::runtime_error& error) {
    add_error(HullFileError(error.what(), "a netCDF file from Capytaine"), source.path, diagnostics);
  }
  return std::nullopt;
}

}  // namespace overbend
