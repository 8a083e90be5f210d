# The page of `plimsoll report`, bundled by npm's esbuild into build/report/page.html. The program
# does without it: where npm is missing, or has nowhere to download from, the build says so and goes
# on, and `plimsoll report` says what is missing.
set(web ${PROJECT_SOURCE_DIR}/app/report/web)
set(web_sources
  .npmrc
  bundle.mjs
  charts.js
  clock.js
  data.js
  facts.js
  format.js
  package-lock.json
  package.json
  page.html
  plots.js
  replay.js
  report.js
  sea.js
  strip.js
  style.css
  surface.js)
list(TRANSFORM web_sources PREPEND ${web}/)
set(page ${PROJECT_BINARY_DIR}/report/page.html)
add_custom_command(OUTPUT ${page}
  COMMAND ${CMAKE_COMMAND} -DWEB=${web} -DWORK=${PROJECT_BINARY_DIR}/report_web -DPAGE=${page}
    -P ${PROJECT_SOURCE_DIR}/cmake/bundle_report.cmake
  DEPENDS ${web_sources} ${PROJECT_SOURCE_DIR}/cmake/bundle_report.cmake
  COMMENT "Bundling the report's page" VERBATIM)
# Builds with sanitizers test nothing with it.
if(PLIMSOLL_SANITIZE)
  add_custom_target(report_page DEPENDS ${page})
else()
  add_custom_target(report_page ALL DEPENDS ${page})
endif()
