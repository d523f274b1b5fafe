/** The number of a sign, a power of ten and 16 bits; false where the first byte has other bits. */
static inline bool device_acme_float_decode(const uint8_t *in, int64_t *number)
{
    uint8_t power = (uint8_t)(in[0] & 0x7Fu);
    int64_t value = (int64_t)in[1] * 256 + in[2];
    if (power > 4u) {
        return false;
    }
    for (; power > 0u; power--) {
        value *= 10;
    }
    *number = (in[0] & 0x80u) != 0u ? -value : value;
    return true;
}

/** Writes the bytes of the nearest number. */
static inline void device_acme_float_encode(int64_t number, uint8_t *out)
{
    uint64_t magnitude = number < 0 ? (uint64_t)-number : (uint64_t)number;
    uint64_t rest = magnitude;
    uint64_t unit = 1;
    uint32_t power = 0;
    while (rest > 0xFFFFu) {
        power++;
        unit *= 10u;
        rest = (magnitude + unit / 2u) / unit;
    }
    out[0] = (uint8_t)((number < 0 ? 0x80u : 0u) | power);
    out[1] = (uint8_t)(rest >> 8);
    out[2] = (uint8_t)(rest & 0xFFu);
}
