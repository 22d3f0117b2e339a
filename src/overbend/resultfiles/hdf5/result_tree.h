/// Results as the datasets of results.h5 in memory, for use without a file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "resultfiles/hdf5/dataset_sink.h"

namespace overbend {

/// Groups and datasets by their paths, "/static/stations/s".
class ResultTree final : public DatasetSink {
 public:
  void group(const std::string& path, const std::string& description) override;
  void attribute(const std::string& object, const std::string& name, const std::string& text) override;
  void write(const std::string& path, const ResultField& field, const std::vector<double>& values,
             const std::vector<Extent>& shape) override;
  void write(const std::string& path, const ResultField& field, const std::vector<int>& values,
             const std::vector<Extent>& shape) override;
  void write(const std::string& path, const ResultField& field, const std::vector<std::int64_t>& values,
             const std::vector<Extent>& shape) override;
  void write(const std::string& path, const ResultField& field, const std::vector<std::uint64_t>& values,
             const std::vector<Extent>& shape) override;
  void write(const std::string& path, const ResultField& field, const std::vector<std::string>& values,
             const std::vector<Extent>& shape) override;
  void make_scale(const std::string& path, const std::string& name) override;
  void attach_scale(const std::string& path, const std::string& scale, unsigned dimension = 0) override;

  std::map<std::string, std::string> groups;  ///< Paths and descriptions.
  std::map<std::string, Dataset> datasets;
  std::vector<std::string> order;                 ///< Paths of the datasets in the order of writing: that of the text
                                                  ///< tables.
  std::map<std::string, std::string> attributes;  ///< Attributes of the root.

 private:
  void add(const std::string& path, Dataset dataset);
};

}  // namespace overbend
