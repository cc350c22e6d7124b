// Where two rows of small numbers differ: what a search for a silhouette does most.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace shadowlab::shadow {

/// How many places `differing` compares, and so how many it reads of each row.
inline constexpr std::size_t differing_span = 64;

/// Bit k is set where a[k] and b[k] differ and chosen[k] is -1; it is 0 elsewhere.
inline std::uint64_t differing(const std::int8_t* a, const std::int8_t* b,
                               const std::int8_t* chosen) {
  std::uint64_t set = 0;
#if defined(__SSE2__)
  const auto sixteen_at = [](const std::int8_t* p) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
  };
  for (std::size_t k = 0; k < differing_span; k += 16) {
    const __m128i equal = _mm_cmpeq_epi8(sixteen_at(a + k), sixteen_at(b + k));
    const __m128i wanted = _mm_andnot_si128(equal, sixteen_at(chosen + k));
    const auto signs = static_cast<std::uint32_t>(_mm_movemask_epi8(wanted));
    set |= static_cast<std::uint64_t>(signs) << k;
  }
#else
  for (std::size_t k = 0; k < differing_span; ++k) {
    set |= static_cast<std::uint64_t>(a[k] != b[k] && chosen[k] != 0) << k;
  }
#endif
  return set;
}

}  // namespace shadowlab::shadow
