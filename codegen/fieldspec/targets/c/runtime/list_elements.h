/* ---- list_elements ---- */

/**
 * The bytes of an element that some bytes begin with, maybe more than the `left` ones; 0 for a wrong count, SIZE_MAX where
 * a type is not known.
 */
typedef size_t (*device_element_size)(const uint8_t *in, size_t left);

/** In a number of bytes: they are those of a text at most, or of bytes, which a number in the record counts. */
#define DEVICE_TEXT_OF ((size_t)1 << (8u * sizeof(size_t) - 1u))
#define DEVICE_BYTES_OF (DEVICE_TEXT_OF + DEVICE_TEXT_OF / 2u)
#define DEVICE_MOST_OF (DEVICE_TEXT_OF / 2u - 1u)

/** The bytes of a field whose type another one decides, as an image says; SIZE_MAX where that decides nothing. */
typedef size_t (*device_decided_size)(const uint8_t *in);

/** 1 if another element of a list follows one, else 0. */
typedef size_t (*device_follows)(const uint8_t *in);

/**
 * A list with fields after it, which begins after `first` bytes of other fields, and at `room` in the image of its
 * record: there all lists come last, each with room for all elements. It has `least` to `most` bytes, `element` for each
 * element. At `count_at` in the image, in `count_size` bytes of a form, is the number of units of `unit` bytes, plus `plus`; where
 * `mask` is not 0, in these bits. A `count_size` of 0 is that of a list that always has `most` bytes. The data decide the
 * size of the last one.
 * `element_size` is NULL where all elements have the same size, or `decided_size` tells that of the only element; with
 * `follows`, that of the first element, and each element tells whether another one follows, wherever the list is. Numbers
 * of `bits` bits are packed, from the highest bit or where they are `low_first` from the lowest; it is 0 for whole bytes.
 * Where it `counts_sent` bytes, the number at `count_at` is that of elements only in the image: what is sent is the
 * number of their sent bytes, plus `sent_plus`.
 */
typedef struct device_inner_list {
    size_t first;
    size_t room;
    size_t element;
    size_t least;
    size_t most;
    size_t count_at;
    size_t count_size;
    size_t unit;
    long plus;
    uint8_t count_form;
    uint32_t mask;
    device_element_size element_size;
    device_decided_size decided_size;
    device_follows follows;
    size_t bits;
    bool is_low_first;
    bool is_signed;
    bool counts_sent;
    long sent_plus;
} device_inner_list;

/** Writes a number to the bytes at `count_at`, of which no bits count. */
static inline void device_store_list_number(const device_inner_list *list, uint8_t *image, size_t number)
{
    if (list->mask == 0u) {
        device_store_count(image + list->count_at, list->count_size, list->count_form, (uint32_t)number);
    }
}

/** The number in some bytes at `count_at`, or in the bits of it that count the list. */
static inline uint32_t device_list_count(const device_inner_list *list, const uint8_t *image)
{
    uint32_t number = device_load_count(image + list->count_at, list->count_size, list->count_form);
    return list->mask == 0u ? number : (number & list->mask) / (list->mask & (0u - list->mask));
}

/** The sent bytes of elements that differ in size, as a number in sent bytes says; SIZE_MAX for one that cannot be right. */
static inline size_t device_measured_bytes(const device_inner_list *list, const uint8_t *fields)
{
    long size = (long)device_list_count(list, fields) - list->sent_plus;
    return size < 0 || (unsigned long)size > list->most ? SIZE_MAX : (size_t)size;
}

/** Whether the type that another field decides is a text, whose bytes a number counts. */
static inline bool device_decides_text(const device_inner_list *list, const uint8_t *fields)
{
    size_t size = list->decided_size(fields);
    return size >= DEVICE_TEXT_OF && size < DEVICE_BYTES_OF;
}

/** The sent bytes of a field whose type another one decides, as sent fields say. */
static inline device_codec_status device_take_decided(const device_inner_list *list, const uint8_t *fields, size_t *size)
{
    size_t measured = device_measured_bytes(list, fields);
    *size = list->decided_size(fields);
    if (*size == SIZE_MAX) {
        return DEVICE_ERR_UNKNOWN_VALUE;
    }
    if (!list->counts_sent) {
        return DEVICE_OK;
    }
    if (*size >= DEVICE_TEXT_OF ? measured > (*size & DEVICE_MOST_OF) : measured != *size) {
        return DEVICE_ERR_WRONG_MEASURE;
    }
    *size = measured;
    return DEVICE_OK;
}

/** The elements of a list with a first one, in an image with room for at most some of them. */
static inline size_t device_count_elements(device_follows follows, const uint8_t *image, size_t element, size_t maximum)
{
    size_t count = 1u;
    while (count < maximum && follows(image + (count - 1u) * element) != 0u) {
        count++;
    }
    return count;
}

/**
 * The bytes of the first element of a list whose elements tell whether others follow, or of an optional record that
 * varies in size; 0 if there is none.
 */
static inline size_t device_first_element(const device_inner_list *list, const uint8_t *image)
{
    return list->decided_size != NULL && list->decided_size(image) == 0u ? 0u : list->element;
}

/** The bytes of a list, as its count in an image says; SIZE_MAX for a count that cannot be right. */
static inline size_t device_list_size(const device_inner_list *list, const uint8_t *image)
{
    size_t number, size;
    uint32_t counted;
    if (list->follows != NULL) {
        size = device_first_element(list, image);
        number = list->most / list->element;
        return size == 0u ? 0u : device_count_elements(list->follows, image + list->room, size, number) * size;
    }
    if (list->count_size == 0u || list->decided_size != NULL) {
        return list->most;
    }
    counted = device_list_count(list, image);
    if (list->plus > 0 && counted < (uint32_t)list->plus) {
        return SIZE_MAX;
    }
    if (counted > list->most + (list->plus > 0 ? (uint32_t)list->plus : 0u)) {
        return SIZE_MAX;
    }
    number = (size_t)counted;
    size = (list->plus < 0 ? number + (size_t)-list->plus : number - (size_t)list->plus) * list->unit;
    return size < list->least || size > list->most || size % list->element != 0u ? SIZE_MAX : size;
}

static inline void device_copy_bytes(uint8_t *to, const uint8_t *from, size_t size)
{
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        to[offset] = from[offset];
    }
}

/** The bytes before the mark of bytes of varying length, which zeros follow. */
static inline size_t device_marked_bytes(const uint8_t *image, size_t size)
{
    while (size > 0u && image[size - 1u] == 0u) {
        size--;
    }
    return size == 0u ? 0u : size - 1u;
}

/** Reads bytes of varying length from `size` bytes of an image; the number of them. */
static inline size_t device_load_marked(uint8_t *data, const uint8_t *image, size_t size)
{
    size_t count = device_marked_bytes(image, size);
    device_copy_bytes(data, image, count);
    return count;
}

/** Writes bytes of varying length with the mark into `size` bytes of an image. */
static inline void device_store_marked(uint8_t *image, const uint8_t *data, size_t count, size_t size)
{
    size_t offset;
    device_copy_bytes(image, data, count);
    for (offset = count; offset < size; offset++) {
        image[offset] = offset == count ? 1u : 0u;
    }
}

/** The bytes of a text before the first zero. */
static inline size_t device_text_bytes(const uint8_t *text, size_t maximum)
{
    size_t size = 0;
    while (size < maximum && text[size] != 0u) {
        size++;
    }
    return size;
}

/** The bytes that are sent for `size` bytes of the image of a list, of elements that do not differ in size. */
static inline size_t device_list_bytes(const device_inner_list *list, size_t size)
{
    return list->bits == 0u ? size : (size / list->element * list->bits + 7u) / 8u;
}

/** Writes the image of packed numbers that has `size` bytes. */
static inline void device_unpack_list(const device_inner_list *list, const uint8_t *in, size_t size, uint8_t *image)
{
    size_t index, bit, place = 0;
    for (index = 0; index < size; index += list->element) {
        uint32_t number = 0u;
        for (bit = 0; bit < list->bits; bit++, place++) {
            size_t own = list->is_low_first ? bit : list->bits - 1u - bit;
            size_t shift = list->is_low_first ? place % 8u : 7u - place % 8u;
            number |= (uint32_t)((in[place / 8u] >> shift) & 1) << own;
        }
        if (list->is_signed && (number >> (list->bits - 1u)) != 0u) {
            number |= UINT32_MAX << list->bits;
        }
        for (bit = 0; bit < list->element; bit++) {
            image[index + (list->is_low_first ? bit : list->element - 1u - bit)] = (uint8_t)(number >> 8u * bit);
        }
    }
}

/** Writes what is sent of the image of packed numbers, which has `size` bytes. */
static inline void device_pack_list(const device_inner_list *list, const uint8_t *image, size_t size, uint8_t *out)
{
    size_t index, bit, place = 0;
    for (index = 0; index < device_list_bytes(list, size); index++) {
        out[index] = 0u;
    }
    for (index = 0; index < size; index += list->element) {
        for (bit = 0; bit < list->bits; bit++, place++) {
            size_t own = list->is_low_first ? bit : list->bits - 1u - bit;
            size_t from = index + (list->is_low_first ? own / 8u : list->element - 1u - own / 8u);
            size_t shift = list->is_low_first ? place % 8u : 7u - place % 8u;
            out[place / 8u] = (uint8_t)(out[place / 8u] | ((image[from] >> own % 8u) & 1) << shift);
        }
    }
}
