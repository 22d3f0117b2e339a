#include "platform/process.h"

#include <fcntl.h>
#include <io.h>

#include <array>
#include <atomic>
#include <cctype>
#include <cstdio>
#include <set>
#include <thread>

#include "platform/windows/system.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

std::atomic<void (*)()> interrupt_handler{nullptr};

BOOL WINAPI handle_interrupt(DWORD event) {
  void (*handler)() = interrupt_handler.exchange(nullptr);
  if (handler == nullptr) return FALSE;  // a second event ends the program
  handler();
  // The system ends the program when this function returns; until then main() may write a checkpoint and end.
  constexpr DWORD kTimeToEnd = 20'000;  // [ms]
  if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT) ::Sleep(kTimeToEnd);
  return TRUE;
}

/// Returns a text that a function of the system writes into a buffer; empty on failure.
template <class Function>
std::wstring read_text(Function write) {
  std::wstring text(MAX_PATH, L'\0');
  for (;;) {
    const DWORD length = write(text.data(), static_cast<DWORD>(text.size()));
    if (length == 0) return {};
    if (length < text.size()) {
      text.resize(length);
      return text;
    }
    text.resize(2 * text.size());
  }
}

std::wstring read_variable(const wchar_t* name) {
  return read_text([&](wchar_t* text, DWORD size) {
    const DWORD length = ::GetEnvironmentVariableW(name, text, size);
    return length > size ? size : length;
  });
}

/// Appends a word to a command line so that CommandLineToArgvW() returns it unchanged.
void append_word(std::wstring& line, const std::wstring& word) {
  if (!line.empty()) line += L' ';
  if (!word.empty() && word.find_first_of(L" \t\"") == std::wstring::npos) {
    line += word;
    return;
  }
  line += L'"';
  std::size_t backslashes = 0;
  for (const wchar_t c : word) {
    if (c == L'"') line.append(backslashes + 1, L'\\');  // doubles those before a quote and escapes it
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    line += c;
  }
  line.append(backslashes, L'\\');
  line += L'"';
}

/// A pipe whose write end a child process inherits.
struct Pipe {
  Handle read_end, write_end;

  bool open() {
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    return ::CreatePipe(read_end.address(), write_end.address(), &inherited, 0) != FALSE &&
           ::SetHandleInformation(read_end.get(), HANDLE_FLAG_INHERIT, 0) != FALSE;
  }
};

Handle open_null_device() {
  SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
  return Handle(::CreateFileW(L"NUL", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited,
                              OPEN_EXISTING, 0, nullptr));
}

/// Starts a program, found on the PATH, which inherits these handles and no others.
std::optional<Handle> start_program(const std::vector<std::string>& command, HANDLE in, HANDLE out, HANDLE err) {
  if (command.empty()) return std::nullopt;
  const fs::path given(to_utf16(command.front()));
  const fs::path program = given.has_parent_path() ? given : find_program(command.front());
  if (program.empty()) return std::nullopt;
  std::wstring line;
  for (const std::string& word : command) append_word(line, to_utf16(word));
  STARTUPINFOEXW start{};
  start.StartupInfo.cb = sizeof start;
  start.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
  start.StartupInfo.hStdInput = in;
  start.StartupInfo.hStdOutput = out;
  start.StartupInfo.hStdError = err;
  const std::set<HANDLE> unique = {in, out, err};
  std::vector<HANDLE> inherited(unique.begin(), unique.end());
  SIZE_T size = 0;
  ::InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
  std::vector<std::byte> list(size);
  start.lpAttributeList = reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(list.data());
  if (::InitializeProcThreadAttributeList(start.lpAttributeList, 1, 0, &size) == FALSE) return std::nullopt;
  ::UpdateProcThreadAttribute(start.lpAttributeList, 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, inherited.data(),
                              inherited.size() * sizeof(HANDLE), nullptr, nullptr);
  PROCESS_INFORMATION started{};
  const BOOL succeeded =
      ::CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE,
                       CREATE_NO_WINDOW | EXTENDED_STARTUPINFO_PRESENT, nullptr, nullptr, &start.StartupInfo, &started);
  ::DeleteProcThreadAttributeList(start.lpAttributeList);
  if (succeeded == FALSE) return std::nullopt;
  ::CloseHandle(started.hThread);
  return Handle(started.hProcess);
}

int wait_for_program(const Handle& process) {
  DWORD code = 0;
  ::WaitForSingleObject(process.get(), INFINITE);
  ::GetExitCodeProcess(process.get(), &code);
  return static_cast<int>(code);
}

void read_to_end(const Handle& pipe, std::string& text) {
  char buffer[4096];
  DWORD count = 0;
  while (::ReadFile(pipe.get(), buffer, sizeof buffer, &count, nullptr) != FALSE && count > 0) {
    text.append(buffer, count);
  }
}

}  // namespace

std::vector<std::string> prepare_process(int count, char** arguments) {
  for (std::FILE* stream : {stdin, stdout, stderr}) {
    const int descriptor = ::_fileno(stream);
    if (descriptor >= 0) ::_setmode(descriptor, _O_BINARY);  // lines end as on other systems
  }
  ::SetConsoleOutputCP(CP_UTF8);
  for (const DWORD stream : {STD_OUTPUT_HANDLE, STD_ERROR_HANDLE}) {
    const HANDLE console = ::GetStdHandle(stream);
    DWORD mode = 0;
    if (::GetConsoleMode(console, &mode) == FALSE) continue;
    ::SetConsoleMode(console, mode | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  }
  int wide_count = 0;
  wchar_t** const wide = ::CommandLineToArgvW(::GetCommandLineW(), &wide_count);
  if (wide == nullptr) return {arguments, arguments + count};
  std::vector<std::string> command;
  for (int i = 0; i < wide_count; ++i) command.push_back(to_utf8(wide[i]));
  ::LocalFree(wide);
  return command;
}

void set_interrupt_handler(void (*handler)()) {
  interrupt_handler = handler;
  ::SetConsoleCtrlHandler(handle_interrupt, FALSE);
  if (handler != nullptr) ::SetConsoleCtrlHandler(handle_interrupt, TRUE);
}

bool is_terminal(StandardStream stream) {
  const DWORD number = stream == StandardStream::input    ? STD_INPUT_HANDLE
                       : stream == StandardStream::output ? STD_OUTPUT_HANDLE
                                                          : STD_ERROR_HANDLE;
  DWORD mode = 0;
  return ::GetConsoleMode(::GetStdHandle(number), &mode) != FALSE;
}

bool has_own_console() {
  std::array<DWORD, 2> processes{};
  return ::GetConsoleProcessList(processes.data(), static_cast<DWORD>(processes.size())) == 1;
}

bool is_superuser() {
  return false;
}

std::string environment_variable(const char* name) {
  return to_utf8(read_variable(to_utf16(name).c_str()));
}

fs::path executable_path() {
  return read_text([](wchar_t* text, DWORD size) { return ::GetModuleFileNameW(nullptr, text, size); });
}

long process_number() {
  return static_cast<long>(::GetCurrentProcessId());
}

std::string process_start(long number) {
  constexpr DWORD kAccess = PROCESS_QUERY_LIMITED_INFORMATION | SYNCHRONIZE;
  const Handle process(::OpenProcess(kAccess, FALSE, static_cast<DWORD>(number)));
  FILETIME created{}, ended{}, kernel{}, user{};
  // A process that has ended keeps its number while another has a handle of it.
  if (!process || ::WaitForSingleObject(process.get(), 0) != WAIT_TIMEOUT) return {};
  if (::GetProcessTimes(process.get(), &created, &ended, &kernel, &user) == FALSE) return {};
  return std::to_string((std::uint64_t{created.dwHighDateTime} << 32U) | created.dwLowDateTime);
}

std::string process_namespace() {
  std::wstring name(MAX_COMPUTERNAME_LENGTH + 1, L'\0');
  auto size = static_cast<DWORD>(name.size());
  name.resize(::GetComputerNameW(name.data(), &size) != FALSE ? size : 0);
  std::string text = to_utf8(name);
  for (char& c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  }
  return text;  // start times of processes differ from boot to boot
}

fs::path find_program(const std::string& name) {
  const std::wstring wide = to_utf16(name), folders = read_variable(L"PATH");
  const std::wstring found = read_text([&](wchar_t* text, DWORD size) {
    const DWORD length = ::SearchPathW(folders.c_str(), wide.c_str(), L".exe", size, text, nullptr);
    return length > size ? size : length;
  });
  return found;
}

std::optional<ProgramOutput> run_program(const std::vector<std::string>& command) {
  Pipe out, err;
  if (!out.open() || !err.open()) return std::nullopt;
  const Handle nothing = open_null_device();
  const std::optional<Handle> process = start_program(command, nothing.get(), out.write_end.get(), err.write_end.get());
  out.write_end = Handle();
  err.write_end = Handle();
  if (!process) return std::nullopt;
  ProgramOutput result;
  // Both at once: neither pipe may fill up while the other is waited for.
  std::thread reader([&] { read_to_end(err.read_end, result.err); });
  read_to_end(out.read_end, result.out);
  reader.join();
  result.code = wait_for_program(*process);
  return result;
}

std::optional<int> run_program_silently(const std::vector<std::string>& command) {
  const Handle nothing = open_null_device();
  const std::optional<Handle> process = start_program(command, nothing.get(), nothing.get(), nothing.get());
  return process ? std::optional(wait_for_program(*process)) : std::nullopt;
}

void open_browser(const std::string& url) {
  ::ShellExecuteW(nullptr, L"open", to_utf16(url).c_str(), nullptr, nullptr, SW_SHOWNORMAL);
}

}  // namespace overbend
