# Installs a build into an empty folder, then configures, builds and runs two projects that know it by find_package alone.
#   cmake -DBUILD=... -DCONFIG=... -DTESTS=... -DSCRATCH=... -DDATA_DIR=share -DBIN_DIR=bin -DSANITIZE=... -DGENERATOR=Ninja -P run.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
    list(JOIN ARGV " " command)
    message(STATUS "${command}")
    execute_process(COMMAND ${ARGV} WORKING_DIRECTORY "${SCRATCH}" RESULT_VARIABLE result OUTPUT_VARIABLE out
                    ERROR_VARIABLE err)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "failed (${result}): ${command}\n${out}\n${err}")
    endif()
    set(output "${out}" PARENT_SCOPE)
endfunction()

function(expect text pattern)
    if(NOT text MATCHES "${pattern}")
        message(FATAL_ERROR "'${pattern}' was expected in\n${text}")
    endif()
endfunction()

function(refuse text pattern)
    if(text MATCHES "${pattern}")
        message(FATAL_ERROR "'${pattern}' must not be in\n${text}")
    endif()
endfunction()

# The prefix has a blank, and is moved after the installation: a package must bear both.
set(first_prefix "${SCRATCH}/first prefix")
set(prefix "${SCRATCH}/other prefix")
file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}" --prefix "${first_prefix}")
file(RENAME "${first_prefix}" "${prefix}")

set(flags "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_BUILD_TYPE=Release)
if(SANITIZE)
    list(APPEND flags "-DCMAKE_CXX_FLAGS=-fsanitize=${SANITIZE}")
endif()
foreach(project IN ITEMS consumer consumer_planning)
    file(COPY "${TESTS}/${project}" DESTINATION "${SCRATCH}")
    if(project STREQUAL consumer)
        file(COPY_FILE "${TESTS}/../demos/first_route.cpp" "${SCRATCH}/consumer/main.cpp")
    endif()
    run("${CMAKE_COMMAND}" -S "${SCRATCH}/${project}" -B "${SCRATCH}/build-${project}" -G "${GENERATOR}" ${flags})
    run("${CMAKE_COMMAND}" --build "${SCRATCH}/build-${project}")
endforeach()

# The program reads maps/shangchuan.000, which the installation has too, and writes route.geojson.
file(MAKE_DIRECTORY "${SCRATCH}/run")
file(CREATE_LINK "${prefix}/${DATA_DIR}/seahex/maps" "${SCRATCH}/run/maps" SYMBOLIC)
run("${CMAKE_COMMAND}" -E chdir "${SCRATCH}/run" "${SCRATCH}/build-consumer/consumer")
file(READ "${SCRATCH}/run/route.geojson" route)
expect("${route}" "\\[ 112\\.521, 21\\.635 \\].*\\[ 112\\.901, 21\\.669 \\]")

# The straight line is 113.1 long, and no path on hexagons with three rings is more than 3 % longer.
run("${SCRATCH}/build-consumer_planning/consumer_planning")
expect("${output}" "length 11[3-6]")
run(ldd "${SCRATCH}/build-consumer_planning/consumer_planning")
expect("${output}" "libompl")
refuse("${output}" "libgdal|libcairo|libGeographic")

# The installed plan_route finds its chart in the prefix.
run("${prefix}/${BIN_DIR}/plan_route" --scenario cheng2020 --json)
expect("${output}" "\"source\": \"${prefix}/${DATA_DIR}/seahex/maps/shangchuan.000\"")
message(STATUS "both projects work")
