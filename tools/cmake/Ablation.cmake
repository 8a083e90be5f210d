# Writes into a folder, to stand before the sources, a constants.h of engine whose constants are
# read from the environment.
function(plimsoll_write_ablated_constants folder)
  set(maker ${PROJECT_SOURCE_DIR}/tools/ablation/constants.py)
  execute_process(COMMAND ${Python_EXECUTABLE} -B ${maker} --write ${folder} COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB_RECURSE constants ${PROJECT_SOURCE_DIR}/engine/constants.h)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${maker} ${constants})
endfunction()
