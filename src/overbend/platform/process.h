/// This process, other processes and programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// To be called at the start of main(). Opens standard streams that the calling program has closed: the next files
/// opened would otherwise get their numbers, and text meant for the terminal would be written into results. Lets a
/// limit of the size of files be reported like a full disk. Returns the command line in UTF-8, beginning with the
/// program.
std::vector<std::string> prepare_process(int count, char** arguments);

/// Calls `handler` at the first Ctrl-C or request to end (SIGTERM; closing of the console window); the second ends the
/// program. `handler` may only set an atomic variable. nullptr: the first one ends the program.
void set_interrupt_handler(void (*handler)());

enum class StandardStream { input, output, error };
bool is_terminal(StandardStream stream);

/// True if the console window was opened for this program alone: by a double-click on it. Always false but on Windows.
bool has_own_console();

/// True if the process runs as the superuser, under whom some programs restrict themselves. Always false on Windows.
bool is_superuser();

/// Returns the value of an environment variable in UTF-8; empty if it is not set.
std::string environment_variable(const char* name);

/// Returns the path of this program; empty if the system does not report it.
std::filesystem::path executable_path();

/// Returns the number of this process.
long process_number();

/// Returns the start time of a process in a notation of the system, which distinguishes processes with the same number;
/// empty if there is no such process.
std::string process_start(long number);

/// Returns machine, its boot and its process namespace as letters, digits, "-" and "_": numbers of processes are
/// comparable only if these are equal.
std::string process_namespace();

/// Returns the path of a program found on the PATH; empty if not found.
std::filesystem::path find_program(const std::string& name);

struct ProgramOutput {
  int code = 0;  ///< Exit code; 128 plus the signal if one terminated it.
  std::string out, err;
};

/// Runs the program named by the first item of `command`, found on the PATH, with the other items as arguments,
/// unchanged and without a shell, and waits for it; its input is empty. Empty if there is no such program.
std::optional<ProgramOutput> run_program(const std::vector<std::string>& command);

/// Same, with the output discarded. Returns the exit code.
std::optional<int> run_program_silently(const std::vector<std::string>& command);

/// Opens an address in the user's browser if there is a display; does not wait for it, and errors are ignored.
void open_browser(const std::string& url);

}  // namespace overbend
