# Reading headers takes most of the time of compiling one of our small files. So each library reads only once what nearly
# all of its files include: Eigen, and the headers that the library names. Every file still includes everything that it
# uses: `./dev tidy` and one job of continuous integration compile without precompiled headers
# (CMAKE_DISABLE_PRECOMPILE_HEADERS).
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
