# Run as a script: writes a header with the project's version and a digest of the sources that decide which cells of a
# chart are blocked. A file of cells names it, so that no file outlives a change of the rules, whoever forgets what.
#
#   cmake -DROOT=<source tree> -DROOMS=<room,room> -DVERSION=<x.y.z> -DHEADER=<file> -P DigestOfCode.cmake
string(REPLACE "," ";" rooms "${ROOMS}")
set(sources)
foreach(room IN LISTS rooms)
    file(GLOB found RELATIVE "${ROOT}" "${ROOT}/include/seahex/${room}/*.h" "${ROOT}/src/${room}/*.h"
         "${ROOT}/src/${room}/*.cpp")
    list(APPEND sources ${found})
endforeach()
if(NOT sources)
    message(FATAL_ERROR "no sources in the rooms ${ROOMS} of ${ROOT}")
endif()
list(SORT sources)

set(digests "")
foreach(source IN LISTS sources)
    file(SHA256 "${ROOT}/${source}" digest)
    string(APPEND digests "${source} ${digest}\n")
endforeach()
string(SHA256 whole "${digests}")

file(WRITE "${HEADER}" "#pragma once

namespace seahex
{

constexpr const char *PROGRAM_VERSION = \"${VERSION}\";
constexpr const char *CODE_DIGEST = \"${whole}\";

}  // namespace seahex
")
