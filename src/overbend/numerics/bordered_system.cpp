#include "numerics/bordered_system.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

struct BorderKernels {
  void (*solve_panel)(const BlockView&, const SparsePanelView&, double*);
  void (*panel_product)(const SparsePanelView&, const double*, double*);
  void (*panel_times_vector)(const SparsePanelView&, const double*, double*);
  void (*subtract_columns)(int, int, const double*, const double*, double*);
};

BorderKernels kernels_for(Isa isa) {
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) {
    return {isa_avx512::solve_panel, isa_avx512::panel_product, isa_avx512::panel_times_vector,
            isa_avx512::subtract_columns};
  }
  if (isa == Isa::avx2) {
    return {isa_avx2::solve_panel, isa_avx2::panel_product, isa_avx2::panel_times_vector, isa_avx2::subtract_columns};
  }
#endif
  (void)isa;
  return {isa_baseline::solve_panel, isa_baseline::panel_product, isa_baseline::panel_times_vector,
          isa_baseline::subtract_columns};
}

std::size_t to_size(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

BorderedSystem::BorderedSystem(const std::vector<BorderedLine>& lines, int unknowns, Isa isa)
    : corner_(to_size(unknowns * unknowns)), held_(to_size(unknowns), 0), schur_(unknowns), isa_(isa) {
  for (const BorderedLine& shape : lines) {
    const int columns = static_cast<int>(shape.unknowns.size());
    const int stride = padded_columns(columns);
    Line line;
    line.blocks.resize(shape.nodes);
    line.unknowns = shape.unknowns;
    line.columns = NodePanels(shape.nodes, columns);
    line.rows = NodePanels(shape.nodes, columns);
    line.solved.assign(to_size(shape.nodes * kNodeDofs * stride), 0.0);
    line.contribution.assign(to_size(stride * stride), 0.0);
    line.touched_y.assign(to_size(stride), 0.0);
    line.touched_cx.assign(to_size(stride), 0.0);
    lines_.push_back(std::move(line));
  }
}

void BorderedSystem::set_zero() {
  for (Line& line : lines_) {
    line.blocks.set_zero();
    line.columns.clear();
    line.rows.clear();
  }
  clear_corner();
}

void BorderedSystem::clear_border(int line) {
  at(line).columns.clear();
  at(line).rows.clear();
}

void BorderedSystem::clear_corner() {
  std::fill(corner_.begin(), corner_.end(), 0.0);
}

void BorderedSystem::hold(int unknown, bool held) {
  held_[to_size(unknown)] = held ? 1 : 0;
}

BlockSolveReport BorderedSystem::factor_line(int line, int first) {
  const BlockSolveReport report = refactor_on(at(line).blocks, first, isa_);
  if (report.solved()) {
    factor_border(line);
  }
  return report;
}

void BorderedSystem::factor_border(int index) {
  Line& line = at(index);
  if (!line.columns.empty()) {
    kernels_for(isa_).solve_panel(make_block_view(line.blocks), line.columns.view(), line.solved.data());
  }
  close_line(line);
}

void BorderedSystem::close_line(Line& line) const {
  if (!line.columns.empty() && !line.rows.empty()) {
    kernels_for(isa_).panel_product(line.rows.view(), line.solved.data(), line.contribution.data());
  } else {
    std::fill(line.contribution.begin(), line.contribution.end(), 0.0);
  }
}

int BorderedSystem::close() {
  const int n = unknowns();
  double* const schur = schur_.matrix();
  double* const terms = schur_.terms();
  for (std::size_t i = 0; i < corner_.size(); ++i) {
    schur[i] = corner_[i];
    terms[i] = std::abs(corner_[i]);
  }
  for (const Line& line : lines_) {
    const int stride = line.columns.stride();
    for (std::size_t i = 0; i < line.unknowns.size(); ++i) {
      for (std::size_t j = 0; j < line.unknowns.size(); ++j) {
        const double part = line.contribution[i * to_size(stride) + j];
        const int entry = line.unknowns[i] * n + line.unknowns[j];
        schur[entry] -= part;
        terms[entry] = std::max(terms[entry], std::abs(part));
      }
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (held_[to_size(i)] != 0 || held_[to_size(j)] != 0) {
        schur[i * n + j] = terms[i * n + j] = i == j ? 1.0 : 0.0;
      }
    }
  }
  return schur_.factor();
}

BorderedReport BorderedSystem::make_line_report(const Line& line, const BlockSolveReport& report,
                                                BorderedReport so_far) const {
  so_far.negative_blocks += report.negative_blocks;
  if (!report.solved()) {
    so_far.singular_line = static_cast<int>(&line - lines_.data());
    so_far.singular_node = report.singular_node;
  }
  return so_far;
}

BorderedReport BorderedSystem::factor() {
  BorderedReport report;
  for (int i = 0; i < lines() && report.solved(); ++i) {
    report = make_line_report(at(i), factor_line(i), report);
  }
  if (report.solved()) {
    report.singular_unknown = close();
    report.negative_border = schur_.sign() < 0;
  }
  return report;
}

void BorderedSystem::solve(std::span<double* const> x, double* y) {
  for (int i = 0; i < lines(); ++i) {
    resolve_on(at(i).blocks, x[to_size(i)], isa_);
  }
  solve_border(x, y);
}

void BorderedSystem::solve_border(std::span<double* const> x, double* y) {
  const BorderKernels kernels = kernels_for(isa_);
  for (int i = 0; i < lines(); ++i) {
    Line& line = at(i);
    if (line.rows.empty()) {
      continue;
    }
    kernels.panel_times_vector(line.rows.view(), x[to_size(i)], line.touched_cx.data());
    for (std::size_t j = 0; j < line.unknowns.size(); ++j) {
      y[line.unknowns[j]] -= line.touched_cx[j];
    }
  }
  for (int i = 0; i < unknowns(); ++i) {
    y[i] = held_[to_size(i)] != 0 ? 0.0 : y[i];
  }
  schur_.solve(y);
  for (int i = 0; i < lines(); ++i) {
    Line& line = at(i);
    if (line.columns.empty()) {
      continue;
    }
    for (std::size_t j = 0; j < line.unknowns.size(); ++j) {
      line.touched_y[j] = y[line.unknowns[j]];
    }
    kernels.subtract_columns(line.blocks.nodes(), line.columns.stride(), line.solved.data(), line.touched_y.data(),
                             x[to_size(i)]);
  }
}

BlockSolveReport BorderedSystem::solve_line(Line& line, double* x) {
  const bool has_single_unknown = line.unknowns.size() == 1 && !line.columns.empty();
  put_right_hand_sides(line, x, has_single_unknown);
  const BlockSolveReport report = solve_on(line.blocks, isa_);
  if (!report.solved()) {
    return report;
  }
  const int stride = line.columns.stride();
  for (int row = 0; row < kNodeDofs * line.blocks.nodes(); ++row) {
    const double* sides = line.blocks.diag(0) + row * kRowWidth + kNodeDofs;
    x[row] = sides[0];
    if (has_single_unknown) {
      line.solved[to_size(row * stride)] = sides[1];
    }
  }
  if (!has_single_unknown && !line.columns.empty()) {
    kernels_for(isa_).solve_panel(make_block_view(line.blocks), line.columns.view(), line.solved.data());
  }
  close_line(line);
  return report;
}

void BorderedSystem::put_right_hand_sides(Line& line, const double* x, bool has_border_column) {
  const SparsePanelView border = line.columns.view();
  for (int node = 0; node < line.blocks.nodes(); ++node) {
    const int slot = has_border_column ? border.slot[node] : -1;
    for (int i = 0; i < kNodeDofs; ++i) {
      line.blocks.rhs(node, i, 0) = x[kNodeDofs * node + i];
      line.blocks.rhs(node, i, 1) = slot < 0 ? 0.0 : border.values[(slot * kNodeDofs + i) * border.stride];
    }
  }
}

BorderedReport BorderedSystem::factor_and_solve(std::span<double* const> x, double* y) {
  BorderedReport report;
  for (int i = 0; i < lines() && report.solved(); ++i) {
    report = make_line_report(at(i), solve_line(at(i), x[to_size(i)]), report);
  }
  if (report.solved()) {
    report.singular_unknown = close();
    report.negative_border = schur_.sign() < 0;
  }
  if (report.solved()) {
    solve_border(x, y);
  }
  return report;
}

}  // namespace overbend
