static unsigned long passed, failed;
static void (*told)(const char *what);

static void expect(bool holds, const char *what)
{
    if (holds) {
        passed++;
    } else {
        failed++;
        told(what);
    }
}

static bool same_bytes(const void *left, const void *right, size_t size)
{
    const uint8_t *one = (const uint8_t *)left, *other = (const uint8_t *)right;
    size_t at;
    for (at = 0; at < size; at++) {
        if (one[at] != other[at]) {
            return false;
        }
    }
    return true;
}

static bool same_text(const char *left, const char *right)
{
    size_t at;
    for (at = 0; left[at] == right[at]; at++) {
        if (left[at] == '\0') {
            return true;
        }
    }
    return false;
}

/* Copies by volatile accesses: the compiler cannot know what is copied, so the code that follows runs when the test does. */
static void copy(void *to, const void *from, size_t size)
{
    volatile uint8_t *target = (uint8_t *)to;
    size_t at;
    for (at = 0; at < size; at++) {
        target[at] = ((const uint8_t *)from)[at];
    }
}

static void clear(void *what, size_t size)
{
    size_t at;
    for (at = 0; at < size; at++) {
        ((uint8_t *)what)[at] = 0;
    }
}
