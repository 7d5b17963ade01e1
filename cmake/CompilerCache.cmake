# Uses ccache where there is one; set CMAKE_CXX_COMPILER_LAUNCHER to choose another or none.
find_program(SEAHEX_CCACHE ccache)
mark_as_advanced(SEAHEX_CCACHE)
if(SEAHEX_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${SEAHEX_CCACHE}")
endif()
