/// Contact of a line with the rollers of bodies, at rest and in motion: one search, one gap, one law.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mechanics/contact_law.h"
#include "mechanics/mobilised_friction.h"
#include "mechanics/roller_contact.h"
#include "mechanics/vessel_motion.h"
#include "numerics/block_tridiagonal.h"
#include "system/body.h"
#include "system/continuation.h"
#include "system/line.h"
#include "system/weights.h"

namespace overbend {

/// Memory of a contact from step to step.
struct ContactMemory {
  double slip_axial = 0.0, slip_lateral = 0.0;  ///< Elastic part of the slip since contact began [m].
  bool carries = false;                         ///< True if the contact carried.
  Slip axial = Slip::stick, lateral = Slip::stick;
  int element = 0;  ///< Element of the closest point, where the search begins.
  double xi = 0.5;
  int passing = 0;  ///< Number of elements further on at which the line passed the roller's axis, see ClosestPoint.
  double rate_axial = 0.0, rate_lateral = 0.0;  ///< Slip rate while the contact carried [m/s].
};

/// Contact of the line with one roller at one instant.
struct RollerContact {
  ClosestPoint closest;
  double penetration = -1.0;                        ///< Negative: the gap [m].
  double rate = 0.0;                                ///< Penetration rate [m/s].
  double normal = 0.0, axial = 0.0, lateral = 0.0;  ///< Forces on the pipe along the directions below [N].
  Vec3 normal_direction = Vec3::Zero(), axial_direction = Vec3::Zero(), lateral_direction = Vec3::Zero();
  Vec3 roller_velocity = Vec3::Zero();                    ///< Velocity of the roller at the contact point [m/s].
  double slip_rate_axial = 0.0, slip_rate_lateral = 0.0;  ///< [m/s]

  Vec3 force() const { return normal * normal_direction + axial * axial_direction + lateral * lateral_direction; }
};

/// Free: contacts open, close, stick and slide. Kept: they keep their states from before the step, as in its first
/// iteration, because a predictor ignores stiff springs and would open contacts that carry.
enum class ContactMode { free, kept };

/// Targets of the contact forces: six per node, both as in LineTarget.
struct ContactTarget {
  std::vector<double>& residual;
  std::vector<double>& cuts;
};

/// Contacts of one line with all rollers.
class RollerContacts {
 public:
  /// `line` and `bodies` must outlive this.
  RollerContacts(const Line& line, const std::vector<Body>& bodies);

  int count() const { return static_cast<int>(rollers_.size()); }
  const BodyRoller& roller(int index) const { return *rollers_[static_cast<std::size_t>(index)].roller; }
  const PlacedRoller& placed(int index) const { return placed_[static_cast<std::size_t>(index)]; }
  /// In the order of the bodies and of their rollers.
  const std::vector<RollerContact>& contacts() const { return contacts_; }

  /// Moves the rollers with their bodies and finds, by the cells, the elements that may touch each box. Elements are at
  /// `q`, enlarged by `reach` for their further motion [m]. With a reach the result remains valid until line and bodies
  /// have moved by half of it.
  void place(const std::vector<RigidMotion>& bodies, const double* q, double reach);

  /// Moves the rollers with their bodies by less than the `reach` of place(): the elements in range are unchanged.
  void move(const std::vector<RigidMotion>& bodies);

  void set(const Continuation& continuation) { continuation_ = continuation; }

  /// Adds the forces on a line at rest: normal springs, and full friction if the continuation says so; every roller on
  /// its nominal side, at the closest point of the whole line. Rollers out of reach are skipped.
  void evaluate_at_rest(const double* q, const ContactTarget& target);

  /// Adds the forces of all rollers that a moving line may touch. `before` is the memory at the start of the step,
  /// `after` receives that at its end. Rollers that were so far away at the last complete() that they cannot have come
  /// near since are skipped and keep their contact of that time.
  void evaluate(const double* q, const double* v, const Weights& weights, const std::vector<ContactMemory>& before,
                std::vector<ContactMemory>& after, ContactMode mode, const ContactTarget& target);

  /// Evaluates the rollers skipped by the last evaluation, at the same state, and searches the whole line for rollers
  /// out of reach, so that every contact has its distance.
  void complete(const double* q, const double* v, std::vector<ContactMemory>& after);
  /// Skips nothing before the next complete().
  void forget() {
    reference_.known = false;
    moved_since_search_ = kFar;
  }

  /// Adds the derivatives of the forces of the last evaluation by its unknowns `q`.
  void add_tangent(const double* q, const Weights& weights, BlockTridiagonal& tangent) const;

  int roller_body(int index) const { return static_cast<int>(rollers_[static_cast<std::size_t>(index)].body); }
  /// True if a roller exerted a normal or friction force at the last evaluation.
  bool carries(int index) const { return carrying_[static_cast<std::size_t>(index)].carries; }
  /// Returns the part of add_tangent() from a roller that carries: derivative of minus its nodal forces by the
  /// element's unknowns.
  ElementMatrix contact_tangent(int index, const double* q, const Weights& weights) const;
  /// Returns minus the nodal forces of a roller on its element, as in the residual.
  ElementVector contact_residual(int index) const;
  /// Returns their derivative by the rotation of the body in excess of a joint rotation of body and pipe: friction acts
  /// on the pipe's surface, which the body's angular velocity moves along and the pipe, which has no torsion, does not.
  Eigen::Matrix<double, 12, 3> contact_turning(int index, const Weights& weights) const;

  /// Returns the first element within reach of a roller until the next place(); `beyond` if there is none.
  int first_within_reach(int beyond) const;
  /// Returns the first element with a contact at the last evaluation; `beyond` if there is none.
  int first_carrying(int beyond) const;

  /// Sets the contact states of the following correction: a contact that slid one way may not slide the other way at
  /// the next evaluation, it sticks in between.
  void end_iteration(const std::vector<ContactMemory>& memories);

  /// Changes when a contact opens or closes, sticks or slides, because the tangent then changes.
  std::uint64_t signature() const { return signature_; }
  /// False while a contact has a state that contradicts its law: no equilibrium yet.
  bool settled() const { return settled_; }

 private:
  static constexpr double kFar = 1e300;

  struct Member {
    const BodyRoller* roller = nullptr;
    std::size_t body = 0;
  };
  /// Data of a contact for the tangent.
  struct CarryingContact {
    bool carries = false;
    RollerDistance distance;
    NormalForce normal;
    FrictionForce axial, lateral;
    MobilisedFrictionForce rub = {};
  };
  struct SlipStates {
    Slip axial = Slip::stick, lateral = Slip::stick;
  };
  /// Positions at the time when all rollers were examined.
  struct Reference {
    bool known = false;
    std::vector<double> q;
    std::vector<PlacedRoller> placed;
    std::vector<double> gap;  ///< Gap of each roller; none may be skipped unless it is above 0 [m].
  };

  /// Contact geometry and motion of a pipe at a roller that it passes.
  struct Meeting {
    RollerDistance distance;
    Vec3 velocity = Vec3::Zero();                     ///< Velocity of the centreline at the point [m/s].
    Vec3 slip_rate = Vec3::Zero();                    ///< Relative to the roller [m/s].
    Eigen::Vector4d shape = Eigen::Vector4d::Zero();  ///< Values of the shape functions at the point.
  };

  ElementRange within_reach(const Member& member) const {
    return ranges_[member.body][static_cast<std::size_t>(member.roller->box)];
  }
  void search(std::size_t body, const double* q, double reach);
  void measure(std::size_t index, RollerDistance& distance, bool on_meant_side);
  void rub(std::size_t index, const RollerDistance& distance, const NormalForce& normal);
  void push(std::size_t index, const Eigen::Vector4d& shape, const ContactTarget& target);
  void evaluate_one_at_rest(std::size_t index, const double* q, const ContactTarget& target);
  void look(const double* q, const double* v, const std::vector<ContactMemory>& memory);
  Meeting find(std::size_t index, const RollerClosestPoint& seen, const double* q, const double* v,
               const ContactMemory& memory);
  Meeting search_along(std::size_t index, const ElementRange& range, const double* q, const double* v,
                       const ContactMemory& memory);
  void regard(std::size_t index, Meeting& meeting);
  void measure_beyond_reach(std::size_t index, const double* q, const double* v, const ContactMemory& memory);
  std::optional<Meeting> meet(std::size_t index, const RollerClosestPoint& seen, const double* q, const double* v,
                              ContactMemory& after);
  void evaluate_one(std::size_t index, const std::optional<Meeting>& meeting, const Weights& weights,
                    const ContactMemory& before, ContactMemory& after, ContactMode mode, const ContactTarget& target);
  double moved_since_reference(const double* q) const;
  double rollers_moved() const;

  const Line* line_;
  const std::vector<Body>* bodies_;
  Continuation continuation_;
  std::vector<Member> rollers_;
  std::vector<PlacedRoller> placed_;
  std::vector<ElementBounds> bounds_;
  std::vector<std::vector<ElementRange>> ranges_;  ///< Per body and box.
  std::vector<RollerContact> contacts_;
  std::vector<CarryingContact> carrying_;
  std::vector<SlipStates> iterate_;
  std::vector<RigidMotion> motions_;
  Reference reference_;
  double rollers_moved_ = 0.0;                ///< Maximum motion of any roller since the reference [m].
  double moved_ = 0.0;                        ///< Last value of moved_since_reference() [m].
  double moved_since_search_ = kFar;          ///< Sum over the steps [m].
  double max_length_ = 0.0;                   ///< Maximum element length [m].
  std::vector<char> passed_over_;             ///< True if skipped by the last evaluation.
  std::vector<std::size_t> looked_at_;        ///< Examined rollers, with
  std::vector<RollerSearch> looks_;           ///< their search positions and
  std::vector<RollerClosestPoint> meetings_;  ///< the results.
  std::uint64_t signature_ = 0;
  bool settled_ = true;
};

}  // namespace overbend
