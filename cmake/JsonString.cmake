# json_string(VARIABLE TEXT): the text as a JSON string, quotes included. For the scripts beside this file.
function(json_string variable text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(REPLACE "\n" "\\n" text "${text}")
  string(REPLACE "\t" "\\t" text "${text}")
  string(REPLACE "\r" "" text "${text}")
  set(${variable} "\"${text}\"" PARENT_SCOPE)
endfunction()
