/*
 * TC100 (TOYO), version 2.0
 * From: TC100 series operation manual V.2001
 * Identity: 8f5fd7b11e77b14b
 *
 * Generated; do not edit. For C99 and later and C++98 to C++20, hosted or freestanding, with any byte order, any alignment and an
 * int of 16 bits or more. Headers from this generator compile without warnings with gcc and clang, and pass cppcheck. Their
 * self-tests pass on x86-64, AArch64, m68k (big-endian; int of 32 and 16 bits) and Cortex-M0, and under sanitizers; their fuzz
 * targets find nothing.
 *
 * Define before you include it:
 *   TC100_WITH_TEXTS adds the texts of codes, which take memory
 *   TC100_WIDE_CRC_TABLE takes a table of 512 bytes for a faster CRC
 */
#include "tc100_v2_0_constants.h"
#ifndef TC100_INCLUDED
#define TC100_INCLUDED

/* ---- Compilers and machines ---- */

#ifdef __GNUC__
/** A call would take more code than the function itself, even with -Os. */
#define TC100_INLINE static inline __attribute__((always_inline))
#define TC100_LIKELY(test) __builtin_expect(!!(test), 1)
/** Built-in functions need no string.h, and no call for a few bytes, also in freestanding code. */
#define TC100_COPY(to, from, size) __builtin_memcpy((to), (from), (size))
#define TC100_CLEAR(to, size) __builtin_memset((to), 0, (size))
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ && \
    (defined(__x86_64__) || defined(__i386__) || defined(__aarch64__) || defined(__ARM_FEATURE_UNALIGNED))
/**
 * Store a number with one instruction. Compilers merge loads of single bytes by themselves, and mostly stores
 * too. Where they may reorder stores, they build vectors instead, which take up to four times as long.
 */
#define TC100_STORES_AT_ONCE
#endif
#else
#include <string.h>
#define TC100_INLINE static inline
#define TC100_LIKELY(test) (test)
#define TC100_COPY(to, from, size) memcpy((to), (from), (size))
#define TC100_CLEAR(to, size) memset((to), 0, (size))
#endif

/* ---- Results of codec calls ---- */

/** The result of a codec call. */
typedef enum tc100_codec_status {
    TC100_OK = 0, /**< No error. */
    TC100_ERR_INCOMPLETE = 1, /**< There are too few bytes. */
    TC100_ERR_WRONG_LENGTH = 2, /**< The number of bytes or elements is wrong. */
    TC100_ERR_WRONG_MARK = 3, /**< A delimiter of the frame is missing or wrong. */
    TC100_ERR_NOT_HEX = 4, /**< A character is not a hexadecimal digit. */
    TC100_ERR_WRONG_CHECKSUM = 5, /**< The checksum does not match. */
    TC100_ERR_UNKNOWN_CODE = 6, /**< No message has this code. */
    TC100_ERR_UNKNOWN_VALUE = 7, /**< The value is not a member of its enum, or the text is not ASCII. */
    TC100_ERR_WRONG_CONST = 8, /**< A constant field has another value. */
    TC100_ERR_WRONG_MEASURE = 9, /**< A length or count field does not match the data. */
    TC100_ERR_OUT_OF_RANGE = 10, /**< A value is out of range. */
    TC100_ERR_CAPACITY = 11 /**< The buffer is too small. */
} tc100_codec_status;

/* ---- Numbers and characters ---- */

TC100_INLINE uint8_t tc100_load_u8(const uint8_t *in)
{
    return in[0];
}

TC100_INLINE void tc100_store_u8(uint8_t *out, uint8_t value)
{
    out[0] = value;
}

TC100_INLINE uint16_t tc100_load_u16_be(const uint8_t *in)
{
    return (uint16_t)(((uint32_t)in[0] << 8) | (uint32_t)in[1]);
}

TC100_INLINE void tc100_store_u16_be(uint8_t *out, uint16_t value)
{
#ifdef TC100_STORES_AT_ONCE
    value = __builtin_bswap16(value);
    TC100_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)(value >> 8);
    out[1] = (uint8_t)value;
#endif
}

TC100_INLINE uint16_t tc100_load_u16_le(const uint8_t *in)
{
    return (uint16_t)((uint32_t)in[0] | ((uint32_t)in[1] << 8));
}

TC100_INLINE void tc100_store_u16_le(uint8_t *out, uint16_t value)
{
#ifdef TC100_STORES_AT_ONCE
    TC100_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)value;
    out[1] = (uint8_t)(value >> 8);
#endif
}

TC100_INLINE uint32_t tc100_load_u32_be(const uint8_t *in)
{
    return ((uint32_t)in[0] << 24) | ((uint32_t)in[1] << 16) |
           ((uint32_t)in[2] << 8) | (uint32_t)in[3];
}

TC100_INLINE void tc100_store_u32_be(uint8_t *out, uint32_t value)
{
#ifdef TC100_STORES_AT_ONCE
    value = __builtin_bswap32(value);
    TC100_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)(value >> 24);
    out[1] = (uint8_t)(value >> 16);
    out[2] = (uint8_t)(value >> 8);
    out[3] = (uint8_t)value;
#endif
}

TC100_INLINE uint64_t tc100_load_u64_be(const uint8_t *in)
{
    return ((uint64_t)in[0] << 56) | ((uint64_t)in[1] << 48) |
           ((uint64_t)in[2] << 40) | ((uint64_t)in[3] << 32) |
           ((uint64_t)in[4] << 24) | ((uint64_t)in[5] << 16) |
           ((uint64_t)in[6] << 8) | (uint64_t)in[7];
}

TC100_INLINE void tc100_store_u64_be(uint8_t *out, uint64_t value)
{
#ifdef TC100_STORES_AT_ONCE
    value = __builtin_bswap64(value);
    TC100_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)(value >> 56);
    out[1] = (uint8_t)(value >> 48);
    out[2] = (uint8_t)(value >> 40);
    out[3] = (uint8_t)(value >> 32);
    out[4] = (uint8_t)(value >> 24);
    out[5] = (uint8_t)(value >> 16);
    out[6] = (uint8_t)(value >> 8);
    out[7] = (uint8_t)value;
#endif
}

TC100_INLINE int8_t tc100_signed_8(uint8_t raw)
{
    return (int8_t)((raw & 0x80u) ? -(int32_t)(uint8_t)~raw - 1 : (int32_t)raw);
}

TC100_INLINE int16_t tc100_signed_16(uint16_t raw)
{
    return (int16_t)((raw & 0x8000u) ? -(int32_t)(uint16_t)~raw - 1 : (int32_t)raw);
}

TC100_INLINE int32_t tc100_signed_32(uint32_t raw)
{
    return (int32_t)((raw & 0x80000000u) ? -(int32_t)(uint32_t)~raw - 1 : (int32_t)raw);
}

TC100_INLINE int64_t tc100_signed_64(uint64_t raw)
{
    return (int64_t)((raw & UINT64_C(0x8000000000000000)) ? -(int64_t)(uint64_t)~raw - 1 : (int64_t)raw);
}

static inline bool tc100_is_ascii(const uint8_t *in, size_t size)
{
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        if (in[offset] > 127u) {
            return false;
        }
    }
    return true;
}

/** Whether a text of at most `size` characters is ASCII. */
static inline bool tc100_is_text(const char *text, size_t size)
{
    size_t offset;
    for (offset = 0; offset < size && text[offset] != '\0'; offset++) {
        if ((uint8_t)text[offset] > 127u) {
            return false;
        }
    }
    return true;
}

/** Writes a text of at most `size` characters, padded with zeros. */
static inline void tc100_put_text(uint8_t *out, const char *text, size_t size)
{
    size_t offset;
    TC100_CLEAR(out, size);
    for (offset = 0; offset < size && text[offset] != '\0'; offset++) {
        out[offset] = (uint8_t)text[offset];
    }
}

/** The value of a hexadecimal digit; more than 15 for any other character. */
static inline uint8_t tc100_digit(uint8_t character)
{
    if (character >= 0x30u && character <= 0x39u) {
        return (uint8_t)(character - 0x30u);
    }
    if (character >= 0x41u && character <= 0x46u) {
        return (uint8_t)(character - 0x37u);
    }
    if (character >= 0x61u && character <= 0x66u) {
        return (uint8_t)(character - 0x57u);
    }
    return 0xFFu;
}

static inline uint8_t tc100_hex_digit(uint8_t value)
{
    return (uint8_t)(value < 10u ? value + 0x30u : value + 0x37u);
}

/* ---- Checksums ---- */

/**
 * CRC-16, polynomial 0xA001 reflected, start value 0xFFFF.
 * Define TC100_WIDE_CRC_TABLE for a table of 512 bytes.
 */
static inline uint16_t tc100_crc16_modbus(const uint8_t *in, size_t size)
{
#ifdef TC100_WIDE_CRC_TABLE
    static const uint16_t table[256] = {
        0x0000u, 0xC0C1u, 0xC181u, 0x0140u, 0xC301u, 0x03C0u, 0x0280u, 0xC241u,
        0xC601u, 0x06C0u, 0x0780u, 0xC741u, 0x0500u, 0xC5C1u, 0xC481u, 0x0440u,
        0xCC01u, 0x0CC0u, 0x0D80u, 0xCD41u, 0x0F00u, 0xCFC1u, 0xCE81u, 0x0E40u,
        0x0A00u, 0xCAC1u, 0xCB81u, 0x0B40u, 0xC901u, 0x09C0u, 0x0880u, 0xC841u,
        0xD801u, 0x18C0u, 0x1980u, 0xD941u, 0x1B00u, 0xDBC1u, 0xDA81u, 0x1A40u,
        0x1E00u, 0xDEC1u, 0xDF81u, 0x1F40u, 0xDD01u, 0x1DC0u, 0x1C80u, 0xDC41u,
        0x1400u, 0xD4C1u, 0xD581u, 0x1540u, 0xD701u, 0x17C0u, 0x1680u, 0xD641u,
        0xD201u, 0x12C0u, 0x1380u, 0xD341u, 0x1100u, 0xD1C1u, 0xD081u, 0x1040u,
        0xF001u, 0x30C0u, 0x3180u, 0xF141u, 0x3300u, 0xF3C1u, 0xF281u, 0x3240u,
        0x3600u, 0xF6C1u, 0xF781u, 0x3740u, 0xF501u, 0x35C0u, 0x3480u, 0xF441u,
        0x3C00u, 0xFCC1u, 0xFD81u, 0x3D40u, 0xFF01u, 0x3FC0u, 0x3E80u, 0xFE41u,
        0xFA01u, 0x3AC0u, 0x3B80u, 0xFB41u, 0x3900u, 0xF9C1u, 0xF881u, 0x3840u,
        0x2800u, 0xE8C1u, 0xE981u, 0x2940u, 0xEB01u, 0x2BC0u, 0x2A80u, 0xEA41u,
        0xEE01u, 0x2EC0u, 0x2F80u, 0xEF41u, 0x2D00u, 0xEDC1u, 0xEC81u, 0x2C40u,
        0xE401u, 0x24C0u, 0x2580u, 0xE541u, 0x2700u, 0xE7C1u, 0xE681u, 0x2640u,
        0x2200u, 0xE2C1u, 0xE381u, 0x2340u, 0xE101u, 0x21C0u, 0x2080u, 0xE041u,
        0xA001u, 0x60C0u, 0x6180u, 0xA141u, 0x6300u, 0xA3C1u, 0xA281u, 0x6240u,
        0x6600u, 0xA6C1u, 0xA781u, 0x6740u, 0xA501u, 0x65C0u, 0x6480u, 0xA441u,
        0x6C00u, 0xACC1u, 0xAD81u, 0x6D40u, 0xAF01u, 0x6FC0u, 0x6E80u, 0xAE41u,
        0xAA01u, 0x6AC0u, 0x6B80u, 0xAB41u, 0x6900u, 0xA9C1u, 0xA881u, 0x6840u,
        0x7800u, 0xB8C1u, 0xB981u, 0x7940u, 0xBB01u, 0x7BC0u, 0x7A80u, 0xBA41u,
        0xBE01u, 0x7EC0u, 0x7F80u, 0xBF41u, 0x7D00u, 0xBDC1u, 0xBC81u, 0x7C40u,
        0xB401u, 0x74C0u, 0x7580u, 0xB541u, 0x7700u, 0xB7C1u, 0xB681u, 0x7640u,
        0x7200u, 0xB2C1u, 0xB381u, 0x7340u, 0xB101u, 0x71C0u, 0x7080u, 0xB041u,
        0x5000u, 0x90C1u, 0x9181u, 0x5140u, 0x9301u, 0x53C0u, 0x5280u, 0x9241u,
        0x9601u, 0x56C0u, 0x5780u, 0x9741u, 0x5500u, 0x95C1u, 0x9481u, 0x5440u,
        0x9C01u, 0x5CC0u, 0x5D80u, 0x9D41u, 0x5F00u, 0x9FC1u, 0x9E81u, 0x5E40u,
        0x5A00u, 0x9AC1u, 0x9B81u, 0x5B40u, 0x9901u, 0x59C0u, 0x5880u, 0x9841u,
        0x8801u, 0x48C0u, 0x4980u, 0x8941u, 0x4B00u, 0x8BC1u, 0x8A81u, 0x4A40u,
        0x4E00u, 0x8EC1u, 0x8F81u, 0x4F40u, 0x8D01u, 0x4DC0u, 0x4C80u, 0x8C41u,
        0x4400u, 0x84C1u, 0x8581u, 0x4540u, 0x8701u, 0x47C0u, 0x4680u, 0x8641u,
        0x8201u, 0x42C0u, 0x4380u, 0x8341u, 0x4100u, 0x81C1u, 0x8081u, 0x4040u,
    };
    uint16_t crc = 0xFFFFu;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        crc = (uint16_t)(crc >> 8 ^ table[(crc ^ in[offset]) & 0xFFu]);
    }
#else
    static const uint16_t table[16] = {
        0x0000u, 0xCC01u, 0xD801u, 0x1400u, 0xF001u, 0x3C00u, 0x2800u, 0xE401u,
        0xA001u, 0x6C00u, 0x7800u, 0xB401u, 0x5000u, 0x9C01u, 0x8801u, 0x4400u,
    };
    uint16_t crc = 0xFFFFu;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        crc = (uint16_t)(crc ^ in[offset]);
        crc = (uint16_t)(crc >> 4 ^ table[crc & 15u]);
        crc = (uint16_t)(crc >> 4 ^ table[crc & 15u]);
    }
#endif
    return crc;
}

/** The two's complement of the sum of all bytes. */
static inline uint8_t tc100_lrc(const uint8_t *in, size_t size)
{
    uint32_t sum = 0;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        sum += in[offset];
    }
    return (uint8_t)((0u - sum) & 0xFFu);
}

/* ---- Enums and codes ---- */

/** Whether a value is one of tc100_rotation_direction. */
static inline bool tc100_rotation_direction_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of tc100_pulse_input_form. */
static inline bool tc100_pulse_input_form_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(2));
}

/** Whether a value is one of tc100_control_mode. */
static inline bool tc100_control_mode_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of tc100_servo_command. */
static inline bool tc100_servo_command_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of tc100_moving_state_rule. */
static inline bool tc100_moving_state_rule_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of tc100_homing_mode. */
static inline bool tc100_homing_mode_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(7));
}

/** Whether a value is one of tc100_baud_rate. */
static inline bool tc100_baud_rate_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(4));
}

/** Whether a value is one of tc100_data_bits. */
static inline bool tc100_data_bits_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of tc100_parity. */
static inline bool tc100_parity_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(2));
}

/** Whether a value is one of tc100_protocol. */
static inline bool tc100_protocol_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of tc100_action_status. */
static inline bool tc100_action_status_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(2));
}

/** Whether a value is one of tc100_torque_search_direction. */
static inline bool tc100_torque_search_direction_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of tc100_motion_command. */
static inline bool tc100_motion_command_known(int64_t value)
{
    if (value >= INT64_C(0) && value <= INT64_C(4)) {
        return true;
    }
    if (value >= INT64_C(6) && value <= INT64_C(9)) {
        return true;
    }
    return TC100_LIKELY(value >= INT64_C(11) && value <= INT64_C(12));
}

/** Whether a value is one of tc100_parameter_storage. */
static inline bool tc100_parameter_storage_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/* ---- Bit fields ---- */

static inline bool tc100_simulated_input_word_simulated_input_1(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_1_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_2(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_2_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_3(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_3_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_4(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_4_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_5(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_5_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_6(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_6_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_7(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_7_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_8(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_8_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_9(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_9_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_10(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_10_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_11(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_11_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_12(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_12_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_13(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_13_MASK) != 0;
}

static inline bool tc100_simulated_input_word_simulated_input_14(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_14_MASK) != 0;
}

static inline bool tc100_output_word_output_1(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_1_MASK) != 0;
}

static inline bool tc100_output_word_output_2(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_2_MASK) != 0;
}

static inline bool tc100_output_word_output_3(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_3_MASK) != 0;
}

static inline bool tc100_output_word_output_4(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_4_MASK) != 0;
}

static inline bool tc100_output_word_output_5(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_5_MASK) != 0;
}

static inline bool tc100_output_word_output_6(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_6_MASK) != 0;
}

static inline bool tc100_output_word_output_7(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_7_MASK) != 0;
}

static inline bool tc100_output_word_output_8(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_8_MASK) != 0;
}

static inline bool tc100_output_word_output_9(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_9_MASK) != 0;
}

static inline bool tc100_output_word_output_10(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_10_MASK) != 0;
}

static inline bool tc100_input_word_input_1(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_1_MASK) != 0;
}

static inline bool tc100_input_word_input_2(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_2_MASK) != 0;
}

static inline bool tc100_input_word_input_3(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_3_MASK) != 0;
}

static inline bool tc100_input_word_input_4(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_4_MASK) != 0;
}

static inline bool tc100_input_word_input_5(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_5_MASK) != 0;
}

static inline bool tc100_input_word_input_6(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_6_MASK) != 0;
}

static inline bool tc100_input_word_input_7(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_7_MASK) != 0;
}

static inline bool tc100_input_word_input_8(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_8_MASK) != 0;
}

static inline bool tc100_input_word_input_9(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_9_MASK) != 0;
}

static inline bool tc100_input_word_input_10(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_10_MASK) != 0;
}

static inline bool tc100_input_word_input_11(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_11_MASK) != 0;
}

static inline bool tc100_input_word_input_12(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_12_MASK) != 0;
}

static inline bool tc100_input_word_input_13(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_13_MASK) != 0;
}

static inline bool tc100_input_word_input_14(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_14_MASK) != 0;
}

static inline bool tc100_input_word_z_phase(uint16_t word)
{
    return (word & TC100_INPUT_WORD_Z_PHASE_MASK) != 0;
}

/* ---- Records ---- */

/**
 * The body of a reply that refuses a request.
 * Source: 8.3 L1750-1752
 */
typedef struct tc100_exception {
    /**
     * Printed as 錯誤碼.
     * Range: 1..3. See exception_code.
     * Source: 8.4 L1829
     */
    uint8_t exception_code;
} tc100_exception;

/** Whether the values of tc100_exception may be written. */
static inline tc100_codec_status tc100_exception_check(const tc100_exception *in)
{
    if (!(in->exception_code >= 1u && in->exception_code <= 3u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    return TC100_OK;
}

/** Writes tc100_exception to 1 byte without checks. */
static inline void tc100_exception_pack(const tc100_exception *in, uint8_t *out)
{
    tc100_store_u8(out + 0, in->exception_code);
}

/** Reads tc100_exception from 1 byte without checks. */
static inline void tc100_exception_unpack(const uint8_t *in, tc100_exception *out)
{
    out->exception_code = tc100_load_u8(in + 0);
}

/**
 * Writes tc100_exception: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline tc100_codec_status tc100_exception_encode(const tc100_exception *in, uint8_t *out, size_t capacity,
        size_t *length)
{
    tc100_codec_status status;
    if (capacity < 1u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_exception_check(in);
    if (status != TC100_OK) {
        return status;
    }
    tc100_exception_pack(in, out);
    *length = 1u;
    return TC100_OK;
}

/** Reads tc100_exception from exactly 1 byte. */
static inline tc100_codec_status tc100_exception_decode(const uint8_t *in, size_t length, tc100_exception *out)
{
    if (length != 1u) {
        return length < 1u ? TC100_ERR_INCOMPLETE : TC100_ERR_WRONG_LENGTH;
    }
    tc100_exception_unpack(in, out);
    return TC100_OK;
}

/**
 * One point, which the manual also calls step and program.
 * Printed as 步序.
 * Source: 8.2 L1648-1658
 */
typedef struct tc100_point {
    /**
     * How the point is reached.
     * Printed as 移動模式.
     * Range: 0..16. See point_mode.
     * Source: 8.2 L1648
     */
    uint16_t mode;
    /**
     * The target position, or the distance in relative modes. Homing and torque searches do not use it.
     * Printed as 移動量 / 移動位置.
     * One count is 1 pulse. Range: -2147483648..2147483647.
     * Note: 8.2 counts in pulses. Chapter 4 and the software's lists speak of mm, from -9999.99 to 9999.99; the
     * software converts between mm, pulse and mil (9.3), and 2000H to 2006H count in 0.01 mm or pulses.
     * Source: 8.2 L1649
     */
    int32_t position;
    /**
     * The speed, a percentage of the maximum speed 0802H. Homing does not use it.
     * Printed as 移動速度.
     * One count is 1 %. Range: 0..100. 0 means start_speed.
     * Note: Chapter 4 and the software offer 1 to 100 only.
     * Source: 8.2 L1650; 4.1 L804
     */
    uint16_t speed;
    /**
     * The limit of the current, as a part of the rated current of the actuator; 1000 is the rated current. Homing
     * does not use it.
     * Printed as 扭力限制.
     * One count is 0.1 %. Range: 0..1000.
     * Note: The parameter 0500H (maximum torque) goes to 650 in the same unit; the manual does not relate the two.
     * Source: 8.2 L1651; 4.1 L805
     */
    uint16_t torque_limit;
    /**
     * The output INRANGE is on between this position and the upper limit.
     * Printed as 範圍 L.
     * Note: 8.2 prints no unit and no range. Chapter 4 and the software speak of mm, from -9999.99 to 9999.99; see
     * the position. The output must be assigned to a terminal by 0712H (4.6).
     * Source: 8.2 L1653
     */
    int32_t zone_lower_limit;
    /**
     * The output INRANGE is on between the lower limit and this position.
     * Printed as 範圍 H.
     * Note: 8.2 prints no unit and no range. Chapter 4 and the software speak of mm, from -9999.99 to 9999.99; see
     * the position. The output must be assigned to a terminal by 0712H (4.6).
     * Source: 8.2 L1654
     */
    int32_t zone_upper_limit;
    /**
     * The time of acceleration to the speed of the point.
     * Printed as 加速時間.
     * One count is 1 ms. Range: 1..30000.
     * Source: 8.2 L1655
     */
    uint16_t acceleration_time;
    /**
     * The time of deceleration from the speed of the point to the stop.
     * Printed as 減速時間.
     * One count is 1 ms. Range: 1..30000.
     * Source: 8.2 L1656
     */
    uint16_t deceleration_time;
    /**
     * The wait after the move; the outputs READY and MOVE change only after it (4.7).
     * Printed as 等待時間.
     * One count is 1 ms. Range: 0..30000.
     * Source: 8.2 L1657
     */
    uint16_t wait_time;
    /**
     * The point that is executed next.
     * Printed as 下一個步序.
     * Range: -1, 1..127. -1 means end.
     * Source: 8.2 L1658
     */
    int16_t next_point;
} tc100_point;

/** Whether the values of tc100_point may be written. */
static inline tc100_codec_status tc100_point_check(const tc100_point *in)
{
    if (!(in->mode <= 16u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    if (!(in->torque_limit <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    if (!(in->acceleration_time >= 1u && in->acceleration_time <= 30000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    if (!(in->deceleration_time >= 1u && in->deceleration_time <= 30000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    if (!(in->wait_time <= 30000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    if (!((in->next_point == (-1)) || (in->next_point >= 1 && in->next_point <= 127))) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    return TC100_OK;
}

/** Writes tc100_point to 28 bytes without checks. */
static inline void tc100_point_pack(const tc100_point *in, uint8_t *out)
{
    tc100_store_u16_be(out + 0, in->mode);
    tc100_store_u32_be(out + 2, (uint32_t)in->position);
    tc100_store_u16_be(out + 6, in->speed);
    tc100_store_u16_be(out + 8, in->torque_limit);
    tc100_store_u16_be(out + 10, 0u);
    tc100_store_u32_be(out + 12, (uint32_t)in->zone_lower_limit);
    tc100_store_u32_be(out + 16, (uint32_t)in->zone_upper_limit);
    tc100_store_u16_be(out + 20, in->acceleration_time);
    tc100_store_u16_be(out + 22, in->deceleration_time);
    tc100_store_u16_be(out + 24, in->wait_time);
    tc100_store_u16_be(out + 26, (uint16_t)in->next_point);
}

/** Reads tc100_point from 28 bytes without checks. */
static inline void tc100_point_unpack(const uint8_t *in, tc100_point *out)
{
    out->mode = tc100_load_u16_be(in + 0);
    out->position = tc100_signed_32(tc100_load_u32_be(in + 2));
    out->speed = tc100_load_u16_be(in + 6);
    out->torque_limit = tc100_load_u16_be(in + 8);
    out->zone_lower_limit = tc100_signed_32(tc100_load_u32_be(in + 12));
    out->zone_upper_limit = tc100_signed_32(tc100_load_u32_be(in + 16));
    out->acceleration_time = tc100_load_u16_be(in + 20);
    out->deceleration_time = tc100_load_u16_be(in + 22);
    out->wait_time = tc100_load_u16_be(in + 24);
    out->next_point = tc100_signed_16(tc100_load_u16_be(in + 26));
}

/**
 * Writes tc100_point: 28 bytes.
 * `length` receives the number of bytes written.
 */
static inline tc100_codec_status tc100_point_encode(const tc100_point *in, uint8_t *out, size_t capacity,
        size_t *length)
{
    tc100_codec_status status;
    if (capacity < 28u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_point_check(in);
    if (status != TC100_OK) {
        return status;
    }
    tc100_point_pack(in, out);
    *length = 28u;
    return TC100_OK;
}

/** Reads tc100_point from exactly 28 bytes. */
static inline tc100_codec_status tc100_point_decode(const uint8_t *in, size_t length, tc100_point *out)
{
    if (length != 28u) {
        return length < 28u ? TC100_ERR_INCOMPLETE : TC100_ERR_WRONG_LENGTH;
    }
    tc100_point_unpack(in, out);
    return TC100_OK;
}

/* ---- Data of requests and responses ---- */

typedef struct tc100_read_registers_request {
    /**
     * Printed as 讀取開始位置.
     * Range: 0..65535.
     * Source: 8.4 L1798-1799
     */
    uint16_t address;
    /**
     * Printed as 讀出 WORD 數.
     * Range: 1..60.
     * Source: 8.5 L2026-2027
     */
    uint16_t word_count;
} tc100_read_registers_request;

/** Whether the values of tc100_read_registers_request may be written. */
static inline tc100_codec_status tc100_read_registers_request_check(const tc100_read_registers_request *in)
{
    if (!(in->word_count >= 1u && in->word_count <= 60u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    return TC100_OK;
}

/** Writes tc100_read_registers_request to 4 bytes without checks. */
static inline void tc100_read_registers_request_pack(const tc100_read_registers_request *in, uint8_t *out)
{
    tc100_store_u16_be(out + 0, in->address);
    tc100_store_u16_be(out + 2, in->word_count);
}

/** Reads tc100_read_registers_request from 4 bytes without checks. */
static inline void tc100_read_registers_request_unpack(const uint8_t *in, tc100_read_registers_request *out)
{
    out->address = tc100_load_u16_be(in + 0);
    out->word_count = tc100_load_u16_be(in + 2);
}

/**
 * Writes tc100_read_registers_request: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline tc100_codec_status tc100_read_registers_request_encode(const tc100_read_registers_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    tc100_codec_status status;
    if (capacity < 4u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_read_registers_request_check(in);
    if (status != TC100_OK) {
        return status;
    }
    tc100_read_registers_request_pack(in, out);
    *length = 4u;
    return TC100_OK;
}

/** Reads tc100_read_registers_request from exactly 4 bytes. */
static inline tc100_codec_status tc100_read_registers_request_decode(const uint8_t *in, size_t length,
        tc100_read_registers_request *out)
{
    if (length != 4u) {
        return length < 4u ? TC100_ERR_INCOMPLETE : TC100_ERR_WRONG_LENGTH;
    }
    tc100_read_registers_request_unpack(in, out);
    return TC100_OK;
}

typedef struct tc100_read_registers_response {
    /**
     * Printed as WORD 資料.
     * Range: 0..65535.
     * Source: 8.4 L1812-1819
     */
    uint16_t values[60];
    size_t values_count;
} tc100_read_registers_response;

/**
 * Writes tc100_read_registers_response: 3 to 121 bytes.
 * `length` receives the number of bytes written.
 */
static inline tc100_codec_status tc100_read_registers_response_encode(const tc100_read_registers_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t at;
    if (in->values_count < 1u || in->values_count > 60u) {
        return TC100_ERR_WRONG_LENGTH;
    }
    if (capacity < (1u + in->values_count * 2u)) {
        return TC100_ERR_CAPACITY;
    }
    for (at = 0; at < in->values_count; at++) {
        tc100_store_u16_be(out + 1u + at * 2u, in->values[at]);
    }
    tc100_store_u8(out + 0, (uint8_t)(in->values_count * 2u));
    *length = (1u + in->values_count * 2u);
    return TC100_OK;
}

/** Reads tc100_read_registers_response from exactly 3 to 121 bytes. */
static inline tc100_codec_status tc100_read_registers_response_decode(const uint8_t *in, size_t length,
        tc100_read_registers_response *out)
{
    size_t at;
    if (length < 3u) {
        return TC100_ERR_INCOMPLETE;
    }
    if (length > 121u) {
        return TC100_ERR_WRONG_LENGTH;
    }
    if ((length - 1u) % 2u != 0) {
        return TC100_ERR_WRONG_LENGTH;
    }
    out->values_count = (length - 1u) / 2u;
    for (at = 0; at < out->values_count; at++) {
        out->values[at] = tc100_load_u16_be(in + 1u + at * 2u);
    }
    if (tc100_load_u8(in + 0) != out->values_count * 2u) {
        return TC100_ERR_WRONG_MEASURE;
    }
    return TC100_OK;
}

typedef struct tc100_write_register_request {
    /**
     * Printed as 寫入開始位置.
     * Range: 0..65535.
     * Source: 8.4 L1859-1860
     */
    uint16_t address;
    /**
     * Printed as 寫入資料.
     * Range: 0..65535.
     * Note: The tables call it a number of words; it is the word that is written.
     * Source: 8.4 L1861-1862
     */
    uint16_t value;
} tc100_write_register_request;

/** Writes tc100_write_register_request to 4 bytes without checks. */
static inline void tc100_write_register_request_pack(const tc100_write_register_request *in, uint8_t *out)
{
    tc100_store_u16_be(out + 0, in->address);
    tc100_store_u16_be(out + 2, in->value);
}

/** Reads tc100_write_register_request from 4 bytes without checks. */
static inline void tc100_write_register_request_unpack(const uint8_t *in, tc100_write_register_request *out)
{
    out->address = tc100_load_u16_be(in + 0);
    out->value = tc100_load_u16_be(in + 2);
}

/**
 * Writes tc100_write_register_request: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline tc100_codec_status tc100_write_register_request_encode(const tc100_write_register_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 4u) {
        return TC100_ERR_CAPACITY;
    }
    tc100_write_register_request_pack(in, out);
    *length = 4u;
    return TC100_OK;
}

/** Reads tc100_write_register_request from exactly 4 bytes. */
static inline tc100_codec_status tc100_write_register_request_decode(const uint8_t *in, size_t length,
        tc100_write_register_request *out)
{
    if (length != 4u) {
        return length < 4u ? TC100_ERR_INCOMPLETE : TC100_ERR_WRONG_LENGTH;
    }
    tc100_write_register_request_unpack(in, out);
    return TC100_OK;
}

typedef struct tc100_write_register_response {
    /**
     * Printed as 寫入開始位置.
     * Range: 0..65535.
     * Source: 8.4 L1872-1873
     */
    uint16_t address;
    /**
     * Printed as 寫入資料.
     * Range: 0..65535.
     * Source: 8.4 L1874-1875
     */
    uint16_t value;
} tc100_write_register_response;

/** Writes tc100_write_register_response to 4 bytes without checks. */
static inline void tc100_write_register_response_pack(const tc100_write_register_response *in, uint8_t *out)
{
    tc100_store_u16_be(out + 0, in->address);
    tc100_store_u16_be(out + 2, in->value);
}

/** Reads tc100_write_register_response from 4 bytes without checks. */
static inline void tc100_write_register_response_unpack(const uint8_t *in, tc100_write_register_response *out)
{
    out->address = tc100_load_u16_be(in + 0);
    out->value = tc100_load_u16_be(in + 2);
}

/**
 * Writes tc100_write_register_response: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline tc100_codec_status tc100_write_register_response_encode(const tc100_write_register_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 4u) {
        return TC100_ERR_CAPACITY;
    }
    tc100_write_register_response_pack(in, out);
    *length = 4u;
    return TC100_OK;
}

/** Reads tc100_write_register_response from exactly 4 bytes. */
static inline tc100_codec_status tc100_write_register_response_decode(const uint8_t *in, size_t length,
        tc100_write_register_response *out)
{
    if (length != 4u) {
        return length < 4u ? TC100_ERR_INCOMPLETE : TC100_ERR_WRONG_LENGTH;
    }
    tc100_write_register_response_unpack(in, out);
    return TC100_OK;
}

typedef struct tc100_write_registers_request {
    /**
     * Printed as 寫入開始位置.
     * Range: 0..65535.
     * Source: 8.4 L1913-1914
     */
    uint16_t address;
    /**
     * Printed as WORD 資料.
     * Range: 0..65535.
     * Source: 8.4 L1918-1924
     */
    uint16_t values[59];
    size_t values_count;
} tc100_write_registers_request;

/**
 * Writes tc100_write_registers_request: 7 to 123 bytes.
 * `length` receives the number of bytes written.
 */
static inline tc100_codec_status tc100_write_registers_request_encode(const tc100_write_registers_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t at;
    if (in->values_count < 1u || in->values_count > 59u) {
        return TC100_ERR_WRONG_LENGTH;
    }
    if (capacity < (5u + in->values_count * 2u)) {
        return TC100_ERR_CAPACITY;
    }
    tc100_store_u16_be(out + 0, in->address);
    for (at = 0; at < in->values_count; at++) {
        tc100_store_u16_be(out + 5u + at * 2u, in->values[at]);
    }
    tc100_store_u16_be(out + 2, (uint16_t)(in->values_count));
    tc100_store_u8(out + 4, (uint8_t)(in->values_count * 2u));
    *length = (5u + in->values_count * 2u);
    return TC100_OK;
}

/** Reads tc100_write_registers_request from exactly 7 to 123 bytes. */
static inline tc100_codec_status tc100_write_registers_request_decode(const uint8_t *in, size_t length,
        tc100_write_registers_request *out)
{
    size_t at;
    if (length < 7u) {
        return TC100_ERR_INCOMPLETE;
    }
    if (length > 123u) {
        return TC100_ERR_WRONG_LENGTH;
    }
    if ((length - 5u) % 2u != 0) {
        return TC100_ERR_WRONG_LENGTH;
    }
    out->values_count = (length - 5u) / 2u;
    out->address = tc100_load_u16_be(in + 0);
    for (at = 0; at < out->values_count; at++) {
        out->values[at] = tc100_load_u16_be(in + 5u + at * 2u);
    }
    if (tc100_load_u16_be(in + 2) != out->values_count) {
        return TC100_ERR_WRONG_MEASURE;
    }
    if (tc100_load_u8(in + 4) != out->values_count * 2u) {
        return TC100_ERR_WRONG_MEASURE;
    }
    return TC100_OK;
}

typedef struct tc100_write_registers_response {
    /**
     * Printed as 寫入開始位置.
     * Range: 0..65535.
     * Source: 8.4 L1934-1935
     */
    uint16_t address;
    /**
     * Printed as 讀入 WORD 數.
     * Range: 1..59.
     * Note: 8.5 calls what is written read in, in all of its write structures.
     * Source: 8.5 L2169-2170
     */
    uint16_t word_count;
} tc100_write_registers_response;

/** Whether the values of tc100_write_registers_response may be written. */
static inline tc100_codec_status tc100_write_registers_response_check(const tc100_write_registers_response *in)
{
    if (!(in->word_count >= 1u && in->word_count <= 59u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    return TC100_OK;
}

/** Writes tc100_write_registers_response to 4 bytes without checks. */
static inline void tc100_write_registers_response_pack(const tc100_write_registers_response *in, uint8_t *out)
{
    tc100_store_u16_be(out + 0, in->address);
    tc100_store_u16_be(out + 2, in->word_count);
}

/** Reads tc100_write_registers_response from 4 bytes without checks. */
static inline void tc100_write_registers_response_unpack(const uint8_t *in, tc100_write_registers_response *out)
{
    out->address = tc100_load_u16_be(in + 0);
    out->word_count = tc100_load_u16_be(in + 2);
}

/**
 * Writes tc100_write_registers_response: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline tc100_codec_status tc100_write_registers_response_encode(const tc100_write_registers_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    tc100_codec_status status;
    if (capacity < 4u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_write_registers_response_check(in);
    if (status != TC100_OK) {
        return status;
    }
    tc100_write_registers_response_pack(in, out);
    *length = 4u;
    return TC100_OK;
}

/** Reads tc100_write_registers_response from exactly 4 bytes. */
static inline tc100_codec_status tc100_write_registers_response_decode(const uint8_t *in, size_t length,
        tc100_write_registers_response *out)
{
    if (length != 4u) {
        return length < 4u ? TC100_ERR_INCOMPLETE : TC100_ERR_WRONG_LENGTH;
    }
    tc100_write_registers_response_unpack(in, out);
    return TC100_OK;
}

/* ---- Registers ---- */

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_jog_positive_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_jog_positive_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_jog_negative_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_jog_negative_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_manual_mode_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_manual_mode_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_teach_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_teach_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_lock_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_lock_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_4_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_4_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_5_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_5_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_6_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_6_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_sensor_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_sensor_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_brake_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_brake_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_full_count_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_full_count_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_in_position_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_in_position_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_alarm_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_alarm_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_ready_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_ready_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_moving_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_moving_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_servo_on_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_servo_on_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_0_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_0_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_1_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_1_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_2_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_2_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_3_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_3_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_4_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_4_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_5_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_5_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_6_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_point_select_bit_6_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_torque_limit_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_torque_limit_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_error_bit_0_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_error_bit_0_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_error_bit_1_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_error_bit_1_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_error_bit_2_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_error_bit_2_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_error_bit_3_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_error_bit_3_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_zone_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_zone_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_near_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_near_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_soft_limit_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_soft_limit_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_relative_distance_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_relative_distance_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_absolute_position_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_absolute_position_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_torque_search_direction_decode(const uint8_t *in,
        tc100_torque_search_direction *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_torque_search_direction_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_torque_search_direction)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_torque_search_direction_encode(tc100_torque_search_direction value,
        uint8_t *out)
{
    if (!tc100_torque_search_direction_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_preset_position_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_preset_position_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_servo_decode(const uint8_t *in, tc100_servo_command *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_servo_command_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_servo_command)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_servo_encode(tc100_servo_command value, uint8_t *out)
{
    if (!tc100_servo_command_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_motion_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_motion_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Decodes the value from its 2 bytes.
 * An integer, as the device may answer what motion_command does not have.
 */
static inline tc100_codec_status tc100_reg_motion_command_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_motion_command_encode(tc100_motion_command value, uint8_t *out)
{
    if (!tc100_motion_command_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_simulated_inputs_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_simulated_inputs_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 16383u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_simulated_input_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_simulated_input_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** The address of simulated_input by its number; other numbers are refused. */
static inline tc100_codec_status tc100_reg_simulated_input_at(uint32_t number, uint16_t *address)
{
    if (number - TC100_REG_SIMULATED_INPUT_FIRST >= TC100_REG_SIMULATED_INPUT_COUNT) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    *address = (uint16_t)(TC100_REG_SIMULATED_INPUT_ADDRESS + (number - TC100_REG_SIMULATED_INPUT_FIRST) * TC100_REG_SIMULATED_INPUT_STRIDE);
    return TC100_OK;
}

/**
 * Decodes the value from its 2 bytes.
 * An integer, as the device may answer what parameter_storage does not have.
 */
static inline tc100_codec_status tc100_reg_parameter_storage_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_parameter_storage_encode(tc100_parameter_storage value, uint8_t *out)
{
    if (!tc100_parameter_storage_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 8 bytes. */
static inline tc100_codec_status tc100_reg_write_enable_key_decode(const uint8_t *in, uint64_t *out)
{
    *out = tc100_load_u64_be(in);
    return TC100_OK;
}

/** Encodes the value into its 8 bytes. */
static inline tc100_codec_status tc100_reg_write_enable_key_encode(uint8_t *out)
{
    tc100_store_u64_be(out, UINT64_C(5509644182563149415));
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_full_count_limit_decode(const uint8_t *in, uint32_t *out)
{
    *out = tc100_load_u32_be(in);
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_full_count_limit_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 100000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u32_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_in_position_zone_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_in_position_zone_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_electronic_gear_numerator_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_electronic_gear_numerator_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 10000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_electronic_gear_denominator_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_electronic_gear_denominator_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 10000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_pulse_rotation_direction_decode(const uint8_t *in,
        tc100_rotation_direction *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_rotation_direction_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_rotation_direction)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_pulse_rotation_direction_encode(tc100_rotation_direction value, uint8_t *out)
{
    if (!tc100_rotation_direction_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_pulse_input_form_decode(const uint8_t *in, tc100_pulse_input_form *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_pulse_input_form_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_pulse_input_form)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_pulse_input_form_encode(tc100_pulse_input_form value, uint8_t *out)
{
    if (!tc100_pulse_input_form_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_near_zone_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_near_zone_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 10000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_push_torque_positive_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_push_torque_positive_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_push_torque_negative_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_push_torque_negative_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_torque_limit_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_torque_limit_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 10000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_position_correction_speed_limit_enabled_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_position_correction_speed_limit_enabled_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_position_correction_speed_limit_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_position_correction_speed_limit_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 10u && value <= 500u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_maximum_torque_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_maximum_torque_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 650u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_full_torque_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_full_torque_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 500u && value <= 10000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_control_mode_decode(const uint8_t *in, tc100_control_mode *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_control_mode_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_control_mode)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_control_mode_encode(tc100_control_mode value, uint8_t *out)
{
    if (!tc100_control_mode_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_servo_at_power_on_decode(const uint8_t *in, tc100_servo_command *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_servo_command_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_servo_command)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_servo_at_power_on_encode(tc100_servo_command value, uint8_t *out)
{
    if (!tc100_servo_command_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_required_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_required_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_total_revolutions_enabled_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_total_revolutions_enabled_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_start_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = tc100_load_u32_be(in);
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_start_speed_encode(uint32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_maximum_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = tc100_load_u32_be(in);
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_maximum_speed_encode(uint32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_acceleration_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_acceleration_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 30000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_deceleration_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_deceleration_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 30000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_torque_limit_press_distance_decode(const uint8_t *in, uint32_t *out)
{
    *out = tc100_load_u32_be(in);
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_torque_limit_press_distance_encode(uint32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_moving_state_rule_decode(const uint8_t *in, tc100_moving_state_rule *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_moving_state_rule_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_moving_state_rule)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_moving_state_rule_encode(tc100_moving_state_rule value, uint8_t *out)
{
    if (!tc100_moving_state_rule_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_jog_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_jog_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_jog_distance_decode(const uint8_t *in, uint32_t *out)
{
    *out = tc100_load_u32_be(in);
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_jog_distance_encode(uint32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_jog_wait_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_jog_wait_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_soft_limit_positive_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_soft_limit_positive_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_soft_limit_negative_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_soft_limit_negative_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_mode_decode(const uint8_t *in, tc100_homing_mode *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_homing_mode_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_homing_mode)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_mode_encode(tc100_homing_mode value, uint8_t *out)
{
    if (!tc100_homing_mode_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_homing_offset_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_homing_offset_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_offset_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_offset_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_homing_position_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_homing_position_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_torque_limit_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_torque_limit_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_homing_z_phase_offset_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_homing_z_phase_offset_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_torque_limit_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_torque_limit_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_z_phase_speed_1_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_z_phase_speed_1_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_z_phase_speed_2_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_homing_z_phase_speed_2_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_baud_rate_decode(const uint8_t *in, tc100_baud_rate *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_baud_rate_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_baud_rate)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_baud_rate_encode(tc100_baud_rate value, uint8_t *out)
{
    if (!tc100_baud_rate_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_data_bits_decode(const uint8_t *in, tc100_data_bits *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_data_bits_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_data_bits)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_data_bits_encode(tc100_data_bits value, uint8_t *out)
{
    if (!tc100_data_bits_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_parity_decode(const uint8_t *in, tc100_parity *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_parity_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_parity)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_parity_encode(tc100_parity value, uint8_t *out)
{
    if (!tc100_parity_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_broadcast_enabled_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_broadcast_enabled_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_protocol_decode(const uint8_t *in, tc100_protocol *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_protocol_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_protocol)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_protocol_encode(tc100_protocol value, uint8_t *out)
{
    if (!tc100_protocol_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_action_status_decode(const uint8_t *in, tc100_action_status *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_action_status_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_action_status)number;
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_action_status_encode(tc100_action_status value, uint8_t *out)
{
    if (!tc100_action_status_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_in_position_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_in_position_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_torque_limit_reached_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_torque_limit_reached_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_alarm_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_alarm_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_motor_speed_decode(const uint8_t *in, int16_t *out)
{
    *out = tc100_signed_16(tc100_load_u16_be(in));
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_motor_speed_encode(int16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_motor_current_decode(const uint8_t *in, int16_t *out)
{
    *out = tc100_signed_16(tc100_load_u16_be(in));
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_motor_current_encode(int16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_command_position_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_command_position_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/** Decodes the value from its 4 bytes. */
static inline tc100_codec_status tc100_reg_encoder_position_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into its 4 bytes. */
static inline tc100_codec_status tc100_reg_encoder_position_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_servo_on_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_servo_on_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_fault_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_fault_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_executed_point_decode(const uint8_t *in, int16_t *out)
{
    *out = tc100_signed_16(tc100_load_u16_be(in));
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_executed_point_encode(int16_t value, uint8_t *out)
{
    if (!(value >= (-1) && value <= 127)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_output_states_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_output_states_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1023u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_output_state_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_output_state_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** The address of output_state by its number; other numbers are refused. */
static inline tc100_codec_status tc100_reg_output_state_at(uint32_t number, uint16_t *address)
{
    if (number - TC100_REG_OUTPUT_STATE_FIRST >= TC100_REG_OUTPUT_STATE_COUNT) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    *address = (uint16_t)(TC100_REG_OUTPUT_STATE_ADDRESS + (number - TC100_REG_OUTPUT_STATE_FIRST) * TC100_REG_OUTPUT_STATE_STRIDE);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_input_states_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_input_states_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 32767u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_input_state_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_input_state_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** The address of input_state by its number; other numbers are refused. */
static inline tc100_codec_status tc100_reg_input_state_at(uint32_t number, uint16_t *address)
{
    if (number - TC100_REG_INPUT_STATE_FIRST >= TC100_REG_INPUT_STATE_COUNT) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    *address = (uint16_t)(TC100_REG_INPUT_STATE_ADDRESS + (number - TC100_REG_INPUT_STATE_FIRST) * TC100_REG_INPUT_STATE_STRIDE);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_z_phase_state_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_z_phase_state_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_alarm_history_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_alarm_history_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/** The address of alarm_history by its number; other numbers are refused. */
static inline tc100_codec_status tc100_reg_alarm_history_at(uint32_t number, uint16_t *address)
{
    if (number - TC100_REG_ALARM_HISTORY_FIRST >= TC100_REG_ALARM_HISTORY_COUNT) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    *address = (uint16_t)(TC100_REG_ALARM_HISTORY_ADDRESS + (number - TC100_REG_ALARM_HISTORY_FIRST) * TC100_REG_ALARM_HISTORY_STRIDE);
    return TC100_OK;
}

/** Decodes the value from its 32 bytes. */
static inline tc100_codec_status tc100_reg_motor_type_decode(const uint8_t *in, char out[33])
{
    TC100_COPY(out, in, 32u);
    out[32] = '\0';
    if (!tc100_is_ascii(in, 32u)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 32 bytes. */
static inline tc100_codec_status tc100_reg_motor_type_encode(const char value[33], uint8_t *out)
{
    if (!tc100_is_text(value, 32u)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_put_text(out, value, 32u);
    return TC100_OK;
}

/** Decodes the value from its 32 bytes. */
static inline tc100_codec_status tc100_reg_controller_type_decode(const uint8_t *in, char out[33])
{
    TC100_COPY(out, in, 32u);
    out[32] = '\0';
    if (!tc100_is_ascii(in, 32u)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into its 32 bytes. */
static inline tc100_codec_status tc100_reg_controller_type_encode(const char value[33], uint8_t *out)
{
    if (!tc100_is_text(value, 32u)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_put_text(out, value, 32u);
    return TC100_OK;
}

/** Decodes the value from its 2 bytes. */
static inline tc100_codec_status tc100_reg_firmware_version_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into its 2 bytes. */
static inline tc100_codec_status tc100_reg_firmware_version_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/* ---- Record tables ---- */

/** The address of an element of points by its number; other numbers are refused. */
static inline tc100_codec_status tc100_table_points_at(uint32_t number, uint16_t *address)
{
    if (number - TC100_TABLE_POINTS_FIRST >= TC100_TABLE_POINTS_COUNT) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    *address = (uint16_t)(TC100_TABLE_POINTS_ADDRESS + (number - TC100_TABLE_POINTS_FIRST) * TC100_TABLE_POINTS_STRIDE);
    return TC100_OK;
}

/* ---- Frames ---- */

/**
 * RS-485 with two wires, half duplex.
 * Printed as RTU 模式.
 * Frames are binary.
 * Note: The parameter 0A04H chooses between ASCII, as delivered, and RTU. It is that of RS-485; whether USB
 * follows it is not printed.
 * Source: 8.1 L1463-1481; 5.8 L1275; 8.4 L1790, 1851, 1905
 */
/** An opened request: its header, and where its body is. */
typedef struct tc100_rtu_request_frame {
    /** Source: 8.4 L1796 */
    uint8_t unit_address;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    const uint8_t *body;
    size_t body_length;
} tc100_rtu_request_frame;

/** Checks a frame and finds its body. */
static inline tc100_codec_status tc100_rtu_request_open(const uint8_t *frame, size_t size, tc100_rtu_request_frame *out)
{
    const uint8_t *in = frame;
    size_t length = size;
    if (length < 4u) {
        return TC100_ERR_INCOMPLETE;
    }
    if (tc100_crc16_modbus(in, length - 2u) != tc100_load_u16_le(in + length - 2u)) {
        return TC100_ERR_WRONG_CHECKSUM;
    }
    out->unit_address = tc100_load_u8(in + 0);
    out->code = tc100_load_u8(in + 1);
    if (out->code != 3u && out->code != 6u && out->code != 16u) {
        return TC100_ERR_UNKNOWN_CODE;
    }
    out->body = in + 2u;
    out->body_length = length - 4u;
    return TC100_OK;
}

/** Completes a frame whose body is at out + 2. `length` receives the size of the frame. */
static inline tc100_codec_status tc100_rtu_request_close(uint8_t unit_address, uint32_t code, size_t body_length,
        uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 4u;
    if (capacity < 4u || body_length > capacity - 4u) {
        return TC100_ERR_CAPACITY;
    }
    if (!((unit_address >= 1 && unit_address <= 16) || (unit_address == 0))) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u8(out + 0, (uint8_t)unit_address);
    if (code > 255u) {
        return TC100_ERR_UNKNOWN_CODE;
    }
    tc100_store_u8(out + 1, (uint8_t)code);
    tc100_store_u16_le(out + total - 2u, tc100_crc16_modbus(out, total - 2u));
    *length = total;
    return TC100_OK;
}

/** An opened response: its header, and where its body is. */
typedef struct tc100_rtu_response_frame {
    /** Source: 8.4 L1796 */
    uint8_t unit_address;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    /** The frame is an exception response; its body is the record of the exception. */
    bool error;
    const uint8_t *body;
    size_t body_length;
} tc100_rtu_response_frame;

/** Checks a frame and finds its body. */
static inline tc100_codec_status tc100_rtu_response_open(const uint8_t *frame, size_t size,
        tc100_rtu_response_frame *out)
{
    const uint8_t *in = frame;
    size_t length = size;
    if (length < 4u) {
        return TC100_ERR_INCOMPLETE;
    }
    if (tc100_crc16_modbus(in, length - 2u) != tc100_load_u16_le(in + length - 2u)) {
        return TC100_ERR_WRONG_CHECKSUM;
    }
    out->unit_address = tc100_load_u8(in + 0);
    out->code = tc100_load_u8(in + 1);
    out->error = (out->code & 128u) != 0;
    if (out->error) {
        out->code &= ~(uint32_t)128u;
    }
    if (!out->error && out->code != 3u && out->code != 6u && out->code != 16u) {
        return TC100_ERR_UNKNOWN_CODE;
    }
    out->body = in + 2u;
    out->body_length = length - 4u;
    return TC100_OK;
}

/** Completes a frame whose body is at out + 2. `length` receives the size of the frame. */
static inline tc100_codec_status tc100_rtu_response_close(uint8_t unit_address, uint32_t code, size_t body_length,
        uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 4u;
    if (capacity < 4u || body_length > capacity - 4u) {
        return TC100_ERR_CAPACITY;
    }
    if (!((unit_address >= 1 && unit_address <= 16) || (unit_address == 0))) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u8(out + 0, (uint8_t)unit_address);
    if (code > 255u) {
        return TC100_ERR_UNKNOWN_CODE;
    }
    tc100_store_u8(out + 1, (uint8_t)code);
    tc100_store_u16_le(out + total - 2u, tc100_crc16_modbus(out, total - 2u));
    *length = total;
    return TC100_OK;
}

/** Writes the whole frame of the request read_registers_request. */
static inline tc100_codec_status tc100_rtu_encode_read_registers_request(uint8_t unit_address,
        const tc100_read_registers_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_read_registers_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    if (unit_address == 0) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    return tc100_rtu_request_close(unit_address, 3u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response read_registers_response. */
static inline tc100_codec_status tc100_rtu_encode_read_registers_response(uint8_t unit_address,
        const tc100_read_registers_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_read_registers_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_rtu_response_close(unit_address, 3u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request write_register_request. */
static inline tc100_codec_status tc100_rtu_encode_write_register_request(uint8_t unit_address,
        const tc100_write_register_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_write_register_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_rtu_request_close(unit_address, 6u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_register_response. */
static inline tc100_codec_status tc100_rtu_encode_write_register_response(uint8_t unit_address,
        const tc100_write_register_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_write_register_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_rtu_response_close(unit_address, 6u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request write_registers_request. */
static inline tc100_codec_status tc100_rtu_encode_write_registers_request(uint8_t unit_address,
        const tc100_write_registers_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_write_registers_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_rtu_request_close(unit_address, 16u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_registers_response. */
static inline tc100_codec_status tc100_rtu_encode_write_registers_response(uint8_t unit_address,
        const tc100_write_registers_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_write_registers_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_rtu_response_close(unit_address, 16u, body_length, out, capacity, length);
}

/** Writes the whole frame of an exception response to a code. */
static inline tc100_codec_status tc100_rtu_encode_exception_response(uint8_t unit_address, uint32_t code,
        const tc100_exception *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_exception_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_rtu_response_close(unit_address, code | 128u, body_length, out, capacity, length);
}

/**
 * RS-485 with two wires, half duplex, or USB.
 * Printed as ASCII 模式.
 * Frames are hexadecimal characters; they begin with 3A and end with 0D 0A.
 * Note: The vendor's software needs this mode.
 * Note: In two tables of 8.5 (L2046-2047, L2057-2058) the words for the high and the low byte have slipped
 * onto the rows of the LRC, which is one byte, and of the end mark.
 * Source: 8.1 L1463-1483; 5.8 L1275; 8.5 L2015, 2078, 2136
 */
/** Removes the delimiters and writes the bytes between them. `out` may be the frame itself. */
static inline tc100_codec_status tc100_ascii_parts(const uint8_t *frame, size_t size, uint8_t *out, size_t capacity,
        size_t *length)
{
    size_t at;
    if (size < 3u) {
        return TC100_ERR_WRONG_MARK;
    }
    if (frame[0] != 0x3Au || frame[size - 2u] != 0x0Du || frame[size - 1u] != 0x0Au) {
        return TC100_ERR_WRONG_MARK;
    }
    *length = size - 3u;
    for (at = 0; at < *length; at++) {
        if (tc100_digit(frame[1u + at]) > 15u) {
            return TC100_ERR_NOT_HEX;
        }
    }
    if (*length % 2u != 0) {
        return TC100_ERR_WRONG_LENGTH;
    }
    *length /= 2u;
    if (capacity < *length) {
        return TC100_ERR_CAPACITY;
    }
    for (at = 0; at < *length; at++) {
        out[at] = (uint8_t)(tc100_digit(frame[1u + 2u * at]) << 4 | tc100_digit(frame[2u + 2u * at]));
    }
    return TC100_OK;
}

/** An opened request: its header, and where its body is. */
typedef struct tc100_ascii_request_frame {
    /** Source: 8.5 L2022 */
    uint8_t unit_address;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    const uint8_t *body;
    size_t body_length;
} tc100_ascii_request_frame;

/**
 * Checks a frame and finds its body.
 * `buffer` receives the bytes of the frame, and the body points into it.
 */
static inline tc100_codec_status tc100_ascii_request_open(const uint8_t *frame, size_t size, uint8_t *buffer,
        size_t capacity, tc100_ascii_request_frame *out)
{
    const uint8_t *in = buffer;
    size_t length = 0;
    tc100_codec_status status;
    status = tc100_ascii_parts(frame, size, buffer, capacity, &length);
    if (status != TC100_OK) {
        return status;
    }
    if (length < 3u) {
        return TC100_ERR_INCOMPLETE;
    }
    if (tc100_lrc(in, length - 1u) != tc100_load_u8(in + length - 1u)) {
        return TC100_ERR_WRONG_CHECKSUM;
    }
    out->unit_address = tc100_load_u8(in + 0);
    out->code = tc100_load_u8(in + 1);
    if (out->code != 3u && out->code != 6u && out->code != 16u) {
        return TC100_ERR_UNKNOWN_CODE;
    }
    out->body = in + 2u;
    out->body_length = length - 3u;
    return TC100_OK;
}

/** Completes a frame whose body is at out + 2. `length` receives the size of the frame. */
static inline tc100_codec_status tc100_ascii_request_close(uint8_t unit_address, uint32_t code, size_t body_length,
        uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 3u;
    size_t at;
    if (capacity < 9u || body_length > (capacity - 9u) / 2u) {
        return TC100_ERR_CAPACITY;
    }
    if (!((unit_address >= 1 && unit_address <= 16) || (unit_address == 0))) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u8(out + 0, (uint8_t)unit_address);
    if (code > 255u) {
        return TC100_ERR_UNKNOWN_CODE;
    }
    tc100_store_u8(out + 1, (uint8_t)code);
    tc100_store_u8(out + total - 1u, tc100_lrc(out, total - 1u));
    for (at = total; at-- > 0;) {
        const uint8_t byte = out[at];
        out[1u + 2u * at] = tc100_hex_digit((uint8_t)(byte >> 4));
        out[2u + 2u * at] = tc100_hex_digit((uint8_t)(byte & 15u));
    }
    out[0] = 0x3A;
    out[1u + 2u * total + 0u] = 0x0D;
    out[1u + 2u * total + 1u] = 0x0A;
    *length = total * 2u + 3u;
    return TC100_OK;
}

/** An opened response: its header, and where its body is. */
typedef struct tc100_ascii_response_frame {
    /** Source: 8.5 L2022 */
    uint8_t unit_address;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    /** The frame is an exception response; its body is the record of the exception. */
    bool error;
    const uint8_t *body;
    size_t body_length;
} tc100_ascii_response_frame;

/**
 * Checks a frame and finds its body.
 * `buffer` receives the bytes of the frame, and the body points into it.
 */
static inline tc100_codec_status tc100_ascii_response_open(const uint8_t *frame, size_t size, uint8_t *buffer,
        size_t capacity, tc100_ascii_response_frame *out)
{
    const uint8_t *in = buffer;
    size_t length = 0;
    tc100_codec_status status;
    status = tc100_ascii_parts(frame, size, buffer, capacity, &length);
    if (status != TC100_OK) {
        return status;
    }
    if (length < 3u) {
        return TC100_ERR_INCOMPLETE;
    }
    if (tc100_lrc(in, length - 1u) != tc100_load_u8(in + length - 1u)) {
        return TC100_ERR_WRONG_CHECKSUM;
    }
    out->unit_address = tc100_load_u8(in + 0);
    out->code = tc100_load_u8(in + 1);
    out->error = (out->code & 128u) != 0;
    if (out->error) {
        out->code &= ~(uint32_t)128u;
    }
    if (!out->error && out->code != 3u && out->code != 6u && out->code != 16u) {
        return TC100_ERR_UNKNOWN_CODE;
    }
    out->body = in + 2u;
    out->body_length = length - 3u;
    return TC100_OK;
}

/** Completes a frame whose body is at out + 2. `length` receives the size of the frame. */
static inline tc100_codec_status tc100_ascii_response_close(uint8_t unit_address, uint32_t code, size_t body_length,
        uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 3u;
    size_t at;
    if (capacity < 9u || body_length > (capacity - 9u) / 2u) {
        return TC100_ERR_CAPACITY;
    }
    if (!((unit_address >= 1 && unit_address <= 16) || (unit_address == 0))) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u8(out + 0, (uint8_t)unit_address);
    if (code > 255u) {
        return TC100_ERR_UNKNOWN_CODE;
    }
    tc100_store_u8(out + 1, (uint8_t)code);
    tc100_store_u8(out + total - 1u, tc100_lrc(out, total - 1u));
    for (at = total; at-- > 0;) {
        const uint8_t byte = out[at];
        out[1u + 2u * at] = tc100_hex_digit((uint8_t)(byte >> 4));
        out[2u + 2u * at] = tc100_hex_digit((uint8_t)(byte & 15u));
    }
    out[0] = 0x3A;
    out[1u + 2u * total + 0u] = 0x0D;
    out[1u + 2u * total + 1u] = 0x0A;
    *length = total * 2u + 3u;
    return TC100_OK;
}

/** Writes the whole frame of the request read_registers_request. */
static inline tc100_codec_status tc100_ascii_encode_read_registers_request(uint8_t unit_address,
        const tc100_read_registers_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_read_registers_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    if (unit_address == 0) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    return tc100_ascii_request_close(unit_address, 3u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response read_registers_response. */
static inline tc100_codec_status tc100_ascii_encode_read_registers_response(uint8_t unit_address,
        const tc100_read_registers_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_read_registers_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_ascii_response_close(unit_address, 3u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request write_register_request. */
static inline tc100_codec_status tc100_ascii_encode_write_register_request(uint8_t unit_address,
        const tc100_write_register_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_write_register_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_ascii_request_close(unit_address, 6u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_register_response. */
static inline tc100_codec_status tc100_ascii_encode_write_register_response(uint8_t unit_address,
        const tc100_write_register_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_write_register_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_ascii_response_close(unit_address, 6u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request write_registers_request. */
static inline tc100_codec_status tc100_ascii_encode_write_registers_request(uint8_t unit_address,
        const tc100_write_registers_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_write_registers_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_ascii_request_close(unit_address, 16u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_registers_response. */
static inline tc100_codec_status tc100_ascii_encode_write_registers_response(uint8_t unit_address,
        const tc100_write_registers_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_write_registers_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_ascii_response_close(unit_address, 16u, body_length, out, capacity, length);
}

/** Writes the whole frame of an exception response to a code. */
static inline tc100_codec_status tc100_ascii_encode_exception_response(uint8_t unit_address, uint32_t code,
        const tc100_exception *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    tc100_codec_status status;
    if (capacity < 2u) {
        return TC100_ERR_CAPACITY;
    }
    status = tc100_exception_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != TC100_OK) {
        return status;
    }
    return tc100_ascii_response_close(unit_address, code | 128u, body_length, out, capacity, length);
}

/* ---- Texts of codes, in UTF-8 ---- */

#ifdef TC100_WITH_TEXTS
/** The texts of a code. Line ends separate several causes or remedies. `printed` is the code as the manual writes it;
 * `number` is the second number that the manual gives the code, or -1. */
typedef struct tc100_code_text {
    int64_t code;
    int64_t number;
    const char *printed;
    const char *name;
    const char *label;
    const char *problem;
    const char *causes;
    const char *remedies;
} tc100_code_text;

/** The texts of a code of tc100_exception_code, or NULL if the code is unknown. */
static inline const tc100_code_text *tc100_exception_code_text(int64_t code)
{
    static const tc100_code_text texts[] = {
        {INT64_C(1), (-INT64_C(1)), "", "illegal_function", "\345\212\237\350\203\275\347\242\274\351\214\257\350\252\244", "The function code is none of those that the controller knows.", "", ""},
        {INT64_C(2), (-INT64_C(1)), "", "illegal_data_address", "\347\253\231\350\231\237\351\214\257\350\252\244", "A register that can only be written was read, one that can only be read was written, or there is no such register.", "", ""},
        {INT64_C(3), (-INT64_C(1)), "", "illegal_data_value", "\350\263\207\346\226\231\351\214\257\350\252\244", "A value is out of its range, too many words were asked for, a parameter cannot be changed, or number and data do not fit.", "", ""},
    };
    size_t at;
    for (at = 0; at < sizeof texts / sizeof texts[0]; at++) {
        if (texts[at].code == code) {
            return &texts[at];
        }
    }
    return NULL;
}

/** The texts of a code of tc100_alarm_code, or NULL if the code is unknown. */
static inline const tc100_code_text *tc100_alarm_code_text(int64_t code)
{
    static const tc100_code_text texts[] = {
        {INT64_C(0), (-INT64_C(1)), "", "no_alarm", "\347\204\241\350\255\246\345\240\261", "", "", ""},
        {INT64_C(1), (-INT64_C(1)), "", "loop_error", "Loop error", "", "The load is too heavy.\nThe motor does not follow the frequency of the pulse command.\nThe motor cable is broken.", "Reduce the load.\nKeep the highest pulse frequency below the motor's rated speed.\nCheck the motor wiring."},
        {INT64_C(2), (-INT64_C(1)), "", "full_count", "Full Count", "The difference of the actual and the commanded position exceeds the limit of register 0108H.", "The load is too heavy.\nThe motor does not follow the frequency of the pulse command.\nThe motor cable is broken.", "Lengthen the acceleration and deceleration times.\nKeep the highest pulse frequency below the motor's rated speed.\nCheck the motor wiring."},
        {INT64_C(3), (-INT64_C(1)), "", "overspeed", "\351\201\216\351\200\237\345\272\246", "", "The motor turns too fast.", "Keep the highest pulse frequency below the motor's rated speed."},
        {INT64_C(4), (-INT64_C(1)), "", "gain_adjustment_error", "\345\242\236\347\233\212\345\200\274\350\252\277\346\225\264\344\270\215\350\211\257", "", "Wrong gains make the motor vibrate.\nPulses come without acceleration and deceleration.", "Set the gains anew.\nSet acceleration and deceleration anew."},
        {INT64_C(5), (-INT64_C(1)), "", "overvoltage", "\351\201\216\351\233\273\345\243\223", "", "Regenerated energy raises the voltage of the main circuit.", "Lengthen the acceleration and deceleration times.\nReduce the inertia of the load.\nAdd a regeneration resistor."},
        {INT64_C(6), (-INT64_C(1)), "", "initialization_error", "\345\210\235\346\234\237\345\214\226\347\225\260\345\270\270", "", "The supply was switched on with more than the rated load.", "Reduce the load."},
        {INT64_C(7), (-INT64_C(1)), "", "eeprom_error", "EEPROM \347\225\260\345\270\270", "", "The data in the EEPROM are damaged.", "Ask the maker or the dealer."},
        {INT64_C(8), (-INT64_C(1)), "", "main_circuit_undervoltage", "\344\270\273\350\277\264\350\267\257\351\233\273\346\272\220\351\233\273\345\243\223\344\270\215\350\266\263", "", "The supply of the main circuit is below its voltage.", "Check whether the power supply is strong enough; use a larger one."},
        {INT64_C(9), (-INT64_C(1)), "", "overcurrent", "\351\201\216\351\233\273\346\265\201", "", "A winding of the motor is shorted.\nThe controller's circuit is damaged.", "Replace the motor.\nReplace the controller."},
        {INT64_C(10), (-INT64_C(1)), "", "regeneration_error", "\345\233\236\347\224\237\347\225\260\345\270\270", "", "The internal circuit that absorbs energy has reached its limit.", "Add a regeneration resistor."},
        {INT64_C(11), (-INT64_C(1)), "", "emergency_stop", "\347\267\212\346\200\245\345\201\234\346\255\242", "", "The emergency stop input is off.", "Check the emergency stop circuit, or replace the switch."},
        {INT64_C(12), (-INT64_C(1)), "", "motor_disconnected", "\351\246\254\351\201\224\346\226\267\347\267\232", "", "Phase A or B of the motor is broken.", "Check the motor wiring."},
        {INT64_C(13), (-INT64_C(1)), "", "encoder_disconnected", "\347\267\250\347\242\274\345\231\250\346\226\267\347\267\232", "", "Phase A or B of the encoder is broken.", "Check the encoder wiring."},
        {INT64_C(14), (-INT64_C(1)), "", "current_protection", "\344\277\235\350\255\267\351\233\273\346\265\201\345\200\274", "", "The motor current was above the set value for the set time.", "Look for overload, or for other parts of the machine in the way."},
        {INT64_C(15), (-INT64_C(1)), "", "power_cycle_required", "\351\233\273\346\272\220\345\206\215\346\212\225\345\205\245", "", "", ""},
        {INT64_C(17), (-INT64_C(1)), "", "action_timeout", "\345\213\225\344\275\234\350\266\205\346\231\202", "", "The action did not end within the set time.", "Check the mechanism, or set a value that suits."},
    };
    size_t at;
    for (at = 0; at < sizeof texts / sizeof texts[0]; at++) {
        if (texts[at].code == code) {
            return &texts[at];
        }
    }
    return NULL;
}

/** The texts of a code of tc100_fault_code, or NULL if the code is unknown. */
static inline const tc100_code_text *tc100_fault_code_text(int64_t code)
{
    static const tc100_code_text texts[] = {
        {INT64_C(0), (-INT64_C(1)), "", "no_fault", "\346\262\222\346\234\211\351\214\257\350\252\244", "", "", ""},
        {INT64_C(1), (-INT64_C(1)), "", "motion_command_while_moving", "\345\234\250\345\213\225\344\275\234\344\270\255\346\216\245\346\224\266\345\213\225\344\275\234\346\214\207\344\273\244", "", "A motion or a program was commanded during a motion.\nA parameter that must not be changed during a motion was written then.\nData of a program were set while the program ran.", "Stop the motor and the program first.\nStop the motor and the program first.\nStop the motor and the program first."},
        {INT64_C(2), (-INT64_C(1)), "", "value_out_of_limits", "\344\270\212\344\270\213\351\231\220\351\214\257\350\252\244", "", "A value outside its range was written.", "Write a value within the range."},
        {INT64_C(3), (-INT64_C(1)), "", "address_error", "\344\275\215\347\275\256\351\214\257\350\252\244", "", "A read asked for more words than are allowed.", "Stay within the number of words."},
        {INT64_C(4), (-INT64_C(1)), "", "format_error", "\346\240\274\345\274\217\351\214\257\350\252\244", "", "A write had more words than are allowed.", "Stay within the number of words."},
        {INT64_C(5), (-INT64_C(1)), "", "control_mode_error", "\346\216\247\345\210\266\346\250\241\345\274\217\351\214\257\350\252\244", "", "The command belongs to another control mode.", "Compare the parameter 0503H with the input CONT_MODE, then command again."},
        {INT64_C(6), (-INT64_C(1)), "", "power_cycle_required", "\346\226\267\351\233\273\351\207\215\351\226\213", "", "A parameter was written that takes effect after a restart.", "Switch the control supply off and on."},
        {INT64_C(7), (-INT64_C(1)), "", "initialization_incomplete", "\345\210\235\345\247\213\345\214\226\346\234\252\345\256\214\346\210\220", "", "A motion was commanded, by input or line, before the initialization had ended.", "Wait for its end, then command."},
        {INT64_C(8), (-INT64_C(1)), "", "servo_on_off_error", "Servo ON/OFF \351\214\257\350\252\244", "", "A motion was commanded while the servo was off.\nAn alarm reset was commanded while the servo was on.", "Switch the servo on first.\nSwitch the servo off with 1 in 2011H, then write 6 to 201EH."},
        {INT64_C(9), (-INT64_C(1)), "", "lock_active", "LOCK", "", "A motion was commanded while the signal LOCK was on.\nThe signal LOCK came on during a motion.", "Switch LOCK off, then command.\nSwitch LOCK off, then command."},
        {INT64_C(10), (-INT64_C(1)), "", "soft_limit_reached", "\350\273\237\351\253\224\346\245\265\351\231\220", "", "The position has reached a soft limit.", "Command motions within the soft limits."},
        {INT64_C(11), (-INT64_C(1)), "", "parameter_write_not_permitted", "\345\217\203\346\225\270\345\257\253\345\205\245\346\254\212\351\231\220\344\270\215\350\266\263", "", "The right to write the parameter is missing.", "Raise the level for writing parameters."},
        {INT64_C(12), (-INT64_C(1)), "", "homing_incomplete", "\345\216\237\351\273\236\345\276\251\346\255\270\346\234\252\345\256\214\346\210\220", "", "A motion or a program was commanded before homing was complete.", "Carry out homing, or lift the restriction with 0 in 051BH."},
        {INT64_C(13), (-INT64_C(1)), "", "brake_released", "\345\211\216\350\273\212\345\267\262\350\247\243\351\231\244", "", "The servo was switched while the command to release the brake was in effect.", "End that command first."},
    };
    size_t at;
    for (at = 0; at < sizeof texts / sizeof texts[0]; at++) {
        if (texts[at].code == code) {
            return &texts[at];
        }
    }
    return NULL;
}
#endif

/* ---- Values that stand for a state ---- */

/** Whether point.speed is not a quantity: start_speed. */
static inline bool tc100_point_speed_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point.next_point is not a quantity: end. */
static inline bool tc100_point_next_point_is_absent(int16_t value)
{
    return value == (-1);
}

/** Whether jog_positive_input is not a quantity: not_used. */
static inline bool tc100_reg_jog_positive_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether jog_negative_input is not a quantity: not_used. */
static inline bool tc100_reg_jog_negative_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether manual_mode_input is not a quantity: not_used. */
static inline bool tc100_reg_manual_mode_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether teach_input is not a quantity: not_used. */
static inline bool tc100_reg_teach_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether lock_input is not a quantity: not_used. */
static inline bool tc100_reg_lock_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point_select_bit_4_input is not a quantity: not_used. */
static inline bool tc100_reg_point_select_bit_4_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point_select_bit_5_input is not a quantity: not_used. */
static inline bool tc100_reg_point_select_bit_5_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point_select_bit_6_input is not a quantity: not_used. */
static inline bool tc100_reg_point_select_bit_6_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether homing_sensor_input is not a quantity: not_used. */
static inline bool tc100_reg_homing_sensor_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether brake_input is not a quantity: not_used. */
static inline bool tc100_reg_brake_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether full_count_input is not a quantity: not_used. */
static inline bool tc100_reg_full_count_input_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether in_position_output is not a quantity: not_used. */
static inline bool tc100_reg_in_position_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether alarm_output is not a quantity: not_used. */
static inline bool tc100_reg_alarm_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether ready_output is not a quantity: not_used. */
static inline bool tc100_reg_ready_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether moving_output is not a quantity: not_used. */
static inline bool tc100_reg_moving_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether servo_on_output is not a quantity: not_used. */
static inline bool tc100_reg_servo_on_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point_select_bit_0_output is not a quantity: not_used. */
static inline bool tc100_reg_point_select_bit_0_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point_select_bit_1_output is not a quantity: not_used. */
static inline bool tc100_reg_point_select_bit_1_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point_select_bit_2_output is not a quantity: not_used. */
static inline bool tc100_reg_point_select_bit_2_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point_select_bit_3_output is not a quantity: not_used. */
static inline bool tc100_reg_point_select_bit_3_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point_select_bit_4_output is not a quantity: not_used. */
static inline bool tc100_reg_point_select_bit_4_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point_select_bit_5_output is not a quantity: not_used. */
static inline bool tc100_reg_point_select_bit_5_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether point_select_bit_6_output is not a quantity: not_used. */
static inline bool tc100_reg_point_select_bit_6_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether torque_limit_output is not a quantity: not_used. */
static inline bool tc100_reg_torque_limit_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether error_bit_0_output is not a quantity: not_used. */
static inline bool tc100_reg_error_bit_0_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether error_bit_1_output is not a quantity: not_used. */
static inline bool tc100_reg_error_bit_1_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether error_bit_2_output is not a quantity: not_used. */
static inline bool tc100_reg_error_bit_2_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether error_bit_3_output is not a quantity: not_used. */
static inline bool tc100_reg_error_bit_3_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether zone_output is not a quantity: not_used. */
static inline bool tc100_reg_zone_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether near_output is not a quantity: not_used. */
static inline bool tc100_reg_near_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether soft_limit_output is not a quantity: not_used. */
static inline bool tc100_reg_soft_limit_output_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether motion_speed is not a quantity: start_speed. */
static inline bool tc100_reg_motion_speed_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether soft_limit_positive is not a quantity: no_limit. */
static inline bool tc100_reg_soft_limit_positive_is_absent(int32_t value)
{
    return value == 0;
}

/** Whether soft_limit_negative is not a quantity: no_limit. */
static inline bool tc100_reg_soft_limit_negative_is_absent(int32_t value)
{
    return value == 0;
}

/** Whether homing_speed is not a quantity: start_speed. */
static inline bool tc100_reg_homing_speed_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether homing_offset_speed is not a quantity: start_speed. */
static inline bool tc100_reg_homing_offset_speed_is_absent(uint16_t value)
{
    return value == 0u;
}

/** Whether executed_point is not a quantity: none. */
static inline bool tc100_reg_executed_point_is_absent(int16_t value)
{
    return value == (-1);
}

/* ---- Values out of range ---- */

/** Whether exception.exception_code is outside of its stated range. */
static inline bool tc100_exception_exception_code_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 3u);
}

/** Whether point.mode is outside of its stated range. */
static inline bool tc100_point_mode_is_out_of_range(uint16_t value)
{
    return !(value <= 16u);
}

/** Whether point.speed is outside of its stated range. */
static inline bool tc100_point_speed_is_out_of_range(uint16_t value)
{
    return !(value <= 100u);
}

/** Whether point.torque_limit is outside of its stated range. */
static inline bool tc100_point_torque_limit_is_out_of_range(uint16_t value)
{
    return !(value <= 1000u);
}

/** Whether point.acceleration_time is outside of its stated range. */
static inline bool tc100_point_acceleration_time_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 30000u);
}

/** Whether point.deceleration_time is outside of its stated range. */
static inline bool tc100_point_deceleration_time_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 30000u);
}

/** Whether point.wait_time is outside of its stated range. */
static inline bool tc100_point_wait_time_is_out_of_range(uint16_t value)
{
    return !(value <= 30000u);
}

/** Whether point.next_point is outside of its stated range. */
static inline bool tc100_point_next_point_is_out_of_range(int16_t value)
{
    return !((value == (-1)) || (value >= 1 && value <= 127));
}

/** Whether read_registers_request.word_count is outside of its stated range. */
static inline bool tc100_read_registers_request_word_count_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 60u);
}

/** Whether read_registers_response.byte_count is outside of its stated range. */
static inline bool tc100_read_registers_response_byte_count_is_out_of_range(uint8_t value)
{
    return !(value >= 2u && value <= 120u);
}

/** Whether write_registers_request.word_count is outside of its stated range. */
static inline bool tc100_write_registers_request_word_count_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 59u);
}

/** Whether write_registers_request.byte_count is outside of its stated range. */
static inline bool tc100_write_registers_request_byte_count_is_out_of_range(uint8_t value)
{
    return !(value >= 2u && value <= 118u);
}

/** Whether write_registers_response.word_count is outside of its stated range. */
static inline bool tc100_write_registers_response_word_count_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 59u);
}

/** Whether motion_speed is outside of its stated range. */
static inline bool tc100_reg_motion_speed_is_out_of_range(uint16_t value)
{
    return !(value <= 100u);
}

/** Whether simulated_inputs is outside of its stated range. */
static inline bool tc100_reg_simulated_inputs_is_out_of_range(uint16_t value)
{
    return !(value <= 16383u);
}

/** Whether full_count_limit is outside of its stated range. */
static inline bool tc100_reg_full_count_limit_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 100000u);
}

/** Whether in_position_zone is outside of its stated range. */
static inline bool tc100_reg_in_position_zone_is_out_of_range(uint16_t value)
{
    return !(value <= 1000u);
}

/** Whether electronic_gear_numerator is outside of its stated range. */
static inline bool tc100_reg_electronic_gear_numerator_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 10000u);
}

/** Whether electronic_gear_denominator is outside of its stated range. */
static inline bool tc100_reg_electronic_gear_denominator_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 10000u);
}

/** Whether near_zone is outside of its stated range. */
static inline bool tc100_reg_near_zone_is_out_of_range(uint16_t value)
{
    return !(value <= 10000u);
}

/** Whether push_torque_positive is outside of its stated range. */
static inline bool tc100_reg_push_torque_positive_is_out_of_range(uint16_t value)
{
    return !(value <= 1000u);
}

/** Whether push_torque_negative is outside of its stated range. */
static inline bool tc100_reg_push_torque_negative_is_out_of_range(uint16_t value)
{
    return !(value <= 1000u);
}

/** Whether torque_limit_time is outside of its stated range. */
static inline bool tc100_reg_torque_limit_time_is_out_of_range(uint16_t value)
{
    return !(value <= 10000u);
}

/** Whether position_correction_speed_limit is outside of its stated range. */
static inline bool tc100_reg_position_correction_speed_limit_is_out_of_range(uint16_t value)
{
    return !(value >= 10u && value <= 500u);
}

/** Whether maximum_torque is outside of its stated range. */
static inline bool tc100_reg_maximum_torque_is_out_of_range(uint16_t value)
{
    return !(value <= 650u);
}

/** Whether full_torque_time is outside of its stated range. */
static inline bool tc100_reg_full_torque_time_is_out_of_range(uint16_t value)
{
    return !(value >= 500u && value <= 10000u);
}

/** Whether acceleration_time is outside of its stated range. */
static inline bool tc100_reg_acceleration_time_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 30000u);
}

/** Whether deceleration_time is outside of its stated range. */
static inline bool tc100_reg_deceleration_time_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 30000u);
}

/** Whether jog_speed is outside of its stated range. */
static inline bool tc100_reg_jog_speed_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 1000u);
}

/** Whether jog_wait_time is outside of its stated range. */
static inline bool tc100_reg_jog_wait_time_is_out_of_range(uint16_t value)
{
    return !(value <= 1000u);
}

/** Whether homing_speed is outside of its stated range. */
static inline bool tc100_reg_homing_speed_is_out_of_range(uint16_t value)
{
    return !(value <= 100u);
}

/** Whether homing_offset_speed is outside of its stated range. */
static inline bool tc100_reg_homing_offset_speed_is_out_of_range(uint16_t value)
{
    return !(value <= 100u);
}

/** Whether homing_torque_limit is outside of its stated range. */
static inline bool tc100_reg_homing_torque_limit_is_out_of_range(uint16_t value)
{
    return !(value <= 1000u);
}

/** Whether homing_torque_limit_time is outside of its stated range. */
static inline bool tc100_reg_homing_torque_limit_time_is_out_of_range(uint16_t value)
{
    return !(value <= 1000u);
}

/** Whether homing_z_phase_speed_1 is outside of its stated range. */
static inline bool tc100_reg_homing_z_phase_speed_1_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 100u);
}

/** Whether homing_z_phase_speed_2 is outside of its stated range. */
static inline bool tc100_reg_homing_z_phase_speed_2_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 100u);
}

/** Whether executed_point is outside of its stated range. */
static inline bool tc100_reg_executed_point_is_out_of_range(int16_t value)
{
    return !(value >= (-1) && value <= 127);
}

/** Whether output_states is outside of its stated range. */
static inline bool tc100_reg_output_states_is_out_of_range(uint16_t value)
{
    return !(value <= 1023u);
}

/** Whether input_states is outside of its stated range. */
static inline bool tc100_reg_input_states_is_out_of_range(uint16_t value)
{
    return !(value <= 32767u);
}

#endif
