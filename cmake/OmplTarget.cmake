# Debian 12's OMPL (1.5.2) sets variables and no target, and its library list names what only libompl itself links (`ode`,
# parts of Boost), whether their development packages are there or not. This gives every version the target that newer ones
# bring: ompl::ompl.
if(NOT TARGET ompl::ompl)
    set(_seahex_ompl_libraries)
    foreach(_seahex_library IN LISTS OMPL_LIBRARIES)
        if(EXISTS "${_seahex_library}")
            list(APPEND _seahex_ompl_libraries "${_seahex_library}")
        endif()
    endforeach()
    add_library(ompl::ompl INTERFACE IMPORTED)
    set_target_properties(ompl::ompl PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${OMPL_INCLUDE_DIRS}"
        INTERFACE_LINK_LIBRARIES "${_seahex_ompl_libraries}")
    unset(_seahex_ompl_libraries)
endif()
