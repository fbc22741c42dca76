# Renders a few pixels under oclgrind, whose exit code is 0 whatever it finds: its words decide.
foreach(lanes IN ITEMS 1 8)
  execute_process(
    COMMAND oclgrind --data-races --check-api --build-options -cl-opt-disable
            ${NICOL} render ${SCENE} -o ${FOLDER}/oclgrind_${lanes}.exr --width 8 --height 8 --lanes ${lanes}
            --wavelengths 480:620:20 --no-cache --no-budget
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  message("${output}")
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "exit code ${code} with ${lanes} lanes")
  endif()
  if(NOT output MATCHES "Oclgrind Simulator")
    message(FATAL_ERROR "the picture was not made under oclgrind")
  endif()
  if(output MATCHES "Invalid (read|write)|data race|Uninitialized|Oclgrind: [0-9]+ errors|undefined")
    message(FATAL_ERROR "oclgrind has a finding with ${lanes} lanes")
  endif()
endforeach()
