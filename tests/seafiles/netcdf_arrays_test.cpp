#include "seafiles/netcdf_arrays.h"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <hdf5_hl.h>

#include <bit>
#include <cmath>
#include <random>

#include "support/solved_case.h"

namespace overbend {
namespace {

/// Writes the classic format: dimensions time (records), place and letters, variables of several types.
class ClassicWriter {
 public:
  explicit ClassicWriter(unsigned version) : version_(version) {}

  std::string file(std::uint64_t records) {
    const std::size_t length = head(records, 0).size();
    std::string values = dof_names() + numbers();
    for (std::uint64_t i = 0; i < records; ++i) values += record(i);
    return head(records, length) + values;
  }

 private:
  static std::string big_endian(std::uint64_t value, unsigned length) {
    std::string bytes;
    for (unsigned k = length; k-- > 0;) bytes += static_cast<char>(value >> (8 * k));
    return bytes;
  }
  std::string count(std::uint64_t value) const { return big_endian(value, version_ == 5 ? 8 : 4); }
  static std::string padded(std::string bytes) {
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    return bytes;
  }
  std::string name(const std::string& text) const { return count(text.size()) + padded(text); }
  std::string list(unsigned mark, std::uint64_t items) const { return big_endian(mark, 4) + count(items); }
  std::string variable(const std::string& called, const std::vector<std::uint64_t>& dimensions, unsigned type,
                       std::uint64_t begin, const std::string& attributes) const {
    std::string text = name(called) + count(dimensions.size());
    for (const std::uint64_t dimension : dimensions) text += count(dimension);
    return text + attributes + big_endian(type, 4) + count(8) + big_endian(begin, version_ == 1 ? 4 : 8);
  }
  std::string no_attributes() const { return list(0, 0); }
  std::string packing() const {
    return list(12, 2) + name("scale_factor") + big_endian(6, 4) + count(1) + number(0.5) + name("add_offset") +
           big_endian(5, 4) + count(1) + big_endian(std::bit_cast<std::uint32_t>(10.0F), 4);
  }
  std::string head(std::uint64_t records, std::uint64_t begin) const {
    const std::uint64_t numbers_begin = begin + 12, records_begin = numbers_begin + 16;
    return "CDF" + std::string(1, static_cast<char>(version_)) + count(records) + list(10, 3) + name("time") +
           count(0) + name("place") + count(2) + name("letters") + count(5) + no_attributes() + list(11, 4) +
           variable("place_name", {1, 2}, 2, begin, no_attributes()) +
           variable("depth", {1}, 6, numbers_begin, no_attributes()) +
           variable("short", {0, 1}, 3, records_begin, packing()) +
           variable("level", {0}, 5, records_begin + 4, no_attributes());
  }
  static std::string number(double value) { return big_endian(std::bit_cast<std::uint64_t>(value), 8); }
  static std::string dof_names() { return std::string("bow\0\0stern\0\0", 12); }
  static std::string numbers() { return number(89.0) + number(-1.5); }
  static std::string record(std::uint64_t i) {
    return big_endian(i, 2) + big_endian(static_cast<std::uint16_t>(-3), 2) +
           big_endian(std::bit_cast<std::uint32_t>(0.25F * static_cast<float>(i)), 4);
  }

  unsigned version_;
};

class NetcdfFiles : public ::testing::Test {
 protected:
  std::string written(const std::string& bytes) const {
    const std::string path = (folder_.path() / "file.nc").string();
    testing::write_file(path, bytes);
    return path;
  }
  /// Written by the library of HDF5, as netCDF-4 is: numbers, words of any length, numbers in compressed pieces.
  std::string hdf5_file() const {
    const std::string path = (folder_.path() / "hdf5.nc").string();
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hsize_t count = 2;
    const std::vector<double> values = {89.0, -1.5};
    H5LTmake_dataset_double(file, "depth", 1, &count, values.data());
    const hid_t set = H5Dopen2(file, "depth", H5P_DEFAULT);
    H5DSset_scale(set, "depth");
    H5Dclose(set);
    make_string_attribute(file);
    make_pieces(file, "pieces", true);
    make_pieces(file, "gap", false);
    H5Fclose(file);
    return path;
  }
  /// Message of rejection of the file; empty if it is read.
  static std::string rejection(const std::string& path) {
    try {
      const NetcdfFile file(path);
      for (const char* name : {"depth", "short", "level", "pieces"}) look_at(file, name);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }

 private:
  /// An array that is given has as many values as its sizes say.
  static void look_at(const NetcdfFile& file, const char* name) {
    const auto array = file.numbers(name);
    if (!array) return;
    EXPECT_EQ(count_values(array->sizes), array->values.size());
    EXPECT_EQ(array->dimensions.size(), array->sizes.size());
  }
  static void make_string_attribute(hid_t file) {
    const std::vector<const char*> texts = {"bow", "stern"};
    const hsize_t count = texts.size();
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate_simple(1, &count, nullptr);
    H5Tset_size(type, H5T_VARIABLE);
    const hid_t set = H5Dcreate2(file, "place_name", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, static_cast<const void*>(texts.data()));
    H5Dclose(set);
    H5Sclose(space);
    H5Tclose(type);
  }
  /// 20 numbers in pieces of 6, all of them or the first alone.
  static void make_pieces(hid_t file, const char* name, bool all) {
    const hsize_t count = 20, piece = 6, first = 0, written = all ? count : piece;
    const hid_t space = H5Screate_simple(1, &count, nullptr), plan = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(plan, 1, &piece);
    H5Pset_deflate(plan, 4);
    const hid_t set = H5Dcreate2(file, name, H5T_IEEE_F32LE, space, H5P_DEFAULT, plan, H5P_DEFAULT);
    const std::vector<double> values(count, 0.75);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, &first, nullptr, &written, nullptr);
    const hid_t memory = H5Screate_simple(1, &written, nullptr);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data());
    for (const hid_t used : {memory, space}) H5Sclose(used);
    H5Dclose(set);
    H5Pclose(plan);
  }

  testing::TemporaryFolder folder_;
};

TEST_F(NetcdfFiles, of_every_classic_format_are_read) {
  for (const unsigned version : {1U, 2U, 5U}) {
    const NetcdfFile file(written(ClassicWriter(version).file(3)));
    EXPECT_EQ(file.texts("place_name"), (std::vector<std::string>{"bow", "stern"}));
    const auto depth = file.numbers("depth"), packed = file.numbers("short"), level = file.numbers("level");
    ASSERT_TRUE(depth && packed && level);
    EXPECT_EQ(depth->values, (std::vector<double>{89.0, -1.5}));
    EXPECT_EQ(packed->dimensions, (std::vector<std::string>{"time", "place"}));
    EXPECT_EQ(packed->sizes, (std::vector<std::size_t>{3, 2}));
    EXPECT_EQ(packed->values, (std::vector<double>{10.0, 8.5, 10.5, 8.5, 11.0, 8.5}));  // 10 + number / 2
    EXPECT_EQ(level->values, (std::vector<double>{0.0, 0.25, 0.5}));
    EXPECT_FALSE(file.numbers("place_name") || file.numbers("nothing"));
  }
}

TEST_F(NetcdfFiles, that_are_cut_short_say_which_variable_is_not_whole) {
  const std::string whole = ClassicWriter(2).file(3);
  EXPECT_EQ(rejection(written(whole.substr(0, whole.size() - 1))),
            "a variable level that lies beyond the end of the file");
  EXPECT_EQ(rejection(written(whole.substr(0, 60))), "a damaged netCDF file: its header is truncated");
  EXPECT_EQ(rejection(written("CDF\x03")), "a damaged netCDF file: its format version is 3");
  EXPECT_NE(rejection(written("")), "");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_NE(rejection(written(whole.substr(0, length))), "") << length;
  }
}

TEST_F(NetcdfFiles, whose_variables_lie_in_one_place_are_rejected) {
  std::string whole = ClassicWriter(1).file(3);
  const std::size_t name = whole.find("depth"), begin = name + 8 + 4 + 4 + 8 + 4 + 4;  // rank, dimension, no attributes
  ASSERT_EQ(rejection(written(whole)), "");
  whole[begin + 3] = static_cast<char>(whole[begin + 3] - 4);
  EXPECT_EQ(rejection(written(whole)), "a damaged netCDF file: values of its variables overlap");
  whole[begin + 3] = 4;
  EXPECT_EQ(rejection(written(whole)), "a damaged netCDF file: values of its variables overlap");  // with the head
}

TEST_F(NetcdfFiles, with_changed_bytes_are_read_within_their_bounds) {
  const std::string whole = ClassicWriter(5).file(3);
  std::mt19937 draw(1);
  int rejected = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string changed = whole;
    for (int k = 0; k <= i % 3; ++k) changed[draw() % changed.size()] = static_cast<char>(draw());
    rejected += rejection(written(changed)).empty() ? 0 : 1;
  }
  EXPECT_GT(rejected, 100);
  EXPECT_LT(rejected, 2900);
}

TEST_F(NetcdfFiles, of_hdf5_are_read) {
  const NetcdfFile file(hdf5_file());
  EXPECT_EQ(file.texts("place_name"), (std::vector<std::string>{"bow", "stern"}));
  ASSERT_TRUE(file.numbers("depth") && file.numbers("pieces"));
  EXPECT_EQ(file.numbers("depth")->values, (std::vector<double>{89.0, -1.5}));
  EXPECT_EQ(file.numbers("pieces")->values, std::vector<double>(20, 0.75));
}

TEST_F(NetcdfFiles, of_hdf5_with_missing_chunks_are_no_zeros) {
  const NetcdfFile file(hdf5_file());
  EXPECT_THROW(
      {
        try {
          file.numbers("gap");
        } catch (const std::runtime_error& error) {
          EXPECT_STREQ(error.what(), "a variable gap that has 1 of its 4 chunks");
          throw;
        }
      },
      std::runtime_error);
}

TEST_F(NetcdfFiles, of_hdf5_with_changed_bytes_do_not_end_the_program) {
  const std::string whole = testing::file_text(hdf5_file());
  std::mt19937 draw(1);
  int rejected = 0;
  for (int i = 0; i < 150; ++i) {  // among them those that end the process which reads
    std::string changed = whole;
    for (int k = 0; k <= i % 16; ++k) changed[draw() % changed.size()] = static_cast<char>(draw());
    rejected += rejection(written(changed)).empty() ? 0 : 1;
  }
  EXPECT_GT(rejected, 10);
  EXPECT_LT(rejected, 140);
  EXPECT_NE(rejection(written(whole.substr(0, whole.size() / 2))), "");
  EXPECT_EQ(rejection(written("no such file")), "a file that is not netCDF");
}

}  // namespace
}  // namespace overbend
