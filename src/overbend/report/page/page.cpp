#include "report/page/page.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <string_view>

#include "base/shown_unit.h"
#include "report/page/assets.h"
#include "report/page/html.h"
#include "runstore/replace_file.h"

namespace overbend {
namespace {

/// Display units of SI values in the figures.
Json units() {
  Json all = Json::object();
  const auto put = [&](std::string_view si, const ShownUnit& unit) {
    all[std::string(si)] = {{"name", unit.name}, {"factor", unit.factor}, {"more", unit.more}};
  };
  for (const ShownUnit& unit : shown_units(units_in_use())) put(unit.si, unit);
  put("section", section_length());
  return all;
}

std::string data_slot(const char* id, const Json& data) {
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id,
                     html::escape_json(json_text(data)));
}

Json document_json(const Document& document) {
  return {{"title", document.title},
          {"paper", units_in_use() == UnitSystem::us ? "letter" : "A4"},
          {"front", document.front},
          {"body", document.body.json()}};
}

}  // namespace

std::string page_text(const Document& document) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" href=\"data:,\">\n"
      "<title>{}</title>\n<style>\n{}\n</style>\n</head>\n<body>\n<div "
      "id=\"report\"></div>\n<noscript>\n<main>\n{}</main>\n</noscript>\n"
      "{}{}{}<script>\n{}\n</script>\n</body>\n</html>\n",
      html::escape(document.title), report_asset("style"), html::plain(document),
      data_slot("document", document_json(document)), data_slot("results-data", document.data),
      data_slot("shown-units", units()), report_asset("script"));
}

void write_page(const Document& document, const std::filesystem::path& file) {
  replace_file(file, page_text(document));
}

std::string written_now() {
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
}

}  // namespace overbend
