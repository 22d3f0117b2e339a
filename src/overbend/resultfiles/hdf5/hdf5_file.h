/// Subset of HDF5 needed for results, with handles that close themselves and errors as std::runtime_error.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "resultfiles/hdf5/dataset_sink.h"

namespace overbend {

static_assert(std::is_same_v<Extent, hsize_t>);

/// Owns one HDF5 identifier.
class Hdf5Handle {
 public:
  Hdf5Handle() = default;
  /// Takes ownership of the identifier; throws with `what` if it is invalid.
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what);
  ~Hdf5Handle() { reset(); }
  Hdf5Handle(Hdf5Handle&& source) noexcept : id_(std::exchange(source.id_, -1)), close_(source.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& source) noexcept;
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;

  operator hid_t() const { return id_; }
  /// Closes the identifier; returns false on failure.
  bool reset() noexcept;

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

/// A file open for writing. Datasets have the attributes units, frame and description. All functions throw FileError if
/// the file cannot be written.
class Hdf5Writer final : public DatasetSink {
 public:
  explicit Hdf5Writer(const std::filesystem::path& file);
  /// Opens a file that was closed by this class, for changes.
  static Hdf5Writer reopen(const std::filesystem::path& file);

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

  /// Creates a compressed dataset in chunks of `chunk_rows` along its first dimension, to be filled by write_rows().
  template <class Number>
  void create(const std::string& path, const ResultField& field, const std::vector<hsize_t>& shape, hsize_t chunk_rows);
  /// Writes rows from `first` on, as many as `values` holds.
  template <class Number>
  void write_rows(const std::string& path, hsize_t first, const std::vector<Number>& values);

  /// Adds another name for the object that exists, or will exist, at `target`.
  void link(const std::string& path, const std::string& target);
  bool has(const std::string& path) const;
  /// Removes a group, or a dataset that is not a scale, from the file.
  void remove(const std::string& path);
  /// Overwrites the values of a dataset of numbers; the count must match.
  void overwrite(const std::string& path, const std::vector<double>& values);

  void make_scale(const std::string& path, const std::string& name) override;
  void attach_scale(const std::string& path, const std::string& scale, unsigned dimension = 0) override;

  /// Closes and seals the file (runstore/file_seal.h); throws FileError if it could not be written completely (disk
  /// full).
  void close();

 private:
  Hdf5Writer() = default;
  Hdf5Handle dataset(const std::string& path) const;
  void write_raw(const std::string& path, const ResultField& field, hid_t memory_type, hid_t file_type,
                 const std::vector<hsize_t>& shape, const void* values);
  void describe(const std::string& path, const ResultField& field);
  void require_disk() const;

  std::unique_ptr<std::error_code> error_ = std::make_unique<std::error_code>();  ///< See make_tolerant_access().
  std::filesystem::path path_;
  Hdf5Handle file_;
};

/// A file open for reading. Accepts only files closed by Hdf5Writer; throws std::runtime_error otherwise.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& file);

  bool has(const std::string& path) const;
  /// Returns all values of a dataset in row-major order.
  std::vector<double> doubles(const std::string& path) const;
  /// Returns `count` rows of the first dimension from `first` on, with all their values.
  std::vector<double> doubles(const std::string& path, hsize_t first, hsize_t count) const;
  /// Extent of the first dimension; 1 for a single value.
  hsize_t lines(const std::string& path) const;
  std::vector<int> ints(const std::string& path) const;
  std::vector<std::int64_t> counts(const std::string& path) const;
  /// Returns a single unsigned integer.
  std::uint64_t seed(const std::string& path) const;
  std::vector<std::string> texts(const std::string& path) const;

  /// Returns the direct members of a group, "/" for the root, in the order of names; groups end with '/'.
  std::vector<std::string> names(const std::string& group) const;
  /// Returns a dataset with its attributes.
  Dataset whole(const std::string& path) const;

 private:
  Hdf5Handle dataset(const std::string& path) const;

  Hdf5Handle file_;
  std::string name_;
};

}  // namespace overbend
