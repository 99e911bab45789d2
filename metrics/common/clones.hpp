#pragma once
// ALCOVE_CLONES before a function compiles it once for each vector width and picks one when the
// program starts. Contraction and reassociation are off in every build, so that all give the same
// bits.

// Sanitizers run before the pick can be made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ALCOVE_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define ALCOVE_CLONES
#endif
