/* ---- counts ---- */

/**
 * Whether bytes are the number in a field that counts others. Its form is 0 or 1 where it is binary, with the most or the
 * least significant byte first, 10 where it is decimal digits, else the letter for 10 among hexadecimal digits.
 */
static inline bool device_is_count(const uint8_t *in, size_t size, uint8_t form)
{
    size_t offset;
    for (offset = 0; offset < size && form > 1u; offset++) {
        bool is_letter = form > 10u && in[offset] >= form && in[offset] <= form + 5u;
        if (!is_letter && (in[offset] < 0x30u || in[offset] > 0x39u)) {
            return false;
        }
    }
    return true;
}

/** That number. */
static inline uint32_t device_load_count(const uint8_t *in, size_t size, uint8_t form)
{
    uint32_t number = 0u;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        uint32_t byte = in[form == 1u ? size - 1u - offset : offset];
        if (form > 1u) {
            number = number * (form == 10u ? 10u : 16u) + (byte & 0x0Fu) + (byte < 0x40u ? 0u : 9u);
        } else {
            number = number << 8 | byte;
        }
    }
    return number;
}

/** Writes it unless `out` is NULL; false for a number that has more bytes or digits. */
static inline bool device_store_count(uint8_t *out, size_t size, uint8_t form, uint32_t number)
{
    uint32_t base = form < 2u ? 256u : form == 10u ? 10u : 16u;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        uint32_t byte = number % base;
        if (form > 1u) {
            byte = byte < 10u ? 0x30u + byte : form + byte - 10u;
        }
        if (out != NULL) {
            out[form == 1u ? offset : size - 1u - offset] = (uint8_t)byte;
        }
        number /= base;
    }
    return number == 0u;
}
