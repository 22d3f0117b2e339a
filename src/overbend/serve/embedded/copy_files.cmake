# Copies files with their folders: cmake -DFROM=dir -DTO=dir "-DFILES=a|b/c" -P copy_files.cmake
# What is no longer there is taken away: a page is built from its sources alone.
cmake_policy(SET CMP0057 NEW)  # if(... IN_LIST ...)
string(REPLACE "|" ";" FILES "${FILES}")
file(GLOB_RECURSE old RELATIVE ${TO} ${TO}/src/* ${TO}/public/*)
foreach(name IN LISTS old)
  if(NOT name IN_LIST FILES)
    file(REMOVE ${TO}/${name})
  endif()
endforeach()
foreach(name IN LISTS FILES)
  configure_file(${FROM}/${name} ${TO}/${name} COPYONLY)
endforeach()
