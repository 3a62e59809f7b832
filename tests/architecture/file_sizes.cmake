cmake_minimum_required(VERSION 3.25)

# Fails when a hand-written source file has outgrown 400 lines: it holds more than one concept.
set(LIMIT 400)
file(GLOB_RECURSE files ${ROOT}/renderer/*.h ${ROOT}/renderer/*.cpp ${ROOT}/warptest/*.h
     ${ROOT}/warptest/*.cpp ${ROOT}/grading/*.h ${ROOT}/grading/*.cpp ${ROOT}/tests/*.h
     ${ROOT}/tests/*.cpp)
if(NOT files)
    message(SEND_ERROR "no files found below ${ROOT}")
endif()
foreach(file IN LISTS files)
    file(READ ${file} text)
    string(REGEX MATCHALL "\n" newlines "${text}")
    list(LENGTH newlines lines)
    if(lines GREATER LIMIT)
        file(RELATIVE_PATH relative ${ROOT} ${file})
        message(SEND_ERROR "${relative}: ${lines} lines, the limit is ${LIMIT}")
    endif()
endforeach()
