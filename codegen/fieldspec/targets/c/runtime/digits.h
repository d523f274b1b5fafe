/* ---- digits ---- */

/** Whether all bytes are digits; `letter` is that for 10, 0 if digits are decimal, and `places` of them follow a point. */
static inline bool device_is_digits(const uint8_t *in, size_t size, size_t places, uint8_t letter)
{
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        uint32_t character = in[offset];
        if (places != 0u && offset + places + 1u == size) {
            if (character != 0x2Eu) {
                return false;
            }
        } else if ((character < 0x30u || character > 0x39u) &&
                   (letter == 0u || character < letter || character > letter + 5u)) {
            return false;
        }
    }
    return true;
}

/** The number of digits, of which one may be a point. */
static inline uint64_t device_load_digits(const uint8_t *in, size_t size, uint32_t base)
{
    uint64_t value = 0;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        uint32_t low = in[offset] & 0x0Fu;
        if (in[offset] != 0x2Eu) {
            value = value * base + ((in[offset] & 0x40u) != 0u ? low + 9u : low);
        }
    }
    return value;
}

/** Writes the digits of a number with leading zeros. */
static inline void device_store_digits(uint8_t *out, size_t size, size_t places, uint8_t letter, uint64_t value)
{
    uint32_t base = letter == 0u ? 10u : 16u;
    size_t offset;
    for (offset = size; offset > 0u; offset--) {
        uint32_t digit = (uint32_t)(value % base);
        if (places != 0u && offset + places == size) {
            out[offset - 1u] = 0x2Eu;
        } else {
            out[offset - 1u] = (uint8_t)(digit < 10u ? 0x30u + digit : letter + digit - 10u);
            value /= base;
        }
    }
}

/* ---- signed_digits ---- */

/** Whether the bytes are a sign and decimal digits, of which `places` follow a point. */
static inline bool device_is_signed_digits(const uint8_t *in, size_t size, size_t places)
{
    return (in[0] == 0x2Bu || in[0] == 0x2Du) && device_is_digits(in + 1, size - 1u, places, 0u);
}

/** The number of a sign and decimal digits, of which one may be a point. */
static inline int64_t device_load_signed_digits(const uint8_t *in, size_t size)
{
    uint64_t value = device_load_digits(in + 1, size - 1u, 10u) & UINT64_C(0x7FFFFFFFFFFFFFFF);
    return in[0] == 0x2Du ? -(int64_t)value : (int64_t)value;
}

/** Writes the sign and the decimal digits of a number. */
static inline void device_store_signed_digits(uint8_t *out, size_t size, size_t places, int64_t value)
{
    uint64_t digits = value < 0 ? (uint64_t)-value : (uint64_t)value;
    out[0] = value < 0 ? 0x2Du : 0x2Bu;
    device_store_digits(out + 1, size - 1u, places, 0u, digits);
}

/* ---- blank_digits ---- */

/** Where the digits after blanks and a sign begin. */
static inline size_t device_behind_blanks(const uint8_t *in, size_t size)
{
    size_t offset = 0;
    while (offset < size && in[offset] == 0x20u) {
        offset++;
    }
    return offset < size && in[offset] == 0x2Du ? offset + 1u : offset;
}

/** Whether the bytes are decimal digits, of which `places` follow a point, with blanks in place of leading zeros. */
static inline bool device_is_blank_digits(const uint8_t *in, size_t size, size_t places, bool is_signed)
{
    size_t offset = device_behind_blanks(in, size);
    size_t minimum = places == 0u ? 1u : places + 2u;
    if (size - offset < minimum || (in[offset] == 0x30u && size - offset > minimum)
            || (offset > 0u && in[offset - 1u] == 0x2Du && !is_signed)) {
        return false;
    }
    return device_is_digits(in + offset, size - offset, places, 0u);
}

/** The number of such digits; one below zero has the bits of its two's complement. */
static inline uint64_t device_load_blank_digits(const uint8_t *in, size_t size)
{
    size_t offset = device_behind_blanks(in, size);
    uint64_t value = device_load_digits(in + offset, size - offset, 10u);
    return offset > 0u && in[offset - 1u] == 0x2Du ? UINT64_C(0) - value : value;
}

/** Writes the digits of a number with blanks in place of leading zeros. */
static inline void device_store_blank_digits(uint8_t *out, size_t size, size_t places, uint64_t value)
{
    size_t minimum = places == 0u ? 1u : places + 2u;
    size_t offset;
    device_store_digits(out, size, places, 0u, value);
    for (offset = 0; offset + minimum < size && out[offset] == 0x30u; offset++) {
        out[offset] = 0x20u;
    }
}

/* ---- signed_blank_digits ---- */

/** Writes a number with blanks in place of leading zeros; `-` takes the place of one below zero. */
static inline void device_store_signed_blank_digits(uint8_t *out, size_t size, size_t places, int64_t value)
{
    size_t offset = 0;
    device_store_blank_digits(out, size, places, value < 0 ? (uint64_t)-value : (uint64_t)value);
    while (offset < size && out[offset] == 0x20u) {
        offset++;
    }
    if (value < 0 && offset > 0u) {
        out[offset - 1u] = 0x2Du;
    }
}

/* ---- low_first_digits ---- */

/** The number of hexadecimal digits, of which those of the lowest byte come first. */
static inline uint64_t device_load_low_first_digits(const uint8_t *in, size_t size)
{
    uint64_t value = 0;
    size_t offset;
    for (offset = size; offset > 0u; offset -= 2u) {
        value = (value << 8) | device_load_digits(in + (offset - 2u), 2u, 16u);
    }
    return value;
}

/** Writes the hexadecimal digits of a number, those of its lowest byte first. */
static inline void device_store_low_first_digits(uint8_t *out, size_t size, uint8_t letter, uint64_t value)
{
    size_t offset;
    for (offset = 0; offset < size; offset += 2u) {
        device_store_digits(out + offset, 2u, 0u, letter, value & 0xFFu);
        value >>= 8;
    }
}

/* ---- bcd ---- */

/** Whether four bits each are a decimal digit. */
static inline bool device_is_bcd(uint64_t raw)
{
    for (; raw != 0u; raw >>= 4) {
        if ((raw & 15u) > 9u) {
            return false;
        }
    }
    return true;
}

/** The number whose decimal digits have four bits each. */
static inline uint64_t device_of_bcd(uint64_t raw)
{
    uint64_t value = 0;
    uint32_t shift;
    for (shift = 64u; shift > 0u; shift -= 4u) {
        value = value * 10u + ((raw >> (shift - 4u)) & 15u);
    }
    return value;
}

/** The decimal digits of a number with four bits each. */
static inline uint64_t device_to_bcd(uint64_t value)
{
    uint64_t raw = 0;
    uint32_t shift;
    for (shift = 0; shift < 64u; shift += 4u) {
        raw |= (value % 10u) << shift;
        value /= 10u;
    }
    return raw;
}

/* ---- signed_bcd ---- */

/** Whether four bits each are a decimal digit, the highest ones at `place` perhaps a sign. */
static inline bool device_is_signed_bcd(uint64_t raw, uint32_t place)
{
    return device_is_bcd((raw >> place) == 15u ? raw & ~(UINT64_C(15) << place) : raw);
}

/** The number whose decimal digits have four bits each, below zero with ones in place of the highest digit. */
static inline int64_t device_of_signed_bcd(uint64_t raw, uint32_t place)
{
    if ((raw >> place) == 15u) {
        return -(int64_t)device_of_bcd(raw & ~(UINT64_C(15) << place));
    }
    return (int64_t)device_of_bcd(raw);
}

/** The decimal digits of a number with four bits each, below zero with ones in place of the highest digit. */
static inline uint64_t device_to_signed_bcd(int64_t value, uint32_t place)
{
    return value < 0 ? device_to_bcd((uint64_t)-value) | (UINT64_C(15) << place) : device_to_bcd((uint64_t)value);
}

/* ---- unsigned_packed ---- */

/** Whether four bits each are a decimal digit, and the lowest ones that there is no sign. */
static inline bool device_is_unsigned_packed(uint64_t raw)
{
    return (raw & 15u) == 15u && device_is_bcd(raw >> 4);
}

/** The number whose decimal digits have four bits each, before four bits for no sign. */
static inline uint64_t device_of_unsigned_packed(uint64_t raw)
{
    return device_of_bcd(raw >> 4);
}

/** The decimal digits of a number with four bits each, before four bits for no sign. */
static inline uint64_t device_to_unsigned_packed(uint64_t value)
{
    return (device_to_bcd(value) << 4) | 15u;
}

/* ---- signed_packed ---- */

/** Whether four bits each are a decimal digit, and the lowest ones a sign. */
static inline bool device_is_signed_packed(uint64_t raw)
{
    return ((raw & 15u) == 12u || (raw & 15u) == 13u) && device_is_bcd(raw >> 4);
}

/** The number whose decimal digits have four bits each, before those of its sign. */
static inline int64_t device_of_signed_packed(uint64_t raw)
{
    int64_t value = (int64_t)device_of_bcd(raw >> 4);
    return (raw & 15u) == 13u ? -value : value;
}

/** The decimal digits of a number with four bits each, before those of its sign. */
static inline uint64_t device_to_signed_packed(int64_t value)
{
    return value < 0 ? (device_to_bcd((uint64_t)-value) << 4) | 13u : (device_to_bcd((uint64_t)value) << 4) | 12u;
}
