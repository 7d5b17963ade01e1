# One test: installs this build and uses it from outside (run.cmake).
add_test(NAME consumer.outsideProjects
    COMMAND "${CMAKE_COMMAND}" "-DBUILD=${PROJECT_BINARY_DIR}" "-DCONFIG=$<CONFIG>" "-DTESTS=${CMAKE_CURRENT_SOURCE_DIR}"
            "-DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/consumer" "-DDATA_DIR=${CMAKE_INSTALL_DATADIR}"
            "-DBIN_DIR=${CMAKE_INSTALL_BINDIR}" "-DSANITIZE=${SEAHEX_SANITIZE}" "-DGENERATOR=${CMAKE_GENERATOR}"
            -P "${CMAKE_CURRENT_SOURCE_DIR}/consumer/run.cmake")
set_tests_properties(consumer.outsideProjects PROPERTIES LABELS slow TIMEOUT 600)
