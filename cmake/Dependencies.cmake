# What the floors stand on. All of it comes as Debian 12 packages; demos/ and tests/ look for their own.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED)  # headers only: geometry
find_package(ompl 1.5 REQUIRED)
include(OmplTarget)

find_package(GDAL 3.6 REQUIRED)
list(APPEND CMAKE_MODULE_PATH /usr/share/cmake/geographiclib)  # Debian ships the module beside CMake's own
find_package(GeographicLib REQUIRED)
include(GeographicLibTarget)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo>=1.16)
find_package(Threads REQUIRED)
