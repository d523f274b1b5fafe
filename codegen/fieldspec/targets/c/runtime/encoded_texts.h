/* ---- encoded_texts ---- */

/* Encodings are 0 for ASCII, 1 for Latin-1, 2 for UTF-8, 3 for UTF-16 with the high byte first, 4 with the low one;
 * 5 to 7 are the first three with the bytes of each word of 16 bits exchanged; 8 is packed ASCII, and 9 that of such words.
 * Packed ASCII has a unit of six bits for each character. Texts in structs are UTF-8. `padding` fills a text up, before it where `is_right`; `end` ends it, unless it is above 0x7F. */

/** The bytes of a unit of an encoding. */
static inline size_t device_text_unit_size(uint32_t encoding)
{
    return encoding == 3u || encoding == 4u ? 2u : 1u;
}

/**
 * The character at `*offset` of UTF-8, after which `*offset` is; 0xFFFFFFFF for bytes that are none. `turn` is 1 where the
 * bytes of each word are exchanged, else 0.
 */
static inline uint32_t device_next_utf_8(const uint8_t *in, size_t size, size_t *offset, size_t turn)
{
    static const uint32_t minimum[] = {0u, 0x80u, 0x800u, 0x10000u};
    uint32_t character = in[*offset ^ turn];
    uint32_t following = character < 0x80u ? 0u : character < 0xE0u ? 1u : character < 0xF0u ? 2u : 3u;
    uint32_t left;
    *offset += 1u;
    if (following == 0u) {
        return character;
    }
    if (character < 0xC2u || character > 0xF4u || size - *offset < following) {
        return 0xFFFFFFFFu;
    }
    character &= 0x3Fu >> following;
    for (left = following; left > 0u; left--) {
        uint32_t next = in[*offset ^ turn];
        if ((next & 0xC0u) != 0x80u) {
            return 0xFFFFFFFFu;
        }
        character = character << 6 | (next & 0x3Fu);
        *offset += 1u;
    }
    if (character < minimum[following] || character > 0x10FFFFu || (character >= 0xD800u && character <= 0xDFFFu)) {
        return 0xFFFFFFFFu;
    }
    return character;
}

/** The bytes of a text of `size` bytes where each character of packed ASCII has one. */
static inline size_t device_whole_text_size(size_t size, uint32_t encoding)
{
    return encoding > 7u ? size / 3u * 4u : size;
}

/** The character `offset` of packed ASCII, four of which are in three bytes. `turn` is as in UTF-8. */
static inline uint32_t device_packed_character(const uint8_t *in, size_t offset, size_t turn)
{
    size_t first = offset / 4u * 3u;
    uint32_t number = (uint32_t)in[first ^ turn] << 16 | (uint32_t)in[(first + 1u) ^ turn] << 8 | in[(first + 2u) ^ turn];
    uint32_t code = number >> (18u - 6u * (uint32_t)(offset % 4u)) & 0x3Fu;
    return code < 0x20u ? code + 0x40u : code;
}

/** Writes the characters of packed ASCII, `before` of which fill the text up before it. */
static inline void device_pack_text(uint8_t *out, const char *text, size_t length, size_t size, uint8_t padding,
                                    size_t before, uint8_t end)
{
    size_t offset;
    uint32_t bits = 0u;
    for (offset = 0; offset < size / 3u * 4u; offset++) {
        bool is_text = offset >= before && offset - before < length;
        bool is_end = offset == before + length && end < 0x80u;
        bits = bits << 6 | ((is_text ? (uint8_t)text[offset - before] : is_end ? end : padding) & 0x3Fu);
        if (offset % 4u != 0u) {
            out[offset / 4u * 3u + offset % 4u - 1u] = (uint8_t)(bits >> (6u - 2u * (uint32_t)(offset % 4u)) & 0xFFu);
        }
    }
}

/** The unit at byte `offset` of a text: a byte, 16 bits of UTF-16, or the character `offset` of packed ASCII. */
static inline uint32_t device_text_unit(const uint8_t *in, size_t offset, uint32_t encoding)
{
    if (encoding > 7u) {
        return device_packed_character(in, offset, encoding == 9u ? 1u : 0u);
    }
    if (encoding < 3u || encoding > 4u) {
        return in[encoding > 4u ? offset ^ 1u : offset];
    }
    return encoding == 3u ? (uint32_t)in[offset] << 8 | in[offset + 1u] : (uint32_t)in[offset + 1u] << 8 | in[offset];
}

/** The character at `*offset` of an encoding, after which `*offset` is; 0xFFFFFFFF for bytes that are none. */
static inline uint32_t device_next_character(const uint8_t *in, size_t size, size_t *offset, uint32_t encoding)
{
    uint32_t character, second;
    if (encoding == 2u || encoding == 7u) {
        return device_next_utf_8(in, size, offset, encoding == 7u ? 1u : 0u);
    }
    character = device_text_unit(in, *offset, encoding);
    *offset += device_text_unit_size(encoding);
    if (device_text_unit_size(encoding) == 1u) {
        return (encoding == 0u || encoding == 5u) && character > 0x7Fu ? 0xFFFFFFFFu : character;
    }
    if (character < 0xD800u || character > 0xDFFFu) {
        return character;
    }
    if (character > 0xDBFFu || size - *offset < 2u) {
        return 0xFFFFFFFFu;
    }
    second = device_text_unit(in, *offset, encoding);
    *offset += 2u;
    if (second < 0xDC00u || second > 0xDFFFu) {
        return 0xFFFFFFFFu;
    }
    return 0x10000u + ((character & 0x3FFu) << 10 | (second & 0x3FFu));
}

/** Writes a unit and returns its bytes. */
static inline size_t device_put_unit(uint8_t *out, uint32_t unit, uint32_t encoding)
{
    if (encoding < 3u) {
        out[0] = (uint8_t)unit;
        return 1u;
    }
    out[encoding == 3u ? 0 : 1] = (uint8_t)(unit >> 8);
    out[encoding == 3u ? 1 : 0] = (uint8_t)(unit & 0xFFu);
    return 2u;
}

/** Writes a character to at most four bytes and returns their number; 0 for one that the encoding does not have. */
static inline size_t device_put_character(uint8_t *out, uint32_t character, uint32_t encoding)
{
    size_t size = 1u, offset;
    if (encoding == 8u) {
        out[0] = (uint8_t)(character & 0xFFu);
        return character < 0x20u || character > 0x5Fu ? 0u : 1u;
    }
    if (encoding > 2u) {
        if (character < 0x10000u) {
            return device_put_unit(out, character, encoding);
        }
        size = device_put_unit(out, 0xD7C0u + (character >> 10), encoding);
        return size + device_put_unit(out + 2, 0xDC00u + (character & 0x3FFu), encoding);
    }
    if (encoding < 2u || character < 0x80u) {
        out[0] = (uint8_t)(character & 0xFFu);
        return character > (encoding == 0u ? 0x7Fu : 0xFFu) ? 0u : 1u;
    }
    size = character < 0x800u ? 2u : character < 0x10000u ? 3u : 4u;
    for (offset = size - 1u; offset > 0u; offset--) {
        out[offset] = (uint8_t)(0x80u | (character & 0x3Fu));
        character >>= 6;
    }
    out[0] = (uint8_t)(((0xF00u >> size) & 0xF0u) | character);
    return size;
}

/** Whether bytes are characters of an encoding; writes them to `out`, with a zero after them, unless it is NULL. */
static inline bool device_read_encoded_text(char *out, const uint8_t *in, size_t size, uint32_t encoding, uint8_t padding,
                                            bool is_right, uint8_t end)
{
    size_t unit = device_text_unit_size(encoding);
    size_t offset = 0, last, length = 0, byte;
    size = device_whole_text_size(size, encoding);
    last = size;
    if (end < 0x80u) {
        for (last = 0; last < size && device_text_unit(in, last, encoding) != end; last += unit) {
        }
        if (last >= size) {
            return false;
        }
    } else if (is_right) {
        while (offset < last && device_text_unit(in, offset, encoding) == padding) {
            offset += unit;
        }
    } else {
        while (last > offset && device_text_unit(in, last - unit, encoding) == padding) {
            last -= unit;
        }
    }
    while (offset < last) {
        uint8_t bytes[4];
        uint32_t character = device_next_character(in, last, &offset, encoding);
        size_t written;
        if (character == 0u || character == 0xFFFFFFFFu) {
            return false;
        }
        written = device_put_character(bytes, character, 2u);
        for (byte = 0; out != NULL && byte < written; byte++) {
            out[length + byte] = (char)bytes[byte];
        }
        length += written;
    }
    if (out != NULL) {
        out[length] = '\0';
    }
    return true;
}

/** Whether bytes are characters of an encoding. */
static inline bool device_is_encoded_text(const uint8_t *in, size_t size, uint32_t encoding, uint8_t padding, bool is_right,
                                          uint8_t end)
{
    return device_read_encoded_text(NULL, in, size, encoding, padding, is_right, end);
}

/** Reads a text without a check; it is empty where the bytes are none. */
static inline void device_load_encoded_text(char *out, const uint8_t *in, size_t size, uint32_t encoding, uint8_t padding,
                                            bool is_right, uint8_t end)
{
    if (!device_read_encoded_text(out, in, size, encoding, padding, is_right, end)) {
        out[0] = '\0';
    }
}

/** Whether a text of at most `capacity` bytes can be sent in `size` bytes; writes it to `out`, unless that is NULL. */
static inline bool device_write_encoded_text(uint8_t *out, const char *text, size_t capacity, size_t size,
                                             uint32_t encoding, uint8_t padding, bool is_right, uint8_t end)
{
    const uint8_t *in = (const uint8_t *)text;
    uint8_t *first = out;
    bool is_turned = encoding > 4u && encoding != 8u;
    size_t unit = device_text_unit_size(encoding);
    size_t whole = device_whole_text_size(size, encoding);
    size_t room = end < 0x80u ? whole - unit : whole;
    size_t length = 0, total = 0, offset, byte;
    uint8_t bytes[4];
    encoding -= !is_turned ? 0u : encoding > 7u ? 1u : 5u;
    while (length < capacity && text[length] != '\0') {
        length++;
    }
    for (offset = 0; offset < length;) {
        bool is_first = offset == 0u;
        uint32_t character = device_next_utf_8(in, length, &offset, 0u);
        size_t written = character == 0xFFFFFFFFu ? 0u : device_put_character(bytes, character, encoding);
        if (written == 0u || written > room - total || (end < 0x80u && character == end)) {
            return false;
        }
        if (end > 0x7Fu && character == padding && (is_right ? is_first : offset == length)) {
            return false;
        }
        total += written;
    }
    if (out == NULL) {
        return true;
    }
    if (encoding > 7u) {
        device_pack_text(out, text, length, size, padding, is_right ? whole - total : 0u, end);
        length = 0u;
    }
    for (offset = encoding > 7u ? size : 0u; offset < size; offset += unit) {
        (void)device_put_unit(out + offset, padding, encoding);
    }
    out += is_right && encoding < 8u ? size - total : 0u;
    for (offset = 0; offset < length;) {
        size_t written = device_put_character(bytes, device_next_utf_8(in, length, &offset, 0u), encoding);
        for (byte = 0; byte < written; byte++) {
            out[byte] = bytes[byte];
        }
        out += written;
    }
    if (end < 0x80u && encoding < 8u) {
        (void)device_put_unit(out, end, encoding);
    }
    for (offset = 0; is_turned && offset < size; offset += 2u) {
        uint8_t low = first[offset];
        first[offset] = first[offset + 1u];
        first[offset + 1u] = low;
    }
    return true;
}

/** Whether a text of at most `capacity` bytes can be sent. */
static inline bool device_fits_encoded_text(const char *text, size_t capacity, size_t size, uint32_t encoding,
                                            uint8_t padding, bool is_right, uint8_t end)
{
    return device_write_encoded_text(NULL, text, capacity, size, encoding, padding, is_right, end);
}

/** Writes a text that can be sent, and what fills it up. */
static inline void device_store_encoded_text(uint8_t *out, const char *text, size_t capacity, size_t size,
                                             uint32_t encoding, uint8_t padding, bool is_right, uint8_t end)
{
    (void)device_write_encoded_text(out, text, capacity, size, encoding, padding, is_right, end);
}
