#include "resultfiles/hdf5/result_tree.h"

#include <utility>

namespace overbend {
namespace {

template <class Values>
Dataset described(const ResultField& field, Values values, const std::vector<Extent>& shape) {
  return {std::move(values),
          shape,
          std::string(field.units),
          std::string(field.description).append(field.aspect),
          field.frame,
          std::vector<std::string>(shape.size())};
}

template <class Number>
std::vector<std::int64_t> counts(const std::vector<Number>& values) {
  return {values.begin(), values.end()};
}

}  // namespace

void ResultTree::group(const std::string& path, const std::string& description) {
  groups[path] = description;
}

void ResultTree::attribute(const std::string& object, const std::string& name, const std::string& text) {
  if (object == "/") attributes[name] = text;
}

void ResultTree::add(const std::string& path, Dataset dataset) {
  if (datasets.insert_or_assign(path, std::move(dataset)).second) order.push_back(path);
}

void ResultTree::write(const std::string& path, const ResultField& field, const std::vector<double>& values,
                       const std::vector<Extent>& shape) {
  add(path, described(field, values, shape));
}

void ResultTree::write(const std::string& path, const ResultField& field, const std::vector<int>& values,
                       const std::vector<Extent>& shape) {
  add(path, described(field, counts(values), shape));
}

void ResultTree::write(const std::string& path, const ResultField& field, const std::vector<std::int64_t>& values,
                       const std::vector<Extent>& shape) {
  add(path, described(field, values, shape));
}

void ResultTree::write(const std::string& path, const ResultField& field, const std::vector<std::uint64_t>& values,
                       const std::vector<Extent>& shape) {
  add(path, described(field, counts(values), shape));
}

void ResultTree::write(const std::string& path, const ResultField& field, const std::vector<std::string>& values,
                       const std::vector<Extent>& shape) {
  add(path, described(field, values, shape));
}

void ResultTree::make_scale(const std::string& path, const std::string& /*name*/) {
  datasets.at(path).scales = {path};
}

void ResultTree::attach_scale(const std::string& path, const std::string& scale, unsigned dimension) {
  datasets.at(path).scales.at(dimension) = scale;
}

}  // namespace overbend
