# Installs the build to a folder of its own and builds README's example against it. README must show
# the very files that are built.

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}")
  endif()
endfunction()

file(READ "${README}" readme)
foreach(shown example.cxx CMakeLists.example.txt)
  file(READ "${EXAMPLE}/${shown}" text)
  string(FIND "${readme}" "${text}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "README.md does not show ${EXAMPLE}/${shown} as it is")
  endif()
endforeach()

set(prefix "${BUILD}/Testing/installed")
set(project "${BUILD}/Testing/example")
file(REMOVE_RECURSE "${prefix}" "${project}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}" --config "${CONFIGURATION}")

file(MAKE_DIRECTORY "${project}")
configure_file("${EXAMPLE}/example.cxx" "${project}/example.cxx" COPYONLY)
configure_file("${EXAMPLE}/CMakeLists.example.txt" "${project}/CMakeLists.txt" COPYONLY)
run("${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${project}" -B "${project}/build"
  "-DCMAKE_BUILD_TYPE=${CONFIGURATION}" "-DCMAKE_PREFIX_PATH=${prefix}" "-DVTK_DIR=${VTK_DIR}")
run("${CMAKE_COMMAND}" --build "${project}/build")
