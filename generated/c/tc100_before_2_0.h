/*
 * TC100 (TOYO), version before-2.0
 * From: TC100 series operation manual V.2001
 * Identity: b1a30ddf3d283d0f
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
#ifdef TC100_INCLUDED
#ifndef TC100_VERSION_IS_BEFORE_2_0
#error "another version of this device is already included"
#endif
#else
#define TC100_INCLUDED
#define TC100_VERSION_IS_BEFORE_2_0

#if defined(__cplusplus) && __cplusplus < 201103L && !defined(__STDC_CONSTANT_MACROS)
#define __STDC_CONSTANT_MACROS
#endif
#if defined(__cplusplus) && __cplusplus < 201103L && !defined(__STDC_LIMIT_MACROS)
#define __STDC_LIMIT_MACROS
#endif
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define TC100_VERSION "before-2.0"
#define TC100_IDENTITY "b1a30ddf3d283d0f"

/* ---- Compilers and machines ---- */

#ifdef __GNUC__
/** A call would take more code than the function itself, even with -Os. */
#define TC100_INLINE static inline __attribute__((always_inline))
#define TC100_LIKELY(test) __builtin_expect(!!(test), 1)
/** An enum has 16 bits, even where the compiler makes enums as short as they can be: a cast of 256 does not become 0. */
#define TC100_ENUM_16 __attribute__((__mode__(__HI__)))
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
#define TC100_ENUM_16
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
    TC100_ERR_WRONG_CHECK = 5, /**< The checksum does not match. */
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
    size_t at;
    for (at = 0; at < size; at++) {
        if (in[at] > 127u) {
            return false;
        }
    }
    return true;
}

/** Whether a text of at most `size` characters is ASCII. */
static inline bool tc100_is_text(const char *text, size_t size)
{
    size_t at;
    for (at = 0; at < size && text[at] != '\0'; at++) {
        if ((uint8_t)text[at] > 127u) {
            return false;
        }
    }
    return true;
}

/** Writes a text of at most `size` characters, padded with zeros. */
static inline void tc100_put_text(uint8_t *out, const char *text, size_t size)
{
    size_t at;
    TC100_CLEAR(out, size);
    for (at = 0; at < size && text[at] != '\0'; at++) {
        out[at] = (uint8_t)text[at];
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
    size_t at;
    for (at = 0; at < size; at++) {
        crc = (uint16_t)(crc >> 8 ^ table[(crc ^ in[at]) & 0xFFu]);
    }
#else
    static const uint16_t table[16] = {
        0x0000u, 0xCC01u, 0xD801u, 0x1400u, 0xF001u, 0x3C00u, 0x2800u, 0xE401u,
        0xA001u, 0x6C00u, 0x7800u, 0xB401u, 0x5000u, 0x9C01u, 0x8801u, 0x4400u,
    };
    uint16_t crc = 0xFFFFu;
    size_t at;
    for (at = 0; at < size; at++) {
        crc = (uint16_t)(crc ^ in[at]);
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
    size_t at;
    for (at = 0; at < size; at++) {
        sum += in[at];
    }
    return (uint8_t)((0u - sum) & 0xFFu);
}

/* ---- Enums and codes ---- */

/**
 * Other values may occur.
 * Note: Where several exceptions apply, the one with the lowest code is sent (L1780-1782).
 * Source: 8.3 L1772-1776
 */
typedef enum tc100_exception_code {
    TC100_EXCEPTION_CODE_ILLEGAL_FUNCTION = 1, /**< 功能碼錯誤 The function code is none of those that the controller knows. */
    TC100_EXCEPTION_CODE_ILLEGAL_DATA_ADDRESS = 2, /**< 站號錯誤 A register that can only be written was read, one that can only be read was written, or there is no such register. */
    TC100_EXCEPTION_CODE_ILLEGAL_DATA_VALUE = 3 /**< 資料錯誤 A value is out of its range, too many words were asked for, a parameter cannot be changed, or number and data do not fit. */
} TC100_ENUM_16 tc100_exception_code;

/**
 * What is wrong with the drive or the motor. The servo stays off while an alarm stands (6.3).
 * Printed as AlarmStatus 警報狀態.
 * Other values may occur.
 * Note: The flash counts of the ERR LED in 10.2 and 10.3 are not these codes: each is the code plus one, from
 * 2 flashes for alarm 1 to 18 flashes for alarm 17. Alarm 15 has no flash count in print.
 * Source: 8.2 L1509
 */
typedef enum tc100_alarm_code {
    TC100_ALARM_CODE_NO_ALARM = 0, /**< 無警報 */
    TC100_ALARM_CODE_LOOP_ERROR = 1, /**< Loop error */
    TC100_ALARM_CODE_FULL_COUNT = 2, /**< Full Count The difference of the actual and the commanded position exceeds the limit of register 0108H. */
    TC100_ALARM_CODE_OVERSPEED = 3, /**< 過速度 */
    TC100_ALARM_CODE_GAIN_ADJUSTMENT_ERROR = 4, /**< 增益值調整不良 */
    TC100_ALARM_CODE_OVERVOLTAGE = 5, /**< 過電壓 */
    TC100_ALARM_CODE_INITIALIZATION_ERROR = 6, /**< 初期化異常 */
    TC100_ALARM_CODE_EEPROM_ERROR = 7, /**< EEPROM 異常 */
    TC100_ALARM_CODE_MAIN_CIRCUIT_UNDERVOLTAGE = 8, /**< 主迴路電源電壓不足 */
    TC100_ALARM_CODE_OVERCURRENT = 9, /**< 過電流 */
    TC100_ALARM_CODE_REGENERATION_ERROR = 10, /**< 回生異常 */
    TC100_ALARM_CODE_EMERGENCY_STOP = 11, /**< 緊急停止 */
    TC100_ALARM_CODE_MOTOR_DISCONNECTED = 12, /**< 馬達斷線 */
    TC100_ALARM_CODE_ENCODER_DISCONNECTED = 13, /**< 編碼器斷線 */
    TC100_ALARM_CODE_CURRENT_PROTECTION = 14, /**< 保護電流值 */
    TC100_ALARM_CODE_POWER_CYCLE_REQUIRED = 15, /**< 電源再投入 */
    TC100_ALARM_CODE_ACTION_TIMEOUT = 17 /**< 動作超時 */
} TC100_ENUM_16 tc100_alarm_code;

/**
 * Why the controller did not carry out a command or accept a value.
 * Printed as ErrorStatus 故障狀態.
 * Other values may occur.
 * Source: 8.2 L1515
 */
typedef enum tc100_fault_code {
    TC100_FAULT_CODE_NO_FAULT = 0, /**< 沒有錯誤 */
    TC100_FAULT_CODE_MOTION_COMMAND_WHILE_MOVING = 1, /**< 在動作中接收動作指令 */
    TC100_FAULT_CODE_VALUE_OUT_OF_LIMITS = 2, /**< 上下限錯誤 */
    TC100_FAULT_CODE_ADDRESS_ERROR = 3, /**< 位置錯誤 */
    TC100_FAULT_CODE_FORMAT_ERROR = 4, /**< 格式錯誤 */
    TC100_FAULT_CODE_CONTROL_MODE_ERROR = 5, /**< 控制模式錯誤 */
    TC100_FAULT_CODE_POWER_CYCLE_REQUIRED = 6, /**< 斷電重開 */
    TC100_FAULT_CODE_INITIALIZATION_INCOMPLETE = 7, /**< 初始化未完成 */
    TC100_FAULT_CODE_SERVO_ON_OFF_ERROR = 8, /**< Servo ON/OFF 錯誤 */
    TC100_FAULT_CODE_LOCK_ACTIVE = 9, /**< LOCK */
    TC100_FAULT_CODE_SOFT_LIMIT_REACHED = 10, /**< 軟體極限 */
    TC100_FAULT_CODE_PARAMETER_WRITE_NOT_PERMITTED = 11, /**< 參數寫入權限不足 */
    TC100_FAULT_CODE_HOMING_INCOMPLETE = 12, /**< 原點復歸未完成 */
    TC100_FAULT_CODE_BRAKE_RELEASED = 13 /**< 剎車已解除 */
} TC100_ENUM_16 tc100_fault_code;

/** Source: 5.1 L1164 */
typedef enum tc100_rotation_direction {
    TC100_ROTATION_DIRECTION_CLOCKWISE = 0, /**< CW */
    TC100_ROTATION_DIRECTION_COUNTERCLOCKWISE = 1 /**< CCW */
} TC100_ENUM_16 tc100_rotation_direction;

/** Whether a value is one of tc100_rotation_direction. */
static inline bool tc100_rotation_direction_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Source: 5.1 L1165 */
typedef enum tc100_pulse_input_form {
    TC100_PULSE_INPUT_FORM_CLOCKWISE_AND_COUNTERCLOCKWISE = 0, /**< CW/CCW One pulse train for each direction. */
    TC100_PULSE_INPUT_FORM_PULSE_AND_DIRECTION = 1, /**< PULSE/DIR */
    TC100_PULSE_INPUT_FORM_TWO_PHASES = 2 /**< A 相 /B 相 */
} TC100_ENUM_16 tc100_pulse_input_form;

/** Whether a value is one of tc100_pulse_input_form. */
static inline bool tc100_pulse_input_form_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(2));
}

/** Source: 5.3 L1184 */
typedef enum tc100_control_mode {
    TC100_CONTROL_MODE_POSITION_MODE = 0, /**< 位置模式 */
    TC100_CONTROL_MODE_TORQUE_MODE = 1 /**< 扭力模式 */
} TC100_ENUM_16 tc100_control_mode;

/** Whether a value is one of tc100_control_mode. */
static inline bool tc100_control_mode_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/**
 * Note: 0 is on. The servo status 100CH numbers the states the other way round.
 * Source: 5.3 L1185; 8.2 L1622
 */
typedef enum tc100_servo_command {
    TC100_SERVO_COMMAND_SERVO_ON = 0, /**< 伺服ON */
    TC100_SERVO_COMMAND_SERVO_OFF = 1 /**< 伺服OFF */
} TC100_ENUM_16 tc100_servo_command;

/** Whether a value is one of tc100_servo_command. */
static inline bool tc100_servo_command_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Source: 5.6 L1242 */
typedef enum tc100_moving_state_rule {
    TC100_MOVING_STATE_RULE_PULSES_SENT = 0, /**< When all pulses of the move have been given out. */
    TC100_MOVING_STATE_RULE_PULSES_SENT_AND_IN_POSITION = 1 /**< When all pulses of the move have been given out and the in position signal is on. */
} TC100_ENUM_16 tc100_moving_state_rule;

/** Whether a value is one of tc100_moving_state_rule. */
static inline bool tc100_moving_state_rule_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Source: 5.7 L1253 */
typedef enum tc100_homing_mode {
    TC100_HOMING_MODE_TORQUE_POSITIVE = 0, /**< 扭力復歸 + 方向 Positive direction until the torque limit. */
    TC100_HOMING_MODE_TORQUE_NEGATIVE = 1, /**< 扭力復歸 - 方向 Negative direction until the torque limit. */
    TC100_HOMING_MODE_TORQUE_POSITIVE_THEN_Z_PHASE = 2, /**< 扭力復歸 + 方向後，反向找 Z 相 Positive direction until the torque limit, then back to the Z phase. */
    TC100_HOMING_MODE_TORQUE_NEGATIVE_THEN_Z_PHASE = 3, /**< 扭力復歸 - 方向後，反向找 Z 相 Negative direction until the torque limit, then back to the Z phase. */
    TC100_HOMING_MODE_SENSOR_POSITIVE = 4, /**< + 方向找 ORG_SIG 信號 Positive direction until the homing sensor. */
    TC100_HOMING_MODE_SENSOR_NEGATIVE = 5, /**< - 方向找 ORG_SIG 信號 Negative direction until the homing sensor. */
    TC100_HOMING_MODE_SENSOR_POSITIVE_THEN_Z_PHASE = 6, /**< + 方向找 ORG_SIG 信號後，反向找 Z 相 Positive direction until the homing sensor, then back to the Z phase. */
    TC100_HOMING_MODE_SENSOR_NEGATIVE_THEN_Z_PHASE = 7 /**< - 方向找 ORG_SIG 信號後，反向找 Z 相 Negative direction until the homing sensor, then back to the Z phase. */
} TC100_ENUM_16 tc100_homing_mode;

/** Whether a value is one of tc100_homing_mode. */
static inline bool tc100_homing_mode_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(7));
}

/** Source: 5.8 L1271 */
typedef enum tc100_baud_rate {
    TC100_BAUD_RATE_BAUD_9600 = 0, /**< 9600bps */
    TC100_BAUD_RATE_BAUD_19200 = 1, /**< 19200bps */
    TC100_BAUD_RATE_BAUD_38400 = 2, /**< 38400bps */
    TC100_BAUD_RATE_BAUD_57600 = 3, /**< 57600bps */
    TC100_BAUD_RATE_BAUD_115200 = 4 /**< 115200bps */
} TC100_ENUM_16 tc100_baud_rate;

/** Whether a value is one of tc100_baud_rate. */
static inline bool tc100_baud_rate_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(4));
}

/** Source: 5.8 L1272 */
typedef enum tc100_data_bits {
    TC100_DATA_BITS_EIGHT_BITS = 0, /**< 8bit */
    TC100_DATA_BITS_SEVEN_BITS = 1 /**< 7bit */
} TC100_ENUM_16 tc100_data_bits;

/** Whether a value is one of tc100_data_bits. */
static inline bool tc100_data_bits_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Source: 5.8 L1273 */
typedef enum tc100_parity {
    TC100_PARITY_NO_PARITY = 0, /**< None */
    TC100_PARITY_EVEN_PARITY = 1, /**< Even */
    TC100_PARITY_ODD_PARITY = 2 /**< Odd */
} TC100_ENUM_16 tc100_parity;

/** Whether a value is one of tc100_parity. */
static inline bool tc100_parity_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(2));
}

/** Source: 5.8 L1275 */
typedef enum tc100_protocol {
    TC100_PROTOCOL_MODBUS_ASCII = 0, /**< MODBUS-ASCII */
    TC100_PROTOCOL_MODBUS_RTU = 1 /**< MODBUS-RTU */
} TC100_ENUM_16 tc100_protocol;

/** Whether a value is one of tc100_protocol. */
static inline bool tc100_protocol_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Source: 8.2 L1506 */
typedef enum tc100_action_status {
    TC100_ACTION_STATUS_STOPPED = 0, /**< 停止 */
    TC100_ACTION_STATUS_MOVING = 1, /**< 動作中 */
    TC100_ACTION_STATUS_STOPPED_BY_ERROR = 2 /**< 異常停止 An abnormal stop. */
} TC100_ENUM_16 tc100_action_status;

/** Whether a value is one of tc100_action_status. */
static inline bool tc100_action_status_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(2));
}

/** Source: 8.2 L1620 */
typedef enum tc100_torque_search_direction {
    TC100_TORQUE_SEARCH_DIRECTION_POSITIVE = 0, /**< + 方向 */
    TC100_TORQUE_SEARCH_DIRECTION_NEGATIVE = 1 /**< - 方向 */
} TC100_ENUM_16 tc100_torque_search_direction;

/** Whether a value is one of tc100_torque_search_direction. */
static inline bool tc100_torque_search_direction_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/**
 * Note: Points number the same motions differently: homing is 3 here and 2 in a point's mode.
 * Source: 8.2 L1624
 */
typedef enum tc100_motion_command {
    TC100_MOTION_COMMAND_RELATIVE_MOVE = 0, /**< INC 相對位置移動 Moves by the distance in 2000H. */
    TC100_MOTION_COMMAND_ABSOLUTE_MOVE = 1, /**< ABS 絶對位置移動 Moves to the position in 2002H. */
    TC100_MOTION_COMMAND_TORQUE_SEARCH = 2, /**< TSL 扭力搜尋移動 Moves in the direction of 2005H until the torque limit. */
    TC100_MOTION_COMMAND_HOMING = 3, /**< ORG 原點復歸 */
    TC100_MOTION_COMMAND_PRESET_POSITION = 4, /**< 設定指令和現在位置數據值 Gives the commanded and the present position the value in 2006H. */
    TC100_MOTION_COMMAND_ALARM_RESET = 6, /**< 警報重置 */
    TC100_MOTION_COMMAND_CLEAR_DEVIATION = 7, /**< 偏差清除 Makes the commanded position equal to the present one. */
    TC100_MOTION_COMMAND_DECELERATE_AND_STOP = 8, /**< 減速停止 */
    TC100_MOTION_COMMAND_EMERGENCY_STOP = 9, /**< 緊急停止 */
    TC100_MOTION_COMMAND_JOG_POSITIVE = 11, /**< + JOG Jogs in the positive direction. How long is not described. */
    TC100_MOTION_COMMAND_JOG_NEGATIVE = 12 /**< - JOG Jogs in the negative direction. How long is not described. */
} TC100_ENUM_16 tc100_motion_command;

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

/** Source: 8.2 L1667 */
typedef enum tc100_parameter_storage {
    TC100_PARAMETER_STORAGE_PRESENT_PARAMETERS = 0, /**< 當前參數 The parameters as they are. */
    TC100_PARAMETER_STORAGE_DEFAULT_PARAMETERS = 1 /**< 默認數據 The default values. */
} TC100_ENUM_16 tc100_parameter_storage;

/** Whether a value is one of tc100_parameter_storage. */
static inline bool tc100_parameter_storage_known(int64_t value)
{
    return TC100_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/**
 * Other values may occur.
 * Note: The gripper software of 9.5 has the modes CLOSE, CLOSE-R, OPEN and OPEN-R too. Their codes are not
 * printed; the values may be among those that are called unavailable here, so values without a name are passed
 * on.
 * Note: The vendor's software numbers its list of modes by itself: its 05 and 06 are INC-R and ABS-R (9.3),
 * which are 12 and 13 on the wire.
 * Note: The motion command 201EH numbers the same motions differently: homing is 3 there and 2 here.
 * Note: Nine modes are available (4.1).
 * Source: 8.2 L1648
 */
typedef enum tc100_point_mode {
    TC100_POINT_MODE_RELATIVE_MOVE = 0, /**< INC 相對位置移動 Moves by the distance. */
    TC100_POINT_MODE_ABSOLUTE_MOVE = 1, /**< ABS 絶對位置移動 Moves to the position. */
    TC100_POINT_MODE_HOMING = 2, /**< ORG 原點復歸 */
    TC100_POINT_MODE_TORQUE_SEARCH_POSITIVE = 3, /**< + TSL 正方向扭力搜尋移動 Moves in the positive direction until the torque limit, or to the end of the stroke. */
    TC100_POINT_MODE_TORQUE_SEARCH_NEGATIVE = 4, /**< - TSL 負方向扭力搜尋移動 Moves in the negative direction until the torque limit, or to the end of the stroke. */
    TC100_POINT_MODE_RELATIVE_MOVE_CONTINUOUS = 12, /**< INC-R 相對位置移動 (連續移動) Moves by the distance and on to the next point without a stop, changing speed. */
    TC100_POINT_MODE_ABSOLUTE_MOVE_CONTINUOUS = 13, /**< ABS-R 絶對位置移動 (連續移動) Moves to the position and on to the next point without a stop, changing speed. */
    TC100_POINT_MODE_RELATIVE_MOVE_WITH_TORQUE = 15, /**< INC-T 相對位置移動 [扭力模式] Moves by the distance with the torque limit; stops and reports when more torque is needed. */
    TC100_POINT_MODE_ABSOLUTE_MOVE_WITH_TORQUE = 16 /**< ABS-T 絶對位置移動 [扭力模式] Moves to the position with the torque limit; stops and reports when more torque is needed. */
} TC100_ENUM_16 tc100_point_mode;

/* ---- Bit fields ---- */

/**
 * All simulated inputs.
 * A word of 16 bits.
 * Source: 8.2 L1625
 */
typedef uint16_t tc100_simulated_input_word;

/**
 * Printed as IN1.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_1_MASK 0x0001u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_1_SHIFT 0u
static inline bool tc100_simulated_input_word_simulated_input_1(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_1_MASK) != 0;
}

/**
 * Printed as IN2.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_2_MASK 0x0002u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_2_SHIFT 1u
static inline bool tc100_simulated_input_word_simulated_input_2(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_2_MASK) != 0;
}

/**
 * Printed as IN3.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_3_MASK 0x0004u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_3_SHIFT 2u
static inline bool tc100_simulated_input_word_simulated_input_3(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_3_MASK) != 0;
}

/**
 * Printed as IN4.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_4_MASK 0x0008u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_4_SHIFT 3u
static inline bool tc100_simulated_input_word_simulated_input_4(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_4_MASK) != 0;
}

/**
 * Printed as IN5.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_5_MASK 0x0010u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_5_SHIFT 4u
static inline bool tc100_simulated_input_word_simulated_input_5(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_5_MASK) != 0;
}

/**
 * Printed as IN6.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_6_MASK 0x0020u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_6_SHIFT 5u
static inline bool tc100_simulated_input_word_simulated_input_6(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_6_MASK) != 0;
}

/**
 * Printed as IN7.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_7_MASK 0x0040u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_7_SHIFT 6u
static inline bool tc100_simulated_input_word_simulated_input_7(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_7_MASK) != 0;
}

/**
 * Printed as IN8.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_8_MASK 0x0080u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_8_SHIFT 7u
static inline bool tc100_simulated_input_word_simulated_input_8(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_8_MASK) != 0;
}

/**
 * Printed as IN9.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_9_MASK 0x0100u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_9_SHIFT 8u
static inline bool tc100_simulated_input_word_simulated_input_9(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_9_MASK) != 0;
}

/**
 * Printed as IN10.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_10_MASK 0x0200u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_10_SHIFT 9u
static inline bool tc100_simulated_input_word_simulated_input_10(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_10_MASK) != 0;
}

/**
 * Printed as IN11.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_11_MASK 0x0400u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_11_SHIFT 10u
static inline bool tc100_simulated_input_word_simulated_input_11(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_11_MASK) != 0;
}

/**
 * Printed as IN12.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_12_MASK 0x0800u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_12_SHIFT 11u
static inline bool tc100_simulated_input_word_simulated_input_12(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_12_MASK) != 0;
}

/**
 * Printed as IN13.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_13_MASK 0x1000u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_13_SHIFT 12u
static inline bool tc100_simulated_input_word_simulated_input_13(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_13_MASK) != 0;
}

/**
 * Printed as IN14.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_14_MASK 0x2000u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_14_SHIFT 13u
static inline bool tc100_simulated_input_word_simulated_input_14(uint16_t word)
{
    return (word & TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_14_MASK) != 0;
}

/**
 * All outputs.
 * A word of 16 bits.
 * Source: 8.2 L1517
 */
typedef uint16_t tc100_output_word;

/**
 * Printed as OUT 1.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_1_MASK 0x0001u
#define TC100_OUTPUT_WORD_OUTPUT_1_SHIFT 0u
static inline bool tc100_output_word_output_1(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_1_MASK) != 0;
}

/**
 * Printed as OUT 2.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_2_MASK 0x0002u
#define TC100_OUTPUT_WORD_OUTPUT_2_SHIFT 1u
static inline bool tc100_output_word_output_2(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_2_MASK) != 0;
}

/**
 * Printed as OUT 3.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_3_MASK 0x0004u
#define TC100_OUTPUT_WORD_OUTPUT_3_SHIFT 2u
static inline bool tc100_output_word_output_3(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_3_MASK) != 0;
}

/**
 * Printed as OUT 4.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_4_MASK 0x0008u
#define TC100_OUTPUT_WORD_OUTPUT_4_SHIFT 3u
static inline bool tc100_output_word_output_4(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_4_MASK) != 0;
}

/**
 * Printed as OUT 5.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_5_MASK 0x0010u
#define TC100_OUTPUT_WORD_OUTPUT_5_SHIFT 4u
static inline bool tc100_output_word_output_5(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_5_MASK) != 0;
}

/**
 * Printed as OUT 6.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_6_MASK 0x0020u
#define TC100_OUTPUT_WORD_OUTPUT_6_SHIFT 5u
static inline bool tc100_output_word_output_6(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_6_MASK) != 0;
}

/**
 * Printed as OUT 7.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_7_MASK 0x0040u
#define TC100_OUTPUT_WORD_OUTPUT_7_SHIFT 6u
static inline bool tc100_output_word_output_7(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_7_MASK) != 0;
}

/**
 * Printed as OUT 8.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_8_MASK 0x0080u
#define TC100_OUTPUT_WORD_OUTPUT_8_SHIFT 7u
static inline bool tc100_output_word_output_8(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_8_MASK) != 0;
}

/**
 * Printed as OUT 9.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_9_MASK 0x0100u
#define TC100_OUTPUT_WORD_OUTPUT_9_SHIFT 8u
static inline bool tc100_output_word_output_9(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_9_MASK) != 0;
}

/**
 * Printed as OUT 10.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_10_MASK 0x0200u
#define TC100_OUTPUT_WORD_OUTPUT_10_SHIFT 9u
static inline bool tc100_output_word_output_10(uint16_t word)
{
    return (word & TC100_OUTPUT_WORD_OUTPUT_10_MASK) != 0;
}

/**
 * All inputs.
 * A word of 16 bits.
 * Source: 8.2 L1531
 */
typedef uint16_t tc100_input_word;

/**
 * Printed as IN 1.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_1_MASK 0x0001u
#define TC100_INPUT_WORD_INPUT_1_SHIFT 0u
static inline bool tc100_input_word_input_1(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_1_MASK) != 0;
}

/**
 * Printed as IN 2.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_2_MASK 0x0002u
#define TC100_INPUT_WORD_INPUT_2_SHIFT 1u
static inline bool tc100_input_word_input_2(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_2_MASK) != 0;
}

/**
 * Printed as IN 3.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_3_MASK 0x0004u
#define TC100_INPUT_WORD_INPUT_3_SHIFT 2u
static inline bool tc100_input_word_input_3(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_3_MASK) != 0;
}

/**
 * Printed as IN 4.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_4_MASK 0x0008u
#define TC100_INPUT_WORD_INPUT_4_SHIFT 3u
static inline bool tc100_input_word_input_4(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_4_MASK) != 0;
}

/**
 * Printed as IN 5.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_5_MASK 0x0010u
#define TC100_INPUT_WORD_INPUT_5_SHIFT 4u
static inline bool tc100_input_word_input_5(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_5_MASK) != 0;
}

/**
 * Printed as IN 6.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_6_MASK 0x0020u
#define TC100_INPUT_WORD_INPUT_6_SHIFT 5u
static inline bool tc100_input_word_input_6(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_6_MASK) != 0;
}

/**
 * Printed as IN 7.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_7_MASK 0x0040u
#define TC100_INPUT_WORD_INPUT_7_SHIFT 6u
static inline bool tc100_input_word_input_7(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_7_MASK) != 0;
}

/**
 * Printed as IN 8.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_8_MASK 0x0080u
#define TC100_INPUT_WORD_INPUT_8_SHIFT 7u
static inline bool tc100_input_word_input_8(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_8_MASK) != 0;
}

/**
 * Printed as IN 9.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_9_MASK 0x0100u
#define TC100_INPUT_WORD_INPUT_9_SHIFT 8u
static inline bool tc100_input_word_input_9(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_9_MASK) != 0;
}

/**
 * Printed as IN 10.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_10_MASK 0x0200u
#define TC100_INPUT_WORD_INPUT_10_SHIFT 9u
static inline bool tc100_input_word_input_10(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_10_MASK) != 0;
}

/**
 * Printed as IN 11.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_11_MASK 0x0400u
#define TC100_INPUT_WORD_INPUT_11_SHIFT 10u
static inline bool tc100_input_word_input_11(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_11_MASK) != 0;
}

/**
 * Printed as IN 12.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_12_MASK 0x0800u
#define TC100_INPUT_WORD_INPUT_12_SHIFT 11u
static inline bool tc100_input_word_input_12(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_12_MASK) != 0;
}

/**
 * Printed as IN 13.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_13_MASK 0x1000u
#define TC100_INPUT_WORD_INPUT_13_SHIFT 12u
static inline bool tc100_input_word_input_13(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_13_MASK) != 0;
}

/**
 * Printed as IN 14.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_14_MASK 0x2000u
#define TC100_INPUT_WORD_INPUT_14_SHIFT 13u
static inline bool tc100_input_word_input_14(uint16_t word)
{
    return (word & TC100_INPUT_WORD_INPUT_14_MASK) != 0;
}

/**
 * Printed as Z 相.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_Z_PHASE_MASK 0x4000u
#define TC100_INPUT_WORD_Z_PHASE_SHIFT 14u
static inline bool tc100_input_word_z_phase(uint16_t word)
{
    return (word & TC100_INPUT_WORD_Z_PHASE_MASK) != 0;
}

/* ---- Records ---- */

#define TC100_EXCEPTION_SIZE 1u
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

#define TC100_POINT_SIZE 28u
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
    tc100_store_u16_be(out + 20, 0u);
    tc100_store_u16_be(out + 22, 0u);
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

/**
 * Reads neighbouring registers.
 * Printed as 03 H 資料讀取.
 * Read holding registers.
 * Source: 8.2 L1710
 */
#define TC100_READ_REGISTERS_CODE 3u

#define TC100_READ_REGISTERS_REQUEST_SIZE 4u
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

#define TC100_READ_REGISTERS_RESPONSE_SIZE 121u
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

/**
 * Writes one register. The response repeats the request.
 * Printed as 06 H 資料寫入 (1Word).
 * Write one register.
 * Source: 8.2 L1711
 */
#define TC100_WRITE_REGISTER_CODE 6u

#define TC100_WRITE_REGISTER_REQUEST_SIZE 4u
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

#define TC100_WRITE_REGISTER_RESPONSE_SIZE 4u
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

/**
 * Writes neighbouring registers. The response repeats the address and the number.
 * Printed as 10 H 連續資料寫入 (1Word 以上).
 * Write several registers.
 * Note: The manual gives 59, 60 and 63 words as the most that one request may write; the least of them is
 * safe.
 * Source: 8.2 L1712
 */
#define TC100_WRITE_REGISTERS_CODE 16u

#define TC100_WRITE_REGISTERS_REQUEST_SIZE 123u
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

#define TC100_WRITE_REGISTERS_RESPONSE_SIZE 4u
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

/**
 * Jogs in the positive direction while MANUAL is on.
 * Printed as JOG+ + JOG 移動.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1193
 */
#define TC100_REG_JOG_POSITIVE_INPUT_ADDRESS 0x0601u
#define TC100_REG_JOG_POSITIVE_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_jog_positive_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_jog_positive_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Jogs in the negative direction while MANUAL is on.
 * Printed as JOG- - JOG 移動.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1194
 */
#define TC100_REG_JOG_NEGATIVE_INPUT_ADDRESS 0x0602u
#define TC100_REG_JOG_NEGATIVE_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_jog_negative_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_jog_negative_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as MANUAL 手動模式.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1195
 */
#define TC100_REG_MANUAL_MODE_INPUT_ADDRESS 0x0603u
#define TC100_REG_MANUAL_MODE_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_manual_mode_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_manual_mode_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Stores the present position in the selected point while MANUAL is on.
 * Printed as TEACH 點位置存入.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1196
 */
#define TC100_REG_TEACH_INPUT_ADDRESS 0x0604u
#define TC100_REG_TEACH_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_teach_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_teach_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Pause, interlock.
 * Printed as LOCK 暫停 / 聯鎖.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1197
 */
#define TC100_REG_LOCK_INPUT_ADDRESS 0x0607u
#define TC100_REG_LOCK_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_lock_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_lock_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as PRGSEL4 程式選擇 No.0~127 Bit4.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1198
 */
#define TC100_REG_POINT_SELECT_BIT_4_INPUT_ADDRESS 0x060Eu
#define TC100_REG_POINT_SELECT_BIT_4_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_4_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_4_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as PRGSEL5 程式選擇 No.0~127 Bit5.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1199
 */
#define TC100_REG_POINT_SELECT_BIT_5_INPUT_ADDRESS 0x060Fu
#define TC100_REG_POINT_SELECT_BIT_5_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_5_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_5_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as PRGSEL6 程式選擇 No.0~127 Bit6.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1200
 */
#define TC100_REG_POINT_SELECT_BIT_6_INPUT_ADDRESS 0x0610u
#define TC100_REG_POINT_SELECT_BIT_6_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_6_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_6_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as ORG_SIG 原點復歸用檢出信號.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1201
 */
#define TC100_REG_HOMING_SENSOR_INPUT_ADDRESS 0x0611u
#define TC100_REG_HOMING_SENSOR_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_sensor_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_sensor_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Switches the brake while the servo is off.
 * Printed as BK_OFF 制動 ON/OFF 信號.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1202
 */
#define TC100_REG_BRAKE_INPUT_ADDRESS 0x0612u
#define TC100_REG_BRAKE_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_brake_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_brake_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Switches the detection of full count, which is active initially.
 * Printed as FULL_COUNT 切換 FULL-COUNT 判斷.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1203
 */
#define TC100_REG_FULL_COUNT_INPUT_ADDRESS 0x0613u
#define TC100_REG_FULL_COUNT_INPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_full_count_input_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_full_count_input_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as INPOSITION Inposition 到位信號.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1209
 */
#define TC100_REG_IN_POSITION_OUTPUT_ADDRESS 0x0700u
#define TC100_REG_IN_POSITION_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_in_position_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_in_position_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as ALARM 錯誤信號.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1210
 */
#define TC100_REG_ALARM_OUTPUT_ADDRESS 0x0701u
#define TC100_REG_ALARM_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_alarm_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_alarm_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Ready for the next point.
 * Printed as READY 準備完成，可執行下一點位.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1211
 */
#define TC100_REG_READY_OUTPUT_ADDRESS 0x0702u
#define TC100_REG_READY_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_ready_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_ready_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as MOVE 移動中.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1212
 */
#define TC100_REG_MOVING_OUTPUT_ADDRESS 0x0703u
#define TC100_REG_MOVING_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_moving_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_moving_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as SERVO-S SERVO ON 狀態.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1213
 */
#define TC100_REG_SERVO_ON_OUTPUT_ADDRESS 0x0705u
#define TC100_REG_SERVO_ON_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_servo_on_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_servo_on_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as PRGSEL0-S 程式選擇 No.0~127 Bit0.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1214
 */
#define TC100_REG_POINT_SELECT_BIT_0_OUTPUT_ADDRESS 0x0706u
#define TC100_REG_POINT_SELECT_BIT_0_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_0_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_0_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as PRGSEL1-S 程式選擇 No.0~127 Bit1.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1215
 */
#define TC100_REG_POINT_SELECT_BIT_1_OUTPUT_ADDRESS 0x0707u
#define TC100_REG_POINT_SELECT_BIT_1_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_1_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_1_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as PRGSEL2-S 程式選擇 No.0~127 Bit2.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1216
 */
#define TC100_REG_POINT_SELECT_BIT_2_OUTPUT_ADDRESS 0x0708u
#define TC100_REG_POINT_SELECT_BIT_2_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_2_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_2_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as PRGSEL3-S 程式選擇 No.0~127 Bit3.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1217
 */
#define TC100_REG_POINT_SELECT_BIT_3_OUTPUT_ADDRESS 0x0709u
#define TC100_REG_POINT_SELECT_BIT_3_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_3_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_3_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as PRGSEL4-S 程式選擇 No.0~127 Bit4.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1218
 */
#define TC100_REG_POINT_SELECT_BIT_4_OUTPUT_ADDRESS 0x070Au
#define TC100_REG_POINT_SELECT_BIT_4_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_4_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_4_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as PRGSEL5-S 程式選擇 No.0~127 Bit5.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1219
 */
#define TC100_REG_POINT_SELECT_BIT_5_OUTPUT_ADDRESS 0x070Bu
#define TC100_REG_POINT_SELECT_BIT_5_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_5_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_5_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as PRGSEL6-S 程式選擇 No.0~127 Bit6.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1220
 */
#define TC100_REG_POINT_SELECT_BIT_6_OUTPUT_ADDRESS 0x070Cu
#define TC100_REG_POINT_SELECT_BIT_6_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_6_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_point_select_bit_6_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Called TRQLIM in 6.2 and 7.5.
 * Printed as TRQ_LMT 扭力極限.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1221
 */
#define TC100_REG_TORQUE_LIMIT_OUTPUT_ADDRESS 0x070Du
#define TC100_REG_TORQUE_LIMIT_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_torque_limit_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_torque_limit_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as ERR0 錯誤編碼 Bit0.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Note: 6.4 says that ERR0 to ERR3 show 16 states in binary. It does not say whether they carry alarms or
 * faults; alarm 17 does not fit four bits.
 * Source: 5.5 L1222
 */
#define TC100_REG_ERROR_BIT_0_OUTPUT_ADDRESS 0x070Eu
#define TC100_REG_ERROR_BIT_0_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_error_bit_0_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_error_bit_0_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as ERR1 錯誤編碼 Bit1.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1223
 */
#define TC100_REG_ERROR_BIT_1_OUTPUT_ADDRESS 0x070Fu
#define TC100_REG_ERROR_BIT_1_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_error_bit_1_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_error_bit_1_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as ERR2 錯誤編碼 Bit2.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1224
 */
#define TC100_REG_ERROR_BIT_2_OUTPUT_ADDRESS 0x0710u
#define TC100_REG_ERROR_BIT_2_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_error_bit_2_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_error_bit_2_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as ERR3 錯誤編碼 Bit3.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1225
 */
#define TC100_REG_ERROR_BIT_3_OUTPUT_ADDRESS 0x0711u
#define TC100_REG_ERROR_BIT_3_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_error_bit_3_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_error_bit_3_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * On while the position is inside the zone of the point.
 * Printed as INRANGE 區間設定範圍內輸出.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1226
 */
#define TC100_REG_ZONE_OUTPUT_ADDRESS 0x0712u
#define TC100_REG_ZONE_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_zone_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_zone_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * On near the target, see 011DH; the target is that of a point in mode ABS or INC.
 * Printed as NEAR 當移動至目標位置的範圍內時輸出.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1227
 */
#define TC100_REG_NEAR_OUTPUT_ADDRESS 0x0713u
#define TC100_REG_NEAR_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_near_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_near_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * On when the position has reached a soft limit.
 * Printed as SOFTLMT 軟體極限輸出燈號.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1228
 */
#define TC100_REG_SOFT_LIMIT_OUTPUT_ADDRESS 0x0714u
#define TC100_REG_SOFT_LIMIT_OUTPUT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_soft_limit_output_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_soft_limit_output_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The distance of a relative move in position or torque control.
 * Printed as INCamount 相對移動量.
 * Read and write.
 * Note: One count is 0.01 mm or 1 pulse; what decides between them is not printed.
 * Source: 8.2 L1618
 */
#define TC100_REG_RELATIVE_DISTANCE_ADDRESS 0x2000u
#define TC100_REG_RELATIVE_DISTANCE_WORDS 2u
#define TC100_REG_RELATIVE_DISTANCE_DEFAULT 0

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_relative_distance_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_relative_distance_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/**
 * The target of an absolute move in position or torque control.
 * Printed as ABSSamount 絕對移動量.
 * Read and write.
 * Note: One count is 0.01 mm or 1 pulse; what decides between them is not printed.
 * Source: 8.2 L1619
 */
#define TC100_REG_ABSOLUTE_POSITION_ADDRESS 0x2002u
#define TC100_REG_ABSOLUTE_POSITION_WORDS 2u
#define TC100_REG_ABSOLUTE_POSITION_DEFAULT 0

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_absolute_position_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_absolute_position_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/**
 * The direction of the torque search of 201EH.
 * Printed as TrqStopDir 扭力停止搜尋方向.
 * Read and write.
 * Range: 0..1. See torque_search_direction.
 * Note: In points, each direction is a mode of its own.
 * Source: 8.2 L1620
 */
#define TC100_REG_TORQUE_SEARCH_DIRECTION_ADDRESS 0x2005u
#define TC100_REG_TORQUE_SEARCH_DIRECTION_WORDS 1u
#define TC100_REG_TORQUE_SEARCH_DIRECTION_MIN 0u
#define TC100_REG_TORQUE_SEARCH_DIRECTION_MAX 1u

/** Decodes the value from the 2 bytes of its words. */
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

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_torque_search_direction_encode(tc100_torque_search_direction value,
        uint8_t *out)
{
    if (!tc100_torque_search_direction_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * The value that command 4 of 201EH gives to the commanded and the present position.
 * Printed as PosAmount 位置指定資料.
 * Read and write.
 * Note: One count is 0.01 mm or 1 pulse; what decides between them is not printed.
 * Source: 8.2 L1621
 */
#define TC100_REG_PRESET_POSITION_ADDRESS 0x2006u
#define TC100_REG_PRESET_POSITION_WORDS 2u
#define TC100_REG_PRESET_POSITION_DEFAULT 0

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_preset_position_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_preset_position_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/**
 * Switches the servo.
 * Printed as Servo ON/OFF 伺服ON/OFF.
 * Read and write.
 * Range: 0..1. See servo_command.
 * Note: 0 is on and 1 is off. The servo status 100CH says it the other way round.
 * Source: 8.2 L1622
 */
#define TC100_REG_SERVO_ADDRESS 0x2011u
#define TC100_REG_SERVO_WORDS 1u
#define TC100_REG_SERVO_MIN 0u
#define TC100_REG_SERVO_MAX 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_servo_decode(const uint8_t *in, tc100_servo_command *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_servo_command_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_servo_command)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_servo_encode(tc100_servo_command value, uint8_t *out)
{
    if (!tc100_servo_command_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * The speed of relative and absolute moves and of jogging by 201EH, a percentage of the maximum speed 0802H.
 * Printed as MovSpeedSet 位置 / 扭力控制動作速度設定.
 * Read and write.
 * One count is 1 %. Range: 0..100. 0 means start_speed.
 * Source: 8.2 L1623
 */
#define TC100_REG_MOTION_SPEED_ADDRESS 0x2014u
#define TC100_REG_MOTION_SPEED_WORDS 1u
#define TC100_REG_MOTION_SPEED_MIN 0u
#define TC100_REG_MOTION_SPEED_MAX 100u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_motion_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_motion_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Writing a value starts the action that it names.
 * Printed as MovType 移動類型.
 * The manual does not say how it is accessed. Writing starts an action.
 * Range: 0..12. See motion_command.
 * Source: 8.2 L1624
 */
#define TC100_REG_MOTION_COMMAND_ADDRESS 0x201Eu
#define TC100_REG_MOTION_COMMAND_WORDS 1u
#define TC100_REG_MOTION_COMMAND_MIN 0u
#define TC100_REG_MOTION_COMMAND_MAX 12u

/**
 * Decodes the value from the 2 bytes of its words.
 * An integer, as the device may answer what motion_command does not have.
 */
static inline tc100_codec_status tc100_reg_motion_command_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_motion_command_encode(tc100_motion_command value, uint8_t *out)
{
    if (!tc100_motion_command_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * All simulated inputs at once.
 * Printed as 模擬輸入設定(二進制).
 * Read and write.
 * Range: 0..16383. See simulated_input_word.
 * Source: 8.2 L1625
 */
#define TC100_REG_SIMULATED_INPUTS_ADDRESS 0x2040u
#define TC100_REG_SIMULATED_INPUTS_WORDS 1u
#define TC100_REG_SIMULATED_INPUTS_MIN 0u
#define TC100_REG_SIMULATED_INPUTS_MAX 16383u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_simulated_inputs_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_simulated_inputs_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 16383u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * One simulated input; 1 is on. The controller receives this value or the signal at the terminal.
 * Printed as 模擬輸入設定.
 * Read and write.
 * Range: 0..1.
 * Source: 8.2 L1626-1632, 1636-1642
 */
#define TC100_REG_SIMULATED_INPUT_ADDRESS 0x2041u
#define TC100_REG_SIMULATED_INPUT_WORDS 1u
#define TC100_REG_SIMULATED_INPUT_COUNT 14u
#define TC100_REG_SIMULATED_INPUT_STRIDE 1u
#define TC100_REG_SIMULATED_INPUT_FIRST 1u
#define TC100_REG_SIMULATED_INPUT_MIN 0u
#define TC100_REG_SIMULATED_INPUT_MAX 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_simulated_input_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
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
 * Stores the parameters.
 * Printed as 參數儲存.
 * The manual does not say how it is accessed. Writing starts an action.
 * Range: 0..1. See parameter_storage.
 * Note: Which parameters and whether points too are stored is not printed, nor whether 1 stores the default
 * values or brings them back, nor how long it takes, nor what reading gives.
 * Source: 8.2 L1667
 */
#define TC100_REG_PARAMETER_STORAGE_ADDRESS 0x9999u
#define TC100_REG_PARAMETER_STORAGE_WORDS 1u
#define TC100_REG_PARAMETER_STORAGE_MIN 0u
#define TC100_REG_PARAMETER_STORAGE_MAX 1u

/**
 * Decodes the value from the 2 bytes of its words.
 * An integer, as the device may answer what parameter_storage does not have.
 */
static inline tc100_codec_status tc100_reg_parameter_storage_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_parameter_storage_encode(tc100_parameter_storage value, uint8_t *out)
{
    if (!tc100_parameter_storage_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * Writing the four words 4C76 3031 5479 5667 opens writing. As characters they read Lv01TyVg.
 * Printed as 開放寫入指令.
 * Write only. Writing starts an action.
 * Note: What needs it, how long it lasts and whether other keys exist is not printed; a flow chart of writing
 * parameters that followed is not in the text. Fault 11 (parameter write not permitted) asks for a higher
 * write level.
 * Source: 8.2 L1669, 1673-1675
 */
#define TC100_REG_WRITE_ENABLE_KEY_ADDRESS 0x999Bu
#define TC100_REG_WRITE_ENABLE_KEY_WORDS 4u
#define TC100_REG_WRITE_ENABLE_KEY_VALUE UINT64_C(5509644182563149415)

/** Decodes the value from the 8 bytes of its words. */
static inline tc100_codec_status tc100_reg_write_enable_key_decode(const uint8_t *in, uint64_t *out)
{
    *out = tc100_load_u64_be(in);
    return TC100_OK;
}

/** Encodes the value into the 8 bytes of its words. */
static inline tc100_codec_status tc100_reg_write_enable_key_encode(uint8_t *out)
{
    tc100_store_u64_be(out, UINT64_C(5509644182563149415));
    return TC100_OK;
}

/**
 * The full count alarm is raised when the actual position is further than this from the commanded one.
 * Printed as FullCountValue 計數器溢位警報值.
 * Read and write.
 * One count is 1 pulse. Range: 1..100000.
 * Note: 5.1 prints no range; it is taken from the two screens of chapter 9. They show 100 and 200 as values,
 * which depend on the actuator and are no defaults.
 * Source: 5.1 L1160
 */
#define TC100_REG_FULL_COUNT_LIMIT_ADDRESS 0x0108u
#define TC100_REG_FULL_COUNT_LIMIT_WORDS 2u
#define TC100_REG_FULL_COUNT_LIMIT_MIN 1u
#define TC100_REG_FULL_COUNT_LIMIT_MAX 100000u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_full_count_limit_decode(const uint8_t *in, uint32_t *out)
{
    *out = tc100_load_u32_be(in);
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_full_count_limit_encode(uint32_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 100000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u32_be(out, value);
    return TC100_OK;
}

/**
 * The in position signal is on while the actual position is nearer than this to the commanded one.
 * Printed as InPositionZone INPOSITION 信號的到位區間範圍設定.
 * Read and write.
 * One count is 1 pulse. Range: 0..1000.
 * Note: A large value, or a slow motion, can keep the signal on all the time.
 * Source: 5.1 L1161
 */
#define TC100_REG_IN_POSITION_ZONE_ADDRESS 0x010Au
#define TC100_REG_IN_POSITION_ZONE_WORDS 1u
#define TC100_REG_IN_POSITION_ZONE_MIN 0u
#define TC100_REG_IN_POSITION_ZONE_MAX 1000u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_in_position_zone_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_in_position_zone_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * With the denominator: the encoder pulses of one motor revolution after the change are the basic ones divided
 * by (numerator / denominator).
 * Printed as ElectroGearNum 電子齒輪分子.
 * Read and write. A change takes effect after a restart.
 * Range: 1..10000.
 * Note: The vendor's software shows it in pulse control only.
 * Source: 5.1 L1162
 */
#define TC100_REG_ELECTRONIC_GEAR_NUMERATOR_ADDRESS 0x010Bu
#define TC100_REG_ELECTRONIC_GEAR_NUMERATOR_WORDS 1u
#define TC100_REG_ELECTRONIC_GEAR_NUMERATOR_MIN 1u
#define TC100_REG_ELECTRONIC_GEAR_NUMERATOR_MAX 10000u
#define TC100_REG_ELECTRONIC_GEAR_NUMERATOR_DEFAULT 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_electronic_gear_numerator_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_electronic_gear_numerator_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 10000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * See the numerator.
 * Printed as ElectroGearDen 電子齒輪分母.
 * Read and write. A change takes effect after a restart.
 * Range: 1..10000.
 * Source: 5.1 L1163
 */
#define TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_ADDRESS 0x010Cu
#define TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_WORDS 1u
#define TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_MIN 1u
#define TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_MAX 10000u
#define TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_DEFAULT 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_electronic_gear_denominator_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_electronic_gear_denominator_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 10000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The direction in which the motor turns in control by external pulses.
 * Printed as PosDir 外部脈沖指令，旋轉方向指定.
 * Read and write. A change takes effect after a restart.
 * Range: 0..1. See rotation_direction.
 * Source: 5.1 L1164
 */
#define TC100_REG_PULSE_ROTATION_DIRECTION_ADDRESS 0x0114u
#define TC100_REG_PULSE_ROTATION_DIRECTION_WORDS 1u
#define TC100_REG_PULSE_ROTATION_DIRECTION_MIN 0u
#define TC100_REG_PULSE_ROTATION_DIRECTION_MAX 1u

/** Decodes the value from the 2 bytes of its words. */
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

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_pulse_rotation_direction_encode(tc100_rotation_direction value, uint8_t *out)
{
    if (!tc100_rotation_direction_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * The form of the external pulses.
 * Printed as SelComPulse 外部脈衝指令形式.
 * Read and write. A change takes effect after a restart.
 * Range: 0..2. See pulse_input_form.
 * Source: 5.1 L1165
 */
#define TC100_REG_PULSE_INPUT_FORM_ADDRESS 0x0115u
#define TC100_REG_PULSE_INPUT_FORM_WORDS 1u
#define TC100_REG_PULSE_INPUT_FORM_MIN 0u
#define TC100_REG_PULSE_INPUT_FORM_MAX 2u
#define TC100_REG_PULSE_INPUT_FORM_DEFAULT 0u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_pulse_input_form_decode(const uint8_t *in, tc100_pulse_input_form *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_pulse_input_form_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_pulse_input_form)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_pulse_input_form_encode(tc100_pulse_input_form value, uint8_t *out)
{
    if (!tc100_pulse_input_form_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * The near output is on when the target is nearer than this.
 * Printed as NearZone NEAR 信號輸出的區間範圍設定.
 * Read and write.
 * One count is 1 pulse. Range: 0..10000.
 * Source: 5.1 L1166
 */
#define TC100_REG_NEAR_ZONE_ADDRESS 0x011Du
#define TC100_REG_NEAR_ZONE_WORDS 1u
#define TC100_REG_NEAR_ZONE_MIN 0u
#define TC100_REG_NEAR_ZONE_MAX 10000u
#define TC100_REG_NEAR_ZONE_DEFAULT 4u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_near_zone_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_near_zone_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 10000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The torque when pushing in the positive direction. The moves by the homing offsets 0902H and 0908H use it
 * too.
 * Printed as PushTrqRateCw + 方向的推壓，扭力值.
 * Read and write.
 * One count is 0.1 %. Range: 0..1000.
 * Source: 5.2 L1172
 */
#define TC100_REG_PUSH_TORQUE_POSITIVE_ADDRESS 0x0400u
#define TC100_REG_PUSH_TORQUE_POSITIVE_WORDS 1u
#define TC100_REG_PUSH_TORQUE_POSITIVE_MIN 0u
#define TC100_REG_PUSH_TORQUE_POSITIVE_MAX 1000u
#define TC100_REG_PUSH_TORQUE_POSITIVE_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_PUSH_TORQUE_POSITIVE_SCALE_DENOMINATOR INT64_C(10)

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_push_torque_positive_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_push_torque_positive_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The torque when pushing in the negative direction. The moves by the homing offsets 0902H and 0908H use it
 * too.
 * Printed as PushTrqRateCcw - 方向的推壓，扭力值.
 * Read and write.
 * One count is 0.1 %. Range: 0..1000.
 * Source: 5.2 L1173
 */
#define TC100_REG_PUSH_TORQUE_NEGATIVE_ADDRESS 0x0401u
#define TC100_REG_PUSH_TORQUE_NEGATIVE_WORDS 1u
#define TC100_REG_PUSH_TORQUE_NEGATIVE_MIN 0u
#define TC100_REG_PUSH_TORQUE_NEGATIVE_MAX 1000u
#define TC100_REG_PUSH_TORQUE_NEGATIVE_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_PUSH_TORQUE_NEGATIVE_SCALE_DENOMINATOR INT64_C(10)

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_push_torque_negative_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_push_torque_negative_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The time after which the torque limit counts as reached.
 * Printed as TrqLmtTime 扭力極限檢出時間.
 * Read and write. A change takes effect after a restart.
 * One count is 1 ms. Range: 0..10000.
 * Note: Homing has a time of its own, 090AH, with a range of 0 to 1000.
 * Source: 5.2 L1174
 */
#define TC100_REG_TORQUE_LIMIT_TIME_ADDRESS 0x0402u
#define TC100_REG_TORQUE_LIMIT_TIME_WORDS 1u
#define TC100_REG_TORQUE_LIMIT_TIME_MIN 0u
#define TC100_REG_TORQUE_LIMIT_TIME_MAX 10000u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_torque_limit_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_torque_limit_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 10000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The speed of position correction is limited by 0407H.
 * Printed as RtnSpdLmtEnable 選擇有無位置補正速限.
 * Read and write.
 * Range: 0..1.
 * Source: 5.2 L1175
 */
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_ADDRESS 0x0406u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_WORDS 1u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_MIN 0u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_MAX 1u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_DEFAULT 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_position_correction_speed_limit_enabled_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_position_correction_speed_limit_enabled_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/**
 * Printed as RtnMaxSpd 位置補正速限.
 * Read and write.
 * One count is 1 rpm. Range: 10..500.
 * Source: 5.2 L1176
 */
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ADDRESS 0x0407u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_WORDS 1u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_MIN 10u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_MAX 500u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_DEFAULT 10u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_position_correction_speed_limit_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_position_correction_speed_limit_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 10u && value <= 500u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The greatest torque in position mode.
 * Printed as MaxTrqRate 位置模式時最大輸出扭力設定.
 * Read and write.
 * One count is 0.1 %. Range: 0..650.
 * Note: The torque limit of a point goes to 1000 (100.0% of the rated current), this one to 650; the manual
 * does not relate the two.
 * Source: 5.3 L1182
 */
#define TC100_REG_MAXIMUM_TORQUE_ADDRESS 0x0500u
#define TC100_REG_MAXIMUM_TORQUE_WORDS 1u
#define TC100_REG_MAXIMUM_TORQUE_MIN 0u
#define TC100_REG_MAXIMUM_TORQUE_MAX 650u
#define TC100_REG_MAXIMUM_TORQUE_DEFAULT 650u
#define TC100_REG_MAXIMUM_TORQUE_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_MAXIMUM_TORQUE_SCALE_DENOMINATOR INT64_C(10)

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_maximum_torque_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_maximum_torque_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 650u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The time at full torque in position mode after which an error is detected.
 * Printed as FullTrqTime 位置模式時檢測完全扭力錯誤時間.
 * Read and write.
 * One count is 1 ms. Range: 500..10000.
 * Source: 5.3 L1183
 */
#define TC100_REG_FULL_TORQUE_TIME_ADDRESS 0x0501u
#define TC100_REG_FULL_TORQUE_TIME_WORDS 1u
#define TC100_REG_FULL_TORQUE_TIME_MIN 500u
#define TC100_REG_FULL_TORQUE_TIME_MAX 10000u
#define TC100_REG_FULL_TORQUE_TIME_DEFAULT 1000u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_full_torque_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_full_torque_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 500u && value <= 10000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Position mode or torque mode in control by external pulses.
 * Printed as ModeSwitch Pulse 控制下切換模式開關.
 * Read and write.
 * Range: 0..1. See control_mode.
 * Note: 5.3 calls 1 torque mode; 3.8 and 6.3 say that 1 lets the input signal CONT_MODE choose between the
 * modes. Chapter 5 has no parameter that assigns CONT_MODE to an input.
 * Source: 5.3 L1184
 */
#define TC100_REG_CONTROL_MODE_ADDRESS 0x0503u
#define TC100_REG_CONTROL_MODE_WORDS 1u
#define TC100_REG_CONTROL_MODE_MIN 0u
#define TC100_REG_CONTROL_MODE_MAX 1u
#define TC100_REG_CONTROL_MODE_DEFAULT 0u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_control_mode_decode(const uint8_t *in, tc100_control_mode *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_control_mode_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_control_mode)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_control_mode_encode(tc100_control_mode value, uint8_t *out)
{
    if (!tc100_control_mode_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * Whether the servo is on after power-on.
 * Printed as ServoState 電源投入後・伺服狀態設定.
 * Read and write.
 * Range: 0..1. See servo_command.
 * Note: 0 is on, as in 2011H and against 100CH, where 1 is on.
 * Source: 5.3 L1185
 */
#define TC100_REG_SERVO_AT_POWER_ON_ADDRESS 0x0515u
#define TC100_REG_SERVO_AT_POWER_ON_WORDS 1u
#define TC100_REG_SERVO_AT_POWER_ON_MIN 0u
#define TC100_REG_SERVO_AT_POWER_ON_MAX 1u
#define TC100_REG_SERVO_AT_POWER_ON_DEFAULT 0u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_servo_at_power_on_decode(const uint8_t *in, tc100_servo_command *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_servo_command_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_servo_command)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_servo_at_power_on_encode(tc100_servo_command value, uint8_t *out)
{
    if (!tc100_servo_command_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * No motion is possible before homing is done.
 * Printed as OrgRetRestrict 原點復歸未完成的動作限制.
 * Read and write.
 * Range: 0..1.
 * Source: 5.3 L1186
 */
#define TC100_REG_HOMING_REQUIRED_ADDRESS 0x051Bu
#define TC100_REG_HOMING_REQUIRED_WORDS 1u
#define TC100_REG_HOMING_REQUIRED_MIN 0u
#define TC100_REG_HOMING_REQUIRED_MAX 1u
#define TC100_REG_HOMING_REQUIRED_DEFAULT 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_required_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_required_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/**
 * The revolutions of the motor are accumulated.
 * Printed as UseTotalRev 指定馬達累積計算迴轉數的功能開關.
 * Read and write. A change takes effect after a restart.
 * Range: 0..1.
 * Note: The vendor's software shows the total (9.3); 8.2 prints no register for it.
 * Source: 5.3 L1187
 */
#define TC100_REG_TOTAL_REVOLUTIONS_ENABLED_ADDRESS 0x051Eu
#define TC100_REG_TOTAL_REVOLUTIONS_ENABLED_WORDS 1u
#define TC100_REG_TOTAL_REVOLUTIONS_ENABLED_MIN 0u
#define TC100_REG_TOTAL_REVOLUTIONS_ENABLED_MAX 1u
#define TC100_REG_TOTAL_REVOLUTIONS_ENABLED_DEFAULT 0u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_total_revolutions_enabled_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_total_revolutions_enabled_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/**
 * The speed that a speed setting of 0% stands for, whatever 0802H holds.
 * Printed as LowSpeed 啟動速度設定.
 * Read and write.
 * One count is 1 pps.
 * Source: 5.6 L1234
 */
#define TC100_REG_START_SPEED_ADDRESS 0x0800u
#define TC100_REG_START_SPEED_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_start_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = tc100_load_u32_be(in);
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_start_speed_encode(uint32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, value);
    return TC100_OK;
}

/**
 * The speed of which speed settings are a percentage: revolutions per minute / 60 * pulses of the encoder per
 * revolution.
 * Printed as HighSpeed 運轉時最高速設定.
 * Read and write.
 * One count is 1 pps.
 * Source: 5.6 L1235
 */
#define TC100_REG_MAXIMUM_SPEED_ADDRESS 0x0802u
#define TC100_REG_MAXIMUM_SPEED_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_maximum_speed_decode(const uint8_t *in, uint32_t *out)
{
    *out = tc100_load_u32_be(in);
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_maximum_speed_encode(uint32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, value);
    return TC100_OK;
}

/**
 * Printed as AccelTim 加速時間設定.
 * Read and write.
 * One count is 1 ms. Range: 1..30000.
 * Source: 5.6 L1236
 */
#define TC100_REG_ACCELERATION_TIME_ADDRESS 0x0804u
#define TC100_REG_ACCELERATION_TIME_WORDS 1u
#define TC100_REG_ACCELERATION_TIME_MIN 1u
#define TC100_REG_ACCELERATION_TIME_MAX 30000u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_acceleration_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_acceleration_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 30000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as DecelTime 減速時間設定.
 * Read and write.
 * One count is 1 ms. Range: 1..30000.
 * Source: 5.6 L1237
 */
#define TC100_REG_DECELERATION_TIME_ADDRESS 0x0805u
#define TC100_REG_DECELERATION_TIME_WORDS 1u
#define TC100_REG_DECELERATION_TIME_MIN 1u
#define TC100_REG_DECELERATION_TIME_MAX 30000u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_deceleration_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_deceleration_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 30000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * How far a torque search goes on after it has reached the torque limit.
 * Printed as TrqLimitPress 扭力公差設定.
 * Read and write.
 * One count is 1 pulse.
 * Source: 5.6 L1238
 */
#define TC100_REG_TORQUE_LIMIT_PRESS_DISTANCE_ADDRESS 0x0807u
#define TC100_REG_TORQUE_LIMIT_PRESS_DISTANCE_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_torque_limit_press_distance_decode(const uint8_t *in, uint32_t *out)
{
    *out = tc100_load_u32_be(in);
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_torque_limit_press_distance_encode(uint32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, value);
    return TC100_OK;
}

/**
 * When the moving state ends.
 * Printed as MoveSttSet 移動中的狀態設定.
 * Read and write.
 * Range: 0..1. See moving_state_rule.
 * Source: 5.6 L1242
 */
#define TC100_REG_MOVING_STATE_RULE_ADDRESS 0x080Au
#define TC100_REG_MOVING_STATE_RULE_WORDS 1u
#define TC100_REG_MOVING_STATE_RULE_MIN 0u
#define TC100_REG_MOVING_STATE_RULE_MAX 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_moving_state_rule_decode(const uint8_t *in, tc100_moving_state_rule *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_moving_state_rule_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_moving_state_rule)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_moving_state_rule_encode(tc100_moving_state_rule value, uint8_t *out)
{
    if (!tc100_moving_state_rule_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * The speed of jogging by the inputs.
 * Printed as JogInchingSpd JOG 移動時速度設定.
 * Read and write.
 * One count is 0.1 %. Range: 1..1000.
 * Note: In tenths of a percent; all other speeds that are given in percent are whole percents. Jogging by
 * 201EH uses 2014H.
 * Source: 5.6 L1243
 */
#define TC100_REG_JOG_SPEED_ADDRESS 0x080Fu
#define TC100_REG_JOG_SPEED_WORDS 1u
#define TC100_REG_JOG_SPEED_MIN 1u
#define TC100_REG_JOG_SPEED_MAX 1000u
#define TC100_REG_JOG_SPEED_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_JOG_SPEED_SCALE_DENOMINATOR INT64_C(10)

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_jog_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_jog_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The distance of one jog by the inputs.
 * Printed as JogInchingData JOG 移動時的移動量設定.
 * Read and write.
 * One count is 1 pulse.
 * Source: 5.6 L1244
 */
#define TC100_REG_JOG_DISTANCE_ADDRESS 0x0810u
#define TC100_REG_JOG_DISTANCE_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_jog_distance_decode(const uint8_t *in, uint32_t *out)
{
    *out = tc100_load_u32_be(in);
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_jog_distance_encode(uint32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, value);
    return TC100_OK;
}

/**
 * The wait after a jog by the inputs.
 * Printed as JogInchingWait JOG 移動後的等待時間設定.
 * Read and write.
 * One count is 1 ms. Range: 0..1000.
 * Source: 5.6 L1245
 */
#define TC100_REG_JOG_WAIT_TIME_ADDRESS 0x0812u
#define TC100_REG_JOG_WAIT_TIME_WORDS 1u
#define TC100_REG_JOG_WAIT_TIME_MIN 0u
#define TC100_REG_JOG_WAIT_TIME_MAX 1000u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_jog_wait_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_jog_wait_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The soft limit in the positive direction.
 * Printed as PlusSoftLimit + 方向的軟體極限.
 * Read and write.
 * 0 means no_limit.
 * Note: The description says mm, and not how many mm one count is.
 * Source: 5.6 L1246
 */
#define TC100_REG_SOFT_LIMIT_POSITIVE_ADDRESS 0x0813u
#define TC100_REG_SOFT_LIMIT_POSITIVE_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_soft_limit_positive_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_soft_limit_positive_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/**
 * The soft limit in the negative direction.
 * Printed as MinusSoftLimit - 方向的軟體極限.
 * Read and write.
 * 0 means no_limit.
 * Note: The description says mm, and not how many mm one count is.
 * Source: 5.6 L1247
 */
#define TC100_REG_SOFT_LIMIT_NEGATIVE_ADDRESS 0x0815u
#define TC100_REG_SOFT_LIMIT_NEGATIVE_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_soft_limit_negative_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_soft_limit_negative_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/**
 * How and in which direction the home position is searched.
 * Printed as OrgMode 原點復歸方向.
 * Read and write.
 * Range: 0..7. See homing_mode.
 * Source: 5.7 L1253
 */
#define TC100_REG_HOMING_MODE_ADDRESS 0x0900u
#define TC100_REG_HOMING_MODE_WORDS 1u
#define TC100_REG_HOMING_MODE_MIN 0u
#define TC100_REG_HOMING_MODE_MAX 7u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_mode_decode(const uint8_t *in, tc100_homing_mode *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_homing_mode_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_homing_mode)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_mode_encode(tc100_homing_mode value, uint8_t *out)
{
    if (!tc100_homing_mode_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * A percentage of the maximum speed 0802H. For homing by torque, 20 or less is advised.
 * Printed as OrgSpeed 原點復歸速度.
 * Read and write.
 * One count is 1 %. Range: 0..100. 0 means start_speed.
 * Source: 5.7 L1254
 */
#define TC100_REG_HOMING_SPEED_ADDRESS 0x0901u
#define TC100_REG_HOMING_SPEED_WORDS 1u
#define TC100_REG_HOMING_SPEED_MIN 0u
#define TC100_REG_HOMING_SPEED_MAX 100u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The distance that is moved after homing is done. The push torques 0400H and 0401H apply.
 * Printed as OrgOffset 原點復歸的偏移量設定.
 * Read and write.
 * One count is 1 pulse.
 * Note: This row places the move after homing; 0904H places it after the detection of torque, in the other
 * direction, and for homing by torque only.
 * Source: 5.7 L1255
 */
#define TC100_REG_HOMING_OFFSET_ADDRESS 0x0902u
#define TC100_REG_HOMING_OFFSET_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_offset_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_offset_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/**
 * The speed of the move by the offset, back from where the torque was detected; a percentage of the maximum
 * speed 0802H.
 * Printed as OrgOffsetSpeed 原點復歸偏移量 移動速度.
 * Read and write.
 * One count is 1 %. Range: 0..100. 0 means start_speed.
 * Source: 5.7 L1259
 */
#define TC100_REG_HOMING_OFFSET_SPEED_ADDRESS 0x0904u
#define TC100_REG_HOMING_OFFSET_SPEED_WORDS 1u
#define TC100_REG_HOMING_OFFSET_SPEED_MIN 0u
#define TC100_REG_HOMING_OFFSET_SPEED_MAX 100u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_offset_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_offset_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The value that the position takes when homing is done.
 * Printed as OrgData 原點復歸的數據.
 * Read and write.
 * Note: The description says mm, and not how many mm one count is.
 * Source: 5.7 L1260
 */
#define TC100_REG_HOMING_POSITION_ADDRESS 0x0905u
#define TC100_REG_HOMING_POSITION_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_position_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_position_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/**
 * The torque that counts as having met the hard stop.
 * Printed as OrgTrqLimit 原點復歸時的扭力設定.
 * Read and write.
 * One count is 0.1 %. Range: 0..1000.
 * Source: 5.7 L1261
 */
#define TC100_REG_HOMING_TORQUE_LIMIT_ADDRESS 0x0907u
#define TC100_REG_HOMING_TORQUE_LIMIT_WORDS 1u
#define TC100_REG_HOMING_TORQUE_LIMIT_MIN 0u
#define TC100_REG_HOMING_TORQUE_LIMIT_MAX 1000u
#define TC100_REG_HOMING_TORQUE_LIMIT_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_HOMING_TORQUE_LIMIT_SCALE_DENOMINATOR INT64_C(10)

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_torque_limit_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_torque_limit_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The distance that is moved from the hard stop before the Z phase is searched. The push torques 0400H and
 * 0401H apply.
 * Printed as OrgOffset_Z 檢出 Z 相前，偏移量.
 * Read and write.
 * One count is 1 pulse.
 * Source: 5.7 L1262
 */
#define TC100_REG_HOMING_Z_PHASE_OFFSET_ADDRESS 0x0908u
#define TC100_REG_HOMING_Z_PHASE_OFFSET_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_z_phase_offset_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_z_phase_offset_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/**
 * How long the torque must last in homing by torque.
 * Printed as OrgTrqLmtTime 原點復歸時的扭力檢測時間.
 * Read and write.
 * One count is 1 ms. Range: 0..1000.
 * Source: 5.7 L1263
 */
#define TC100_REG_HOMING_TORQUE_LIMIT_TIME_ADDRESS 0x090Au
#define TC100_REG_HOMING_TORQUE_LIMIT_TIME_WORDS 1u
#define TC100_REG_HOMING_TORQUE_LIMIT_TIME_MIN 0u
#define TC100_REG_HOMING_TORQUE_LIMIT_TIME_MAX 1000u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_torque_limit_time_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_torque_limit_time_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1000u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The speed of the first search of the Z phase, a percentage of the maximum speed 0802H.
 * Printed as OrgSpeed_Z1 Z 相檢出速度 _1.
 * Read and write.
 * One count is 1 %. Range: 1..100.
 * Source: 5.7 L1264
 */
#define TC100_REG_HOMING_Z_PHASE_SPEED_1_ADDRESS 0x090Bu
#define TC100_REG_HOMING_Z_PHASE_SPEED_1_WORDS 1u
#define TC100_REG_HOMING_Z_PHASE_SPEED_1_MIN 1u
#define TC100_REG_HOMING_Z_PHASE_SPEED_1_MAX 100u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_z_phase_speed_1_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_z_phase_speed_1_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The speed of the second search of the Z phase, in the other direction.
 * Printed as OrgSpeed_Z2 Z 相檢出速度 _2.
 * Read and write.
 * One count is 1 %. Range: 1..100.
 * Source: 5.7 L1265
 */
#define TC100_REG_HOMING_Z_PHASE_SPEED_2_ADDRESS 0x090Cu
#define TC100_REG_HOMING_Z_PHASE_SPEED_2_WORDS 1u
#define TC100_REG_HOMING_Z_PHASE_SPEED_2_MIN 1u
#define TC100_REG_HOMING_Z_PHASE_SPEED_2_MAX 100u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_z_phase_speed_2_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_homing_z_phase_speed_2_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 100u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as BaudRate 通信速率.
 * Read and write. A change takes effect after a restart.
 * Range: 0..4. See baud_rate.
 * Source: 5.8 L1271
 */
#define TC100_REG_BAUD_RATE_ADDRESS 0x0A00u
#define TC100_REG_BAUD_RATE_WORDS 1u
#define TC100_REG_BAUD_RATE_MIN 0u
#define TC100_REG_BAUD_RATE_MAX 4u
#define TC100_REG_BAUD_RATE_DEFAULT 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_baud_rate_decode(const uint8_t *in, tc100_baud_rate *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_baud_rate_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_baud_rate)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_baud_rate_encode(tc100_baud_rate value, uint8_t *out)
{
    if (!tc100_baud_rate_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * Printed as DataSize 字串數據 Bit 設定.
 * Read and write. A change takes effect after a restart.
 * Range: 0..1. See data_bits.
 * Note: RTU needs 8 bits (8.1).
 * Source: 5.8 L1272
 */
#define TC100_REG_DATA_BITS_ADDRESS 0x0A01u
#define TC100_REG_DATA_BITS_WORDS 1u
#define TC100_REG_DATA_BITS_MIN 0u
#define TC100_REG_DATA_BITS_MAX 1u
#define TC100_REG_DATA_BITS_DEFAULT 0u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_data_bits_decode(const uint8_t *in, tc100_data_bits *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_data_bits_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_data_bits)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_data_bits_encode(tc100_data_bits value, uint8_t *out)
{
    if (!tc100_data_bits_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * Printed as Parity 奇偶校驗.
 * Read and write. A change takes effect after a restart.
 * Range: 0..2. See parity.
 * Source: 5.8 L1273
 */
#define TC100_REG_PARITY_ADDRESS 0x0A02u
#define TC100_REG_PARITY_WORDS 1u
#define TC100_REG_PARITY_MIN 0u
#define TC100_REG_PARITY_MAX 2u
#define TC100_REG_PARITY_DEFAULT 0u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_parity_decode(const uint8_t *in, tc100_parity *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_parity_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_parity)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_parity_encode(tc100_parity value, uint8_t *out)
{
    if (!tc100_parity_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * Messages to the broadcast station 0 are obeyed; otherwise they are ignored.
 * Printed as Broadcast 擴播設定.
 * Read and write.
 * Range: 0..1.
 * Source: 5.8 L1274
 */
#define TC100_REG_BROADCAST_ENABLED_ADDRESS 0x0A03u
#define TC100_REG_BROADCAST_ENABLED_WORDS 1u
#define TC100_REG_BROADCAST_ENABLED_MIN 0u
#define TC100_REG_BROADCAST_ENABLED_MAX 1u
#define TC100_REG_BROADCAST_ENABLED_DEFAULT 0u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_broadcast_enabled_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_broadcast_enabled_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/**
 * The Modbus mode of RS485.
 * Printed as Protocol 通訊協議.
 * Read and write. A change takes effect after a restart.
 * Range: 0..1. See protocol.
 * Note: The vendor's software needs ASCII (8.1).
 * Source: 5.8 L1275
 */
#define TC100_REG_PROTOCOL_ADDRESS 0x0A04u
#define TC100_REG_PROTOCOL_WORDS 1u
#define TC100_REG_PROTOCOL_MIN 0u
#define TC100_REG_PROTOCOL_MAX 1u
#define TC100_REG_PROTOCOL_DEFAULT 0u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_protocol_decode(const uint8_t *in, tc100_protocol *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_protocol_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_protocol)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_protocol_encode(tc100_protocol value, uint8_t *out)
{
    if (!tc100_protocol_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * Printed as ActionStatus 動作狀態.
 * Read only.
 * Range: 0..2. See action_status.
 * Source: 8.2 L1506
 */
#define TC100_REG_ACTION_STATUS_ADDRESS 0x1000u
#define TC100_REG_ACTION_STATUS_WORDS 1u
#define TC100_REG_ACTION_STATUS_MIN 0u
#define TC100_REG_ACTION_STATUS_MAX 2u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_action_status_decode(const uint8_t *in, tc100_action_status *out)
{
    const uint16_t number = tc100_load_u16_be(in);
    if (!tc100_action_status_known((int64_t)number)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    *out = (tc100_action_status)number;
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_action_status_encode(tc100_action_status value, uint8_t *out)
{
    if (!tc100_action_status_known((int64_t)value)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * The position is within the zone around the target, see 010AH.
 * Printed as InpStatus 到位訊號目前的狀態.
 * Read only.
 * Range: 0..1.
 * Source: 8.2 L1507
 */
#define TC100_REG_IN_POSITION_ADDRESS 0x1001u
#define TC100_REG_IN_POSITION_WORDS 1u
#define TC100_REG_IN_POSITION_MIN 0u
#define TC100_REG_IN_POSITION_MAX 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_in_position_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_in_position_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/**
 * The torque has reached its limit.
 * Printed as TrqLmtStatus 力矩極限狀態.
 * Read only.
 * Source: 8.2 L1508
 */
#define TC100_REG_TORQUE_LIMIT_REACHED_ADDRESS 0x1004u
#define TC100_REG_TORQUE_LIMIT_REACHED_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_torque_limit_reached_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_torque_limit_reached_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/**
 * The present alarm.
 * Printed as AlarmStatus 警報狀態.
 * Read only.
 * See alarm_code.
 * Source: 8.2 L1509
 */
#define TC100_REG_ALARM_ADDRESS 0x1005u
#define TC100_REG_ALARM_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_alarm_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_alarm_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * Printed as MonSpeed 馬達轉速.
 * Read only.
 * One count is 1 rpm.
 * Source: 8.2 L1510
 */
#define TC100_REG_MOTOR_SPEED_ADDRESS 0x1006u
#define TC100_REG_MOTOR_SPEED_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_motor_speed_decode(const uint8_t *in, int16_t *out)
{
    *out = tc100_signed_16(tc100_load_u16_be(in));
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_motor_speed_encode(int16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * Printed as MonCurrent 馬達電流值.
 * Read only.
 * One count is 0.1 %.
 * Source: 8.2 L1511
 */
#define TC100_REG_MOTOR_CURRENT_ADDRESS 0x1007u
#define TC100_REG_MOTOR_CURRENT_WORDS 1u
#define TC100_REG_MOTOR_CURRENT_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_MOTOR_CURRENT_SCALE_DENOMINATOR INT64_C(10)

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_motor_current_decode(const uint8_t *in, int16_t *out)
{
    *out = tc100_signed_16(tc100_load_u16_be(in));
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_motor_current_encode(int16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * Where the position command stands.
 * Printed as CmdNowPos 指令現在位置.
 * Read only.
 * Note: In control by external pulses it is not cleared after homing (3.9).
 * Source: 8.2 L1512
 */
#define TC100_REG_COMMAND_POSITION_ADDRESS 0x1008u
#define TC100_REG_COMMAND_POSITION_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_command_position_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_command_position_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/**
 * Where the encoder says that the motor is.
 * Printed as EcdPos 編碼器位置.
 * Read only.
 * Note: In control by external pulses it is not cleared after homing (3.9).
 * Source: 8.2 L1513
 */
#define TC100_REG_ENCODER_POSITION_ADDRESS 0x100Au
#define TC100_REG_ENCODER_POSITION_WORDS 2u

/** Decodes the value from the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_encoder_position_decode(const uint8_t *in, int32_t *out)
{
    *out = tc100_signed_32(tc100_load_u32_be(in));
    return TC100_OK;
}

/** Encodes the value into the 4 bytes of its words. */
static inline tc100_codec_status tc100_reg_encoder_position_encode(int32_t value, uint8_t *out)
{
    tc100_store_u32_be(out, (uint32_t)value);
    return TC100_OK;
}

/**
 * Printed as ServoStatus 伺服狀態.
 * Read only.
 * Range: 0..1.
 * Note: 1 is on. In the command 2011H and in the parameter 0515H 1 is off.
 * Source: 8.2 L1514
 */
#define TC100_REG_SERVO_ON_ADDRESS 0x100Cu
#define TC100_REG_SERVO_ON_WORDS 1u
#define TC100_REG_SERVO_ON_MIN 0u
#define TC100_REG_SERVO_ON_MAX 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_servo_on_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_servo_on_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/**
 * The present fault.
 * Printed as ErrorStatus 故障狀態.
 * Read only.
 * See fault_code.
 * Source: 8.2 L1515
 */
#define TC100_REG_FAULT_ADDRESS 0x100Du
#define TC100_REG_FAULT_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_fault_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_fault_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * The number of the point that was executed last.
 * Printed as StepNo 程序選擇號碼.
 * Read only.
 * Range: -1..127. -1 means none.
 * Note: The printed range holds 0; points are numbered from 1.
 * Source: 8.2 L1516
 */
#define TC100_REG_EXECUTED_POINT_ADDRESS 0x100Eu
#define TC100_REG_EXECUTED_POINT_WORDS 1u
#define TC100_REG_EXECUTED_POINT_MIN (-1)
#define TC100_REG_EXECUTED_POINT_MAX 127

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_executed_point_decode(const uint8_t *in, int16_t *out)
{
    *out = tc100_signed_16(tc100_load_u16_be(in));
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_executed_point_encode(int16_t value, uint8_t *out)
{
    if (!(value >= (-1) && value <= 127)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, (uint16_t)value);
    return TC100_OK;
}

/**
 * All outputs at once.
 * Printed as PORT (OUT1~10) 整體輸出狀態.
 * Read only.
 * Range: 0..1023. See output_word.
 * Source: 8.2 L1517
 */
#define TC100_REG_OUTPUT_STATES_ADDRESS 0x1020u
#define TC100_REG_OUTPUT_STATES_WORDS 1u
#define TC100_REG_OUTPUT_STATES_MIN 0u
#define TC100_REG_OUTPUT_STATES_MAX 1023u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_output_states_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_output_states_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 1023u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * One output; 1 is on.
 * Printed as 單獨輸出狀態.
 * Read only.
 * Range: 0..1.
 * Source: 8.2 L1518-1519, 1523-1530
 */
#define TC100_REG_OUTPUT_STATE_ADDRESS 0x1021u
#define TC100_REG_OUTPUT_STATE_WORDS 1u
#define TC100_REG_OUTPUT_STATE_COUNT 10u
#define TC100_REG_OUTPUT_STATE_STRIDE 1u
#define TC100_REG_OUTPUT_STATE_FIRST 1u
#define TC100_REG_OUTPUT_STATE_MIN 0u
#define TC100_REG_OUTPUT_STATE_MAX 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_output_state_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
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

/**
 * All inputs at once.
 * Printed as PORT (IN1~IN14、Z相) 整體輸入狀態.
 * Read only.
 * Range: 0..32767. See input_word.
 * Source: 8.2 L1531
 */
#define TC100_REG_INPUT_STATES_ADDRESS 0x1040u
#define TC100_REG_INPUT_STATES_WORDS 1u
#define TC100_REG_INPUT_STATES_MIN 0u
#define TC100_REG_INPUT_STATES_MAX 32767u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_input_states_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_input_states_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 32767u)) {
        return TC100_ERR_OUT_OF_RANGE;
    }
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/**
 * One input; 1 is on.
 * Printed as 單獨輸入狀態.
 * Read only.
 * Range: 0..1.
 * Source: 8.2 L1532-1545
 */
#define TC100_REG_INPUT_STATE_ADDRESS 0x1041u
#define TC100_REG_INPUT_STATE_WORDS 1u
#define TC100_REG_INPUT_STATE_COUNT 14u
#define TC100_REG_INPUT_STATE_STRIDE 1u
#define TC100_REG_INPUT_STATE_FIRST 1u
#define TC100_REG_INPUT_STATE_MIN 0u
#define TC100_REG_INPUT_STATE_MAX 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_input_state_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
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

/**
 * The Z phase of the encoder; 1 is on.
 * Printed as Z 相輸入狀態 Z 相輸入狀態.
 * Read only.
 * Range: 0..1.
 * Source: 8.2 L1546
 */
#define TC100_REG_Z_PHASE_STATE_ADDRESS 0x104Fu
#define TC100_REG_Z_PHASE_STATE_WORDS 1u
#define TC100_REG_Z_PHASE_STATE_MIN 0u
#define TC100_REG_Z_PHASE_STATE_MAX 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_z_phase_state_decode(const uint8_t *in, bool *out)
{
    *out = tc100_load_u16_be(in) != 0;
    if (tc100_load_u16_be(in) > 1u) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_z_phase_state_encode(bool value, uint8_t *out)
{
    tc100_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return TC100_OK;
}

/**
 * The stored alarms.
 * Printed as 50 筆錯誤履歷.
 * Read only.
 * See alarm_code.
 * Note: Whether the first entry is the newest or the oldest one is not printed, nor what an empty entry holds.
 * Source: 8.2 L1552-1574, 1578-1604
 */
#define TC100_REG_ALARM_HISTORY_ADDRESS 0x1060u
#define TC100_REG_ALARM_HISTORY_WORDS 1u
#define TC100_REG_ALARM_HISTORY_COUNT 50u
#define TC100_REG_ALARM_HISTORY_STRIDE 1u
#define TC100_REG_ALARM_HISTORY_FIRST 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_alarm_history_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
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

/**
 * The type of the motor, up to 31 letters and digits.
 * Printed as MotorType 馬達型號.
 * Read only.
 * Note: How a shorter text is ended or filled is not printed.
 * Source: 8.2 L1610
 */
#define TC100_REG_MOTOR_TYPE_ADDRESS 0x10D0u
#define TC100_REG_MOTOR_TYPE_WORDS 16u

/** Decodes the value from the 32 bytes of its words. */
static inline tc100_codec_status tc100_reg_motor_type_decode(const uint8_t *in, char out[33])
{
    TC100_COPY(out, in, 32u);
    out[32] = '\0';
    if (!tc100_is_ascii(in, 32u)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 32 bytes of its words. */
static inline tc100_codec_status tc100_reg_motor_type_encode(const char value[33], uint8_t *out)
{
    if (!tc100_is_text(value, 32u)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_put_text(out, value, 32u);
    return TC100_OK;
}

/**
 * The type of the controller, TC-100.
 * Printed as Controller 控制器型號.
 * Read only.
 * Note: The manual's cover and 1.2 write the name without a hyphen. How the text is ended or filled is not
 * printed.
 * Source: 8.2 L1611
 */
#define TC100_REG_CONTROLLER_TYPE_ADDRESS 0x10E0u
#define TC100_REG_CONTROLLER_TYPE_WORDS 16u

/** Decodes the value from the 32 bytes of its words. */
static inline tc100_codec_status tc100_reg_controller_type_decode(const uint8_t *in, char out[33])
{
    TC100_COPY(out, in, 32u);
    out[32] = '\0';
    if (!tc100_is_ascii(in, 32u)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    return TC100_OK;
}

/** Encodes the value into the 32 bytes of its words. */
static inline tc100_codec_status tc100_reg_controller_type_encode(const char value[33], uint8_t *out)
{
    if (!tc100_is_text(value, 32u)) {
        return TC100_ERR_UNKNOWN_VALUE;
    }
    tc100_put_text(out, value, 32u);
    return TC100_OK;
}

/**
 * The firmware version; 100 stands for 1.00.
 * Printed as FirmwareNo Firmware 版本.
 * Read only.
 * Note: The remark calls the form HEX-ASCII. Whether 1.00 is the word 0100H, or the number 100 (0064H), is not
 * decided by the print. The title bar of the vendor's software shows 02.21 (9.3).
 * Source: 8.2 L1612
 */
#define TC100_REG_FIRMWARE_VERSION_ADDRESS 0x10F0u
#define TC100_REG_FIRMWARE_VERSION_WORDS 1u

/** Decodes the value from the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_firmware_version_decode(const uint8_t *in, uint16_t *out)
{
    *out = tc100_load_u16_be(in);
    return TC100_OK;
}

/** Encodes the value into the 2 bytes of its words. */
static inline tc100_codec_status tc100_reg_firmware_version_encode(uint16_t value, uint8_t *out)
{
    tc100_store_u16_be(out, value);
    return TC100_OK;
}

/* ---- Record tables ---- */

/**
 * The points P1 to P127. The table prints the first one whole and the addresses of the second one; the others
 * follow at the same distance.
 * Printed as 步序指令說明.
 * Its elements are tc100_point.
 * Note: Two words between one point and the next, 901EH and 901FH for the first one, are not described.
 * Source: 8.2 L1644-1659
 */
#define TC100_TABLE_POINTS_ADDRESS 0x9010u
#define TC100_TABLE_POINTS_WORDS 14u
#define TC100_TABLE_POINTS_STRIDE 16u
#define TC100_TABLE_POINTS_COUNT 127u
#define TC100_TABLE_POINTS_FIRST 1u

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
        return TC100_ERR_WRONG_CHECK;
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
        return TC100_ERR_WRONG_CHECK;
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
static inline tc100_codec_status tc100_rtu_encode_error(uint8_t unit_address, uint32_t code, const tc100_exception *in,
        uint8_t *out, size_t capacity, size_t *length)
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
        return TC100_ERR_WRONG_CHECK;
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
        return TC100_ERR_WRONG_CHECK;
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
static inline tc100_codec_status tc100_ascii_encode_error(uint8_t unit_address, uint32_t code,
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

#define TC100_POINT_SPEED_ABSENT_START_SPEED 0u /**< point.speed: start_speed. The start speed 0800H. */
/** Whether point.speed is no quantity: start_speed. */
static inline bool tc100_point_speed_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_POINT_NEXT_POINT_ABSENT_END (-1) /**< point.next_point: end. The program ends. */
/** Whether point.next_point is no quantity: end. */
static inline bool tc100_point_next_point_is_absent(int16_t value)
{
    return value == (-1);
}

#define TC100_REG_JOG_POSITIVE_INPUT_ABSENT_NOT_USED 0u /**< jog_positive_input: not_used. The function has no terminal. */
/** Whether jog_positive_input is no quantity: not_used. */
static inline bool tc100_reg_jog_positive_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_JOG_NEGATIVE_INPUT_ABSENT_NOT_USED 0u /**< jog_negative_input: not_used. The function has no terminal. */
/** Whether jog_negative_input is no quantity: not_used. */
static inline bool tc100_reg_jog_negative_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_MANUAL_MODE_INPUT_ABSENT_NOT_USED 0u /**< manual_mode_input: not_used. The function has no terminal. */
/** Whether manual_mode_input is no quantity: not_used. */
static inline bool tc100_reg_manual_mode_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_TEACH_INPUT_ABSENT_NOT_USED 0u /**< teach_input: not_used. The function has no terminal. */
/** Whether teach_input is no quantity: not_used. */
static inline bool tc100_reg_teach_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_LOCK_INPUT_ABSENT_NOT_USED 0u /**< lock_input: not_used. The function has no terminal. */
/** Whether lock_input is no quantity: not_used. */
static inline bool tc100_reg_lock_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_POINT_SELECT_BIT_4_INPUT_ABSENT_NOT_USED 0u /**< point_select_bit_4_input: not_used. The function has no terminal. */
/** Whether point_select_bit_4_input is no quantity: not_used. */
static inline bool tc100_reg_point_select_bit_4_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_POINT_SELECT_BIT_5_INPUT_ABSENT_NOT_USED 0u /**< point_select_bit_5_input: not_used. The function has no terminal. */
/** Whether point_select_bit_5_input is no quantity: not_used. */
static inline bool tc100_reg_point_select_bit_5_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_POINT_SELECT_BIT_6_INPUT_ABSENT_NOT_USED 0u /**< point_select_bit_6_input: not_used. The function has no terminal. */
/** Whether point_select_bit_6_input is no quantity: not_used. */
static inline bool tc100_reg_point_select_bit_6_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_HOMING_SENSOR_INPUT_ABSENT_NOT_USED 0u /**< homing_sensor_input: not_used. The function has no terminal. */
/** Whether homing_sensor_input is no quantity: not_used. */
static inline bool tc100_reg_homing_sensor_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_BRAKE_INPUT_ABSENT_NOT_USED 0u /**< brake_input: not_used. The function has no terminal. */
/** Whether brake_input is no quantity: not_used. */
static inline bool tc100_reg_brake_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_FULL_COUNT_INPUT_ABSENT_NOT_USED 0u /**< full_count_input: not_used. The function has no terminal. */
/** Whether full_count_input is no quantity: not_used. */
static inline bool tc100_reg_full_count_input_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_IN_POSITION_OUTPUT_ABSENT_NOT_USED 0u /**< in_position_output: not_used. The function has no terminal. */
/** Whether in_position_output is no quantity: not_used. */
static inline bool tc100_reg_in_position_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_ALARM_OUTPUT_ABSENT_NOT_USED 0u /**< alarm_output: not_used. The function has no terminal. */
/** Whether alarm_output is no quantity: not_used. */
static inline bool tc100_reg_alarm_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_READY_OUTPUT_ABSENT_NOT_USED 0u /**< ready_output: not_used. The function has no terminal. */
/** Whether ready_output is no quantity: not_used. */
static inline bool tc100_reg_ready_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_MOVING_OUTPUT_ABSENT_NOT_USED 0u /**< moving_output: not_used. The function has no terminal. */
/** Whether moving_output is no quantity: not_used. */
static inline bool tc100_reg_moving_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_SERVO_ON_OUTPUT_ABSENT_NOT_USED 0u /**< servo_on_output: not_used. The function has no terminal. */
/** Whether servo_on_output is no quantity: not_used. */
static inline bool tc100_reg_servo_on_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_POINT_SELECT_BIT_0_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_0_output: not_used. The function has no terminal. */
/** Whether point_select_bit_0_output is no quantity: not_used. */
static inline bool tc100_reg_point_select_bit_0_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_POINT_SELECT_BIT_1_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_1_output: not_used. The function has no terminal. */
/** Whether point_select_bit_1_output is no quantity: not_used. */
static inline bool tc100_reg_point_select_bit_1_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_POINT_SELECT_BIT_2_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_2_output: not_used. The function has no terminal. */
/** Whether point_select_bit_2_output is no quantity: not_used. */
static inline bool tc100_reg_point_select_bit_2_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_POINT_SELECT_BIT_3_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_3_output: not_used. The function has no terminal. */
/** Whether point_select_bit_3_output is no quantity: not_used. */
static inline bool tc100_reg_point_select_bit_3_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_POINT_SELECT_BIT_4_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_4_output: not_used. The function has no terminal. */
/** Whether point_select_bit_4_output is no quantity: not_used. */
static inline bool tc100_reg_point_select_bit_4_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_POINT_SELECT_BIT_5_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_5_output: not_used. The function has no terminal. */
/** Whether point_select_bit_5_output is no quantity: not_used. */
static inline bool tc100_reg_point_select_bit_5_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_POINT_SELECT_BIT_6_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_6_output: not_used. The function has no terminal. */
/** Whether point_select_bit_6_output is no quantity: not_used. */
static inline bool tc100_reg_point_select_bit_6_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_TORQUE_LIMIT_OUTPUT_ABSENT_NOT_USED 0u /**< torque_limit_output: not_used. The function has no terminal. */
/** Whether torque_limit_output is no quantity: not_used. */
static inline bool tc100_reg_torque_limit_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_ERROR_BIT_0_OUTPUT_ABSENT_NOT_USED 0u /**< error_bit_0_output: not_used. The function has no terminal. */
/** Whether error_bit_0_output is no quantity: not_used. */
static inline bool tc100_reg_error_bit_0_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_ERROR_BIT_1_OUTPUT_ABSENT_NOT_USED 0u /**< error_bit_1_output: not_used. The function has no terminal. */
/** Whether error_bit_1_output is no quantity: not_used. */
static inline bool tc100_reg_error_bit_1_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_ERROR_BIT_2_OUTPUT_ABSENT_NOT_USED 0u /**< error_bit_2_output: not_used. The function has no terminal. */
/** Whether error_bit_2_output is no quantity: not_used. */
static inline bool tc100_reg_error_bit_2_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_ERROR_BIT_3_OUTPUT_ABSENT_NOT_USED 0u /**< error_bit_3_output: not_used. The function has no terminal. */
/** Whether error_bit_3_output is no quantity: not_used. */
static inline bool tc100_reg_error_bit_3_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_ZONE_OUTPUT_ABSENT_NOT_USED 0u /**< zone_output: not_used. The function has no terminal. */
/** Whether zone_output is no quantity: not_used. */
static inline bool tc100_reg_zone_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_NEAR_OUTPUT_ABSENT_NOT_USED 0u /**< near_output: not_used. The function has no terminal. */
/** Whether near_output is no quantity: not_used. */
static inline bool tc100_reg_near_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_SOFT_LIMIT_OUTPUT_ABSENT_NOT_USED 0u /**< soft_limit_output: not_used. The function has no terminal. */
/** Whether soft_limit_output is no quantity: not_used. */
static inline bool tc100_reg_soft_limit_output_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_MOTION_SPEED_ABSENT_START_SPEED 0u /**< motion_speed: start_speed. The start speed 0800H. */
/** Whether motion_speed is no quantity: start_speed. */
static inline bool tc100_reg_motion_speed_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_SOFT_LIMIT_POSITIVE_ABSENT_NO_LIMIT 0 /**< soft_limit_positive: no_limit. The soft limit is not active. */
/** Whether soft_limit_positive is no quantity: no_limit. */
static inline bool tc100_reg_soft_limit_positive_is_absent(int32_t value)
{
    return value == 0;
}

#define TC100_REG_SOFT_LIMIT_NEGATIVE_ABSENT_NO_LIMIT 0 /**< soft_limit_negative: no_limit. The soft limit is not active. */
/** Whether soft_limit_negative is no quantity: no_limit. */
static inline bool tc100_reg_soft_limit_negative_is_absent(int32_t value)
{
    return value == 0;
}

#define TC100_REG_HOMING_SPEED_ABSENT_START_SPEED 0u /**< homing_speed: start_speed. The start speed 0800H. */
/** Whether homing_speed is no quantity: start_speed. */
static inline bool tc100_reg_homing_speed_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_HOMING_OFFSET_SPEED_ABSENT_START_SPEED 0u /**< homing_offset_speed: start_speed. The start speed 0800H. */
/** Whether homing_offset_speed is no quantity: start_speed. */
static inline bool tc100_reg_homing_offset_speed_is_absent(uint16_t value)
{
    return value == 0u;
}

#define TC100_REG_EXECUTED_POINT_ABSENT_NONE (-1) /**< executed_point: none. No point was executed yet. */
/** Whether executed_point is no quantity: none. */
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
