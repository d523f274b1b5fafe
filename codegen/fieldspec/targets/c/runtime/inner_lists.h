/* ---- inner_lists ---- */

/**
 * Writes the image of a list whose elements differ in size or tell whether others follow, unless `image` is NULL: as many
 * of them as have `size` bytes there, or all to the end, where that is SIZE_MAX. `*size` receives the bytes in the image,
 * `*read_size` those that were read.
 */
static inline device_codec_status device_take_elements(const device_inner_list *list, const uint8_t *in, size_t left,
        uint8_t *image, size_t *size, size_t *read_size)
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
    *read_size = from;
    return to < list->least ? DEVICE_ERR_INCOMPLETE : DEVICE_OK;
}

/**
 * The bytes of a list in the image, and those that were sent of it, which may be more than the `left` ones; the last list
 * ends with these. Writes the image of elements that differ in size or tell whether others follow.
 */
static inline device_codec_status device_take_list(const device_inner_list *list, const uint8_t *fields, const uint8_t *in,
        size_t left, bool is_last, uint8_t *image, size_t *size, size_t *read_size)
{
    device_codec_status status;
    *size = SIZE_MAX;
    *read_size = left;
    if (!device_is_count(fields + list->count_at, list->count_size, list->count_form)) {
        return DEVICE_ERR_UNKNOWN_VALUE;
    }
    if (list->follows != NULL || (list->element_size != NULL && list->decided_size != NULL)) {
        *size = device_first_element(list, fields);
    } else if (list->decided_size != NULL) {
        status = device_take_decided(list, fields, size);
        *read_size = *size;
        return status;
    } else if (list->counts_sent) {
        *read_size = device_measured_bytes(list, fields);
        if (*read_size == SIZE_MAX || (is_last && *read_size != left)) {
            return DEVICE_ERR_WRONG_MEASURE;
        }
        if (*read_size > left) {
            return DEVICE_OK;
        }
        status = device_take_elements(list, in, *read_size, image, size, read_size);
        return status == DEVICE_ERR_INCOMPLETE || status == DEVICE_ERR_WRONG_LENGTH ? DEVICE_ERR_WRONG_MEASURE : status;
    } else if (!is_last) {
        *size = device_list_size(list, fields);
        if (*size == SIZE_MAX) {
            return DEVICE_ERR_WRONG_MEASURE;
        }
    }
    if (list->element_size != NULL || list->follows != NULL) {
        return device_take_elements(list, in, left, image, size, read_size);
    }
    if (*size == SIZE_MAX && list->bits != 0u) {
        *size = 8u * left / list->bits * list->element;
        *size = *size < list->most ? *size : list->most;
        *read_size = device_list_bytes(list, *size);
        return *size < list->least ? DEVICE_ERR_INCOMPLETE : DEVICE_OK;
    }
    *size = *size == SIZE_MAX ? left : *size;
    *read_size = device_list_bytes(list, *size);
    return DEVICE_OK;
}

/**
 * The bytes of a record that some bytes begin with, maybe more than the `left` ones; 0 for a wrong count, SIZE_MAX where
 * a type is not known. `fields` has room for its `fixed` bytes of other fields.
 */
static inline size_t device_sent_size(const device_inner_list *lists, size_t count, size_t fixed, uint8_t *fields,
        const uint8_t *in, size_t left)
{
    size_t index, offset = 0, from = 0;
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        device_codec_status status;
        size_t size, read_size;
        if (left < from + (list->first - offset)) {
            break;
        }
        device_copy_bytes(fields + offset, in + from, list->first - offset);
        from += list->first - offset;
        offset = list->first;
        status = device_take_list(list, fields, in + from, left - from, false, NULL, &size, &read_size);
        if (status != DEVICE_OK) {
            return status == DEVICE_ERR_INCOMPLETE ? left + 1u : status == DEVICE_ERR_UNKNOWN_VALUE ? SIZE_MAX : 0u;
        }
        from += read_size;
        if (from > left) {
            break;
        }
    }
    return from + (fixed - offset);
}

/** Writes the image of a record with lists, whose other fields have `fixed` bytes. */
static inline device_codec_status device_take_lists(const device_inner_list *lists, size_t count, size_t fixed,
        const uint8_t *in, size_t length, uint8_t *image, size_t *image_length)
{
    size_t index, offset = 0, from = 0;
    device_codec_status result = DEVICE_OK;
    image[0] = 0u; /* compilers do not know that nothing counts a list before all fields */
    *image_length = fixed;
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        bool is_last = index + 1u == count;
        device_codec_status status;
        size_t left, size, read_size, rest;
        if (length - from < fixed - offset) {
            return DEVICE_ERR_INCOMPLETE;
        }
        device_copy_bytes(image + offset, in + from, list->first - offset);
        from += list->first - offset;
        offset = list->first;
        left = length - from - (fixed - offset);
        status = device_take_list(list, image, in + from, left, is_last, image + list->room, &size, &read_size);
        if (status != DEVICE_OK) {
            return status;
        }
        if (read_size > left) {
            return DEVICE_ERR_INCOMPLETE;
        }
        if (is_last && read_size < left) {
            return DEVICE_ERR_WRONG_LENGTH;
        }
        if (list->bits != 0u) {
            device_unpack_list(list, in + from, size, image + list->room);
        } else if (list->element_size == NULL && list->follows == NULL) {
            if (size > list->most) {
                return DEVICE_ERR_WRONG_LENGTH;
            }
            for (rest = size; list->decided_size != NULL && rest < list->most; rest++) {
                image[list->room + rest] = 0u;
            }
            device_copy_bytes(image + list->room, in + from, size);
            if (list->decided_size != NULL && list->decided_size(image) >= DEVICE_BYTES_OF) {
                image[list->room + size] = 1u;
            }
            if (list->decided_size != NULL && device_decides_text(list, image) && device_text_bytes(in + from, size) != size) {
                result = DEVICE_ERR_UNKNOWN_VALUE;
            }
            if (is_last && list->decided_size == NULL && (size < list->least || size % list->element != 0u)) {
                result = DEVICE_OK; /* the image refuses its wrong size */
            }
        }
        if (list->counts_sent) {
            device_store_list_number(list, image, list->decided_size != NULL ? 1u : size / list->element);
        }
        from += read_size;
        *image_length = list->room + (list->decided_size != NULL && list->follows == NULL ? list->most : size);
    }
    device_copy_bytes(image + offset, in + from, fixed - offset);
    return result;
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
        size = size < DEVICE_TEXT_OF ? size
                : size < DEVICE_BYTES_OF ? device_text_bytes(image, size & DEVICE_MOST_OF)
                : device_marked_bytes(image, (size & DEVICE_MOST_OF) + 1u);
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
    size_t index, offset = 0, to = 0, total = fixed;
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        size_t size = index + 1u < count ? device_list_size(list, image) : image_length - list->room;
        size_t own = device_place_list(list, image, size, NULL);
        uint32_t sent_size = (uint32_t)((long)own + list->sent_plus);
        if (list->counts_sent && list->mask == 0u
                && !device_store_count(NULL, list->count_size, list->count_form, sent_size)) {
            return DEVICE_ERR_OUT_OF_RANGE;
        }
        if (list->counts_sent && list->mask != 0u && device_measured_bytes(list, image) != own) {
            return DEVICE_ERR_WRONG_MEASURE;
        }
        total += own;
    }
    if (capacity < total) {
        return DEVICE_ERR_CAPACITY;
    }
    for (index = 0; index < count; index++) {
        const device_inner_list *list = &lists[index];
        size_t own, size = index + 1u < count ? device_list_size(list, image) : image_length - list->room;
        device_copy_bytes(out + to, image + offset, list->first - offset);
        to += list->first - offset;
        offset = list->first;
        own = device_place_list(list, image, size, out + to);
        if (list->counts_sent) {
            device_store_list_number(list, out + device_before(lists, index, image), (size_t)((long)own + list->sent_plus));
        }
        to += own;
    }
    device_copy_bytes(out + to, image + offset, fixed - offset);
    *length = total;
    return DEVICE_OK;
}
