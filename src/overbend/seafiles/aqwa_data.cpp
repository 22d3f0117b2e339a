#include "seafiles/aqwa_data.h"

#include <fmt/format.h>

#include <cmath>

#include "seafiles/body_number.h"
#include "seafiles/hull_data_builder.h"
#include "seafiles/hull_statements.h"

namespace overbend {
namespace {

void add_structure(HullDataBuilder& builder, const AqwaData::Structure& structure) {
  for (const auto& [omega, matrices] : structure.radiation) {
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        if (matrices.has_mass) builder.add_added_mass(omega, i, j, matrices.added_mass(i, j), matrices.line);
        if (matrices.has_damping) builder.add_damping(omega, i, j, matrices.damping(i, j), matrices.line);
      }
    }
  }
  for (const AqwaData::WaveValues& values : structure.forces) {
    for (std::size_t k = 0; k < 6; ++k) {
      builder.add_force(values.omega, values.heading, static_cast<int>(k),
                        std::polar(1.0, -values.phase[k]) * values.amplitude[k], values.line);
    }
  }
}

HydrodynamicData convert_structure(const AqwaData& file, const HydrodynamicsSource& source,
                                   HullStatements& statements) {
  const AqwaData::Structure& structure = find_structure(file, source.body);
  const HydrodynamicsSource defaults;
  HydrodynamicData data;
  data.source = source.path;
  data.origin_V = source.origin_V;
  data.water_density = file.water_density ? settled_constant("water_density", source.water_density,
                                                             defaults.water_density, *file.water_density)
                                          : source.water_density;
  data.gravity =
      file.gravity ? settled_constant("gravity", source.gravity, defaults.gravity, *file.gravity) : source.gravity;
  HullDataBuilder builder;
  add_structure(builder, structure);
  builder.build(data, source.mirror_headings);
  if (!structure.stiffness) throw HullFileError("no hydrostatic stiffness", "that of the structure");
  data.hydrostatic_stiffness = *structure.stiffness;
  if (!structure.centre_of_gravity) throw HullFileError("no centre of gravity", "that of the structure");
  statements.water_depth = file.water_depth;
  statements.mass = structure.mass;
  statements.displaced_volume = structure.volume;
  statements.centre_of_gravity = source.file_origin + *structure.centre_of_gravity;
  statements.reference = statements.centre_of_gravity;
  if (file.structures.size() > 1) {
    data.notes.push_back(
        fmt::format("Structure {} of {} in {} is used; the forces that motions of the others cause on "
                    "it are left out.",
                    source.body.value_or(1), file.structures.size(), file_name(source.path)));
  }
  return data;
}

}  // namespace

const AqwaData::Structure& find_structure(const AqwaData& data, const std::optional<int>& number) {
  std::vector<const AqwaData::Structure*> list;
  for (const auto& [key, structure] : data.structures) {
    if (key != static_cast<int>(list.size()) + 1) {
      throw HullFileError("a structure " + std::to_string(key), "structures counted from 1");
    }
    list.push_back(&structure);
  }
  return *list[find_body(number, std::vector<std::string>(list.size()))];
}

std::optional<HydrodynamicData> read_aqwa(const HydrodynamicsSource& source, bool database, Diagnostics& diagnostics) {
  try {
    const HullText text = HullText::read(source.path);
    const AqwaData file = database ? parse_aqwa_database(text) : parse_aqwa_listing(text);
    HullStatements statements;
    HydrodynamicData data = convert_structure(file, source, statements);
    check_same_frequencies(data, source.path, source.path, diagnostics);
    complete_hull(data, statements, source, diagnostics);
    return data;
  } catch (const HullFileError& error) {
    add_error(error, source.path, diagnostics);
    return std::nullopt;
  }
}

}  // namespace overbend
