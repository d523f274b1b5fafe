/* ---- RECORD ---- */

/* Decodes and encodes twice, then encodes into a buffer of the exact size, and into one that is a byte too small. */
#define RECORD(type, decode, encode, most, exact) \
    do { \
        type value, second; \
        uint8_t out[most] = {0}, again[most] = {0}; \
        uint8_t *room; \
        size_t length = 0, beyond = 0; \
        memset(&value, 0, sizeof value); \
        memset(&second, 0, sizeof second); \
        if (decode(data, size, &value) != DEVICE_OK) { \
            break; \
        } \
        if (encode(&value, out, sizeof out, &length) == DEVICE_ERR_OUT_OF_RANGE) { \
            break; \
        } \
        hold(encode(&value, out, sizeof out, &length) == DEVICE_OK && length == size); \
        hold(!(exact) || memcmp(out, data, size) == 0); \
        hold(decode(out, length, &second) == DEVICE_OK); \
        hold(encode(&second, again, sizeof again, &length) == DEVICE_OK && length == size); \
        hold(memcmp(out, again, size) == 0); \
        room = (uint8_t *)malloc(size); \
        if (room != NULL && size > 0) { \
            hold(encode(&value, room, size, &length) == DEVICE_OK && memcmp(room, out, size) == 0); \
            hold(encode(&value, room, size - 1, &beyond) == DEVICE_ERR_CAPACITY); \
        } \
        free(room); \
    } while (0)

/* ---- PACKED ---- */

/* Unpacks any bytes and packs them, twice: the second time changes nothing. */
#define PACKED(type, unpack, pack, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}, again[length] = {0}; \
        if (size < (length)) { \
            break; \
        } \
        memset(&value, 0, sizeof value); \
        unpack(data, &value); \
        pack(&value, out); \
        unpack(out, &value); \
        pack(&value, again); \
        hold(memcmp(out, again, sizeof out) == 0); \
    } while (0)

/* ---- FIXED ---- */

/* A record without values, which has only one form. */
#define FIXED(decode, encode, most, exact) \
    do { \
        uint8_t out[(most) + 1u] = {0}; \
        size_t length = 0; \
        if (decode(data, size) != DEVICE_OK) { \
            break; \
        } \
        hold(encode(out, sizeof out, &length) == DEVICE_OK && length == size); \
        hold(!(exact) || memcmp(out, data, size) == 0); \
    } while (0)

/* ---- VALUE ---- */

/* The value of a register or a parameter. */
#define VALUE(type, decode, encode, held, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        if (size < (length) || decode(data, &value) != DEVICE_OK || encode(value, out) == DEVICE_ERR_OUT_OF_RANGE) { \
            break; \
        } \
        hold(encode(value, out) == DEVICE_OK && memcmp(out, data, held) == 0); \
    } while (0)

/* ---- SEVERAL_FORMS ---- */

/* A value that several series of bytes are, as of a zero with two signs: what is encoded of it is the same again. */
#define SEVERAL_FORMS(type, argument, decode, encode, length) \
    do { \
        type value, second; \
        uint8_t out[length] = {0}; \
        memset(&second, 0, sizeof second); \
        if (size < (length) || decode(data, &value) != DEVICE_OK || (type)(argument)value != value || \
            encode((argument)value, out) != DEVICE_OK) { \
            break; \
        } \
        hold(decode(out, &second) == DEVICE_OK && second == value); \
    } while (0)

/* ---- TURNED ---- */

/* A number that is written with its words in the opposite order of those that are read. */
#define TURNED(type, argument, decode, encode, length) \
    do { \
        type value, second; \
        uint8_t out[length] = {0}, again[length] = {0}; \
        size_t at; \
        memset(&second, 0, sizeof second); \
        if (size < (length) || decode(data, &value) != DEVICE_OK || (type)(argument)value != value || \
            encode((argument)value, out) != DEVICE_OK) { \
            break; \
        } \
        for (at = 0; at < (length); at++) { \
            again[at] = out[((length) - 1u - at) ^ 1u]; \
        } \
        hold(decode(again, &second) == DEVICE_OK && second == value); \
    } while (0)

/* ---- ARRAY ---- */

/* The text or the bytes of a register or a parameter. A text ends at its first zero. */
#define ARRAY(declared, decode, encode, exact, length) \
    do { \
        declared, second[sizeof value]; \
        uint8_t out[length] = {0}, again[length] = {0}; \
        if (size < (length) || decode(data, value) != DEVICE_OK) { \
            break; \
        } \
        hold(encode(value, out) == DEVICE_OK && (!(exact) || memcmp(out, data, sizeof out) == 0)); \
        hold(decode(out, second) == DEVICE_OK && encode(second, again) == DEVICE_OK && memcmp(out, again, sizeof out) == 0); \
    } while (0)

/* ---- CONSTANT ---- */

/* A constant: what is encoded can be decoded, and so can anything else that the device answers. */
#define CONSTANT(type, decode, encode, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        hold(encode(out) == DEVICE_OK && decode(out, &value) == DEVICE_OK); \
        hold(size < (length) || decode(data, &value) != DEVICE_ERR_WRONG_CONST); \
    } while (0)

/* ---- TRIGGER ---- */

/* A trigger: the device may answer anything, and whatever can be encoded is decoded to the same. `argument` is the type
 * of the value to encode: an enum, which need not hold every answer. */
#define TRIGGER(type, argument, decode, encode, held, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        if (size < (length)) { \
            break; \
        } \
        hold(decode(data, &value) == DEVICE_OK); \
        if ((type)(argument)value == value) { \
            hold(encode((argument)value, out) != DEVICE_OK || memcmp(out, data, held) == 0); \
        } \
    } while (0)

/* ---- ADDRESS ---- */

/* An address or a number that is computed from another: two different ones that are accepted give different results. */
#define ADDRESS(type, at) \
    do { \
        type one = 0, other = 0; \
        uint32_t first, second; \
        if (size < 8) { \
            break; \
        } \
        first = data[0] | (uint32_t)data[1] << 8 | (uint32_t)data[2] << 16 | (uint32_t)data[3] << 24; \
        second = data[4] | (uint32_t)data[5] << 8 | (uint32_t)data[6] << 16 | (uint32_t)data[7] << 24; \
        if (at(first, &one) == DEVICE_OK && at(second, &other) == DEVICE_OK) { \
            hold((first == second) == (one == other)); \
        } \
    } while (0)

/* ---- MOVING_ADDRESS ---- */

/* An address that is computed from that of the first element: two different numbers that are accepted give different ones. */
#define MOVING_ADDRESS(type, at) \
    do { \
        type base, one = 0, other = 0; \
        uint32_t first, second; \
        if (size < 4) { \
            break; \
        } \
        base = (type)(data[0] | (uint32_t)data[1] << 8); \
        first = data[2]; \
        second = data[3]; \
        if (at(base, first, &one) == DEVICE_OK && at(base, second, &other) == DEVICE_OK) { \
            hold((first == second) == (one == other)); \
        } \
    } while (0)

/* ---- QUANTITY ---- */

/* Any quantity is refused or becomes a count, whatever the exponent; converting a count back and forth keeps it. */
#define QUANTITY(type, exponent_type, from_raw, to_raw, exact) \
    do { \
        type raw = 0, again = 0; \
        exponent_type exponent; \
        double quantity; \
        if (size < sizeof quantity + sizeof exponent) { \
            break; \
        } \
        memcpy(&quantity, data, sizeof quantity); \
        memcpy(&exponent, data + sizeof quantity, sizeof exponent); \
        if (to_raw(quantity, exponent, &raw) == DEVICE_OK) { \
            hold(from_raw(raw, exponent, &quantity) == DEVICE_OK); \
            hold(!(exact) || (to_raw(quantity, exponent, &again) == DEVICE_OK && again == raw)); \
        } \
    } while (0)

/* ---- CONVERSION ---- */

/* Any quantity is refused or becomes a count; with a reference of usual size, converting a count back and forth keeps it. */
#define CONVERSION(type, from_raw, to_raw, exact) \
    do { \
        type raw = 0, again = 0; \
        double quantity, reference; \
        if (size < 2 * sizeof quantity) { \
            break; \
        } \
        memcpy(&quantity, data, sizeof quantity); \
        memcpy(&reference, data + sizeof quantity, sizeof reference); \
        if (to_raw(quantity, reference, &raw) == DEVICE_OK && (exact) && reference > 1e-9 && reference < 1e9) { \
            hold(to_raw(from_raw(raw, reference), reference, &again) == DEVICE_OK && again == raw); \
        } \
    } while (0)
