# Writes a C++ source that takes files into the program:
#   cmake -DOUT=x.cpp "-DFILES=name=path|name=path" -DSYSTEM=Linux -P embed.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../cmake/embed_bytes.cmake)
set(symbols "")
set(table "")
string(REPLACE "|" ";" FILES "${FILES}")
foreach(entry IN LISTS FILES)
  string(FIND "${entry}" "=" cut)
  string(SUBSTRING "${entry}" 0 ${cut} name)
  math(EXPR cut "${cut} + 1")
  string(SUBSTRING "${entry}" ${cut} -1 path)
  embed_bytes(symbol overbend_report_${name} "${path}")
  file(SIZE "${path}" bytes)
  string(APPEND symbols "${symbol}")
  string(APPEND table "  if (name == \"${name}\") return {overbend_report_${name}, ${bytes}};\n")
endforeach()
file(WRITE "${OUT}" "// Made by report/embed.cmake; do not edit.\n#include \"report/page/assets.h\"\n\n${symbols}
namespace overbend {

std::string_view report_asset(std::string_view name) {
${table}  return {};
}

}  // namespace overbend
")
