/** The position of an encoder whose tracks are two bytes. */
static inline bool device_acme_gray_decode(const uint8_t *in, int64_t *number)
{
    uint32_t tracks = ((uint32_t)in[0] << 8) | in[1];
    tracks ^= tracks >> 8;
    tracks ^= tracks >> 4;
    tracks ^= tracks >> 2;
    tracks ^= tracks >> 1;
    *number = (int64_t)tracks;
    return true;
}

/** Writes the tracks of a position. */
static inline void device_acme_gray_encode(int64_t number, uint8_t *out)
{
    uint32_t position = (uint32_t)number;
    position ^= position >> 1;
    out[0] = (uint8_t)(position >> 8);
    out[1] = (uint8_t)(position & 0xFFu);
}
