# cmake --install: the program with what it reads, and the libraries as a package for CMake.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS plimsoll RUNTIME)
install(DIRECTORY shaders scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/plimsoll
  PATTERN pictures EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/report/page.html
  ${PROJECT_BINARY_DIR}/report/comparison.html
  ${PROJECT_BINARY_DIR}/report/runs.html
  DESTINATION ${CMAKE_INSTALL_DATADIR}/plimsoll/report OPTIONAL)
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY app DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN *.md
  PATTERN web EXCLUDE)
install(FILES scenes/README.md scenes/GUIDE.md scenes/KEYS.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/scenes)

# What the program prints for editors and shells.
foreach(printed IN ITEMS
    "schema|scene.schema.json|plimsoll"
    "completion bash|plimsoll|bash-completion/completions"
    "completion zsh|_plimsoll|zsh/site-functions")
  string(REPLACE "|" ";" printed "${printed}")
  list(GET printed 0 command)
  list(GET printed 1 name)
  list(GET printed 2 folder)
  string(REPLACE " " ";" command "${command}")
  list(JOIN command "\" \"" command)
  set(file ${PROJECT_BINARY_DIR}/printed/${name})
  install(CODE "
    file(MAKE_DIRECTORY \"${PROJECT_BINARY_DIR}/printed\")
    execute_process(COMMAND \"$<TARGET_FILE:plimsoll>\" \"${command}\"
      OUTPUT_FILE \"${file}\" COMMAND_ERROR_IS_FATAL ANY)")
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder})
endforeach()

# plimsoll::base and plimsoll::databases are there for the others; their headers are not meant for users.
install(TARGETS plimsoll_hydro plimsoll_engine plimsoll_base plimsoll_scene plimsoll_databases
  plimsoll_assembly
  EXPORT plimsoll)
include(tools/cmake/PublicHeaders.cmake)
install(CODE "
  set(SOURCE \"${PROJECT_SOURCE_DIR}\")
  set(HEADERS \"${public_headers}\")
  set(DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/plimsoll\")
  include(\"${PROJECT_SOURCE_DIR}/tools/cmake/install_headers.cmake\")")
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/plimsoll)
install(EXPORT plimsoll NAMESPACE plimsoll:: FILE plimsoll-targets.cmake DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plimsoll-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES tools/cmake/plimsoll-config.cmake ${PROJECT_BINARY_DIR}/plimsoll-config-version.cmake
  DESTINATION ${package})

# cpack --config build/CPackConfig.cmake: a Debian package of all that.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "Plimsoll's maintainers <maintainers@plimsoll.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "maritime sandbox: bodies of any shape in water")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Pictures need them; they are loaded by name.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libegl-mesa0, libgl1-mesa-dri, fonts-dejavu-core")
# What a project that uses the libraries builds with.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libassimp-dev, libeigen3-dev, libfmt-dev, libhwy-dev, libmuparser-dev, \
libode-dev, libpng-dev, libtbb-dev, libyaml-cpp-dev")
set(CPACK_STRIP_FILES ON)
include(CPack)
