/// Hinged bodies among the free ones: a chain of sections carried by the vessel, each with one unknown, its angle.
///
/// Equations by d'Alembert's principle: the unbalanced force of every section does work on each motion that carries it,
/// those of the hinges before it and, if the vessel is free, the vessel's. Roller forces come from
/// system/body_border.h. Theory: docs/theory/stinger-motion.md.
#pragma once

#include <span>
#include <vector>

#include "system/state.h"
#include "system/system.h"

namespace overbend {

/// Rotation about an axis through a point, W.
struct Twist {
  Vec3 axis = Vec3::Zero(), origin = Vec3::Zero();

  /// Returns the generalised force of a force at a point.
  double generalised_force(const Vec3& force, const Vec3& point) const {
    return axis.dot((point - origin).cross(force));
  }
};

/// Loads on a hinge at the last evaluated state.
struct HingeReading {
  double angle = 0.0, rate = 0.0;  ///< [rad], [rad/s]
  Vec3 force = Vec3::Zero(),
       moment = Vec3::Zero();                       ///< On the section, W; the moment without that of stops [N], [N m].
  Vec3 place = Vec3::Zero();                        ///< W [m].
  double stop_moment = 0.0, friction_moment = 0.0;  ///< Moments on the section, positive tip down [N m].
  double draught = 0.0;                             ///< Draught of the tanks [m].
};

/// Equations of the hinged sections of a stinger.
class HingedSections {
 public:
  /// `numbers`: index of each body of the system among the free ones, -1 for other bodies.
  HingedSections(const System& system, const std::vector<int>& numbers);

  bool empty() const { return sections_.empty(); }
  bool has(int number) const { return number >= 0 && at_[static_cast<std::size_t>(number)] >= 0; }
  /// Returns the numbers of the sections that carry a section, itself last.
  std::span<const int> chain(int number) const;
  const Twist& twist(int number) const { return section(number).twist; }
  /// Returns the vessel's number among the free bodies, or -1.
  int vessel() const { return vessel_; }

  /// Moves the sections to a state; the position of the vessel is in `surroundings`.
  void lead(const std::vector<HullState>& states, Surroundings& surroundings);
  /// Evaluates the water at a time at the present positions of the sections.
  void evaluate_water(double time);

  /// Adds the generalised forces of the sections without rollers to the residual, six for each free body, and sets the
  /// tangent if `with_tangent`. The friction memory of `state` is updated from `before`.
  void evaluate(std::vector<HullState>& state, const std::vector<HullState>& before, const Weights& weights,
                bool with_tangent, std::vector<double>& residual);
  /// Adds the reaction to a roller's force on the pipe at a point to all bodies that carry the section.
  void add_roller(int number, const Vec3& point, const Vec3& force, std::vector<double>& residual);
  /// Returns the tangent of evaluate(), row-major over all free bodies' unknowns.
  const std::vector<double>& tangent() const { return tangent_; }

  /// Returns energies, and powers of water, vessel and friction, after evaluate() and add_roller().
  BodyEnergy energy() const;
  std::size_t count() const { return sections_.size(); }
  /// Returns the loads of section `index`, from the vessel astern.
  HingeReading reading(std::size_t index) const;

 private:
  struct Section {
    const HingedBody* body = nullptr;
    int index = 0, number = 0;  ///< In System::bodies, among the free ones.
    std::vector<int> chain;
    RigidMotion motion;
    Twist twist;
    Wrench unbalance;  ///< Unbalanced load about its hinge, including rollers once added.
    HingeMotion turn;
    HingeMoment moment;
    std::vector<Vec3> points;
    std::vector<WaterState> water;
  };
  /// Motion of the whole chain: of the vessel, and of each hinge.
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
  std::vector<int> at_;  ///< Per free body: index of its section, -1 for none.
  std::vector<Section> sections_;
  RigidMotion barge_;
  BodyPose vessel_pose_;
  Coordinates now_, more_, less_;
  std::vector<double> high_, low_, tangent_;
};

}  // namespace overbend
