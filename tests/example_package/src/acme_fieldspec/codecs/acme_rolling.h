/** The sum of some bytes, turned by three bits before each. */
static inline uint16_t device_acme_rolling_checksum(const uint8_t *in, size_t size)
{
    uint32_t total = 0x5AA5u;
    size_t at;
    for (at = 0; at < size; at++) {
        total = ((total << 3) | (total >> 13)) & 0xFFFFu;
        total = (total + in[at]) & 0xFFFFu;
    }
    return (uint16_t)total;
}
