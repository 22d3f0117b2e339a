/// The model: everything the analyses need, in SI and resolved frames. Built once, const from then on, free to share.
///
/// World frame W: x east, y north, z up, z = 0 mean water level, origin under midship in the vessel's mean position.
#pragma once

#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/vec.h"
#include "model/description/description.h"
#include "model/pipe/contact_stiffness.h"
#include "model/pipe/section.h"
#include "model/site/bed_surface.h"
#include "model/vessel/supports.h"

namespace overbend {

/// Pose of the vessel: origin and axes of V (x forward, y port, z up) in W.
struct VesselPose {
  Vec3 p_WV = Vec3::Zero();
  Mat3 R_WV = Mat3::Identity();
};

struct Seabed {
  BedSurface surface;
  double stiffness = 0.0;  ///< [N/m2]
  double friction_axial = 0.0, friction_lateral = 0.0;
};

/// Current as a vector over z, linear in between, constant beyond the ends of the table. Rows by rising z.
struct CurrentProfile {
  std::vector<double> z;
  std::vector<double> vx, vy;  ///< World components [m/s].
};

/// Limits between the main section and segments: distances from the tensioner.
struct SectionSpan {
  double from = 0.0, to = 0.0;  ///< Unstressed length from the tensioner [m].
  int section = 0;
};

struct Model {
  Model();  // These six are compiled once: a copy of all members is long, and many sources make one.
  Model(const Model&);
  Model(Model&&) noexcept;
  Model& operator=(const Model&);
  Model& operator=(Model&&) noexcept;
  ~Model();

  Description description;
  /// [0] the line's own, then the segments', then the coated pipe between joints, then
  /// what is built in. None without a pipe, as supports.
  std::vector<Section> sections;
  std::vector<SectionDescription> described;  ///< What each of them was made from; of a cable, the pipe's.
  std::vector<SectionSpan> spans;             ///< By distance from the tensioner; the rest has section 0.
  int coated = 0;  ///< Section of the coated pipe between field joints; 0 where these are not told apart.
  Supports supports;
  VesselPose mean_pose;   ///< Where the vessel lies.
  VesselPose drawn_pose;  ///< As described: the lay route runs astern from there.
  Seabed seabed;
  CurrentProfile current;
  double water_weight_density = 0.0;  ///< [N/m3]
  double water_density = 0.0;         ///< [kg/m3]

  int section_at(double distance_from_top) const;
  /// The pipe that lies over a roller as it is laid.
  const Section& section_over(const Roller& roller) const;
  /// Of the pipe where no segment says otherwise.
  const Section& pipe_section() const { return sections.front(); }
  /// The same, but for a cable, which comes and goes over rollers that are made for the pipe.
  const Section& pipe_over(const Roller& roller) const;
  /// Stiffness of the contact with a roller that gives none, by its parts.
  ContactStiffness contact_parts(const Roller& roller) const;
  /// What a section was made from: coated pipe between field joints comes from the line's own.
  const SectionDescription& description_of(std::size_t section) const;
  /// Of the section `distance_from_top` from the tensioner [m].
  SectionKind kind_at(double distance_from_top) const;
};

/// Resolves frames and derives properties. The description has been validated by the reader.
Model build_model(const Description& description);

/// Where no tension is wanted and the moments of the steel hang on it: makes them anew for the tension found at the
/// tensioner [N]. Whether it is another than the one that they were made for.
bool bend_under(Model& model, double tension);

/// Turns a point or a direction of the ramp/stinger frame S into W.
Vec3 point_from_ramp(const Model& model, const VesselPose& pose, const Vec3& p_S);
Vec3 direction_from_ramp(const VesselPose& pose, const Vec3& d_S);

/// Axes of the vessel for a heading (azimuth), trim (bow up) and heel (starboard down) [rad].
Mat3 vessel_axes(double heading, double trim, double heel);

/// Horizontal unit vector pointing astern.
Vec3 astern_direction(const VesselPose& pose);

/// What had to be assumed: sentences for the report.
Assumptions assumptions(const Model& model);

}  // namespace overbend
