#include "numerics/bounded_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/dense_algebra.h"
#include "numerics/constrained_least_squares.h"

namespace overbend {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// weight of linearised equalities relative to the objective, in the least squares of a step
constexpr double kEqualWeight = 1e4;
constexpr double kDamping = 1e-4;        // limits steps in directions without influence
constexpr double kPenalty = 100.0;       // weight of violations in the merit function
constexpr double kFirstReach = 0.3;      // trust region of the first step, in every unknown
constexpr double kMinStepLength = 1e-6;  // minimum step worth taking for the objective, and lower limit of shortening
constexpr double kActive = 1e-3;         // constraints below this value count as active
constexpr double kPeak = 0.3;            // fraction of the maximum objective value: lower peaks do not bound a step
constexpr double kLevelWeight = 0.03;    // weight of the maximum as an unknown: its curvature, relative to a slope of 1

class Search {
 public:
  explicit Search(const SearchProblem& problem)
      : problem_(problem), n_(problem.start.size()), curvature_(MatrixXd::Identity(n_, n_)) {}

  std::optional<SearchResult> run() {
    x_ = problem_.start.cwiseMax(0.0).cwiseMin(1.0);
    const std::optional<SearchValues> first = problem_.values(x_);
    if (!first) return std::nullopt;
    current_ = *first;
    SearchResult end;
    for (; end.steps < problem_.steps && !end.settled; ++end.steps) {
      if (nothing_to_gain()) {
        end.settled = true;
        break;
      }
      end.settled = !advance();
    }
    end.x = x_;
    end.values = current_;
    end.violation = compute_violation(current_);
    end.met = end.violation <= problem_.tolerance;
    return end;
  }

 private:
  bool nothing_to_gain() const {
    return compute_violation(current_) <= problem_.tolerance && current_.objective.size() == 0;
  }

  double objective_value(const SearchValues& v) const {
    if (v.objective.size() == 0) return 0.0;
    return problem_.linear_objective ? v.objective.maxCoeff() : v.objective.squaredNorm();
  }

  /// True if the maximum of several values is minimised.
  bool levels() const { return problem_.linear_objective && current_.objective.size() > 1; }

  Index max_index() const {
    Index row = 0;
    current_.objective.maxCoeff(&row);
    return row;
  }

  /// Indices of values that are not below their neighbours and not small.
  std::vector<Index> peaks() const {
    std::vector<Index> found;
    const VectorXd& objective = current_.objective;
    for (Index i = 0; i < objective.size(); ++i) {
      const bool peak = (i == 0 || objective(i) >= objective(i - 1)) &&
                        (i + 1 == objective.size() || objective(i) >= objective(i + 1));
      if (peak && objective(i) >= kPeak * objective.maxCoeff()) found.push_back(i);
    }
    return found;
  }

  double merit(const SearchValues& v) const {
    return objective_value(v) + kPenalty * (v.equal.cwiseAbs().sum() + (-v.inequality).cwiseMax(0.0).sum());
  }

  /// Returns the next trust region to try; nothing if it is too small.
  static std::optional<double> shorter(double reach) {
    return 0.4 * reach > kMinStepLength ? std::optional(0.4 * reach) : std::nullopt;
  }

  /// Makes one step. Returns false if no worthwhile step exists.
  bool advance() {
    const SearchSlopes slopes = problem_.slopes(x_, current_);
    if (problem_.linear_objective && current_.objective.size() > 0) update_curvature(slopes);
    const double before = merit(current_), aim_before = objective_value(current_),
                 violated = compute_violation(current_);
    for (std::optional<double> next = reach_; next; next = shorter(*next)) {
      const double reach = *next;
      const VectorXd step = step_within(slopes, current_, reach);
      // Steps of Newton's method close to a constraint are short.
      if (step.cwiseAbs().maxCoeff() < kMinStepLength) return violated > problem_.tolerance && take(step, before);
      if (!take(step, before) && !take_corrected(slopes, step, reach, before)) continue;
      const double length = (x_ - from_).cwiseAbs().maxCoeff();
      // Enlarges the trust region only if the model was right up to its bound.
      reach_ = reach < reach_ ? reach : length > 0.9 * reach ? 2.0 * reach : reach;
      if (compute_violation(current_) > problem_.tolerance || violated > problem_.tolerance) return true;
      const double gain = aim_before - objective_value(current_);
      small_gains_ = gain < problem_.settled * std::max(std::abs(aim_before), 1e-12) ? small_gains_ + 1 : 0;
      return small_gains_ < 2 && length > problem_.settled;
    }
    return false;
  }

  bool take(const VectorXd& step, double before) {
    const VectorXd trial_point = (x_ + step).cwiseMax(0.0).cwiseMin(1.0);
    tried_ = problem_.values(trial_point);
    if (!tried_ || merit(*tried_) >= before) return false;
    from_ = x_;
    x_ = trial_point;
    current_ = *tried_;
    return true;
  }

  /// Second-order correction: curved constraints are evaluated at the end of the step and corrected there.
  bool take_corrected(const SearchSlopes& slopes, const VectorXd& step, double reach, double before) {
    if (!tried_ || compute_violation(*tried_) <= problem_.tolerance) return false;
    SearchValues trial = current_;
    trial.equal = tried_->equal - slopes.equal * step;
    trial.inequality = tried_->inequality - slopes.inequality * step;
    return take(step_within(slopes, trial, reach), before);
  }

  /// Active constraints and values equal to the maximum, which they must not exceed.
  MatrixXd holding(const SearchSlopes& slopes, Index row, const std::vector<Index>& equals) const {
    MatrixXd columns(n_, slopes.equal.rows() + slopes.inequality.rows() + static_cast<Index>(equals.size()));
    MatrixXd ties(n_, static_cast<Index>(equals.size()));
    for (std::size_t k = 0; k < equals.size(); ++k) {
      ties.col(static_cast<Index>(k)) = (slopes.objective.row(row) - slopes.objective.row(equals[k])).transpose();
    }
    columns << slopes.equal.transpose(), slopes.inequality.transpose(), ties;
    for (Index k = 0; k < slopes.inequality.rows(); ++k) {
      if (current_.inequality(k) > kActive) columns.col(slopes.equal.rows() + k).setZero();
    }
    return columns;
  }

  /// Returns the gradient of the objective minus the part balanced by constraints; least-squares multipliers of these
  /// slopes.
  VectorXd change_of_lagrangian(const SearchSlopes& slopes) const {
    const Index row = max_index();
    std::vector<Index> equals;
    if (levels()) {
      for (const Index peak : peaks()) {
        if (peak != row && current_.objective(peak) > current_.objective(row) - kActive) equals.push_back(peak);
      }
    }
    const MatrixXd current = holding(slopes, row, equals), before = holding(last_slopes_, row, equals);
    VectorXd change = (slopes.objective.row(row) - last_slopes_.objective.row(row)).transpose();
    if (current.cols() == 0) return change;
    return change - (current - before) * min_norm_solution(current, slopes.objective.row(row).transpose());
  }

  /// Powell's damped update with the gradient of the Lagrangian, so that the model stays convex.
  void update_curvature(const SearchSlopes& slopes) {
    if (last_x_.size() == n_) {
      const VectorXd s = x_ - last_x_, y = change_of_lagrangian(slopes);
      const VectorXd bs = curvature_ * s;
      const double sbs = s.dot(bs), sy = s.dot(y);
      if (sbs > 1e-16) {
        const double theta = sy >= 0.2 * sbs ? 1.0 : 0.8 * sbs / (sbs - sy);
        const VectorXd r = theta * y + (1.0 - theta) * bs;
        curvature_ += r * r.transpose() / s.dot(r) - bs * bs.transpose() / sbs;
      }
    } else {
      curvature_ = MatrixXd::Identity(n_, n_) * std::max(slopes.objective.row(max_index()).norm(), 1e-6);
    }
    last_slopes_ = slopes;
    last_x_ = x_;
  }

  /// Rows whose sum of squares is the model of the objective: |A p - b|.
  void objective_rows(const SearchSlopes& slopes, MatrixXd& rows, VectorXd& wanted) const {
    if (current_.objective.size() == 0) {
      rows = MatrixXd::Identity(n_, n_);
      wanted = VectorXd::Zero(n_);
    } else if (problem_.linear_objective) {
      rows = upper_root(curvature_);
      wanted = -rows.transpose().triangularView<Eigen::Lower>().solve(VectorXd(slopes.objective.row(0).transpose()));
    } else {
      rows.resize(slopes.objective.rows() + n_, n_);
      rows << slopes.objective, kDamping * slopes.objective.norm() * MatrixXd::Identity(n_, n_);
      wanted = VectorXd::Zero(rows.rows());
      wanted.head(current_.objective.size()) = -current_.objective;
    }
  }

  /// Step for the maximum of several values as an additional unknown, which none of them exceeds.
  VectorXd level_step(const SearchSlopes& slopes, const SearchValues& values, double reach) const {
    const std::vector<Index> tops = peaks();
    const auto count = static_cast<Index>(tops.size());
    const MatrixXd root = upper_root(curvature_);
    // The slope of the maximum, 1, acts against the equalities: they must hold much closer than the tolerance.
    const double weight = kEqualWeight * std::max(root.norm(), 1.0) / std::clamp(slopes.equal.norm(), 1e-12, 1.0);
    MatrixXd rows = MatrixXd::Zero(n_ + 1 + slopes.equal.rows(), n_ + 2);
    rows.topLeftCorner(n_, n_) = root;
    rows(n_, n_) = kLevelWeight;
    rows(n_, n_ + 1) = -1.0 / kLevelWeight;
    rows.bottomLeftCorner(slopes.equal.rows(), n_) = weight * slopes.equal;
    rows.bottomRightCorner(slopes.equal.rows(), 1) = -weight * values.equal;
    const MatrixXd reduced = qr_triangle(rows).topRows(n_ + 1);
    MatrixXd c = MatrixXd::Zero(2 * n_ + slopes.inequality.rows() + count, n_ + 1);
    c.topLeftCorner(n_, n_).setIdentity();
    c.block(n_, 0, n_, n_) = -MatrixXd::Identity(n_, n_);
    c.block(2 * n_, 0, slopes.inequality.rows(), n_) = slopes.inequality;
    VectorXd d(c.rows());
    d.head(2 * n_ + slopes.inequality.rows()) << (-x_).cwiseMax(-reach), (x_.array() - 1.0).matrix().cwiseMax(-reach),
        -values.inequality;
    for (Index k = 0; k < count; ++k) {
      const Index row = 2 * n_ + slopes.inequality.rows() + k, peak = tops[static_cast<std::size_t>(k)];
      c.row(row).head(n_) = -slopes.objective.row(peak);
      c(row, n_) = 1.0;
      d(row) = values.objective(peak) - values.objective.maxCoeff();
    }
    return inequality_least_squares(reduced.leftCols(n_ + 1), reduced.col(n_ + 1), c, d)
        .head(n_)
        .cwiseMax(-reach)
        .cwiseMin(reach);
  }

  /// Returns the step within the trust region `reach`; `values` belong to the slopes.
  VectorXd step_within(const SearchSlopes& slopes, const SearchValues& values, double reach) const {
    if (levels()) return level_step(slopes, values, reach);
    MatrixXd objective;
    VectorXd wanted;
    objective_rows(slopes, objective, wanted);
    const double weight = kEqualWeight * std::max(objective.norm(), 1e-12) / std::max(slopes.equal.norm(), 1e-12);
    MatrixXd rows(objective.rows() + slopes.equal.rows(), n_ + 1);
    rows << objective, wanted, weight * slopes.equal, -weight * values.equal;
    const MatrixXd reduced = qr_triangle(rows).topRows(n_);
    const MatrixXd r = reduced.leftCols(n_);
    const VectorXd b = reduced.col(n_);
    MatrixXd c(2 * n_ + slopes.inequality.rows(), n_);
    c << MatrixXd::Identity(n_, n_), -MatrixXd::Identity(n_, n_), slopes.inequality;
    VectorXd d(c.rows());
    d << (-x_).cwiseMax(-reach), (x_.array() - 1.0).matrix().cwiseMax(-reach), -values.inequality;
    return inequality_least_squares(r, b, c, d).cwiseMax(-reach).cwiseMin(reach);
  }

  const SearchProblem& problem_;
  Index n_;
  MatrixXd curvature_;
  VectorXd x_, from_, last_x_;
  SearchSlopes last_slopes_;
  std::optional<SearchValues> tried_;
  SearchValues current_;
  double reach_ = kFirstReach;
  int small_gains_ = 0;
};

}  // namespace

double compute_violation(const SearchValues& v) {
  double worst = 0.0;
  if (v.equal.size() > 0) worst = v.equal.cwiseAbs().maxCoeff();
  if (v.inequality.size() > 0) worst = std::max(worst, -v.inequality.minCoeff());
  return worst;
}

std::optional<SearchResult> bounded_search(const SearchProblem& problem) {
  return Search(problem).run();
}

}  // namespace overbend
