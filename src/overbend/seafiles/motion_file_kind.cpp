#include "seafiles/motion_file_kind.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/diagnostics.h"
#include "base/ranges.h"
#include "base/text.h"
#include "seafiles/column_title.h"
#include "seafiles/hull_file_kind.h"
#include "seafiles/motion_record_checks.h"
#include "seafiles/table_layout.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeadLength = std::size_t{1} << 20U;  ///< Names in HDF5 files follow their first data.

std::string read_head(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(kHeadLength, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return head;
}

std::string ending(const std::string& path) {
  return lower_case(fs::path(path).extension().string());
}

/// Returns the kinds of a table by its titles.
std::vector<MotionFileKind> table_kinds(std::string_view head) {
  if (head.find('\0') != std::string_view::npos) return {};
  if (head.size() == kHeadLength) head = head.substr(0, head.find_last_of('\n'));
  Diagnostics unused;
  const std::optional<ExportedTable> table = read_exported_table(head, "", unused);
  if (!table || !table->has_header) return {};
  bool has_time = false, has_freedom = false, has_amplitude = false;
  for (const std::string_view cell : table->rows.front().cells) {
    const ColumnTitle title = parse_column_title(cell);
    has_time = has_time || is_time_title(title);
    has_amplitude = has_amplitude || title.name == "amplitude";
    has_freedom = has_freedom || ranges::any_of(kMotionColumns, [&](const std::string_view column) {
                    return column.substr(0, column.find('_')) == title.name;
                  });
  }
  if (has_amplitude) return {MotionFileKind::raos};
  if (has_time && has_freedom) return {MotionFileKind::history};
  return {};
}

/// Returns the kinds of a file of WAMIT's set, which holds numbers alone.
std::vector<MotionFileKind> wamit_kinds(const std::string& path) {
  const std::string last = ending(path);
  std::error_code error;
  if (last == ".hst") return {MotionFileKind::coupled};
  if (last == ".1" && !fs::exists(fs::path(path).replace_extension(".hst"), error)) return {MotionFileKind::coupled};
  return {};
}

/// True if the beginning of a binary file names hydrodynamic coefficients; results and beds do not.
bool names_coefficients(std::string_view head) {
  return head.find("added_mass") != std::string_view::npos || head.find("hydro_coeffs") != std::string_view::npos;
}

}  // namespace

std::vector<MotionFileKind> find_motion_file_kinds(const std::string& path) {
  const std::string head = read_head(path);
  if (head.empty()) return {};
  if (head.starts_with("CDF") || head.starts_with("\x89HDF")) {
    return names_coefficients(head) ? std::vector{MotionFileKind::coupled} : std::vector<MotionFileKind>{};
  }
  if (const auto kind = find_text_kind(head)) {
    switch (*kind) {
      case HullFileKind::hydrostar_rao:
        return {MotionFileKind::raos};
      case HullFileKind::wamit_output:
      case HullFileKind::aqwa_listing:
        return {MotionFileKind::raos, MotionFileKind::coupled};
      case HullFileKind::orcaflex: {
        std::vector<MotionFileKind> kinds;
        if (head.find("DisplacementRAOs") != std::string::npos) kinds.push_back(MotionFileKind::raos);
        if (head.find("LoadRAOs") != std::string::npos) kinds.push_back(MotionFileKind::coupled);
        return kinds;
      }
      default:
        return {MotionFileKind::coupled};
    }
  }
  if (ending(path) == ".4") return {MotionFileKind::raos};
  if (find_hull_file_kind(path) == HullFileKind::wamit_files) return wamit_kinds(path);
  return table_kinds(head);
}

}  // namespace overbend
