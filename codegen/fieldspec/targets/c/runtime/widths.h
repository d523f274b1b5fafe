/* ---- widths ---- */

/** A field of a record whose values vary in width. Codecs work on an image, in which each has all bytes that it may have. */
typedef struct device_width {
    size_t size; /**< The bytes in the image. */
    size_t most; /**< The most bytes that are sent; 0 where those of the image are. */
    uint16_t end; /**< The byte that follows; 0x100 where nothing does. */
    uint8_t form; /**< 1 for a text, else the letter for 10 among digits, and 0 where they are decimal. */
    uint8_t places; /**< How many digits follow a point. */
    bool has_sign; /**< Whether a sign comes first in the image; it is sent below zero only. */
    size_t other_at; /**< Where in the image is the text that this field counts, or what counts this text. */
    size_t other_size; /**< The bytes of that one in the image; 0 where there is none. */
    size_t count_size; /**< The bytes of the field that counts. */
    size_t plus; /**< What it contains in addition. */
    uint8_t count_form; /**< The form of its number. */
} device_width;

/** Whether a character is a digit of a field. */
static inline bool device_width_digit(const device_width *field, uint8_t character)
{
    return (character >= 0x30u && character <= 0x39u) ||
           (field->form != 0u && character >= field->form && character <= field->form + 5u);
}

/** How many digits come before the point in the image. */
static inline size_t device_width_whole(const device_width *field)
{
    return field->most - (field->places != 0u ? field->places + 1u : 0u);
}

/** Writes the image of the bytes of a value; false for bytes that are none. */
static inline bool device_widen_digits(const device_width *field, const uint8_t *in, size_t length, uint8_t *out)
{
    size_t room = device_width_whole(field);
    size_t whole = 0, fraction = 0, skipped = 0, offset, sent_size;
    bool is_negative = false;
    if (field->has_sign) {
        out[0] = 0x2Bu;
        if (length > 0u && (in[0] == 0x2Bu || in[0] == 0x2Du)) {
            out[0] = in[0];
            in++;
            length--;
        }
    }
    while (whole < length && device_width_digit(field, in[whole])) {
        whole++;
    }
    if (whole == 0u || (whole < length && (field->places == 0u || in[whole] != 0x2Eu))) {
        return false;
    }
    if (whole < length) {
        fraction = length - whole - 1u;
        if (fraction == 0u || fraction > field->places) {
            return false;
        }
    }
    for (offset = 0; offset < length; offset++) {
        if (offset != whole && !device_width_digit(field, in[offset])) {
            return false;
        }
        if (offset != whole && in[offset] != 0x30u) {
            is_negative = field->has_sign && out[0] == 0x2Du;
        }
    }
    while (skipped + 1u < whole && in[skipped] == 0x30u) {
        skipped++;
    }
    sent_size = whole - skipped + (field->most - room) + (is_negative ? 1u : 0u);
    if (sent_size > field->most) {
        return false;
    }
    out += field->has_sign ? 1 : 0;
    for (offset = 0; offset < room; offset++) {
        out[offset] = offset + whole < room + skipped ? 0x30u : in[offset + whole - room];
    }
    if (field->places != 0u) {
        out[room] = 0x2Eu;
        for (offset = 0; offset < field->places; offset++) {
            out[room + 1u + offset] = offset < fraction ? in[whole + 1u + offset] : 0x30u;
        }
    }
    return true;
}

/** Writes the image of the bytes of a field; false for bytes that are not those of its value. */
static inline bool device_widen(const device_width *field, const uint8_t *in, size_t length, uint8_t *out)
{
    size_t offset;
    if (length > field->most) {
        return false;
    }
    if (field->form != 1u) {
        return device_widen_digits(field, in, length, out);
    }
    for (offset = 0; offset < field->size; offset++) {
        if (offset < length && in[offset] == 0u) {
            return false;
        }
        out[offset] = offset < length ? in[offset] : 0u;
    }
    return true;
}

/** Writes the image of a record. */
static inline device_codec_status device_widen_fields(const device_width *fields, size_t count, const uint8_t *in,
                                                      size_t length, uint8_t *out)
{
    bool is_unfit = false;
    uint8_t *image = out;
    size_t offset = 0, number;
    for (number = 0; number < count; number++) {
        const device_width *field = &fields[number];
        bool is_counted = field->most != 0u && field->other_size != 0u;
        size_t size = 0, byte;
        if (field->most == 0u) {
            size = field->size;
        } else if (is_counted) {
            uint8_t *counting = image + field->other_at;
            uint32_t counted = device_load_count(counting, field->count_size, field->count_form);
            if (!device_is_count(counting, field->count_size, field->count_form)) {
                return DEVICE_ERR_UNKNOWN_VALUE;
            }
            if (counted < field->plus || counted - field->plus > field->most) {
                return is_unfit ? DEVICE_ERR_UNKNOWN_VALUE : DEVICE_ERR_WRONG_MEASURE;
            }
            size = (size_t)(counted - field->plus);
            device_store_count(counting, field->count_size, field->count_form, (uint32_t)(field->size + field->plus));
        } else {
            while (offset + size < length && in[offset + size] != field->end) {
                size++;
            }
        }
        if (size > length - offset || (field->most != 0u && field->end < 0x100u && offset + size == length)) {
            return is_unfit ? DEVICE_ERR_UNKNOWN_VALUE : DEVICE_ERR_INCOMPLETE;
        }
        if (field->most == 0u) {
            for (byte = 0; byte < size; byte++) {
                out[byte] = in[offset + byte];
            }
        } else if (!device_widen(field, in + offset, size, out)) {
            is_unfit = true;
        }
        offset += size;
        out += field->size;
    }
    if (is_unfit) {
        return DEVICE_ERR_UNKNOWN_VALUE;
    }
    return offset == length ? DEVICE_OK : DEVICE_ERR_WRONG_LENGTH;
}

/** Writes what is sent of the image of a record. */
static inline device_codec_status device_narrow_fields(const device_width *fields, size_t count, const uint8_t *in,
                                                       uint8_t *out, size_t capacity, size_t *length)
{
    const uint8_t *image = in;
    size_t written = 0, number;
    for (number = 0; number < count; number++) {
        const device_width *field = &fields[number];
        size_t first = 0, last = field->size;
        bool is_negative = false;
        if (field->most == 0u && field->other_size != 0u) {
            size_t text = field->other_size;
            while (text > 0u && image[field->other_at + text - 1u] == 0u) {
                text--;
            }
            if (field->size > capacity - written) {
                return DEVICE_ERR_CAPACITY;
            }
            device_store_count(out + written, field->size, field->count_form, (uint32_t)(text + field->plus));
            written += field->size;
            in += field->size;
            continue;
        }
        if (field->most != 0u && field->form == 1u) {
            while (last > 0u && in[last - 1u] == 0u) {
                last--;
            }
        } else if (field->most != 0u) {
            size_t point;
            first = field->has_sign ? 1u : 0u;
            is_negative = field->has_sign && in[0] == 0x2Du;
            point = first + device_width_whole(field);
            while (first + 1u < point && in[first] == 0x30u) {
                first++;
            }
        }
        if (last - first + (is_negative ? 1u : 0u) > capacity - written) {
            return DEVICE_ERR_CAPACITY;
        }
        if (is_negative) {
            out[written++] = 0x2Du;
        }
        for (; first < last; first++) {
            if (field->most != 0u && in[first] == field->end) {
                return DEVICE_ERR_UNKNOWN_VALUE;
            }
            out[written++] = in[first];
        }
        in += field->size;
    }
    *length = written;
    return DEVICE_OK;
}
