#include "serve/model/library_hull.h"

#include <fmt/format.h>

#include "base/shown_unit.h"
#include "seafiles/rao_reader.h"
#include "seafiles/scaled_hull.h"
#include "serve/http/page_files.h"
#include "serve/model/data_files.h"

namespace overbend {
namespace {

constexpr HullDimensions kBarge{120.0, 30.0};  ///< Length and beam of the barge of data/bgl1, see its README.md.
constexpr const char* kBargeFile = "data/bgl1/rao.csv";
constexpr double kBargeDepth = 89.0;  ///< Water depth of its RAOs [m].

RaoTable barge_raos() {
  Diagnostics errors;
  const std::string text(embedded_text(kBargeFile));
  std::optional<RaoTable> table = read_rao_text(text, kBargeFile, {}, kBargeDepth, errors);
  if (!table) throw HttpError(422, "the library hull cannot be read");
  return std::move(*table);
}

double dimension(const Json& body, const char* key, double min, double max) {
  const double value = body.contains(key) && body[key].is_number() ? body[key].get<double>() : 0.0;
  if (value >= min && value <= max) return value;
  throw HttpError(422, fmt::format("{}: expected {} to {}", key, shown(min, "m", 0), shown(max, "m", 0)));
}

std::string size_text(const HullDimensions& size) {
  return fmt::format("{} by {}", shown(size.length, "m", 1), shown(size.beam, "m", 1));
}

std::string assumption_text(const HullDimensions& size) {
  return fmt::format(
      "The vessel's motion response is that of the box barge BGL-1, {}, scaled to {} by Froude's law: sway and roll "
      "with the beam, all other motions with the length; draught and loading are assumed in proportion. Replace this "
      "estimate by the vessel's own RAOs.",
      size_text(kBarge), size_text(size));
}

HttpAnswer scaled_hull(const std::filesystem::path& folder, const HttpRequest& request) {
  const Json body = request.json();
  const HullDimensions size{dimension(body, "length", 20.0, 500.0), dimension(body, "beam", 5.0, 100.0)};
  const std::string name = fmt::format("box-hull-{:.5g}x{:.5g}m.csv", size.length, size.beam);
  const std::string title = fmt::format("Motion RAOs of a box hull of {}, scaled from BGL-1", size_text(size));
  const std::string assumption = assumption_text(size);
  write_data_file(folder, name, rao_csv(scale_raos(barge_raos(), kBarge, size), title, assumption));
  return json_answer({{"name", name}, {"assumption", assumption}});
}

}  // namespace

void add_hull_routes(std::vector<HttpRoute>& routes, const std::filesystem::path& folder) {
  routes.push_back({"POST", "/api/hull", [folder](const HttpRequest& r) { return scaled_hull(folder, r); }});
}

}  // namespace overbend
