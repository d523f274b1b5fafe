/* ---- moving ---- */

/** Moves bytes up, to make room before them. */
static inline void device_move_up(uint8_t *data, size_t size, size_t room)
{
    while (size > 0u) {
        size--;
        data[size + room] = data[size];
    }
}

/* ---- replace ---- */

/** The row of the table for a byte, or for the two bytes that are sent for it; ROWS if there is none. */
static inline size_t device_ROW(uint8_t first, uint8_t second, bool is_sent)
{
    static const uint8_t pairs[ROWS][3] = {
PAIRS
    };
    size_t row;
    for (row = 0; row < ROWS; row++) {
        if (is_sent ? pairs[row][1] == first && pairs[row][2] == second : pairs[row][0] == first) {
            break;
        }
    }
    return row;
}

/** Turns the bytes between `head` and `tail` bytes into those that are sent. */
static inline device_codec_status device_ESCAPE(
    uint8_t *data, size_t *length, size_t head, size_t tail, size_t capacity)
{
    static const uint8_t sent_bytes[ROWS][2] = {
SENT
    };
    size_t size = *length - head - tail, room = 0, offset, to = head;
    for (offset = 0; offset < size; offset++) {
        room += device_ROW(data[head + offset], 0, false) < ROWS ? 1u : 0u;
    }
    if (room > capacity - *length) {
        return DEVICE_ERR_CAPACITY;
    }
    device_move_up(data + head, size + tail, room);
    for (offset = head + room; offset < head + room + size; offset++) {
        size_t row = device_ROW(data[offset], 0, false);
        if (row < ROWS) {
            data[to] = sent_bytes[row][0];
            data[to + 1u] = sent_bytes[row][1];
            to += 2u;
        } else {
            data[to] = data[offset];
            to++;
        }
    }
    *length += room;
    return DEVICE_OK;
}

/** Turns the bytes between `head` and `tail` bytes back into the original ones. */
static inline device_codec_status device_UNESCAPE(uint8_t *data, size_t *length, size_t head, size_t tail)
{
    static const uint8_t originals[ROWS] = {ORIGINALS};
    size_t stop = *length - tail, offset = head, to = head;
    while (offset < stop) {
        if (SPECIAL) {
            size_t row = offset + 1u < stop ? device_ROW(data[offset], data[offset + 1u], true) : ROWS;
            if (row >= ROWS) {
                return DEVICE_ERR_WRONG_MARK;
            }
            data[to] = originals[row];
            offset += 2u;
        } else {
            data[to] = data[offset];
            offset++;
        }
        to++;
    }
    for (offset = 0; offset < tail; offset++) {
        data[to + offset] = data[stop + offset];
    }
    *length = to + tail;
    return DEVICE_OK;
}

/* ---- insert ---- */

/** Whether the pattern ends at a byte. */
static inline bool device_ROW(const uint8_t *data, size_t begin, size_t end)
{
    static const uint8_t pattern[ROWS] = {PATTERN};
    size_t offset;
    if (end - begin < ROWS) {
        return false;
    }
    for (offset = 0; offset < ROWS; offset++) {
        if (data[end - ROWS + offset] != pattern[offset]) {
            return false;
        }
    }
    return true;
}

/** Turns the bytes between `head` and `tail` bytes into those that are sent. */
static inline device_codec_status device_ESCAPE(
    uint8_t *data, size_t *length, size_t head, size_t tail, size_t capacity)
{
    size_t size = *length - head - tail, room = 0, offset, begin = head, to = head;
    for (offset = head; offset < head + size; offset++) {
        if (device_ROW(data, begin, offset + 1u)) {
            room++;
            begin = offset + 1u;
        }
    }
    if (room > capacity - *length) {
        return DEVICE_ERR_CAPACITY;
    }
    device_move_up(data + head, size + tail, room);
    begin = head;
    for (offset = head + room; offset < head + room + size; offset++) {
        data[to] = data[offset];
        to++;
        if (device_ROW(data, begin, to)) {
            data[to] = INSERTED;
            to++;
            begin = to;
        }
    }
    *length += room;
    return DEVICE_OK;
}

/** Turns the bytes between `head` and `tail` bytes back into the original ones. */
static inline device_codec_status device_UNESCAPE(uint8_t *data, size_t *length, size_t head, size_t tail)
{
    size_t stop = *length - tail, offset = head, to = head, begin = head;
    while (offset < stop) {
        data[to] = data[offset];
        offset++;
        to++;
        if (device_ROW(data, begin, to)) {
            if (offset >= stop || data[offset] != INSERTED) {
                return DEVICE_ERR_WRONG_MARK;
            }
            offset++;
            begin = to;
        }
    }
    for (offset = 0; offset < tail; offset++) {
        data[to + offset] = data[stop + offset];
    }
    *length = to + tail;
    return DEVICE_OK;
}

/* ---- add ---- */

/** Turns the bytes between `head` and `tail` bytes into those that are sent. */
static inline void device_ESCAPE(uint8_t *data, size_t length, size_t head, size_t tail)
{
    size_t offset;
    for (offset = head; offset < length - tail; offset++) {
        data[offset] = (uint8_t)((data[offset] + INSERTED) & 0xFFu);
    }
}

/** Turns the bytes between `head` and `tail` bytes back into the original ones. */
static inline void device_UNESCAPE(uint8_t *data, size_t length, size_t head, size_t tail)
{
    size_t offset;
    for (offset = head; offset < length - tail; offset++) {
        data[offset] = (uint8_t)((data[offset] - INSERTED) & 0xFFu);
    }
}

/* ---- cobs ---- */

/** Turns the bytes between `head` and `tail` bytes into blocks without zeros. */
static inline device_codec_status device_ESCAPE(
    uint8_t *data, size_t *length, size_t head, size_t tail, size_t capacity)
{
    size_t size = *length - head - tail, room = 1, offset, block = 0, to = head, code;
    for (offset = 0; offset < size; offset++) {
        if (block == 254u) {
            room++;
            block = 0;
        }
        block = data[head + offset] == 0u ? 0u : block + 1u;
    }
    if (room > capacity - *length) {
        return DEVICE_ERR_CAPACITY;
    }
    device_move_up(data + head, size + tail, room);
    code = to;
    to++;
    for (offset = head + room; offset < head + room + size; offset++) {
        uint8_t byte = data[offset];
        if (to - code == 255u) {
            data[code] = 0xFFu;
            code = to;
            to++;
        }
        if (byte == 0u) {
            data[code] = (uint8_t)(to - code);
            code = to;
        } else {
            data[to] = byte;
        }
        to++;
    }
    data[code] = (uint8_t)(to - code);
    *length += room;
    return DEVICE_OK;
}

/** Turns the blocks between `head` and `tail` bytes back into the original bytes. */
static inline device_codec_status device_UNESCAPE(uint8_t *data, size_t *length, size_t head, size_t tail)
{
    size_t stop = *length - tail, offset = head, to = head, end;
    uint8_t code;
    if (offset == stop) {
        return DEVICE_ERR_WRONG_MARK;
    }
    while (offset < stop) {
        code = data[offset];
        if (code == 0u || code > stop - offset) {
            return DEVICE_ERR_WRONG_MARK;
        }
        end = offset + code;
        for (offset++; offset < end; offset++) {
            if (data[offset] == 0u) {
                return DEVICE_ERR_WRONG_MARK;
            }
            data[to] = data[offset];
            to++;
        }
        if (code < 0xFFu && offset < stop) {
            data[to] = 0u;
            to++;
        }
    }
    for (offset = 0; offset < tail; offset++) {
        data[to + offset] = data[stop + offset];
    }
    *length = to + tail;
    return DEVICE_OK;
}

/* ---- can ---- */

/** Packs the first parts into the identifier of a CAN frame: the identifier, the number of data, zeros, the data. */
/* The code of a remote request has a bit for that, and the number of data in place of data. */ /* if REMOTE */
static inline device_codec_status device_ESCAPE(
    uint8_t *data, size_t *length, size_t head, size_t tail, size_t capacity)
{
    static const uint8_t fields[ROWS][COLUMNS] = {
FIELDS
    };
    uint32_t identifier = FLAGS, number;
    size_t offset = head, row, byte, size = *length - head - tail - SIZE, content = size;
    for (row = 0; row < ROWS; row++) {
        number = 0;
        for (byte = 0; byte < fields[row][0]; byte++) {
            number |= (uint32_t)data[offset + byte] << (8u * (fields[row][1] != 0u ? byte : fields[row][0] - 1u - byte));
        }
        identifier |= number & ((uint32_t)fields[row][4] << 24u); /* if REMOTE */
        number &= ~((uint32_t)fields[row][4] << 24u);             /* if REMOTE */
        if ((number >> fields[row][3]) != 0u) {
            return DEVICE_ERR_OUT_OF_RANGE;
        }
        identifier |= number << fields[row][2];
        offset += fields[row][0];
    }
    if ((identifier & REMOTE) != 0u) {             /* if REMOTE */
        size = content == 1u ? data[offset] : content; /* if REMOTE */
        content = 0;                               /* if REMOTE */
    }                                              /* if REMOTE */
    if (size > 8u) {
        return DEVICE_ERR_WRONG_LENGTH;
    }
    if (capacity < content + 8u) {
        return DEVICE_ERR_CAPACITY;
    }
    device_move_up(data + SIZE, content, 8u - SIZE);
    device_store_u32_be(data, identifier);
    device_store_u32_be(data + 4u, (uint32_t)size << 24u);
    *length = content + 8u;
    return DEVICE_OK;
}

/** Turns the identifier of a CAN frame back into the first parts. */
static inline device_codec_status device_UNESCAPE(uint8_t *data, size_t *length, size_t head, size_t tail)
{
    static const uint8_t fields[ROWS][COLUMNS] = {
FIELDS
    };
    uint32_t identifier, number;
    uint32_t remote; /* if REMOTE */
    size_t offset = head, row, byte, size = *length - head - tail;
    uint8_t dlc;
    if (size < 8u || size > 16u) {
        return DEVICE_ERR_WRONG_MARK;
    }
    identifier = device_load_u32_be(data);
    remote = identifier & REMOTE; /* if REMOTE */
    dlc = data[4];
    if ((identifier & MASKED) != FLAGS || dlc > 8u || size != CONTENT + 8u
        || device_load_u32_be(data + 4u) != (uint32_t)dlc << 24u) {
        return DEVICE_ERR_WRONG_MARK;
    }
    for (row = 0; row < ROWS; row++) {
        number = (identifier >> fields[row][2]) & (((uint32_t)1u << fields[row][3]) - 1u);
        number |= remote & ((uint32_t)fields[row][4] << 24u); /* if REMOTE */
        for (byte = 0; byte < fields[row][0]; byte++) {
            data[offset + byte] =
                (uint8_t)(number >> (8u * (fields[row][1] != 0u ? byte : fields[row][0] - 1u - byte)));
        }
        offset += fields[row][0];
    }
    for (byte = 8u; byte < size; byte++) {
        data[byte + SIZE - 8u] = data[byte];
    }
    if (remote != 0u) { /* if REMOTE */
        data[offset] = dlc; /* if REMOTE */
        size++;         /* if REMOTE */
    }                   /* if REMOTE */
    *length = size + SIZE - 8u;
    return DEVICE_OK;
}
