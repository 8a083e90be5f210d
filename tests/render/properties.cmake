# Read by ctest once the tests of this folder are known. Graphics drivers keep what they allocated until
# the process ends, which the leak checker of AddressSanitizer would report.
foreach(test IN LISTS render_tests_TESTS)
  set_tests_properties(${test} PROPERTIES LABELS "unit;render"
    ENVIRONMENT_MODIFICATION "ASAN_OPTIONS=set:detect_leaks=0")
endforeach()
