# penumbra_add_unit_test(NAME <executable> SOURCES <file>... LIBRARIES <target>... [TIMEOUT <seconds>]
#   [PREPARATION <file>])
#
# Builds a program of Catch2 tests and registers each of its TEST_CASEs in ctest, as
# "<executable>/<name>". The main function comes with it. Tests that render link
# PenumbraTestRendering (or PenumbraOffscreen) among LIBRARIES: their plain vtkRenderWindow then
# needs no X server. TIMEOUT (120) is for each TEST_CASE. PREPARATION defines PrepareTests() where
# none of this will do.
function(penumbra_add_unit_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME;TIMEOUT;PREPARATION" "SOURCES;LIBRARIES")
  if(NOT test_NAME OR NOT test_SOURCES OR test_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "penumbra_add_unit_test needs NAME and SOURCES "
      "and does not know \"${test_UNPARSED_ARGUMENTS}\"")
  endif()
  if(NOT test_TIMEOUT)
    set(test_TIMEOUT 120)
  endif()
  set(support "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
  set(preparation "${support}/PrepareNothing.cxx")
  if("PenumbraTestRendering" IN_LIST test_LIBRARIES OR "PenumbraOffscreen" IN_LIST test_LIBRARIES)
    set(preparation "${support}/PrepareRendering.cxx")
  endif()
  if(test_PREPARATION)
    set(preparation ${test_PREPARATION})
  endif()

  add_executable(${test_NAME} ${test_SOURCES} ${preparation})
  target_link_libraries(${test_NAME} PRIVATE PenumbraTestMain ${test_LIBRARIES})
  set_target_properties(${test_NAME} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/Testing/Programs")
  catch_discover_tests(${test_NAME}
    TEST_PREFIX "${test_NAME}/"
    PROPERTIES
      TIMEOUT ${test_TIMEOUT}
      ENVIRONMENT "DISPLAY="
      SKIP_REGULAR_EXPRESSION "SKIPPED:")
endfunction()
