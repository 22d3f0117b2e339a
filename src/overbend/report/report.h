/// The HTML report of a static or dynamic analysis: one file that opens offline in any browser and prints on A4.
///
///     results ---> tables (HTML, made here) + figures' data (one JSON block) + page (style, scripts, d3; embedded)
///
/// Tables do not need scripts; figures are drawn as SVG when the page is opened. Nothing is fetched from anywhere.
#pragma once

#include <filesystem>
#include <string>

#include "results/dynamic_results.h"
#include "results/seek_results.h"
#include "results/sensitivity_results.h"

namespace overbend {

/// What may come with a static analysis; null for none.
struct StaticExtras {
  const SensitivityResults* sensitivities = nullptr;
  const SeekResults* seek = nullptr;  ///< Of statics that a goal seek ended at.
};

/// The whole page. `model_text` is the model file as the user wrote it; it is printed, and its inputs are listed.
/// `extras` get sections of their own.
std::string report_html(const StaticResults& results, const std::string& model_text, const StaticExtras& extras = {});

/// The page of a dynamic run: its own results first, then the static state that it
/// starts from.
std::string report_html(const StaticResults& statics, const DynamicResults& results, const std::string& model_text);

/// Writes the page to `file`, beside it first and then renamed. Throws std::runtime_error where that fails.
void write_report(const StaticResults& results, const std::string& model_text, const std::filesystem::path& file,
                  const StaticExtras& extras = {});
void write_report(const StaticResults& statics, const DynamicResults& results, const std::string& model_text,
                  const std::filesystem::path& file);

}  // namespace overbend
