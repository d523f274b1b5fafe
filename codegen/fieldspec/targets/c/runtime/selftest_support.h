static unsigned long passed, failed;
static void (*told)(const char *name);

static void expect(bool holds, const char *name)
{
    if (holds) {
        passed++;
    } else {
        failed++;
        told(name);
    }
}

static bool same_bytes(const void *left, const void *right, size_t size)
{
    const uint8_t *one = (const uint8_t *)left, *other = (const uint8_t *)right;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        if (one[offset] != other[offset]) {
            return false;
        }
    }
    return true;
}

static bool same_text(const char *left, const char *right)
{
    size_t offset;
    for (offset = 0; left[offset] == right[offset]; offset++) {
        if (left[offset] == '\0') {
            return true;
        }
    }
    return false;
}

/* Copies by volatile accesses: the compiler cannot know what is copied, so the code that follows runs when the test does. */
static void copy(void *to, const void *from, size_t size)
{
    volatile uint8_t *target = (uint8_t *)to;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        target[offset] = ((const uint8_t *)from)[offset];
    }
}

static void clear(void *data, size_t size)
{
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        ((uint8_t *)data)[offset] = 0;
    }
}
