# The native program and the WebAssembly one print the same bytes.
# cmake -DNATIVE=... -DNODE=... -DWEBASSEMBLY=... -DPOLYGONS=... -DWORK=... -P determinism.cmake
cmake_minimum_required(VERSION 3.24)

foreach(needed NATIVE NODE WEBASSEMBLY POLYGONS WORK)
  if(NOT ${needed})
    message(FATAL_ERROR "-D${needed}=... is missing")
  endif()
endforeach()
if(NOT EXISTS "${WEBASSEMBLY}")
  message(FATAL_ERROR "${WEBASSEMBLY} is not built")
endif()
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")

set(compared 0)
set(differences 0)

# compare(<arguments>...): compares the output of both programs in WORK, to the byte.
function(compare)
  foreach(kind native wasm)
    if(kind STREQUAL native)
      set(program "${NATIVE}")
    else()
      set(program "${NODE}" "${WEBASSEMBLY}")
    endif()
    execute_process(
      COMMAND ${program} ${ARGN}
      WORKING_DIRECTORY "${WORK}"
      OUTPUT_FILE "${WORK}/${kind}.out"
      ERROR_FILE "${WORK}/${kind}.err"
      RESULT_VARIABLE status)
    file(SHA256 "${WORK}/${kind}.out" ${kind}_out)
    file(SHA256 "${WORK}/${kind}.err" ${kind}_err)
    set(${kind} "${status} ${${kind}_out} ${${kind}_err}")
  endforeach()
  if(NOT native STREQUAL wasm)
    list(JOIN ARGN " " line)
    math(EXPR differences "${differences} + 1")
    set(differences ${differences} PARENT_SCOPE)
    foreach(kind native wasm)
      file(RENAME "${WORK}/${kind}.out" "${WORK}/${differences}.${kind}.out")
      file(RENAME "${WORK}/${kind}.err" "${WORK}/${differences}.${kind}.err")
    endforeach()
    message(SEND_ERROR "evenlift ${line}: native and WebAssembly differ, see ${WORK}/${differences}.*")
    if(differences EQUAL 10)
      message(FATAL_ERROR "ten differences are enough")
    endif()
  endif()
  math(EXPR compared "${compared} + 1")
  set(compared ${compared} PARENT_SCOPE)
endfunction()

set(metrics area circle distance distributed random)

# Every sample with one metric in turn: starting the programs takes most of the time. soak/fingerprints.test.mjs
# compares thousands of polygons with every metric and setting in one run.
file(GLOB files "${POLYGONS}/*.txt")
set(turn 0)
foreach(file IN LISTS files)
  cmake_path(GET file STEM name)
  if(name STREQUAL index)
    continue()
  endif()
  math(EXPR index "${turn} % 5")
  list(GET metrics ${index} metric)
  compare(place "${file}" --json --candidates --metric ${metric} --teams 5 --seed ${turn})
  math(EXPR due "${turn} % 3")
  if(due EQUAL 0)
    compare(trace "${file}" --json --metric ${metric} --teams 4 --seed ${turn})
  endif()
  math(EXPR turn "${turn} + 1")
endforeach()

# The generators.
foreach(family regular convex star comb spiral random)
  foreach(n 8 53 104)
    compare(generate ${family} --n ${n} --seed ${n})
  endforeach()
endforeach()

# Drawings, tables and results: their lists of shapes, and each shape, with coarse and fine edges.
file(GLOB drawings "${POLYGONS}/../../tests/data/import/*")
foreach(file IN LISTS drawings)
  compare(place "${file}")
  compare(place "${file}" --shape all --json)
  compare(place "${file}" --shape all --json --flatten 0.001)
endforeach()

# The other outputs, and refusals.
compare(place "${POLYGONS}/grand-piano.txt" --svg picture.svg)
file(SHA256 "${WORK}/picture.svg" wasm_picture)
execute_process(COMMAND "${NATIVE}" place "${POLYGONS}/grand-piano.txt" --svg picture.svg
                WORKING_DIRECTORY "${WORK}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(SHA256 "${WORK}/picture.svg" native_picture)
if(NOT wasm_picture STREQUAL native_picture)
  message(FATAL_ERROR "place --svg: native and WebAssembly draw different pictures")
endif()
compare(place "${POLYGONS}/labyrinth.txt" --teams max --candidates)
compare(link encode "${POLYGONS}/thesis-sample.txt" --teams 7 --metric circle)
compare(trace "${POLYGONS}/thesis-sample.txt" --teams max --min-ratio 0)
compare(generate random --n 20000 --seed 9)
foreach(name worktop guitar boomerang grand-piano square)
  compare(trace "${POLYGONS}/${name}.txt" --json --metric balanced --robots 6)
endforeach()
compare(place missing.txt)
compare(place "${POLYGONS}/square.txt" --teams 0)
compare()

# The times in an experiment's files differ.
set(measured "")
foreach(name square star hammer thesis-sample letter-e-moved gear comb)
  list(APPEND measured "${POLYGONS}/${name}.txt")
endforeach()
execute_process(COMMAND "${NATIVE}" experiment ${measured} --out native-experiment --samples 4 --max-balanced 8 --jobs 2
                WORKING_DIRECTORY "${WORK}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${NODE}" "${WEBASSEMBLY}" experiment ${measured} --out wasm-experiment --samples 4 --max-balanced 8
                WORKING_DIRECTORY "${WORK}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(name measurements.csv aggregates.csv polygons.csv thesis.md robots.md report.html)
  file(SHA256 "${WORK}/native-experiment/${name}" native_sum)
  file(SHA256 "${WORK}/wasm-experiment/${name}" wasm_sum)
  if(NOT native_sum STREQUAL wasm_sum)
    message(FATAL_ERROR "experiment: native and WebAssembly write different ${name}")
  endif()
endforeach()

message(STATUS "${compared} runs and an experiment, the same bytes")
