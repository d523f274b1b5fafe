#ifdef __GNUC__
/** A call of these functions would take more than what they do, even where size counts. */
#define DEVICE_INLINE static inline __attribute__((always_inline))
#define DEVICE_LIKELY(test) __builtin_expect(!!(test), 1)
/** An enum has 16 bits, even where the compiler makes enums as short as they can be: a cast of 256 does not become 0. */
#define DEVICE_ENUM_16 __attribute__((__mode__(__HI__)))
/** Built in: without string.h, and without a call for a few bytes, where the compiler is a freestanding one. */
#define DEVICE_COPY(to, from, size) __builtin_memcpy((to), (from), (size))
#define DEVICE_CLEAR(to, size) __builtin_memset((to), 0, (size))
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ && \
    (defined(__x86_64__) || defined(__i386__) || defined(__aarch64__) || defined(__ARM_FEATURE_UNALIGNED))
/**
 * Numbers are stored at once. The compiler turns loads byte by byte into one by itself, and stores too, but
 * not where it knows that it may change their order: then it makes vectors, which take up to four times as
 * long.
 */
#define DEVICE_STORES_AT_ONCE
#endif
#else
#include <string.h>
#define DEVICE_INLINE static inline
#define DEVICE_LIKELY(test) (test)
#define DEVICE_ENUM_16
#define DEVICE_COPY(to, from, size) memcpy((to), (from), (size))
#define DEVICE_CLEAR(to, size) memset((to), 0, (size))
#endif
