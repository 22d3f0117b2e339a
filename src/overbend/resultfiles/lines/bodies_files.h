/// Bodies that lines are on in the files of results: static.bodies and dynamic.bodies of summary.json, rows below a
/// group of results.h5.
#pragma once

#include <string>
#include <vector>

#include "resultfiles/hdf5/dataset_sink.h"
#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/summary/json_fields.h"
#include "results/dynamic_results.h"

namespace overbend {

/// A group for every body, by its number from 0, below `group`. Nothing without bodies.
void write_bodies(DatasetSink& file, const std::string& group, const std::vector<BodyResult>& bodies);
std::vector<BodyResult> read_bodies(const Hdf5Reader& file, const std::string& group);

/// The group /dynamic/bodies.
void write_bodies_in_time(DatasetSink& file, const std::vector<BodyDynamics>& bodies);
std::vector<BodyDynamics> read_bodies_in_time(const Hdf5Reader& file);

/// Rows of a summary.
Json bodies_json(const std::vector<BodyResult>& bodies);

/// Throw std::runtime_error that names the quantity which is no number.
void require_finite(const std::vector<BodyResult>& bodies);
void require_finite(const std::vector<BodyDynamics>& bodies);

}  // namespace overbend
