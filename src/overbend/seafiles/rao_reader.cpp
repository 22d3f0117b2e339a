#include "seafiles/rao_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/shown_unit.h"
#include "base/text.h"
#include "seafiles/hull_file_kind.h"
#include "seafiles/rao_assembly.h"
#include "seafiles/rao_formats.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

/// Returns the file extension in lower case: ".csv".
std::string file_ending(const std::string& file) {
  return lower_case(std::filesystem::path(file).extension().string());
}

enum class RaoFormat { table, wamit, wamit_output, aqwa_listing, hydrostar, orcaflex };

/// Returns the format of a text by its contents, or else by the ending of its name.
std::optional<RaoFormat> find_format(const std::string& text, const std::string& file) {
  const std::string ending = file_ending(file);
  if (ending == ".csv") return RaoFormat::table;
  if (ending == ".4") return RaoFormat::wamit;
  const auto kind = find_text_kind(text);
  if (kind == HullFileKind::wamit_output) return RaoFormat::wamit_output;
  if (kind == HullFileKind::aqwa_listing) return RaoFormat::aqwa_listing;
  if (kind == HullFileKind::hydrostar_rao) return RaoFormat::hydrostar;
  if (kind == HullFileKind::orcaflex || ending == ".yml" || ending == ".yaml") return RaoFormat::orcaflex;
  return std::nullopt;
}

const char* default_set(RaoFormat format) {
  switch (format) {
    case RaoFormat::wamit:
    case RaoFormat::wamit_output:
      return "wamit";
    case RaoFormat::aqwa_listing:
      return "aqwa";
    case RaoFormat::orcaflex:
      return "orcaflex";
    case RaoFormat::table:
    case RaoFormat::hydrostar:
      break;
  }
  return "house";
}

/// Returns the convention, in increasing priority: named set, statements of the file, user settings.
ConventionValues settle(const std::string& set, const RaoSettings& stated, const RaoSettings& user_settings) {
  ConventionValues convention = convention_set(user_settings.set.empty() ? set : user_settings.set);
  for (const RaoSettings* from : {&stated, &user_settings}) {
    for (const auto& [key, word] : from->values) convention[key] = word;
  }
  return convention;
}

/// Sets the reference point of the motions and the origin of the phases; assumptions are noted in the table.
void place_points(RaoTable& table, const std::string& set, const rao_formats::RaoFile& content,
                  const RaoSettings& user_settings) {
  const RaoSettings& stated = content.stated;
  const std::string name = "The RAOs of " + table.source;
  if (user_settings.reference) {
    table.reference_V = *user_settings.reference;
  } else if (stated.reference) {
    table.reference_V = user_settings.file_origin + *stated.reference;
    if ((set == "orcaflex" || content.axes_of_file) && !user_settings.file_origin_stated) {
      table.assumptions.push_back(
          {AssumptionRank::other, name + " state their origin in the vessel axes of the file; the origin of these axes "
                                         "is assumed at midship on the water line."});
    }
  } else {
    table.assumptions.push_back(
        {AssumptionRank::other, name + " do not state their reference point; midship on the water line is assumed."});
  }
  if (user_settings.wave_origin) {
    table.wave_origin_V = *user_settings.wave_origin;
  } else if (stated.wave_origin) {
    table.wave_origin_V = user_settings.file_origin + *stated.wave_origin;
  } else if (set == "wamit") {
    table.assumptions.push_back(
        {AssumptionRank::other, name + " are assumed to have phases relative to the wave at midship (X = Y = 0)."});
  } else {
    table.wave_origin_V = table.reference_V;
  }
}

WaveColumnSettings column(const RaoSettings& user_settings, double depth) {
  const auto word = user_settings.values.find("frequencies");
  WaveColumnSettings settings;
  if (word != user_settings.values.end()) settings.stated = from_enum_name<WaveColumn>(word->second);
  settings.length_scale = user_settings.length_scale;
  settings.depth = depth;
  return settings;
}

rao_formats::RaoFile read_content(RaoFormat format, const std::string& text, const std::string& file,
                                  const RaoSettings& user_settings, double depth, Diagnostics& diagnostics) {
  switch (format) {
    case RaoFormat::wamit:
      return rao_formats::read_wamit(text, file, column(user_settings, depth), diagnostics);
    case RaoFormat::wamit_output:
      return rao_formats::read_wamit_output(text, file, user_settings, diagnostics);
    case RaoFormat::aqwa_listing:
      return rao_formats::read_aqwa_listing(text, file, user_settings, diagnostics);
    case RaoFormat::hydrostar:
      return rao_formats::read_hydrostar(text, file, user_settings, diagnostics);
    case RaoFormat::orcaflex:
      return rao_formats::read_orcaflex(text, file, user_settings, diagnostics);
    case RaoFormat::table:
      break;
  }
  return rao_formats::read_csv(text, file, diagnostics);
}

/// Moves one-sided RAOs to the centreline, because mirroring is valid only for points on it.
RaoTable sides_alike(RaoTable table, double depth) {
  const double reference = table.reference_V.y(), origin = table.wave_origin_V.y();
  if (!table.one_sided() || (reference == 0.0 && origin == 0.0)) return table;
  if (reference != 0.0) {
    table.assumptions.push_back(
        {AssumptionRank::other,
         fmt::format(
             "The RAOs of {} cover one side of the vessel and refer to a point {} off the centreline; to mirror them, "
             "they are moved to the centreline, and the vessel motions in the results are those of the point there.",
             table.source, shown_digits(std::abs(reference), "m", 3))});
  }
  return transferred_to_centreline(std::move(table), depth);
}

}  // namespace

std::optional<RaoTable> read_raos(const std::string& file, const RaoSettings& user_settings, double depth,
                                  Diagnostics& diagnostics) {
  const std::optional<std::string> text = read_text_file(file, diagnostics);
  if (!text) return std::nullopt;
  return read_rao_text(*text, file, user_settings, depth, diagnostics);
}

std::optional<RaoTable> read_rao_text(const std::string& text, const std::string& file,
                                      const RaoSettings& user_settings, double depth, Diagnostics& diagnostics) {
  const std::optional<RaoFormat> format = find_format(text, file);
  if (!format) {
    diagnostics.add({Severity::error, file, 0, 0, "", "a file ending in '" + for_display(file_ending(file)) + "'",
                     ".csv, .4 or .out (WAMIT), .LIS (AQWA), .rao (HydroStar) or .yml (OrcaFlex)", ""});
    return std::nullopt;
  }
  Diagnostics file_diagnostics;
  const rao_formats::RaoFile content = read_content(*format, text, file, user_settings, depth, file_diagnostics);
  for (const Diagnostic& diagnostic : file_diagnostics.sorted()) diagnostics.add(diagnostic);
  if (file_diagnostics.has_errors()) return std::nullopt;
  const std::string set = user_settings.set.empty() ? default_set(*format) : user_settings.set;
  const RaoTranslation translation(settle(set, content.stated, user_settings), user_settings.length_scale, depth);
  std::optional<RaoTable> table = assemble_raos(content, translation, file, diagnostics);
  if (!table) return std::nullopt;
  const bool finite = std::all_of(table->values.begin(), table->values.end(), [](const std::complex<double>& value) {
    return std::isfinite(value.real()) && std::isfinite(value.imag());
  });
  if (!finite) {
    diagnostics.add({Severity::error, file, 0, 0, "", "motions too large for a vessel", "finite numbers", ""});
    return std::nullopt;
  }
  for (const std::string& sentence : content.assumptions) {
    table->assumptions.push_back({AssumptionRank::governing, sentence});
  }
  for (const std::string& sentence : content.notes) table->assumptions.push_back({AssumptionRank::other, sentence});
  place_points(*table, set, content, user_settings);
  return sides_alike(std::move(*table), depth);
}

}  // namespace overbend
