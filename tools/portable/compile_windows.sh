#!/usr/bin/env bash
# Compiles the sources for Windows that no build of this machine compiles: a quick check on every change.
set -euo pipefail
cd "$(dirname "$0")/../.."
compile() {
  x86_64-w64-mingw32-g++-posix -std=c++20 -D_WIN32_WINNT=0x0A00 -Wall -Wextra -Werror -fsyntax-only -Isrc/overbend "$1"
}
export -f compile
printf '%s\n' src/overbend/platform/windows/*.cpp src/overbend/platform/temporary.cpp | xargs -P "$(nproc)" -I{} bash -c 'compile {}'
