# WebAssembly, by Debian's emscripten; programs run under node.
set(ENV{NODE_PATH} /usr/share/nodejs)  # for the checks of the compiler, when it configures
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
# SIMD instructions for kernels alone (src/CMakeLists.txt): where it vectorises ordinary code, this LLVM exchanges
# components, so that at -O3 cross products are wrong.
set(CMAKE_C_FLAGS_INIT "-fwasm-exceptions")
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions")
# With fetch, the script of emscripten 3.1.6 takes node for a browser.
find_program(node NAMES node nodejs REQUIRED)
set(CMAKE_CROSSCOMPILING_EMULATOR ${node} --no-experimental-fetch)
