// RAILBOOK_WIDE before a function: compiled a second time for registers of 256 bits, which a
// processor that has them takes. The operations and their order are the same, and so are the
// digits. For functions whose name is the only one of its namespace in all files: Clang makes a
// symbol of it that others see.
#pragma once

#if defined(__x86_64__) && defined(__linux__)
#define RAILBOOK_AVX2_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define RAILBOOK_AVX2_CLONES
#endif
