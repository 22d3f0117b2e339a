/// Destination of named datasets: results.h5, or a tree in memory (resultfiles/hdf5/result_tree.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "resultfiles/hdf5/dataset.h"
#include "results/fields/result_field.h"

namespace overbend {

/// Receives groups and datasets by their paths; numbers of any shape in row-major order, an empty shape is a scalar.
class DatasetSink {
 public:
  DatasetSink() = default;
  DatasetSink(const DatasetSink&) = default;
  DatasetSink(DatasetSink&&) = default;
  DatasetSink& operator=(const DatasetSink&) = default;
  DatasetSink& operator=(DatasetSink&&) = default;
  virtual ~DatasetSink() = default;

  /// Creates a group.
  virtual void group(const std::string& path, const std::string& description) = 0;
  virtual void attribute(const std::string& object, const std::string& name, const std::string& text) = 0;

  /// Writes numbers in row-major order with the units, frame and description of the field.
  virtual void write(const std::string& path, const ResultField& field, const std::vector<double>& values,
                     const std::vector<Extent>& shape) = 0;
  virtual void write(const std::string& path, const ResultField& field, const std::vector<int>& values,
                     const std::vector<Extent>& shape) = 0;
  virtual void write(const std::string& path, const ResultField& field, const std::vector<std::int64_t>& values,
                     const std::vector<Extent>& shape) = 0;
  virtual void write(const std::string& path, const ResultField& field, const std::vector<std::uint64_t>& values,
                     const std::vector<Extent>& shape) = 0;
  /// UTF-8 texts.
  virtual void write(const std::string& path, const ResultField& field, const std::vector<std::string>& values,
                     const std::vector<Extent>& shape) = 0;

  /// Makes a 1-D dataset the dimension scale `name`, to be attached to a dimension of others.
  virtual void make_scale(const std::string& path, const std::string& name) = 0;
  virtual void attach_scale(const std::string& path, const std::string& scale, unsigned dimension = 0) = 0;
};

}  // namespace overbend
