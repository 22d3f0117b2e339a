#include "seafiles/rao_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "base/shown_unit.h"
#include "base/text.h"
#include "seafiles/rao_assembly.h"
#include "seafiles/rao_formats.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

/// In lower case: ".csv".
std::string file_ending(const std::string& file) {
  return lower_case(std::filesystem::path(file).extension().string());
}

bool is_orcaflex(const std::string& ending) {
  return ending == ".yml" || ending == ".yaml";
}

/// The convention, in increasing priority: the named set, the file's statements, the user's.
ConventionWords settle(const std::string& set, const RaoSettings& stated, const RaoSettings& given) {
  ConventionWords words = convention_set(given.set.empty() ? set : given.set);
  for (const RaoSettings* from : {&stated, &given}) {
    for (const auto& [key, word] : from->words) words[key] = word;
  }
  return words;
}

/// The point the motions are of and the one the phases count from; what is assumed is noted in the table.
void place_points(RaoTable& table, const std::string& set, const RaoSettings& stated, const RaoSettings& given) {
  const std::string name = "The RAOs of " + table.source;
  if (given.reference) {
    table.reference_V = *given.reference;
  } else if (stated.reference) {
    table.reference_V = given.file_origin + *stated.reference;
    if (set == "orcaflex" && !given.file_origin_stated) {
      table.assumptions.push_back(
          {AssumptionRank::other, name + " give their origin in the vessel axes of the file; the origin of these axes "
                                         "is assumed at midship on the water line."});
    }
  } else {
    table.assumptions.push_back(
        {AssumptionRank::other, name + " do not state their reference point; midship on the water line is assumed."});
  }
  if (given.wave_origin) {
    table.wave_origin_V = *given.wave_origin;
  } else if (stated.wave_origin) {
    table.wave_origin_V = given.file_origin + *stated.wave_origin;
  } else if (set == "wamit") {
    table.assumptions.push_back(
        {AssumptionRank::other, name + " are assumed to have phases relative to the wave at midship (X = Y = 0)."});
  } else {
    table.wave_origin_V = table.reference_V;
  }
}

WaveColumnSettings column(const RaoSettings& given, double depth) {
  const auto word = given.words.find("frequencies");
  WaveColumnSettings settings;
  if (word != given.words.end()) settings.stated = from_word<WaveColumn>(word->second);
  settings.length_scale = given.length_scale;
  settings.depth = depth;
  return settings;
}

/// The mirror image of one side is that of the other only for points on the centreline.
RaoTable sides_alike(RaoTable table, double depth) {
  const double reference = table.reference_V.y(), origin = table.wave_origin_V.y();
  if (!table.one_sided() || (reference == 0.0 && origin == 0.0)) return table;
  if (reference != 0.0) {
    table.assumptions.push_back(
        {AssumptionRank::other,
         fmt::format(
             "The RAOs of {} cover one side of the vessel and are of a point {} off the centreline; for the mirror "
             "image they are moved to the centreline, and the vessel's motions in the results are of the point there.",
             table.source, shown_digits(std::abs(reference), "m", 3))});
  }
  return moved_to_centreline(std::move(table), depth);
}

}  // namespace

std::optional<RaoTable> read_raos(const std::string& file, const RaoSettings& given, double depth,
                                  Diagnostics& diagnostics) {
  const std::string ending = file_ending(file);
  if (ending != ".csv" && ending != ".4" && !is_orcaflex(ending)) {
    diagnostics.add({Severity::error, file, 0, 0, "", "a file ending in '" + for_display(ending) + "'",
                     ".csv, .4 (WAMIT) or .yml (OrcaFlex)", ""});
    return std::nullopt;
  }
  const std::optional<std::string> text = read_text_file(file, diagnostics);
  if (!text) return std::nullopt;
  return read_rao_text(*text, file, given, depth, diagnostics);
}

std::optional<RaoTable> read_rao_text(const std::string& text, const std::string& file, const RaoSettings& given,
                                      double depth, Diagnostics& diagnostics) {
  const std::string ending = file_ending(file);
  const bool orcaflex = is_orcaflex(ending);
  Diagnostics faults;
  const rao_formats::RaoFile content = orcaflex ? rao_formats::read_orcaflex(text, file, given, faults)
                                       : ending == ".4"
                                           ? rao_formats::read_wamit(text, file, column(given, depth), faults)
                                           : rao_formats::read_csv(text, file, faults);
  for (const Diagnostic& fault : faults.sorted()) diagnostics.add(fault);
  if (faults.has_errors()) return std::nullopt;
  const std::string type_set = orcaflex ? "orcaflex" : ending == ".4" ? "wamit" : "house";
  const std::string set = given.set.empty() ? type_set : given.set;
  const RaoTranslation translation(settle(set, content.stated, given), given.length_scale, depth);
  std::optional<RaoTable> table = assemble_raos(content, translation, file, diagnostics);
  if (!table) return std::nullopt;
  for (const std::string& sentence : content.assumptions) {
    table->assumptions.push_back({AssumptionRank::governing, sentence});
  }
  place_points(*table, set, content.stated, given);
  return sides_alike(std::move(*table), depth);
}

}  // namespace overbend
