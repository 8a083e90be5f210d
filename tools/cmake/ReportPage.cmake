# The pages of `plimsoll report`, of one run and of several, and of `plimsoll compare --html`,
# bundled by npm's esbuild into build/report. The program does without them: where npm is missing, or
# has nowhere to download from, the build says so and goes on, and these commands say what is missing.
set(web ${PROJECT_SOURCE_DIR}/app/report/web)
set(web_sources
  .npmrc
  analysis.js
  backdrop.js
  bundle.mjs
  charts.js
  chooser.js
  clock.js
  comparison.css
  comparison.html
  comparison.js
  differences.js
  data.js
  extent.js
  facts.js
  format.js
  line_shapes.js
  package-lock.json
  package.json
  page.html
  plots.js
  pressure.js
  quantities.js
  replay.js
  report.js
  runs.css
  runs.html
  runs.js
  rig.js
  rigging.js
  sea.js
  spectra.js
  stage.js
  strip.js
  style.css
  surface.js
  track.js)
list(TRANSFORM web_sources PREPEND ${web}/)
set(pages ${PROJECT_BINARY_DIR}/report)
set(page_files ${pages}/page.html ${pages}/comparison.html ${pages}/runs.html)
add_custom_command(OUTPUT ${page_files}
  COMMAND ${CMAKE_COMMAND} -DWEB=${web} -DWORK=${PROJECT_BINARY_DIR}/report_web -DPAGES=${pages}
    -P ${PROJECT_SOURCE_DIR}/tools/cmake/bundle_report.cmake
  DEPENDS ${web_sources} ${PROJECT_SOURCE_DIR}/tools/cmake/bundle_report.cmake
  COMMENT "Bundling the pages of reports and comparisons" VERBATIM)
# Builds with sanitizers test nothing with it.
if(PLIMSOLL_SANITIZE)
  add_custom_target(report_page DEPENDS ${page_files})
else()
  add_custom_target(report_page ALL DEPENDS ${page_files})
endif()
