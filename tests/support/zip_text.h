/// Reads files out of a zip archive, as spreadsheet programs do with a workbook.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>

namespace overbend::testing {

namespace zip {

inline std::size_t number(const std::string& bytes, std::size_t index, int count) {
  std::size_t value = 0;
  for (int i = count - 1; i >= 0; --i) value = value << 8U | static_cast<unsigned char>(bytes.at(index + i));
  return value;
}

inline std::string inflated(std::string packed, std::size_t size) {
  std::string text(size, '\0');
  z_stream stream = {};
  stream.next_in = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(size);
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::runtime_error("no zlib");
  const int end = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (end != Z_STREAM_END) throw std::runtime_error("a damaged archive");
  return text;
}

}  // namespace zip

/// Every file of the archive by its name; APPNOTE.TXT of PKWARE has the format.
inline std::map<std::string, std::string> zip_texts(const std::string& archive) {
  std::map<std::string, std::string> texts;
  const std::size_t end = archive.rfind("PK\x05\x06");
  if (end == std::string::npos) throw std::runtime_error("no zip archive");
  std::size_t index = zip::number(archive, end + 16, 4);
  for (std::size_t left = zip::number(archive, end + 10, 2); left > 0; --left) {
    const std::size_t method = zip::number(archive, index + 10, 2), packed = zip::number(archive, index + 20, 4),
                      size = zip::number(archive, index + 24, 4), name = zip::number(archive, index + 28, 2),
                      local = zip::number(archive, index + 42, 4);
    const std::size_t data = local + 30 + zip::number(archive, local + 26, 2) + zip::number(archive, local + 28, 2);
    const std::string content = archive.substr(data, packed);
    texts[archive.substr(index + 46, name)] = method == 0 ? content : zip::inflated(content, size);
    index += 46 + name + zip::number(archive, index + 30, 2) + zip::number(archive, index + 32, 2);
  }
  return texts;
}

}  // namespace overbend::testing
