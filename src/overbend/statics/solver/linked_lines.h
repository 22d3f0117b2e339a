/// Lines that hold each other: ends on other lines, free ends, wires without weight. They rest together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statics/solver/lines_setup.h"
#include "statics/solver/statics.h"

namespace overbend {

/// What the lines and the vessel are brought to, by the lines of the model.
struct LiftPosition {
  std::vector<double> lengths;                  ///< Unstressed [m].
  std::vector<std::optional<double>> tensions;  ///< At the upper end, in place of a length [N].
  VesselOffset vessel;
  std::vector<VesselOffset> bodies;    ///< Of the other bodies of the model, in their order.
  std::vector<JoinDescription> joins;  ///< In the order in which they are made.
  double closed = 1.0;                 ///< Share of the gap of the last of them that is closed.
};

/// A vessel away from its place, along its axes as it lies; a heading turns clockwise.
VesselPose moved_pose(const VesselPose& pose, const VesselOffset& offset);

/// See lines_setup().
LinesSetup linked_lines_setup(const Model& model);

/// Linked lines at rest with what is welded, brought from position to position. Friction of the bed goes with the way.
class LinkedLines {
 public:
  /// Pipe on the bed, wires slack. `model` must outlive this.
  explicit LinkedLines(const Model& model);
  /// Goes on from the same position by itself.
  LinkedLines(const LinkedLines& other);
  LinkedLines& operator=(const LinkedLines&) = delete;

  /// Brings all to a position, in as many parts of the way as the equations ask for. Where a position cannot be
  /// reached all stays where it was. Lengths found of tensions stay: see position().
  std::optional<StaticFailure> bring_to(const LiftPosition& target);

  const LiftPosition& position() const { return position_; }
  const LinesSetup& setup() const { return setup_; }
  const SystemState& state() const { return state_; }
  /// Stands evaluated at the state.
  const Assembly& assembly() const { return *assembly_; }
  double residual() const { return residual_; }
  int iterations() const { return iterations_; }
  /// What a run in time starts from.
  LinesAtRest at_rest() const;

 private:
  /// Two first ends held by a point of their own: the second's place and direction in its frame as they were before.
  struct Weld {
    std::size_t attachment = 0;
    Vec3 place = Vec3::Zero(), direction = Vec3::UnitX();
    double kink = 0.0;
  };

  void weld(const JoinDescription& join);
  void part();
  void put(const LiftPosition& position);
  bool rest(const SystemState& laid);
  void evaluate();
  LiftPosition between(const LiftPosition& target, double share) const;
  std::optional<StaticFailure> travel(const LiftPosition& target);
  double upper_tension(std::size_t line) const;
  bool haul_to_tensions(const LiftPosition& target);
  std::optional<StaticFailure> overstretched() const;
  void find_lengths();
  std::optional<StaticFailure> let_float();

  const Model* model_;
  LinesSetup setup_;
  std::optional<Assembly> assembly_;
  SystemState state_;
  LiftPosition position_;
  std::vector<Weld> welds_;
  bool afloat_ = false;  ///< A vessel that floats free has been let go.
  double residual_ = 0.0;
  int iterations_ = 0;
};

/// Of the vessel, where it does not float free, and of the other bodies, as body_poses() has them.
std::vector<VesselPose> poses_at(const Model& model, const LiftPosition& position);

/// The position that a model has as drawn.
LiftPosition drawn_position(const Description& description);

/// What a stage of a lift asks for, from where the lines are: what it does not name stays.
LiftPosition stage_position(const Description& description, const LayStageDescription& stage, LiftPosition from);

}  // namespace overbend
