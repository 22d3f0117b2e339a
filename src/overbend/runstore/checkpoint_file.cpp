#include "runstore/checkpoint_file.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>

#include "runstore/append_file.h"
#include "runstore/run_record.h"

namespace overbend {
namespace {

constexpr std::string_view kMagic = "overbend checkpoint\n";

/// FNV-1a, 64 bit.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

/// Writes values in sequence with their representation in memory; lengths precede lists.
class Encoder {
 public:
  explicit Encoder(std::string_view start) : bytes_(start) {}
  void number(std::uint64_t value) { raw(&value, sizeof value); }
  void number(double value) { raw(&value, sizeof value); }
  void text(const std::string& value) {
    number(std::uint64_t{value.size()});
    bytes_ += value;
  }
  void numbers(const std::vector<double>& values) {
    number(std::uint64_t{values.size()});
    raw(values.data(), values.size() * sizeof(double));
  }
  void sums(const std::vector<std::uint64_t>& values) {
    number(std::uint64_t{values.size()});
    raw(values.data(), values.size() * sizeof(std::uint64_t));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void raw(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
  std::string bytes_;
};

/// Inverse of Encoder; wrong lengths throw instead of allocating memory.
class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : bytes_(bytes) {}
  void number(std::uint64_t& value) { std::memcpy(&value, take(sizeof value).data(), sizeof value); }
  void number(double& value) { std::memcpy(&value, take(sizeof value).data(), sizeof value); }
  void text(std::string& value) { value = take(count(1)); }
  template <class Number>
  void numbers(std::vector<Number>& values) {
    values.resize(count(sizeof(Number)));
    const std::string_view data = take(values.size() * sizeof(Number));
    if (!values.empty()) std::memcpy(values.data(), data.data(), data.size());
  }
  /// Reads the length of a list whose elements take at least `size` bytes each.
  std::size_t count(std::size_t size) {
    std::uint64_t value = 0;
    number(value);
    if (value > bytes_.size() / size) throw std::runtime_error("its content ends too early");
    return value;
  }
  void expect_end() const {
    if (!bytes_.empty()) throw std::runtime_error("it contains extra data");
  }

 private:
  std::string_view take(std::size_t size) {
    if (size > bytes_.size()) throw std::runtime_error("its content ends too early");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  std::string_view bytes_;
};

void encode(const RunCheckpoint& c, Encoder& out) {
  out.text(c.version);
  out.text(c.model_hash);
  out.number(c.seed);
  out.number(std::uint64_t{c.columns.size()});
  for (const HistoryColumn& column : c.columns) {
    out.text(column.name);
    out.text(column.units);
    out.text(column.description);
    out.number(std::uint64_t{column.extreme});
    out.number(std::uint64_t{column.spectrum});
    out.number(std::uint64_t{column.is_minimum});
  }
  out.number(static_cast<std::uint64_t>(c.snapshot.stations));
  out.number(static_cast<std::uint64_t>(c.snapshot.line_points));
  for (const std::uint64_t bytes : {c.row_bytes, c.snapshot_bytes, c.impact_bytes}) out.number(bytes);
  for (const auto* sums : {&c.row_sums, &c.snapshot_sums, &c.impact_sums}) out.sums(*sums);
  out.number(c.state.time);
  out.number(std::uint64_t{c.state.arrays.size()});
  for (const DynamicCheckpoint::Array& array : c.state.arrays) {
    out.text(array.name);
    out.numbers(array.values);
  }
}

void decode_column(Decoder& in, HistoryColumn& column) {
  std::uint64_t extreme = 0, spectrum = 0, minimum = 0;
  in.text(column.name);
  in.text(column.units);
  in.text(column.description);
  in.number(extreme);
  in.number(spectrum);
  in.number(minimum);
  column.extreme = extreme != 0;
  column.spectrum = spectrum != 0;
  column.is_minimum = minimum != 0;
}

/// Decodes all data after the version.
void decode(Decoder& in, RunCheckpoint& c) {
  std::uint64_t stations = 0, line_points = 0;
  in.text(c.model_hash);
  in.number(c.seed);
  c.columns.resize(in.count(1));
  for (HistoryColumn& column : c.columns) decode_column(in, column);
  in.number(stations);
  in.number(line_points);
  c.snapshot = {static_cast<int>(stations), static_cast<int>(line_points)};
  for (std::uint64_t* bytes : {&c.row_bytes, &c.snapshot_bytes, &c.impact_bytes}) in.number(*bytes);
  for (auto* sums : {&c.row_sums, &c.snapshot_sums, &c.impact_sums}) in.numbers(*sums);
  in.number(c.state.time);
  c.state.arrays.resize(in.count(1));
  for (DynamicCheckpoint::Array& array : c.state.arrays) {
    in.text(array.name);
    in.numbers(array.values);
  }
  in.expect_end();
}

std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream.is_open() || stream.bad()) throw std::runtime_error("the file '" + file.string() + "' cannot be read");
  return bytes;
}

/// Returns the content between the file mark and the checksum.
std::string_view verified_content(std::string_view bytes) {
  if (!bytes.starts_with(kMagic)) throw std::runtime_error("it is not a checkpoint file");
  if (bytes.size() < kMagic.size() + sizeof(std::uint64_t)) throw std::runtime_error("it is truncated");
  const std::string_view summed = bytes.substr(0, bytes.size() - sizeof(std::uint64_t));
  std::uint64_t stored = 0;
  std::memcpy(&stored, bytes.data() + summed.size(), sizeof stored);
  if (stored != checksum(summed)) throw std::runtime_error("its checksum is wrong");
  return summed.substr(kMagic.size());
}

}  // namespace

void write_checkpoint(const RunCheckpoint& checkpoint, const std::filesystem::path& file) {
  Encoder out(kMagic);
  encode(checkpoint, out);
  out.number(checksum(out.bytes()));
  const std::filesystem::path temporary = file.string() + ".new";
  write_synced(temporary, std::as_bytes(std::span(out.bytes())));
  if (const std::error_code error = rename_file(temporary, file)) throw_file_error(file, "written", error);
  sync_folder(file.parent_path());
}

RunCheckpoint read_checkpoint(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  RunCheckpoint checkpoint;
  try {
    Decoder in(verified_content(bytes));
    in.text(checkpoint.version);
    // The layout of the data that follows may differ between versions.
    if (checkpoint.version == program_identity()) decode(in, checkpoint);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("the checkpoint '" + file.string() + "' is damaged: " + error.what());
  }
  if (checkpoint.version != program_identity()) {
    throw std::runtime_error("the checkpoint '" + file.string() + "' is of version " + checkpoint.version +
                             " of the program, this is " + program_identity() + "; start again with --restart");
  }
  return checkpoint;
}

}  // namespace overbend
