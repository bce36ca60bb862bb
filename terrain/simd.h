// Where the processor has AVX2 a function marked so uses it. Every lane has a sum of its own and
// there is no fused multiply-add, so the bits do not depend on the width.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define SOFTSOIL_SIMD __attribute__((target_clones("avx2", "default")))
#else
#define SOFTSOIL_SIMD
#endif

namespace softsoil {

// Floats side by side. Eight only within functions that are marked so.
typedef float Four __attribute__((vector_size(16)));
typedef float Eight __attribute__((vector_size(32)));

// The same anywhere in memory.
template <class Floats>
struct __attribute__((packed, may_alias)) Unaligned {
  Floats floats;
};
inline const Unaligned<Four>& FourAt(const float* first) {
  return *reinterpret_cast<const Unaligned<Four>*>(first);
}
inline const Unaligned<Eight>& EightAt(const float* first) {
  return *reinterpret_cast<const Unaligned<Eight>*>(first);
}
inline Unaligned<Eight>& EightAt(float* first) {
  return *reinterpret_cast<Unaligned<Eight>*>(first);
}

}  // namespace softsoil
