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
#include "model/description/study_enum_names.h"
#include "model/waves/peak_period.h"
#include "seafiles/scatter_bins.h"
#include "seafiles/table_layout.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr std::size_t kMonths = 12;
constexpr std::array<std::string_view, kMonths> kMonthNames = {"jan", "feb", "mar", "apr", "may", "jun",
                                                               "jul", "aug", "sep", "oct", "nov", "dec"};
constexpr const char* kAxis = "ascending by a constant step, or ranges such as 2-4 that follow each other";
constexpr double kRounding = 0.005;  ///< Excess over 1 allowed for the rounded probabilities of a month.

bool is_total(std::string_view text) {
  const std::string word = lower_case(text);
  return word == "total" || word == "sum" || word == "all";
}

/// Number of decimals of a number as written.
int decimals(std::string_view cell) {
  const std::size_t point = cell.find('.');
  if (point == std::string_view::npos) return 0;
  const std::size_t end = std::min(cell.find_first_not_of("0123456789", point + 1), cell.size());
  return static_cast<int>(end - point - 1);
}

/// Sum of values as written, to compare with a total.
struct WrittenSum {
  double sum = 0.0;
  int count = 0, digits = 0;

  void add(double value, std::string_view cell) {
    sum += value;
    ++count;
    digits = std::max(digits, decimals(cell));
  }
  /// Returns true if a total agrees within the rounding of the values and its own.
  bool agrees(double total, std::string_view cell) const {
    const int last = std::max(digits, decimals(cell));
    const double unit = std::pow(10.0, -last);
    return std::abs(total - sum) <= 0.5 * unit * (last > 0 ? count + 1 : 1) * (1.0 + 1e-6);
  }
};

class ScatterReader {
 public:
  ScatterReader(const std::string& path, Diagnostics& diagnostics, const ScatterSettings& settings)
      : path_(path), diagnostics_(diagnostics), settings_(settings) {}

  std::optional<ScatterDiagram> read(const std::string& text) {
    const std::optional<ExportedTable> table = read_exported_table(text, path_, diagnostics_);
    if (!table) return std::nullopt;
    for (const TextRow& remark : table->remarks) take_remark(remark);
    if (table->rows.empty()) {
      complain(0, "", "an empty file", "a scatter diagram");
      return std::nullopt;
    }
    take_head(table->rows.front());
    for (std::size_t i = 1; good_ && i < table->rows.size(); ++i) take_row(*table, table->rows[i]);
    if (good_ && diagram_.seas.empty()) complain(0, "", "a header without rows", "a row per wave height");
    if (good_) take_heights();
    if (good_) take_percent();
    if (good_) take_fractions();
    if (good_) take_peak_periods();
    return good_ ? std::optional(std::move(diagram_)) : std::nullopt;
  }

 private:
  void complain(int line, std::string key, std::string found, std::string expected, std::string hint = {}) {
    good_ = false;
    diagnostics_.add(
        {Severity::error, path_, line, 0, std::move(key), std::move(found), std::move(expected), std::move(hint)});
  }
  static std::string quoted(std::string_view text) { return "'" + for_display(text) + "'"; }

  void take_remark(const TextRow& remark) {
    if (remark.cells.size() != 2 || lower_case(remark.cells[0]) != "values") return;
    stated_line_ = remark.line;
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
    const std::string_view corner = column < head.cells.size() ? head.cells[column] : std::string_view();
    if (!take_corner(head.line, corner)) return;
    first_ = ++column;
    columns_ = head.cells.size();
    for (; column < columns_; ++column) take_period(head, column);
    if (!good_) return;
    if (periods_.empty()) return complain(head.line, "", "no peak periods", "a column per period after hs_m, in s");
    if (const std::string why = complete_scatter_bins(periods_); !why.empty()) {
      complain(head.line, "", "peak periods " + why, kAxis);
    }
  }

  /// Takes the cell that names wave height and period.
  bool take_corner(int line, std::string_view text) {
    const ScatterCorner corner = parse_scatter_corner(text);
    height_factor_ = corner.height_factor;
    plain_ = corner.plain;
    if (!corner.height) {
      complain(line, "", text.empty() ? "the end of the line" : quoted(text),
               "a header of 'hs_m' and the peak periods in s, or of 'Hs (m) / Tz (s)' and the mean periods, optionally "
               "preceded by 'month' and 'from_deg'");
      return false;
    }
    if (corner.period && settings_.period && corner.period != settings_.period) {
      complain(line, "", quoted(text) + ", and operability.scatter_period: " + enum_name(*settings_.period),
               "the same period");
      return false;
    }
    const std::optional<ScatterPeriod> period = corner.period ? corner.period : settings_.period;
    if (!period && !corner.plain) {
      complain(line, "", quoted(text) + ", which does not say whether the periods are Tp or Tz",
               "'Hs (m) / Tp (s)' or 'Hs (m) / Tz (s)'", "operability.scatter_period: tp or tz states it");
      return false;
    }
    period_ = period.value_or(ScatterPeriod::tp);
    return true;
  }

  void take_period(const TextRow& head, std::size_t column) {
    const std::string_view text = head.cells[column];
    const bool total = is_total(text);
    taken_.push_back(!total);
    titles_.emplace_back(text);
    if (total) return;
    const std::optional<ScatterBin> period = parse_scatter_bin(text);
    if (!period || period->middle <= 0.0) {
      return complain(head.line, fmt::format("column {}", column + 1), quoted(text), "a peak period in s, above 0");
    }
    periods_.push_back(*period);
  }

  void take_row(const ExportedTable& table, const TextRow& row) {
    if (row.cells.size() != columns_) {
      return complain(row.line, "", std::to_string(row.cells.size()) + " columns",
                      std::to_string(columns_) + ", as in the header", row_width_hint(table, row));
    }
    if (is_total(row.cells[first_ - 1]) || is_total(row.cells.front())) return check_column_totals(row);
    const std::optional<std::size_t> month = months_ ? parse_month(row) : 0;
    const std::optional<double> from = directions_ ? parse_direction(row) : std::nullopt;
    std::optional<ScatterBin> height = parse_scatter_bin(row.cells[first_ - 1]);
    if (!height || height->middle < 0.0) {
      return complain(row.line, "hs_m", quoted(row.cells[first_ - 1]), "a wave height in m, at least 0");
    }
    height->middle *= height_factor_;
    if (height->width) *height->width *= height_factor_;
    if (!month || !good_) return;
    if (!rows_.insert({*month, from.value_or(0.0), height->middle}).second) {
      return complain(row.line, "hs_m", quoted(row.cells[first_ - 1]) + " twice", "each height once");
    }
    heights_.insert({height->middle, height->width.value_or(0.0)});
    take_values(row, *height, from, *month);
  }

  void take_values(const TextRow& row, const ScatterBin& height, std::optional<double> from, std::size_t month) {
    sums_.resize(columns_ - first_);
    WrittenSum row_sum;
    std::size_t period = 0;
    for (std::size_t i = first_; i < columns_ && good_; ++i) {
      const std::string_view cell = row.cells[i];
      const double value = number(row, i);
      if (!taken_[i - first_]) {
        check_total(row.line, cell, value, row_sum, "row");
      } else {
        add(height, periods_[period++], from, month, value);
        row_sum.add(value, cell);
        sums_[i - first_].add(value, cell);
        sum_.add(value, cell);
      }
    }
  }

  void check_total(int line, std::string_view cell, double total, const WrittenSum& sum, const char* what) {
    if (cell.empty() || sum.agrees(total, cell) || !good_) return;
    complain(line, "total", quoted(cell) + " for values that add up to " + format_number(sum.sum, 9),
             std::string("the sum of the ") + what, "a value is damaged or missing");
  }

  /// Checks a row of totals; with months or directions it may belong to any of their parts.
  void check_column_totals(const TextRow& row) {
    if (months_ || directions_) return;
    sums_.resize(columns_ - first_);
    for (std::size_t i = first_; i < columns_ && good_; ++i) {
      const double total = number(row, i);
      check_total(row.line, row.cells[i], total, taken_[i - first_] ? sums_[i - first_] : sum_, "column");
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
    std::string_view cell = row.cells[column];
    if (cell.empty()) return 0.0;
    const bool percent = cell.back() == '%';
    if (percent) cell = trim(cell.substr(0, cell.size() - 1));
    const std::optional<double> value = cell_number(cell);
    if (!value || *value < 0.0) {
      complain(row.line, fmt::format("column {}", column + 1),
               quoted(row.cells[column]) + " under " + for_display(titles_[column - first_]), "a number, at least 0");
      return 0.0;
    }
    if (percent && percent_line_ == 0) percent_line_ = row.line;
    if (!percent && *value > 0.0 && plain_line_ == 0) plain_line_ = row.line;
    return *value;
  }

  /// Per cent signs state what the values are.
  void take_percent() {
    if (percent_line_ == 0) return;
    if (plain_line_ > 0) {
      return complain(std::max(percent_line_, plain_line_), "", "values with and without a per cent sign", "one kind");
    }
    if (stated_line_ > 0 && max_sum_ != 100.0) {
      return complain(stated_line_, "values", "a statement that contradicts the per cent signs of the values",
                      "per cent");
    }
    max_sum_ = 100.0;
  }

  void add(const ScatterBin& height, const ScatterBin& period, std::optional<double> from, std::size_t month,
           double often) {
    const auto key = std::tuple(from.value_or(0.0), height.middle, period.middle);
    const auto [place, fresh] = index_.try_emplace(key, diagram_.seas.size());
    if (fresh) {
      diagram_.seas.push_back({height.middle, period.middle, from, std::vector<double>(months_ ? kMonths : 1, 0.0)});
    }
    diagram_.seas[place->second].fraction[month] += often;
  }

  void take_heights() {
    std::vector<ScatterBin> heights;
    for (const auto& [middle, width] : heights_) {
      heights.push_back({middle, width > 0.0 ? std::optional(width) : std::nullopt});
    }
    if (const std::string why = complete_scatter_bins(heights); !why.empty()) {
      return complain(0, "hs_m", "wave heights " + why, kAxis);
    }
    for (ScatterDiagram::Sea& sea : diagram_.seas) {
      sea.hs_width = *ranges::find(heights, sea.hs, &ScatterBin::middle)->width;
    }
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

  /// Converts mean periods with the spectrum of the study, and reports what the diagram is.
  void take_peak_periods() {
    if (period_ == ScatterPeriod::tz && !convert_mean_periods()) return;
    if (plain_ && period_ == ScatterPeriod::tp && percent_line_ == 0) return;
    diagram_.remark = fmt::format("a scatter diagram of {} seas by Hs and {}, {} that add up to {}{}",
                                  diagram_.seas.size(), period_ == ScatterPeriod::tz ? "Tz" : "Tp",
                                  max_sum_ == 100.0 ? "per cent" : "values", format_number(sum_.sum, 9), ratio_text_);
    add_notice(diagnostics_, path_, 0, diagram_.remark);
  }

  bool convert_mean_periods() {
    const WavesDescription* waves = settings_.waves;
    const bool jonswap = waves != nullptr && waves->type == WaveType::jonswap;
    if (!jonswap && (waves == nullptr || waves->type != WaveType::pierson_moskowitz)) {
      complain(0, "", "mean periods Tz, and a model without a spectrum that gives Tp for them",
               "a base model with environment.waves.type: jonswap or pierson_moskowitz", "or a diagram of Tp");
      return false;
    }
    const std::optional<double> gamma = jonswap ? waves->gamma : std::optional(1.0);
    std::set<double> ratios;
    for (ScatterDiagram::Sea& sea : diagram_.seas) {
      const double tz = sea.tp;
      sea.tp = peak_period(sea.hs, tz, gamma);
      ratios.insert(sea.tp / tz);
    }
    const double low = *ratios.begin(), high = *ratios.rbegin();
    const std::string ratio =
        high - low < 1e-6 ? fmt::format("{:.4f}", low) : fmt::format("{:.4f} to {:.4f}", low, high);
    ratio_text_ = fmt::format("; Tp = {} Tz of {}", ratio,
                              !jonswap ? "Pierson-Moskowitz spectra"
                              : gamma  ? fmt::format("JONSWAP spectra with gamma {:g}", *gamma)
                                       : std::string("JONSWAP spectra with the gamma of each sea by DNV-RP-C205"));
    return true;
  }

  std::string path_;
  Diagnostics& diagnostics_;
  const ScatterSettings& settings_;
  bool good_ = true, months_ = false, directions_ = false;
  std::optional<double> max_sum_;  ///< Maximum sum of the values of a month; none: counts.
  std::size_t first_ = 0;          ///< Column of the first period.
  std::size_t columns_ = 0;
  std::vector<bool> taken_;          ///< True for the columns after hs_m that are used.
  std::vector<std::string> titles_;  ///< Titles of the columns after hs_m.
  std::vector<ScatterBin> periods_;
  ScatterPeriod period_ = ScatterPeriod::tp;
  double height_factor_ = 1.0;                               ///< Factor of the heights, to m.
  bool plain_ = true;                                        ///< True for the header hs_m.
  int percent_line_ = 0, plain_line_ = 0, stated_line_ = 0;  ///< First lines with and without per cent, of a statement.
  WrittenSum sum_;
  std::vector<WrittenSum> sums_;  ///< Sums of the columns after hs_m.
  std::string ratio_text_;
  std::set<std::pair<double, double>> heights_;  ///< Centre and width; width 0: not given.
  std::set<std::tuple<std::size_t, double, double>> rows_;
  std::map<std::tuple<double, double, double>, std::size_t> index_;
  ScatterDiagram diagram_;
};

}  // namespace

std::optional<ScatterDiagram> read_scatter_text(const std::string& text, const std::string& path,
                                                Diagnostics& diagnostics, const ScatterSettings& settings) {
  return ScatterReader(path, diagnostics, settings).read(text);
}

std::optional<ScatterDiagram> read_scatter(const std::string& path, Diagnostics& diagnostics,
                                           const ScatterSettings& settings) {
  const std::optional<std::string> text = read_text_file(path, diagnostics);
  return text ? read_scatter_text(*text, path, diagnostics, settings) : std::nullopt;
}

}  // namespace overbend
