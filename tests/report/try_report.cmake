# cmake -DPROGRAM=… -DPAGES=… -DCMAKE_DIR=… -DSOURCE=… -DWORK=… -P try_report.cmake
include(${CMAKE_CURRENT_LIST_DIR}/driver.cmake)
driver(fault ${PAGES}/page.html ${SOURCE}/check_page.mjs)
if(fault)
  message("skipped: ${fault}")
  return()
endif()

file(REMOVE_RECURSE ${WORK}/run)
execute_process(COMMAND ${PROGRAM} run ${SOURCE}/two_boxes.yaml --out ${WORK}/run --quiet
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} report ${WORK}/run COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${NODE} check_page.mjs ${BROWSER} ${WORK}/run/report.html
  WORKING_DIRECTORY ${WORK}/driver COMMAND_ERROR_IS_FATAL ANY)
