/// Values of the engine as values of Python.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>

#include "base/json.h"
#include "resultfiles/hdf5/dataset.h"

namespace overbend {

/// Dicts, lists, numbers, texts and None.
pybind11::object to_python(const Json& json);

/// The values of a dataset that `owner` keeps alive: read-only arrays on the same memory, of texts a new array of str;
/// what has no dimension is a single value.
pybind11::object to_python(const Dataset& dataset, const pybind11::object& owner);

/// A dataset with what is told of it: (values, units, description, frame, scales).
pybind11::tuple told(const Dataset& dataset, const pybind11::object& owner);

}  // namespace overbend
