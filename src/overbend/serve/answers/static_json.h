/// A static state for the page.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "results/static_results.h"
#include "serve/http/http.h"

namespace overbend {

/// Returns `key`, `pipe`, `touchdown`, `supports`, `tensioner`, `moorings`, `lines` and `findings` of POST /api/static.
/// Lists run from the tensioner to the anchor. Without a pipe, its members are null. `lists` selects the members of
/// `pipe` in addition to s, x, y and z; if null, all are returned, and `tables` too (results/tables/csv_tables.h).
Json static_json(const StaticResults& results, const std::vector<std::string>* lists = nullptr);

/// Returns all fixed objects and the sea: GET /api/scene. `seed` is the seed of the sea; default: that of a run of the
/// model.
Json scene_json(const Model& model, std::optional<std::uint64_t> seed = std::nullopt);

/// Returns [x, y, z] in frame W [m].
Json place_json(const Vec3& p_W);

/// Returns twelve numbers: position of the vessel's origin [m], then R_WV row by row.
Json pose_json(const Vec3& p_WV, const Mat3& R_WV);

}  // namespace overbend
