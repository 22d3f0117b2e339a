/// Lines attached to each other: ends on other lines, free ends, wires without weight. They are solved together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statics/solver/lines_setup.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Target position of lines and vessel, in the order of the lines of the model.
struct LiftPosition {
  std::vector<double> lengths;                  ///< Unstressed [m].
  std::vector<std::optional<double>> tensions;  ///< Tension at the upper end in place of a length [N].
  VesselOffset vessel;
  std::vector<VesselOffset> bodies;    ///< Offsets of the other bodies of the model, in their order.
  std::vector<JoinDescription> joins;  ///< In the order in which the joints are made.
  double closed = 1.0;                 ///< Closed share of the gap of the last joint.
};

/// Pose of a vessel displaced along its own axes; a positive heading turns clockwise.
VesselPose moved_pose(const VesselPose& pose, const VesselOffset& offset);

/// See lines_setup().
LinesSetup linked_lines_setup(const Model& model);

/// Linked lines with their welds in equilibrium, moved from position to position. Bed friction depends on the path.
class LinkedLines {
 public:
  /// Starts with pipe on the bed and slack wires. `model` must outlive this object.
  explicit LinkedLines(const Model& model);
  /// Independent copy at the same position.
  LinkedLines(const LinkedLines& source);
  LinkedLines& operator=(const LinkedLines&) = delete;

  /// Moves everything to a position, in as many increments as the equations require. If a position cannot be reached,
  /// the state is unchanged. Lengths found for given tensions are kept: see position().
  std::optional<StaticFailure> move_to(const LiftPosition& target);

  const LiftPosition& position() const { return position_; }
  const LinesSetup& setup() const { return setup_; }
  const SystemState& state() const { return state_; }
  /// Evaluated at the state.
  const Assembly& assembly() const { return *assembly_; }
  double residual() const { return residual_; }
  int iterations() const { return iterations_; }
  /// Initial state of a time-domain simulation.
  StaticLines make_static_lines() const;

 private:
  /// Two first ends held by a common point: initial position and direction of the second end in its frame.
  struct Weld {
    std::size_t attachment = 0;
    Vec3 place = Vec3::Zero(), direction = Vec3::UnitX();
    double kink = 0.0;
  };

  void weld(const JoinDescription& join);
  void undo_weld();
  void apply_position(const LiftPosition& position);
  bool rest(const SystemState& laid);
  void evaluate();
  LiftPosition between(const LiftPosition& target, double share) const;
  std::optional<StaticFailure> travel(const LiftPosition& target);
  double upper_tension(std::size_t line) const;
  bool find_lengths_for_tensions(const LiftPosition& target);
  std::optional<StaticFailure> find_overstretched_line() const;
  void end_tension_control();
  std::optional<StaticFailure> release_vessel_if_floating();

  const Model* model_;
  LinesSetup setup_;
  std::optional<Assembly> assembly_;
  SystemState state_;
  LiftPosition position_;
  std::vector<Weld> welds_;
  bool afloat_ = false;  ///< True if a free-floating vessel has been released.
  double residual_ = 0.0;
  int iterations_ = 0;
};

/// Poses of the vessel, if it does not float freely, and of the other bodies, as from body_poses().
std::vector<VesselPose> poses_at(const Model& model, const LiftPosition& position);

/// Nominal position of a model.
LiftPosition nominal_position(const Description& description);

/// Position required by a stage of a lift, starting from the present one: items that it does not name are unchanged.
LiftPosition stage_position(const Description& description, const LayStageDescription& stage, LiftPosition from);

}  // namespace overbend
