# seahex_developer_flags: the warnings of every target of ours. A user's build shows none of them as an error.
add_library(seahex_developer_flags INTERFACE)
target_compile_options(seahex_developer_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual -Wold-style-cast
    $<$<BOOL:${SEAHEX_DEVELOPER}>:-Werror>)
# Boost 1.74 includes headers of its own that it calls deprecated.
target_compile_definitions(seahex_developer_flags INTERFACE BOOST_ALLOW_DEPRECATED_HEADERS)

if(SEAHEX_SANITIZE)
    # With instrumentation in between, g++ 12 sees uninitialised values in Boost's R-tree where there are none.
    target_compile_options(seahex_developer_flags INTERFACE
        -fsanitize=${SEAHEX_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -Wno-maybe-uninitialized)
    target_link_options(seahex_developer_flags INTERFACE -fsanitize=${SEAHEX_SANITIZE})
endif()
