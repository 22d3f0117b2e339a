/// Data of a run for display on the page.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "results/dynamic_sink.h"
#include "serve/http/http.h"

namespace overbend {

/// A stretch of a history [s] and how many points it is to be drawn with.
struct SeriesWindow {
  double from = 0.0, to = 0.0;
  std::size_t points = 0;
};

/// `{t, min, max}`: the window cut into at most `points` equal runs of rows, of each its first time, least and greatest
/// value.
Json series_json(std::span<const double> time, std::span<const double> values, const SeriesWindow& window);

/// `{frequency, density, segments, std}`: one-sided spectral density over frequency [Hz] of the rows from t = 0 on,
/// which are equally spaced, and their standard deviation; empty lists for fewer than 8 rows.
Json spectrum_json(std::span<const double> time, std::span<const double> values);

/// `[{name, unit, text}]`, without the time.
Json columns_json(const std::vector<HistoryColumn>& columns);

/// The same out of results.h5. Like the others here: throws std::runtime_error when the file is none of ours, and is
/// called with RunQueue::files() held.
Json envelopes_json(const std::filesystem::path& h5);
Json impacts_json(const std::filesystem::path& h5);

/// The static state that a run began with, as POST /api/static gives it.
Json run_statics_json(const std::filesystem::path& h5);
/// Everything that does not move in a run, and its sea, as GET /api/scene. `file`: path of its model as it was
/// read. HttpFault where the text stored with the results is none that is read today.
Json run_scene_json(const std::filesystem::path& h5, const std::string& file);

/// At most `count` frames from `first` on, in base64 of little-endian float32.
Json frames_json(const std::filesystem::path& h5, std::int64_t first, std::int64_t count);

}  // namespace overbend
