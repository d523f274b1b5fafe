/* ---- inner_lists ---- */

/** Writes the image of a record with a list that begins at `first` and that `behind` bytes follow: there it comes last. */
static inline void device_take_list(const uint8_t *in, size_t length, size_t first, size_t behind, uint8_t *out)
{
    size_t at, room = length < first + behind ? 0u : length - first - behind;
    for (at = 0; at < length; at++) {
        size_t from = at;
        if (length >= first + behind && at >= first) {
            from = at < first + behind ? at + room : at - behind;
        }
        out[at] = in[from];
    }
}

/** Turns bytes around. */
static inline void device_turn(uint8_t *bytes, size_t length)
{
    size_t at;
    for (at = 0; at < length / 2u; at++) {
        uint8_t byte = bytes[at];
        bytes[at] = bytes[length - 1u - at];
        bytes[length - 1u - at] = byte;
    }
}

/** Moves the list in the image of a record to where it is sent. */
static inline void device_place_list(uint8_t *bytes, size_t length, size_t first, size_t behind)
{
    device_turn(bytes + first, behind);
    device_turn(bytes + first + behind, length - first - behind);
    device_turn(bytes + first, length - first);
}
