# cmake -DSCRIPT=… -P try_script.cmake
find_program(NODE NAMES node nodejs)
if(NOT NODE)
  message("skipped: no node")
  return()
endif()
execute_process(COMMAND ${NODE} ${SCRIPT} COMMAND_ERROR_IS_FATAL ANY)
