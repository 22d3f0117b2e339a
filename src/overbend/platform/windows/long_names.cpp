// Folders with long names. The C library of this compiler lists a folder by a name of at most 260 characters, and its
// C++ library (std::filesystem::directory_iterator) goes through it. The linker replaces its functions by these
// (--wrap, src/CMakeLists.txt).
#include <dirent.h>

#include <cerrno>
#include <cstring>
#include <cwchar>
#include <memory>

#include "platform/windows/system.h"

namespace {

/// Listing of a folder; the C++ library only passes it on.
struct Listing {
  _wdirent entry{};
  WIN32_FIND_DATAW found{};
  HANDLE search = INVALID_HANDLE_VALUE;
  bool is_first = true;
};

int error_number(DWORD error) {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
      return ENOENT;
    case ERROR_DIRECTORY:
      return ENOTDIR;
    case ERROR_ACCESS_DENIED:
      return EACCES;
    default:
      return EIO;
  }
}

Listing* listing(_WDIR* folder) {
  return reinterpret_cast<Listing*>(folder);
}

}  // namespace

extern "C" {

_WDIR* __wrap__wopendir(const wchar_t* name);
_wdirent* __wrap__wreaddir(_WDIR* folder);
int __wrap__wclosedir(_WDIR* folder);

_WDIR* __wrap__wopendir(const wchar_t* name) {
  const std::wstring path = overbend::system_path(name);
  const DWORD attributes = ::GetFileAttributesW(path.c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES || (attributes & FILE_ATTRIBUTE_DIRECTORY) == 0) {
    errno = attributes == INVALID_FILE_ATTRIBUTES ? error_number(::GetLastError()) : ENOTDIR;
    return nullptr;
  }
  auto result = std::make_unique<Listing>();
  const wchar_t* pattern = path.ends_with(L'\\') || path.ends_with(L'/') ? L"*" : L"\\*";
  result->search = ::FindFirstFileW((path + pattern).c_str(), &result->found);
  if (result->search == INVALID_HANDLE_VALUE) {
    errno = error_number(::GetLastError());
    return nullptr;
  }
  return reinterpret_cast<_WDIR*>(result.release());
}

_wdirent* __wrap__wreaddir(_WDIR* folder) {
  Listing& from = *listing(folder);
  if (!from.is_first && ::FindNextFileW(from.search, &from.found) == 0) {
    if (::GetLastError() != ERROR_NO_MORE_FILES) errno = EIO;
    return nullptr;
  }
  from.is_first = false;
  from.entry.d_namlen = static_cast<unsigned short>(std::wcslen(from.found.cFileName));
  std::memcpy(from.entry.d_name, from.found.cFileName, (from.entry.d_namlen + 1U) * sizeof(wchar_t));
  return &from.entry;
}

int __wrap__wclosedir(_WDIR* folder) {
  const std::unique_ptr<Listing> closed(listing(folder));
  return ::FindClose(closed->search) != 0 ? 0 : -1;
}
}
