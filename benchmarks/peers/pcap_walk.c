/* The words of all answers to reads of registers in a capture of Modbus TCP, added up: a loop over the bytes of the file. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint32_t word_at(const uint8_t *at) { return (uint32_t)(at[0] << 8 | at[1]); }

int main(int count, char **arguments)
{
    FILE *file = count == 2 ? fopen(arguments[1], "rb") : NULL;
    if (file == NULL || fseek(file, 0, SEEK_END) != 0) return 1;
    size_t size = (size_t)ftell(file);
    rewind(file);
    uint8_t *data = malloc(size);
    if (data == NULL || fread(data, 1, size, file) != size) return 1;
    uint64_t sum = 0, frames = 0;
    for (size_t at = 24; at + 16 <= size;) {
        uint32_t length;
        memcpy(&length, data + at + 8, 4);
        const uint8_t *packet = data + at + 16;
        at += 16 + length;
        if (at > size || length < 62 || word_at(packet + 12) != 0x0800 || packet[23] != 6) continue;
        const uint8_t *tcp = packet + 14 + (packet[14] & 15) * 4;
        const uint8_t *frame = tcp + (tcp[12] >> 4) * 4;
        frames++;
        if (word_at(tcp) == 502 && frame[7] == 4)
            for (int word = 0; word < frame[8] / 2; word++) sum += word_at(frame + 9 + 2 * word);
    }
    printf("%llu frames, sum %llu\n", (unsigned long long)frames, (unsigned long long)sum);
    return 0;
}
