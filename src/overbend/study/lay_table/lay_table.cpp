#include "study/lay_table/lay_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/shown_unit.h"
#include "base/version.h"
#include "report/studies/lay_table_page.h"
#include "resultfiles/studies/lay_table_writer.h"
#include "runstore/staged_folder.h"
#include "study/lay_table/limit_search.h"
#include "study/stages/stage_choice.h"

namespace overbend {
namespace {

using TableRowCallback = std::function<bool(const LayTableRow&, std::size_t of)>;

/// Calculates the rows of one table.
class TableMaker {
 public:
  TableMaker(const Description& description, const LayTableDescription& asked, TableRowCallback on_row)
      : cases_(description), asked_(asked), on_row_(std::move(on_row)) {
    table_.title = description.title;
    table_.version = kVersion;
    table_.vary = asked.vary;
    table_.route = !asked.profile.empty();
    table_.tension = asked.tension;
    table_.held_tension = cases_.own_tension();
  }

  LayTable make() {
    if (is_lay_operation(cases_.description().operation.type)) {
      table_.findings.push_back(no_stage_finding(cases_.description(), false));
    }
    if (!cases_.given_lay().lay) {
      table_.findings.push_back(
          {FindingCode::case_without_solution, "the model's own lay has no equilibrium: " + cases_.given_lay().reason});
    }
    if (table_.route) {
      along_route();
    } else {
      steps();
    }
    std::vector<Findings> rows;
    for (const LayTableRow& row : table_.rows) {
      if (row.lay) rows.push_back(row.serious);
    }
    for (const SharedFinding& shared : shared_findings(rows)) {
      Finding finding = shared.worst;
      finding.message = fmt::format("{} of {} lays: {}", shared.runs.size(), rows.size(), shared.text());
      table_.findings.push_back(std::move(finding));
    }
    table_.assumptions = cases_.assumptions();
    table_.solves = cases_.solves();
    return std::move(table_);
  }

 private:
  LayCase lay_at(double value) {
    switch (asked_.vary) {
      case LayTableVary::lay_back:
        return cases_.at_lay_back(value, cases_.own_depth());
      case LayTableVary::depth:
        return cases_.at(cases_.own_tension(), value);
      default:
        return cases_.at(value, cases_.own_depth());
    }
  }

  static LayTableRow make_row(LayRowKind kind, double value, const LayCase& lay) {
    LayTableRow row;
    row.kind = kind;
    row.varied = value;
    row.depth = lay.depth;
    row.lay = lay.lay;
    const bool reserved = lay.lay && lay.lay->verdict == VerdictKind::reserved;
    row.reason = reserved && kind == LayRowKind::step ? "" : lay.reason;  // the findings give the reason
    row.serious = lay.serious;
    return row;
  }

  bool add(LayTableRow row, int solves_before, std::size_t of) {
    row.solves = cases_.solves() - solves_before;
    table_.rows.push_back(std::move(row));
    return !on_row_ || on_row_(table_.rows.back(), of);
  }

  void along_route() {
    for (const RouteDepth& point : asked_.profile) {
      const int before = cases_.solves();
      const bool sought = asked_.tension == RouteTension::minimum;
      const LayCase lay = sought ? cases_.at_min_tension(point.depth) : cases_.at(cases_.own_tension(), point.depth);
      LayTableRow row = make_row(LayRowKind::step, lay.tension, lay);
      row.distance = point.distance;
      if (!add(std::move(row), before, asked_.profile.size())) return;
    }
  }

  /// Default limits of the table, where the file gives none: [from, to].
  std::pair<double, double> limits() const {
    const LayCase& own_lay = cases_.given_lay();
    double base = own_lay.tension, less = 0.5, more = 2.0;
    if (asked_.vary != LayTableVary::tension) {
      less = 0.8;
      more = 1.2;
      base = asked_.vary == LayTableVary::depth ? own_lay.depth : own_lay.lay ? own_lay.lay->lay_back : 0.0;
    }
    return {asked_.from.value_or(less * base), asked_.to.value_or(more * base)};
  }

  void steps() {
    const auto [from, to] = limits();
    if (from <= 0.0 || to <= 0.0) {
      table_.findings.push_back(
          {FindingCode::table_range_unknown, "the limits of the table do not follow from the model: give from and to"});
      return;
    }
    std::vector<TriedLay> tried;
    for (int i = 0; i <= asked_.steps; ++i) {
      const double value = from + (to - from) * i / asked_.steps;
      const int before = cases_.solves();
      tried.push_back({value, lay_at(value)});
      LayTableRow row = make_row(LayRowKind::step, value, tried.back().lay);
      if (!add(std::move(row), before, static_cast<std::size_t>(asked_.steps) + 1)) return;
    }
    if (from > to) std::reverse(tried.begin(), tried.end());
    add_limits(tried);
    warn_of_gaps(tried);
    std::stable_sort(table_.rows.begin(), table_.rows.end(), [up = from < to](const auto& a, const auto& b) {
      return up ? a.varied < b.varied : a.varied > b.varied;
    });
  }

  /// `tried` is sorted by increasing value.
  void add_limits(const std::vector<TriedLay>& tried) {
    const auto passes = [](const TriedLay& trial) { return trial.lay.passed(); };
    const auto first = std::find_if(tried.begin(), tried.end(), passes);
    if (first == tried.end()) {
      table_.findings.push_back({FindingCode::no_passing_value, "no row of the table passes"});
      return;
    }
    const auto last = std::find_if(tried.rbegin(), tried.rend(), passes);
    add_limit(LayRowKind::minimum, *first, first == tried.begin() ? nullptr : &*(first - 1));
    add_limit(LayRowKind::maximum, *last, last == tried.rbegin() ? nullptr : &*(last - 1));
  }

  /// `beyond`: the row past the limit; null if that lies outside the table.
  void add_limit(LayRowKind kind, const TriedLay& passing, const TriedLay* beyond) {
    const TryLay try_at = [this](double value) { return lay_at(value); };
    const int before = cases_.solves();
    const bool down = kind == LayRowKind::minimum;
    const std::optional<LayLimit> limit =
        beyond != nullptr ? narrowed(passing, *beyond, {}, try_at) : limit_beyond(passing, down, {}, try_at);
    if (!limit) {
      table_.findings.push_back({FindingCode::limit_not_found,
                                 fmt::format("no {} limit of the varied quantity was found: the lay still passes far "
                                             "beyond the table",
                                             down ? "lower" : "upper")});
      return;
    }
    LayTableRow row = make_row(kind, limit->passing.value, limit->passing.lay);
    row.reason = fmt::format("{} it, {}", down ? "below" : "above", limit->beyond.lay.reason);
    row.solves = cases_.solves() - before;
    table_.rows.push_back(std::move(row));
  }

  /// Warns of rows that do not pass between others that do.
  void warn_of_gaps(const std::vector<TriedLay>& tried) {
    const ShownUnit unit = shown_unit("", asked_.vary == LayTableVary::tension ? "N" : "m");
    const auto passes = [&](std::size_t i) { return tried[i].lay.passed(); };
    for (std::size_t i = 1; i < tried.size(); ++i) {
      if (passes(i) || !passes(i - 1)) continue;
      std::size_t next = i + 1;
      while (next < tried.size() && !passes(next)) ++next;
      if (next == tried.size()) return;
      table_.findings.push_back({FindingCode::gap_between_passing_values,
                                 fmt::format("at {:.4g} {}, between values that pass, {}", tried[i].value * unit.factor,
                                             unit.name, tried[i].lay.reason)});
    }
  }

  LayCases cases_;
  const LayTableDescription& asked_;
  TableRowCallback on_row_;
  LayTable table_;
};

}  // namespace

LayTable make_lay_table(const Description& description, const LayTableDescription& asked,
                        const TableRowCallback& on_row) {
  const auto begin = std::chrono::steady_clock::now();
  LayTable table = TableMaker(description, asked, on_row).make();
  table.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return table;
}

void write_lay_table_run(const LayTable& table, const Description& description, const std::filesystem::path& folder) {
  StagedFolder staged(folder);
  write_lay_table_files(table, staged.path());
  write_lay_table_page(table, description.source_text, staged.path() / "report.html");
  staged.commit("summary.json");
}

}  // namespace overbend
