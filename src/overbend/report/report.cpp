#include "report/report.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "io/yaml_reader.h"
#include "report/assets.h"
#include "report/figures.h"
#include "report/html.h"
#include "report/report_data.h"
#include "report/sections.h"

namespace overbend {
namespace {

std::string script(std::string_view text) {
  return "<script>\n" + std::string(text) + "\n</script>\n";
}

std::string head(const StaticResults& results) {
  return "<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>" +
         html::escape(results.title) + " - static analysis</title>\n<style>\n" + std::string(report_asset("style")) +
         "</style>\n</head>\n";
}

std::string scripts(const StaticResults& results) {
  std::string out = "<script type=\"application/json\" id=\"results-data\">" + html::escape_json(report_data(results)) +
                    "</script>\n";
  for (const char* name : {"d3", "data", "chart", "diagrams", "bars", "side_view", "painter", "scene", "main"}) {
    out += script(report_asset(name));
  }
  return out;
}

std::string now() {
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
}

}  // namespace

std::string report_html(const StaticResults& results, const std::string& model_text) {
  if (results.stations.empty()) {
    throw std::logic_error("a report needs results with stations");
  }
  // The inputs are told as the program understands them; what it can not read any more is still printed at the end.
  const std::optional<Description> description = read_model_text(model_text, "model.yaml").description;
  const std::string tables = "<div class=\"wide\">\n" +
                             html::section("summary", "Static summary", static_summary_table(results)) + "</div>\n" +
                             (results.supports.empty() ? ""
                                                       : html::section("supports", "Supports",
                                                                       support_table(results) + roller_table(results)));
  return "<!DOCTYPE html>\n<html lang=\"en\">\n" + head(results) + "<body>\n<main>\n" + title_block(results, now()) +
         key_results(results) + warnings_section(results) + figures_section(results) + tables +
         inputs_section(results, description) + assumptions_section(results) + balance_section(results) +
         model_text_section(model_text) + "</main>\n" + scripts(results) + "</body>\n</html>\n";
}

void write_report(const StaticResults& results, const std::string& model_text, const std::filesystem::path& file) {
  const std::string page = report_html(results, model_text);
  const std::filesystem::path beside = file.parent_path() / ("." + file.filename().string() + ".part");
  std::ofstream out(beside, std::ios::binary | std::ios::trunc);
  out << page;
  out.close();
  std::error_code error;
  if (out) {
    std::filesystem::rename(beside, file, error);
  }
  if (!out || error) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    throw std::runtime_error(file.string() + ": the report can not be written" +
                             (error ? ": " + error.message() : std::string()));
  }
}

}  // namespace overbend
