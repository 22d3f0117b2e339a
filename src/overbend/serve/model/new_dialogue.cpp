#include "serve/model/new_dialogue.h"

#include <fmt/format.h>

#include <array>

#include "report/page/json_number.h"
#include "study/run/new_lay.h"

namespace overbend {
namespace {

/// Returns the API 5L wall thicknesses [m] with D/t from 10 to 60.
Json find_walls(double diameter) {
  Json walls = Json::array();
  for (const double millimetres : api_walls()) {
    const double slenderness = diameter / (1e-3 * millimetres);
    if (slenderness >= 10.0 && slenderness <= 60.0) walls.push_back(seven_digits(1e-3 * millimetres));
  }
  return walls;
}

Json pipes() {
  Json list = Json::array();
  for (int inches = 4; inches <= 48; inches += 2) {
    const std::optional<double> diameter = nominal_diameter(inches);
    if (!diameter) continue;
    list.push_back({{"name", std::to_string(inches)},
                    {"outside_diameter", seven_digits(*diameter)},
                    {"walls", find_walls(*diameter)}});
  }
  return list;
}

/// Returns API 5L grades with their yield stress; the table is in MPa.
Json grades() {
  constexpr std::array<std::pair<const char*, int>, 7> kGrades = {
      {{"X42", 290}, {"X52", 359}, {"X56", 386}, {"X60", 414}, {"X65", 450}, {"X70", 485}, {"X80", 555}}};
  Json list = Json::array();
  for (const auto& [name, yield] : kGrades) list.push_back({{"name", name}, {"yield", yield * 1e6}});
  return list;
}

Json vessels() {
  Json list = Json::array();
  for (const auto& [name, title] :
       {std::pair{"barge", "Flat barge for shallow water"}, {"BGL-1", "BGL-1, lay barge"}, {"ship", "Lay ship"}}) {
    const VesselSize size = vessel_size(name);
    list.push_back({{"name", name},
                    {"title", title},
                    {"length", size.length},
                    {"beam", size.beam},
                    {"depth", size.depth},
                    {"draught", size.draught}});
  }
  return list;
}

/// Reads an answer given as a text or a number.
void take(const Json& answers, const char* key, std::string& into) {
  const auto found = answers.find(key);
  if (found == answers.end() || found->is_null()) return;
  const std::string text = found->is_string() ? found->get<std::string>() : json_text(*found);
  if (!text.empty()) into = text;
}

void take_boxes(const Json& answers, int& boxes) {
  std::string text;
  take(answers, "boxes", text);
  if (text.empty()) return;
  const bool number = text.size() <= 3 && text.find_first_not_of("0123456789") == std::string::npos;
  boxes = number ? std::stoi(text) : -1;
  if (boxes < 1 || boxes > 100) {
    HttpError error(422, "boxes: found '" + text + "', expected a whole number from 1 to 100");
    error.more["key"] = "boxes";
    throw error;
  }
}

/// Throws HttpError 422. A message that names an option of the command, "--wall: found ...", gets the key of the
/// answer.
[[noreturn]] void throw_answer_error(std::string why) {
  std::string key;
  if (why.starts_with("--")) {
    why.erase(0, 2);
    key = why.substr(0, why.find_first_of(": "));
    for (char& c : key) c = c == '-' ? '_' : c;
  }
  HttpError error(422, why);
  error.more["key"] = key;
  throw error;
}

NewOptions read_options(const Json& answers) {
  NewOptions options;
  take(answers, "pipe", options.pipe);
  take(answers, "depth", options.depth);
  take(answers, "wall", options.wall);
  take(answers, "yield", options.yield);
  take(answers, "coating", options.coating);
  take(answers, "concrete", options.concrete);
  take(answers, "lay", options.lay);
  take(answers, "vessel", options.vessel);
  take(answers, "stinger_radius", options.stinger_radius);
  take(answers, "tension", options.tension);
  take(answers, "title", options.title);
  take_boxes(answers, options.boxes);
  if (options.lay != "s" && options.lay != "j") {
    throw_answer_error("--lay: found '" + options.lay + "', expected s or j");
  }
  if (!options.vessel.empty() && options.vessel != "barge" && options.vessel != "BGL-1" && options.vessel != "ship") {
    throw_answer_error("--vessel: found '" + options.vessel + "', expected barge, BGL-1 or ship");
  }
  return options;
}

}  // namespace

Json new_dialogue() {
  const NewOptions defaults;
  return {{"pipes", pipes()},
          {"grades", grades()},
          {"vessels", vessels()},
          {"defaults",
           {{"pipe", kDefaultPipe},
            {"depth", kUsualDepth},
            {"lay", defaults.lay},
            {"yield", defaults.yield},
            {"coating", defaults.coating}}}};
}

std::string new_text(const Json& answers) {
  const std::variant<NewLay, std::string> chosen = choose_lay(read_options(answers));
  if (const auto* why = std::get_if<std::string>(&chosen)) throw_answer_error(*why);
  return std::get<NewLay>(chosen).text;
}

}  // namespace overbend
