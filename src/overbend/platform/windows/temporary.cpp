#include "platform/temporary.h"

#include <random>

#include "platform/windows/system.h"

namespace overbend {
namespace {

std::string random_letters(std::size_t count) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device source;
  std::uniform_int_distribution<std::size_t> index(0, kLetters.size() - 1);
  std::string text;
  while (text.size() < count) text += kLetters[index(source)];
  return text;
}

}  // namespace

std::filesystem::path make_unique_folder(const std::filesystem::path& parent, const std::string& stem,
                                         std::error_code& error) {
  constexpr std::size_t kLetterCount = 6;
  for (int attempt = 0; attempt < 100; ++attempt) {
    std::filesystem::path folder = parent / (stem + random_letters(kLetterCount));
    error = error_unless(::CreateDirectoryW(system_path(folder).c_str(), nullptr));
    if (!error) return folder;
    if (error != std::errc::file_exists) break;
  }
  return {};
}

}  // namespace overbend
