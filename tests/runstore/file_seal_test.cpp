#include "runstore/file_seal.h"

#include <gtest/gtest.h>

#include <random>

#include "resultfiles/static/results_reader.h"
#include "resultfiles/static/results_writer.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::file_text;
using testing::TemporaryFolder;
using testing::write_file;

std::string seal_error(const fs::path& file) {
  try {
    require_sealed(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(file_seal, a_sealed_file_is_whole_whatever_its_length) {
  const TemporaryFolder folder;
  for (const std::size_t length : {0U, 1U, 7U, 8U, 9U, 1000U, 1U << 20U}) {
    write_file(folder / "file", std::string(length, 'x'));
    EXPECT_NE(seal_error(folder / "file"), "") << length;
    seal_file(folder / "file");
    EXPECT_EQ(seal_error(folder / "file"), "") << length;
    EXPECT_EQ(file_text(folder / "file").substr(0, length), std::string(length, 'x'));
  }
}

TEST(file_seal, every_changed_bit_and_every_cut_is_found) {
  const TemporaryFolder folder;
  write_file(folder / "file", "the quick brown fox jumps over the lazy dog");
  seal_file(folder / "file");
  const std::string whole = file_text(folder / "file");
  for (std::size_t index = 0; index < whole.size(); ++index) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string bytes = whole;
      bytes[index] = static_cast<char>(bytes[index] ^ (1 << bit));
      write_file(folder / "file", bytes);
      EXPECT_NE(seal_error(folder / "file"), "") << index;
    }
    write_file(folder / "file", whole.substr(0, index));
    EXPECT_NE(seal_error(folder / "file"), "") << index;
  }
  write_file(folder / "file", whole + "x");
  EXPECT_NE(seal_error(folder / "file"), "");
}

TEST(file_seal, says_what_is_wrong_with_a_file_that_is_none) {
  const TemporaryFolder folder;
  EXPECT_NE(seal_error(folder / "nothing").find("does not exist"), std::string::npos);
  EXPECT_NE(seal_error(folder.path()).find("is a folder"), std::string::npos);
}

/// One way to damage a file: bits, bytes, a stretch of zeros or noise, a stretch from elsewhere, an end that is lost.
std::string damaged(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return random() % n; };
  const std::size_t index = below(bytes.size()), length = std::min<std::size_t>(1 + below(4096), bytes.size() - index);
  switch (below(5)) {
    case 0:
      bytes[index] = static_cast<char>(bytes[index] ^ (1U << below(8)));
      break;
    case 1:
      bytes.replace(index, length, std::string(length, '\0'));
      break;
    case 2:
      for (std::size_t i = 0; i < length; ++i) bytes[index + i] = static_cast<char>(below(256));
      break;
    case 3:
      bytes.replace(index, length, bytes.substr(below(bytes.size()), length));
      break;
    default:
      bytes.resize(index);
      break;
  }
  return bytes;
}

// HDF5 follows damaged addresses into memory that is not its own: what is damaged must not get that far.
TEST(file_seal, damaged_results_are_rejected_by_the_hundred) {
  const TemporaryFolder folder;
  const auto& [description, results] = testing::solved_case("J12-D400-T560");
  write_static_hdf5(results, description, folder / "whole.h5");
  EXPECT_NO_THROW(read_static_results(folder / "whole.h5"));
  const std::string whole = file_text(folder / "whole.h5");
  std::mt19937 random(20261122);
  for (int trial = 0; trial < 400; ++trial) {
    const std::string bytes = damaged(whole, random);
    if (bytes == whole) continue;
    write_file(folder / "results.h5", bytes);
    EXPECT_THROW(read_static_results(folder / "results.h5"), std::runtime_error) << trial;
  }
}

}  // namespace
}  // namespace overbend
