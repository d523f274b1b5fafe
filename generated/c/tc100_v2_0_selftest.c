/*
 * Tests tc100_v2_0.h: TC100, version 2.0
 * Identity: 8f5fd7b11e77b14b
 *
 * Generated; do not edit. Compile and run it: it exits with 0 if every test passes. On a machine without an operating system
 * compile it with -ffreestanding; then it has no main, and you call tc100_selftest yourself.
 */
#define TC100_WITH_TEXTS
#include "tc100_v2_0.h"

#if !defined(__STDC_HOSTED__) || __STDC_HOSTED__
#include <stdio.h>
#define HOSTED
#endif

/* Calls `tell` for each test that fails, and returns their number. */
unsigned long tc100_selftest(void (*tell)(const char *what));

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

static void test_0(void)
{
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_1_MASK == 0x0001u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_1_MASK");
    expect(tc100_simulated_input_word_simulated_input_1(0x0001u) == true, "tc100_simulated_input_word_simulated_input_1");
    expect(tc100_simulated_input_word_simulated_input_1((uint16_t)~0x0001u) == false, "tc100_simulated_input_word_simulated_input_1");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_2_MASK == 0x0002u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_2_MASK");
    expect(tc100_simulated_input_word_simulated_input_2(0x0002u) == true, "tc100_simulated_input_word_simulated_input_2");
    expect(tc100_simulated_input_word_simulated_input_2((uint16_t)~0x0002u) == false, "tc100_simulated_input_word_simulated_input_2");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_3_MASK == 0x0004u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_3_MASK");
    expect(tc100_simulated_input_word_simulated_input_3(0x0004u) == true, "tc100_simulated_input_word_simulated_input_3");
    expect(tc100_simulated_input_word_simulated_input_3((uint16_t)~0x0004u) == false, "tc100_simulated_input_word_simulated_input_3");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_4_MASK == 0x0008u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_4_MASK");
    expect(tc100_simulated_input_word_simulated_input_4(0x0008u) == true, "tc100_simulated_input_word_simulated_input_4");
    expect(tc100_simulated_input_word_simulated_input_4((uint16_t)~0x0008u) == false, "tc100_simulated_input_word_simulated_input_4");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_5_MASK == 0x0010u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_5_MASK");
    expect(tc100_simulated_input_word_simulated_input_5(0x0010u) == true, "tc100_simulated_input_word_simulated_input_5");
    expect(tc100_simulated_input_word_simulated_input_5((uint16_t)~0x0010u) == false, "tc100_simulated_input_word_simulated_input_5");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_6_MASK == 0x0020u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_6_MASK");
    expect(tc100_simulated_input_word_simulated_input_6(0x0020u) == true, "tc100_simulated_input_word_simulated_input_6");
    expect(tc100_simulated_input_word_simulated_input_6((uint16_t)~0x0020u) == false, "tc100_simulated_input_word_simulated_input_6");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_7_MASK == 0x0040u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_7_MASK");
    expect(tc100_simulated_input_word_simulated_input_7(0x0040u) == true, "tc100_simulated_input_word_simulated_input_7");
    expect(tc100_simulated_input_word_simulated_input_7((uint16_t)~0x0040u) == false, "tc100_simulated_input_word_simulated_input_7");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_8_MASK == 0x0080u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_8_MASK");
    expect(tc100_simulated_input_word_simulated_input_8(0x0080u) == true, "tc100_simulated_input_word_simulated_input_8");
    expect(tc100_simulated_input_word_simulated_input_8((uint16_t)~0x0080u) == false, "tc100_simulated_input_word_simulated_input_8");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_9_MASK == 0x0100u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_9_MASK");
    expect(tc100_simulated_input_word_simulated_input_9(0x0100u) == true, "tc100_simulated_input_word_simulated_input_9");
    expect(tc100_simulated_input_word_simulated_input_9((uint16_t)~0x0100u) == false, "tc100_simulated_input_word_simulated_input_9");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_10_MASK == 0x0200u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_10_MASK");
    expect(tc100_simulated_input_word_simulated_input_10(0x0200u) == true, "tc100_simulated_input_word_simulated_input_10");
    expect(tc100_simulated_input_word_simulated_input_10((uint16_t)~0x0200u) == false, "tc100_simulated_input_word_simulated_input_10");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_11_MASK == 0x0400u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_11_MASK");
    expect(tc100_simulated_input_word_simulated_input_11(0x0400u) == true, "tc100_simulated_input_word_simulated_input_11");
    expect(tc100_simulated_input_word_simulated_input_11((uint16_t)~0x0400u) == false, "tc100_simulated_input_word_simulated_input_11");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_12_MASK == 0x0800u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_12_MASK");
    expect(tc100_simulated_input_word_simulated_input_12(0x0800u) == true, "tc100_simulated_input_word_simulated_input_12");
    expect(tc100_simulated_input_word_simulated_input_12((uint16_t)~0x0800u) == false, "tc100_simulated_input_word_simulated_input_12");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_13_MASK == 0x1000u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_13_MASK");
    expect(tc100_simulated_input_word_simulated_input_13(0x1000u) == true, "tc100_simulated_input_word_simulated_input_13");
    expect(tc100_simulated_input_word_simulated_input_13((uint16_t)~0x1000u) == false, "tc100_simulated_input_word_simulated_input_13");
    expect(TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_14_MASK == 0x2000u, "TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_14_MASK");
    expect(tc100_simulated_input_word_simulated_input_14(0x2000u) == true, "tc100_simulated_input_word_simulated_input_14");
    expect(tc100_simulated_input_word_simulated_input_14((uint16_t)~0x2000u) == false, "tc100_simulated_input_word_simulated_input_14");
    expect(TC100_OUTPUT_WORD_OUTPUT_1_MASK == 0x0001u, "TC100_OUTPUT_WORD_OUTPUT_1_MASK");
    expect(tc100_output_word_output_1(0x0001u) == true, "tc100_output_word_output_1");
    expect(tc100_output_word_output_1((uint16_t)~0x0001u) == false, "tc100_output_word_output_1");
    expect(TC100_OUTPUT_WORD_OUTPUT_2_MASK == 0x0002u, "TC100_OUTPUT_WORD_OUTPUT_2_MASK");
    expect(tc100_output_word_output_2(0x0002u) == true, "tc100_output_word_output_2");
    expect(tc100_output_word_output_2((uint16_t)~0x0002u) == false, "tc100_output_word_output_2");
    expect(TC100_OUTPUT_WORD_OUTPUT_3_MASK == 0x0004u, "TC100_OUTPUT_WORD_OUTPUT_3_MASK");
    expect(tc100_output_word_output_3(0x0004u) == true, "tc100_output_word_output_3");
    expect(tc100_output_word_output_3((uint16_t)~0x0004u) == false, "tc100_output_word_output_3");
    expect(TC100_OUTPUT_WORD_OUTPUT_4_MASK == 0x0008u, "TC100_OUTPUT_WORD_OUTPUT_4_MASK");
    expect(tc100_output_word_output_4(0x0008u) == true, "tc100_output_word_output_4");
    expect(tc100_output_word_output_4((uint16_t)~0x0008u) == false, "tc100_output_word_output_4");
    expect(TC100_OUTPUT_WORD_OUTPUT_5_MASK == 0x0010u, "TC100_OUTPUT_WORD_OUTPUT_5_MASK");
    expect(tc100_output_word_output_5(0x0010u) == true, "tc100_output_word_output_5");
    expect(tc100_output_word_output_5((uint16_t)~0x0010u) == false, "tc100_output_word_output_5");
    expect(TC100_OUTPUT_WORD_OUTPUT_6_MASK == 0x0020u, "TC100_OUTPUT_WORD_OUTPUT_6_MASK");
    expect(tc100_output_word_output_6(0x0020u) == true, "tc100_output_word_output_6");
    expect(tc100_output_word_output_6((uint16_t)~0x0020u) == false, "tc100_output_word_output_6");
    expect(TC100_OUTPUT_WORD_OUTPUT_7_MASK == 0x0040u, "TC100_OUTPUT_WORD_OUTPUT_7_MASK");
    expect(tc100_output_word_output_7(0x0040u) == true, "tc100_output_word_output_7");
    expect(tc100_output_word_output_7((uint16_t)~0x0040u) == false, "tc100_output_word_output_7");
    expect(TC100_OUTPUT_WORD_OUTPUT_8_MASK == 0x0080u, "TC100_OUTPUT_WORD_OUTPUT_8_MASK");
    expect(tc100_output_word_output_8(0x0080u) == true, "tc100_output_word_output_8");
    expect(tc100_output_word_output_8((uint16_t)~0x0080u) == false, "tc100_output_word_output_8");
    expect(TC100_OUTPUT_WORD_OUTPUT_9_MASK == 0x0100u, "TC100_OUTPUT_WORD_OUTPUT_9_MASK");
    expect(tc100_output_word_output_9(0x0100u) == true, "tc100_output_word_output_9");
    expect(tc100_output_word_output_9((uint16_t)~0x0100u) == false, "tc100_output_word_output_9");
    expect(TC100_OUTPUT_WORD_OUTPUT_10_MASK == 0x0200u, "TC100_OUTPUT_WORD_OUTPUT_10_MASK");
    expect(tc100_output_word_output_10(0x0200u) == true, "tc100_output_word_output_10");
    expect(tc100_output_word_output_10((uint16_t)~0x0200u) == false, "tc100_output_word_output_10");
    expect(TC100_INPUT_WORD_INPUT_1_MASK == 0x0001u, "TC100_INPUT_WORD_INPUT_1_MASK");
    expect(tc100_input_word_input_1(0x0001u) == true, "tc100_input_word_input_1");
    expect(tc100_input_word_input_1((uint16_t)~0x0001u) == false, "tc100_input_word_input_1");
    expect(TC100_INPUT_WORD_INPUT_2_MASK == 0x0002u, "TC100_INPUT_WORD_INPUT_2_MASK");
    expect(tc100_input_word_input_2(0x0002u) == true, "tc100_input_word_input_2");
    expect(tc100_input_word_input_2((uint16_t)~0x0002u) == false, "tc100_input_word_input_2");
    expect(TC100_INPUT_WORD_INPUT_3_MASK == 0x0004u, "TC100_INPUT_WORD_INPUT_3_MASK");
    expect(tc100_input_word_input_3(0x0004u) == true, "tc100_input_word_input_3");
    expect(tc100_input_word_input_3((uint16_t)~0x0004u) == false, "tc100_input_word_input_3");
    expect(TC100_INPUT_WORD_INPUT_4_MASK == 0x0008u, "TC100_INPUT_WORD_INPUT_4_MASK");
    expect(tc100_input_word_input_4(0x0008u) == true, "tc100_input_word_input_4");
    expect(tc100_input_word_input_4((uint16_t)~0x0008u) == false, "tc100_input_word_input_4");
    expect(TC100_INPUT_WORD_INPUT_5_MASK == 0x0010u, "TC100_INPUT_WORD_INPUT_5_MASK");
    expect(tc100_input_word_input_5(0x0010u) == true, "tc100_input_word_input_5");
    expect(tc100_input_word_input_5((uint16_t)~0x0010u) == false, "tc100_input_word_input_5");
    expect(TC100_INPUT_WORD_INPUT_6_MASK == 0x0020u, "TC100_INPUT_WORD_INPUT_6_MASK");
    expect(tc100_input_word_input_6(0x0020u) == true, "tc100_input_word_input_6");
    expect(tc100_input_word_input_6((uint16_t)~0x0020u) == false, "tc100_input_word_input_6");
    expect(TC100_INPUT_WORD_INPUT_7_MASK == 0x0040u, "TC100_INPUT_WORD_INPUT_7_MASK");
    expect(tc100_input_word_input_7(0x0040u) == true, "tc100_input_word_input_7");
    expect(tc100_input_word_input_7((uint16_t)~0x0040u) == false, "tc100_input_word_input_7");
    expect(TC100_INPUT_WORD_INPUT_8_MASK == 0x0080u, "TC100_INPUT_WORD_INPUT_8_MASK");
    expect(tc100_input_word_input_8(0x0080u) == true, "tc100_input_word_input_8");
    expect(tc100_input_word_input_8((uint16_t)~0x0080u) == false, "tc100_input_word_input_8");
    expect(TC100_INPUT_WORD_INPUT_9_MASK == 0x0100u, "TC100_INPUT_WORD_INPUT_9_MASK");
    expect(tc100_input_word_input_9(0x0100u) == true, "tc100_input_word_input_9");
    expect(tc100_input_word_input_9((uint16_t)~0x0100u) == false, "tc100_input_word_input_9");
    expect(TC100_INPUT_WORD_INPUT_10_MASK == 0x0200u, "TC100_INPUT_WORD_INPUT_10_MASK");
    expect(tc100_input_word_input_10(0x0200u) == true, "tc100_input_word_input_10");
    expect(tc100_input_word_input_10((uint16_t)~0x0200u) == false, "tc100_input_word_input_10");
    expect(TC100_INPUT_WORD_INPUT_11_MASK == 0x0400u, "TC100_INPUT_WORD_INPUT_11_MASK");
    expect(tc100_input_word_input_11(0x0400u) == true, "tc100_input_word_input_11");
    expect(tc100_input_word_input_11((uint16_t)~0x0400u) == false, "tc100_input_word_input_11");
    expect(TC100_INPUT_WORD_INPUT_12_MASK == 0x0800u, "TC100_INPUT_WORD_INPUT_12_MASK");
    expect(tc100_input_word_input_12(0x0800u) == true, "tc100_input_word_input_12");
    expect(tc100_input_word_input_12((uint16_t)~0x0800u) == false, "tc100_input_word_input_12");
    expect(TC100_INPUT_WORD_INPUT_13_MASK == 0x1000u, "TC100_INPUT_WORD_INPUT_13_MASK");
    expect(tc100_input_word_input_13(0x1000u) == true, "tc100_input_word_input_13");
    expect(tc100_input_word_input_13((uint16_t)~0x1000u) == false, "tc100_input_word_input_13");
    expect(TC100_INPUT_WORD_INPUT_14_MASK == 0x2000u, "TC100_INPUT_WORD_INPUT_14_MASK");
    expect(tc100_input_word_input_14(0x2000u) == true, "tc100_input_word_input_14");
    expect(tc100_input_word_input_14((uint16_t)~0x2000u) == false, "tc100_input_word_input_14");
    expect(TC100_INPUT_WORD_Z_PHASE_MASK == 0x4000u, "TC100_INPUT_WORD_Z_PHASE_MASK");
    expect(tc100_input_word_z_phase(0x4000u) == true, "tc100_input_word_z_phase");
    expect(tc100_input_word_z_phase((uint16_t)~0x4000u) == false, "tc100_input_word_z_phase");
}

static void test_1(void)
{
    expect(tc100_rotation_direction_known(INT64_C(0)) == true, "tc100_rotation_direction_known");
    expect(tc100_rotation_direction_known(INT64_C(1)) == true, "tc100_rotation_direction_known");
    expect(tc100_rotation_direction_known(INT64_C(2)) == false, "tc100_rotation_direction_known");
    expect(tc100_pulse_input_form_known(INT64_C(0)) == true, "tc100_pulse_input_form_known");
    expect(tc100_pulse_input_form_known(INT64_C(1)) == true, "tc100_pulse_input_form_known");
    expect(tc100_pulse_input_form_known(INT64_C(2)) == true, "tc100_pulse_input_form_known");
    expect(tc100_pulse_input_form_known(INT64_C(3)) == false, "tc100_pulse_input_form_known");
    expect(tc100_control_mode_known(INT64_C(0)) == true, "tc100_control_mode_known");
    expect(tc100_control_mode_known(INT64_C(1)) == true, "tc100_control_mode_known");
    expect(tc100_control_mode_known(INT64_C(2)) == false, "tc100_control_mode_known");
    expect(tc100_servo_command_known(INT64_C(0)) == true, "tc100_servo_command_known");
    expect(tc100_servo_command_known(INT64_C(1)) == true, "tc100_servo_command_known");
    expect(tc100_servo_command_known(INT64_C(2)) == false, "tc100_servo_command_known");
    expect(tc100_moving_state_rule_known(INT64_C(0)) == true, "tc100_moving_state_rule_known");
    expect(tc100_moving_state_rule_known(INT64_C(1)) == true, "tc100_moving_state_rule_known");
    expect(tc100_moving_state_rule_known(INT64_C(2)) == false, "tc100_moving_state_rule_known");
    expect(tc100_homing_mode_known(INT64_C(0)) == true, "tc100_homing_mode_known");
    expect(tc100_homing_mode_known(INT64_C(1)) == true, "tc100_homing_mode_known");
    expect(tc100_homing_mode_known(INT64_C(2)) == true, "tc100_homing_mode_known");
    expect(tc100_homing_mode_known(INT64_C(3)) == true, "tc100_homing_mode_known");
    expect(tc100_homing_mode_known(INT64_C(4)) == true, "tc100_homing_mode_known");
    expect(tc100_homing_mode_known(INT64_C(5)) == true, "tc100_homing_mode_known");
    expect(tc100_homing_mode_known(INT64_C(6)) == true, "tc100_homing_mode_known");
    expect(tc100_homing_mode_known(INT64_C(7)) == true, "tc100_homing_mode_known");
    expect(tc100_homing_mode_known(INT64_C(8)) == false, "tc100_homing_mode_known");
    expect(tc100_baud_rate_known(INT64_C(0)) == true, "tc100_baud_rate_known");
    expect(tc100_baud_rate_known(INT64_C(1)) == true, "tc100_baud_rate_known");
    expect(tc100_baud_rate_known(INT64_C(2)) == true, "tc100_baud_rate_known");
    expect(tc100_baud_rate_known(INT64_C(3)) == true, "tc100_baud_rate_known");
    expect(tc100_baud_rate_known(INT64_C(4)) == true, "tc100_baud_rate_known");
    expect(tc100_baud_rate_known(INT64_C(5)) == false, "tc100_baud_rate_known");
    expect(tc100_data_bits_known(INT64_C(0)) == true, "tc100_data_bits_known");
    expect(tc100_data_bits_known(INT64_C(1)) == true, "tc100_data_bits_known");
    expect(tc100_data_bits_known(INT64_C(2)) == false, "tc100_data_bits_known");
    expect(tc100_parity_known(INT64_C(0)) == true, "tc100_parity_known");
    expect(tc100_parity_known(INT64_C(1)) == true, "tc100_parity_known");
    expect(tc100_parity_known(INT64_C(2)) == true, "tc100_parity_known");
    expect(tc100_parity_known(INT64_C(3)) == false, "tc100_parity_known");
    expect(tc100_protocol_known(INT64_C(0)) == true, "tc100_protocol_known");
    expect(tc100_protocol_known(INT64_C(1)) == true, "tc100_protocol_known");
    expect(tc100_protocol_known(INT64_C(2)) == false, "tc100_protocol_known");
    expect(tc100_action_status_known(INT64_C(0)) == true, "tc100_action_status_known");
    expect(tc100_action_status_known(INT64_C(1)) == true, "tc100_action_status_known");
    expect(tc100_action_status_known(INT64_C(2)) == true, "tc100_action_status_known");
    expect(tc100_action_status_known(INT64_C(3)) == false, "tc100_action_status_known");
    expect(tc100_torque_search_direction_known(INT64_C(0)) == true, "tc100_torque_search_direction_known");
    expect(tc100_torque_search_direction_known(INT64_C(1)) == true, "tc100_torque_search_direction_known");
    expect(tc100_torque_search_direction_known(INT64_C(2)) == false, "tc100_torque_search_direction_known");
    expect(tc100_motion_command_known(INT64_C(0)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(1)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(2)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(3)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(4)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(6)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(7)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(8)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(9)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(11)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(12)) == true, "tc100_motion_command_known");
    expect(tc100_motion_command_known(INT64_C(13)) == false, "tc100_motion_command_known");
    expect(tc100_parameter_storage_known(INT64_C(0)) == true, "tc100_parameter_storage_known");
    expect(tc100_parameter_storage_known(INT64_C(1)) == true, "tc100_parameter_storage_known");
    expect(tc100_parameter_storage_known(INT64_C(2)) == false, "tc100_parameter_storage_known");
}

static void test_2(void)
{
    expect(tc100_exception_code_text(INT64_C(1)) != NULL && tc100_exception_code_text(INT64_C(1))->number == (-INT64_C(1)) && same_text(tc100_exception_code_text(INT64_C(1))->name, "illegal_function") && same_text(tc100_exception_code_text(INT64_C(1))->printed, ""), "tc100_exception_code_text");
    expect(tc100_exception_code_text(INT64_C(2)) != NULL && tc100_exception_code_text(INT64_C(2))->number == (-INT64_C(1)) && same_text(tc100_exception_code_text(INT64_C(2))->name, "illegal_data_address") && same_text(tc100_exception_code_text(INT64_C(2))->printed, ""), "tc100_exception_code_text");
    expect(tc100_exception_code_text(INT64_C(3)) != NULL && tc100_exception_code_text(INT64_C(3))->number == (-INT64_C(1)) && same_text(tc100_exception_code_text(INT64_C(3))->name, "illegal_data_value") && same_text(tc100_exception_code_text(INT64_C(3))->printed, ""), "tc100_exception_code_text");
    expect(tc100_exception_code_text(INT64_C(0)) == NULL, "tc100_exception_code_text");
    expect(tc100_alarm_code_text(INT64_C(0)) != NULL && tc100_alarm_code_text(INT64_C(0))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(0))->name, "no_alarm") && same_text(tc100_alarm_code_text(INT64_C(0))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(1)) != NULL && tc100_alarm_code_text(INT64_C(1))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(1))->name, "loop_error") && same_text(tc100_alarm_code_text(INT64_C(1))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(2)) != NULL && tc100_alarm_code_text(INT64_C(2))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(2))->name, "full_count") && same_text(tc100_alarm_code_text(INT64_C(2))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(3)) != NULL && tc100_alarm_code_text(INT64_C(3))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(3))->name, "overspeed") && same_text(tc100_alarm_code_text(INT64_C(3))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(4)) != NULL && tc100_alarm_code_text(INT64_C(4))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(4))->name, "gain_adjustment_error") && same_text(tc100_alarm_code_text(INT64_C(4))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(5)) != NULL && tc100_alarm_code_text(INT64_C(5))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(5))->name, "overvoltage") && same_text(tc100_alarm_code_text(INT64_C(5))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(6)) != NULL && tc100_alarm_code_text(INT64_C(6))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(6))->name, "initialization_error") && same_text(tc100_alarm_code_text(INT64_C(6))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(7)) != NULL && tc100_alarm_code_text(INT64_C(7))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(7))->name, "eeprom_error") && same_text(tc100_alarm_code_text(INT64_C(7))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(8)) != NULL && tc100_alarm_code_text(INT64_C(8))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(8))->name, "main_circuit_undervoltage") && same_text(tc100_alarm_code_text(INT64_C(8))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(9)) != NULL && tc100_alarm_code_text(INT64_C(9))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(9))->name, "overcurrent") && same_text(tc100_alarm_code_text(INT64_C(9))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(10)) != NULL && tc100_alarm_code_text(INT64_C(10))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(10))->name, "regeneration_error") && same_text(tc100_alarm_code_text(INT64_C(10))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(11)) != NULL && tc100_alarm_code_text(INT64_C(11))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(11))->name, "emergency_stop") && same_text(tc100_alarm_code_text(INT64_C(11))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(12)) != NULL && tc100_alarm_code_text(INT64_C(12))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(12))->name, "motor_disconnected") && same_text(tc100_alarm_code_text(INT64_C(12))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(13)) != NULL && tc100_alarm_code_text(INT64_C(13))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(13))->name, "encoder_disconnected") && same_text(tc100_alarm_code_text(INT64_C(13))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(14)) != NULL && tc100_alarm_code_text(INT64_C(14))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(14))->name, "current_protection") && same_text(tc100_alarm_code_text(INT64_C(14))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(15)) != NULL && tc100_alarm_code_text(INT64_C(15))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(15))->name, "power_cycle_required") && same_text(tc100_alarm_code_text(INT64_C(15))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(17)) != NULL && tc100_alarm_code_text(INT64_C(17))->number == (-INT64_C(1)) && same_text(tc100_alarm_code_text(INT64_C(17))->name, "action_timeout") && same_text(tc100_alarm_code_text(INT64_C(17))->printed, ""), "tc100_alarm_code_text");
    expect(tc100_alarm_code_text(INT64_C(16)) == NULL, "tc100_alarm_code_text");
    expect(tc100_fault_code_text(INT64_C(0)) != NULL && tc100_fault_code_text(INT64_C(0))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(0))->name, "no_fault") && same_text(tc100_fault_code_text(INT64_C(0))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(1)) != NULL && tc100_fault_code_text(INT64_C(1))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(1))->name, "motion_command_while_moving") && same_text(tc100_fault_code_text(INT64_C(1))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(2)) != NULL && tc100_fault_code_text(INT64_C(2))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(2))->name, "value_out_of_limits") && same_text(tc100_fault_code_text(INT64_C(2))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(3)) != NULL && tc100_fault_code_text(INT64_C(3))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(3))->name, "address_error") && same_text(tc100_fault_code_text(INT64_C(3))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(4)) != NULL && tc100_fault_code_text(INT64_C(4))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(4))->name, "format_error") && same_text(tc100_fault_code_text(INT64_C(4))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(5)) != NULL && tc100_fault_code_text(INT64_C(5))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(5))->name, "control_mode_error") && same_text(tc100_fault_code_text(INT64_C(5))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(6)) != NULL && tc100_fault_code_text(INT64_C(6))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(6))->name, "power_cycle_required") && same_text(tc100_fault_code_text(INT64_C(6))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(7)) != NULL && tc100_fault_code_text(INT64_C(7))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(7))->name, "initialization_incomplete") && same_text(tc100_fault_code_text(INT64_C(7))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(8)) != NULL && tc100_fault_code_text(INT64_C(8))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(8))->name, "servo_on_off_error") && same_text(tc100_fault_code_text(INT64_C(8))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(9)) != NULL && tc100_fault_code_text(INT64_C(9))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(9))->name, "lock_active") && same_text(tc100_fault_code_text(INT64_C(9))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(10)) != NULL && tc100_fault_code_text(INT64_C(10))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(10))->name, "soft_limit_reached") && same_text(tc100_fault_code_text(INT64_C(10))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(11)) != NULL && tc100_fault_code_text(INT64_C(11))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(11))->name, "parameter_write_not_permitted") && same_text(tc100_fault_code_text(INT64_C(11))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(12)) != NULL && tc100_fault_code_text(INT64_C(12))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(12))->name, "homing_incomplete") && same_text(tc100_fault_code_text(INT64_C(12))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(13)) != NULL && tc100_fault_code_text(INT64_C(13))->number == (-INT64_C(1)) && same_text(tc100_fault_code_text(INT64_C(13))->name, "brake_released") && same_text(tc100_fault_code_text(INT64_C(13))->printed, ""), "tc100_fault_code_text");
    expect(tc100_fault_code_text(INT64_C(14)) == NULL, "tc100_fault_code_text");
}

static void test_3(void)
{
    expect(TC100_READ_REGISTERS_CODE == 3u, "TC100_READ_REGISTERS_CODE");
    expect(TC100_WRITE_REGISTER_CODE == 6u, "TC100_WRITE_REGISTER_CODE");
    expect(TC100_WRITE_REGISTERS_CODE == 16u, "TC100_WRITE_REGISTERS_CODE");
}

static void test_4(void)
{
    expect(TC100_REG_JOG_POSITIVE_INPUT_ADDRESS == 1537u, "TC100_REG_JOG_POSITIVE_INPUT_ADDRESS");
    expect(TC100_REG_JOG_NEGATIVE_INPUT_ADDRESS == 1538u, "TC100_REG_JOG_NEGATIVE_INPUT_ADDRESS");
    expect(TC100_REG_MANUAL_MODE_INPUT_ADDRESS == 1539u, "TC100_REG_MANUAL_MODE_INPUT_ADDRESS");
    expect(TC100_REG_TEACH_INPUT_ADDRESS == 1540u, "TC100_REG_TEACH_INPUT_ADDRESS");
    expect(TC100_REG_LOCK_INPUT_ADDRESS == 1543u, "TC100_REG_LOCK_INPUT_ADDRESS");
    expect(TC100_REG_POINT_SELECT_BIT_4_INPUT_ADDRESS == 1550u, "TC100_REG_POINT_SELECT_BIT_4_INPUT_ADDRESS");
    expect(TC100_REG_POINT_SELECT_BIT_5_INPUT_ADDRESS == 1551u, "TC100_REG_POINT_SELECT_BIT_5_INPUT_ADDRESS");
    expect(TC100_REG_POINT_SELECT_BIT_6_INPUT_ADDRESS == 1552u, "TC100_REG_POINT_SELECT_BIT_6_INPUT_ADDRESS");
    expect(TC100_REG_HOMING_SENSOR_INPUT_ADDRESS == 1553u, "TC100_REG_HOMING_SENSOR_INPUT_ADDRESS");
    expect(TC100_REG_BRAKE_INPUT_ADDRESS == 1554u, "TC100_REG_BRAKE_INPUT_ADDRESS");
    expect(TC100_REG_FULL_COUNT_INPUT_ADDRESS == 1555u, "TC100_REG_FULL_COUNT_INPUT_ADDRESS");
    expect(TC100_REG_IN_POSITION_OUTPUT_ADDRESS == 1792u, "TC100_REG_IN_POSITION_OUTPUT_ADDRESS");
    expect(TC100_REG_ALARM_OUTPUT_ADDRESS == 1793u, "TC100_REG_ALARM_OUTPUT_ADDRESS");
    expect(TC100_REG_READY_OUTPUT_ADDRESS == 1794u, "TC100_REG_READY_OUTPUT_ADDRESS");
    expect(TC100_REG_MOVING_OUTPUT_ADDRESS == 1795u, "TC100_REG_MOVING_OUTPUT_ADDRESS");
    expect(TC100_REG_SERVO_ON_OUTPUT_ADDRESS == 1797u, "TC100_REG_SERVO_ON_OUTPUT_ADDRESS");
    expect(TC100_REG_POINT_SELECT_BIT_0_OUTPUT_ADDRESS == 1798u, "TC100_REG_POINT_SELECT_BIT_0_OUTPUT_ADDRESS");
    expect(TC100_REG_POINT_SELECT_BIT_1_OUTPUT_ADDRESS == 1799u, "TC100_REG_POINT_SELECT_BIT_1_OUTPUT_ADDRESS");
    expect(TC100_REG_POINT_SELECT_BIT_2_OUTPUT_ADDRESS == 1800u, "TC100_REG_POINT_SELECT_BIT_2_OUTPUT_ADDRESS");
    expect(TC100_REG_POINT_SELECT_BIT_3_OUTPUT_ADDRESS == 1801u, "TC100_REG_POINT_SELECT_BIT_3_OUTPUT_ADDRESS");
    expect(TC100_REG_POINT_SELECT_BIT_4_OUTPUT_ADDRESS == 1802u, "TC100_REG_POINT_SELECT_BIT_4_OUTPUT_ADDRESS");
    expect(TC100_REG_POINT_SELECT_BIT_5_OUTPUT_ADDRESS == 1803u, "TC100_REG_POINT_SELECT_BIT_5_OUTPUT_ADDRESS");
    expect(TC100_REG_POINT_SELECT_BIT_6_OUTPUT_ADDRESS == 1804u, "TC100_REG_POINT_SELECT_BIT_6_OUTPUT_ADDRESS");
    expect(TC100_REG_TORQUE_LIMIT_OUTPUT_ADDRESS == 1805u, "TC100_REG_TORQUE_LIMIT_OUTPUT_ADDRESS");
    expect(TC100_REG_ERROR_BIT_0_OUTPUT_ADDRESS == 1806u, "TC100_REG_ERROR_BIT_0_OUTPUT_ADDRESS");
    expect(TC100_REG_ERROR_BIT_1_OUTPUT_ADDRESS == 1807u, "TC100_REG_ERROR_BIT_1_OUTPUT_ADDRESS");
    expect(TC100_REG_ERROR_BIT_2_OUTPUT_ADDRESS == 1808u, "TC100_REG_ERROR_BIT_2_OUTPUT_ADDRESS");
    expect(TC100_REG_ERROR_BIT_3_OUTPUT_ADDRESS == 1809u, "TC100_REG_ERROR_BIT_3_OUTPUT_ADDRESS");
    expect(TC100_REG_ZONE_OUTPUT_ADDRESS == 1810u, "TC100_REG_ZONE_OUTPUT_ADDRESS");
    expect(TC100_REG_NEAR_OUTPUT_ADDRESS == 1811u, "TC100_REG_NEAR_OUTPUT_ADDRESS");
    expect(TC100_REG_SOFT_LIMIT_OUTPUT_ADDRESS == 1812u, "TC100_REG_SOFT_LIMIT_OUTPUT_ADDRESS");
    expect(TC100_REG_RELATIVE_DISTANCE_ADDRESS == 8192u, "TC100_REG_RELATIVE_DISTANCE_ADDRESS");
    expect(TC100_REG_ABSOLUTE_POSITION_ADDRESS == 8194u, "TC100_REG_ABSOLUTE_POSITION_ADDRESS");
    expect(TC100_REG_TORQUE_SEARCH_DIRECTION_ADDRESS == 8197u, "TC100_REG_TORQUE_SEARCH_DIRECTION_ADDRESS");
    expect(TC100_REG_PRESET_POSITION_ADDRESS == 8198u, "TC100_REG_PRESET_POSITION_ADDRESS");
    expect(TC100_REG_SERVO_ADDRESS == 8209u, "TC100_REG_SERVO_ADDRESS");
    expect(TC100_REG_MOTION_SPEED_ADDRESS == 8212u, "TC100_REG_MOTION_SPEED_ADDRESS");
    expect(TC100_REG_MOTION_COMMAND_ADDRESS == 8222u, "TC100_REG_MOTION_COMMAND_ADDRESS");
    expect(TC100_REG_SIMULATED_INPUTS_ADDRESS == 8256u, "TC100_REG_SIMULATED_INPUTS_ADDRESS");
    expect(TC100_REG_SIMULATED_INPUT_ADDRESS == 8257u, "TC100_REG_SIMULATED_INPUT_ADDRESS");
    expect(TC100_REG_PARAMETER_STORAGE_ADDRESS == 39321u, "TC100_REG_PARAMETER_STORAGE_ADDRESS");
    expect(TC100_REG_WRITE_ENABLE_KEY_ADDRESS == 39323u, "TC100_REG_WRITE_ENABLE_KEY_ADDRESS");
    expect(TC100_REG_FULL_COUNT_LIMIT_ADDRESS == 264u, "TC100_REG_FULL_COUNT_LIMIT_ADDRESS");
    expect(TC100_REG_IN_POSITION_ZONE_ADDRESS == 266u, "TC100_REG_IN_POSITION_ZONE_ADDRESS");
    expect(TC100_REG_ELECTRONIC_GEAR_NUMERATOR_ADDRESS == 267u, "TC100_REG_ELECTRONIC_GEAR_NUMERATOR_ADDRESS");
    expect(TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_ADDRESS == 268u, "TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_ADDRESS");
    expect(TC100_REG_PULSE_ROTATION_DIRECTION_ADDRESS == 276u, "TC100_REG_PULSE_ROTATION_DIRECTION_ADDRESS");
    expect(TC100_REG_PULSE_INPUT_FORM_ADDRESS == 277u, "TC100_REG_PULSE_INPUT_FORM_ADDRESS");
    expect(TC100_REG_NEAR_ZONE_ADDRESS == 285u, "TC100_REG_NEAR_ZONE_ADDRESS");
    expect(TC100_REG_PUSH_TORQUE_POSITIVE_ADDRESS == 1024u, "TC100_REG_PUSH_TORQUE_POSITIVE_ADDRESS");
    expect(TC100_REG_PUSH_TORQUE_NEGATIVE_ADDRESS == 1025u, "TC100_REG_PUSH_TORQUE_NEGATIVE_ADDRESS");
    expect(TC100_REG_TORQUE_LIMIT_TIME_ADDRESS == 1026u, "TC100_REG_TORQUE_LIMIT_TIME_ADDRESS");
    expect(TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_ADDRESS == 1030u, "TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_ADDRESS");
    expect(TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ADDRESS == 1031u, "TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ADDRESS");
    expect(TC100_REG_MAXIMUM_TORQUE_ADDRESS == 1280u, "TC100_REG_MAXIMUM_TORQUE_ADDRESS");
    expect(TC100_REG_FULL_TORQUE_TIME_ADDRESS == 1281u, "TC100_REG_FULL_TORQUE_TIME_ADDRESS");
    expect(TC100_REG_CONTROL_MODE_ADDRESS == 1283u, "TC100_REG_CONTROL_MODE_ADDRESS");
    expect(TC100_REG_SERVO_AT_POWER_ON_ADDRESS == 1301u, "TC100_REG_SERVO_AT_POWER_ON_ADDRESS");
    expect(TC100_REG_HOMING_REQUIRED_ADDRESS == 1307u, "TC100_REG_HOMING_REQUIRED_ADDRESS");
    expect(TC100_REG_TOTAL_REVOLUTIONS_ENABLED_ADDRESS == 1310u, "TC100_REG_TOTAL_REVOLUTIONS_ENABLED_ADDRESS");
    expect(TC100_REG_START_SPEED_ADDRESS == 2048u, "TC100_REG_START_SPEED_ADDRESS");
    expect(TC100_REG_MAXIMUM_SPEED_ADDRESS == 2050u, "TC100_REG_MAXIMUM_SPEED_ADDRESS");
    expect(TC100_REG_ACCELERATION_TIME_ADDRESS == 2052u, "TC100_REG_ACCELERATION_TIME_ADDRESS");
    expect(TC100_REG_DECELERATION_TIME_ADDRESS == 2053u, "TC100_REG_DECELERATION_TIME_ADDRESS");
    expect(TC100_REG_TORQUE_LIMIT_PRESS_DISTANCE_ADDRESS == 2055u, "TC100_REG_TORQUE_LIMIT_PRESS_DISTANCE_ADDRESS");
    expect(TC100_REG_MOVING_STATE_RULE_ADDRESS == 2058u, "TC100_REG_MOVING_STATE_RULE_ADDRESS");
    expect(TC100_REG_JOG_SPEED_ADDRESS == 2063u, "TC100_REG_JOG_SPEED_ADDRESS");
    expect(TC100_REG_JOG_DISTANCE_ADDRESS == 2064u, "TC100_REG_JOG_DISTANCE_ADDRESS");
    expect(TC100_REG_JOG_WAIT_TIME_ADDRESS == 2066u, "TC100_REG_JOG_WAIT_TIME_ADDRESS");
    expect(TC100_REG_SOFT_LIMIT_POSITIVE_ADDRESS == 2067u, "TC100_REG_SOFT_LIMIT_POSITIVE_ADDRESS");
    expect(TC100_REG_SOFT_LIMIT_NEGATIVE_ADDRESS == 2069u, "TC100_REG_SOFT_LIMIT_NEGATIVE_ADDRESS");
    expect(TC100_REG_HOMING_MODE_ADDRESS == 2304u, "TC100_REG_HOMING_MODE_ADDRESS");
    expect(TC100_REG_HOMING_SPEED_ADDRESS == 2305u, "TC100_REG_HOMING_SPEED_ADDRESS");
    expect(TC100_REG_HOMING_OFFSET_ADDRESS == 2306u, "TC100_REG_HOMING_OFFSET_ADDRESS");
    expect(TC100_REG_HOMING_OFFSET_SPEED_ADDRESS == 2308u, "TC100_REG_HOMING_OFFSET_SPEED_ADDRESS");
    expect(TC100_REG_HOMING_POSITION_ADDRESS == 2309u, "TC100_REG_HOMING_POSITION_ADDRESS");
    expect(TC100_REG_HOMING_TORQUE_LIMIT_ADDRESS == 2311u, "TC100_REG_HOMING_TORQUE_LIMIT_ADDRESS");
    expect(TC100_REG_HOMING_Z_PHASE_OFFSET_ADDRESS == 2312u, "TC100_REG_HOMING_Z_PHASE_OFFSET_ADDRESS");
    expect(TC100_REG_HOMING_TORQUE_LIMIT_TIME_ADDRESS == 2314u, "TC100_REG_HOMING_TORQUE_LIMIT_TIME_ADDRESS");
    expect(TC100_REG_HOMING_Z_PHASE_SPEED_1_ADDRESS == 2315u, "TC100_REG_HOMING_Z_PHASE_SPEED_1_ADDRESS");
    expect(TC100_REG_HOMING_Z_PHASE_SPEED_2_ADDRESS == 2316u, "TC100_REG_HOMING_Z_PHASE_SPEED_2_ADDRESS");
    expect(TC100_REG_BAUD_RATE_ADDRESS == 2560u, "TC100_REG_BAUD_RATE_ADDRESS");
    expect(TC100_REG_DATA_BITS_ADDRESS == 2561u, "TC100_REG_DATA_BITS_ADDRESS");
    expect(TC100_REG_PARITY_ADDRESS == 2562u, "TC100_REG_PARITY_ADDRESS");
    expect(TC100_REG_BROADCAST_ENABLED_ADDRESS == 2563u, "TC100_REG_BROADCAST_ENABLED_ADDRESS");
    expect(TC100_REG_PROTOCOL_ADDRESS == 2564u, "TC100_REG_PROTOCOL_ADDRESS");
    expect(TC100_REG_ACTION_STATUS_ADDRESS == 4096u, "TC100_REG_ACTION_STATUS_ADDRESS");
    expect(TC100_REG_IN_POSITION_ADDRESS == 4097u, "TC100_REG_IN_POSITION_ADDRESS");
    expect(TC100_REG_TORQUE_LIMIT_REACHED_ADDRESS == 4100u, "TC100_REG_TORQUE_LIMIT_REACHED_ADDRESS");
    expect(TC100_REG_ALARM_ADDRESS == 4101u, "TC100_REG_ALARM_ADDRESS");
    expect(TC100_REG_MOTOR_SPEED_ADDRESS == 4102u, "TC100_REG_MOTOR_SPEED_ADDRESS");
    expect(TC100_REG_MOTOR_CURRENT_ADDRESS == 4103u, "TC100_REG_MOTOR_CURRENT_ADDRESS");
    expect(TC100_REG_COMMAND_POSITION_ADDRESS == 4104u, "TC100_REG_COMMAND_POSITION_ADDRESS");
    expect(TC100_REG_ENCODER_POSITION_ADDRESS == 4106u, "TC100_REG_ENCODER_POSITION_ADDRESS");
    expect(TC100_REG_SERVO_ON_ADDRESS == 4108u, "TC100_REG_SERVO_ON_ADDRESS");
    expect(TC100_REG_FAULT_ADDRESS == 4109u, "TC100_REG_FAULT_ADDRESS");
    expect(TC100_REG_EXECUTED_POINT_ADDRESS == 4110u, "TC100_REG_EXECUTED_POINT_ADDRESS");
    expect(TC100_REG_OUTPUT_STATES_ADDRESS == 4128u, "TC100_REG_OUTPUT_STATES_ADDRESS");
    expect(TC100_REG_OUTPUT_STATE_ADDRESS == 4129u, "TC100_REG_OUTPUT_STATE_ADDRESS");
    expect(TC100_REG_INPUT_STATES_ADDRESS == 4160u, "TC100_REG_INPUT_STATES_ADDRESS");
    expect(TC100_REG_INPUT_STATE_ADDRESS == 4161u, "TC100_REG_INPUT_STATE_ADDRESS");
    expect(TC100_REG_Z_PHASE_STATE_ADDRESS == 4175u, "TC100_REG_Z_PHASE_STATE_ADDRESS");
    expect(TC100_REG_ALARM_HISTORY_ADDRESS == 4192u, "TC100_REG_ALARM_HISTORY_ADDRESS");
    expect(TC100_REG_MOTOR_TYPE_ADDRESS == 4304u, "TC100_REG_MOTOR_TYPE_ADDRESS");
    expect(TC100_REG_CONTROLLER_TYPE_ADDRESS == 4320u, "TC100_REG_CONTROLLER_TYPE_ADDRESS");
    expect(TC100_REG_FIRMWARE_VERSION_ADDRESS == 4336u, "TC100_REG_FIRMWARE_VERSION_ADDRESS");
    {
        uint16_t address = 0;
        expect(tc100_table_points_at(127u, &address) == TC100_OK, "tc100_table_points_at last");
        expect(address == 38896u, "tc100_table_points_at last address");
        expect(tc100_table_points_at(128u, &address) == TC100_ERR_OUT_OF_RANGE, "tc100_table_points_at beyond");
        (void)address;
    }
}

static void test_5(void)
{
    static const uint8_t wanted[] = {0x03};
    uint8_t bytes[TC100_EXCEPTION_SIZE];
    tc100_exception in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.exception_code = 3u;
    copy(&in, &in, sizeof in);
    expect(tc100_exception_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "exception.exception_code encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "exception.exception_code bytes");
    expect(tc100_exception_decode(bytes, length, &out) == TC100_OK, "exception.exception_code decodes");
    expect(out.exception_code == 3u, "exception.exception_code: exception_code");
    expect(tc100_exception_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "exception.exception_code short");
    expect(tc100_exception_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "exception.exception_code cut");
}

static void test_6(void)
{
    static const uint8_t wanted[] = {0x00, 0x10, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[TC100_POINT_SIZE];
    tc100_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 16u;
    in.position = (-2147483647 - 1);
    in.speed = 0u;
    in.torque_limit = 0u;
    in.zone_lower_limit = 0;
    in.zone_upper_limit = 0;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.wait_time = 0u;
    in.next_point = (-1);
    copy(&in, &in, sizeof in);
    expect(tc100_point_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "point.mode encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.mode bytes");
    expect(tc100_point_decode(bytes, length, &out) == TC100_OK, "point.mode decodes");
    expect(out.mode == 16u, "point.mode: mode");
    expect(out.position == (-2147483647 - 1), "point.mode: position");
    expect(out.speed == 0u, "point.mode: speed");
    expect(out.torque_limit == 0u, "point.mode: torque_limit");
    expect(out.zone_lower_limit == 0, "point.mode: zone_lower_limit");
    expect(out.zone_upper_limit == 0, "point.mode: zone_upper_limit");
    expect(out.acceleration_time == 1u, "point.mode: acceleration_time");
    expect(out.deceleration_time == 1u, "point.mode: deceleration_time");
    expect(out.wait_time == 0u, "point.mode: wait_time");
    expect(out.next_point == (-1), "point.mode: next_point");
    expect(tc100_point_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "point.mode short");
    expect(tc100_point_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "point.mode cut");
}

static void test_7(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[TC100_POINT_SIZE];
    tc100_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 0u;
    in.position = 2147483647;
    in.speed = 0u;
    in.torque_limit = 0u;
    in.zone_lower_limit = 0;
    in.zone_upper_limit = 0;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.wait_time = 0u;
    in.next_point = (-1);
    copy(&in, &in, sizeof in);
    expect(tc100_point_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "point.position encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.position bytes");
    expect(tc100_point_decode(bytes, length, &out) == TC100_OK, "point.position decodes");
    expect(out.mode == 0u, "point.position: mode");
    expect(out.position == 2147483647, "point.position: position");
    expect(out.speed == 0u, "point.position: speed");
    expect(out.torque_limit == 0u, "point.position: torque_limit");
    expect(out.zone_lower_limit == 0, "point.position: zone_lower_limit");
    expect(out.zone_upper_limit == 0, "point.position: zone_upper_limit");
    expect(out.acceleration_time == 1u, "point.position: acceleration_time");
    expect(out.deceleration_time == 1u, "point.position: deceleration_time");
    expect(out.wait_time == 0u, "point.position: wait_time");
    expect(out.next_point == (-1), "point.position: next_point");
    expect(tc100_point_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "point.position short");
    expect(tc100_point_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "point.position cut");
}

static void test_8(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x64, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[TC100_POINT_SIZE];
    tc100_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 0u;
    in.position = (-2147483647 - 1);
    in.speed = 100u;
    in.torque_limit = 0u;
    in.zone_lower_limit = 0;
    in.zone_upper_limit = 0;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.wait_time = 0u;
    in.next_point = (-1);
    copy(&in, &in, sizeof in);
    expect(tc100_point_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "point.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.speed bytes");
    expect(tc100_point_decode(bytes, length, &out) == TC100_OK, "point.speed decodes");
    expect(out.mode == 0u, "point.speed: mode");
    expect(out.position == (-2147483647 - 1), "point.speed: position");
    expect(out.speed == 100u, "point.speed: speed");
    expect(out.torque_limit == 0u, "point.speed: torque_limit");
    expect(out.zone_lower_limit == 0, "point.speed: zone_lower_limit");
    expect(out.zone_upper_limit == 0, "point.speed: zone_upper_limit");
    expect(out.acceleration_time == 1u, "point.speed: acceleration_time");
    expect(out.deceleration_time == 1u, "point.speed: deceleration_time");
    expect(out.wait_time == 0u, "point.speed: wait_time");
    expect(out.next_point == (-1), "point.speed: next_point");
    expect(tc100_point_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "point.speed short");
    expect(tc100_point_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "point.speed cut");
}

static void test_9(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x03, 0xE8, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[TC100_POINT_SIZE];
    tc100_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 0u;
    in.position = (-2147483647 - 1);
    in.speed = 0u;
    in.torque_limit = 1000u;
    in.zone_lower_limit = 0;
    in.zone_upper_limit = 0;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.wait_time = 0u;
    in.next_point = (-1);
    copy(&in, &in, sizeof in);
    expect(tc100_point_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "point.torque_limit encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.torque_limit bytes");
    expect(tc100_point_decode(bytes, length, &out) == TC100_OK, "point.torque_limit decodes");
    expect(out.mode == 0u, "point.torque_limit: mode");
    expect(out.position == (-2147483647 - 1), "point.torque_limit: position");
    expect(out.speed == 0u, "point.torque_limit: speed");
    expect(out.torque_limit == 1000u, "point.torque_limit: torque_limit");
    expect(out.zone_lower_limit == 0, "point.torque_limit: zone_lower_limit");
    expect(out.zone_upper_limit == 0, "point.torque_limit: zone_upper_limit");
    expect(out.acceleration_time == 1u, "point.torque_limit: acceleration_time");
    expect(out.deceleration_time == 1u, "point.torque_limit: deceleration_time");
    expect(out.wait_time == 0u, "point.torque_limit: wait_time");
    expect(out.next_point == (-1), "point.torque_limit: next_point");
    expect(tc100_point_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "point.torque_limit short");
    expect(tc100_point_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "point.torque_limit cut");
}

static void test_10(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[TC100_POINT_SIZE];
    tc100_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 0u;
    in.position = (-2147483647 - 1);
    in.speed = 0u;
    in.torque_limit = 0u;
    in.zone_lower_limit = 2147483647;
    in.zone_upper_limit = 0;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.wait_time = 0u;
    in.next_point = (-1);
    copy(&in, &in, sizeof in);
    expect(tc100_point_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "point.zone_lower_limit encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.zone_lower_limit bytes");
    expect(tc100_point_decode(bytes, length, &out) == TC100_OK, "point.zone_lower_limit decodes");
    expect(out.mode == 0u, "point.zone_lower_limit: mode");
    expect(out.position == (-2147483647 - 1), "point.zone_lower_limit: position");
    expect(out.speed == 0u, "point.zone_lower_limit: speed");
    expect(out.torque_limit == 0u, "point.zone_lower_limit: torque_limit");
    expect(out.zone_lower_limit == 2147483647, "point.zone_lower_limit: zone_lower_limit");
    expect(out.zone_upper_limit == 0, "point.zone_lower_limit: zone_upper_limit");
    expect(out.acceleration_time == 1u, "point.zone_lower_limit: acceleration_time");
    expect(out.deceleration_time == 1u, "point.zone_lower_limit: deceleration_time");
    expect(out.wait_time == 0u, "point.zone_lower_limit: wait_time");
    expect(out.next_point == (-1), "point.zone_lower_limit: next_point");
    expect(tc100_point_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "point.zone_lower_limit short");
    expect(tc100_point_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "point.zone_lower_limit cut");
}

static void test_11(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[TC100_POINT_SIZE];
    tc100_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 0u;
    in.position = (-2147483647 - 1);
    in.speed = 0u;
    in.torque_limit = 0u;
    in.zone_lower_limit = 0;
    in.zone_upper_limit = 2147483647;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.wait_time = 0u;
    in.next_point = (-1);
    copy(&in, &in, sizeof in);
    expect(tc100_point_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "point.zone_upper_limit encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.zone_upper_limit bytes");
    expect(tc100_point_decode(bytes, length, &out) == TC100_OK, "point.zone_upper_limit decodes");
    expect(out.mode == 0u, "point.zone_upper_limit: mode");
    expect(out.position == (-2147483647 - 1), "point.zone_upper_limit: position");
    expect(out.speed == 0u, "point.zone_upper_limit: speed");
    expect(out.torque_limit == 0u, "point.zone_upper_limit: torque_limit");
    expect(out.zone_lower_limit == 0, "point.zone_upper_limit: zone_lower_limit");
    expect(out.zone_upper_limit == 2147483647, "point.zone_upper_limit: zone_upper_limit");
    expect(out.acceleration_time == 1u, "point.zone_upper_limit: acceleration_time");
    expect(out.deceleration_time == 1u, "point.zone_upper_limit: deceleration_time");
    expect(out.wait_time == 0u, "point.zone_upper_limit: wait_time");
    expect(out.next_point == (-1), "point.zone_upper_limit: next_point");
    expect(tc100_point_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "point.zone_upper_limit short");
    expect(tc100_point_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "point.zone_upper_limit cut");
}

static void test_12(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x75, 0x30, 0x00, 0x01, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[TC100_POINT_SIZE];
    tc100_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 0u;
    in.position = (-2147483647 - 1);
    in.speed = 0u;
    in.torque_limit = 0u;
    in.zone_lower_limit = 0;
    in.zone_upper_limit = 0;
    in.acceleration_time = 30000u;
    in.deceleration_time = 1u;
    in.wait_time = 0u;
    in.next_point = (-1);
    copy(&in, &in, sizeof in);
    expect(tc100_point_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "point.acceleration_time encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.acceleration_time bytes");
    expect(tc100_point_decode(bytes, length, &out) == TC100_OK, "point.acceleration_time decodes");
    expect(out.mode == 0u, "point.acceleration_time: mode");
    expect(out.position == (-2147483647 - 1), "point.acceleration_time: position");
    expect(out.speed == 0u, "point.acceleration_time: speed");
    expect(out.torque_limit == 0u, "point.acceleration_time: torque_limit");
    expect(out.zone_lower_limit == 0, "point.acceleration_time: zone_lower_limit");
    expect(out.zone_upper_limit == 0, "point.acceleration_time: zone_upper_limit");
    expect(out.acceleration_time == 30000u, "point.acceleration_time: acceleration_time");
    expect(out.deceleration_time == 1u, "point.acceleration_time: deceleration_time");
    expect(out.wait_time == 0u, "point.acceleration_time: wait_time");
    expect(out.next_point == (-1), "point.acceleration_time: next_point");
    expect(tc100_point_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "point.acceleration_time short");
    expect(tc100_point_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "point.acceleration_time cut");
}

static void test_13(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x75, 0x30, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[TC100_POINT_SIZE];
    tc100_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 0u;
    in.position = (-2147483647 - 1);
    in.speed = 0u;
    in.torque_limit = 0u;
    in.zone_lower_limit = 0;
    in.zone_upper_limit = 0;
    in.acceleration_time = 1u;
    in.deceleration_time = 30000u;
    in.wait_time = 0u;
    in.next_point = (-1);
    copy(&in, &in, sizeof in);
    expect(tc100_point_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "point.deceleration_time encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.deceleration_time bytes");
    expect(tc100_point_decode(bytes, length, &out) == TC100_OK, "point.deceleration_time decodes");
    expect(out.mode == 0u, "point.deceleration_time: mode");
    expect(out.position == (-2147483647 - 1), "point.deceleration_time: position");
    expect(out.speed == 0u, "point.deceleration_time: speed");
    expect(out.torque_limit == 0u, "point.deceleration_time: torque_limit");
    expect(out.zone_lower_limit == 0, "point.deceleration_time: zone_lower_limit");
    expect(out.zone_upper_limit == 0, "point.deceleration_time: zone_upper_limit");
    expect(out.acceleration_time == 1u, "point.deceleration_time: acceleration_time");
    expect(out.deceleration_time == 30000u, "point.deceleration_time: deceleration_time");
    expect(out.wait_time == 0u, "point.deceleration_time: wait_time");
    expect(out.next_point == (-1), "point.deceleration_time: next_point");
    expect(tc100_point_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "point.deceleration_time short");
    expect(tc100_point_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "point.deceleration_time cut");
}

static void test_14(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x75, 0x30, 0xFF, 0xFF};
    uint8_t bytes[TC100_POINT_SIZE];
    tc100_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 0u;
    in.position = (-2147483647 - 1);
    in.speed = 0u;
    in.torque_limit = 0u;
    in.zone_lower_limit = 0;
    in.zone_upper_limit = 0;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.wait_time = 30000u;
    in.next_point = (-1);
    copy(&in, &in, sizeof in);
    expect(tc100_point_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "point.wait_time encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.wait_time bytes");
    expect(tc100_point_decode(bytes, length, &out) == TC100_OK, "point.wait_time decodes");
    expect(out.mode == 0u, "point.wait_time: mode");
    expect(out.position == (-2147483647 - 1), "point.wait_time: position");
    expect(out.speed == 0u, "point.wait_time: speed");
    expect(out.torque_limit == 0u, "point.wait_time: torque_limit");
    expect(out.zone_lower_limit == 0, "point.wait_time: zone_lower_limit");
    expect(out.zone_upper_limit == 0, "point.wait_time: zone_upper_limit");
    expect(out.acceleration_time == 1u, "point.wait_time: acceleration_time");
    expect(out.deceleration_time == 1u, "point.wait_time: deceleration_time");
    expect(out.wait_time == 30000u, "point.wait_time: wait_time");
    expect(out.next_point == (-1), "point.wait_time: next_point");
    expect(tc100_point_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "point.wait_time short");
    expect(tc100_point_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "point.wait_time cut");
}

static void test_15(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x7F};
    uint8_t bytes[TC100_POINT_SIZE];
    tc100_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 0u;
    in.position = (-2147483647 - 1);
    in.speed = 0u;
    in.torque_limit = 0u;
    in.zone_lower_limit = 0;
    in.zone_upper_limit = 0;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.wait_time = 0u;
    in.next_point = 127;
    copy(&in, &in, sizeof in);
    expect(tc100_point_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "point.next_point encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.next_point bytes");
    expect(tc100_point_decode(bytes, length, &out) == TC100_OK, "point.next_point decodes");
    expect(out.mode == 0u, "point.next_point: mode");
    expect(out.position == (-2147483647 - 1), "point.next_point: position");
    expect(out.speed == 0u, "point.next_point: speed");
    expect(out.torque_limit == 0u, "point.next_point: torque_limit");
    expect(out.zone_lower_limit == 0, "point.next_point: zone_lower_limit");
    expect(out.zone_upper_limit == 0, "point.next_point: zone_upper_limit");
    expect(out.acceleration_time == 1u, "point.next_point: acceleration_time");
    expect(out.deceleration_time == 1u, "point.next_point: deceleration_time");
    expect(out.wait_time == 0u, "point.next_point: wait_time");
    expect(out.next_point == 127, "point.next_point: next_point");
    expect(tc100_point_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "point.next_point short");
    expect(tc100_point_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "point.next_point cut");
}

static void test_16(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x01};
    uint8_t bytes[TC100_READ_REGISTERS_REQUEST_SIZE];
    tc100_read_registers_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 65535u;
    in.word_count = 1u;
    copy(&in, &in, sizeof in);
    expect(tc100_read_registers_request_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "read_registers_request.address encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_registers_request.address bytes");
    expect(tc100_read_registers_request_decode(bytes, length, &out) == TC100_OK, "read_registers_request.address decodes");
    expect(out.address == 65535u, "read_registers_request.address: address");
    expect(out.word_count == 1u, "read_registers_request.address: word_count");
    expect(tc100_read_registers_request_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "read_registers_request.address short");
    expect(tc100_read_registers_request_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "read_registers_request.address cut");
}

static void test_17(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x3C};
    uint8_t bytes[TC100_READ_REGISTERS_REQUEST_SIZE];
    tc100_read_registers_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 0u;
    in.word_count = 60u;
    copy(&in, &in, sizeof in);
    expect(tc100_read_registers_request_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "read_registers_request.word_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_registers_request.word_count bytes");
    expect(tc100_read_registers_request_decode(bytes, length, &out) == TC100_OK, "read_registers_request.word_count decodes");
    expect(out.address == 0u, "read_registers_request.word_count: address");
    expect(out.word_count == 60u, "read_registers_request.word_count: word_count");
    expect(tc100_read_registers_request_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "read_registers_request.word_count short");
    expect(tc100_read_registers_request_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "read_registers_request.word_count cut");
}

static void test_18(void)
{
    static const uint8_t wanted[] = {0x02, 0xFF, 0xFF};
    uint8_t bytes[TC100_READ_REGISTERS_RESPONSE_SIZE];
    tc100_read_registers_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.values_count = 1u;
    in.values[0] = 65535u;
    copy(&in, &in, sizeof in);
    expect(tc100_read_registers_response_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "read_registers_response.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_registers_response.values bytes");
    expect(tc100_read_registers_response_decode(bytes, length, &out) == TC100_OK, "read_registers_response.values decodes");
    expect(out.values_count == 1u, "read_registers_response.values: values count");
    expect(out.values[0] == 65535u, "read_registers_response.values: values");
    expect(tc100_read_registers_response_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "read_registers_response.values short");
    expect(tc100_read_registers_response_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "read_registers_response.values cut");
}

static void test_19(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x00};
    uint8_t bytes[TC100_WRITE_REGISTER_REQUEST_SIZE];
    tc100_write_register_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 65535u;
    in.value = 0u;
    copy(&in, &in, sizeof in);
    expect(tc100_write_register_request_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "write_register_request.address encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_register_request.address bytes");
    expect(tc100_write_register_request_decode(bytes, length, &out) == TC100_OK, "write_register_request.address decodes");
    expect(out.address == 65535u, "write_register_request.address: address");
    expect(out.value == 0u, "write_register_request.address: value");
    expect(tc100_write_register_request_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "write_register_request.address short");
    expect(tc100_write_register_request_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "write_register_request.address cut");
}

static void test_20(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[TC100_WRITE_REGISTER_REQUEST_SIZE];
    tc100_write_register_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 0u;
    in.value = 65535u;
    copy(&in, &in, sizeof in);
    expect(tc100_write_register_request_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "write_register_request.value encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_register_request.value bytes");
    expect(tc100_write_register_request_decode(bytes, length, &out) == TC100_OK, "write_register_request.value decodes");
    expect(out.address == 0u, "write_register_request.value: address");
    expect(out.value == 65535u, "write_register_request.value: value");
    expect(tc100_write_register_request_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "write_register_request.value short");
    expect(tc100_write_register_request_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "write_register_request.value cut");
}

static void test_21(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x00};
    uint8_t bytes[TC100_WRITE_REGISTER_RESPONSE_SIZE];
    tc100_write_register_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 65535u;
    in.value = 0u;
    copy(&in, &in, sizeof in);
    expect(tc100_write_register_response_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "write_register_response.address encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_register_response.address bytes");
    expect(tc100_write_register_response_decode(bytes, length, &out) == TC100_OK, "write_register_response.address decodes");
    expect(out.address == 65535u, "write_register_response.address: address");
    expect(out.value == 0u, "write_register_response.address: value");
    expect(tc100_write_register_response_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "write_register_response.address short");
    expect(tc100_write_register_response_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "write_register_response.address cut");
}

static void test_22(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[TC100_WRITE_REGISTER_RESPONSE_SIZE];
    tc100_write_register_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 0u;
    in.value = 65535u;
    copy(&in, &in, sizeof in);
    expect(tc100_write_register_response_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "write_register_response.value encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_register_response.value bytes");
    expect(tc100_write_register_response_decode(bytes, length, &out) == TC100_OK, "write_register_response.value decodes");
    expect(out.address == 0u, "write_register_response.value: address");
    expect(out.value == 65535u, "write_register_response.value: value");
    expect(tc100_write_register_response_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "write_register_response.value short");
    expect(tc100_write_register_response_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "write_register_response.value cut");
}

static void test_23(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x01, 0x02, 0x00, 0x00};
    uint8_t bytes[TC100_WRITE_REGISTERS_REQUEST_SIZE];
    tc100_write_registers_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 65535u;
    in.values_count = 1u;
    in.values[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(tc100_write_registers_request_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "write_registers_request.address encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_registers_request.address bytes");
    expect(tc100_write_registers_request_decode(bytes, length, &out) == TC100_OK, "write_registers_request.address decodes");
    expect(out.address == 65535u, "write_registers_request.address: address");
    expect(out.values_count == 1u, "write_registers_request.address: values count");
    expect(out.values[0] == 0u, "write_registers_request.address: values");
    expect(tc100_write_registers_request_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "write_registers_request.address short");
    expect(tc100_write_registers_request_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "write_registers_request.address cut");
}

static void test_24(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x01, 0x02, 0xFF, 0xFF};
    uint8_t bytes[TC100_WRITE_REGISTERS_REQUEST_SIZE];
    tc100_write_registers_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 0u;
    in.values_count = 1u;
    in.values[0] = 65535u;
    copy(&in, &in, sizeof in);
    expect(tc100_write_registers_request_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "write_registers_request.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_registers_request.values bytes");
    expect(tc100_write_registers_request_decode(bytes, length, &out) == TC100_OK, "write_registers_request.values decodes");
    expect(out.address == 0u, "write_registers_request.values: address");
    expect(out.values_count == 1u, "write_registers_request.values: values count");
    expect(out.values[0] == 65535u, "write_registers_request.values: values");
    expect(tc100_write_registers_request_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "write_registers_request.values short");
    expect(tc100_write_registers_request_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "write_registers_request.values cut");
}

static void test_25(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x01};
    uint8_t bytes[TC100_WRITE_REGISTERS_RESPONSE_SIZE];
    tc100_write_registers_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 65535u;
    in.word_count = 1u;
    copy(&in, &in, sizeof in);
    expect(tc100_write_registers_response_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "write_registers_response.address encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_registers_response.address bytes");
    expect(tc100_write_registers_response_decode(bytes, length, &out) == TC100_OK, "write_registers_response.address decodes");
    expect(out.address == 65535u, "write_registers_response.address: address");
    expect(out.word_count == 1u, "write_registers_response.address: word_count");
    expect(tc100_write_registers_response_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "write_registers_response.address short");
    expect(tc100_write_registers_response_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "write_registers_response.address cut");
}

static void test_26(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x3B};
    uint8_t bytes[TC100_WRITE_REGISTERS_RESPONSE_SIZE];
    tc100_write_registers_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 0u;
    in.word_count = 59u;
    copy(&in, &in, sizeof in);
    expect(tc100_write_registers_response_encode(&in, bytes, sizeof bytes, &length) == TC100_OK, "write_registers_response.word_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_registers_response.word_count bytes");
    expect(tc100_write_registers_response_decode(bytes, length, &out) == TC100_OK, "write_registers_response.word_count decodes");
    expect(out.address == 0u, "write_registers_response.word_count: address");
    expect(out.word_count == 59u, "write_registers_response.word_count: word_count");
    expect(tc100_write_registers_response_encode(&in, bytes, sizeof wanted - 1, &length) == TC100_ERR_CAPACITY, "write_registers_response.word_count short");
    expect(tc100_write_registers_response_decode(wanted, sizeof wanted - 1, &out) != TC100_OK, "write_registers_response.word_count cut");
}

static void test_27(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_jog_positive_input_encode(in, bytes) == TC100_OK, "jog_positive_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "jog_positive_input 0 bytes");
    expect(tc100_reg_jog_positive_input_decode(bytes, &out) == TC100_OK, "jog_positive_input 0");
    expect(out == 0u, "jog_positive_input 0");
    in = 65535u;
    expect(tc100_reg_jog_positive_input_encode(in, bytes) == TC100_OK, "jog_positive_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "jog_positive_input 65535 bytes");
    expect(tc100_reg_jog_positive_input_decode(bytes, &out) == TC100_OK, "jog_positive_input 65535");
    expect(out == 65535u, "jog_positive_input 65535");
}

static void test_28(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_jog_negative_input_encode(in, bytes) == TC100_OK, "jog_negative_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "jog_negative_input 0 bytes");
    expect(tc100_reg_jog_negative_input_decode(bytes, &out) == TC100_OK, "jog_negative_input 0");
    expect(out == 0u, "jog_negative_input 0");
    in = 65535u;
    expect(tc100_reg_jog_negative_input_encode(in, bytes) == TC100_OK, "jog_negative_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "jog_negative_input 65535 bytes");
    expect(tc100_reg_jog_negative_input_decode(bytes, &out) == TC100_OK, "jog_negative_input 65535");
    expect(out == 65535u, "jog_negative_input 65535");
}

static void test_29(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_manual_mode_input_encode(in, bytes) == TC100_OK, "manual_mode_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "manual_mode_input 0 bytes");
    expect(tc100_reg_manual_mode_input_decode(bytes, &out) == TC100_OK, "manual_mode_input 0");
    expect(out == 0u, "manual_mode_input 0");
    in = 65535u;
    expect(tc100_reg_manual_mode_input_encode(in, bytes) == TC100_OK, "manual_mode_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "manual_mode_input 65535 bytes");
    expect(tc100_reg_manual_mode_input_decode(bytes, &out) == TC100_OK, "manual_mode_input 65535");
    expect(out == 65535u, "manual_mode_input 65535");
}

static void test_30(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_teach_input_encode(in, bytes) == TC100_OK, "teach_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "teach_input 0 bytes");
    expect(tc100_reg_teach_input_decode(bytes, &out) == TC100_OK, "teach_input 0");
    expect(out == 0u, "teach_input 0");
    in = 65535u;
    expect(tc100_reg_teach_input_encode(in, bytes) == TC100_OK, "teach_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "teach_input 65535 bytes");
    expect(tc100_reg_teach_input_decode(bytes, &out) == TC100_OK, "teach_input 65535");
    expect(out == 65535u, "teach_input 65535");
}

static void test_31(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_lock_input_encode(in, bytes) == TC100_OK, "lock_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "lock_input 0 bytes");
    expect(tc100_reg_lock_input_decode(bytes, &out) == TC100_OK, "lock_input 0");
    expect(out == 0u, "lock_input 0");
    in = 65535u;
    expect(tc100_reg_lock_input_encode(in, bytes) == TC100_OK, "lock_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "lock_input 65535 bytes");
    expect(tc100_reg_lock_input_decode(bytes, &out) == TC100_OK, "lock_input 65535");
    expect(out == 65535u, "lock_input 65535");
}

static void test_32(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_point_select_bit_4_input_encode(in, bytes) == TC100_OK, "point_select_bit_4_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "point_select_bit_4_input 0 bytes");
    expect(tc100_reg_point_select_bit_4_input_decode(bytes, &out) == TC100_OK, "point_select_bit_4_input 0");
    expect(out == 0u, "point_select_bit_4_input 0");
    in = 65535u;
    expect(tc100_reg_point_select_bit_4_input_encode(in, bytes) == TC100_OK, "point_select_bit_4_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "point_select_bit_4_input 65535 bytes");
    expect(tc100_reg_point_select_bit_4_input_decode(bytes, &out) == TC100_OK, "point_select_bit_4_input 65535");
    expect(out == 65535u, "point_select_bit_4_input 65535");
}

static void test_33(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_point_select_bit_5_input_encode(in, bytes) == TC100_OK, "point_select_bit_5_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "point_select_bit_5_input 0 bytes");
    expect(tc100_reg_point_select_bit_5_input_decode(bytes, &out) == TC100_OK, "point_select_bit_5_input 0");
    expect(out == 0u, "point_select_bit_5_input 0");
    in = 65535u;
    expect(tc100_reg_point_select_bit_5_input_encode(in, bytes) == TC100_OK, "point_select_bit_5_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "point_select_bit_5_input 65535 bytes");
    expect(tc100_reg_point_select_bit_5_input_decode(bytes, &out) == TC100_OK, "point_select_bit_5_input 65535");
    expect(out == 65535u, "point_select_bit_5_input 65535");
}

static void test_34(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_point_select_bit_6_input_encode(in, bytes) == TC100_OK, "point_select_bit_6_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "point_select_bit_6_input 0 bytes");
    expect(tc100_reg_point_select_bit_6_input_decode(bytes, &out) == TC100_OK, "point_select_bit_6_input 0");
    expect(out == 0u, "point_select_bit_6_input 0");
    in = 65535u;
    expect(tc100_reg_point_select_bit_6_input_encode(in, bytes) == TC100_OK, "point_select_bit_6_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "point_select_bit_6_input 65535 bytes");
    expect(tc100_reg_point_select_bit_6_input_decode(bytes, &out) == TC100_OK, "point_select_bit_6_input 65535");
    expect(out == 65535u, "point_select_bit_6_input 65535");
}

static void test_35(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_homing_sensor_input_encode(in, bytes) == TC100_OK, "homing_sensor_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "homing_sensor_input 0 bytes");
    expect(tc100_reg_homing_sensor_input_decode(bytes, &out) == TC100_OK, "homing_sensor_input 0");
    expect(out == 0u, "homing_sensor_input 0");
    in = 65535u;
    expect(tc100_reg_homing_sensor_input_encode(in, bytes) == TC100_OK, "homing_sensor_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "homing_sensor_input 65535 bytes");
    expect(tc100_reg_homing_sensor_input_decode(bytes, &out) == TC100_OK, "homing_sensor_input 65535");
    expect(out == 65535u, "homing_sensor_input 65535");
}

static void test_36(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_brake_input_encode(in, bytes) == TC100_OK, "brake_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "brake_input 0 bytes");
    expect(tc100_reg_brake_input_decode(bytes, &out) == TC100_OK, "brake_input 0");
    expect(out == 0u, "brake_input 0");
    in = 65535u;
    expect(tc100_reg_brake_input_encode(in, bytes) == TC100_OK, "brake_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "brake_input 65535 bytes");
    expect(tc100_reg_brake_input_decode(bytes, &out) == TC100_OK, "brake_input 65535");
    expect(out == 65535u, "brake_input 65535");
}

static void test_37(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_full_count_input_encode(in, bytes) == TC100_OK, "full_count_input 0");
    expect(same_bytes(bytes, "\000\000", 2u), "full_count_input 0 bytes");
    expect(tc100_reg_full_count_input_decode(bytes, &out) == TC100_OK, "full_count_input 0");
    expect(out == 0u, "full_count_input 0");
    in = 65535u;
    expect(tc100_reg_full_count_input_encode(in, bytes) == TC100_OK, "full_count_input 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "full_count_input 65535 bytes");
    expect(tc100_reg_full_count_input_decode(bytes, &out) == TC100_OK, "full_count_input 65535");
    expect(out == 65535u, "full_count_input 65535");
}

static void test_38(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_in_position_output_encode(in, bytes) == TC100_OK, "in_position_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "in_position_output 0 bytes");
    expect(tc100_reg_in_position_output_decode(bytes, &out) == TC100_OK, "in_position_output 0");
    expect(out == 0u, "in_position_output 0");
    in = 65535u;
    expect(tc100_reg_in_position_output_encode(in, bytes) == TC100_OK, "in_position_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "in_position_output 65535 bytes");
    expect(tc100_reg_in_position_output_decode(bytes, &out) == TC100_OK, "in_position_output 65535");
    expect(out == 65535u, "in_position_output 65535");
}

static void test_39(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_alarm_output_encode(in, bytes) == TC100_OK, "alarm_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "alarm_output 0 bytes");
    expect(tc100_reg_alarm_output_decode(bytes, &out) == TC100_OK, "alarm_output 0");
    expect(out == 0u, "alarm_output 0");
    in = 65535u;
    expect(tc100_reg_alarm_output_encode(in, bytes) == TC100_OK, "alarm_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "alarm_output 65535 bytes");
    expect(tc100_reg_alarm_output_decode(bytes, &out) == TC100_OK, "alarm_output 65535");
    expect(out == 65535u, "alarm_output 65535");
}

static void test_40(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_ready_output_encode(in, bytes) == TC100_OK, "ready_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "ready_output 0 bytes");
    expect(tc100_reg_ready_output_decode(bytes, &out) == TC100_OK, "ready_output 0");
    expect(out == 0u, "ready_output 0");
    in = 65535u;
    expect(tc100_reg_ready_output_encode(in, bytes) == TC100_OK, "ready_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "ready_output 65535 bytes");
    expect(tc100_reg_ready_output_decode(bytes, &out) == TC100_OK, "ready_output 65535");
    expect(out == 65535u, "ready_output 65535");
}

static void test_41(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_moving_output_encode(in, bytes) == TC100_OK, "moving_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "moving_output 0 bytes");
    expect(tc100_reg_moving_output_decode(bytes, &out) == TC100_OK, "moving_output 0");
    expect(out == 0u, "moving_output 0");
    in = 65535u;
    expect(tc100_reg_moving_output_encode(in, bytes) == TC100_OK, "moving_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "moving_output 65535 bytes");
    expect(tc100_reg_moving_output_decode(bytes, &out) == TC100_OK, "moving_output 65535");
    expect(out == 65535u, "moving_output 65535");
}

static void test_42(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_servo_on_output_encode(in, bytes) == TC100_OK, "servo_on_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo_on_output 0 bytes");
    expect(tc100_reg_servo_on_output_decode(bytes, &out) == TC100_OK, "servo_on_output 0");
    expect(out == 0u, "servo_on_output 0");
    in = 65535u;
    expect(tc100_reg_servo_on_output_encode(in, bytes) == TC100_OK, "servo_on_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "servo_on_output 65535 bytes");
    expect(tc100_reg_servo_on_output_decode(bytes, &out) == TC100_OK, "servo_on_output 65535");
    expect(out == 65535u, "servo_on_output 65535");
}

static void test_43(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_point_select_bit_0_output_encode(in, bytes) == TC100_OK, "point_select_bit_0_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "point_select_bit_0_output 0 bytes");
    expect(tc100_reg_point_select_bit_0_output_decode(bytes, &out) == TC100_OK, "point_select_bit_0_output 0");
    expect(out == 0u, "point_select_bit_0_output 0");
    in = 65535u;
    expect(tc100_reg_point_select_bit_0_output_encode(in, bytes) == TC100_OK, "point_select_bit_0_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "point_select_bit_0_output 65535 bytes");
    expect(tc100_reg_point_select_bit_0_output_decode(bytes, &out) == TC100_OK, "point_select_bit_0_output 65535");
    expect(out == 65535u, "point_select_bit_0_output 65535");
}

static void test_44(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_point_select_bit_1_output_encode(in, bytes) == TC100_OK, "point_select_bit_1_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "point_select_bit_1_output 0 bytes");
    expect(tc100_reg_point_select_bit_1_output_decode(bytes, &out) == TC100_OK, "point_select_bit_1_output 0");
    expect(out == 0u, "point_select_bit_1_output 0");
    in = 65535u;
    expect(tc100_reg_point_select_bit_1_output_encode(in, bytes) == TC100_OK, "point_select_bit_1_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "point_select_bit_1_output 65535 bytes");
    expect(tc100_reg_point_select_bit_1_output_decode(bytes, &out) == TC100_OK, "point_select_bit_1_output 65535");
    expect(out == 65535u, "point_select_bit_1_output 65535");
}

static void test_45(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_point_select_bit_2_output_encode(in, bytes) == TC100_OK, "point_select_bit_2_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "point_select_bit_2_output 0 bytes");
    expect(tc100_reg_point_select_bit_2_output_decode(bytes, &out) == TC100_OK, "point_select_bit_2_output 0");
    expect(out == 0u, "point_select_bit_2_output 0");
    in = 65535u;
    expect(tc100_reg_point_select_bit_2_output_encode(in, bytes) == TC100_OK, "point_select_bit_2_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "point_select_bit_2_output 65535 bytes");
    expect(tc100_reg_point_select_bit_2_output_decode(bytes, &out) == TC100_OK, "point_select_bit_2_output 65535");
    expect(out == 65535u, "point_select_bit_2_output 65535");
}

static void test_46(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_point_select_bit_3_output_encode(in, bytes) == TC100_OK, "point_select_bit_3_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "point_select_bit_3_output 0 bytes");
    expect(tc100_reg_point_select_bit_3_output_decode(bytes, &out) == TC100_OK, "point_select_bit_3_output 0");
    expect(out == 0u, "point_select_bit_3_output 0");
    in = 65535u;
    expect(tc100_reg_point_select_bit_3_output_encode(in, bytes) == TC100_OK, "point_select_bit_3_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "point_select_bit_3_output 65535 bytes");
    expect(tc100_reg_point_select_bit_3_output_decode(bytes, &out) == TC100_OK, "point_select_bit_3_output 65535");
    expect(out == 65535u, "point_select_bit_3_output 65535");
}

static void test_47(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_point_select_bit_4_output_encode(in, bytes) == TC100_OK, "point_select_bit_4_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "point_select_bit_4_output 0 bytes");
    expect(tc100_reg_point_select_bit_4_output_decode(bytes, &out) == TC100_OK, "point_select_bit_4_output 0");
    expect(out == 0u, "point_select_bit_4_output 0");
    in = 65535u;
    expect(tc100_reg_point_select_bit_4_output_encode(in, bytes) == TC100_OK, "point_select_bit_4_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "point_select_bit_4_output 65535 bytes");
    expect(tc100_reg_point_select_bit_4_output_decode(bytes, &out) == TC100_OK, "point_select_bit_4_output 65535");
    expect(out == 65535u, "point_select_bit_4_output 65535");
}

static void test_48(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_point_select_bit_5_output_encode(in, bytes) == TC100_OK, "point_select_bit_5_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "point_select_bit_5_output 0 bytes");
    expect(tc100_reg_point_select_bit_5_output_decode(bytes, &out) == TC100_OK, "point_select_bit_5_output 0");
    expect(out == 0u, "point_select_bit_5_output 0");
    in = 65535u;
    expect(tc100_reg_point_select_bit_5_output_encode(in, bytes) == TC100_OK, "point_select_bit_5_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "point_select_bit_5_output 65535 bytes");
    expect(tc100_reg_point_select_bit_5_output_decode(bytes, &out) == TC100_OK, "point_select_bit_5_output 65535");
    expect(out == 65535u, "point_select_bit_5_output 65535");
}

static void test_49(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_point_select_bit_6_output_encode(in, bytes) == TC100_OK, "point_select_bit_6_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "point_select_bit_6_output 0 bytes");
    expect(tc100_reg_point_select_bit_6_output_decode(bytes, &out) == TC100_OK, "point_select_bit_6_output 0");
    expect(out == 0u, "point_select_bit_6_output 0");
    in = 65535u;
    expect(tc100_reg_point_select_bit_6_output_encode(in, bytes) == TC100_OK, "point_select_bit_6_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "point_select_bit_6_output 65535 bytes");
    expect(tc100_reg_point_select_bit_6_output_decode(bytes, &out) == TC100_OK, "point_select_bit_6_output 65535");
    expect(out == 65535u, "point_select_bit_6_output 65535");
}

static void test_50(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_torque_limit_output_encode(in, bytes) == TC100_OK, "torque_limit_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "torque_limit_output 0 bytes");
    expect(tc100_reg_torque_limit_output_decode(bytes, &out) == TC100_OK, "torque_limit_output 0");
    expect(out == 0u, "torque_limit_output 0");
    in = 65535u;
    expect(tc100_reg_torque_limit_output_encode(in, bytes) == TC100_OK, "torque_limit_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "torque_limit_output 65535 bytes");
    expect(tc100_reg_torque_limit_output_decode(bytes, &out) == TC100_OK, "torque_limit_output 65535");
    expect(out == 65535u, "torque_limit_output 65535");
}

static void test_51(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_error_bit_0_output_encode(in, bytes) == TC100_OK, "error_bit_0_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "error_bit_0_output 0 bytes");
    expect(tc100_reg_error_bit_0_output_decode(bytes, &out) == TC100_OK, "error_bit_0_output 0");
    expect(out == 0u, "error_bit_0_output 0");
    in = 65535u;
    expect(tc100_reg_error_bit_0_output_encode(in, bytes) == TC100_OK, "error_bit_0_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "error_bit_0_output 65535 bytes");
    expect(tc100_reg_error_bit_0_output_decode(bytes, &out) == TC100_OK, "error_bit_0_output 65535");
    expect(out == 65535u, "error_bit_0_output 65535");
}

static void test_52(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_error_bit_1_output_encode(in, bytes) == TC100_OK, "error_bit_1_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "error_bit_1_output 0 bytes");
    expect(tc100_reg_error_bit_1_output_decode(bytes, &out) == TC100_OK, "error_bit_1_output 0");
    expect(out == 0u, "error_bit_1_output 0");
    in = 65535u;
    expect(tc100_reg_error_bit_1_output_encode(in, bytes) == TC100_OK, "error_bit_1_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "error_bit_1_output 65535 bytes");
    expect(tc100_reg_error_bit_1_output_decode(bytes, &out) == TC100_OK, "error_bit_1_output 65535");
    expect(out == 65535u, "error_bit_1_output 65535");
}

static void test_53(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_error_bit_2_output_encode(in, bytes) == TC100_OK, "error_bit_2_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "error_bit_2_output 0 bytes");
    expect(tc100_reg_error_bit_2_output_decode(bytes, &out) == TC100_OK, "error_bit_2_output 0");
    expect(out == 0u, "error_bit_2_output 0");
    in = 65535u;
    expect(tc100_reg_error_bit_2_output_encode(in, bytes) == TC100_OK, "error_bit_2_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "error_bit_2_output 65535 bytes");
    expect(tc100_reg_error_bit_2_output_decode(bytes, &out) == TC100_OK, "error_bit_2_output 65535");
    expect(out == 65535u, "error_bit_2_output 65535");
}

static void test_54(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_error_bit_3_output_encode(in, bytes) == TC100_OK, "error_bit_3_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "error_bit_3_output 0 bytes");
    expect(tc100_reg_error_bit_3_output_decode(bytes, &out) == TC100_OK, "error_bit_3_output 0");
    expect(out == 0u, "error_bit_3_output 0");
    in = 65535u;
    expect(tc100_reg_error_bit_3_output_encode(in, bytes) == TC100_OK, "error_bit_3_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "error_bit_3_output 65535 bytes");
    expect(tc100_reg_error_bit_3_output_decode(bytes, &out) == TC100_OK, "error_bit_3_output 65535");
    expect(out == 65535u, "error_bit_3_output 65535");
}

static void test_55(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_zone_output_encode(in, bytes) == TC100_OK, "zone_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "zone_output 0 bytes");
    expect(tc100_reg_zone_output_decode(bytes, &out) == TC100_OK, "zone_output 0");
    expect(out == 0u, "zone_output 0");
    in = 65535u;
    expect(tc100_reg_zone_output_encode(in, bytes) == TC100_OK, "zone_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "zone_output 65535 bytes");
    expect(tc100_reg_zone_output_decode(bytes, &out) == TC100_OK, "zone_output 65535");
    expect(out == 65535u, "zone_output 65535");
}

static void test_56(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_near_output_encode(in, bytes) == TC100_OK, "near_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "near_output 0 bytes");
    expect(tc100_reg_near_output_decode(bytes, &out) == TC100_OK, "near_output 0");
    expect(out == 0u, "near_output 0");
    in = 65535u;
    expect(tc100_reg_near_output_encode(in, bytes) == TC100_OK, "near_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "near_output 65535 bytes");
    expect(tc100_reg_near_output_decode(bytes, &out) == TC100_OK, "near_output 65535");
    expect(out == 65535u, "near_output 65535");
}

static void test_57(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_soft_limit_output_encode(in, bytes) == TC100_OK, "soft_limit_output 0");
    expect(same_bytes(bytes, "\000\000", 2u), "soft_limit_output 0 bytes");
    expect(tc100_reg_soft_limit_output_decode(bytes, &out) == TC100_OK, "soft_limit_output 0");
    expect(out == 0u, "soft_limit_output 0");
    in = 65535u;
    expect(tc100_reg_soft_limit_output_encode(in, bytes) == TC100_OK, "soft_limit_output 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "soft_limit_output 65535 bytes");
    expect(tc100_reg_soft_limit_output_decode(bytes, &out) == TC100_OK, "soft_limit_output 65535");
    expect(out == 65535u, "soft_limit_output 65535");
}

static void test_58(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(tc100_reg_relative_distance_encode(in, bytes) == TC100_OK, "relative_distance -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "relative_distance -2147483648 bytes");
    expect(tc100_reg_relative_distance_decode(bytes, &out) == TC100_OK, "relative_distance -2147483648");
    expect(out == (-2147483647 - 1), "relative_distance -2147483648");
    in = 0;
    expect(tc100_reg_relative_distance_encode(in, bytes) == TC100_OK, "relative_distance 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "relative_distance 0 bytes");
    expect(tc100_reg_relative_distance_decode(bytes, &out) == TC100_OK, "relative_distance 0");
    expect(out == 0, "relative_distance 0");
    in = 2147483647;
    expect(tc100_reg_relative_distance_encode(in, bytes) == TC100_OK, "relative_distance 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "relative_distance 2147483647 bytes");
    expect(tc100_reg_relative_distance_decode(bytes, &out) == TC100_OK, "relative_distance 2147483647");
    expect(out == 2147483647, "relative_distance 2147483647");
}

static void test_59(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(tc100_reg_absolute_position_encode(in, bytes) == TC100_OK, "absolute_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "absolute_position -2147483648 bytes");
    expect(tc100_reg_absolute_position_decode(bytes, &out) == TC100_OK, "absolute_position -2147483648");
    expect(out == (-2147483647 - 1), "absolute_position -2147483648");
    in = 0;
    expect(tc100_reg_absolute_position_encode(in, bytes) == TC100_OK, "absolute_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "absolute_position 0 bytes");
    expect(tc100_reg_absolute_position_decode(bytes, &out) == TC100_OK, "absolute_position 0");
    expect(out == 0, "absolute_position 0");
    in = 2147483647;
    expect(tc100_reg_absolute_position_encode(in, bytes) == TC100_OK, "absolute_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "absolute_position 2147483647 bytes");
    expect(tc100_reg_absolute_position_decode(bytes, &out) == TC100_OK, "absolute_position 2147483647");
    expect(out == 2147483647, "absolute_position 2147483647");
}

static void test_60(void)
{
    uint8_t bytes[2];
    tc100_torque_search_direction out = TC100_TORQUE_SEARCH_DIRECTION_NEGATIVE;
    volatile tc100_torque_search_direction in = TC100_TORQUE_SEARCH_DIRECTION_POSITIVE;
    in = TC100_TORQUE_SEARCH_DIRECTION_POSITIVE;
    expect(tc100_reg_torque_search_direction_encode(in, bytes) == TC100_OK, "torque_search_direction 0");
    expect(same_bytes(bytes, "\000\000", 2u), "torque_search_direction 0 bytes");
    expect(tc100_reg_torque_search_direction_decode(bytes, &out) == TC100_OK, "torque_search_direction 0");
    expect(out == TC100_TORQUE_SEARCH_DIRECTION_POSITIVE, "torque_search_direction 0");
    in = TC100_TORQUE_SEARCH_DIRECTION_NEGATIVE;
    expect(tc100_reg_torque_search_direction_encode(in, bytes) == TC100_OK, "torque_search_direction 1");
    expect(same_bytes(bytes, "\000\001", 2u), "torque_search_direction 1 bytes");
    expect(tc100_reg_torque_search_direction_decode(bytes, &out) == TC100_OK, "torque_search_direction 1");
    expect(out == TC100_TORQUE_SEARCH_DIRECTION_NEGATIVE, "torque_search_direction 1");
}

static void test_61(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(tc100_reg_preset_position_encode(in, bytes) == TC100_OK, "preset_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "preset_position -2147483648 bytes");
    expect(tc100_reg_preset_position_decode(bytes, &out) == TC100_OK, "preset_position -2147483648");
    expect(out == (-2147483647 - 1), "preset_position -2147483648");
    in = 0;
    expect(tc100_reg_preset_position_encode(in, bytes) == TC100_OK, "preset_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "preset_position 0 bytes");
    expect(tc100_reg_preset_position_decode(bytes, &out) == TC100_OK, "preset_position 0");
    expect(out == 0, "preset_position 0");
    in = 2147483647;
    expect(tc100_reg_preset_position_encode(in, bytes) == TC100_OK, "preset_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "preset_position 2147483647 bytes");
    expect(tc100_reg_preset_position_decode(bytes, &out) == TC100_OK, "preset_position 2147483647");
    expect(out == 2147483647, "preset_position 2147483647");
}

static void test_62(void)
{
    uint8_t bytes[2];
    tc100_servo_command out = TC100_SERVO_COMMAND_SERVO_OFF;
    volatile tc100_servo_command in = TC100_SERVO_COMMAND_SERVO_ON;
    in = TC100_SERVO_COMMAND_SERVO_ON;
    expect(tc100_reg_servo_encode(in, bytes) == TC100_OK, "servo 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo 0 bytes");
    expect(tc100_reg_servo_decode(bytes, &out) == TC100_OK, "servo 0");
    expect(out == TC100_SERVO_COMMAND_SERVO_ON, "servo 0");
    in = TC100_SERVO_COMMAND_SERVO_OFF;
    expect(tc100_reg_servo_encode(in, bytes) == TC100_OK, "servo 1");
    expect(same_bytes(bytes, "\000\001", 2u), "servo 1 bytes");
    expect(tc100_reg_servo_decode(bytes, &out) == TC100_OK, "servo 1");
    expect(out == TC100_SERVO_COMMAND_SERVO_OFF, "servo 1");
}

static void test_63(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_motion_speed_encode(in, bytes) == TC100_OK, "motion_speed 0");
    expect(same_bytes(bytes, "\000\000", 2u), "motion_speed 0 bytes");
    expect(tc100_reg_motion_speed_decode(bytes, &out) == TC100_OK, "motion_speed 0");
    expect(out == 0u, "motion_speed 0");
    in = 100u;
    expect(tc100_reg_motion_speed_encode(in, bytes) == TC100_OK, "motion_speed 100");
    expect(same_bytes(bytes, "\000\144", 2u), "motion_speed 100 bytes");
    expect(tc100_reg_motion_speed_decode(bytes, &out) == TC100_OK, "motion_speed 100");
    expect(out == 100u, "motion_speed 100");
}

static void test_64(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile tc100_motion_command in = TC100_MOTION_COMMAND_RELATIVE_MOVE;
    in = TC100_MOTION_COMMAND_RELATIVE_MOVE;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 0");
    expect(same_bytes(bytes, "\000\000", 2u), "motion_command 0 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 0");
    expect(out == 0u, "motion_command 0");
    in = TC100_MOTION_COMMAND_ABSOLUTE_MOVE;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 1");
    expect(same_bytes(bytes, "\000\001", 2u), "motion_command 1 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 1");
    expect(out == 1u, "motion_command 1");
    in = TC100_MOTION_COMMAND_TORQUE_SEARCH;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 2");
    expect(same_bytes(bytes, "\000\002", 2u), "motion_command 2 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 2");
    expect(out == 2u, "motion_command 2");
    in = TC100_MOTION_COMMAND_HOMING;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 3");
    expect(same_bytes(bytes, "\000\003", 2u), "motion_command 3 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 3");
    expect(out == 3u, "motion_command 3");
    in = TC100_MOTION_COMMAND_PRESET_POSITION;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 4");
    expect(same_bytes(bytes, "\000\004", 2u), "motion_command 4 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 4");
    expect(out == 4u, "motion_command 4");
    in = TC100_MOTION_COMMAND_ALARM_RESET;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 6");
    expect(same_bytes(bytes, "\000\006", 2u), "motion_command 6 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 6");
    expect(out == 6u, "motion_command 6");
    in = TC100_MOTION_COMMAND_CLEAR_DEVIATION;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 7");
    expect(same_bytes(bytes, "\000\007", 2u), "motion_command 7 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 7");
    expect(out == 7u, "motion_command 7");
    in = TC100_MOTION_COMMAND_DECELERATE_AND_STOP;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 8");
    expect(same_bytes(bytes, "\000\010", 2u), "motion_command 8 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 8");
    expect(out == 8u, "motion_command 8");
    in = TC100_MOTION_COMMAND_EMERGENCY_STOP;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 9");
    expect(same_bytes(bytes, "\000\011", 2u), "motion_command 9 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 9");
    expect(out == 9u, "motion_command 9");
    in = TC100_MOTION_COMMAND_JOG_POSITIVE;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 11");
    expect(same_bytes(bytes, "\000\013", 2u), "motion_command 11 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 11");
    expect(out == 11u, "motion_command 11");
    in = TC100_MOTION_COMMAND_JOG_NEGATIVE;
    expect(tc100_reg_motion_command_encode(in, bytes) == TC100_OK, "motion_command 12");
    expect(same_bytes(bytes, "\000\014", 2u), "motion_command 12 bytes");
    expect(tc100_reg_motion_command_decode(bytes, &out) == TC100_OK, "motion_command 12");
    expect(out == 12u, "motion_command 12");
}

static void test_65(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_simulated_inputs_encode(in, bytes) == TC100_OK, "simulated_inputs 0");
    expect(same_bytes(bytes, "\000\000", 2u), "simulated_inputs 0 bytes");
    expect(tc100_reg_simulated_inputs_decode(bytes, &out) == TC100_OK, "simulated_inputs 0");
    expect(out == 0u, "simulated_inputs 0");
    in = 16383u;
    expect(tc100_reg_simulated_inputs_encode(in, bytes) == TC100_OK, "simulated_inputs 16383");
    expect(same_bytes(bytes, "\077\377", 2u), "simulated_inputs 16383 bytes");
    expect(tc100_reg_simulated_inputs_decode(bytes, &out) == TC100_OK, "simulated_inputs 16383");
    expect(out == 16383u, "simulated_inputs 16383");
}

static void test_66(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile tc100_parameter_storage in = TC100_PARAMETER_STORAGE_PRESENT_PARAMETERS;
    in = TC100_PARAMETER_STORAGE_PRESENT_PARAMETERS;
    expect(tc100_reg_parameter_storage_encode(in, bytes) == TC100_OK, "parameter_storage 0");
    expect(same_bytes(bytes, "\000\000", 2u), "parameter_storage 0 bytes");
    expect(tc100_reg_parameter_storage_decode(bytes, &out) == TC100_OK, "parameter_storage 0");
    expect(out == 0u, "parameter_storage 0");
    in = TC100_PARAMETER_STORAGE_DEFAULT_PARAMETERS;
    expect(tc100_reg_parameter_storage_encode(in, bytes) == TC100_OK, "parameter_storage 1");
    expect(same_bytes(bytes, "\000\001", 2u), "parameter_storage 1 bytes");
    expect(tc100_reg_parameter_storage_decode(bytes, &out) == TC100_OK, "parameter_storage 1");
    expect(out == 1u, "parameter_storage 1");
}

static void test_67(void)
{
    uint8_t bytes[8];
    uint64_t out = 0;
    static const uint8_t other[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    expect(tc100_reg_write_enable_key_encode(bytes) == TC100_OK, "write_enable_key");
    expect(same_bytes(bytes, "\114\166\060\061\124\171\126\147", 8u), "write_enable_key bytes");
    expect(tc100_reg_write_enable_key_decode(bytes, &out) == TC100_OK, "write_enable_key");
    expect(out == UINT64_C(5509644182563149415), "write_enable_key");
    expect(tc100_reg_write_enable_key_decode(other, &out) == TC100_OK, "write_enable_key 0");
    expect(out == UINT64_C(0), "write_enable_key 0");
}

static void test_68(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(tc100_reg_full_count_limit_encode(in, bytes) == TC100_OK, "full_count_limit 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "full_count_limit 1 bytes");
    expect(tc100_reg_full_count_limit_decode(bytes, &out) == TC100_OK, "full_count_limit 1");
    expect(out == 1u, "full_count_limit 1");
    in = 100000u;
    expect(tc100_reg_full_count_limit_encode(in, bytes) == TC100_OK, "full_count_limit 100000");
    expect(same_bytes(bytes, "\000\001\206\240", 4u), "full_count_limit 100000 bytes");
    expect(tc100_reg_full_count_limit_decode(bytes, &out) == TC100_OK, "full_count_limit 100000");
    expect(out == 100000u, "full_count_limit 100000");
}

static void test_69(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_in_position_zone_encode(in, bytes) == TC100_OK, "in_position_zone 0");
    expect(same_bytes(bytes, "\000\000", 2u), "in_position_zone 0 bytes");
    expect(tc100_reg_in_position_zone_decode(bytes, &out) == TC100_OK, "in_position_zone 0");
    expect(out == 0u, "in_position_zone 0");
    in = 1000u;
    expect(tc100_reg_in_position_zone_encode(in, bytes) == TC100_OK, "in_position_zone 1000");
    expect(same_bytes(bytes, "\003\350", 2u), "in_position_zone 1000 bytes");
    expect(tc100_reg_in_position_zone_decode(bytes, &out) == TC100_OK, "in_position_zone 1000");
    expect(out == 1000u, "in_position_zone 1000");
}

static void test_70(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(tc100_reg_electronic_gear_numerator_encode(in, bytes) == TC100_OK, "electronic_gear_numerator 1");
    expect(same_bytes(bytes, "\000\001", 2u), "electronic_gear_numerator 1 bytes");
    expect(tc100_reg_electronic_gear_numerator_decode(bytes, &out) == TC100_OK, "electronic_gear_numerator 1");
    expect(out == 1u, "electronic_gear_numerator 1");
    in = 10000u;
    expect(tc100_reg_electronic_gear_numerator_encode(in, bytes) == TC100_OK, "electronic_gear_numerator 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "electronic_gear_numerator 10000 bytes");
    expect(tc100_reg_electronic_gear_numerator_decode(bytes, &out) == TC100_OK, "electronic_gear_numerator 10000");
    expect(out == 10000u, "electronic_gear_numerator 10000");
}

static void test_71(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(tc100_reg_electronic_gear_denominator_encode(in, bytes) == TC100_OK, "electronic_gear_denominator 1");
    expect(same_bytes(bytes, "\000\001", 2u), "electronic_gear_denominator 1 bytes");
    expect(tc100_reg_electronic_gear_denominator_decode(bytes, &out) == TC100_OK, "electronic_gear_denominator 1");
    expect(out == 1u, "electronic_gear_denominator 1");
    in = 10000u;
    expect(tc100_reg_electronic_gear_denominator_encode(in, bytes) == TC100_OK, "electronic_gear_denominator 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "electronic_gear_denominator 10000 bytes");
    expect(tc100_reg_electronic_gear_denominator_decode(bytes, &out) == TC100_OK, "electronic_gear_denominator 10000");
    expect(out == 10000u, "electronic_gear_denominator 10000");
}

static void test_72(void)
{
    uint8_t bytes[2];
    tc100_rotation_direction out = TC100_ROTATION_DIRECTION_COUNTERCLOCKWISE;
    volatile tc100_rotation_direction in = TC100_ROTATION_DIRECTION_CLOCKWISE;
    in = TC100_ROTATION_DIRECTION_CLOCKWISE;
    expect(tc100_reg_pulse_rotation_direction_encode(in, bytes) == TC100_OK, "pulse_rotation_direction 0");
    expect(same_bytes(bytes, "\000\000", 2u), "pulse_rotation_direction 0 bytes");
    expect(tc100_reg_pulse_rotation_direction_decode(bytes, &out) == TC100_OK, "pulse_rotation_direction 0");
    expect(out == TC100_ROTATION_DIRECTION_CLOCKWISE, "pulse_rotation_direction 0");
    in = TC100_ROTATION_DIRECTION_COUNTERCLOCKWISE;
    expect(tc100_reg_pulse_rotation_direction_encode(in, bytes) == TC100_OK, "pulse_rotation_direction 1");
    expect(same_bytes(bytes, "\000\001", 2u), "pulse_rotation_direction 1 bytes");
    expect(tc100_reg_pulse_rotation_direction_decode(bytes, &out) == TC100_OK, "pulse_rotation_direction 1");
    expect(out == TC100_ROTATION_DIRECTION_COUNTERCLOCKWISE, "pulse_rotation_direction 1");
}

static void test_73(void)
{
    uint8_t bytes[2];
    tc100_pulse_input_form out = TC100_PULSE_INPUT_FORM_TWO_PHASES;
    volatile tc100_pulse_input_form in = TC100_PULSE_INPUT_FORM_CLOCKWISE_AND_COUNTERCLOCKWISE;
    in = TC100_PULSE_INPUT_FORM_CLOCKWISE_AND_COUNTERCLOCKWISE;
    expect(tc100_reg_pulse_input_form_encode(in, bytes) == TC100_OK, "pulse_input_form 0");
    expect(same_bytes(bytes, "\000\000", 2u), "pulse_input_form 0 bytes");
    expect(tc100_reg_pulse_input_form_decode(bytes, &out) == TC100_OK, "pulse_input_form 0");
    expect(out == TC100_PULSE_INPUT_FORM_CLOCKWISE_AND_COUNTERCLOCKWISE, "pulse_input_form 0");
    in = TC100_PULSE_INPUT_FORM_PULSE_AND_DIRECTION;
    expect(tc100_reg_pulse_input_form_encode(in, bytes) == TC100_OK, "pulse_input_form 1");
    expect(same_bytes(bytes, "\000\001", 2u), "pulse_input_form 1 bytes");
    expect(tc100_reg_pulse_input_form_decode(bytes, &out) == TC100_OK, "pulse_input_form 1");
    expect(out == TC100_PULSE_INPUT_FORM_PULSE_AND_DIRECTION, "pulse_input_form 1");
    in = TC100_PULSE_INPUT_FORM_TWO_PHASES;
    expect(tc100_reg_pulse_input_form_encode(in, bytes) == TC100_OK, "pulse_input_form 2");
    expect(same_bytes(bytes, "\000\002", 2u), "pulse_input_form 2 bytes");
    expect(tc100_reg_pulse_input_form_decode(bytes, &out) == TC100_OK, "pulse_input_form 2");
    expect(out == TC100_PULSE_INPUT_FORM_TWO_PHASES, "pulse_input_form 2");
}

static void test_74(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_near_zone_encode(in, bytes) == TC100_OK, "near_zone 0");
    expect(same_bytes(bytes, "\000\000", 2u), "near_zone 0 bytes");
    expect(tc100_reg_near_zone_decode(bytes, &out) == TC100_OK, "near_zone 0");
    expect(out == 0u, "near_zone 0");
    in = 10000u;
    expect(tc100_reg_near_zone_encode(in, bytes) == TC100_OK, "near_zone 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "near_zone 10000 bytes");
    expect(tc100_reg_near_zone_decode(bytes, &out) == TC100_OK, "near_zone 10000");
    expect(out == 10000u, "near_zone 10000");
}

static void test_75(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_push_torque_positive_encode(in, bytes) == TC100_OK, "push_torque_positive 0");
    expect(same_bytes(bytes, "\000\000", 2u), "push_torque_positive 0 bytes");
    expect(tc100_reg_push_torque_positive_decode(bytes, &out) == TC100_OK, "push_torque_positive 0");
    expect(out == 0u, "push_torque_positive 0");
    in = 1000u;
    expect(tc100_reg_push_torque_positive_encode(in, bytes) == TC100_OK, "push_torque_positive 1000");
    expect(same_bytes(bytes, "\003\350", 2u), "push_torque_positive 1000 bytes");
    expect(tc100_reg_push_torque_positive_decode(bytes, &out) == TC100_OK, "push_torque_positive 1000");
    expect(out == 1000u, "push_torque_positive 1000");
}

static void test_76(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_push_torque_negative_encode(in, bytes) == TC100_OK, "push_torque_negative 0");
    expect(same_bytes(bytes, "\000\000", 2u), "push_torque_negative 0 bytes");
    expect(tc100_reg_push_torque_negative_decode(bytes, &out) == TC100_OK, "push_torque_negative 0");
    expect(out == 0u, "push_torque_negative 0");
    in = 1000u;
    expect(tc100_reg_push_torque_negative_encode(in, bytes) == TC100_OK, "push_torque_negative 1000");
    expect(same_bytes(bytes, "\003\350", 2u), "push_torque_negative 1000 bytes");
    expect(tc100_reg_push_torque_negative_decode(bytes, &out) == TC100_OK, "push_torque_negative 1000");
    expect(out == 1000u, "push_torque_negative 1000");
}

static void test_77(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_torque_limit_time_encode(in, bytes) == TC100_OK, "torque_limit_time 0");
    expect(same_bytes(bytes, "\000\000", 2u), "torque_limit_time 0 bytes");
    expect(tc100_reg_torque_limit_time_decode(bytes, &out) == TC100_OK, "torque_limit_time 0");
    expect(out == 0u, "torque_limit_time 0");
    in = 10000u;
    expect(tc100_reg_torque_limit_time_encode(in, bytes) == TC100_OK, "torque_limit_time 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "torque_limit_time 10000 bytes");
    expect(tc100_reg_torque_limit_time_decode(bytes, &out) == TC100_OK, "torque_limit_time 10000");
    expect(out == 10000u, "torque_limit_time 10000");
}

static void test_78(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 10u;
    expect(tc100_reg_position_correction_speed_limit_encode(in, bytes) == TC100_OK, "position_correction_speed_limit 10");
    expect(same_bytes(bytes, "\000\012", 2u), "position_correction_speed_limit 10 bytes");
    expect(tc100_reg_position_correction_speed_limit_decode(bytes, &out) == TC100_OK, "position_correction_speed_limit 10");
    expect(out == 10u, "position_correction_speed_limit 10");
    in = 500u;
    expect(tc100_reg_position_correction_speed_limit_encode(in, bytes) == TC100_OK, "position_correction_speed_limit 500");
    expect(same_bytes(bytes, "\001\364", 2u), "position_correction_speed_limit 500 bytes");
    expect(tc100_reg_position_correction_speed_limit_decode(bytes, &out) == TC100_OK, "position_correction_speed_limit 500");
    expect(out == 500u, "position_correction_speed_limit 500");
}

static void test_79(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_maximum_torque_encode(in, bytes) == TC100_OK, "maximum_torque 0");
    expect(same_bytes(bytes, "\000\000", 2u), "maximum_torque 0 bytes");
    expect(tc100_reg_maximum_torque_decode(bytes, &out) == TC100_OK, "maximum_torque 0");
    expect(out == 0u, "maximum_torque 0");
    in = 650u;
    expect(tc100_reg_maximum_torque_encode(in, bytes) == TC100_OK, "maximum_torque 650");
    expect(same_bytes(bytes, "\002\212", 2u), "maximum_torque 650 bytes");
    expect(tc100_reg_maximum_torque_decode(bytes, &out) == TC100_OK, "maximum_torque 650");
    expect(out == 650u, "maximum_torque 650");
}

static void test_80(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 500u;
    expect(tc100_reg_full_torque_time_encode(in, bytes) == TC100_OK, "full_torque_time 500");
    expect(same_bytes(bytes, "\001\364", 2u), "full_torque_time 500 bytes");
    expect(tc100_reg_full_torque_time_decode(bytes, &out) == TC100_OK, "full_torque_time 500");
    expect(out == 500u, "full_torque_time 500");
    in = 10000u;
    expect(tc100_reg_full_torque_time_encode(in, bytes) == TC100_OK, "full_torque_time 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "full_torque_time 10000 bytes");
    expect(tc100_reg_full_torque_time_decode(bytes, &out) == TC100_OK, "full_torque_time 10000");
    expect(out == 10000u, "full_torque_time 10000");
}

static void test_81(void)
{
    uint8_t bytes[2];
    tc100_control_mode out = TC100_CONTROL_MODE_TORQUE_MODE;
    volatile tc100_control_mode in = TC100_CONTROL_MODE_POSITION_MODE;
    in = TC100_CONTROL_MODE_POSITION_MODE;
    expect(tc100_reg_control_mode_encode(in, bytes) == TC100_OK, "control_mode 0");
    expect(same_bytes(bytes, "\000\000", 2u), "control_mode 0 bytes");
    expect(tc100_reg_control_mode_decode(bytes, &out) == TC100_OK, "control_mode 0");
    expect(out == TC100_CONTROL_MODE_POSITION_MODE, "control_mode 0");
    in = TC100_CONTROL_MODE_TORQUE_MODE;
    expect(tc100_reg_control_mode_encode(in, bytes) == TC100_OK, "control_mode 1");
    expect(same_bytes(bytes, "\000\001", 2u), "control_mode 1 bytes");
    expect(tc100_reg_control_mode_decode(bytes, &out) == TC100_OK, "control_mode 1");
    expect(out == TC100_CONTROL_MODE_TORQUE_MODE, "control_mode 1");
}

static void test_82(void)
{
    uint8_t bytes[2];
    tc100_servo_command out = TC100_SERVO_COMMAND_SERVO_OFF;
    volatile tc100_servo_command in = TC100_SERVO_COMMAND_SERVO_ON;
    in = TC100_SERVO_COMMAND_SERVO_ON;
    expect(tc100_reg_servo_at_power_on_encode(in, bytes) == TC100_OK, "servo_at_power_on 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo_at_power_on 0 bytes");
    expect(tc100_reg_servo_at_power_on_decode(bytes, &out) == TC100_OK, "servo_at_power_on 0");
    expect(out == TC100_SERVO_COMMAND_SERVO_ON, "servo_at_power_on 0");
    in = TC100_SERVO_COMMAND_SERVO_OFF;
    expect(tc100_reg_servo_at_power_on_encode(in, bytes) == TC100_OK, "servo_at_power_on 1");
    expect(same_bytes(bytes, "\000\001", 2u), "servo_at_power_on 1 bytes");
    expect(tc100_reg_servo_at_power_on_decode(bytes, &out) == TC100_OK, "servo_at_power_on 1");
    expect(out == TC100_SERVO_COMMAND_SERVO_OFF, "servo_at_power_on 1");
}

static void test_83(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(tc100_reg_start_speed_encode(in, bytes) == TC100_OK, "start_speed 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "start_speed 0 bytes");
    expect(tc100_reg_start_speed_decode(bytes, &out) == TC100_OK, "start_speed 0");
    expect(out == 0u, "start_speed 0");
    in = 4294967295u;
    expect(tc100_reg_start_speed_encode(in, bytes) == TC100_OK, "start_speed 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "start_speed 4294967295 bytes");
    expect(tc100_reg_start_speed_decode(bytes, &out) == TC100_OK, "start_speed 4294967295");
    expect(out == 4294967295u, "start_speed 4294967295");
}

static void test_84(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(tc100_reg_maximum_speed_encode(in, bytes) == TC100_OK, "maximum_speed 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "maximum_speed 0 bytes");
    expect(tc100_reg_maximum_speed_decode(bytes, &out) == TC100_OK, "maximum_speed 0");
    expect(out == 0u, "maximum_speed 0");
    in = 4294967295u;
    expect(tc100_reg_maximum_speed_encode(in, bytes) == TC100_OK, "maximum_speed 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "maximum_speed 4294967295 bytes");
    expect(tc100_reg_maximum_speed_decode(bytes, &out) == TC100_OK, "maximum_speed 4294967295");
    expect(out == 4294967295u, "maximum_speed 4294967295");
}

static void test_85(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(tc100_reg_acceleration_time_encode(in, bytes) == TC100_OK, "acceleration_time 1");
    expect(same_bytes(bytes, "\000\001", 2u), "acceleration_time 1 bytes");
    expect(tc100_reg_acceleration_time_decode(bytes, &out) == TC100_OK, "acceleration_time 1");
    expect(out == 1u, "acceleration_time 1");
    in = 30000u;
    expect(tc100_reg_acceleration_time_encode(in, bytes) == TC100_OK, "acceleration_time 30000");
    expect(same_bytes(bytes, "\165\060", 2u), "acceleration_time 30000 bytes");
    expect(tc100_reg_acceleration_time_decode(bytes, &out) == TC100_OK, "acceleration_time 30000");
    expect(out == 30000u, "acceleration_time 30000");
}

static void test_86(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(tc100_reg_deceleration_time_encode(in, bytes) == TC100_OK, "deceleration_time 1");
    expect(same_bytes(bytes, "\000\001", 2u), "deceleration_time 1 bytes");
    expect(tc100_reg_deceleration_time_decode(bytes, &out) == TC100_OK, "deceleration_time 1");
    expect(out == 1u, "deceleration_time 1");
    in = 30000u;
    expect(tc100_reg_deceleration_time_encode(in, bytes) == TC100_OK, "deceleration_time 30000");
    expect(same_bytes(bytes, "\165\060", 2u), "deceleration_time 30000 bytes");
    expect(tc100_reg_deceleration_time_decode(bytes, &out) == TC100_OK, "deceleration_time 30000");
    expect(out == 30000u, "deceleration_time 30000");
}

static void test_87(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(tc100_reg_torque_limit_press_distance_encode(in, bytes) == TC100_OK, "torque_limit_press_distance 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "torque_limit_press_distance 0 bytes");
    expect(tc100_reg_torque_limit_press_distance_decode(bytes, &out) == TC100_OK, "torque_limit_press_distance 0");
    expect(out == 0u, "torque_limit_press_distance 0");
    in = 4294967295u;
    expect(tc100_reg_torque_limit_press_distance_encode(in, bytes) == TC100_OK, "torque_limit_press_distance 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "torque_limit_press_distance 4294967295 bytes");
    expect(tc100_reg_torque_limit_press_distance_decode(bytes, &out) == TC100_OK, "torque_limit_press_distance 4294967295");
    expect(out == 4294967295u, "torque_limit_press_distance 4294967295");
}

static void test_88(void)
{
    uint8_t bytes[2];
    tc100_moving_state_rule out = TC100_MOVING_STATE_RULE_PULSES_SENT_AND_IN_POSITION;
    volatile tc100_moving_state_rule in = TC100_MOVING_STATE_RULE_PULSES_SENT;
    in = TC100_MOVING_STATE_RULE_PULSES_SENT;
    expect(tc100_reg_moving_state_rule_encode(in, bytes) == TC100_OK, "moving_state_rule 0");
    expect(same_bytes(bytes, "\000\000", 2u), "moving_state_rule 0 bytes");
    expect(tc100_reg_moving_state_rule_decode(bytes, &out) == TC100_OK, "moving_state_rule 0");
    expect(out == TC100_MOVING_STATE_RULE_PULSES_SENT, "moving_state_rule 0");
    in = TC100_MOVING_STATE_RULE_PULSES_SENT_AND_IN_POSITION;
    expect(tc100_reg_moving_state_rule_encode(in, bytes) == TC100_OK, "moving_state_rule 1");
    expect(same_bytes(bytes, "\000\001", 2u), "moving_state_rule 1 bytes");
    expect(tc100_reg_moving_state_rule_decode(bytes, &out) == TC100_OK, "moving_state_rule 1");
    expect(out == TC100_MOVING_STATE_RULE_PULSES_SENT_AND_IN_POSITION, "moving_state_rule 1");
}

static void test_89(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(tc100_reg_jog_speed_encode(in, bytes) == TC100_OK, "jog_speed 1");
    expect(same_bytes(bytes, "\000\001", 2u), "jog_speed 1 bytes");
    expect(tc100_reg_jog_speed_decode(bytes, &out) == TC100_OK, "jog_speed 1");
    expect(out == 1u, "jog_speed 1");
    in = 1000u;
    expect(tc100_reg_jog_speed_encode(in, bytes) == TC100_OK, "jog_speed 1000");
    expect(same_bytes(bytes, "\003\350", 2u), "jog_speed 1000 bytes");
    expect(tc100_reg_jog_speed_decode(bytes, &out) == TC100_OK, "jog_speed 1000");
    expect(out == 1000u, "jog_speed 1000");
}

static void test_90(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(tc100_reg_jog_distance_encode(in, bytes) == TC100_OK, "jog_distance 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "jog_distance 0 bytes");
    expect(tc100_reg_jog_distance_decode(bytes, &out) == TC100_OK, "jog_distance 0");
    expect(out == 0u, "jog_distance 0");
    in = 4294967295u;
    expect(tc100_reg_jog_distance_encode(in, bytes) == TC100_OK, "jog_distance 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "jog_distance 4294967295 bytes");
    expect(tc100_reg_jog_distance_decode(bytes, &out) == TC100_OK, "jog_distance 4294967295");
    expect(out == 4294967295u, "jog_distance 4294967295");
}

static void test_91(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_jog_wait_time_encode(in, bytes) == TC100_OK, "jog_wait_time 0");
    expect(same_bytes(bytes, "\000\000", 2u), "jog_wait_time 0 bytes");
    expect(tc100_reg_jog_wait_time_decode(bytes, &out) == TC100_OK, "jog_wait_time 0");
    expect(out == 0u, "jog_wait_time 0");
    in = 1000u;
    expect(tc100_reg_jog_wait_time_encode(in, bytes) == TC100_OK, "jog_wait_time 1000");
    expect(same_bytes(bytes, "\003\350", 2u), "jog_wait_time 1000 bytes");
    expect(tc100_reg_jog_wait_time_decode(bytes, &out) == TC100_OK, "jog_wait_time 1000");
    expect(out == 1000u, "jog_wait_time 1000");
}

static void test_92(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(tc100_reg_soft_limit_positive_encode(in, bytes) == TC100_OK, "soft_limit_positive -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "soft_limit_positive -2147483648 bytes");
    expect(tc100_reg_soft_limit_positive_decode(bytes, &out) == TC100_OK, "soft_limit_positive -2147483648");
    expect(out == (-2147483647 - 1), "soft_limit_positive -2147483648");
    in = 0;
    expect(tc100_reg_soft_limit_positive_encode(in, bytes) == TC100_OK, "soft_limit_positive 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "soft_limit_positive 0 bytes");
    expect(tc100_reg_soft_limit_positive_decode(bytes, &out) == TC100_OK, "soft_limit_positive 0");
    expect(out == 0, "soft_limit_positive 0");
    in = 2147483647;
    expect(tc100_reg_soft_limit_positive_encode(in, bytes) == TC100_OK, "soft_limit_positive 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "soft_limit_positive 2147483647 bytes");
    expect(tc100_reg_soft_limit_positive_decode(bytes, &out) == TC100_OK, "soft_limit_positive 2147483647");
    expect(out == 2147483647, "soft_limit_positive 2147483647");
}

static void test_93(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(tc100_reg_soft_limit_negative_encode(in, bytes) == TC100_OK, "soft_limit_negative -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "soft_limit_negative -2147483648 bytes");
    expect(tc100_reg_soft_limit_negative_decode(bytes, &out) == TC100_OK, "soft_limit_negative -2147483648");
    expect(out == (-2147483647 - 1), "soft_limit_negative -2147483648");
    in = 0;
    expect(tc100_reg_soft_limit_negative_encode(in, bytes) == TC100_OK, "soft_limit_negative 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "soft_limit_negative 0 bytes");
    expect(tc100_reg_soft_limit_negative_decode(bytes, &out) == TC100_OK, "soft_limit_negative 0");
    expect(out == 0, "soft_limit_negative 0");
    in = 2147483647;
    expect(tc100_reg_soft_limit_negative_encode(in, bytes) == TC100_OK, "soft_limit_negative 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "soft_limit_negative 2147483647 bytes");
    expect(tc100_reg_soft_limit_negative_decode(bytes, &out) == TC100_OK, "soft_limit_negative 2147483647");
    expect(out == 2147483647, "soft_limit_negative 2147483647");
}

static void test_94(void)
{
    uint8_t bytes[2];
    tc100_homing_mode out = TC100_HOMING_MODE_SENSOR_NEGATIVE_THEN_Z_PHASE;
    volatile tc100_homing_mode in = TC100_HOMING_MODE_TORQUE_POSITIVE;
    in = TC100_HOMING_MODE_TORQUE_POSITIVE;
    expect(tc100_reg_homing_mode_encode(in, bytes) == TC100_OK, "homing_mode 0");
    expect(same_bytes(bytes, "\000\000", 2u), "homing_mode 0 bytes");
    expect(tc100_reg_homing_mode_decode(bytes, &out) == TC100_OK, "homing_mode 0");
    expect(out == TC100_HOMING_MODE_TORQUE_POSITIVE, "homing_mode 0");
    in = TC100_HOMING_MODE_TORQUE_NEGATIVE;
    expect(tc100_reg_homing_mode_encode(in, bytes) == TC100_OK, "homing_mode 1");
    expect(same_bytes(bytes, "\000\001", 2u), "homing_mode 1 bytes");
    expect(tc100_reg_homing_mode_decode(bytes, &out) == TC100_OK, "homing_mode 1");
    expect(out == TC100_HOMING_MODE_TORQUE_NEGATIVE, "homing_mode 1");
    in = TC100_HOMING_MODE_TORQUE_POSITIVE_THEN_Z_PHASE;
    expect(tc100_reg_homing_mode_encode(in, bytes) == TC100_OK, "homing_mode 2");
    expect(same_bytes(bytes, "\000\002", 2u), "homing_mode 2 bytes");
    expect(tc100_reg_homing_mode_decode(bytes, &out) == TC100_OK, "homing_mode 2");
    expect(out == TC100_HOMING_MODE_TORQUE_POSITIVE_THEN_Z_PHASE, "homing_mode 2");
    in = TC100_HOMING_MODE_TORQUE_NEGATIVE_THEN_Z_PHASE;
    expect(tc100_reg_homing_mode_encode(in, bytes) == TC100_OK, "homing_mode 3");
    expect(same_bytes(bytes, "\000\003", 2u), "homing_mode 3 bytes");
    expect(tc100_reg_homing_mode_decode(bytes, &out) == TC100_OK, "homing_mode 3");
    expect(out == TC100_HOMING_MODE_TORQUE_NEGATIVE_THEN_Z_PHASE, "homing_mode 3");
    in = TC100_HOMING_MODE_SENSOR_POSITIVE;
    expect(tc100_reg_homing_mode_encode(in, bytes) == TC100_OK, "homing_mode 4");
    expect(same_bytes(bytes, "\000\004", 2u), "homing_mode 4 bytes");
    expect(tc100_reg_homing_mode_decode(bytes, &out) == TC100_OK, "homing_mode 4");
    expect(out == TC100_HOMING_MODE_SENSOR_POSITIVE, "homing_mode 4");
    in = TC100_HOMING_MODE_SENSOR_NEGATIVE;
    expect(tc100_reg_homing_mode_encode(in, bytes) == TC100_OK, "homing_mode 5");
    expect(same_bytes(bytes, "\000\005", 2u), "homing_mode 5 bytes");
    expect(tc100_reg_homing_mode_decode(bytes, &out) == TC100_OK, "homing_mode 5");
    expect(out == TC100_HOMING_MODE_SENSOR_NEGATIVE, "homing_mode 5");
    in = TC100_HOMING_MODE_SENSOR_POSITIVE_THEN_Z_PHASE;
    expect(tc100_reg_homing_mode_encode(in, bytes) == TC100_OK, "homing_mode 6");
    expect(same_bytes(bytes, "\000\006", 2u), "homing_mode 6 bytes");
    expect(tc100_reg_homing_mode_decode(bytes, &out) == TC100_OK, "homing_mode 6");
    expect(out == TC100_HOMING_MODE_SENSOR_POSITIVE_THEN_Z_PHASE, "homing_mode 6");
    in = TC100_HOMING_MODE_SENSOR_NEGATIVE_THEN_Z_PHASE;
    expect(tc100_reg_homing_mode_encode(in, bytes) == TC100_OK, "homing_mode 7");
    expect(same_bytes(bytes, "\000\007", 2u), "homing_mode 7 bytes");
    expect(tc100_reg_homing_mode_decode(bytes, &out) == TC100_OK, "homing_mode 7");
    expect(out == TC100_HOMING_MODE_SENSOR_NEGATIVE_THEN_Z_PHASE, "homing_mode 7");
}

static void test_95(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_homing_speed_encode(in, bytes) == TC100_OK, "homing_speed 0");
    expect(same_bytes(bytes, "\000\000", 2u), "homing_speed 0 bytes");
    expect(tc100_reg_homing_speed_decode(bytes, &out) == TC100_OK, "homing_speed 0");
    expect(out == 0u, "homing_speed 0");
    in = 100u;
    expect(tc100_reg_homing_speed_encode(in, bytes) == TC100_OK, "homing_speed 100");
    expect(same_bytes(bytes, "\000\144", 2u), "homing_speed 100 bytes");
    expect(tc100_reg_homing_speed_decode(bytes, &out) == TC100_OK, "homing_speed 100");
    expect(out == 100u, "homing_speed 100");
}

static void test_96(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(tc100_reg_homing_offset_encode(in, bytes) == TC100_OK, "homing_offset -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "homing_offset -2147483648 bytes");
    expect(tc100_reg_homing_offset_decode(bytes, &out) == TC100_OK, "homing_offset -2147483648");
    expect(out == (-2147483647 - 1), "homing_offset -2147483648");
    in = 0;
    expect(tc100_reg_homing_offset_encode(in, bytes) == TC100_OK, "homing_offset 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "homing_offset 0 bytes");
    expect(tc100_reg_homing_offset_decode(bytes, &out) == TC100_OK, "homing_offset 0");
    expect(out == 0, "homing_offset 0");
    in = 2147483647;
    expect(tc100_reg_homing_offset_encode(in, bytes) == TC100_OK, "homing_offset 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "homing_offset 2147483647 bytes");
    expect(tc100_reg_homing_offset_decode(bytes, &out) == TC100_OK, "homing_offset 2147483647");
    expect(out == 2147483647, "homing_offset 2147483647");
}

static void test_97(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_homing_offset_speed_encode(in, bytes) == TC100_OK, "homing_offset_speed 0");
    expect(same_bytes(bytes, "\000\000", 2u), "homing_offset_speed 0 bytes");
    expect(tc100_reg_homing_offset_speed_decode(bytes, &out) == TC100_OK, "homing_offset_speed 0");
    expect(out == 0u, "homing_offset_speed 0");
    in = 100u;
    expect(tc100_reg_homing_offset_speed_encode(in, bytes) == TC100_OK, "homing_offset_speed 100");
    expect(same_bytes(bytes, "\000\144", 2u), "homing_offset_speed 100 bytes");
    expect(tc100_reg_homing_offset_speed_decode(bytes, &out) == TC100_OK, "homing_offset_speed 100");
    expect(out == 100u, "homing_offset_speed 100");
}

static void test_98(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(tc100_reg_homing_position_encode(in, bytes) == TC100_OK, "homing_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "homing_position -2147483648 bytes");
    expect(tc100_reg_homing_position_decode(bytes, &out) == TC100_OK, "homing_position -2147483648");
    expect(out == (-2147483647 - 1), "homing_position -2147483648");
    in = 0;
    expect(tc100_reg_homing_position_encode(in, bytes) == TC100_OK, "homing_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "homing_position 0 bytes");
    expect(tc100_reg_homing_position_decode(bytes, &out) == TC100_OK, "homing_position 0");
    expect(out == 0, "homing_position 0");
    in = 2147483647;
    expect(tc100_reg_homing_position_encode(in, bytes) == TC100_OK, "homing_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "homing_position 2147483647 bytes");
    expect(tc100_reg_homing_position_decode(bytes, &out) == TC100_OK, "homing_position 2147483647");
    expect(out == 2147483647, "homing_position 2147483647");
}

static void test_99(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_homing_torque_limit_encode(in, bytes) == TC100_OK, "homing_torque_limit 0");
    expect(same_bytes(bytes, "\000\000", 2u), "homing_torque_limit 0 bytes");
    expect(tc100_reg_homing_torque_limit_decode(bytes, &out) == TC100_OK, "homing_torque_limit 0");
    expect(out == 0u, "homing_torque_limit 0");
    in = 1000u;
    expect(tc100_reg_homing_torque_limit_encode(in, bytes) == TC100_OK, "homing_torque_limit 1000");
    expect(same_bytes(bytes, "\003\350", 2u), "homing_torque_limit 1000 bytes");
    expect(tc100_reg_homing_torque_limit_decode(bytes, &out) == TC100_OK, "homing_torque_limit 1000");
    expect(out == 1000u, "homing_torque_limit 1000");
}

static void test_100(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(tc100_reg_homing_z_phase_offset_encode(in, bytes) == TC100_OK, "homing_z_phase_offset -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "homing_z_phase_offset -2147483648 bytes");
    expect(tc100_reg_homing_z_phase_offset_decode(bytes, &out) == TC100_OK, "homing_z_phase_offset -2147483648");
    expect(out == (-2147483647 - 1), "homing_z_phase_offset -2147483648");
    in = 0;
    expect(tc100_reg_homing_z_phase_offset_encode(in, bytes) == TC100_OK, "homing_z_phase_offset 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "homing_z_phase_offset 0 bytes");
    expect(tc100_reg_homing_z_phase_offset_decode(bytes, &out) == TC100_OK, "homing_z_phase_offset 0");
    expect(out == 0, "homing_z_phase_offset 0");
    in = 2147483647;
    expect(tc100_reg_homing_z_phase_offset_encode(in, bytes) == TC100_OK, "homing_z_phase_offset 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "homing_z_phase_offset 2147483647 bytes");
    expect(tc100_reg_homing_z_phase_offset_decode(bytes, &out) == TC100_OK, "homing_z_phase_offset 2147483647");
    expect(out == 2147483647, "homing_z_phase_offset 2147483647");
}

static void test_101(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_homing_torque_limit_time_encode(in, bytes) == TC100_OK, "homing_torque_limit_time 0");
    expect(same_bytes(bytes, "\000\000", 2u), "homing_torque_limit_time 0 bytes");
    expect(tc100_reg_homing_torque_limit_time_decode(bytes, &out) == TC100_OK, "homing_torque_limit_time 0");
    expect(out == 0u, "homing_torque_limit_time 0");
    in = 1000u;
    expect(tc100_reg_homing_torque_limit_time_encode(in, bytes) == TC100_OK, "homing_torque_limit_time 1000");
    expect(same_bytes(bytes, "\003\350", 2u), "homing_torque_limit_time 1000 bytes");
    expect(tc100_reg_homing_torque_limit_time_decode(bytes, &out) == TC100_OK, "homing_torque_limit_time 1000");
    expect(out == 1000u, "homing_torque_limit_time 1000");
}

static void test_102(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(tc100_reg_homing_z_phase_speed_1_encode(in, bytes) == TC100_OK, "homing_z_phase_speed_1 1");
    expect(same_bytes(bytes, "\000\001", 2u), "homing_z_phase_speed_1 1 bytes");
    expect(tc100_reg_homing_z_phase_speed_1_decode(bytes, &out) == TC100_OK, "homing_z_phase_speed_1 1");
    expect(out == 1u, "homing_z_phase_speed_1 1");
    in = 100u;
    expect(tc100_reg_homing_z_phase_speed_1_encode(in, bytes) == TC100_OK, "homing_z_phase_speed_1 100");
    expect(same_bytes(bytes, "\000\144", 2u), "homing_z_phase_speed_1 100 bytes");
    expect(tc100_reg_homing_z_phase_speed_1_decode(bytes, &out) == TC100_OK, "homing_z_phase_speed_1 100");
    expect(out == 100u, "homing_z_phase_speed_1 100");
}

static void test_103(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(tc100_reg_homing_z_phase_speed_2_encode(in, bytes) == TC100_OK, "homing_z_phase_speed_2 1");
    expect(same_bytes(bytes, "\000\001", 2u), "homing_z_phase_speed_2 1 bytes");
    expect(tc100_reg_homing_z_phase_speed_2_decode(bytes, &out) == TC100_OK, "homing_z_phase_speed_2 1");
    expect(out == 1u, "homing_z_phase_speed_2 1");
    in = 100u;
    expect(tc100_reg_homing_z_phase_speed_2_encode(in, bytes) == TC100_OK, "homing_z_phase_speed_2 100");
    expect(same_bytes(bytes, "\000\144", 2u), "homing_z_phase_speed_2 100 bytes");
    expect(tc100_reg_homing_z_phase_speed_2_decode(bytes, &out) == TC100_OK, "homing_z_phase_speed_2 100");
    expect(out == 100u, "homing_z_phase_speed_2 100");
}

static void test_104(void)
{
    uint8_t bytes[2];
    tc100_baud_rate out = TC100_BAUD_RATE_BAUD_115200;
    volatile tc100_baud_rate in = TC100_BAUD_RATE_BAUD_9600;
    in = TC100_BAUD_RATE_BAUD_9600;
    expect(tc100_reg_baud_rate_encode(in, bytes) == TC100_OK, "baud_rate 0");
    expect(same_bytes(bytes, "\000\000", 2u), "baud_rate 0 bytes");
    expect(tc100_reg_baud_rate_decode(bytes, &out) == TC100_OK, "baud_rate 0");
    expect(out == TC100_BAUD_RATE_BAUD_9600, "baud_rate 0");
    in = TC100_BAUD_RATE_BAUD_19200;
    expect(tc100_reg_baud_rate_encode(in, bytes) == TC100_OK, "baud_rate 1");
    expect(same_bytes(bytes, "\000\001", 2u), "baud_rate 1 bytes");
    expect(tc100_reg_baud_rate_decode(bytes, &out) == TC100_OK, "baud_rate 1");
    expect(out == TC100_BAUD_RATE_BAUD_19200, "baud_rate 1");
    in = TC100_BAUD_RATE_BAUD_38400;
    expect(tc100_reg_baud_rate_encode(in, bytes) == TC100_OK, "baud_rate 2");
    expect(same_bytes(bytes, "\000\002", 2u), "baud_rate 2 bytes");
    expect(tc100_reg_baud_rate_decode(bytes, &out) == TC100_OK, "baud_rate 2");
    expect(out == TC100_BAUD_RATE_BAUD_38400, "baud_rate 2");
    in = TC100_BAUD_RATE_BAUD_57600;
    expect(tc100_reg_baud_rate_encode(in, bytes) == TC100_OK, "baud_rate 3");
    expect(same_bytes(bytes, "\000\003", 2u), "baud_rate 3 bytes");
    expect(tc100_reg_baud_rate_decode(bytes, &out) == TC100_OK, "baud_rate 3");
    expect(out == TC100_BAUD_RATE_BAUD_57600, "baud_rate 3");
    in = TC100_BAUD_RATE_BAUD_115200;
    expect(tc100_reg_baud_rate_encode(in, bytes) == TC100_OK, "baud_rate 4");
    expect(same_bytes(bytes, "\000\004", 2u), "baud_rate 4 bytes");
    expect(tc100_reg_baud_rate_decode(bytes, &out) == TC100_OK, "baud_rate 4");
    expect(out == TC100_BAUD_RATE_BAUD_115200, "baud_rate 4");
}

static void test_105(void)
{
    uint8_t bytes[2];
    tc100_data_bits out = TC100_DATA_BITS_SEVEN_BITS;
    volatile tc100_data_bits in = TC100_DATA_BITS_EIGHT_BITS;
    in = TC100_DATA_BITS_EIGHT_BITS;
    expect(tc100_reg_data_bits_encode(in, bytes) == TC100_OK, "data_bits 0");
    expect(same_bytes(bytes, "\000\000", 2u), "data_bits 0 bytes");
    expect(tc100_reg_data_bits_decode(bytes, &out) == TC100_OK, "data_bits 0");
    expect(out == TC100_DATA_BITS_EIGHT_BITS, "data_bits 0");
    in = TC100_DATA_BITS_SEVEN_BITS;
    expect(tc100_reg_data_bits_encode(in, bytes) == TC100_OK, "data_bits 1");
    expect(same_bytes(bytes, "\000\001", 2u), "data_bits 1 bytes");
    expect(tc100_reg_data_bits_decode(bytes, &out) == TC100_OK, "data_bits 1");
    expect(out == TC100_DATA_BITS_SEVEN_BITS, "data_bits 1");
}

static void test_106(void)
{
    uint8_t bytes[2];
    tc100_parity out = TC100_PARITY_ODD_PARITY;
    volatile tc100_parity in = TC100_PARITY_NO_PARITY;
    in = TC100_PARITY_NO_PARITY;
    expect(tc100_reg_parity_encode(in, bytes) == TC100_OK, "parity 0");
    expect(same_bytes(bytes, "\000\000", 2u), "parity 0 bytes");
    expect(tc100_reg_parity_decode(bytes, &out) == TC100_OK, "parity 0");
    expect(out == TC100_PARITY_NO_PARITY, "parity 0");
    in = TC100_PARITY_EVEN_PARITY;
    expect(tc100_reg_parity_encode(in, bytes) == TC100_OK, "parity 1");
    expect(same_bytes(bytes, "\000\001", 2u), "parity 1 bytes");
    expect(tc100_reg_parity_decode(bytes, &out) == TC100_OK, "parity 1");
    expect(out == TC100_PARITY_EVEN_PARITY, "parity 1");
    in = TC100_PARITY_ODD_PARITY;
    expect(tc100_reg_parity_encode(in, bytes) == TC100_OK, "parity 2");
    expect(same_bytes(bytes, "\000\002", 2u), "parity 2 bytes");
    expect(tc100_reg_parity_decode(bytes, &out) == TC100_OK, "parity 2");
    expect(out == TC100_PARITY_ODD_PARITY, "parity 2");
}

static void test_107(void)
{
    uint8_t bytes[2];
    tc100_protocol out = TC100_PROTOCOL_MODBUS_RTU;
    volatile tc100_protocol in = TC100_PROTOCOL_MODBUS_ASCII;
    in = TC100_PROTOCOL_MODBUS_ASCII;
    expect(tc100_reg_protocol_encode(in, bytes) == TC100_OK, "protocol 0");
    expect(same_bytes(bytes, "\000\000", 2u), "protocol 0 bytes");
    expect(tc100_reg_protocol_decode(bytes, &out) == TC100_OK, "protocol 0");
    expect(out == TC100_PROTOCOL_MODBUS_ASCII, "protocol 0");
    in = TC100_PROTOCOL_MODBUS_RTU;
    expect(tc100_reg_protocol_encode(in, bytes) == TC100_OK, "protocol 1");
    expect(same_bytes(bytes, "\000\001", 2u), "protocol 1 bytes");
    expect(tc100_reg_protocol_decode(bytes, &out) == TC100_OK, "protocol 1");
    expect(out == TC100_PROTOCOL_MODBUS_RTU, "protocol 1");
}

static void test_108(void)
{
    uint8_t bytes[2];
    tc100_action_status out = TC100_ACTION_STATUS_STOPPED_BY_ERROR;
    volatile tc100_action_status in = TC100_ACTION_STATUS_STOPPED;
    in = TC100_ACTION_STATUS_STOPPED;
    expect(tc100_reg_action_status_encode(in, bytes) == TC100_OK, "action_status 0");
    expect(same_bytes(bytes, "\000\000", 2u), "action_status 0 bytes");
    expect(tc100_reg_action_status_decode(bytes, &out) == TC100_OK, "action_status 0");
    expect(out == TC100_ACTION_STATUS_STOPPED, "action_status 0");
    in = TC100_ACTION_STATUS_MOVING;
    expect(tc100_reg_action_status_encode(in, bytes) == TC100_OK, "action_status 1");
    expect(same_bytes(bytes, "\000\001", 2u), "action_status 1 bytes");
    expect(tc100_reg_action_status_decode(bytes, &out) == TC100_OK, "action_status 1");
    expect(out == TC100_ACTION_STATUS_MOVING, "action_status 1");
    in = TC100_ACTION_STATUS_STOPPED_BY_ERROR;
    expect(tc100_reg_action_status_encode(in, bytes) == TC100_OK, "action_status 2");
    expect(same_bytes(bytes, "\000\002", 2u), "action_status 2 bytes");
    expect(tc100_reg_action_status_decode(bytes, &out) == TC100_OK, "action_status 2");
    expect(out == TC100_ACTION_STATUS_STOPPED_BY_ERROR, "action_status 2");
}

static void test_109(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_alarm_encode(in, bytes) == TC100_OK, "alarm 0");
    expect(same_bytes(bytes, "\000\000", 2u), "alarm 0 bytes");
    expect(tc100_reg_alarm_decode(bytes, &out) == TC100_OK, "alarm 0");
    expect(out == 0u, "alarm 0");
    in = 65535u;
    expect(tc100_reg_alarm_encode(in, bytes) == TC100_OK, "alarm 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "alarm 65535 bytes");
    expect(tc100_reg_alarm_decode(bytes, &out) == TC100_OK, "alarm 65535");
    expect(out == 65535u, "alarm 65535");
}

static void test_110(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-32768);
    expect(tc100_reg_motor_speed_encode(in, bytes) == TC100_OK, "motor_speed -32768");
    expect(same_bytes(bytes, "\200\000", 2u), "motor_speed -32768 bytes");
    expect(tc100_reg_motor_speed_decode(bytes, &out) == TC100_OK, "motor_speed -32768");
    expect(out == (-32768), "motor_speed -32768");
    in = 0;
    expect(tc100_reg_motor_speed_encode(in, bytes) == TC100_OK, "motor_speed 0");
    expect(same_bytes(bytes, "\000\000", 2u), "motor_speed 0 bytes");
    expect(tc100_reg_motor_speed_decode(bytes, &out) == TC100_OK, "motor_speed 0");
    expect(out == 0, "motor_speed 0");
    in = 32767;
    expect(tc100_reg_motor_speed_encode(in, bytes) == TC100_OK, "motor_speed 32767");
    expect(same_bytes(bytes, "\177\377", 2u), "motor_speed 32767 bytes");
    expect(tc100_reg_motor_speed_decode(bytes, &out) == TC100_OK, "motor_speed 32767");
    expect(out == 32767, "motor_speed 32767");
}

static void test_111(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-32768);
    expect(tc100_reg_motor_current_encode(in, bytes) == TC100_OK, "motor_current -32768");
    expect(same_bytes(bytes, "\200\000", 2u), "motor_current -32768 bytes");
    expect(tc100_reg_motor_current_decode(bytes, &out) == TC100_OK, "motor_current -32768");
    expect(out == (-32768), "motor_current -32768");
    in = 0;
    expect(tc100_reg_motor_current_encode(in, bytes) == TC100_OK, "motor_current 0");
    expect(same_bytes(bytes, "\000\000", 2u), "motor_current 0 bytes");
    expect(tc100_reg_motor_current_decode(bytes, &out) == TC100_OK, "motor_current 0");
    expect(out == 0, "motor_current 0");
    in = 32767;
    expect(tc100_reg_motor_current_encode(in, bytes) == TC100_OK, "motor_current 32767");
    expect(same_bytes(bytes, "\177\377", 2u), "motor_current 32767 bytes");
    expect(tc100_reg_motor_current_decode(bytes, &out) == TC100_OK, "motor_current 32767");
    expect(out == 32767, "motor_current 32767");
}

static void test_112(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(tc100_reg_command_position_encode(in, bytes) == TC100_OK, "command_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "command_position -2147483648 bytes");
    expect(tc100_reg_command_position_decode(bytes, &out) == TC100_OK, "command_position -2147483648");
    expect(out == (-2147483647 - 1), "command_position -2147483648");
    in = 0;
    expect(tc100_reg_command_position_encode(in, bytes) == TC100_OK, "command_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "command_position 0 bytes");
    expect(tc100_reg_command_position_decode(bytes, &out) == TC100_OK, "command_position 0");
    expect(out == 0, "command_position 0");
    in = 2147483647;
    expect(tc100_reg_command_position_encode(in, bytes) == TC100_OK, "command_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "command_position 2147483647 bytes");
    expect(tc100_reg_command_position_decode(bytes, &out) == TC100_OK, "command_position 2147483647");
    expect(out == 2147483647, "command_position 2147483647");
}

static void test_113(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(tc100_reg_encoder_position_encode(in, bytes) == TC100_OK, "encoder_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "encoder_position -2147483648 bytes");
    expect(tc100_reg_encoder_position_decode(bytes, &out) == TC100_OK, "encoder_position -2147483648");
    expect(out == (-2147483647 - 1), "encoder_position -2147483648");
    in = 0;
    expect(tc100_reg_encoder_position_encode(in, bytes) == TC100_OK, "encoder_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "encoder_position 0 bytes");
    expect(tc100_reg_encoder_position_decode(bytes, &out) == TC100_OK, "encoder_position 0");
    expect(out == 0, "encoder_position 0");
    in = 2147483647;
    expect(tc100_reg_encoder_position_encode(in, bytes) == TC100_OK, "encoder_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "encoder_position 2147483647 bytes");
    expect(tc100_reg_encoder_position_decode(bytes, &out) == TC100_OK, "encoder_position 2147483647");
    expect(out == 2147483647, "encoder_position 2147483647");
}

static void test_114(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_fault_encode(in, bytes) == TC100_OK, "fault 0");
    expect(same_bytes(bytes, "\000\000", 2u), "fault 0 bytes");
    expect(tc100_reg_fault_decode(bytes, &out) == TC100_OK, "fault 0");
    expect(out == 0u, "fault 0");
    in = 65535u;
    expect(tc100_reg_fault_encode(in, bytes) == TC100_OK, "fault 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "fault 65535 bytes");
    expect(tc100_reg_fault_decode(bytes, &out) == TC100_OK, "fault 65535");
    expect(out == 65535u, "fault 65535");
}

static void test_115(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-1);
    expect(tc100_reg_executed_point_encode(in, bytes) == TC100_OK, "executed_point -1");
    expect(same_bytes(bytes, "\377\377", 2u), "executed_point -1 bytes");
    expect(tc100_reg_executed_point_decode(bytes, &out) == TC100_OK, "executed_point -1");
    expect(out == (-1), "executed_point -1");
    in = 127;
    expect(tc100_reg_executed_point_encode(in, bytes) == TC100_OK, "executed_point 127");
    expect(same_bytes(bytes, "\000\177", 2u), "executed_point 127 bytes");
    expect(tc100_reg_executed_point_decode(bytes, &out) == TC100_OK, "executed_point 127");
    expect(out == 127, "executed_point 127");
}

static void test_116(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_output_states_encode(in, bytes) == TC100_OK, "output_states 0");
    expect(same_bytes(bytes, "\000\000", 2u), "output_states 0 bytes");
    expect(tc100_reg_output_states_decode(bytes, &out) == TC100_OK, "output_states 0");
    expect(out == 0u, "output_states 0");
    in = 1023u;
    expect(tc100_reg_output_states_encode(in, bytes) == TC100_OK, "output_states 1023");
    expect(same_bytes(bytes, "\003\377", 2u), "output_states 1023 bytes");
    expect(tc100_reg_output_states_decode(bytes, &out) == TC100_OK, "output_states 1023");
    expect(out == 1023u, "output_states 1023");
}

static void test_117(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_input_states_encode(in, bytes) == TC100_OK, "input_states 0");
    expect(same_bytes(bytes, "\000\000", 2u), "input_states 0 bytes");
    expect(tc100_reg_input_states_decode(bytes, &out) == TC100_OK, "input_states 0");
    expect(out == 0u, "input_states 0");
    in = 32767u;
    expect(tc100_reg_input_states_encode(in, bytes) == TC100_OK, "input_states 32767");
    expect(same_bytes(bytes, "\177\377", 2u), "input_states 32767 bytes");
    expect(tc100_reg_input_states_decode(bytes, &out) == TC100_OK, "input_states 32767");
    expect(out == 32767u, "input_states 32767");
}

static void test_118(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_alarm_history_encode(in, bytes) == TC100_OK, "alarm_history 0");
    expect(same_bytes(bytes, "\000\000", 2u), "alarm_history 0 bytes");
    expect(tc100_reg_alarm_history_decode(bytes, &out) == TC100_OK, "alarm_history 0");
    expect(out == 0u, "alarm_history 0");
    in = 65535u;
    expect(tc100_reg_alarm_history_encode(in, bytes) == TC100_OK, "alarm_history 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "alarm_history 65535 bytes");
    expect(tc100_reg_alarm_history_decode(bytes, &out) == TC100_OK, "alarm_history 65535");
    expect(out == 65535u, "alarm_history 65535");
}

static void test_119(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(tc100_reg_firmware_version_encode(in, bytes) == TC100_OK, "firmware_version 0");
    expect(same_bytes(bytes, "\000\000", 2u), "firmware_version 0 bytes");
    expect(tc100_reg_firmware_version_decode(bytes, &out) == TC100_OK, "firmware_version 0");
    expect(out == 0u, "firmware_version 0");
    in = 65535u;
    expect(tc100_reg_firmware_version_encode(in, bytes) == TC100_OK, "firmware_version 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "firmware_version 65535 bytes");
    expect(tc100_reg_firmware_version_decode(bytes, &out) == TC100_OK, "firmware_version 65535");
    expect(out == 65535u, "firmware_version 65535");
}

static void test_120(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x10, 0x00, 0x0E, 0x1C, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xF9, 0x6A};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-inc-0-00-100-500 opens");
    expect(opened.unit_address == 1u, "example worked-p1-inc-0-00-100-500: station");
    expect(opened.code == 16u, "example worked-p1-inc-0-00-100-500: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-inc-0-00-100-500 decodes");
    expect(out.address == 36880u, "example worked-p1-inc-0-00-100-500: address");
    expect(out.values_count == 14u, "example worked-p1-inc-0-00-100-500: values count");
    expect(out.values[0] == 0u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[1] == 0u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[2] == 0u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[3] == 100u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[4] == 500u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[5] == 0u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[6] == 0u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[7] == 0u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[8] == 0u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[9] == 0u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[10] == 300u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[11] == 300u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[12] == 0u, "example worked-p1-inc-0-00-100-500: values");
    expect(out.values[13] == 65535u, "example worked-p1-inc-0-00-100-500: values");
    in.address = 36880u;
    in.values_count = 14u;
    in.values[0] = 0u;
    in.values[1] = 0u;
    in.values[2] = 0u;
    in.values[3] = 100u;
    in.values[4] = 500u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 0u;
    in.values[8] = 0u;
    in.values[9] = 0u;
    in.values[10] = 300u;
    in.values[11] = 300u;
    in.values[12] = 0u;
    in.values[13] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-inc-0-00-100-500 encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-inc-0-00-100-500 bytes");
}

static void test_121(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x00, 0xA5, 0x00};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-inc-250-00-100-500-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-inc-250-00-100-500-mode: station");
    expect(opened.code == 6u, "example worked-p2-inc-250-00-100-500-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-inc-250-00-100-500-mode decodes");
    expect(out.address == 36896u, "example worked-p2-inc-250-00-100-500-mode: address");
    expect(out.value == 0u, "example worked-p2-inc-250-00-100-500-mode: value");
    in.address = 36896u;
    in.value = 0u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-inc-250-00-100-500-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-inc-250-00-100-500-mode bytes");
}

static void test_122(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0x6C, 0xFC};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-inc-250-00-100-500-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-inc-250-00-100-500-rest: station");
    expect(opened.code == 16u, "example worked-p2-inc-250-00-100-500-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-inc-250-00-100-500-rest decodes");
    expect(out.address == 36899u, "example worked-p2-inc-250-00-100-500-rest: address");
    expect(out.values_count == 11u, "example worked-p2-inc-250-00-100-500-rest: values count");
    expect(out.values[0] == 100u, "example worked-p2-inc-250-00-100-500-rest: values");
    expect(out.values[1] == 500u, "example worked-p2-inc-250-00-100-500-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-inc-250-00-100-500-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-inc-250-00-100-500-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-inc-250-00-100-500-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-inc-250-00-100-500-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-inc-250-00-100-500-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-inc-250-00-100-500-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-inc-250-00-100-500-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-inc-250-00-100-500-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-inc-250-00-100-500-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 500u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-inc-250-00-100-500-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-inc-250-00-100-500-rest bytes");
}

static void test_123(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x30, 0x00, 0x00, 0xA4, 0xC5};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p3-inc-m128-55-50-823-mode opens");
    expect(opened.unit_address == 1u, "example worked-p3-inc-m128-55-50-823-mode: station");
    expect(opened.code == 6u, "example worked-p3-inc-m128-55-50-823-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p3-inc-m128-55-50-823-mode decodes");
    expect(out.address == 36912u, "example worked-p3-inc-m128-55-50-823-mode: address");
    expect(out.value == 0u, "example worked-p3-inc-m128-55-50-823-mode: value");
    in.address = 36912u;
    in.value = 0u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p3-inc-m128-55-50-823-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p3-inc-m128-55-50-823-mode bytes");
}

static void test_124(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x33, 0x00, 0x0B, 0x16, 0x00, 0x32, 0x03, 0x37, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xC3, 0x87};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p3-inc-m128-55-50-823-rest opens");
    expect(opened.unit_address == 1u, "example worked-p3-inc-m128-55-50-823-rest: station");
    expect(opened.code == 16u, "example worked-p3-inc-m128-55-50-823-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p3-inc-m128-55-50-823-rest decodes");
    expect(out.address == 36915u, "example worked-p3-inc-m128-55-50-823-rest: address");
    expect(out.values_count == 11u, "example worked-p3-inc-m128-55-50-823-rest: values count");
    expect(out.values[0] == 50u, "example worked-p3-inc-m128-55-50-823-rest: values");
    expect(out.values[1] == 823u, "example worked-p3-inc-m128-55-50-823-rest: values");
    expect(out.values[2] == 0u, "example worked-p3-inc-m128-55-50-823-rest: values");
    expect(out.values[3] == 0u, "example worked-p3-inc-m128-55-50-823-rest: values");
    expect(out.values[4] == 0u, "example worked-p3-inc-m128-55-50-823-rest: values");
    expect(out.values[5] == 0u, "example worked-p3-inc-m128-55-50-823-rest: values");
    expect(out.values[6] == 0u, "example worked-p3-inc-m128-55-50-823-rest: values");
    expect(out.values[7] == 300u, "example worked-p3-inc-m128-55-50-823-rest: values");
    expect(out.values[8] == 300u, "example worked-p3-inc-m128-55-50-823-rest: values");
    expect(out.values[9] == 0u, "example worked-p3-inc-m128-55-50-823-rest: values");
    expect(out.values[10] == 65535u, "example worked-p3-inc-m128-55-50-823-rest: values");
    in.address = 36915u;
    in.values_count = 11u;
    in.values[0] = 50u;
    in.values[1] = 823u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p3-inc-m128-55-50-823-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p3-inc-m128-55-50-823-rest bytes");
}

static void test_125(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x01, 0x64, 0xC0};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-abs-250-00-100-500-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-abs-250-00-100-500-mode: station");
    expect(opened.code == 6u, "example worked-p2-abs-250-00-100-500-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-abs-250-00-100-500-mode decodes");
    expect(out.address == 36896u, "example worked-p2-abs-250-00-100-500-mode: address");
    expect(out.value == 1u, "example worked-p2-abs-250-00-100-500-mode: value");
    in.address = 36896u;
    in.value = 1u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-abs-250-00-100-500-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-abs-250-00-100-500-mode bytes");
}

static void test_126(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0x6C, 0xFC};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-abs-250-00-100-500-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-abs-250-00-100-500-rest: station");
    expect(opened.code == 16u, "example worked-p2-abs-250-00-100-500-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-abs-250-00-100-500-rest decodes");
    expect(out.address == 36899u, "example worked-p2-abs-250-00-100-500-rest: address");
    expect(out.values_count == 11u, "example worked-p2-abs-250-00-100-500-rest: values count");
    expect(out.values[0] == 100u, "example worked-p2-abs-250-00-100-500-rest: values");
    expect(out.values[1] == 500u, "example worked-p2-abs-250-00-100-500-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-abs-250-00-100-500-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-abs-250-00-100-500-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-abs-250-00-100-500-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-abs-250-00-100-500-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-abs-250-00-100-500-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-abs-250-00-100-500-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-abs-250-00-100-500-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-abs-250-00-100-500-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-abs-250-00-100-500-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 500u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-abs-250-00-100-500-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-abs-250-00-100-500-rest bytes");
}

static void test_127(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x30, 0x00, 0x01, 0x65, 0x05};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p3-abs-128-55-50-823-mode opens");
    expect(opened.unit_address == 1u, "example worked-p3-abs-128-55-50-823-mode: station");
    expect(opened.code == 6u, "example worked-p3-abs-128-55-50-823-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p3-abs-128-55-50-823-mode decodes");
    expect(out.address == 36912u, "example worked-p3-abs-128-55-50-823-mode: address");
    expect(out.value == 1u, "example worked-p3-abs-128-55-50-823-mode: value");
    in.address = 36912u;
    in.value = 1u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p3-abs-128-55-50-823-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p3-abs-128-55-50-823-mode bytes");
}

static void test_128(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x33, 0x00, 0x0B, 0x16, 0x00, 0x32, 0x03, 0x37, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xC3, 0x87};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p3-abs-128-55-50-823-rest opens");
    expect(opened.unit_address == 1u, "example worked-p3-abs-128-55-50-823-rest: station");
    expect(opened.code == 16u, "example worked-p3-abs-128-55-50-823-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p3-abs-128-55-50-823-rest decodes");
    expect(out.address == 36915u, "example worked-p3-abs-128-55-50-823-rest: address");
    expect(out.values_count == 11u, "example worked-p3-abs-128-55-50-823-rest: values count");
    expect(out.values[0] == 50u, "example worked-p3-abs-128-55-50-823-rest: values");
    expect(out.values[1] == 823u, "example worked-p3-abs-128-55-50-823-rest: values");
    expect(out.values[2] == 0u, "example worked-p3-abs-128-55-50-823-rest: values");
    expect(out.values[3] == 0u, "example worked-p3-abs-128-55-50-823-rest: values");
    expect(out.values[4] == 0u, "example worked-p3-abs-128-55-50-823-rest: values");
    expect(out.values[5] == 0u, "example worked-p3-abs-128-55-50-823-rest: values");
    expect(out.values[6] == 0u, "example worked-p3-abs-128-55-50-823-rest: values");
    expect(out.values[7] == 300u, "example worked-p3-abs-128-55-50-823-rest: values");
    expect(out.values[8] == 300u, "example worked-p3-abs-128-55-50-823-rest: values");
    expect(out.values[9] == 0u, "example worked-p3-abs-128-55-50-823-rest: values");
    expect(out.values[10] == 65535u, "example worked-p3-abs-128-55-50-823-rest: values");
    in.address = 36915u;
    in.values_count = 11u;
    in.values[0] = 50u;
    in.values[1] = 823u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p3-abs-128-55-50-823-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p3-abs-128-55-50-823-rest bytes");
}

static void test_129(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x02, 0x24, 0xC1};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-org-250-00-100-500-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-org-250-00-100-500-mode: station");
    expect(opened.code == 6u, "example worked-p2-org-250-00-100-500-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-org-250-00-100-500-mode decodes");
    expect(out.address == 36896u, "example worked-p2-org-250-00-100-500-mode: address");
    expect(out.value == 2u, "example worked-p2-org-250-00-100-500-mode: value");
    in.address = 36896u;
    in.value = 2u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-org-250-00-100-500-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-org-250-00-100-500-mode bytes");
}

static void test_130(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0x6C, 0xFC};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-org-250-00-100-500-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-org-250-00-100-500-rest: station");
    expect(opened.code == 16u, "example worked-p2-org-250-00-100-500-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-org-250-00-100-500-rest decodes");
    expect(out.address == 36899u, "example worked-p2-org-250-00-100-500-rest: address");
    expect(out.values_count == 11u, "example worked-p2-org-250-00-100-500-rest: values count");
    expect(out.values[0] == 100u, "example worked-p2-org-250-00-100-500-rest: values");
    expect(out.values[1] == 500u, "example worked-p2-org-250-00-100-500-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-org-250-00-100-500-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-org-250-00-100-500-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-org-250-00-100-500-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-org-250-00-100-500-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-org-250-00-100-500-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-org-250-00-100-500-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-org-250-00-100-500-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-org-250-00-100-500-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-org-250-00-100-500-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 500u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-org-250-00-100-500-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-org-250-00-100-500-rest bytes");
}

static void test_131(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x03, 0xE5, 0x01};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-plus-tsl-250-00-100-335-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-plus-tsl-250-00-100-335-mode: station");
    expect(opened.code == 6u, "example worked-p2-plus-tsl-250-00-100-335-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-plus-tsl-250-00-100-335-mode decodes");
    expect(out.address == 36896u, "example worked-p2-plus-tsl-250-00-100-335-mode: address");
    expect(out.value == 3u, "example worked-p2-plus-tsl-250-00-100-335-mode: value");
    in.address = 36896u;
    in.value = 3u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-plus-tsl-250-00-100-335-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-plus-tsl-250-00-100-335-mode bytes");
}

static void test_132(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x01, 0x4F, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xAC, 0x03};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-plus-tsl-250-00-100-335-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-plus-tsl-250-00-100-335-rest: station");
    expect(opened.code == 16u, "example worked-p2-plus-tsl-250-00-100-335-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-plus-tsl-250-00-100-335-rest decodes");
    expect(out.address == 36899u, "example worked-p2-plus-tsl-250-00-100-335-rest: address");
    expect(out.values_count == 11u, "example worked-p2-plus-tsl-250-00-100-335-rest: values count");
    expect(out.values[0] == 100u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    expect(out.values[1] == 335u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-plus-tsl-250-00-100-335-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 335u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-plus-tsl-250-00-100-335-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-plus-tsl-250-00-100-335-rest bytes");
}

static void test_133(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x04, 0xA4, 0xC3};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-minus-tsl-250-00-100-445-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-minus-tsl-250-00-100-445-mode: station");
    expect(opened.code == 6u, "example worked-p2-minus-tsl-250-00-100-445-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-minus-tsl-250-00-100-445-mode decodes");
    expect(out.address == 36896u, "example worked-p2-minus-tsl-250-00-100-445-mode: address");
    expect(out.value == 4u, "example worked-p2-minus-tsl-250-00-100-445-mode: value");
    in.address = 36896u;
    in.value = 4u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-minus-tsl-250-00-100-445-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-minus-tsl-250-00-100-445-mode bytes");
}

static void test_134(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x01, 0xBD, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xA6, 0xAE};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-minus-tsl-250-00-100-445-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-minus-tsl-250-00-100-445-rest: station");
    expect(opened.code == 16u, "example worked-p2-minus-tsl-250-00-100-445-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-minus-tsl-250-00-100-445-rest decodes");
    expect(out.address == 36899u, "example worked-p2-minus-tsl-250-00-100-445-rest: address");
    expect(out.values_count == 11u, "example worked-p2-minus-tsl-250-00-100-445-rest: values count");
    expect(out.values[0] == 100u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    expect(out.values[1] == 445u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-minus-tsl-250-00-100-445-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 445u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-minus-tsl-250-00-100-445-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-minus-tsl-250-00-100-445-rest bytes");
}

static void test_135(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x10, 0x00, 0x0D, 0x64, 0xCA};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-abs-r-100-00-30-1000-to-2-mode opens");
    expect(opened.unit_address == 1u, "example worked-p1-abs-r-100-00-30-1000-to-2-mode: station");
    expect(opened.code == 6u, "example worked-p1-abs-r-100-00-30-1000-to-2-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-abs-r-100-00-30-1000-to-2-mode decodes");
    expect(out.address == 36880u, "example worked-p1-abs-r-100-00-30-1000-to-2-mode: address");
    expect(out.value == 13u, "example worked-p1-abs-r-100-00-30-1000-to-2-mode: value");
    in.address = 36880u;
    in.value = 13u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-abs-r-100-00-30-1000-to-2-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-abs-r-100-00-30-1000-to-2-mode bytes");
}

static void test_136(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x13, 0x00, 0x0B, 0x16, 0x00, 0x1E, 0x03, 0xE8, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0x00, 0x02, 0x2C, 0x20};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-abs-r-100-00-30-1000-to-2-rest opens");
    expect(opened.unit_address == 1u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: station");
    expect(opened.code == 16u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-abs-r-100-00-30-1000-to-2-rest decodes");
    expect(out.address == 36883u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: address");
    expect(out.values_count == 11u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values count");
    expect(out.values[0] == 30u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[1] == 1000u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[2] == 0u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[3] == 0u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[4] == 0u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[5] == 0u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[6] == 0u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[7] == 300u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[8] == 300u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[9] == 0u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[10] == 2u, "example worked-p1-abs-r-100-00-30-1000-to-2-rest: values");
    in.address = 36883u;
    in.values_count = 11u;
    in.values[0] = 30u;
    in.values[1] = 1000u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 2u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-abs-r-100-00-30-1000-to-2-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-abs-r-100-00-30-1000-to-2-rest bytes");
}

static void test_137(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x0D, 0x64, 0xC5};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-abs-r-250-00-100-1000-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-abs-r-250-00-100-1000-mode: station");
    expect(opened.code == 6u, "example worked-p2-abs-r-250-00-100-1000-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-abs-r-250-00-100-1000-mode decodes");
    expect(out.address == 36896u, "example worked-p2-abs-r-250-00-100-1000-mode: address");
    expect(out.value == 13u, "example worked-p2-abs-r-250-00-100-1000-mode: value");
    in.address = 36896u;
    in.value = 13u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-abs-r-250-00-100-1000-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-abs-r-250-00-100-1000-mode bytes");
}

static void test_138(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x03, 0xE8, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xC2, 0x8C};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-abs-r-250-00-100-1000-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-abs-r-250-00-100-1000-rest: station");
    expect(opened.code == 16u, "example worked-p2-abs-r-250-00-100-1000-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-abs-r-250-00-100-1000-rest decodes");
    expect(out.address == 36899u, "example worked-p2-abs-r-250-00-100-1000-rest: address");
    expect(out.values_count == 11u, "example worked-p2-abs-r-250-00-100-1000-rest: values count");
    expect(out.values[0] == 100u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    expect(out.values[1] == 1000u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-abs-r-250-00-100-1000-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 1000u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-abs-r-250-00-100-1000-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-abs-r-250-00-100-1000-rest bytes");
}

static void test_139(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x10, 0x00, 0x0D, 0x64, 0xCA};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-abs-r-210-00-100-500-to-2-mode opens");
    expect(opened.unit_address == 1u, "example worked-p1-abs-r-210-00-100-500-to-2-mode: station");
    expect(opened.code == 6u, "example worked-p1-abs-r-210-00-100-500-to-2-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-abs-r-210-00-100-500-to-2-mode decodes");
    expect(out.address == 36880u, "example worked-p1-abs-r-210-00-100-500-to-2-mode: address");
    expect(out.value == 13u, "example worked-p1-abs-r-210-00-100-500-to-2-mode: value");
    in.address = 36880u;
    in.value = 13u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-abs-r-210-00-100-500-to-2-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-abs-r-210-00-100-500-to-2-mode bytes");
}

static void test_140(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x13, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0x00, 0x02, 0x53, 0xCD};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-abs-r-210-00-100-500-to-2-rest opens");
    expect(opened.unit_address == 1u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: station");
    expect(opened.code == 16u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-abs-r-210-00-100-500-to-2-rest decodes");
    expect(out.address == 36883u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: address");
    expect(out.values_count == 11u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values count");
    expect(out.values[0] == 100u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    expect(out.values[1] == 500u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    expect(out.values[2] == 0u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    expect(out.values[3] == 0u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    expect(out.values[4] == 0u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    expect(out.values[5] == 0u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    expect(out.values[6] == 0u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    expect(out.values[7] == 300u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    expect(out.values[8] == 300u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    expect(out.values[9] == 0u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    expect(out.values[10] == 2u, "example worked-p1-abs-r-210-00-100-500-to-2-rest: values");
    in.address = 36883u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 500u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 2u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-abs-r-210-00-100-500-to-2-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-abs-r-210-00-100-500-to-2-rest bytes");
}

static void test_141(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x0D, 0x64, 0xC5};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-abs-r-250-00-20-200-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-abs-r-250-00-20-200-mode: station");
    expect(opened.code == 6u, "example worked-p2-abs-r-250-00-20-200-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-abs-r-250-00-20-200-mode decodes");
    expect(out.address == 36896u, "example worked-p2-abs-r-250-00-20-200-mode: address");
    expect(out.value == 13u, "example worked-p2-abs-r-250-00-20-200-mode: value");
    in.address = 36896u;
    in.value = 13u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-abs-r-250-00-20-200-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-abs-r-250-00-20-200-mode bytes");
}

static void test_142(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x14, 0x00, 0xC8, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0x76, 0x4F};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-abs-r-250-00-20-200-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-abs-r-250-00-20-200-rest: station");
    expect(opened.code == 16u, "example worked-p2-abs-r-250-00-20-200-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-abs-r-250-00-20-200-rest decodes");
    expect(out.address == 36899u, "example worked-p2-abs-r-250-00-20-200-rest: address");
    expect(out.values_count == 11u, "example worked-p2-abs-r-250-00-20-200-rest: values count");
    expect(out.values[0] == 20u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    expect(out.values[1] == 200u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-abs-r-250-00-20-200-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 20u;
    in.values[1] = 200u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-abs-r-250-00-20-200-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-abs-r-250-00-20-200-rest bytes");
}

static void test_143(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x30, 0x00, 0x01, 0x65, 0x05};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p3-abs-200-00-50-823-mode opens");
    expect(opened.unit_address == 1u, "example worked-p3-abs-200-00-50-823-mode: station");
    expect(opened.code == 6u, "example worked-p3-abs-200-00-50-823-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p3-abs-200-00-50-823-mode decodes");
    expect(out.address == 36912u, "example worked-p3-abs-200-00-50-823-mode: address");
    expect(out.value == 1u, "example worked-p3-abs-200-00-50-823-mode: value");
    in.address = 36912u;
    in.value = 1u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p3-abs-200-00-50-823-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p3-abs-200-00-50-823-mode bytes");
}

static void test_144(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x33, 0x00, 0x0B, 0x16, 0x00, 0x32, 0x03, 0x37, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xC3, 0x87};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p3-abs-200-00-50-823-rest opens");
    expect(opened.unit_address == 1u, "example worked-p3-abs-200-00-50-823-rest: station");
    expect(opened.code == 16u, "example worked-p3-abs-200-00-50-823-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p3-abs-200-00-50-823-rest decodes");
    expect(out.address == 36915u, "example worked-p3-abs-200-00-50-823-rest: address");
    expect(out.values_count == 11u, "example worked-p3-abs-200-00-50-823-rest: values count");
    expect(out.values[0] == 50u, "example worked-p3-abs-200-00-50-823-rest: values");
    expect(out.values[1] == 823u, "example worked-p3-abs-200-00-50-823-rest: values");
    expect(out.values[2] == 0u, "example worked-p3-abs-200-00-50-823-rest: values");
    expect(out.values[3] == 0u, "example worked-p3-abs-200-00-50-823-rest: values");
    expect(out.values[4] == 0u, "example worked-p3-abs-200-00-50-823-rest: values");
    expect(out.values[5] == 0u, "example worked-p3-abs-200-00-50-823-rest: values");
    expect(out.values[6] == 0u, "example worked-p3-abs-200-00-50-823-rest: values");
    expect(out.values[7] == 300u, "example worked-p3-abs-200-00-50-823-rest: values");
    expect(out.values[8] == 300u, "example worked-p3-abs-200-00-50-823-rest: values");
    expect(out.values[9] == 0u, "example worked-p3-abs-200-00-50-823-rest: values");
    expect(out.values[10] == 65535u, "example worked-p3-abs-200-00-50-823-rest: values");
    in.address = 36915u;
    in.values_count = 11u;
    in.values[0] = 50u;
    in.values[1] = 823u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p3-abs-200-00-50-823-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p3-abs-200-00-50-823-rest bytes");
}

static void test_145(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x10, 0x00, 0x0C, 0xA5, 0x0A};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-inc-r-100-00-30-1000-to-2-mode opens");
    expect(opened.unit_address == 1u, "example worked-p1-inc-r-100-00-30-1000-to-2-mode: station");
    expect(opened.code == 6u, "example worked-p1-inc-r-100-00-30-1000-to-2-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-inc-r-100-00-30-1000-to-2-mode decodes");
    expect(out.address == 36880u, "example worked-p1-inc-r-100-00-30-1000-to-2-mode: address");
    expect(out.value == 12u, "example worked-p1-inc-r-100-00-30-1000-to-2-mode: value");
    in.address = 36880u;
    in.value = 12u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-inc-r-100-00-30-1000-to-2-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-inc-r-100-00-30-1000-to-2-mode bytes");
}

static void test_146(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x13, 0x00, 0x0B, 0x16, 0x00, 0x1E, 0x03, 0xE8, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0x00, 0x02, 0x2C, 0x20};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-inc-r-100-00-30-1000-to-2-rest opens");
    expect(opened.unit_address == 1u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: station");
    expect(opened.code == 16u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-inc-r-100-00-30-1000-to-2-rest decodes");
    expect(out.address == 36883u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: address");
    expect(out.values_count == 11u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values count");
    expect(out.values[0] == 30u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[1] == 1000u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[2] == 0u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[3] == 0u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[4] == 0u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[5] == 0u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[6] == 0u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[7] == 300u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[8] == 300u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[9] == 0u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    expect(out.values[10] == 2u, "example worked-p1-inc-r-100-00-30-1000-to-2-rest: values");
    in.address = 36883u;
    in.values_count = 11u;
    in.values[0] = 30u;
    in.values[1] = 1000u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 2u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-inc-r-100-00-30-1000-to-2-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-inc-r-100-00-30-1000-to-2-rest bytes");
}

static void test_147(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x0C, 0xA5, 0x05};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-inc-r-250-00-100-1000-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-inc-r-250-00-100-1000-mode: station");
    expect(opened.code == 6u, "example worked-p2-inc-r-250-00-100-1000-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-inc-r-250-00-100-1000-mode decodes");
    expect(out.address == 36896u, "example worked-p2-inc-r-250-00-100-1000-mode: address");
    expect(out.value == 12u, "example worked-p2-inc-r-250-00-100-1000-mode: value");
    in.address = 36896u;
    in.value = 12u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-inc-r-250-00-100-1000-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-inc-r-250-00-100-1000-mode bytes");
}

static void test_148(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x03, 0xE8, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xC2, 0x8C};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-inc-r-250-00-100-1000-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-inc-r-250-00-100-1000-rest: station");
    expect(opened.code == 16u, "example worked-p2-inc-r-250-00-100-1000-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-inc-r-250-00-100-1000-rest decodes");
    expect(out.address == 36899u, "example worked-p2-inc-r-250-00-100-1000-rest: address");
    expect(out.values_count == 11u, "example worked-p2-inc-r-250-00-100-1000-rest: values count");
    expect(out.values[0] == 100u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    expect(out.values[1] == 1000u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-inc-r-250-00-100-1000-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 1000u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-inc-r-250-00-100-1000-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-inc-r-250-00-100-1000-rest bytes");
}

static void test_149(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x10, 0x00, 0x0C, 0xA5, 0x0A};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-inc-r-210-00-100-500-to-2-mode opens");
    expect(opened.unit_address == 1u, "example worked-p1-inc-r-210-00-100-500-to-2-mode: station");
    expect(opened.code == 6u, "example worked-p1-inc-r-210-00-100-500-to-2-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-inc-r-210-00-100-500-to-2-mode decodes");
    expect(out.address == 36880u, "example worked-p1-inc-r-210-00-100-500-to-2-mode: address");
    expect(out.value == 12u, "example worked-p1-inc-r-210-00-100-500-to-2-mode: value");
    in.address = 36880u;
    in.value = 12u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-inc-r-210-00-100-500-to-2-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-inc-r-210-00-100-500-to-2-mode bytes");
}

static void test_150(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x13, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0x00, 0x02, 0x53, 0xCD};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-inc-r-210-00-100-500-to-2-rest opens");
    expect(opened.unit_address == 1u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: station");
    expect(opened.code == 16u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-inc-r-210-00-100-500-to-2-rest decodes");
    expect(out.address == 36883u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: address");
    expect(out.values_count == 11u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values count");
    expect(out.values[0] == 100u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    expect(out.values[1] == 500u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    expect(out.values[2] == 0u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    expect(out.values[3] == 0u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    expect(out.values[4] == 0u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    expect(out.values[5] == 0u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    expect(out.values[6] == 0u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    expect(out.values[7] == 300u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    expect(out.values[8] == 300u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    expect(out.values[9] == 0u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    expect(out.values[10] == 2u, "example worked-p1-inc-r-210-00-100-500-to-2-rest: values");
    in.address = 36883u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 500u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 2u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-inc-r-210-00-100-500-to-2-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-inc-r-210-00-100-500-to-2-rest bytes");
}

static void test_151(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x0C, 0xA5, 0x05};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-inc-r-50-00-20-200-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-inc-r-50-00-20-200-mode: station");
    expect(opened.code == 6u, "example worked-p2-inc-r-50-00-20-200-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-inc-r-50-00-20-200-mode decodes");
    expect(out.address == 36896u, "example worked-p2-inc-r-50-00-20-200-mode: address");
    expect(out.value == 12u, "example worked-p2-inc-r-50-00-20-200-mode: value");
    in.address = 36896u;
    in.value = 12u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-inc-r-50-00-20-200-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-inc-r-50-00-20-200-mode bytes");
}

static void test_152(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x14, 0x00, 0xC8, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0x76, 0x4F};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-inc-r-50-00-20-200-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-inc-r-50-00-20-200-rest: station");
    expect(opened.code == 16u, "example worked-p2-inc-r-50-00-20-200-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-inc-r-50-00-20-200-rest decodes");
    expect(out.address == 36899u, "example worked-p2-inc-r-50-00-20-200-rest: address");
    expect(out.values_count == 11u, "example worked-p2-inc-r-50-00-20-200-rest: values count");
    expect(out.values[0] == 20u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    expect(out.values[1] == 200u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-inc-r-50-00-20-200-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 20u;
    in.values[1] = 200u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-inc-r-50-00-20-200-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-inc-r-50-00-20-200-rest bytes");
}

static void test_153(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x10, 0x00, 0x0E, 0x1C, 0x00, 0x0F, 0x00, 0x00, 0x00, 0x00, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xF9, 0x71};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-inc-t-0-00-100-500 opens");
    expect(opened.unit_address == 1u, "example worked-p1-inc-t-0-00-100-500: station");
    expect(opened.code == 16u, "example worked-p1-inc-t-0-00-100-500: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-inc-t-0-00-100-500 decodes");
    expect(out.address == 36880u, "example worked-p1-inc-t-0-00-100-500: address");
    expect(out.values_count == 14u, "example worked-p1-inc-t-0-00-100-500: values count");
    expect(out.values[0] == 15u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[1] == 0u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[2] == 0u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[3] == 100u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[4] == 500u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[5] == 0u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[6] == 0u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[7] == 0u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[8] == 0u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[9] == 0u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[10] == 300u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[11] == 300u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[12] == 0u, "example worked-p1-inc-t-0-00-100-500: values");
    expect(out.values[13] == 65535u, "example worked-p1-inc-t-0-00-100-500: values");
    in.address = 36880u;
    in.values_count = 14u;
    in.values[0] = 15u;
    in.values[1] = 0u;
    in.values[2] = 0u;
    in.values[3] = 100u;
    in.values[4] = 500u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 0u;
    in.values[8] = 0u;
    in.values[9] = 0u;
    in.values[10] = 300u;
    in.values[11] = 300u;
    in.values[12] = 0u;
    in.values[13] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-inc-t-0-00-100-500 encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-inc-t-0-00-100-500 bytes");
}

static void test_154(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x0F, 0xE5, 0x04};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-inc-t-250-00-100-500-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-inc-t-250-00-100-500-mode: station");
    expect(opened.code == 6u, "example worked-p2-inc-t-250-00-100-500-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-inc-t-250-00-100-500-mode decodes");
    expect(out.address == 36896u, "example worked-p2-inc-t-250-00-100-500-mode: address");
    expect(out.value == 15u, "example worked-p2-inc-t-250-00-100-500-mode: value");
    in.address = 36896u;
    in.value = 15u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-inc-t-250-00-100-500-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-inc-t-250-00-100-500-mode bytes");
}

static void test_155(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0x6C, 0xFC};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-inc-t-250-00-100-500-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-inc-t-250-00-100-500-rest: station");
    expect(opened.code == 16u, "example worked-p2-inc-t-250-00-100-500-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-inc-t-250-00-100-500-rest decodes");
    expect(out.address == 36899u, "example worked-p2-inc-t-250-00-100-500-rest: address");
    expect(out.values_count == 11u, "example worked-p2-inc-t-250-00-100-500-rest: values count");
    expect(out.values[0] == 100u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    expect(out.values[1] == 500u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-inc-t-250-00-100-500-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 500u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-inc-t-250-00-100-500-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-inc-t-250-00-100-500-rest bytes");
}

static void test_156(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x30, 0x00, 0x0F, 0xE4, 0xC1};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p3-inc-t-m128-55-50-823-mode opens");
    expect(opened.unit_address == 1u, "example worked-p3-inc-t-m128-55-50-823-mode: station");
    expect(opened.code == 6u, "example worked-p3-inc-t-m128-55-50-823-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p3-inc-t-m128-55-50-823-mode decodes");
    expect(out.address == 36912u, "example worked-p3-inc-t-m128-55-50-823-mode: address");
    expect(out.value == 15u, "example worked-p3-inc-t-m128-55-50-823-mode: value");
    in.address = 36912u;
    in.value = 15u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p3-inc-t-m128-55-50-823-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p3-inc-t-m128-55-50-823-mode bytes");
}

static void test_157(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x33, 0x00, 0x0B, 0x16, 0x00, 0x32, 0x03, 0x37, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xC3, 0x87};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p3-inc-t-m128-55-50-823-rest opens");
    expect(opened.unit_address == 1u, "example worked-p3-inc-t-m128-55-50-823-rest: station");
    expect(opened.code == 16u, "example worked-p3-inc-t-m128-55-50-823-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p3-inc-t-m128-55-50-823-rest decodes");
    expect(out.address == 36915u, "example worked-p3-inc-t-m128-55-50-823-rest: address");
    expect(out.values_count == 11u, "example worked-p3-inc-t-m128-55-50-823-rest: values count");
    expect(out.values[0] == 50u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    expect(out.values[1] == 823u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    expect(out.values[2] == 0u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    expect(out.values[3] == 0u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    expect(out.values[4] == 0u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    expect(out.values[5] == 0u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    expect(out.values[6] == 0u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    expect(out.values[7] == 300u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    expect(out.values[8] == 300u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    expect(out.values[9] == 0u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    expect(out.values[10] == 65535u, "example worked-p3-inc-t-m128-55-50-823-rest: values");
    in.address = 36915u;
    in.values_count = 11u;
    in.values[0] = 50u;
    in.values[1] = 823u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p3-inc-t-m128-55-50-823-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p3-inc-t-m128-55-50-823-rest bytes");
}

static void test_158(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x10, 0xA4, 0xCC};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-abs-t-250-00-100-500-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-abs-t-250-00-100-500-mode: station");
    expect(opened.code == 6u, "example worked-p2-abs-t-250-00-100-500-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-abs-t-250-00-100-500-mode decodes");
    expect(out.address == 36896u, "example worked-p2-abs-t-250-00-100-500-mode: address");
    expect(out.value == 16u, "example worked-p2-abs-t-250-00-100-500-mode: value");
    in.address = 36896u;
    in.value = 16u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-abs-t-250-00-100-500-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-abs-t-250-00-100-500-mode bytes");
}

static void test_159(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0x6C, 0xFC};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-abs-t-250-00-100-500-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-abs-t-250-00-100-500-rest: station");
    expect(opened.code == 16u, "example worked-p2-abs-t-250-00-100-500-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-abs-t-250-00-100-500-rest decodes");
    expect(out.address == 36899u, "example worked-p2-abs-t-250-00-100-500-rest: address");
    expect(out.values_count == 11u, "example worked-p2-abs-t-250-00-100-500-rest: values count");
    expect(out.values[0] == 100u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    expect(out.values[1] == 500u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-abs-t-250-00-100-500-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 500u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-abs-t-250-00-100-500-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-abs-t-250-00-100-500-rest bytes");
}

static void test_160(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x30, 0x00, 0x10, 0xA5, 0x09};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p3-abs-t-128-55-50-823-mode opens");
    expect(opened.unit_address == 1u, "example worked-p3-abs-t-128-55-50-823-mode: station");
    expect(opened.code == 6u, "example worked-p3-abs-t-128-55-50-823-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p3-abs-t-128-55-50-823-mode decodes");
    expect(out.address == 36912u, "example worked-p3-abs-t-128-55-50-823-mode: address");
    expect(out.value == 16u, "example worked-p3-abs-t-128-55-50-823-mode: value");
    in.address = 36912u;
    in.value = 16u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p3-abs-t-128-55-50-823-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p3-abs-t-128-55-50-823-mode bytes");
}

static void test_161(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x33, 0x00, 0x0B, 0x16, 0x00, 0x32, 0x03, 0x37, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0xC3, 0x87};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p3-abs-t-128-55-50-823-rest opens");
    expect(opened.unit_address == 1u, "example worked-p3-abs-t-128-55-50-823-rest: station");
    expect(opened.code == 16u, "example worked-p3-abs-t-128-55-50-823-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p3-abs-t-128-55-50-823-rest decodes");
    expect(out.address == 36915u, "example worked-p3-abs-t-128-55-50-823-rest: address");
    expect(out.values_count == 11u, "example worked-p3-abs-t-128-55-50-823-rest: values count");
    expect(out.values[0] == 50u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    expect(out.values[1] == 823u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    expect(out.values[2] == 0u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    expect(out.values[3] == 0u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    expect(out.values[4] == 0u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    expect(out.values[5] == 0u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    expect(out.values[6] == 0u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    expect(out.values[7] == 300u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    expect(out.values[8] == 300u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    expect(out.values[9] == 0u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    expect(out.values[10] == 65535u, "example worked-p3-abs-t-128-55-50-823-rest: values");
    in.address = 36915u;
    in.values_count = 11u;
    in.values[0] = 50u;
    in.values[1] = 823u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p3-abs-t-128-55-50-823-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p3-abs-t-128-55-50-823-rest bytes");
}

static void test_162(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x10, 0x00, 0x0E, 0x1C, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x01, 0xF4, 0x00, 0x02, 0xC7, 0x97};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p1-abs-0-00-100-500-to-2 opens");
    expect(opened.unit_address == 1u, "example worked-p1-abs-0-00-100-500-to-2: station");
    expect(opened.code == 16u, "example worked-p1-abs-0-00-100-500-to-2: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p1-abs-0-00-100-500-to-2 decodes");
    expect(out.address == 36880u, "example worked-p1-abs-0-00-100-500-to-2: address");
    expect(out.values_count == 14u, "example worked-p1-abs-0-00-100-500-to-2: values count");
    expect(out.values[0] == 1u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[1] == 0u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[2] == 0u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[3] == 100u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[4] == 500u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[5] == 0u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[6] == 0u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[7] == 0u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[8] == 0u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[9] == 0u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[10] == 300u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[11] == 300u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[12] == 500u, "example worked-p1-abs-0-00-100-500-to-2: values");
    expect(out.values[13] == 2u, "example worked-p1-abs-0-00-100-500-to-2: values");
    in.address = 36880u;
    in.values_count = 14u;
    in.values[0] = 1u;
    in.values[1] = 0u;
    in.values[2] = 0u;
    in.values[3] = 100u;
    in.values[4] = 500u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 0u;
    in.values[8] = 0u;
    in.values[9] = 0u;
    in.values[10] = 300u;
    in.values[11] = 300u;
    in.values[12] = 500u;
    in.values[13] = 2u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p1-abs-0-00-100-500-to-2 encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p1-abs-0-00-100-500-to-2 bytes");
}

static void test_163(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x90, 0x20, 0x00, 0x01, 0x64, 0xC0};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-abs-200-100-500-mode opens");
    expect(opened.unit_address == 1u, "example worked-p2-abs-200-100-500-mode: station");
    expect(opened.code == 6u, "example worked-p2-abs-200-100-500-mode: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-abs-200-100-500-mode decodes");
    expect(out.address == 36896u, "example worked-p2-abs-200-100-500-mode: address");
    expect(out.value == 1u, "example worked-p2-abs-200-100-500-mode: value");
    in.address = 36896u;
    in.value = 1u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-abs-200-100-500-mode encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-abs-200-100-500-mode bytes");
}

static void test_164(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x90, 0x23, 0x00, 0x0B, 0x16, 0x00, 0x64, 0x01, 0xF4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x2C, 0x01, 0x2C, 0x00, 0x00, 0xFF, 0xFF, 0x6C, 0xFC};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example worked-p2-abs-200-100-500-rest opens");
    expect(opened.unit_address == 1u, "example worked-p2-abs-200-100-500-rest: station");
    expect(opened.code == 16u, "example worked-p2-abs-200-100-500-rest: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example worked-p2-abs-200-100-500-rest decodes");
    expect(out.address == 36899u, "example worked-p2-abs-200-100-500-rest: address");
    expect(out.values_count == 11u, "example worked-p2-abs-200-100-500-rest: values count");
    expect(out.values[0] == 100u, "example worked-p2-abs-200-100-500-rest: values");
    expect(out.values[1] == 500u, "example worked-p2-abs-200-100-500-rest: values");
    expect(out.values[2] == 0u, "example worked-p2-abs-200-100-500-rest: values");
    expect(out.values[3] == 0u, "example worked-p2-abs-200-100-500-rest: values");
    expect(out.values[4] == 0u, "example worked-p2-abs-200-100-500-rest: values");
    expect(out.values[5] == 0u, "example worked-p2-abs-200-100-500-rest: values");
    expect(out.values[6] == 0u, "example worked-p2-abs-200-100-500-rest: values");
    expect(out.values[7] == 300u, "example worked-p2-abs-200-100-500-rest: values");
    expect(out.values[8] == 300u, "example worked-p2-abs-200-100-500-rest: values");
    expect(out.values[9] == 0u, "example worked-p2-abs-200-100-500-rest: values");
    expect(out.values[10] == 65535u, "example worked-p2-abs-200-100-500-rest: values");
    in.address = 36899u;
    in.values_count = 11u;
    in.values[0] = 100u;
    in.values[1] = 500u;
    in.values[2] = 0u;
    in.values[3] = 0u;
    in.values[4] = 0u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 300u;
    in.values[8] = 300u;
    in.values[9] = 0u;
    in.values[10] = 65535u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example worked-p2-abs-200-100-500-rest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example worked-p2-abs-200-100-500-rest bytes");
}

static void test_165(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x20, 0x1E, 0x00, 0x03, 0xA2, 0x0D};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example rtu-homing opens");
    expect(opened.unit_address == 1u, "example rtu-homing: station");
    expect(opened.code == 6u, "example rtu-homing: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example rtu-homing decodes");
    expect(out.address == 8222u, "example rtu-homing: address");
    expect(out.value == 3u, "example rtu-homing: value");
    in.address = 8222u;
    in.value = 3u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example rtu-homing encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-homing bytes");
}

static void test_166(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x32, 0x30, 0x31, 0x45, 0x30, 0x30, 0x30, 0x33, 0x42, 0x38, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    tc100_ascii_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == TC100_OK, "example ascii-homing opens");
    expect(opened.unit_address == 1u, "example ascii-homing: station");
    expect(opened.code == 6u, "example ascii-homing: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example ascii-homing decodes");
    expect(out.address == 8222u, "example ascii-homing: address");
    expect(out.value == 3u, "example ascii-homing: value");
    in.address = 8222u;
    in.value = 3u;
    expect(tc100_ascii_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example ascii-homing encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-homing bytes");
}

static void test_167(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x39, 0x39, 0x39, 0x42, 0x30, 0x30, 0x30, 0x34, 0x30, 0x38, 0x34, 0x43, 0x37, 0x36, 0x33, 0x30, 0x33, 0x31, 0x35, 0x34, 0x37, 0x39, 0x35, 0x36, 0x36, 0x37, 0x30, 0x32, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    tc100_ascii_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == TC100_OK, "example ascii-write-enable opens");
    expect(opened.unit_address == 1u, "example ascii-write-enable: station");
    expect(opened.code == 16u, "example ascii-write-enable: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example ascii-write-enable decodes");
    expect(out.address == 39323u, "example ascii-write-enable: address");
    expect(out.values_count == 4u, "example ascii-write-enable: values count");
    expect(out.values[0] == 19574u, "example ascii-write-enable: values");
    expect(out.values[1] == 12337u, "example ascii-write-enable: values");
    expect(out.values[2] == 21625u, "example ascii-write-enable: values");
    expect(out.values[3] == 22119u, "example ascii-write-enable: values");
    in.address = 39323u;
    in.values_count = 4u;
    in.values[0] = 19574u;
    in.values[1] = 12337u;
    in.values[2] = 21625u;
    in.values[3] = 22119u;
    expect(tc100_ascii_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example ascii-write-enable encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-write-enable bytes");
}

static void test_168(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x34, 0x32, 0x30, 0x31, 0x45, 0x30, 0x30, 0x30, 0x33, 0x42, 0x41, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    tc100_ascii_request_frame opened;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == TC100_ERR_UNKNOWN_CODE, "example unknown-function-04-request");
}

static void test_169(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x38, 0x34, 0x30, 0x31, 0x37, 0x41, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    tc100_ascii_response_frame opened;
    tc100_exception in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == TC100_OK, "example unknown-function-04-response opens");
    expect(opened.unit_address == 1u, "example unknown-function-04-response: station");
    expect(opened.code == 4u, "example unknown-function-04-response: code");
    expect(opened.error == true, "example unknown-function-04-response: error");
    expect(tc100_exception_decode(opened.body, opened.body_length, &out) == TC100_OK, "example unknown-function-04-response decodes");
    expect(out.exception_code == 1u, "example unknown-function-04-response: exception_code");
    in.exception_code = 1u;
    expect(tc100_ascii_encode_exception_response(1u, 4u, &in, again, sizeof again, &length) == TC100_OK, "example unknown-function-04-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example unknown-function-04-response bytes");
}

static void test_170(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x39, 0x30, 0x32, 0x30, 0x31, 0x45, 0x30, 0x30, 0x30, 0x33, 0x32, 0x45, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    tc100_ascii_request_frame opened;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == TC100_ERR_UNKNOWN_CODE, "example unknown-function-90-request");
}

static void test_171(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x39, 0x30, 0x30, 0x31, 0x36, 0x45, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    tc100_ascii_response_frame opened;
    tc100_exception in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == TC100_OK, "example unknown-function-90-response opens");
    expect(opened.unit_address == 1u, "example unknown-function-90-response: station");
    expect(opened.code == 16u, "example unknown-function-90-response: code");
    expect(opened.error == true, "example unknown-function-90-response: error");
    expect(tc100_exception_decode(opened.body, opened.body_length, &out) == TC100_OK, "example unknown-function-90-response decodes");
    expect(out.exception_code == 1u, "example unknown-function-90-response: exception_code");
    in.exception_code = 1u;
    expect(tc100_ascii_encode_exception_response(1u, 16u, &in, again, sizeof again, &length) == TC100_OK, "example unknown-function-90-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example unknown-function-90-response bytes");
}

static void test_172(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x10, 0x00, 0x00, 0x01, 0x80, 0xCA};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example rtu-read-action-status opens");
    expect(opened.unit_address == 1u, "example rtu-read-action-status: station");
    expect(opened.code == 3u, "example rtu-read-action-status: code");
    expect(tc100_read_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example rtu-read-action-status decodes");
    expect(out.address == 4096u, "example rtu-read-action-status: address");
    expect(out.word_count == 1u, "example rtu-read-action-status: word_count");
    in.address = 4096u;
    in.word_count = 1u;
    expect(tc100_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example rtu-read-action-status encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-read-action-status bytes");
}

static void test_173(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x20, 0x1E, 0x00, 0x03, 0xA2, 0x0D};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example rtu-homing-8.4 opens");
    expect(opened.unit_address == 1u, "example rtu-homing-8.4: station");
    expect(opened.code == 6u, "example rtu-homing-8.4: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example rtu-homing-8.4 decodes");
    expect(out.address == 8222u, "example rtu-homing-8.4: address");
    expect(out.value == 3u, "example rtu-homing-8.4: value");
    in.address = 8222u;
    in.value = 3u;
    expect(tc100_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example rtu-homing-8.4 encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-homing-8.4 bytes");
}

static void test_174(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x20, 0x00, 0x00, 0x02, 0x04, 0x00, 0x00, 0x00, 0x64, 0x6B, 0x85};
    uint8_t received[sizeof frame];
    tc100_rtu_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_rtu_request_open(received, sizeof received, &opened) == TC100_OK, "example rtu-write-relative-distance opens");
    expect(opened.unit_address == 1u, "example rtu-write-relative-distance: station");
    expect(opened.code == 16u, "example rtu-write-relative-distance: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example rtu-write-relative-distance decodes");
    expect(out.address == 8192u, "example rtu-write-relative-distance: address");
    expect(out.values_count == 2u, "example rtu-write-relative-distance: values count");
    expect(out.values[0] == 0u, "example rtu-write-relative-distance: values");
    expect(out.values[1] == 100u, "example rtu-write-relative-distance: values");
    in.address = 8192u;
    in.values_count = 2u;
    in.values[0] = 0u;
    in.values[1] = 100u;
    expect(tc100_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example rtu-write-relative-distance encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-write-relative-distance bytes");
}

static void test_175(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x31, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x45, 0x42, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    tc100_ascii_request_frame opened;
    tc100_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == TC100_OK, "example ascii-read-action-status opens");
    expect(opened.unit_address == 1u, "example ascii-read-action-status: station");
    expect(opened.code == 3u, "example ascii-read-action-status: code");
    expect(tc100_read_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example ascii-read-action-status decodes");
    expect(out.address == 4096u, "example ascii-read-action-status: address");
    expect(out.word_count == 1u, "example ascii-read-action-status: word_count");
    in.address = 4096u;
    in.word_count = 1u;
    expect(tc100_ascii_encode_read_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example ascii-read-action-status encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-read-action-status bytes");
}

static void test_176(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x32, 0x30, 0x31, 0x45, 0x30, 0x30, 0x30, 0x33, 0x42, 0x38, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    tc100_ascii_request_frame opened;
    tc100_write_register_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == TC100_OK, "example ascii-homing-8.5 opens");
    expect(opened.unit_address == 1u, "example ascii-homing-8.5: station");
    expect(opened.code == 6u, "example ascii-homing-8.5: code");
    expect(tc100_write_register_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example ascii-homing-8.5 decodes");
    expect(out.address == 8222u, "example ascii-homing-8.5: address");
    expect(out.value == 3u, "example ascii-homing-8.5: value");
    in.address = 8222u;
    in.value = 3u;
    expect(tc100_ascii_encode_write_register_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example ascii-homing-8.5 encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-homing-8.5 bytes");
}

static void test_177(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x32, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x32, 0x30, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x36, 0x34, 0x36, 0x35, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    tc100_ascii_request_frame opened;
    tc100_write_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(tc100_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == TC100_OK, "example ascii-write-relative-distance opens");
    expect(opened.unit_address == 1u, "example ascii-write-relative-distance: station");
    expect(opened.code == 16u, "example ascii-write-relative-distance: code");
    expect(tc100_write_registers_request_decode(opened.body, opened.body_length, &out) == TC100_OK, "example ascii-write-relative-distance decodes");
    expect(out.address == 8192u, "example ascii-write-relative-distance: address");
    expect(out.values_count == 2u, "example ascii-write-relative-distance: values count");
    expect(out.values[0] == 0u, "example ascii-write-relative-distance: values");
    expect(out.values[1] == 100u, "example ascii-write-relative-distance: values");
    in.address = 8192u;
    in.values_count = 2u;
    in.values[0] = 0u;
    in.values[1] = 100u;
    expect(tc100_ascii_encode_write_registers_request(1u, &in, again, sizeof again, &length) == TC100_OK, "example ascii-write-relative-distance encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-write-relative-distance bytes");
}

static void test_178(void)
{
    expect(tc100_point_speed_is_absent(TC100_POINT_SPEED_ABSENT_START_SPEED) == true, "tc100_point_speed_is_absent start_speed");
    expect(tc100_point_speed_is_absent(1u) == false, "tc100_point_speed_is_absent 1");
}

static void test_179(void)
{
    expect(tc100_point_next_point_is_absent(TC100_POINT_NEXT_POINT_ABSENT_END) == true, "tc100_point_next_point_is_absent end");
    expect(tc100_point_next_point_is_absent((-2)) == false, "tc100_point_next_point_is_absent -2");
    expect(tc100_point_next_point_is_absent(0) == false, "tc100_point_next_point_is_absent 0");
    expect(tc100_point_next_point_is_absent(1) == false, "tc100_point_next_point_is_absent 1");
}

static void test_180(void)
{
    expect(tc100_reg_jog_positive_input_is_absent(TC100_REG_JOG_POSITIVE_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_jog_positive_input_is_absent not_used");
    expect(tc100_reg_jog_positive_input_is_absent(1u) == false, "tc100_reg_jog_positive_input_is_absent 1");
}

static void test_181(void)
{
    expect(tc100_reg_jog_negative_input_is_absent(TC100_REG_JOG_NEGATIVE_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_jog_negative_input_is_absent not_used");
    expect(tc100_reg_jog_negative_input_is_absent(1u) == false, "tc100_reg_jog_negative_input_is_absent 1");
}

static void test_182(void)
{
    expect(tc100_reg_manual_mode_input_is_absent(TC100_REG_MANUAL_MODE_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_manual_mode_input_is_absent not_used");
    expect(tc100_reg_manual_mode_input_is_absent(1u) == false, "tc100_reg_manual_mode_input_is_absent 1");
}

static void test_183(void)
{
    expect(tc100_reg_teach_input_is_absent(TC100_REG_TEACH_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_teach_input_is_absent not_used");
    expect(tc100_reg_teach_input_is_absent(1u) == false, "tc100_reg_teach_input_is_absent 1");
}

static void test_184(void)
{
    expect(tc100_reg_lock_input_is_absent(TC100_REG_LOCK_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_lock_input_is_absent not_used");
    expect(tc100_reg_lock_input_is_absent(1u) == false, "tc100_reg_lock_input_is_absent 1");
}

static void test_185(void)
{
    expect(tc100_reg_point_select_bit_4_input_is_absent(TC100_REG_POINT_SELECT_BIT_4_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_point_select_bit_4_input_is_absent not_used");
    expect(tc100_reg_point_select_bit_4_input_is_absent(1u) == false, "tc100_reg_point_select_bit_4_input_is_absent 1");
}

static void test_186(void)
{
    expect(tc100_reg_point_select_bit_5_input_is_absent(TC100_REG_POINT_SELECT_BIT_5_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_point_select_bit_5_input_is_absent not_used");
    expect(tc100_reg_point_select_bit_5_input_is_absent(1u) == false, "tc100_reg_point_select_bit_5_input_is_absent 1");
}

static void test_187(void)
{
    expect(tc100_reg_point_select_bit_6_input_is_absent(TC100_REG_POINT_SELECT_BIT_6_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_point_select_bit_6_input_is_absent not_used");
    expect(tc100_reg_point_select_bit_6_input_is_absent(1u) == false, "tc100_reg_point_select_bit_6_input_is_absent 1");
}

static void test_188(void)
{
    expect(tc100_reg_homing_sensor_input_is_absent(TC100_REG_HOMING_SENSOR_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_homing_sensor_input_is_absent not_used");
    expect(tc100_reg_homing_sensor_input_is_absent(1u) == false, "tc100_reg_homing_sensor_input_is_absent 1");
}

static void test_189(void)
{
    expect(tc100_reg_brake_input_is_absent(TC100_REG_BRAKE_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_brake_input_is_absent not_used");
    expect(tc100_reg_brake_input_is_absent(1u) == false, "tc100_reg_brake_input_is_absent 1");
}

static void test_190(void)
{
    expect(tc100_reg_full_count_input_is_absent(TC100_REG_FULL_COUNT_INPUT_ABSENT_NOT_USED) == true, "tc100_reg_full_count_input_is_absent not_used");
    expect(tc100_reg_full_count_input_is_absent(1u) == false, "tc100_reg_full_count_input_is_absent 1");
}

static void test_191(void)
{
    expect(tc100_reg_in_position_output_is_absent(TC100_REG_IN_POSITION_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_in_position_output_is_absent not_used");
    expect(tc100_reg_in_position_output_is_absent(1u) == false, "tc100_reg_in_position_output_is_absent 1");
}

static void test_192(void)
{
    expect(tc100_reg_alarm_output_is_absent(TC100_REG_ALARM_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_alarm_output_is_absent not_used");
    expect(tc100_reg_alarm_output_is_absent(1u) == false, "tc100_reg_alarm_output_is_absent 1");
}

static void test_193(void)
{
    expect(tc100_reg_ready_output_is_absent(TC100_REG_READY_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_ready_output_is_absent not_used");
    expect(tc100_reg_ready_output_is_absent(1u) == false, "tc100_reg_ready_output_is_absent 1");
}

static void test_194(void)
{
    expect(tc100_reg_moving_output_is_absent(TC100_REG_MOVING_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_moving_output_is_absent not_used");
    expect(tc100_reg_moving_output_is_absent(1u) == false, "tc100_reg_moving_output_is_absent 1");
}

static void test_195(void)
{
    expect(tc100_reg_servo_on_output_is_absent(TC100_REG_SERVO_ON_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_servo_on_output_is_absent not_used");
    expect(tc100_reg_servo_on_output_is_absent(1u) == false, "tc100_reg_servo_on_output_is_absent 1");
}

static void test_196(void)
{
    expect(tc100_reg_point_select_bit_0_output_is_absent(TC100_REG_POINT_SELECT_BIT_0_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_point_select_bit_0_output_is_absent not_used");
    expect(tc100_reg_point_select_bit_0_output_is_absent(1u) == false, "tc100_reg_point_select_bit_0_output_is_absent 1");
}

static void test_197(void)
{
    expect(tc100_reg_point_select_bit_1_output_is_absent(TC100_REG_POINT_SELECT_BIT_1_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_point_select_bit_1_output_is_absent not_used");
    expect(tc100_reg_point_select_bit_1_output_is_absent(1u) == false, "tc100_reg_point_select_bit_1_output_is_absent 1");
}

static void test_198(void)
{
    expect(tc100_reg_point_select_bit_2_output_is_absent(TC100_REG_POINT_SELECT_BIT_2_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_point_select_bit_2_output_is_absent not_used");
    expect(tc100_reg_point_select_bit_2_output_is_absent(1u) == false, "tc100_reg_point_select_bit_2_output_is_absent 1");
}

static void test_199(void)
{
    expect(tc100_reg_point_select_bit_3_output_is_absent(TC100_REG_POINT_SELECT_BIT_3_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_point_select_bit_3_output_is_absent not_used");
    expect(tc100_reg_point_select_bit_3_output_is_absent(1u) == false, "tc100_reg_point_select_bit_3_output_is_absent 1");
}

static void test_200(void)
{
    expect(tc100_reg_point_select_bit_4_output_is_absent(TC100_REG_POINT_SELECT_BIT_4_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_point_select_bit_4_output_is_absent not_used");
    expect(tc100_reg_point_select_bit_4_output_is_absent(1u) == false, "tc100_reg_point_select_bit_4_output_is_absent 1");
}

static void test_201(void)
{
    expect(tc100_reg_point_select_bit_5_output_is_absent(TC100_REG_POINT_SELECT_BIT_5_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_point_select_bit_5_output_is_absent not_used");
    expect(tc100_reg_point_select_bit_5_output_is_absent(1u) == false, "tc100_reg_point_select_bit_5_output_is_absent 1");
}

static void test_202(void)
{
    expect(tc100_reg_point_select_bit_6_output_is_absent(TC100_REG_POINT_SELECT_BIT_6_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_point_select_bit_6_output_is_absent not_used");
    expect(tc100_reg_point_select_bit_6_output_is_absent(1u) == false, "tc100_reg_point_select_bit_6_output_is_absent 1");
}

static void test_203(void)
{
    expect(tc100_reg_torque_limit_output_is_absent(TC100_REG_TORQUE_LIMIT_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_torque_limit_output_is_absent not_used");
    expect(tc100_reg_torque_limit_output_is_absent(1u) == false, "tc100_reg_torque_limit_output_is_absent 1");
}

static void test_204(void)
{
    expect(tc100_reg_error_bit_0_output_is_absent(TC100_REG_ERROR_BIT_0_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_error_bit_0_output_is_absent not_used");
    expect(tc100_reg_error_bit_0_output_is_absent(1u) == false, "tc100_reg_error_bit_0_output_is_absent 1");
}

static void test_205(void)
{
    expect(tc100_reg_error_bit_1_output_is_absent(TC100_REG_ERROR_BIT_1_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_error_bit_1_output_is_absent not_used");
    expect(tc100_reg_error_bit_1_output_is_absent(1u) == false, "tc100_reg_error_bit_1_output_is_absent 1");
}

static void test_206(void)
{
    expect(tc100_reg_error_bit_2_output_is_absent(TC100_REG_ERROR_BIT_2_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_error_bit_2_output_is_absent not_used");
    expect(tc100_reg_error_bit_2_output_is_absent(1u) == false, "tc100_reg_error_bit_2_output_is_absent 1");
}

static void test_207(void)
{
    expect(tc100_reg_error_bit_3_output_is_absent(TC100_REG_ERROR_BIT_3_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_error_bit_3_output_is_absent not_used");
    expect(tc100_reg_error_bit_3_output_is_absent(1u) == false, "tc100_reg_error_bit_3_output_is_absent 1");
}

static void test_208(void)
{
    expect(tc100_reg_zone_output_is_absent(TC100_REG_ZONE_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_zone_output_is_absent not_used");
    expect(tc100_reg_zone_output_is_absent(1u) == false, "tc100_reg_zone_output_is_absent 1");
}

static void test_209(void)
{
    expect(tc100_reg_near_output_is_absent(TC100_REG_NEAR_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_near_output_is_absent not_used");
    expect(tc100_reg_near_output_is_absent(1u) == false, "tc100_reg_near_output_is_absent 1");
}

static void test_210(void)
{
    expect(tc100_reg_soft_limit_output_is_absent(TC100_REG_SOFT_LIMIT_OUTPUT_ABSENT_NOT_USED) == true, "tc100_reg_soft_limit_output_is_absent not_used");
    expect(tc100_reg_soft_limit_output_is_absent(1u) == false, "tc100_reg_soft_limit_output_is_absent 1");
}

static void test_211(void)
{
    expect(tc100_reg_motion_speed_is_absent(TC100_REG_MOTION_SPEED_ABSENT_START_SPEED) == true, "tc100_reg_motion_speed_is_absent start_speed");
    expect(tc100_reg_motion_speed_is_absent(1u) == false, "tc100_reg_motion_speed_is_absent 1");
}

static void test_212(void)
{
    expect(tc100_reg_soft_limit_positive_is_absent(TC100_REG_SOFT_LIMIT_POSITIVE_ABSENT_NO_LIMIT) == true, "tc100_reg_soft_limit_positive_is_absent no_limit");
    expect(tc100_reg_soft_limit_positive_is_absent((-1)) == false, "tc100_reg_soft_limit_positive_is_absent -1");
    expect(tc100_reg_soft_limit_positive_is_absent(1) == false, "tc100_reg_soft_limit_positive_is_absent 1");
}

static void test_213(void)
{
    expect(tc100_reg_soft_limit_negative_is_absent(TC100_REG_SOFT_LIMIT_NEGATIVE_ABSENT_NO_LIMIT) == true, "tc100_reg_soft_limit_negative_is_absent no_limit");
    expect(tc100_reg_soft_limit_negative_is_absent((-1)) == false, "tc100_reg_soft_limit_negative_is_absent -1");
    expect(tc100_reg_soft_limit_negative_is_absent(1) == false, "tc100_reg_soft_limit_negative_is_absent 1");
}

static void test_214(void)
{
    expect(tc100_reg_homing_speed_is_absent(TC100_REG_HOMING_SPEED_ABSENT_START_SPEED) == true, "tc100_reg_homing_speed_is_absent start_speed");
    expect(tc100_reg_homing_speed_is_absent(1u) == false, "tc100_reg_homing_speed_is_absent 1");
}

static void test_215(void)
{
    expect(tc100_reg_homing_offset_speed_is_absent(TC100_REG_HOMING_OFFSET_SPEED_ABSENT_START_SPEED) == true, "tc100_reg_homing_offset_speed_is_absent start_speed");
    expect(tc100_reg_homing_offset_speed_is_absent(1u) == false, "tc100_reg_homing_offset_speed_is_absent 1");
}

static void test_216(void)
{
    expect(tc100_reg_executed_point_is_absent(TC100_REG_EXECUTED_POINT_ABSENT_NONE) == true, "tc100_reg_executed_point_is_absent none");
    expect(tc100_reg_executed_point_is_absent((-2)) == false, "tc100_reg_executed_point_is_absent -2");
    expect(tc100_reg_executed_point_is_absent(0) == false, "tc100_reg_executed_point_is_absent 0");
    expect(tc100_reg_executed_point_is_absent(1) == false, "tc100_reg_executed_point_is_absent 1");
}

static void test_217(void)
{
    expect(tc100_exception_exception_code_is_out_of_range(0u) == true, "tc100_exception_exception_code_is_out_of_range 0");
    expect(tc100_exception_exception_code_is_out_of_range(1u) == false, "tc100_exception_exception_code_is_out_of_range 1");
    expect(tc100_exception_exception_code_is_out_of_range(2u) == false, "tc100_exception_exception_code_is_out_of_range 2");
    expect(tc100_exception_exception_code_is_out_of_range(3u) == false, "tc100_exception_exception_code_is_out_of_range 3");
    expect(tc100_exception_exception_code_is_out_of_range(4u) == true, "tc100_exception_exception_code_is_out_of_range 4");
}

static void test_218(void)
{
    expect(tc100_point_mode_is_out_of_range(0u) == false, "tc100_point_mode_is_out_of_range 0");
    expect(tc100_point_mode_is_out_of_range(1u) == false, "tc100_point_mode_is_out_of_range 1");
    expect(tc100_point_mode_is_out_of_range(15u) == false, "tc100_point_mode_is_out_of_range 15");
    expect(tc100_point_mode_is_out_of_range(16u) == false, "tc100_point_mode_is_out_of_range 16");
    expect(tc100_point_mode_is_out_of_range(17u) == true, "tc100_point_mode_is_out_of_range 17");
}

static void test_219(void)
{
    expect(tc100_point_speed_is_out_of_range(0u) == false, "tc100_point_speed_is_out_of_range 0");
    expect(tc100_point_speed_is_out_of_range(1u) == false, "tc100_point_speed_is_out_of_range 1");
    expect(tc100_point_speed_is_out_of_range(99u) == false, "tc100_point_speed_is_out_of_range 99");
    expect(tc100_point_speed_is_out_of_range(100u) == false, "tc100_point_speed_is_out_of_range 100");
    expect(tc100_point_speed_is_out_of_range(101u) == true, "tc100_point_speed_is_out_of_range 101");
}

static void test_220(void)
{
    expect(tc100_point_torque_limit_is_out_of_range(0u) == false, "tc100_point_torque_limit_is_out_of_range 0");
    expect(tc100_point_torque_limit_is_out_of_range(1u) == false, "tc100_point_torque_limit_is_out_of_range 1");
    expect(tc100_point_torque_limit_is_out_of_range(999u) == false, "tc100_point_torque_limit_is_out_of_range 999");
    expect(tc100_point_torque_limit_is_out_of_range(1000u) == false, "tc100_point_torque_limit_is_out_of_range 1000");
    expect(tc100_point_torque_limit_is_out_of_range(1001u) == true, "tc100_point_torque_limit_is_out_of_range 1001");
}

static void test_221(void)
{
    expect(tc100_point_acceleration_time_is_out_of_range(0u) == true, "tc100_point_acceleration_time_is_out_of_range 0");
    expect(tc100_point_acceleration_time_is_out_of_range(1u) == false, "tc100_point_acceleration_time_is_out_of_range 1");
    expect(tc100_point_acceleration_time_is_out_of_range(2u) == false, "tc100_point_acceleration_time_is_out_of_range 2");
    expect(tc100_point_acceleration_time_is_out_of_range(29999u) == false, "tc100_point_acceleration_time_is_out_of_range 29999");
    expect(tc100_point_acceleration_time_is_out_of_range(30000u) == false, "tc100_point_acceleration_time_is_out_of_range 30000");
    expect(tc100_point_acceleration_time_is_out_of_range(30001u) == true, "tc100_point_acceleration_time_is_out_of_range 30001");
}

static void test_222(void)
{
    expect(tc100_point_deceleration_time_is_out_of_range(0u) == true, "tc100_point_deceleration_time_is_out_of_range 0");
    expect(tc100_point_deceleration_time_is_out_of_range(1u) == false, "tc100_point_deceleration_time_is_out_of_range 1");
    expect(tc100_point_deceleration_time_is_out_of_range(2u) == false, "tc100_point_deceleration_time_is_out_of_range 2");
    expect(tc100_point_deceleration_time_is_out_of_range(29999u) == false, "tc100_point_deceleration_time_is_out_of_range 29999");
    expect(tc100_point_deceleration_time_is_out_of_range(30000u) == false, "tc100_point_deceleration_time_is_out_of_range 30000");
    expect(tc100_point_deceleration_time_is_out_of_range(30001u) == true, "tc100_point_deceleration_time_is_out_of_range 30001");
}

static void test_223(void)
{
    expect(tc100_point_wait_time_is_out_of_range(0u) == false, "tc100_point_wait_time_is_out_of_range 0");
    expect(tc100_point_wait_time_is_out_of_range(1u) == false, "tc100_point_wait_time_is_out_of_range 1");
    expect(tc100_point_wait_time_is_out_of_range(29999u) == false, "tc100_point_wait_time_is_out_of_range 29999");
    expect(tc100_point_wait_time_is_out_of_range(30000u) == false, "tc100_point_wait_time_is_out_of_range 30000");
    expect(tc100_point_wait_time_is_out_of_range(30001u) == true, "tc100_point_wait_time_is_out_of_range 30001");
}

static void test_224(void)
{
    expect(tc100_point_next_point_is_out_of_range((-2)) == true, "tc100_point_next_point_is_out_of_range -2");
    expect(tc100_point_next_point_is_out_of_range((-1)) == false, "tc100_point_next_point_is_out_of_range -1");
    expect(tc100_point_next_point_is_out_of_range(0) == true, "tc100_point_next_point_is_out_of_range 0");
    expect(tc100_point_next_point_is_out_of_range(1) == false, "tc100_point_next_point_is_out_of_range 1");
    expect(tc100_point_next_point_is_out_of_range(2) == false, "tc100_point_next_point_is_out_of_range 2");
    expect(tc100_point_next_point_is_out_of_range(126) == false, "tc100_point_next_point_is_out_of_range 126");
    expect(tc100_point_next_point_is_out_of_range(127) == false, "tc100_point_next_point_is_out_of_range 127");
    expect(tc100_point_next_point_is_out_of_range(128) == true, "tc100_point_next_point_is_out_of_range 128");
}

static void test_225(void)
{
    expect(tc100_read_registers_request_word_count_is_out_of_range(0u) == true, "tc100_read_registers_request_word_count_is_out_of_range 0");
    expect(tc100_read_registers_request_word_count_is_out_of_range(1u) == false, "tc100_read_registers_request_word_count_is_out_of_range 1");
    expect(tc100_read_registers_request_word_count_is_out_of_range(2u) == false, "tc100_read_registers_request_word_count_is_out_of_range 2");
    expect(tc100_read_registers_request_word_count_is_out_of_range(59u) == false, "tc100_read_registers_request_word_count_is_out_of_range 59");
    expect(tc100_read_registers_request_word_count_is_out_of_range(60u) == false, "tc100_read_registers_request_word_count_is_out_of_range 60");
    expect(tc100_read_registers_request_word_count_is_out_of_range(61u) == true, "tc100_read_registers_request_word_count_is_out_of_range 61");
}

static void test_226(void)
{
    expect(tc100_read_registers_response_byte_count_is_out_of_range(1u) == true, "tc100_read_registers_response_byte_count_is_out_of_range 1");
    expect(tc100_read_registers_response_byte_count_is_out_of_range(2u) == false, "tc100_read_registers_response_byte_count_is_out_of_range 2");
    expect(tc100_read_registers_response_byte_count_is_out_of_range(3u) == false, "tc100_read_registers_response_byte_count_is_out_of_range 3");
    expect(tc100_read_registers_response_byte_count_is_out_of_range(119u) == false, "tc100_read_registers_response_byte_count_is_out_of_range 119");
    expect(tc100_read_registers_response_byte_count_is_out_of_range(120u) == false, "tc100_read_registers_response_byte_count_is_out_of_range 120");
    expect(tc100_read_registers_response_byte_count_is_out_of_range(121u) == true, "tc100_read_registers_response_byte_count_is_out_of_range 121");
}

static void test_227(void)
{
    expect(tc100_write_registers_request_word_count_is_out_of_range(0u) == true, "tc100_write_registers_request_word_count_is_out_of_range 0");
    expect(tc100_write_registers_request_word_count_is_out_of_range(1u) == false, "tc100_write_registers_request_word_count_is_out_of_range 1");
    expect(tc100_write_registers_request_word_count_is_out_of_range(2u) == false, "tc100_write_registers_request_word_count_is_out_of_range 2");
    expect(tc100_write_registers_request_word_count_is_out_of_range(58u) == false, "tc100_write_registers_request_word_count_is_out_of_range 58");
    expect(tc100_write_registers_request_word_count_is_out_of_range(59u) == false, "tc100_write_registers_request_word_count_is_out_of_range 59");
    expect(tc100_write_registers_request_word_count_is_out_of_range(60u) == true, "tc100_write_registers_request_word_count_is_out_of_range 60");
}

static void test_228(void)
{
    expect(tc100_write_registers_request_byte_count_is_out_of_range(1u) == true, "tc100_write_registers_request_byte_count_is_out_of_range 1");
    expect(tc100_write_registers_request_byte_count_is_out_of_range(2u) == false, "tc100_write_registers_request_byte_count_is_out_of_range 2");
    expect(tc100_write_registers_request_byte_count_is_out_of_range(3u) == false, "tc100_write_registers_request_byte_count_is_out_of_range 3");
    expect(tc100_write_registers_request_byte_count_is_out_of_range(117u) == false, "tc100_write_registers_request_byte_count_is_out_of_range 117");
    expect(tc100_write_registers_request_byte_count_is_out_of_range(118u) == false, "tc100_write_registers_request_byte_count_is_out_of_range 118");
    expect(tc100_write_registers_request_byte_count_is_out_of_range(119u) == true, "tc100_write_registers_request_byte_count_is_out_of_range 119");
}

static void test_229(void)
{
    expect(tc100_write_registers_response_word_count_is_out_of_range(0u) == true, "tc100_write_registers_response_word_count_is_out_of_range 0");
    expect(tc100_write_registers_response_word_count_is_out_of_range(1u) == false, "tc100_write_registers_response_word_count_is_out_of_range 1");
    expect(tc100_write_registers_response_word_count_is_out_of_range(2u) == false, "tc100_write_registers_response_word_count_is_out_of_range 2");
    expect(tc100_write_registers_response_word_count_is_out_of_range(58u) == false, "tc100_write_registers_response_word_count_is_out_of_range 58");
    expect(tc100_write_registers_response_word_count_is_out_of_range(59u) == false, "tc100_write_registers_response_word_count_is_out_of_range 59");
    expect(tc100_write_registers_response_word_count_is_out_of_range(60u) == true, "tc100_write_registers_response_word_count_is_out_of_range 60");
}

static void test_230(void)
{
    expect(tc100_reg_motion_speed_is_out_of_range(0u) == false, "tc100_reg_motion_speed_is_out_of_range 0");
    expect(tc100_reg_motion_speed_is_out_of_range(1u) == false, "tc100_reg_motion_speed_is_out_of_range 1");
    expect(tc100_reg_motion_speed_is_out_of_range(99u) == false, "tc100_reg_motion_speed_is_out_of_range 99");
    expect(tc100_reg_motion_speed_is_out_of_range(100u) == false, "tc100_reg_motion_speed_is_out_of_range 100");
    expect(tc100_reg_motion_speed_is_out_of_range(101u) == true, "tc100_reg_motion_speed_is_out_of_range 101");
}

static void test_231(void)
{
    expect(tc100_reg_simulated_inputs_is_out_of_range(0u) == false, "tc100_reg_simulated_inputs_is_out_of_range 0");
    expect(tc100_reg_simulated_inputs_is_out_of_range(1u) == false, "tc100_reg_simulated_inputs_is_out_of_range 1");
    expect(tc100_reg_simulated_inputs_is_out_of_range(16382u) == false, "tc100_reg_simulated_inputs_is_out_of_range 16382");
    expect(tc100_reg_simulated_inputs_is_out_of_range(16383u) == false, "tc100_reg_simulated_inputs_is_out_of_range 16383");
    expect(tc100_reg_simulated_inputs_is_out_of_range(16384u) == true, "tc100_reg_simulated_inputs_is_out_of_range 16384");
}

static void test_232(void)
{
    expect(tc100_reg_full_count_limit_is_out_of_range(0u) == true, "tc100_reg_full_count_limit_is_out_of_range 0");
    expect(tc100_reg_full_count_limit_is_out_of_range(1u) == false, "tc100_reg_full_count_limit_is_out_of_range 1");
    expect(tc100_reg_full_count_limit_is_out_of_range(2u) == false, "tc100_reg_full_count_limit_is_out_of_range 2");
    expect(tc100_reg_full_count_limit_is_out_of_range(99999u) == false, "tc100_reg_full_count_limit_is_out_of_range 99999");
    expect(tc100_reg_full_count_limit_is_out_of_range(100000u) == false, "tc100_reg_full_count_limit_is_out_of_range 100000");
    expect(tc100_reg_full_count_limit_is_out_of_range(100001u) == true, "tc100_reg_full_count_limit_is_out_of_range 100001");
}

static void test_233(void)
{
    expect(tc100_reg_in_position_zone_is_out_of_range(0u) == false, "tc100_reg_in_position_zone_is_out_of_range 0");
    expect(tc100_reg_in_position_zone_is_out_of_range(1u) == false, "tc100_reg_in_position_zone_is_out_of_range 1");
    expect(tc100_reg_in_position_zone_is_out_of_range(999u) == false, "tc100_reg_in_position_zone_is_out_of_range 999");
    expect(tc100_reg_in_position_zone_is_out_of_range(1000u) == false, "tc100_reg_in_position_zone_is_out_of_range 1000");
    expect(tc100_reg_in_position_zone_is_out_of_range(1001u) == true, "tc100_reg_in_position_zone_is_out_of_range 1001");
}

static void test_234(void)
{
    expect(tc100_reg_electronic_gear_numerator_is_out_of_range(0u) == true, "tc100_reg_electronic_gear_numerator_is_out_of_range 0");
    expect(tc100_reg_electronic_gear_numerator_is_out_of_range(1u) == false, "tc100_reg_electronic_gear_numerator_is_out_of_range 1");
    expect(tc100_reg_electronic_gear_numerator_is_out_of_range(2u) == false, "tc100_reg_electronic_gear_numerator_is_out_of_range 2");
    expect(tc100_reg_electronic_gear_numerator_is_out_of_range(9999u) == false, "tc100_reg_electronic_gear_numerator_is_out_of_range 9999");
    expect(tc100_reg_electronic_gear_numerator_is_out_of_range(10000u) == false, "tc100_reg_electronic_gear_numerator_is_out_of_range 10000");
    expect(tc100_reg_electronic_gear_numerator_is_out_of_range(10001u) == true, "tc100_reg_electronic_gear_numerator_is_out_of_range 10001");
}

static void test_235(void)
{
    expect(tc100_reg_electronic_gear_denominator_is_out_of_range(0u) == true, "tc100_reg_electronic_gear_denominator_is_out_of_range 0");
    expect(tc100_reg_electronic_gear_denominator_is_out_of_range(1u) == false, "tc100_reg_electronic_gear_denominator_is_out_of_range 1");
    expect(tc100_reg_electronic_gear_denominator_is_out_of_range(2u) == false, "tc100_reg_electronic_gear_denominator_is_out_of_range 2");
    expect(tc100_reg_electronic_gear_denominator_is_out_of_range(9999u) == false, "tc100_reg_electronic_gear_denominator_is_out_of_range 9999");
    expect(tc100_reg_electronic_gear_denominator_is_out_of_range(10000u) == false, "tc100_reg_electronic_gear_denominator_is_out_of_range 10000");
    expect(tc100_reg_electronic_gear_denominator_is_out_of_range(10001u) == true, "tc100_reg_electronic_gear_denominator_is_out_of_range 10001");
}

static void test_236(void)
{
    expect(tc100_reg_near_zone_is_out_of_range(0u) == false, "tc100_reg_near_zone_is_out_of_range 0");
    expect(tc100_reg_near_zone_is_out_of_range(1u) == false, "tc100_reg_near_zone_is_out_of_range 1");
    expect(tc100_reg_near_zone_is_out_of_range(9999u) == false, "tc100_reg_near_zone_is_out_of_range 9999");
    expect(tc100_reg_near_zone_is_out_of_range(10000u) == false, "tc100_reg_near_zone_is_out_of_range 10000");
    expect(tc100_reg_near_zone_is_out_of_range(10001u) == true, "tc100_reg_near_zone_is_out_of_range 10001");
}

static void test_237(void)
{
    expect(tc100_reg_push_torque_positive_is_out_of_range(0u) == false, "tc100_reg_push_torque_positive_is_out_of_range 0");
    expect(tc100_reg_push_torque_positive_is_out_of_range(1u) == false, "tc100_reg_push_torque_positive_is_out_of_range 1");
    expect(tc100_reg_push_torque_positive_is_out_of_range(999u) == false, "tc100_reg_push_torque_positive_is_out_of_range 999");
    expect(tc100_reg_push_torque_positive_is_out_of_range(1000u) == false, "tc100_reg_push_torque_positive_is_out_of_range 1000");
    expect(tc100_reg_push_torque_positive_is_out_of_range(1001u) == true, "tc100_reg_push_torque_positive_is_out_of_range 1001");
}

static void test_238(void)
{
    expect(tc100_reg_push_torque_negative_is_out_of_range(0u) == false, "tc100_reg_push_torque_negative_is_out_of_range 0");
    expect(tc100_reg_push_torque_negative_is_out_of_range(1u) == false, "tc100_reg_push_torque_negative_is_out_of_range 1");
    expect(tc100_reg_push_torque_negative_is_out_of_range(999u) == false, "tc100_reg_push_torque_negative_is_out_of_range 999");
    expect(tc100_reg_push_torque_negative_is_out_of_range(1000u) == false, "tc100_reg_push_torque_negative_is_out_of_range 1000");
    expect(tc100_reg_push_torque_negative_is_out_of_range(1001u) == true, "tc100_reg_push_torque_negative_is_out_of_range 1001");
}

static void test_239(void)
{
    expect(tc100_reg_torque_limit_time_is_out_of_range(0u) == false, "tc100_reg_torque_limit_time_is_out_of_range 0");
    expect(tc100_reg_torque_limit_time_is_out_of_range(1u) == false, "tc100_reg_torque_limit_time_is_out_of_range 1");
    expect(tc100_reg_torque_limit_time_is_out_of_range(9999u) == false, "tc100_reg_torque_limit_time_is_out_of_range 9999");
    expect(tc100_reg_torque_limit_time_is_out_of_range(10000u) == false, "tc100_reg_torque_limit_time_is_out_of_range 10000");
    expect(tc100_reg_torque_limit_time_is_out_of_range(10001u) == true, "tc100_reg_torque_limit_time_is_out_of_range 10001");
}

static void test_240(void)
{
    expect(tc100_reg_position_correction_speed_limit_is_out_of_range(9u) == true, "tc100_reg_position_correction_speed_limit_is_out_of_range 9");
    expect(tc100_reg_position_correction_speed_limit_is_out_of_range(10u) == false, "tc100_reg_position_correction_speed_limit_is_out_of_range 10");
    expect(tc100_reg_position_correction_speed_limit_is_out_of_range(11u) == false, "tc100_reg_position_correction_speed_limit_is_out_of_range 11");
    expect(tc100_reg_position_correction_speed_limit_is_out_of_range(499u) == false, "tc100_reg_position_correction_speed_limit_is_out_of_range 499");
    expect(tc100_reg_position_correction_speed_limit_is_out_of_range(500u) == false, "tc100_reg_position_correction_speed_limit_is_out_of_range 500");
    expect(tc100_reg_position_correction_speed_limit_is_out_of_range(501u) == true, "tc100_reg_position_correction_speed_limit_is_out_of_range 501");
}

static void test_241(void)
{
    expect(tc100_reg_maximum_torque_is_out_of_range(0u) == false, "tc100_reg_maximum_torque_is_out_of_range 0");
    expect(tc100_reg_maximum_torque_is_out_of_range(1u) == false, "tc100_reg_maximum_torque_is_out_of_range 1");
    expect(tc100_reg_maximum_torque_is_out_of_range(649u) == false, "tc100_reg_maximum_torque_is_out_of_range 649");
    expect(tc100_reg_maximum_torque_is_out_of_range(650u) == false, "tc100_reg_maximum_torque_is_out_of_range 650");
    expect(tc100_reg_maximum_torque_is_out_of_range(651u) == true, "tc100_reg_maximum_torque_is_out_of_range 651");
}

static void test_242(void)
{
    expect(tc100_reg_full_torque_time_is_out_of_range(499u) == true, "tc100_reg_full_torque_time_is_out_of_range 499");
    expect(tc100_reg_full_torque_time_is_out_of_range(500u) == false, "tc100_reg_full_torque_time_is_out_of_range 500");
    expect(tc100_reg_full_torque_time_is_out_of_range(501u) == false, "tc100_reg_full_torque_time_is_out_of_range 501");
    expect(tc100_reg_full_torque_time_is_out_of_range(9999u) == false, "tc100_reg_full_torque_time_is_out_of_range 9999");
    expect(tc100_reg_full_torque_time_is_out_of_range(10000u) == false, "tc100_reg_full_torque_time_is_out_of_range 10000");
    expect(tc100_reg_full_torque_time_is_out_of_range(10001u) == true, "tc100_reg_full_torque_time_is_out_of_range 10001");
}

static void test_243(void)
{
    expect(tc100_reg_acceleration_time_is_out_of_range(0u) == true, "tc100_reg_acceleration_time_is_out_of_range 0");
    expect(tc100_reg_acceleration_time_is_out_of_range(1u) == false, "tc100_reg_acceleration_time_is_out_of_range 1");
    expect(tc100_reg_acceleration_time_is_out_of_range(2u) == false, "tc100_reg_acceleration_time_is_out_of_range 2");
    expect(tc100_reg_acceleration_time_is_out_of_range(29999u) == false, "tc100_reg_acceleration_time_is_out_of_range 29999");
    expect(tc100_reg_acceleration_time_is_out_of_range(30000u) == false, "tc100_reg_acceleration_time_is_out_of_range 30000");
    expect(tc100_reg_acceleration_time_is_out_of_range(30001u) == true, "tc100_reg_acceleration_time_is_out_of_range 30001");
}

static void test_244(void)
{
    expect(tc100_reg_deceleration_time_is_out_of_range(0u) == true, "tc100_reg_deceleration_time_is_out_of_range 0");
    expect(tc100_reg_deceleration_time_is_out_of_range(1u) == false, "tc100_reg_deceleration_time_is_out_of_range 1");
    expect(tc100_reg_deceleration_time_is_out_of_range(2u) == false, "tc100_reg_deceleration_time_is_out_of_range 2");
    expect(tc100_reg_deceleration_time_is_out_of_range(29999u) == false, "tc100_reg_deceleration_time_is_out_of_range 29999");
    expect(tc100_reg_deceleration_time_is_out_of_range(30000u) == false, "tc100_reg_deceleration_time_is_out_of_range 30000");
    expect(tc100_reg_deceleration_time_is_out_of_range(30001u) == true, "tc100_reg_deceleration_time_is_out_of_range 30001");
}

static void test_245(void)
{
    expect(tc100_reg_jog_speed_is_out_of_range(0u) == true, "tc100_reg_jog_speed_is_out_of_range 0");
    expect(tc100_reg_jog_speed_is_out_of_range(1u) == false, "tc100_reg_jog_speed_is_out_of_range 1");
    expect(tc100_reg_jog_speed_is_out_of_range(2u) == false, "tc100_reg_jog_speed_is_out_of_range 2");
    expect(tc100_reg_jog_speed_is_out_of_range(999u) == false, "tc100_reg_jog_speed_is_out_of_range 999");
    expect(tc100_reg_jog_speed_is_out_of_range(1000u) == false, "tc100_reg_jog_speed_is_out_of_range 1000");
    expect(tc100_reg_jog_speed_is_out_of_range(1001u) == true, "tc100_reg_jog_speed_is_out_of_range 1001");
}

static void test_246(void)
{
    expect(tc100_reg_jog_wait_time_is_out_of_range(0u) == false, "tc100_reg_jog_wait_time_is_out_of_range 0");
    expect(tc100_reg_jog_wait_time_is_out_of_range(1u) == false, "tc100_reg_jog_wait_time_is_out_of_range 1");
    expect(tc100_reg_jog_wait_time_is_out_of_range(999u) == false, "tc100_reg_jog_wait_time_is_out_of_range 999");
    expect(tc100_reg_jog_wait_time_is_out_of_range(1000u) == false, "tc100_reg_jog_wait_time_is_out_of_range 1000");
    expect(tc100_reg_jog_wait_time_is_out_of_range(1001u) == true, "tc100_reg_jog_wait_time_is_out_of_range 1001");
}

static void test_247(void)
{
    expect(tc100_reg_homing_speed_is_out_of_range(0u) == false, "tc100_reg_homing_speed_is_out_of_range 0");
    expect(tc100_reg_homing_speed_is_out_of_range(1u) == false, "tc100_reg_homing_speed_is_out_of_range 1");
    expect(tc100_reg_homing_speed_is_out_of_range(99u) == false, "tc100_reg_homing_speed_is_out_of_range 99");
    expect(tc100_reg_homing_speed_is_out_of_range(100u) == false, "tc100_reg_homing_speed_is_out_of_range 100");
    expect(tc100_reg_homing_speed_is_out_of_range(101u) == true, "tc100_reg_homing_speed_is_out_of_range 101");
}

static void test_248(void)
{
    expect(tc100_reg_homing_offset_speed_is_out_of_range(0u) == false, "tc100_reg_homing_offset_speed_is_out_of_range 0");
    expect(tc100_reg_homing_offset_speed_is_out_of_range(1u) == false, "tc100_reg_homing_offset_speed_is_out_of_range 1");
    expect(tc100_reg_homing_offset_speed_is_out_of_range(99u) == false, "tc100_reg_homing_offset_speed_is_out_of_range 99");
    expect(tc100_reg_homing_offset_speed_is_out_of_range(100u) == false, "tc100_reg_homing_offset_speed_is_out_of_range 100");
    expect(tc100_reg_homing_offset_speed_is_out_of_range(101u) == true, "tc100_reg_homing_offset_speed_is_out_of_range 101");
}

static void test_249(void)
{
    expect(tc100_reg_homing_torque_limit_is_out_of_range(0u) == false, "tc100_reg_homing_torque_limit_is_out_of_range 0");
    expect(tc100_reg_homing_torque_limit_is_out_of_range(1u) == false, "tc100_reg_homing_torque_limit_is_out_of_range 1");
    expect(tc100_reg_homing_torque_limit_is_out_of_range(999u) == false, "tc100_reg_homing_torque_limit_is_out_of_range 999");
    expect(tc100_reg_homing_torque_limit_is_out_of_range(1000u) == false, "tc100_reg_homing_torque_limit_is_out_of_range 1000");
    expect(tc100_reg_homing_torque_limit_is_out_of_range(1001u) == true, "tc100_reg_homing_torque_limit_is_out_of_range 1001");
}

static void test_250(void)
{
    expect(tc100_reg_homing_torque_limit_time_is_out_of_range(0u) == false, "tc100_reg_homing_torque_limit_time_is_out_of_range 0");
    expect(tc100_reg_homing_torque_limit_time_is_out_of_range(1u) == false, "tc100_reg_homing_torque_limit_time_is_out_of_range 1");
    expect(tc100_reg_homing_torque_limit_time_is_out_of_range(999u) == false, "tc100_reg_homing_torque_limit_time_is_out_of_range 999");
    expect(tc100_reg_homing_torque_limit_time_is_out_of_range(1000u) == false, "tc100_reg_homing_torque_limit_time_is_out_of_range 1000");
    expect(tc100_reg_homing_torque_limit_time_is_out_of_range(1001u) == true, "tc100_reg_homing_torque_limit_time_is_out_of_range 1001");
}

static void test_251(void)
{
    expect(tc100_reg_homing_z_phase_speed_1_is_out_of_range(0u) == true, "tc100_reg_homing_z_phase_speed_1_is_out_of_range 0");
    expect(tc100_reg_homing_z_phase_speed_1_is_out_of_range(1u) == false, "tc100_reg_homing_z_phase_speed_1_is_out_of_range 1");
    expect(tc100_reg_homing_z_phase_speed_1_is_out_of_range(2u) == false, "tc100_reg_homing_z_phase_speed_1_is_out_of_range 2");
    expect(tc100_reg_homing_z_phase_speed_1_is_out_of_range(99u) == false, "tc100_reg_homing_z_phase_speed_1_is_out_of_range 99");
    expect(tc100_reg_homing_z_phase_speed_1_is_out_of_range(100u) == false, "tc100_reg_homing_z_phase_speed_1_is_out_of_range 100");
    expect(tc100_reg_homing_z_phase_speed_1_is_out_of_range(101u) == true, "tc100_reg_homing_z_phase_speed_1_is_out_of_range 101");
}

static void test_252(void)
{
    expect(tc100_reg_homing_z_phase_speed_2_is_out_of_range(0u) == true, "tc100_reg_homing_z_phase_speed_2_is_out_of_range 0");
    expect(tc100_reg_homing_z_phase_speed_2_is_out_of_range(1u) == false, "tc100_reg_homing_z_phase_speed_2_is_out_of_range 1");
    expect(tc100_reg_homing_z_phase_speed_2_is_out_of_range(2u) == false, "tc100_reg_homing_z_phase_speed_2_is_out_of_range 2");
    expect(tc100_reg_homing_z_phase_speed_2_is_out_of_range(99u) == false, "tc100_reg_homing_z_phase_speed_2_is_out_of_range 99");
    expect(tc100_reg_homing_z_phase_speed_2_is_out_of_range(100u) == false, "tc100_reg_homing_z_phase_speed_2_is_out_of_range 100");
    expect(tc100_reg_homing_z_phase_speed_2_is_out_of_range(101u) == true, "tc100_reg_homing_z_phase_speed_2_is_out_of_range 101");
}

static void test_253(void)
{
    expect(tc100_reg_executed_point_is_out_of_range((-2)) == true, "tc100_reg_executed_point_is_out_of_range -2");
    expect(tc100_reg_executed_point_is_out_of_range((-1)) == false, "tc100_reg_executed_point_is_out_of_range -1");
    expect(tc100_reg_executed_point_is_out_of_range(0) == false, "tc100_reg_executed_point_is_out_of_range 0");
    expect(tc100_reg_executed_point_is_out_of_range(126) == false, "tc100_reg_executed_point_is_out_of_range 126");
    expect(tc100_reg_executed_point_is_out_of_range(127) == false, "tc100_reg_executed_point_is_out_of_range 127");
    expect(tc100_reg_executed_point_is_out_of_range(128) == true, "tc100_reg_executed_point_is_out_of_range 128");
}

static void test_254(void)
{
    expect(tc100_reg_output_states_is_out_of_range(0u) == false, "tc100_reg_output_states_is_out_of_range 0");
    expect(tc100_reg_output_states_is_out_of_range(1u) == false, "tc100_reg_output_states_is_out_of_range 1");
    expect(tc100_reg_output_states_is_out_of_range(1022u) == false, "tc100_reg_output_states_is_out_of_range 1022");
    expect(tc100_reg_output_states_is_out_of_range(1023u) == false, "tc100_reg_output_states_is_out_of_range 1023");
    expect(tc100_reg_output_states_is_out_of_range(1024u) == true, "tc100_reg_output_states_is_out_of_range 1024");
}

static void test_255(void)
{
    expect(tc100_reg_input_states_is_out_of_range(0u) == false, "tc100_reg_input_states_is_out_of_range 0");
    expect(tc100_reg_input_states_is_out_of_range(1u) == false, "tc100_reg_input_states_is_out_of_range 1");
    expect(tc100_reg_input_states_is_out_of_range(32766u) == false, "tc100_reg_input_states_is_out_of_range 32766");
    expect(tc100_reg_input_states_is_out_of_range(32767u) == false, "tc100_reg_input_states_is_out_of_range 32767");
    expect(tc100_reg_input_states_is_out_of_range(32768u) == true, "tc100_reg_input_states_is_out_of_range 32768");
}

unsigned long tc100_selftest(void (*tell)(const char *what))
{
    (void)same_bytes;
    (void)same_text;
    (void)copy;
    (void)clear;
    told = tell;
    passed = 0;
    failed = 0;
    test_0();
    test_1();
    test_2();
    test_3();
    test_4();
    test_5();
    test_6();
    test_7();
    test_8();
    test_9();
    test_10();
    test_11();
    test_12();
    test_13();
    test_14();
    test_15();
    test_16();
    test_17();
    test_18();
    test_19();
    test_20();
    test_21();
    test_22();
    test_23();
    test_24();
    test_25();
    test_26();
    test_27();
    test_28();
    test_29();
    test_30();
    test_31();
    test_32();
    test_33();
    test_34();
    test_35();
    test_36();
    test_37();
    test_38();
    test_39();
    test_40();
    test_41();
    test_42();
    test_43();
    test_44();
    test_45();
    test_46();
    test_47();
    test_48();
    test_49();
    test_50();
    test_51();
    test_52();
    test_53();
    test_54();
    test_55();
    test_56();
    test_57();
    test_58();
    test_59();
    test_60();
    test_61();
    test_62();
    test_63();
    test_64();
    test_65();
    test_66();
    test_67();
    test_68();
    test_69();
    test_70();
    test_71();
    test_72();
    test_73();
    test_74();
    test_75();
    test_76();
    test_77();
    test_78();
    test_79();
    test_80();
    test_81();
    test_82();
    test_83();
    test_84();
    test_85();
    test_86();
    test_87();
    test_88();
    test_89();
    test_90();
    test_91();
    test_92();
    test_93();
    test_94();
    test_95();
    test_96();
    test_97();
    test_98();
    test_99();
    test_100();
    test_101();
    test_102();
    test_103();
    test_104();
    test_105();
    test_106();
    test_107();
    test_108();
    test_109();
    test_110();
    test_111();
    test_112();
    test_113();
    test_114();
    test_115();
    test_116();
    test_117();
    test_118();
    test_119();
    test_120();
    test_121();
    test_122();
    test_123();
    test_124();
    test_125();
    test_126();
    test_127();
    test_128();
    test_129();
    test_130();
    test_131();
    test_132();
    test_133();
    test_134();
    test_135();
    test_136();
    test_137();
    test_138();
    test_139();
    test_140();
    test_141();
    test_142();
    test_143();
    test_144();
    test_145();
    test_146();
    test_147();
    test_148();
    test_149();
    test_150();
    test_151();
    test_152();
    test_153();
    test_154();
    test_155();
    test_156();
    test_157();
    test_158();
    test_159();
    test_160();
    test_161();
    test_162();
    test_163();
    test_164();
    test_165();
    test_166();
    test_167();
    test_168();
    test_169();
    test_170();
    test_171();
    test_172();
    test_173();
    test_174();
    test_175();
    test_176();
    test_177();
    test_178();
    test_179();
    test_180();
    test_181();
    test_182();
    test_183();
    test_184();
    test_185();
    test_186();
    test_187();
    test_188();
    test_189();
    test_190();
    test_191();
    test_192();
    test_193();
    test_194();
    test_195();
    test_196();
    test_197();
    test_198();
    test_199();
    test_200();
    test_201();
    test_202();
    test_203();
    test_204();
    test_205();
    test_206();
    test_207();
    test_208();
    test_209();
    test_210();
    test_211();
    test_212();
    test_213();
    test_214();
    test_215();
    test_216();
    test_217();
    test_218();
    test_219();
    test_220();
    test_221();
    test_222();
    test_223();
    test_224();
    test_225();
    test_226();
    test_227();
    test_228();
    test_229();
    test_230();
    test_231();
    test_232();
    test_233();
    test_234();
    test_235();
    test_236();
    test_237();
    test_238();
    test_239();
    test_240();
    test_241();
    test_242();
    test_243();
    test_244();
    test_245();
    test_246();
    test_247();
    test_248();
    test_249();
    test_250();
    test_251();
    test_252();
    test_253();
    test_254();
    test_255();
    return failed;
}

#ifdef HOSTED
static void print(const char *what)
{
    printf("failed: %s\n", what);
}

int main(void)
{
    (void)tc100_selftest(print);
    printf("%lu passed, %lu failed\n", passed, failed);
    return failed ? 1 : 0;
}
#endif
