/*
 * CK10 (unknown), version 1
 * From: CK10 series, Modbus communication, user manual
 * Identity: fdc1e9665defc19d
 *
 * Generated; do not edit. For C99 and later and C++98 to C++20, hosted or freestanding, with any byte order, any alignment and an
 * int of 16 bits or more. Headers from this generator compile without warnings with gcc and clang, and pass cppcheck. Their
 * self-tests pass on x86-64, AArch64, m68k (big-endian; int of 32 and 16 bits) and Cortex-M0, and under sanitizers; their fuzz
 * targets find nothing.
 *
 * Define before you include it:
 *   CK10_WITH_TEXTS adds the texts of codes, which take memory
 *   CK10_WIDE_CRC_TABLE takes a table of 512 bytes for a faster CRC
 */
#include "ck10_v1_constants.h"
#ifndef CK10_INCLUDED
#define CK10_INCLUDED

/* ---- Compilers and machines ---- */

#ifdef __GNUC__
/** A call would take more code than the function itself, even with -Os. */
#define CK10_INLINE static inline __attribute__((always_inline))
#define CK10_LIKELY(test) __builtin_expect(!!(test), 1)
/** Built-in functions need no string.h, and no call for a few bytes, also in freestanding code. */
#define CK10_COPY(to, from, size) __builtin_memcpy((to), (from), (size))
#define CK10_CLEAR(to, size) __builtin_memset((to), 0, (size))
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ && \
    (defined(__x86_64__) || defined(__i386__) || defined(__aarch64__) || defined(__ARM_FEATURE_UNALIGNED))
/**
 * Store a number with one instruction. Compilers merge loads of single bytes by themselves, and mostly stores
 * too. Where they may reorder stores, they build vectors instead, which take up to four times as long.
 */
#define CK10_STORES_AT_ONCE
#endif
#else
#include <string.h>
#define CK10_INLINE static inline
#define CK10_LIKELY(test) (test)
#define CK10_COPY(to, from, size) memcpy((to), (from), (size))
#define CK10_CLEAR(to, size) memset((to), 0, (size))
#endif

/* ---- Results of codec calls ---- */

/** The result of a codec call. */
typedef enum ck10_codec_status {
    CK10_OK = 0, /**< No error. */
    CK10_ERR_INCOMPLETE = 1, /**< There are too few bytes. */
    CK10_ERR_WRONG_LENGTH = 2, /**< The number of bytes or elements is wrong. */
    CK10_ERR_WRONG_MARK = 3, /**< A delimiter of the frame is missing or wrong. */
    CK10_ERR_NOT_HEX = 4, /**< A character is not a hexadecimal digit. */
    CK10_ERR_WRONG_CHECKSUM = 5, /**< The checksum does not match. */
    CK10_ERR_UNKNOWN_CODE = 6, /**< No message has this code. */
    CK10_ERR_UNKNOWN_VALUE = 7, /**< The value is not a member of its enum, or the text is not ASCII. */
    CK10_ERR_WRONG_CONST = 8, /**< A constant field has another value. */
    CK10_ERR_WRONG_MEASURE = 9, /**< A length or count field does not match the data. */
    CK10_ERR_OUT_OF_RANGE = 10, /**< A value is out of range. */
    CK10_ERR_CAPACITY = 11 /**< The buffer is too small. */
} ck10_codec_status;

/* ---- Numbers and characters ---- */

CK10_INLINE uint8_t ck10_load_u8(const uint8_t *in)
{
    return in[0];
}

CK10_INLINE void ck10_store_u8(uint8_t *out, uint8_t value)
{
    out[0] = value;
}

CK10_INLINE uint16_t ck10_load_u16_be(const uint8_t *in)
{
    return (uint16_t)(((uint32_t)in[0] << 8) | (uint32_t)in[1]);
}

CK10_INLINE void ck10_store_u16_be(uint8_t *out, uint16_t value)
{
#ifdef CK10_STORES_AT_ONCE
    value = __builtin_bswap16(value);
    CK10_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)(value >> 8);
    out[1] = (uint8_t)value;
#endif
}

CK10_INLINE uint16_t ck10_load_u16_le(const uint8_t *in)
{
    return (uint16_t)((uint32_t)in[0] | ((uint32_t)in[1] << 8));
}

CK10_INLINE void ck10_store_u16_le(uint8_t *out, uint16_t value)
{
#ifdef CK10_STORES_AT_ONCE
    CK10_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)value;
    out[1] = (uint8_t)(value >> 8);
#endif
}

CK10_INLINE uint32_t ck10_load_u32_be(const uint8_t *in)
{
    return ((uint32_t)in[0] << 24) | ((uint32_t)in[1] << 16) |
           ((uint32_t)in[2] << 8) | (uint32_t)in[3];
}

CK10_INLINE void ck10_store_u32_be(uint8_t *out, uint32_t value)
{
#ifdef CK10_STORES_AT_ONCE
    value = __builtin_bswap32(value);
    CK10_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)(value >> 24);
    out[1] = (uint8_t)(value >> 16);
    out[2] = (uint8_t)(value >> 8);
    out[3] = (uint8_t)value;
#endif
}

CK10_INLINE uint64_t ck10_load_u64_be(const uint8_t *in)
{
    return ((uint64_t)in[0] << 56) | ((uint64_t)in[1] << 48) |
           ((uint64_t)in[2] << 40) | ((uint64_t)in[3] << 32) |
           ((uint64_t)in[4] << 24) | ((uint64_t)in[5] << 16) |
           ((uint64_t)in[6] << 8) | (uint64_t)in[7];
}

CK10_INLINE void ck10_store_u64_be(uint8_t *out, uint64_t value)
{
#ifdef CK10_STORES_AT_ONCE
    value = __builtin_bswap64(value);
    CK10_COPY(out, &value, sizeof value);
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

CK10_INLINE int8_t ck10_signed_8(uint8_t raw)
{
    return (int8_t)((raw & 0x80u) ? -(int32_t)(uint8_t)~raw - 1 : (int32_t)raw);
}

CK10_INLINE int16_t ck10_signed_16(uint16_t raw)
{
    return (int16_t)((raw & 0x8000u) ? -(int32_t)(uint16_t)~raw - 1 : (int32_t)raw);
}

CK10_INLINE int32_t ck10_signed_32(uint32_t raw)
{
    return (int32_t)((raw & 0x80000000u) ? -(int32_t)(uint32_t)~raw - 1 : (int32_t)raw);
}

CK10_INLINE int64_t ck10_signed_64(uint64_t raw)
{
    return (int64_t)((raw & UINT64_C(0x8000000000000000)) ? -(int64_t)(uint64_t)~raw - 1 : (int64_t)raw);
}

/** The value of a hexadecimal digit; more than 15 for any other character. */
static inline uint8_t ck10_digit(uint8_t character)
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

static inline uint8_t ck10_hex_digit(uint8_t value)
{
    return (uint8_t)(value < 10u ? value + 0x30u : value + 0x37u);
}

/* ---- Checksums ---- */

/**
 * CRC-16, polynomial 0xA001 reflected, start value 0xFFFF.
 * Define CK10_WIDE_CRC_TABLE for a table of 512 bytes.
 */
static inline uint16_t ck10_crc16_modbus(const uint8_t *in, size_t size)
{
#ifdef CK10_WIDE_CRC_TABLE
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
static inline uint8_t ck10_lrc(const uint8_t *in, size_t size)
{
    uint32_t sum = 0;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        sum += in[offset];
    }
    return (uint8_t)((0u - sum) & 0xFFu);
}

/* ---- Enums and codes ---- */

/** Whether a value is one of ck10_push_status. */
static inline bool ck10_push_status_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(3));
}

/** Whether a value is one of ck10_move_kind. */
static inline bool ck10_move_kind_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(1) && value <= INT64_C(2));
}

/** Whether a value is one of ck10_jog_direction. */
static inline bool ck10_jog_direction_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of ck10_push_mode. */
static inline bool ck10_push_mode_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of ck10_stop_kind. */
static inline bool ck10_stop_kind_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of ck10_point_table_command. */
static inline bool ck10_point_table_command_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(1) && value <= INT64_C(3));
}

/** Whether a value is one of ck10_soft_limit_stop. */
static inline bool ck10_soft_limit_stop_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(2));
}

/** Whether a value is one of ck10_hard_limit_stop. */
static inline bool ck10_hard_limit_stop_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of ck10_homing_method. */
static inline bool ck10_homing_method_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(7));
}

/** Whether a value is one of ck10_rotation. */
static inline bool ck10_rotation_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of ck10_emergency_stop_mode. */
static inline bool ck10_emergency_stop_mode_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(4));
}

/** Whether a value is one of ck10_emergency_brake_mode. */
static inline bool ck10_emergency_brake_mode_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of ck10_operation_mode. */
static inline bool ck10_operation_mode_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(5));
}

/** Whether a value is one of ck10_switch_function. */
static inline bool ck10_switch_function_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of ck10_baud_rate. */
static inline bool ck10_baud_rate_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(4));
}

/** Whether a value is one of ck10_enabled. */
static inline bool ck10_enabled_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of ck10_polarity. */
static inline bool ck10_polarity_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of ck10_point_command. */
static inline bool ck10_point_command_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(11));
}

/** Whether a value is one of ck10_output_moment. */
static inline bool ck10_output_moment_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(2));
}

/** Whether a value is one of ck10_check_in_position. */
static inline bool ck10_check_in_position_known(int64_t value)
{
    return CK10_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/* ---- Bit fields ---- */

static inline bool ck10_motion_status_error(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_ERROR_MASK) != 0;
}

static inline bool ck10_motion_status_positive_hard_limit(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_POSITIVE_HARD_LIMIT_MASK) != 0;
}

static inline bool ck10_motion_status_negative_hard_limit(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_NEGATIVE_HARD_LIMIT_MASK) != 0;
}

static inline bool ck10_motion_status_positive_soft_limit(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_POSITIVE_SOFT_LIMIT_MASK) != 0;
}

static inline bool ck10_motion_status_negative_soft_limit(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_NEGATIVE_SOFT_LIMIT_MASK) != 0;
}

static inline bool ck10_motion_status_position_overflow(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_POSITION_OVERFLOW_MASK) != 0;
}

static inline bool ck10_motion_status_overcurrent(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_OVERCURRENT_MASK) != 0;
}

static inline bool ck10_motion_status_overspeed(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_OVERSPEED_MASK) != 0;
}

static inline bool ck10_motion_status_position_tracking(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_POSITION_TRACKING_MASK) != 0;
}

static inline bool ck10_motion_status_overload(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_OVERLOAD_MASK) != 0;
}

static inline bool ck10_motion_status_overheat(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_OVERHEAT_MASK) != 0;
}

static inline bool ck10_motion_status_back_emf(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_BACK_EMF_MASK) != 0;
}

static inline bool ck10_motion_status_in_position_error(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_IN_POSITION_ERROR_MASK) != 0;
}

static inline bool ck10_motion_status_emergency_stop(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_EMERGENCY_STOP_MASK) != 0;
}

static inline bool ck10_motion_status_slow_stop(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_SLOW_STOP_MASK) != 0;
}

static inline bool ck10_motion_status_homing(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_HOMING_MASK) != 0;
}

static inline bool ck10_motion_status_in_position(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_IN_POSITION_MASK) != 0;
}

static inline bool ck10_motion_status_servo_on(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_SERVO_ON_MASK) != 0;
}

static inline bool ck10_motion_status_alarm_reset(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_ALARM_RESET_MASK) != 0;
}

static inline bool ck10_motion_status_point_table_stopped(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_POINT_TABLE_STOPPED_MASK) != 0;
}

static inline bool ck10_motion_status_origin_sensor(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_ORIGIN_SENSOR_MASK) != 0;
}

static inline bool ck10_motion_status_z_pulse(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_Z_PULSE_MASK) != 0;
}

static inline bool ck10_motion_status_homing_complete(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_HOMING_COMPLETE_MASK) != 0;
}

static inline bool ck10_motion_status_direction(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_DIRECTION_MASK) != 0;
}

static inline bool ck10_motion_status_moving(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_MOVING_MASK) != 0;
}

static inline bool ck10_motion_status_accelerating(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_ACCELERATING_MASK) != 0;
}

static inline bool ck10_motion_status_decelerating(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_DECELERATING_MASK) != 0;
}

static inline bool ck10_motion_status_constant_speed(uint32_t word)
{
    return (word & CK10_MOTION_STATUS_CONSTANT_SPEED_MASK) != 0;
}

static inline bool ck10_input_signals_positive_limit(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_POSITIVE_LIMIT_MASK) != 0;
}

static inline bool ck10_input_signals_negative_limit(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_NEGATIVE_LIMIT_MASK) != 0;
}

static inline bool ck10_input_signals_origin(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_ORIGIN_MASK) != 0;
}

static inline bool ck10_input_signals_clear_position(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_CLEAR_POSITION_MASK) != 0;
}

static inline bool ck10_input_signals_point_address_0(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_POINT_ADDRESS_0_MASK) != 0;
}

static inline bool ck10_input_signals_point_address_1(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_POINT_ADDRESS_1_MASK) != 0;
}

static inline bool ck10_input_signals_point_address_2(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_POINT_ADDRESS_2_MASK) != 0;
}

static inline bool ck10_input_signals_point_address_3(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_POINT_ADDRESS_3_MASK) != 0;
}

static inline bool ck10_input_signals_point_address_4(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_POINT_ADDRESS_4_MASK) != 0;
}

static inline bool ck10_input_signals_point_address_5_or_user_6(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_POINT_ADDRESS_5_OR_USER_6_MASK) != 0;
}

static inline bool ck10_input_signals_point_address_6_or_user_7(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_POINT_ADDRESS_6_OR_USER_7_MASK) != 0;
}

static inline bool ck10_input_signals_point_address_7_or_user_8(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_POINT_ADDRESS_7_OR_USER_8_MASK) != 0;
}

static inline bool ck10_input_signals_start_point_table(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_START_POINT_TABLE_MASK) != 0;
}

static inline bool ck10_input_signals_stop(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_STOP_MASK) != 0;
}

static inline bool ck10_input_signals_jog_positive(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_JOG_POSITIVE_MASK) != 0;
}

static inline bool ck10_input_signals_jog_negative(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_JOG_NEGATIVE_MASK) != 0;
}

static inline bool ck10_input_signals_reset_alarm(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_RESET_ALARM_MASK) != 0;
}

static inline bool ck10_input_signals_servo_on(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_SERVO_ON_MASK) != 0;
}

static inline bool ck10_input_signals_start_homing(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_START_HOMING_MASK) != 0;
}

static inline bool ck10_input_signals_emergency_stop(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_EMERGENCY_STOP_MASK) != 0;
}

static inline bool ck10_input_signals_jump_0(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_JUMP_0_MASK) != 0;
}

static inline bool ck10_input_signals_jump_1(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_JUMP_1_MASK) != 0;
}

static inline bool ck10_input_signals_jump_2(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_JUMP_2_MASK) != 0;
}

static inline bool ck10_input_signals_start_jump(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_START_JUMP_MASK) != 0;
}

static inline bool ck10_input_signals_user_0(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_USER_0_MASK) != 0;
}

static inline bool ck10_input_signals_user_1(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_USER_1_MASK) != 0;
}

static inline bool ck10_input_signals_user_2(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_USER_2_MASK) != 0;
}

static inline bool ck10_input_signals_user_3(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_USER_3_MASK) != 0;
}

static inline bool ck10_input_signals_user_4(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_USER_4_MASK) != 0;
}

static inline bool ck10_input_signals_user_5(uint32_t word)
{
    return (word & CK10_INPUT_SIGNALS_USER_5_MASK) != 0;
}

static inline bool ck10_output_signals_compare_output(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_COMPARE_OUTPUT_MASK) != 0;
}

static inline bool ck10_output_signals_in_position(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_IN_POSITION_MASK) != 0;
}

static inline bool ck10_output_signals_alarm(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_ALARM_MASK) != 0;
}

static inline bool ck10_output_signals_moving(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_MOVING_MASK) != 0;
}

static inline bool ck10_output_signals_accelerating_or_decelerating(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_ACCELERATING_OR_DECELERATING_MASK) != 0;
}

static inline bool ck10_output_signals_acknowledge(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_ACKNOWLEDGE_MASK) != 0;
}

static inline bool ck10_output_signals_end(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_END_MASK) != 0;
}

static inline bool ck10_output_signals_alarm_blink(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_ALARM_BLINK_MASK) != 0;
}

static inline bool ck10_output_signals_homing_complete(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_HOMING_COMPLETE_MASK) != 0;
}

static inline bool ck10_output_signals_servo_ready(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_SERVO_READY_MASK) != 0;
}

static inline bool ck10_output_signals_point_output_0(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_POINT_OUTPUT_0_MASK) != 0;
}

static inline bool ck10_output_signals_point_output_1(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_POINT_OUTPUT_1_MASK) != 0;
}

static inline bool ck10_output_signals_point_output_2(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_POINT_OUTPUT_2_MASK) != 0;
}

static inline bool ck10_output_signals_user_0(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_USER_0_MASK) != 0;
}

static inline bool ck10_output_signals_user_1(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_USER_1_MASK) != 0;
}

static inline bool ck10_output_signals_user_2(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_USER_2_MASK) != 0;
}

static inline bool ck10_output_signals_user_3(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_USER_3_MASK) != 0;
}

static inline bool ck10_output_signals_user_4(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_USER_4_MASK) != 0;
}

static inline bool ck10_output_signals_user_5(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_USER_5_MASK) != 0;
}

static inline bool ck10_output_signals_user_6(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_USER_6_MASK) != 0;
}

static inline bool ck10_output_signals_user_7(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_USER_7_MASK) != 0;
}

static inline bool ck10_output_signals_user_8(uint32_t word)
{
    return (word & CK10_OUTPUT_SIGNALS_USER_8_MASK) != 0;
}

static inline bool ck10_user_inputs_user_0(uint16_t word)
{
    return (word & CK10_USER_INPUTS_USER_0_MASK) != 0;
}

static inline bool ck10_user_inputs_user_1(uint16_t word)
{
    return (word & CK10_USER_INPUTS_USER_1_MASK) != 0;
}

static inline bool ck10_user_inputs_user_2(uint16_t word)
{
    return (word & CK10_USER_INPUTS_USER_2_MASK) != 0;
}

static inline bool ck10_user_inputs_user_3(uint16_t word)
{
    return (word & CK10_USER_INPUTS_USER_3_MASK) != 0;
}

static inline bool ck10_user_inputs_user_4(uint16_t word)
{
    return (word & CK10_USER_INPUTS_USER_4_MASK) != 0;
}

static inline bool ck10_user_inputs_user_5(uint16_t word)
{
    return (word & CK10_USER_INPUTS_USER_5_MASK) != 0;
}

static inline bool ck10_user_inputs_user_6(uint16_t word)
{
    return (word & CK10_USER_INPUTS_USER_6_MASK) != 0;
}

static inline bool ck10_user_inputs_user_7(uint16_t word)
{
    return (word & CK10_USER_INPUTS_USER_7_MASK) != 0;
}

static inline bool ck10_user_inputs_user_8(uint16_t word)
{
    return (word & CK10_USER_INPUTS_USER_8_MASK) != 0;
}

static inline bool ck10_user_outputs_user_0(uint16_t word)
{
    return (word & CK10_USER_OUTPUTS_USER_0_MASK) != 0;
}

static inline bool ck10_user_outputs_user_1(uint16_t word)
{
    return (word & CK10_USER_OUTPUTS_USER_1_MASK) != 0;
}

static inline bool ck10_user_outputs_user_2(uint16_t word)
{
    return (word & CK10_USER_OUTPUTS_USER_2_MASK) != 0;
}

static inline bool ck10_user_outputs_user_3(uint16_t word)
{
    return (word & CK10_USER_OUTPUTS_USER_3_MASK) != 0;
}

static inline bool ck10_user_outputs_user_4(uint16_t word)
{
    return (word & CK10_USER_OUTPUTS_USER_4_MASK) != 0;
}

static inline bool ck10_user_outputs_user_5(uint16_t word)
{
    return (word & CK10_USER_OUTPUTS_USER_5_MASK) != 0;
}

static inline bool ck10_user_outputs_user_6(uint16_t word)
{
    return (word & CK10_USER_OUTPUTS_USER_6_MASK) != 0;
}

static inline bool ck10_user_outputs_user_7(uint16_t word)
{
    return (word & CK10_USER_OUTPUTS_USER_7_MASK) != 0;
}

static inline bool ck10_user_outputs_user_8(uint16_t word)
{
    return (word & CK10_USER_OUTPUTS_USER_8_MASK) != 0;
}

static inline bool ck10_point_output_setting_point_output_0(uint16_t word)
{
    return (word & CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_0_MASK) != 0;
}

static inline bool ck10_point_output_setting_point_output_1(uint16_t word)
{
    return (word & CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_1_MASK) != 0;
}

static inline bool ck10_point_output_setting_point_output_2(uint16_t word)
{
    return (word & CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_2_MASK) != 0;
}

static inline uint16_t ck10_point_output_setting_moment(uint16_t word)
{
    return (uint16_t)((word & CK10_POINT_OUTPUT_SETTING_MOMENT_MASK) >> CK10_POINT_OUTPUT_SETTING_MOMENT_SHIFT);
}

static inline uint16_t ck10_point_output_setting_with_moment(uint16_t word, uint16_t value)
{
    return (uint16_t)((word & (uint16_t)~CK10_POINT_OUTPUT_SETTING_MOMENT_MASK) | ((uint16_t)(value << CK10_POINT_OUTPUT_SETTING_MOMENT_SHIFT) & CK10_POINT_OUTPUT_SETTING_MOMENT_MASK));
}

/* ---- Records ---- */

/**
 * The body of a reply that refuses a request.
 * Source: 1.4 L225-229
 */
typedef struct ck10_exception {
    /**
     * Printed as 異常碼.
     * See exception_code.
     * Source: 1.4 L228
     */
    uint8_t exception_code;
} ck10_exception;

/** Writes ck10_exception to 1 byte without checks. */
static inline void ck10_exception_pack(const ck10_exception *in, uint8_t *out)
{
    ck10_store_u8(out + 0, in->exception_code);
}

/** Reads ck10_exception from 1 byte without checks. */
static inline void ck10_exception_unpack(const uint8_t *in, ck10_exception *out)
{
    out->exception_code = ck10_load_u8(in + 0);
}

/**
 * Writes ck10_exception: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline ck10_codec_status ck10_exception_encode(const ck10_exception *in, uint8_t *out, size_t capacity,
        size_t *length)
{
    if (capacity < 1u) {
        return CK10_ERR_CAPACITY;
    }
    ck10_exception_pack(in, out);
    *length = 1u;
    return CK10_OK;
}

/** Reads ck10_exception from exactly 1 byte. */
static inline ck10_codec_status ck10_exception_decode(const uint8_t *in, size_t length, ck10_exception *out)
{
    if (length != 1u) {
        return length < 1u ? CK10_ERR_INCOMPLETE : CK10_ERR_WRONG_LENGTH;
    }
    ck10_exception_unpack(in, out);
    return CK10_OK;
}

/**
 * One row of the point table, which the manual calls PT and position table.
 * Printed as 位置表.
 * Note: The manual prints the addresses of point 0, in decimal too: 10000 for 2710h to 10029 for 272Dh.
 * Note: A field of two words is to be read and written with one request (2 L243).
 * Note: For fields that do not say so, the manual does not print how to leave them empty.
 * Source: 2.7 L575-600
 */
typedef struct ck10_point {
    /**
     * Where to, or how far, the point moves.
     * Printed as 位置.
     * One count is 1 pulse. Range: -2147483648..2147483647.
     * Source: 2.7 L575; 3.5 L833
     */
    int32_t position;
    /**
     * The speed at which the move starts, and that of moves at low speed.
     * Printed as 低速.
     * One count is 1 pps. Range: 1..35000.
     * Source: 2.7 L576; 3.5 L834
     */
    uint32_t low_speed;
    /**
     * The speed of the move.
     * Printed as 高速.
     * One count is 1 pps. Range: 1..500000.
     * Note: The parameters 138Ah, 1394h and 13A4h allow up to 800000 pps.
     * Source: 2.7 L577; 3.5 L835
     */
    uint32_t high_speed;
    /**
     * Printed as 加速時間.
     * One count is 1 ms. Range: 1..9999.
     * Source: 2.7 L578; 3.5 L836
     */
    uint16_t acceleration_time;
    /**
     * Printed as 減速時間.
     * One count is 1 ms. Range: 1..9999.
     * Source: 2.7 L579; 3.5 L837
     */
    uint16_t deceleration_time;
    /**
     * What the point does.
     * Printed as 命令.
     * Range: 0..11. See point_command. 65535 means ignored.
     * Source: 2.7 L580; 3.5 L819
     */
    uint16_t command;
    /**
     * How long the controller waits before the next point; without a next point it does not.
     * Printed as 等待時間.
     * One count is 1 ms. Range: 0..60000.
     * Note: Even with 0 it waits until the motor is in position or has stopped (3.5 L839).
     * Source: 2.7 L581; 3.5 L838-839
     */
    uint16_t waiting_time;
    /**
     * The point that follows when this one is done: 0 to 127. 10000 plus its number: the jump is made at once when
     * the input that starts jumps comes on.
     * Printed as 跳轉編號.
     * Range: 0..127, 10000..10127. 65535 means ignored.
     * Note: 2.7 calls it JP Table No and Jump Table No as well; 3.5 calls the empty field that ends the table
     * blank.
     * Source: 2.7 L583; 3.5 L844-845
     */
    uint16_t jump_point;
    /**
     * The point that follows instead of the jump point if jump input 0 is on.
     * Printed as JPT0.
     * Range: 0..127, 10000..10127. 65535 means ignored.
     * Note: In the text of 3.5, the second interval of each of the three fields stands on the row of the next one.
     * Source: 2.7 L584; 3.5 L846-847
     */
    uint16_t jump_point_of_input_0;
    /**
     * The point that follows instead of the jump point if jump input 1 is on.
     * Printed as JPT1.
     * Range: 0..127, 10000..10127. 65535 means ignored.
     * Source: 2.7 L585; 3.5 L847-849
     */
    uint16_t jump_point_of_input_1;
    /**
     * The point that follows instead of the jump point if jump input 2 is on.
     * Printed as JPT2.
     * Range: 0..127, 10000..10127. 65535 means ignored.
     * Source: 2.7 L586; 3.5 L849-851
     */
    uint16_t jump_point_of_input_2;
    /**
     * How often the point is carried out before the loop jump, which then takes the place of the jump point.
     * Printed as 循環計數.
     * Range: 0..100.
     * Source: 2.7 L587; 3.5 L857
     */
    uint16_t loop_count;
    /**
     * The point that follows the loop.
     * Printed as Loop Jump Table No..
     * Range: 0..127, 10000..10127.
     * Source: 2.7 L588; 3.5 L858-859
     */
    uint16_t loop_jump_point;
    /**
     * Which outputs the point sets, and when.
     * Printed as PT 設定.
     * Range: 0..23. See point_output_setting.
     * Source: 2.7 L589; 3.5 L860
     */
    uint16_t output_setting;
    /**
     * The point whose loop counter is cleared.
     * Printed as 循環計數清除.
     * Range: 0..127. 65535 means ignored.
     * Source: 2.7 L592; 3.5 L861
     */
    uint16_t clear_loop_counter_of;
    /**
     * Whether the point is done only when the motor is in position.
     * Printed as 到位檢查.
     * Range: 0..1. See check_in_position.
     * Source: 2.7 L593; 3.5 L862
     */
    uint16_t check_in_position;
    /**
     * Where the outputs come on, with an output setting of 17 to 23.
     * Printed as 比較位置.
     * One count is 1 pulse. Range: -2147483648..2147483647.
     * Note: The output setting of 2.7 calls it trigger position too.
     * Source: 2.7 L594; 3.5 L863
     */
    int32_t trigger_position;
    /**
     * How long the outputs stay on, with an output setting of 17 to 23.
     * Printed as 比較輸出時間.
     * One count is 1 ms. Range: 0..65535.
     * Source: 2.7 L595; 3.5 L864
     */
    uint16_t trigger_time;
    /**
     * The torque of a push.
     * Printed as 推力比.
     * One count is 1 %. Range: 20..90.
     * Source: 2.7 L596; 3.5 L865
     */
    uint16_t push_torque_ratio;
    /**
     * The speed of a push, at most 200 rpm.
     * Printed as 推力速度.
     * One count is 1 pps. Range: 1..33333.
     * Note: 33333 pps are 200 rpm at 10000 pulses per turn; with fewer pulses they are more.
     * Source: 2.7 L597; 3.5 L866
     */
    uint32_t push_speed;
    /**
     * The target of a push.
     * Printed as 推力位置.
     * One count is 1 pulse. Range: -2147483648..2147483647.
     * Source: 2.7 L598; 3.5 L867
     */
    int32_t push_position;
    /**
     * 0 stops at the workpiece; 1 to 10000 do not stop.
     * Printed as 推力模式.
     * One count is 1 pulse. Range: 0..10000. 0 means stop_mode.
     * Note: The register 07E6h of the same name knows 0 and 1 only. What the pulses count is not printed.
     * Source: 2.7 L599; 3.5 L868
     */
    uint16_t push_mode;
} ck10_point;

/** Whether the values of ck10_point may be written. */
static inline ck10_codec_status ck10_point_check(const ck10_point *in)
{
    if (!(in->low_speed >= 1u && in->low_speed <= 35000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!(in->high_speed >= 1u && in->high_speed <= 500000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!(in->acceleration_time >= 1u && in->acceleration_time <= 9999u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!(in->deceleration_time >= 1u && in->deceleration_time <= 9999u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!ck10_point_command_known((int64_t)in->command) && in->command != 65535u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    if (!(in->waiting_time <= 60000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!((in->jump_point <= 127u) || (in->jump_point >= 10000u && in->jump_point <= 10127u) ||
            (in->jump_point == 65535u))) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!((in->jump_point_of_input_0 <= 127u) ||
            (in->jump_point_of_input_0 >= 10000u && in->jump_point_of_input_0 <= 10127u) ||
            (in->jump_point_of_input_0 == 65535u))) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!((in->jump_point_of_input_1 <= 127u) ||
            (in->jump_point_of_input_1 >= 10000u && in->jump_point_of_input_1 <= 10127u) ||
            (in->jump_point_of_input_1 == 65535u))) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!((in->jump_point_of_input_2 <= 127u) ||
            (in->jump_point_of_input_2 >= 10000u && in->jump_point_of_input_2 <= 10127u) ||
            (in->jump_point_of_input_2 == 65535u))) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!(in->loop_count <= 100u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!((in->loop_jump_point <= 127u) || (in->loop_jump_point >= 10000u && in->loop_jump_point <= 10127u))) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!(in->output_setting <= 23u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!((in->clear_loop_counter_of <= 127u) || (in->clear_loop_counter_of == 65535u))) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!ck10_check_in_position_known((int64_t)in->check_in_position)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    if (!(in->push_torque_ratio >= 20u && in->push_torque_ratio <= 90u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!(in->push_speed >= 1u && in->push_speed <= 33333u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    if (!(in->push_mode <= 10000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    return CK10_OK;
}

/** Writes ck10_point to 64 bytes without checks. */
static inline void ck10_point_pack(const ck10_point *in, uint8_t *out)
{
    size_t at;
    ck10_store_u32_be(out + 0, (uint32_t)in->position);
    ck10_store_u32_be(out + 4, in->low_speed);
    ck10_store_u32_be(out + 8, in->high_speed);
    ck10_store_u16_be(out + 12, in->acceleration_time);
    ck10_store_u16_be(out + 14, in->deceleration_time);
    ck10_store_u16_be(out + 16, in->command);
    ck10_store_u16_be(out + 18, in->waiting_time);
    ck10_store_u16_be(out + 20, 0u);
    ck10_store_u16_be(out + 22, in->jump_point);
    ck10_store_u16_be(out + 24, in->jump_point_of_input_0);
    ck10_store_u16_be(out + 26, in->jump_point_of_input_1);
    ck10_store_u16_be(out + 28, in->jump_point_of_input_2);
    ck10_store_u16_be(out + 30, in->loop_count);
    ck10_store_u16_be(out + 32, in->loop_jump_point);
    ck10_store_u16_be(out + 34, in->output_setting);
    ck10_store_u16_be(out + 36, in->clear_loop_counter_of);
    ck10_store_u16_be(out + 38, in->check_in_position);
    ck10_store_u32_be(out + 40, (uint32_t)in->trigger_position);
    ck10_store_u16_be(out + 44, in->trigger_time);
    ck10_store_u16_be(out + 46, in->push_torque_ratio);
    ck10_store_u32_be(out + 48, in->push_speed);
    ck10_store_u32_be(out + 52, (uint32_t)in->push_position);
    ck10_store_u16_be(out + 56, in->push_mode);
    for (at = 0; at < 3u; at++) {
        ck10_store_u16_be(out + 58u + at * 2u, 0u);
    }
}

/** Reads ck10_point from 64 bytes without checks. */
static inline void ck10_point_unpack(const uint8_t *in, ck10_point *out)
{
    out->position = ck10_signed_32(ck10_load_u32_be(in + 0));
    out->low_speed = ck10_load_u32_be(in + 4);
    out->high_speed = ck10_load_u32_be(in + 8);
    out->acceleration_time = ck10_load_u16_be(in + 12);
    out->deceleration_time = ck10_load_u16_be(in + 14);
    out->command = ck10_load_u16_be(in + 16);
    out->waiting_time = ck10_load_u16_be(in + 18);
    out->jump_point = ck10_load_u16_be(in + 22);
    out->jump_point_of_input_0 = ck10_load_u16_be(in + 24);
    out->jump_point_of_input_1 = ck10_load_u16_be(in + 26);
    out->jump_point_of_input_2 = ck10_load_u16_be(in + 28);
    out->loop_count = ck10_load_u16_be(in + 30);
    out->loop_jump_point = ck10_load_u16_be(in + 32);
    out->output_setting = ck10_load_u16_be(in + 34);
    out->clear_loop_counter_of = ck10_load_u16_be(in + 36);
    out->check_in_position = ck10_load_u16_be(in + 38);
    out->trigger_position = ck10_signed_32(ck10_load_u32_be(in + 40));
    out->trigger_time = ck10_load_u16_be(in + 44);
    out->push_torque_ratio = ck10_load_u16_be(in + 46);
    out->push_speed = ck10_load_u32_be(in + 48);
    out->push_position = ck10_signed_32(ck10_load_u32_be(in + 52));
    out->push_mode = ck10_load_u16_be(in + 56);
}

/**
 * Writes ck10_point: 64 bytes.
 * `length` receives the number of bytes written.
 */
static inline ck10_codec_status ck10_point_encode(const ck10_point *in, uint8_t *out, size_t capacity, size_t *length)
{
    ck10_codec_status status;
    if (capacity < 64u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_point_check(in);
    if (status != CK10_OK) {
        return status;
    }
    ck10_point_pack(in, out);
    *length = 64u;
    return CK10_OK;
}

/** Reads ck10_point from exactly 64 bytes. */
static inline ck10_codec_status ck10_point_decode(const uint8_t *in, size_t length, ck10_point *out)
{
    if (length != 64u) {
        return length < 64u ? CK10_ERR_INCOMPLETE : CK10_ERR_WRONG_LENGTH;
    }
    ck10_point_unpack(in, out);
    if (!ck10_point_command_known((int64_t)out->command) && out->command != 65535u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    if (!ck10_check_in_position_known((int64_t)out->check_in_position)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/* ---- Data of requests and responses ---- */

typedef struct ck10_read_registers_request {
    /**
     * Printed as Start add.
     * Source: 1.3 L127
     */
    uint16_t address;
    /**
     * Printed as No of reg.
     * Range: 1..125.
     * Source: 1.3 L127, 130
     */
    uint16_t word_count;
} ck10_read_registers_request;

/** Whether the values of ck10_read_registers_request may be written. */
static inline ck10_codec_status ck10_read_registers_request_check(const ck10_read_registers_request *in)
{
    if (!(in->word_count >= 1u && in->word_count <= 125u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    return CK10_OK;
}

/** Writes ck10_read_registers_request to 4 bytes without checks. */
static inline void ck10_read_registers_request_pack(const ck10_read_registers_request *in, uint8_t *out)
{
    ck10_store_u16_be(out + 0, in->address);
    ck10_store_u16_be(out + 2, in->word_count);
}

/** Reads ck10_read_registers_request from 4 bytes without checks. */
static inline void ck10_read_registers_request_unpack(const uint8_t *in, ck10_read_registers_request *out)
{
    out->address = ck10_load_u16_be(in + 0);
    out->word_count = ck10_load_u16_be(in + 2);
}

/**
 * Writes ck10_read_registers_request: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline ck10_codec_status ck10_read_registers_request_encode(const ck10_read_registers_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    ck10_codec_status status;
    if (capacity < 4u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_read_registers_request_check(in);
    if (status != CK10_OK) {
        return status;
    }
    ck10_read_registers_request_pack(in, out);
    *length = 4u;
    return CK10_OK;
}

/** Reads ck10_read_registers_request from exactly 4 bytes. */
static inline ck10_codec_status ck10_read_registers_request_decode(const uint8_t *in, size_t length,
        ck10_read_registers_request *out)
{
    if (length != 4u) {
        return length < 4u ? CK10_ERR_INCOMPLETE : CK10_ERR_WRONG_LENGTH;
    }
    ck10_read_registers_request_unpack(in, out);
    return CK10_OK;
}

typedef struct ck10_read_registers_response {
    /**
     * Printed as Reg value.
     * Source: 1.3 L135, 138
     */
    uint16_t values[125];
    size_t values_count;
} ck10_read_registers_response;

/**
 * Writes ck10_read_registers_response: 3 to 251 bytes.
 * `length` receives the number of bytes written.
 */
static inline ck10_codec_status ck10_read_registers_response_encode(const ck10_read_registers_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t at;
    if (in->values_count < 1u || in->values_count > 125u) {
        return CK10_ERR_WRONG_LENGTH;
    }
    if (capacity < (1u + in->values_count * 2u)) {
        return CK10_ERR_CAPACITY;
    }
    for (at = 0; at < in->values_count; at++) {
        ck10_store_u16_be(out + 1u + at * 2u, in->values[at]);
    }
    ck10_store_u8(out + 0, (uint8_t)(in->values_count * 2u));
    *length = (1u + in->values_count * 2u);
    return CK10_OK;
}

/** Reads ck10_read_registers_response from exactly 3 to 251 bytes. */
static inline ck10_codec_status ck10_read_registers_response_decode(const uint8_t *in, size_t length,
        ck10_read_registers_response *out)
{
    size_t at;
    if (length < 3u) {
        return CK10_ERR_INCOMPLETE;
    }
    if (length > 251u) {
        return CK10_ERR_WRONG_LENGTH;
    }
    if ((length - 1u) % 2u != 0) {
        return CK10_ERR_WRONG_LENGTH;
    }
    out->values_count = (length - 1u) / 2u;
    for (at = 0; at < out->values_count; at++) {
        out->values[at] = ck10_load_u16_be(in + 1u + at * 2u);
    }
    if (ck10_load_u8(in + 0) != out->values_count * 2u) {
        return CK10_ERR_WRONG_MEASURE;
    }
    return CK10_OK;
}

typedef struct ck10_write_register_request {
    /**
     * Printed as Start add.
     * Source: 1.3 L147
     */
    uint16_t address;
    /**
     * Printed as Value.
     * Source: 1.3 L147, 150
     */
    uint16_t value;
} ck10_write_register_request;

/** Writes ck10_write_register_request to 4 bytes without checks. */
static inline void ck10_write_register_request_pack(const ck10_write_register_request *in, uint8_t *out)
{
    ck10_store_u16_be(out + 0, in->address);
    ck10_store_u16_be(out + 2, in->value);
}

/** Reads ck10_write_register_request from 4 bytes without checks. */
static inline void ck10_write_register_request_unpack(const uint8_t *in, ck10_write_register_request *out)
{
    out->address = ck10_load_u16_be(in + 0);
    out->value = ck10_load_u16_be(in + 2);
}

/**
 * Writes ck10_write_register_request: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline ck10_codec_status ck10_write_register_request_encode(const ck10_write_register_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    if (capacity < 4u) {
        return CK10_ERR_CAPACITY;
    }
    ck10_write_register_request_pack(in, out);
    *length = 4u;
    return CK10_OK;
}

/** Reads ck10_write_register_request from exactly 4 bytes. */
static inline ck10_codec_status ck10_write_register_request_decode(const uint8_t *in, size_t length,
        ck10_write_register_request *out)
{
    if (length != 4u) {
        return length < 4u ? CK10_ERR_INCOMPLETE : CK10_ERR_WRONG_LENGTH;
    }
    ck10_write_register_request_unpack(in, out);
    return CK10_OK;
}

typedef struct ck10_write_register_response {
    /**
     * Printed as Start add.
     * Source: 1.3 L155
     */
    uint16_t address;
    /**
     * Printed as Value.
     * Source: 1.3 L155
     */
    uint16_t value;
} ck10_write_register_response;

/** Writes ck10_write_register_response to 4 bytes without checks. */
static inline void ck10_write_register_response_pack(const ck10_write_register_response *in, uint8_t *out)
{
    ck10_store_u16_be(out + 0, in->address);
    ck10_store_u16_be(out + 2, in->value);
}

/** Reads ck10_write_register_response from 4 bytes without checks. */
static inline void ck10_write_register_response_unpack(const uint8_t *in, ck10_write_register_response *out)
{
    out->address = ck10_load_u16_be(in + 0);
    out->value = ck10_load_u16_be(in + 2);
}

/**
 * Writes ck10_write_register_response: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline ck10_codec_status ck10_write_register_response_encode(const ck10_write_register_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 4u) {
        return CK10_ERR_CAPACITY;
    }
    ck10_write_register_response_pack(in, out);
    *length = 4u;
    return CK10_OK;
}

/** Reads ck10_write_register_response from exactly 4 bytes. */
static inline ck10_codec_status ck10_write_register_response_decode(const uint8_t *in, size_t length,
        ck10_write_register_response *out)
{
    if (length != 4u) {
        return length < 4u ? CK10_ERR_INCOMPLETE : CK10_ERR_WRONG_LENGTH;
    }
    ck10_write_register_response_unpack(in, out);
    return CK10_OK;
}

typedef struct ck10_write_registers_request {
    /**
     * Printed as Start add.
     * Source: 1.3 L167
     */
    uint16_t address;
    /**
     * Printed as Val.
     * Source: 1.3 L167
     */
    uint16_t values[123];
    size_t values_count;
} ck10_write_registers_request;

/**
 * Writes ck10_write_registers_request: 7 to 251 bytes.
 * `length` receives the number of bytes written.
 */
static inline ck10_codec_status ck10_write_registers_request_encode(const ck10_write_registers_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t at;
    if (in->values_count < 1u || in->values_count > 123u) {
        return CK10_ERR_WRONG_LENGTH;
    }
    if (capacity < (5u + in->values_count * 2u)) {
        return CK10_ERR_CAPACITY;
    }
    ck10_store_u16_be(out + 0, in->address);
    for (at = 0; at < in->values_count; at++) {
        ck10_store_u16_be(out + 5u + at * 2u, in->values[at]);
    }
    ck10_store_u16_be(out + 2, (uint16_t)(in->values_count));
    ck10_store_u8(out + 4, (uint8_t)(in->values_count * 2u));
    *length = (5u + in->values_count * 2u);
    return CK10_OK;
}

/** Reads ck10_write_registers_request from exactly 7 to 251 bytes. */
static inline ck10_codec_status ck10_write_registers_request_decode(const uint8_t *in, size_t length,
        ck10_write_registers_request *out)
{
    size_t at;
    if (length < 7u) {
        return CK10_ERR_INCOMPLETE;
    }
    if (length > 251u) {
        return CK10_ERR_WRONG_LENGTH;
    }
    if ((length - 5u) % 2u != 0) {
        return CK10_ERR_WRONG_LENGTH;
    }
    out->values_count = (length - 5u) / 2u;
    out->address = ck10_load_u16_be(in + 0);
    for (at = 0; at < out->values_count; at++) {
        out->values[at] = ck10_load_u16_be(in + 5u + at * 2u);
    }
    if (ck10_load_u16_be(in + 2) != out->values_count) {
        return CK10_ERR_WRONG_MEASURE;
    }
    if (ck10_load_u8(in + 4) != out->values_count * 2u) {
        return CK10_ERR_WRONG_MEASURE;
    }
    return CK10_OK;
}

typedef struct ck10_write_registers_response {
    /**
     * Printed as Start add.
     * Source: 1.3 L173, 176
     */
    uint16_t address;
    /**
     * Printed as No of reg.
     * Source: 1.3 L173, 176
     */
    uint16_t word_count;
} ck10_write_registers_response;

/** Writes ck10_write_registers_response to 4 bytes without checks. */
static inline void ck10_write_registers_response_pack(const ck10_write_registers_response *in, uint8_t *out)
{
    ck10_store_u16_be(out + 0, in->address);
    ck10_store_u16_be(out + 2, in->word_count);
}

/** Reads ck10_write_registers_response from 4 bytes without checks. */
static inline void ck10_write_registers_response_unpack(const uint8_t *in, ck10_write_registers_response *out)
{
    out->address = ck10_load_u16_be(in + 0);
    out->word_count = ck10_load_u16_be(in + 2);
}

/**
 * Writes ck10_write_registers_response: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline ck10_codec_status ck10_write_registers_response_encode(const ck10_write_registers_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 4u) {
        return CK10_ERR_CAPACITY;
    }
    ck10_write_registers_response_pack(in, out);
    *length = 4u;
    return CK10_OK;
}

/** Reads ck10_write_registers_response from exactly 4 bytes. */
static inline ck10_codec_status ck10_write_registers_response_decode(const uint8_t *in, size_t length,
        ck10_write_registers_response *out)
{
    if (length != 4u) {
        return length < 4u ? CK10_ERR_INCOMPLETE : CK10_ERR_WRONG_LENGTH;
    }
    ck10_write_registers_response_unpack(in, out);
    return CK10_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes ck10_report_server_id_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline ck10_codec_status ck10_report_server_id_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return CK10_OK;
}

/** Reads ck10_report_server_id_request from exactly 0 bytes. */
static inline ck10_codec_status ck10_report_server_id_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return CK10_ERR_WRONG_LENGTH;
    }
    return CK10_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes ck10_report_server_id_response: 3 bytes.
 * `length` receives the number of bytes written.
 */
static inline ck10_codec_status ck10_report_server_id_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 3u) {
        return CK10_ERR_CAPACITY;
    }
    ck10_store_u8(out + 0, 2u);
    ck10_store_u8(out + 1, 104u);
    ck10_store_u8(out + 2, 255u);
    *length = 3u;
    return CK10_OK;
}

/** Reads ck10_report_server_id_response from exactly 3 bytes. */
static inline ck10_codec_status ck10_report_server_id_response_decode(const uint8_t *in, size_t length)
{
    if (length != 3u) {
        return length < 3u ? CK10_ERR_INCOMPLETE : CK10_ERR_WRONG_LENGTH;
    }
    if (ck10_load_u8(in + 0) != 2u) {
        return CK10_ERR_WRONG_CONST;
    }
    if (ck10_load_u8(in + 1) != 104u) {
        return CK10_ERR_WRONG_CONST;
    }
    if (ck10_load_u8(in + 2) != 255u) {
        return CK10_ERR_WRONG_CONST;
    }
    return CK10_OK;
}

/* ---- Registers ---- */

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_axis_start_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_axis_start_speed_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_axis_acceleration_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_axis_acceleration_time_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_axis_deceleration_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_axis_deceleration_time_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_axis_move_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_axis_move_speed_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_target_position_or_distance_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_target_position_or_distance_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/**
 * Decodes the value from its 2 bytes.
 * An integer, as the device may answer what move_kind does not have.
 */
static inline ck10_codec_status ck10_reg_start_move_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_start_move_encode(ck10_move_kind value, uint8_t *out)
{
    if (!ck10_move_kind_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u16_be(out, (uint16_t)value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_axis_jog_acceleration_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_axis_jog_acceleration_time_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_axis_jog_start_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_axis_jog_start_speed_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_axis_jog_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_axis_jog_speed_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_jog_direction_decode(const uint8_t *in, ck10_jog_direction *out)
{
    const uint16_t number = ck10_load_u16_be(in);
    if (!ck10_jog_direction_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_jog_direction)number;
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_jog_direction_encode(ck10_jog_direction value, uint8_t *out)
{
    if (!ck10_jog_direction_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u16_be(out, (uint16_t)value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_start_jog_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_start_jog_encode(uint8_t *out)
{
    ck10_store_u16_be(out, 1u);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_push_start_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_push_start_speed_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_push_move_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_push_move_speed_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_push_acceleration_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_push_acceleration_time_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_push_deceleration_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_push_deceleration_time_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_push_mode_decode(const uint8_t *in, ck10_push_mode *out)
{
    const uint16_t number = ck10_load_u16_be(in);
    if (!ck10_push_mode_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_push_mode)number;
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_push_mode_encode(ck10_push_mode value, uint8_t *out)
{
    if (!ck10_push_mode_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u16_be(out, (uint16_t)value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_push_torque_ratio_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_push_torque_ratio_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_push_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_push_speed_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_push_start_position_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_push_start_position_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_push_end_position_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_push_end_position_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_start_push_motion_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_start_push_motion_encode(uint8_t *out)
{
    ck10_store_u16_be(out, 1u);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_start_homing_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_start_homing_encode(uint8_t *out)
{
    ck10_store_u16_be(out, 1u);
    return CK10_OK;
}

/**
 * Decodes the value from its 2 bytes.
 * An integer, as the device may answer what stop_kind does not have.
 */
static inline ck10_codec_status ck10_reg_stop_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_stop_encode(ck10_stop_kind value, uint8_t *out)
{
    if (!ck10_stop_kind_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u16_be(out, (uint16_t)value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_servo_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_servo_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_clear_position_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_clear_position_encode(uint8_t *out)
{
    ck10_store_u16_be(out, 1u);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_reset_alarm_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_reset_alarm_encode(uint8_t *out)
{
    ck10_store_u16_be(out, 1u);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_save_point_table_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_save_point_table_encode(uint8_t *out)
{
    ck10_store_u16_be(out, 1u);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_start_point_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_start_point_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/**
 * Decodes the value from its 2 bytes.
 * An integer, as the device may answer what point_table_command does not have.
 */
static inline ck10_codec_status ck10_reg_run_point_table_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_run_point_table_encode(ck10_point_table_command value, uint8_t *out)
{
    if (!ck10_point_table_command_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u16_be(out, (uint16_t)value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_save_all_parameters_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_save_all_parameters_encode(uint8_t *out)
{
    ck10_store_u16_be(out, 1u);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_compare_start_position_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_compare_start_position_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_compare_period_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_compare_period_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_compare_pulse_width_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_compare_pulse_width_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 1000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_compare_enable_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_compare_enable_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_compare_active_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_compare_active_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_model_id_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_model_id_encode(uint8_t *out)
{
    ck10_store_u32_be(out, 104u);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_hardware_type_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_hardware_type_encode(uint8_t *out)
{
    ck10_store_u16_be(out, 31u);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_firmware_version_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_firmware_version_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_power_cycles_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_power_cycles_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 8 bytes. */
static inline ck10_codec_status ck10_reg_turns_total_decode(const uint8_t *in, uint64_t *out)
{
    *out = ck10_load_u64_be(in);
    return CK10_OK;
}

/** Encodes the value into its 8 bytes. */
static inline ck10_codec_status ck10_reg_turns_total_encode(uint64_t value, uint8_t *out)
{
    ck10_store_u64_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 8 bytes. */
static inline ck10_codec_status ck10_reg_turns_since_power_on_decode(const uint8_t *in, uint64_t *out)
{
    *out = ck10_load_u64_be(in);
    return CK10_OK;
}

/** Encodes the value into its 8 bytes. */
static inline ck10_codec_status ck10_reg_turns_since_power_on_encode(uint64_t value, uint8_t *out)
{
    ck10_store_u64_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_resolution_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_resolution_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 50000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_maximum_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_maximum_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 800000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_start_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_start_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 35000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_acceleration_time_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_acceleration_time_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 9999u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_deceleration_time_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_deceleration_time_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 9999u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_reserved_5_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_reserved_5_encode(uint32_t value, uint8_t *out)
{
    if (!(value == 100u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_jog_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_jog_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 800000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_jog_start_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_jog_start_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 35000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_jog_acceleration_time_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_jog_acceleration_time_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 9999u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_positive_soft_limit_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_positive_soft_limit_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_negative_soft_limit_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_negative_soft_limit_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_soft_limit_stop_decode(const uint8_t *in, ck10_soft_limit_stop *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_soft_limit_stop_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_soft_limit_stop)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_soft_limit_stop_encode(ck10_soft_limit_stop value, uint8_t *out)
{
    if (!ck10_soft_limit_stop_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_hard_limit_stop_decode(const uint8_t *in, ck10_hard_limit_stop *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_hard_limit_stop_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_hard_limit_stop)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_hard_limit_stop_encode(ck10_hard_limit_stop value, uint8_t *out)
{
    if (!ck10_hard_limit_stop_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_reserved_13_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_reserved_13_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 1u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 800000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_search_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_search_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 80000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_acceleration_time_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_acceleration_time_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 9999u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_method_decode(const uint8_t *in, ck10_homing_method *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_homing_method_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_homing_method)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_method_encode(ck10_homing_method value, uint8_t *out)
{
    if (!ck10_homing_method_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_direction_decode(const uint8_t *in, ck10_rotation *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_rotation_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_rotation)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_direction_encode(ck10_rotation value, uint8_t *out)
{
    if (!ck10_rotation_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_offset_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_offset_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_origin_position_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_origin_position_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_reserved_21_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_reserved_21_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 1u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_position_loop_gain_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_position_loop_gain_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 63u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_in_position_range_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_in_position_range_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 127u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_tracking_limit_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_tracking_limit_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 134217727u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_motor_direction_decode(const uint8_t *in, ck10_rotation *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_rotation_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_rotation)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_motor_direction_encode(ck10_rotation value, uint8_t *out)
{
    if (!ck10_rotation_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_reserved_26_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_reserved_26_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 1u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_torque_ratio_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_homing_torque_ratio_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 20u && value <= 90u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_position_overflow_limit_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_position_overflow_limit_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 134217727u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_reserved_29_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_reserved_29_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 10u && value <= 5000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_run_current_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_run_current_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 5u && value <= 15u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_boost_current_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_boost_current_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 7u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_stop_current_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_stop_current_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 2u && value <= 10u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_emergency_stop_mode_decode(const uint8_t *in, ck10_emergency_stop_mode *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_emergency_stop_mode_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_emergency_stop_mode)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_emergency_stop_mode_encode(ck10_emergency_stop_mode value, uint8_t *out)
{
    if (!ck10_emergency_stop_mode_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_emergency_brake_mode_decode(const uint8_t *in, ck10_emergency_brake_mode *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_emergency_brake_mode_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_emergency_brake_mode)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_emergency_brake_mode_encode(ck10_emergency_brake_mode value, uint8_t *out)
{
    if (!ck10_emergency_brake_mode_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_operation_mode_decode(const uint8_t *in, ck10_operation_mode *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_operation_mode_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_operation_mode)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_operation_mode_encode(ck10_operation_mode value, uint8_t *out)
{
    if (!ck10_operation_mode_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_switch_function_decode(const uint8_t *in, ck10_switch_function *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_switch_function_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_switch_function)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_switch_function_encode(ck10_switch_function value, uint8_t *out)
{
    if (!ck10_switch_function_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_baud_rate_decode(const uint8_t *in, ck10_baud_rate *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_baud_rate_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_baud_rate)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_baud_rate_encode(ck10_baud_rate value, uint8_t *out)
{
    if (!ck10_baud_rate_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_save_position_decode(const uint8_t *in, ck10_enabled *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_enabled_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_enabled)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_save_position_encode(ck10_enabled value, uint8_t *out)
{
    if (!ck10_enabled_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_show_motor_number_decode(const uint8_t *in, ck10_enabled *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_enabled_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_enabled)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_show_motor_number_encode(ck10_enabled value, uint8_t *out)
{
    if (!ck10_enabled_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_assignment_flags_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_assignment_flags_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_1_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_1_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_2_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_2_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_3_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_3_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_4_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_4_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_5_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_5_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_6_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_6_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_7_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_7_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_8_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_8_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_9_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_9_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_10_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_10_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_11_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_11_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_12_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_12_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_1_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_1_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_2_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_2_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_3_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_3_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_4_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_4_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_5_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_5_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_6_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_6_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_7_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_7_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_8_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_8_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_9_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_9_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_10_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_10_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_1_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_1_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_2_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_2_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_3_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_3_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_4_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_4_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_5_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_5_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_6_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_6_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_7_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_7_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_8_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_8_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_9_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_9_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_10_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_10_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_11_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_11_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_12_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_input_12_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_1_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_1_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_2_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_2_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_3_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_3_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_4_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_4_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_5_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_5_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_6_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_6_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_7_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_7_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_8_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_8_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_9_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_9_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_10_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_output_10_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_resolution_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_resolution_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 50000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_maximum_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_maximum_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 800000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_start_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_start_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 35000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_acceleration_time_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_acceleration_time_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 9999u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_deceleration_time_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_deceleration_time_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 9999u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_reserved_5_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_reserved_5_encode(uint32_t value, uint8_t *out)
{
    if (!(value == 100u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_jog_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_jog_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 800000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_jog_start_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_jog_start_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 35000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_jog_acceleration_time_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_jog_acceleration_time_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 9999u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_positive_soft_limit_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_positive_soft_limit_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_negative_soft_limit_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_negative_soft_limit_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_soft_limit_stop_decode(const uint8_t *in, ck10_soft_limit_stop *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_soft_limit_stop_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_soft_limit_stop)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_soft_limit_stop_encode(ck10_soft_limit_stop value, uint8_t *out)
{
    if (!ck10_soft_limit_stop_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_hard_limit_stop_decode(const uint8_t *in, ck10_hard_limit_stop *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_hard_limit_stop_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_hard_limit_stop)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_hard_limit_stop_encode(ck10_hard_limit_stop value, uint8_t *out)
{
    if (!ck10_hard_limit_stop_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_reserved_13_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_reserved_13_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 1u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 800000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_search_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_search_speed_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 80000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_acceleration_time_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_acceleration_time_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 9999u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_method_decode(const uint8_t *in, ck10_homing_method *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_homing_method_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_homing_method)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_method_encode(ck10_homing_method value, uint8_t *out)
{
    if (!ck10_homing_method_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_direction_decode(const uint8_t *in, ck10_rotation *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_rotation_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_rotation)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_direction_encode(ck10_rotation value, uint8_t *out)
{
    if (!ck10_rotation_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_offset_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_offset_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_origin_position_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_origin_position_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_reserved_21_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_reserved_21_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 1u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_position_loop_gain_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_position_loop_gain_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 63u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_in_position_range_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_in_position_range_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 127u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_tracking_limit_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_tracking_limit_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 134217727u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_motor_direction_decode(const uint8_t *in, ck10_rotation *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_rotation_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_rotation)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_motor_direction_encode(ck10_rotation value, uint8_t *out)
{
    if (!ck10_rotation_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_reserved_26_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_reserved_26_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 1u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_torque_ratio_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_homing_torque_ratio_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 20u && value <= 90u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_position_overflow_limit_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_position_overflow_limit_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 134217727u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_reserved_29_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_reserved_29_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 10u && value <= 5000u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_run_current_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_run_current_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 5u && value <= 15u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_boost_current_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_boost_current_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 7u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_stop_current_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_stop_current_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 2u && value <= 10u)) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_emergency_stop_mode_decode(const uint8_t *in,
        ck10_emergency_stop_mode *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_emergency_stop_mode_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_emergency_stop_mode)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_emergency_stop_mode_encode(ck10_emergency_stop_mode value, uint8_t *out)
{
    if (!ck10_emergency_stop_mode_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_emergency_brake_mode_decode(const uint8_t *in,
        ck10_emergency_brake_mode *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_emergency_brake_mode_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_emergency_brake_mode)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_emergency_brake_mode_encode(ck10_emergency_brake_mode value,
        uint8_t *out)
{
    if (!ck10_emergency_brake_mode_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_operation_mode_decode(const uint8_t *in, ck10_operation_mode *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_operation_mode_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_operation_mode)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_operation_mode_encode(ck10_operation_mode value, uint8_t *out)
{
    if (!ck10_operation_mode_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_switch_function_decode(const uint8_t *in, ck10_switch_function *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_switch_function_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_switch_function)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_switch_function_encode(ck10_switch_function value, uint8_t *out)
{
    if (!ck10_switch_function_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_baud_rate_decode(const uint8_t *in, ck10_baud_rate *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_baud_rate_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_baud_rate)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_baud_rate_encode(ck10_baud_rate value, uint8_t *out)
{
    if (!ck10_baud_rate_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_save_position_decode(const uint8_t *in, ck10_enabled *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_enabled_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_enabled)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_save_position_encode(ck10_enabled value, uint8_t *out)
{
    if (!ck10_enabled_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_show_motor_number_decode(const uint8_t *in, ck10_enabled *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_enabled_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_enabled)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_show_motor_number_encode(ck10_enabled value, uint8_t *out)
{
    if (!ck10_enabled_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_assignment_flags_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_assignment_flags_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_1_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_1_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_2_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_2_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_3_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_3_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_4_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_4_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_5_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_5_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_6_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_6_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_7_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_7_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_8_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_8_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_9_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_9_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_10_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_10_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_11_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_11_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_12_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_12_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_1_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_1_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_2_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_2_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_3_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_3_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_4_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_4_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_5_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_5_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_6_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_6_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_7_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_7_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_8_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_8_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_9_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_9_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_10_function_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_10_function_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_1_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_1_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_2_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_2_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_3_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_3_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_4_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_4_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_5_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_5_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_6_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_6_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_7_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_7_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_8_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_8_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_9_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_9_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_10_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_10_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_11_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_11_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_12_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_input_12_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_1_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_1_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_2_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_2_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_3_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_3_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_4_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_4_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_5_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_5_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_6_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_6_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_7_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_7_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_8_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_8_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_9_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_9_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_10_polarity_decode(const uint8_t *in, ck10_polarity *out)
{
    const uint32_t number = ck10_load_u32_be(in);
    if (!ck10_polarity_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_polarity)number;
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_flash_output_10_polarity_encode(ck10_polarity value, uint8_t *out)
{
    if (!ck10_polarity_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_motion_status_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_motion_status_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_actual_position_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_actual_position_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_command_position_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_command_position_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_speed_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_speed_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_position_error_decode(const uint8_t *in, int32_t *out)
{
    *out = ck10_signed_32(ck10_load_u32_be(in));
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_position_error_encode(int32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, (uint32_t)value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_inputs_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_inputs_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 4 bytes. */
static inline ck10_codec_status ck10_reg_outputs_decode(const uint8_t *in, uint32_t *out)
{
    *out = ck10_load_u32_be(in);
    return CK10_OK;
}

/** Encodes the value into its 4 bytes. */
static inline ck10_codec_status ck10_reg_outputs_encode(uint32_t value, uint8_t *out)
{
    ck10_store_u32_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_current_point_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_current_point_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_point_table_running_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_point_table_running_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_push_status_decode(const uint8_t *in, ck10_push_status *out)
{
    const uint16_t number = ck10_load_u16_be(in);
    if (!ck10_push_status_known((int64_t)number)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    *out = (ck10_push_status)number;
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_push_status_encode(ck10_push_status value, uint8_t *out)
{
    if (!ck10_push_status_known((int64_t)value)) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    ck10_store_u16_be(out, (uint16_t)value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_current_alarm_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_current_alarm_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_motor_id_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_motor_id_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_inputs_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_inputs_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_0_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_0_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_1_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_1_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_2_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_2_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_3_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_3_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_4_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_4_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_5_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_5_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_6_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_6_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_7_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_7_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_8_decode(const uint8_t *in, bool *out)
{
    *out = ck10_load_u16_be(in) != 0;
    if (ck10_load_u16_be(in) > 1u) {
        return CK10_ERR_UNKNOWN_VALUE;
    }
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_input_8_encode(bool value, uint8_t *out)
{
    ck10_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_outputs_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_outputs_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_0_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_0_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_1_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_1_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_2_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_2_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_3_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_3_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_4_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_4_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_5_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_5_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_6_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_6_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_7_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_7_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_8_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_user_output_8_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_clear_alarm_history_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_clear_alarm_history_encode(uint8_t *out)
{
    ck10_store_u16_be(out, 65535u);
    return CK10_OK;
}

/** Decodes the value from its 2 bytes. */
static inline ck10_codec_status ck10_reg_alarm_history_decode(const uint8_t *in, uint16_t *out)
{
    *out = ck10_load_u16_be(in);
    return CK10_OK;
}

/** Encodes the value into its 2 bytes. */
static inline ck10_codec_status ck10_reg_alarm_history_encode(uint16_t value, uint8_t *out)
{
    ck10_store_u16_be(out, value);
    return CK10_OK;
}

/** The address of alarm_history by its number; other numbers are refused. */
static inline ck10_codec_status ck10_reg_alarm_history_at(uint32_t number, uint16_t *address)
{
    if (number - CK10_REG_ALARM_HISTORY_FIRST >= CK10_REG_ALARM_HISTORY_COUNT) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    *address = (uint16_t)(CK10_REG_ALARM_HISTORY_ADDRESS + (number - CK10_REG_ALARM_HISTORY_FIRST) * CK10_REG_ALARM_HISTORY_STRIDE);
    return CK10_OK;
}

/* ---- Record tables ---- */

/** The address of an element of points by its number; other numbers are refused. */
static inline ck10_codec_status ck10_table_points_at(uint32_t number, uint16_t *address)
{
    if (number - CK10_TABLE_POINTS_FIRST >= CK10_TABLE_POINTS_COUNT) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    *address = (uint16_t)(CK10_TABLE_POINTS_ADDRESS + (number - CK10_TABLE_POINTS_FIRST) * CK10_TABLE_POINTS_STRIDE);
    return CK10_OK;
}

/** The address of an element of flash_points by its number; other numbers are refused. */
static inline ck10_codec_status ck10_table_flash_points_at(uint32_t number, uint16_t *address)
{
    if (number - CK10_TABLE_FLASH_POINTS_FIRST >= CK10_TABLE_FLASH_POINTS_COUNT) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    *address = (uint16_t)(CK10_TABLE_FLASH_POINTS_ADDRESS + (number - CK10_TABLE_FLASH_POINTS_FIRST) * CK10_TABLE_FLASH_POINTS_STRIDE);
    return CK10_OK;
}

/* ---- Frames ---- */

/**
 * RS-485, half duplex, asynchronous.
 * Printed as Modbus RTU.
 * Frames are binary.
 * Note: Chapter 2 (L243) says that values of 32 and 64 bits are accessed from the low position on. Read as the
 * lowest address first, it fits both orders of words; read as the low word first, it contradicts 1.2.
 * Note: 1.2 prints that a frame begins with a silence of 3.5 characters; that it also ends with one is not
 * printed (L107-110).
 * Note: A request with a wrong check, or one that does not arrive, gets no answer; the master waits for its
 * timeout (1.4 L201-202).
 * Note: 1.4 (L202) names parity errors too, though 1.1 knows no parity.
 * Source: 1.2 L78-86, 105-118
 */
/** An opened request: its header, and where its body is. */
typedef struct ck10_rtu_request_frame {
    /**
     * Printed as 位址.
     * Source: 1.2 L112
     */
    uint8_t unit_address;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    const uint8_t *body;
    size_t body_length;
} ck10_rtu_request_frame;

/** Checks a frame and finds its body. */
static inline ck10_codec_status ck10_rtu_request_open(const uint8_t *frame, size_t size, ck10_rtu_request_frame *out)
{
    const uint8_t *in = frame;
    size_t length = size;
    if (length < 4u) {
        return CK10_ERR_INCOMPLETE;
    }
    if (ck10_crc16_modbus(in, length - 2u) != ck10_load_u16_le(in + length - 2u)) {
        return CK10_ERR_WRONG_CHECKSUM;
    }
    out->unit_address = ck10_load_u8(in + 0);
    out->code = ck10_load_u8(in + 1);
    if (out->code != 3u && out->code != 6u && out->code != 16u && out->code != 17u) {
        return CK10_ERR_UNKNOWN_CODE;
    }
    out->body = in + 2u;
    out->body_length = length - 4u;
    return CK10_OK;
}

/** Completes a frame whose body is at out + 2. `length` receives the size of the frame. */
static inline ck10_codec_status ck10_rtu_request_close(uint8_t unit_address, uint32_t code, size_t body_length,
        uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 4u;
    if (capacity < 4u || body_length > capacity - 4u) {
        return CK10_ERR_CAPACITY;
    }
    if (!((unit_address >= 1 && unit_address <= 16) || (unit_address == 0))) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u8(out + 0, (uint8_t)unit_address);
    if (code > 255u) {
        return CK10_ERR_UNKNOWN_CODE;
    }
    ck10_store_u8(out + 1, (uint8_t)code);
    ck10_store_u16_le(out + total - 2u, ck10_crc16_modbus(out, total - 2u));
    *length = total;
    return CK10_OK;
}

/** An opened response: its header, and where its body is. */
typedef struct ck10_rtu_response_frame {
    /**
     * Printed as 位址.
     * Source: 1.2 L112
     */
    uint8_t unit_address;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    /** The frame is an exception response; its body is the record of the exception. */
    bool error;
    const uint8_t *body;
    size_t body_length;
} ck10_rtu_response_frame;

/** Checks a frame and finds its body. */
static inline ck10_codec_status ck10_rtu_response_open(const uint8_t *frame, size_t size, ck10_rtu_response_frame *out)
{
    const uint8_t *in = frame;
    size_t length = size;
    if (length < 4u) {
        return CK10_ERR_INCOMPLETE;
    }
    if (ck10_crc16_modbus(in, length - 2u) != ck10_load_u16_le(in + length - 2u)) {
        return CK10_ERR_WRONG_CHECKSUM;
    }
    out->unit_address = ck10_load_u8(in + 0);
    out->code = ck10_load_u8(in + 1);
    out->error = (out->code & 128u) != 0;
    if (out->error) {
        out->code &= ~(uint32_t)128u;
    }
    if (!out->error && out->code != 3u && out->code != 6u && out->code != 16u && out->code != 17u) {
        return CK10_ERR_UNKNOWN_CODE;
    }
    out->body = in + 2u;
    out->body_length = length - 4u;
    return CK10_OK;
}

/** Completes a frame whose body is at out + 2. `length` receives the size of the frame. */
static inline ck10_codec_status ck10_rtu_response_close(uint8_t unit_address, uint32_t code, size_t body_length,
        uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 4u;
    if (capacity < 4u || body_length > capacity - 4u) {
        return CK10_ERR_CAPACITY;
    }
    if (!((unit_address >= 1 && unit_address <= 16) || (unit_address == 0))) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u8(out + 0, (uint8_t)unit_address);
    if (code > 255u) {
        return CK10_ERR_UNKNOWN_CODE;
    }
    ck10_store_u8(out + 1, (uint8_t)code);
    ck10_store_u16_le(out + total - 2u, ck10_crc16_modbus(out, total - 2u));
    *length = total;
    return CK10_OK;
}

/** Writes the whole frame of the request read_registers_request. */
static inline ck10_codec_status ck10_rtu_encode_read_registers_request(uint8_t unit_address,
        const ck10_read_registers_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_read_registers_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    if (unit_address == 0) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    return ck10_rtu_request_close(unit_address, 3u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response read_registers_response. */
static inline ck10_codec_status ck10_rtu_encode_read_registers_response(uint8_t unit_address,
        const ck10_read_registers_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_read_registers_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_rtu_response_close(unit_address, 3u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request write_register_request. */
static inline ck10_codec_status ck10_rtu_encode_write_register_request(uint8_t unit_address,
        const ck10_write_register_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_write_register_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_rtu_request_close(unit_address, 6u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_register_response. */
static inline ck10_codec_status ck10_rtu_encode_write_register_response(uint8_t unit_address,
        const ck10_write_register_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_write_register_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_rtu_response_close(unit_address, 6u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request write_registers_request. */
static inline ck10_codec_status ck10_rtu_encode_write_registers_request(uint8_t unit_address,
        const ck10_write_registers_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_write_registers_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_rtu_request_close(unit_address, 16u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_registers_response. */
static inline ck10_codec_status ck10_rtu_encode_write_registers_response(uint8_t unit_address,
        const ck10_write_registers_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_write_registers_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_rtu_response_close(unit_address, 16u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request report_server_id_request. */
static inline ck10_codec_status ck10_rtu_encode_report_server_id_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    if (unit_address == 0) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    return ck10_rtu_request_close(unit_address, 17u, 0, out, capacity, length);
}

/** Writes the whole frame of the response report_server_id_response. */
static inline ck10_codec_status ck10_rtu_encode_report_server_id_response(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_report_server_id_response_encode(out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_rtu_response_close(unit_address, 17u, body_length, out, capacity, length);
}

/** Writes the whole frame of an exception response to a code. */
static inline ck10_codec_status ck10_rtu_encode_exception_response(uint8_t unit_address, uint32_t code,
        const ck10_exception *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_exception_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_rtu_response_close(unit_address, code | 128u, body_length, out, capacity, length);
}

/**
 * RS-485, half duplex, asynchronous. Each byte is two characters, the high one first.
 * Printed as Modbus ASC.
 * Frames are hexadecimal characters; they begin with 3A and end with 0D 0A.
 * Note: Two characters may be one second apart at most (L103).
 * Note: The tables of 1.3 and 1.4 print two columns for the check, low and high; the LRC is one byte (1.2
 * L101).
 * Source: 1.2 L68-76, 88-103
 */
/** Removes the delimiters and writes the bytes between them. `out` may be the frame itself. */
static inline ck10_codec_status ck10_ascii_parts(const uint8_t *frame, size_t size, uint8_t *out, size_t capacity,
        size_t *length)
{
    size_t at;
    if (size < 3u) {
        return CK10_ERR_WRONG_MARK;
    }
    if (frame[0] != 0x3Au || frame[size - 2u] != 0x0Du || frame[size - 1u] != 0x0Au) {
        return CK10_ERR_WRONG_MARK;
    }
    *length = size - 3u;
    for (at = 0; at < *length; at++) {
        if (ck10_digit(frame[1u + at]) > 15u) {
            return CK10_ERR_NOT_HEX;
        }
    }
    if (*length % 2u != 0) {
        return CK10_ERR_WRONG_LENGTH;
    }
    *length /= 2u;
    if (capacity < *length) {
        return CK10_ERR_CAPACITY;
    }
    for (at = 0; at < *length; at++) {
        out[at] = (uint8_t)(ck10_digit(frame[1u + 2u * at]) << 4 | ck10_digit(frame[2u + 2u * at]));
    }
    return CK10_OK;
}

/** An opened request: its header, and where its body is. */
typedef struct ck10_ascii_request_frame {
    /**
     * Printed as 位址.
     * Source: 1.2 L95
     */
    uint8_t unit_address;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    const uint8_t *body;
    size_t body_length;
} ck10_ascii_request_frame;

/**
 * Checks a frame and finds its body.
 * `buffer` receives the bytes of the frame, and the body points into it.
 */
static inline ck10_codec_status ck10_ascii_request_open(const uint8_t *frame, size_t size, uint8_t *buffer,
        size_t capacity, ck10_ascii_request_frame *out)
{
    const uint8_t *in = buffer;
    size_t length = 0;
    ck10_codec_status status;
    status = ck10_ascii_parts(frame, size, buffer, capacity, &length);
    if (status != CK10_OK) {
        return status;
    }
    if (length < 3u) {
        return CK10_ERR_INCOMPLETE;
    }
    if (ck10_lrc(in, length - 1u) != ck10_load_u8(in + length - 1u)) {
        return CK10_ERR_WRONG_CHECKSUM;
    }
    out->unit_address = ck10_load_u8(in + 0);
    out->code = ck10_load_u8(in + 1);
    if (out->code != 3u && out->code != 6u && out->code != 16u && out->code != 17u) {
        return CK10_ERR_UNKNOWN_CODE;
    }
    out->body = in + 2u;
    out->body_length = length - 3u;
    return CK10_OK;
}

/** Completes a frame whose body is at out + 2. `length` receives the size of the frame. */
static inline ck10_codec_status ck10_ascii_request_close(uint8_t unit_address, uint32_t code, size_t body_length,
        uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 3u;
    size_t at;
    if (capacity < 9u || body_length > (capacity - 9u) / 2u) {
        return CK10_ERR_CAPACITY;
    }
    if (!((unit_address >= 1 && unit_address <= 16) || (unit_address == 0))) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u8(out + 0, (uint8_t)unit_address);
    if (code > 255u) {
        return CK10_ERR_UNKNOWN_CODE;
    }
    ck10_store_u8(out + 1, (uint8_t)code);
    ck10_store_u8(out + total - 1u, ck10_lrc(out, total - 1u));
    for (at = total; at-- > 0;) {
        const uint8_t byte = out[at];
        out[1u + 2u * at] = ck10_hex_digit((uint8_t)(byte >> 4));
        out[2u + 2u * at] = ck10_hex_digit((uint8_t)(byte & 15u));
    }
    out[0] = 0x3A;
    out[1u + 2u * total + 0u] = 0x0D;
    out[1u + 2u * total + 1u] = 0x0A;
    *length = total * 2u + 3u;
    return CK10_OK;
}

/** An opened response: its header, and where its body is. */
typedef struct ck10_ascii_response_frame {
    /**
     * Printed as 位址.
     * Source: 1.2 L95
     */
    uint8_t unit_address;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    /** The frame is an exception response; its body is the record of the exception. */
    bool error;
    const uint8_t *body;
    size_t body_length;
} ck10_ascii_response_frame;

/**
 * Checks a frame and finds its body.
 * `buffer` receives the bytes of the frame, and the body points into it.
 */
static inline ck10_codec_status ck10_ascii_response_open(const uint8_t *frame, size_t size, uint8_t *buffer,
        size_t capacity, ck10_ascii_response_frame *out)
{
    const uint8_t *in = buffer;
    size_t length = 0;
    ck10_codec_status status;
    status = ck10_ascii_parts(frame, size, buffer, capacity, &length);
    if (status != CK10_OK) {
        return status;
    }
    if (length < 3u) {
        return CK10_ERR_INCOMPLETE;
    }
    if (ck10_lrc(in, length - 1u) != ck10_load_u8(in + length - 1u)) {
        return CK10_ERR_WRONG_CHECKSUM;
    }
    out->unit_address = ck10_load_u8(in + 0);
    out->code = ck10_load_u8(in + 1);
    out->error = (out->code & 128u) != 0;
    if (out->error) {
        out->code &= ~(uint32_t)128u;
    }
    if (!out->error && out->code != 3u && out->code != 6u && out->code != 16u && out->code != 17u) {
        return CK10_ERR_UNKNOWN_CODE;
    }
    out->body = in + 2u;
    out->body_length = length - 3u;
    return CK10_OK;
}

/** Completes a frame whose body is at out + 2. `length` receives the size of the frame. */
static inline ck10_codec_status ck10_ascii_response_close(uint8_t unit_address, uint32_t code, size_t body_length,
        uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 3u;
    size_t at;
    if (capacity < 9u || body_length > (capacity - 9u) / 2u) {
        return CK10_ERR_CAPACITY;
    }
    if (!((unit_address >= 1 && unit_address <= 16) || (unit_address == 0))) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    ck10_store_u8(out + 0, (uint8_t)unit_address);
    if (code > 255u) {
        return CK10_ERR_UNKNOWN_CODE;
    }
    ck10_store_u8(out + 1, (uint8_t)code);
    ck10_store_u8(out + total - 1u, ck10_lrc(out, total - 1u));
    for (at = total; at-- > 0;) {
        const uint8_t byte = out[at];
        out[1u + 2u * at] = ck10_hex_digit((uint8_t)(byte >> 4));
        out[2u + 2u * at] = ck10_hex_digit((uint8_t)(byte & 15u));
    }
    out[0] = 0x3A;
    out[1u + 2u * total + 0u] = 0x0D;
    out[1u + 2u * total + 1u] = 0x0A;
    *length = total * 2u + 3u;
    return CK10_OK;
}

/** Writes the whole frame of the request read_registers_request. */
static inline ck10_codec_status ck10_ascii_encode_read_registers_request(uint8_t unit_address,
        const ck10_read_registers_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_read_registers_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    if (unit_address == 0) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    return ck10_ascii_request_close(unit_address, 3u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response read_registers_response. */
static inline ck10_codec_status ck10_ascii_encode_read_registers_response(uint8_t unit_address,
        const ck10_read_registers_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_read_registers_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_ascii_response_close(unit_address, 3u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request write_register_request. */
static inline ck10_codec_status ck10_ascii_encode_write_register_request(uint8_t unit_address,
        const ck10_write_register_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_write_register_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_ascii_request_close(unit_address, 6u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_register_response. */
static inline ck10_codec_status ck10_ascii_encode_write_register_response(uint8_t unit_address,
        const ck10_write_register_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_write_register_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_ascii_response_close(unit_address, 6u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request write_registers_request. */
static inline ck10_codec_status ck10_ascii_encode_write_registers_request(uint8_t unit_address,
        const ck10_write_registers_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_write_registers_request_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_ascii_request_close(unit_address, 16u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_registers_response. */
static inline ck10_codec_status ck10_ascii_encode_write_registers_response(uint8_t unit_address,
        const ck10_write_registers_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_write_registers_response_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_ascii_response_close(unit_address, 16u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request report_server_id_request. */
static inline ck10_codec_status ck10_ascii_encode_report_server_id_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    if (unit_address == 0) {
        return CK10_ERR_OUT_OF_RANGE;
    }
    return ck10_ascii_request_close(unit_address, 17u, 0, out, capacity, length);
}

/** Writes the whole frame of the response report_server_id_response. */
static inline ck10_codec_status ck10_ascii_encode_report_server_id_response(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_report_server_id_response_encode(out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_ascii_response_close(unit_address, 17u, body_length, out, capacity, length);
}

/** Writes the whole frame of an exception response to a code. */
static inline ck10_codec_status ck10_ascii_encode_exception_response(uint8_t unit_address, uint32_t code,
        const ck10_exception *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    ck10_codec_status status;
    if (capacity < 2u) {
        return CK10_ERR_CAPACITY;
    }
    status = ck10_exception_encode(in, out + 2, capacity - 2u, &body_length);
    if (status != CK10_OK) {
        return status;
    }
    return ck10_ascii_response_close(unit_address, code | 128u, body_length, out, capacity, length);
}

/* ---- Texts of codes, in UTF-8 ---- */

#ifdef CK10_WITH_TEXTS
/** The texts of a code. Line ends separate several causes or remedies. `printed` is the code as the manual writes it;
 * `number` is the second number that the manual gives the code, or -1. */
typedef struct ck10_code_text {
    int64_t code;
    int64_t number;
    const char *printed;
    const char *name;
    const char *label;
    const char *problem;
    const char *causes;
    const char *remedies;
} ck10_code_text;

/** The texts of a code of ck10_exception_code, or NULL if the code is unknown. */
static inline const ck10_code_text *ck10_exception_code_text(int64_t code)
{
    static const ck10_code_text texts[] = {
        {INT64_C(1), (-INT64_C(1)), "", "illegal_function", "\347\204\241\346\225\210\345\212\237\350\203\275", "The command is not supported.", "", ""},
        {INT64_C(2), (-INT64_C(1)), "", "illegal_data_address", "\347\204\241\346\225\210\350\263\207\346\226\231\344\275\215\347\275\256", "The address is not allowed.", "", ""},
        {INT64_C(3), (-INT64_C(1)), "", "illegal_data_value", "\347\204\241\346\225\210\350\263\207\346\226\231\345\200\274", "The value is not allowed.", "", ""},
        {INT64_C(4), (-INT64_C(1)), "", "device_failure", "\345\276\236\347\253\231\350\243\235\347\275\256\351\214\257\350\252\244", "An error came up while the controller carried out the command.", "", ""},
    };
    size_t at;
    for (at = 0; at < sizeof texts / sizeof texts[0]; at++) {
        if (texts[at].code == code) {
            return &texts[at];
        }
    }
    return NULL;
}

/** The texts of a code of ck10_alarm_code, or NULL if the code is unknown. */
static inline const ck10_code_text *ck10_alarm_code_text(int64_t code)
{
    static const ck10_code_text texts[] = {
        {INT64_C(0), (-INT64_C(1)), "", "no_alarm", "\347\204\241\350\255\246\345\240\261", "", "", ""},
        {INT64_C(1), (-INT64_C(1)), "", "overcurrent", "\351\201\216\351\233\273\346\265\201", "Too much current.", "", ""},
        {INT64_C(2), (-INT64_C(1)), "", "overspeed", "\351\201\216\351\200\237\345\272\246", "The motor turns faster than 3300 rpm.", "", ""},
        {INT64_C(3), (-INT64_C(1)), "", "position_tracking", "\344\275\215\347\275\256\350\277\275\350\271\244", "While moving, the position error became greater than the tracking limit.", "", ""},
        {INT64_C(4), (-INT64_C(1)), "", "overload", "\351\201\216\350\262\240\350\274\211", "For more than 5 s the load was greater than the motor can bear.", "", ""},
        {INT64_C(5), (-INT64_C(1)), "", "overheat", "\351\201\216\346\272\253\345\272\246", "The inside of the controller became hotter than 85 degrees Celsius.", "", ""},
        {INT64_C(6), (-INT64_C(1)), "", "back_emf", "\345\217\215\351\233\273\345\213\225\345\213\242", "The voltage that the motor gives back became higher than 48 V.", "", ""},
        {INT64_C(7), (-INT64_C(1)), "", "motor_connection", "\351\246\254\351\201\224\351\200\243\347\265\220", "The connection of the motor is not as it should be.", "", ""},
        {INT64_C(8), (-INT64_C(1)), "", "encoder_connection", "\347\267\250\347\242\274\345\231\250\351\200\243\347\265\220", "The connection of the encoder is not as it should be.", "", ""},
        {INT64_C(10), (-INT64_C(1)), "", "in_position_error", "\345\256\232\344\275\215", "After the stop there was a position error for more than 3 s.", "", ""},
        {INT64_C(12), (-INT64_C(1)), "", "memory", "\350\250\230\346\206\266\351\253\224\350\243\235\347\275\256", "The memory device is not as it should be.", "", ""},
        {INT64_C(15), (-INT64_C(1)), "", "position_overflow", "\344\275\215\347\275\256\346\272\242\345\207\272", "At rest, the position error became greater than the overflow limit.", "", ""},
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

/** Whether point.command is not a quantity: ignored. */
static inline bool ck10_point_command_is_absent(uint16_t value)
{
    return value == 65535u;
}

/** Whether point.jump_point is not a quantity: ignored. */
static inline bool ck10_point_jump_point_is_absent(uint16_t value)
{
    return value == 65535u;
}

/** Whether point.jump_point_of_input_0 is not a quantity: ignored. */
static inline bool ck10_point_jump_point_of_input_0_is_absent(uint16_t value)
{
    return value == 65535u;
}

/** Whether point.jump_point_of_input_1 is not a quantity: ignored. */
static inline bool ck10_point_jump_point_of_input_1_is_absent(uint16_t value)
{
    return value == 65535u;
}

/** Whether point.jump_point_of_input_2 is not a quantity: ignored. */
static inline bool ck10_point_jump_point_of_input_2_is_absent(uint16_t value)
{
    return value == 65535u;
}

/** Whether point.clear_loop_counter_of is not a quantity: ignored. */
static inline bool ck10_point_clear_loop_counter_of_is_absent(uint16_t value)
{
    return value == 65535u;
}

/** Whether point.push_mode is not a quantity: stop_mode. */
static inline bool ck10_point_push_mode_is_absent(uint16_t value)
{
    return value == 0u;
}

/* ---- Values out of range ---- */

/** Whether point.low_speed is outside of its stated range. */
static inline bool ck10_point_low_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 35000u);
}

/** Whether point.high_speed is outside of its stated range. */
static inline bool ck10_point_high_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 500000u);
}

/** Whether point.acceleration_time is outside of its stated range. */
static inline bool ck10_point_acceleration_time_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether point.deceleration_time is outside of its stated range. */
static inline bool ck10_point_deceleration_time_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether point.waiting_time is outside of its stated range. */
static inline bool ck10_point_waiting_time_is_out_of_range(uint16_t value)
{
    return !(value <= 60000u);
}

/** Whether point.jump_point is outside of its stated range. */
static inline bool ck10_point_jump_point_is_out_of_range(uint16_t value)
{
    return !((value <= 127u) || (value >= 10000u && value <= 10127u) || (value == 65535u));
}

/** Whether point.jump_point_of_input_0 is outside of its stated range. */
static inline bool ck10_point_jump_point_of_input_0_is_out_of_range(uint16_t value)
{
    return !((value <= 127u) || (value >= 10000u && value <= 10127u) || (value == 65535u));
}

/** Whether point.jump_point_of_input_1 is outside of its stated range. */
static inline bool ck10_point_jump_point_of_input_1_is_out_of_range(uint16_t value)
{
    return !((value <= 127u) || (value >= 10000u && value <= 10127u) || (value == 65535u));
}

/** Whether point.jump_point_of_input_2 is outside of its stated range. */
static inline bool ck10_point_jump_point_of_input_2_is_out_of_range(uint16_t value)
{
    return !((value <= 127u) || (value >= 10000u && value <= 10127u) || (value == 65535u));
}

/** Whether point.loop_count is outside of its stated range. */
static inline bool ck10_point_loop_count_is_out_of_range(uint16_t value)
{
    return !(value <= 100u);
}

/** Whether point.loop_jump_point is outside of its stated range. */
static inline bool ck10_point_loop_jump_point_is_out_of_range(uint16_t value)
{
    return !((value <= 127u) || (value >= 10000u && value <= 10127u));
}

/** Whether point.output_setting is outside of its stated range. */
static inline bool ck10_point_output_setting_is_out_of_range(uint16_t value)
{
    return !(value <= 23u);
}

/** Whether point.clear_loop_counter_of is outside of its stated range. */
static inline bool ck10_point_clear_loop_counter_of_is_out_of_range(uint16_t value)
{
    return !((value <= 127u) || (value == 65535u));
}

/** Whether point.push_torque_ratio is outside of its stated range. */
static inline bool ck10_point_push_torque_ratio_is_out_of_range(uint16_t value)
{
    return !(value >= 20u && value <= 90u);
}

/** Whether point.push_speed is outside of its stated range. */
static inline bool ck10_point_push_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 33333u);
}

/** Whether point.push_mode is outside of its stated range. */
static inline bool ck10_point_push_mode_is_out_of_range(uint16_t value)
{
    return !(value <= 10000u);
}

/** Whether read_registers_request.word_count is outside of its stated range. */
static inline bool ck10_read_registers_request_word_count_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 125u);
}

/** Whether write_registers_request.word_count is outside of its stated range. */
static inline bool ck10_write_registers_request_word_count_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 123u);
}

/** Whether compare_pulse_width is outside of its stated range. */
static inline bool ck10_reg_compare_pulse_width_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 1000u);
}

/** Whether resolution is outside of its stated range. */
static inline bool ck10_reg_resolution_is_out_of_range(uint32_t value)
{
    return !(value <= 50000u);
}

/** Whether maximum_speed is outside of its stated range. */
static inline bool ck10_reg_maximum_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 800000u);
}

/** Whether start_speed is outside of its stated range. */
static inline bool ck10_reg_start_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 35000u);
}

/** Whether acceleration_time is outside of its stated range. */
static inline bool ck10_reg_acceleration_time_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether deceleration_time is outside of its stated range. */
static inline bool ck10_reg_deceleration_time_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether jog_speed is outside of its stated range. */
static inline bool ck10_reg_jog_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 800000u);
}

/** Whether jog_start_speed is outside of its stated range. */
static inline bool ck10_reg_jog_start_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 35000u);
}

/** Whether jog_acceleration_time is outside of its stated range. */
static inline bool ck10_reg_jog_acceleration_time_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether homing_speed is outside of its stated range. */
static inline bool ck10_reg_homing_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 800000u);
}

/** Whether homing_search_speed is outside of its stated range. */
static inline bool ck10_reg_homing_search_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 80000u);
}

/** Whether homing_acceleration_time is outside of its stated range. */
static inline bool ck10_reg_homing_acceleration_time_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether position_loop_gain is outside of its stated range. */
static inline bool ck10_reg_position_loop_gain_is_out_of_range(uint32_t value)
{
    return !(value <= 63u);
}

/** Whether in_position_range is outside of its stated range. */
static inline bool ck10_reg_in_position_range_is_out_of_range(uint32_t value)
{
    return !(value <= 127u);
}

/** Whether tracking_limit is outside of its stated range. */
static inline bool ck10_reg_tracking_limit_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 134217727u);
}

/** Whether homing_torque_ratio is outside of its stated range. */
static inline bool ck10_reg_homing_torque_ratio_is_out_of_range(uint32_t value)
{
    return !(value >= 20u && value <= 90u);
}

/** Whether position_overflow_limit is outside of its stated range. */
static inline bool ck10_reg_position_overflow_limit_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 134217727u);
}

/** Whether run_current is outside of its stated range. */
static inline bool ck10_reg_run_current_is_out_of_range(uint32_t value)
{
    return !(value >= 5u && value <= 15u);
}

/** Whether boost_current is outside of its stated range. */
static inline bool ck10_reg_boost_current_is_out_of_range(uint32_t value)
{
    return !(value <= 7u);
}

/** Whether stop_current is outside of its stated range. */
static inline bool ck10_reg_stop_current_is_out_of_range(uint32_t value)
{
    return !(value >= 2u && value <= 10u);
}

/** Whether flash_resolution is outside of its stated range. */
static inline bool ck10_reg_flash_resolution_is_out_of_range(uint32_t value)
{
    return !(value <= 50000u);
}

/** Whether flash_maximum_speed is outside of its stated range. */
static inline bool ck10_reg_flash_maximum_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 800000u);
}

/** Whether flash_start_speed is outside of its stated range. */
static inline bool ck10_reg_flash_start_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 35000u);
}

/** Whether flash_acceleration_time is outside of its stated range. */
static inline bool ck10_reg_flash_acceleration_time_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether flash_deceleration_time is outside of its stated range. */
static inline bool ck10_reg_flash_deceleration_time_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether flash_jog_speed is outside of its stated range. */
static inline bool ck10_reg_flash_jog_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 800000u);
}

/** Whether flash_jog_start_speed is outside of its stated range. */
static inline bool ck10_reg_flash_jog_start_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 35000u);
}

/** Whether flash_jog_acceleration_time is outside of its stated range. */
static inline bool ck10_reg_flash_jog_acceleration_time_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether flash_homing_speed is outside of its stated range. */
static inline bool ck10_reg_flash_homing_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 800000u);
}

/** Whether flash_homing_search_speed is outside of its stated range. */
static inline bool ck10_reg_flash_homing_search_speed_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 80000u);
}

/** Whether flash_homing_acceleration_time is outside of its stated range. */
static inline bool ck10_reg_flash_homing_acceleration_time_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether flash_position_loop_gain is outside of its stated range. */
static inline bool ck10_reg_flash_position_loop_gain_is_out_of_range(uint32_t value)
{
    return !(value <= 63u);
}

/** Whether flash_in_position_range is outside of its stated range. */
static inline bool ck10_reg_flash_in_position_range_is_out_of_range(uint32_t value)
{
    return !(value <= 127u);
}

/** Whether flash_tracking_limit is outside of its stated range. */
static inline bool ck10_reg_flash_tracking_limit_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 134217727u);
}

/** Whether flash_homing_torque_ratio is outside of its stated range. */
static inline bool ck10_reg_flash_homing_torque_ratio_is_out_of_range(uint32_t value)
{
    return !(value >= 20u && value <= 90u);
}

/** Whether flash_position_overflow_limit is outside of its stated range. */
static inline bool ck10_reg_flash_position_overflow_limit_is_out_of_range(uint32_t value)
{
    return !(value >= 1u && value <= 134217727u);
}

/** Whether flash_run_current is outside of its stated range. */
static inline bool ck10_reg_flash_run_current_is_out_of_range(uint32_t value)
{
    return !(value >= 5u && value <= 15u);
}

/** Whether flash_boost_current is outside of its stated range. */
static inline bool ck10_reg_flash_boost_current_is_out_of_range(uint32_t value)
{
    return !(value <= 7u);
}

/** Whether flash_stop_current is outside of its stated range. */
static inline bool ck10_reg_flash_stop_current_is_out_of_range(uint32_t value)
{
    return !(value >= 2u && value <= 10u);
}

#endif
