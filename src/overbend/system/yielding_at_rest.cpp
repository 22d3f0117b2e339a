// Steel that yields in statics: what passes the supports from the tensioner down.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "system/yielding_element.h"

namespace overbend {
namespace {

/// One for each law of the line.
void set_out(const YieldingElements& elements, std::vector<PassingPipe>& passing) {
  passing.clear();
  for (std::size_t e = 0; e < elements.law.size(); ++e) {
    const BendingLaw* law = elements.law[e];
    const auto same = [&](const PassingPipe& pipe) { return pipe.law == law; };
    if (law != nullptr && std::ranges::none_of(passing, same)) passing.push_back({law, e});
  }
}

/// The pipe comes to a place as it was bent before.
BendingMemory& arrive(PassingPipe& pipe, const Vec3& tangent) {
  if (pipe.begun) {
    bring_along(pipe.memory, tangent);
  } else {
    pipe.memory = fresh_memory(tangent);
    pipe.begun = true;
  }
  return pipe.memory;
}

/// What is passed in one element of a line at rest.
struct PassedElement {
  std::size_t index = 0;
  const BendingLaw* law = nullptr;  ///< Of the pipe that lies there; null for linear steel.
  LevelMix mix;
  double z = 0.0;  ///< Of its middle [m].
  ElementVector q;
  double length = 0.0;  ///< [m]
};

/// Moments below are given as the vectors E I k would be, with k the curvature vector [N m].

/// Moment at `xi` that loads within an element add to the linear course that its nodes know: of a beam clamped at both
/// ends, which has no part along that course whatever the material.
Vec3 moment_within(const PassedElement& element, std::span<const RollerPush> pushes, double xi) {
  const Vec3 chord = element.q.segment<3>(6).normalized();
  const auto across = [&](const Vec3& v) { return Vec3(v - v.dot(chord) * chord); };
  const double h = element.length;
  Vec3 moment = (h * h / 12.0) * (1.0 - 6.0 * xi + 6.0 * xi * xi) * across(pushes.front().load);
  for (const RollerPush& push : pushes) {
    const double a = push.xi, b = 1.0 - a;
    const double share = b * b * ((1.0 + 2.0 * a) * xi - a) - std::max(0.0, xi - a);
    moment -= h * share * across(push.force);
  }
  return moment;
}

/// Weight of a Gauss point in the linear course of the moments (least squares) at `xi`.
double linear_weight(int point, double xi) {
  return kGaussWeight[point] * (1.0 + 3.0 * (2.0 * xi - 1.0) * (2.0 * kGaussXi[point] - 1.0));
}

/// The pipe that lies in an element with rollers, as it comes to its places and as it is bent there.
class LyingPipe {
 public:
  LyingPipe(const PassedElement& element, double share) : element_(element), share_(share) {}

  /// Moment at a Gauss point of a pipe with a memory.
  Vec3 moment_at(int point, BendingMemory memory, double EI) const {
    const CentrelinePoint there = point_at(element_.q, gauss_shape(point, element_.length));
    bring_along(memory, there.a.normalized());
    return moment(curvature_vector(there), memory, EI).first;
  }

  /// Moment of a pipe that is bent to a curvature, and its derivative across the pipe; the memory becomes what it is
  /// then.
  std::pair<Vec3, Mat2> moment(const Vec3& curvature, BendingMemory& memory, double EI) const {
    const Vec2 k = in_axes(memory, curvature);
    const BendingAnswer answer = bend(*element_.law, element_.mix, k, memory);
    return {from_axes(memory, EI * k - share_ * answer.plastic_moment),
            EI * Mat2::Identity() - share_ * answer.plastic_tangent};
  }

  /// Curvature under a roller: the law has the moment there that balances the element, by the linear course of the
  /// moments at its Gauss points and what the loads within it add. Points below the roller have passed it. `memory` as
  /// the pipe comes to the roller.
  Vec3 curvature_under(std::span<const RollerPush> pushes, const RollerPush& push, const BendingMemory& memory) const {
    constexpr int kMaxCurvatureSteps = 20;
    constexpr double kTolerance = 1e-7;  // of the first limit of the law
    const Vec3 within = moment_within(element_, pushes, push.xi);
    Vec3 above = within;
    double weight_below = 0.0;
    for (int i = 0; i < kGaussPoints; ++i) {
      const double weight = linear_weight(i, push.xi);
      if (kGaussXi[i] >= push.xi) {
        above += weight * moment_at(i, memory, push.EI);
      } else {
        weight_below += weight;
      }
    }
    Vec3 curvature = curvature_vector(centreline(element_.q, push.xi, element_.length)) + within / push.EI;
    for (int iteration = 0; iteration < kMaxCurvatureSteps; ++iteration) {
      BendingMemory bent = memory;
      const auto [moment_there, slope] = moment(curvature, bent, push.EI);
      Vec3 wanted = above;
      for (int i = 0; i < kGaussPoints; ++i) {
        if (kGaussXi[i] < push.xi) wanted += linear_weight(i, push.xi) * moment_at(i, bent, push.EI);
      }
      // More bending under the roller takes as much off the points below, which unload elastically.
      const Mat2 change = slope + std::max(weight_below, 0.0) * (push.EI * Mat2::Identity() - slope);
      const Vec2 step = change.inverse() * in_axes(memory, wanted - moment_there);
      curvature += from_axes(memory, step);
      if (step.norm() < kTolerance * element_.law->limit[0]) break;
    }
    return curvature;
  }

 private:
  const PassedElement& element_;
  double share_;  ///< Of the plastic moments that acts.
};

/// Pipe of every law on its way from the tensioner down the line.
class PassingPipes {
 public:
  PassingPipes(const YieldingElements& elements, const StaticYield& how, std::vector<PassingPipe>& pipes)
      : elements_(elements), how_(how), pipes_(pipes) {}

  /// Bends all pipes to the curvature of a Gauss point; the memory of the pipe that lies there, as it arrives, or null.
  BendingMemory* pass(const PassedElement& element, const Vec3& tangent, const Vec3& curvature) {
    BendingMemory* lying = nullptr;
    for_each(element, tangent, [&](const PassingPipe& pipe, BendingMemory& memory) {
      if (pipe.law == element.law) {
        lying = &memory;
      } else {
        bend(*pipe.law, level_at(*pipe.law, element.z), in_axes(memory, curvature), memory);
      }
    });
    return lying;
  }

  /// The pipe that lies there as it arrives, for a point that no other pipe is to be bent by.
  BendingMemory* look(const PassedElement& element, const Vec3& tangent) {
    BendingMemory* lying = nullptr;
    for_each(element, tangent, [&](const PassingPipe& pipe, BendingMemory& memory) {
      if (pipe.law == element.law) lying = &memory;
    });
    return lying;
  }

  /// Bends all pipes to the curvature that the pipe lying there has under a roller; `pushes`: all of the element.
  void pass_peak(const PassedElement& element, std::span<const RollerPush> pushes, const RollerPush& push) {
    const CentrelinePoint there = centreline(element.q, push.xi, element.length);
    const Vec3 tangent = there.a.normalized();
    const BendingMemory* lying = look(element, tangent);
    const Vec3 curvature = lying != nullptr
                               ? LyingPipe(element, how_.share).curvature_under(pushes, push, *lying)
                               : curvature_vector(there) + moment_within(element, pushes, push.xi) / push.EI;
    for_each(element, tangent, [&](const PassingPipe& pipe, BendingMemory& memory) {
      bend(*pipe.law, level_at(*pipe.law, element.z), in_axes(memory, curvature), memory);
    });
  }

 private:
  template <class Visit>
  void for_each(const PassedElement& element, const Vec3& tangent, const Visit& visit) {
    if (!elements_.bends_passing(element.index)) return;
    for (PassingPipe& pipe : pipes_) {
      if (element.index >= pipe.last) visit(pipe, arrive(pipe, tangent));
    }
  }

  const YieldingElements& elements_;
  const StaticYield& how_;
  std::vector<PassingPipe>& pipes_;
};

}  // namespace

void add_static_yielding(const YieldingElements& elements, const LineMesh& mesh, const StaticYield& how,
                         const LineShape& q, bool keep_memory, StaticYielding& points, const YieldingTarget& target) {
  const std::size_t count = elements.law.size();
  points.plastic_moment.assign(kGaussPoints * count, Vec3::Zero());
  points.memory.resize(keep_memory ? kGaussPoints * count : 0);
  const bool laying = how.before == nullptr && how.history == LayHistory::laying;
  points.passing.clear();
  if (laying) set_out(elements, points.passing);
  PassingPipes pipes(elements, how, points.passing);
  BendingMemory own;
  auto push = how.pushes.begin();
  for (std::size_t e = count; e-- > 0;) {
    const BendingLaw* law = elements.law[e];
    const PassedElement element{e,          law,           elements.mix[e], 0.5 * (q.q[6 * e + 2] + q.q[6 * e + 8]),
                                dofs(q, e), mesh.length[e]};
    const auto end = std::find_if(
        push, how.pushes.end(), [e](const RollerPush& other) { return static_cast<std::size_t>(other.element) != e; });
    const std::span<const RollerPush> pushes(push, laying ? end : push);
    const auto pass_peaks_down_to = [&](double xi) {
      for (; push != end && push->xi > xi; ++push) {
        if (laying) pipes.pass_peak(element, pushes, *push);
      }
    };
    ElementSum sum(target.tangent != nullptr);
    for (int i = kGaussPoints - 1; i >= 0; --i) {
      pass_peaks_down_to(kGaussXi[i]);
      const HermiteValues shape = gauss_shape(i, mesh.length[e]);
      const CentrelinePoint at = point_at(element.q, shape);
      const Vec3 tangent = at.a.normalized(), curvature = curvature_vector(at);
      const std::size_t index = kGaussPoints * e + static_cast<std::size_t>(i);
      BendingMemory* memory = pushes.empty() ? pipes.pass(element, tangent, curvature) : pipes.look(element, tangent);
      if (!pushes.empty() && memory != nullptr) {
        own = *memory;
        memory = &own;
      }
      if (memory == nullptr && (law != nullptr || keep_memory)) {  // it came here otherwise than from the tensioner
        own = how.before != nullptr ? how.before[index] : fresh_memory(tangent);
        bring_along(own, tangent);
        memory = &own;
      }
      if (law != nullptr) {
        BendingAnswer answer = bend(*law, elements.mix[e], in_axes(*memory, curvature), *memory);
        answer.plastic_moment *= how.share;
        answer.plastic_tangent *= how.share;
        sum.add(shape, at, kGaussWeight[i] * mesh.length[e], *memory, answer, points.plastic_moment[index]);
      }
      if (keep_memory) points.memory[index] = *memory;
    }
    pass_peaks_down_to(-1.0);
    sum.scatter_to(static_cast<int>(e), target);
  }
}

namespace {

/// A place of a line that lay still: a Gauss point, or where a roller pushed.
struct PassedPoint {
  double from_top = 0.0;  ///< [m]
  double z = 0.0;         ///< Of the middle of its element [m].
  Vec3 tangent, curvature;
  std::size_t index = 0;            ///< Of the Gauss point, or of the nearest one in the element.
  std::optional<Vec3> moment = {};  ///< Under a roller, in place of the curvature; as the vector E I k [N m].
  double EI = 0.0;                  ///< Of that element [N m2].
  bool bends = true;                ///< False for the Gauss points of an element with rollers: see RollerPush.
};

/// Moment under a roller: the linear course of the moments at the Gauss points and what the loads within add.
Vec3 moment_under(const BentLine& line, const PassedElement& element, std::span<const RollerPush> pushes,
                  const RollerPush& push) {
  Vec3 moment = moment_within(element, pushes, push.xi);
  for (int i = 0; i < kGaussPoints; ++i) {
    const CentrelinePoint there = point_at(element.q, gauss_shape(i, element.length));
    Vec3 at_point = push.EI * curvature_vector(there);
    if (!line.memory.empty()) {
      const BendingMemory& memory = line.memory[kGaussPoints * element.index + static_cast<std::size_t>(i)];
      at_point -= from_axes(memory, memory.held);
    }
    moment += linear_weight(i, push.xi) * at_point;
  }
  return moment;
}

int nearest_gauss_point(double xi) {
  const auto off = [xi](int i) { return std::abs(kGaussXi[i] - xi); };
  int nearest = 0;
  for (int i = 1; i < kGaussPoints; ++i) nearest = off(i) < off(nearest) ? i : nearest;
  return nearest;
}

/// From the top down.
std::vector<PassedPoint> points_passed(const BentLine& line) {
  std::vector<PassedPoint> points;
  auto push = line.pushes.begin();
  for (std::size_t e = line.mesh.length.size(); e-- > 0;) {
    const double h = line.mesh.length[e], z = 0.5 * (line.q[6 * e + 2] + line.q[6 * e + 8]);
    const PassedElement element{e, nullptr, {}, z, dofs({line.q.data(), nullptr}, e), h};
    const auto end = std::find_if(
        push, line.pushes.end(), [e](const RollerPush& other) { return static_cast<std::size_t>(other.element) != e; });
    const std::span<const RollerPush> pushes(push, end);
    const auto add = [&](double xi, const CentrelinePoint& there, int gauss_point) -> PassedPoint& {
      points.push_back({line.mesh.total_length() - line.mesh.s[e] - xi * h, z, there.a.normalized(),
                        curvature_vector(there), kGaussPoints * e + static_cast<std::size_t>(gauss_point)});
      return points.back();
    };
    const auto add_pushes_down_to = [&](double xi) {
      for (; push != end && push->xi > xi; ++push) {
        PassedPoint& point = add(push->xi, centreline(element.q, push->xi, h), nearest_gauss_point(push->xi));
        point.moment = moment_under(line, element, pushes, *push);
        point.EI = push->EI;
      }
    };
    for (int i = kGaussPoints - 1; i >= 0; --i) {
      add_pushes_down_to(kGaussXi[i]);
      add(kGaussXi[i], point_at(element.q, gauss_shape(i, h)), i).bends = pushes.empty();
    }
    add_pushes_down_to(-1.0);
  }
  return points;
}

/// Index of the point nearest to a distance from the top.
std::size_t nearest_point(const std::vector<PassedPoint>& points, double from_top) {
  const auto after = std::lower_bound(points.begin(), points.end(), from_top,
                                      [](const PassedPoint& a, double u) { return a.from_top < u; });
  const std::size_t i = static_cast<std::size_t>(after - points.begin());
  if (i == points.size()) return i - 1;
  return i > 0 && from_top - points[i - 1].from_top < points[i].from_top - from_top ? i - 1 : i;
}

void pass(const BendingLaw& law, const PassedPoint& point, BendingMemory& memory) {
  bring_along(memory, point.tangent);
  if (!point.bends) return;
  const LevelMix mix = level_at(law, point.z);
  if (point.moment) {
    curvature_for(law, mix, point.EI, in_axes(memory, *point.moment), memory);
  } else {
    bend(law, mix, in_axes(memory, point.curvature), memory);
  }
}

}  // namespace

std::vector<BendingMemory> moved_along(const BentLine& before, double shift, const YieldingElements& elements,
                                       const LineMesh& mesh) {
  const std::vector<PassedPoint> points = points_passed(before);
  std::vector<BendingMemory> moved(kGaussPoints * elements.law.size());
  for (std::size_t e = 0; e < elements.law.size(); ++e) {
    for (int i = 0; i < kGaussPoints; ++i) {
      BendingMemory& memory = moved[kGaussPoints * e + static_cast<std::size_t>(i)];
      const double to = mesh.total_length() - (mesh.s[e] + kGaussXi[i] * mesh.length[e]);
      const double from = to - shift;
      const std::size_t end = nearest_point(points, to);
      std::size_t at = nearest_point(points, std::max(from, 0.0));
      const bool known = from >= 0.0 && !before.memory.empty();
      memory = known ? before.memory[points[at].index] : fresh_memory(points[at].tangent);
      if (elements.law[e] == nullptr) continue;
      while (at != end) {
        at = at < end ? at + 1 : at - 1;
        pass(*elements.law[e], points[at], memory);
      }
    }
  }
  return moved;
}

}  // namespace overbend
