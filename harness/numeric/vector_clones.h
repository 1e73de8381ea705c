/* SPDX-License-Identifier: BSD-3-Clause */
/* For functions, in C and C++, that are one loop over many numbers. */
#ifndef ASSAY_VECTOR_CLONES_H
#define ASSAY_VECTOR_CLONES_H

/* A function for each set of instructions; the processor's is taken when the program or library is loaded. They give
   the same bits. Not where a sanitizer works before that, and not of clang, which has it for few kinds of functions. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ASSAY_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ASSAY_VECTOR_CLONES
#endif

#endif
