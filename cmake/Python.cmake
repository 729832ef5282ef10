# evenlift_find_python(VARIABLE MODULES DESCRIPTION) sets the cache entry VARIABLE to a Python that can import MODULES,
# unless it is already set. If there are several Pythons, the first in PATH takes precedence: users and continuous
# integration put their own there.
function(evenlift_find_python variable modules description)
  if(${variable})
    return()
  endif()
  find_program(first_python NAMES python3 python NO_CACHE)
  foreach(python "${first_python}" /usr/bin/python3)
    execute_process(COMMAND "${python}" -c "import ${modules}" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    if("${failed}" STREQUAL "0")
      set(${variable} "${python}" CACHE FILEPATH "${description}")
      return()
    endif()
  endforeach()
endfunction()
