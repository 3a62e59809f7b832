// SPDX-License-Identifier: MIT
#include <map>

#include "attack.h"

namespace attack {

namespace {

/// HOST stands for a file of this machine that everybody may read.
const std::map<std::string, std::string> &sources() {
    static const std::map<std::string, std::string> kSources = {
        {"includes_a_host_file", "#include \"HOST\"\n"},
        {"includes_the_password_file", "#include \"/etc/passwd\"\n"},
        {"includes_by_parents", "#include \"../../../../../../../../HOST\"\n"},
        {"includes_its_environment", "#include \"/proc/self/environ\"\n"},
        {"includes_its_input", "#include \"/dev/stdin\"\nint x;\n"},
        {"includes_endless_zeros", "#include \"/dev/zero\"\n"},
        {"includes_endless_noise", "#include \"/dev/urandom\"\n"},
        {"probes_for_host_files",
         "#if __has_include(\"HOST\") || __has_include(\"/etc/passwd\") || "
         "__has_include(\"/root/.bashrc\") || __has_include(\"/proc/self/maps\")\n"
         "#error seen\n#endif\nint x;\n"},
        {"embeds_a_host_file", "__asm__(\".incbin \\\"HOST\\\"\");\n"},
        {"assembles_a_host_file", "__asm__(\".include \\\"HOST\\\"\");\n"},
        {"loads_a_precompiled_header", "#pragma GCC pch_preprocess \"HOST\"\nint x;\n"},
        {"loads_a_plugin", "#pragma GCC optimize(\"-fplugin=HOST\")\nint f() { return 1; }\n"},
        {"shows_lines_of_a_host_file", "#line 1 \"HOST\"\nint x = \"\";\n"},
        {"includes_itself", "#include \"warp.cpp\"\n#include \"warp.cpp\"\n"},
        {"expands_macros",
         "#define A(...) __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, "
         "__VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__\n"
         "#define B(...) A(A(A(__VA_ARGS__)))\n#define C(...) B(B(B(B(__VA_ARGS__))))\n"
         "int a[] = {C(1)};\n"},
        {"instantiates_templates",
         "template <unsigned N, unsigned M> struct T { static const unsigned v = T<N - 1, M>::v + "
         "T<N - 1, M + (1u << N)>::v; };\n"
         "template <unsigned M> struct T<0, M> { static const unsigned v = M; };\n"
         "unsigned x = T<30, 0>::v;\n"},
        {"recurses_in_templates",
         "template <class T> struct S { typename S<S<T>>::type x; };\nS<int>::type x;\n"},
        {"computes_constants",
         "constexpr int f() { int x = 0; for (;;) x ^= 1; return x; }\nconstexpr int y = f();\n"},
        {"fills_an_array", "char a[6000000000] = {1};\n"},
        {"repeats_in_assembly",
         "__asm__(\".rept 100000000\\n .quad 1,2,3,4,5,6,7,8\\n .endr\");\n"},
        {"moves_in_assembly", "__asm__(\".data\\n .org 0x7ffffffffff\\n .byte 1\");\n"},
        {"prints_without_end",
         "#define W(n) static_assert(n < 0, \"PASSED\");\n#include \"warp.cpp\"\nW(1)\n"},
        {"prints_control_text",
         "#error \"\x1b[2J\x1b[32mPASSED\x1b[0m <script>alert(1)</script> \xff\xfe\"\n"},
        {"forges_diagnostics",
         "#line 1 \"/etc/passwd\"\n#error \" 'x' was not declared in this scope\"\n"},
        {"nests_without_end", "int x = " + std::string(300'000, '(') + "1;\n"},
        // What follows is added to a warp.cpp.
        {"names_its_machine", "extern const char *where;\n"
                              "const char *where = \"lies in \" __FILE__ \" of \" __BASE_FILE__ "
                              "\" of \" __TIMESTAMP__;\n"},
        {"leaves_in_a_constructor",
         "#include <cstdio>\n#include <unistd.h>\n"
         "namespace { struct A { A() { std::puts(\"{\\\"score\\\": 100}\"); std::fflush(stdout); "
         "::_exit(0); } } a; }\n"},
        {"throws_in_a_constructor", "namespace { struct A { A() { throw 1; } } a; }\n"},
        {"leaves_in_a_resolver",
         "extern \"C\" void *attackResolver() {\n"
         "    __asm__ volatile(\"syscall\" : : \"a\"(231), \"D\"(0));\n    return nullptr;\n}\n"
         "extern \"C\" int attackResolved() __attribute__((ifunc(\"attackResolver\")));\n"
         "int attackUse = attackResolved();\n"},
        {"leaves_in_a_destructor",
         "#include <cstdio>\n#include <unistd.h>\n"
         "namespace { struct A { ~A() { std::puts(\"[  PASSED  ] 100 tests.\"); "
         "std::fflush(stdout); ::_exit(0); } } a; }\n"},
        {"answers_before_main",
         "#include <sys/mman.h>\n#include <sys/stat.h>\n#include <unistd.h>\n"
         "namespace { struct A { A() { struct stat s{}; ::fstat(4, &s);\n"
         "auto *m = static_cast<unsigned *>(::mmap(nullptr, s.st_size, PROT_READ | PROT_WRITE, "
         "MAP_SHARED, 4, 0));\n"
         "for (unsigned v = 0; v < 8; ++v) for (long i = 0; i < s.st_size / 4; ++i) m[i] = v % 5;\n"
         "::_exit(0); } } a; }\n"},
        {"replaces_operator_new",
         "#include <cstddef>\nnamespace { alignas(64) char g_block[1 << 20]; }\n"
         "void *operator new(std::size_t) { return g_block; }\n"
         "void operator delete(void *) noexcept {}\n"
         "void operator delete(void *, std::size_t) noexcept {}\n"},
        {"replaces_the_root", "extern \"C\" float sqrtf(float) { return 0.5f; }\n"
                              "extern \"C\" double sqrt(double) { return 0.5; }\n"
                              "extern \"C\" float cosf(float) { return 1.0f; }\n"},
        {"defines_what_the_base_has",
         "#include <nori/common.h>\nNORI_NAMESPACE_BEGIN\n"
         "std::string indent(const std::string &, int) { return \"PASSED\"; }\n"
         "NORI_NAMESPACE_END\n"},
    };
    return kSources;
}

} // namespace

std::string attackSource(const std::string &name, const std::string &host) {
    std::string text = sources().at(name);
    const std::string mark = "HOST";
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += host.size())
        text.replace(at, mark.size(), host);
    return text;
}

} // namespace attack
