#include "python/to_python.h"

#include <vector>

#include "base/utf8.h"

namespace overbend {
namespace {

namespace py = pybind11;

template <class Number>
py::object numbers(const std::vector<Number>& values, const std::vector<Extent>& shape, const py::object& owner) {
  if (shape.empty() && values.size() == 1) return py::cast(values.front());
  std::vector<py::ssize_t> extents(shape.begin(), shape.end());
  if (extents.empty()) extents.push_back(static_cast<py::ssize_t>(values.size()));
  py::array array(py::dtype::of<Number>(), extents, values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::object texts(const std::vector<std::string>& values, const std::vector<Extent>& shape) {
  if (shape.empty() && values.size() == 1) return py::str(valid_utf8(values.front()));
  py::list list;
  for (const std::string& value : values) list.append(valid_utf8(value));
  if (values.empty()) return py::module_::import("numpy").attr("empty")(0, "U1");
  return py::module_::import("numpy").attr("array")(list);
}

}  // namespace

py::object to_python(const Json& json) {
  switch (json.type()) {
    case Json::value_t::object: {
      py::dict object;
      for (const auto& [key, value] : json.items()) object[py::str(valid_utf8(key))] = to_python(value);
      return object;
    }
    case Json::value_t::array: {
      py::list list;
      for (const Json& value : json) list.append(to_python(value));
      return list;
    }
    case Json::value_t::string:
      return py::str(valid_utf8(json.get_ref<const std::string&>()));
    case Json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned:
      return py::int_(json.get<std::int64_t>());
    case Json::value_t::number_float:
      return py::float_(json.get<double>());
    default:
      return py::none();
  }
}

py::object to_python(const Dataset& dataset, const py::object& owner) {
  if (const auto* values = std::get_if<std::vector<double>>(&dataset.values)) {
    return numbers(*values, dataset.shape, owner);
  }
  if (const auto* values = std::get_if<std::vector<std::int64_t>>(&dataset.values)) {
    return numbers(*values, dataset.shape, owner);
  }
  return texts(std::get<std::vector<std::string>>(dataset.values), dataset.shape);
}

py::tuple dataset_tuple(const Dataset& dataset, const py::object& owner) {
  py::list scales;
  for (const std::string& scale : dataset.scales) scales.append(valid_utf8(scale));
  return py::make_tuple(to_python(dataset, owner), valid_utf8(dataset.units), valid_utf8(dataset.description),
                        valid_utf8(dataset.frame), scales);
}

}  // namespace overbend
