/// Bodies on hinges among the free ones: a chain of sections that hangs on the vessel, each with one unknown, its
/// angle.
///
/// Their equations are those of d'Alembert's principle: the unbalanced force of every section works on each motion that
/// carries it along, those of the hinges before it and, where the vessel is free, the vessel's. What rollers do comes
/// from system/body_border.h. Theory: docs/theory/stinger-motion.md.
#pragma once

#include <span>
#include <vector>

#include "system/state.h"
#include "system/system.h"

namespace overbend {

/// A turning about an axis that stands at a place, W.
struct Twist {
  Vec3 axis = Vec3::Zero(), at = Vec3::Zero();

  /// Its generalised force of a force at a point.
  double of(const Vec3& force, const Vec3& point) const { return axis.dot((point - at).cross(force)); }
};

/// What a hinge bears, of the state evaluated last.
struct HingeReading {
  double angle = 0.0, rate = 0.0;  ///< [rad], [rad/s]
  Vec3 force = Vec3::Zero(),
       moment = Vec3::Zero();                       ///< On the section, W; the moment without that of stops [N], [N m].
  Vec3 place = Vec3::Zero();                        ///< W [m].
  double stop_moment = 0.0, friction_moment = 0.0;  ///< On the section, positive when they push the tip down [N m].
  double draught = 0.0;                             ///< Of the tanks below the surface [m].
};

class HingedSections {
 public:
  /// `numbers`: of the bodies of the system among the free ones, -1 where they are not.
  HingedSections(const System& system, const std::vector<int>& numbers);

  bool empty() const { return sections_.empty(); }
  bool has(int number) const { return number >= 0 && at_[static_cast<std::size_t>(number)] >= 0; }
  /// Numbers of the sections that carry it along, itself the last.
  std::span<const int> chain(int number) const;
  const Twist& twist(int number) const { return section(number).twist; }
  /// The vessel's number where it is free, else -1.
  int vessel() const { return vessel_; }

  /// Brings the sections to a state; the vessel is where `now` has it.
  void lead(const std::vector<HullState>& at, Surroundings& now);
  /// Takes the water at a time where the sections are now.
  void meet_water(double time);

  /// Adds the generalised forces of the sections by themselves to the residual, six for each free body; friction in
  /// `state` receives what that of `before` has become. With `tangent` its tangent, too.
  void evaluate(std::vector<HullState>& state, const std::vector<HullState>& before, const Weights& weights,
                bool with_tangent, std::vector<double>& residual);
  /// A roller's force on the pipe at a point: adds what its opposite does to all that carry the section.
  void add_roller(int number, const Vec3& point, const Vec3& force, std::vector<double>& residual);
  /// Tangent of evaluate(), row-major over all free bodies' unknowns.
  const std::vector<double>& tangent() const { return tangent_; }

  /// After evaluate() and add_roller(): energies, and powers of water, vessel and what rubs.
  BodyEnergy energy() const;
  std::size_t count() const { return sections_.size(); }
  /// Of section `index`, from the barge astern.
  HingeReading reading(std::size_t index) const;

 private:
  struct Section {
    const HingedBody* body = nullptr;
    int index = 0, number = 0;  ///< In System::bodies, among the free ones.
    std::vector<int> chain;
    RigidMotion motion;
    Twist twist;
    Wrench unbalance;  ///< Of itself about its hinge, rollers included once added.
    HingeMotion turn;
    HingeMoment moment;
    std::vector<Vec3> points;
    std::vector<WaterState> water;
  };
  /// Motion of the whole tree: of the vessel, and of each hinge.
  struct Coordinates {
    Vec6 h = Vec6::Zero(), v = Vec6::Zero(), a = Vec6::Zero();
    std::vector<HingeMotion> turns;
  };

  const Section& section(int number) const {
    return sections_[static_cast<std::size_t>(at_[static_cast<std::size_t>(number)])];
  }
  Section& section(int number) { return sections_[static_cast<std::size_t>(at_[static_cast<std::size_t>(number)])]; }
  void move(const Coordinates& to);
  void add_forces(std::vector<double>& sum);
  void add_joints(std::vector<HullState>& state, const std::vector<HullState>& before, const Weights& weights,
                  bool with_tangent, std::vector<double>& residual);
  void find_tangent(const Weights& weights);
  void add_column(int unknown, double weight, const Coordinates& more, const Coordinates& less, double change);
  Wrench carried(std::size_t first) const;

  const System* system_;
  int vessel_ = -1;
  std::vector<int> at_;  ///< Of each free body: which section, -1 for none.
  std::vector<Section> sections_;
  RigidMotion barge_;
  BodyPose vessel_pose_;
  Coordinates now_, more_, less_;
  std::vector<double> high_, low_, tangent_;
};

}  // namespace overbend
