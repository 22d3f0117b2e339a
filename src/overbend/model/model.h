/// Model: all data of the analyses, in SI and resolved frames. Built once, const from then on, free to share.  World
/// frame W: x east, y north, z up, z = 0 mean water level, origin under midship in the vessel's mean position.
#pragma once

#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/vec.h"
#include "model/description/description.h"
#include "model/pipe/contact_stiffness.h"
#include "model/pipe/section.h"
#include "model/site/seabed_surface.h"
#include "model/vessel/supports.h"

namespace overbend {

/// Pose of the vessel: origin and axes of V (x forward, y port, z up) in W.
struct VesselPose {
  Vec3 p_WV = Vec3::Zero();
  Mat3 R_WV = Mat3::Identity();
};

struct Seabed {
  SeabedSurface surface;
  double stiffness = 0.0;  ///< [N/m2]
  double friction_axial = 0.0, friction_lateral = 0.0;
};

/// Current as a vector over z, linear between rows, constant beyond the ends of the table. Rows by increasing z.
struct CurrentProfile {
  std::vector<double> z;
  std::vector<double> vx, vy;  ///< World components [m/s].
};

/// Span of the line with one section.
struct SectionSpan {
  double from = 0.0, to = 0.0;  ///< Unstressed length from the tensioner [m].
  int section = 0;
};

struct Model {
  Model();  // Defined in one source file to limit code size.
  Model(const Model&);
  Model(Model&&) noexcept;
  Model& operator=(const Model&);
  Model& operator=(Model&&) noexcept;
  ~Model();

  Description description;
  /// [0] main section, then segments, coated pipe between joints and in-line structures. Without a pipe empty, as are
  /// the supports.
  std::vector<Section> sections;
  /// Description from which each section was made; for a cable that of the pipe.
  std::vector<SectionDescription> described;
  std::vector<SectionSpan> spans;  ///< By distance from the tensioner; section 0 elsewhere.
  int coated = 0;  ///< Section of the coated pipe between field joints; 0 if these are not modelled separately.
  Supports supports;
  VesselPose mean_pose;     ///< Position and attitude of the vessel in the analysis.
  VesselPose nominal_pose;  ///< Nominal pose as described; the lay route runs astern from it.
  Seabed seabed;
  CurrentProfile current;
  double water_weight_density = 0.0;  ///< [N/m3]
  double water_density = 0.0;         ///< [kg/m3]

  int section_at(double distance_from_top) const;
  /// Returns the pipe section over a roller in the laid configuration.
  const Section& section_over(const Roller& roller) const;
  /// Main section of the pipe, used outside the segments.
  const Section& pipe_section() const { return sections.front(); }
  /// As section_over(), but skips a cable: rollers are sized for the pipe.
  const Section& pipe_over(const Roller& roller) const;
  /// Returns the parts of the contact stiffness of a roller without a given stiffness.
  ContactStiffness contact_parts(const Roller& roller) const;
  /// Returns the description of a section; for coated pipe between field joints that of the main section.
  const SectionDescription& find_section_description(std::size_t section) const;
  /// Returns the kind of the section at `distance_from_top` from the tensioner [m].
  SectionKind kind_at(double distance_from_top) const;
};

/// Resolves frames and computes derived properties. The reader has validated the description.
Model build_model(const Description& description);

/// Updates the moment-curvature laws for the tension found at the tensioner [N], if no tension is given and the laws
/// depend on it. Returns true if the tension differs from the one used before.
bool update_moment_curvature(Model& model, double tension);

/// Transforms a point or a direction from the ramp/stinger frame S to W.
Vec3 point_from_ramp(const Model& model, const VesselPose& pose, const Vec3& p_S);
Vec3 direction_from_ramp(const VesselPose& pose, const Vec3& d_S);

/// Returns the axes of the vessel for a heading (azimuth), trim (bow up) and heel (starboard down) [rad].
Mat3 vessel_axes(double heading, double trim, double heel);

/// Horizontal unit vector pointing astern.
Vec3 astern_direction(const VesselPose& pose);

/// Returns the assumptions of the model as sentences for the report.
Assumptions assumptions(const Model& model);

}  // namespace overbend
