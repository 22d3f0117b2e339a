/// Settings of mesh, statics and dynamic analysis.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace overbend {

/// How impacts on rollers are followed in time.
enum class ImpactTreatment {
  resolved,  ///< By steps that are a fraction of the contact time.
  captured,  ///< Within the steps that there are, for screening.
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

}  // namespace overbend
