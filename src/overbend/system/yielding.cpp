#include "system/yielding.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace overbend {
namespace {

/// Unknowns of an element as seen from its first node: derivatives need no more, and the difference keeps digits that
/// positions of hundreds of metres lose.
ElementVector dofs(const LineShape& shape, std::size_t element) {
  ElementVector q(Eigen::Map<const ElementVector>(shape.q + 6 * element));
  q.segment<3>(6) -= q.segment<3>(0).eval();
  if (shape.low != nullptr) {
    const double* low = shape.low + 6 * element;
    q.segment<3>(6) += Vec3(low[6] - low[0], low[7] - low[1], low[8] - low[2]);
  }
  q.segment<3>(0).setZero();
  return q;
}

void scatter(const ElementVector& force, const ElementMatrix& k, int element, const YieldingTarget& target) {
  double* residual = target.residual->data() + 6 * element;
  for (int i = 0; i < 12; ++i) residual[i] += force(i);
  if (target.cuts != nullptr) {
    double* cuts = target.cuts->data() + 6 * element;
    for (int i = 6; i < 12; ++i) cuts[i] += force(i);
    if (element == 0) {  // the cut at the first node is minus what the first element adds
      for (int i = 0; i < 6; ++i) cuts[i] -= force(i);
    }
  }
  if (target.tangent != nullptr) add_element(*target.tangent, element, k);
}

/// Sums up the points of one element.
class ElementSum {
 public:
  explicit ElementSum(bool with_tangent) : with_tangent_(with_tangent) {}

  void add(const HermiteValues& shape, const CentrelinePoint& at, double weight, const BendingMemory& memory,
           const BendingAnswer& answer, Vec3& moment) {
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
    add_plastic_point(shape, at, weight, moment, slides ? &tangent : nullptr, force_,
                      with_tangent_ ? &stiffness_ : nullptr);
  }
  void scatter_to(int element, const YieldingTarget& target) const {
    if (any_) scatter(force_, stiffness_, element, target);
  }

 private:
  /// Not before it is needed: most elements of a line that yields in places stay elastic.
  void clear() {
    any_ = true;
    force_.setZero();
    if (with_tangent_) stiffness_.setZero();
  }

  bool with_tangent_, any_ = false;
  ElementVector force_;
  ElementMatrix stiffness_;
};

/// Derivatives of the Hermite functions at a Gauss point; values are left out.
HermiteValues gauss_shape(int point, double h) {
  static const std::array<HermiteValues, kGaussPoints> unit = {hermite(kGaussXi[0], 1.0), hermite(kGaussXi[1], 1.0),
                                                               hermite(kGaussXi[2], 1.0), hermite(kGaussXi[3], 1.0)};
  const HermiteValues& of = unit[static_cast<std::size_t>(point)];
  const double by_h = 1.0 / h;
  HermiteValues shape;
  shape.first << by_h * of.first(0), of.first(1), by_h * of.first(2), of.first(3);
  shape.second << by_h * by_h * of.second(0), by_h * of.second(1), by_h * by_h * of.second(2), by_h * of.second(3);
  return shape;
}

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

/// Derivatives of the centreline there.
CentrelinePoint point_at(const ElementVector& q, const HermiteValues& shape) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 4>> nodes(q.data());
  return {Vec3::Zero(), nodes * shape.first, nodes * shape.second};
}

}  // namespace

YieldingElements yielding_elements(const Model& model, const LineMesh& mesh) {
  YieldingElements elements;
  for (const int section : mesh.section) {
    const Section& of = model.sections[static_cast<std::size_t>(section)];
    elements.law.push_back(of.bending ? &*of.bending : nullptr);
    elements.any = elements.any || of.bending;
    elements.linear_pipe.push_back(!of.bending && of.kind == SectionKind::pipe);
  }
  elements.mix.resize(mesh.section.size());
  return elements;
}

void choose_levels(YieldingElements& elements, const double* q) {
  for (std::size_t e = 0; e < elements.law.size(); ++e) {
    if (elements.law[e] != nullptr) {
      elements.mix[e] = level_at(*elements.law[e], 0.5 * (q[6 * e + 2] + q[6 * e + 8]));
    }
  }
}

std::vector<BendingMemory> fresh_memories(const LineMesh& mesh, const double* q) {
  std::vector<BendingMemory> memories;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    const ElementVector at_nodes = dofs({q, nullptr}, e);
    for (int i = 0; i < kGaussPoints; ++i) {
      memories.push_back(fresh_memory(point_at(at_nodes, gauss_shape(i, mesh.length[e])).a.normalized()));
    }
  }
  return memories;
}

void add_static_yielding(const YieldingElements& elements, const LineMesh& mesh, const StaticYield& how,
                         const LineShape& q, bool keep_memory, StaticYielding& points, const YieldingTarget& target) {
  const std::size_t count = elements.law.size();
  points.plastic_moment.assign(kGaussPoints * count, Vec3::Zero());
  points.memory.resize(keep_memory ? kGaussPoints * count : 0);
  const bool laying = how.before == nullptr && how.history == LayHistory::laying;
  points.passing.clear();
  if (laying) set_out(elements, points.passing);
  BendingMemory own;
  for (std::size_t e = count; e-- > 0;) {
    const BendingLaw* law = elements.law[e];
    const ElementVector at_nodes = dofs(q, e);
    const double z = 0.5 * (q.q[6 * e + 2] + q.q[6 * e + 8]);
    ElementSum sum(target.tangent != nullptr);
    for (int i = kGaussPoints - 1; i >= 0; --i) {
      const HermiteValues shape = gauss_shape(i, mesh.length[e]);
      const CentrelinePoint at = point_at(at_nodes, shape);
      const Vec3 tangent = at.a.normalized(), curvature = curvature_vector(at);
      const std::size_t index = kGaussPoints * e + static_cast<std::size_t>(i);
      BendingMemory* memory = nullptr;
      for (PassingPipe& pipe : points.passing) {
        if (!elements.bends_passing(e) || e < pipe.last) continue;
        BendingMemory& passed = arrive(pipe, tangent);
        if (pipe.law == law) {
          memory = &passed;
        } else {
          bend(*pipe.law, level_at(*pipe.law, z), in_axes(passed, curvature), passed);
        }
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
    sum.scatter_to(static_cast<int>(e), target);
  }
}

namespace {

/// The Gauss points of a line that lay still, from its top down.
struct PassedPoint {
  double from_top = 0.0;  ///< [m]
  double z = 0.0;         ///< Of the middle of its element [m].
  Vec3 tangent, curvature;
  std::size_t index = 0;
};

std::vector<PassedPoint> points_passed(const BentLine& line) {
  std::vector<PassedPoint> points;
  for (std::size_t e = line.mesh.length.size(); e-- > 0;) {
    const ElementVector at_nodes = dofs({line.q.data(), nullptr}, e);
    for (int i = kGaussPoints - 1; i >= 0; --i) {
      const CentrelinePoint at = point_at(at_nodes, gauss_shape(i, line.mesh.length[e]));
      const double s = line.mesh.s[e] + kGaussXi[i] * line.mesh.length[e];
      points.push_back({line.mesh.total_length() - s, 0.5 * (line.q[6 * e + 2] + line.q[6 * e + 8]), at.a.normalized(),
                        curvature_vector(at), kGaussPoints * e + static_cast<std::size_t>(i)});
    }
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

void pass(const BendingLaw& law, const PassedPoint& at, BendingMemory& memory) {
  bring_along(memory, at.tangent);
  bend(law, level_at(law, at.z), in_axes(memory, at.curvature), memory);
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

MovingYielding::MovingYielding(const YieldingElements& elements, const LineMesh& mesh)
    : elements_(&elements), mesh_(&mesh), padded_((elements.law.size() + kLanes - 1) / kLanes * kLanes) {
  if (!elements.any) return;
  left_.resize(kGaussPoints * padded_, 0.0);
  stored_held_.resize(kLanes, 0.0);
  slid_.reserve(kGaussPoints * elements.law.size());
  has_slid_.resize(kGaussPoints * elements.law.size());
}

void MovingYielding::begin(const BendingMemories& before, BendingMemories& after) {
  forget_slid();
  if (!fitted_.empty()) fitted_ = {};
  after.become(before);
  for (std::size_t point = 0; point < before.size(); ++point) {
    const BendingLaw* law = elements_->law[point / kGaussPoints];
    const LevelMix& mix = elements_->mix[point / kGaussPoints];
    if (law == nullptr ? !before.has_slid(point) : before.mix(point) == mix) continue;
    if (fitted_.empty()) fitted_ = before;
    BendingMemory memory = before.at(point);
    if (law == nullptr) {
      memory = fresh_memory(memory.tangent);
    } else {
      bring_to_level(*law, mix, memory);
    }
    fitted_.set(point, memory);
  }
  if (!fitted_.empty()) after.become(fitted_);
}

HeldSections MovingYielding::held(const BendingMemories& before, BendingMemories& after) {
  std::fill(stored_held_.begin(), stored_held_.end(), 0.0);
  return {start(before).held(), after.held(), left_.data(), stored_held_.data()};
}

double MovingYielding::add_sliding(const double* q, const BendingMemories& before, BendingMemories& after,
                                   const YieldingTarget& target) {
  double loss = 0.0;
  stored_sliding_ = 0.0;
  for (std::size_t e = 0; e < elements_->law.size(); ++e) {
    const double* any = left_.data() + e;
    if (elements_->law[e] == nullptr || any[0] + any[padded_] + any[2 * padded_] + any[3 * padded_] == 0.0) continue;
    const ElementVector at_nodes = dofs({q, nullptr}, e);
    ElementSum sum(target.tangent != nullptr);
    for (int i = 0; i < kGaussPoints; ++i) {
      const std::size_t point = kGaussPoints * e + static_cast<std::size_t>(i);
      if (left(point) == 0.0) continue;
      const HermiteValues shape = gauss_shape(i, mesh_->length[e]);
      const CentrelinePoint at = point_at(at_nodes, shape);
      BendingMemory memory = start(before).at(point);
      bring_along(memory, at.a.normalized());
      const Vec2 k = in_axes(memory, curvature_vector(at));
      const BendingAnswer answer = bend(*elements_->law[e], elements_->mix[e], k, memory);
      after.set(point, memory);
      if (!has_slid_[point]) slid_.push_back(point);
      has_slid_[point] = true;
      const double weight = kGaussWeight[i] * mesh_->length[e];
      loss += weight * answer.loss;
      stored_sliding_ += weight * stored_beyond_elastic(k, memory);
      Vec3 moment;
      sum.add(shape, at, weight, memory, answer, moment);
    }
    sum.scatter_to(static_cast<int>(e), target);
  }
  return loss;
}

double MovingYielding::stored() const {
  return std::accumulate(stored_held_.begin(), stored_held_.end(), stored_sliding_);
}

void MovingYielding::finish(const BendingMemories& before, BendingMemories& after) {
  for (const std::size_t point : slid_) {
    if (left(point) != 0.0) continue;
    BendingMemory memory = start(before).at(point);
    const BendingMemory carried = after.at(point);  // by the kernel
    memory.tangent = carried.tangent;
    memory.axis = carried.axis;
    after.set(point, memory);
  }
  forget_slid();
}

void MovingYielding::forget_slid() {
  for (const std::size_t point : slid_) has_slid_[point] = false;
  slid_.clear();
}

void add_element_yielding(const LineMesh& mesh, int element, const LineShape& q, const Vec3* plastic_moment,
                          ElementVector& force) {
  const std::size_t e = static_cast<std::size_t>(element);
  const ElementVector at_nodes = dofs(q, e);
  for (int i = 0; i < kGaussPoints; ++i) {
    const HermiteValues shape = gauss_shape(i, mesh.length[e]);
    add_plastic_point(shape, point_at(at_nodes, shape), kGaussWeight[i] * mesh.length[e], plastic_moment[i], nullptr,
                      force, nullptr);
  }
}

}  // namespace overbend
