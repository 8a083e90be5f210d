# Puts a header before engine's constants.h whose constants are read from the environment.
set(ablation ${PROJECT_SOURCE_DIR}/tools/ablation/constants.py)
execute_process(COMMAND ${Python_EXECUTABLE} -B ${ablation} --write ${CMAKE_BINARY_DIR}/ablation
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE constants ${PROJECT_SOURCE_DIR}/engine/constants.h)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ablation} ${constants})
include_directories(BEFORE ${CMAKE_BINARY_DIR}/ablation)
