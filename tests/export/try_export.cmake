# cmake -DPROGRAM=… -DCMAKE_DIR=… -DSOURCE=… -DWORK=… -P try_export.cmake
include(${CMAKE_DIR}/npm_ci.cmake)
file(MAKE_DIRECTORY ${WORK})
file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/.npmrc ${SOURCE}/check_export.mjs
  DESTINATION ${WORK})
npm_ci(${WORK} fault)
if(fault)
  message("skipped: ${fault}")
  return()
endif()
find_program(NODE NAMES node nodejs)
file(REMOVE_RECURSE ${WORK}/run)
execute_process(COMMAND ${PROGRAM} run ${SOURCE}/rigged_boxes.yaml --out ${WORK}/run --no-render --quiet
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} export ${WORK}/run ${WORK}/run.glb --fps 50 COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${NODE} check_export.mjs run.glb run/trajectory.csv WORKING_DIRECTORY ${WORK}
  COMMAND_ERROR_IS_FATAL ANY)
