# Writes a C++ source with a hash of the files below the folder SOURCE to the file OUTPUT, unless it is the same:
#   cmake -D SOURCE=src -D OUTPUT=source_hash.cpp -P source_hash.cmake
# It tells apart programs whose results may differ, also where there is no version control.
file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${SOURCE} ${SOURCE}/*)
list(SORT files)
foreach(file IN LISTS files)
  file(SHA256 ${SOURCE}/${file} hash)
  string(APPEND all "${hash} ${file}\n")
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING ${hash} 0 16 hash)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT
"#include \"bind/program/library.hpp\"

const char* const signorini::bind::source_hash = \"${hash}\";
")
