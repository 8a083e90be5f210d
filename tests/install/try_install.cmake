# cmake -DBUILD=… -DSOURCE=… -DWORK=… -P try_install.cmake

function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE code
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}: ${code}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect what text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "${what}: no \"${pattern}\" in\n${text}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
file(RENAME ${WORK}/first ${WORK}/moved)

# The program, with a scene and its mesh, and pictures by the shaders beside it.
set(share ${WORK}/moved/share/plimsoll)
run(${WORK}/moved/bin/plimsoll run ${share}/scenes/teapot_drop.yaml --out ${WORK}/teapot
  --set duration=0.3)
foreach(file IN ITEMS trajectory.csv summary.json sheet.png)
  if(NOT EXISTS ${WORK}/teapot/${file})
    message(FATAL_ERROR "the installed program wrote no ${file}:\n${output}")
  endif()
endforeach()
# The report's page comes with it where it was built.
if(EXISTS ${BUILD}/report/page.html)
  run(${WORK}/moved/bin/plimsoll report ${WORK}/teapot)
  if(NOT EXISTS ${share}/report/page.html OR NOT EXISTS ${WORK}/teapot/report.html)
    message(FATAL_ERROR "the installed program wrote no report.html:\n${output}")
  endif()
endif()

# A unit has the library that was installed.
if(EXISTS ${BUILD}/fmu/plimsoll_unit.so)
  run(${WORK}/moved/bin/plimsoll export ${share}/scenes/teapot_drop.yaml ${WORK}/teapot.fmu)
  run(${CMAKE_COMMAND} -E tar tf ${WORK}/teapot.fmu)
  expect("a unit of the installed program" "${output}"
    "binaries/[a-z0-9_]+-linux/teapot_drop.so.*resources/files/0/teapot.obj")
endif()

# What editors and shells read is what the program prints.
foreach(printed IN ITEMS "share/plimsoll/scene.schema.json|schema"
    "share/bash-completion/completions/plimsoll|completion;bash"
    "share/zsh/site-functions/_plimsoll|completion;zsh")
  string(REPLACE "|" ";" printed "${printed}")
  list(POP_FRONT printed file)
  file(READ ${WORK}/moved/${file} installed)
  run(${WORK}/moved/bin/plimsoll ${printed})
  if(NOT installed STREQUAL output)
    message(FATAL_ERROR "${file} is not what the program prints")
  endif()
endforeach()

if(EXISTS ${BUILD}/report/comparison.html)
  run(${WORK}/moved/bin/plimsoll compare ${WORK}/teapot ${WORK}/teapot --html ${WORK}/same.html)
  if(NOT EXISTS ${share}/report/comparison.html OR NOT EXISTS ${WORK}/same.html)
    message(FATAL_ERROR "the installed program wrote no page of a comparison:\n${output}")
  endif()
endif()
# Shaders are read at run time: without those that were installed it falls back on the sources.
file(RENAME ${share}/shaders ${share}/shaders-away)
file(WRITE ${share}/shaders/none "")
execute_process(COMMAND ${WORK}/moved/bin/plimsoll run ${share}/scenes/teapot_drop.yaml
  --out ${WORK}/blind --set duration=0.1 RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE output)
if(code EQUAL 0)
  message(FATAL_ERROR "the installed program does not read the installed shaders")
endif()
expect("without shaders" "${output}" "share/plimsoll/shaders")

# The installed headers are closed under inclusion, and none is of the inside of a library.
set(include ${WORK}/moved/include/plimsoll)
file(GLOB_RECURSE headers RELATIVE ${include} ${include}/*)
foreach(header IN LISTS headers)
  if(NOT header MATCHES "^(hydro|engine|app/(base|scene|databases|assembly))/[a-z_/]+\\.h$")
    message(FATAL_ERROR "${header} is installed, which is no header of the libraries")
  endif()
  file(STRINGS ${include}/${header} includes REGEX "^ *#include")
  foreach(line IN LISTS includes)
    if(line MATCHES "\"(.+)\"" AND NOT EXISTS ${include}/${CMAKE_MATCH_1})
      message(FATAL_ERROR "${header} includes ${CMAKE_MATCH_1}, which is not installed")
    endif()
    if(line MATCHES "<(ode|hwy|yaml-cpp|assimp|EGL|GL)/|-inl\\.h")
      message(FATAL_ERROR "${header} is installed and asks its users for more: ${line}")
    endif()
  endforeach()
endforeach()
# Each can be included first: a source file that includes it alone compiles.
file(MAKE_DIRECTORY ${WORK}/headers)
set(sources "")
foreach(header IN LISTS headers)
  string(MAKE_C_IDENTIFIER ${header} name)
  file(WRITE ${WORK}/headers/${name}.cpp "#include \"${header}\"\n")
  list(APPEND sources ${name}.cpp)
endforeach()
list(JOIN sources " " sources)
file(WRITE ${WORK}/headers/CMakeLists.txt "
cmake_minimum_required(VERSION 3.25)
project(headers LANGUAGES CXX)
find_package(plimsoll REQUIRED)
add_library(headers OBJECT ${sources})
target_link_libraries(headers PRIVATE plimsoll::assembly)
target_compile_options(headers PRIVATE -fsyntax-only)
")
run(${CMAKE_COMMAND} -S ${WORK}/headers -B ${WORK}/headers/build -DCMAKE_PREFIX_PATH=${WORK}/moved)
run(${CMAKE_COMMAND} --build ${WORK}/headers/build --parallel 2)

# The libraries, in a project of somebody else: a scene is read, stepped and pushed.
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/crate -B ${WORK}/crate -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_PREFIX_PATH=${WORK}/moved)
run(${CMAKE_COMMAND} --build ${WORK}/crate)
run(${WORK}/crate/crate ${SOURCE}/tests/install/crate/crate.yaml)
expect("the example" "${output}"
  "draught 0\\.(149|150|151) m, by Archimedes 0\\.150 m; drifted by [0-9.]*[1-9]")

# The examples of the libraries' pages, each with its library alone.
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/libraries -B ${WORK}/libraries
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${WORK}/moved)
run(${CMAKE_COMMAND} --build ${WORK}/libraries)
run(${WORK}/libraries/hydro)
expect("the example of hydro" "${output}"
  "4\\.000 m\\^3 displaced: 39226\\.6 N of buoyancy, 526\\.3 N of drag")
run(${WORK}/libraries/engine)
expect("the example of engine" "${output}" "draught 0\\.1[45][0-9] m")
run(${WORK}/libraries/scene ${SOURCE}/tests/install/crate/crate.yaml)
expect("the example of scene" "${output}" "crate starts at z = 2 m")
