// Models: reading, changing, inspecting.
#include <pybind11/stl.h>

#include "model/model.h"
#include "modelfile/yaml/moved_text.h"
#include "python/background_work.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/model_handle.h"
#include "python/to_python.h"
#include "study/run/input_findings.h"

namespace overbend {
namespace {

namespace py = pybind11;
using ModelPointer = std::shared_ptr<ModelHandle>;
using GivenModel = Given<ModelHandle>;

YamlChange make_change(const std::tuple<std::string, std::string, std::string>& request) {
  const auto& [key, kind, value] = request;
  if (kind == "scalar") return {key, YamlChange::Kind::scalar, value};
  if (kind == "flow") return {key, YamlChange::Kind::flow, value};
  if (kind == "remove") return {key, YamlChange::Kind::remove, value};
  throw std::invalid_argument("'" + key + "': found the kind '" + kind + "', expected scalar, flow or remove");
}

ModelPointer changed(const GivenModel& model,
                     const std::vector<std::tuple<std::string, std::string, std::string>>& requests) {
  std::vector<YamlChange> changes;
  for (const auto& request : requests) changes.push_back(make_change(request));
  return interruptible([&] { return model->changed(changes); });
}

py::object python_value(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::map: {
      py::dict map;
      for (const YamlEntry& entry : node.entries) map[py::str(entry.key)] = python_value(entry.value);
      return map;
    }
    case YamlNode::Kind::list: {
      py::list list;
      for (const YamlNode& item : node.items) list.append(python_value(item));
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
  return node == nullptr ? py::object(py::none()) : python_value(*node);
}

const Description& full_description(const GivenModel& model) {
  return *interruptible([&] { return &model->description(); });
}

}  // namespace

void add_model(py::module_& module) {
  py::class_<ModelHandle, std::shared_ptr<ModelHandle>>(module, "Model", "A model as read from a file or text.")
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
           "Returns the model with keys set: (key, 'scalar' or 'flow' or 'remove', value).")
      .def(
          "moved",
          [](const GivenModel& model, const std::string& folder) {
            return moved_text(model->text(), model->file(), folder);
          },
          py::arg("folder"),
          "Returns the text for a file in another folder, with the paths of referenced files adapted.")
      .def("value", &find, py::arg("key"), "Returns the value of a key in the text; None if it is not given.")
      .def_property_readonly("tree", [](const GivenModel& model) { return python_value(model->tree()); })
      .def_property_readonly("text", [](const GivenModel& model) { return model->text(); })
      .def_property_readonly("file", [](const GivenModel& model) { return model->file(); })
      .def_property_readonly("title", [](const GivenModel& model) { return model->statics_description().title; })
      .def_property_readonly("has_pipe", [](const GivenModel& model) { return model->statics_description().has_pipe; })
      .def_property_readonly(
          "assumptions",
          [](const GivenModel& model) { return texts(assumptions(build_model(full_description(model)))); })
      .def_property_readonly("findings", [](const GivenModel& model) {
        return to_python(findings_json(input_findings(build_model(full_description(model)))));
      });
}

}  // namespace overbend
