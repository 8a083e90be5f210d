# driver(RESULT PAGE SCRIPTS…): a folder with scripts and what they need to drive a browser, and
# BROWSER and NODE. RESULT is empty, or why there is none. Uses CMAKE_DIR, SOURCE and WORK.
include(${CMAKE_DIR}/npm_ci.cmake)

function(driver result page)
  # A build without npm has no page, and a machine may have no browser.
  find_program(BROWSER NAMES chromium chromium-browser google-chrome google-chrome-stable)
  find_program(NODE NAMES node nodejs)
  if(NOT BROWSER)
    set(${result} "no chromium" PARENT_SCOPE)
    return()
  endif()
  # Ubuntu's is a script that asks for a snap.
  execute_process(COMMAND ${BROWSER} --version RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
  if(NOT code EQUAL 0)
    set(${result} "${BROWSER} does not start" PARENT_SCOPE)
    return()
  endif()
  if(NOT EXISTS ${page})
    set(${result} "the report's page was not built; build the target report_page" PARENT_SCOPE)
    return()
  endif()
  # Beside the folders of runs: what was installed stays for the next test.
  file(MAKE_DIRECTORY ${WORK}/driver)
  file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/.npmrc
    ${SOURCE}/browser.mjs ${SOURCE}/plots.mjs ${ARGN} DESTINATION ${WORK}/driver)
  npm_ci(${WORK}/driver fault)
  set(${result} "${fault}" PARENT_SCOPE)
endfunction()
