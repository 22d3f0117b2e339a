/// Conventions of Windows shared by the sources of this folder: errors, texts, handles.
#pragma once

#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#ifndef NOMINMAX
#define NOMINMAX
#endif
// winsock2.h comes first: windows.h would include an older version of it.
// clang-format off
#include <winsock2.h>
#include <ws2tcpip.h>
#include <windows.h>
#include <iphlpapi.h>
#include <shellapi.h>
// clang-format on

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace overbend {

/// Returns an error of the system, if possible as one of the conditions of the C library, whose messages are in
/// English.
inline std::error_code system_error(DWORD code) {
  switch (code) {
    case ERROR_LOCK_VIOLATION:
    case ERROR_IO_PENDING:
      return make_error_code(std::errc::resource_unavailable_try_again);
    case ERROR_SHARING_VIOLATION:
      return make_error_code(std::errc::text_file_busy);
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return make_error_code(std::errc::no_space_on_device);
    default:
      break;
  }
  const std::error_condition known = std::system_category().default_error_condition(static_cast<int>(code));
  if (known.category() == std::generic_category()) return {known.value(), std::generic_category()};
  return {static_cast<int>(code), std::system_category()};
}

inline std::error_code last_error() {
  return system_error(::GetLastError());
}

/// Returns the error of a function of the system that returns FALSE on failure.
inline std::error_code error_unless(BOOL succeeded) {
  return succeeded != FALSE ? std::error_code() : last_error();
}

inline std::wstring to_utf16(std::string_view text) {
  const int length = static_cast<int>(text.size());
  std::wstring wide(static_cast<std::size_t>(::MultiByteToWideChar(CP_UTF8, 0, text.data(), length, nullptr, 0)),
                    L'\0');
  ::MultiByteToWideChar(CP_UTF8, 0, text.data(), length, wide.data(), static_cast<int>(wide.size()));
  return wide;
}

inline std::string to_utf8(std::wstring_view wide) {
  const int length = static_cast<int>(wide.size());
  const int size = ::WideCharToMultiByte(CP_UTF8, 0, wide.data(), length, nullptr, 0, nullptr, nullptr);
  std::string text(static_cast<std::size_t>(size), '\0');
  ::WideCharToMultiByte(CP_UTF8, 0, wide.data(), length, text.data(), size, nullptr, nullptr);
  return text;
}

/// Returns a path as the functions of the system take it. Paths that are too long for their usual form get the prefix
/// for long ones, which must be absolute and normal.
inline std::wstring system_path(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path absolute = std::filesystem::absolute(path, error).lexically_normal().make_preferred();
  const std::wstring& text = absolute.native();
  if (error || text.size() < MAX_PATH - 12 || text.starts_with(L"\\\\?\\")) return path.native();
  return text.starts_with(L"\\\\") ? L"\\\\?\\UNC" + text.substr(1) : L"\\\\?\\" + text;
}

/// Owner of a handle of the system.
class Handle {
 public:
  Handle() = default;
  explicit Handle(HANDLE handle) : handle_(handle == INVALID_HANDLE_VALUE ? nullptr : handle) {}
  ~Handle() {
    if (handle_ != nullptr) ::CloseHandle(handle_);
  }
  Handle(Handle&& source) noexcept : handle_(std::exchange(source.handle_, nullptr)) {}
  Handle& operator=(Handle&& source) noexcept {
    std::swap(handle_, source.handle_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  explicit operator bool() const { return handle_ != nullptr; }
  HANDLE get() const { return handle_; }
  HANDLE* address() { return &handle_; }

 private:
  HANDLE handle_ = nullptr;
};

}  // namespace overbend
