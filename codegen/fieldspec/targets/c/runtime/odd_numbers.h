/* ---- u24_be ---- */

DEVICE_INLINE uint32_t device_load_u24_be(const uint8_t *in)
{
    return ((uint32_t)in[0] << 16) | ((uint32_t)in[1] << 8) |
           (uint32_t)in[2];
}

DEVICE_INLINE void device_store_u24_be(uint8_t *out, uint32_t value)
{
    out[0] = (uint8_t)(value >> 16);
    out[1] = (uint8_t)(value >> 8);
    out[2] = (uint8_t)value;
}

/* ---- u24_le ---- */

DEVICE_INLINE uint32_t device_load_u24_le(const uint8_t *in)
{
    return (uint32_t)in[0] | ((uint32_t)in[1] << 8) |
           ((uint32_t)in[2] << 16);
}

DEVICE_INLINE void device_store_u24_le(uint8_t *out, uint32_t value)
{
    out[0] = (uint8_t)value;
    out[1] = (uint8_t)(value >> 8);
    out[2] = (uint8_t)(value >> 16);
}

/* ---- u40_be ---- */

DEVICE_INLINE uint64_t device_load_u40_be(const uint8_t *in)
{
    return ((uint64_t)in[0] << 32) | ((uint64_t)in[1] << 24) |
           ((uint64_t)in[2] << 16) | ((uint64_t)in[3] << 8) |
           (uint64_t)in[4];
}

DEVICE_INLINE void device_store_u40_be(uint8_t *out, uint64_t value)
{
    out[0] = (uint8_t)(value >> 32);
    out[1] = (uint8_t)(value >> 24);
    out[2] = (uint8_t)(value >> 16);
    out[3] = (uint8_t)(value >> 8);
    out[4] = (uint8_t)value;
}

/* ---- u40_le ---- */

DEVICE_INLINE uint64_t device_load_u40_le(const uint8_t *in)
{
    return (uint64_t)in[0] | ((uint64_t)in[1] << 8) |
           ((uint64_t)in[2] << 16) | ((uint64_t)in[3] << 24) |
           ((uint64_t)in[4] << 32);
}

DEVICE_INLINE void device_store_u40_le(uint8_t *out, uint64_t value)
{
    out[0] = (uint8_t)value;
    out[1] = (uint8_t)(value >> 8);
    out[2] = (uint8_t)(value >> 16);
    out[3] = (uint8_t)(value >> 24);
    out[4] = (uint8_t)(value >> 32);
}

/* ---- u48_be ---- */

DEVICE_INLINE uint64_t device_load_u48_be(const uint8_t *in)
{
    return ((uint64_t)in[0] << 40) | ((uint64_t)in[1] << 32) |
           ((uint64_t)in[2] << 24) | ((uint64_t)in[3] << 16) |
           ((uint64_t)in[4] << 8) | (uint64_t)in[5];
}

DEVICE_INLINE void device_store_u48_be(uint8_t *out, uint64_t value)
{
    out[0] = (uint8_t)(value >> 40);
    out[1] = (uint8_t)(value >> 32);
    out[2] = (uint8_t)(value >> 24);
    out[3] = (uint8_t)(value >> 16);
    out[4] = (uint8_t)(value >> 8);
    out[5] = (uint8_t)value;
}

/* ---- u48_be_words_le ---- */

DEVICE_INLINE uint64_t device_load_u48_be_words_le(const uint8_t *in)
{
    return ((uint64_t)in[0] << 8) | (uint64_t)in[1] |
           ((uint64_t)in[2] << 24) | ((uint64_t)in[3] << 16) |
           ((uint64_t)in[4] << 40) | ((uint64_t)in[5] << 32);
}

DEVICE_INLINE void device_store_u48_be_words_le(uint8_t *out, uint64_t value)
{
    out[0] = (uint8_t)(value >> 8);
    out[1] = (uint8_t)value;
    out[2] = (uint8_t)(value >> 24);
    out[3] = (uint8_t)(value >> 16);
    out[4] = (uint8_t)(value >> 40);
    out[5] = (uint8_t)(value >> 32);
}

/* ---- u48_le ---- */

DEVICE_INLINE uint64_t device_load_u48_le(const uint8_t *in)
{
    return (uint64_t)in[0] | ((uint64_t)in[1] << 8) |
           ((uint64_t)in[2] << 16) | ((uint64_t)in[3] << 24) |
           ((uint64_t)in[4] << 32) | ((uint64_t)in[5] << 40);
}

DEVICE_INLINE void device_store_u48_le(uint8_t *out, uint64_t value)
{
    out[0] = (uint8_t)value;
    out[1] = (uint8_t)(value >> 8);
    out[2] = (uint8_t)(value >> 16);
    out[3] = (uint8_t)(value >> 24);
    out[4] = (uint8_t)(value >> 32);
    out[5] = (uint8_t)(value >> 40);
}

/* ---- u48_le_words_be ---- */

DEVICE_INLINE uint64_t device_load_u48_le_words_be(const uint8_t *in)
{
    return ((uint64_t)in[0] << 32) | ((uint64_t)in[1] << 40) |
           ((uint64_t)in[2] << 16) | ((uint64_t)in[3] << 24) |
           (uint64_t)in[4] | ((uint64_t)in[5] << 8);
}

DEVICE_INLINE void device_store_u48_le_words_be(uint8_t *out, uint64_t value)
{
    out[0] = (uint8_t)(value >> 32);
    out[1] = (uint8_t)(value >> 40);
    out[2] = (uint8_t)(value >> 16);
    out[3] = (uint8_t)(value >> 24);
    out[4] = (uint8_t)value;
    out[5] = (uint8_t)(value >> 8);
}

/* ---- u56_be ---- */

DEVICE_INLINE uint64_t device_load_u56_be(const uint8_t *in)
{
    return ((uint64_t)in[0] << 48) | ((uint64_t)in[1] << 40) |
           ((uint64_t)in[2] << 32) | ((uint64_t)in[3] << 24) |
           ((uint64_t)in[4] << 16) | ((uint64_t)in[5] << 8) |
           (uint64_t)in[6];
}

DEVICE_INLINE void device_store_u56_be(uint8_t *out, uint64_t value)
{
    out[0] = (uint8_t)(value >> 48);
    out[1] = (uint8_t)(value >> 40);
    out[2] = (uint8_t)(value >> 32);
    out[3] = (uint8_t)(value >> 24);
    out[4] = (uint8_t)(value >> 16);
    out[5] = (uint8_t)(value >> 8);
    out[6] = (uint8_t)value;
}

/* ---- u56_le ---- */

DEVICE_INLINE uint64_t device_load_u56_le(const uint8_t *in)
{
    return (uint64_t)in[0] | ((uint64_t)in[1] << 8) |
           ((uint64_t)in[2] << 16) | ((uint64_t)in[3] << 24) |
           ((uint64_t)in[4] << 32) | ((uint64_t)in[5] << 40) |
           ((uint64_t)in[6] << 48);
}

DEVICE_INLINE void device_store_u56_le(uint8_t *out, uint64_t value)
{
    out[0] = (uint8_t)value;
    out[1] = (uint8_t)(value >> 8);
    out[2] = (uint8_t)(value >> 16);
    out[3] = (uint8_t)(value >> 24);
    out[4] = (uint8_t)(value >> 32);
    out[5] = (uint8_t)(value >> 40);
    out[6] = (uint8_t)(value >> 48);
}

/* ---- signed_24 ---- */

DEVICE_INLINE int32_t device_signed_24(uint32_t raw)
{
    return (int32_t)(raw ^ 0x800000u) - 0x800000;
}

/* ---- signed_40 ---- */

DEVICE_INLINE int64_t device_signed_40(uint64_t raw)
{
    return (int64_t)(raw ^ UINT64_C(0x8000000000)) - INT64_C(0x8000000000);
}

/* ---- signed_48 ---- */

DEVICE_INLINE int64_t device_signed_48(uint64_t raw)
{
    return (int64_t)(raw ^ UINT64_C(0x800000000000)) - INT64_C(0x800000000000);
}

/* ---- signed_56 ---- */

DEVICE_INLINE int64_t device_signed_56(uint64_t raw)
{
    return (int64_t)(raw ^ UINT64_C(0x80000000000000)) - INT64_C(0x80000000000000);
}
