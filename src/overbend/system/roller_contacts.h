/// Contact of a line with the rollers of bodies, at rest and in motion: one search, one gap, one law.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mechanics/contact_law.h"
#include "mechanics/roller_contact.h"
#include "mechanics/roller_rub.h"
#include "mechanics/vessel_motion.h"
#include "numerics/block_tridiagonal.h"
#include "system/body.h"
#include "system/continuation.h"
#include "system/line.h"
#include "system/weights.h"

namespace overbend {

/// What a contact remembers from step to step.
struct ContactMemory {
  double slip_axial = 0.0, slip_lateral = 0.0;  ///< Elastic part of the slip since contact began [m].
  bool carries = false;                         ///< Whether the contact carried.
  Slip axial = Slip::stick, lateral = Slip::stick;
  int element = 0;  ///< Where the closest point was: the search begins here.
  double xi = 0.5;
  int passing = 0;  ///< How many elements further on the line passed the roller's axis, see ClosestPoint.
  double rate_axial = 0.0, rate_lateral = 0.0;  ///< Of the slip, where the contact carried [m/s].
};

/// One roller as the line meets it at one instant.
struct RollerContact {
  ClosestPoint at;
  double penetration = -1.0;                        ///< Negative: the gap [m].
  double rate = 0.0;                                ///< Of penetration [m/s].
  double normal = 0.0, axial = 0.0, lateral = 0.0;  ///< Forces on the pipe along the directions below [N].
  Vec3 normal_direction = Vec3::Zero(), axial_direction = Vec3::Zero(), lateral_direction = Vec3::Zero();
  Vec3 roller_velocity = Vec3::Zero();                    ///< Of the roller where the pipe touches it [m/s].
  double slip_rate_axial = 0.0, slip_rate_lateral = 0.0;  ///< [m/s]

  Vec3 force() const { return normal * normal_direction + axial * axial_direction + lateral * lateral_direction; }
};

/// Whether contacts open, close, stick and slide as they will, or stay as they were before the step. The first
/// iteration of a step keeps them: a predictor knows nothing of stiff springs, and would open contacts that carry.
enum class ContactMode { free, kept };

/// Where the forces of contacts are added: six per node, both as in LineTarget.
struct ContactTarget {
  std::vector<double>& residual;
  std::vector<double>& cuts;
};

class RollerContacts {
 public:
  /// `line` and `bodies` must outlive this.
  RollerContacts(const Line& line, const std::vector<Body>& bodies);

  int count() const { return static_cast<int>(rollers_.size()); }
  const BodyRoller& roller(int index) const { return *rollers_[static_cast<std::size_t>(index)].roller; }
  const PlacedRoller& placed(int index) const { return placed_[static_cast<std::size_t>(index)]; }
  /// In the order of the bodies and of their rollers.
  const std::vector<RollerContact>& contacts() const { return contacts_; }

  /// Moves the rollers with their bodies and looks, by the cells, which elements may meet which box. Elements are taken
  /// where `q` has them, grown by `reach` for what they may still move [m]. With a reach, what was found serves on
  /// until line and bodies have moved by half of it.
  void place(const std::vector<RigidMotion>& bodies, const double* q, double reach);

  /// Moves the rollers with their bodies by less than the `reach` they were placed with: what they may meet stays.
  void move(const std::vector<RigidMotion>& bodies);

  void set(const Continuation& continuation) { continuation_ = continuation; }

  /// Forces on a line at rest: normal springs, and full friction where the continuation says so; every roller on the
  /// side that it is meant for, wherever along the line the closest point is. Rollers out of reach are not looked at.
  void evaluate_at_rest(const double* q, const ContactTarget& target);

  /// Forces of all rollers that a moving line may meet, added to the line's. `before` is the memory at the start of the
  /// step, `after` receives that at its end. Rollers that were so far away when complete() was called last that they
  /// cannot have come near since are passed over, and tell of their contact what it was then.
  void evaluate(const double* q, const double* v, const Weights& weights, const std::vector<ContactMemory>& before,
                std::vector<ContactMemory>& after, ContactMode mode, const ContactTarget& target);

  /// Looks at what the last evaluation passed over, of the same state, and for rollers out of reach along the whole
  /// line, so that every contact tells its distance.
  void complete(const double* q, const double* v, std::vector<ContactMemory>& after);
  /// Nothing is passed over before complete() is called again.
  void forget() {
    reference_.known = false;
    moved_since_search_ = kFar;
  }

  /// Adds how the forces of the last evaluation change with the unknowns `q` that it was given.
  void add_tangent(const double* q, const Weights& weights, BlockTridiagonal& tangent) const;

  int body_of(int index) const { return static_cast<int>(rollers_[static_cast<std::size_t>(index)].body); }
  /// Whether a roller pushed or rubbed at the last evaluation.
  bool carries(int index) const { return carrying_[static_cast<std::size_t>(index)].carries; }
  /// What add_tangent() adds for a roller that carries: how minus its forces on the nodes of the element change with
  /// the element's unknowns.
  ElementMatrix tangent_of(int index, const double* q, const Weights& weights) const;
  /// Minus the forces of a roller on the nodes of the element that it touches, as they are in the residual.
  ElementVector residual_of(int index) const;
  /// How they change with the turning of the body beyond what they do when body and pipe turn together: friction acts
  /// on the pipe's surface, which the body's angular velocity moves along and the pipe, which has no torsion, does not.
  Eigen::Matrix<double, 12, 3> turning_of(int index, const Weights& weights) const;

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
  static constexpr double kFar = 1e300;

  struct Member {
    const BodyRoller* roller = nullptr;
    std::size_t body = 0;
  };
  /// What the tangent needs of a contact.
  struct CarryingContact {
    bool carries = false;
    RollerDistance distance;
    NormalForce normal;
    FrictionForce axial, lateral;
    RubForce rub = {};
  };
  struct SlipStates {
    Slip axial = Slip::stick, lateral = Slip::stick;
  };
  /// Where everything was when all rollers were looked at.
  struct Reference {
    bool known = false;
    std::vector<double> q;
    std::vector<PlacedRoller> placed;
    std::vector<double> gap;  ///< Of each roller; nothing may be passed over where it is not above 0 [m].
  };

  /// Of a pipe that passes a roller: what its forces are made from.
  struct Meeting {
    RollerDistance distance;
    Vec3 velocity = Vec3::Zero();                     ///< Of the centreline at the point [m/s].
    Vec3 slip_rate = Vec3::Zero();                    ///< Against the roller [m/s].
    Eigen::Vector4d shape = Eigen::Vector4d::Zero();  ///< Values of the element's functions at the point.
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
  Meeting find(std::size_t index, const RollerMeeting& seen, const double* q, const double* v,
               const ContactMemory& memory);
  Meeting search_along(std::size_t index, const ElementRange& range, const double* q, const double* v,
                       const ContactMemory& memory);
  void regard(std::size_t index, Meeting& meeting);
  void look_beyond_reach(std::size_t index, const double* q, const double* v, const ContactMemory& memory);
  std::optional<Meeting> meet(std::size_t index, const RollerMeeting& seen, const double* q, const double* v,
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
  std::vector<std::vector<ElementRange>> ranges_;  ///< Body by body, of its boxes.
  std::vector<RollerContact> contacts_;
  std::vector<CarryingContact> carrying_;
  std::vector<SlipStates> iterate_;
  std::vector<RigidMotion> motions_;
  Reference reference_;
  double rollers_moved_ = 0.0;           ///< Most of any roller since the reference [m].
  double moved_ = 0.0;                   ///< As moved_since_reference() had it last [m].
  double moved_since_search_ = kFar;     ///< Sum from step to step [m].
  double longest_ = 0.0;                 ///< Element [m].
  std::vector<char> passed_over_;        ///< By the last evaluation.
  std::vector<std::size_t> looked_at_;   ///< Rollers, with
  std::vector<RollerLook> looks_;        ///< where each is looked for and
  std::vector<RollerMeeting> meetings_;  ///< what was seen there.
  std::uint64_t signature_ = 0;
  bool settled_ = true;
};

}  // namespace overbend
