#include "system/held_end.h"

namespace overbend {
namespace {

Mat6 dense_block(const double* rows) {
  Mat6 out;
  for (int i = 0; i < kNodeDofs; ++i) {
    for (int j = 0; j < kNodeDofs; ++j) {
      out(i, j) = rows[i * kRowWidth + j];
    }
  }
  return out;
}

}  // namespace

Vec6 held_end_force(const Attachment& held, const LineAssembly& line, const LineState& state, const BodyPose& pose) {
  const int node = held_node(held, line.line());
  const double* q = state.q.data() + 6 * node;
  const Vec3 r = Eigen::Map<const Vec3>(q), t = Eigen::Map<const Vec3>(q + 3);
  const std::array<double, 6>& all = line.held_force(node);
  Vec6 sum = Vec6::Zero();
  if (held.hold_place) {
    sum += point_rows(pose, r).transpose() * Eigen::Map<const Vec3>(all.data());
  }
  if (held.hold_direction) {
    sum += vector_rows(pose, t).transpose() * Eigen::Map<const Vec3>(all.data() + 3);
  }
  return sum;
}

HeldEnd held_end(const Attachment& held, const LineAssembly& line, const LineState& state, const BodyPose& pose) {
  HeldEnd end;
  end.node = held_node(held, line.line());
  const double* q = state.q.data() + 6 * end.node;
  const Vec3 r = Eigen::Map<const Vec3>(q), t = Eigen::Map<const Vec3>(q + 3);
  const Vec6 all = Eigen::Map<const Vec6>(line.held_force(end.node).data());
  const Mat3& e = pose.E;
  const auto hold = [&](int first, const Eigen::Matrix<double, 3, 6>& rows, const Vec3& arm) {
    const Vec3 force = all.segment<3>(first);
    const Mat3 across = cross_matrix(force);
    end.motion.middleRows<3>(first) = rows;
    end.turned_force.block<3, 3>(first, 3) = across * e;
    end.turning += generalised_force_slope(pose, arm, force);
  };
  if (held.hold_place) {
    hold(0, point_rows(pose, r), r - pose.place);
  }
  if (held.hold_direction) {
    hold(3, vector_rows(pose, t), t);
  }
  return end;
}

Mat6 diagonal_block(const LineAssembly& line, int node) {
  return dense_block(line.tangent().diag(node));
}

NeighbourBlocks blocks_before(const LineAssembly& line, int node) {
  const BlockTridiagonal& k = line.tangent();
  return {node - 1, dense_block(k.upper(node - 1)), dense_block(k.lower(node - 1))};
}

NeighbourBlocks blocks_behind(const LineAssembly& line, int node) {
  const BlockTridiagonal& k = line.tangent();
  return {node + 1, dense_block(k.lower(node)), dense_block(k.upper(node))};
}

ContactBorder contact_border(const BodyPose& pose, const ElementVector& q, const ElementVector& residual,
                             const ElementMatrix& tangent, const Eigen::Matrix<double, 12, 3>& turning) {
  const Mat3& e = pose.E;
  Eigen::Matrix<double, 12, 6> motion;  // of the nodes, if they moved with the body
  Eigen::Matrix<double, 12, 3> turned;  // [residual] x, block by block
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (int i = 0; i < 4; ++i) {
    const Vec3 value = q.segment<3>(3 * i), part = residual.segment<3>(3 * i);
    const bool place = i % 2 == 0;
    motion.middleRows<3>(3 * i) = place ? point_rows(pose, value) : vector_rows(pose, value);
    turned.middleRows<3>(3 * i) = cross_matrix(part);
    force -= place ? part : Vec3(Vec3::Zero());
    moment -= (place ? Vec3(value - pose.place) : value).cross(part);
  }
  ContactBorder border;
  // Entry by entry: at this size faster than the general matrix product.
  border.columns = -tangent.lazyProduct(motion);
  border.columns.rightCols<3>() += (turning - turned) * e;
  border.rows = -tangent.transpose().lazyProduct(motion);
  border.rows.rightCols<3>() -= turned * e;
  border.corner = -motion.transpose().lazyProduct(border.columns);
  border.corner.block<3, 3>(3, 0) += e.transpose() * cross_matrix(force);
  border.corner += generalised_moment_slope(pose, moment);
  return border;
}

CarrierMotion carrier_motion(const BodyPose& pose, int k) {
  CarrierMotion motion;
  motion.origin = pose.place;
  if (k < 3) {
    motion.velocity(k) = 1.0;
  } else {
    motion.axis = pose.E.col(k - 3);
  }
  return motion;
}

ElementMotion element_motion(const CarrierMotion& motion, const ElementVector& q) {
  ElementMotion out;
  for (int i = 0; i < 4; ++i) {
    const Vec3 value = q.segment<3>(3 * i);
    out.segment<3>(3 * i) =
        i % 2 == 0 ? Vec3(motion.velocity + motion.axis.cross(value - motion.origin)) : Vec3(motion.axis.cross(value));
  }
  return out;
}

TwistBorder twist_border(const Twist& twist, const ElementVector& q, const ElementVector& residual,
                         const ElementMatrix& tangent, const Eigen::Matrix<double, 12, 3>& turning) {
  const ElementMotion motion = element_motion({Vec3::Zero(), twist.axis, twist.origin}, q);
  ElementMotion turned;  // the forces rotate with the body
  for (int i = 0; i < 4; ++i) {
    turned.segment<3>(3 * i) = twist.axis.cross(Vec3(residual.segment<3>(3 * i)));
  }
  TwistBorder border;
  border.column = turned + turning * twist.axis - tangent * motion;
  border.row = turned - tangent.transpose() * motion;
  return border;
}

double twist_corner(const Twist& twist, const CarrierMotion* by, const ElementVector& q, const ElementVector& residual,
                    const ElementMotion& column) {
  double sum = -element_motion({Vec3::Zero(), twist.axis, twist.origin}, q).dot(column);
  if (by == nullptr) {
    return sum;
  }
  const Vec3 axis_turned = by->axis.cross(twist.axis);
  const Vec3 at_moved = by->velocity + by->axis.cross(twist.origin - by->origin);
  for (int i = 0; i < 4; ++i) {
    const Vec3 value = q.segment<3>(3 * i), part = residual.segment<3>(3 * i);
    const Vec3 change = i % 2 == 0 ? Vec3(axis_turned.cross(value - twist.origin) - twist.axis.cross(at_moved))
                                   : Vec3(axis_turned.cross(value));
    sum -= change.dot(part);
  }
  return sum;
}

void add_to_panel(double* panel, int stride, int first, const Mat6& part) {
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      panel[i * stride + first + j] += part(i, j);
    }
  }
}

void remove_held(const HeldDirections& held, double* panel, int stride) {
  const auto remove = [&](const HeldVectors& directions, int row) {
    for (const Vec3& d : directions) {
      for (int j = 0; j < stride; ++j) {
        double* const entry = panel + row * stride + j;
        const double part = d(0) * entry[0] + d(1) * entry[stride] + d(2) * entry[2 * stride];
        for (int i = 0; i < 3; ++i) {
          entry[i * stride] -= d(i) * part;
        }
      }
    }
  };
  remove(held.position, 0);
  remove(held.tangent, 3);
}

}  // namespace overbend
