# Reading headers takes most of the time of compiling a small file. So each library reads Eigen, and the headers that it
# names, only once. Every file still includes all that it uses: `./dev tidy` and one job of continuous integration use
# no precompiled headers (CMAKE_DISABLE_PRECOMPILE_HEADERS).
include_guard()

function(evenlift_precompile target)
  target_precompile_headers(
    ${target}
    PRIVATE
    <Eigen/Core>
    <algorithm>
    <optional>
    <string>
    <vector>
    ${ARGN})
endfunction()
