#include "seafiles/rao_assembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "seafiles/rao_symmetry.h"

namespace overbend {
namespace {

constexpr int kMaxErrors = 10;
constexpr std::size_t kMaxTableSize = 4'000'000;

/// Returns the sorted values without those within `slack` of their predecessor.
std::vector<double> make_axis(std::vector<double> values, double slack) {
  std::sort(values.begin(), values.end());
  const auto same = [&](double a, double b) { return b - a <= slack; };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  return values;
}

std::size_t nearest(const std::vector<double>& axis, double value) {
  const auto above = std::lower_bound(axis.begin(), axis.end(), value);
  if (above == axis.begin()) return 0;
  if (above == axis.end()) return axis.size() - 1;
  const auto below = above - 1;
  return static_cast<std::size_t>((value - *below < *above - value ? below : above) - axis.begin());
}

class Assembly {
 public:
  Assembly(const rao_formats::RaoFile& content, const RaoTranslation& translation, const std::string& file,
           Diagnostics& diagnostics)
      : records_(content.records),
        symmetry_(content.symmetry),
        translation_(translation),
        file_(file),
        diagnostics_(diagnostics) {}

  std::optional<RaoTable> run() {
    if (records_.empty()) {
      complain(0, "no rows of numbers", "motion responses by heading and frequency");
      return std::nullopt;
    }
    find_axes();
    const std::size_t places = table_.headings.size() * table_.omegas.size() * 6;
    if (places > kMaxTableSize) {
      complain(0, fmt::format("{} headings and {} frequencies", table_.headings.size(), table_.omegas.size()),
               "a table: the same frequencies for every heading");
      return std::nullopt;
    }
    table_.values.assign(places, {});
    line_.assign(places, 0);
    for (const RaoRecord& record : records_) enter(record);
    find_gaps();
    if (complaints_ > 0) return std::nullopt;
    table_.source = file_;
    table_.starboard = mirrored_;
    table_.asymmetric = !sides_alike();
    complete_by_symmetry(table_, symmetry_);
    remark_on_headings();
    return std::move(table_);
  }

 private:
  void complain(int line, const std::string& found, const std::string& expected) {
    if (complaints_++ < kMaxErrors) diagnostics_.add({Severity::error, file_, line, 0, "", found, expected, ""});
  }

  void find_axes() {
    std::vector<double> headings, omegas;
    for (const RaoRecord& record : records_) {
      headings.push_back(translation_.heading(record.heading));
      omegas.push_back(record.omega);
    }
    const double highest = *std::max_element(omegas.begin(), omegas.end());
    table_.omegas = make_axis(std::move(omegas), 1e-7 * highest);
    const auto starboard = [](double h) { return h == 0.0 || h >= kPi - 1e-7; };
    mirrored_ = sides_alike() && std::all_of(headings.begin(), headings.end(), starboard) &&
                std::any_of(headings.begin(), headings.end(), [](double h) { return h > kPi + 1e-7; });
    if (mirrored_) {
      for (double& h : headings) h = image(h);
    }
    table_.headings = make_axis(std::move(headings), 1e-7);
  }

  bool sides_alike() const {
    return symmetry_ == RaoSymmetry::unstated || symmetry_ == RaoSymmetry::port_starboard ||
           symmetry_ == RaoSymmetry::quarters;
  }

  static double image(double heading) { return heading == 0.0 ? 0.0 : 2.0 * kPi - heading; }

  std::string place_label(std::size_t heading, std::size_t omega, std::size_t freedom) const {
    const double h = mirrored_ ? image(table_.headings[heading]) : table_.headings[heading];
    return fmt::format("{} for waves travelling towards {:.6g} deg at {:.6g} rad/s", kFreedomNames[freedom],
                       h * kToDegrees, table_.omegas[omega]);
  }

  void enter(const RaoRecord& record) {
    const double turned = translation_.heading(record.heading);
    const std::size_t h = nearest(table_.headings, mirrored_ ? image(turned) : turned);
    const std::size_t w = nearest(table_.omegas, record.omega);
    const auto k = static_cast<std::size_t>(record.freedom);
    const std::complex<double> value = (mirrored_ && k % 2 == 1 ? -1.0 : 1.0) * translation_.response(record);
    const std::size_t index = (h * table_.omegas.size() + w) * 6 + k;
    if (line_[index] != 0 && std::abs(table_.values[index] - value) > 1e-6 * (1e-3 + std::abs(value))) {
      complain(record.line, fmt::format("{} twice, with different values", place_label(h, w, k)),
               fmt::format("each value once; it is already in line {}", line_[index]));
      return;
    }
    line_[index] = record.line;
    table_.values[index] = value;
  }

  void find_gaps() {
    for (std::size_t k = 0; k < 6; ++k) {
      const bool present = std::any_of(records_.begin(), records_.end(),
                                       [&](const RaoRecord& r) { return static_cast<std::size_t>(r.freedom) == k; });
      if (!present) {
        table_.assumptions.push_back(
            {AssumptionRank::other,
             fmt::format("The RAOs of {} do not contain {}; it is taken as zero.", file_, kFreedomNames[k])});
        continue;
      }
      for (std::size_t i = k; i < line_.size(); i += 6) {
        if (line_[i] != 0) continue;
        complain(0, "no value of " + place_label(i / 6 / table_.omegas.size(), i / 6 % table_.omegas.size(), k),
                 "every heading with every frequency");
      }
    }
  }

  void remark_on_headings() {
    const std::vector<double>& h = table_.headings;
    const bool one_sided = table_.one_sided();
    double widest = one_sided ? 2.0 * std::max(h.front(), kPi - h.back()) : h.front() + 2.0 * kPi - h.back();
    for (std::size_t i = 1; i < h.size(); ++i) widest = std::max(widest, h[i] - h[i - 1]);
    if (one_sided) {
      const bool stated = symmetry_ != RaoSymmetry::unstated;
      table_.assumptions.push_back(
          {AssumptionRank::other,
           fmt::format("The RAOs of {} cover one side of the vessel; the other side is {} its mirror image.", file_,
                       stated ? "stated to be" : "assumed to be")});
    }
    if (widest * kToDegrees > 45.1) {
      diagnostics_.add({Severity::warning, file_, 0, 0, "",
                        fmt::format("neighbouring headings are {:.4g} deg apart; responses between them are "
                                    "interpolated linearly{}",
                                    widest * kToDegrees, symmetry_remark()),
                        "", ""});
    }
  }

  const char* symmetry_remark() const {
    return table_.asymmetric ? "; nothing is mirrored because the file states that the sides differ (Symmetry)" : "";
  }

  const std::vector<RaoRecord>& records_;
  RaoSymmetry symmetry_;
  const RaoTranslation& translation_;
  std::string file_;
  Diagnostics& diagnostics_;
  RaoTable table_;
  std::vector<int> line_;  ///< Line of each value; 0: no value yet.
  bool mirrored_ = false;
  int complaints_ = 0;
};

}  // namespace

std::optional<RaoTable> assemble_raos(const rao_formats::RaoFile& content, const RaoTranslation& translation,
                                      const std::string& file, Diagnostics& diagnostics) {
  return Assembly(content, translation, file, diagnostics).run();
}

}  // namespace overbend
