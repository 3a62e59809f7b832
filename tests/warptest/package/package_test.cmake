cmake_minimum_required(VERSION 3.25)

# step(<what> <command>...): runs it, or ends with its output.
function(step what)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "${what} failed:\n${out}")
    endif()
    message(STATUS "${what}: done")
endfunction()

set(prefix ${WORK}/prefix)
set(build ${WORK}/example)
file(REMOVE_RECURSE ${prefix} ${build})
step("install" ${CMAKE_COMMAND} --install ${BUILT} --component warptest --prefix ${prefix})
step("configure" ${CMAKE_COMMAND} -S ${EXAMPLE} -B ${build} -G Ninja -DCMAKE_BUILD_TYPE=Release
     -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${prefix})
step("build" ${CMAKE_COMMAND} --build ${build})
step("test" ${CMAKE_CTEST_COMMAND} --test-dir ${build} --output-on-failure)
