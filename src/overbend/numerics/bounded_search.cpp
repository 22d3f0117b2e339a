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

constexpr double kEqualWeight = 1e4;   // of linearised equalities against the aim, in the least squares of a step
constexpr double kDamping = 1e-4;      // keeps directions short that nothing depends on
constexpr double kPenalty = 100.0;     // of violations in the merit
constexpr double kFirstReach = 0.3;    // of the first step, in every unknown
constexpr double kShortest = 1e-6;     // step that is worth taking for the aim, or to shorten one to
constexpr double kActive = 1e-3;       // below it a condition counts as one that holds back
constexpr double kPeak = 0.3;          // of the largest value of an aim: lower ones do not bound a step
constexpr double kLevelWeight = 0.03;  // of the largest value as an unknown: its curvature, against a slope of 1

class Search {
 public:
  explicit Search(const SearchProblem& problem)
      : problem_(problem), n_(problem.start.size()), curvature_(MatrixXd::Identity(n_, n_)) {}

  std::optional<SearchEnd> run() {
    x_ = problem_.start.cwiseMax(0.0).cwiseMin(1.0);
    const std::optional<SearchValues> first = problem_.values(x_);
    if (!first) return std::nullopt;
    now_ = *first;
    SearchEnd end;
    for (; end.steps < problem_.steps && !end.settled; ++end.steps) {
      if (nothing_to_gain()) {
        end.settled = true;
        break;
      }
      end.settled = !advance();
    }
    end.x = x_;
    end.values = now_;
    end.violation = violation_of(now_);
    end.met = end.violation <= problem_.tolerance;
    return end;
  }

 private:
  bool nothing_to_gain() const { return violation_of(now_) <= problem_.tolerance && now_.aim.size() == 0; }

  double aim_of(const SearchValues& v) const {
    if (v.aim.size() == 0) return 0.0;
    return problem_.linear_aim ? v.aim.maxCoeff() : v.aim.squaredNorm();
  }

  /// The largest of several values is what counts.
  bool levels() const { return problem_.linear_aim && now_.aim.size() > 1; }

  Index largest() const {
    Index row = 0;
    now_.aim.maxCoeff(&row);
    return row;
  }

  /// Values that are not below their neighbours, and not small.
  std::vector<Index> peaks() const {
    std::vector<Index> found;
    const VectorXd& aim = now_.aim;
    for (Index i = 0; i < aim.size(); ++i) {
      const bool peak = (i == 0 || aim(i) >= aim(i - 1)) && (i + 1 == aim.size() || aim(i) >= aim(i + 1));
      if (peak && aim(i) >= kPeak * aim.maxCoeff()) found.push_back(i);
    }
    return found;
  }

  double merit(const SearchValues& v) const {
    return aim_of(v) + kPenalty * (v.equal.cwiseAbs().sum() + (-v.least).cwiseMax(0.0).sum());
  }

  /// The next bound of a step to try; none where it is not worth it.
  static std::optional<double> shorter(double reach) {
    return 0.4 * reach > kShortest ? std::optional(0.4 * reach) : std::nullopt;
  }

  /// One step; false where there is none that is worth taking.
  bool advance() {
    const SearchSlopes slopes = problem_.slopes(x_, now_);
    if (problem_.linear_aim && now_.aim.size() > 0) learn_curvature(slopes);
    const double before = merit(now_), aim_before = aim_of(now_), violated = violation_of(now_);
    for (std::optional<double> next = reach_; next; next = shorter(*next)) {
      const double reach = *next;
      const VectorXd step = step_within(slopes, now_, reach);
      // The last steps of Newton's method towards a condition are short.
      if (step.cwiseAbs().maxCoeff() < kShortest) return violated > problem_.tolerance && take(step, before);
      if (!take(step, before) && !take_corrected(slopes, step, reach, before)) continue;
      const double length = (x_ - from_).cwiseAbs().maxCoeff();
      // Farther only where the model proved right up to its bound.
      reach_ = reach < reach_ ? reach : length > 0.9 * reach ? 2.0 * reach : reach;
      if (violation_of(now_) > problem_.tolerance || violated > problem_.tolerance) return true;
      const double gain = aim_before - aim_of(now_);
      small_gains_ = gain < problem_.settled * std::max(std::abs(aim_before), 1e-12) ? small_gains_ + 1 : 0;
      return small_gains_ < 2 && length > problem_.settled;
    }
    return false;
  }

  bool take(const VectorXd& step, double before) {
    const VectorXd there = (x_ + step).cwiseMax(0.0).cwiseMin(1.0);
    tried_ = problem_.values(there);
    if (!tried_ || merit(*tried_) >= before) return false;
    from_ = x_;
    x_ = there;
    now_ = *tried_;
    return true;
  }

  /// Conditions that curve away spoil a good step: the second-order correction meets them where the step has led.
  bool take_corrected(const SearchSlopes& slopes, const VectorXd& step, double reach, double before) {
    if (!tried_ || violation_of(*tried_) <= problem_.tolerance) return false;
    SearchValues there = now_;
    there.equal = tried_->equal - slopes.equal * step;
    there.least = tried_->least - slopes.least * step;
    return take(step_within(slopes, there, reach), before);
  }

  /// What holds back the aim: conditions, and values that are as large as the largest, which it may not exceed.
  MatrixXd holding(const SearchSlopes& slopes, Index row, const std::vector<Index>& equals) const {
    MatrixXd columns(n_, slopes.equal.rows() + slopes.least.rows() + static_cast<Index>(equals.size()));
    MatrixXd ties(n_, static_cast<Index>(equals.size()));
    for (std::size_t k = 0; k < equals.size(); ++k) {
      ties.col(static_cast<Index>(k)) = (slopes.aim.row(row) - slopes.aim.row(equals[k])).transpose();
    }
    columns << slopes.equal.transpose(), slopes.least.transpose(), ties;
    for (Index k = 0; k < slopes.least.rows(); ++k) {
      if (now_.least(k) > kActive) columns.col(slopes.equal.rows() + k).setZero();
    }
    return columns;
  }

  /// The aim's gradient less what conditions hold back of it; by least squares with the multipliers of these slopes.
  VectorXd change_of_lagrangian(const SearchSlopes& slopes) const {
    const Index row = largest();
    std::vector<Index> equals;
    if (levels()) {
      for (const Index peak : peaks()) {
        if (peak != row && now_.aim(peak) > now_.aim(row) - kActive) equals.push_back(peak);
      }
    }
    const MatrixXd here = holding(slopes, row, equals), before = holding(last_slopes_, row, equals);
    VectorXd change = (slopes.aim.row(row) - last_slopes_.aim.row(row)).transpose();
    if (here.cols() == 0) return change;
    return change - (here - before) * shortest_least_squares(here, slopes.aim.row(row).transpose());
  }

  /// Powell's damped update by the gradient of the Lagrangian, so that the model stays convex.
  void learn_curvature(const SearchSlopes& slopes) {
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
      curvature_ = MatrixXd::Identity(n_, n_) * std::max(slopes.aim.row(largest()).norm(), 1e-6);
    }
    last_slopes_ = slopes;
    last_x_ = x_;
  }

  /// Rows whose sum of squares is the model of the aim: |A p - b|.
  void aim_rows(const SearchSlopes& slopes, MatrixXd& rows, VectorXd& wanted) const {
    if (now_.aim.size() == 0) {
      rows = MatrixXd::Identity(n_, n_);
      wanted = VectorXd::Zero(n_);
    } else if (problem_.linear_aim) {
      rows = upper_root(curvature_);
      wanted = -rows.transpose().triangularView<Eigen::Lower>().solve(VectorXd(slopes.aim.row(0).transpose()));
    } else {
      rows.resize(slopes.aim.rows() + n_, n_);
      rows << slopes.aim, kDamping * slopes.aim.norm() * MatrixXd::Identity(n_, n_);
      wanted = VectorXd::Zero(rows.rows());
      wanted.head(now_.aim.size()) = -now_.aim;
    }
  }

  /// The step of several values, the largest of which is a further unknown: none of them exceeds it.
  VectorXd level_step(const SearchSlopes& slopes, const SearchValues& at, double reach) const {
    const std::vector<Index> tops = peaks();
    const auto count = static_cast<Index>(tops.size());
    const MatrixXd root = upper_root(curvature_);
    // The slope of the largest value, 1, pulls at the equalities: they have to hold far closer than the tolerance.
    const double weight = kEqualWeight * std::max(root.norm(), 1.0) / std::clamp(slopes.equal.norm(), 1e-12, 1.0);
    MatrixXd rows = MatrixXd::Zero(n_ + 1 + slopes.equal.rows(), n_ + 2);
    rows.topLeftCorner(n_, n_) = root;
    rows(n_, n_) = kLevelWeight;
    rows(n_, n_ + 1) = -1.0 / kLevelWeight;
    rows.bottomLeftCorner(slopes.equal.rows(), n_) = weight * slopes.equal;
    rows.bottomRightCorner(slopes.equal.rows(), 1) = -weight * at.equal;
    const MatrixXd reduced = triangle_of(rows).topRows(n_ + 1);
    MatrixXd c = MatrixXd::Zero(2 * n_ + slopes.least.rows() + count, n_ + 1);
    c.topLeftCorner(n_, n_).setIdentity();
    c.block(n_, 0, n_, n_) = -MatrixXd::Identity(n_, n_);
    c.block(2 * n_, 0, slopes.least.rows(), n_) = slopes.least;
    VectorXd d(c.rows());
    d.head(2 * n_ + slopes.least.rows()) << (-x_).cwiseMax(-reach), (x_.array() - 1.0).matrix().cwiseMax(-reach),
        -at.least;
    for (Index k = 0; k < count; ++k) {
      const Index row = 2 * n_ + slopes.least.rows() + k, peak = tops[static_cast<std::size_t>(k)];
      c.row(row).head(n_) = -slopes.aim.row(peak);
      c(row, n_) = 1.0;
      d(row) = at.aim(peak) - at.aim.maxCoeff();
    }
    return inequality_least_squares(reduced.leftCols(n_ + 1), reduced.col(n_ + 1), c, d)
        .head(n_)
        .cwiseMax(-reach)
        .cwiseMin(reach);
  }

  /// `at`: the values that the slopes are taken to belong to.
  VectorXd step_within(const SearchSlopes& slopes, const SearchValues& at, double reach) const {
    if (levels()) return level_step(slopes, at, reach);
    MatrixXd aim;
    VectorXd wanted;
    aim_rows(slopes, aim, wanted);
    const double weight = kEqualWeight * std::max(aim.norm(), 1e-12) / std::max(slopes.equal.norm(), 1e-12);
    MatrixXd rows(aim.rows() + slopes.equal.rows(), n_ + 1);
    rows << aim, wanted, weight * slopes.equal, -weight * at.equal;
    const MatrixXd reduced = triangle_of(rows).topRows(n_);
    const MatrixXd r = reduced.leftCols(n_);
    const VectorXd b = reduced.col(n_);
    MatrixXd c(2 * n_ + slopes.least.rows(), n_);
    c << MatrixXd::Identity(n_, n_), -MatrixXd::Identity(n_, n_), slopes.least;
    VectorXd d(c.rows());
    d << (-x_).cwiseMax(-reach), (x_.array() - 1.0).matrix().cwiseMax(-reach), -at.least;
    return inequality_least_squares(r, b, c, d).cwiseMax(-reach).cwiseMin(reach);
  }

  const SearchProblem& problem_;
  Index n_;
  MatrixXd curvature_;
  VectorXd x_, from_, last_x_;
  SearchSlopes last_slopes_;
  std::optional<SearchValues> tried_;
  SearchValues now_;
  double reach_ = kFirstReach;
  int small_gains_ = 0;
};

}  // namespace

double violation_of(const SearchValues& v) {
  double worst = 0.0;
  if (v.equal.size() > 0) worst = v.equal.cwiseAbs().maxCoeff();
  if (v.least.size() > 0) worst = std::max(worst, -v.least.minCoeff());
  return worst;
}

std::optional<SearchEnd> bounded_search(const SearchProblem& problem) {
  return Search(problem).run();
}

}  // namespace overbend
