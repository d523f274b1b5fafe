#ifdef __GNUC__
/** A call would take more code than the function itself, even with -Os. */
#define DEVICE_INLINE static inline __attribute__((always_inline))
#define DEVICE_LIKELY(test) __builtin_expect(!!(test), 1)
/** Built-in functions need no string.h, and no call for a few bytes, also in freestanding code. */
#define DEVICE_COPY(to, from, size) __builtin_memcpy((to), (from), (size))
#define DEVICE_CLEAR(to, size) __builtin_memset((to), 0, (size))
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ && \
    (defined(__x86_64__) || defined(__i386__) || defined(__aarch64__) || defined(__ARM_FEATURE_UNALIGNED))
/**
 * Store a number with one instruction. Compilers merge loads of single bytes by themselves, and mostly stores
 * too. Where they may reorder stores, they build vectors instead, which take up to four times as long.
 */
#define DEVICE_STORES_AT_ONCE
#endif
#else
#include <string.h>
#define DEVICE_INLINE static inline
#define DEVICE_LIKELY(test) (test)
#define DEVICE_COPY(to, from, size) memcpy((to), (from), (size))
#define DEVICE_CLEAR(to, size) memset((to), 0, (size))
#endif
