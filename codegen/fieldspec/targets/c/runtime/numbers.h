/* ---- bits ---- */

/* The bit with an index, from 0; the first one is the least significant bit of the first byte. */
DEVICE_INLINE bool device_load_bit(const uint8_t *in, size_t index)
{
    return (((uint32_t)in[index / 8u] >> (index % 8u)) & 1u) != 0u;
}

/* Changes the bit with an index, from 0, and no other. */
DEVICE_INLINE void device_store_bit(uint8_t *out, size_t index, bool value)
{
    uint32_t mask = (uint32_t)1u << (index % 8u);
    uint32_t byte = out[index / 8u];
    out[index / 8u] = (uint8_t)(value ? byte | mask : byte & ~mask);
}

/* ---- signed ---- */

DEVICE_INLINE int8_t device_signed_8(uint8_t raw)
{
    return (int8_t)((raw & 0x80u) ? -(int32_t)(uint8_t)~raw - 1 : (int32_t)raw);
}

DEVICE_INLINE int16_t device_signed_16(uint16_t raw)
{
    return (int16_t)((raw & 0x8000u) ? -(int32_t)(uint16_t)~raw - 1 : (int32_t)raw);
}

DEVICE_INLINE int32_t device_signed_32(uint32_t raw)
{
    return (int32_t)((raw & 0x80000000u) ? -(int32_t)(uint32_t)~raw - 1 : (int32_t)raw);
}

DEVICE_INLINE int64_t device_signed_64(uint64_t raw)
{
    return (int64_t)((raw & UINT64_C(0x8000000000000000)) ? -(int64_t)(uint64_t)~raw - 1 : (int64_t)raw);
}

/* ---- float ---- */

DEVICE_INLINE float device_float_of(uint32_t bits)
{
    float value;
    DEVICE_COPY(&value, &bits, sizeof value);
    return value;
}

DEVICE_INLINE uint32_t device_bits_of(float value)
{
    uint32_t bits;
    DEVICE_COPY(&bits, &value, sizeof bits);
    return bits;
}

/* ---- double ---- */

DEVICE_INLINE double device_double_of(uint64_t bits)
{
    double value;
    DEVICE_COPY(&value, &bits, sizeof value);
    return value;
}

DEVICE_INLINE uint64_t device_bits_of_double(double value)
{
    uint64_t bits;
    DEVICE_COPY(&bits, &value, sizeof bits);
    return bits;
}

/* ---- text ---- */

static inline bool device_is_ascii(const uint8_t *in, size_t size)
{
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        if (in[offset] > 127u) {
            return false;
        }
    }
    return true;
}

/** Whether a text of at most `size` characters is ASCII. */
static inline bool device_is_text(const char *text, size_t size)
{
    size_t offset;
    for (offset = 0; offset < size && text[offset] != '\0'; offset++) {
        if ((uint8_t)text[offset] > 127u) {
            return false;
        }
    }
    return true;
}

/** Writes a text of at most `size` characters, padded with zeros. */
static inline void device_put_text(uint8_t *out, const char *text, size_t size)
{
    size_t offset;
    DEVICE_CLEAR(out, size);
    for (offset = 0; offset < size && text[offset] != '\0'; offset++) {
        out[offset] = (uint8_t)text[offset];
    }
}

/* ---- hexadecimal ---- */

/** The value of a hexadecimal digit; more than 15 for any other character. */
static inline uint8_t device_digit(uint8_t character)
{
    if (character >= 0x30u && character <= 0x39u) {
        return (uint8_t)(character - 0x30u);
    }
    if (character >= 0x41u && character <= 0x46u) {
        return (uint8_t)(character - 0x37u);
    }
    if (character >= 0x61u && character <= 0x66u) {
        return (uint8_t)(character - 0x57u);
    }
    return 0xFFu;
}

static inline uint8_t device_hex_digit(uint8_t value)
{
    return (uint8_t)(value < 10u ? value + 0x30u : value + 0x37u);
}
