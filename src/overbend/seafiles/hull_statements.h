/// Last steps of every reader of hull data: comparison with the model, missing weight, change of reference point.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/hydrodynamic_data.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {

/// Statements of a file about its hull. Points are in frame V [m]; nothing where the file says nothing.
struct HullStatements {
  std::optional<double> water_depth;       ///< Infinite for deep water [m].
  std::optional<double> mass;              ///< [kg]
  std::optional<double> displaced_volume;  ///< [m3]
  std::optional<Vec3> centre_of_gravity;   ///< Point of the weight in the stiffness.
  std::string centre_in_file;              ///< The same in the words and axes of the file, for messages.
  std::optional<Vec3> reference;           ///< Point of added mass, damping, moments and stiffness.
  std::optional<Vec3> wave_origin;         ///< Phases refer to the crest at this point; default: `reference`.
  StiffnessContents stiffness = StiffnessContents::with_weight;  ///< Unless the user states another.
};

/// Compares water depth, mass, displacement and centre of gravity with the model (warnings; another centre of gravity
/// is an error if the stiffness contains the weight), adds the weight to a stiffness without it, and transfers
/// everything to data.origin_V. Conversions are added to data.notes. Throws HullFileError.
void complete_hull(HydrodynamicData& data, const HullStatements& statements, const HydrodynamicsSource& source,
                   Diagnostics& diagnostics);

/// Returns the water depth [m] of the wave numbers that turn phases: that of the model if known, otherwise of the file.
double phase_depth(const HydrodynamicsSource& source, const HullStatements& statements);

/// Returns a point as text: "(0, 0, 1.5) m".
std::string point_text(const Vec3& point);

/// Returns a value stated by the user in place of a default, or else that of the file. Throws HullFileError if both
/// differ by more than 0.1 %. `name` is the key below vessel.motion.coupled.convention.
double settled_constant(const char* name, double stated_by_user, double default_value, double stated_in_file);

/// Warns of frequencies with added mass but without wave forces in `data`: these are interpolated, and forces outside
/// the range of frequencies of the file are not known.
void check_same_frequencies(const HydrodynamicData& data, const std::string& file, const std::string& other_file,
                            Diagnostics& diagnostics);

/// Sets the stiffness stated by the user, for files without one; otherwise throws HullFileError with what is needed.
void use_stated_stiffness(HydrodynamicData& data, const HydrodynamicsSource& source);

}  // namespace overbend
