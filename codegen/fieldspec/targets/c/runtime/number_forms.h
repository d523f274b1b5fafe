/* ---- half ---- */

/** The number that the 16 bits of half precision stand for. */
static inline float device_float_of_half(uint16_t bits)
{
    uint32_t sign = ((uint32_t)bits & 0x8000u) << 16;
    uint32_t exponent = ((uint32_t)bits >> 10) & 0x1Fu;
    uint32_t fraction = (uint32_t)bits & 0x3FFu;
    if (exponent == 31u) {
        exponent = 255u;
    } else if (exponent != 0u) {
        exponent += 112u;
    } else if (fraction != 0u) {
        exponent = 113u;
        while (!(fraction & 0x400u)) {
            fraction <<= 1;
            exponent--;
        }
        fraction &= 0x3FFu;
    }
    return device_float_of(sign | (exponent << 23) | (fraction << 13));
}

/** Whether a finite number becomes infinite in half precision. */
static inline bool device_exceeds_half(float value)
{
    uint32_t bits = device_bits_of(value) & 0x7FFFFFFFu;
    return bits >= 0x477FF000u && bits < 0x7F800000u;
}

/** The 16 bits of a number, rounded to the nearest one, of two equally near ones to the even one. */
static inline uint16_t device_half_of(float value)
{
    uint32_t bits = device_bits_of(value);
    uint32_t sign = (bits >> 16) & 0x8000u;
    uint32_t number = bits & 0x7FFFFFFFu;
    uint32_t shift = 13u;
    uint32_t half;
    uint32_t rest;
    if (number > 0x7F800000u) {
        half = 0x7C00u | ((number >> 13) & 0x3FFu);
        return (uint16_t)(sign | (half == 0x7C00u ? 0x7E00u : half));
    }
    if (number >= 0x477FF000u) {
        return (uint16_t)(sign | 0x7C00u);
    }
    if (number < 0x33000000u) {
        return (uint16_t)sign;
    }
    if (number < 0x38800000u) {
        shift = 126u - (number >> 23);
        number = (number & 0x7FFFFFu) | 0x800000u;
    } else {
        number -= 0x38000000u;
    }
    half = number >> shift;
    rest = (number & (((uint32_t)1u << shift) - 1u)) << 1;
    if (rest > (uint32_t)1u << shift || (rest == (uint32_t)1u << shift && (half & 1u))) {
        half++;
    }
    return (uint16_t)(sign | half);
}

/* ---- signed ---- */

DEVICE_INLINE number_type device_signed(word_type raw)
{
    return (number_type)(raw ^ SIGN) - LEAST;
}

/* ---- magnitude ---- */

/* The number of bits of which the highest says that it is below zero. */
DEVICE_INLINE number_type device_of_magnitude(word_type bits)
{
    return (number_type)((bits & SIGN) ? -(wide_type)(bits & MAGNITUDE) : (wide_type)bits);
}

DEVICE_INLINE word_type device_magnitude_of(number_type value)
{
    return (word_type)(value < 0 ? ((wide_word)0 - (wide_word)value) | SIGN : (wide_word)value);
}

/* ---- codec ---- */

/** Whether bytes are a number of a codec. */
static inline bool device_is_codec(const uint8_t *in)
{
    int64_t number = 0;
    return device_codec_decode(in, &number) && number >= LOW && number <= HIGH;
}

/** The number of a codec. */
static inline int64_t device_load_codec(const uint8_t *in)
{
    int64_t number = 0;
    (void)device_codec_decode(in, &number);
    return number;
}
