# cmake -DPROGRAM=… -DPAGES=… -DCMAKE_DIR=… -DSOURCE=… -DWORK=… -P try_comparison.cmake
include(${CMAKE_CURRENT_LIST_DIR}/driver.cmake)
driver(fault ${PAGES}/comparison.html ${SOURCE}/check_comparison.mjs ${SOURCE}/check_no_replay.mjs)
if(fault)
  message("skipped: ${fault}")
  return()
endif()

file(REMOVE_RECURSE ${WORK}/small_steps ${WORK}/large_steps)
execute_process(COMMAND ${PROGRAM} run ${SOURCE}/two_boxes.yaml --out ${WORK}/small_steps --no-render
  --quiet COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} run ${SOURCE}/two_boxes.yaml --out ${WORK}/large_steps --no-render
  --quiet --set step=0.02 --set bodies[right].position=[0.8,0.6,0.9] COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} compare ${WORK}/small_steps ${WORK}/large_steps
  --html ${WORK}/comparison.html RESULT_VARIABLE code OUTPUT_QUIET)
if(NOT code EQUAL 1)
  message(FATAL_ERROR "compare --html ended with ${code}, expected 1")
endif()
execute_process(COMMAND ${NODE} check_comparison.mjs ${BROWSER} ${WORK}/comparison.html
  WORKING_DIRECTORY ${WORK}/driver COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} compare ${WORK}/small_steps ${WORK}/small_steps/trajectory.csv
  --html ${WORK}/without_replay.html OUTPUT_QUIET)
execute_process(COMMAND ${NODE} check_no_replay.mjs ${BROWSER} ${WORK}/without_replay.html
  WORKING_DIRECTORY ${WORK}/driver COMMAND_ERROR_IS_FATAL ANY)
