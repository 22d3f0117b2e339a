#include <algorithm>

#include "moorings/catenary.h"

namespace overbend {
namespace {

/// Advances along one suspended span and records points that divide every stretch into `count` equal parts.
class SpanSampler {
 public:
  SpanSampler(const CatenaryLine& line, const CatenarySite& site, const CatenarySpan& span, int count,
              std::vector<Eigen::Vector2d>& points)
      : line_(line), site_(site), span_(span), count_(count), points_(points), at_(span.start) {}

  void run() {
    note();
    const double total = std::max(span_length(), 1e-9);
    for (std::size_t i = span_.from.piece; i <= std::min(span_.to.piece, line_.pieces.size() - 1); ++i) {
      const double from = i == span_.from.piece ? span_.from.into.v : 0.0;
      const double to = i == span_.to.piece ? span_.to.into.v : line_.pieces[i].length;
      advance_in_piece(line_.pieces[i], to - from, total);
      if (i < span_.to.piece) pass(i);
    }
  }

 private:
  double span_length() const {
    double sum = span_.to.into.v - span_.from.into.v;
    for (std::size_t i = span_.from.piece; i < span_.to.piece && i < line_.pieces.size(); ++i) {
      sum += line_.pieces[i].length;
    }
    return sum;
  }
  void advance_in_piece(const CatenaryPiece& piece, double length, double total) {
    const int parts = std::max(1, static_cast<int>(count_ * length / total));
    for (int k = 0; k < parts; ++k) {
      double left = length / parts;
      while (left > 0.0) {
        const CatenaryStretch stretch = next_stretch(at_, Dual(left), piece);
        advance_catenary(at_, stretch.length, stretch.weight, piece.EA);
        left -= stretch.length.v;
        if (!stretch.to_surface) break;
        at_.z = 0.0;
        at_.above = !at_.above;
        note();
      }
      note();
    }
  }
  void pass(std::size_t piece) {
    for (const CatenaryPoint& point : line_.points) {
      if (point.behind == piece) at_.sink = at_.sink + pull_up(point, at_.z, site_.bed_at(at_.x));
    }
  }
  void note() { points_.emplace_back(at_.x.v, at_.z.v); }

  const CatenaryLine& line_;
  const CatenarySite& site_;
  const CatenarySpan& span_;
  int count_;
  std::vector<Eigen::Vector2d>& points_;
  CatenaryState at_;
};

}  // namespace

std::vector<Eigen::Vector2d> catenary_shape(const CatenaryLine& line, const CatenarySolution& solution, int count) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < solution.trace.span_count; ++i) {
    SpanSampler(line, solution.trace.site, solution.trace.spans[i], count, points).run();
  }
  if (solution.trace.ends_on_bed) points.emplace_back(solution.trace.end.x.v, solution.trace.end.z.v);
  return points;
}

}  // namespace overbend
