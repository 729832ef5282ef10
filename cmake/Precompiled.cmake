# Reading Eigen takes most of the time of compiling one of our small files, so each library reads it only once. Every
# file still includes everything that it uses: `./dev tidy` and one job of continuous integration compile without
# precompiled headers (CMAKE_DISABLE_PRECOMPILE_HEADERS).
include_guard()

# evenlift_precompile(TARGET [HEADER...])
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
