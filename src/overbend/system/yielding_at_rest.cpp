// Plasticity in statics: pipe passes the supports from the tensioner down.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "base/ranges.h"
#include "system/yielding_element.h"

namespace overbend {
namespace {

/// Initial state of the pipe of each law.
void set_out(const YieldingElements& elements, std::vector<PassingPipe>& passing) {
  passing.clear();
  for (std::size_t e = 0; e < elements.law.size(); ++e) {
    const BendingLaw* law = elements.law[e];
    const auto same = [&](const PassingPipe& pipe) { return pipe.law == law; };
    if (law != nullptr && ranges::none_of(passing, same)) passing.push_back({law, e});
  }
}

/// Memory of the pipe as it arrives at a position with its previous bending.
BendingMemory& arrive(PassingPipe& pipe, const Vec3& tangent) {
  if (pipe.begun) {
    transport_axes(pipe.memory, tangent);
  } else {
    pipe.memory = make_bending_memory(tangent);
    pipe.begun = true;
  }
  return pipe.memory;
}

/// An element of a line at rest that the pipe passes.
struct PassedElement {
  std::size_t index = 0;
  const BendingLaw* law = nullptr;  ///< Law of the pipe that lies there; null for linear steel.
  LevelMix mix;
  double z = 0.0;  ///< Height of its middle [m].
  ElementVector q;
  double length = 0.0;  ///< [m]
};

/// Moments below are vectors E I k, with k the curvature vector [N m].

/// Moment at `xi` from loads within an element, in excess of the linear distribution known to its nodes: that of a beam
/// clamped at both ends, which has no linear part for any material.
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

/// Weight of a Gauss point in the linear fit (least squares) of the moments at `xi`.
double linear_weight(int point, double xi) {
  return kGaussWeight[point] * (1.0 + 3.0 * (2.0 * xi - 1.0) * (2.0 * kGaussXi[point] - 1.0));
}

/// The pipe that lies in an element with rollers, as it arrives and as it is bent there.
class LyingPipe {
 public:
  LyingPipe(const PassedElement& element, double share) : element_(element), share_(share) {}

  /// Moment at a Gauss point of a pipe with a memory.
  Vec3 moment_at(int point, BendingMemory memory, double EI) const {
    const CentrelinePoint centre_point = point_at(element_.q, gauss_shape(point, element_.length));
    transport_axes(memory, centre_point.a.normalized());
    return moment(curvature_vector(centre_point), memory, EI).first;
  }

  /// Moment of a pipe bent to a curvature, and its derivative across the pipe; the memory is updated.
  std::pair<Vec3, Mat2> moment(const Vec3& curvature, BendingMemory& memory, double EI) const {
    const Vec2 k = in_axes(memory, curvature);
    const BendingResponse answer = bend(*element_.law, element_.mix, k, memory);
    return {from_axes(memory, EI * k - share_ * answer.plastic_moment),
            EI * Mat2::Identity() - share_ * answer.plastic_tangent};
  }

  /// Curvature under a roller: its moment by the law balances the element, from the linear fit of the moments at its
  /// Gauss points and the loads within it. Points below the roller have passed it. `memory`: of the pipe as it arrives
  /// at the roller.
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
      // More bending under the roller reduces the points below equally, which unload elastically.
      const Mat2 change = slope + std::max(weight_below, 0.0) * (push.EI * Mat2::Identity() - slope);
      const Vec2 step = change.inverse() * in_axes(memory, wanted - moment_there);
      curvature += from_axes(memory, step);
      if (step.norm() < kTolerance * element_.law->limit[0]) break;
    }
    return curvature;
  }

 private:
  const PassedElement& element_;
  double share_;  ///< Factor on the plastic moments.
};

/// Pipe of every law on its way from the tensioner down the line.
class PassingPipes {
 public:
  PassingPipes(const YieldingElements& elements, const StaticYield& how, std::vector<PassingPipe>& pipes)
      : elements_(elements), how_(how), pipes_(pipes) {}

  /// Bends all pipes to the curvature of a Gauss point. Returns the memory of the pipe that lies there, as it arrives,
  /// or null.
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

  /// Returns the memory of the pipe that lies there as it arrives, for a point that bends no other pipe.
  BendingMemory* look(const PassedElement& element, const Vec3& tangent) {
    BendingMemory* lying = nullptr;
    for_each(element, tangent, [&](const PassingPipe& pipe, BendingMemory& memory) {
      if (pipe.law == element.law) lying = &memory;
    });
    return lying;
  }

  /// Bends all pipes to the curvature under a roller of the pipe that lies there; `pushes`: all of the element.
  void pass_peak(const PassedElement& element, std::span<const RollerPush> pushes, const RollerPush& push) {
    const CentrelinePoint centre_point = centreline(element.q, push.xi, element.length);
    const Vec3 tangent = centre_point.a.normalized();
    const BendingMemory* lying = look(element, tangent);
    const Vec3 curvature = lying != nullptr
                               ? LyingPipe(element, how_.share).curvature_under(pushes, push, *lying)
                               : curvature_vector(centre_point) + moment_within(element, pushes, push.xi) / push.EI;
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
  BendingMemory fresh;
  auto push = how.pushes.begin();
  for (std::size_t e = count; e-- > 0;) {
    const BendingLaw* law = elements.law[e];
    const PassedElement element{e,          law,           elements.mix[e], 0.5 * (q.q[6 * e + 2] + q.q[6 * e + 8]),
                                dofs(q, e), mesh.length[e]};
    const auto end = std::find_if(push, how.pushes.end(), [e](const RollerPush& candidate) {
      return static_cast<std::size_t>(candidate.element) != e;
    });
    const std::span pushes(std::to_address(push), static_cast<std::size_t>(laying ? end - push : 0));
    const auto pass_peaks_down_to = [&](double xi) {
      for (; push != end && push->xi > xi; ++push) {
        if (laying) pipes.pass_peak(element, pushes, *push);
      }
    };
    ElementSum sum(target.tangent != nullptr);
    for (int i = kGaussPoints - 1; i >= 0; --i) {
      pass_peaks_down_to(kGaussXi[i]);
      const HermiteValues shape = gauss_shape(i, mesh.length[e]);
      const CentrelinePoint centre_point = point_at(element.q, shape);
      const Vec3 tangent = centre_point.a.normalized(), curvature = curvature_vector(centre_point);
      const std::size_t index = kGaussPoints * e + static_cast<std::size_t>(i);
      BendingMemory* memory = pushes.empty() ? pipes.pass(element, tangent, curvature) : pipes.look(element, tangent);
      if (!pushes.empty() && memory != nullptr) {
        fresh = *memory;
        memory = &fresh;
      }
      if (memory == nullptr && (law != nullptr || keep_memory)) {  // it did not come here from the tensioner
        fresh = how.before != nullptr ? how.before[index] : make_bending_memory(tangent);
        transport_axes(fresh, tangent);
        memory = &fresh;
      }
      if (law != nullptr) {
        BendingResponse answer = bend(*law, elements.mix[e], in_axes(*memory, curvature), *memory);
        answer.plastic_moment *= how.share;
        answer.plastic_tangent *= how.share;
        sum.add(shape, centre_point, kGaussWeight[i] * mesh.length[e], *memory, answer, points.plastic_moment[index]);
      }
      if (keep_memory) points.memory[index] = *memory;
    }
    pass_peaks_down_to(-1.0);
    sum.scatter_to(static_cast<int>(e), target);
  }
}

namespace {

/// A position of a line in its previous configuration: a Gauss point or a roller.
struct PassedPoint {
  double from_top = 0.0;  ///< [m]
  double z = 0.0;         ///< Height of the middle of its element [m].
  Vec3 tangent, curvature;
  std::size_t index = 0;            ///< Index of the Gauss point, or of the nearest one in the element.
  std::optional<Vec3> moment = {};  ///< Under a roller, in place of the curvature; as the vector E I k [N m].
  double EI = 0.0;                  ///< Bending stiffness of that element [N m2].
  bool bends = true;                ///< False for the Gauss points of an element with rollers: see RollerPush.
};

/// Moment under a roller: the linear fit of the moments at the Gauss points plus the loads within the element.
Vec3 moment_under(const BentLine& line, const PassedElement& element, std::span<const RollerPush> pushes,
                  const RollerPush& push) {
  Vec3 moment = moment_within(element, pushes, push.xi);
  for (int i = 0; i < kGaussPoints; ++i) {
    const CentrelinePoint centre_point = point_at(element.q, gauss_shape(i, element.length));
    Vec3 at_point = push.EI * curvature_vector(centre_point);
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

/// Returns the positions from the top down.
std::vector<PassedPoint> points_passed(const BentLine& line) {
  std::vector<PassedPoint> points;
  auto push = line.pushes.begin();
  for (std::size_t e = line.mesh.length.size(); e-- > 0;) {
    const double h = line.mesh.length[e], z = 0.5 * (line.q[6 * e + 2] + line.q[6 * e + 8]);
    const PassedElement element{e, nullptr, {}, z, dofs({line.q.data(), nullptr}, e), h};
    const auto end = std::find_if(push, line.pushes.end(), [e](const RollerPush& candidate) {
      return static_cast<std::size_t>(candidate.element) != e;
    });
    const std::span pushes(std::to_address(push), static_cast<std::size_t>(end - push));
    const auto add = [&](double xi, const CentrelinePoint& centre_point, int gauss_point) -> PassedPoint& {
      points.push_back({line.mesh.total_length() - line.mesh.s[e] - xi * h, z, centre_point.a.normalized(),
                        curvature_vector(centre_point), kGaussPoints * e + static_cast<std::size_t>(gauss_point)});
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
  transport_axes(memory, point.tangent);
  if (!point.bends) return;
  const LevelMix mix = level_at(law, point.z);
  if (point.moment) {
    find_curvature(law, mix, point.EI, in_axes(memory, *point.moment), memory);
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
      std::size_t index = nearest_point(points, std::max(from, 0.0));
      const bool known = from >= 0.0 && !before.memory.empty();
      memory = known ? before.memory[points[index].index] : make_bending_memory(points[index].tangent);
      if (elements.law[e] == nullptr) continue;
      while (index != end) {
        index = index < end ? index + 1 : index - 1;
        pass(*elements.law[e], points[index], memory);
      }
    }
  }
  return moved;
}

}  // namespace overbend
