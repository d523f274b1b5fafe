/*
 * Fuzzes hiwin_e_v2_14_4.h: E1/E2 PROFINET, version 2.14.4
 * Identity: 9bc9d8915a5c154a
 *
 * Generated; do not edit. For libFuzzer, and for AFL++ by afl-clang-fast:
 *
 *     clang -g -O1 -fsanitize=fuzzer,address,undefined,float-cast-overflow hiwin_e_v2_14_4_fuzz.c && ./a.out
 *
 * The first two bytes of an input select a function, the others are its input. The target stops
 * - when a function reads or writes out of bounds, which the sanitizers detect;
 * - when encoding what was decoded gives other bytes, apart from reserved ones and those after the end of a text;
 * - when opening a frame that was closed gives another body, or closing a frame that was opened gives other bytes.
 */
#include "hiwin_e_v2_14_4.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { LARGEST = 1024, CHOICES = 162 };

static void hold(bool so)
{
    if (!so) {
        abort();
    }
}

/* Decodes and encodes twice, then encodes into a buffer of the exact size, and into one that is a byte too small. */
#define RECORD(type, decode, encode, most, exact) \
    do { \
        type value, second; \
        uint8_t out[most] = {0}, again[most] = {0}; \
        uint8_t *room; \
        size_t length = 0, beyond = 0; \
        memset(&value, 0, sizeof value); \
        memset(&second, 0, sizeof second); \
        if (decode(data, size, &value) != HIWIN_E_OK) { \
            break; \
        } \
        if (encode(&value, out, sizeof out, &length) == HIWIN_E_ERR_OUT_OF_RANGE) { \
            break; \
        } \
        hold(encode(&value, out, sizeof out, &length) == HIWIN_E_OK && length == size); \
        hold(!(exact) || memcmp(out, data, size) == 0); \
        hold(decode(out, length, &second) == HIWIN_E_OK); \
        hold(encode(&second, again, sizeof again, &length) == HIWIN_E_OK && length == size); \
        hold(memcmp(out, again, size) == 0); \
        room = (uint8_t *)malloc(size); \
        if (room != NULL && size > 0) { \
            hold(encode(&value, room, size, &length) == HIWIN_E_OK && memcmp(room, out, size) == 0); \
            hold(encode(&value, room, size - 1, &beyond) == HIWIN_E_ERR_CAPACITY); \
        } \
        free(room); \
    } while (0)

/* Unpacks any bytes and packs them, twice: the second time changes nothing. */
#define PACKED(type, unpack, pack, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}, again[length] = {0}; \
        if (size < (length)) { \
            break; \
        } \
        memset(&value, 0, sizeof value); \
        unpack(data, &value); \
        pack(&value, out); \
        unpack(out, &value); \
        pack(&value, again); \
        hold(memcmp(out, again, sizeof out) == 0); \
    } while (0)

/* A record without values, which has only one form. */
#define FIXED(decode, encode, most, exact) \
    do { \
        uint8_t out[(most) + 1u] = {0}; \
        size_t length = 0; \
        if (decode(data, size) != HIWIN_E_OK) { \
            break; \
        } \
        hold(encode(out, sizeof out, &length) == HIWIN_E_OK && length == size); \
        hold(!(exact) || memcmp(out, data, size) == 0); \
    } while (0)

/* The value of a register or a parameter. */
#define VALUE(type, decode, encode, held, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        if (size < (length) || decode(data, &value) != HIWIN_E_OK || encode(value, out) == HIWIN_E_ERR_OUT_OF_RANGE) { \
            break; \
        } \
        hold(encode(value, out) == HIWIN_E_OK && memcmp(out, data, held) == 0); \
    } while (0)

/* A constant: what is encoded can be decoded, and so can anything else that the device answers. */
#define CONSTANT(type, decode, encode, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        hold(encode(out) == HIWIN_E_OK && decode(out, &value) == HIWIN_E_OK); \
        hold(size < (length) || decode(data, &value) != HIWIN_E_ERR_WRONG_CONST); \
    } while (0)

/* A trigger: the device may answer anything, and whatever can be encoded is decoded to the same. `argument` is the type
 * of the value to encode: an enum, which need not hold every answer. */
#define TRIGGER(type, argument, decode, encode, held, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        if (size < (length)) { \
            break; \
        } \
        hold(decode(data, &value) == HIWIN_E_OK); \
        if ((type)(argument)value == value) { \
            hold(encode((argument)value, out) != HIWIN_E_OK || memcmp(out, data, held) == 0); \
        } \
    } while (0)

/* Any quantity is refused or becomes a count; with a reference of usual size, converting a count back and forth keeps it. */
#define CONVERSION(type, from_raw, to_raw, exact) \
    do { \
        type raw = 0, again = 0; \
        double quantity, reference; \
        if (size < 2 * sizeof quantity) { \
            break; \
        } \
        memcpy(&quantity, data, sizeof quantity); \
        memcpy(&reference, data + sizeof quantity, sizeof reference); \
        if (to_raw(quantity, reference, &raw) == HIWIN_E_OK && (exact) && reference > 1e-9 && reference < 1e9) { \
            hold(to_raw(from_raw(raw, reference), reference, &again) == HIWIN_E_OK && again == raw); \
        } \
    } while (0)

static void frame_0(const uint8_t *data, size_t size)
{
    static uint8_t out[4 * LARGEST];
    hiwin_e_cyclic_request_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (hiwin_e_cyclic_request_open(data, size, &opened) != HIWIN_E_OK) {
        return;
    }
    hold(opened.body >= data && opened.body + opened.body_length <= data + size);
    memcpy(out + 0, opened.body, opened.body_length);
    if (hiwin_e_cyclic_request_close(opened.body_length, out, sizeof out, &length) == HIWIN_E_OK) {
        hold(length == size && memcmp(out, data, size) == 0);
    }
}

static void frame_1(const uint8_t *data, size_t size)
{
    enum { GIVEN = 0 };
    static uint8_t out[4 * LARGEST];
    hiwin_e_cyclic_request_frame opened;
    size_t length = 0;
    hiwin_e_codec_status status;
    memset(&opened, 0, sizeof opened);
    memcpy(out + 0, data + GIVEN, size - GIVEN);
    if (hiwin_e_cyclic_request_close(size - GIVEN, out, sizeof out, &length) != HIWIN_E_OK) {
        return;
    }
    status = hiwin_e_cyclic_request_open(out, length, &opened);
    hold(status == HIWIN_E_OK);
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

static void frame_2(const uint8_t *data, size_t size)
{
    static uint8_t out[4 * LARGEST];
    hiwin_e_cyclic_response_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (hiwin_e_cyclic_response_open(data, size, &opened) != HIWIN_E_OK) {
        return;
    }
    hold(opened.body >= data && opened.body + opened.body_length <= data + size);
    memcpy(out + 0, opened.body, opened.body_length);
    if (hiwin_e_cyclic_response_close(opened.body_length, out, sizeof out, &length) == HIWIN_E_OK) {
        hold(length == size && memcmp(out, data, size) == 0);
    }
}

static void frame_3(const uint8_t *data, size_t size)
{
    enum { GIVEN = 0 };
    static uint8_t out[4 * LARGEST];
    hiwin_e_cyclic_response_frame opened;
    size_t length = 0;
    hiwin_e_codec_status status;
    memset(&opened, 0, sizeof opened);
    memcpy(out + 0, data + GIVEN, size - GIVEN);
    if (hiwin_e_cyclic_response_close(size - GIVEN, out, sizeof out, &length) != HIWIN_E_OK) {
        return;
    }
    status = hiwin_e_cyclic_response_open(out, length, &opened);
    hold(status == HIWIN_E_OK);
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

static void frame_4(const uint8_t *data, size_t size)
{
    static uint8_t out[4 * LARGEST];
    hiwin_e_parameter_channel_request_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (hiwin_e_parameter_channel_request_open(data, size, &opened) != HIWIN_E_OK) {
        return;
    }
    hold(opened.body >= data && opened.body + opened.body_length <= data + size);
    memcpy(out + 4, opened.body, opened.body_length);
    if (hiwin_e_parameter_channel_request_close(opened.request_reference, opened.code, opened.body_length, out, sizeof out, &length) == HIWIN_E_OK) {
        hold(length == size && memcmp(out, data, size) == 0);
    }
}

static void frame_5(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t out[4 * LARGEST];
    hiwin_e_parameter_channel_request_frame opened;
    size_t length = 0;
    hiwin_e_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 4, data + GIVEN, size - GIVEN);
    if (hiwin_e_parameter_channel_request_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != HIWIN_E_OK) {
        return;
    }
    status = hiwin_e_parameter_channel_request_open(out, length, &opened);
    if (status == HIWIN_E_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == HIWIN_E_OK);
    hold(opened.request_reference == data[0]);
    hold(opened.code == data[1]);
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

static void frame_6(const uint8_t *data, size_t size)
{
    static uint8_t out[4 * LARGEST];
    hiwin_e_parameter_channel_response_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (hiwin_e_parameter_channel_response_open(data, size, &opened) != HIWIN_E_OK) {
        return;
    }
    hold(opened.body >= data && opened.body + opened.body_length <= data + size);
    memcpy(out + 4, opened.body, opened.body_length);
    if (hiwin_e_parameter_channel_response_close(opened.request_reference, opened.code | (opened.error ? 128u : 0u), opened.body_length, out, sizeof out, &length) == HIWIN_E_OK) {
        hold(length == size && memcmp(out, data, size) == 0);
    }
}

static void frame_7(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t out[4 * LARGEST];
    hiwin_e_parameter_channel_response_frame opened;
    size_t length = 0;
    hiwin_e_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 4, data + GIVEN, size - GIVEN);
    if (hiwin_e_parameter_channel_response_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != HIWIN_E_OK) {
        return;
    }
    status = hiwin_e_parameter_channel_response_open(out, length, &opened);
    if (status == HIWIN_E_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == HIWIN_E_OK);
    hold(opened.request_reference == data[0]);
    hold(opened.code == (data[1] & 127u));
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    unsigned choice;
    if (size < 2 || size > LARGEST) {
        return 0;
    }
    choice = (data[0] | (unsigned)data[1] << 8) % CHOICES;
    data += 2;
    size -= 2;
    switch (choice) {
    case 0:
        frame_0(data, size);
        break;
    case 1:
        frame_1(data, size);
        break;
    case 2:
        frame_2(data, size);
        break;
    case 3:
        frame_3(data, size);
        break;
    case 4:
        frame_4(data, size);
        break;
    case 5:
        frame_5(data, size);
        break;
    case 6:
        frame_6(data, size);
        break;
    case 7:
        frame_7(data, size);
        break;
    case 8:
        RECORD(hiwin_e_parameter_error, hiwin_e_parameter_error_decode, hiwin_e_parameter_error_encode, HIWIN_E_PARAMETER_ERROR_SIZE, 1);
        break;
    case 9:
        PACKED(hiwin_e_parameter_error, hiwin_e_parameter_error_unpack, hiwin_e_parameter_error_pack, HIWIN_E_PARAMETER_ERROR_SIZE);
        break;
    case 10:
        RECORD(hiwin_e_read_parameter_request, hiwin_e_read_parameter_request_decode, hiwin_e_read_parameter_request_encode, HIWIN_E_READ_PARAMETER_REQUEST_SIZE, 1);
        break;
    case 11:
        PACKED(hiwin_e_read_parameter_request, hiwin_e_read_parameter_request_unpack, hiwin_e_read_parameter_request_pack, HIWIN_E_READ_PARAMETER_REQUEST_SIZE);
        break;
    case 12:
        RECORD(hiwin_e_read_parameter_response, hiwin_e_read_parameter_response_decode, hiwin_e_read_parameter_response_encode, HIWIN_E_READ_PARAMETER_RESPONSE_SIZE, 1);
        break;
    case 13:
        RECORD(hiwin_e_write_parameter_request, hiwin_e_write_parameter_request_decode, hiwin_e_write_parameter_request_encode, HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE, 1);
        break;
    case 14:
        FIXED(hiwin_e_write_parameter_response_decode, hiwin_e_write_parameter_response_encode, HIWIN_E_WRITE_PARAMETER_RESPONSE_SIZE, 1);
        break;
    case 15:
        RECORD(hiwin_e_telegram_3_request, hiwin_e_telegram_3_request_decode, hiwin_e_telegram_3_request_encode, HIWIN_E_TELEGRAM_3_REQUEST_SIZE, 1);
        break;
    case 16:
        PACKED(hiwin_e_telegram_3_request, hiwin_e_telegram_3_request_unpack, hiwin_e_telegram_3_request_pack, HIWIN_E_TELEGRAM_3_REQUEST_SIZE);
        break;
    case 17:
        RECORD(hiwin_e_telegram_3_response, hiwin_e_telegram_3_response_decode, hiwin_e_telegram_3_response_encode, HIWIN_E_TELEGRAM_3_RESPONSE_SIZE, 1);
        break;
    case 18:
        PACKED(hiwin_e_telegram_3_response, hiwin_e_telegram_3_response_unpack, hiwin_e_telegram_3_response_pack, HIWIN_E_TELEGRAM_3_RESPONSE_SIZE);
        break;
    case 19:
        RECORD(hiwin_e_telegram_5_request, hiwin_e_telegram_5_request_decode, hiwin_e_telegram_5_request_encode, HIWIN_E_TELEGRAM_5_REQUEST_SIZE, 1);
        break;
    case 20:
        PACKED(hiwin_e_telegram_5_request, hiwin_e_telegram_5_request_unpack, hiwin_e_telegram_5_request_pack, HIWIN_E_TELEGRAM_5_REQUEST_SIZE);
        break;
    case 21:
        RECORD(hiwin_e_telegram_5_response, hiwin_e_telegram_5_response_decode, hiwin_e_telegram_5_response_encode, HIWIN_E_TELEGRAM_5_RESPONSE_SIZE, 1);
        break;
    case 22:
        PACKED(hiwin_e_telegram_5_response, hiwin_e_telegram_5_response_unpack, hiwin_e_telegram_5_response_pack, HIWIN_E_TELEGRAM_5_RESPONSE_SIZE);
        break;
    case 23:
        RECORD(hiwin_e_telegram_9_request, hiwin_e_telegram_9_request_decode, hiwin_e_telegram_9_request_encode, HIWIN_E_TELEGRAM_9_REQUEST_SIZE, 1);
        break;
    case 24:
        PACKED(hiwin_e_telegram_9_request, hiwin_e_telegram_9_request_unpack, hiwin_e_telegram_9_request_pack, HIWIN_E_TELEGRAM_9_REQUEST_SIZE);
        break;
    case 25:
        RECORD(hiwin_e_telegram_9_response, hiwin_e_telegram_9_response_decode, hiwin_e_telegram_9_response_encode, HIWIN_E_TELEGRAM_9_RESPONSE_SIZE, 1);
        break;
    case 26:
        PACKED(hiwin_e_telegram_9_response, hiwin_e_telegram_9_response_unpack, hiwin_e_telegram_9_response_pack, HIWIN_E_TELEGRAM_9_RESPONSE_SIZE);
        break;
    case 27:
        RECORD(hiwin_e_telegram_102_request, hiwin_e_telegram_102_request_decode, hiwin_e_telegram_102_request_encode, HIWIN_E_TELEGRAM_102_REQUEST_SIZE, 1);
        break;
    case 28:
        PACKED(hiwin_e_telegram_102_request, hiwin_e_telegram_102_request_unpack, hiwin_e_telegram_102_request_pack, HIWIN_E_TELEGRAM_102_REQUEST_SIZE);
        break;
    case 29:
        RECORD(hiwin_e_telegram_102_response, hiwin_e_telegram_102_response_decode, hiwin_e_telegram_102_response_encode, HIWIN_E_TELEGRAM_102_RESPONSE_SIZE, 1);
        break;
    case 30:
        PACKED(hiwin_e_telegram_102_response, hiwin_e_telegram_102_response_unpack, hiwin_e_telegram_102_response_pack, HIWIN_E_TELEGRAM_102_RESPONSE_SIZE);
        break;
    case 31:
        RECORD(hiwin_e_telegram_105_request, hiwin_e_telegram_105_request_decode, hiwin_e_telegram_105_request_encode, HIWIN_E_TELEGRAM_105_REQUEST_SIZE, 1);
        break;
    case 32:
        PACKED(hiwin_e_telegram_105_request, hiwin_e_telegram_105_request_unpack, hiwin_e_telegram_105_request_pack, HIWIN_E_TELEGRAM_105_REQUEST_SIZE);
        break;
    case 33:
        RECORD(hiwin_e_telegram_105_response, hiwin_e_telegram_105_response_decode, hiwin_e_telegram_105_response_encode, HIWIN_E_TELEGRAM_105_RESPONSE_SIZE, 1);
        break;
    case 34:
        PACKED(hiwin_e_telegram_105_response, hiwin_e_telegram_105_response_unpack, hiwin_e_telegram_105_response_pack, HIWIN_E_TELEGRAM_105_RESPONSE_SIZE);
        break;
    case 35:
        RECORD(hiwin_e_telegram_111_request, hiwin_e_telegram_111_request_decode, hiwin_e_telegram_111_request_encode, HIWIN_E_TELEGRAM_111_REQUEST_SIZE, 0);
        break;
    case 36:
        PACKED(hiwin_e_telegram_111_request, hiwin_e_telegram_111_request_unpack, hiwin_e_telegram_111_request_pack, HIWIN_E_TELEGRAM_111_REQUEST_SIZE);
        break;
    case 37:
        RECORD(hiwin_e_telegram_111_response, hiwin_e_telegram_111_response_decode, hiwin_e_telegram_111_response_encode, HIWIN_E_TELEGRAM_111_RESPONSE_SIZE, 0);
        break;
    case 38:
        PACKED(hiwin_e_telegram_111_response, hiwin_e_telegram_111_response_unpack, hiwin_e_telegram_111_response_pack, HIWIN_E_TELEGRAM_111_RESPONSE_SIZE);
        break;
    case 39:
        RECORD(hiwin_e_telegram_750_request, hiwin_e_telegram_750_request_decode, hiwin_e_telegram_750_request_encode, HIWIN_E_TELEGRAM_750_REQUEST_SIZE, 1);
        break;
    case 40:
        PACKED(hiwin_e_telegram_750_request, hiwin_e_telegram_750_request_unpack, hiwin_e_telegram_750_request_pack, HIWIN_E_TELEGRAM_750_REQUEST_SIZE);
        break;
    case 41:
        RECORD(hiwin_e_telegram_750_response, hiwin_e_telegram_750_response_decode, hiwin_e_telegram_750_response_encode, HIWIN_E_TELEGRAM_750_RESPONSE_SIZE, 1);
        break;
    case 42:
        PACKED(hiwin_e_telegram_750_response, hiwin_e_telegram_750_response_unpack, hiwin_e_telegram_750_response_pack, HIWIN_E_TELEGRAM_750_RESPONSE_SIZE);
        break;
    case 43:
        VALUE(hiwin_e_motor_type, hiwin_e_par_drive_parameters_motor_type_decode, hiwin_e_par_drive_parameters_motor_type_encode, 2u, 2u);
        break;
    case 44:
        VALUE(int32_t, hiwin_e_par_drive_parameters_inner_encoder_resolution_decode, hiwin_e_par_drive_parameters_inner_encoder_resolution_encode, 4u, 4u);
        break;
    case 45:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_digital_outputs_decode, hiwin_e_par_drive_parameters_digital_outputs_encode, 2u, 2u);
        break;
    case 46:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_software_state_12_decode, hiwin_e_par_drive_parameters_software_state_12_encode, 2u, 2u);
        break;
    case 47:
        VALUE(hiwin_e_gantry_application_mode, hiwin_e_par_drive_parameters_gantry_application_mode_decode, hiwin_e_par_drive_parameters_gantry_application_mode_encode, 2u, 2u);
        break;
    case 48:
        VALUE(int32_t, hiwin_e_par_drive_parameters_yaw_target_position_decode, hiwin_e_par_drive_parameters_yaw_target_position_encode, 4u, 4u);
        break;
    case 49:
        VALUE(int32_t, hiwin_e_par_drive_parameters_yaw_feedback_position_decode, hiwin_e_par_drive_parameters_yaw_feedback_position_encode, 4u, 4u);
        break;
    case 50:
        VALUE(int32_t, hiwin_e_par_drive_parameters_master_feedback_position_decode, hiwin_e_par_drive_parameters_master_feedback_position_encode, 4u, 4u);
        break;
    case 51:
        VALUE(int32_t, hiwin_e_par_drive_parameters_slave_feedback_position_decode, hiwin_e_par_drive_parameters_slave_feedback_position_encode, 4u, 4u);
        break;
    case 52:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_reference_mark_functions_decode, hiwin_e_par_drive_parameters_reference_mark_functions_encode, 2u, 2u);
        break;
    case 53:
        VALUE(bool, hiwin_e_par_drive_parameters_position_trigger_enabled_decode, hiwin_e_par_drive_parameters_position_trigger_enabled_encode, 2u, 2u);
        break;
    case 54:
        VALUE(int16_t, hiwin_e_par_drive_parameters_speed_analog_input_voltage_decode, hiwin_e_par_drive_parameters_speed_analog_input_voltage_encode, 2u, 2u);
        break;
    case 55:
        VALUE(int16_t, hiwin_e_par_drive_parameters_speed_analog_input_offset_decode, hiwin_e_par_drive_parameters_speed_analog_input_offset_encode, 2u, 2u);
        break;
    case 56:
        VALUE(int16_t, hiwin_e_par_drive_parameters_torque_analog_input_voltage_decode, hiwin_e_par_drive_parameters_torque_analog_input_voltage_encode, 2u, 2u);
        break;
    case 57:
        VALUE(int16_t, hiwin_e_par_drive_parameters_torque_analog_input_offset_decode, hiwin_e_par_drive_parameters_torque_analog_input_offset_encode, 2u, 2u);
        break;
    case 58:
        VALUE(int16_t, hiwin_e_par_drive_parameters_analog_output_1_voltage_decode, hiwin_e_par_drive_parameters_analog_output_1_voltage_encode, 2u, 2u);
        break;
    case 59:
        VALUE(int16_t, hiwin_e_par_drive_parameters_analog_output_2_voltage_decode, hiwin_e_par_drive_parameters_analog_output_2_voltage_encode, 2u, 2u);
        break;
    case 60:
        VALUE(int32_t, hiwin_e_par_drive_parameters_position_trigger_array_value_decode, hiwin_e_par_drive_parameters_position_trigger_array_value_encode, 4u, 4u);
        break;
    case 61:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_position_trigger_array_index_decode, hiwin_e_par_drive_parameters_position_trigger_array_index_encode, 2u, 2u);
        break;
    case 62:
        TRIGGER(uint16_t, uint16_t, hiwin_e_par_drive_parameters_position_trigger_array_control_decode, hiwin_e_par_drive_parameters_position_trigger_array_control_encode, 2u, 2u);
        break;
    case 63:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_position_trigger_error_decode, hiwin_e_par_drive_parameters_position_trigger_error_encode, 2u, 2u);
        break;
    case 64:
        VALUE(int16_t, hiwin_e_par_drive_parameters_position_trigger_status_decode, hiwin_e_par_drive_parameters_position_trigger_status_encode, 2u, 2u);
        break;
    case 65:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_expected_position_trigger_count_decode, hiwin_e_par_drive_parameters_expected_position_trigger_count_encode, 2u, 2u);
        break;
    case 66:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_position_trigger_count_decode, hiwin_e_par_drive_parameters_position_trigger_count_encode, 2u, 2u);
        break;
    case 67:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_remaining_position_trigger_count_decode, hiwin_e_par_drive_parameters_remaining_position_trigger_count_encode, 2u, 2u);
        break;
    case 68:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_gantry_parameter_index_decode, hiwin_e_par_drive_parameters_gantry_parameter_index_encode, 2u, 2u);
        break;
    case 69:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_gantry_parameter_subindex_decode, hiwin_e_par_drive_parameters_gantry_parameter_subindex_encode, 2u, 2u);
        break;
    case 70:
        VALUE(int16_t, hiwin_e_par_drive_parameters_gantry_parameter_type_decode, hiwin_e_par_drive_parameters_gantry_parameter_type_encode, 2u, 2u);
        break;
    case 71:
        TRIGGER(uint16_t, hiwin_e_gantry_parameter_command, hiwin_e_par_drive_parameters_gantry_parameter_command_decode, hiwin_e_par_drive_parameters_gantry_parameter_command_encode, 2u, 2u);
        break;
    case 72:
        VALUE(hiwin_e_gantry_parameter_status, hiwin_e_par_drive_parameters_gantry_parameter_status_decode, hiwin_e_par_drive_parameters_gantry_parameter_status_encode, 2u, 2u);
        break;
    case 73:
        VALUE(int32_t, hiwin_e_par_drive_parameters_gantry_integer_input_decode, hiwin_e_par_drive_parameters_gantry_integer_input_encode, 4u, 4u);
        break;
    case 74:
        VALUE(int32_t, hiwin_e_par_drive_parameters_gantry_integer_output_decode, hiwin_e_par_drive_parameters_gantry_integer_output_encode, 4u, 4u);
        break;
    case 75:
        VALUE(float, hiwin_e_par_drive_parameters_gantry_float_input_decode, hiwin_e_par_drive_parameters_gantry_float_input_encode, 4u, 4u);
        break;
    case 76:
        VALUE(float, hiwin_e_par_drive_parameters_gantry_float_output_decode, hiwin_e_par_drive_parameters_gantry_float_output_encode, 4u, 4u);
        break;
    case 77:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_drive_warnings_1_decode, hiwin_e_par_drive_parameters_drive_warnings_1_encode, 2u, 2u);
        break;
    case 78:
        VALUE(uint16_t, hiwin_e_par_drive_parameters_drive_warnings_2_decode, hiwin_e_par_drive_parameters_drive_warnings_2_encode, 2u, 2u);
        break;
    case 79:
        VALUE(uint32_t, hiwin_e_par_drive_parameters_operation_warnings_decode, hiwin_e_par_drive_parameters_operation_warnings_encode, 4u, 4u);
        break;
    case 80:
        TRIGGER(int32_t, hiwin_e_absolute_encoder_initialization, hiwin_e_par_drive_parameters_absolute_encoder_initialization_decode, hiwin_e_par_drive_parameters_absolute_encoder_initialization_encode, 4u, 4u);
        break;
    case 81:
        VALUE(int32_t, hiwin_e_par_drive_parameters_general_integer_1_decode, hiwin_e_par_drive_parameters_general_integer_1_encode, 4u, 4u);
        break;
    case 82:
        VALUE(int32_t, hiwin_e_par_drive_parameters_general_integer_2_decode, hiwin_e_par_drive_parameters_general_integer_2_encode, 4u, 4u);
        break;
    case 83:
        VALUE(int32_t, hiwin_e_par_drive_parameters_general_integer_3_decode, hiwin_e_par_drive_parameters_general_integer_3_encode, 4u, 4u);
        break;
    case 84:
        VALUE(int32_t, hiwin_e_par_drive_parameters_general_integer_4_decode, hiwin_e_par_drive_parameters_general_integer_4_encode, 4u, 4u);
        break;
    case 85:
        VALUE(int32_t, hiwin_e_par_drive_parameters_general_integer_5_decode, hiwin_e_par_drive_parameters_general_integer_5_encode, 4u, 4u);
        break;
    case 86:
        VALUE(int32_t, hiwin_e_par_drive_parameters_general_integer_6_decode, hiwin_e_par_drive_parameters_general_integer_6_encode, 4u, 4u);
        break;
    case 87:
        VALUE(int32_t, hiwin_e_par_drive_parameters_general_integer_7_decode, hiwin_e_par_drive_parameters_general_integer_7_encode, 4u, 4u);
        break;
    case 88:
        VALUE(int32_t, hiwin_e_par_drive_parameters_general_integer_8_decode, hiwin_e_par_drive_parameters_general_integer_8_encode, 4u, 4u);
        break;
    case 89:
        VALUE(int32_t, hiwin_e_par_drive_parameters_general_integer_9_decode, hiwin_e_par_drive_parameters_general_integer_9_encode, 4u, 4u);
        break;
    case 90:
        VALUE(float, hiwin_e_par_drive_parameters_general_float_0_decode, hiwin_e_par_drive_parameters_general_float_0_encode, 4u, 4u);
        break;
    case 91:
        VALUE(float, hiwin_e_par_drive_parameters_general_float_1_decode, hiwin_e_par_drive_parameters_general_float_1_encode, 4u, 4u);
        break;
    case 92:
        VALUE(float, hiwin_e_par_drive_parameters_general_float_2_decode, hiwin_e_par_drive_parameters_general_float_2_encode, 4u, 4u);
        break;
    case 93:
        VALUE(float, hiwin_e_par_drive_parameters_general_float_3_decode, hiwin_e_par_drive_parameters_general_float_3_encode, 4u, 4u);
        break;
    case 94:
        VALUE(float, hiwin_e_par_drive_parameters_general_float_4_decode, hiwin_e_par_drive_parameters_general_float_4_encode, 4u, 4u);
        break;
    case 95:
        TRIGGER(int16_t, hiwin_e_drive_reset, hiwin_e_par_drive_parameters_drive_reset_decode, hiwin_e_par_drive_parameters_drive_reset_encode, 2u, 2u);
        break;
    case 96:
        TRIGGER(int16_t, hiwin_e_parameter_save, hiwin_e_par_drive_parameters_parameter_save_decode, hiwin_e_par_drive_parameters_parameter_save_encode, 2u, 2u);
        break;
    case 97:
        VALUE(hiwin_e_mastership, hiwin_e_par_drive_parameters_mastership_decode, hiwin_e_par_drive_parameters_mastership_encode, 2u, 2u);
        break;
    case 98:
        VALUE(uint16_t, hiwin_e_par_monitoring_parameters_digital_output_states_decode, hiwin_e_par_monitoring_parameters_digital_output_states_encode, 2u, 2u);
        break;
    case 99:
        VALUE(uint16_t, hiwin_e_par_monitoring_parameters_alarm_decode, hiwin_e_par_monitoring_parameters_alarm_encode, 2u, 2u);
        break;
    case 100:
        VALUE(uint16_t, hiwin_e_par_monitoring_parameters_warning_decode, hiwin_e_par_monitoring_parameters_warning_encode, 2u, 2u);
        break;
    case 101:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_telegram_selection_decode, hiwin_e_par_profidrive_parameters_telegram_selection_encode, 2u, 2u);
        break;
    case 102:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_sign_of_life_failure_tolerance_decode, hiwin_e_par_profidrive_parameters_sign_of_life_failure_tolerance_encode, 2u, 2u);
        break;
    case 103:
        VALUE(hiwin_e_operating_mode, hiwin_e_par_profidrive_parameters_operating_mode_decode, hiwin_e_par_profidrive_parameters_operating_mode_encode, 2u, 2u);
        break;
    case 104:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_alarm_counter_decode, hiwin_e_par_profidrive_parameters_alarm_counter_encode, 2u, 2u);
        break;
    case 105:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_alarm_codes_decode, hiwin_e_par_profidrive_parameters_alarm_codes_encode, 2u, 2u);
        break;
    case 106:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_internal_alarm_codes_decode, hiwin_e_par_profidrive_parameters_internal_alarm_codes_encode, 2u, 2u);
        break;
    case 107:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_decode, hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_encode, 2u, 2u);
        break;
    case 108:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_block_count_decode, hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_block_count_encode, 2u, 2u);
        break;
    case 109:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_alarms_per_block_decode, hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_alarms_per_block_encode, 2u, 2u);
        break;
    case 110:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_alarm_block_counter_decode, hiwin_e_par_profidrive_parameters_alarm_block_counter_encode, 2u, 2u);
        break;
    case 111:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_drive_identification_decode, hiwin_e_par_profidrive_parameters_drive_identification_encode, 2u, 2u);
        break;
    case 112:
        CONSTANT(uint16_t, hiwin_e_par_profidrive_parameters_drive_identification_manufacturer_decode, hiwin_e_par_profidrive_parameters_drive_identification_manufacturer_encode, 2u);
        break;
    case 113:
        CONSTANT(uint16_t, hiwin_e_par_profidrive_parameters_drive_identification_drive_unit_type_decode, hiwin_e_par_profidrive_parameters_drive_identification_drive_unit_type_encode, 2u);
        break;
    case 114:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_drive_identification_firmware_version_decode, hiwin_e_par_profidrive_parameters_drive_identification_firmware_version_encode, 2u, 2u);
        break;
    case 115:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_drive_identification_firmware_year_decode, hiwin_e_par_profidrive_parameters_drive_identification_firmware_year_encode, 2u, 2u);
        break;
    case 116:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_drive_identification_firmware_day_and_month_decode, hiwin_e_par_profidrive_parameters_drive_identification_firmware_day_and_month_encode, 2u, 2u);
        break;
    case 117:
        CONSTANT(uint16_t, hiwin_e_par_profidrive_parameters_drive_identification_drive_object_count_decode, hiwin_e_par_profidrive_parameters_drive_identification_drive_object_count_encode, 2u);
        break;
    case 118:
        VALUE(uint16_t, hiwin_e_par_profidrive_parameters_drive_identification_minor_firmware_version_decode, hiwin_e_par_profidrive_parameters_drive_identification_minor_firmware_version_encode, 2u, 2u);
        break;
    case 119:
        VALUE(uint32_t, hiwin_e_par_profidrive_parameters_encoder_format_decode, hiwin_e_par_profidrive_parameters_encoder_format_encode, 4u, 4u);
        break;
    case 120:
        VALUE(uint32_t, hiwin_e_par_profidrive_parameters_encoder_format_header_decode, hiwin_e_par_profidrive_parameters_encoder_format_header_encode, 4u, 4u);
        break;
    case 121:
        VALUE(uint32_t, hiwin_e_par_profidrive_parameters_encoder_format_encoder_type_decode, hiwin_e_par_profidrive_parameters_encoder_format_encoder_type_encode, 4u, 4u);
        break;
    case 122:
        VALUE(uint32_t, hiwin_e_par_profidrive_parameters_encoder_format_encoder_resolution_decode, hiwin_e_par_profidrive_parameters_encoder_format_encoder_resolution_encode, 4u, 4u);
        break;
    case 123:
        VALUE(uint32_t, hiwin_e_par_profidrive_parameters_encoder_format_actual_position_1_shift_decode, hiwin_e_par_profidrive_parameters_encoder_format_actual_position_1_shift_encode, 4u, 4u);
        break;
    case 124:
        VALUE(uint32_t, hiwin_e_par_profidrive_parameters_encoder_format_actual_position_2_shift_decode, hiwin_e_par_profidrive_parameters_encoder_format_actual_position_2_shift_encode, 4u, 4u);
        break;
    case 125:
        VALUE(uint32_t, hiwin_e_par_profidrive_parameters_encoder_format_maximum_turn_count_decode, hiwin_e_par_profidrive_parameters_encoder_format_maximum_turn_count_encode, 4u, 4u);
        break;
    case 126:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_basic_function_switch_1_decode, hiwin_e_par_servo_parameters_basic_function_switch_1_encode, 2u, 2u);
        break;
    case 127:
        VALUE(int32_t, hiwin_e_par_servo_parameters_modulo_range_upper_limit_decode, hiwin_e_par_servo_parameters_modulo_range_upper_limit_encode, 4u, 4u);
        break;
    case 128:
        VALUE(int32_t, hiwin_e_par_servo_parameters_modulo_range_lower_limit_decode, hiwin_e_par_servo_parameters_modulo_range_lower_limit_encode, 4u, 4u);
        break;
    case 129:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_quick_stop_deceleration_time_decode, hiwin_e_par_servo_parameters_quick_stop_deceleration_time_encode, 2u, 2u);
        break;
    case 130:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_maximum_speed_rotary_decode, hiwin_e_par_servo_parameters_maximum_speed_rotary_encode, 2u, 2u);
        break;
    case 131:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_reference_speed_rotary_decode, hiwin_e_par_servo_parameters_reference_speed_rotary_encode, 2u, 2u);
        break;
    case 132:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_maximum_speed_linear_decode, hiwin_e_par_servo_parameters_maximum_speed_linear_encode, 2u, 2u);
        break;
    case 133:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_reference_speed_linear_decode, hiwin_e_par_servo_parameters_reference_speed_linear_encode, 2u, 2u);
        break;
    case 134:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_positive_torque_limit_decode, hiwin_e_par_servo_parameters_positive_torque_limit_encode, 2u, 2u);
        break;
    case 135:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_negative_torque_limit_decode, hiwin_e_par_servo_parameters_negative_torque_limit_encode, 2u, 2u);
        break;
    case 136:
        VALUE(uint32_t, hiwin_e_par_servo_parameters_reference_torque_decode, hiwin_e_par_servo_parameters_reference_torque_encode, 4u, 4u);
        break;
    case 137:
        VALUE(uint32_t, hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_decode, hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_encode, 4u, 4u);
        break;
    case 138:
        VALUE(uint32_t, hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_decode, hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_encode, 4u, 4u);
        break;
    case 139:
        VALUE(uint32_t, hiwin_e_par_servo_parameters_positive_fixed_stop_torque_decode, hiwin_e_par_servo_parameters_positive_fixed_stop_torque_encode, 4u, 4u);
        break;
    case 140:
        VALUE(uint32_t, hiwin_e_par_servo_parameters_negative_fixed_stop_torque_decode, hiwin_e_par_servo_parameters_negative_fixed_stop_torque_encode, 4u, 4u);
        break;
    case 141:
        VALUE(uint32_t, hiwin_e_par_servo_parameters_fixed_stop_following_error_decode, hiwin_e_par_servo_parameters_fixed_stop_following_error_encode, 4u, 4u);
        break;
    case 142:
        VALUE(uint32_t, hiwin_e_par_servo_parameters_reference_force_decode, hiwin_e_par_servo_parameters_reference_force_encode, 4u, 4u);
        break;
    case 143:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_positive_force_limit_decode, hiwin_e_par_servo_parameters_positive_force_limit_encode, 2u, 2u);
        break;
    case 144:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_negative_force_limit_decode, hiwin_e_par_servo_parameters_negative_force_limit_encode, 2u, 2u);
        break;
    case 145:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_point_to_point_speed_rotary_decode, hiwin_e_par_servo_parameters_point_to_point_speed_rotary_encode, 2u, 2u);
        break;
    case 146:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_point_to_point_acceleration_time_decode, hiwin_e_par_servo_parameters_point_to_point_acceleration_time_encode, 2u, 2u);
        break;
    case 147:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_point_to_point_deceleration_time_decode, hiwin_e_par_servo_parameters_point_to_point_deceleration_time_encode, 2u, 2u);
        break;
    case 148:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_decode, hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_encode, 2u, 2u);
        break;
    case 149:
        VALUE(int32_t, hiwin_e_par_servo_parameters_point_to_point_distance_decode, hiwin_e_par_servo_parameters_point_to_point_distance_encode, 4u, 4u);
        break;
    case 150:
        VALUE(bool, hiwin_e_par_servo_parameters_jog_direction_reversed_decode, hiwin_e_par_servo_parameters_jog_direction_reversed_encode, 2u, 2u);
        break;
    case 151:
        VALUE(uint16_t, hiwin_e_par_servo_parameters_point_to_point_speed_linear_decode, hiwin_e_par_servo_parameters_point_to_point_speed_linear_encode, 2u, 2u);
        break;
    case 152:
        CONVERSION(int32_t, hiwin_e_commanded_speed_from_raw, hiwin_e_commanded_speed_to_raw, 1);
        break;
    case 153:
        CONVERSION(int32_t, hiwin_e_actual_speed_from_raw, hiwin_e_actual_speed_to_raw, 1);
        break;
    case 154:
        CONVERSION(int16_t, hiwin_e_commanded_speed_a_from_raw, hiwin_e_commanded_speed_a_to_raw, 1);
        break;
    case 155:
        CONVERSION(int16_t, hiwin_e_actual_speed_a_from_raw, hiwin_e_actual_speed_a_to_raw, 1);
        break;
    case 156:
        CONVERSION(uint16_t, hiwin_e_output_torque_from_raw, hiwin_e_output_torque_to_raw, 1);
        break;
    case 157:
        CONVERSION(uint16_t, hiwin_e_torque_reduced_by_from_raw, hiwin_e_torque_reduced_by_to_raw, 1);
        break;
    case 158:
        CONVERSION(int16_t, hiwin_e_motor_torque_from_raw, hiwin_e_motor_torque_to_raw, 1);
        break;
    case 159:
        CONVERSION(int16_t, hiwin_e_torque_value_from_raw, hiwin_e_torque_value_to_raw, 1);
        break;
    case 160:
        CONVERSION(uint16_t, hiwin_e_share_of_acceleration_from_raw, hiwin_e_share_of_acceleration_to_raw, 1);
        break;
    case 161:
        CONVERSION(uint16_t, hiwin_e_overridden_velocity_from_raw, hiwin_e_overridden_velocity_to_raw, 1);
        break;
    default:
        break;
    }
    return 0;
}
