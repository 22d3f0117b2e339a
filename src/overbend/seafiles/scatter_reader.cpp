#include "seafiles/scatter_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr std::size_t kMonths = 12;
constexpr std::array<std::string_view, kMonths> kMonthNames = {"jan", "feb", "mar", "apr", "may", "jun",
                                                               "jul", "aug", "sep", "oct", "nov", "dec"};
constexpr double kRounding = 0.005;  ///< Excess over 1 allowed for the rounded probabilities of a month.
constexpr double kEven = 1e-6;       ///< Relative tolerance of spacings.

/// Row or column of the diagram.
struct Cell {
  double middle = 0.0;
  std::optional<double> width;  ///< Set if given as a range.
};

/// Parses "0.75" or "0.5-1".
std::optional<Cell> parse_cell(std::string_view text) {
  if (const std::optional<double> middle = cell_number(text)) return Cell{*middle, std::nullopt};
  const std::size_t dash = text.find('-', 1);
  if (dash == std::string_view::npos) return std::nullopt;
  const auto from = cell_number(trim(text.substr(0, dash))), to = cell_number(trim(text.substr(dash + 1)));
  if (!from || !to || *to <= *from) return std::nullopt;
  return Cell{0.5 * (*from + *to), *to - *from};
}

bool is_total(std::string_view text) {
  const std::string word = lower_case(text);
  return word == "total" || word == "sum" || word == "all";
}

/// Returns the common width of cells in ascending order; nothing if they are uneven.
std::optional<double> even_width(const std::vector<Cell>& cells) {
  const std::optional<double> first_width = cells.front().width;
  const double width = first_width ? *first_width : cells.size() > 1 ? cells[1].middle - cells[0].middle : 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].width.has_value() != first_width.has_value()) return std::nullopt;
    if (first_width && std::abs(*cells[i].width - width) > kEven * width) return std::nullopt;
    if (i > 0 && std::abs(cells[i].middle - cells[i - 1].middle - width) > kEven * width) return std::nullopt;
  }
  return width > 0.0 ? std::optional(width) : std::nullopt;
}

class ScatterReader {
 public:
  ScatterReader(const std::string& path, Diagnostics& diagnostics) : path_(path), diagnostics_(diagnostics) {}

  std::optional<ScatterDiagram> read(const std::string& text) {
    const TextTable table = split_table(text, ',');
    for (const TextRow& remark : table.remarks) take_remark(remark);
    if (table.rows.empty()) {
      complain(0, "", "an empty file", "a scatter diagram");
      return std::nullopt;
    }
    take_head(table.rows.front());
    for (std::size_t i = 1; good_ && i < table.rows.size(); ++i) take_row(table.rows[i]);
    if (good_ && diagram_.seas.empty()) complain(0, "", "a header without rows", "a row per wave height");
    if (good_) take_heights();
    if (good_) take_fractions();
    return good_ ? std::optional(std::move(diagram_)) : std::nullopt;
  }

 private:
  void complain(int line, std::string key, std::string found, std::string expected) {
    good_ = false;
    diagnostics_.add({Severity::error, path_, line, 0, std::move(key), std::move(found), std::move(expected), ""});
  }
  static std::string quoted(std::string_view text) { return "'" + for_display(text) + "'"; }

  void take_remark(const TextRow& remark) {
    if (remark.cells.size() != 2 || lower_case(remark.cells[0]) != "values") return;
    const std::string word = lower_case(remark.cells[1]);
    if (word == "counts") return;
    if (word == "probability") {
      max_sum_ = 1.0;
    } else if (word == "per cent" || word == "percent" || word == "%") {
      max_sum_ = 100.0;
    } else {
      complain(remark.line, "values", quoted(remark.cells[1]), "counts, probability or per cent");
    }
  }

  void take_head(const TextRow& head) {
    std::size_t column = 0;
    const auto named = [&](std::string_view name) {
      const bool matches = column < head.cells.size() && lower_case(head.cells[column]) == name;
      column += matches ? 1 : 0;
      return matches;
    };
    months_ = named("month");
    directions_ = named("from_deg");
    if (!named("hs_m")) {
      complain(head.line, "", column < head.cells.size() ? quoted(head.cells[column]) : "the end of the line",
               "a header of 'hs_m' and the peak periods in s, optionally preceded by 'month' and 'from_deg'");
      return;
    }
    first_ = column;
    columns_ = head.cells.size();
    for (; column < columns_; ++column) take_period(head, column);
    if (!good_) return;
    if (periods_.empty()) return complain(head.line, "", "no peak periods", "one per column after hs_m, in s");
    const std::optional<double> width = even_width(periods_);
    if (!width) {
      return complain(head.line, "", "peak periods that are not evenly spaced", "ascending by a constant step");
    }
    diagram_.tp_step = *width;
  }

  void take_period(const TextRow& head, std::size_t column) {
    const std::string_view text = head.cells[column];
    const bool passed_over = is_total(text);
    taken_.push_back(!passed_over);
    if (passed_over) return;
    const std::optional<Cell> period = parse_cell(text);
    if (!period || period->middle <= 0.0) {
      return complain(head.line, fmt::format("column {}", column + 1), quoted(text), "a peak period in s, above 0");
    }
    periods_.push_back(*period);
  }

  void take_row(const TextRow& row) {
    if (row.cells.size() != columns_) {
      return complain(row.line, "", std::to_string(row.cells.size()) + " columns",
                      std::to_string(columns_) + ", as in the header");
    }
    if (is_total(row.cells[first_ - 1]) || is_total(row.cells.front())) return;
    const std::optional<std::size_t> month = months_ ? parse_month(row) : 0;
    const std::optional<double> from = directions_ ? parse_direction(row) : std::nullopt;
    const std::optional<Cell> height = parse_cell(row.cells[first_ - 1]);
    if (!height || height->middle < 0.0) {
      return complain(row.line, "hs_m", quoted(row.cells[first_ - 1]), "a wave height in m, at least 0");
    }
    if (!month || !good_) return;
    if (!rows_.insert({*month, from.value_or(0.0), height->middle}).second) {
      return complain(row.line, "hs_m", quoted(row.cells[first_ - 1]) + " twice", "each height once");
    }
    heights_.insert({height->middle, height->width.value_or(0.0)});
    std::size_t period = 0;
    for (std::size_t i = first_; i < columns_; ++i) {
      if (taken_[i - first_]) add(*height, periods_[period++], from, *month, number(row, i));
    }
  }

  std::optional<std::size_t> parse_month(const TextRow& row) {
    const std::string word = lower_case(row.cells.front()).substr(0, 3);
    const auto name = ranges::find(kMonthNames, word);
    if (name != kMonthNames.end()) return static_cast<std::size_t>(name - kMonthNames.begin());
    const std::optional<double> number = cell_number(row.cells.front());
    if (number && *number >= 1.0 && *number <= 12.0 && *number == std::floor(*number)) {
      return static_cast<std::size_t>(*number) - 1;
    }
    complain(row.line, "month", quoted(row.cells.front()), "1 to 12, or jan to dec");
    return std::nullopt;
  }

  std::optional<double> parse_direction(const TextRow& row) {
    const std::string_view text = row.cells[first_ - 2];
    const std::optional<double> degrees = cell_number(text);
    if (degrees && *degrees >= 0.0 && *degrees <= 360.0) return std::fmod(*degrees, 360.0) * kDegree;
    complain(row.line, "from_deg", quoted(text), "an azimuth from 0 to 360");
    return std::nullopt;
  }

  double number(const TextRow& row, std::size_t column) {
    if (row.cells[column].empty()) return 0.0;
    const std::optional<double> value = cell_number(row.cells[column]);
    if (value && *value >= 0.0) return *value;
    complain(row.line, fmt::format("column {}", column + 1), quoted(row.cells[column]), "a number, at least 0");
    return 0.0;
  }

  void add(const Cell& height, const Cell& period, std::optional<double> from, std::size_t month, double often) {
    const auto key = std::tuple(from.value_or(0.0), height.middle, period.middle);
    const auto [place, fresh] = index_.try_emplace(key, diagram_.seas.size());
    if (fresh) {
      diagram_.seas.push_back({height.middle, period.middle, from, std::vector<double>(months_ ? kMonths : 1, 0.0)});
    }
    diagram_.seas[place->second].fraction[month] += often;
  }

  void take_heights() {
    std::vector<Cell> heights;
    for (const auto& [middle, width] : heights_) {
      heights.push_back({middle, width > 0.0 ? std::optional(width) : std::nullopt});
    }
    const std::optional<double> width = even_width(heights);
    if (!width) return complain(0, "hs_m", "wave heights that are not evenly spaced", "ascending by a constant step");
    diagram_.hs_step = *width;
  }

  void take_fractions() {
    for (std::size_t month = 0; month < (months_ ? kMonths : 1); ++month) {
      double sum = 0.0;
      for (const ScatterDiagram::Sea& sea : diagram_.seas) sum += sea.fraction[month];
      const std::string month_label = months_ ? fmt::format("month {}", month + 1) : "";
      if (sum <= 0.0) return complain(0, month_label, "no seas", "at least one");
      if (max_sum_ && sum > *max_sum_ * (1.0 + kRounding)) {
        return complain(0, month_label, "values that add up to " + format_number(sum),
                        "at most " + format_number(*max_sum_));
      }
      const double total = max_sum_ ? std::max(*max_sum_, sum) : sum;
      for (ScatterDiagram::Sea& sea : diagram_.seas) sea.fraction[month] /= total;
    }
  }

  std::string path_;
  Diagnostics& diagnostics_;
  bool good_ = true, months_ = false, directions_ = false;
  std::optional<double> max_sum_;  ///< Maximum sum of the values of a month; none: counts.
  std::size_t first_ = 0;          ///< Column of the first period.
  std::size_t columns_ = 0;
  std::vector<bool> taken_;  ///< True for the columns after hs_m that are used.
  std::vector<Cell> periods_;
  std::set<std::pair<double, double>> heights_;  ///< Centre and width; width 0: not given.
  std::set<std::tuple<std::size_t, double, double>> rows_;
  std::map<std::tuple<double, double, double>, std::size_t> index_;
  ScatterDiagram diagram_;
};

}  // namespace

std::optional<ScatterDiagram> read_scatter_text(const std::string& text, const std::string& path,
                                                Diagnostics& diagnostics) {
  return ScatterReader(path, diagnostics).read(text);
}

std::optional<ScatterDiagram> read_scatter(const std::string& path, Diagnostics& diagnostics) {
  const std::optional<std::string> text = read_text_file(path, diagnostics);
  return text ? read_scatter_text(*text, path, diagnostics) : std::nullopt;
}

}  // namespace overbend
