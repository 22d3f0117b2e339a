/// Settings of mesh, statics and dynamic analysis.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace overbend {

/// Treatment of impacts on rollers in time-domain simulation.
enum class ImpactTreatment {
  resolved,  ///< Steps are a fraction of the contact time.
  captured,  ///< Impacts are handled within the current steps; for screening.
};

enum class StaticMethod { newton, dynamic_relaxation };

/// Loading history of a yielding pipe in statics: `laying` passes every section over the supports from the tensioner,
/// `monotonic` bends it once, directly to its final shape.
enum class LayHistory { laying, monotonic };

/// Origin of the pipe's position on the seabed in statics.
enum class SeabedLayHistory {
  steady,           ///< In equilibrium on the line on which it was laid; it does not slide back.
  pulled_sideways,  ///< First straight along its route, then pulled sideways.
};

/// Friction of the rollers in statics.
enum class RollerFriction {
  none,  ///< Rollers turn freely, and the pipe slides along them.
  lay,   ///< Full friction, opposing the pipe as it is paid out.
  haul,  ///< Full friction, opposing the pipe as it is hauled in.
};

struct MeshDescription {
  std::optional<double> overbend_element;    ///< Element length over the supports [m]; mesh rule if not given.
  std::optional<double> touchdown_element;   ///< Element length around touchdown [m].
  std::optional<double> max_element_length;  ///< Maximum element length [m].
  bool operator==(const MeshDescription&) const = default;
};

struct StaticSettings {
  StaticMethod method = StaticMethod::newton;
  LayHistory history = LayHistory::laying;
  SeabedLayHistory laying = SeabedLayHistory::steady;
  RollerFriction roller_friction = RollerFriction::none;
  double tolerance = 1e-9;  ///< Max. unbalanced nodal force divided by the total weight [-].
  int max_iterations = 60;  ///< Max. iterations per load step.
  /// Applies the mean wave drift to a floating hull in equilibrium. If not given, only in the equilibrium from which a
  /// dynamic analysis starts.
  std::optional<bool> mean_drift;
};

/// Accepted simulated duration; the maximum is about four months [s].
inline constexpr double kMinDuration = 1e-3, kMaxDuration = 1e7;
/// Maximum seed: integers up to this value are exact in a double.
inline constexpr std::uint64_t kMaxSeed = 9'000'000'000'000'000;

struct DynamicSettings {
  double duration = 0.0;           ///< Simulated time from t = 0 [s].
  double build_up = 60.0;          ///< Ramp of the waves before t = 0 [s].
  std::optional<double> step;      ///< Fixed step [s].
  std::optional<double> max_step;  ///< Maximum step of the adaptive integrator [s].
  double spectral_radius = 0.6;
  double output_step = 0.5;  ///< [s]
  std::vector<std::uint64_t> seeds;
  ImpactTreatment impacts = ImpactTreatment::resolved;
  double impact_steps = 16.0;          ///< Steps in the undamped contact time of an impact.
  std::optional<double> impact_force;  ///< Impacts weaker than this are neither resolved nor recorded [N].
  double tolerance = 1e-6;             ///< Max. unbalanced nodal force divided by the weight of the line [-].
  std::optional<double> step_error;    ///< Position error of a node per adaptive step [m].
};

}  // namespace overbend
