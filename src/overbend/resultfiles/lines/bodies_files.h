/// Bodies connected to lines in the result files: static.bodies and dynamic.bodies of summary.json, rows below a group
/// of results.h5.
#pragma once

#include <string>
#include <vector>

#include "resultfiles/hdf5/dataset_sink.h"
#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/summary/json_fields.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Writes a group for every body, by its number from 0, below `group`. Nothing without bodies.
void write_bodies(DatasetSink& file, const std::string& group, const std::vector<BodyResult>& bodies);
std::vector<BodyResult> read_bodies(const Hdf5Reader& file, const std::string& group);

/// Writes the group /dynamic/bodies.
void write_bodies_in_time(DatasetSink& file, const std::vector<BodyDynamics>& bodies);
std::vector<BodyDynamics> read_bodies_in_time(const Hdf5Reader& file);

/// Returns the rows of a summary.
Json bodies_json(const std::vector<BodyResult>& bodies);

/// Throw std::runtime_error that names the first quantity that is not finite.
void require_finite(const std::vector<BodyResult>& bodies);
void require_finite(const std::vector<BodyDynamics>& bodies);

}  // namespace overbend
