// Copies of a function for AVX-512, for AVX2 and for every x86-64, chosen when the program starts.
// The code must be such that both give the same bits: no contraction, no reassociation.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define DRYDOCK_VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define DRYDOCK_VECTOR_CLONES
#endif

/// Before a loop whose arrays do not overlap, which a compiler cannot see.
#if defined(__GNUC__) && !defined(__clang__)
#define DRYDOCK_NO_OVERLAP _Pragma("GCC ivdep")
#else
#define DRYDOCK_NO_OVERLAP
#endif
