cmake_minimum_required(VERSION 3.25)

# Fails when a file includes across a boundary it may not cross. One row per folder: the project
# headers (first path component of <...>) that files below it may include.
set(ALLOWED
    "renderer/include:nori"
    "renderer/src:nori"
    "renderer/app:preview,nori,window"
    "renderer/window:window"
    "warptest/statistics:statistics"
    "warptest/catalog:catalog"
    "warptest/battery:battery,catalog,statistics"
    "warptest/bindings:bindings,battery,catalog,nori"
    "warptest/app:viewer,window,bindings,battery,catalog,statistics,grader"
    "grading/protocol:protocol"
    "grading/probe:probe,protocol,nori"
    "grading/plot:plot"
    "grading/decoder:decoder,protocol"
    "grading/grader:grader,plot,protocol,battery,catalog,statistics,window")
set(OURS "battery|bindings|catalog|decoder|grader|nori|plot|preview|probe|protocol|statistics|viewer|window")

foreach(row IN LISTS ALLOWED)
    string(REGEX MATCH "^([^:]+):(.+)$" _ ${row})
    set(folder ${CMAKE_MATCH_1})
    string(REPLACE "," ";" permitted ${CMAKE_MATCH_2})
    file(GLOB_RECURSE files ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
    if(NOT files)
        message(SEND_ERROR "${folder}: no files: the rule for it checks nothing")
    endif()
    foreach(file IN LISTS files)
        file(STRINGS ${file} includes REGEX "^#include <(${OURS})/")
        foreach(line IN LISTS includes)
            string(REGEX MATCH "<([a-z]+)/" _ ${line})
            if(NOT CMAKE_MATCH_1 IN_LIST permitted)
                file(RELATIVE_PATH relative ${ROOT} ${file})
                message(SEND_ERROR
                    "${relative}: ${line}, but ${folder} may include only: ${permitted}")
            endif()
        endforeach()
    endforeach()
endforeach()
