# cmake -DPROGRAM=… -DPAGE=… -DCMAKE_DIR=… -DSOURCE=… -DWORK=… -P try_report.cmake
include(${CMAKE_DIR}/npm_ci.cmake)

# A build without npm has no page, and a machine may have no browser.
find_program(BROWSER NAMES chromium chromium-browser google-chrome google-chrome-stable)
if(NOT BROWSER)
  message("skipped: no chromium")
  return()
endif()
# Ubuntu's is a script that asks for a snap.
execute_process(COMMAND ${BROWSER} --version RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
if(NOT code EQUAL 0)
  message("skipped: ${BROWSER} does not start")
  return()
endif()
if(NOT EXISTS ${PAGE})
  message("skipped: the report's page was not built; build the target report_page")
  return()
endif()
# Beside the folder of the run: what was installed stays for the next test.
set(driver ${WORK}/driver)
file(MAKE_DIRECTORY ${driver})
file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/.npmrc ${SOURCE}/browser.mjs
  ${SOURCE}/check_page.mjs DESTINATION ${driver})
npm_ci(${driver} fault)
if(fault)
  message("skipped: ${fault}")
  return()
endif()

file(REMOVE_RECURSE ${WORK}/run)
execute_process(COMMAND ${PROGRAM} run ${SOURCE}/two_boxes.yaml --out ${WORK}/run --quiet
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} report ${WORK}/run COMMAND_ERROR_IS_FATAL ANY)
find_program(NODE NAMES node nodejs)
execute_process(COMMAND ${NODE} check_page.mjs ${BROWSER} ${WORK}/run/report.html
  WORKING_DIRECTORY ${driver} COMMAND_ERROR_IS_FATAL ANY)
