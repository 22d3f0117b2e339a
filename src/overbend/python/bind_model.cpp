// Models: read, changed, looked at.
#include <pybind11/stl.h>

#include "model/model.h"
#include "modelfile/yaml/moved_text.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/model_handle.h"
#include "python/to_python.h"
#include "python/without_lock.h"
#include "study/run/input_findings.h"

namespace overbend {
namespace {

namespace py = pybind11;
using ModelPointer = std::shared_ptr<ModelHandle>;
using GivenModel = Given<ModelHandle>;

YamlChange change_of(const std::tuple<std::string, std::string, std::string>& told) {
  const auto& [key, kind, value] = told;
  if (kind == "scalar") return {key, YamlChange::Kind::scalar, value};
  if (kind == "flow") return {key, YamlChange::Kind::flow, value};
  if (kind == "remove") return {key, YamlChange::Kind::remove, value};
  throw std::invalid_argument("'" + key + "': found the kind '" + kind + "', expected scalar, flow or remove");
}

ModelPointer changed(const GivenModel& model,
                     const std::vector<std::tuple<std::string, std::string, std::string>>& told) {
  std::vector<YamlChange> changes;
  for (const auto& one : told) changes.push_back(change_of(one));
  return interruptible([&] { return model->changed(changes); });
}

py::object value_of(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::map: {
      py::dict map;
      for (const YamlEntry& entry : node.entries) map[py::str(entry.key)] = value_of(entry.value);
      return map;
    }
    case YamlNode::Kind::list: {
      py::list list;
      for (const YamlNode& item : node.items) list.append(value_of(item));
      return list;
    }
    case YamlNode::Kind::scalar:
      return py::str(node.text);
    case YamlNode::Kind::null:
      break;
  }
  return py::none();
}

py::object find(const GivenModel& model, const std::string& key) {
  const YamlNode* node = without_lock([&] { return model->find(key); });
  return node == nullptr ? py::object(py::none()) : value_of(*node);
}

const Description& whole(const GivenModel& model) {
  return *interruptible([&] { return &model->description(); });
}

}  // namespace

void add_model(py::module_& module) {
  py::class_<ModelHandle, std::shared_ptr<ModelHandle>>(module, "Model", "A model file as it was read.")
      .def_static(
          "read", [](const std::string& path) { return interruptible([&] { return ModelHandle::read(path); }); },
          py::arg("path"))
      .def_static(
          "from_text",
          [](const std::string& text, const std::string& file) {
            return interruptible([&] { return ModelHandle::from_text(text, file); });
          },
          py::arg("text"), py::arg("file"))
      .def("changed", &changed, py::arg("changes"),
           "The model with keys set: (key, 'scalar' or 'flow' or 'remove', value).")
      .def(
          "moved",
          [](const GivenModel& model, const std::string& folder) {
            return moved_text(model->text(), model->file(), folder);
          },
          py::arg("folder"), "The text for a file in another folder: files that the model names are named from there.")
      .def("value", &find, py::arg("key"), "What the text has for a key; None where it is left out.")
      .def_property_readonly("tree", [](const GivenModel& model) { return value_of(model->tree()); })
      .def_property_readonly("text", [](const GivenModel& model) { return model->text(); })
      .def_property_readonly("file", [](const GivenModel& model) { return model->file(); })
      .def_property_readonly("title", [](const GivenModel& model) { return model->still().title; })
      .def_property_readonly("has_pipe", [](const GivenModel& model) { return model->still().has_pipe; })
      .def_property_readonly("assumptions",
                             [](const GivenModel& model) { return texts(assumptions(build_model(whole(model)))); })
      .def_property_readonly("findings", [](const GivenModel& model) {
        return to_python(findings_json(input_findings(build_model(whole(model)))));
      });
}

}  // namespace overbend
