include_guard()

# For our own targets only; libraries come in as SYSTEM, so their headers stay silent.
add_library(evenlift_warnings INTERFACE)
target_compile_options(
  evenlift_warnings
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            -Wshadow
            -Wconversion
            -Wsign-conversion
            -Wold-style-cast
            -Wnon-virtual-dtor
            -Woverloaded-virtual
            -Wcast-align
            -Wextra-semi
            # Fields have defaults: Request{.teams = 3} is the way to fill a struct.
            -Wno-missing-field-initializers
            $<$<BOOL:${EVENLIFT_WERROR}>:-Werror>)

# With sanitizers GCC takes members of the standard library for uninitialized, as its manual says.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  target_compile_options(evenlift_warnings INTERFACE -Wno-maybe-uninitialized)
endif()
