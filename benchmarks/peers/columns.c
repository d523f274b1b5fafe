/* Telegram 111 by hand: many frames of 24 bytes to ten columns in the machine's order, and to records in it. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

static uint16_t u16(const unsigned char *at) { return (uint16_t)(at[0] << 8 | at[1]); }
static uint32_t u32(const unsigned char *at)
{
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

void columns(const unsigned char *restrict frames, size_t number, uint16_t *restrict status_1,
             uint16_t *restrict positioning_1, uint16_t *restrict positioning_2, uint16_t *restrict status_2,
             uint16_t *restrict message, int32_t *restrict position, int32_t *restrict speed, uint16_t *restrict fault,
             uint16_t *restrict warning)
{
    for (size_t at = 0; at < number; at++) {
        const unsigned char *frame = frames + 24 * at;
        status_1[at] = u16(frame);
        positioning_1[at] = u16(frame + 2);
        positioning_2[at] = u16(frame + 4);
        status_2[at] = u16(frame + 6);
        message[at] = u16(frame + 8);
        position[at] = (int32_t)u32(frame + 10);
        speed[at] = (int32_t)u32(frame + 14);
        fault[at] = u16(frame + 18);
        warning[at] = u16(frame + 20);
    }
}

void bits(const uint16_t *restrict words, size_t number, uint16_t mask, unsigned char *restrict held)
{
    for (size_t at = 0; at < number; at++)
        held[at] = (words[at] & mask) != 0;
}
