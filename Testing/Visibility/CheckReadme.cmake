# README must show the very files that are built.
file(READ "${README}" readme)
foreach(shown example.cxx CMakeLists.example.txt)
  file(READ "${EXAMPLE}/${shown}" text)
  string(FIND "${readme}" "${text}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "${README} does not show ${EXAMPLE}/${shown} as it is")
  endif()
endforeach()
