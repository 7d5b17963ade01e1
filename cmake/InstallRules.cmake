# cmake --install puts libraries, headers, charts and a package config, so that find_package(seahex) works elsewhere.
include(CMakePackageConfigHelpers)

set(SEAHEX_CONFIG_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/seahex")
install(TARGETS seahex_core seahex_chart seahex_io seahex_planning seahex EXPORT seahexTargets FILE_SET HEADERS)
install(EXPORT seahexTargets NAMESPACE seahex:: DESTINATION "${SEAHEX_CONFIG_DIR}")

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/seahexConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/seahexConfig.cmake" INSTALL_DESTINATION "${SEAHEX_CONFIG_DIR}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/seahexConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/seahexConfig.cmake" "${PROJECT_BINARY_DIR}/seahexConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/OmplTarget.cmake" "${PROJECT_SOURCE_DIR}/cmake/GeographicLibTarget.cmake"
        DESTINATION "${SEAHEX_CONFIG_DIR}")

install(DIRECTORY "${PROJECT_SOURCE_DIR}/maps/" DESTINATION "${CMAKE_INSTALL_DATADIR}/seahex/maps"
        FILES_MATCHING PATTERN "*.000" PATTERN "README.md")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
