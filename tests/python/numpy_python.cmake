# NICOL_NUMPY_PYTHON: the first python3 that has numpy and matplotlib; the one that comes first of all may have neither.
function(has_numpy result candidate)
  execute_process(COMMAND ${candidate} -c "import numpy, matplotlib" RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()
find_program(NICOL_NUMPY_PYTHON NAMES python3 PATHS /usr/bin VALIDATOR has_numpy REQUIRED
             DOC "python3 with numpy and matplotlib (packages python3-numpy, python3-matplotlib), for tests")
