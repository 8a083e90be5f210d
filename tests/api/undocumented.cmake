# cmake -DSOURCE=… -DWORK=… -P undocumented.cmake: the pages of sources in which one comment of a
# public header is missing must have that fault, and no other.
cmake_policy(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/app ${SOURCE}/engine ${SOURCE}/hydro DESTINATION ${WORK}
  FILES_MATCHING PATTERN "*.h" PATTERN node_modules EXCLUDE)
file(COPY ${SOURCE}/tools/cmake ${SOURCE}/tools/reference DESTINATION ${WORK}/tools)
file(COPY ${SOURCE}/tests/install DESTINATION ${WORK}/tests)
file(COPY ${SOURCE}/CMakeLists.txt DESTINATION ${WORK})
set(comment "/// Steps taken since the start.")
set(header ${WORK}/engine/simulation.h)
file(READ ${header} text)
string(REPLACE "${comment}" "" without "${text}")
if(without STREQUAL text)
  message(FATAL_ERROR "${header} lacks the comment ${comment}")
endif()
file(WRITE ${header} "${without}")
execute_process(COMMAND ${CMAKE_COMMAND} -DPAGES=${WORK}/pages -P ${WORK}/tools/cmake/make_api.cmake
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(REGEX MATCHALL "is not documented" faults "${output}")
list(LENGTH faults count)
if(code EQUAL 0 OR NOT count EQUAL 1 OR NOT output MATCHES "steps\\(\\) const.* is not documented")
  message(FATAL_ERROR "expected one fault, of Simulation::steps; exit code ${code}, and\n${output}")
endif()
