# cmake -DPROGRAM=… -DPAGES=… -DCMAKE_DIR=… -DSOURCE=… -DWORK=… -P try_runs.cmake
include(${CMAKE_CURRENT_LIST_DIR}/driver.cmake)
driver(fault ${PAGES}/runs.html ${SOURCE}/check_runs.mjs)
if(fault)
  message("skipped: ${fault}")
  return()
endif()

set(folders "")
foreach(density IN ITEMS 400 500 600)
  list(APPEND folders ${WORK}/density_${density})
  file(REMOVE_RECURSE ${WORK}/density_${density})
  execute_process(COMMAND ${PROGRAM} run ${SOURCE}/two_boxes.yaml --out ${WORK}/density_${density}
    --no-render --quiet --set bodies[right].density=${density} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${PROGRAM} report ${folders} --out ${WORK}/runs.html
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${NODE} check_runs.mjs ${BROWSER} ${WORK}/runs.html
  WORKING_DIRECTORY ${WORK}/driver COMMAND_ERROR_IS_FATAL ANY)
