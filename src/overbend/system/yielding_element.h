/// Contributions of elements with plasticity to the equations of a line, at rest and in motion.
#pragma once

#include <array>

#include "system/yielding.h"

namespace overbend {

/// Unknowns of an element relative to its first node: derivatives need no more, and the difference keeps digits that
/// positions of hundreds of metres lose.
inline ElementVector dofs(const LineShape& shape, std::size_t element) {
  ElementVector q(Eigen::Map<const ElementVector>(shape.q + 6 * element));
  q.segment<3>(6) -= q.segment<3>(0).eval();
  if (shape.low != nullptr) {
    const double* low = shape.low + 6 * element;
    q.segment<3>(6) += Vec3(low[6] - low[0], low[7] - low[1], low[8] - low[2]);
  }
  q.segment<3>(0).setZero();
  return q;
}

inline void scatter(const ElementVector& force, const ElementMatrix& k, int element, const YieldingTarget& target) {
  double* residual = target.residual->data() + 6 * element;
  for (int i = 0; i < 12; ++i) residual[i] += force(i);
  if (target.cuts != nullptr) {
    double* cuts = target.cuts->data() + 6 * element;
    for (int i = 6; i < 12; ++i) cuts[i] += force(i);
    if (element == 0) {  // the cut at the first node is minus the contribution of the first element
      for (int i = 0; i < 6; ++i) cuts[i] -= force(i);
    }
  }
  if (target.tangent != nullptr) add_element(*target.tangent, element, k);
}

/// Sum over the points of one element.
class ElementSum {
 public:
  explicit ElementSum(bool with_tangent) : with_tangent_(with_tangent) {}

  void add(const HermiteValues& shape, const CentrelinePoint& centre_point, double weight, const BendingMemory& memory,
           const BendingResponse& answer, Vec3& moment) {
    moment = from_axes(memory, answer.plastic_moment);
    if (answer.plastic_moment.isZero(0.0)) return;
    if (!any_) clear();
    const bool slides = with_tangent_ && answer.sliding;
    Mat3 tangent;
    if (slides) {
      Eigen::Matrix<double, 3, 2> axes;
      axes << memory.axis, memory.tangent.cross(memory.axis);
      tangent = axes * answer.plastic_tangent * axes.transpose();
    }
    add_plastic_point(shape, centre_point, weight, moment, slides ? &tangent : nullptr, force_,
                      with_tangent_ ? &stiffness_ : nullptr);
  }
  void scatter_to(int element, const YieldingTarget& target) const {
    if (any_) scatter(force_, stiffness_, element, target);
  }

 private:
  /// Deferred: most elements of a line with local yielding stay elastic.
  void clear() {
    any_ = true;
    force_.setZero();
    if (with_tangent_) stiffness_.setZero();
  }

  bool with_tangent_, any_ = false;
  ElementVector force_;
  ElementMatrix stiffness_;
};

/// Derivatives of the Hermite functions at a Gauss point, without values.
inline HermiteValues gauss_shape(int point, double h) {
  static const std::array<HermiteValues, kGaussPoints> unit = {hermite(kGaussXi[0], 1.0), hermite(kGaussXi[1], 1.0),
                                                               hermite(kGaussXi[2], 1.0), hermite(kGaussXi[3], 1.0)};
  const HermiteValues& of = unit[static_cast<std::size_t>(point)];
  const double by_h = 1.0 / h;
  HermiteValues shape;
  shape.first << by_h * of.first(0), of.first(1), by_h * of.first(2), of.first(3);
  shape.second << by_h * by_h * of.second(0), by_h * of.second(1), by_h * by_h * of.second(2), by_h * of.second(3);
  return shape;
}

/// Derivatives of the centreline there, without position.
inline CentrelinePoint point_at(const ElementVector& q, const HermiteValues& shape) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 4>> nodes(q.data());
  return {Vec3::Zero(), nodes * shape.first, nodes * shape.second};
}

}  // namespace overbend
