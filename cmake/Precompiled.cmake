# Reading Eigen is most of what compiling one of our small files takes: each library reads it once. Every file still includes
# what it uses: `./dev tidy` and one job of continuous integration compile without (CMAKE_DISABLE_PRECOMPILE_HEADERS).
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
