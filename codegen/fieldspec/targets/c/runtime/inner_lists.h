/* ---- inner_lists ---- */

/**
 * The bytes of an element that some bytes begin with, maybe more than the `left` ones; 0 for a wrong count, SIZE_MAX where
 * a type is not known.
 */
typedef size_t (*device_element_size)(const uint8_t *in, size_t left);

/** The bytes of a field whose type another one decides, as an image says; SIZE_MAX where that decides nothing. */
typedef size_t (*device_decided_size)(const uint8_t *in);

/** 1 if another element of a list follows one, else 0. */
typedef size_t (*device_follows)(const uint8_t *in);

/**
 * A list with fields after it, which begins after `first` bytes of other fields, and at `room` in the image of its
 * record: there all lists come last, each with room for all elements. It has `least` to `most` bytes, `element` for each
 * element. At `count_at` in the image, in `count_size` bytes, is the number of units of `unit` bytes, plus `plus`; where
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
    bool is_little;
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

/** The number in some bytes at `count_at`. */
static inline uint32_t device_list_number(const device_inner_list *list, const uint8_t *image)
{
    const uint8_t *count = image + list->count_at;
    uint32_t number = 0u;
    size_t index;
    for (index = 0; index < list->count_size; index++) {
        number = number << 8 | count[list->is_little ? list->count_size - 1u - index : index];
    }
    return number;
}

/** Writes a number to the bytes at `count_at`. */
static inline void device_store_list_number(const device_inner_list *list, uint8_t *image, size_t number)
{
    uint8_t *count = image + list->count_at;
    size_t index;
    for (index = 0; index < list->count_size; index++) {
        count[list->is_little ? index : list->count_size - 1u - index] = (uint8_t)(number >> 8u * index);
    }
}

/** The sent bytes of elements that differ in size, as a number in sent bytes says; SIZE_MAX for one that cannot be right. */
static inline size_t device_measured_bytes(const device_inner_list *list, const uint8_t *fields)
{
    long size = (long)device_list_number(list, fields) - list->sent_plus;
    return size < 0 || (unsigned long)size > list->most ? SIZE_MAX : (size_t)size;
}

/** The elements of a list with a first one, in an image with room for at most some of them. */
static inline size_t device_count_elements(device_follows follows, const uint8_t *image, size_t element, size_t most)
{
    size_t count = 1u;
    while (count < most && follows(image + (count - 1u) * element) != 0u) {
        count++;
    }
    return count;
}

/** The bytes of the first element of a list whose elements tell whether others follow; 0 if there is none. */
static inline size_t device_first_element(const device_inner_list *list, const uint8_t *image)
{
    return list->decided_size != NULL && list->decided_size(image) == 0u ? 0u : list->element;
}

/** The bytes of a list, as its count in an image says; SIZE_MAX for a count that cannot be right. */
static inline size_t device_list_size(const device_inner_list *list, const uint8_t *image)
{
    uint32_t bits = device_list_number(list, image);
    size_t number, size;
    if (list->follows != NULL) {
        size = device_first_element(list, image);
        number = list->most / list->element;
        return size == 0u ? 0u : device_count_elements(list->follows, image + list->room, size, number) * size;
    }
    if (list->count_size == 0u) {
        return list->most;
    }
    number = (size_t)(list->mask == 0u ? bits : (bits & list->mask) / (list->mask & (0u - list->mask)));
    if (list->plus > 0 && number < (size_t)list->plus) {
        return SIZE_MAX;
    }
    size = (list->plus < 0 ? number + (size_t)-list->plus : number - (size_t)list->plus) * list->unit;
    return size < list->least || size > list->most || size % list->element != 0u ? SIZE_MAX : size;
}

static inline void device_copy_bytes(uint8_t *to, const uint8_t *from, size_t size)
{
    size_t at;
    for (at = 0; at < size; at++) {
        to[at] = from[at];
    }
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

/**
 * Writes the image of a list whose elements differ in size or tell whether others follow, unless `image` is NULL: as many
 * of them as have `size` bytes there, or all to the end, where that is SIZE_MAX. `*size` receives the bytes in the image,
 * `*taken` those that were read.
 */
static inline device_codec_status device_take_elements(const device_inner_list *list, const uint8_t *in, size_t left,
        uint8_t *image, size_t *size, size_t *taken)
{
    size_t from = 0, to = 0;
    while (*size == SIZE_MAX ? from < left : to < *size) {
        size_t own;
        if (to == list->most) {
            return DEVICE_ERR_WRONG_LENGTH;
        }
        own = list->element_size == NULL ? list->element : list->element_size(in + from, left - from);
        if (own == 0u || own == SIZE_MAX) {
            return own == 0u ? DEVICE_ERR_WRONG_MEASURE : DEVICE_ERR_UNKNOWN_VALUE;
        }
        if (own > left - from) {
            return DEVICE_ERR_INCOMPLETE;
        }
        if (image != NULL) {
            device_copy_bytes(image + to, in + from, own);
        }
        if (list->follows != NULL && list->follows(in + from) != 0u) {
            if (*size == list->most) {
                return DEVICE_ERR_WRONG_MEASURE;
            }
            *size += list->element;
        }
        from += own;
        to += list->element;
    }
    *size = to;
    *taken = from;
    return to < list->least ? DEVICE_ERR_INCOMPLETE : DEVICE_OK;
}

/** The same of elements that are all of the `measured` bytes: a list that ends otherwise has a wrong number. */
static inline device_codec_status device_take_measured(const device_inner_list *list, const uint8_t *in, size_t measured,
        uint8_t *image, size_t *size, size_t *taken)
{
    device_codec_status status;
    *size = SIZE_MAX;
    status = device_take_elements(list, in, measured, image, size, taken);
    return status == DEVICE_ERR_INCOMPLETE || status == DEVICE_ERR_WRONG_LENGTH ? DEVICE_ERR_WRONG_MEASURE : status;
}

/**
 * The bytes of a record that some bytes begin with, maybe more than the `left` ones; 0 for a wrong count, SIZE_MAX where
 * a type is not known. `fields` has room for its `fixed` bytes of other fields.
 */
static inline size_t device_sent_size(const device_inner_list *lists, size_t count, size_t fixed, uint8_t *fields,
        const uint8_t *in, size_t left)
{
    size_t index, at = 0, from = 0;
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        size_t size, taken;
        if (left < from + (list->first - at)) {
            break;
        }
        device_copy_bytes(fields + at, in + from, list->first - at);
        from += list->first - at;
        at = list->first;
        if (list->follows != NULL) {
            size = device_first_element(list, fields);
        } else {
            size = list->decided_size != NULL ? list->decided_size(fields)
                    : list->counts_sent ? device_measured_bytes(list, fields) : device_list_size(list, fields);
        }
        taken = size;
        if (size == SIZE_MAX) {
            return list->decided_size != NULL ? SIZE_MAX : 0u;
        }
        if ((list->element_size != NULL || list->follows != NULL) && (!list->counts_sent || size <= left - from)) {
            device_codec_status status = list->counts_sent
                    ? device_take_measured(list, in + from, size, NULL, &size, &taken)
                    : device_take_elements(list, in + from, left - from, NULL, &size, &taken);
            if (status != DEVICE_OK) {
                return status == DEVICE_ERR_INCOMPLETE ? left + 1u : status == DEVICE_ERR_UNKNOWN_VALUE ? SIZE_MAX : 0u;
            }
        } else {
            taken = device_list_bytes(list, size);
        }
        from += taken;
        if (from > left) {
            break;
        }
    }
    return from + (fixed - at);
}

/** Writes the image of a record with lists, whose other fields have `fixed` bytes. */
static inline device_codec_status device_take_lists(const device_inner_list *lists, size_t count, size_t fixed,
        const uint8_t *in, size_t length, uint8_t *image, size_t *image_length)
{
    size_t index, at = 0, from = 0;
    *image_length = fixed;
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        size_t left, size = SIZE_MAX, taken;
        if (length - from < fixed - at) {
            return DEVICE_ERR_INCOMPLETE;
        }
        device_copy_bytes(image + at, in + from, list->first - at);
        from += list->first - at;
        at = list->first;
        left = length - from - (fixed - at);
        if (list->follows != NULL) {
            size = device_first_element(list, image);
        } else if (list->decided_size != NULL) {
            size = list->decided_size(image);
            if (size == SIZE_MAX) {
                return DEVICE_ERR_UNKNOWN_VALUE;
            }
            if (index + 1u == count && size < left) {
                return DEVICE_ERR_WRONG_LENGTH;
            }
        } else if (list->counts_sent) {
            size_t measured = device_measured_bytes(list, image);
            if (measured == SIZE_MAX || (index + 1u == count && measured != left)) {
                return DEVICE_ERR_WRONG_MEASURE;
            }
            if (measured > left) {
                return DEVICE_ERR_INCOMPLETE;
            }
            left = measured;
        } else if (index + 1u < count) {
            size = device_list_size(list, image);
            if (size == SIZE_MAX) {
                return DEVICE_ERR_WRONG_MEASURE;
            }
        }
        if (list->element_size != NULL || list->follows != NULL) {
            device_codec_status status = list->counts_sent
                    ? device_take_measured(list, in + from, left, image + list->room, &size, &taken)
                    : device_take_elements(list, in + from, left, image + list->room, &size, &taken);
            if (status != DEVICE_OK) {
                return status;
            }
            if (index + 1u == count && taken < left) {
                return DEVICE_ERR_WRONG_LENGTH;
            }
            if (list->counts_sent) {
                device_store_list_number(list, image, size / list->element);
            }
        } else if (list->bits != 0u) {
            size_t numbers = 8u * left / list->bits;
            if (size == SIZE_MAX) {
                size = numbers * list->element < list->most ? numbers * list->element : list->most;
                if (size < list->least || device_list_bytes(list, size) < left) {
                    return size < list->least ? DEVICE_ERR_INCOMPLETE : DEVICE_ERR_WRONG_LENGTH;
                }
            }
            taken = device_list_bytes(list, size);
            if (taken > left) {
                return DEVICE_ERR_INCOMPLETE;
            }
            device_unpack_list(list, in + from, size, image + list->room);
        } else {
            if (size != SIZE_MAX && size > left) {
                return DEVICE_ERR_INCOMPLETE;
            }
            size = size == SIZE_MAX ? left : size;
            if (size > list->most) {
                return DEVICE_ERR_WRONG_LENGTH;
            }
            device_copy_bytes(image + list->room, in + from, size);
            taken = size;
        }
        from += taken;
        *image_length = list->room + (list->decided_size != NULL && list->follows == NULL ? list->most : size);
    }
    device_copy_bytes(image + at, in + from, fixed - at);
    return DEVICE_OK;
}

/**
 * Writes what is sent of a list that has `size` bytes in an image, unless `out` is NULL; the number of these bytes. The
 * fields of its record are at `fields`.
 */
static inline size_t device_place_list(const device_inner_list *list, const uint8_t *fields, size_t size, uint8_t *out)
{
    const uint8_t *image = fields + list->room;
    size_t from, to = 0;
    if (list->decided_size != NULL && list->follows == NULL) {
        size = list->decided_size(fields);
    }
    if (list->bits != 0u) {
        if (out != NULL) {
            device_pack_list(list, image, size, out);
        }
        return device_list_bytes(list, size);
    }
    if (list->element_size == NULL) {
        if (out != NULL) {
            device_copy_bytes(out, image, size);
        }
        return size;
    }
    for (from = 0; from < size; from += list->element) {
        size_t own = list->element_size(image + from, list->element);
        if (out != NULL) {
            device_copy_bytes(out + to, image + from, own);
        }
        to += own;
    }
    return to;
}

/** The bytes of lists that are sent before the number of the list at an `index`. */
static inline size_t device_before(const device_inner_list *lists, size_t index, const uint8_t *image)
{
    size_t other, size = 0;
    for (other = 0; other < index; other++) {
        if (lists[other].first <= lists[index].count_at) {
            size += device_place_list(&lists[other], image, device_list_size(&lists[other], image), NULL);
        }
    }
    return size;
}

/** Writes what is sent of the image of a record with lists. */
static inline device_codec_status device_place_lists(const device_inner_list *lists, size_t count, size_t fixed,
        const uint8_t *image, size_t image_length, uint8_t *out, size_t capacity, size_t *length)
{
    size_t index, at = 0, to = 0, total = fixed;
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        size_t size = index + 1u < count ? device_list_size(list, image) : image_length - list->room;
        size_t own = device_place_list(list, image, size, NULL);
        if (list->counts_sent && (unsigned long)((long)own + list->sent_plus) >> 8u * list->count_size != 0u) {
            return DEVICE_ERR_OUT_OF_RANGE;
        }
        total += own;
    }
    if (capacity < total) {
        return DEVICE_ERR_CAPACITY;
    }
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        size_t own, size = index + 1u < count ? device_list_size(list, image) : image_length - list->room;
        device_copy_bytes(out + to, image + at, list->first - at);
        to += list->first - at;
        at = list->first;
        own = device_place_list(list, image, size, out + to);
        if (list->counts_sent) {
            device_store_list_number(list, out + device_before(lists, index, image), (size_t)((long)own + list->sent_plus));
        }
        to += own;
    }
    device_copy_bytes(out + to, image + at, fixed - at);
    *length = total;
    return DEVICE_OK;
}
