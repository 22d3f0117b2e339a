/// Description of the lay: the content of the model file in SI units, before frames, mesh and derived properties.
///
/// Units are m, kg, s, N, Pa, rad. Azimuths stay as on a chart: clockwise from north, in rad. Vessel positions are in
/// the vessel frame V (origin midship on the water, x forward, y port, z up); ramp, stinger and tensioner in the frame
/// S (origin on the stern shoe, X astern, Z up). A member without a value in the file carries the default written here;
/// `std::optional` is used only where "not given" has a meaning of its own.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"
#include "base/vec.h"
#include "model/description/check_settings.h"
#include "model/description/fatigue_description.h"
#include "model/description/hull_description.h"
#include "model/description/lay_table_description.h"
#include "model/description/line_description.h"
#include "model/description/mooring_description.h"
#include "model/description/motion_history.h"
#include "model/description/route_description.h"
#include "model/description/seabed_description.h"
#include "model/description/section_description.h"
#include "model/description/stinger_description.h"
#include "model/description/structure_description.h"
#include "model/waves/rao_table.h"

namespace overbend {

/// A stretch of line with a section of its own, counted from the tensioner astern.
struct SegmentDescription {
  std::string name;
  double length = 0.0;  ///< Unstressed length [m].
  SectionDescription section;
};

struct PipeDescription {
  SectionDescription section;                    ///< Of the line where no segment says otherwise.
  std::vector<SegmentDescription> segments;      ///< From the tensioner astern; the rest has `section`.
  std::vector<StructureDescription> structures;  ///< Built in, over segments and all.
  std::optional<double> length;                  ///< Unstressed length from tensioner to anchor [m].
  std::optional<double> anchor;                  ///< Horizontal distance of the anchor astern of the stern shoe [m].
};

struct CurrentPoint {
  double depth = 0.0;    ///< Below the mean water level [m].
  double speed = 0.0;    ///< [m/s]
  double towards = 0.0;  ///< Azimuth the current goes to [rad].
};

enum class WaveType { none, airy, stokes5, jonswap, pierson_moskowitz, user };

/// A row of a user's wave spectrum, one-sided.
struct SpectrumPoint {
  double omega = 0.0;    ///< [rad/s]
  double density = 0.0;  ///< S(omega) [m2 s]
};

struct WavesDescription {
  WaveType type = WaveType::none;
  double hs = 0.0;                  ///< Significant wave height [m].
  double tp = 0.0;                  ///< Peak period [s].
  double height = 0.0;              ///< Of a regular wave, crest to trough [m].
  double period = 0.0;              ///< Of a regular wave [s].
  double phase = 0.0;               ///< Of a regular wave: a crest passes the origin at t = phase/omega [rad].
  double from = 0.0;                ///< Azimuth the waves come from [rad].
  std::optional<double> gamma;      ///< JONSWAP peak enhancement; DNV-RP-C205 rule where not given.
  std::optional<double> spreading;  ///< Exponent s of cos^2s directional spreading; long-crested where not given.
  int components = 200;
  std::uint64_t seed = 1;
  std::string spectrum_file;            ///< For `user`: CSV of frequency and spectral density.
  std::vector<SpectrumPoint> spectrum;  ///< Its points, by increasing frequency; empty when it could not be read.
};

struct EnvironmentDescription {
  double water_depth = 0.0;               ///< At the stern shoe [m].
  double water_weight_density = 10.05e3;  ///< [N/m3]
  SeabedDescription seabed;
  std::vector<CurrentPoint> current;  ///< By increasing depth.
  WavesDescription waves;
};

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
  std::string motion_file;  ///< For raos, history, coupled; resolved against the model file's folder.
  std::map<std::string, HarmonicMotion> harmonic;  ///< By degree of freedom: surge, sway, heave, roll, pitch, yaw.
  Vec3 motion_reference_V = Vec3::Zero();          ///< Point that harmonic and recorded motion are of, frame V [m].
  std::optional<RaoTable> raos;                    ///< Contents of the motion file, when it is there to be read.
  std::optional<MotionHistory> history;            ///< Likewise.
  std::optional<CoupledHullDescription> coupled;   ///< The hull that floats free.
  std::optional<HydrostaticsDescription> hydrostatics;
  std::vector<VesselLoadDescription> loads;
};

enum class Guide { clamped, pinned };
enum class TensionerMode { controlled, locked, constant };

struct TensionerDescription {
  double x = 0.0;        ///< Frame S, pipe axis [m].
  double z = 0.0;        ///< Frame S, pipe axis [m].
  double incline = 0.0;  ///< Of the pipe at the tensioner, positive when it dips astern [rad].
  Guide guide = Guide::clamped;
  std::optional<double> tension;     ///< Wanted effective tension [N].
  std::optional<double> range_low;   ///< Operational range [N].
  std::optional<double> range_high;  ///< Operational range [N].
  TensionerMode mode = TensionerMode::locked;
  bool mode_assumed = false;           ///< The model gives neither mode nor range.
  double delay = 0.0;                  ///< Response delay [s].
  double velocity = 0.0;               ///< Response velocity [m/s].
  std::optional<double> acceleration;  ///< Response acceleration [m/s2].
  std::optional<double> travel;        ///< Displacement limit either way [m].
  double found = 0.0;  ///< Where no tension is wanted: the last one found, see bend_under(); no key [N].
};

struct BottomRollerDescription {
  double radius = 0.0;  ///< [m]
  double face = 0.0;    ///< Length of the roller [m].
};

struct SideRollerDescription {
  double radius = 0.0;     ///< [m]
  double face = 0.0;       ///< Length of the roller [m].
  double angle = 0.0;      ///< Of the roller's axis from horizontal [rad].
  double clearance = 0.0;  ///< Gap to a pipe centred on the bottom roller [m].
};

/// How impacts on rollers are followed in time.
enum class ImpactTreatment {
  resolved,  ///< By steps that are a fraction of the contact time.
  captured,  ///< Within the steps that there are, for screening.
};

/// How the damping of a roller follows from its coefficient of restitution.
enum class RollerDamping {
  clipped,   ///< For a contact that never pulls, as the program's do: rebounds have the coefficient given.
  textbook,  ///< -ln e / sqrt(pi^2 + ln^2 e), for comparison with programs that take it.
};

/// Stiffness used for a roller that gives none.
enum class RollerStiffness {
  physical,  ///< Springs in series of pipe shell, coating and roller structure.
  penalty,   ///< EI/D^3 of the pipe: as good as rigid in statics.
};

/// A kind of roller row, used by name in the supports.
struct RollerKindDescription {
  std::string name;
  BottomRollerDescription bottom;
  std::optional<SideRollerDescription> sides;
  std::optional<double> stiffness;  ///< Of the contact as a whole [N/m]; where not given, as default_stiffness says.
  double friction_axial = 0.0;
  double friction_lateral = 0.0;
  double restitution = 0.5;
  RollerDamping damping = RollerDamping::clipped;
  /// Of sticking friction [N/m]; a tenth of the normal one if not given.
  std::optional<double> tangential_stiffness = {};
  RollerStiffness default_stiffness = RollerStiffness::physical;
  std::optional<double> structure_stiffness = {};  ///< Of roller, bearings and box [N/m]; kRollerStructure if absent.
};

enum class Structure { ramp, stinger };

struct BoxDescription {
  std::string name;
  Structure structure = Structure::ramp;
  double x = 0.0;       ///< Frame S: where the underside of the coated pipe rests, mid-box [m].
  double z = 0.0;       ///< Frame S [m].
  double offset = 0.0;  ///< Raises the box along the outward normal of the support curve [m].
  double length = 0.0;  ///< Along the pipe [m].
  std::optional<double>
      incline;         ///< Of the box axis, positive when it dips astern [rad]; tangent of the curve if not given.
  std::string roller;  ///< Name of a roller kind.
  int rows = 1;
  int section = 0;  ///< Of a stinger on hinges: which of its sections carries the box.
};

/// Model of the supports: their rollers, or one gap spring for each box.
enum class SupportContact { rollers, gap_springs };

struct SupportsDescription {
  SupportContact contact = SupportContact::rollers;
  std::optional<double> ramp_radius;     ///< Of the arc that ramp_row stands on; none beside listed boxes [m].
  std::optional<double> stinger_radius;  ///< [m]
  std::vector<BoxDescription> boxes;     ///< From the tensioner astern: ramp boxes first, then the stinger's.
  std::optional<BoxRowDescription> ramp_row, stinger_row;  ///< Boxes told as a row; those in `boxes` are made from it.
  std::vector<StingerSectionDescription> sections;  ///< On hinges, from the barge astern; empty: a fixed stinger.
  std::vector<StingerSettingDescription> settings;  ///< Of the angles of the sections.
  std::string setting;                              ///< The one chosen; empty: none.
};

enum class StaticMethod { newton, dynamic_relaxation };

/// Loading history of a yielding pipe in statics: it came over the supports from the tensioner, or it
/// was bent to its shape once and only there.
enum class LayHistory { laying, monotonic };

/// How the pipe on the bed came to lie there, in statics.
enum class Laying {
  steady,         ///< At rest on the line on which it was laid: it does not slide back.
  pulled_across,  ///< Straight along its route first, then pulled sideways.
};

/// Friction of the rollers in statics.
enum class RollerFriction {
  none,  ///< Rollers turn freely, and the pipe slides along them.
  lay,   ///< Full, against the pipe's way as it is paid out.
  haul,  ///< Full, against its way as it is hauled in.
};

struct MeshDescription {
  std::optional<double> overbend_element;   ///< Element length over the supports [m]; rule of the mesh if not given.
  std::optional<double> touchdown_element;  ///< Element length around touchdown [m].
  std::optional<double> longest_element;    ///< [m]
  bool operator==(const MeshDescription&) const = default;
};

struct StaticSettings {
  StaticMethod method = StaticMethod::newton;
  LayHistory history = LayHistory::laying;
  Laying laying = Laying::steady;
  RollerFriction roller_friction = RollerFriction::none;
  double tolerance = 1e-9;  ///< Largest unbalanced nodal force over the total weight.
  int max_iterations = 60;  ///< Of one stage.
  /// Whether the waves' mean drift acts on a floating hull at rest; not said: only in the equilibrium that a dynamic
  /// analysis starts from.
  std::optional<bool> mean_drift;
};

/// Simulated time of a run that can be meant: the longest is four months [s].
inline constexpr double kMinDuration = 1e-3, kMaxDuration = 1e7;
/// Seeds are whole numbers that a double holds exactly.
inline constexpr std::uint64_t kMaxSeed = 9'000'000'000'000'000;

struct DynamicSettings {
  double duration = 0.0;           ///< [s]
  double build_up = 60.0;          ///< [s]
  std::optional<double> step;      ///< Fixed step [s].
  std::optional<double> max_step;  ///< [s]
  double spectral_radius = 0.6;
  double output_step = 0.5;  ///< [s]
  std::vector<std::uint64_t> seeds;
  ImpactTreatment impacts = ImpactTreatment::resolved;
  double impact_steps = 16.0;          ///< Steps in the undamped contact time of an impact.
  std::optional<double> impact_force;  ///< Impacts weaker than this are neither resolved nor recorded [N].
  double tolerance = 1e-6;             ///< Largest unbalanced nodal force over the line's weight.
  std::optional<double> step_error;    ///< Of a node's place in one step, where the step is free [m].
};

/// Document control: what the head of the report says of itself. Plain words of the user, empty where not given.
struct ReportDescription {
  std::string client, project, document, revision, prepared, checked;
};

/// The whole model file.
struct Description {
  Description();  // These six are compiled once: a copy of all members is long, and many sources make one.
  Description(const Description&);
  Description(Description&&) noexcept;
  Description& operator=(const Description&);
  Description& operator=(Description&&) noexcept;
  ~Description();

  std::string title;
  ReportDescription report;
  std::string source_file;  ///< Path as given by the user.
  std::string source_text;  ///< The file's text, echoed into the results.
  EnvironmentDescription environment;
  bool has_pipe =
      true;  ///< False: hull and moorings, or lines, by themselves; pipe, tensioner and supports say nothing.
  PipeDescription pipe;
  VesselDescription vessel;
  TensionerDescription tensioner;
  std::vector<RollerKindDescription> rollers;
  SupportsDescription supports;
  RouteDescription route;  ///< On which the pipe is laid.
  MeshDescription mesh;
  StaticSettings statics;
  std::optional<DynamicSettings> dynamics;
  CheckSettings checks;
  std::optional<FatigueDescription> fatigue;
  std::optional<MooringsDescription> moorings;
  std::vector<FreeLineDescription> lines;  ///< Besides the pipe, or alone.
  std::optional<StationKeepingDescription> station_keeping;
  OperationDescription operation;
  std::optional<LayTableDescription> lay_table;
  /// The stage of an operation on the line that this is, see model/lay_stage.h; none: the line as laid.
  std::optional<LayStageDescription> stage;
  Findings findings;  ///< Unusual input that was accepted.
};

}  // namespace overbend
