/// Conversion of values of the engine to Python.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>

#include "base/json.h"
#include "resultfiles/hdf5/dataset.h"

namespace overbend {

/// Converts JSON to dicts, lists, numbers, strings and None.
pybind11::object to_python(const Json& json);

/// Returns the values of a dataset: a read-only array that shares its memory, which `owner` keeps alive; a new array of
/// str for texts; a scalar for a dataset without dimensions.
pybind11::object to_python(const Dataset& dataset, const pybind11::object& owner);

/// Returns (values, units, description, frame, scales) of a dataset.
pybind11::tuple dataset_tuple(const Dataset& dataset, const pybind11::object& owner);

}  // namespace overbend
