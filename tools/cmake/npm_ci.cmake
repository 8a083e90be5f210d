# npm_ci(FOLDER RESULT): installs what FOLDER/package-lock.json names, unless that has been done.
# RESULT is empty, or why it could not be done. Packages run no scripts of their own.
function(npm_ci folder result)
  find_program(NPM npm)
  find_program(NODE NAMES node nodejs)
  if(NOT NPM OR NOT NODE)
    set(${result} "npm is missing" PARENT_SCOPE)
    return()
  endif()
  file(SHA256 ${folder}/package-lock.json lock)
  set(stamp ${folder}/node_modules/.installed-${lock})
  if(EXISTS ${stamp})
    set(${result} "" PARENT_SCOPE)
    return()
  endif()
  execute_process(
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1
      --fetch-retry-mintimeout=1000 --loglevel=error
    WORKING_DIRECTORY ${folder} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    set(${result} "npm cannot install its packages:\n${said}" PARENT_SCOPE)
    return()
  endif()
  file(TOUCH ${stamp})
  set(${result} "" PARENT_SCOPE)
endfunction()
