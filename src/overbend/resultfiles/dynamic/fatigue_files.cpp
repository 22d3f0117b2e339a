#include "resultfiles/dynamic/fatigue_files.h"

#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/tables/csv_fields.h"
#include "results/fields/fatigue_fields.h"

namespace overbend {
namespace {

constexpr const char* kGroup = "/dynamic/fatigue";
constexpr const char* kSpots = "/dynamic/fatigue/spots";

std::string along_group(std::size_t spot) {
  return std::string(kGroup) + "/along_" + std::to_string(spot);
}

void write_along(DatasetSink& file, std::size_t number, const FatigueSpot& spot) {
  file.group(along_group(number), "Spot " + std::to_string(number) + " at the stations of /dynamic/stations");
  auto write = [&](const ResultField& field, const std::vector<double>& values) {
    const std::string path = along_group(number) + "/" + field.name;
    file.write(path, field, values, {values.size()});
    file.attach_scale(path, "/dynamic/stations/s");
  };
  visit_fatigue_along(spot, write);
}

}  // namespace

std::string fatigue_table(const DynamicResults& results) {
  std::vector<std::string> head = {headed("s", shown_name("m")), headed("from tensioner", shown_name("m"))};
  for (const FatigueSpot& spot : results.fatigue->spots) {
    auto name = [&](const ResultField& field, const std::vector<double>&) {
      head.push_back(headed(spot.name + " " + std::string(field.heading), shown_unit(field).name));
    };
    visit_fatigue_along(spot, name);
  }
  CsvTable table(head);
  for (std::size_t i = 0; i < results.station_s.size(); ++i) {
    const double metre = shown_unit("m").factor;
    table.cell(metre * results.station_s[i]).cell(metre * (results.station_s.back() - results.station_s[i]));
    for (const FatigueSpot& spot : results.fatigue->spots) {
      auto value = [&](const ResultField& field, const std::vector<double>& values) {
        table.cell(values[i] * shown_unit(field).factor);
      };
      visit_fatigue_along(spot, value);
    }
    table.end_row();
  }
  return table.text();
}

void write_fatigue(DatasetSink& file, const DynamicResults& results) {
  if (!results.fatigue) return;
  file.group(kGroup, "Fatigue of welds during laying");
  ValueWriter values{file, kGroup};
  visit_fatigue(*results.fatigue, values);
  TableWriter spots;
  for (const FatigueSpot& spot : results.fatigue->spots) {
    spots(index_field("Number of the spot, from 0"), spots.rows());
    visit_fatigue_spot(spot, spots);
    spots.end_row();
  }
  spots.write(file, kSpots, "Positions on the weld");
  for (std::size_t i = 0; i < results.fatigue->spots.size(); ++i) write_along(file, i, results.fatigue->spots[i]);
}

void read_fatigue(const Hdf5Reader& file, DynamicResults& results) {
  if (!file.has(kGroup)) return;
  FatigueResults& fatigue = results.fatigue.emplace();
  ValueReader values{file, kGroup};
  visit_fatigue(fatigue, values);
  TableReader spots(file, kSpots);
  fatigue.spots.resize(spots.rows("index"));
  for (std::size_t i = 0; i < fatigue.spots.size(); ++i) {
    spots.start_row(i);
    visit_fatigue_spot(fatigue.spots[i], spots);
    auto read = [&](const ResultField& field, std::vector<double>& list) {
      list = file.doubles(along_group(i) + "/" + field.name);
    };
    visit_fatigue_along(fatigue.spots[i], read);
  }
}

}  // namespace overbend
