# Debian's FindGeographicLib sets variables and no target.
if(NOT TARGET GeographicLib::GeographicLib)
    add_library(GeographicLib::GeographicLib INTERFACE IMPORTED)
    set_target_properties(GeographicLib::GeographicLib PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${GeographicLib_INCLUDE_DIRS}"
        INTERFACE_LINK_LIBRARIES "${GeographicLib_LIBRARIES}")
endif()
