/// A rigid body that carries rollers.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/contact_cells.h"
#include "mechanics/contact_law.h"
#include "model/model.h"
#include "system/free_body.h"

namespace overbend {

/// A roller in the frame of its body with its law.
struct BodyRoller {
  Vec3 center_V = Vec3::Zero(), axis_V = Vec3::UnitY(), normal_V = Vec3::UnitZ();
  double half_face = 0.0, radius = 0.0;  ///< [m]
  int box = 0;                           ///< Index in the body's cells.
  RollerPosition position = RollerPosition::bottom;
  double mass = 0.0;  ///< Mass of the pipe moved by the contact [kg].
  ContactLaw law;
};

/// The vessel with ramp and stinger, with prescribed motion or floating, or another body.
struct Body {
  std::vector<BodyRoller> rollers;
  ContactCells cells;                 ///< In the ramp's frame.
  Vec3 ramp_origin_V = Vec3::Zero();  ///< Origin of the ramp's frame, with x astern, z up [m].
  std::optional<FreeBody> free;       ///< If its motion follows from the loads on it.
};

}  // namespace overbend
