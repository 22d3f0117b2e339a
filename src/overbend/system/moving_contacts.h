/// Contact of a moving line with rollers that move with the vessel.
#pragma once

#include <vector>

#include "mechanics/contact_cells.h"
#include "mechanics/contact_law.h"
#include "mechanics/line_elements.h"
#include "mechanics/roller_contact.h"
#include "mechanics/vessel_motion.h"
#include "model/model.h"
#include "numerics/block_tridiagonal.h"

namespace overbend {

/// What a contact remembers from step to step.
struct ContactMemory {
  double slip_axial = 0.0, slip_lateral = 0.0;  ///< Elastic part of the slip since contact began [m].
  bool carries = false;                         ///< Whether the contact carried.
  Slip axial = Slip::stick, lateral = Slip::stick;
  int element = 0;  ///< Where the closest point was: the search begins here.
  double xi = 0.5;
};

/// One roller as the line meets it at one instant.
struct MovingContact {
  ClosestPoint at;
  double penetration = -1.0;                        ///< Negative: the gap [m].
  double rate = 0.0;                                ///< Of penetration [m/s].
  double normal = 0.0, axial = 0.0, lateral = 0.0;  ///< Forces on the pipe along the directions below [N].
  Vec3 normal_direction = Vec3::Zero(), axial_direction = Vec3::Zero(), lateral_direction = Vec3::Zero();
  Vec3 roller_velocity = Vec3::Zero();                    ///< Of the roller where the pipe touches it [m/s].
  double slip_rate_axial = 0.0, slip_rate_lateral = 0.0;  ///< [m/s]

  Vec3 force() const { return normal * normal_direction + axial * axial_direction + lateral * lateral_direction; }
};

/// A roller in the frame of the vessel with its law.
struct MovingRoller {
  Vec3 center_V = Vec3::Zero(), axis_V = Vec3::UnitY(), normal_V = Vec3::UnitZ();
  double half_face = 0.0, radius = 0.0;  ///< [m]
  int box = 0;
  double mass = 0.0;  ///< Of the pipe that the contact moves [kg].
  ContactLaw law;
};

/// Shares of the integrator and the step, see LineMotion.
struct StepShares {
  double velocity = 0.0, acceleration = 0.0, step = 0.0;
};

/// Whether contacts open, close, stick and slide as they will, or stay as they were before the step. The first
/// iteration of a step keeps them: a predictor knows nothing of stiff springs, and would open contacts that carry.
enum class ContactMode { free, kept };

/// Where the forces of contacts are added: six per node, both as in LineTarget.
struct ContactTarget {
  std::vector<double>& residual;
  std::vector<double>& cuts;
};

class MovingContacts {
 public:
  MovingContacts() = default;
  /// `pipe_radius` and `length` by element; the vectors must outlive this.
  MovingContacts(std::vector<MovingRoller> rollers, ContactCells cells, const Vec3& shoe_V,
                 const std::vector<double>& length, const AlignedDoubles& pipe_radius);

  int count() const { return static_cast<int>(rollers_.size()); }
  const std::vector<MovingRoller>& rollers() const { return rollers_; }
  const std::vector<MovingContact>& contacts() const { return contacts_; }

  /// Moves the rollers with the vessel and looks, by the cells, which elements may meet which box. Elements are taken
  /// where `q` has them, grown by `reach` for what they may still move.
  void place(const RigidMotion& vessel, const double* q, double reach);

  /// Forces of all rollers that the line may meet, added to the line's. `before` is the memory at the start of the
  /// step, `after` receives that at its end.
  void evaluate(const double* q, const double* v, const StepShares& shares, const std::vector<ContactMemory>& before,
                std::vector<ContactMemory>& after, ContactMode mode, const ContactTarget& target);

  /// Adds how the forces of the last evaluation change with the unknowns `q` that it was given.
  void add_tangent(const double* q, const StepShares& shares, BlockTridiagonal& tangent) const;

  /// The first element that a roller may meet before the rollers are placed again; `beyond` where there is none.
  int first_within_reach(int beyond) const;
  /// The first element that met one at the last evaluation; `beyond` where none did.
  int first_carrying(int beyond) const;

  /// Tells which states the correction that now follows was made with: a contact that slid one way may not slide the
  /// other way at the next evaluation, it sticks in between.
  void end_iteration(const std::vector<ContactMemory>& now);

  /// Changes when a contact opens or closes, sticks or slides: the tangent is then another.
  std::uint64_t signature() const { return signature_; }
  /// False while a contact stands in a state that its law would not have it in: no equilibrium yet.
  bool settled() const { return settled_; }

 private:
  void evaluate_one(std::size_t roller, const double* q, const double* v, const StepShares& shares,
                    const ContactMemory& before, ContactMemory& after, ContactMode mode, const ContactTarget& target);
  void add_tangent_of(std::size_t roller, const double* q, const StepShares& shares, BlockTridiagonal& tangent) const;

  std::vector<MovingRoller> rollers_;
  ContactCells cells_;
  Vec3 shoe_V_ = Vec3::Zero();
  const std::vector<double>* length_ = nullptr;
  const AlignedDoubles* pipe_radius_ = nullptr;

  std::vector<PlacedRoller> placed_;
  std::vector<ElementBounds> bounds_;
  std::vector<ElementRange> ranges_;
  std::vector<MovingContact> contacts_;
  /// What the tangent needs of a contact.
  struct CarryingContact {
    bool carries = false;
    RollerDistance distance;
    NormalForce normal;
    FrictionForce axial, lateral;
  };
  std::vector<CarryingContact> carrying_;
  struct SlipStates {
    Slip axial = Slip::stick, lateral = Slip::stick;
  };
  std::vector<SlipStates> iterate_;
  RigidMotion vessel_;
  std::uint64_t signature_ = 0;
  bool settled_ = true;
};

}  // namespace overbend
