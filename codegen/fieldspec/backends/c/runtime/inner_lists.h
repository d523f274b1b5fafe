/* ---- inner_lists ---- */

/**
 * A list with fields behind it, which begins behind `first` bytes of other fields, and at `room` in the image of its
 * record: there all lists come last, each with room for all elements. It has `least` to `most` bytes, `element` for each
 * element. At `count_at` in the image, in one byte or in two, is the number of units of `unit` bytes, plus `plus`; a
 * `count_size` of 0 is that of the list whose size the data decide.
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
} device_inner_list;

/** The bytes of a list, as its count in an image says; SIZE_MAX for a count below the least one. */
static inline size_t device_list_size(const device_inner_list *list, const uint8_t *image)
{
    const uint8_t *count = image + list->count_at;
    size_t number = count[0];
    if (list->count_size > 1u) {
        number = list->is_little ? number + count[1] * 256u : number * 256u + count[1];
    }
    if (list->plus > 0 && number < (size_t)list->plus) {
        return SIZE_MAX;
    }
    return (list->plus < 0 ? number + (size_t)-list->plus : number - (size_t)list->plus) * list->unit;
}

static inline void device_copy_bytes(uint8_t *to, const uint8_t *from, size_t size)
{
    size_t at;
    for (at = 0; at < size; at++) {
        to[at] = from[at];
    }
}

/** Writes the image of a record with lists, whose other fields have `fixed` bytes. */
static inline device_codec_status device_take_lists(const device_inner_list *lists, size_t count, size_t fixed,
        const uint8_t *in, size_t length, uint8_t *image, size_t *image_length)
{
    size_t index, at = 0, from = 0;
    *image_length = fixed;
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        size_t size;
        if (length - from < fixed - at) {
            return DEVICE_ERR_INCOMPLETE;
        }
        device_copy_bytes(image + at, in + from, list->first - at);
        from += list->first - at;
        at = list->first;
        size = length - from - (fixed - at);
        if (list->count_size != 0u) {
            size_t left = size;
            size = device_list_size(list, image);
            if (size < list->least || size > list->most || size % list->element != 0u) {
                return DEVICE_ERR_WRONG_MEASURE;
            }
            if (size > left) {
                return DEVICE_ERR_INCOMPLETE;
            }
        } else if (size > list->most) {
            return DEVICE_ERR_WRONG_LENGTH;
        }
        device_copy_bytes(image + list->room, in + from, size);
        from += size;
        *image_length = list->room + size;
    }
    device_copy_bytes(image + at, in + from, fixed - at);
    return DEVICE_OK;
}

/** Writes what is sent of the image of a record with lists. */
static inline device_codec_status device_place_lists(const device_inner_list *lists, size_t count, size_t fixed,
        const uint8_t *image, size_t image_length, uint8_t *out, size_t capacity, size_t *length)
{
    size_t index, at = 0, to = 0, total = fixed;
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        total += list->count_size != 0u ? device_list_size(list, image) : image_length - list->room;
    }
    if (capacity < total) {
        return DEVICE_ERR_CAPACITY;
    }
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        size_t size = list->count_size != 0u ? device_list_size(list, image) : image_length - list->room;
        device_copy_bytes(out + to, image + at, list->first - at);
        to += list->first - at;
        at = list->first;
        device_copy_bytes(out + to, image + list->room, size);
        to += size;
    }
    device_copy_bytes(out + to, image + at, fixed - at);
    *length = total;
    return DEVICE_OK;
}
