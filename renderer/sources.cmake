# Every translation unit of the renderer, in one place, because several builds read this list: the
# renderer itself, its tests, and the grader's build of a submission.

# Core: no NORI_REGISTER_CLASS, linked as a static library.
set(NORI_CORE_SOURCES)

# Plugins: each registers itself under the `type` its file is named after.
set(NORI_PLUGIN_SOURCES)
