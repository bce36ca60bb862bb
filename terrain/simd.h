// Where the processor has AVX2 a function marked so uses it. Every lane has a sum of its own and
// there is no fused multiply-add, so the bits do not depend on the width.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define SOFTSOIL_SIMD __attribute__((target_clones("avx2", "default")))
#else
#define SOFTSOIL_SIMD
#endif

namespace softsoil {

// Floats side by side, anywhere in memory. Eight only within functions that are marked so.
typedef float Four __attribute__((vector_size(16), aligned(4), may_alias));
typedef float Eight __attribute__((vector_size(32), aligned(4), may_alias));

inline const Four& FourAt(const float* first) { return *reinterpret_cast<const Four*>(first); }
inline const Eight& EightAt(const float* first) { return *reinterpret_cast<const Eight*>(first); }
inline Eight& EightAt(float* first) { return *reinterpret_cast<Eight*>(first); }

}  // namespace softsoil
