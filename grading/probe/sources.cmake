# The probe, in one place: CMake builds it with our complete renderer, the grader in the sandbox with
# a submission's files. Paths are below grading/.
set(NORI_PROBE_SOURCES
    probe/emitter_probe.cpp probe/main.cpp probe/mesh_probe.cpp probe/radiance_probe.cpp
    probe/scene_store.cpp probe/threads.cpp probe/warp_probe.cpp
    protocol/encoding.cpp protocol/request.cpp protocol/slots.cpp)
