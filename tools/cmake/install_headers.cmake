# Installs headers and all that they include, so that what is installed is closed.
# SOURCE: the root of the sources; HEADERS: relative to it; DESTINATION: the folder.
cmake_policy(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/closed_headers.cmake)
closed_headers(${SOURCE} closed ${HEADERS})
foreach(header IN LISTS closed)
  get_filename_component(folder ${header} DIRECTORY)
  file(INSTALL ${SOURCE}/${header} DESTINATION ${DESTINATION}/${folder})
endforeach()
