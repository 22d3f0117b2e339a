#include "report/page.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "report/assets.h"
#include "report/html.h"
#include "runstore/replace_file.h"

namespace overbend {
namespace {

std::string script(std::string_view text) {
  return "<script>\n" + std::string(text) + "\n</script>\n";
}

std::string head(const std::string& title) {
  return "<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>" +
         html::escape(title) + "</title>\n<style>\n" + std::string(report_asset("style")) + "</style>\n</head>\n";
}

std::string scripts(const std::string& data) {
  std::string out = "<script type=\"application/json\" id=\"results-data\">" + html::escape_json(data) + "</script>\n";
  for (const char* name :
       {"d3", "data", "chart", "along", "diagrams", "envelopes", "checks", "in_time", "histories", "bars", "contacts",
        "compared_tensioner", "compared_contact", "side_view", "painter", "scene", "main"}) {
    out += script(report_asset(name));
  }
  return out;
}

}  // namespace

std::string whole_page(const std::string& title, const std::string& body, const std::string& data) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n" + head(title) + "<body>\n<main>\n" + body + "</main>\n" +
         scripts(data) + "</body>\n</html>\n";
}

void write_page(const std::string& page, const std::filesystem::path& file) {
  replace_file(file, page);
}

std::string written_now() {
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
}

}  // namespace overbend
