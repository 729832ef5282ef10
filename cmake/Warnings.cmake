include_guard()

# For our own targets only: libraries are included as SYSTEM, so their headers cause no warnings.
add_library(evenlift_warnings INTERFACE)
target_compile_options(
  evenlift_warnings
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            # Files that are compiled together (Precompiled.cmake) may use one name for two things.
            $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>
            -Wconversion
            -Wsign-conversion
            -Wold-style-cast
            -Wnon-virtual-dtor
            -Woverloaded-virtual
            -Wcast-align
            -Wextra-semi
            # Fields have defaults: Request{.teams = 3} is usual.
            -Wno-missing-field-initializers
            $<$<BOOL:${EVENLIFT_WERROR}>:-Werror>)

# With sanitizers GCC reports members of the standard library as uninitialized, as its manual warns.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  target_compile_options(evenlift_warnings INTERFACE -Wno-maybe-uninitialized)
endif()
