/// Data of a run for the page.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "results/dynamic_sink.h"
#include "serve/http/http.h"

namespace overbend {

/// Time window of a history [s] and the number of points to draw.
struct SeriesWindow {
  double from = 0.0, to = 0.0;
  std::size_t points = 0;
};

/// Returns `{t, min, max}`: the window divided into at most `points` equal groups of rows, with first time, minimum and
/// maximum of each.
Json series_json(std::span<const double> time, std::span<const double> values, const SeriesWindow& window);

/// Returns `{frequency, density, segments, std}`: one-sided spectral density over frequency [Hz] of the equally spaced
/// rows from t = 0, and their standard deviation; empty lists for fewer than 8 rows.
Json spectrum_json(std::span<const double> time, std::span<const double> values);

/// Returns `[{name, unit, text}]` without the time.
Json columns_json(const std::vector<HistoryColumn>& columns);

/// Returns the envelopes in results.h5. All functions below throw std::runtime_error if the file is not a valid results
/// file, and must be called with RunQueue::files() held.
Json envelopes_json(const std::filesystem::path& h5);
/// Returns the impacts.
Json impacts_json(const std::filesystem::path& h5);

/// Returns the initial static state of a run, like POST /api/static.
Json run_statics_json(const std::filesystem::path& h5);
/// Returns the fixed objects and the sea of a run, like GET /api/scene. `file` is the path of its model. HttpError if
/// the model text stored with the results can no longer be read.
Json run_scene_json(const std::filesystem::path& h5, const std::string& file);

/// Returns at most `count` frames starting at `first`, as little-endian float32 in base64.
Json frames_json(const std::filesystem::path& h5, std::int64_t first, std::int64_t count);

}  // namespace overbend
