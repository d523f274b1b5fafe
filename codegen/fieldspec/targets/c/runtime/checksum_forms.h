/* ---- reflected ---- */

/** ABOUT */
static inline RESULT device_ALGORITHM(const uint8_t *in, size_t size)
{
    static const REGISTER table[16] = {
TABLE
    };
    REGISTER crc = START;
    INDEX
    for (offset = 0; offset < SIZE; offset++) {
        crc = (REGISTER)(crc ^ BYTE);
        crc = (REGISTER)(crc >> 4 ^ table[crc & 15u]);
        crc = (REGISTER)(crc >> 4 ^ table[crc & 15u]);
    }
    FINISH
}

/* ---- forward ---- */

/** ABOUT */
static inline RESULT device_ALGORITHM(const uint8_t *in, size_t size)
{
    static const REGISTER table[16] = {
TABLE
    };
    REGISTER crc = START;
    INDEX
    for (offset = 0; offset < SIZE; offset++) {
        crc = (REGISTER)(crc ^ (REGISTER)((REGISTER)BYTE << BYTE_SHIFT));
        crc = (REGISTER)((REGISTER)(crc << 4) ^ table[crc >> DIGIT_SHIFT]);
        crc = (REGISTER)((REGISTER)(crc << 4) ^ table[crc >> DIGIT_SHIFT]);
    }
    FINISH
}

/* ---- total ---- */

/** ABOUT */
static inline RESULT device_ALGORITHM(const uint8_t *in, size_t size)
{
    REGISTER number = START;
    INDEX
    for (offset = 0; offset < SIZE; offset++) {
        number = (REGISTER)(number OPERATOR TERM);
    }
    FINISH
}

/* ---- fletcher ---- */

/** ABOUT */
static inline RESULT device_ALGORITHM(const uint8_t *in, size_t size)
{
    REGISTER lower = LOWER_START;
    REGISTER upper = UPPER_START;
    INDEX
    for (offset = 0; offset < SIZE; offset++) {
        lower = (lower + TERM) MODULO;
        STEP
    }
    FINISH
}

/* ---- avoiding ---- */

/** The same with other bytes in place of those that must not occur. */
static inline RESULT device_ALGORITHM(const uint8_t *in, size_t size)
{
    static const uint8_t avoided[COUNT] = AVOIDED;
    static const uint8_t replacements[COUNT] = REPLACEMENTS;
    RESULT number = device_COMPUTED(in, size);
    RESULT result = 0;
    unsigned shift;
    size_t offset;
    for (shift = 0; shift < BITS; shift += 8u) {
        uint8_t byte = (uint8_t)(number >> shift);
        for (offset = 0; offset < COUNT && avoided[offset] != byte; offset++) {
        }
        if (offset < COUNT) {
            byte = replacements[offset];
        }
        result = (RESULT)(result | (RESULT)((RESULT)byte << shift));
    }
    return result;
}

/* ---- swapped ---- */

/** The place of a byte where the bytes of each number of so many bytes are in the opposite order. */
static inline size_t device_swapped(size_t offset, size_t unit)
{
    return offset / unit * unit + unit - 1u - offset % unit;
}

/* ---- reverse ---- */

/** The lowest bits of a number in the opposite order. */
static inline uint64_t device_reversed(uint64_t number, unsigned width)
{
    uint64_t result = 0;
    unsigned bit;
    for (bit = 0; bit < width; bit++) {
        result = result << 1 | (number >> bit & 1u);
    }
    return result;
}

/* ---- characters ---- */

/** One byte of a checksum that is sent as bytes (base 256) or as digits of a base; `letter` is the digit of ten. */
static inline uint8_t device_checksum_byte(unsigned digit, unsigned base, uint8_t letter)
{
    if (base == 256u) {
        return (uint8_t)digit;
    }
    return (uint8_t)(digit < 10u ? 0x30u + digit : letter + digit - 10u);
}

/** Writes a checksum of so many bytes or digits; those of a little one begin with the lowest. */
static inline void device_store_checksum(
    uint8_t *out, size_t size, uint64_t number, unsigned base, uint8_t letter, bool little)
{
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        out[little ? offset : size - 1u - offset] = device_checksum_byte((unsigned)(number % base), base, letter);
        number /= base;
    }
}

/** Whether the bytes are those of a checksum. */
static inline bool device_is_checksum(
    const uint8_t *in, size_t size, uint64_t number, unsigned base, uint8_t letter, bool little)
{
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        if (in[little ? offset : size - 1u - offset] != device_checksum_byte((unsigned)(number % base), base, letter)) {
            return false;
        }
        number /= base;
    }
    return true;
}
