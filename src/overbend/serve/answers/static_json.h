/// A static state as the page draws it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "results/static_results.h"
#include "serve/http/http.h"

namespace overbend {

/// `key`, `pipe`, `touchdown`, `supports`, `tensioner`, `moorings`, `lines` and `warnings` of POST /api/static. Lists
/// run from the tensioner to the anchor. Without a pipe what is told of one is null. `lists`: which of `pipe` are
/// wanted beside s, x, y and z; all when null, and then `tables` as well (results/tables/result_tables.h).
Json static_json(const StaticResults& results, const std::vector<std::string>* lists = nullptr);

/// Everything that does not move, and the sea: GET /api/scene. The sea has the seed given, else that of a run of the
/// model.
Json scene_json(const Model& model, std::optional<std::uint64_t> seed = std::nullopt);

/// [x, y, z] in W.
Json place_json(const Vec3& p_W);

/// Twelve numbers: place of the vessel's origin, then R_WV row by row.
Json pose_json(const Vec3& p_WV, const Mat3& R_WV);

}  // namespace overbend
