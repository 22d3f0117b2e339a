#include "seafiles/wave_file_reader.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "model/site/sea_statistics.h"
#include "model/waves/peak_period.h"
#include "model/waves/wave_theory.h"
#include "seafiles/elevation_reader.h"
#include "seafiles/ndbc_reader.h"
#include "seafiles/spectrum_reader.h"
#include "seafiles/swan_spectrum_reader.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

bool exists(const std::string& path) {
  std::error_code error;
  return !path.empty() && std::filesystem::exists(path, error);
}

class WaveFile {
 public:
  WaveFile(WavesDescription& waves, Diagnostics& diagnostics) : waves_(waves), diagnostics_(diagnostics) {}

  void read_elevation() {
    const std::optional<std::string> text = read_text_file(waves_.elevation_file, diagnostics_);
    if (!text) return;
    const std::optional<ElevationRecord> record = read_elevation_text(*text, waves_.elevation_file, diagnostics_);
    if (!record) return;
    waves_.record = *record;
    waves_.hs = record_statistics(*record).hs;
    waves_.assumptions.push_back({AssumptionRank::setting, "The mean of the measured elevation, " +
                                                               format_number(record->mean, 3) +
                                                               " m, is subtracted; t = 0 is the first row."});
  }

  void read_spectrum() {
    const std::string& path = waves_.spectrum_file;
    const std::optional<std::string> text = read_text_file(path, diagnostics_);
    if (!text) return;
    const WaveFileRequest request{
        {path, waves_.key + ".time", waves_.time}, waves_.location, waves_.key + ".location", *text};
    if (is_ndbc(*text)) {
      warn_unused(waves_.location.has_value(), "location");
      take(read_ndbc(request, diagnostics_));
    } else if (is_swan(*text)) {
      take(read_swan_spectrum(request, diagnostics_));
    } else {
      take_csv(*text);
    }
  }

 private:
  void reject(std::string found, std::string expected, std::string hint) {
    diagnostics_.add({Severity::error, waves_.spectrum_file, 0, 0, waves_.key, std::move(found), std::move(expected),
                      std::move(hint)});
  }

  void warn_unused(bool given, const char* key) {
    if (!given) return;
    diagnostics_.add({Severity::warning, waves_.spectrum_file, 0, 0, waves_.key + "." + key,
                      "the file has no choice of this kind: it is not used", "", "", FindingCode::unused_input});
  }

  void take_csv(const std::string& text) {
    if (waves_.type != WaveType::user) return reject_spectrum();
    warn_unused(!waves_.time.empty(), "time");
    warn_unused(waves_.location.has_value(), "location");
    waves_.spectrum = read_spectrum_text(text, waves_.spectrum_file, diagnostics_);
    waves_.hs = sea_statistics(waves_.spectrum).hs;
  }

  void reject_spectrum() {
    reject("a spectrum for waves of type " + std::string(enum_name(waves_.type)),
           "type user, or an NDBC file of WVHT and DPD", "the shape is that of the type or of the file, not both");
  }

  void take(std::optional<WaveFileContent> content) {
    if (!content) return;
    if (content->state && waves_.type == WaveType::user) {
      return reject("sea states, WVHT and DPD, and no spectrum", "a file of a spectrum for waves of type user",
                    "give type jonswap or pierson_moskowitz, the shape that height and period are for");
    }
    if (!content->state && waves_.type != WaveType::user) return reject_spectrum();
    if (content->state) {
      take_state(*content->state);
    } else {
      waves_.hs = sea_statistics(content->spectrum).hs;
    }
    waves_.spectrum = std::move(content->spectrum);
    waves_.directions = std::move(content->directions);
    waves_.file_gives_direction = content->from.has_value();
    if (content->from) waves_.from = *content->from;
    append(content->assumptions);
  }

  void append(const Assumptions& assumptions) {
    waves_.assumptions.insert(waves_.assumptions.end(), assumptions.begin(), assumptions.end());
  }

  void take_state(const FileSeaState& state) {
    constexpr double kMaxHeight = 40.0, kMinPeriod = 0.5, kMaxPeriod = 100.0;  // limits of the keys hs [m] and tp [s]
    if (state.hs > kMaxHeight || state.tp < kMinPeriod || state.tp > kMaxPeriod) {
      diagnostics_.add({Severity::error, waves_.spectrum_file, state.line, 0, "WVHT, DPD",
                        format_number(state.hs) + " m and " + format_number(state.tp) + " s",
                        "at most 40 m, and 0.5 to 100 s", ""});
      return;
    }
    waves_.hs = state.hs;
    waves_.tp = state.tp;
    if (state.tz && *state.tz > 0.0) compare_crossing_period(state);
  }

  /// Peak period and zero up-crossing period together fix the shape: warns where the chosen one has another.
  void compare_crossing_period(const FileSeaState& state) {
    constexpr double kAlike = 0.1;
    const double gamma =
        waves_.type == WaveType::pierson_moskowitz ? 1.0 : waves_.gamma.value_or(jonswap_gamma(state.hs, state.tp));
    const double tz = state.tp / tp_over_tz(gamma);
    if (std::abs(tz - *state.tz) <= kAlike * *state.tz) return;
    diagnostics_.add({Severity::warning, waves_.spectrum_file, state.line, 0, "APD",
                      "the measured zero up-crossing period is " + format_number(*state.tz, 3) +
                          " s, that of the spectrum is " + format_number(tz, 3) +
                          " s: the measured sea has another shape, such as wind sea with swell",
                      "", ""});
  }

  WavesDescription& waves_;
  Diagnostics& diagnostics_;
};

}  // namespace

void read_wave_file(WavesDescription& waves, Diagnostics& diagnostics) {
  const bool has_spectrum =
      waves.type == WaveType::user || waves.type == WaveType::jonswap || waves.type == WaveType::pierson_moskowitz;
  if (waves.type == WaveType::elevation && exists(waves.elevation_file)) {
    WaveFile(waves, diagnostics).read_elevation();
  } else if (has_spectrum && exists(waves.spectrum_file)) {
    WaveFile(waves, diagnostics).read_spectrum();
  }
}

}  // namespace overbend
