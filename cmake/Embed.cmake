# Embeds files in a program, and makes the page's samples. As a module it offers functions; as a script (cmake -D... -P
# Embed.cmake) it writes one of the results.
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  if(DEFINED BYTES_OF)
    # A C++ array of bytes, for #include inside braces.
    file(READ "${BYTES_OF}" bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes "${bytes}")
    file(WRITE "${OUTPUT}" "${bytes}\n")
  endif()
  if(DEFINED TEXTS_IN)
    # Texts as rows {"name", "text"}, for #include inside braces.
    file(GLOB files "${TEXTS_IN}/*.txt")
    set(rows "")
    foreach(file IN LISTS files)
      cmake_path(GET file STEM name)
      file(READ "${file}" text)
      string(APPEND rows "{\"${name}\", R\"text(${text})text\"},\n")
    endforeach()
    file(WRITE "${OUTPUT}" "${rows}")
  endif()
  return()
endif()
include_guard()
set(evenlift_embed_script "${CMAKE_CURRENT_LIST_FILE}")

# Writes the bytes of each given file to a header NAME.inc in the build folder's `embedded`. Sets <variable> to the
# headers' paths, for use as sources, and <variable>_DIR to their folder.
function(evenlift_embed variable)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/embedded")
  set(outputs "")
  foreach(file IN LISTS ARGN)
    cmake_path(GET file FILENAME name)
    set(output "${folder}/${name}.inc")
    add_custom_command(
      OUTPUT "${output}"
      COMMAND "${CMAKE_COMMAND}" "-DBYTES_OF=${file}" "-DOUTPUT=${output}" -P "${evenlift_embed_script}"
      DEPENDS "${file}" "${evenlift_embed_script}"
      VERBATIM)
    list(APPEND outputs "${output}")
  endforeach()
  set(${variable} "${outputs}" PARENT_SCOPE)
  set(${variable}_DIR "${folder}" PARENT_SCOPE)
endfunction()

# Embeds the texts of a folder as one header named after it, with a row {"name", "text"} for each.
function(evenlift_embed_texts variable folder)
  cmake_path(GET folder FILENAME name)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.inc")
  file(GLOB files CONFIGURE_DEPENDS "${folder}/*.txt")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DTEXTS_IN=${folder}" "-DOUTPUT=${output}" -P "${evenlift_embed_script}"
    DEPENDS ${files} "${evenlift_embed_script}"
    VERBATIM)
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()
