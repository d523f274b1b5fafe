/*
 * Tests esc11_v1_17.h: ESC11-B, version 1.17
 * Identity: 499facc7f5252c73
 *
 * Generated; do not edit. Compile and run it: it exits with 0 if every test passes. On a machine without an operating system
 * compile it with -ffreestanding; then it has no main, and you call esc11_selftest yourself.
 */
#define ESC11_WITH_TEXTS
#include "esc11_v1_17.h"

#if !defined(__STDC_HOSTED__) || __STDC_HOSTED__
#include <stdio.h>
#define HOSTED
#endif

/* Calls `tell` for each test that fails, and returns their number. */
unsigned long esc11_selftest(void (*tell)(const char *what));

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
    expect(ESC11_COMMUNICATION_STATUS_EXECUTING_MASK == 0x01u, "ESC11_COMMUNICATION_STATUS_EXECUTING_MASK");
    expect(esc11_communication_status_executing(0x01u) == true, "esc11_communication_status_executing");
    expect(esc11_communication_status_executing((uint8_t)~0x01u) == false, "esc11_communication_status_executing");
    expect(ESC11_COMMUNICATION_STATUS_OUT_OF_POSITION_MASK == 0x02u, "ESC11_COMMUNICATION_STATUS_OUT_OF_POSITION_MASK");
    expect(esc11_communication_status_out_of_position(0x02u) == true, "esc11_communication_status_out_of_position");
    expect(esc11_communication_status_out_of_position((uint8_t)~0x02u) == false, "esc11_communication_status_out_of_position");
    expect(ESC11_COMMUNICATION_STATUS_SERVO_OFF_MASK == 0x04u, "ESC11_COMMUNICATION_STATUS_SERVO_OFF_MASK");
    expect(esc11_communication_status_servo_off(0x04u) == true, "esc11_communication_status_servo_off");
    expect(esc11_communication_status_servo_off((uint8_t)~0x04u) == false, "esc11_communication_status_servo_off");
    expect(ESC11_COMMUNICATION_STATUS_DATA_READ_REQUEST_MASK == 0x08u, "ESC11_COMMUNICATION_STATUS_DATA_READ_REQUEST_MASK");
    expect(esc11_communication_status_data_read_request(0x08u) == true, "esc11_communication_status_data_read_request");
    expect(esc11_communication_status_data_read_request((uint8_t)~0x08u) == false, "esc11_communication_status_data_read_request");
    expect(ESC11_COMMUNICATION_STATUS_COMMAND_RESEND_REQUEST_MASK == 0x10u, "ESC11_COMMUNICATION_STATUS_COMMAND_RESEND_REQUEST_MASK");
    expect(esc11_communication_status_command_resend_request(0x10u) == true, "esc11_communication_status_command_resend_request");
    expect(esc11_communication_status_command_resend_request((uint8_t)~0x10u) == false, "esc11_communication_status_command_resend_request");
    expect(ESC11_COMMUNICATION_STATUS_COMMAND_ERROR_MASK == 0x20u, "ESC11_COMMUNICATION_STATUS_COMMAND_ERROR_MASK");
    expect(esc11_communication_status_command_error(0x20u) == true, "esc11_communication_status_command_error");
    expect(esc11_communication_status_command_error((uint8_t)~0x20u) == false, "esc11_communication_status_command_error");
    expect(ESC11_COMMUNICATION_STATUS_ALARM_MASK == 0x40u, "ESC11_COMMUNICATION_STATUS_ALARM_MASK");
    expect(esc11_communication_status_alarm(0x40u) == true, "esc11_communication_status_alarm");
    expect(esc11_communication_status_alarm((uint8_t)~0x40u) == false, "esc11_communication_status_alarm");
    expect(ESC11_COMMUNICATION_STATUS_COMMUNICATION_ERROR_MASK == 0x80u, "ESC11_COMMUNICATION_STATUS_COMMUNICATION_ERROR_MASK");
    expect(esc11_communication_status_communication_error(0x80u) == true, "esc11_communication_status_communication_error");
    expect(esc11_communication_status_communication_error((uint8_t)~0x80u) == false, "esc11_communication_status_communication_error");
    expect(ESC11_IO_INPUTS_POINT_INPUT_0_MASK == 0x01u, "ESC11_IO_INPUTS_POINT_INPUT_0_MASK");
    expect(esc11_io_inputs_point_input_0(0x01u) == true, "esc11_io_inputs_point_input_0");
    expect(esc11_io_inputs_point_input_0((uint8_t)~0x01u) == false, "esc11_io_inputs_point_input_0");
    expect(ESC11_IO_INPUTS_POINT_INPUT_1_MASK == 0x02u, "ESC11_IO_INPUTS_POINT_INPUT_1_MASK");
    expect(esc11_io_inputs_point_input_1(0x02u) == true, "esc11_io_inputs_point_input_1");
    expect(esc11_io_inputs_point_input_1((uint8_t)~0x02u) == false, "esc11_io_inputs_point_input_1");
    expect(ESC11_IO_INPUTS_POINT_INPUT_2_MASK == 0x04u, "ESC11_IO_INPUTS_POINT_INPUT_2_MASK");
    expect(esc11_io_inputs_point_input_2(0x04u) == true, "esc11_io_inputs_point_input_2");
    expect(esc11_io_inputs_point_input_2((uint8_t)~0x04u) == false, "esc11_io_inputs_point_input_2");
    expect(ESC11_IO_INPUTS_POINT_INPUT_3_MASK == 0x08u, "ESC11_IO_INPUTS_POINT_INPUT_3_MASK");
    expect(esc11_io_inputs_point_input_3(0x08u) == true, "esc11_io_inputs_point_input_3");
    expect(esc11_io_inputs_point_input_3((uint8_t)~0x08u) == false, "esc11_io_inputs_point_input_3");
    expect(ESC11_IO_INPUTS_POINT_INPUT_4_MASK == 0x10u, "ESC11_IO_INPUTS_POINT_INPUT_4_MASK");
    expect(esc11_io_inputs_point_input_4(0x10u) == true, "esc11_io_inputs_point_input_4");
    expect(esc11_io_inputs_point_input_4((uint8_t)~0x10u) == false, "esc11_io_inputs_point_input_4");
    expect(ESC11_IO_INPUTS_START_MASK == 0x20u, "ESC11_IO_INPUTS_START_MASK");
    expect(esc11_io_inputs_start(0x20u) == true, "esc11_io_inputs_start");
    expect(esc11_io_inputs_start((uint8_t)~0x20u) == false, "esc11_io_inputs_start");
    expect(ESC11_IO_INPUTS_SELECTION_MASK == 0x40u, "ESC11_IO_INPUTS_SELECTION_MASK");
    expect(esc11_io_inputs_selection(0x40u) == true, "esc11_io_inputs_selection");
    expect(esc11_io_inputs_selection((uint8_t)~0x40u) == false, "esc11_io_inputs_selection");
    expect(ESC11_IO_INPUTS_INTERLOCK_RELEASED_MASK == 0x80u, "ESC11_IO_INPUTS_INTERLOCK_RELEASED_MASK");
    expect(esc11_io_inputs_interlock_released(0x80u) == true, "esc11_io_inputs_interlock_released");
    expect(esc11_io_inputs_interlock_released((uint8_t)~0x80u) == false, "esc11_io_inputs_interlock_released");
    expect(ESC11_IO_OUTPUTS_POINT_OUTPUT_0_MASK == 0x01u, "ESC11_IO_OUTPUTS_POINT_OUTPUT_0_MASK");
    expect(esc11_io_outputs_point_output_0(0x01u) == true, "esc11_io_outputs_point_output_0");
    expect(esc11_io_outputs_point_output_0((uint8_t)~0x01u) == false, "esc11_io_outputs_point_output_0");
    expect(ESC11_IO_OUTPUTS_POINT_OUTPUT_1_MASK == 0x02u, "ESC11_IO_OUTPUTS_POINT_OUTPUT_1_MASK");
    expect(esc11_io_outputs_point_output_1(0x02u) == true, "esc11_io_outputs_point_output_1");
    expect(esc11_io_outputs_point_output_1((uint8_t)~0x02u) == false, "esc11_io_outputs_point_output_1");
    expect(ESC11_IO_OUTPUTS_POINT_OUTPUT_2_MASK == 0x04u, "ESC11_IO_OUTPUTS_POINT_OUTPUT_2_MASK");
    expect(esc11_io_outputs_point_output_2(0x04u) == true, "esc11_io_outputs_point_output_2");
    expect(esc11_io_outputs_point_output_2((uint8_t)~0x04u) == false, "esc11_io_outputs_point_output_2");
    expect(ESC11_IO_OUTPUTS_POINT_OUTPUT_3_MASK == 0x08u, "ESC11_IO_OUTPUTS_POINT_OUTPUT_3_MASK");
    expect(esc11_io_outputs_point_output_3(0x08u) == true, "esc11_io_outputs_point_output_3");
    expect(esc11_io_outputs_point_output_3((uint8_t)~0x08u) == false, "esc11_io_outputs_point_output_3");
    expect(ESC11_IO_OUTPUTS_POINT_OUTPUT_4_MASK == 0x10u, "ESC11_IO_OUTPUTS_POINT_OUTPUT_4_MASK");
    expect(esc11_io_outputs_point_output_4(0x10u) == true, "esc11_io_outputs_point_output_4");
    expect(esc11_io_outputs_point_output_4((uint8_t)~0x10u) == false, "esc11_io_outputs_point_output_4");
    expect(ESC11_IO_OUTPUTS_HOMING_COMPLETE_MASK == 0x20u, "ESC11_IO_OUTPUTS_HOMING_COMPLETE_MASK");
    expect(esc11_io_outputs_homing_complete(0x20u) == true, "esc11_io_outputs_homing_complete");
    expect(esc11_io_outputs_homing_complete((uint8_t)~0x20u) == false, "esc11_io_outputs_homing_complete");
    expect(ESC11_IO_OUTPUTS_IN_ZONE_MASK == 0x40u, "ESC11_IO_OUTPUTS_IN_ZONE_MASK");
    expect(esc11_io_outputs_in_zone(0x40u) == true, "esc11_io_outputs_in_zone");
    expect(esc11_io_outputs_in_zone((uint8_t)~0x40u) == false, "esc11_io_outputs_in_zone");
    expect(ESC11_IO_STATE_OUTPUTS_READY_MASK == 0x01u, "ESC11_IO_STATE_OUTPUTS_READY_MASK");
    expect(esc11_io_state_outputs_ready(0x01u) == true, "esc11_io_state_outputs_ready");
    expect(esc11_io_state_outputs_ready((uint8_t)~0x01u) == false, "esc11_io_state_outputs_ready");
    expect(ESC11_IO_STATE_OUTPUTS_BUSY_MASK == 0x02u, "ESC11_IO_STATE_OUTPUTS_BUSY_MASK");
    expect(esc11_io_state_outputs_busy(0x02u) == true, "esc11_io_state_outputs_busy");
    expect(esc11_io_state_outputs_busy((uint8_t)~0x02u) == false, "esc11_io_state_outputs_busy");
    expect(ESC11_IO_STATE_OUTPUTS_ALARM_MASK == 0x04u, "ESC11_IO_STATE_OUTPUTS_ALARM_MASK");
    expect(esc11_io_state_outputs_alarm(0x04u) == true, "esc11_io_state_outputs_alarm");
    expect(esc11_io_state_outputs_alarm((uint8_t)~0x04u) == false, "esc11_io_state_outputs_alarm");
    expect(ESC11_IO_STATE_OUTPUTS_IN_POSITION_MASK == 0x08u, "ESC11_IO_STATE_OUTPUTS_IN_POSITION_MASK");
    expect(esc11_io_state_outputs_in_position(0x08u) == true, "esc11_io_state_outputs_in_position");
    expect(esc11_io_state_outputs_in_position((uint8_t)~0x08u) == false, "esc11_io_state_outputs_in_position");
    expect(ESC11_IO_STATE_OUTPUTS_HOLD_MASK == 0x10u, "ESC11_IO_STATE_OUTPUTS_HOLD_MASK");
    expect(esc11_io_state_outputs_hold(0x10u) == true, "esc11_io_state_outputs_hold");
    expect(esc11_io_state_outputs_hold((uint8_t)~0x10u) == false, "esc11_io_state_outputs_hold");
    expect(ESC11_IO_STATE_OUTPUTS_RUN_LAMP_MASK == 0x20u, "ESC11_IO_STATE_OUTPUTS_RUN_LAMP_MASK");
    expect(esc11_io_state_outputs_run_lamp(0x20u) == true, "esc11_io_state_outputs_run_lamp");
    expect(esc11_io_state_outputs_run_lamp((uint8_t)~0x20u) == false, "esc11_io_state_outputs_run_lamp");
    expect(ESC11_IO_STATE_OUTPUTS_READY_LAMP_MASK == 0x40u, "ESC11_IO_STATE_OUTPUTS_READY_LAMP_MASK");
    expect(esc11_io_state_outputs_ready_lamp(0x40u) == true, "esc11_io_state_outputs_ready_lamp");
    expect(esc11_io_state_outputs_ready_lamp((uint8_t)~0x40u) == false, "esc11_io_state_outputs_ready_lamp");
    expect(ESC11_IO_STATE_OUTPUTS_ALARM_LAMP_MASK == 0x80u, "ESC11_IO_STATE_OUTPUTS_ALARM_LAMP_MASK");
    expect(esc11_io_state_outputs_alarm_lamp(0x80u) == true, "esc11_io_state_outputs_alarm_lamp");
    expect(esc11_io_state_outputs_alarm_lamp((uint8_t)~0x80u) == false, "esc11_io_state_outputs_alarm_lamp");
}

static void test_1(void)
{
    expect(esc11_homing_direction_known(INT64_C(0)) == true, "esc11_homing_direction_known");
    expect(esc11_homing_direction_known(INT64_C(1)) == true, "esc11_homing_direction_known");
    expect(esc11_homing_direction_known(INT64_C(2)) == false, "esc11_homing_direction_known");
    expect(esc11_homing_method_known(INT64_C(0)) == true, "esc11_homing_method_known");
    expect(esc11_homing_method_known(INT64_C(1)) == true, "esc11_homing_method_known");
    expect(esc11_homing_method_known(INT64_C(2)) == false, "esc11_homing_method_known");
    expect(esc11_point_mode_known(INT64_C(65)) == true, "esc11_point_mode_known");
    expect(esc11_point_mode_known(INT64_C(67)) == true, "esc11_point_mode_known");
    expect(esc11_point_mode_known(INT64_C(71)) == true, "esc11_point_mode_known");
    expect(esc11_point_mode_known(INT64_C(72)) == true, "esc11_point_mode_known");
    expect(esc11_point_mode_known(INT64_C(73)) == true, "esc11_point_mode_known");
    expect(esc11_point_mode_known(INT64_C(74)) == true, "esc11_point_mode_known");
    expect(esc11_point_mode_known(INT64_C(75)) == true, "esc11_point_mode_known");
    expect(esc11_point_mode_known(INT64_C(79)) == true, "esc11_point_mode_known");
    expect(esc11_point_mode_known(INT64_C(80)) == false, "esc11_point_mode_known");
}

static void test_2(void)
{
    expect(esc11_alarm_code_text(INT64_C(1)) != NULL && esc11_alarm_code_text(INT64_C(1))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(1))->name, "overload") && same_text(esc11_alarm_code_text(INT64_C(1))->printed, "OVER LOAD"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(2)) != NULL && esc11_alarm_code_text(INT64_C(2))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(2))->name, "overcurrent") && same_text(esc11_alarm_code_text(INT64_C(2))->printed, "OVER CURRENT"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(3)) != NULL && esc11_alarm_code_text(INT64_C(3))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(3))->name, "machine_reference_over") && same_text(esc11_alarm_code_text(INT64_C(3))->printed, "MACHINE REFERENCE OVER"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(4)) != NULL && esc11_alarm_code_text(INT64_C(4))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(4))->name, "supply_voltage_low") && same_text(esc11_alarm_code_text(INT64_C(4))->printed, "POWER SUPPLY VOLTAGE LOW"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(5)) != NULL && esc11_alarm_code_text(INT64_C(5))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(5))->name, "data_not_written") && same_text(esc11_alarm_code_text(INT64_C(5))->printed, "DATA NOT WRITE"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(6)) != NULL && esc11_alarm_code_text(INT64_C(6))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(6))->name, "position_deviation_over") && same_text(esc11_alarm_code_text(INT64_C(6))->printed, "P.E. COUNTER OVER"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(7)) != NULL && esc11_alarm_code_text(INT64_C(7))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(7))->name, "point_data_destroyed") && same_text(esc11_alarm_code_text(INT64_C(7))->printed, "PNT DATA DESTROY"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(8)) != NULL && esc11_alarm_code_text(INT64_C(8))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(8))->name, "parameter_data_destroyed") && same_text(esc11_alarm_code_text(INT64_C(8))->printed, "PRM DATA DESTROY"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(9)) != NULL && esc11_alarm_code_text(INT64_C(9))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(9))->name, "system_fault_1") && same_text(esc11_alarm_code_text(INT64_C(9))->printed, "SYSTEM FAULT1"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(10)) != NULL && esc11_alarm_code_text(INT64_C(10))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(10))->name, "feedback_error_1") && same_text(esc11_alarm_code_text(INT64_C(10))->printed, "FEEDBACK ERROR1"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(11)) != NULL && esc11_alarm_code_text(INT64_C(11))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(11))->name, "feedback_error_2") && same_text(esc11_alarm_code_text(INT64_C(11))->printed, "FEEDBACK ERROR2"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(12)) != NULL && esc11_alarm_code_text(INT64_C(12))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(12))->name, "abnormal_voltage") && same_text(esc11_alarm_code_text(INT64_C(12))->printed, "ABNORMAL VOLTAGE"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(13)) != NULL && esc11_alarm_code_text(INT64_C(13))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(13))->name, "system_fault_2") && same_text(esc11_alarm_code_text(INT64_C(13))->printed, "SYSTEM FAULT2"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(14)) != NULL && esc11_alarm_code_text(INT64_C(14))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(14))->name, "feedback_error_3") && same_text(esc11_alarm_code_text(INT64_C(14))->printed, "FEEDBACK ERROR3"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(32)) != NULL && esc11_alarm_code_text(INT64_C(32))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(32))->name, "soft_limit_exceeded") && same_text(esc11_alarm_code_text(INT64_C(32))->printed, "SOFT LIMIT OVER"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(33)) != NULL && esc11_alarm_code_text(INT64_C(33))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(33))->name, "pulse_overflow") && same_text(esc11_alarm_code_text(INT64_C(33))->printed, "PULSE OVERFLOW"), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(34)) != NULL && esc11_alarm_code_text(INT64_C(34))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(34))->name, "io_logic_error") && same_text(esc11_alarm_code_text(INT64_C(34))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(35)) != NULL && esc11_alarm_code_text(INT64_C(35))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(35))->name, "homing_incomplete") && same_text(esc11_alarm_code_text(INT64_C(35))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(36)) != NULL && esc11_alarm_code_text(INT64_C(36))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(36))->name, "servo_off") && same_text(esc11_alarm_code_text(INT64_C(36))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(37)) != NULL && esc11_alarm_code_text(INT64_C(37))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(37))->name, "interlock") && same_text(esc11_alarm_code_text(INT64_C(37))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(38)) != NULL && esc11_alarm_code_text(INT64_C(38))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(38))->name, "no_point") && same_text(esc11_alarm_code_text(INT64_C(38))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(39)) != NULL && esc11_alarm_code_text(INT64_C(39))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(39))->name, "operating") && same_text(esc11_alarm_code_text(INT64_C(39))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(40)) != NULL && esc11_alarm_code_text(INT64_C(40))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(40))->name, "processing") && same_text(esc11_alarm_code_text(INT64_C(40))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(41)) != NULL && esc11_alarm_code_text(INT64_C(41))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(41))->name, "home_not_found") && same_text(esc11_alarm_code_text(INT64_C(41))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(48)) != NULL && esc11_alarm_code_text(INT64_C(48))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(48))->name, "network_communication_error") && same_text(esc11_alarm_code_text(INT64_C(48))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(49)) != NULL && esc11_alarm_code_text(INT64_C(49))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(49))->name, "communication_command_error") && same_text(esc11_alarm_code_text(INT64_C(49))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(50)) != NULL && esc11_alarm_code_text(INT64_C(50))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(50))->name, "data_error") && same_text(esc11_alarm_code_text(INT64_C(50))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(51)) != NULL && esc11_alarm_code_text(INT64_C(51))->number == (-INT64_C(1)) && same_text(esc11_alarm_code_text(INT64_C(51))->name, "unknown_actuator_type") && same_text(esc11_alarm_code_text(INT64_C(51))->printed, ""), "esc11_alarm_code_text");
    expect(esc11_alarm_code_text(INT64_C(0)) == NULL, "esc11_alarm_code_text");
}

static void test_3(void)
{
    expect(ESC11_READ_POINTS_CODE == 80u, "ESC11_READ_POINTS_CODE");
    expect(ESC11_READ_PARAMETERS_CODE == 81u, "ESC11_READ_PARAMETERS_CODE");
    expect(ESC11_READ_IO_STATUS_CODE == 82u, "ESC11_READ_IO_STATUS_CODE");
    expect(ESC11_READ_ALARM_HISTORY_CODE == 83u, "ESC11_READ_ALARM_HISTORY_CODE");
    expect(ESC11_WRITE_POINTS_CODE == 96u, "ESC11_WRITE_POINTS_CODE");
    expect(ESC11_WRITE_PARAMETERS_CODE == 97u, "ESC11_WRITE_PARAMETERS_CODE");
    expect(ESC11_WRITE_PARAMETER_CODE == 98u, "ESC11_WRITE_PARAMETER_CODE");
    expect(ESC11_WRITE_TEMPORARY_POINT_CODE == 99u, "ESC11_WRITE_TEMPORARY_POINT_CODE");
    expect(ESC11_CLEAR_POINTS_CODE == 112u, "ESC11_CLEAR_POINTS_CODE");
    expect(ESC11_INITIALIZE_POINTS_CODE == 113u, "ESC11_INITIALIZE_POINTS_CODE");
    expect(ESC11_INITIALIZE_PARAMETERS_CODE == 114u, "ESC11_INITIALIZE_PARAMETERS_CODE");
    expect(ESC11_CLEAR_ALARM_HISTORY_CODE == 115u, "ESC11_CLEAR_ALARM_HISTORY_CODE");
    expect(ESC11_CLEAR_ACCUMULATED_TIME_CODE == 116u, "ESC11_CLEAR_ACCUMULATED_TIME_CODE");
    expect(ESC11_STOP_CODE == 16u, "ESC11_STOP_CODE");
    expect(ESC11_START_HOMING_CODE == 17u, "ESC11_START_HOMING_CODE");
    expect(ESC11_MOVE_POSITIVE_DISTANCE_CODE == 18u, "ESC11_MOVE_POSITIVE_DISTANCE_CODE");
    expect(ESC11_MOVE_NEGATIVE_DISTANCE_CODE == 19u, "ESC11_MOVE_NEGATIVE_DISTANCE_CODE");
    expect(ESC11_MOVE_OPEN_CODE == 20u, "ESC11_MOVE_OPEN_CODE");
    expect(ESC11_MOVE_CLOSE_CODE == 21u, "ESC11_MOVE_CLOSE_CODE");
    expect(ESC11_MOVE_RELATIVE_CODE == 22u, "ESC11_MOVE_RELATIVE_CODE");
    expect(ESC11_MOVE_ABSOLUTE_CODE == 23u, "ESC11_MOVE_ABSOLUTE_CODE");
    expect(ESC11_MOVE_TO_POINT_CODE == 26u, "ESC11_MOVE_TO_POINT_CODE");
    expect(ESC11_GRIP_OPEN_CODE == 32u, "ESC11_GRIP_OPEN_CODE");
    expect(ESC11_GRIP_CLOSE_CODE == 33u, "ESC11_GRIP_CLOSE_CODE");
    expect(ESC11_GRIP_RELATIVE_CODE == 34u, "ESC11_GRIP_RELATIVE_CODE");
    expect(ESC11_GRIP_ABSOLUTE_CODE == 35u, "ESC11_GRIP_ABSOLUTE_CODE");
    expect(ESC11_GRIP_OPEN_WITH_ZONE_CODE == 36u, "ESC11_GRIP_OPEN_WITH_ZONE_CODE");
    expect(ESC11_GRIP_CLOSE_WITH_ZONE_CODE == 37u, "ESC11_GRIP_CLOSE_WITH_ZONE_CODE");
    expect(ESC11_NO_OPERATION_CODE == 48u, "ESC11_NO_OPERATION_CODE");
    expect(ESC11_SET_MOTOR_EXCITATION_CODE == 49u, "ESC11_SET_MOTOR_EXCITATION_CODE");
    expect(ESC11_READ_VERSION_CODE == 64u, "ESC11_READ_VERSION_CODE");
    expect(ESC11_READ_CURRENT_POSITION_CODE == 65u, "ESC11_READ_CURRENT_POSITION_CODE");
    expect(ESC11_READ_CURRENT_POINT_NUMBER_CODE == 66u, "ESC11_READ_CURRENT_POINT_NUMBER_CODE");
    expect(ESC11_READ_PARAMETER_CODE == 67u, "ESC11_READ_PARAMETER_CODE");
    expect(ESC11_READ_POINT_CODE == 68u, "ESC11_READ_POINT_CODE");
    expect(ESC11_READ_HOMING_STATE_CODE == 69u, "ESC11_READ_HOMING_STATE_CODE");
    expect(ESC11_READ_MOTOR_EXCITATION_CODE == 70u, "ESC11_READ_MOTOR_EXCITATION_CODE");
    expect(ESC11_READ_ALARM_CODE_CODE == 71u, "ESC11_READ_ALARM_CODE_CODE");
    expect(ESC11_READ_ACCUMULATED_TIME_CODE == 72u, "ESC11_READ_ACCUMULATED_TIME_CODE");
    expect(ESC11_RESET_ALARM_CODE == 78u, "ESC11_RESET_ALARM_CODE");
}

static void test_4(void)
{
    expect(ESC11_PAR_PARAMETERS_ACTUATOR_TYPE_NUMBER == 0u, "ESC11_PAR_PARAMETERS_ACTUATOR_TYPE_NUMBER");
    expect(ESC11_PAR_PARAMETERS_POSITIVE_SOFT_LIMIT_NUMBER == 1u, "ESC11_PAR_PARAMETERS_POSITIVE_SOFT_LIMIT_NUMBER");
    expect(ESC11_PAR_PARAMETERS_NEGATIVE_SOFT_LIMIT_NUMBER == 2u, "ESC11_PAR_PARAMETERS_NEGATIVE_SOFT_LIMIT_NUMBER");
    expect(ESC11_PAR_PARAMETERS_STROKE_NUMBER == 3u, "ESC11_PAR_PARAMETERS_STROKE_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_4_NUMBER == 4u, "ESC11_PAR_PARAMETERS_PRESET_4_NUMBER");
    expect(ESC11_PAR_PARAMETERS_HOMING_DIRECTION_NUMBER == 5u, "ESC11_PAR_PARAMETERS_HOMING_DIRECTION_NUMBER");
    expect(ESC11_PAR_PARAMETERS_HOMING_SPEED_NUMBER == 6u, "ESC11_PAR_PARAMETERS_HOMING_SPEED_NUMBER");
    expect(ESC11_PAR_PARAMETERS_HOME_OFFSET_NUMBER == 7u, "ESC11_PAR_PARAMETERS_HOME_OFFSET_NUMBER");
    expect(ESC11_PAR_PARAMETERS_ACCELERATION_NUMBER == 8u, "ESC11_PAR_PARAMETERS_ACCELERATION_NUMBER");
    expect(ESC11_PAR_PARAMETERS_MAXIMUM_PROGRAM_SPEED_NUMBER == 9u, "ESC11_PAR_PARAMETERS_MAXIMUM_PROGRAM_SPEED_NUMBER");
    expect(ESC11_PAR_PARAMETERS_GRIPPING_SPEED_NUMBER == 10u, "ESC11_PAR_PARAMETERS_GRIPPING_SPEED_NUMBER");
    expect(ESC11_PAR_PARAMETERS_CONSTANT_SPEED_DISTANCE_NUMBER == 11u, "ESC11_PAR_PARAMETERS_CONSTANT_SPEED_DISTANCE_NUMBER");
    expect(ESC11_PAR_PARAMETERS_LIMIT_WIDTH_NUMBER == 12u, "ESC11_PAR_PARAMETERS_LIMIT_WIDTH_NUMBER");
    expect(ESC11_PAR_PARAMETERS_POSITIONING_COMPLETE_PULSES_NUMBER == 13u, "ESC11_PAR_PARAMETERS_POSITIONING_COMPLETE_PULSES_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_14_NUMBER == 14u, "ESC11_PAR_PARAMETERS_PRESET_14_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_15_NUMBER == 15u, "ESC11_PAR_PARAMETERS_PRESET_15_NUMBER");
    expect(ESC11_PAR_PARAMETERS_HOMING_METHOD_NUMBER == 16u, "ESC11_PAR_PARAMETERS_HOMING_METHOD_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_17_NUMBER == 17u, "ESC11_PAR_PARAMETERS_PRESET_17_NUMBER");
    expect(ESC11_PAR_PARAMETERS_UNREGISTERED_18_NUMBER == 18u, "ESC11_PAR_PARAMETERS_UNREGISTERED_18_NUMBER");
    expect(ESC11_PAR_PARAMETERS_UNREGISTERED_19_NUMBER == 19u, "ESC11_PAR_PARAMETERS_UNREGISTERED_19_NUMBER");
    expect(ESC11_PAR_PARAMETERS_UNREGISTERED_20_NUMBER == 20u, "ESC11_PAR_PARAMETERS_UNREGISTERED_20_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_21_NUMBER == 21u, "ESC11_PAR_PARAMETERS_PRESET_21_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_22_NUMBER == 22u, "ESC11_PAR_PARAMETERS_PRESET_22_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_23_NUMBER == 23u, "ESC11_PAR_PARAMETERS_PRESET_23_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_24_NUMBER == 24u, "ESC11_PAR_PARAMETERS_PRESET_24_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_25_NUMBER == 25u, "ESC11_PAR_PARAMETERS_PRESET_25_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_26_NUMBER == 26u, "ESC11_PAR_PARAMETERS_PRESET_26_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_27_NUMBER == 27u, "ESC11_PAR_PARAMETERS_PRESET_27_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_28_NUMBER == 28u, "ESC11_PAR_PARAMETERS_PRESET_28_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_29_NUMBER == 29u, "ESC11_PAR_PARAMETERS_PRESET_29_NUMBER");
    expect(ESC11_PAR_PARAMETERS_ACTUATOR_MAXIMUM_SPEED_NUMBER == 30u, "ESC11_PAR_PARAMETERS_ACTUATOR_MAXIMUM_SPEED_NUMBER");
    expect(ESC11_PAR_PARAMETERS_PRESET_31_NUMBER == 31u, "ESC11_PAR_PARAMETERS_PRESET_31_NUMBER");
}

static void test_5(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x00};
    uint8_t bytes[ESC11_ALARM_HISTORY_ENTRY_SIZE];
    esc11_alarm_history_entry in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.hours = 65535u;
    in.minutes = 0u;
    in.alarm_code = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_alarm_history_entry_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "alarm_history_entry.hours encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "alarm_history_entry.hours bytes");
    expect(esc11_alarm_history_entry_decode(bytes, length, &out) == ESC11_OK, "alarm_history_entry.hours decodes");
    expect(out.hours == 65535u, "alarm_history_entry.hours: hours");
    expect(out.minutes == 0u, "alarm_history_entry.hours: minutes");
    expect(out.alarm_code == 0u, "alarm_history_entry.hours: alarm_code");
    expect(esc11_alarm_history_entry_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "alarm_history_entry.hours short");
    expect(esc11_alarm_history_entry_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "alarm_history_entry.hours cut");
}

static void test_6(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x3C, 0x00};
    uint8_t bytes[ESC11_ALARM_HISTORY_ENTRY_SIZE];
    esc11_alarm_history_entry in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.hours = 0u;
    in.minutes = 60u;
    in.alarm_code = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_alarm_history_entry_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "alarm_history_entry.minutes encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "alarm_history_entry.minutes bytes");
    expect(esc11_alarm_history_entry_decode(bytes, length, &out) == ESC11_OK, "alarm_history_entry.minutes decodes");
    expect(out.hours == 0u, "alarm_history_entry.minutes: hours");
    expect(out.minutes == 60u, "alarm_history_entry.minutes: minutes");
    expect(out.alarm_code == 0u, "alarm_history_entry.minutes: alarm_code");
    expect(esc11_alarm_history_entry_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "alarm_history_entry.minutes short");
    expect(esc11_alarm_history_entry_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "alarm_history_entry.minutes cut");
}

static void test_7(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0xFF};
    uint8_t bytes[ESC11_ALARM_HISTORY_ENTRY_SIZE];
    esc11_alarm_history_entry in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.hours = 0u;
    in.minutes = 0u;
    in.alarm_code = 255u;
    copy(&in, &in, sizeof in);
    expect(esc11_alarm_history_entry_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "alarm_history_entry.alarm_code encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "alarm_history_entry.alarm_code bytes");
    expect(esc11_alarm_history_entry_decode(bytes, length, &out) == ESC11_OK, "alarm_history_entry.alarm_code decodes");
    expect(out.hours == 0u, "alarm_history_entry.alarm_code: hours");
    expect(out.minutes == 0u, "alarm_history_entry.alarm_code: minutes");
    expect(out.alarm_code == 255u, "alarm_history_entry.alarm_code: alarm_code");
    expect(esc11_alarm_history_entry_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "alarm_history_entry.alarm_code short");
    expect(esc11_alarm_history_entry_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "alarm_history_entry.alarm_code cut");
}

static void test_8(void)
{
    static const uint8_t wanted[] = {0x1F, 0x41, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x00, 0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_POINT_SIZE];
    esc11_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.number = 31u;
    in.mode = 65u;
    in.distance = (-134217727);
    in.speed = 0u;
    in.force = 0u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "point.number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.number bytes");
    expect(esc11_point_decode(bytes, length, &out) == ESC11_OK, "point.number decodes");
    expect(out.number == 31u, "point.number: number");
    expect(out.mode == 65u, "point.number: mode");
    expect(out.distance == (-134217727), "point.number: distance");
    expect(out.speed == 0u, "point.number: speed");
    expect(out.force == 0u, "point.number: force");
    expect(out.zone_limit_1 == (-134217727), "point.number: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "point.number: zone_limit_2");
    expect(esc11_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "point.number short");
    expect(esc11_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "point.number cut");
}

static void test_9(void)
{
    static const uint8_t wanted[] = {0x01, 0x4F, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x00, 0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_POINT_SIZE];
    esc11_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.number = 1u;
    in.mode = 79u;
    in.distance = (-134217727);
    in.speed = 0u;
    in.force = 0u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "point.mode encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.mode bytes");
    expect(esc11_point_decode(bytes, length, &out) == ESC11_OK, "point.mode decodes");
    expect(out.number == 1u, "point.mode: number");
    expect(out.mode == 79u, "point.mode: mode");
    expect(out.distance == (-134217727), "point.mode: distance");
    expect(out.speed == 0u, "point.mode: speed");
    expect(out.force == 0u, "point.mode: force");
    expect(out.zone_limit_1 == (-134217727), "point.mode: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "point.mode: zone_limit_2");
    expect(esc11_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "point.mode short");
    expect(esc11_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "point.mode cut");
}

static void test_10(void)
{
    static const uint8_t wanted[] = {0x01, 0x41, 0xFF, 0xFF, 0xFF, 0x07, 0x00, 0x00, 0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_POINT_SIZE];
    esc11_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.number = 1u;
    in.mode = 65u;
    in.distance = 134217727;
    in.speed = 0u;
    in.force = 0u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "point.distance encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.distance bytes");
    expect(esc11_point_decode(bytes, length, &out) == ESC11_OK, "point.distance decodes");
    expect(out.number == 1u, "point.distance: number");
    expect(out.mode == 65u, "point.distance: mode");
    expect(out.distance == 134217727, "point.distance: distance");
    expect(out.speed == 0u, "point.distance: speed");
    expect(out.force == 0u, "point.distance: force");
    expect(out.zone_limit_1 == (-134217727), "point.distance: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "point.distance: zone_limit_2");
    expect(esc11_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "point.distance short");
    expect(esc11_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "point.distance cut");
}

static void test_11(void)
{
    static const uint8_t wanted[] = {0x01, 0x41, 0x01, 0x00, 0x00, 0xF8, 0x64, 0x00, 0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_POINT_SIZE];
    esc11_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.number = 1u;
    in.mode = 65u;
    in.distance = (-134217727);
    in.speed = 100u;
    in.force = 0u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "point.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.speed bytes");
    expect(esc11_point_decode(bytes, length, &out) == ESC11_OK, "point.speed decodes");
    expect(out.number == 1u, "point.speed: number");
    expect(out.mode == 65u, "point.speed: mode");
    expect(out.distance == (-134217727), "point.speed: distance");
    expect(out.speed == 100u, "point.speed: speed");
    expect(out.force == 0u, "point.speed: force");
    expect(out.zone_limit_1 == (-134217727), "point.speed: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "point.speed: zone_limit_2");
    expect(esc11_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "point.speed short");
    expect(esc11_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "point.speed cut");
}

static void test_12(void)
{
    static const uint8_t wanted[] = {0x01, 0x41, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x64, 0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_POINT_SIZE];
    esc11_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.number = 1u;
    in.mode = 65u;
    in.distance = (-134217727);
    in.speed = 0u;
    in.force = 100u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "point.force encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.force bytes");
    expect(esc11_point_decode(bytes, length, &out) == ESC11_OK, "point.force decodes");
    expect(out.number == 1u, "point.force: number");
    expect(out.mode == 65u, "point.force: mode");
    expect(out.distance == (-134217727), "point.force: distance");
    expect(out.speed == 0u, "point.force: speed");
    expect(out.force == 100u, "point.force: force");
    expect(out.zone_limit_1 == (-134217727), "point.force: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "point.force: zone_limit_2");
    expect(esc11_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "point.force short");
    expect(esc11_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "point.force cut");
}

static void test_13(void)
{
    static const uint8_t wanted[] = {0x01, 0x41, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0x07, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_POINT_SIZE];
    esc11_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.number = 1u;
    in.mode = 65u;
    in.distance = (-134217727);
    in.speed = 0u;
    in.force = 0u;
    in.zone_limit_1 = 134217727;
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "point.zone_limit_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.zone_limit_1 bytes");
    expect(esc11_point_decode(bytes, length, &out) == ESC11_OK, "point.zone_limit_1 decodes");
    expect(out.number == 1u, "point.zone_limit_1: number");
    expect(out.mode == 65u, "point.zone_limit_1: mode");
    expect(out.distance == (-134217727), "point.zone_limit_1: distance");
    expect(out.speed == 0u, "point.zone_limit_1: speed");
    expect(out.force == 0u, "point.zone_limit_1: force");
    expect(out.zone_limit_1 == 134217727, "point.zone_limit_1: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "point.zone_limit_1: zone_limit_2");
    expect(esc11_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "point.zone_limit_1 short");
    expect(esc11_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "point.zone_limit_1 cut");
}

static void test_14(void)
{
    static const uint8_t wanted[] = {0x01, 0x41, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x00, 0x01, 0x00, 0x00, 0xF8, 0xFF, 0xFF, 0xFF, 0x07};
    uint8_t bytes[ESC11_POINT_SIZE];
    esc11_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.number = 1u;
    in.mode = 65u;
    in.distance = (-134217727);
    in.speed = 0u;
    in.force = 0u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = 134217727;
    copy(&in, &in, sizeof in);
    expect(esc11_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "point.zone_limit_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.zone_limit_2 bytes");
    expect(esc11_point_decode(bytes, length, &out) == ESC11_OK, "point.zone_limit_2 decodes");
    expect(out.number == 1u, "point.zone_limit_2: number");
    expect(out.mode == 65u, "point.zone_limit_2: mode");
    expect(out.distance == (-134217727), "point.zone_limit_2: distance");
    expect(out.speed == 0u, "point.zone_limit_2: speed");
    expect(out.force == 0u, "point.zone_limit_2: force");
    expect(out.zone_limit_1 == (-134217727), "point.zone_limit_2: zone_limit_1");
    expect(out.zone_limit_2 == 134217727, "point.zone_limit_2: zone_limit_2");
    expect(esc11_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "point.zone_limit_2 short");
    expect(esc11_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "point.zone_limit_2 cut");
}

static void test_15(void)
{
    static const uint8_t wanted[] = {0x00, 0x4F, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x00, 0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_TEMPORARY_POINT_SIZE];
    esc11_temporary_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 79u;
    in.distance = (-134217727);
    in.speed = 0u;
    in.force = 0u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_temporary_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "temporary_point.mode encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "temporary_point.mode bytes");
    expect(esc11_temporary_point_decode(bytes, length, &out) == ESC11_OK, "temporary_point.mode decodes");
    expect(out.mode == 79u, "temporary_point.mode: mode");
    expect(out.distance == (-134217727), "temporary_point.mode: distance");
    expect(out.speed == 0u, "temporary_point.mode: speed");
    expect(out.force == 0u, "temporary_point.mode: force");
    expect(out.zone_limit_1 == (-134217727), "temporary_point.mode: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "temporary_point.mode: zone_limit_2");
    expect(esc11_temporary_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "temporary_point.mode short");
    expect(esc11_temporary_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "temporary_point.mode cut");
}

static void test_16(void)
{
    static const uint8_t wanted[] = {0x00, 0x41, 0xFF, 0xFF, 0xFF, 0x07, 0x00, 0x00, 0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_TEMPORARY_POINT_SIZE];
    esc11_temporary_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 65u;
    in.distance = 134217727;
    in.speed = 0u;
    in.force = 0u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_temporary_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "temporary_point.distance encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "temporary_point.distance bytes");
    expect(esc11_temporary_point_decode(bytes, length, &out) == ESC11_OK, "temporary_point.distance decodes");
    expect(out.mode == 65u, "temporary_point.distance: mode");
    expect(out.distance == 134217727, "temporary_point.distance: distance");
    expect(out.speed == 0u, "temporary_point.distance: speed");
    expect(out.force == 0u, "temporary_point.distance: force");
    expect(out.zone_limit_1 == (-134217727), "temporary_point.distance: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "temporary_point.distance: zone_limit_2");
    expect(esc11_temporary_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "temporary_point.distance short");
    expect(esc11_temporary_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "temporary_point.distance cut");
}

static void test_17(void)
{
    static const uint8_t wanted[] = {0x00, 0x41, 0x01, 0x00, 0x00, 0xF8, 0x64, 0x00, 0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_TEMPORARY_POINT_SIZE];
    esc11_temporary_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 65u;
    in.distance = (-134217727);
    in.speed = 100u;
    in.force = 0u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_temporary_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "temporary_point.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "temporary_point.speed bytes");
    expect(esc11_temporary_point_decode(bytes, length, &out) == ESC11_OK, "temporary_point.speed decodes");
    expect(out.mode == 65u, "temporary_point.speed: mode");
    expect(out.distance == (-134217727), "temporary_point.speed: distance");
    expect(out.speed == 100u, "temporary_point.speed: speed");
    expect(out.force == 0u, "temporary_point.speed: force");
    expect(out.zone_limit_1 == (-134217727), "temporary_point.speed: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "temporary_point.speed: zone_limit_2");
    expect(esc11_temporary_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "temporary_point.speed short");
    expect(esc11_temporary_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "temporary_point.speed cut");
}

static void test_18(void)
{
    static const uint8_t wanted[] = {0x00, 0x41, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x64, 0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_TEMPORARY_POINT_SIZE];
    esc11_temporary_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 65u;
    in.distance = (-134217727);
    in.speed = 0u;
    in.force = 100u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_temporary_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "temporary_point.force encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "temporary_point.force bytes");
    expect(esc11_temporary_point_decode(bytes, length, &out) == ESC11_OK, "temporary_point.force decodes");
    expect(out.mode == 65u, "temporary_point.force: mode");
    expect(out.distance == (-134217727), "temporary_point.force: distance");
    expect(out.speed == 0u, "temporary_point.force: speed");
    expect(out.force == 100u, "temporary_point.force: force");
    expect(out.zone_limit_1 == (-134217727), "temporary_point.force: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "temporary_point.force: zone_limit_2");
    expect(esc11_temporary_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "temporary_point.force short");
    expect(esc11_temporary_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "temporary_point.force cut");
}

static void test_19(void)
{
    static const uint8_t wanted[] = {0x00, 0x41, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0x07, 0x01, 0x00, 0x00, 0xF8};
    uint8_t bytes[ESC11_TEMPORARY_POINT_SIZE];
    esc11_temporary_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 65u;
    in.distance = (-134217727);
    in.speed = 0u;
    in.force = 0u;
    in.zone_limit_1 = 134217727;
    in.zone_limit_2 = (-134217727);
    copy(&in, &in, sizeof in);
    expect(esc11_temporary_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "temporary_point.zone_limit_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "temporary_point.zone_limit_1 bytes");
    expect(esc11_temporary_point_decode(bytes, length, &out) == ESC11_OK, "temporary_point.zone_limit_1 decodes");
    expect(out.mode == 65u, "temporary_point.zone_limit_1: mode");
    expect(out.distance == (-134217727), "temporary_point.zone_limit_1: distance");
    expect(out.speed == 0u, "temporary_point.zone_limit_1: speed");
    expect(out.force == 0u, "temporary_point.zone_limit_1: force");
    expect(out.zone_limit_1 == 134217727, "temporary_point.zone_limit_1: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "temporary_point.zone_limit_1: zone_limit_2");
    expect(esc11_temporary_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "temporary_point.zone_limit_1 short");
    expect(esc11_temporary_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "temporary_point.zone_limit_1 cut");
}

static void test_20(void)
{
    static const uint8_t wanted[] = {0x00, 0x41, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x00, 0x01, 0x00, 0x00, 0xF8, 0xFF, 0xFF, 0xFF, 0x07};
    uint8_t bytes[ESC11_TEMPORARY_POINT_SIZE];
    esc11_temporary_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.mode = 65u;
    in.distance = (-134217727);
    in.speed = 0u;
    in.force = 0u;
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = 134217727;
    copy(&in, &in, sizeof in);
    expect(esc11_temporary_point_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "temporary_point.zone_limit_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "temporary_point.zone_limit_2 bytes");
    expect(esc11_temporary_point_decode(bytes, length, &out) == ESC11_OK, "temporary_point.zone_limit_2 decodes");
    expect(out.mode == 65u, "temporary_point.zone_limit_2: mode");
    expect(out.distance == (-134217727), "temporary_point.zone_limit_2: distance");
    expect(out.speed == 0u, "temporary_point.zone_limit_2: speed");
    expect(out.force == 0u, "temporary_point.zone_limit_2: force");
    expect(out.zone_limit_1 == (-134217727), "temporary_point.zone_limit_2: zone_limit_1");
    expect(out.zone_limit_2 == 134217727, "temporary_point.zone_limit_2: zone_limit_2");
    expect(esc11_temporary_point_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "temporary_point.zone_limit_2 short");
    expect(esc11_temporary_point_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "temporary_point.zone_limit_2 cut");
}

static void test_21(void)
{
    static const uint8_t wanted[] = {0x1F};
    uint8_t bytes[ESC11_READ_POINTS_REQUEST_SIZE];
    esc11_read_points_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.first_point = 31u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_points_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_points_request.first_point encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_points_request.first_point bytes");
    expect(esc11_read_points_request_decode(bytes, length, &out) == ESC11_OK, "read_points_request.first_point decodes");
    expect(out.first_point == 31u, "read_points_request.first_point: first_point");
    expect(esc11_read_points_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_points_request.first_point short");
    expect(esc11_read_points_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_points_request.first_point cut");
}

static void test_22(void)
{
    static const uint8_t wanted[] = {0x1F, 0x4F, 0xFF, 0xFF, 0xFF, 0x07, 0x64, 0x64, 0xFF, 0xFF, 0xFF, 0x07, 0xFF, 0xFF, 0xFF, 0x07};
    uint8_t bytes[ESC11_READ_POINTS_RESPONSE_SIZE];
    esc11_read_points_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.points_count = 1u;
    in.points[0].number = 31u;
    in.points[0].mode = 79u;
    in.points[0].distance = 134217727;
    in.points[0].speed = 100u;
    in.points[0].force = 100u;
    in.points[0].zone_limit_1 = 134217727;
    in.points[0].zone_limit_2 = 134217727;
    copy(&in, &in, sizeof in);
    expect(esc11_read_points_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_points_response.points encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_points_response.points bytes");
    expect(esc11_read_points_response_decode(bytes, length, &out) == ESC11_OK, "read_points_response.points decodes");
    expect(out.points_count == 1u, "read_points_response.points: points count");
    expect(out.points[0].number == 31u, "read_points_response.points: number");
    expect(out.points[0].mode == 79u, "read_points_response.points: mode");
    expect(out.points[0].distance == 134217727, "read_points_response.points: distance");
    expect(out.points[0].speed == 100u, "read_points_response.points: speed");
    expect(out.points[0].force == 100u, "read_points_response.points: force");
    expect(out.points[0].zone_limit_1 == 134217727, "read_points_response.points: zone_limit_1");
    expect(out.points[0].zone_limit_2 == 134217727, "read_points_response.points: zone_limit_2");
    expect(esc11_read_points_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_points_response.points short");
    expect(esc11_read_points_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_points_response.points cut");
}

static void test_23(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[ESC11_READ_PARAMETERS_RESPONSE_SIZE];
    esc11_read_parameters_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.parameters[0] = 65535u;
    in.parameters[1] = 65535u;
    in.parameters[2] = 65535u;
    in.parameters[3] = 65535u;
    in.parameters[4] = 65535u;
    in.parameters[5] = 65535u;
    in.parameters[6] = 65535u;
    in.parameters[7] = 65535u;
    in.parameters[8] = 65535u;
    in.parameters[9] = 65535u;
    in.parameters[10] = 65535u;
    in.parameters[11] = 65535u;
    in.parameters[12] = 65535u;
    in.parameters[13] = 65535u;
    in.parameters[14] = 65535u;
    in.parameters[15] = 65535u;
    in.parameters[16] = 65535u;
    in.parameters[17] = 65535u;
    in.parameters[18] = 65535u;
    in.parameters[19] = 65535u;
    in.parameters[20] = 65535u;
    in.parameters[21] = 65535u;
    in.parameters[22] = 65535u;
    in.parameters[23] = 65535u;
    in.parameters[24] = 65535u;
    in.parameters[25] = 65535u;
    in.parameters[26] = 65535u;
    in.parameters[27] = 65535u;
    in.parameters[28] = 65535u;
    in.parameters[29] = 65535u;
    in.parameters[30] = 65535u;
    in.parameters[31] = 65535u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_parameters_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_parameters_response.parameters encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameters_response.parameters bytes");
    expect(esc11_read_parameters_response_decode(bytes, length, &out) == ESC11_OK, "read_parameters_response.parameters decodes");
    expect(out.parameters[0] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[1] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[2] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[3] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[4] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[5] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[6] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[7] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[8] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[9] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[10] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[11] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[12] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[13] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[14] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[15] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[16] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[17] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[18] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[19] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[20] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[21] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[22] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[23] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[24] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[25] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[26] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[27] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[28] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[29] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[30] == 65535u, "read_parameters_response.parameters: parameters");
    expect(out.parameters[31] == 65535u, "read_parameters_response.parameters: parameters");
    expect(esc11_read_parameters_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_parameters_response.parameters short");
    expect(esc11_read_parameters_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_parameters_response.parameters cut");
}

static void test_24(void)
{
    static const uint8_t wanted[] = {0xFF, 0x00, 0x00};
    uint8_t bytes[ESC11_READ_IO_STATUS_RESPONSE_SIZE];
    esc11_read_io_status_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.inputs = 255u;
    in.outputs = 0u;
    in.state_outputs = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_io_status_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_io_status_response.inputs encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_io_status_response.inputs bytes");
    expect(esc11_read_io_status_response_decode(bytes, length, &out) == ESC11_OK, "read_io_status_response.inputs decodes");
    expect(out.inputs == 255u, "read_io_status_response.inputs: inputs");
    expect(out.outputs == 0u, "read_io_status_response.inputs: outputs");
    expect(out.state_outputs == 0u, "read_io_status_response.inputs: state_outputs");
    expect(esc11_read_io_status_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_io_status_response.inputs short");
    expect(esc11_read_io_status_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_io_status_response.inputs cut");
}

static void test_25(void)
{
    static const uint8_t wanted[] = {0x00, 0xFF, 0x00};
    uint8_t bytes[ESC11_READ_IO_STATUS_RESPONSE_SIZE];
    esc11_read_io_status_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.inputs = 0u;
    in.outputs = 255u;
    in.state_outputs = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_io_status_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_io_status_response.outputs encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_io_status_response.outputs bytes");
    expect(esc11_read_io_status_response_decode(bytes, length, &out) == ESC11_OK, "read_io_status_response.outputs decodes");
    expect(out.inputs == 0u, "read_io_status_response.outputs: inputs");
    expect(out.outputs == 255u, "read_io_status_response.outputs: outputs");
    expect(out.state_outputs == 0u, "read_io_status_response.outputs: state_outputs");
    expect(esc11_read_io_status_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_io_status_response.outputs short");
    expect(esc11_read_io_status_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_io_status_response.outputs cut");
}

static void test_26(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0xFF};
    uint8_t bytes[ESC11_READ_IO_STATUS_RESPONSE_SIZE];
    esc11_read_io_status_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.inputs = 0u;
    in.outputs = 0u;
    in.state_outputs = 255u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_io_status_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_io_status_response.state_outputs encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_io_status_response.state_outputs bytes");
    expect(esc11_read_io_status_response_decode(bytes, length, &out) == ESC11_OK, "read_io_status_response.state_outputs decodes");
    expect(out.inputs == 0u, "read_io_status_response.state_outputs: inputs");
    expect(out.outputs == 0u, "read_io_status_response.state_outputs: outputs");
    expect(out.state_outputs == 255u, "read_io_status_response.state_outputs: state_outputs");
    expect(esc11_read_io_status_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_io_status_response.state_outputs short");
    expect(esc11_read_io_status_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_io_status_response.state_outputs cut");
}

static void test_27(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x3C, 0xFF};
    uint8_t bytes[ESC11_READ_ALARM_HISTORY_RESPONSE_SIZE];
    esc11_read_alarm_history_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.entries_count = 1u;
    in.entries[0].hours = 65535u;
    in.entries[0].minutes = 60u;
    in.entries[0].alarm_code = 255u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_alarm_history_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_alarm_history_response.entries encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_alarm_history_response.entries bytes");
    expect(esc11_read_alarm_history_response_decode(bytes, length, &out) == ESC11_OK, "read_alarm_history_response.entries decodes");
    expect(out.entries_count == 1u, "read_alarm_history_response.entries: entries count");
    expect(out.entries[0].hours == 65535u, "read_alarm_history_response.entries: hours");
    expect(out.entries[0].minutes == 60u, "read_alarm_history_response.entries: minutes");
    expect(out.entries[0].alarm_code == 255u, "read_alarm_history_response.entries: alarm_code");
    expect(esc11_read_alarm_history_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_alarm_history_response.entries short");
    expect(esc11_read_alarm_history_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_alarm_history_response.entries cut");
}

static void test_28(void)
{
    static const uint8_t wanted[] = {0x1F, 0x4F, 0xFF, 0xFF, 0xFF, 0x07, 0x64, 0x64, 0xFF, 0xFF, 0xFF, 0x07, 0xFF, 0xFF, 0xFF, 0x07};
    uint8_t bytes[ESC11_WRITE_POINTS_REQUEST_SIZE];
    esc11_write_points_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.points_count = 1u;
    in.points[0].number = 31u;
    in.points[0].mode = 79u;
    in.points[0].distance = 134217727;
    in.points[0].speed = 100u;
    in.points[0].force = 100u;
    in.points[0].zone_limit_1 = 134217727;
    in.points[0].zone_limit_2 = 134217727;
    copy(&in, &in, sizeof in);
    expect(esc11_write_points_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "write_points_request.points encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_points_request.points bytes");
    expect(esc11_write_points_request_decode(bytes, length, &out) == ESC11_OK, "write_points_request.points decodes");
    expect(out.points_count == 1u, "write_points_request.points: points count");
    expect(out.points[0].number == 31u, "write_points_request.points: number");
    expect(out.points[0].mode == 79u, "write_points_request.points: mode");
    expect(out.points[0].distance == 134217727, "write_points_request.points: distance");
    expect(out.points[0].speed == 100u, "write_points_request.points: speed");
    expect(out.points[0].force == 100u, "write_points_request.points: force");
    expect(out.points[0].zone_limit_1 == 134217727, "write_points_request.points: zone_limit_1");
    expect(out.points[0].zone_limit_2 == 134217727, "write_points_request.points: zone_limit_2");
    expect(esc11_write_points_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "write_points_request.points short");
    expect(esc11_write_points_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "write_points_request.points cut");
}

static void test_29(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[ESC11_WRITE_PARAMETERS_REQUEST_SIZE];
    esc11_write_parameters_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.parameters[0] = 65535u;
    in.parameters[1] = 65535u;
    in.parameters[2] = 65535u;
    in.parameters[3] = 65535u;
    in.parameters[4] = 65535u;
    in.parameters[5] = 65535u;
    in.parameters[6] = 65535u;
    in.parameters[7] = 65535u;
    in.parameters[8] = 65535u;
    in.parameters[9] = 65535u;
    in.parameters[10] = 65535u;
    in.parameters[11] = 65535u;
    in.parameters[12] = 65535u;
    in.parameters[13] = 65535u;
    in.parameters[14] = 65535u;
    in.parameters[15] = 65535u;
    in.parameters[16] = 65535u;
    in.parameters[17] = 65535u;
    in.parameters[18] = 65535u;
    in.parameters[19] = 65535u;
    in.parameters[20] = 65535u;
    in.parameters[21] = 65535u;
    in.parameters[22] = 65535u;
    in.parameters[23] = 65535u;
    in.parameters[24] = 65535u;
    in.parameters[25] = 65535u;
    in.parameters[26] = 65535u;
    in.parameters[27] = 65535u;
    in.parameters[28] = 65535u;
    in.parameters[29] = 65535u;
    in.parameters[30] = 65535u;
    in.parameters[31] = 65535u;
    copy(&in, &in, sizeof in);
    expect(esc11_write_parameters_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "write_parameters_request.parameters encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameters_request.parameters bytes");
    expect(esc11_write_parameters_request_decode(bytes, length, &out) == ESC11_OK, "write_parameters_request.parameters decodes");
    expect(out.parameters[0] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[1] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[2] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[3] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[4] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[5] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[6] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[7] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[8] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[9] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[10] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[11] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[12] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[13] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[14] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[15] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[16] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[17] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[18] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[19] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[20] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[21] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[22] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[23] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[24] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[25] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[26] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[27] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[28] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[29] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[30] == 65535u, "write_parameters_request.parameters: parameters");
    expect(out.parameters[31] == 65535u, "write_parameters_request.parameters: parameters");
    expect(esc11_write_parameters_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "write_parameters_request.parameters short");
    expect(esc11_write_parameters_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "write_parameters_request.parameters cut");
}

static void test_30(void)
{
    static const uint8_t wanted[] = {0x1F, 0x00, 0x00};
    uint8_t bytes[ESC11_WRITE_PARAMETER_REQUEST_SIZE];
    esc11_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.parameter_number = 31u;
    in.value = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "write_parameter_request.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.parameter_number bytes");
    expect(esc11_write_parameter_request_decode(bytes, length, &out) == ESC11_OK, "write_parameter_request.parameter_number decodes");
    expect(out.parameter_number == 31u, "write_parameter_request.parameter_number: parameter_number");
    expect(out.value == 0u, "write_parameter_request.parameter_number: value");
    expect(esc11_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "write_parameter_request.parameter_number short");
    expect(esc11_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "write_parameter_request.parameter_number cut");
}

static void test_31(void)
{
    static const uint8_t wanted[] = {0x00, 0xFF, 0xFF};
    uint8_t bytes[ESC11_WRITE_PARAMETER_REQUEST_SIZE];
    esc11_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.parameter_number = 0u;
    in.value = 65535u;
    copy(&in, &in, sizeof in);
    expect(esc11_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "write_parameter_request.value encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.value bytes");
    expect(esc11_write_parameter_request_decode(bytes, length, &out) == ESC11_OK, "write_parameter_request.value decodes");
    expect(out.parameter_number == 0u, "write_parameter_request.value: parameter_number");
    expect(out.value == 65535u, "write_parameter_request.value: value");
    expect(esc11_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "write_parameter_request.value short");
    expect(esc11_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "write_parameter_request.value cut");
}

static void test_32(void)
{
    static const uint8_t wanted[] = {0x00, 0x4F, 0xFF, 0xFF, 0xFF, 0x07, 0x64, 0x64, 0xFF, 0xFF, 0xFF, 0x07, 0xFF, 0xFF, 0xFF, 0x07};
    uint8_t bytes[ESC11_WRITE_TEMPORARY_POINT_REQUEST_SIZE];
    esc11_write_temporary_point_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.point.mode = 79u;
    in.point.distance = 134217727;
    in.point.speed = 100u;
    in.point.force = 100u;
    in.point.zone_limit_1 = 134217727;
    in.point.zone_limit_2 = 134217727;
    copy(&in, &in, sizeof in);
    expect(esc11_write_temporary_point_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "write_temporary_point_request.point encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_temporary_point_request.point bytes");
    expect(esc11_write_temporary_point_request_decode(bytes, length, &out) == ESC11_OK, "write_temporary_point_request.point decodes");
    expect(out.point.mode == 79u, "write_temporary_point_request.point: mode");
    expect(out.point.distance == 134217727, "write_temporary_point_request.point: distance");
    expect(out.point.speed == 100u, "write_temporary_point_request.point: speed");
    expect(out.point.force == 100u, "write_temporary_point_request.point: force");
    expect(out.point.zone_limit_1 == 134217727, "write_temporary_point_request.point: zone_limit_1");
    expect(out.point.zone_limit_2 == 134217727, "write_temporary_point_request.point: zone_limit_2");
    expect(esc11_write_temporary_point_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "write_temporary_point_request.point short");
    expect(esc11_write_temporary_point_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "write_temporary_point_request.point cut");
}

static void test_33(void)
{
    static const uint8_t wanted[] = {0x1F, 0x01};
    uint8_t bytes[ESC11_CLEAR_POINTS_REQUEST_SIZE];
    esc11_clear_points_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.first_point = 31u;
    in.point_count = 1u;
    copy(&in, &in, sizeof in);
    expect(esc11_clear_points_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "clear_points_request.first_point encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "clear_points_request.first_point bytes");
    expect(esc11_clear_points_request_decode(bytes, length, &out) == ESC11_OK, "clear_points_request.first_point decodes");
    expect(out.first_point == 31u, "clear_points_request.first_point: first_point");
    expect(out.point_count == 1u, "clear_points_request.first_point: point_count");
    expect(esc11_clear_points_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "clear_points_request.first_point short");
    expect(esc11_clear_points_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "clear_points_request.first_point cut");
}

static void test_34(void)
{
    static const uint8_t wanted[] = {0x01, 0x1F};
    uint8_t bytes[ESC11_CLEAR_POINTS_REQUEST_SIZE];
    esc11_clear_points_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.first_point = 1u;
    in.point_count = 31u;
    copy(&in, &in, sizeof in);
    expect(esc11_clear_points_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "clear_points_request.point_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "clear_points_request.point_count bytes");
    expect(esc11_clear_points_request_decode(bytes, length, &out) == ESC11_OK, "clear_points_request.point_count decodes");
    expect(out.first_point == 1u, "clear_points_request.point_count: first_point");
    expect(out.point_count == 31u, "clear_points_request.point_count: point_count");
    expect(esc11_clear_points_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "clear_points_request.point_count short");
    expect(esc11_clear_points_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "clear_points_request.point_count cut");
}

static void test_35(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF};
    uint8_t bytes[ESC11_INITIALIZE_PARAMETERS_REQUEST_SIZE];
    esc11_initialize_parameters_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.actuator_type = 65535u;
    copy(&in, &in, sizeof in);
    expect(esc11_initialize_parameters_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "initialize_parameters_request.actuator_type encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "initialize_parameters_request.actuator_type bytes");
    expect(esc11_initialize_parameters_request_decode(bytes, length, &out) == ESC11_OK, "initialize_parameters_request.actuator_type decodes");
    expect(out.actuator_type == 65535u, "initialize_parameters_request.actuator_type: actuator_type");
    expect(esc11_initialize_parameters_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "initialize_parameters_request.actuator_type short");
    expect(esc11_initialize_parameters_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "initialize_parameters_request.actuator_type cut");
}

static void test_36(void)
{
    static const uint8_t wanted[] = {0xFF, 0x01, 0x00};
    uint8_t bytes[ESC11_MOVE_POSITIVE_DISTANCE_REQUEST_SIZE];
    esc11_move_positive_distance_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = 255u;
    in.speed = 1u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_positive_distance_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_positive_distance_request.distance encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_positive_distance_request.distance bytes");
    expect(esc11_move_positive_distance_request_decode(bytes, length, &out) == ESC11_OK, "move_positive_distance_request.distance decodes");
    expect(out.distance == 255u, "move_positive_distance_request.distance: distance");
    expect(out.speed == 1u, "move_positive_distance_request.distance: speed");
    expect(out.force == 0u, "move_positive_distance_request.distance: force");
    expect(esc11_move_positive_distance_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_positive_distance_request.distance short");
    expect(esc11_move_positive_distance_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_positive_distance_request.distance cut");
}

static void test_37(void)
{
    static const uint8_t wanted[] = {0x01, 0x64, 0x00};
    uint8_t bytes[ESC11_MOVE_POSITIVE_DISTANCE_REQUEST_SIZE];
    esc11_move_positive_distance_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = 1u;
    in.speed = 100u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_positive_distance_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_positive_distance_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_positive_distance_request.speed bytes");
    expect(esc11_move_positive_distance_request_decode(bytes, length, &out) == ESC11_OK, "move_positive_distance_request.speed decodes");
    expect(out.distance == 1u, "move_positive_distance_request.speed: distance");
    expect(out.speed == 100u, "move_positive_distance_request.speed: speed");
    expect(out.force == 0u, "move_positive_distance_request.speed: force");
    expect(esc11_move_positive_distance_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_positive_distance_request.speed short");
    expect(esc11_move_positive_distance_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_positive_distance_request.speed cut");
}

static void test_38(void)
{
    static const uint8_t wanted[] = {0x01, 0x01, 0x64};
    uint8_t bytes[ESC11_MOVE_POSITIVE_DISTANCE_REQUEST_SIZE];
    esc11_move_positive_distance_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = 1u;
    in.speed = 1u;
    in.force = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_positive_distance_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_positive_distance_request.force encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_positive_distance_request.force bytes");
    expect(esc11_move_positive_distance_request_decode(bytes, length, &out) == ESC11_OK, "move_positive_distance_request.force decodes");
    expect(out.distance == 1u, "move_positive_distance_request.force: distance");
    expect(out.speed == 1u, "move_positive_distance_request.force: speed");
    expect(out.force == 100u, "move_positive_distance_request.force: force");
    expect(esc11_move_positive_distance_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_positive_distance_request.force short");
    expect(esc11_move_positive_distance_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_positive_distance_request.force cut");
}

static void test_39(void)
{
    static const uint8_t wanted[] = {0xFF, 0x01, 0x00};
    uint8_t bytes[ESC11_MOVE_NEGATIVE_DISTANCE_REQUEST_SIZE];
    esc11_move_negative_distance_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = 255u;
    in.speed = 1u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_negative_distance_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_negative_distance_request.distance encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_negative_distance_request.distance bytes");
    expect(esc11_move_negative_distance_request_decode(bytes, length, &out) == ESC11_OK, "move_negative_distance_request.distance decodes");
    expect(out.distance == 255u, "move_negative_distance_request.distance: distance");
    expect(out.speed == 1u, "move_negative_distance_request.distance: speed");
    expect(out.force == 0u, "move_negative_distance_request.distance: force");
    expect(esc11_move_negative_distance_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_negative_distance_request.distance short");
    expect(esc11_move_negative_distance_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_negative_distance_request.distance cut");
}

static void test_40(void)
{
    static const uint8_t wanted[] = {0x01, 0x64, 0x00};
    uint8_t bytes[ESC11_MOVE_NEGATIVE_DISTANCE_REQUEST_SIZE];
    esc11_move_negative_distance_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = 1u;
    in.speed = 100u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_negative_distance_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_negative_distance_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_negative_distance_request.speed bytes");
    expect(esc11_move_negative_distance_request_decode(bytes, length, &out) == ESC11_OK, "move_negative_distance_request.speed decodes");
    expect(out.distance == 1u, "move_negative_distance_request.speed: distance");
    expect(out.speed == 100u, "move_negative_distance_request.speed: speed");
    expect(out.force == 0u, "move_negative_distance_request.speed: force");
    expect(esc11_move_negative_distance_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_negative_distance_request.speed short");
    expect(esc11_move_negative_distance_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_negative_distance_request.speed cut");
}

static void test_41(void)
{
    static const uint8_t wanted[] = {0x01, 0x01, 0x64};
    uint8_t bytes[ESC11_MOVE_NEGATIVE_DISTANCE_REQUEST_SIZE];
    esc11_move_negative_distance_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = 1u;
    in.speed = 1u;
    in.force = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_negative_distance_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_negative_distance_request.force encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_negative_distance_request.force bytes");
    expect(esc11_move_negative_distance_request_decode(bytes, length, &out) == ESC11_OK, "move_negative_distance_request.force decodes");
    expect(out.distance == 1u, "move_negative_distance_request.force: distance");
    expect(out.speed == 1u, "move_negative_distance_request.force: speed");
    expect(out.force == 100u, "move_negative_distance_request.force: force");
    expect(esc11_move_negative_distance_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_negative_distance_request.force short");
    expect(esc11_move_negative_distance_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_negative_distance_request.force cut");
}

static void test_42(void)
{
    static const uint8_t wanted[] = {0x64};
    uint8_t bytes[ESC11_MOVE_OPEN_REQUEST_SIZE];
    esc11_move_open_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.speed = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_open_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_open_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_open_request.speed bytes");
    expect(esc11_move_open_request_decode(bytes, length, &out) == ESC11_OK, "move_open_request.speed decodes");
    expect(out.speed == 100u, "move_open_request.speed: speed");
    expect(esc11_move_open_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_open_request.speed short");
    expect(esc11_move_open_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_open_request.speed cut");
}

static void test_43(void)
{
    static const uint8_t wanted[] = {0x64};
    uint8_t bytes[ESC11_MOVE_CLOSE_REQUEST_SIZE];
    esc11_move_close_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.speed = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_close_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_close_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_close_request.speed bytes");
    expect(esc11_move_close_request_decode(bytes, length, &out) == ESC11_OK, "move_close_request.speed decodes");
    expect(out.speed == 100u, "move_close_request.speed: speed");
    expect(esc11_move_close_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_close_request.speed short");
    expect(esc11_move_close_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_close_request.speed cut");
}

static void test_44(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0xFF, 0x07, 0x00};
    uint8_t bytes[ESC11_MOVE_RELATIVE_REQUEST_SIZE];
    esc11_move_relative_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = 134217727;
    in.speed = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_relative_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_relative_request.distance encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_relative_request.distance bytes");
    expect(esc11_move_relative_request_decode(bytes, length, &out) == ESC11_OK, "move_relative_request.distance decodes");
    expect(out.distance == 134217727, "move_relative_request.distance: distance");
    expect(out.speed == 0u, "move_relative_request.distance: speed");
    expect(esc11_move_relative_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_relative_request.distance short");
    expect(esc11_move_relative_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_relative_request.distance cut");
}

static void test_45(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0x64};
    uint8_t bytes[ESC11_MOVE_RELATIVE_REQUEST_SIZE];
    esc11_move_relative_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = (-134217727);
    in.speed = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_relative_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_relative_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_relative_request.speed bytes");
    expect(esc11_move_relative_request_decode(bytes, length, &out) == ESC11_OK, "move_relative_request.speed decodes");
    expect(out.distance == (-134217727), "move_relative_request.speed: distance");
    expect(out.speed == 100u, "move_relative_request.speed: speed");
    expect(esc11_move_relative_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_relative_request.speed short");
    expect(esc11_move_relative_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_relative_request.speed cut");
}

static void test_46(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0xFF, 0x07, 0x00};
    uint8_t bytes[ESC11_MOVE_ABSOLUTE_REQUEST_SIZE];
    esc11_move_absolute_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = 134217727;
    in.speed = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_absolute_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_absolute_request.position encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_absolute_request.position bytes");
    expect(esc11_move_absolute_request_decode(bytes, length, &out) == ESC11_OK, "move_absolute_request.position decodes");
    expect(out.position == 134217727, "move_absolute_request.position: position");
    expect(out.speed == 0u, "move_absolute_request.position: speed");
    expect(esc11_move_absolute_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_absolute_request.position short");
    expect(esc11_move_absolute_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_absolute_request.position cut");
}

static void test_47(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0x64};
    uint8_t bytes[ESC11_MOVE_ABSOLUTE_REQUEST_SIZE];
    esc11_move_absolute_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-134217727);
    in.speed = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_absolute_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_absolute_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_absolute_request.speed bytes");
    expect(esc11_move_absolute_request_decode(bytes, length, &out) == ESC11_OK, "move_absolute_request.speed decodes");
    expect(out.position == (-134217727), "move_absolute_request.speed: position");
    expect(out.speed == 100u, "move_absolute_request.speed: speed");
    expect(esc11_move_absolute_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_absolute_request.speed short");
    expect(esc11_move_absolute_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_absolute_request.speed cut");
}

static void test_48(void)
{
    static const uint8_t wanted[] = {0x1F, 0x00};
    uint8_t bytes[ESC11_MOVE_TO_POINT_REQUEST_SIZE];
    esc11_move_to_point_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.point_number = 31u;
    in.speed = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_to_point_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_to_point_request.point_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_to_point_request.point_number bytes");
    expect(esc11_move_to_point_request_decode(bytes, length, &out) == ESC11_OK, "move_to_point_request.point_number decodes");
    expect(out.point_number == 31u, "move_to_point_request.point_number: point_number");
    expect(out.speed == 0u, "move_to_point_request.point_number: speed");
    expect(esc11_move_to_point_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_to_point_request.point_number short");
    expect(esc11_move_to_point_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_to_point_request.point_number cut");
}

static void test_49(void)
{
    static const uint8_t wanted[] = {0x01, 0x64};
    uint8_t bytes[ESC11_MOVE_TO_POINT_REQUEST_SIZE];
    esc11_move_to_point_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.point_number = 1u;
    in.speed = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_move_to_point_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "move_to_point_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "move_to_point_request.speed bytes");
    expect(esc11_move_to_point_request_decode(bytes, length, &out) == ESC11_OK, "move_to_point_request.speed decodes");
    expect(out.point_number == 1u, "move_to_point_request.speed: point_number");
    expect(out.speed == 100u, "move_to_point_request.speed: speed");
    expect(esc11_move_to_point_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "move_to_point_request.speed short");
    expect(esc11_move_to_point_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "move_to_point_request.speed cut");
}

static void test_50(void)
{
    static const uint8_t wanted[] = {0x64, 0x00};
    uint8_t bytes[ESC11_GRIP_OPEN_REQUEST_SIZE];
    esc11_grip_open_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.speed = 100u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_open_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_open_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_open_request.speed bytes");
    expect(esc11_grip_open_request_decode(bytes, length, &out) == ESC11_OK, "grip_open_request.speed decodes");
    expect(out.speed == 100u, "grip_open_request.speed: speed");
    expect(out.force == 0u, "grip_open_request.speed: force");
    expect(esc11_grip_open_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_open_request.speed short");
    expect(esc11_grip_open_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_open_request.speed cut");
}

static void test_51(void)
{
    static const uint8_t wanted[] = {0x00, 0x64};
    uint8_t bytes[ESC11_GRIP_OPEN_REQUEST_SIZE];
    esc11_grip_open_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.speed = 0u;
    in.force = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_open_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_open_request.force encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_open_request.force bytes");
    expect(esc11_grip_open_request_decode(bytes, length, &out) == ESC11_OK, "grip_open_request.force decodes");
    expect(out.speed == 0u, "grip_open_request.force: speed");
    expect(out.force == 100u, "grip_open_request.force: force");
    expect(esc11_grip_open_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_open_request.force short");
    expect(esc11_grip_open_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_open_request.force cut");
}

static void test_52(void)
{
    static const uint8_t wanted[] = {0x64, 0x00};
    uint8_t bytes[ESC11_GRIP_CLOSE_REQUEST_SIZE];
    esc11_grip_close_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.speed = 100u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_close_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_close_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_close_request.speed bytes");
    expect(esc11_grip_close_request_decode(bytes, length, &out) == ESC11_OK, "grip_close_request.speed decodes");
    expect(out.speed == 100u, "grip_close_request.speed: speed");
    expect(out.force == 0u, "grip_close_request.speed: force");
    expect(esc11_grip_close_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_close_request.speed short");
    expect(esc11_grip_close_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_close_request.speed cut");
}

static void test_53(void)
{
    static const uint8_t wanted[] = {0x00, 0x64};
    uint8_t bytes[ESC11_GRIP_CLOSE_REQUEST_SIZE];
    esc11_grip_close_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.speed = 0u;
    in.force = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_close_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_close_request.force encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_close_request.force bytes");
    expect(esc11_grip_close_request_decode(bytes, length, &out) == ESC11_OK, "grip_close_request.force decodes");
    expect(out.speed == 0u, "grip_close_request.force: speed");
    expect(out.force == 100u, "grip_close_request.force: force");
    expect(esc11_grip_close_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_close_request.force short");
    expect(esc11_grip_close_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_close_request.force cut");
}

static void test_54(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0xFF, 0x07, 0x00, 0x00};
    uint8_t bytes[ESC11_GRIP_RELATIVE_REQUEST_SIZE];
    esc11_grip_relative_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = 134217727;
    in.speed = 0u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_relative_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_relative_request.distance encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_relative_request.distance bytes");
    expect(esc11_grip_relative_request_decode(bytes, length, &out) == ESC11_OK, "grip_relative_request.distance decodes");
    expect(out.distance == 134217727, "grip_relative_request.distance: distance");
    expect(out.speed == 0u, "grip_relative_request.distance: speed");
    expect(out.force == 0u, "grip_relative_request.distance: force");
    expect(esc11_grip_relative_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_relative_request.distance short");
    expect(esc11_grip_relative_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_relative_request.distance cut");
}

static void test_55(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0x64, 0x00};
    uint8_t bytes[ESC11_GRIP_RELATIVE_REQUEST_SIZE];
    esc11_grip_relative_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = (-134217727);
    in.speed = 100u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_relative_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_relative_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_relative_request.speed bytes");
    expect(esc11_grip_relative_request_decode(bytes, length, &out) == ESC11_OK, "grip_relative_request.speed decodes");
    expect(out.distance == (-134217727), "grip_relative_request.speed: distance");
    expect(out.speed == 100u, "grip_relative_request.speed: speed");
    expect(out.force == 0u, "grip_relative_request.speed: force");
    expect(esc11_grip_relative_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_relative_request.speed short");
    expect(esc11_grip_relative_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_relative_request.speed cut");
}

static void test_56(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0x00, 0x64};
    uint8_t bytes[ESC11_GRIP_RELATIVE_REQUEST_SIZE];
    esc11_grip_relative_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.distance = (-134217727);
    in.speed = 0u;
    in.force = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_relative_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_relative_request.force encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_relative_request.force bytes");
    expect(esc11_grip_relative_request_decode(bytes, length, &out) == ESC11_OK, "grip_relative_request.force decodes");
    expect(out.distance == (-134217727), "grip_relative_request.force: distance");
    expect(out.speed == 0u, "grip_relative_request.force: speed");
    expect(out.force == 100u, "grip_relative_request.force: force");
    expect(esc11_grip_relative_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_relative_request.force short");
    expect(esc11_grip_relative_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_relative_request.force cut");
}

static void test_57(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0xFF, 0x07, 0x00, 0x00};
    uint8_t bytes[ESC11_GRIP_ABSOLUTE_REQUEST_SIZE];
    esc11_grip_absolute_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = 134217727;
    in.speed = 0u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_absolute_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_absolute_request.position encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_absolute_request.position bytes");
    expect(esc11_grip_absolute_request_decode(bytes, length, &out) == ESC11_OK, "grip_absolute_request.position decodes");
    expect(out.position == 134217727, "grip_absolute_request.position: position");
    expect(out.speed == 0u, "grip_absolute_request.position: speed");
    expect(out.force == 0u, "grip_absolute_request.position: force");
    expect(esc11_grip_absolute_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_absolute_request.position short");
    expect(esc11_grip_absolute_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_absolute_request.position cut");
}

static void test_58(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0x64, 0x00};
    uint8_t bytes[ESC11_GRIP_ABSOLUTE_REQUEST_SIZE];
    esc11_grip_absolute_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-134217727);
    in.speed = 100u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_absolute_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_absolute_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_absolute_request.speed bytes");
    expect(esc11_grip_absolute_request_decode(bytes, length, &out) == ESC11_OK, "grip_absolute_request.speed decodes");
    expect(out.position == (-134217727), "grip_absolute_request.speed: position");
    expect(out.speed == 100u, "grip_absolute_request.speed: speed");
    expect(out.force == 0u, "grip_absolute_request.speed: force");
    expect(esc11_grip_absolute_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_absolute_request.speed short");
    expect(esc11_grip_absolute_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_absolute_request.speed cut");
}

static void test_59(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0x00, 0x64};
    uint8_t bytes[ESC11_GRIP_ABSOLUTE_REQUEST_SIZE];
    esc11_grip_absolute_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-134217727);
    in.speed = 0u;
    in.force = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_absolute_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_absolute_request.force encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_absolute_request.force bytes");
    expect(esc11_grip_absolute_request_decode(bytes, length, &out) == ESC11_OK, "grip_absolute_request.force decodes");
    expect(out.position == (-134217727), "grip_absolute_request.force: position");
    expect(out.speed == 0u, "grip_absolute_request.force: speed");
    expect(out.force == 100u, "grip_absolute_request.force: force");
    expect(esc11_grip_absolute_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_absolute_request.force short");
    expect(esc11_grip_absolute_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_absolute_request.force cut");
}

static void test_60(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0xFF, 0x07, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x00};
    uint8_t bytes[ESC11_GRIP_OPEN_WITH_ZONE_REQUEST_SIZE];
    esc11_grip_open_with_zone_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.zone_limit_1 = 134217727;
    in.zone_limit_2 = (-134217727);
    in.speed = 0u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_open_with_zone_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_open_with_zone_request.zone_limit_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_open_with_zone_request.zone_limit_1 bytes");
    expect(esc11_grip_open_with_zone_request_decode(bytes, length, &out) == ESC11_OK, "grip_open_with_zone_request.zone_limit_1 decodes");
    expect(out.zone_limit_1 == 134217727, "grip_open_with_zone_request.zone_limit_1: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "grip_open_with_zone_request.zone_limit_1: zone_limit_2");
    expect(out.speed == 0u, "grip_open_with_zone_request.zone_limit_1: speed");
    expect(out.force == 0u, "grip_open_with_zone_request.zone_limit_1: force");
    expect(esc11_grip_open_with_zone_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_open_with_zone_request.zone_limit_1 short");
    expect(esc11_grip_open_with_zone_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_open_with_zone_request.zone_limit_1 cut");
}

static void test_61(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0xFF, 0xFF, 0xFF, 0x07, 0x00, 0x00};
    uint8_t bytes[ESC11_GRIP_OPEN_WITH_ZONE_REQUEST_SIZE];
    esc11_grip_open_with_zone_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = 134217727;
    in.speed = 0u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_open_with_zone_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_open_with_zone_request.zone_limit_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_open_with_zone_request.zone_limit_2 bytes");
    expect(esc11_grip_open_with_zone_request_decode(bytes, length, &out) == ESC11_OK, "grip_open_with_zone_request.zone_limit_2 decodes");
    expect(out.zone_limit_1 == (-134217727), "grip_open_with_zone_request.zone_limit_2: zone_limit_1");
    expect(out.zone_limit_2 == 134217727, "grip_open_with_zone_request.zone_limit_2: zone_limit_2");
    expect(out.speed == 0u, "grip_open_with_zone_request.zone_limit_2: speed");
    expect(out.force == 0u, "grip_open_with_zone_request.zone_limit_2: force");
    expect(esc11_grip_open_with_zone_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_open_with_zone_request.zone_limit_2 short");
    expect(esc11_grip_open_with_zone_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_open_with_zone_request.zone_limit_2 cut");
}

static void test_62(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8, 0x64, 0x00};
    uint8_t bytes[ESC11_GRIP_OPEN_WITH_ZONE_REQUEST_SIZE];
    esc11_grip_open_with_zone_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    in.speed = 100u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_open_with_zone_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_open_with_zone_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_open_with_zone_request.speed bytes");
    expect(esc11_grip_open_with_zone_request_decode(bytes, length, &out) == ESC11_OK, "grip_open_with_zone_request.speed decodes");
    expect(out.zone_limit_1 == (-134217727), "grip_open_with_zone_request.speed: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "grip_open_with_zone_request.speed: zone_limit_2");
    expect(out.speed == 100u, "grip_open_with_zone_request.speed: speed");
    expect(out.force == 0u, "grip_open_with_zone_request.speed: force");
    expect(esc11_grip_open_with_zone_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_open_with_zone_request.speed short");
    expect(esc11_grip_open_with_zone_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_open_with_zone_request.speed cut");
}

static void test_63(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x64};
    uint8_t bytes[ESC11_GRIP_OPEN_WITH_ZONE_REQUEST_SIZE];
    esc11_grip_open_with_zone_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    in.speed = 0u;
    in.force = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_open_with_zone_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_open_with_zone_request.force encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_open_with_zone_request.force bytes");
    expect(esc11_grip_open_with_zone_request_decode(bytes, length, &out) == ESC11_OK, "grip_open_with_zone_request.force decodes");
    expect(out.zone_limit_1 == (-134217727), "grip_open_with_zone_request.force: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "grip_open_with_zone_request.force: zone_limit_2");
    expect(out.speed == 0u, "grip_open_with_zone_request.force: speed");
    expect(out.force == 100u, "grip_open_with_zone_request.force: force");
    expect(esc11_grip_open_with_zone_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_open_with_zone_request.force short");
    expect(esc11_grip_open_with_zone_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_open_with_zone_request.force cut");
}

static void test_64(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0xFF, 0x07, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x00};
    uint8_t bytes[ESC11_GRIP_CLOSE_WITH_ZONE_REQUEST_SIZE];
    esc11_grip_close_with_zone_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.zone_limit_1 = 134217727;
    in.zone_limit_2 = (-134217727);
    in.speed = 0u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_close_with_zone_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_close_with_zone_request.zone_limit_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_close_with_zone_request.zone_limit_1 bytes");
    expect(esc11_grip_close_with_zone_request_decode(bytes, length, &out) == ESC11_OK, "grip_close_with_zone_request.zone_limit_1 decodes");
    expect(out.zone_limit_1 == 134217727, "grip_close_with_zone_request.zone_limit_1: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "grip_close_with_zone_request.zone_limit_1: zone_limit_2");
    expect(out.speed == 0u, "grip_close_with_zone_request.zone_limit_1: speed");
    expect(out.force == 0u, "grip_close_with_zone_request.zone_limit_1: force");
    expect(esc11_grip_close_with_zone_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_close_with_zone_request.zone_limit_1 short");
    expect(esc11_grip_close_with_zone_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_close_with_zone_request.zone_limit_1 cut");
}

static void test_65(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0xFF, 0xFF, 0xFF, 0x07, 0x00, 0x00};
    uint8_t bytes[ESC11_GRIP_CLOSE_WITH_ZONE_REQUEST_SIZE];
    esc11_grip_close_with_zone_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = 134217727;
    in.speed = 0u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_close_with_zone_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_close_with_zone_request.zone_limit_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_close_with_zone_request.zone_limit_2 bytes");
    expect(esc11_grip_close_with_zone_request_decode(bytes, length, &out) == ESC11_OK, "grip_close_with_zone_request.zone_limit_2 decodes");
    expect(out.zone_limit_1 == (-134217727), "grip_close_with_zone_request.zone_limit_2: zone_limit_1");
    expect(out.zone_limit_2 == 134217727, "grip_close_with_zone_request.zone_limit_2: zone_limit_2");
    expect(out.speed == 0u, "grip_close_with_zone_request.zone_limit_2: speed");
    expect(out.force == 0u, "grip_close_with_zone_request.zone_limit_2: force");
    expect(esc11_grip_close_with_zone_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_close_with_zone_request.zone_limit_2 short");
    expect(esc11_grip_close_with_zone_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_close_with_zone_request.zone_limit_2 cut");
}

static void test_66(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8, 0x64, 0x00};
    uint8_t bytes[ESC11_GRIP_CLOSE_WITH_ZONE_REQUEST_SIZE];
    esc11_grip_close_with_zone_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    in.speed = 100u;
    in.force = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_close_with_zone_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_close_with_zone_request.speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_close_with_zone_request.speed bytes");
    expect(esc11_grip_close_with_zone_request_decode(bytes, length, &out) == ESC11_OK, "grip_close_with_zone_request.speed decodes");
    expect(out.zone_limit_1 == (-134217727), "grip_close_with_zone_request.speed: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "grip_close_with_zone_request.speed: zone_limit_2");
    expect(out.speed == 100u, "grip_close_with_zone_request.speed: speed");
    expect(out.force == 0u, "grip_close_with_zone_request.speed: force");
    expect(esc11_grip_close_with_zone_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_close_with_zone_request.speed short");
    expect(esc11_grip_close_with_zone_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_close_with_zone_request.speed cut");
}

static void test_67(void)
{
    static const uint8_t wanted[] = {0x01, 0x00, 0x00, 0xF8, 0x01, 0x00, 0x00, 0xF8, 0x00, 0x64};
    uint8_t bytes[ESC11_GRIP_CLOSE_WITH_ZONE_REQUEST_SIZE];
    esc11_grip_close_with_zone_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.zone_limit_1 = (-134217727);
    in.zone_limit_2 = (-134217727);
    in.speed = 0u;
    in.force = 100u;
    copy(&in, &in, sizeof in);
    expect(esc11_grip_close_with_zone_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "grip_close_with_zone_request.force encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "grip_close_with_zone_request.force bytes");
    expect(esc11_grip_close_with_zone_request_decode(bytes, length, &out) == ESC11_OK, "grip_close_with_zone_request.force decodes");
    expect(out.zone_limit_1 == (-134217727), "grip_close_with_zone_request.force: zone_limit_1");
    expect(out.zone_limit_2 == (-134217727), "grip_close_with_zone_request.force: zone_limit_2");
    expect(out.speed == 0u, "grip_close_with_zone_request.force: speed");
    expect(out.force == 100u, "grip_close_with_zone_request.force: force");
    expect(esc11_grip_close_with_zone_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "grip_close_with_zone_request.force short");
    expect(esc11_grip_close_with_zone_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "grip_close_with_zone_request.force cut");
}

static void test_68(void)
{
    static const uint8_t wanted[] = {0x01};
    uint8_t bytes[ESC11_SET_MOTOR_EXCITATION_REQUEST_SIZE];
    esc11_set_motor_excitation_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.excited = true;
    copy(&in, &in, sizeof in);
    expect(esc11_set_motor_excitation_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "set_motor_excitation_request.excited encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "set_motor_excitation_request.excited bytes");
    expect(esc11_set_motor_excitation_request_decode(bytes, length, &out) == ESC11_OK, "set_motor_excitation_request.excited decodes");
    expect(out.excited == true, "set_motor_excitation_request.excited: excited");
    expect(esc11_set_motor_excitation_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "set_motor_excitation_request.excited short");
    expect(esc11_set_motor_excitation_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "set_motor_excitation_request.excited cut");
}

static void test_69(void)
{
    static const uint8_t wanted[] = {0x41, 0x42, 0x43, 0x44, 0x45, 0x46};
    uint8_t bytes[ESC11_READ_VERSION_RESPONSE_SIZE];
    esc11_read_version_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(in.version, "\101\102\103\104\105\106", 6u);
    copy(&in, &in, sizeof in);
    expect(esc11_read_version_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_version_response.version encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_version_response.version bytes");
    expect(esc11_read_version_response_decode(bytes, length, &out) == ESC11_OK, "read_version_response.version decodes");
    expect(same_bytes(out.version, "\101\102\103\104\105\106", 6u), "read_version_response.version: version");
    expect(esc11_read_version_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_version_response.version short");
    expect(esc11_read_version_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_version_response.version cut");
}

static void test_70(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0xFF, 0x07};
    uint8_t bytes[ESC11_READ_CURRENT_POSITION_RESPONSE_SIZE];
    esc11_read_current_position_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = 134217727;
    copy(&in, &in, sizeof in);
    expect(esc11_read_current_position_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_current_position_response.position encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_current_position_response.position bytes");
    expect(esc11_read_current_position_response_decode(bytes, length, &out) == ESC11_OK, "read_current_position_response.position decodes");
    expect(out.position == 134217727, "read_current_position_response.position: position");
    expect(esc11_read_current_position_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_current_position_response.position short");
    expect(esc11_read_current_position_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_current_position_response.position cut");
}

static void test_71(void)
{
    static const uint8_t wanted[] = {0x1F};
    uint8_t bytes[ESC11_READ_CURRENT_POINT_NUMBER_RESPONSE_SIZE];
    esc11_read_current_point_number_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.point_number = 31u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_current_point_number_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_current_point_number_response.point_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_current_point_number_response.point_number bytes");
    expect(esc11_read_current_point_number_response_decode(bytes, length, &out) == ESC11_OK, "read_current_point_number_response.point_number decodes");
    expect(out.point_number == 31u, "read_current_point_number_response.point_number: point_number");
    expect(esc11_read_current_point_number_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_current_point_number_response.point_number short");
    expect(esc11_read_current_point_number_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_current_point_number_response.point_number cut");
}

static void test_72(void)
{
    static const uint8_t wanted[] = {0x1F};
    uint8_t bytes[ESC11_READ_PARAMETER_REQUEST_SIZE];
    esc11_read_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.parameter_number = 31u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_parameter_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_parameter_request.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_request.parameter_number bytes");
    expect(esc11_read_parameter_request_decode(bytes, length, &out) == ESC11_OK, "read_parameter_request.parameter_number decodes");
    expect(out.parameter_number == 31u, "read_parameter_request.parameter_number: parameter_number");
    expect(esc11_read_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_parameter_request.parameter_number short");
    expect(esc11_read_parameter_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_parameter_request.parameter_number cut");
}

static void test_73(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF};
    uint8_t bytes[ESC11_READ_PARAMETER_RESPONSE_SIZE];
    esc11_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.value = 65535u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_parameter_response.value encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.value bytes");
    expect(esc11_read_parameter_response_decode(bytes, length, &out) == ESC11_OK, "read_parameter_response.value decodes");
    expect(out.value == 65535u, "read_parameter_response.value: value");
    expect(esc11_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_parameter_response.value short");
    expect(esc11_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_parameter_response.value cut");
}

static void test_74(void)
{
    static const uint8_t wanted[] = {0x1F};
    uint8_t bytes[ESC11_READ_POINT_REQUEST_SIZE];
    esc11_read_point_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.point_number = 31u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_point_request_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_point_request.point_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_point_request.point_number bytes");
    expect(esc11_read_point_request_decode(bytes, length, &out) == ESC11_OK, "read_point_request.point_number decodes");
    expect(out.point_number == 31u, "read_point_request.point_number: point_number");
    expect(esc11_read_point_request_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_point_request.point_number short");
    expect(esc11_read_point_request_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_point_request.point_number cut");
}

static void test_75(void)
{
    static const uint8_t wanted[] = {0x1F, 0x4F, 0xFF, 0xFF, 0xFF, 0x07, 0x64, 0x64, 0xFF, 0xFF, 0xFF, 0x07, 0xFF, 0xFF, 0xFF, 0x07};
    uint8_t bytes[ESC11_READ_POINT_RESPONSE_SIZE];
    esc11_read_point_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.point.number = 31u;
    in.point.mode = 79u;
    in.point.distance = 134217727;
    in.point.speed = 100u;
    in.point.force = 100u;
    in.point.zone_limit_1 = 134217727;
    in.point.zone_limit_2 = 134217727;
    copy(&in, &in, sizeof in);
    expect(esc11_read_point_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_point_response.point encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_point_response.point bytes");
    expect(esc11_read_point_response_decode(bytes, length, &out) == ESC11_OK, "read_point_response.point decodes");
    expect(out.point.number == 31u, "read_point_response.point: number");
    expect(out.point.mode == 79u, "read_point_response.point: mode");
    expect(out.point.distance == 134217727, "read_point_response.point: distance");
    expect(out.point.speed == 100u, "read_point_response.point: speed");
    expect(out.point.force == 100u, "read_point_response.point: force");
    expect(out.point.zone_limit_1 == 134217727, "read_point_response.point: zone_limit_1");
    expect(out.point.zone_limit_2 == 134217727, "read_point_response.point: zone_limit_2");
    expect(esc11_read_point_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_point_response.point short");
    expect(esc11_read_point_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_point_response.point cut");
}

static void test_76(void)
{
    static const uint8_t wanted[] = {0x01};
    uint8_t bytes[ESC11_READ_HOMING_STATE_RESPONSE_SIZE];
    esc11_read_homing_state_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.homing_complete = true;
    copy(&in, &in, sizeof in);
    expect(esc11_read_homing_state_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_homing_state_response.homing_complete encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_homing_state_response.homing_complete bytes");
    expect(esc11_read_homing_state_response_decode(bytes, length, &out) == ESC11_OK, "read_homing_state_response.homing_complete decodes");
    expect(out.homing_complete == true, "read_homing_state_response.homing_complete: homing_complete");
    expect(esc11_read_homing_state_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_homing_state_response.homing_complete short");
    expect(esc11_read_homing_state_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_homing_state_response.homing_complete cut");
}

static void test_77(void)
{
    static const uint8_t wanted[] = {0x01};
    uint8_t bytes[ESC11_READ_MOTOR_EXCITATION_RESPONSE_SIZE];
    esc11_read_motor_excitation_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.excited = true;
    copy(&in, &in, sizeof in);
    expect(esc11_read_motor_excitation_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_motor_excitation_response.excited encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_motor_excitation_response.excited bytes");
    expect(esc11_read_motor_excitation_response_decode(bytes, length, &out) == ESC11_OK, "read_motor_excitation_response.excited decodes");
    expect(out.excited == true, "read_motor_excitation_response.excited: excited");
    expect(esc11_read_motor_excitation_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_motor_excitation_response.excited short");
    expect(esc11_read_motor_excitation_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_motor_excitation_response.excited cut");
}

static void test_78(void)
{
    static const uint8_t wanted[] = {0xFF};
    uint8_t bytes[ESC11_READ_ALARM_CODE_RESPONSE_SIZE];
    esc11_read_alarm_code_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.alarm_code = 255u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_alarm_code_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_alarm_code_response.alarm_code encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_alarm_code_response.alarm_code bytes");
    expect(esc11_read_alarm_code_response_decode(bytes, length, &out) == ESC11_OK, "read_alarm_code_response.alarm_code decodes");
    expect(out.alarm_code == 255u, "read_alarm_code_response.alarm_code: alarm_code");
    expect(esc11_read_alarm_code_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_alarm_code_response.alarm_code short");
    expect(esc11_read_alarm_code_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_alarm_code_response.alarm_code cut");
}

static void test_79(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00};
    uint8_t bytes[ESC11_READ_ACCUMULATED_TIME_RESPONSE_SIZE];
    esc11_read_accumulated_time_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.hours = 65535u;
    in.minutes = 0u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_accumulated_time_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_accumulated_time_response.hours encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_accumulated_time_response.hours bytes");
    expect(esc11_read_accumulated_time_response_decode(bytes, length, &out) == ESC11_OK, "read_accumulated_time_response.hours decodes");
    expect(out.hours == 65535u, "read_accumulated_time_response.hours: hours");
    expect(out.minutes == 0u, "read_accumulated_time_response.hours: minutes");
    expect(esc11_read_accumulated_time_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_accumulated_time_response.hours short");
    expect(esc11_read_accumulated_time_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_accumulated_time_response.hours cut");
}

static void test_80(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x3C};
    uint8_t bytes[ESC11_READ_ACCUMULATED_TIME_RESPONSE_SIZE];
    esc11_read_accumulated_time_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.hours = 0u;
    in.minutes = 60u;
    copy(&in, &in, sizeof in);
    expect(esc11_read_accumulated_time_response_encode(&in, bytes, sizeof bytes, &length) == ESC11_OK, "read_accumulated_time_response.minutes encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_accumulated_time_response.minutes bytes");
    expect(esc11_read_accumulated_time_response_decode(bytes, length, &out) == ESC11_OK, "read_accumulated_time_response.minutes decodes");
    expect(out.hours == 0u, "read_accumulated_time_response.minutes: hours");
    expect(out.minutes == 60u, "read_accumulated_time_response.minutes: minutes");
    expect(esc11_read_accumulated_time_response_encode(&in, bytes, sizeof wanted - 1, &length) == ESC11_ERR_CAPACITY, "read_accumulated_time_response.minutes short");
    expect(esc11_read_accumulated_time_response_decode(wanted, sizeof wanted - 1, &out) != ESC11_OK, "read_accumulated_time_response.minutes cut");
}

static void test_81(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(esc11_par_parameters_actuator_type_encode(in, bytes) == ESC11_OK, "parameters.actuator_type 0");
    expect(same_bytes(bytes, "\000\000", 2u), "parameters.actuator_type 0 bytes");
    expect(esc11_par_parameters_actuator_type_decode(bytes, &out) == ESC11_OK, "parameters.actuator_type 0");
    expect(out == 0u, "parameters.actuator_type 0");
    in = 65535u;
    expect(esc11_par_parameters_actuator_type_encode(in, bytes) == ESC11_OK, "parameters.actuator_type 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "parameters.actuator_type 65535 bytes");
    expect(esc11_par_parameters_actuator_type_decode(bytes, &out) == ESC11_OK, "parameters.actuator_type 65535");
    expect(out == 65535u, "parameters.actuator_type 65535");
}

static void test_82(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(esc11_par_parameters_positive_soft_limit_encode(in, bytes) == ESC11_OK, "parameters.positive_soft_limit 0");
    expect(same_bytes(bytes, "\000\000", 2u), "parameters.positive_soft_limit 0 bytes");
    expect(esc11_par_parameters_positive_soft_limit_decode(bytes, &out) == ESC11_OK, "parameters.positive_soft_limit 0");
    expect(out == 0u, "parameters.positive_soft_limit 0");
    in = 9999u;
    expect(esc11_par_parameters_positive_soft_limit_encode(in, bytes) == ESC11_OK, "parameters.positive_soft_limit 9999");
    expect(same_bytes(bytes, "\017\047", 2u), "parameters.positive_soft_limit 9999 bytes");
    expect(esc11_par_parameters_positive_soft_limit_decode(bytes, &out) == ESC11_OK, "parameters.positive_soft_limit 9999");
    expect(out == 9999u, "parameters.positive_soft_limit 9999");
}

static void test_83(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-9999);
    expect(esc11_par_parameters_negative_soft_limit_encode(in, bytes) == ESC11_OK, "parameters.negative_soft_limit -9999");
    expect(same_bytes(bytes, "\361\330", 2u), "parameters.negative_soft_limit -9999 bytes");
    expect(esc11_par_parameters_negative_soft_limit_decode(bytes, &out) == ESC11_OK, "parameters.negative_soft_limit -9999");
    expect(out == (-9999), "parameters.negative_soft_limit -9999");
    in = 0;
    expect(esc11_par_parameters_negative_soft_limit_encode(in, bytes) == ESC11_OK, "parameters.negative_soft_limit 0");
    expect(same_bytes(bytes, "\000\000", 2u), "parameters.negative_soft_limit 0 bytes");
    expect(esc11_par_parameters_negative_soft_limit_decode(bytes, &out) == ESC11_OK, "parameters.negative_soft_limit 0");
    expect(out == 0, "parameters.negative_soft_limit 0");
}

static void test_84(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(esc11_par_parameters_stroke_encode(in, bytes) == ESC11_OK, "parameters.stroke 0");
    expect(same_bytes(bytes, "\000\000", 2u), "parameters.stroke 0 bytes");
    expect(esc11_par_parameters_stroke_decode(bytes, &out) == ESC11_OK, "parameters.stroke 0");
    expect(out == 0u, "parameters.stroke 0");
    in = 9999u;
    expect(esc11_par_parameters_stroke_encode(in, bytes) == ESC11_OK, "parameters.stroke 9999");
    expect(same_bytes(bytes, "\017\047", 2u), "parameters.stroke 9999 bytes");
    expect(esc11_par_parameters_stroke_decode(bytes, &out) == ESC11_OK, "parameters.stroke 9999");
    expect(out == 9999u, "parameters.stroke 9999");
}

static void test_85(void)
{
    uint8_t bytes[2];
    esc11_homing_direction out = ESC11_HOMING_DIRECTION_CLOSE;
    volatile esc11_homing_direction in = ESC11_HOMING_DIRECTION_OPEN;
    in = ESC11_HOMING_DIRECTION_OPEN;
    expect(esc11_par_parameters_homing_direction_encode(in, bytes) == ESC11_OK, "parameters.homing_direction 0");
    expect(same_bytes(bytes, "\000\000", 2u), "parameters.homing_direction 0 bytes");
    expect(esc11_par_parameters_homing_direction_decode(bytes, &out) == ESC11_OK, "parameters.homing_direction 0");
    expect(out == ESC11_HOMING_DIRECTION_OPEN, "parameters.homing_direction 0");
    in = ESC11_HOMING_DIRECTION_CLOSE;
    expect(esc11_par_parameters_homing_direction_encode(in, bytes) == ESC11_OK, "parameters.homing_direction 1");
    expect(same_bytes(bytes, "\001\000", 2u), "parameters.homing_direction 1 bytes");
    expect(esc11_par_parameters_homing_direction_decode(bytes, &out) == ESC11_OK, "parameters.homing_direction 1");
    expect(out == ESC11_HOMING_DIRECTION_CLOSE, "parameters.homing_direction 1");
}

static void test_86(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(esc11_par_parameters_homing_speed_encode(in, bytes) == ESC11_OK, "parameters.homing_speed 1");
    expect(same_bytes(bytes, "\001\000", 2u), "parameters.homing_speed 1 bytes");
    expect(esc11_par_parameters_homing_speed_decode(bytes, &out) == ESC11_OK, "parameters.homing_speed 1");
    expect(out == 1u, "parameters.homing_speed 1");
    in = 50u;
    expect(esc11_par_parameters_homing_speed_encode(in, bytes) == ESC11_OK, "parameters.homing_speed 50");
    expect(same_bytes(bytes, "\062\000", 2u), "parameters.homing_speed 50 bytes");
    expect(esc11_par_parameters_homing_speed_decode(bytes, &out) == ESC11_OK, "parameters.homing_speed 50");
    expect(out == 50u, "parameters.homing_speed 50");
}

static void test_87(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-9999);
    expect(esc11_par_parameters_home_offset_encode(in, bytes) == ESC11_OK, "parameters.home_offset -9999");
    expect(same_bytes(bytes, "\361\330", 2u), "parameters.home_offset -9999 bytes");
    expect(esc11_par_parameters_home_offset_decode(bytes, &out) == ESC11_OK, "parameters.home_offset -9999");
    expect(out == (-9999), "parameters.home_offset -9999");
    in = 9999;
    expect(esc11_par_parameters_home_offset_encode(in, bytes) == ESC11_OK, "parameters.home_offset 9999");
    expect(same_bytes(bytes, "\017\047", 2u), "parameters.home_offset 9999 bytes");
    expect(esc11_par_parameters_home_offset_decode(bytes, &out) == ESC11_OK, "parameters.home_offset 9999");
    expect(out == 9999, "parameters.home_offset 9999");
}

static void test_88(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(esc11_par_parameters_acceleration_encode(in, bytes) == ESC11_OK, "parameters.acceleration 1");
    expect(same_bytes(bytes, "\001\000", 2u), "parameters.acceleration 1 bytes");
    expect(esc11_par_parameters_acceleration_decode(bytes, &out) == ESC11_OK, "parameters.acceleration 1");
    expect(out == 1u, "parameters.acceleration 1");
    in = 100u;
    expect(esc11_par_parameters_acceleration_encode(in, bytes) == ESC11_OK, "parameters.acceleration 100");
    expect(same_bytes(bytes, "\144\000", 2u), "parameters.acceleration 100 bytes");
    expect(esc11_par_parameters_acceleration_decode(bytes, &out) == ESC11_OK, "parameters.acceleration 100");
    expect(out == 100u, "parameters.acceleration 100");
}

static void test_89(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(esc11_par_parameters_maximum_program_speed_encode(in, bytes) == ESC11_OK, "parameters.maximum_program_speed 1");
    expect(same_bytes(bytes, "\001\000", 2u), "parameters.maximum_program_speed 1 bytes");
    expect(esc11_par_parameters_maximum_program_speed_decode(bytes, &out) == ESC11_OK, "parameters.maximum_program_speed 1");
    expect(out == 1u, "parameters.maximum_program_speed 1");
    in = 100u;
    expect(esc11_par_parameters_maximum_program_speed_encode(in, bytes) == ESC11_OK, "parameters.maximum_program_speed 100");
    expect(same_bytes(bytes, "\144\000", 2u), "parameters.maximum_program_speed 100 bytes");
    expect(esc11_par_parameters_maximum_program_speed_decode(bytes, &out) == ESC11_OK, "parameters.maximum_program_speed 100");
    expect(out == 100u, "parameters.maximum_program_speed 100");
}

static void test_90(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(esc11_par_parameters_gripping_speed_encode(in, bytes) == ESC11_OK, "parameters.gripping_speed 1");
    expect(same_bytes(bytes, "\001\000", 2u), "parameters.gripping_speed 1 bytes");
    expect(esc11_par_parameters_gripping_speed_decode(bytes, &out) == ESC11_OK, "parameters.gripping_speed 1");
    expect(out == 1u, "parameters.gripping_speed 1");
    in = 100u;
    expect(esc11_par_parameters_gripping_speed_encode(in, bytes) == ESC11_OK, "parameters.gripping_speed 100");
    expect(same_bytes(bytes, "\144\000", 2u), "parameters.gripping_speed 100 bytes");
    expect(esc11_par_parameters_gripping_speed_decode(bytes, &out) == ESC11_OK, "parameters.gripping_speed 100");
    expect(out == 100u, "parameters.gripping_speed 100");
}

static void test_91(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(esc11_par_parameters_constant_speed_distance_encode(in, bytes) == ESC11_OK, "parameters.constant_speed_distance 1");
    expect(same_bytes(bytes, "\001\000", 2u), "parameters.constant_speed_distance 1 bytes");
    expect(esc11_par_parameters_constant_speed_distance_decode(bytes, &out) == ESC11_OK, "parameters.constant_speed_distance 1");
    expect(out == 1u, "parameters.constant_speed_distance 1");
    in = 9999u;
    expect(esc11_par_parameters_constant_speed_distance_encode(in, bytes) == ESC11_OK, "parameters.constant_speed_distance 9999");
    expect(same_bytes(bytes, "\017\047", 2u), "parameters.constant_speed_distance 9999 bytes");
    expect(esc11_par_parameters_constant_speed_distance_decode(bytes, &out) == ESC11_OK, "parameters.constant_speed_distance 9999");
    expect(out == 9999u, "parameters.constant_speed_distance 9999");
}

static void test_92(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(esc11_par_parameters_limit_width_encode(in, bytes) == ESC11_OK, "parameters.limit_width 1");
    expect(same_bytes(bytes, "\001\000", 2u), "parameters.limit_width 1 bytes");
    expect(esc11_par_parameters_limit_width_decode(bytes, &out) == ESC11_OK, "parameters.limit_width 1");
    expect(out == 1u, "parameters.limit_width 1");
    in = 9999u;
    expect(esc11_par_parameters_limit_width_encode(in, bytes) == ESC11_OK, "parameters.limit_width 9999");
    expect(same_bytes(bytes, "\017\047", 2u), "parameters.limit_width 9999 bytes");
    expect(esc11_par_parameters_limit_width_decode(bytes, &out) == ESC11_OK, "parameters.limit_width 9999");
    expect(out == 9999u, "parameters.limit_width 9999");
}

static void test_93(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(esc11_par_parameters_positioning_complete_pulses_encode(in, bytes) == ESC11_OK, "parameters.positioning_complete_pulses 1");
    expect(same_bytes(bytes, "\001\000", 2u), "parameters.positioning_complete_pulses 1 bytes");
    expect(esc11_par_parameters_positioning_complete_pulses_decode(bytes, &out) == ESC11_OK, "parameters.positioning_complete_pulses 1");
    expect(out == 1u, "parameters.positioning_complete_pulses 1");
    in = 4000u;
    expect(esc11_par_parameters_positioning_complete_pulses_encode(in, bytes) == ESC11_OK, "parameters.positioning_complete_pulses 4000");
    expect(same_bytes(bytes, "\240\017", 2u), "parameters.positioning_complete_pulses 4000 bytes");
    expect(esc11_par_parameters_positioning_complete_pulses_decode(bytes, &out) == ESC11_OK, "parameters.positioning_complete_pulses 4000");
    expect(out == 4000u, "parameters.positioning_complete_pulses 4000");
}

static void test_94(void)
{
    uint8_t bytes[2];
    esc11_homing_method out = ESC11_HOMING_METHOD_STROKE_END_AND_Z_PHASE;
    volatile esc11_homing_method in = ESC11_HOMING_METHOD_STROKE_END;
    in = ESC11_HOMING_METHOD_STROKE_END;
    expect(esc11_par_parameters_homing_method_encode(in, bytes) == ESC11_OK, "parameters.homing_method 0");
    expect(same_bytes(bytes, "\000\000", 2u), "parameters.homing_method 0 bytes");
    expect(esc11_par_parameters_homing_method_decode(bytes, &out) == ESC11_OK, "parameters.homing_method 0");
    expect(out == ESC11_HOMING_METHOD_STROKE_END, "parameters.homing_method 0");
    in = ESC11_HOMING_METHOD_STROKE_END_AND_Z_PHASE;
    expect(esc11_par_parameters_homing_method_encode(in, bytes) == ESC11_OK, "parameters.homing_method 1");
    expect(same_bytes(bytes, "\001\000", 2u), "parameters.homing_method 1 bytes");
    expect(esc11_par_parameters_homing_method_decode(bytes, &out) == ESC11_OK, "parameters.homing_method 1");
    expect(out == ESC11_HOMING_METHOD_STROKE_END_AND_Z_PHASE, "parameters.homing_method 1");
}

static void test_95(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x50, 0x03, 0x58};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_read_points_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-points-request opens");
    expect(opened.unit_address == 0u, "example read-points-request: address");
    expect(opened.code == 80u, "example read-points-request: code");
    expect(esc11_read_points_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-points-request decodes");
    expect(out.first_point == 3u, "example read-points-request: first_point");
    in.first_point = 3u;
    expect(esc11_serial_encode_read_points_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example read-points-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-points-request bytes");
}

static void test_96(void)
{
    static const uint8_t frame[] = {0x14, 0x00, 0x02, 0x03, 0x41, 0x20, 0x03, 0x00, 0x00, 0x64, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xE1};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_points_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-points-response opens");
    expect(opened.unit_address == 0u, "example read-points-response: address");
    expect(opened.status == 2u, "example read-points-response: status");
    expect(esc11_read_points_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-points-response decodes");
    expect(out.points_count == 1u, "example read-points-response: points count");
    expect(out.points[0].number == 3u, "example read-points-response: number");
    expect(out.points[0].mode == 65u, "example read-points-response: mode");
    expect(out.points[0].distance == 800, "example read-points-response: distance");
    expect(out.points[0].speed == 100u, "example read-points-response: speed");
    expect(out.points[0].force == 0u, "example read-points-response: force");
    expect(out.points[0].zone_limit_1 == 0, "example read-points-response: zone_limit_1");
    expect(out.points[0].zone_limit_2 == 0, "example read-points-response: zone_limit_2");
    in.points_count = 1u;
    in.points[0].number = 3u;
    in.points[0].mode = 65u;
    in.points[0].distance = 800;
    in.points[0].speed = 100u;
    in.points[0].force = 0u;
    in.points[0].zone_limit_1 = 0;
    in.points[0].zone_limit_2 = 0;
    expect(esc11_serial_encode_read_points_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-points-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-points-response bytes");
}

static void test_97(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x51, 0x55};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-parameters-request opens");
    expect(opened.unit_address == 0u, "example read-parameters-request: address");
    expect(opened.code == 81u, "example read-parameters-request: code");
    expect(esc11_read_parameters_request_decode(opened.body, opened.body_length) == ESC11_OK, "example read-parameters-request decodes");
    expect(esc11_serial_encode_read_parameters_request(0u, again, sizeof again, &length) == ESC11_OK, "example read-parameters-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-parameters-request bytes");
}

static void test_98(void)
{
    static const uint8_t frame[] = {0x44, 0x00, 0x02, 0x6E, 0x00, 0x64, 0x00, 0x00, 0x00, 0x64, 0x00, 0x00, 0x00, 0x00, 0x00, 0x32, 0x00, 0x00, 0x00, 0x64, 0x00, 0x64, 0x00, 0x32, 0x00, 0x64, 0x00, 0x0A, 0x00, 0xC7, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xDD};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_parameters_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-parameters-response opens");
    expect(opened.unit_address == 0u, "example read-parameters-response: address");
    expect(opened.status == 2u, "example read-parameters-response: status");
    expect(esc11_read_parameters_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-parameters-response decodes");
    expect(out.parameters[0] == 110u, "example read-parameters-response: parameters");
    expect(out.parameters[1] == 100u, "example read-parameters-response: parameters");
    expect(out.parameters[2] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[3] == 100u, "example read-parameters-response: parameters");
    expect(out.parameters[4] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[5] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[6] == 50u, "example read-parameters-response: parameters");
    expect(out.parameters[7] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[8] == 100u, "example read-parameters-response: parameters");
    expect(out.parameters[9] == 100u, "example read-parameters-response: parameters");
    expect(out.parameters[10] == 50u, "example read-parameters-response: parameters");
    expect(out.parameters[11] == 100u, "example read-parameters-response: parameters");
    expect(out.parameters[12] == 10u, "example read-parameters-response: parameters");
    expect(out.parameters[13] == 199u, "example read-parameters-response: parameters");
    expect(out.parameters[14] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[15] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[16] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[17] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[18] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[19] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[20] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[21] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[22] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[23] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[24] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[25] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[26] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[27] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[28] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[29] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[30] == 0u, "example read-parameters-response: parameters");
    expect(out.parameters[31] == 0u, "example read-parameters-response: parameters");
    in.parameters[0] = 110u;
    in.parameters[1] = 100u;
    in.parameters[2] = 0u;
    in.parameters[3] = 100u;
    in.parameters[4] = 0u;
    in.parameters[5] = 0u;
    in.parameters[6] = 50u;
    in.parameters[7] = 0u;
    in.parameters[8] = 100u;
    in.parameters[9] = 100u;
    in.parameters[10] = 50u;
    in.parameters[11] = 100u;
    in.parameters[12] = 10u;
    in.parameters[13] = 199u;
    in.parameters[14] = 0u;
    in.parameters[15] = 0u;
    in.parameters[16] = 0u;
    in.parameters[17] = 0u;
    in.parameters[18] = 0u;
    in.parameters[19] = 0u;
    in.parameters[20] = 0u;
    in.parameters[21] = 0u;
    in.parameters[22] = 0u;
    in.parameters[23] = 0u;
    in.parameters[24] = 0u;
    in.parameters[25] = 0u;
    in.parameters[26] = 0u;
    in.parameters[27] = 0u;
    in.parameters[28] = 0u;
    in.parameters[29] = 0u;
    in.parameters[30] = 0u;
    in.parameters[31] = 0u;
    expect(esc11_serial_encode_read_parameters_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-parameters-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-parameters-response bytes");
}

static void test_99(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x52, 0x56};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-io-status-request opens");
    expect(opened.unit_address == 0u, "example read-io-status-request: address");
    expect(opened.code == 82u, "example read-io-status-request: code");
    expect(esc11_read_io_status_request_decode(opened.body, opened.body_length) == ESC11_OK, "example read-io-status-request decodes");
    expect(esc11_serial_encode_read_io_status_request(0u, again, sizeof again, &length) == ESC11_OK, "example read-io-status-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-io-status-request bytes");
}

static void test_100(void)
{
    static const uint8_t frame[] = {0x07, 0x00, 0x02, 0x00, 0x00, 0x00, 0x09};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_io_status_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-io-status-response opens");
    expect(opened.unit_address == 0u, "example read-io-status-response: address");
    expect(opened.status == 2u, "example read-io-status-response: status");
    expect(esc11_read_io_status_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-io-status-response decodes");
    expect(out.inputs == 0u, "example read-io-status-response: inputs");
    expect(out.outputs == 0u, "example read-io-status-response: outputs");
    expect(out.state_outputs == 0u, "example read-io-status-response: state_outputs");
    in.inputs = 0u;
    in.outputs = 0u;
    in.state_outputs = 0u;
    expect(esc11_serial_encode_read_io_status_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-io-status-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-io-status-response bytes");
}

static void test_101(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x53, 0x57};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-alarm-history-request opens");
    expect(opened.unit_address == 0u, "example read-alarm-history-request: address");
    expect(opened.code == 83u, "example read-alarm-history-request: code");
    expect(esc11_read_alarm_history_request_decode(opened.body, opened.body_length) == ESC11_OK, "example read-alarm-history-request decodes");
    expect(esc11_serial_encode_read_alarm_history_request(0u, again, sizeof again, &length) == ESC11_OK, "example read-alarm-history-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-alarm-history-request bytes");
}

static void test_102(void)
{
    static const uint8_t frame[] = {0x08, 0x00, 0x02, 0x03, 0x00, 0x14, 0x01, 0x22};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_alarm_history_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-alarm-history-response opens");
    expect(opened.unit_address == 0u, "example read-alarm-history-response: address");
    expect(opened.status == 2u, "example read-alarm-history-response: status");
    expect(esc11_read_alarm_history_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-alarm-history-response decodes");
    expect(out.entries_count == 1u, "example read-alarm-history-response: entries count");
    expect(out.entries[0].hours == 3u, "example read-alarm-history-response: hours");
    expect(out.entries[0].minutes == 20u, "example read-alarm-history-response: minutes");
    expect(out.entries[0].alarm_code == 1u, "example read-alarm-history-response: alarm_code");
    in.entries_count = 1u;
    in.entries[0].hours = 3u;
    in.entries[0].minutes = 20u;
    in.entries[0].alarm_code = 1u;
    expect(esc11_serial_encode_read_alarm_history_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-alarm-history-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-alarm-history-response bytes");
}

static void test_103(void)
{
    static const uint8_t frame[] = {0x14, 0x00, 0x60, 0x03, 0x41, 0x20, 0x03, 0x00, 0x00, 0x64, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x3F};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_write_points_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example write-points-request opens");
    expect(opened.unit_address == 0u, "example write-points-request: address");
    expect(opened.code == 96u, "example write-points-request: code");
    expect(esc11_write_points_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example write-points-request decodes");
    expect(out.points_count == 1u, "example write-points-request: points count");
    expect(out.points[0].number == 3u, "example write-points-request: number");
    expect(out.points[0].mode == 65u, "example write-points-request: mode");
    expect(out.points[0].distance == 800, "example write-points-request: distance");
    expect(out.points[0].speed == 100u, "example write-points-request: speed");
    expect(out.points[0].force == 0u, "example write-points-request: force");
    expect(out.points[0].zone_limit_1 == 0, "example write-points-request: zone_limit_1");
    expect(out.points[0].zone_limit_2 == 0, "example write-points-request: zone_limit_2");
    in.points_count = 1u;
    in.points[0].number = 3u;
    in.points[0].mode = 65u;
    in.points[0].distance = 800;
    in.points[0].speed = 100u;
    in.points[0].force = 0u;
    in.points[0].zone_limit_1 = 0;
    in.points[0].zone_limit_2 = 0;
    expect(esc11_serial_encode_write_points_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example write-points-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-points-request bytes");
}

static void test_104(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x02, 0x06};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example write-points-response opens");
    expect(opened.unit_address == 0u, "example write-points-response: address");
    expect(opened.status == 2u, "example write-points-response: status");
    expect(esc11_write_points_response_decode(opened.body, opened.body_length) == ESC11_OK, "example write-points-response decodes");
    expect(esc11_serial_encode_write_points_response(0u, 2u, again, sizeof again, &length) == ESC11_OK, "example write-points-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-points-response bytes");
}

static void test_105(void)
{
    static const uint8_t frame[] = {0x44, 0x00, 0x61, 0x6E, 0x00, 0x64, 0x00, 0x00, 0x00, 0x64, 0x00, 0x00, 0x00, 0x00, 0x00, 0x32, 0x00, 0x00, 0x00, 0x64, 0x00, 0x64, 0x00, 0x32, 0x00, 0x64, 0x00, 0x0A, 0x00, 0x68, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xDD};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_write_parameters_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example write-parameters-request opens");
    expect(opened.unit_address == 0u, "example write-parameters-request: address");
    expect(opened.code == 97u, "example write-parameters-request: code");
    expect(esc11_write_parameters_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example write-parameters-request decodes");
    expect(out.parameters[0] == 110u, "example write-parameters-request: parameters");
    expect(out.parameters[1] == 100u, "example write-parameters-request: parameters");
    expect(out.parameters[2] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[3] == 100u, "example write-parameters-request: parameters");
    expect(out.parameters[4] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[5] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[6] == 50u, "example write-parameters-request: parameters");
    expect(out.parameters[7] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[8] == 100u, "example write-parameters-request: parameters");
    expect(out.parameters[9] == 100u, "example write-parameters-request: parameters");
    expect(out.parameters[10] == 50u, "example write-parameters-request: parameters");
    expect(out.parameters[11] == 100u, "example write-parameters-request: parameters");
    expect(out.parameters[12] == 10u, "example write-parameters-request: parameters");
    expect(out.parameters[13] == 104u, "example write-parameters-request: parameters");
    expect(out.parameters[14] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[15] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[16] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[17] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[18] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[19] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[20] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[21] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[22] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[23] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[24] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[25] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[26] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[27] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[28] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[29] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[30] == 0u, "example write-parameters-request: parameters");
    expect(out.parameters[31] == 0u, "example write-parameters-request: parameters");
    in.parameters[0] = 110u;
    in.parameters[1] = 100u;
    in.parameters[2] = 0u;
    in.parameters[3] = 100u;
    in.parameters[4] = 0u;
    in.parameters[5] = 0u;
    in.parameters[6] = 50u;
    in.parameters[7] = 0u;
    in.parameters[8] = 100u;
    in.parameters[9] = 100u;
    in.parameters[10] = 50u;
    in.parameters[11] = 100u;
    in.parameters[12] = 10u;
    in.parameters[13] = 104u;
    in.parameters[14] = 0u;
    in.parameters[15] = 0u;
    in.parameters[16] = 0u;
    in.parameters[17] = 0u;
    in.parameters[18] = 0u;
    in.parameters[19] = 0u;
    in.parameters[20] = 0u;
    in.parameters[21] = 0u;
    in.parameters[22] = 0u;
    in.parameters[23] = 0u;
    in.parameters[24] = 0u;
    in.parameters[25] = 0u;
    in.parameters[26] = 0u;
    in.parameters[27] = 0u;
    in.parameters[28] = 0u;
    in.parameters[29] = 0u;
    in.parameters[30] = 0u;
    in.parameters[31] = 0u;
    expect(esc11_serial_encode_write_parameters_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example write-parameters-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-parameters-request bytes");
}

static void test_106(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x02, 0x06};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example write-parameters-response opens");
    expect(opened.unit_address == 0u, "example write-parameters-response: address");
    expect(opened.status == 2u, "example write-parameters-response: status");
    expect(esc11_write_parameters_response_decode(opened.body, opened.body_length) == ESC11_OK, "example write-parameters-response decodes");
    expect(esc11_serial_encode_write_parameters_response(0u, 2u, again, sizeof again, &length) == ESC11_OK, "example write-parameters-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-parameters-response bytes");
}

static void test_107(void)
{
    static const uint8_t frame[] = {0x07, 0x00, 0x62, 0x01, 0x64, 0x00, 0xCE};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example write-parameter-request opens");
    expect(opened.unit_address == 0u, "example write-parameter-request: address");
    expect(opened.code == 98u, "example write-parameter-request: code");
    expect(esc11_write_parameter_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example write-parameter-request decodes");
    expect(out.parameter_number == 1u, "example write-parameter-request: parameter_number");
    expect(out.value == 100u, "example write-parameter-request: value");
    in.parameter_number = 1u;
    in.value = 100u;
    expect(esc11_serial_encode_write_parameter_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example write-parameter-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-parameter-request bytes");
}

static void test_108(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x02, 0x06};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example write-parameter-response opens");
    expect(opened.unit_address == 0u, "example write-parameter-response: address");
    expect(opened.status == 2u, "example write-parameter-response: status");
    expect(esc11_write_parameter_response_decode(opened.body, opened.body_length) == ESC11_OK, "example write-parameter-response decodes");
    expect(esc11_serial_encode_write_parameter_response(0u, 2u, again, sizeof again, &length) == ESC11_OK, "example write-parameter-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-parameter-response bytes");
}

static void test_109(void)
{
    static const uint8_t frame[] = {0x14, 0x00, 0x63, 0x00, 0x41, 0x20, 0x03, 0x00, 0x00, 0x64, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x3F};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_write_temporary_point_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example write-temporary-point-request opens");
    expect(opened.unit_address == 0u, "example write-temporary-point-request: address");
    expect(opened.code == 99u, "example write-temporary-point-request: code");
    expect(esc11_write_temporary_point_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example write-temporary-point-request decodes");
    expect(out.point.mode == 65u, "example write-temporary-point-request: mode");
    expect(out.point.distance == 800, "example write-temporary-point-request: distance");
    expect(out.point.speed == 100u, "example write-temporary-point-request: speed");
    expect(out.point.force == 0u, "example write-temporary-point-request: force");
    expect(out.point.zone_limit_1 == 0, "example write-temporary-point-request: zone_limit_1");
    expect(out.point.zone_limit_2 == 0, "example write-temporary-point-request: zone_limit_2");
    in.point.mode = 65u;
    in.point.distance = 800;
    in.point.speed = 100u;
    in.point.force = 0u;
    in.point.zone_limit_1 = 0;
    in.point.zone_limit_2 = 0;
    expect(esc11_serial_encode_write_temporary_point_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example write-temporary-point-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-temporary-point-request bytes");
}

static void test_110(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x00, 0x04};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example write-temporary-point-response opens");
    expect(opened.unit_address == 0u, "example write-temporary-point-response: address");
    expect(opened.status == 0u, "example write-temporary-point-response: status");
    expect(esc11_write_temporary_point_response_decode(opened.body, opened.body_length) == ESC11_OK, "example write-temporary-point-response decodes");
    expect(esc11_serial_encode_write_temporary_point_response(0u, 0u, again, sizeof again, &length) == ESC11_OK, "example write-temporary-point-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-temporary-point-response bytes");
}

static void test_111(void)
{
    static const uint8_t frame[] = {0x06, 0x00, 0x70, 0x05, 0x04, 0x7F};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_clear_points_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example clear-points-request opens");
    expect(opened.unit_address == 0u, "example clear-points-request: address");
    expect(opened.code == 112u, "example clear-points-request: code");
    expect(esc11_clear_points_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example clear-points-request decodes");
    expect(out.first_point == 5u, "example clear-points-request: first_point");
    expect(out.point_count == 4u, "example clear-points-request: point_count");
    in.first_point = 5u;
    in.point_count = 4u;
    expect(esc11_serial_encode_clear_points_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example clear-points-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example clear-points-request bytes");
}

static void test_112(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x02, 0x06};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example clear-points-response opens");
    expect(opened.unit_address == 0u, "example clear-points-response: address");
    expect(opened.status == 2u, "example clear-points-response: status");
    expect(esc11_clear_points_response_decode(opened.body, opened.body_length) == ESC11_OK, "example clear-points-response decodes");
    expect(esc11_serial_encode_clear_points_response(0u, 2u, again, sizeof again, &length) == ESC11_OK, "example clear-points-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example clear-points-response bytes");
}

static void test_113(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x71, 0x75};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example initialize-points-request opens");
    expect(opened.unit_address == 0u, "example initialize-points-request: address");
    expect(opened.code == 113u, "example initialize-points-request: code");
    expect(esc11_initialize_points_request_decode(opened.body, opened.body_length) == ESC11_OK, "example initialize-points-request decodes");
    expect(esc11_serial_encode_initialize_points_request(0u, again, sizeof again, &length) == ESC11_OK, "example initialize-points-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example initialize-points-request bytes");
}

static void test_114(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x02, 0x06};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example initialize-points-response opens");
    expect(opened.unit_address == 0u, "example initialize-points-response: address");
    expect(opened.status == 2u, "example initialize-points-response: status");
    expect(esc11_initialize_points_response_decode(opened.body, opened.body_length) == ESC11_OK, "example initialize-points-response decodes");
    expect(esc11_serial_encode_initialize_points_response(0u, 2u, again, sizeof again, &length) == ESC11_OK, "example initialize-points-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example initialize-points-response bytes");
}

static void test_115(void)
{
    static const uint8_t frame[] = {0x06, 0x00, 0x72, 0x6E, 0x00, 0xE6};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_initialize_parameters_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example initialize-parameters-request opens");
    expect(opened.unit_address == 0u, "example initialize-parameters-request: address");
    expect(opened.code == 114u, "example initialize-parameters-request: code");
    expect(esc11_initialize_parameters_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example initialize-parameters-request decodes");
    expect(out.actuator_type == 110u, "example initialize-parameters-request: actuator_type");
    in.actuator_type = 110u;
    expect(esc11_serial_encode_initialize_parameters_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example initialize-parameters-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example initialize-parameters-request bytes");
}

static void test_116(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x02, 0x06};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example initialize-parameters-response opens");
    expect(opened.unit_address == 0u, "example initialize-parameters-response: address");
    expect(opened.status == 2u, "example initialize-parameters-response: status");
    expect(esc11_initialize_parameters_response_decode(opened.body, opened.body_length) == ESC11_OK, "example initialize-parameters-response decodes");
    expect(esc11_serial_encode_initialize_parameters_response(0u, 2u, again, sizeof again, &length) == ESC11_OK, "example initialize-parameters-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example initialize-parameters-response bytes");
}

static void test_117(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x73, 0x77};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example clear-alarm-history-request opens");
    expect(opened.unit_address == 0u, "example clear-alarm-history-request: address");
    expect(opened.code == 115u, "example clear-alarm-history-request: code");
    expect(esc11_clear_alarm_history_request_decode(opened.body, opened.body_length) == ESC11_OK, "example clear-alarm-history-request decodes");
    expect(esc11_serial_encode_clear_alarm_history_request(0u, again, sizeof again, &length) == ESC11_OK, "example clear-alarm-history-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example clear-alarm-history-request bytes");
}

static void test_118(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x02, 0x06};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example clear-alarm-history-response opens");
    expect(opened.unit_address == 0u, "example clear-alarm-history-response: address");
    expect(opened.status == 2u, "example clear-alarm-history-response: status");
    expect(esc11_clear_alarm_history_response_decode(opened.body, opened.body_length) == ESC11_OK, "example clear-alarm-history-response decodes");
    expect(esc11_serial_encode_clear_alarm_history_response(0u, 2u, again, sizeof again, &length) == ESC11_OK, "example clear-alarm-history-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example clear-alarm-history-response bytes");
}

static void test_119(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x74, 0x78};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example clear-accumulated-time-request opens");
    expect(opened.unit_address == 0u, "example clear-accumulated-time-request: address");
    expect(opened.code == 116u, "example clear-accumulated-time-request: code");
    expect(esc11_clear_accumulated_time_request_decode(opened.body, opened.body_length) == ESC11_OK, "example clear-accumulated-time-request decodes");
    expect(esc11_serial_encode_clear_accumulated_time_request(0u, again, sizeof again, &length) == ESC11_OK, "example clear-accumulated-time-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example clear-accumulated-time-request bytes");
}

static void test_120(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x02, 0x06};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example clear-accumulated-time-response opens");
    expect(opened.unit_address == 0u, "example clear-accumulated-time-response: address");
    expect(opened.status == 2u, "example clear-accumulated-time-response: status");
    expect(esc11_clear_accumulated_time_response_decode(opened.body, opened.body_length) == ESC11_OK, "example clear-accumulated-time-response decodes");
    expect(esc11_serial_encode_clear_accumulated_time_response(0u, 2u, again, sizeof again, &length) == ESC11_OK, "example clear-accumulated-time-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example clear-accumulated-time-response bytes");
}

static void test_121(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x10, 0x14};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example stop-request opens");
    expect(opened.unit_address == 0u, "example stop-request: address");
    expect(opened.code == 16u, "example stop-request: code");
    expect(esc11_stop_request_decode(opened.body, opened.body_length) == ESC11_OK, "example stop-request decodes");
    expect(esc11_serial_encode_stop_request(0u, again, sizeof again, &length) == ESC11_OK, "example stop-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example stop-request bytes");
}

static void test_122(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example stop-response opens");
    expect(opened.unit_address == 0u, "example stop-response: address");
    expect(opened.status == 3u, "example stop-response: status");
    expect(esc11_stop_response_decode(opened.body, opened.body_length) == ESC11_OK, "example stop-response decodes");
    expect(esc11_serial_encode_stop_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example stop-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example stop-response bytes");
}

static void test_123(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x11, 0x15};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example start-homing-request opens");
    expect(opened.unit_address == 0u, "example start-homing-request: address");
    expect(opened.code == 17u, "example start-homing-request: code");
    expect(esc11_start_homing_request_decode(opened.body, opened.body_length) == ESC11_OK, "example start-homing-request decodes");
    expect(esc11_serial_encode_start_homing_request(0u, again, sizeof again, &length) == ESC11_OK, "example start-homing-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example start-homing-request bytes");
}

static void test_124(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example start-homing-response opens");
    expect(opened.unit_address == 0u, "example start-homing-response: address");
    expect(opened.status == 3u, "example start-homing-response: status");
    expect(esc11_start_homing_response_decode(opened.body, opened.body_length) == ESC11_OK, "example start-homing-response decodes");
    expect(esc11_serial_encode_start_homing_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example start-homing-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example start-homing-response bytes");
}

static void test_125(void)
{
    static const uint8_t frame[] = {0x07, 0x00, 0x12, 0x64, 0x32, 0x46, 0xF5};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_move_positive_distance_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example move-positive-distance-request opens");
    expect(opened.unit_address == 0u, "example move-positive-distance-request: address");
    expect(opened.code == 18u, "example move-positive-distance-request: code");
    expect(esc11_move_positive_distance_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example move-positive-distance-request decodes");
    expect(out.distance == 100u, "example move-positive-distance-request: distance");
    expect(out.speed == 50u, "example move-positive-distance-request: speed");
    expect(out.force == 70u, "example move-positive-distance-request: force");
    in.distance = 100u;
    in.speed = 50u;
    in.force = 70u;
    expect(esc11_serial_encode_move_positive_distance_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example move-positive-distance-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-positive-distance-request bytes");
}

static void test_126(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example move-positive-distance-response opens");
    expect(opened.unit_address == 0u, "example move-positive-distance-response: address");
    expect(opened.status == 3u, "example move-positive-distance-response: status");
    expect(esc11_move_positive_distance_response_decode(opened.body, opened.body_length) == ESC11_OK, "example move-positive-distance-response decodes");
    expect(esc11_serial_encode_move_positive_distance_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example move-positive-distance-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-positive-distance-response bytes");
}

static void test_127(void)
{
    static const uint8_t frame[] = {0x07, 0x00, 0x13, 0x64, 0x32, 0x46, 0xF6};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_move_negative_distance_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example move-negative-distance-request opens");
    expect(opened.unit_address == 0u, "example move-negative-distance-request: address");
    expect(opened.code == 19u, "example move-negative-distance-request: code");
    expect(esc11_move_negative_distance_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example move-negative-distance-request decodes");
    expect(out.distance == 100u, "example move-negative-distance-request: distance");
    expect(out.speed == 50u, "example move-negative-distance-request: speed");
    expect(out.force == 70u, "example move-negative-distance-request: force");
    in.distance = 100u;
    in.speed = 50u;
    in.force = 70u;
    expect(esc11_serial_encode_move_negative_distance_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example move-negative-distance-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-negative-distance-request bytes");
}

static void test_128(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example move-negative-distance-response opens");
    expect(opened.unit_address == 0u, "example move-negative-distance-response: address");
    expect(opened.status == 3u, "example move-negative-distance-response: status");
    expect(esc11_move_negative_distance_response_decode(opened.body, opened.body_length) == ESC11_OK, "example move-negative-distance-response decodes");
    expect(esc11_serial_encode_move_negative_distance_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example move-negative-distance-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-negative-distance-response bytes");
}

static void test_129(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x14, 0x32, 0x4B};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_move_open_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example move-open-request opens");
    expect(opened.unit_address == 0u, "example move-open-request: address");
    expect(opened.code == 20u, "example move-open-request: code");
    expect(esc11_move_open_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example move-open-request decodes");
    expect(out.speed == 50u, "example move-open-request: speed");
    in.speed = 50u;
    expect(esc11_serial_encode_move_open_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example move-open-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-open-request bytes");
}

static void test_130(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example move-open-response opens");
    expect(opened.unit_address == 0u, "example move-open-response: address");
    expect(opened.status == 3u, "example move-open-response: status");
    expect(esc11_move_open_response_decode(opened.body, opened.body_length) == ESC11_OK, "example move-open-response decodes");
    expect(esc11_serial_encode_move_open_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example move-open-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-open-response bytes");
}

static void test_131(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x15, 0x32, 0x4C};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_move_close_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example move-close-request opens");
    expect(opened.unit_address == 0u, "example move-close-request: address");
    expect(opened.code == 21u, "example move-close-request: code");
    expect(esc11_move_close_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example move-close-request decodes");
    expect(out.speed == 50u, "example move-close-request: speed");
    in.speed = 50u;
    expect(esc11_serial_encode_move_close_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example move-close-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-close-request bytes");
}

static void test_132(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example move-close-response opens");
    expect(opened.unit_address == 0u, "example move-close-response: address");
    expect(opened.status == 3u, "example move-close-response: status");
    expect(esc11_move_close_response_decode(opened.body, opened.body_length) == ESC11_OK, "example move-close-response decodes");
    expect(esc11_serial_encode_move_close_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example move-close-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-close-response bytes");
}

static void test_133(void)
{
    static const uint8_t frame[] = {0x09, 0x00, 0x16, 0xD0, 0x07, 0x00, 0x00, 0x32, 0x28};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_move_relative_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example move-relative-request opens");
    expect(opened.unit_address == 0u, "example move-relative-request: address");
    expect(opened.code == 22u, "example move-relative-request: code");
    expect(esc11_move_relative_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example move-relative-request decodes");
    expect(out.distance == 2000, "example move-relative-request: distance");
    expect(out.speed == 50u, "example move-relative-request: speed");
    in.distance = 2000;
    in.speed = 50u;
    expect(esc11_serial_encode_move_relative_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example move-relative-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-relative-request bytes");
}

static void test_134(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example move-relative-response opens");
    expect(opened.unit_address == 0u, "example move-relative-response: address");
    expect(opened.status == 3u, "example move-relative-response: status");
    expect(esc11_move_relative_response_decode(opened.body, opened.body_length) == ESC11_OK, "example move-relative-response decodes");
    expect(esc11_serial_encode_move_relative_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example move-relative-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-relative-response bytes");
}

static void test_135(void)
{
    static const uint8_t frame[] = {0x09, 0x00, 0x17, 0xD0, 0x07, 0x00, 0x00, 0x32, 0x29};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_move_absolute_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example move-absolute-request opens");
    expect(opened.unit_address == 0u, "example move-absolute-request: address");
    expect(opened.code == 23u, "example move-absolute-request: code");
    expect(esc11_move_absolute_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example move-absolute-request decodes");
    expect(out.position == 2000, "example move-absolute-request: position");
    expect(out.speed == 50u, "example move-absolute-request: speed");
    in.position = 2000;
    in.speed = 50u;
    expect(esc11_serial_encode_move_absolute_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example move-absolute-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-absolute-request bytes");
}

static void test_136(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example move-absolute-response opens");
    expect(opened.unit_address == 0u, "example move-absolute-response: address");
    expect(opened.status == 3u, "example move-absolute-response: status");
    expect(esc11_move_absolute_response_decode(opened.body, opened.body_length) == ESC11_OK, "example move-absolute-response decodes");
    expect(esc11_serial_encode_move_absolute_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example move-absolute-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-absolute-response bytes");
}

static void test_137(void)
{
    static const uint8_t frame[] = {0x06, 0x00, 0x1A, 0x01, 0x32, 0x53};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_move_to_point_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example move-to-point-request opens");
    expect(opened.unit_address == 0u, "example move-to-point-request: address");
    expect(opened.code == 26u, "example move-to-point-request: code");
    expect(esc11_move_to_point_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example move-to-point-request decodes");
    expect(out.point_number == 1u, "example move-to-point-request: point_number");
    expect(out.speed == 50u, "example move-to-point-request: speed");
    in.point_number = 1u;
    in.speed = 50u;
    expect(esc11_serial_encode_move_to_point_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example move-to-point-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-to-point-request bytes");
}

static void test_138(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example move-to-point-response opens");
    expect(opened.unit_address == 0u, "example move-to-point-response: address");
    expect(opened.status == 3u, "example move-to-point-response: status");
    expect(esc11_move_to_point_response_decode(opened.body, opened.body_length) == ESC11_OK, "example move-to-point-response decodes");
    expect(esc11_serial_encode_move_to_point_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example move-to-point-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example move-to-point-response bytes");
}

static void test_139(void)
{
    static const uint8_t frame[] = {0x06, 0x00, 0x20, 0x32, 0x46, 0x9E};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_grip_open_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example grip-open-request opens");
    expect(opened.unit_address == 0u, "example grip-open-request: address");
    expect(opened.code == 32u, "example grip-open-request: code");
    expect(esc11_grip_open_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example grip-open-request decodes");
    expect(out.speed == 50u, "example grip-open-request: speed");
    expect(out.force == 70u, "example grip-open-request: force");
    in.speed = 50u;
    in.force = 70u;
    expect(esc11_serial_encode_grip_open_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example grip-open-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-open-request bytes");
}

static void test_140(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example grip-open-response opens");
    expect(opened.unit_address == 0u, "example grip-open-response: address");
    expect(opened.status == 3u, "example grip-open-response: status");
    expect(esc11_grip_open_response_decode(opened.body, opened.body_length) == ESC11_OK, "example grip-open-response decodes");
    expect(esc11_serial_encode_grip_open_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example grip-open-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-open-response bytes");
}

static void test_141(void)
{
    static const uint8_t frame[] = {0x06, 0x00, 0x21, 0x32, 0x46, 0x9F};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_grip_close_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example grip-close-request opens");
    expect(opened.unit_address == 0u, "example grip-close-request: address");
    expect(opened.code == 33u, "example grip-close-request: code");
    expect(esc11_grip_close_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example grip-close-request decodes");
    expect(out.speed == 50u, "example grip-close-request: speed");
    expect(out.force == 70u, "example grip-close-request: force");
    in.speed = 50u;
    in.force = 70u;
    expect(esc11_serial_encode_grip_close_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example grip-close-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-close-request bytes");
}

static void test_142(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example grip-close-response opens");
    expect(opened.unit_address == 0u, "example grip-close-response: address");
    expect(opened.status == 3u, "example grip-close-response: status");
    expect(esc11_grip_close_response_decode(opened.body, opened.body_length) == ESC11_OK, "example grip-close-response decodes");
    expect(esc11_serial_encode_grip_close_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example grip-close-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-close-response bytes");
}

static void test_143(void)
{
    static const uint8_t frame[] = {0x0A, 0x00, 0x22, 0xD0, 0x07, 0x00, 0x00, 0x32, 0x46, 0x7B};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_grip_relative_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example grip-relative-request opens");
    expect(opened.unit_address == 0u, "example grip-relative-request: address");
    expect(opened.code == 34u, "example grip-relative-request: code");
    expect(esc11_grip_relative_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example grip-relative-request decodes");
    expect(out.distance == 2000, "example grip-relative-request: distance");
    expect(out.speed == 50u, "example grip-relative-request: speed");
    expect(out.force == 70u, "example grip-relative-request: force");
    in.distance = 2000;
    in.speed = 50u;
    in.force = 70u;
    expect(esc11_serial_encode_grip_relative_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example grip-relative-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-relative-request bytes");
}

static void test_144(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example grip-relative-response opens");
    expect(opened.unit_address == 0u, "example grip-relative-response: address");
    expect(opened.status == 3u, "example grip-relative-response: status");
    expect(esc11_grip_relative_response_decode(opened.body, opened.body_length) == ESC11_OK, "example grip-relative-response decodes");
    expect(esc11_serial_encode_grip_relative_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example grip-relative-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-relative-response bytes");
}

static void test_145(void)
{
    static const uint8_t frame[] = {0x0A, 0x00, 0x23, 0xD0, 0x07, 0x00, 0x00, 0x32, 0x46, 0x7C};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_grip_absolute_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example grip-absolute-request opens");
    expect(opened.unit_address == 0u, "example grip-absolute-request: address");
    expect(opened.code == 35u, "example grip-absolute-request: code");
    expect(esc11_grip_absolute_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example grip-absolute-request decodes");
    expect(out.position == 2000, "example grip-absolute-request: position");
    expect(out.speed == 50u, "example grip-absolute-request: speed");
    expect(out.force == 70u, "example grip-absolute-request: force");
    in.position = 2000;
    in.speed = 50u;
    in.force = 70u;
    expect(esc11_serial_encode_grip_absolute_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example grip-absolute-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-absolute-request bytes");
}

static void test_146(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example grip-absolute-response opens");
    expect(opened.unit_address == 0u, "example grip-absolute-response: address");
    expect(opened.status == 3u, "example grip-absolute-response: status");
    expect(esc11_grip_absolute_response_decode(opened.body, opened.body_length) == ESC11_OK, "example grip-absolute-response decodes");
    expect(esc11_serial_encode_grip_absolute_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example grip-absolute-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-absolute-response bytes");
}

static void test_147(void)
{
    static const uint8_t frame[] = {0x0E, 0x00, 0x24, 0xF4, 0x01, 0x00, 0x00, 0x20, 0x03, 0x00, 0x00, 0x32, 0x46, 0xC2};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_grip_open_with_zone_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example grip-open-with-zone-request opens");
    expect(opened.unit_address == 0u, "example grip-open-with-zone-request: address");
    expect(opened.code == 36u, "example grip-open-with-zone-request: code");
    expect(esc11_grip_open_with_zone_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example grip-open-with-zone-request decodes");
    expect(out.zone_limit_1 == 500, "example grip-open-with-zone-request: zone_limit_1");
    expect(out.zone_limit_2 == 800, "example grip-open-with-zone-request: zone_limit_2");
    expect(out.speed == 50u, "example grip-open-with-zone-request: speed");
    expect(out.force == 70u, "example grip-open-with-zone-request: force");
    in.zone_limit_1 = 500;
    in.zone_limit_2 = 800;
    in.speed = 50u;
    in.force = 70u;
    expect(esc11_serial_encode_grip_open_with_zone_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example grip-open-with-zone-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-open-with-zone-request bytes");
}

static void test_148(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example grip-open-with-zone-response opens");
    expect(opened.unit_address == 0u, "example grip-open-with-zone-response: address");
    expect(opened.status == 3u, "example grip-open-with-zone-response: status");
    expect(esc11_grip_open_with_zone_response_decode(opened.body, opened.body_length) == ESC11_OK, "example grip-open-with-zone-response decodes");
    expect(esc11_serial_encode_grip_open_with_zone_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example grip-open-with-zone-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-open-with-zone-response bytes");
}

static void test_149(void)
{
    static const uint8_t frame[] = {0x0E, 0x00, 0x25, 0xF4, 0x01, 0x00, 0x00, 0x20, 0x03, 0x00, 0x00, 0x32, 0x46, 0xC3};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_grip_close_with_zone_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example grip-close-with-zone-request opens");
    expect(opened.unit_address == 0u, "example grip-close-with-zone-request: address");
    expect(opened.code == 37u, "example grip-close-with-zone-request: code");
    expect(esc11_grip_close_with_zone_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example grip-close-with-zone-request decodes");
    expect(out.zone_limit_1 == 500, "example grip-close-with-zone-request: zone_limit_1");
    expect(out.zone_limit_2 == 800, "example grip-close-with-zone-request: zone_limit_2");
    expect(out.speed == 50u, "example grip-close-with-zone-request: speed");
    expect(out.force == 70u, "example grip-close-with-zone-request: force");
    in.zone_limit_1 = 500;
    in.zone_limit_2 = 800;
    in.speed = 50u;
    in.force = 70u;
    expect(esc11_serial_encode_grip_close_with_zone_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example grip-close-with-zone-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-close-with-zone-request bytes");
}

static void test_150(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x03, 0x07};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example grip-close-with-zone-response opens");
    expect(opened.unit_address == 0u, "example grip-close-with-zone-response: address");
    expect(opened.status == 3u, "example grip-close-with-zone-response: status");
    expect(esc11_grip_close_with_zone_response_decode(opened.body, opened.body_length) == ESC11_OK, "example grip-close-with-zone-response decodes");
    expect(esc11_serial_encode_grip_close_with_zone_response(0u, 3u, again, sizeof again, &length) == ESC11_OK, "example grip-close-with-zone-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example grip-close-with-zone-response bytes");
}

static void test_151(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x30, 0x34};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example no-operation-request opens");
    expect(opened.unit_address == 0u, "example no-operation-request: address");
    expect(opened.code == 48u, "example no-operation-request: code");
    expect(esc11_no_operation_request_decode(opened.body, opened.body_length) == ESC11_OK, "example no-operation-request decodes");
    expect(esc11_serial_encode_no_operation_request(0u, again, sizeof again, &length) == ESC11_OK, "example no-operation-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example no-operation-request bytes");
}

static void test_152(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x00, 0x04};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example no-operation-response opens");
    expect(opened.unit_address == 0u, "example no-operation-response: address");
    expect(opened.status == 0u, "example no-operation-response: status");
    expect(esc11_no_operation_response_decode(opened.body, opened.body_length) == ESC11_OK, "example no-operation-response decodes");
    expect(esc11_serial_encode_no_operation_response(0u, 0u, again, sizeof again, &length) == ESC11_OK, "example no-operation-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example no-operation-response bytes");
}

static void test_153(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x31, 0x01, 0x37};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_set_motor_excitation_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example excite-motor-request opens");
    expect(opened.unit_address == 0u, "example excite-motor-request: address");
    expect(opened.code == 49u, "example excite-motor-request: code");
    expect(esc11_set_motor_excitation_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example excite-motor-request decodes");
    expect(out.excited == true, "example excite-motor-request: excited");
    in.excited = true;
    expect(esc11_serial_encode_set_motor_excitation_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example excite-motor-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example excite-motor-request bytes");
}

static void test_154(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x02, 0x06};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example excite-motor-response opens");
    expect(opened.unit_address == 0u, "example excite-motor-response: address");
    expect(opened.status == 2u, "example excite-motor-response: status");
    expect(esc11_set_motor_excitation_response_decode(opened.body, opened.body_length) == ESC11_OK, "example excite-motor-response decodes");
    expect(esc11_serial_encode_set_motor_excitation_response(0u, 2u, again, sizeof again, &length) == ESC11_OK, "example excite-motor-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example excite-motor-response bytes");
}

static void test_155(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x31, 0x00, 0x36};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_set_motor_excitation_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example release-motor-request opens");
    expect(opened.unit_address == 0u, "example release-motor-request: address");
    expect(opened.code == 49u, "example release-motor-request: code");
    expect(esc11_set_motor_excitation_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example release-motor-request decodes");
    expect(out.excited == false, "example release-motor-request: excited");
    in.excited = false;
    expect(esc11_serial_encode_set_motor_excitation_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example release-motor-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example release-motor-request bytes");
}

static void test_156(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x06, 0x0A};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example release-motor-response opens");
    expect(opened.unit_address == 0u, "example release-motor-response: address");
    expect(opened.status == 6u, "example release-motor-response: status");
    expect(esc11_set_motor_excitation_response_decode(opened.body, opened.body_length) == ESC11_OK, "example release-motor-response decodes");
    expect(esc11_serial_encode_set_motor_excitation_response(0u, 6u, again, sizeof again, &length) == ESC11_OK, "example release-motor-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example release-motor-response bytes");
}

static void test_157(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x40, 0x44};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-version-request opens");
    expect(opened.unit_address == 0u, "example read-version-request: address");
    expect(opened.code == 64u, "example read-version-request: code");
    expect(esc11_read_version_request_decode(opened.body, opened.body_length) == ESC11_OK, "example read-version-request decodes");
    expect(esc11_serial_encode_read_version_request(0u, again, sizeof again, &length) == ESC11_OK, "example read-version-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-version-request bytes");
}

static void test_158(void)
{
    static const uint8_t frame[] = {0x0A, 0x00, 0x02, 0x20, 0x31, 0x2E, 0x30, 0x31, 0x20, 0x0C};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_version_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-version-response opens");
    expect(opened.unit_address == 0u, "example read-version-response: address");
    expect(opened.status == 2u, "example read-version-response: status");
    expect(esc11_read_version_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-version-response decodes");
    expect(same_bytes(out.version, "\040\061\056\060\061\040", 6u), "example read-version-response: version");
    copy(in.version, "\040\061\056\060\061\040", 6u);
    expect(esc11_serial_encode_read_version_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-version-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-version-response bytes");
}

static void test_159(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x41, 0x45};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-current-position-request opens");
    expect(opened.unit_address == 0u, "example read-current-position-request: address");
    expect(opened.code == 65u, "example read-current-position-request: code");
    expect(esc11_read_current_position_request_decode(opened.body, opened.body_length) == ESC11_OK, "example read-current-position-request decodes");
    expect(esc11_serial_encode_read_current_position_request(0u, again, sizeof again, &length) == ESC11_OK, "example read-current-position-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-current-position-request bytes");
}

static void test_160(void)
{
    static const uint8_t frame[] = {0x08, 0x00, 0x02, 0x20, 0x03, 0x00, 0x00, 0x2D};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_current_position_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-current-position-response opens");
    expect(opened.unit_address == 0u, "example read-current-position-response: address");
    expect(opened.status == 2u, "example read-current-position-response: status");
    expect(esc11_read_current_position_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-current-position-response decodes");
    expect(out.position == 800, "example read-current-position-response: position");
    in.position = 800;
    expect(esc11_serial_encode_read_current_position_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-current-position-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-current-position-response bytes");
}

static void test_161(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x42, 0x46};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-current-point-number-request opens");
    expect(opened.unit_address == 0u, "example read-current-point-number-request: address");
    expect(opened.code == 66u, "example read-current-point-number-request: code");
    expect(esc11_read_current_point_number_request_decode(opened.body, opened.body_length) == ESC11_OK, "example read-current-point-number-request decodes");
    expect(esc11_serial_encode_read_current_point_number_request(0u, again, sizeof again, &length) == ESC11_OK, "example read-current-point-number-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-current-point-number-request bytes");
}

static void test_162(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x02, 0x03, 0x0A};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_current_point_number_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-current-point-number-response opens");
    expect(opened.unit_address == 0u, "example read-current-point-number-response: address");
    expect(opened.status == 2u, "example read-current-point-number-response: status");
    expect(esc11_read_current_point_number_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-current-point-number-response decodes");
    expect(out.point_number == 3u, "example read-current-point-number-response: point_number");
    in.point_number = 3u;
    expect(esc11_serial_encode_read_current_point_number_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-current-point-number-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-current-point-number-response bytes");
}

static void test_163(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x43, 0x01, 0x49};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-parameter-request opens");
    expect(opened.unit_address == 0u, "example read-parameter-request: address");
    expect(opened.code == 67u, "example read-parameter-request: code");
    expect(esc11_read_parameter_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-parameter-request decodes");
    expect(out.parameter_number == 1u, "example read-parameter-request: parameter_number");
    in.parameter_number = 1u;
    expect(esc11_serial_encode_read_parameter_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example read-parameter-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-parameter-request bytes");
}

static void test_164(void)
{
    static const uint8_t frame[] = {0x06, 0x00, 0x02, 0x64, 0x00, 0x6C};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-parameter-response opens");
    expect(opened.unit_address == 0u, "example read-parameter-response: address");
    expect(opened.status == 2u, "example read-parameter-response: status");
    expect(esc11_read_parameter_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-parameter-response decodes");
    expect(out.value == 100u, "example read-parameter-response: value");
    in.value = 100u;
    expect(esc11_serial_encode_read_parameter_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-parameter-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-parameter-response bytes");
}

static void test_165(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x44, 0x03, 0x4C};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    esc11_read_point_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-point-request opens");
    expect(opened.unit_address == 0u, "example read-point-request: address");
    expect(opened.code == 68u, "example read-point-request: code");
    expect(esc11_read_point_request_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-point-request decodes");
    expect(out.point_number == 3u, "example read-point-request: point_number");
    in.point_number = 3u;
    expect(esc11_serial_encode_read_point_request(0u, &in, again, sizeof again, &length) == ESC11_OK, "example read-point-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-point-request bytes");
}

static void test_166(void)
{
    static const uint8_t frame[] = {0x14, 0x00, 0x02, 0x03, 0x41, 0x20, 0x03, 0x00, 0x00, 0x64, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xE1};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_point_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-point-response opens");
    expect(opened.unit_address == 0u, "example read-point-response: address");
    expect(opened.status == 2u, "example read-point-response: status");
    expect(esc11_read_point_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-point-response decodes");
    expect(out.point.number == 3u, "example read-point-response: number");
    expect(out.point.mode == 65u, "example read-point-response: mode");
    expect(out.point.distance == 800, "example read-point-response: distance");
    expect(out.point.speed == 100u, "example read-point-response: speed");
    expect(out.point.force == 0u, "example read-point-response: force");
    expect(out.point.zone_limit_1 == 0, "example read-point-response: zone_limit_1");
    expect(out.point.zone_limit_2 == 0, "example read-point-response: zone_limit_2");
    in.point.number = 3u;
    in.point.mode = 65u;
    in.point.distance = 800;
    in.point.speed = 100u;
    in.point.force = 0u;
    in.point.zone_limit_1 = 0;
    in.point.zone_limit_2 = 0;
    expect(esc11_serial_encode_read_point_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-point-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-point-response bytes");
}

static void test_167(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x45, 0x49};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-homing-state-request opens");
    expect(opened.unit_address == 0u, "example read-homing-state-request: address");
    expect(opened.code == 69u, "example read-homing-state-request: code");
    expect(esc11_read_homing_state_request_decode(opened.body, opened.body_length) == ESC11_OK, "example read-homing-state-request decodes");
    expect(esc11_serial_encode_read_homing_state_request(0u, again, sizeof again, &length) == ESC11_OK, "example read-homing-state-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-homing-state-request bytes");
}

static void test_168(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x02, 0x01, 0x08};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_homing_state_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-homing-state-response opens");
    expect(opened.unit_address == 0u, "example read-homing-state-response: address");
    expect(opened.status == 2u, "example read-homing-state-response: status");
    expect(esc11_read_homing_state_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-homing-state-response decodes");
    expect(out.homing_complete == true, "example read-homing-state-response: homing_complete");
    in.homing_complete = true;
    expect(esc11_serial_encode_read_homing_state_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-homing-state-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-homing-state-response bytes");
}

static void test_169(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x46, 0x4A};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-motor-excitation-request opens");
    expect(opened.unit_address == 0u, "example read-motor-excitation-request: address");
    expect(opened.code == 70u, "example read-motor-excitation-request: code");
    expect(esc11_read_motor_excitation_request_decode(opened.body, opened.body_length) == ESC11_OK, "example read-motor-excitation-request decodes");
    expect(esc11_serial_encode_read_motor_excitation_request(0u, again, sizeof again, &length) == ESC11_OK, "example read-motor-excitation-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-motor-excitation-request bytes");
}

static void test_170(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x02, 0x01, 0x08};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_motor_excitation_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-motor-excitation-response opens");
    expect(opened.unit_address == 0u, "example read-motor-excitation-response: address");
    expect(opened.status == 2u, "example read-motor-excitation-response: status");
    expect(esc11_read_motor_excitation_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-motor-excitation-response decodes");
    expect(out.excited == true, "example read-motor-excitation-response: excited");
    in.excited = true;
    expect(esc11_serial_encode_read_motor_excitation_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-motor-excitation-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-motor-excitation-response bytes");
}

static void test_171(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x47, 0x4B};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-alarm-code-request opens");
    expect(opened.unit_address == 0u, "example read-alarm-code-request: address");
    expect(opened.code == 71u, "example read-alarm-code-request: code");
    expect(esc11_read_alarm_code_request_decode(opened.body, opened.body_length) == ESC11_OK, "example read-alarm-code-request decodes");
    expect(esc11_serial_encode_read_alarm_code_request(0u, again, sizeof again, &length) == ESC11_OK, "example read-alarm-code-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-alarm-code-request bytes");
}

static void test_172(void)
{
    static const uint8_t frame[] = {0x05, 0x00, 0x02, 0x01, 0x08};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_alarm_code_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-alarm-code-response opens");
    expect(opened.unit_address == 0u, "example read-alarm-code-response: address");
    expect(opened.status == 2u, "example read-alarm-code-response: status");
    expect(esc11_read_alarm_code_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-alarm-code-response decodes");
    expect(out.alarm_code == 1u, "example read-alarm-code-response: alarm_code");
    in.alarm_code = 1u;
    expect(esc11_serial_encode_read_alarm_code_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-alarm-code-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-alarm-code-response bytes");
}

static void test_173(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x48, 0x4C};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example read-accumulated-time-request opens");
    expect(opened.unit_address == 0u, "example read-accumulated-time-request: address");
    expect(opened.code == 72u, "example read-accumulated-time-request: code");
    expect(esc11_read_accumulated_time_request_decode(opened.body, opened.body_length) == ESC11_OK, "example read-accumulated-time-request decodes");
    expect(esc11_serial_encode_read_accumulated_time_request(0u, again, sizeof again, &length) == ESC11_OK, "example read-accumulated-time-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-accumulated-time-request bytes");
}

static void test_174(void)
{
    static const uint8_t frame[] = {0x07, 0x00, 0x02, 0x01, 0x00, 0x0A, 0x14};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    esc11_read_accumulated_time_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example read-accumulated-time-response opens");
    expect(opened.unit_address == 0u, "example read-accumulated-time-response: address");
    expect(opened.status == 2u, "example read-accumulated-time-response: status");
    expect(esc11_read_accumulated_time_response_decode(opened.body, opened.body_length, &out) == ESC11_OK, "example read-accumulated-time-response decodes");
    expect(out.hours == 1u, "example read-accumulated-time-response: hours");
    expect(out.minutes == 10u, "example read-accumulated-time-response: minutes");
    in.hours = 1u;
    in.minutes = 10u;
    expect(esc11_serial_encode_read_accumulated_time_response(0u, 2u, &in, again, sizeof again, &length) == ESC11_OK, "example read-accumulated-time-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-accumulated-time-response bytes");
}

static void test_175(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x4E, 0x52};
    uint8_t received[sizeof frame];
    esc11_serial_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_request_open(received, sizeof received, &opened) == ESC11_OK, "example reset-alarm-request opens");
    expect(opened.unit_address == 0u, "example reset-alarm-request: address");
    expect(opened.code == 78u, "example reset-alarm-request: code");
    expect(esc11_reset_alarm_request_decode(opened.body, opened.body_length) == ESC11_OK, "example reset-alarm-request decodes");
    expect(esc11_serial_encode_reset_alarm_request(0u, again, sizeof again, &length) == ESC11_OK, "example reset-alarm-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example reset-alarm-request bytes");
}

static void test_176(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x4C, 0x50};
    uint8_t received[sizeof frame];
    esc11_serial_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(esc11_serial_response_open(received, sizeof received, &opened) == ESC11_OK, "example reset-alarm-response opens");
    expect(opened.unit_address == 0u, "example reset-alarm-response: address");
    expect(opened.status == 76u, "example reset-alarm-response: status");
    expect(esc11_reset_alarm_response_decode(opened.body, opened.body_length) == ESC11_OK, "example reset-alarm-response decodes");
    expect(esc11_serial_encode_reset_alarm_response(0u, 76u, again, sizeof again, &length) == ESC11_OK, "example reset-alarm-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example reset-alarm-response bytes");
}

static void test_177(void)
{
    expect(esc11_alarm_history_entry_minutes_is_out_of_range(0u) == false, "esc11_alarm_history_entry_minutes_is_out_of_range 0");
    expect(esc11_alarm_history_entry_minutes_is_out_of_range(1u) == false, "esc11_alarm_history_entry_minutes_is_out_of_range 1");
    expect(esc11_alarm_history_entry_minutes_is_out_of_range(59u) == false, "esc11_alarm_history_entry_minutes_is_out_of_range 59");
    expect(esc11_alarm_history_entry_minutes_is_out_of_range(60u) == false, "esc11_alarm_history_entry_minutes_is_out_of_range 60");
    expect(esc11_alarm_history_entry_minutes_is_out_of_range(61u) == true, "esc11_alarm_history_entry_minutes_is_out_of_range 61");
}

static void test_178(void)
{
    expect(esc11_point_number_is_out_of_range(0u) == true, "esc11_point_number_is_out_of_range 0");
    expect(esc11_point_number_is_out_of_range(1u) == false, "esc11_point_number_is_out_of_range 1");
    expect(esc11_point_number_is_out_of_range(2u) == false, "esc11_point_number_is_out_of_range 2");
    expect(esc11_point_number_is_out_of_range(30u) == false, "esc11_point_number_is_out_of_range 30");
    expect(esc11_point_number_is_out_of_range(31u) == false, "esc11_point_number_is_out_of_range 31");
    expect(esc11_point_number_is_out_of_range(32u) == true, "esc11_point_number_is_out_of_range 32");
}

static void test_179(void)
{
    expect(esc11_point_distance_is_out_of_range((-134217728)) == true, "esc11_point_distance_is_out_of_range -134217728");
    expect(esc11_point_distance_is_out_of_range((-134217727)) == false, "esc11_point_distance_is_out_of_range -134217727");
    expect(esc11_point_distance_is_out_of_range((-134217726)) == false, "esc11_point_distance_is_out_of_range -134217726");
    expect(esc11_point_distance_is_out_of_range(134217726) == false, "esc11_point_distance_is_out_of_range 134217726");
    expect(esc11_point_distance_is_out_of_range(134217727) == false, "esc11_point_distance_is_out_of_range 134217727");
    expect(esc11_point_distance_is_out_of_range(134217728) == true, "esc11_point_distance_is_out_of_range 134217728");
}

static void test_180(void)
{
    expect(esc11_point_speed_is_out_of_range(0u) == false, "esc11_point_speed_is_out_of_range 0");
    expect(esc11_point_speed_is_out_of_range(1u) == false, "esc11_point_speed_is_out_of_range 1");
    expect(esc11_point_speed_is_out_of_range(99u) == false, "esc11_point_speed_is_out_of_range 99");
    expect(esc11_point_speed_is_out_of_range(100u) == false, "esc11_point_speed_is_out_of_range 100");
    expect(esc11_point_speed_is_out_of_range(101u) == true, "esc11_point_speed_is_out_of_range 101");
}

static void test_181(void)
{
    expect(esc11_point_force_is_out_of_range(0u) == false, "esc11_point_force_is_out_of_range 0");
    expect(esc11_point_force_is_out_of_range(1u) == false, "esc11_point_force_is_out_of_range 1");
    expect(esc11_point_force_is_out_of_range(99u) == false, "esc11_point_force_is_out_of_range 99");
    expect(esc11_point_force_is_out_of_range(100u) == false, "esc11_point_force_is_out_of_range 100");
    expect(esc11_point_force_is_out_of_range(101u) == true, "esc11_point_force_is_out_of_range 101");
}

static void test_182(void)
{
    expect(esc11_point_zone_limit_1_is_out_of_range((-134217728)) == true, "esc11_point_zone_limit_1_is_out_of_range -134217728");
    expect(esc11_point_zone_limit_1_is_out_of_range((-134217727)) == false, "esc11_point_zone_limit_1_is_out_of_range -134217727");
    expect(esc11_point_zone_limit_1_is_out_of_range((-134217726)) == false, "esc11_point_zone_limit_1_is_out_of_range -134217726");
    expect(esc11_point_zone_limit_1_is_out_of_range(134217726) == false, "esc11_point_zone_limit_1_is_out_of_range 134217726");
    expect(esc11_point_zone_limit_1_is_out_of_range(134217727) == false, "esc11_point_zone_limit_1_is_out_of_range 134217727");
    expect(esc11_point_zone_limit_1_is_out_of_range(134217728) == true, "esc11_point_zone_limit_1_is_out_of_range 134217728");
}

static void test_183(void)
{
    expect(esc11_point_zone_limit_2_is_out_of_range((-134217728)) == true, "esc11_point_zone_limit_2_is_out_of_range -134217728");
    expect(esc11_point_zone_limit_2_is_out_of_range((-134217727)) == false, "esc11_point_zone_limit_2_is_out_of_range -134217727");
    expect(esc11_point_zone_limit_2_is_out_of_range((-134217726)) == false, "esc11_point_zone_limit_2_is_out_of_range -134217726");
    expect(esc11_point_zone_limit_2_is_out_of_range(134217726) == false, "esc11_point_zone_limit_2_is_out_of_range 134217726");
    expect(esc11_point_zone_limit_2_is_out_of_range(134217727) == false, "esc11_point_zone_limit_2_is_out_of_range 134217727");
    expect(esc11_point_zone_limit_2_is_out_of_range(134217728) == true, "esc11_point_zone_limit_2_is_out_of_range 134217728");
}

static void test_184(void)
{
    expect(esc11_temporary_point_distance_is_out_of_range((-134217728)) == true, "esc11_temporary_point_distance_is_out_of_range -134217728");
    expect(esc11_temporary_point_distance_is_out_of_range((-134217727)) == false, "esc11_temporary_point_distance_is_out_of_range -134217727");
    expect(esc11_temporary_point_distance_is_out_of_range((-134217726)) == false, "esc11_temporary_point_distance_is_out_of_range -134217726");
    expect(esc11_temporary_point_distance_is_out_of_range(134217726) == false, "esc11_temporary_point_distance_is_out_of_range 134217726");
    expect(esc11_temporary_point_distance_is_out_of_range(134217727) == false, "esc11_temporary_point_distance_is_out_of_range 134217727");
    expect(esc11_temporary_point_distance_is_out_of_range(134217728) == true, "esc11_temporary_point_distance_is_out_of_range 134217728");
}

static void test_185(void)
{
    expect(esc11_temporary_point_speed_is_out_of_range(0u) == false, "esc11_temporary_point_speed_is_out_of_range 0");
    expect(esc11_temporary_point_speed_is_out_of_range(1u) == false, "esc11_temporary_point_speed_is_out_of_range 1");
    expect(esc11_temporary_point_speed_is_out_of_range(99u) == false, "esc11_temporary_point_speed_is_out_of_range 99");
    expect(esc11_temporary_point_speed_is_out_of_range(100u) == false, "esc11_temporary_point_speed_is_out_of_range 100");
    expect(esc11_temporary_point_speed_is_out_of_range(101u) == true, "esc11_temporary_point_speed_is_out_of_range 101");
}

static void test_186(void)
{
    expect(esc11_temporary_point_force_is_out_of_range(0u) == false, "esc11_temporary_point_force_is_out_of_range 0");
    expect(esc11_temporary_point_force_is_out_of_range(1u) == false, "esc11_temporary_point_force_is_out_of_range 1");
    expect(esc11_temporary_point_force_is_out_of_range(99u) == false, "esc11_temporary_point_force_is_out_of_range 99");
    expect(esc11_temporary_point_force_is_out_of_range(100u) == false, "esc11_temporary_point_force_is_out_of_range 100");
    expect(esc11_temporary_point_force_is_out_of_range(101u) == true, "esc11_temporary_point_force_is_out_of_range 101");
}

static void test_187(void)
{
    expect(esc11_temporary_point_zone_limit_1_is_out_of_range((-134217728)) == true, "esc11_temporary_point_zone_limit_1_is_out_of_range -134217728");
    expect(esc11_temporary_point_zone_limit_1_is_out_of_range((-134217727)) == false, "esc11_temporary_point_zone_limit_1_is_out_of_range -134217727");
    expect(esc11_temporary_point_zone_limit_1_is_out_of_range((-134217726)) == false, "esc11_temporary_point_zone_limit_1_is_out_of_range -134217726");
    expect(esc11_temporary_point_zone_limit_1_is_out_of_range(134217726) == false, "esc11_temporary_point_zone_limit_1_is_out_of_range 134217726");
    expect(esc11_temporary_point_zone_limit_1_is_out_of_range(134217727) == false, "esc11_temporary_point_zone_limit_1_is_out_of_range 134217727");
    expect(esc11_temporary_point_zone_limit_1_is_out_of_range(134217728) == true, "esc11_temporary_point_zone_limit_1_is_out_of_range 134217728");
}

static void test_188(void)
{
    expect(esc11_temporary_point_zone_limit_2_is_out_of_range((-134217728)) == true, "esc11_temporary_point_zone_limit_2_is_out_of_range -134217728");
    expect(esc11_temporary_point_zone_limit_2_is_out_of_range((-134217727)) == false, "esc11_temporary_point_zone_limit_2_is_out_of_range -134217727");
    expect(esc11_temporary_point_zone_limit_2_is_out_of_range((-134217726)) == false, "esc11_temporary_point_zone_limit_2_is_out_of_range -134217726");
    expect(esc11_temporary_point_zone_limit_2_is_out_of_range(134217726) == false, "esc11_temporary_point_zone_limit_2_is_out_of_range 134217726");
    expect(esc11_temporary_point_zone_limit_2_is_out_of_range(134217727) == false, "esc11_temporary_point_zone_limit_2_is_out_of_range 134217727");
    expect(esc11_temporary_point_zone_limit_2_is_out_of_range(134217728) == true, "esc11_temporary_point_zone_limit_2_is_out_of_range 134217728");
}

static void test_189(void)
{
    expect(esc11_read_points_request_first_point_is_out_of_range(0u) == true, "esc11_read_points_request_first_point_is_out_of_range 0");
    expect(esc11_read_points_request_first_point_is_out_of_range(1u) == false, "esc11_read_points_request_first_point_is_out_of_range 1");
    expect(esc11_read_points_request_first_point_is_out_of_range(2u) == false, "esc11_read_points_request_first_point_is_out_of_range 2");
    expect(esc11_read_points_request_first_point_is_out_of_range(30u) == false, "esc11_read_points_request_first_point_is_out_of_range 30");
    expect(esc11_read_points_request_first_point_is_out_of_range(31u) == false, "esc11_read_points_request_first_point_is_out_of_range 31");
    expect(esc11_read_points_request_first_point_is_out_of_range(32u) == true, "esc11_read_points_request_first_point_is_out_of_range 32");
}

static void test_190(void)
{
    expect(esc11_write_parameter_request_parameter_number_is_out_of_range(0u) == false, "esc11_write_parameter_request_parameter_number_is_out_of_range 0");
    expect(esc11_write_parameter_request_parameter_number_is_out_of_range(1u) == false, "esc11_write_parameter_request_parameter_number_is_out_of_range 1");
    expect(esc11_write_parameter_request_parameter_number_is_out_of_range(30u) == false, "esc11_write_parameter_request_parameter_number_is_out_of_range 30");
    expect(esc11_write_parameter_request_parameter_number_is_out_of_range(31u) == false, "esc11_write_parameter_request_parameter_number_is_out_of_range 31");
    expect(esc11_write_parameter_request_parameter_number_is_out_of_range(32u) == true, "esc11_write_parameter_request_parameter_number_is_out_of_range 32");
}

static void test_191(void)
{
    expect(esc11_clear_points_request_first_point_is_out_of_range(0u) == true, "esc11_clear_points_request_first_point_is_out_of_range 0");
    expect(esc11_clear_points_request_first_point_is_out_of_range(1u) == false, "esc11_clear_points_request_first_point_is_out_of_range 1");
    expect(esc11_clear_points_request_first_point_is_out_of_range(2u) == false, "esc11_clear_points_request_first_point_is_out_of_range 2");
    expect(esc11_clear_points_request_first_point_is_out_of_range(30u) == false, "esc11_clear_points_request_first_point_is_out_of_range 30");
    expect(esc11_clear_points_request_first_point_is_out_of_range(31u) == false, "esc11_clear_points_request_first_point_is_out_of_range 31");
    expect(esc11_clear_points_request_first_point_is_out_of_range(32u) == true, "esc11_clear_points_request_first_point_is_out_of_range 32");
}

static void test_192(void)
{
    expect(esc11_clear_points_request_point_count_is_out_of_range(0u) == true, "esc11_clear_points_request_point_count_is_out_of_range 0");
    expect(esc11_clear_points_request_point_count_is_out_of_range(1u) == false, "esc11_clear_points_request_point_count_is_out_of_range 1");
    expect(esc11_clear_points_request_point_count_is_out_of_range(2u) == false, "esc11_clear_points_request_point_count_is_out_of_range 2");
    expect(esc11_clear_points_request_point_count_is_out_of_range(30u) == false, "esc11_clear_points_request_point_count_is_out_of_range 30");
    expect(esc11_clear_points_request_point_count_is_out_of_range(31u) == false, "esc11_clear_points_request_point_count_is_out_of_range 31");
    expect(esc11_clear_points_request_point_count_is_out_of_range(32u) == true, "esc11_clear_points_request_point_count_is_out_of_range 32");
}

static void test_193(void)
{
    expect(esc11_move_positive_distance_request_distance_is_out_of_range(0u) == true, "esc11_move_positive_distance_request_distance_is_out_of_range 0");
    expect(esc11_move_positive_distance_request_distance_is_out_of_range(1u) == false, "esc11_move_positive_distance_request_distance_is_out_of_range 1");
    expect(esc11_move_positive_distance_request_distance_is_out_of_range(2u) == false, "esc11_move_positive_distance_request_distance_is_out_of_range 2");
    expect(esc11_move_positive_distance_request_distance_is_out_of_range(254u) == false, "esc11_move_positive_distance_request_distance_is_out_of_range 254");
    expect(esc11_move_positive_distance_request_distance_is_out_of_range(255u) == false, "esc11_move_positive_distance_request_distance_is_out_of_range 255");
}

static void test_194(void)
{
    expect(esc11_move_positive_distance_request_speed_is_out_of_range(0u) == true, "esc11_move_positive_distance_request_speed_is_out_of_range 0");
    expect(esc11_move_positive_distance_request_speed_is_out_of_range(1u) == false, "esc11_move_positive_distance_request_speed_is_out_of_range 1");
    expect(esc11_move_positive_distance_request_speed_is_out_of_range(2u) == false, "esc11_move_positive_distance_request_speed_is_out_of_range 2");
    expect(esc11_move_positive_distance_request_speed_is_out_of_range(99u) == false, "esc11_move_positive_distance_request_speed_is_out_of_range 99");
    expect(esc11_move_positive_distance_request_speed_is_out_of_range(100u) == false, "esc11_move_positive_distance_request_speed_is_out_of_range 100");
    expect(esc11_move_positive_distance_request_speed_is_out_of_range(101u) == true, "esc11_move_positive_distance_request_speed_is_out_of_range 101");
}

static void test_195(void)
{
    expect(esc11_move_positive_distance_request_force_is_out_of_range(0u) == false, "esc11_move_positive_distance_request_force_is_out_of_range 0");
    expect(esc11_move_positive_distance_request_force_is_out_of_range(1u) == false, "esc11_move_positive_distance_request_force_is_out_of_range 1");
    expect(esc11_move_positive_distance_request_force_is_out_of_range(99u) == false, "esc11_move_positive_distance_request_force_is_out_of_range 99");
    expect(esc11_move_positive_distance_request_force_is_out_of_range(100u) == false, "esc11_move_positive_distance_request_force_is_out_of_range 100");
    expect(esc11_move_positive_distance_request_force_is_out_of_range(101u) == true, "esc11_move_positive_distance_request_force_is_out_of_range 101");
}

static void test_196(void)
{
    expect(esc11_move_negative_distance_request_distance_is_out_of_range(0u) == true, "esc11_move_negative_distance_request_distance_is_out_of_range 0");
    expect(esc11_move_negative_distance_request_distance_is_out_of_range(1u) == false, "esc11_move_negative_distance_request_distance_is_out_of_range 1");
    expect(esc11_move_negative_distance_request_distance_is_out_of_range(2u) == false, "esc11_move_negative_distance_request_distance_is_out_of_range 2");
    expect(esc11_move_negative_distance_request_distance_is_out_of_range(254u) == false, "esc11_move_negative_distance_request_distance_is_out_of_range 254");
    expect(esc11_move_negative_distance_request_distance_is_out_of_range(255u) == false, "esc11_move_negative_distance_request_distance_is_out_of_range 255");
}

static void test_197(void)
{
    expect(esc11_move_negative_distance_request_speed_is_out_of_range(0u) == true, "esc11_move_negative_distance_request_speed_is_out_of_range 0");
    expect(esc11_move_negative_distance_request_speed_is_out_of_range(1u) == false, "esc11_move_negative_distance_request_speed_is_out_of_range 1");
    expect(esc11_move_negative_distance_request_speed_is_out_of_range(2u) == false, "esc11_move_negative_distance_request_speed_is_out_of_range 2");
    expect(esc11_move_negative_distance_request_speed_is_out_of_range(99u) == false, "esc11_move_negative_distance_request_speed_is_out_of_range 99");
    expect(esc11_move_negative_distance_request_speed_is_out_of_range(100u) == false, "esc11_move_negative_distance_request_speed_is_out_of_range 100");
    expect(esc11_move_negative_distance_request_speed_is_out_of_range(101u) == true, "esc11_move_negative_distance_request_speed_is_out_of_range 101");
}

static void test_198(void)
{
    expect(esc11_move_negative_distance_request_force_is_out_of_range(0u) == false, "esc11_move_negative_distance_request_force_is_out_of_range 0");
    expect(esc11_move_negative_distance_request_force_is_out_of_range(1u) == false, "esc11_move_negative_distance_request_force_is_out_of_range 1");
    expect(esc11_move_negative_distance_request_force_is_out_of_range(99u) == false, "esc11_move_negative_distance_request_force_is_out_of_range 99");
    expect(esc11_move_negative_distance_request_force_is_out_of_range(100u) == false, "esc11_move_negative_distance_request_force_is_out_of_range 100");
    expect(esc11_move_negative_distance_request_force_is_out_of_range(101u) == true, "esc11_move_negative_distance_request_force_is_out_of_range 101");
}

static void test_199(void)
{
    expect(esc11_move_open_request_speed_is_out_of_range(0u) == true, "esc11_move_open_request_speed_is_out_of_range 0");
    expect(esc11_move_open_request_speed_is_out_of_range(1u) == false, "esc11_move_open_request_speed_is_out_of_range 1");
    expect(esc11_move_open_request_speed_is_out_of_range(2u) == false, "esc11_move_open_request_speed_is_out_of_range 2");
    expect(esc11_move_open_request_speed_is_out_of_range(99u) == false, "esc11_move_open_request_speed_is_out_of_range 99");
    expect(esc11_move_open_request_speed_is_out_of_range(100u) == false, "esc11_move_open_request_speed_is_out_of_range 100");
    expect(esc11_move_open_request_speed_is_out_of_range(101u) == true, "esc11_move_open_request_speed_is_out_of_range 101");
}

static void test_200(void)
{
    expect(esc11_move_close_request_speed_is_out_of_range(0u) == true, "esc11_move_close_request_speed_is_out_of_range 0");
    expect(esc11_move_close_request_speed_is_out_of_range(1u) == false, "esc11_move_close_request_speed_is_out_of_range 1");
    expect(esc11_move_close_request_speed_is_out_of_range(2u) == false, "esc11_move_close_request_speed_is_out_of_range 2");
    expect(esc11_move_close_request_speed_is_out_of_range(99u) == false, "esc11_move_close_request_speed_is_out_of_range 99");
    expect(esc11_move_close_request_speed_is_out_of_range(100u) == false, "esc11_move_close_request_speed_is_out_of_range 100");
    expect(esc11_move_close_request_speed_is_out_of_range(101u) == true, "esc11_move_close_request_speed_is_out_of_range 101");
}

static void test_201(void)
{
    expect(esc11_move_relative_request_distance_is_out_of_range((-134217728)) == true, "esc11_move_relative_request_distance_is_out_of_range -134217728");
    expect(esc11_move_relative_request_distance_is_out_of_range((-134217727)) == false, "esc11_move_relative_request_distance_is_out_of_range -134217727");
    expect(esc11_move_relative_request_distance_is_out_of_range((-134217726)) == false, "esc11_move_relative_request_distance_is_out_of_range -134217726");
    expect(esc11_move_relative_request_distance_is_out_of_range(134217726) == false, "esc11_move_relative_request_distance_is_out_of_range 134217726");
    expect(esc11_move_relative_request_distance_is_out_of_range(134217727) == false, "esc11_move_relative_request_distance_is_out_of_range 134217727");
    expect(esc11_move_relative_request_distance_is_out_of_range(134217728) == true, "esc11_move_relative_request_distance_is_out_of_range 134217728");
}

static void test_202(void)
{
    expect(esc11_move_relative_request_speed_is_out_of_range(0u) == false, "esc11_move_relative_request_speed_is_out_of_range 0");
    expect(esc11_move_relative_request_speed_is_out_of_range(1u) == false, "esc11_move_relative_request_speed_is_out_of_range 1");
    expect(esc11_move_relative_request_speed_is_out_of_range(99u) == false, "esc11_move_relative_request_speed_is_out_of_range 99");
    expect(esc11_move_relative_request_speed_is_out_of_range(100u) == false, "esc11_move_relative_request_speed_is_out_of_range 100");
    expect(esc11_move_relative_request_speed_is_out_of_range(101u) == true, "esc11_move_relative_request_speed_is_out_of_range 101");
}

static void test_203(void)
{
    expect(esc11_move_absolute_request_position_is_out_of_range((-134217728)) == true, "esc11_move_absolute_request_position_is_out_of_range -134217728");
    expect(esc11_move_absolute_request_position_is_out_of_range((-134217727)) == false, "esc11_move_absolute_request_position_is_out_of_range -134217727");
    expect(esc11_move_absolute_request_position_is_out_of_range((-134217726)) == false, "esc11_move_absolute_request_position_is_out_of_range -134217726");
    expect(esc11_move_absolute_request_position_is_out_of_range(134217726) == false, "esc11_move_absolute_request_position_is_out_of_range 134217726");
    expect(esc11_move_absolute_request_position_is_out_of_range(134217727) == false, "esc11_move_absolute_request_position_is_out_of_range 134217727");
    expect(esc11_move_absolute_request_position_is_out_of_range(134217728) == true, "esc11_move_absolute_request_position_is_out_of_range 134217728");
}

static void test_204(void)
{
    expect(esc11_move_absolute_request_speed_is_out_of_range(0u) == false, "esc11_move_absolute_request_speed_is_out_of_range 0");
    expect(esc11_move_absolute_request_speed_is_out_of_range(1u) == false, "esc11_move_absolute_request_speed_is_out_of_range 1");
    expect(esc11_move_absolute_request_speed_is_out_of_range(99u) == false, "esc11_move_absolute_request_speed_is_out_of_range 99");
    expect(esc11_move_absolute_request_speed_is_out_of_range(100u) == false, "esc11_move_absolute_request_speed_is_out_of_range 100");
    expect(esc11_move_absolute_request_speed_is_out_of_range(101u) == true, "esc11_move_absolute_request_speed_is_out_of_range 101");
}

static void test_205(void)
{
    expect(esc11_move_to_point_request_point_number_is_out_of_range(0u) == true, "esc11_move_to_point_request_point_number_is_out_of_range 0");
    expect(esc11_move_to_point_request_point_number_is_out_of_range(1u) == false, "esc11_move_to_point_request_point_number_is_out_of_range 1");
    expect(esc11_move_to_point_request_point_number_is_out_of_range(2u) == false, "esc11_move_to_point_request_point_number_is_out_of_range 2");
    expect(esc11_move_to_point_request_point_number_is_out_of_range(30u) == false, "esc11_move_to_point_request_point_number_is_out_of_range 30");
    expect(esc11_move_to_point_request_point_number_is_out_of_range(31u) == false, "esc11_move_to_point_request_point_number_is_out_of_range 31");
    expect(esc11_move_to_point_request_point_number_is_out_of_range(32u) == true, "esc11_move_to_point_request_point_number_is_out_of_range 32");
}

static void test_206(void)
{
    expect(esc11_move_to_point_request_speed_is_out_of_range(0u) == false, "esc11_move_to_point_request_speed_is_out_of_range 0");
    expect(esc11_move_to_point_request_speed_is_out_of_range(1u) == false, "esc11_move_to_point_request_speed_is_out_of_range 1");
    expect(esc11_move_to_point_request_speed_is_out_of_range(99u) == false, "esc11_move_to_point_request_speed_is_out_of_range 99");
    expect(esc11_move_to_point_request_speed_is_out_of_range(100u) == false, "esc11_move_to_point_request_speed_is_out_of_range 100");
    expect(esc11_move_to_point_request_speed_is_out_of_range(101u) == true, "esc11_move_to_point_request_speed_is_out_of_range 101");
}

static void test_207(void)
{
    expect(esc11_grip_open_request_speed_is_out_of_range(0u) == false, "esc11_grip_open_request_speed_is_out_of_range 0");
    expect(esc11_grip_open_request_speed_is_out_of_range(1u) == false, "esc11_grip_open_request_speed_is_out_of_range 1");
    expect(esc11_grip_open_request_speed_is_out_of_range(99u) == false, "esc11_grip_open_request_speed_is_out_of_range 99");
    expect(esc11_grip_open_request_speed_is_out_of_range(100u) == false, "esc11_grip_open_request_speed_is_out_of_range 100");
    expect(esc11_grip_open_request_speed_is_out_of_range(101u) == true, "esc11_grip_open_request_speed_is_out_of_range 101");
}

static void test_208(void)
{
    expect(esc11_grip_open_request_force_is_out_of_range(0u) == false, "esc11_grip_open_request_force_is_out_of_range 0");
    expect(esc11_grip_open_request_force_is_out_of_range(1u) == false, "esc11_grip_open_request_force_is_out_of_range 1");
    expect(esc11_grip_open_request_force_is_out_of_range(99u) == false, "esc11_grip_open_request_force_is_out_of_range 99");
    expect(esc11_grip_open_request_force_is_out_of_range(100u) == false, "esc11_grip_open_request_force_is_out_of_range 100");
    expect(esc11_grip_open_request_force_is_out_of_range(101u) == true, "esc11_grip_open_request_force_is_out_of_range 101");
}

static void test_209(void)
{
    expect(esc11_grip_close_request_speed_is_out_of_range(0u) == false, "esc11_grip_close_request_speed_is_out_of_range 0");
    expect(esc11_grip_close_request_speed_is_out_of_range(1u) == false, "esc11_grip_close_request_speed_is_out_of_range 1");
    expect(esc11_grip_close_request_speed_is_out_of_range(99u) == false, "esc11_grip_close_request_speed_is_out_of_range 99");
    expect(esc11_grip_close_request_speed_is_out_of_range(100u) == false, "esc11_grip_close_request_speed_is_out_of_range 100");
    expect(esc11_grip_close_request_speed_is_out_of_range(101u) == true, "esc11_grip_close_request_speed_is_out_of_range 101");
}

static void test_210(void)
{
    expect(esc11_grip_close_request_force_is_out_of_range(0u) == false, "esc11_grip_close_request_force_is_out_of_range 0");
    expect(esc11_grip_close_request_force_is_out_of_range(1u) == false, "esc11_grip_close_request_force_is_out_of_range 1");
    expect(esc11_grip_close_request_force_is_out_of_range(99u) == false, "esc11_grip_close_request_force_is_out_of_range 99");
    expect(esc11_grip_close_request_force_is_out_of_range(100u) == false, "esc11_grip_close_request_force_is_out_of_range 100");
    expect(esc11_grip_close_request_force_is_out_of_range(101u) == true, "esc11_grip_close_request_force_is_out_of_range 101");
}

static void test_211(void)
{
    expect(esc11_grip_relative_request_distance_is_out_of_range((-134217728)) == true, "esc11_grip_relative_request_distance_is_out_of_range -134217728");
    expect(esc11_grip_relative_request_distance_is_out_of_range((-134217727)) == false, "esc11_grip_relative_request_distance_is_out_of_range -134217727");
    expect(esc11_grip_relative_request_distance_is_out_of_range((-134217726)) == false, "esc11_grip_relative_request_distance_is_out_of_range -134217726");
    expect(esc11_grip_relative_request_distance_is_out_of_range(134217726) == false, "esc11_grip_relative_request_distance_is_out_of_range 134217726");
    expect(esc11_grip_relative_request_distance_is_out_of_range(134217727) == false, "esc11_grip_relative_request_distance_is_out_of_range 134217727");
    expect(esc11_grip_relative_request_distance_is_out_of_range(134217728) == true, "esc11_grip_relative_request_distance_is_out_of_range 134217728");
}

static void test_212(void)
{
    expect(esc11_grip_relative_request_speed_is_out_of_range(0u) == false, "esc11_grip_relative_request_speed_is_out_of_range 0");
    expect(esc11_grip_relative_request_speed_is_out_of_range(1u) == false, "esc11_grip_relative_request_speed_is_out_of_range 1");
    expect(esc11_grip_relative_request_speed_is_out_of_range(99u) == false, "esc11_grip_relative_request_speed_is_out_of_range 99");
    expect(esc11_grip_relative_request_speed_is_out_of_range(100u) == false, "esc11_grip_relative_request_speed_is_out_of_range 100");
    expect(esc11_grip_relative_request_speed_is_out_of_range(101u) == true, "esc11_grip_relative_request_speed_is_out_of_range 101");
}

static void test_213(void)
{
    expect(esc11_grip_relative_request_force_is_out_of_range(0u) == false, "esc11_grip_relative_request_force_is_out_of_range 0");
    expect(esc11_grip_relative_request_force_is_out_of_range(1u) == false, "esc11_grip_relative_request_force_is_out_of_range 1");
    expect(esc11_grip_relative_request_force_is_out_of_range(99u) == false, "esc11_grip_relative_request_force_is_out_of_range 99");
    expect(esc11_grip_relative_request_force_is_out_of_range(100u) == false, "esc11_grip_relative_request_force_is_out_of_range 100");
    expect(esc11_grip_relative_request_force_is_out_of_range(101u) == true, "esc11_grip_relative_request_force_is_out_of_range 101");
}

static void test_214(void)
{
    expect(esc11_grip_absolute_request_position_is_out_of_range((-134217728)) == true, "esc11_grip_absolute_request_position_is_out_of_range -134217728");
    expect(esc11_grip_absolute_request_position_is_out_of_range((-134217727)) == false, "esc11_grip_absolute_request_position_is_out_of_range -134217727");
    expect(esc11_grip_absolute_request_position_is_out_of_range((-134217726)) == false, "esc11_grip_absolute_request_position_is_out_of_range -134217726");
    expect(esc11_grip_absolute_request_position_is_out_of_range(134217726) == false, "esc11_grip_absolute_request_position_is_out_of_range 134217726");
    expect(esc11_grip_absolute_request_position_is_out_of_range(134217727) == false, "esc11_grip_absolute_request_position_is_out_of_range 134217727");
    expect(esc11_grip_absolute_request_position_is_out_of_range(134217728) == true, "esc11_grip_absolute_request_position_is_out_of_range 134217728");
}

static void test_215(void)
{
    expect(esc11_grip_absolute_request_speed_is_out_of_range(0u) == false, "esc11_grip_absolute_request_speed_is_out_of_range 0");
    expect(esc11_grip_absolute_request_speed_is_out_of_range(1u) == false, "esc11_grip_absolute_request_speed_is_out_of_range 1");
    expect(esc11_grip_absolute_request_speed_is_out_of_range(99u) == false, "esc11_grip_absolute_request_speed_is_out_of_range 99");
    expect(esc11_grip_absolute_request_speed_is_out_of_range(100u) == false, "esc11_grip_absolute_request_speed_is_out_of_range 100");
    expect(esc11_grip_absolute_request_speed_is_out_of_range(101u) == true, "esc11_grip_absolute_request_speed_is_out_of_range 101");
}

static void test_216(void)
{
    expect(esc11_grip_absolute_request_force_is_out_of_range(0u) == false, "esc11_grip_absolute_request_force_is_out_of_range 0");
    expect(esc11_grip_absolute_request_force_is_out_of_range(1u) == false, "esc11_grip_absolute_request_force_is_out_of_range 1");
    expect(esc11_grip_absolute_request_force_is_out_of_range(99u) == false, "esc11_grip_absolute_request_force_is_out_of_range 99");
    expect(esc11_grip_absolute_request_force_is_out_of_range(100u) == false, "esc11_grip_absolute_request_force_is_out_of_range 100");
    expect(esc11_grip_absolute_request_force_is_out_of_range(101u) == true, "esc11_grip_absolute_request_force_is_out_of_range 101");
}

static void test_217(void)
{
    expect(esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range((-134217728)) == true, "esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range -134217728");
    expect(esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range((-134217727)) == false, "esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range -134217727");
    expect(esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range((-134217726)) == false, "esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range -134217726");
    expect(esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range(134217726) == false, "esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range 134217726");
    expect(esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range(134217727) == false, "esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range 134217727");
    expect(esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range(134217728) == true, "esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range 134217728");
}

static void test_218(void)
{
    expect(esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range((-134217728)) == true, "esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range -134217728");
    expect(esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range((-134217727)) == false, "esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range -134217727");
    expect(esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range((-134217726)) == false, "esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range -134217726");
    expect(esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range(134217726) == false, "esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range 134217726");
    expect(esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range(134217727) == false, "esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range 134217727");
    expect(esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range(134217728) == true, "esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range 134217728");
}

static void test_219(void)
{
    expect(esc11_grip_open_with_zone_request_speed_is_out_of_range(0u) == false, "esc11_grip_open_with_zone_request_speed_is_out_of_range 0");
    expect(esc11_grip_open_with_zone_request_speed_is_out_of_range(1u) == false, "esc11_grip_open_with_zone_request_speed_is_out_of_range 1");
    expect(esc11_grip_open_with_zone_request_speed_is_out_of_range(99u) == false, "esc11_grip_open_with_zone_request_speed_is_out_of_range 99");
    expect(esc11_grip_open_with_zone_request_speed_is_out_of_range(100u) == false, "esc11_grip_open_with_zone_request_speed_is_out_of_range 100");
    expect(esc11_grip_open_with_zone_request_speed_is_out_of_range(101u) == true, "esc11_grip_open_with_zone_request_speed_is_out_of_range 101");
}

static void test_220(void)
{
    expect(esc11_grip_open_with_zone_request_force_is_out_of_range(0u) == false, "esc11_grip_open_with_zone_request_force_is_out_of_range 0");
    expect(esc11_grip_open_with_zone_request_force_is_out_of_range(1u) == false, "esc11_grip_open_with_zone_request_force_is_out_of_range 1");
    expect(esc11_grip_open_with_zone_request_force_is_out_of_range(99u) == false, "esc11_grip_open_with_zone_request_force_is_out_of_range 99");
    expect(esc11_grip_open_with_zone_request_force_is_out_of_range(100u) == false, "esc11_grip_open_with_zone_request_force_is_out_of_range 100");
    expect(esc11_grip_open_with_zone_request_force_is_out_of_range(101u) == true, "esc11_grip_open_with_zone_request_force_is_out_of_range 101");
}

static void test_221(void)
{
    expect(esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range((-134217728)) == true, "esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range -134217728");
    expect(esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range((-134217727)) == false, "esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range -134217727");
    expect(esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range((-134217726)) == false, "esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range -134217726");
    expect(esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range(134217726) == false, "esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range 134217726");
    expect(esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range(134217727) == false, "esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range 134217727");
    expect(esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range(134217728) == true, "esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range 134217728");
}

static void test_222(void)
{
    expect(esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range((-134217728)) == true, "esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range -134217728");
    expect(esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range((-134217727)) == false, "esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range -134217727");
    expect(esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range((-134217726)) == false, "esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range -134217726");
    expect(esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range(134217726) == false, "esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range 134217726");
    expect(esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range(134217727) == false, "esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range 134217727");
    expect(esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range(134217728) == true, "esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range 134217728");
}

static void test_223(void)
{
    expect(esc11_grip_close_with_zone_request_speed_is_out_of_range(0u) == false, "esc11_grip_close_with_zone_request_speed_is_out_of_range 0");
    expect(esc11_grip_close_with_zone_request_speed_is_out_of_range(1u) == false, "esc11_grip_close_with_zone_request_speed_is_out_of_range 1");
    expect(esc11_grip_close_with_zone_request_speed_is_out_of_range(99u) == false, "esc11_grip_close_with_zone_request_speed_is_out_of_range 99");
    expect(esc11_grip_close_with_zone_request_speed_is_out_of_range(100u) == false, "esc11_grip_close_with_zone_request_speed_is_out_of_range 100");
    expect(esc11_grip_close_with_zone_request_speed_is_out_of_range(101u) == true, "esc11_grip_close_with_zone_request_speed_is_out_of_range 101");
}

static void test_224(void)
{
    expect(esc11_grip_close_with_zone_request_force_is_out_of_range(0u) == false, "esc11_grip_close_with_zone_request_force_is_out_of_range 0");
    expect(esc11_grip_close_with_zone_request_force_is_out_of_range(1u) == false, "esc11_grip_close_with_zone_request_force_is_out_of_range 1");
    expect(esc11_grip_close_with_zone_request_force_is_out_of_range(99u) == false, "esc11_grip_close_with_zone_request_force_is_out_of_range 99");
    expect(esc11_grip_close_with_zone_request_force_is_out_of_range(100u) == false, "esc11_grip_close_with_zone_request_force_is_out_of_range 100");
    expect(esc11_grip_close_with_zone_request_force_is_out_of_range(101u) == true, "esc11_grip_close_with_zone_request_force_is_out_of_range 101");
}

static void test_225(void)
{
    expect(esc11_read_current_position_response_position_is_out_of_range((-134217728)) == true, "esc11_read_current_position_response_position_is_out_of_range -134217728");
    expect(esc11_read_current_position_response_position_is_out_of_range((-134217727)) == false, "esc11_read_current_position_response_position_is_out_of_range -134217727");
    expect(esc11_read_current_position_response_position_is_out_of_range((-134217726)) == false, "esc11_read_current_position_response_position_is_out_of_range -134217726");
    expect(esc11_read_current_position_response_position_is_out_of_range(134217726) == false, "esc11_read_current_position_response_position_is_out_of_range 134217726");
    expect(esc11_read_current_position_response_position_is_out_of_range(134217727) == false, "esc11_read_current_position_response_position_is_out_of_range 134217727");
    expect(esc11_read_current_position_response_position_is_out_of_range(134217728) == true, "esc11_read_current_position_response_position_is_out_of_range 134217728");
}

static void test_226(void)
{
    expect(esc11_read_current_point_number_response_point_number_is_out_of_range(0u) == true, "esc11_read_current_point_number_response_point_number_is_out_of_range 0");
    expect(esc11_read_current_point_number_response_point_number_is_out_of_range(1u) == false, "esc11_read_current_point_number_response_point_number_is_out_of_range 1");
    expect(esc11_read_current_point_number_response_point_number_is_out_of_range(2u) == false, "esc11_read_current_point_number_response_point_number_is_out_of_range 2");
    expect(esc11_read_current_point_number_response_point_number_is_out_of_range(30u) == false, "esc11_read_current_point_number_response_point_number_is_out_of_range 30");
    expect(esc11_read_current_point_number_response_point_number_is_out_of_range(31u) == false, "esc11_read_current_point_number_response_point_number_is_out_of_range 31");
    expect(esc11_read_current_point_number_response_point_number_is_out_of_range(32u) == true, "esc11_read_current_point_number_response_point_number_is_out_of_range 32");
}

static void test_227(void)
{
    expect(esc11_read_parameter_request_parameter_number_is_out_of_range(0u) == false, "esc11_read_parameter_request_parameter_number_is_out_of_range 0");
    expect(esc11_read_parameter_request_parameter_number_is_out_of_range(1u) == false, "esc11_read_parameter_request_parameter_number_is_out_of_range 1");
    expect(esc11_read_parameter_request_parameter_number_is_out_of_range(30u) == false, "esc11_read_parameter_request_parameter_number_is_out_of_range 30");
    expect(esc11_read_parameter_request_parameter_number_is_out_of_range(31u) == false, "esc11_read_parameter_request_parameter_number_is_out_of_range 31");
    expect(esc11_read_parameter_request_parameter_number_is_out_of_range(32u) == true, "esc11_read_parameter_request_parameter_number_is_out_of_range 32");
}

static void test_228(void)
{
    expect(esc11_read_point_request_point_number_is_out_of_range(0u) == true, "esc11_read_point_request_point_number_is_out_of_range 0");
    expect(esc11_read_point_request_point_number_is_out_of_range(1u) == false, "esc11_read_point_request_point_number_is_out_of_range 1");
    expect(esc11_read_point_request_point_number_is_out_of_range(2u) == false, "esc11_read_point_request_point_number_is_out_of_range 2");
    expect(esc11_read_point_request_point_number_is_out_of_range(30u) == false, "esc11_read_point_request_point_number_is_out_of_range 30");
    expect(esc11_read_point_request_point_number_is_out_of_range(31u) == false, "esc11_read_point_request_point_number_is_out_of_range 31");
    expect(esc11_read_point_request_point_number_is_out_of_range(32u) == true, "esc11_read_point_request_point_number_is_out_of_range 32");
}

static void test_229(void)
{
    expect(esc11_read_accumulated_time_response_minutes_is_out_of_range(0u) == false, "esc11_read_accumulated_time_response_minutes_is_out_of_range 0");
    expect(esc11_read_accumulated_time_response_minutes_is_out_of_range(1u) == false, "esc11_read_accumulated_time_response_minutes_is_out_of_range 1");
    expect(esc11_read_accumulated_time_response_minutes_is_out_of_range(59u) == false, "esc11_read_accumulated_time_response_minutes_is_out_of_range 59");
    expect(esc11_read_accumulated_time_response_minutes_is_out_of_range(60u) == false, "esc11_read_accumulated_time_response_minutes_is_out_of_range 60");
    expect(esc11_read_accumulated_time_response_minutes_is_out_of_range(61u) == true, "esc11_read_accumulated_time_response_minutes_is_out_of_range 61");
}

static void test_230(void)
{
    expect(esc11_par_parameters_positive_soft_limit_is_out_of_range(0u) == false, "esc11_par_parameters_positive_soft_limit_is_out_of_range 0");
    expect(esc11_par_parameters_positive_soft_limit_is_out_of_range(1u) == false, "esc11_par_parameters_positive_soft_limit_is_out_of_range 1");
    expect(esc11_par_parameters_positive_soft_limit_is_out_of_range(9998u) == false, "esc11_par_parameters_positive_soft_limit_is_out_of_range 9998");
    expect(esc11_par_parameters_positive_soft_limit_is_out_of_range(9999u) == false, "esc11_par_parameters_positive_soft_limit_is_out_of_range 9999");
    expect(esc11_par_parameters_positive_soft_limit_is_out_of_range(10000u) == true, "esc11_par_parameters_positive_soft_limit_is_out_of_range 10000");
}

static void test_231(void)
{
    expect(esc11_par_parameters_negative_soft_limit_is_out_of_range((-10000)) == true, "esc11_par_parameters_negative_soft_limit_is_out_of_range -10000");
    expect(esc11_par_parameters_negative_soft_limit_is_out_of_range((-9999)) == false, "esc11_par_parameters_negative_soft_limit_is_out_of_range -9999");
    expect(esc11_par_parameters_negative_soft_limit_is_out_of_range((-9998)) == false, "esc11_par_parameters_negative_soft_limit_is_out_of_range -9998");
    expect(esc11_par_parameters_negative_soft_limit_is_out_of_range((-1)) == false, "esc11_par_parameters_negative_soft_limit_is_out_of_range -1");
    expect(esc11_par_parameters_negative_soft_limit_is_out_of_range(0) == false, "esc11_par_parameters_negative_soft_limit_is_out_of_range 0");
    expect(esc11_par_parameters_negative_soft_limit_is_out_of_range(1) == true, "esc11_par_parameters_negative_soft_limit_is_out_of_range 1");
}

static void test_232(void)
{
    expect(esc11_par_parameters_stroke_is_out_of_range(0u) == false, "esc11_par_parameters_stroke_is_out_of_range 0");
    expect(esc11_par_parameters_stroke_is_out_of_range(1u) == false, "esc11_par_parameters_stroke_is_out_of_range 1");
    expect(esc11_par_parameters_stroke_is_out_of_range(9998u) == false, "esc11_par_parameters_stroke_is_out_of_range 9998");
    expect(esc11_par_parameters_stroke_is_out_of_range(9999u) == false, "esc11_par_parameters_stroke_is_out_of_range 9999");
    expect(esc11_par_parameters_stroke_is_out_of_range(10000u) == true, "esc11_par_parameters_stroke_is_out_of_range 10000");
}

static void test_233(void)
{
    expect(esc11_par_parameters_homing_speed_is_out_of_range(0u) == true, "esc11_par_parameters_homing_speed_is_out_of_range 0");
    expect(esc11_par_parameters_homing_speed_is_out_of_range(1u) == false, "esc11_par_parameters_homing_speed_is_out_of_range 1");
    expect(esc11_par_parameters_homing_speed_is_out_of_range(2u) == false, "esc11_par_parameters_homing_speed_is_out_of_range 2");
    expect(esc11_par_parameters_homing_speed_is_out_of_range(49u) == false, "esc11_par_parameters_homing_speed_is_out_of_range 49");
    expect(esc11_par_parameters_homing_speed_is_out_of_range(50u) == false, "esc11_par_parameters_homing_speed_is_out_of_range 50");
    expect(esc11_par_parameters_homing_speed_is_out_of_range(51u) == true, "esc11_par_parameters_homing_speed_is_out_of_range 51");
}

static void test_234(void)
{
    expect(esc11_par_parameters_home_offset_is_out_of_range((-10000)) == true, "esc11_par_parameters_home_offset_is_out_of_range -10000");
    expect(esc11_par_parameters_home_offset_is_out_of_range((-9999)) == false, "esc11_par_parameters_home_offset_is_out_of_range -9999");
    expect(esc11_par_parameters_home_offset_is_out_of_range((-9998)) == false, "esc11_par_parameters_home_offset_is_out_of_range -9998");
    expect(esc11_par_parameters_home_offset_is_out_of_range(9998) == false, "esc11_par_parameters_home_offset_is_out_of_range 9998");
    expect(esc11_par_parameters_home_offset_is_out_of_range(9999) == false, "esc11_par_parameters_home_offset_is_out_of_range 9999");
    expect(esc11_par_parameters_home_offset_is_out_of_range(10000) == true, "esc11_par_parameters_home_offset_is_out_of_range 10000");
}

static void test_235(void)
{
    expect(esc11_par_parameters_acceleration_is_out_of_range(0u) == true, "esc11_par_parameters_acceleration_is_out_of_range 0");
    expect(esc11_par_parameters_acceleration_is_out_of_range(1u) == false, "esc11_par_parameters_acceleration_is_out_of_range 1");
    expect(esc11_par_parameters_acceleration_is_out_of_range(2u) == false, "esc11_par_parameters_acceleration_is_out_of_range 2");
    expect(esc11_par_parameters_acceleration_is_out_of_range(99u) == false, "esc11_par_parameters_acceleration_is_out_of_range 99");
    expect(esc11_par_parameters_acceleration_is_out_of_range(100u) == false, "esc11_par_parameters_acceleration_is_out_of_range 100");
    expect(esc11_par_parameters_acceleration_is_out_of_range(101u) == true, "esc11_par_parameters_acceleration_is_out_of_range 101");
}

static void test_236(void)
{
    expect(esc11_par_parameters_maximum_program_speed_is_out_of_range(0u) == true, "esc11_par_parameters_maximum_program_speed_is_out_of_range 0");
    expect(esc11_par_parameters_maximum_program_speed_is_out_of_range(1u) == false, "esc11_par_parameters_maximum_program_speed_is_out_of_range 1");
    expect(esc11_par_parameters_maximum_program_speed_is_out_of_range(2u) == false, "esc11_par_parameters_maximum_program_speed_is_out_of_range 2");
    expect(esc11_par_parameters_maximum_program_speed_is_out_of_range(99u) == false, "esc11_par_parameters_maximum_program_speed_is_out_of_range 99");
    expect(esc11_par_parameters_maximum_program_speed_is_out_of_range(100u) == false, "esc11_par_parameters_maximum_program_speed_is_out_of_range 100");
    expect(esc11_par_parameters_maximum_program_speed_is_out_of_range(101u) == true, "esc11_par_parameters_maximum_program_speed_is_out_of_range 101");
}

static void test_237(void)
{
    expect(esc11_par_parameters_gripping_speed_is_out_of_range(0u) == true, "esc11_par_parameters_gripping_speed_is_out_of_range 0");
    expect(esc11_par_parameters_gripping_speed_is_out_of_range(1u) == false, "esc11_par_parameters_gripping_speed_is_out_of_range 1");
    expect(esc11_par_parameters_gripping_speed_is_out_of_range(2u) == false, "esc11_par_parameters_gripping_speed_is_out_of_range 2");
    expect(esc11_par_parameters_gripping_speed_is_out_of_range(99u) == false, "esc11_par_parameters_gripping_speed_is_out_of_range 99");
    expect(esc11_par_parameters_gripping_speed_is_out_of_range(100u) == false, "esc11_par_parameters_gripping_speed_is_out_of_range 100");
    expect(esc11_par_parameters_gripping_speed_is_out_of_range(101u) == true, "esc11_par_parameters_gripping_speed_is_out_of_range 101");
}

static void test_238(void)
{
    expect(esc11_par_parameters_constant_speed_distance_is_out_of_range(0u) == true, "esc11_par_parameters_constant_speed_distance_is_out_of_range 0");
    expect(esc11_par_parameters_constant_speed_distance_is_out_of_range(1u) == false, "esc11_par_parameters_constant_speed_distance_is_out_of_range 1");
    expect(esc11_par_parameters_constant_speed_distance_is_out_of_range(2u) == false, "esc11_par_parameters_constant_speed_distance_is_out_of_range 2");
    expect(esc11_par_parameters_constant_speed_distance_is_out_of_range(9998u) == false, "esc11_par_parameters_constant_speed_distance_is_out_of_range 9998");
    expect(esc11_par_parameters_constant_speed_distance_is_out_of_range(9999u) == false, "esc11_par_parameters_constant_speed_distance_is_out_of_range 9999");
    expect(esc11_par_parameters_constant_speed_distance_is_out_of_range(10000u) == true, "esc11_par_parameters_constant_speed_distance_is_out_of_range 10000");
}

static void test_239(void)
{
    expect(esc11_par_parameters_limit_width_is_out_of_range(0u) == true, "esc11_par_parameters_limit_width_is_out_of_range 0");
    expect(esc11_par_parameters_limit_width_is_out_of_range(1u) == false, "esc11_par_parameters_limit_width_is_out_of_range 1");
    expect(esc11_par_parameters_limit_width_is_out_of_range(2u) == false, "esc11_par_parameters_limit_width_is_out_of_range 2");
    expect(esc11_par_parameters_limit_width_is_out_of_range(9998u) == false, "esc11_par_parameters_limit_width_is_out_of_range 9998");
    expect(esc11_par_parameters_limit_width_is_out_of_range(9999u) == false, "esc11_par_parameters_limit_width_is_out_of_range 9999");
    expect(esc11_par_parameters_limit_width_is_out_of_range(10000u) == true, "esc11_par_parameters_limit_width_is_out_of_range 10000");
}

static void test_240(void)
{
    expect(esc11_par_parameters_positioning_complete_pulses_is_out_of_range(0u) == true, "esc11_par_parameters_positioning_complete_pulses_is_out_of_range 0");
    expect(esc11_par_parameters_positioning_complete_pulses_is_out_of_range(1u) == false, "esc11_par_parameters_positioning_complete_pulses_is_out_of_range 1");
    expect(esc11_par_parameters_positioning_complete_pulses_is_out_of_range(2u) == false, "esc11_par_parameters_positioning_complete_pulses_is_out_of_range 2");
    expect(esc11_par_parameters_positioning_complete_pulses_is_out_of_range(3999u) == false, "esc11_par_parameters_positioning_complete_pulses_is_out_of_range 3999");
    expect(esc11_par_parameters_positioning_complete_pulses_is_out_of_range(4000u) == false, "esc11_par_parameters_positioning_complete_pulses_is_out_of_range 4000");
    expect(esc11_par_parameters_positioning_complete_pulses_is_out_of_range(4001u) == true, "esc11_par_parameters_positioning_complete_pulses_is_out_of_range 4001");
}

unsigned long esc11_selftest(void (*tell)(const char *what))
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
    return failed;
}

#ifdef HOSTED
static void print(const char *what)
{
    printf("failed: %s\n", what);
}

int main(void)
{
    (void)esc11_selftest(print);
    printf("%lu passed, %lu failed\n", passed, failed);
    return failed ? 1 : 0;
}
#endif
