# cmake -DWEB=sources -DWORK=folder -DPAGES=folder -P bundle_report.cmake
include(${CMAKE_CURRENT_LIST_DIR}/npm_ci.cmake)

# Nothing is made in the source tree: its node_modules, if there is one, is not this build's.
file(COPY ${WEB}/ DESTINATION ${WORK} PATTERN node_modules EXCLUDE)
npm_ci(${WORK} fault)
if(fault)
  message(WARNING "plimsoll report and compare --html will not work, the rest will: ${fault}")
  file(REMOVE ${PAGES}/page.html ${PAGES}/comparison.html ${PAGES}/runs.html)
  return()
endif()
find_program(NODE NAMES node nodejs)
execute_process(COMMAND ${NODE} bundle.mjs ${PAGES} WORKING_DIRECTORY ${WORK}
  COMMAND_ERROR_IS_FATAL ANY)
