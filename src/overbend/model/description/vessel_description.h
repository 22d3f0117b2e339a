/// Vessel as given in the model file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "model/description/hull_description.h"
#include "model/description/motion_history.h"
#include "model/waves/rao_table.h"

namespace overbend {

enum class VesselMotion { fixed, raos, harmonic, history, coupled };

struct HarmonicMotion {
  double amplitude = 0.0;  ///< [m] or [rad]
  double period = 0.0;     ///< [s]
  double phase = 0.0;      ///< [rad]
};

struct VesselDescription {
  std::string name = "barge";
  double length = 120.0;      ///< [m]
  double beam = 30.0;         ///< [m]
  double depth = 9.0;         ///< Keel to deck [m].
  double draught = 5.0;       ///< [m]
  double heading = 0.0;       ///< Azimuth of the bow [rad].
  double trim = 0.0;          ///< Static trim, bow up positive, about midship at the water line [rad].
  double heel = 0.0;          ///< Static heel, starboard down positive, same point [rad].
  double stern_shoe_x = 0.0;  ///< Frame V [m].
  double stern_shoe_z = 0.0;  ///< Frame V, above the water [m].
  VesselMotion motion = VesselMotion::fixed;
  std::string motion_file;  ///< File for raos, history, coupled; resolved against the model file's folder.
  std::map<std::string, HarmonicMotion> harmonic;  ///< By degree of freedom: surge, sway, heave, roll, pitch, yaw.
  Vec3 motion_reference_V = Vec3::Zero();          ///< Reference point of harmonic and recorded motion, frame V [m].
  std::optional<RaoTable> raos;                    ///< Contents of the motion file; empty if it is not read.
  std::optional<MotionHistory> history;            ///< Contents of the motion file; empty if it is not read.
  std::optional<CoupledHullDescription> coupled;   ///< Floating hull.
  std::optional<HydrostaticsDescription> hydrostatics;
  std::vector<VesselLoadDescription> loads;
};

}  // namespace overbend
