/// The little of HDF5 that results need, with handles that close themselves and faults as std::runtime_error.
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
  /// Takes the identifier; throws with `what` when it is none.
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what);
  ~Hdf5Handle() { reset(); }
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;

  operator hid_t() const { return id_; }
  /// Closes; false when that failed.
  bool reset() noexcept;

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

/// A file being written. Datasets carry the attributes units, frame and description. All functions throw FileFault when
/// the disk refuses.
class Hdf5Writer final : public DatasetSink {
 public:
  explicit Hdf5Writer(const std::filesystem::path& file);
  /// To change a file that was closed by one of these.
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

  /// Makes a compressed dataset in chunks of `chunk_rows` along its first dimension, to be filled by write_rows().
  template <class Number>
  void create(const std::string& path, const ResultField& field, const std::vector<hsize_t>& shape, hsize_t chunk_rows);
  /// Fills the rows from `first` on with as many as there are values for.
  template <class Number>
  void write_rows(const std::string& path, hsize_t first, const std::vector<Number>& values);

  /// Another name for what stands, or will stand, at `target`.
  void link(const std::string& path, const std::string& target);
  bool has(const std::string& path) const;
  /// Takes a group or a dataset that is no scale out of the file.
  void remove(const std::string& path);
  /// Gives a dataset of numbers other values, as many as it has.
  void overwrite(const std::string& path, const std::vector<double>& values);

  void make_scale(const std::string& path, const std::string& name) override;
  void attach_scale(const std::string& path, const std::string& scale, unsigned dimension = 0) override;

  /// Closes and seals the file (runstore/file_seal.h); throws FileFault when it could not be written to the end (disk
  /// full).
  void close();

 private:
  Hdf5Writer() = default;
  Hdf5Handle dataset(const std::string& path) const;
  void write_raw(const std::string& path, const ResultField& field, hid_t memory_type, hid_t file_type,
                 const std::vector<hsize_t>& shape, const void* values);
  void describe(const std::string& path, const ResultField& field);
  void require_disk() const;

  std::unique_ptr<int> fault_ = std::make_unique<int>(0);  ///< See forgiving_access().
  std::filesystem::path path_;
  Hdf5Handle file_;
};

/// A file being read: one that is as Hdf5Writer closed it, others are refused with std::runtime_error.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& file);

  bool has(const std::string& path) const;
  /// All values of a dataset, row by row.
  std::vector<double> doubles(const std::string& path) const;
  /// Of the first dimension `count` lines from `first` on, all that lies in them.
  std::vector<double> doubles(const std::string& path, hsize_t first, hsize_t count) const;
  /// Extent of the first dimension; 1 for a single value.
  hsize_t lines(const std::string& path) const;
  std::vector<int> ints(const std::string& path) const;
  std::vector<std::int64_t> counts(const std::string& path) const;
  /// A single integer without sign.
  std::uint64_t seed(const std::string& path) const;
  std::vector<std::string> texts(const std::string& path) const;

  /// What stands directly in a group, "/" for the whole, in the order of names; groups end with '/'.
  std::vector<std::string> names(const std::string& group) const;
  /// A dataset with all that is told of it.
  Dataset whole(const std::string& path) const;

 private:
  Hdf5Handle dataset(const std::string& path) const;

  Hdf5Handle file_;
  std::string name_;
};

}  // namespace overbend
