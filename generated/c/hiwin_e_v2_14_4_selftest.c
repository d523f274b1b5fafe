/*
 * Tests hiwin_e_v2_14_4.h: E1/E2 PROFINET, version 2.14.4
 * Identity: 9bc9d8915a5c154a
 *
 * Generated; do not edit. Compile and run it: it exits with 0 if every test passes. On a machine without an operating system
 * compile it with -ffreestanding; then it has no main, and you call hiwin_e_selftest yourself.
 */
#define HIWIN_E_WITH_TEXTS
#include "hiwin_e_v2_14_4.h"

#if !defined(__STDC_HOSTED__) || __STDC_HOSTED__
#include <stdio.h>
#define HOSTED
#endif

/* Calls `tell` for each test that fails, and returns their number. */
unsigned long hiwin_e_selftest(void (*tell)(const char *what));

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
    expect(HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_1_MASK == 0x0001u, "HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_1_MASK");
    expect(hiwin_e_digital_output_control_output_1(0x0001u) == true, "hiwin_e_digital_output_control_output_1");
    expect(hiwin_e_digital_output_control_output_1((uint16_t)~0x0001u) == false, "hiwin_e_digital_output_control_output_1");
    expect(HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_2_MASK == 0x0002u, "HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_2_MASK");
    expect(hiwin_e_digital_output_control_output_2(0x0002u) == true, "hiwin_e_digital_output_control_output_2");
    expect(hiwin_e_digital_output_control_output_2((uint16_t)~0x0002u) == false, "hiwin_e_digital_output_control_output_2");
    expect(HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_3_MASK == 0x0004u, "HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_3_MASK");
    expect(hiwin_e_digital_output_control_output_3(0x0004u) == true, "hiwin_e_digital_output_control_output_3");
    expect(hiwin_e_digital_output_control_output_3((uint16_t)~0x0004u) == false, "hiwin_e_digital_output_control_output_3");
    expect(HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_4_MASK == 0x0008u, "HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_4_MASK");
    expect(hiwin_e_digital_output_control_output_4(0x0008u) == true, "hiwin_e_digital_output_control_output_4");
    expect(hiwin_e_digital_output_control_output_4((uint16_t)~0x0008u) == false, "hiwin_e_digital_output_control_output_4");
    expect(HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_5_MASK == 0x0010u, "HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_5_MASK");
    expect(hiwin_e_digital_output_control_output_5(0x0010u) == true, "hiwin_e_digital_output_control_output_5");
    expect(hiwin_e_digital_output_control_output_5((uint16_t)~0x0010u) == false, "hiwin_e_digital_output_control_output_5");
    expect(HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_1_MASK == 0x0001u, "HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_1_MASK");
    expect(hiwin_e_digital_output_states_output_1(0x0001u) == true, "hiwin_e_digital_output_states_output_1");
    expect(hiwin_e_digital_output_states_output_1((uint16_t)~0x0001u) == false, "hiwin_e_digital_output_states_output_1");
    expect(HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_2_MASK == 0x0002u, "HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_2_MASK");
    expect(hiwin_e_digital_output_states_output_2(0x0002u) == true, "hiwin_e_digital_output_states_output_2");
    expect(hiwin_e_digital_output_states_output_2((uint16_t)~0x0002u) == false, "hiwin_e_digital_output_states_output_2");
    expect(HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_3_MASK == 0x0004u, "HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_3_MASK");
    expect(hiwin_e_digital_output_states_output_3(0x0004u) == true, "hiwin_e_digital_output_states_output_3");
    expect(hiwin_e_digital_output_states_output_3((uint16_t)~0x0004u) == false, "hiwin_e_digital_output_states_output_3");
    expect(HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_4_MASK == 0x0008u, "HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_4_MASK");
    expect(hiwin_e_digital_output_states_output_4(0x0008u) == true, "hiwin_e_digital_output_states_output_4");
    expect(hiwin_e_digital_output_states_output_4((uint16_t)~0x0008u) == false, "hiwin_e_digital_output_states_output_4");
    expect(HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_5_MASK == 0x0010u, "HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_5_MASK");
    expect(hiwin_e_digital_output_states_output_5(0x0010u) == true, "hiwin_e_digital_output_states_output_5");
    expect(hiwin_e_digital_output_states_output_5((uint16_t)~0x0010u) == false, "hiwin_e_digital_output_states_output_5");
    expect(HIWIN_E_SOFTWARE_STATE_HOMING_MASK == 0x0008u, "HIWIN_E_SOFTWARE_STATE_HOMING_MASK");
    expect(hiwin_e_software_state_homing(0x0008u) == true, "hiwin_e_software_state_homing");
    expect(hiwin_e_software_state_homing((uint16_t)~0x0008u) == false, "hiwin_e_software_state_homing");
    expect(HIWIN_E_SOFTWARE_STATE_POSITION_TRIGGER_ACTIVE_MASK == 0x0010u, "HIWIN_E_SOFTWARE_STATE_POSITION_TRIGGER_ACTIVE_MASK");
    expect(hiwin_e_software_state_position_trigger_active(0x0010u) == true, "hiwin_e_software_state_position_trigger_active");
    expect(hiwin_e_software_state_position_trigger_active((uint16_t)~0x0010u) == false, "hiwin_e_software_state_position_trigger_active");
    expect(HIWIN_E_SOFTWARE_STATE_GANTRY_COMMUNICATING_MASK == 0x0020u, "HIWIN_E_SOFTWARE_STATE_GANTRY_COMMUNICATING_MASK");
    expect(hiwin_e_software_state_gantry_communicating(0x0020u) == true, "hiwin_e_software_state_gantry_communicating");
    expect(hiwin_e_software_state_gantry_communicating((uint16_t)~0x0020u) == false, "hiwin_e_software_state_gantry_communicating");
    expect(HIWIN_E_SOFTWARE_STATE_YAW_MOTOR_ENERGIZED_MASK == 0x0040u, "HIWIN_E_SOFTWARE_STATE_YAW_MOTOR_ENERGIZED_MASK");
    expect(hiwin_e_software_state_yaw_motor_energized(0x0040u) == true, "hiwin_e_software_state_yaw_motor_energized");
    expect(hiwin_e_software_state_yaw_motor_energized((uint16_t)~0x0040u) == false, "hiwin_e_software_state_yaw_motor_energized");
    expect(HIWIN_E_SOFTWARE_STATE_YAW_ALARM_MASK == 0x0080u, "HIWIN_E_SOFTWARE_STATE_YAW_ALARM_MASK");
    expect(hiwin_e_software_state_yaw_alarm(0x0080u) == true, "hiwin_e_software_state_yaw_alarm");
    expect(hiwin_e_software_state_yaw_alarm((uint16_t)~0x0080u) == false, "hiwin_e_software_state_yaw_alarm");
    expect(HIWIN_E_SOFTWARE_STATE_GANTRY_ACTIVE_MASK == 0x0100u, "HIWIN_E_SOFTWARE_STATE_GANTRY_ACTIVE_MASK");
    expect(hiwin_e_software_state_gantry_active(0x0100u) == true, "hiwin_e_software_state_gantry_active");
    expect(hiwin_e_software_state_gantry_active((uint16_t)~0x0100u) == false, "hiwin_e_software_state_gantry_active");
    expect(HIWIN_E_SOFTWARE_STATE_YAW_HOMED_MASK == 0x0200u, "HIWIN_E_SOFTWARE_STATE_YAW_HOMED_MASK");
    expect(hiwin_e_software_state_yaw_homed(0x0200u) == true, "hiwin_e_software_state_yaw_homed");
    expect(hiwin_e_software_state_yaw_homed((uint16_t)~0x0200u) == false, "hiwin_e_software_state_yaw_homed");
    expect(HIWIN_E_SOFTWARE_STATE_YAW_NEAR_HOME_MASK == 0x0400u, "HIWIN_E_SOFTWARE_STATE_YAW_NEAR_HOME_MASK");
    expect(hiwin_e_software_state_yaw_near_home(0x0400u) == true, "hiwin_e_software_state_yaw_near_home");
    expect(hiwin_e_software_state_yaw_near_home((uint16_t)~0x0400u) == false, "hiwin_e_software_state_yaw_near_home");
    expect(HIWIN_E_SOFTWARE_STATE_YAW_CALIBRATED_MASK == 0x0800u, "HIWIN_E_SOFTWARE_STATE_YAW_CALIBRATED_MASK");
    expect(hiwin_e_software_state_yaw_calibrated(0x0800u) == true, "hiwin_e_software_state_yaw_calibrated");
    expect(hiwin_e_software_state_yaw_calibrated((uint16_t)~0x0800u) == false, "hiwin_e_software_state_yaw_calibrated");
    expect(HIWIN_E_SOFTWARE_STATE_YAW_IN_POSITION_MASK == 0x1000u, "HIWIN_E_SOFTWARE_STATE_YAW_IN_POSITION_MASK");
    expect(hiwin_e_software_state_yaw_in_position(0x1000u) == true, "hiwin_e_software_state_yaw_in_position");
    expect(hiwin_e_software_state_yaw_in_position((uint16_t)~0x1000u) == false, "hiwin_e_software_state_yaw_in_position");
    expect(HIWIN_E_SOFTWARE_STATE_YAW_READY_MASK == 0x2000u, "HIWIN_E_SOFTWARE_STATE_YAW_READY_MASK");
    expect(hiwin_e_software_state_yaw_ready(0x2000u) == true, "hiwin_e_software_state_yaw_ready");
    expect(hiwin_e_software_state_yaw_ready((uint16_t)~0x2000u) == false, "hiwin_e_software_state_yaw_ready");
    expect(HIWIN_E_REFERENCE_MARK_FUNCTIONS_ERROR_COMPENSATION_TABLE_MASK == 0x0001u, "HIWIN_E_REFERENCE_MARK_FUNCTIONS_ERROR_COMPENSATION_TABLE_MASK");
    expect(hiwin_e_reference_mark_functions_error_compensation_table(0x0001u) == true, "hiwin_e_reference_mark_functions_error_compensation_table");
    expect(hiwin_e_reference_mark_functions_error_compensation_table((uint16_t)~0x0001u) == false, "hiwin_e_reference_mark_functions_error_compensation_table");
    expect(HIWIN_E_REFERENCE_MARK_FUNCTIONS_POSITION_TRIGGER_MASK == 0x0002u, "HIWIN_E_REFERENCE_MARK_FUNCTIONS_POSITION_TRIGGER_MASK");
    expect(hiwin_e_reference_mark_functions_position_trigger(0x0002u) == true, "hiwin_e_reference_mark_functions_position_trigger");
    expect(hiwin_e_reference_mark_functions_position_trigger((uint16_t)~0x0002u) == false, "hiwin_e_reference_mark_functions_position_trigger");
    expect(HIWIN_E_POSITION_TRIGGER_ERROR_MODE_WITHOUT_ARRAYS_MASK == 0x0001u, "HIWIN_E_POSITION_TRIGGER_ERROR_MODE_WITHOUT_ARRAYS_MASK");
    expect(hiwin_e_position_trigger_error_mode_without_arrays(0x0001u) == true, "hiwin_e_position_trigger_error_mode_without_arrays");
    expect(hiwin_e_position_trigger_error_mode_without_arrays((uint16_t)~0x0001u) == false, "hiwin_e_position_trigger_error_mode_without_arrays");
    expect(HIWIN_E_POSITION_TRIGGER_ERROR_WRONG_ARRAY_INDEX_MASK == 0x0002u, "HIWIN_E_POSITION_TRIGGER_ERROR_WRONG_ARRAY_INDEX_MASK");
    expect(hiwin_e_position_trigger_error_wrong_array_index(0x0002u) == true, "hiwin_e_position_trigger_error_wrong_array_index");
    expect(hiwin_e_position_trigger_error_wrong_array_index((uint16_t)~0x0002u) == false, "hiwin_e_position_trigger_error_wrong_array_index");
    expect(HIWIN_E_POSITION_TRIGGER_ERROR_UNDEFINED_COMMAND_MASK == 0x0004u, "HIWIN_E_POSITION_TRIGGER_ERROR_UNDEFINED_COMMAND_MASK");
    expect(hiwin_e_position_trigger_error_undefined_command(0x0004u) == true, "hiwin_e_position_trigger_error_undefined_command");
    expect(hiwin_e_position_trigger_error_undefined_command((uint16_t)~0x0004u) == false, "hiwin_e_position_trigger_error_undefined_command");
    expect(HIWIN_E_POSITION_TRIGGER_ERROR_ENCODER_NOT_SUPPORTED_MASK == 0x0100u, "HIWIN_E_POSITION_TRIGGER_ERROR_ENCODER_NOT_SUPPORTED_MASK");
    expect(hiwin_e_position_trigger_error_encoder_not_supported(0x0100u) == true, "hiwin_e_position_trigger_error_encoder_not_supported");
    expect(hiwin_e_position_trigger_error_encoder_not_supported((uint16_t)~0x0100u) == false, "hiwin_e_position_trigger_error_encoder_not_supported");
    expect(HIWIN_E_POSITION_TRIGGER_ERROR_NOT_HOMED_MASK == 0x0200u, "HIWIN_E_POSITION_TRIGGER_ERROR_NOT_HOMED_MASK");
    expect(hiwin_e_position_trigger_error_not_homed(0x0200u) == true, "hiwin_e_position_trigger_error_not_homed");
    expect(hiwin_e_position_trigger_error_not_homed((uint16_t)~0x0200u) == false, "hiwin_e_position_trigger_error_not_homed");
    expect(HIWIN_E_POSITION_TRIGGER_ERROR_WRONG_PARAMETER_MASK == 0x0400u, "HIWIN_E_POSITION_TRIGGER_ERROR_WRONG_PARAMETER_MASK");
    expect(hiwin_e_position_trigger_error_wrong_parameter(0x0400u) == true, "hiwin_e_position_trigger_error_wrong_parameter");
    expect(hiwin_e_position_trigger_error_wrong_parameter((uint16_t)~0x0400u) == false, "hiwin_e_position_trigger_error_wrong_parameter");
    expect(HIWIN_E_POSITION_TRIGGER_ERROR_END_POSITION_PASSED_MASK == 0x0800u, "HIWIN_E_POSITION_TRIGGER_ERROR_END_POSITION_PASSED_MASK");
    expect(hiwin_e_position_trigger_error_end_position_passed(0x0800u) == true, "hiwin_e_position_trigger_error_end_position_passed");
    expect(hiwin_e_position_trigger_error_end_position_passed((uint16_t)~0x0800u) == false, "hiwin_e_position_trigger_error_end_position_passed");
    expect(HIWIN_E_BASIC_FUNCTION_SWITCH_1_COAST_STOP_METHOD_MASK == 0x000Fu, "HIWIN_E_BASIC_FUNCTION_SWITCH_1_COAST_STOP_METHOD_MASK");
    expect(hiwin_e_basic_function_switch_1_coast_stop_method(0x000Fu) == 15u, "hiwin_e_basic_function_switch_1_coast_stop_method");
    expect(hiwin_e_basic_function_switch_1_coast_stop_method((uint16_t)~0x000Fu) == 0, "hiwin_e_basic_function_switch_1_coast_stop_method");
    expect(HIWIN_E_DRIVE_WARNINGS_1_POSITION_DEVIATION_TOO_LARGE_MASK == 0x0001u, "HIWIN_E_DRIVE_WARNINGS_1_POSITION_DEVIATION_TOO_LARGE_MASK");
    expect(hiwin_e_drive_warnings_1_position_deviation_too_large(0x0001u) == true, "hiwin_e_drive_warnings_1_position_deviation_too_large");
    expect(hiwin_e_drive_warnings_1_position_deviation_too_large((uint16_t)~0x0001u) == false, "hiwin_e_drive_warnings_1_position_deviation_too_large");
    expect(HIWIN_E_DRIVE_WARNINGS_1_OVERLOAD_MASK == 0x0004u, "HIWIN_E_DRIVE_WARNINGS_1_OVERLOAD_MASK");
    expect(hiwin_e_drive_warnings_1_overload(0x0004u) == true, "hiwin_e_drive_warnings_1_overload");
    expect(hiwin_e_drive_warnings_1_overload((uint16_t)~0x0004u) == false, "hiwin_e_drive_warnings_1_overload");
    expect(HIWIN_E_DRIVE_WARNINGS_1_INTERNAL_FAN_STOPPED_MASK == 0x0080u, "HIWIN_E_DRIVE_WARNINGS_1_INTERNAL_FAN_STOPPED_MASK");
    expect(hiwin_e_drive_warnings_1_internal_fan_stopped(0x0080u) == true, "hiwin_e_drive_warnings_1_internal_fan_stopped");
    expect(hiwin_e_drive_warnings_1_internal_fan_stopped((uint16_t)~0x0080u) == false, "hiwin_e_drive_warnings_1_internal_fan_stopped");
    expect(HIWIN_E_DRIVE_WARNINGS_1_ENCODER_BATTERY_FAULT_MASK == 0x0100u, "HIWIN_E_DRIVE_WARNINGS_1_ENCODER_BATTERY_FAULT_MASK");
    expect(hiwin_e_drive_warnings_1_encoder_battery_fault(0x0100u) == true, "hiwin_e_drive_warnings_1_encoder_battery_fault");
    expect(hiwin_e_drive_warnings_1_encoder_battery_fault((uint16_t)~0x0100u) == false, "hiwin_e_drive_warnings_1_encoder_battery_fault");
    expect(HIWIN_E_DRIVE_WARNINGS_1_RESTART_REQUIRED_MASK == 0x0200u, "HIWIN_E_DRIVE_WARNINGS_1_RESTART_REQUIRED_MASK");
    expect(hiwin_e_drive_warnings_1_restart_required(0x0200u) == true, "hiwin_e_drive_warnings_1_restart_required");
    expect(hiwin_e_drive_warnings_1_restart_required((uint16_t)~0x0200u) == false, "hiwin_e_drive_warnings_1_restart_required");
    expect(HIWIN_E_DRIVE_WARNINGS_1_UNDERVOLTAGE_MASK == 0x0400u, "HIWIN_E_DRIVE_WARNINGS_1_UNDERVOLTAGE_MASK");
    expect(hiwin_e_drive_warnings_1_undervoltage(0x0400u) == true, "hiwin_e_drive_warnings_1_undervoltage");
    expect(hiwin_e_drive_warnings_1_undervoltage((uint16_t)~0x0400u) == false, "hiwin_e_drive_warnings_1_undervoltage");
    expect(HIWIN_E_DRIVE_WARNINGS_1_OVERTRAVEL_SERVO_ON_MASK == 0x0800u, "HIWIN_E_DRIVE_WARNINGS_1_OVERTRAVEL_SERVO_ON_MASK");
    expect(hiwin_e_drive_warnings_1_overtravel_servo_on(0x0800u) == true, "hiwin_e_drive_warnings_1_overtravel_servo_on");
    expect(hiwin_e_drive_warnings_1_overtravel_servo_on((uint16_t)~0x0800u) == false, "hiwin_e_drive_warnings_1_overtravel_servo_on");
    expect(HIWIN_E_DRIVE_WARNINGS_1_POSITIVE_OVERTRAVEL_SERVO_OFF_MASK == 0x1000u, "HIWIN_E_DRIVE_WARNINGS_1_POSITIVE_OVERTRAVEL_SERVO_OFF_MASK");
    expect(hiwin_e_drive_warnings_1_positive_overtravel_servo_off(0x1000u) == true, "hiwin_e_drive_warnings_1_positive_overtravel_servo_off");
    expect(hiwin_e_drive_warnings_1_positive_overtravel_servo_off((uint16_t)~0x1000u) == false, "hiwin_e_drive_warnings_1_positive_overtravel_servo_off");
    expect(HIWIN_E_DRIVE_WARNINGS_1_NEGATIVE_OVERTRAVEL_SERVO_OFF_MASK == 0x2000u, "HIWIN_E_DRIVE_WARNINGS_1_NEGATIVE_OVERTRAVEL_SERVO_OFF_MASK");
    expect(hiwin_e_drive_warnings_1_negative_overtravel_servo_off(0x2000u) == true, "hiwin_e_drive_warnings_1_negative_overtravel_servo_off");
    expect(hiwin_e_drive_warnings_1_negative_overtravel_servo_off((uint16_t)~0x2000u) == false, "hiwin_e_drive_warnings_1_negative_overtravel_servo_off");
    expect(HIWIN_E_DRIVE_WARNINGS_2_OVERVOLTAGE_MASK == 0x0001u, "HIWIN_E_DRIVE_WARNINGS_2_OVERVOLTAGE_MASK");
    expect(hiwin_e_drive_warnings_2_overvoltage(0x0001u) == true, "hiwin_e_drive_warnings_2_overvoltage");
    expect(hiwin_e_drive_warnings_2_overvoltage((uint16_t)~0x0001u) == false, "hiwin_e_drive_warnings_2_overvoltage");
    expect(HIWIN_E_DRIVE_WARNINGS_2_FIELDBUS_SYNCHRONIZATION_TIME_MASK == 0x0002u, "HIWIN_E_DRIVE_WARNINGS_2_FIELDBUS_SYNCHRONIZATION_TIME_MASK");
    expect(hiwin_e_drive_warnings_2_fieldbus_synchronization_time(0x0002u) == true, "hiwin_e_drive_warnings_2_fieldbus_synchronization_time");
    expect(hiwin_e_drive_warnings_2_fieldbus_synchronization_time((uint16_t)~0x0002u) == false, "hiwin_e_drive_warnings_2_fieldbus_synchronization_time");
    expect(HIWIN_E_DRIVE_WARNINGS_2_SYSTEM_WARNING_MASK == 0x0004u, "HIWIN_E_DRIVE_WARNINGS_2_SYSTEM_WARNING_MASK");
    expect(hiwin_e_drive_warnings_2_system_warning(0x0004u) == true, "hiwin_e_drive_warnings_2_system_warning");
    expect(hiwin_e_drive_warnings_2_system_warning((uint16_t)~0x0004u) == false, "hiwin_e_drive_warnings_2_system_warning");
    expect(HIWIN_E_DRIVE_WARNINGS_2_TORQUE_LIMIT_MASK == 0x0008u, "HIWIN_E_DRIVE_WARNINGS_2_TORQUE_LIMIT_MASK");
    expect(hiwin_e_drive_warnings_2_torque_limit(0x0008u) == true, "hiwin_e_drive_warnings_2_torque_limit");
    expect(hiwin_e_drive_warnings_2_torque_limit((uint16_t)~0x0008u) == false, "hiwin_e_drive_warnings_2_torque_limit");
    expect(HIWIN_E_DRIVE_WARNINGS_2_ENCODER_COMMUNICATION_MASK == 0x0010u, "HIWIN_E_DRIVE_WARNINGS_2_ENCODER_COMMUNICATION_MASK");
    expect(hiwin_e_drive_warnings_2_encoder_communication(0x0010u) == true, "hiwin_e_drive_warnings_2_encoder_communication");
    expect(hiwin_e_drive_warnings_2_encoder_communication((uint16_t)~0x0010u) == false, "hiwin_e_drive_warnings_2_encoder_communication");
    expect(HIWIN_E_DRIVE_WARNINGS_2_MULTI_STATION_FUNCTION_DISABLED_MASK == 0x0020u, "HIWIN_E_DRIVE_WARNINGS_2_MULTI_STATION_FUNCTION_DISABLED_MASK");
    expect(hiwin_e_drive_warnings_2_multi_station_function_disabled(0x0020u) == true, "hiwin_e_drive_warnings_2_multi_station_function_disabled");
    expect(hiwin_e_drive_warnings_2_multi_station_function_disabled((uint16_t)~0x0020u) == false, "hiwin_e_drive_warnings_2_multi_station_function_disabled");
    expect(HIWIN_E_DRIVE_WARNINGS_2_I2T_MASK == 0x0040u, "HIWIN_E_DRIVE_WARNINGS_2_I2T_MASK");
    expect(hiwin_e_drive_warnings_2_i2t(0x0040u) == true, "hiwin_e_drive_warnings_2_i2t");
    expect(hiwin_e_drive_warnings_2_i2t((uint16_t)~0x0040u) == false, "hiwin_e_drive_warnings_2_i2t");
    expect(HIWIN_E_OPERATION_WARNINGS_RELATIVE_MOVE_REJECTED_MASK == 0x00000040u, "HIWIN_E_OPERATION_WARNINGS_RELATIVE_MOVE_REJECTED_MASK");
    expect(hiwin_e_operation_warnings_relative_move_rejected(0x00000040u) == true, "hiwin_e_operation_warnings_relative_move_rejected");
    expect(hiwin_e_operation_warnings_relative_move_rejected((uint32_t)~0x00000040u) == false, "hiwin_e_operation_warnings_relative_move_rejected");
    expect(HIWIN_E_OPERATION_WARNINGS_ABSOLUTE_MOVE_REJECTED_MASK == 0x00000080u, "HIWIN_E_OPERATION_WARNINGS_ABSOLUTE_MOVE_REJECTED_MASK");
    expect(hiwin_e_operation_warnings_absolute_move_rejected(0x00000080u) == true, "hiwin_e_operation_warnings_absolute_move_rejected");
    expect(hiwin_e_operation_warnings_absolute_move_rejected((uint32_t)~0x00000080u) == false, "hiwin_e_operation_warnings_absolute_move_rejected");
    expect(HIWIN_E_OPERATION_WARNINGS_LOWER_LIMIT_POSITIVE_MASK == 0x00001000u, "HIWIN_E_OPERATION_WARNINGS_LOWER_LIMIT_POSITIVE_MASK");
    expect(hiwin_e_operation_warnings_lower_limit_positive(0x00001000u) == true, "hiwin_e_operation_warnings_lower_limit_positive");
    expect(hiwin_e_operation_warnings_lower_limit_positive((uint32_t)~0x00001000u) == false, "hiwin_e_operation_warnings_lower_limit_positive");
    expect(HIWIN_E_OPERATION_WARNINGS_UPPER_LIMIT_NEGATIVE_MASK == 0x00002000u, "HIWIN_E_OPERATION_WARNINGS_UPPER_LIMIT_NEGATIVE_MASK");
    expect(hiwin_e_operation_warnings_upper_limit_negative(0x00002000u) == true, "hiwin_e_operation_warnings_upper_limit_negative");
    expect(hiwin_e_operation_warnings_upper_limit_negative((uint32_t)~0x00002000u) == false, "hiwin_e_operation_warnings_upper_limit_negative");
    expect(HIWIN_E_OPERATION_WARNINGS_RANGE_TOO_LARGE_MASK == 0x00004000u, "HIWIN_E_OPERATION_WARNINGS_RANGE_TOO_LARGE_MASK");
    expect(hiwin_e_operation_warnings_range_too_large(0x00004000u) == true, "hiwin_e_operation_warnings_range_too_large");
    expect(hiwin_e_operation_warnings_range_too_large((uint32_t)~0x00004000u) == false, "hiwin_e_operation_warnings_range_too_large");
    expect(HIWIN_E_OPERATION_WARNINGS_RANGE_LOCKED_MASK == 0x00008000u, "HIWIN_E_OPERATION_WARNINGS_RANGE_LOCKED_MASK");
    expect(hiwin_e_operation_warnings_range_locked(0x00008000u) == true, "hiwin_e_operation_warnings_range_locked");
    expect(hiwin_e_operation_warnings_range_locked((uint32_t)~0x00008000u) == false, "hiwin_e_operation_warnings_range_locked");
    expect(HIWIN_E_CONTROL_WORD_1_ON_MASK == 0x0001u, "HIWIN_E_CONTROL_WORD_1_ON_MASK");
    expect(hiwin_e_control_word_1_on(0x0001u) == true, "hiwin_e_control_word_1_on");
    expect(hiwin_e_control_word_1_on((uint16_t)~0x0001u) == false, "hiwin_e_control_word_1_on");
    expect(HIWIN_E_CONTROL_WORD_1_NO_OFF2_MASK == 0x0002u, "HIWIN_E_CONTROL_WORD_1_NO_OFF2_MASK");
    expect(hiwin_e_control_word_1_no_off2(0x0002u) == true, "hiwin_e_control_word_1_no_off2");
    expect(hiwin_e_control_word_1_no_off2((uint16_t)~0x0002u) == false, "hiwin_e_control_word_1_no_off2");
    expect(HIWIN_E_CONTROL_WORD_1_NO_OFF3_MASK == 0x0004u, "HIWIN_E_CONTROL_WORD_1_NO_OFF3_MASK");
    expect(hiwin_e_control_word_1_no_off3(0x0004u) == true, "hiwin_e_control_word_1_no_off3");
    expect(hiwin_e_control_word_1_no_off3((uint16_t)~0x0004u) == false, "hiwin_e_control_word_1_no_off3");
    expect(HIWIN_E_CONTROL_WORD_1_ENABLE_OPERATION_MASK == 0x0008u, "HIWIN_E_CONTROL_WORD_1_ENABLE_OPERATION_MASK");
    expect(hiwin_e_control_word_1_enable_operation(0x0008u) == true, "hiwin_e_control_word_1_enable_operation");
    expect(hiwin_e_control_word_1_enable_operation((uint16_t)~0x0008u) == false, "hiwin_e_control_word_1_enable_operation");
    expect(HIWIN_E_CONTROL_WORD_1_ACKNOWLEDGE_ALARM_MASK == 0x0080u, "HIWIN_E_CONTROL_WORD_1_ACKNOWLEDGE_ALARM_MASK");
    expect(hiwin_e_control_word_1_acknowledge_alarm(0x0080u) == true, "hiwin_e_control_word_1_acknowledge_alarm");
    expect(hiwin_e_control_word_1_acknowledge_alarm((uint16_t)~0x0080u) == false, "hiwin_e_control_word_1_acknowledge_alarm");
    expect(HIWIN_E_CONTROL_WORD_1_CONTROL_BY_PLC_MASK == 0x0400u, "HIWIN_E_CONTROL_WORD_1_CONTROL_BY_PLC_MASK");
    expect(hiwin_e_control_word_1_control_by_plc(0x0400u) == true, "hiwin_e_control_word_1_control_by_plc");
    expect(hiwin_e_control_word_1_control_by_plc((uint16_t)~0x0400u) == false, "hiwin_e_control_word_1_control_by_plc");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_ON_MASK == 0x0001u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_ON_MASK");
    expect(hiwin_e_control_word_1_positioning_on(0x0001u) == true, "hiwin_e_control_word_1_positioning_on");
    expect(hiwin_e_control_word_1_positioning_on((uint16_t)~0x0001u) == false, "hiwin_e_control_word_1_positioning_on");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_OFF2_MASK == 0x0002u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_OFF2_MASK");
    expect(hiwin_e_control_word_1_positioning_no_off2(0x0002u) == true, "hiwin_e_control_word_1_positioning_no_off2");
    expect(hiwin_e_control_word_1_positioning_no_off2((uint16_t)~0x0002u) == false, "hiwin_e_control_word_1_positioning_no_off2");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_OFF3_MASK == 0x0004u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_OFF3_MASK");
    expect(hiwin_e_control_word_1_positioning_no_off3(0x0004u) == true, "hiwin_e_control_word_1_positioning_no_off3");
    expect(hiwin_e_control_word_1_positioning_no_off3((uint16_t)~0x0004u) == false, "hiwin_e_control_word_1_positioning_no_off3");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_ENABLE_OPERATION_MASK == 0x0008u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_ENABLE_OPERATION_MASK");
    expect(hiwin_e_control_word_1_positioning_enable_operation(0x0008u) == true, "hiwin_e_control_word_1_positioning_enable_operation");
    expect(hiwin_e_control_word_1_positioning_enable_operation((uint16_t)~0x0008u) == false, "hiwin_e_control_word_1_positioning_enable_operation");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_ENABLE_TRAVERSING_TASK_MASK == 0x0010u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_ENABLE_TRAVERSING_TASK_MASK");
    expect(hiwin_e_control_word_1_positioning_enable_traversing_task(0x0010u) == true, "hiwin_e_control_word_1_positioning_enable_traversing_task");
    expect(hiwin_e_control_word_1_positioning_enable_traversing_task((uint16_t)~0x0010u) == false, "hiwin_e_control_word_1_positioning_enable_traversing_task");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_INTERMEDIATE_STOP_MASK == 0x0020u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_INTERMEDIATE_STOP_MASK");
    expect(hiwin_e_control_word_1_positioning_no_intermediate_stop(0x0020u) == true, "hiwin_e_control_word_1_positioning_no_intermediate_stop");
    expect(hiwin_e_control_word_1_positioning_no_intermediate_stop((uint16_t)~0x0020u) == false, "hiwin_e_control_word_1_positioning_no_intermediate_stop");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_START_TRAVERSING_TASK_MASK == 0x0040u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_START_TRAVERSING_TASK_MASK");
    expect(hiwin_e_control_word_1_positioning_start_traversing_task(0x0040u) == true, "hiwin_e_control_word_1_positioning_start_traversing_task");
    expect(hiwin_e_control_word_1_positioning_start_traversing_task((uint16_t)~0x0040u) == false, "hiwin_e_control_word_1_positioning_start_traversing_task");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_ACKNOWLEDGE_ALARM_MASK == 0x0080u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_ACKNOWLEDGE_ALARM_MASK");
    expect(hiwin_e_control_word_1_positioning_acknowledge_alarm(0x0080u) == true, "hiwin_e_control_word_1_positioning_acknowledge_alarm");
    expect(hiwin_e_control_word_1_positioning_acknowledge_alarm((uint16_t)~0x0080u) == false, "hiwin_e_control_word_1_positioning_acknowledge_alarm");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_JOG_1_MASK == 0x0100u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_JOG_1_MASK");
    expect(hiwin_e_control_word_1_positioning_jog_1(0x0100u) == true, "hiwin_e_control_word_1_positioning_jog_1");
    expect(hiwin_e_control_word_1_positioning_jog_1((uint16_t)~0x0100u) == false, "hiwin_e_control_word_1_positioning_jog_1");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_JOG_2_MASK == 0x0200u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_JOG_2_MASK");
    expect(hiwin_e_control_word_1_positioning_jog_2(0x0200u) == true, "hiwin_e_control_word_1_positioning_jog_2");
    expect(hiwin_e_control_word_1_positioning_jog_2((uint16_t)~0x0200u) == false, "hiwin_e_control_word_1_positioning_jog_2");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_CONTROL_BY_PLC_MASK == 0x0400u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_CONTROL_BY_PLC_MASK");
    expect(hiwin_e_control_word_1_positioning_control_by_plc(0x0400u) == true, "hiwin_e_control_word_1_positioning_control_by_plc");
    expect(hiwin_e_control_word_1_positioning_control_by_plc((uint16_t)~0x0400u) == false, "hiwin_e_control_word_1_positioning_control_by_plc");
    expect(HIWIN_E_CONTROL_WORD_1_POSITIONING_START_HOMING_MASK == 0x0800u, "HIWIN_E_CONTROL_WORD_1_POSITIONING_START_HOMING_MASK");
    expect(hiwin_e_control_word_1_positioning_start_homing(0x0800u) == true, "hiwin_e_control_word_1_positioning_start_homing");
    expect(hiwin_e_control_word_1_positioning_start_homing((uint16_t)~0x0800u) == false, "hiwin_e_control_word_1_positioning_start_homing");
    expect(HIWIN_E_CONTROL_WORD_2_SIGN_OF_LIFE_MASK == 0xF000u, "HIWIN_E_CONTROL_WORD_2_SIGN_OF_LIFE_MASK");
    expect(hiwin_e_control_word_2_sign_of_life(0xF000u) == 15u, "hiwin_e_control_word_2_sign_of_life");
    expect(hiwin_e_control_word_2_sign_of_life((uint16_t)~0xF000u) == 0, "hiwin_e_control_word_2_sign_of_life");
    expect(HIWIN_E_CONTROL_WORD_2_FIXED_STOP_TRAVERSE_TO_FIXED_STOP_MASK == 0x0100u, "HIWIN_E_CONTROL_WORD_2_FIXED_STOP_TRAVERSE_TO_FIXED_STOP_MASK");
    expect(hiwin_e_control_word_2_fixed_stop_traverse_to_fixed_stop(0x0100u) == true, "hiwin_e_control_word_2_fixed_stop_traverse_to_fixed_stop");
    expect(hiwin_e_control_word_2_fixed_stop_traverse_to_fixed_stop((uint16_t)~0x0100u) == false, "hiwin_e_control_word_2_fixed_stop_traverse_to_fixed_stop");
    expect(HIWIN_E_CONTROL_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK == 0xF000u, "HIWIN_E_CONTROL_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK");
    expect(hiwin_e_control_word_2_fixed_stop_sign_of_life(0xF000u) == 15u, "hiwin_e_control_word_2_fixed_stop_sign_of_life");
    expect(hiwin_e_control_word_2_fixed_stop_sign_of_life((uint16_t)~0xF000u) == 0, "hiwin_e_control_word_2_fixed_stop_sign_of_life");
    expect(HIWIN_E_STATUS_WORD_1_READY_TO_SWITCH_ON_MASK == 0x0001u, "HIWIN_E_STATUS_WORD_1_READY_TO_SWITCH_ON_MASK");
    expect(hiwin_e_status_word_1_ready_to_switch_on(0x0001u) == true, "hiwin_e_status_word_1_ready_to_switch_on");
    expect(hiwin_e_status_word_1_ready_to_switch_on((uint16_t)~0x0001u) == false, "hiwin_e_status_word_1_ready_to_switch_on");
    expect(HIWIN_E_STATUS_WORD_1_READY_TO_OPERATE_MASK == 0x0002u, "HIWIN_E_STATUS_WORD_1_READY_TO_OPERATE_MASK");
    expect(hiwin_e_status_word_1_ready_to_operate(0x0002u) == true, "hiwin_e_status_word_1_ready_to_operate");
    expect(hiwin_e_status_word_1_ready_to_operate((uint16_t)~0x0002u) == false, "hiwin_e_status_word_1_ready_to_operate");
    expect(HIWIN_E_STATUS_WORD_1_OPERATION_ENABLED_MASK == 0x0004u, "HIWIN_E_STATUS_WORD_1_OPERATION_ENABLED_MASK");
    expect(hiwin_e_status_word_1_operation_enabled(0x0004u) == true, "hiwin_e_status_word_1_operation_enabled");
    expect(hiwin_e_status_word_1_operation_enabled((uint16_t)~0x0004u) == false, "hiwin_e_status_word_1_operation_enabled");
    expect(HIWIN_E_STATUS_WORD_1_ALARM_MASK == 0x0008u, "HIWIN_E_STATUS_WORD_1_ALARM_MASK");
    expect(hiwin_e_status_word_1_alarm(0x0008u) == true, "hiwin_e_status_word_1_alarm");
    expect(hiwin_e_status_word_1_alarm((uint16_t)~0x0008u) == false, "hiwin_e_status_word_1_alarm");
    expect(HIWIN_E_STATUS_WORD_1_NO_OFF2_MASK == 0x0010u, "HIWIN_E_STATUS_WORD_1_NO_OFF2_MASK");
    expect(hiwin_e_status_word_1_no_off2(0x0010u) == true, "hiwin_e_status_word_1_no_off2");
    expect(hiwin_e_status_word_1_no_off2((uint16_t)~0x0010u) == false, "hiwin_e_status_word_1_no_off2");
    expect(HIWIN_E_STATUS_WORD_1_NO_OFF3_MASK == 0x0020u, "HIWIN_E_STATUS_WORD_1_NO_OFF3_MASK");
    expect(hiwin_e_status_word_1_no_off3(0x0020u) == true, "hiwin_e_status_word_1_no_off3");
    expect(hiwin_e_status_word_1_no_off3((uint16_t)~0x0020u) == false, "hiwin_e_status_word_1_no_off3");
    expect(HIWIN_E_STATUS_WORD_1_SWITCHING_ON_INHIBITED_MASK == 0x0040u, "HIWIN_E_STATUS_WORD_1_SWITCHING_ON_INHIBITED_MASK");
    expect(hiwin_e_status_word_1_switching_on_inhibited(0x0040u) == true, "hiwin_e_status_word_1_switching_on_inhibited");
    expect(hiwin_e_status_word_1_switching_on_inhibited((uint16_t)~0x0040u) == false, "hiwin_e_status_word_1_switching_on_inhibited");
    expect(HIWIN_E_STATUS_WORD_1_WARNING_MASK == 0x0080u, "HIWIN_E_STATUS_WORD_1_WARNING_MASK");
    expect(hiwin_e_status_word_1_warning(0x0080u) == true, "hiwin_e_status_word_1_warning");
    expect(hiwin_e_status_word_1_warning((uint16_t)~0x0080u) == false, "hiwin_e_status_word_1_warning");
    expect(HIWIN_E_STATUS_WORD_1_SPEED_WITHIN_TOLERANCE_MASK == 0x0100u, "HIWIN_E_STATUS_WORD_1_SPEED_WITHIN_TOLERANCE_MASK");
    expect(hiwin_e_status_word_1_speed_within_tolerance(0x0100u) == true, "hiwin_e_status_word_1_speed_within_tolerance");
    expect(hiwin_e_status_word_1_speed_within_tolerance((uint16_t)~0x0100u) == false, "hiwin_e_status_word_1_speed_within_tolerance");
    expect(HIWIN_E_STATUS_WORD_1_CONTROL_REQUESTED_MASK == 0x0200u, "HIWIN_E_STATUS_WORD_1_CONTROL_REQUESTED_MASK");
    expect(hiwin_e_status_word_1_control_requested(0x0200u) == true, "hiwin_e_status_word_1_control_requested");
    expect(hiwin_e_status_word_1_control_requested((uint16_t)~0x0200u) == false, "hiwin_e_status_word_1_control_requested");
    expect(HIWIN_E_STATUS_WORD_1_SPEED_REACHED_MASK == 0x0400u, "HIWIN_E_STATUS_WORD_1_SPEED_REACHED_MASK");
    expect(hiwin_e_status_word_1_speed_reached(0x0400u) == true, "hiwin_e_status_word_1_speed_reached");
    expect(hiwin_e_status_word_1_speed_reached((uint16_t)~0x0400u) == false, "hiwin_e_status_word_1_speed_reached");
    expect(hiwin_e_status_word_1_state_of(0x0000u) == HIWIN_E_STATUS_WORD_1_NO_STATE, "hiwin_e_status_word_1_state_of 0x0");
    expect(hiwin_e_status_word_1_state_of(0x0001u) == HIWIN_E_STATUS_WORD_1_STATE_READY_FOR_SWITCHING_ON, "hiwin_e_status_word_1_state_of 0x1");
    expect(hiwin_e_status_word_1_state_of(0x0003u) == HIWIN_E_STATUS_WORD_1_STATE_SWITCHED_ON, "hiwin_e_status_word_1_state_of 0x3");
    expect(hiwin_e_status_word_1_state_of(0x0007u) == HIWIN_E_STATUS_WORD_1_STATE_OPERATION, "hiwin_e_status_word_1_state_of 0x7");
    expect(hiwin_e_status_word_1_state_of(0x0040u) == HIWIN_E_STATUS_WORD_1_STATE_SWITCHING_ON_INHIBITED, "hiwin_e_status_word_1_state_of 0x40");
    expect(hiwin_e_status_word_1_state_of(0xFFFFu) == HIWIN_E_STATUS_WORD_1_NO_STATE, "hiwin_e_status_word_1_state_of 0xffff");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_READY_TO_SWITCH_ON_MASK == 0x0001u, "HIWIN_E_STATUS_WORD_1_POSITIONING_READY_TO_SWITCH_ON_MASK");
    expect(hiwin_e_status_word_1_positioning_ready_to_switch_on(0x0001u) == true, "hiwin_e_status_word_1_positioning_ready_to_switch_on");
    expect(hiwin_e_status_word_1_positioning_ready_to_switch_on((uint16_t)~0x0001u) == false, "hiwin_e_status_word_1_positioning_ready_to_switch_on");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_READY_TO_OPERATE_MASK == 0x0002u, "HIWIN_E_STATUS_WORD_1_POSITIONING_READY_TO_OPERATE_MASK");
    expect(hiwin_e_status_word_1_positioning_ready_to_operate(0x0002u) == true, "hiwin_e_status_word_1_positioning_ready_to_operate");
    expect(hiwin_e_status_word_1_positioning_ready_to_operate((uint16_t)~0x0002u) == false, "hiwin_e_status_word_1_positioning_ready_to_operate");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_OPERATION_ENABLED_MASK == 0x0004u, "HIWIN_E_STATUS_WORD_1_POSITIONING_OPERATION_ENABLED_MASK");
    expect(hiwin_e_status_word_1_positioning_operation_enabled(0x0004u) == true, "hiwin_e_status_word_1_positioning_operation_enabled");
    expect(hiwin_e_status_word_1_positioning_operation_enabled((uint16_t)~0x0004u) == false, "hiwin_e_status_word_1_positioning_operation_enabled");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_ALARM_MASK == 0x0008u, "HIWIN_E_STATUS_WORD_1_POSITIONING_ALARM_MASK");
    expect(hiwin_e_status_word_1_positioning_alarm(0x0008u) == true, "hiwin_e_status_word_1_positioning_alarm");
    expect(hiwin_e_status_word_1_positioning_alarm((uint16_t)~0x0008u) == false, "hiwin_e_status_word_1_positioning_alarm");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_NO_OFF2_MASK == 0x0010u, "HIWIN_E_STATUS_WORD_1_POSITIONING_NO_OFF2_MASK");
    expect(hiwin_e_status_word_1_positioning_no_off2(0x0010u) == true, "hiwin_e_status_word_1_positioning_no_off2");
    expect(hiwin_e_status_word_1_positioning_no_off2((uint16_t)~0x0010u) == false, "hiwin_e_status_word_1_positioning_no_off2");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_NO_OFF3_MASK == 0x0020u, "HIWIN_E_STATUS_WORD_1_POSITIONING_NO_OFF3_MASK");
    expect(hiwin_e_status_word_1_positioning_no_off3(0x0020u) == true, "hiwin_e_status_word_1_positioning_no_off3");
    expect(hiwin_e_status_word_1_positioning_no_off3((uint16_t)~0x0020u) == false, "hiwin_e_status_word_1_positioning_no_off3");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_SWITCHING_ON_INHIBITED_MASK == 0x0040u, "HIWIN_E_STATUS_WORD_1_POSITIONING_SWITCHING_ON_INHIBITED_MASK");
    expect(hiwin_e_status_word_1_positioning_switching_on_inhibited(0x0040u) == true, "hiwin_e_status_word_1_positioning_switching_on_inhibited");
    expect(hiwin_e_status_word_1_positioning_switching_on_inhibited((uint16_t)~0x0040u) == false, "hiwin_e_status_word_1_positioning_switching_on_inhibited");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_WARNING_MASK == 0x0080u, "HIWIN_E_STATUS_WORD_1_POSITIONING_WARNING_MASK");
    expect(hiwin_e_status_word_1_positioning_warning(0x0080u) == true, "hiwin_e_status_word_1_positioning_warning");
    expect(hiwin_e_status_word_1_positioning_warning((uint16_t)~0x0080u) == false, "hiwin_e_status_word_1_positioning_warning");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_POSITION_WITHIN_TOLERANCE_MASK == 0x0100u, "HIWIN_E_STATUS_WORD_1_POSITIONING_POSITION_WITHIN_TOLERANCE_MASK");
    expect(hiwin_e_status_word_1_positioning_position_within_tolerance(0x0100u) == true, "hiwin_e_status_word_1_positioning_position_within_tolerance");
    expect(hiwin_e_status_word_1_positioning_position_within_tolerance((uint16_t)~0x0100u) == false, "hiwin_e_status_word_1_positioning_position_within_tolerance");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_CONTROL_REQUESTED_MASK == 0x0200u, "HIWIN_E_STATUS_WORD_1_POSITIONING_CONTROL_REQUESTED_MASK");
    expect(hiwin_e_status_word_1_positioning_control_requested(0x0200u) == true, "hiwin_e_status_word_1_positioning_control_requested");
    expect(hiwin_e_status_word_1_positioning_control_requested((uint16_t)~0x0200u) == false, "hiwin_e_status_word_1_positioning_control_requested");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_TARGET_REACHED_MASK == 0x0400u, "HIWIN_E_STATUS_WORD_1_POSITIONING_TARGET_REACHED_MASK");
    expect(hiwin_e_status_word_1_positioning_target_reached(0x0400u) == true, "hiwin_e_status_word_1_positioning_target_reached");
    expect(hiwin_e_status_word_1_positioning_target_reached((uint16_t)~0x0400u) == false, "hiwin_e_status_word_1_positioning_target_reached");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_HOMING_COMPLETE_MASK == 0x0800u, "HIWIN_E_STATUS_WORD_1_POSITIONING_HOMING_COMPLETE_MASK");
    expect(hiwin_e_status_word_1_positioning_homing_complete(0x0800u) == true, "hiwin_e_status_word_1_positioning_homing_complete");
    expect(hiwin_e_status_word_1_positioning_homing_complete((uint16_t)~0x0800u) == false, "hiwin_e_status_word_1_positioning_homing_complete");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_TRAVERSING_TASK_ACKNOWLEDGED_MASK == 0x1000u, "HIWIN_E_STATUS_WORD_1_POSITIONING_TRAVERSING_TASK_ACKNOWLEDGED_MASK");
    expect(hiwin_e_status_word_1_positioning_traversing_task_acknowledged(0x1000u) == true, "hiwin_e_status_word_1_positioning_traversing_task_acknowledged");
    expect(hiwin_e_status_word_1_positioning_traversing_task_acknowledged((uint16_t)~0x1000u) == false, "hiwin_e_status_word_1_positioning_traversing_task_acknowledged");
    expect(HIWIN_E_STATUS_WORD_1_POSITIONING_MOTOR_STOPPED_MASK == 0x2000u, "HIWIN_E_STATUS_WORD_1_POSITIONING_MOTOR_STOPPED_MASK");
    expect(hiwin_e_status_word_1_positioning_motor_stopped(0x2000u) == true, "hiwin_e_status_word_1_positioning_motor_stopped");
    expect(hiwin_e_status_word_1_positioning_motor_stopped((uint16_t)~0x2000u) == false, "hiwin_e_status_word_1_positioning_motor_stopped");
    expect(hiwin_e_status_word_1_positioning_state_of(0x0000u) == HIWIN_E_STATUS_WORD_1_POSITIONING_NO_STATE, "hiwin_e_status_word_1_positioning_state_of 0x0");
    expect(hiwin_e_status_word_1_positioning_state_of(0x0001u) == HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_READY_FOR_SWITCHING_ON, "hiwin_e_status_word_1_positioning_state_of 0x1");
    expect(hiwin_e_status_word_1_positioning_state_of(0x0003u) == HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHED_ON, "hiwin_e_status_word_1_positioning_state_of 0x3");
    expect(hiwin_e_status_word_1_positioning_state_of(0x0007u) == HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_OPERATION, "hiwin_e_status_word_1_positioning_state_of 0x7");
    expect(hiwin_e_status_word_1_positioning_state_of(0x0040u) == HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHING_ON_INHIBITED, "hiwin_e_status_word_1_positioning_state_of 0x40");
    expect(hiwin_e_status_word_1_positioning_state_of(0xFFFFu) == HIWIN_E_STATUS_WORD_1_POSITIONING_NO_STATE, "hiwin_e_status_word_1_positioning_state_of 0xffff");
    expect(HIWIN_E_STATUS_WORD_2_SIGN_OF_LIFE_MASK == 0xF000u, "HIWIN_E_STATUS_WORD_2_SIGN_OF_LIFE_MASK");
    expect(hiwin_e_status_word_2_sign_of_life(0xF000u) == 15u, "hiwin_e_status_word_2_sign_of_life");
    expect(hiwin_e_status_word_2_sign_of_life((uint16_t)~0xF000u) == 0, "hiwin_e_status_word_2_sign_of_life");
    expect(HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_PULSES_ENABLED_MASK == 0x0800u, "HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_PULSES_ENABLED_MASK");
    expect(hiwin_e_status_word_2_pulse_command_pulses_enabled(0x0800u) == true, "hiwin_e_status_word_2_pulse_command_pulses_enabled");
    expect(hiwin_e_status_word_2_pulse_command_pulses_enabled((uint16_t)~0x0800u) == false, "hiwin_e_status_word_2_pulse_command_pulses_enabled");
    expect(HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_SIGN_OF_LIFE_MASK == 0xF000u, "HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_SIGN_OF_LIFE_MASK");
    expect(hiwin_e_status_word_2_pulse_command_sign_of_life(0xF000u) == 15u, "hiwin_e_status_word_2_pulse_command_sign_of_life");
    expect(hiwin_e_status_word_2_pulse_command_sign_of_life((uint16_t)~0xF000u) == 0, "hiwin_e_status_word_2_pulse_command_sign_of_life");
    expect(HIWIN_E_STATUS_WORD_2_FIXED_STOP_TRAVERSE_TO_FIXED_STOP_ACTIVE_MASK == 0x0100u, "HIWIN_E_STATUS_WORD_2_FIXED_STOP_TRAVERSE_TO_FIXED_STOP_ACTIVE_MASK");
    expect(hiwin_e_status_word_2_fixed_stop_traverse_to_fixed_stop_active(0x0100u) == true, "hiwin_e_status_word_2_fixed_stop_traverse_to_fixed_stop_active");
    expect(hiwin_e_status_word_2_fixed_stop_traverse_to_fixed_stop_active((uint16_t)~0x0100u) == false, "hiwin_e_status_word_2_fixed_stop_traverse_to_fixed_stop_active");
    expect(HIWIN_E_STATUS_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK == 0xF000u, "HIWIN_E_STATUS_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK");
    expect(hiwin_e_status_word_2_fixed_stop_sign_of_life(0xF000u) == 15u, "hiwin_e_status_word_2_fixed_stop_sign_of_life");
    expect(hiwin_e_status_word_2_fixed_stop_sign_of_life((uint16_t)~0xF000u) == 0, "hiwin_e_status_word_2_fixed_stop_sign_of_life");
    expect(HIWIN_E_STATUS_WORD_2_POSITIONING_TRAVERSE_TO_FIXED_STOP_ACTIVE_MASK == 0x0100u, "HIWIN_E_STATUS_WORD_2_POSITIONING_TRAVERSE_TO_FIXED_STOP_ACTIVE_MASK");
    expect(hiwin_e_status_word_2_positioning_traverse_to_fixed_stop_active(0x0100u) == true, "hiwin_e_status_word_2_positioning_traverse_to_fixed_stop_active");
    expect(hiwin_e_status_word_2_positioning_traverse_to_fixed_stop_active((uint16_t)~0x0100u) == false, "hiwin_e_status_word_2_positioning_traverse_to_fixed_stop_active");
    expect(HIWIN_E_STATUS_WORD_2_POSITIONING_PULSES_ENABLED_MASK == 0x0800u, "HIWIN_E_STATUS_WORD_2_POSITIONING_PULSES_ENABLED_MASK");
    expect(hiwin_e_status_word_2_positioning_pulses_enabled(0x0800u) == true, "hiwin_e_status_word_2_positioning_pulses_enabled");
    expect(hiwin_e_status_word_2_positioning_pulses_enabled((uint16_t)~0x0800u) == false, "hiwin_e_status_word_2_positioning_pulses_enabled");
    expect(HIWIN_E_STATUS_WORD_2_POSITIONING_SIGN_OF_LIFE_MASK == 0xF000u, "HIWIN_E_STATUS_WORD_2_POSITIONING_SIGN_OF_LIFE_MASK");
    expect(hiwin_e_status_word_2_positioning_sign_of_life(0xF000u) == 15u, "hiwin_e_status_word_2_positioning_sign_of_life");
    expect(hiwin_e_status_word_2_positioning_sign_of_life((uint16_t)~0xF000u) == 0, "hiwin_e_status_word_2_positioning_sign_of_life");
    expect(HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_1_MASK == 0x0001u, "HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_1_MASK");
    expect(hiwin_e_encoder_1_control_word_function_1(0x0001u) == true, "hiwin_e_encoder_1_control_word_function_1");
    expect(hiwin_e_encoder_1_control_word_function_1((uint16_t)~0x0001u) == false, "hiwin_e_encoder_1_control_word_function_1");
    expect(HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_2_MASK == 0x0002u, "HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_2_MASK");
    expect(hiwin_e_encoder_1_control_word_function_2(0x0002u) == true, "hiwin_e_encoder_1_control_word_function_2");
    expect(hiwin_e_encoder_1_control_word_function_2((uint16_t)~0x0002u) == false, "hiwin_e_encoder_1_control_word_function_2");
    expect(HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_3_MASK == 0x0004u, "HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_3_MASK");
    expect(hiwin_e_encoder_1_control_word_function_3(0x0004u) == true, "hiwin_e_encoder_1_control_word_function_3");
    expect(hiwin_e_encoder_1_control_word_function_3((uint16_t)~0x0004u) == false, "hiwin_e_encoder_1_control_word_function_3");
    expect(HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_4_MASK == 0x0008u, "HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_4_MASK");
    expect(hiwin_e_encoder_1_control_word_function_4(0x0008u) == true, "hiwin_e_encoder_1_control_word_function_4");
    expect(hiwin_e_encoder_1_control_word_function_4((uint16_t)~0x0008u) == false, "hiwin_e_encoder_1_control_word_function_4");
    expect(HIWIN_E_ENCODER_1_CONTROL_WORD_COMMAND_MASK == 0x0070u, "HIWIN_E_ENCODER_1_CONTROL_WORD_COMMAND_MASK");
    expect(hiwin_e_encoder_1_control_word_command(0x0070u) == 7u, "hiwin_e_encoder_1_control_word_command");
    expect(hiwin_e_encoder_1_control_word_command((uint16_t)~0x0070u) == 0, "hiwin_e_encoder_1_control_word_command");
    expect(HIWIN_E_ENCODER_1_CONTROL_WORD_NO_REFERENCE_MARK_SEARCH_MASK == 0x0080u, "HIWIN_E_ENCODER_1_CONTROL_WORD_NO_REFERENCE_MARK_SEARCH_MASK");
    expect(hiwin_e_encoder_1_control_word_no_reference_mark_search(0x0080u) == true, "hiwin_e_encoder_1_control_word_no_reference_mark_search");
    expect(hiwin_e_encoder_1_control_word_no_reference_mark_search((uint16_t)~0x0080u) == false, "hiwin_e_encoder_1_control_word_no_reference_mark_search");
    expect(HIWIN_E_ENCODER_1_CONTROL_WORD_PARKING_SENSOR_MASK == 0x4000u, "HIWIN_E_ENCODER_1_CONTROL_WORD_PARKING_SENSOR_MASK");
    expect(hiwin_e_encoder_1_control_word_parking_sensor(0x4000u) == true, "hiwin_e_encoder_1_control_word_parking_sensor");
    expect(hiwin_e_encoder_1_control_word_parking_sensor((uint16_t)~0x4000u) == false, "hiwin_e_encoder_1_control_word_parking_sensor");
    expect(HIWIN_E_ENCODER_1_CONTROL_WORD_ACKNOWLEDGE_ALARM_MASK == 0x8000u, "HIWIN_E_ENCODER_1_CONTROL_WORD_ACKNOWLEDGE_ALARM_MASK");
    expect(hiwin_e_encoder_1_control_word_acknowledge_alarm(0x8000u) == true, "hiwin_e_encoder_1_control_word_acknowledge_alarm");
    expect(hiwin_e_encoder_1_control_word_acknowledge_alarm((uint16_t)~0x8000u) == false, "hiwin_e_encoder_1_control_word_acknowledge_alarm");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_1_ACTIVE_MASK == 0x0001u, "HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_1_ACTIVE_MASK");
    expect(hiwin_e_encoder_1_status_word_function_1_active(0x0001u) == true, "hiwin_e_encoder_1_status_word_function_1_active");
    expect(hiwin_e_encoder_1_status_word_function_1_active((uint16_t)~0x0001u) == false, "hiwin_e_encoder_1_status_word_function_1_active");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_2_ACTIVE_MASK == 0x0002u, "HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_2_ACTIVE_MASK");
    expect(hiwin_e_encoder_1_status_word_function_2_active(0x0002u) == true, "hiwin_e_encoder_1_status_word_function_2_active");
    expect(hiwin_e_encoder_1_status_word_function_2_active((uint16_t)~0x0002u) == false, "hiwin_e_encoder_1_status_word_function_2_active");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_3_ACTIVE_MASK == 0x0004u, "HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_3_ACTIVE_MASK");
    expect(hiwin_e_encoder_1_status_word_function_3_active(0x0004u) == true, "hiwin_e_encoder_1_status_word_function_3_active");
    expect(hiwin_e_encoder_1_status_word_function_3_active((uint16_t)~0x0004u) == false, "hiwin_e_encoder_1_status_word_function_3_active");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_4_ACTIVE_MASK == 0x0008u, "HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_4_ACTIVE_MASK");
    expect(hiwin_e_encoder_1_status_word_function_4_active(0x0008u) == true, "hiwin_e_encoder_1_status_word_function_4_active");
    expect(hiwin_e_encoder_1_status_word_function_4_active((uint16_t)~0x0008u) == false, "hiwin_e_encoder_1_status_word_function_4_active");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_1_AVAILABLE_MASK == 0x0010u, "HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_1_AVAILABLE_MASK");
    expect(hiwin_e_encoder_1_status_word_value_1_available(0x0010u) == true, "hiwin_e_encoder_1_status_word_value_1_available");
    expect(hiwin_e_encoder_1_status_word_value_1_available((uint16_t)~0x0010u) == false, "hiwin_e_encoder_1_status_word_value_1_available");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_2_AVAILABLE_MASK == 0x0020u, "HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_2_AVAILABLE_MASK");
    expect(hiwin_e_encoder_1_status_word_value_2_available(0x0020u) == true, "hiwin_e_encoder_1_status_word_value_2_available");
    expect(hiwin_e_encoder_1_status_word_value_2_available((uint16_t)~0x0020u) == false, "hiwin_e_encoder_1_status_word_value_2_available");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_3_AVAILABLE_MASK == 0x0040u, "HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_3_AVAILABLE_MASK");
    expect(hiwin_e_encoder_1_status_word_value_3_available(0x0040u) == true, "hiwin_e_encoder_1_status_word_value_3_available");
    expect(hiwin_e_encoder_1_status_word_value_3_available((uint16_t)~0x0040u) == false, "hiwin_e_encoder_1_status_word_value_3_available");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_4_AVAILABLE_MASK == 0x0080u, "HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_4_AVAILABLE_MASK");
    expect(hiwin_e_encoder_1_status_word_value_4_available(0x0080u) == true, "hiwin_e_encoder_1_status_word_value_4_available");
    expect(hiwin_e_encoder_1_status_word_value_4_available((uint16_t)~0x0080u) == false, "hiwin_e_encoder_1_status_word_value_4_available");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_ACKNOWLEDGING_ALARM_MASK == 0x0800u, "HIWIN_E_ENCODER_1_STATUS_WORD_ACKNOWLEDGING_ALARM_MASK");
    expect(hiwin_e_encoder_1_status_word_acknowledging_alarm(0x0800u) == true, "hiwin_e_encoder_1_status_word_acknowledging_alarm");
    expect(hiwin_e_encoder_1_status_word_acknowledging_alarm((uint16_t)~0x0800u) == false, "hiwin_e_encoder_1_status_word_acknowledging_alarm");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_SENSOR_PARKED_MASK == 0x4000u, "HIWIN_E_ENCODER_1_STATUS_WORD_SENSOR_PARKED_MASK");
    expect(hiwin_e_encoder_1_status_word_sensor_parked(0x4000u) == true, "hiwin_e_encoder_1_status_word_sensor_parked");
    expect(hiwin_e_encoder_1_status_word_sensor_parked((uint16_t)~0x4000u) == false, "hiwin_e_encoder_1_status_word_sensor_parked");
    expect(HIWIN_E_ENCODER_1_STATUS_WORD_ALARM_MASK == 0x8000u, "HIWIN_E_ENCODER_1_STATUS_WORD_ALARM_MASK");
    expect(hiwin_e_encoder_1_status_word_alarm(0x8000u) == true, "hiwin_e_encoder_1_status_word_alarm");
    expect(hiwin_e_encoder_1_status_word_alarm((uint16_t)~0x8000u) == false, "hiwin_e_encoder_1_status_word_alarm");
    expect(HIWIN_E_BLOCK_SELECTION_MDI_MASK == 0x8000u, "HIWIN_E_BLOCK_SELECTION_MDI_MASK");
    expect(hiwin_e_block_selection_mdi(0x8000u) == true, "hiwin_e_block_selection_mdi");
    expect(hiwin_e_block_selection_mdi((uint16_t)~0x8000u) == false, "hiwin_e_block_selection_mdi");
    expect(HIWIN_E_SELECTED_BLOCK_MDI_MASK == 0x8000u, "HIWIN_E_SELECTED_BLOCK_MDI_MASK");
    expect(hiwin_e_selected_block_mdi(0x8000u) == true, "hiwin_e_selected_block_mdi");
    expect(hiwin_e_selected_block_mdi((uint16_t)~0x8000u) == false, "hiwin_e_selected_block_mdi");
    expect(HIWIN_E_MDI_MODE_ABSOLUTE_MASK == 0x0001u, "HIWIN_E_MDI_MODE_ABSOLUTE_MASK");
    expect(hiwin_e_mdi_mode_absolute(0x0001u) == true, "hiwin_e_mdi_mode_absolute");
    expect(hiwin_e_mdi_mode_absolute((uint16_t)~0x0001u) == false, "hiwin_e_mdi_mode_absolute");
    expect(HIWIN_E_POSITIONING_CONTROL_WORD_1_ABSOLUTE_MASK == 0x0100u, "HIWIN_E_POSITIONING_CONTROL_WORD_1_ABSOLUTE_MASK");
    expect(hiwin_e_positioning_control_word_1_absolute(0x0100u) == true, "hiwin_e_positioning_control_word_1_absolute");
    expect(hiwin_e_positioning_control_word_1_absolute((uint16_t)~0x0100u) == false, "hiwin_e_positioning_control_word_1_absolute");
    expect(HIWIN_E_POSITIONING_CONTROL_WORD_1_PATH_MASK == 0x0600u, "HIWIN_E_POSITIONING_CONTROL_WORD_1_PATH_MASK");
    expect(hiwin_e_positioning_control_word_1_path(0x0600u) == 3u, "hiwin_e_positioning_control_word_1_path");
    expect(hiwin_e_positioning_control_word_1_path((uint16_t)~0x0600u) == 0, "hiwin_e_positioning_control_word_1_path");
    expect(HIWIN_E_POSITIONING_CONTROL_WORD_1_CONTINUOUS_MASK == 0x1000u, "HIWIN_E_POSITIONING_CONTROL_WORD_1_CONTINUOUS_MASK");
    expect(hiwin_e_positioning_control_word_1_continuous(0x1000u) == true, "hiwin_e_positioning_control_word_1_continuous");
    expect(hiwin_e_positioning_control_word_1_continuous((uint16_t)~0x1000u) == false, "hiwin_e_positioning_control_word_1_continuous");
    expect(HIWIN_E_POSITIONING_CONTROL_WORD_1_MDI_SETUP_MASK == 0x4000u, "HIWIN_E_POSITIONING_CONTROL_WORD_1_MDI_SETUP_MASK");
    expect(hiwin_e_positioning_control_word_1_mdi_setup(0x4000u) == true, "hiwin_e_positioning_control_word_1_mdi_setup");
    expect(hiwin_e_positioning_control_word_1_mdi_setup((uint16_t)~0x4000u) == false, "hiwin_e_positioning_control_word_1_mdi_setup");
    expect(HIWIN_E_POSITIONING_CONTROL_WORD_1_MDI_MASK == 0x8000u, "HIWIN_E_POSITIONING_CONTROL_WORD_1_MDI_MASK");
    expect(hiwin_e_positioning_control_word_1_mdi(0x8000u) == true, "hiwin_e_positioning_control_word_1_mdi");
    expect(hiwin_e_positioning_control_word_1_mdi((uint16_t)~0x8000u) == false, "hiwin_e_positioning_control_word_1_mdi");
    expect(HIWIN_E_POSITIONING_CONTROL_WORD_2_SET_REFERENCE_POINT_MASK == 0x0002u, "HIWIN_E_POSITIONING_CONTROL_WORD_2_SET_REFERENCE_POINT_MASK");
    expect(hiwin_e_positioning_control_word_2_set_reference_point(0x0002u) == true, "hiwin_e_positioning_control_word_2_set_reference_point");
    expect(hiwin_e_positioning_control_word_2_set_reference_point((uint16_t)~0x0002u) == false, "hiwin_e_positioning_control_word_2_set_reference_point");
    expect(HIWIN_E_POSITIONING_CONTROL_WORD_2_JOG_INCREMENTAL_MASK == 0x0020u, "HIWIN_E_POSITIONING_CONTROL_WORD_2_JOG_INCREMENTAL_MASK");
    expect(hiwin_e_positioning_control_word_2_jog_incremental(0x0020u) == true, "hiwin_e_positioning_control_word_2_jog_incremental");
    expect(hiwin_e_positioning_control_word_2_jog_incremental((uint16_t)~0x0020u) == false, "hiwin_e_positioning_control_word_2_jog_incremental");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_1_NEGATIVE_OVERTRAVEL_MASK == 0x0100u, "HIWIN_E_POSITIONING_STATUS_WORD_1_NEGATIVE_OVERTRAVEL_MASK");
    expect(hiwin_e_positioning_status_word_1_negative_overtravel(0x0100u) == true, "hiwin_e_positioning_status_word_1_negative_overtravel");
    expect(hiwin_e_positioning_status_word_1_negative_overtravel((uint16_t)~0x0100u) == false, "hiwin_e_positioning_status_word_1_negative_overtravel");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_1_POSITIVE_OVERTRAVEL_MASK == 0x0200u, "HIWIN_E_POSITIONING_STATUS_WORD_1_POSITIVE_OVERTRAVEL_MASK");
    expect(hiwin_e_positioning_status_word_1_positive_overtravel(0x0200u) == true, "hiwin_e_positioning_status_word_1_positive_overtravel");
    expect(hiwin_e_positioning_status_word_1_positive_overtravel((uint16_t)~0x0200u) == false, "hiwin_e_positioning_status_word_1_positive_overtravel");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_1_JOGGING_MASK == 0x0400u, "HIWIN_E_POSITIONING_STATUS_WORD_1_JOGGING_MASK");
    expect(hiwin_e_positioning_status_word_1_jogging(0x0400u) == true, "hiwin_e_positioning_status_word_1_jogging");
    expect(hiwin_e_positioning_status_word_1_jogging((uint16_t)~0x0400u) == false, "hiwin_e_positioning_status_word_1_jogging");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_1_HOMING_MASK == 0x0800u, "HIWIN_E_POSITIONING_STATUS_WORD_1_HOMING_MASK");
    expect(hiwin_e_positioning_status_word_1_homing(0x0800u) == true, "hiwin_e_positioning_status_word_1_homing");
    expect(hiwin_e_positioning_status_word_1_homing((uint16_t)~0x0800u) == false, "hiwin_e_positioning_status_word_1_homing");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_1_MDI_SETUP_MASK == 0x4000u, "HIWIN_E_POSITIONING_STATUS_WORD_1_MDI_SETUP_MASK");
    expect(hiwin_e_positioning_status_word_1_mdi_setup(0x4000u) == true, "hiwin_e_positioning_status_word_1_mdi_setup");
    expect(hiwin_e_positioning_status_word_1_mdi_setup((uint16_t)~0x4000u) == false, "hiwin_e_positioning_status_word_1_mdi_setup");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_1_MDI_MASK == 0x8000u, "HIWIN_E_POSITIONING_STATUS_WORD_1_MDI_MASK");
    expect(hiwin_e_positioning_status_word_1_mdi(0x8000u) == true, "hiwin_e_positioning_status_word_1_mdi");
    expect(hiwin_e_positioning_status_word_1_mdi((uint16_t)~0x8000u) == false, "hiwin_e_positioning_status_word_1_mdi");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_2_READY_FOR_COMMAND_MASK == 0x0004u, "HIWIN_E_POSITIONING_STATUS_WORD_2_READY_FOR_COMMAND_MASK");
    expect(hiwin_e_positioning_status_word_2_ready_for_command(0x0004u) == true, "hiwin_e_positioning_status_word_2_ready_for_command");
    expect(hiwin_e_positioning_status_word_2_ready_for_command((uint16_t)~0x0004u) == false, "hiwin_e_positioning_status_word_2_ready_for_command");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_2_MOVING_FORWARD_MASK == 0x0010u, "HIWIN_E_POSITIONING_STATUS_WORD_2_MOVING_FORWARD_MASK");
    expect(hiwin_e_positioning_status_word_2_moving_forward(0x0010u) == true, "hiwin_e_positioning_status_word_2_moving_forward");
    expect(hiwin_e_positioning_status_word_2_moving_forward((uint16_t)~0x0010u) == false, "hiwin_e_positioning_status_word_2_moving_forward");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_2_MOVING_BACKWARD_MASK == 0x0020u, "HIWIN_E_POSITIONING_STATUS_WORD_2_MOVING_BACKWARD_MASK");
    expect(hiwin_e_positioning_status_word_2_moving_backward(0x0020u) == true, "hiwin_e_positioning_status_word_2_moving_backward");
    expect(hiwin_e_positioning_status_word_2_moving_backward((uint16_t)~0x0020u) == false, "hiwin_e_positioning_status_word_2_moving_backward");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_2_FIXED_STOP_REACHED_MASK == 0x1000u, "HIWIN_E_POSITIONING_STATUS_WORD_2_FIXED_STOP_REACHED_MASK");
    expect(hiwin_e_positioning_status_word_2_fixed_stop_reached(0x1000u) == true, "hiwin_e_positioning_status_word_2_fixed_stop_reached");
    expect(hiwin_e_positioning_status_word_2_fixed_stop_reached((uint16_t)~0x1000u) == false, "hiwin_e_positioning_status_word_2_fixed_stop_reached");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_2_FIXED_STOP_TORQUE_REACHED_MASK == 0x2000u, "HIWIN_E_POSITIONING_STATUS_WORD_2_FIXED_STOP_TORQUE_REACHED_MASK");
    expect(hiwin_e_positioning_status_word_2_fixed_stop_torque_reached(0x2000u) == true, "hiwin_e_positioning_status_word_2_fixed_stop_torque_reached");
    expect(hiwin_e_positioning_status_word_2_fixed_stop_torque_reached((uint16_t)~0x2000u) == false, "hiwin_e_positioning_status_word_2_fixed_stop_torque_reached");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_2_TRAVERSE_TO_FIXED_STOP_ENABLED_MASK == 0x4000u, "HIWIN_E_POSITIONING_STATUS_WORD_2_TRAVERSE_TO_FIXED_STOP_ENABLED_MASK");
    expect(hiwin_e_positioning_status_word_2_traverse_to_fixed_stop_enabled(0x4000u) == true, "hiwin_e_positioning_status_word_2_traverse_to_fixed_stop_enabled");
    expect(hiwin_e_positioning_status_word_2_traverse_to_fixed_stop_enabled((uint16_t)~0x4000u) == false, "hiwin_e_positioning_status_word_2_traverse_to_fixed_stop_enabled");
    expect(HIWIN_E_POSITIONING_STATUS_WORD_2_TRAVERSING_COMMAND_ACTIVE_MASK == 0x8000u, "HIWIN_E_POSITIONING_STATUS_WORD_2_TRAVERSING_COMMAND_ACTIVE_MASK");
    expect(hiwin_e_positioning_status_word_2_traversing_command_active(0x8000u) == true, "hiwin_e_positioning_status_word_2_traversing_command_active");
    expect(hiwin_e_positioning_status_word_2_traversing_command_active((uint16_t)~0x8000u) == false, "hiwin_e_positioning_status_word_2_traversing_command_active");
    expect(HIWIN_E_MESSAGE_WORD_TORQUE_LIMIT_NOT_ACTIVE_MASK == 0x0002u, "HIWIN_E_MESSAGE_WORD_TORQUE_LIMIT_NOT_ACTIVE_MASK");
    expect(hiwin_e_message_word_torque_limit_not_active(0x0002u) == true, "hiwin_e_message_word_torque_limit_not_active");
    expect(hiwin_e_message_word_torque_limit_not_active((uint16_t)~0x0002u) == false, "hiwin_e_message_word_torque_limit_not_active");
    expect(HIWIN_E_MESSAGE_WORD_NO_MOTOR_OVERLOAD_WARNING_MASK == 0x0040u, "HIWIN_E_MESSAGE_WORD_NO_MOTOR_OVERLOAD_WARNING_MASK");
    expect(hiwin_e_message_word_no_motor_overload_warning(0x0040u) == true, "hiwin_e_message_word_no_motor_overload_warning");
    expect(hiwin_e_message_word_no_motor_overload_warning((uint16_t)~0x0040u) == false, "hiwin_e_message_word_no_motor_overload_warning");
    expect(HIWIN_E_MESSAGE_WORD_NO_I2T_WARNING_MASK == 0x0080u, "HIWIN_E_MESSAGE_WORD_NO_I2T_WARNING_MASK");
    expect(hiwin_e_message_word_no_i2t_warning(0x0080u) == true, "hiwin_e_message_word_no_i2t_warning");
    expect(hiwin_e_message_word_no_i2t_warning((uint16_t)~0x0080u) == false, "hiwin_e_message_word_no_i2t_warning");
    expect(HIWIN_E_MESSAGE_WORD_SPEED_WITHIN_TOLERANCE_MASK == 0x0100u, "HIWIN_E_MESSAGE_WORD_SPEED_WITHIN_TOLERANCE_MASK");
    expect(hiwin_e_message_word_speed_within_tolerance(0x0100u) == true, "hiwin_e_message_word_speed_within_tolerance");
    expect(hiwin_e_message_word_speed_within_tolerance((uint16_t)~0x0100u) == false, "hiwin_e_message_word_speed_within_tolerance");
    expect(HIWIN_E_MESSAGE_WORD_CONTROLLED_BY_PLC_MASK == 0x0800u, "HIWIN_E_MESSAGE_WORD_CONTROLLED_BY_PLC_MASK");
    expect(hiwin_e_message_word_controlled_by_plc(0x0800u) == true, "hiwin_e_message_word_controlled_by_plc");
    expect(hiwin_e_message_word_controlled_by_plc((uint16_t)~0x0800u) == false, "hiwin_e_message_word_controlled_by_plc");
    expect(HIWIN_E_MESSAGE_WORD_DRIVE_READY_MASK == 0x1000u, "HIWIN_E_MESSAGE_WORD_DRIVE_READY_MASK");
    expect(hiwin_e_message_word_drive_ready(0x1000u) == true, "hiwin_e_message_word_drive_ready");
    expect(hiwin_e_message_word_drive_ready((uint16_t)~0x1000u) == false, "hiwin_e_message_word_drive_ready");
    expect(HIWIN_E_MESSAGE_WORD_PULSES_ENABLED_MASK == 0x2000u, "HIWIN_E_MESSAGE_WORD_PULSES_ENABLED_MASK");
    expect(hiwin_e_message_word_pulses_enabled(0x2000u) == true, "hiwin_e_message_word_pulses_enabled");
    expect(hiwin_e_message_word_pulses_enabled((uint16_t)~0x2000u) == false, "hiwin_e_message_word_pulses_enabled");
}

static void test_1(void)
{
    expect(hiwin_e_parameter_format_known(INT64_C(1)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(2)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(3)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(4)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(5)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(6)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(7)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(8)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(65)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(66)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(67)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(68)) == true, "hiwin_e_parameter_format_known");
    expect(hiwin_e_parameter_format_known(INT64_C(69)) == false, "hiwin_e_parameter_format_known");
    expect(hiwin_e_motor_type_known(INT64_C(0)) == true, "hiwin_e_motor_type_known");
    expect(hiwin_e_motor_type_known(INT64_C(1)) == true, "hiwin_e_motor_type_known");
    expect(hiwin_e_motor_type_known(INT64_C(2)) == true, "hiwin_e_motor_type_known");
    expect(hiwin_e_motor_type_known(INT64_C(3)) == false, "hiwin_e_motor_type_known");
    expect(hiwin_e_gantry_application_mode_known(INT64_C(1)) == true, "hiwin_e_gantry_application_mode_known");
    expect(hiwin_e_gantry_application_mode_known(INT64_C(2)) == true, "hiwin_e_gantry_application_mode_known");
    expect(hiwin_e_gantry_application_mode_known(INT64_C(11)) == true, "hiwin_e_gantry_application_mode_known");
    expect(hiwin_e_gantry_application_mode_known(INT64_C(12)) == false, "hiwin_e_gantry_application_mode_known");
    expect(hiwin_e_gantry_parameter_command_known(INT64_C(0)) == true, "hiwin_e_gantry_parameter_command_known");
    expect(hiwin_e_gantry_parameter_command_known(INT64_C(1)) == true, "hiwin_e_gantry_parameter_command_known");
    expect(hiwin_e_gantry_parameter_command_known(INT64_C(2)) == true, "hiwin_e_gantry_parameter_command_known");
    expect(hiwin_e_gantry_parameter_command_known(INT64_C(3)) == true, "hiwin_e_gantry_parameter_command_known");
    expect(hiwin_e_gantry_parameter_command_known(INT64_C(4)) == false, "hiwin_e_gantry_parameter_command_known");
    expect(hiwin_e_gantry_parameter_status_known((-INT64_C(6))) == true, "hiwin_e_gantry_parameter_status_known");
    expect(hiwin_e_gantry_parameter_status_known((-INT64_C(5))) == true, "hiwin_e_gantry_parameter_status_known");
    expect(hiwin_e_gantry_parameter_status_known((-INT64_C(4))) == true, "hiwin_e_gantry_parameter_status_known");
    expect(hiwin_e_gantry_parameter_status_known((-INT64_C(3))) == true, "hiwin_e_gantry_parameter_status_known");
    expect(hiwin_e_gantry_parameter_status_known((-INT64_C(2))) == true, "hiwin_e_gantry_parameter_status_known");
    expect(hiwin_e_gantry_parameter_status_known((-INT64_C(1))) == true, "hiwin_e_gantry_parameter_status_known");
    expect(hiwin_e_gantry_parameter_status_known(INT64_C(0)) == true, "hiwin_e_gantry_parameter_status_known");
    expect(hiwin_e_gantry_parameter_status_known(INT64_C(1)) == true, "hiwin_e_gantry_parameter_status_known");
    expect(hiwin_e_gantry_parameter_status_known(INT64_C(2)) == true, "hiwin_e_gantry_parameter_status_known");
    expect(hiwin_e_gantry_parameter_status_known(INT64_C(3)) == false, "hiwin_e_gantry_parameter_status_known");
    expect(hiwin_e_absolute_encoder_initialization_known(INT64_C(0)) == true, "hiwin_e_absolute_encoder_initialization_known");
    expect(hiwin_e_absolute_encoder_initialization_known(INT64_C(1)) == true, "hiwin_e_absolute_encoder_initialization_known");
    expect(hiwin_e_absolute_encoder_initialization_known(INT64_C(2)) == true, "hiwin_e_absolute_encoder_initialization_known");
    expect(hiwin_e_absolute_encoder_initialization_known(INT64_C(4)) == true, "hiwin_e_absolute_encoder_initialization_known");
    expect(hiwin_e_absolute_encoder_initialization_known(INT64_C(16)) == true, "hiwin_e_absolute_encoder_initialization_known");
    expect(hiwin_e_absolute_encoder_initialization_known(INT64_C(32)) == true, "hiwin_e_absolute_encoder_initialization_known");
    expect(hiwin_e_absolute_encoder_initialization_known(INT64_C(33)) == false, "hiwin_e_absolute_encoder_initialization_known");
    expect(hiwin_e_drive_reset_known((-INT64_C(1))) == true, "hiwin_e_drive_reset_known");
    expect(hiwin_e_drive_reset_known(INT64_C(0)) == true, "hiwin_e_drive_reset_known");
    expect(hiwin_e_drive_reset_known(INT64_C(1)) == true, "hiwin_e_drive_reset_known");
    expect(hiwin_e_drive_reset_known(INT64_C(2)) == true, "hiwin_e_drive_reset_known");
    expect(hiwin_e_drive_reset_known(INT64_C(3)) == false, "hiwin_e_drive_reset_known");
    expect(hiwin_e_parameter_save_known(INT64_C(0)) == true, "hiwin_e_parameter_save_known");
    expect(hiwin_e_parameter_save_known(INT64_C(1)) == true, "hiwin_e_parameter_save_known");
    expect(hiwin_e_parameter_save_known(INT64_C(2)) == false, "hiwin_e_parameter_save_known");
    expect(hiwin_e_mastership_known(INT64_C(0)) == true, "hiwin_e_mastership_known");
    expect(hiwin_e_mastership_known(INT64_C(1)) == true, "hiwin_e_mastership_known");
    expect(hiwin_e_mastership_known(INT64_C(2)) == false, "hiwin_e_mastership_known");
    expect(hiwin_e_operating_mode_known(INT64_C(1)) == true, "hiwin_e_operating_mode_known");
    expect(hiwin_e_operating_mode_known(INT64_C(2)) == true, "hiwin_e_operating_mode_known");
    expect(hiwin_e_operating_mode_known(INT64_C(3)) == true, "hiwin_e_operating_mode_known");
    expect(hiwin_e_operating_mode_known(INT64_C(4)) == false, "hiwin_e_operating_mode_known");
    expect(hiwin_e_coast_stop_method_known(INT64_C(0)) == true, "hiwin_e_coast_stop_method_known");
    expect(hiwin_e_coast_stop_method_known(INT64_C(1)) == true, "hiwin_e_coast_stop_method_known");
    expect(hiwin_e_coast_stop_method_known(INT64_C(2)) == true, "hiwin_e_coast_stop_method_known");
    expect(hiwin_e_coast_stop_method_known(INT64_C(3)) == false, "hiwin_e_coast_stop_method_known");
    expect(hiwin_e_positioning_path_known(INT64_C(0)) == true, "hiwin_e_positioning_path_known");
    expect(hiwin_e_positioning_path_known(INT64_C(1)) == true, "hiwin_e_positioning_path_known");
    expect(hiwin_e_positioning_path_known(INT64_C(2)) == true, "hiwin_e_positioning_path_known");
    expect(hiwin_e_positioning_path_known(INT64_C(3)) == true, "hiwin_e_positioning_path_known");
    expect(hiwin_e_positioning_path_known(INT64_C(4)) == false, "hiwin_e_positioning_path_known");
}

static void test_2(void)
{
    expect(hiwin_e_alarm_code_text(INT64_C(36)) != NULL && hiwin_e_alarm_code_text(INT64_C(36))->number == INT64_C(4) && same_text(hiwin_e_alarm_code_text(INT64_C(36))->name, "system_alarm_1") && same_text(hiwin_e_alarm_code_text(INT64_C(36))->printed, "AL.024"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(37)) != NULL && hiwin_e_alarm_code_text(INT64_C(37))->number == INT64_C(5) && same_text(hiwin_e_alarm_code_text(INT64_C(37))->name, "system_alarm_2") && same_text(hiwin_e_alarm_code_text(INT64_C(37))->printed, "AL.025"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(48)) != NULL && hiwin_e_alarm_code_text(INT64_C(48))->number == INT64_C(6) && same_text(hiwin_e_alarm_code_text(INT64_C(48))->name, "main_circuit_fault") && same_text(hiwin_e_alarm_code_text(INT64_C(48))->printed, "AL.030"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(64)) != NULL && hiwin_e_alarm_code_text(INT64_C(64))->number == INT64_C(7) && same_text(hiwin_e_alarm_code_text(INT64_C(64))->name, "parameter_setting_error") && same_text(hiwin_e_alarm_code_text(INT64_C(64))->printed, "AL.040"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(80)) != NULL && hiwin_e_alarm_code_text(INT64_C(80))->number == INT64_C(11) && same_text(hiwin_e_alarm_code_text(INT64_C(80))->name, "combination_error") && same_text(hiwin_e_alarm_code_text(INT64_C(80))->printed, "AL.050"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(112)) != NULL && hiwin_e_alarm_code_text(INT64_C(112))->number == INT64_C(12) && same_text(hiwin_e_alarm_code_text(INT64_C(112))->name, "motor_change_detected") && same_text(hiwin_e_alarm_code_text(INT64_C(112))->printed, "AL.070"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(176)) != NULL && hiwin_e_alarm_code_text(INT64_C(176))->number == INT64_C(14) && same_text(hiwin_e_alarm_code_text(INT64_C(176))->name, "servo_on_command_invalid") && same_text(hiwin_e_alarm_code_text(INT64_C(176))->printed, "AL.0b0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(256)) != NULL && hiwin_e_alarm_code_text(INT64_C(256))->number == INT64_C(15) && same_text(hiwin_e_alarm_code_text(INT64_C(256))->name, "overcurrent") && same_text(hiwin_e_alarm_code_text(INT64_C(256))->printed, "AL.100"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(800)) != NULL && hiwin_e_alarm_code_text(INT64_C(800))->number == INT64_C(16) && same_text(hiwin_e_alarm_code_text(INT64_C(800))->name, "regenerative_energy_overload") && same_text(hiwin_e_alarm_code_text(INT64_C(800))->printed, "AL.320"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(1024)) != NULL && hiwin_e_alarm_code_text(INT64_C(1024))->number == INT64_C(17) && same_text(hiwin_e_alarm_code_text(INT64_C(1024))->name, "overvoltage") && same_text(hiwin_e_alarm_code_text(INT64_C(1024))->printed, "AL.400"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(1040)) != NULL && hiwin_e_alarm_code_text(INT64_C(1040))->number == INT64_C(18) && same_text(hiwin_e_alarm_code_text(INT64_C(1040))->name, "undervoltage") && same_text(hiwin_e_alarm_code_text(INT64_C(1040))->printed, "AL.410"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(1296)) != NULL && hiwin_e_alarm_code_text(INT64_C(1296))->number == INT64_C(19) && same_text(hiwin_e_alarm_code_text(INT64_C(1296))->name, "overspeed") && same_text(hiwin_e_alarm_code_text(INT64_C(1296))->printed, "AL.510"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(1297)) != NULL && hiwin_e_alarm_code_text(INT64_C(1297))->number == INT64_C(20) && same_text(hiwin_e_alarm_code_text(INT64_C(1297))->name, "encoder_pulse_output_overspeed") && same_text(hiwin_e_alarm_code_text(INT64_C(1297))->printed, "AL.511"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(1808)) != NULL && hiwin_e_alarm_code_text(INT64_C(1808))->number == INT64_C(24) && same_text(hiwin_e_alarm_code_text(INT64_C(1808))->name, "momentary_overload") && same_text(hiwin_e_alarm_code_text(INT64_C(1808))->printed, "AL.710"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(1824)) != NULL && hiwin_e_alarm_code_text(INT64_C(1824))->number == INT64_C(25) && same_text(hiwin_e_alarm_code_text(INT64_C(1824))->name, "continuous_overload") && same_text(hiwin_e_alarm_code_text(INT64_C(1824))->printed, "AL.720"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(1953)) != NULL && hiwin_e_alarm_code_text(INT64_C(1953))->number == INT64_C(29) && same_text(hiwin_e_alarm_code_text(INT64_C(1953))->name, "drive_overload") && same_text(hiwin_e_alarm_code_text(INT64_C(1953))->printed, "AL.7A1"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(1954)) != NULL && hiwin_e_alarm_code_text(INT64_C(1954))->number == INT64_C(30) && same_text(hiwin_e_alarm_code_text(INT64_C(1954))->name, "power_board_temperature") && same_text(hiwin_e_alarm_code_text(INT64_C(1954))->printed, "AL.7A2"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2048)) != NULL && hiwin_e_alarm_code_text(INT64_C(2048))->number == INT64_C(33) && same_text(hiwin_e_alarm_code_text(INT64_C(2048))->name, "encoder_absolute_position_lost") && same_text(hiwin_e_alarm_code_text(INT64_C(2048))->printed, "AL.800"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2064)) != NULL && hiwin_e_alarm_code_text(INT64_C(2064))->number == INT64_C(34) && same_text(hiwin_e_alarm_code_text(INT64_C(2064))->name, "encoder_battery_voltage_low") && same_text(hiwin_e_alarm_code_text(INT64_C(2064))->printed, "AL.810"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2080)) != NULL && hiwin_e_alarm_code_text(INT64_C(2080))->number == INT64_C(35) && same_text(hiwin_e_alarm_code_text(INT64_C(2080))->name, "encoder_communication_error") && same_text(hiwin_e_alarm_code_text(INT64_C(2080))->printed, "AL.820"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2096)) != NULL && hiwin_e_alarm_code_text(INT64_C(2096))->number == INT64_C(36) && same_text(hiwin_e_alarm_code_text(INT64_C(2096))->name, "encoder_data_error") && same_text(hiwin_e_alarm_code_text(INT64_C(2096))->printed, "AL.830"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2112)) != NULL && hiwin_e_alarm_code_text(INT64_C(2112))->number == INT64_C(37) && same_text(hiwin_e_alarm_code_text(INT64_C(2112))->name, "encoder_communication_check_error") && same_text(hiwin_e_alarm_code_text(INT64_C(2112))->printed, "AL.840"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2128)) != NULL && hiwin_e_alarm_code_text(INT64_C(2128))->number == INT64_C(38) && same_text(hiwin_e_alarm_code_text(INT64_C(2128))->name, "encoder_counting_error") && same_text(hiwin_e_alarm_code_text(INT64_C(2128))->printed, "AL.850"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2144)) != NULL && hiwin_e_alarm_code_text(INT64_C(2144))->number == INT64_C(39) && same_text(hiwin_e_alarm_code_text(INT64_C(2144))->name, "encoder_write_error") && same_text(hiwin_e_alarm_code_text(INT64_C(2144))->printed, "AL.860"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2160)) != NULL && hiwin_e_alarm_code_text(INT64_C(2160))->number == INT64_C(40) && same_text(hiwin_e_alarm_code_text(INT64_C(2160))->name, "encoder_overheated") && same_text(hiwin_e_alarm_code_text(INT64_C(2160))->printed, "AL.870"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2176)) != NULL && hiwin_e_alarm_code_text(INT64_C(2176))->number == INT64_C(41) && same_text(hiwin_e_alarm_code_text(INT64_C(2176))->name, "incremental_encoder_phase_sequence") && same_text(hiwin_e_alarm_code_text(INT64_C(2176))->printed, "AL.880"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2192)) != NULL && hiwin_e_alarm_code_text(INT64_C(2192))->number == INT64_C(42) && same_text(hiwin_e_alarm_code_text(INT64_C(2192))->name, "adapter_incremental_encoder_disconnected") && same_text(hiwin_e_alarm_code_text(INT64_C(2192))->printed, "AL.890"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2208)) != NULL && hiwin_e_alarm_code_text(INT64_C(2208))->number == INT64_C(43) && same_text(hiwin_e_alarm_code_text(INT64_C(2208))->name, "encoder_1_signal_at_adapter") && same_text(hiwin_e_alarm_code_text(INT64_C(2208))->printed, "AL.8A0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2224)) != NULL && hiwin_e_alarm_code_text(INT64_C(2224))->number == INT64_C(44) && same_text(hiwin_e_alarm_code_text(INT64_C(2224))->name, "encoder_1_signal_at_encoder") && same_text(hiwin_e_alarm_code_text(INT64_C(2224))->printed, "AL.8b0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2240)) != NULL && hiwin_e_alarm_code_text(INT64_C(2240))->number == INT64_C(45) && same_text(hiwin_e_alarm_code_text(INT64_C(2240))->name, "encoder_2_signal_at_adapter") && same_text(hiwin_e_alarm_code_text(INT64_C(2240))->printed, "AL.8C0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2256)) != NULL && hiwin_e_alarm_code_text(INT64_C(2256))->number == INT64_C(46) && same_text(hiwin_e_alarm_code_text(INT64_C(2256))->name, "encoder_2_signal_at_encoder") && same_text(hiwin_e_alarm_code_text(INT64_C(2256))->printed, "AL.8d0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2272)) != NULL && hiwin_e_alarm_code_text(INT64_C(2272))->number == INT64_C(47) && same_text(hiwin_e_alarm_code_text(INT64_C(2272))->name, "digital_encoder_disconnected") && same_text(hiwin_e_alarm_code_text(INT64_C(2272))->printed, "AL.8E0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2288)) != NULL && hiwin_e_alarm_code_text(INT64_C(2288))->number == INT64_C(48) && same_text(hiwin_e_alarm_code_text(INT64_C(2288))->name, "encoder_adapter_internal_error") && same_text(hiwin_e_alarm_code_text(INT64_C(2288))->printed, "AL.8F0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2145)) != NULL && hiwin_e_alarm_code_text(INT64_C(2145))->number == INT64_C(49) && same_text(hiwin_e_alarm_code_text(INT64_C(2145))->name, "motor_overheated") && same_text(hiwin_e_alarm_code_text(INT64_C(2145))->printed, "AL.861"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2832)) != NULL && hiwin_e_alarm_code_text(INT64_C(2832))->number == INT64_C(50) && same_text(hiwin_e_alarm_code_text(INT64_C(2832))->name, "speed_command_converter_error") && same_text(hiwin_e_alarm_code_text(INT64_C(2832))->printed, "AL.b10"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2848)) != NULL && hiwin_e_alarm_code_text(INT64_C(2848))->number == INT64_C(52) && same_text(hiwin_e_alarm_code_text(INT64_C(2848))->name, "torque_command_converter_error") && same_text(hiwin_e_alarm_code_text(INT64_C(2848))->printed, "AL.b20"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2867)) != NULL && hiwin_e_alarm_code_text(INT64_C(2867))->number == INT64_C(53) && same_text(hiwin_e_alarm_code_text(INT64_C(2867))->name, "current_detection_fault") && same_text(hiwin_e_alarm_code_text(INT64_C(2867))->printed, "AL.b33"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3088)) != NULL && hiwin_e_alarm_code_text(INT64_C(3088))->number == INT64_C(54) && same_text(hiwin_e_alarm_code_text(INT64_C(3088))->name, "motor_runaway") && same_text(hiwin_e_alarm_code_text(INT64_C(3088))->printed, "AL.C10"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3104)) != NULL && hiwin_e_alarm_code_text(INT64_C(3104))->number == INT64_C(55) && same_text(hiwin_e_alarm_code_text(INT64_C(3104))->name, "phase_detection_error") && same_text(hiwin_e_alarm_code_text(INT64_C(3104))->printed, "AL.C20"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3105)) != NULL && hiwin_e_alarm_code_text(INT64_C(3105))->number == INT64_C(56) && same_text(hiwin_e_alarm_code_text(INT64_C(3105))->name, "hall_sensor_fault") && same_text(hiwin_e_alarm_code_text(INT64_C(3105))->printed, "AL.C21"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3152)) != NULL && hiwin_e_alarm_code_text(INT64_C(3152))->number == INT64_C(58) && same_text(hiwin_e_alarm_code_text(INT64_C(3152))->name, "electrical_angle_detection_failed") && same_text(hiwin_e_alarm_code_text(INT64_C(3152))->printed, "AL.C50"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3153)) != NULL && hiwin_e_alarm_code_text(INT64_C(3153))->number == INT64_C(59) && same_text(hiwin_e_alarm_code_text(INT64_C(3153))->name, "electrical_angle_detection_overtravel") && same_text(hiwin_e_alarm_code_text(INT64_C(3153))->printed, "AL.C51"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3154)) != NULL && hiwin_e_alarm_code_text(INT64_C(3154))->number == INT64_C(60) && same_text(hiwin_e_alarm_code_text(INT64_C(3154))->name, "electrical_angle_detection_incomplete") && same_text(hiwin_e_alarm_code_text(INT64_C(3154))->printed, "AL.C52"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3328)) != NULL && hiwin_e_alarm_code_text(INT64_C(3328))->number == INT64_C(62) && same_text(hiwin_e_alarm_code_text(INT64_C(3328))->name, "position_deviation_too_large") && same_text(hiwin_e_alarm_code_text(INT64_C(3328))->printed, "AL.d00"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3344)) != NULL && hiwin_e_alarm_code_text(INT64_C(3344))->number == INT64_C(65) && same_text(hiwin_e_alarm_code_text(INT64_C(3344))->name, "load_position_deviation_too_large") && same_text(hiwin_e_alarm_code_text(INT64_C(3344))->printed, "AL.d10"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3760)) != NULL && hiwin_e_alarm_code_text(INT64_C(3760))->number == INT64_C(66) && same_text(hiwin_e_alarm_code_text(INT64_C(3760))->name, "safety_function_alarm") && same_text(hiwin_e_alarm_code_text(INT64_C(3760))->printed, "AL.Eb0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3761)) != NULL && hiwin_e_alarm_code_text(INT64_C(3761))->number == INT64_C(67) && same_text(hiwin_e_alarm_code_text(INT64_C(3761))->name, "safety_input_timing") && same_text(hiwin_e_alarm_code_text(INT64_C(3761))->printed, "AL.Eb1"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3762)) != NULL && hiwin_e_alarm_code_text(INT64_C(3762))->number == INT64_C(68) && same_text(hiwin_e_alarm_code_text(INT64_C(3762))->name, "safety_module_error") && same_text(hiwin_e_alarm_code_text(INT64_C(3762))->printed, "AL.Eb2"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3856)) != NULL && hiwin_e_alarm_code_text(INT64_C(3856))->number == INT64_C(69) && same_text(hiwin_e_alarm_code_text(INT64_C(3856))->name, "power_line_phase_missing") && same_text(hiwin_e_alarm_code_text(INT64_C(3856))->printed, "AL.F10"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3920)) != NULL && hiwin_e_alarm_code_text(INT64_C(3920))->number == INT64_C(70) && same_text(hiwin_e_alarm_code_text(INT64_C(3920))->name, "motor_line_disconnected") && same_text(hiwin_e_alarm_code_text(INT64_C(3920))->printed, "AL.F50"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(4000)) != NULL && hiwin_e_alarm_code_text(INT64_C(4000))->number == INT64_C(71) && same_text(hiwin_e_alarm_code_text(INT64_C(4000))->name, "encoder_supply_error") && same_text(hiwin_e_alarm_code_text(INT64_C(4000))->printed, "AL.FA0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(4016)) != NULL && hiwin_e_alarm_code_text(INT64_C(4016))->number == INT64_C(72) && same_text(hiwin_e_alarm_code_text(INT64_C(4016))->name, "fieldbus_hardware_failure") && same_text(hiwin_e_alarm_code_text(INT64_C(4016))->printed, "AL.FB0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(4017)) != NULL && hiwin_e_alarm_code_text(INT64_C(4017))->number == INT64_C(73) && same_text(hiwin_e_alarm_code_text(INT64_C(4017))->name, "fieldbus_communication_error") && same_text(hiwin_e_alarm_code_text(INT64_C(4017))->printed, "AL.FB1"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(4032)) != NULL && hiwin_e_alarm_code_text(INT64_C(4032))->number == INT64_C(74) && same_text(hiwin_e_alarm_code_text(INT64_C(4032))->name, "dual_axis_communication_error") && same_text(hiwin_e_alarm_code_text(INT64_C(4032))->printed, "AL.FC0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(4033)) != NULL && hiwin_e_alarm_code_text(INT64_C(4033))->number == INT64_C(75) && same_text(hiwin_e_alarm_code_text(INT64_C(4033))->name, "dual_axis_slave_alarm") && same_text(hiwin_e_alarm_code_text(INT64_C(4033))->printed, "AL.FC1"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(2193)) != NULL && hiwin_e_alarm_code_text(INT64_C(2193))->number == INT64_C(76) && same_text(hiwin_e_alarm_code_text(INT64_C(2193))->name, "incremental_encoder_signal_error") && same_text(hiwin_e_alarm_code_text(INT64_C(2193))->printed, "AL.891"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(4018)) != NULL && hiwin_e_alarm_code_text(INT64_C(4018))->number == INT64_C(77) && same_text(hiwin_e_alarm_code_text(INT64_C(4018))->name, "fieldbus_setting_error") && same_text(hiwin_e_alarm_code_text(INT64_C(4018))->printed, "AL.FB2"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3808)) != NULL && hiwin_e_alarm_code_text(INT64_C(3808))->number == INT64_C(78) && same_text(hiwin_e_alarm_code_text(INT64_C(3808))->name, "fixed_stop_alarm") && same_text(hiwin_e_alarm_code_text(INT64_C(3808))->printed, "AL.EE0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(4048)) != NULL && hiwin_e_alarm_code_text(INT64_C(4048))->number == INT64_C(79) && same_text(hiwin_e_alarm_code_text(INT64_C(4048))->name, "electronic_cam_alarm") && same_text(hiwin_e_alarm_code_text(INT64_C(4048))->printed, "AL.Fd0"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(3833)) != NULL && hiwin_e_alarm_code_text(INT64_C(3833))->number == INT64_C(80) && same_text(hiwin_e_alarm_code_text(INT64_C(3833))->name, "multi_station_alarm") && same_text(hiwin_e_alarm_code_text(INT64_C(3833))->printed, "AL.EF9"), "hiwin_e_alarm_code_text");
    expect(hiwin_e_alarm_code_text(INT64_C(0)) == NULL, "hiwin_e_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(4)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(4))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(4))->name, "system_alarm_1") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(4))->printed, "AL.024"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(5)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(5))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(5))->name, "system_alarm_2") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(5))->printed, "AL.025"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(6)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(6))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(6))->name, "main_circuit_fault") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(6))->printed, "AL.030"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(7)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(7))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(7))->name, "parameter_setting_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(7))->printed, "AL.040"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(11)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(11))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(11))->name, "combination_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(11))->printed, "AL.050"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(12)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(12))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(12))->name, "motor_change_detected") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(12))->printed, "AL.070"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(14)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(14))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(14))->name, "servo_on_command_invalid") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(14))->printed, "AL.0b0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(15)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(15))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(15))->name, "overcurrent") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(15))->printed, "AL.100"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(16)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(16))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(16))->name, "regenerative_energy_overload") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(16))->printed, "AL.320"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(17)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(17))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(17))->name, "overvoltage") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(17))->printed, "AL.400"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(18)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(18))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(18))->name, "undervoltage") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(18))->printed, "AL.410"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(19)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(19))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(19))->name, "overspeed") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(19))->printed, "AL.510"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(20)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(20))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(20))->name, "encoder_pulse_output_overspeed") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(20))->printed, "AL.511"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(24)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(24))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(24))->name, "momentary_overload") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(24))->printed, "AL.710"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(25)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(25))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(25))->name, "continuous_overload") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(25))->printed, "AL.720"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(29)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(29))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(29))->name, "drive_overload") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(29))->printed, "AL.7A1"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(30)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(30))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(30))->name, "power_board_temperature") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(30))->printed, "AL.7A2"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(33)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(33))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(33))->name, "encoder_absolute_position_lost") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(33))->printed, "AL.800"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(34)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(34))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(34))->name, "encoder_battery_voltage_low") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(34))->printed, "AL.810"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(35)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(35))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(35))->name, "encoder_communication_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(35))->printed, "AL.820"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(36)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(36))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(36))->name, "encoder_data_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(36))->printed, "AL.830"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(37)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(37))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(37))->name, "encoder_communication_check_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(37))->printed, "AL.840"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(38)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(38))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(38))->name, "encoder_counting_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(38))->printed, "AL.850"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(39)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(39))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(39))->name, "encoder_write_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(39))->printed, "AL.860"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(40)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(40))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(40))->name, "encoder_overheated") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(40))->printed, "AL.870"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(41)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(41))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(41))->name, "incremental_encoder_phase_sequence") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(41))->printed, "AL.880"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(42)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(42))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(42))->name, "adapter_incremental_encoder_disconnected") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(42))->printed, "AL.890"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(43)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(43))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(43))->name, "encoder_1_signal_at_adapter") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(43))->printed, "AL.8A0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(44)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(44))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(44))->name, "encoder_1_signal_at_encoder") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(44))->printed, "AL.8b0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(45)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(45))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(45))->name, "encoder_2_signal_at_adapter") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(45))->printed, "AL.8C0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(46)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(46))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(46))->name, "encoder_2_signal_at_encoder") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(46))->printed, "AL.8d0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(47)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(47))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(47))->name, "digital_encoder_disconnected") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(47))->printed, "AL.8E0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(48)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(48))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(48))->name, "encoder_adapter_internal_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(48))->printed, "AL.8F0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(49)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(49))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(49))->name, "motor_overheated") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(49))->printed, "AL.861"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(50)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(50))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(50))->name, "speed_command_converter_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(50))->printed, "AL.b10"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(52)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(52))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(52))->name, "torque_command_converter_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(52))->printed, "AL.b20"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(53)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(53))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(53))->name, "current_detection_fault") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(53))->printed, "AL.b33"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(54)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(54))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(54))->name, "motor_runaway") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(54))->printed, "AL.C10"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(55)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(55))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(55))->name, "phase_detection_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(55))->printed, "AL.C20"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(56)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(56))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(56))->name, "hall_sensor_fault") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(56))->printed, "AL.C21"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(58)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(58))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(58))->name, "electrical_angle_detection_failed") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(58))->printed, "AL.C50"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(59)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(59))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(59))->name, "electrical_angle_detection_overtravel") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(59))->printed, "AL.C51"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(60)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(60))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(60))->name, "electrical_angle_detection_incomplete") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(60))->printed, "AL.C52"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(62)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(62))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(62))->name, "position_deviation_too_large") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(62))->printed, "AL.d00"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(65)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(65))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(65))->name, "load_position_deviation_too_large") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(65))->printed, "AL.d10"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(66)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(66))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(66))->name, "safety_function_alarm") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(66))->printed, "AL.Eb0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(67)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(67))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(67))->name, "safety_input_timing") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(67))->printed, "AL.Eb1"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(68)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(68))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(68))->name, "safety_module_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(68))->printed, "AL.Eb2"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(69)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(69))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(69))->name, "power_line_phase_missing") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(69))->printed, "AL.F10"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(70)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(70))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(70))->name, "motor_line_disconnected") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(70))->printed, "AL.F50"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(71)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(71))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(71))->name, "encoder_supply_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(71))->printed, "AL.FA0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(72)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(72))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(72))->name, "fieldbus_hardware_failure") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(72))->printed, "AL.FB0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(73)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(73))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(73))->name, "fieldbus_communication_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(73))->printed, "AL.FB1"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(74)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(74))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(74))->name, "dual_axis_communication_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(74))->printed, "AL.FC0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(75)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(75))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(75))->name, "dual_axis_slave_alarm") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(75))->printed, "AL.FC1"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(76)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(76))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(76))->name, "incremental_encoder_signal_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(76))->printed, "AL.891"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(77)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(77))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(77))->name, "fieldbus_setting_error") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(77))->printed, "AL.FB2"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(78)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(78))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(78))->name, "fixed_stop_alarm") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(78))->printed, "AL.EE0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(79)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(79))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(79))->name, "electronic_cam_alarm") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(79))->printed, "AL.Fd0"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(80)) != NULL && hiwin_e_internal_alarm_code_text(INT64_C(80))->number == (-INT64_C(1)) && same_text(hiwin_e_internal_alarm_code_text(INT64_C(80))->name, "multi_station_alarm") && same_text(hiwin_e_internal_alarm_code_text(INT64_C(80))->printed, "AL.EF9"), "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_internal_alarm_code_text(INT64_C(0)) == NULL, "hiwin_e_internal_alarm_code_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(0)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(0))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(0))->name, "parameter_number_not_allowed") && same_text(hiwin_e_parameter_error_number_text(INT64_C(0))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(1)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(1))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(1))->name, "value_not_changeable") && same_text(hiwin_e_parameter_error_number_text(INT64_C(1))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(2)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(2))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(2))->name, "limit_exceeded") && same_text(hiwin_e_parameter_error_number_text(INT64_C(2))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(3)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(3))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(3))->name, "wrong_subindex") && same_text(hiwin_e_parameter_error_number_text(INT64_C(3))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(4)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(4))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(4))->name, "no_array") && same_text(hiwin_e_parameter_error_number_text(INT64_C(4))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(5)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(5))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(5))->name, "wrong_data_type") && same_text(hiwin_e_parameter_error_number_text(INT64_C(5))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(6)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(6))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(6))->name, "setting_not_allowed") && same_text(hiwin_e_parameter_error_number_text(INT64_C(6))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(7)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(7))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(7))->name, "description_not_changeable") && same_text(hiwin_e_parameter_error_number_text(INT64_C(7))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(9)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(9))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(9))->name, "description_not_available") && same_text(hiwin_e_parameter_error_number_text(INT64_C(9))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(11)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(11))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(11))->name, "no_priority") && same_text(hiwin_e_parameter_error_number_text(INT64_C(11))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(15)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(15))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(15))->name, "text_array_not_available") && same_text(hiwin_e_parameter_error_number_text(INT64_C(15))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(17)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(17))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(17))->name, "operating_state_prevents_access") && same_text(hiwin_e_parameter_error_number_text(INT64_C(17))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(20)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(20))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(20))->name, "value_not_allowed") && same_text(hiwin_e_parameter_error_number_text(INT64_C(20))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(21)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(21))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(21))->name, "response_too_long") && same_text(hiwin_e_parameter_error_number_text(INT64_C(21))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(22)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(22))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(22))->name, "parameter_address_not_allowed") && same_text(hiwin_e_parameter_error_number_text(INT64_C(22))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(23)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(23))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(23))->name, "wrong_format") && same_text(hiwin_e_parameter_error_number_text(INT64_C(23))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(24)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(24))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(24))->name, "value_count_inconsistent") && same_text(hiwin_e_parameter_error_number_text(INT64_C(24))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(25)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(25))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(25))->name, "axis_missing") && same_text(hiwin_e_parameter_error_number_text(INT64_C(25))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(32)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(32))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(32))->name, "text_not_changeable") && same_text(hiwin_e_parameter_error_number_text(INT64_C(32))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(33)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(33))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(33))->name, "service_not_supported") && same_text(hiwin_e_parameter_error_number_text(INT64_C(33))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(34)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(34))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(34))->name, "too_many_parameters") && same_text(hiwin_e_parameter_error_number_text(INT64_C(34))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(35)) != NULL && hiwin_e_parameter_error_number_text(INT64_C(35))->number == (-INT64_C(1)) && same_text(hiwin_e_parameter_error_number_text(INT64_C(35))->name, "several_parameters_not_supported") && same_text(hiwin_e_parameter_error_number_text(INT64_C(35))->printed, ""), "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_parameter_error_number_text(INT64_C(8)) == NULL, "hiwin_e_parameter_error_number_text");
    expect(hiwin_e_warning_code_text(INT64_C(2304)) != NULL && hiwin_e_warning_code_text(INT64_C(2304))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2304))->name, "position_deviation_too_large") && same_text(hiwin_e_warning_code_text(INT64_C(2304))->printed, "AL.900"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2305)) != NULL && hiwin_e_warning_code_text(INT64_C(2305))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2305))->name, "unsupported_901") && same_text(hiwin_e_warning_code_text(INT64_C(2305))->printed, "AL.901"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2320)) != NULL && hiwin_e_warning_code_text(INT64_C(2320))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2320))->name, "overload") && same_text(hiwin_e_warning_code_text(INT64_C(2320))->printed, "AL.910"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2321)) != NULL && hiwin_e_warning_code_text(INT64_C(2321))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2321))->name, "unsupported_911") && same_text(hiwin_e_warning_code_text(INT64_C(2321))->printed, "AL.911"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2322)) != NULL && hiwin_e_warning_code_text(INT64_C(2322))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2322))->name, "unsupported_912") && same_text(hiwin_e_warning_code_text(INT64_C(2322))->printed, "AL.912"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2336)) != NULL && hiwin_e_warning_code_text(INT64_C(2336))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2336))->name, "unsupported_920") && same_text(hiwin_e_warning_code_text(INT64_C(2336))->printed, "AL.920"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2337)) != NULL && hiwin_e_warning_code_text(INT64_C(2337))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2337))->name, "unsupported_921") && same_text(hiwin_e_warning_code_text(INT64_C(2337))->printed, "AL.921"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2339)) != NULL && hiwin_e_warning_code_text(INT64_C(2339))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2339))->name, "internal_fan_stopped") && same_text(hiwin_e_warning_code_text(INT64_C(2339))->printed, "AL.923"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2340)) != NULL && hiwin_e_warning_code_text(INT64_C(2340))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2340))->name, "i2t") && same_text(hiwin_e_warning_code_text(INT64_C(2340))->printed, "AL.924"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2352)) != NULL && hiwin_e_warning_code_text(INT64_C(2352))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2352))->name, "encoder_battery_fault") && same_text(hiwin_e_warning_code_text(INT64_C(2352))->printed, "AL.930"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2369)) != NULL && hiwin_e_warning_code_text(INT64_C(2369))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2369))->name, "restart_required") && same_text(hiwin_e_warning_code_text(INT64_C(2369))->printed, "AL.941"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2371)) != NULL && hiwin_e_warning_code_text(INT64_C(2371))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2371))->name, "fieldbus_synchronization_time") && same_text(hiwin_e_warning_code_text(INT64_C(2371))->printed, "AL.943"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2372)) != NULL && hiwin_e_warning_code_text(INT64_C(2372))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2372))->name, "system_warning") && same_text(hiwin_e_warning_code_text(INT64_C(2372))->printed, "AL.944"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2373)) != NULL && hiwin_e_warning_code_text(INT64_C(2373))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2373))->name, "torque_limit") && same_text(hiwin_e_warning_code_text(INT64_C(2373))->printed, "AL.945"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2374)) != NULL && hiwin_e_warning_code_text(INT64_C(2374))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2374))->name, "encoder_communication") && same_text(hiwin_e_warning_code_text(INT64_C(2374))->printed, "AL.946"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2375)) != NULL && hiwin_e_warning_code_text(INT64_C(2375))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2375))->name, "multi_station_function_disabled") && same_text(hiwin_e_warning_code_text(INT64_C(2375))->printed, "AL.947"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2417)) != NULL && hiwin_e_warning_code_text(INT64_C(2417))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2417))->name, "undervoltage") && same_text(hiwin_e_warning_code_text(INT64_C(2417))->printed, "AL.971"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2432)) != NULL && hiwin_e_warning_code_text(INT64_C(2432))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2432))->name, "operation") && same_text(hiwin_e_warning_code_text(INT64_C(2432))->printed, "AL.980"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2464)) != NULL && hiwin_e_warning_code_text(INT64_C(2464))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2464))->name, "overtravel_servo_on") && same_text(hiwin_e_warning_code_text(INT64_C(2464))->printed, "AL.9A0"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2465)) != NULL && hiwin_e_warning_code_text(INT64_C(2465))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2465))->name, "positive_overtravel_servo_off") && same_text(hiwin_e_warning_code_text(INT64_C(2465))->printed, "AL.9A1"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2466)) != NULL && hiwin_e_warning_code_text(INT64_C(2466))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2466))->name, "negative_overtravel_servo_off") && same_text(hiwin_e_warning_code_text(INT64_C(2466))->printed, "AL.9A2"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2474)) != NULL && hiwin_e_warning_code_text(INT64_C(2474))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2474))->name, "unsupported_9aa") && same_text(hiwin_e_warning_code_text(INT64_C(2474))->printed, "AL.9AA"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2475)) != NULL && hiwin_e_warning_code_text(INT64_C(2475))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2475))->name, "unsupported_9ab") && same_text(hiwin_e_warning_code_text(INT64_C(2475))->printed, "AL.9Ab"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(2544)) != NULL && hiwin_e_warning_code_text(INT64_C(2544))->number == (-INT64_C(1)) && same_text(hiwin_e_warning_code_text(INT64_C(2544))->name, "overvoltage") && same_text(hiwin_e_warning_code_text(INT64_C(2544))->printed, "AL.9F0"), "hiwin_e_warning_code_text");
    expect(hiwin_e_warning_code_text(INT64_C(0)) == NULL, "hiwin_e_warning_code_text");
}

static void test_3(void)
{
    expect(HIWIN_E_READ_PARAMETER_CODE == 1u, "HIWIN_E_READ_PARAMETER_CODE");
    expect(HIWIN_E_WRITE_PARAMETER_CODE == 2u, "HIWIN_E_WRITE_PARAMETER_CODE");
    expect(HIWIN_E_TELEGRAM_3_NUMBER == 3u, "HIWIN_E_TELEGRAM_3_NUMBER");
    expect(HIWIN_E_TELEGRAM_5_NUMBER == 5u, "HIWIN_E_TELEGRAM_5_NUMBER");
    expect(HIWIN_E_TELEGRAM_9_NUMBER == 9u, "HIWIN_E_TELEGRAM_9_NUMBER");
    expect(HIWIN_E_TELEGRAM_102_NUMBER == 102u, "HIWIN_E_TELEGRAM_102_NUMBER");
    expect(HIWIN_E_TELEGRAM_105_NUMBER == 105u, "HIWIN_E_TELEGRAM_105_NUMBER");
    expect(HIWIN_E_TELEGRAM_111_NUMBER == 111u, "HIWIN_E_TELEGRAM_111_NUMBER");
    expect(HIWIN_E_TELEGRAM_750_NUMBER == 750u, "HIWIN_E_TELEGRAM_750_NUMBER");
}

static void test_4(void)
{
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_MOTOR_TYPE_NUMBER == 12288u, "HIWIN_E_PAR_DRIVE_PARAMETERS_MOTOR_TYPE_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_INNER_ENCODER_RESOLUTION_NUMBER == 12289u, "HIWIN_E_PAR_DRIVE_PARAMETERS_INNER_ENCODER_RESOLUTION_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_DIGITAL_OUTPUTS_NUMBER == 12356u, "HIWIN_E_PAR_DRIVE_PARAMETERS_DIGITAL_OUTPUTS_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_SOFTWARE_STATE_12_NUMBER == 12374u, "HIWIN_E_PAR_DRIVE_PARAMETERS_SOFTWARE_STATE_12_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_APPLICATION_MODE_NUMBER == 12375u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_APPLICATION_MODE_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_YAW_TARGET_POSITION_NUMBER == 12376u, "HIWIN_E_PAR_DRIVE_PARAMETERS_YAW_TARGET_POSITION_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_YAW_FEEDBACK_POSITION_NUMBER == 12377u, "HIWIN_E_PAR_DRIVE_PARAMETERS_YAW_FEEDBACK_POSITION_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_MASTER_FEEDBACK_POSITION_NUMBER == 12378u, "HIWIN_E_PAR_DRIVE_PARAMETERS_MASTER_FEEDBACK_POSITION_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_SLAVE_FEEDBACK_POSITION_NUMBER == 12379u, "HIWIN_E_PAR_DRIVE_PARAMETERS_SLAVE_FEEDBACK_POSITION_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_REFERENCE_MARK_FUNCTIONS_NUMBER == 12384u, "HIWIN_E_PAR_DRIVE_PARAMETERS_REFERENCE_MARK_FUNCTIONS_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ENABLED_NUMBER == 12385u, "HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ENABLED_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_OVERTRAVEL_STOP_MODE_NUMBER == 12386u, "HIWIN_E_PAR_DRIVE_PARAMETERS_OVERTRAVEL_STOP_MODE_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_SPEED_ANALOG_INPUT_VOLTAGE_NUMBER == 12387u, "HIWIN_E_PAR_DRIVE_PARAMETERS_SPEED_ANALOG_INPUT_VOLTAGE_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_SPEED_ANALOG_INPUT_OFFSET_NUMBER == 12388u, "HIWIN_E_PAR_DRIVE_PARAMETERS_SPEED_ANALOG_INPUT_OFFSET_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_TORQUE_ANALOG_INPUT_VOLTAGE_NUMBER == 12389u, "HIWIN_E_PAR_DRIVE_PARAMETERS_TORQUE_ANALOG_INPUT_VOLTAGE_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_TORQUE_ANALOG_INPUT_OFFSET_NUMBER == 12390u, "HIWIN_E_PAR_DRIVE_PARAMETERS_TORQUE_ANALOG_INPUT_OFFSET_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_ANALOG_OUTPUT_1_VOLTAGE_NUMBER == 12391u, "HIWIN_E_PAR_DRIVE_PARAMETERS_ANALOG_OUTPUT_1_VOLTAGE_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_ANALOG_OUTPUT_2_VOLTAGE_NUMBER == 12392u, "HIWIN_E_PAR_DRIVE_PARAMETERS_ANALOG_OUTPUT_2_VOLTAGE_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_VALUE_NUMBER == 12393u, "HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_VALUE_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_INDEX_NUMBER == 12394u, "HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_INDEX_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_CONTROL_NUMBER == 12395u, "HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_CONTROL_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ERROR_NUMBER == 12396u, "HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ERROR_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_STATUS_NUMBER == 12397u, "HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_STATUS_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_EXPECTED_POSITION_TRIGGER_COUNT_NUMBER == 12398u, "HIWIN_E_PAR_DRIVE_PARAMETERS_EXPECTED_POSITION_TRIGGER_COUNT_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_COUNT_NUMBER == 12399u, "HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_COUNT_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_REMAINING_POSITION_TRIGGER_COUNT_NUMBER == 12400u, "HIWIN_E_PAR_DRIVE_PARAMETERS_REMAINING_POSITION_TRIGGER_COUNT_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_INDEX_NUMBER == 12416u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_INDEX_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_SUBINDEX_NUMBER == 12417u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_SUBINDEX_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_TYPE_NUMBER == 12418u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_TYPE_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_COMMAND_NUMBER == 12419u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_COMMAND_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_STATUS_NUMBER == 12420u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_STATUS_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_INTEGER_INPUT_NUMBER == 12421u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_INTEGER_INPUT_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_INTEGER_OUTPUT_NUMBER == 12422u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_INTEGER_OUTPUT_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_FLOAT_INPUT_NUMBER == 12423u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_FLOAT_INPUT_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_FLOAT_OUTPUT_NUMBER == 12424u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_FLOAT_OUTPUT_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_ALARM_STATES_NUMBER == 12544u, "HIWIN_E_PAR_DRIVE_PARAMETERS_ALARM_STATES_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_WARNINGS_1_NUMBER == 12560u, "HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_WARNINGS_1_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_WARNINGS_2_NUMBER == 12561u, "HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_WARNINGS_2_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_OPERATION_WARNINGS_NUMBER == 12576u, "HIWIN_E_PAR_DRIVE_PARAMETERS_OPERATION_WARNINGS_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_ABSOLUTE_ENCODER_INITIALIZATION_NUMBER == 12800u, "HIWIN_E_PAR_DRIVE_PARAMETERS_ABSOLUTE_ENCODER_INITIALIZATION_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_1_NUMBER == 12801u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_1_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_2_NUMBER == 12802u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_2_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_3_NUMBER == 12803u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_3_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_4_NUMBER == 12804u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_4_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_5_NUMBER == 12805u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_5_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_6_NUMBER == 12806u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_6_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_7_NUMBER == 12807u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_7_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_8_NUMBER == 12808u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_8_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_9_NUMBER == 12809u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_9_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_0_NUMBER == 12816u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_0_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_1_NUMBER == 12817u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_1_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_2_NUMBER == 12818u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_2_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_3_NUMBER == 12819u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_3_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_4_NUMBER == 12820u, "HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_4_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_RESET_NUMBER == 12821u, "HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_RESET_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_PARAMETER_SAVE_NUMBER == 12822u, "HIWIN_E_PAR_DRIVE_PARAMETERS_PARAMETER_SAVE_NUMBER");
    expect(HIWIN_E_PAR_DRIVE_PARAMETERS_MASTERSHIP_NUMBER == 12823u, "HIWIN_E_PAR_DRIVE_PARAMETERS_MASTERSHIP_NUMBER");
    expect(HIWIN_E_PAR_MONITORING_PARAMETERS_DIGITAL_OUTPUT_STATES_NUMBER == 16389u, "HIWIN_E_PAR_MONITORING_PARAMETERS_DIGITAL_OUTPUT_STATES_NUMBER");
    expect(HIWIN_E_PAR_MONITORING_PARAMETERS_ALARM_NUMBER == 16533u, "HIWIN_E_PAR_MONITORING_PARAMETERS_ALARM_NUMBER");
    expect(HIWIN_E_PAR_MONITORING_PARAMETERS_WARNING_NUMBER == 16534u, "HIWIN_E_PAR_MONITORING_PARAMETERS_WARNING_NUMBER");
    {
        uint16_t number = 0;
        expect(hiwin_e_par_monitoring_parameters_wire_number(4095u, &number) == HIWIN_E_OK, "hiwin_e_par_monitoring_parameters_wire_number last");
        expect(number == 20479u, "hiwin_e_par_monitoring_parameters_wire_number last number");
        expect(hiwin_e_par_monitoring_parameters_wire_number(4096u, &number) == HIWIN_E_ERR_OUT_OF_RANGE, "hiwin_e_par_monitoring_parameters_wire_number beyond");
        (void)number;
    }
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_TELEGRAM_SELECTION_NUMBER == 922u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_TELEGRAM_SELECTION_NUMBER");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_SIGN_OF_LIFE_FAILURE_TOLERANCE_NUMBER == 925u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_SIGN_OF_LIFE_FAILURE_TOLERANCE_NUMBER");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_OPERATING_MODE_NUMBER == 930u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_OPERATING_MODE_NUMBER");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_COUNTER_NUMBER == 944u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_COUNTER_NUMBER");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_CODES_NUMBER == 945u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_CODES_NUMBER");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_INTERNAL_ALARM_CODES_NUMBER == 947u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_INTERNAL_ALARM_CODES_NUMBER");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BUFFER_CAPACITY_NUMBER == 950u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BUFFER_CAPACITY_NUMBER");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BUFFER_CAPACITY_BLOCK_COUNT_SUBINDEX == 0u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BUFFER_CAPACITY_BLOCK_COUNT_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BUFFER_CAPACITY_ALARMS_PER_BLOCK_SUBINDEX == 1u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BUFFER_CAPACITY_ALARMS_PER_BLOCK_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BLOCK_COUNTER_NUMBER == 952u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BLOCK_COUNTER_NUMBER");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_NUMBER == 964u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_NUMBER");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_MANUFACTURER_SUBINDEX == 0u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_MANUFACTURER_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_DRIVE_UNIT_TYPE_SUBINDEX == 1u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_DRIVE_UNIT_TYPE_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_FIRMWARE_VERSION_SUBINDEX == 2u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_FIRMWARE_VERSION_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_FIRMWARE_YEAR_SUBINDEX == 3u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_FIRMWARE_YEAR_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_FIRMWARE_DAY_AND_MONTH_SUBINDEX == 4u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_FIRMWARE_DAY_AND_MONTH_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_DRIVE_OBJECT_COUNT_SUBINDEX == 5u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_DRIVE_OBJECT_COUNT_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_MINOR_FIRMWARE_VERSION_SUBINDEX == 6u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_MINOR_FIRMWARE_VERSION_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_NUMBER == 979u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_NUMBER");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_HEADER_SUBINDEX == 0u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_HEADER_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ENCODER_TYPE_SUBINDEX == 1u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ENCODER_TYPE_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ENCODER_RESOLUTION_SUBINDEX == 2u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ENCODER_RESOLUTION_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ACTUAL_POSITION_1_SHIFT_SUBINDEX == 3u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ACTUAL_POSITION_1_SHIFT_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ACTUAL_POSITION_2_SHIFT_SUBINDEX == 4u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ACTUAL_POSITION_2_SHIFT_SUBINDEX");
    expect(HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_MAXIMUM_TURN_COUNT_SUBINDEX == 5u, "HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_MAXIMUM_TURN_COUNT_SUBINDEX");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_BASIC_FUNCTION_SWITCH_1_NUMBER == 8193u, "HIWIN_E_PAR_SERVO_PARAMETERS_BASIC_FUNCTION_SWITCH_1_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_UPPER_LIMIT_NUMBER == 8795u, "HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_UPPER_LIMIT_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_LOWER_LIMIT_NUMBER == 8796u, "HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_LOWER_LIMIT_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_QUICK_STOP_DECELERATION_TIME_NUMBER == 8970u, "HIWIN_E_PAR_SERVO_PARAMETERS_QUICK_STOP_DECELERATION_TIME_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_ROTARY_NUMBER == 8982u, "HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_ROTARY_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_ROTARY_NUMBER == 8983u, "HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_ROTARY_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_LINEAR_NUMBER == 9093u, "HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_LINEAR_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_LINEAR_NUMBER == 9094u, "HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_LINEAR_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_TORQUE_LIMIT_NUMBER == 9218u, "HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_TORQUE_LIMIT_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_TORQUE_LIMIT_NUMBER == 9219u, "HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_TORQUE_LIMIT_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_TORQUE_NUMBER == 9258u, "HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_TORQUE_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TOLERANCE_NUMBER == 9259u, "HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TOLERANCE_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TOLERANCE_NUMBER == 9260u, "HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TOLERANCE_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TORQUE_NUMBER == 9261u, "HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TORQUE_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TORQUE_NUMBER == 9262u, "HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TORQUE_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_FIXED_STOP_FOLLOWING_ERROR_NUMBER == 9263u, "HIWIN_E_PAR_SERVO_PARAMETERS_FIXED_STOP_FOLLOWING_ERROR_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_FORCE_NUMBER == 9274u, "HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_FORCE_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FORCE_LIMIT_NUMBER == 9347u, "HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FORCE_LIMIT_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FORCE_LIMIT_NUMBER == 9348u, "HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FORCE_LIMIT_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_ROTARY_NUMBER == 9523u, "HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_ROTARY_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_ACCELERATION_TIME_NUMBER == 9524u, "HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_ACCELERATION_TIME_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DECELERATION_TIME_NUMBER == 9527u, "HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DECELERATION_TIME_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_EMERGENCY_DECELERATION_TIME_NUMBER == 9528u, "HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_EMERGENCY_DECELERATION_TIME_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DISTANCE_NUMBER == 9529u, "HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DISTANCE_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_JOG_DIRECTION_REVERSED_NUMBER == 9530u, "HIWIN_E_PAR_SERVO_PARAMETERS_JOG_DIRECTION_REVERSED_NUMBER");
    expect(HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_LINEAR_NUMBER == 9605u, "HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_LINEAR_NUMBER");
    {
        uint16_t number = 0;
        expect(hiwin_e_par_servo_parameters_wire_number(4095u, &number) == HIWIN_E_OK, "hiwin_e_par_servo_parameters_wire_number last");
        expect(number == 12287u, "hiwin_e_par_servo_parameters_wire_number last number");
        expect(hiwin_e_par_servo_parameters_wire_number(4096u, &number) == HIWIN_E_ERR_OUT_OF_RANGE, "hiwin_e_par_servo_parameters_wire_number beyond");
        (void)number;
    }
}

static void test_5(void)
{
    static const uint8_t wanted[] = {0x44, 0x01, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_PARAMETER_ERROR_SIZE];
    hiwin_e_parameter_error in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.error_number = 65535u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_parameter_error_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "parameter_error.error_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "parameter_error.error_number bytes");
    expect(hiwin_e_parameter_error_decode(bytes, length, &out) == HIWIN_E_OK, "parameter_error.error_number decodes");
    expect(out.error_number == 65535u, "parameter_error.error_number: error_number");
    expect(hiwin_e_parameter_error_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "parameter_error.error_number short");
    expect(hiwin_e_parameter_error_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "parameter_error.error_number cut");
}

static void test_6(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_REQUEST_SIZE];
    hiwin_e_read_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_request.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_request.element_count bytes");
    expect(hiwin_e_read_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_request.element_count decodes");
    expect(out.element_count == 255u, "read_parameter_request.element_count: element_count");
    expect(out.parameter_number == 0u, "read_parameter_request.element_count: parameter_number");
    expect(out.subindex == 0u, "read_parameter_request.element_count: subindex");
    expect(hiwin_e_read_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_request.element_count short");
    expect(hiwin_e_read_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_request.element_count cut");
}

static void test_7(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_REQUEST_SIZE];
    hiwin_e_read_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_request.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_request.parameter_number bytes");
    expect(hiwin_e_read_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_request.parameter_number decodes");
    expect(out.element_count == 0u, "read_parameter_request.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "read_parameter_request.parameter_number: parameter_number");
    expect(out.subindex == 0u, "read_parameter_request.parameter_number: subindex");
    expect(hiwin_e_read_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_request.parameter_number short");
    expect(hiwin_e_read_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_request.parameter_number cut");
}

static void test_8(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_REQUEST_SIZE];
    hiwin_e_read_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_request.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_request.subindex bytes");
    expect(hiwin_e_read_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_request.subindex decodes");
    expect(out.element_count == 0u, "read_parameter_request.subindex: element_count");
    expect(out.parameter_number == 0u, "read_parameter_request.subindex: parameter_number");
    expect(out.subindex == 65535u, "read_parameter_request.subindex: subindex");
    expect(hiwin_e_read_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_request.subindex short");
    expect(hiwin_e_read_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_request.subindex cut");
}

static void test_9(void)
{
    static const uint8_t wanted[] = {0x01, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 1u;
    in.values_count = 1u;
    in.values.boolean_value[0] = false;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.boolean_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.boolean_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.boolean_value.format decodes");
    expect(out.format == 1u, "read_parameter_response.boolean_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.boolean_value.format: values count");
    expect(out.values.boolean_value[0] == false, "read_parameter_response.boolean_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.boolean_value.format short");
}

static void test_10(void)
{
    static const uint8_t wanted[] = {0x01, 0x01, 0x01};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 1u;
    in.values_count = 1u;
    in.values.boolean_value[0] = true;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.boolean_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.boolean_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.boolean_value.values decodes");
    expect(out.format == 1u, "read_parameter_response.boolean_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.boolean_value.values: values count");
    expect(out.values.boolean_value[0] == true, "read_parameter_response.boolean_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.boolean_value.values short");
}

static void test_11(void)
{
    static const uint8_t wanted[] = {0x02, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 2u;
    in.values_count = 1u;
    in.values.integer_8_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.integer_8_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.integer_8_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.integer_8_value.format decodes");
    expect(out.format == 2u, "read_parameter_response.integer_8_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.integer_8_value.format: values count");
    expect(out.values.integer_8_value[0] == 0, "read_parameter_response.integer_8_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.integer_8_value.format short");
}

static void test_12(void)
{
    static const uint8_t wanted[] = {0x02, 0x01, 0x7F};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 2u;
    in.values_count = 1u;
    in.values.integer_8_value[0] = 127;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.integer_8_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.integer_8_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.integer_8_value.values decodes");
    expect(out.format == 2u, "read_parameter_response.integer_8_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.integer_8_value.values: values count");
    expect(out.values.integer_8_value[0] == 127, "read_parameter_response.integer_8_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.integer_8_value.values short");
}

static void test_13(void)
{
    static const uint8_t wanted[] = {0x03, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.integer_16_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.integer_16_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.integer_16_value.format decodes");
    expect(out.format == 3u, "read_parameter_response.integer_16_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.integer_16_value.format: values count");
    expect(out.values.integer_16_value[0] == 0, "read_parameter_response.integer_16_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.integer_16_value.format short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.integer_16_value.format cut");
}

static void test_14(void)
{
    static const uint8_t wanted[] = {0x03, 0x01, 0x7F, 0xFF};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = 32767;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.integer_16_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.integer_16_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.integer_16_value.values decodes");
    expect(out.format == 3u, "read_parameter_response.integer_16_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.integer_16_value.values: values count");
    expect(out.values.integer_16_value[0] == 32767, "read_parameter_response.integer_16_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.integer_16_value.values short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.integer_16_value.values cut");
}

static void test_15(void)
{
    static const uint8_t wanted[] = {0x04, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.integer_32_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.integer_32_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.integer_32_value.format decodes");
    expect(out.format == 4u, "read_parameter_response.integer_32_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.integer_32_value.format: values count");
    expect(out.values.integer_32_value[0] == 0, "read_parameter_response.integer_32_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.integer_32_value.format short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.integer_32_value.format cut");
}

static void test_16(void)
{
    static const uint8_t wanted[] = {0x04, 0x01, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 2147483647;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.integer_32_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.integer_32_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.integer_32_value.values decodes");
    expect(out.format == 4u, "read_parameter_response.integer_32_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.integer_32_value.values: values count");
    expect(out.values.integer_32_value[0] == 2147483647, "read_parameter_response.integer_32_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.integer_32_value.values short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.integer_32_value.values cut");
}

static void test_17(void)
{
    static const uint8_t wanted[] = {0x05, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 5u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_8_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_8_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_8_value.format decodes");
    expect(out.format == 5u, "read_parameter_response.unsigned_8_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_8_value.format: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "read_parameter_response.unsigned_8_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_8_value.format short");
}

static void test_18(void)
{
    static const uint8_t wanted[] = {0x05, 0x01, 0xFF};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 5u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 255u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_8_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_8_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_8_value.values decodes");
    expect(out.format == 5u, "read_parameter_response.unsigned_8_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_8_value.values: values count");
    expect(out.values.unsigned_8_value[0] == 255u, "read_parameter_response.unsigned_8_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_8_value.values short");
}

static void test_19(void)
{
    static const uint8_t wanted[] = {0x41, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 65u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_8_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_8_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_8_value.format decodes");
    expect(out.format == 65u, "read_parameter_response.unsigned_8_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_8_value.format: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "read_parameter_response.unsigned_8_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_8_value.format short");
}

static void test_20(void)
{
    static const uint8_t wanted[] = {0x41, 0x01, 0xFF};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 65u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 255u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_8_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_8_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_8_value.values decodes");
    expect(out.format == 65u, "read_parameter_response.unsigned_8_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_8_value.values: values count");
    expect(out.values.unsigned_8_value[0] == 255u, "read_parameter_response.unsigned_8_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_8_value.values short");
}

static void test_21(void)
{
    static const uint8_t wanted[] = {0x06, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_16_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_16_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_16_value.format decodes");
    expect(out.format == 6u, "read_parameter_response.unsigned_16_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_16_value.format: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "read_parameter_response.unsigned_16_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_16_value.format short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.unsigned_16_value.format cut");
}

static void test_22(void)
{
    static const uint8_t wanted[] = {0x06, 0x01, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 65535u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_16_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_16_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_16_value.values decodes");
    expect(out.format == 6u, "read_parameter_response.unsigned_16_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_16_value.values: values count");
    expect(out.values.unsigned_16_value[0] == 65535u, "read_parameter_response.unsigned_16_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_16_value.values short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.unsigned_16_value.values cut");
}

static void test_23(void)
{
    static const uint8_t wanted[] = {0x42, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 66u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_16_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_16_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_16_value.format decodes");
    expect(out.format == 66u, "read_parameter_response.unsigned_16_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_16_value.format: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "read_parameter_response.unsigned_16_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_16_value.format short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.unsigned_16_value.format cut");
}

static void test_24(void)
{
    static const uint8_t wanted[] = {0x42, 0x01, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 66u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 65535u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_16_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_16_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_16_value.values decodes");
    expect(out.format == 66u, "read_parameter_response.unsigned_16_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_16_value.values: values count");
    expect(out.values.unsigned_16_value[0] == 65535u, "read_parameter_response.unsigned_16_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_16_value.values short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.unsigned_16_value.values cut");
}

static void test_25(void)
{
    static const uint8_t wanted[] = {0x07, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 7u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_32_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_32_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_32_value.format decodes");
    expect(out.format == 7u, "read_parameter_response.unsigned_32_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_32_value.format: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "read_parameter_response.unsigned_32_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_32_value.format short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.unsigned_32_value.format cut");
}

static void test_26(void)
{
    static const uint8_t wanted[] = {0x07, 0x01, 0xFF, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 7u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 4294967295u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_32_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_32_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_32_value.values decodes");
    expect(out.format == 7u, "read_parameter_response.unsigned_32_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_32_value.values: values count");
    expect(out.values.unsigned_32_value[0] == 4294967295u, "read_parameter_response.unsigned_32_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_32_value.values short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.unsigned_32_value.values cut");
}

static void test_27(void)
{
    static const uint8_t wanted[] = {0x43, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 67u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_32_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_32_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_32_value.format decodes");
    expect(out.format == 67u, "read_parameter_response.unsigned_32_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_32_value.format: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "read_parameter_response.unsigned_32_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_32_value.format short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.unsigned_32_value.format cut");
}

static void test_28(void)
{
    static const uint8_t wanted[] = {0x43, 0x01, 0xFF, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 67u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 4294967295u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.unsigned_32_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.unsigned_32_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.unsigned_32_value.values decodes");
    expect(out.format == 67u, "read_parameter_response.unsigned_32_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.unsigned_32_value.values: values count");
    expect(out.values.unsigned_32_value[0] == 4294967295u, "read_parameter_response.unsigned_32_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.unsigned_32_value.values short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.unsigned_32_value.values cut");
}

static void test_29(void)
{
    static const uint8_t wanted[] = {0x08, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 8u;
    in.values_count = 1u;
    in.values.floating_point_value[0] = hiwin_e_float_of(0x00000000u);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.floating_point_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.floating_point_value.format bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.floating_point_value.format decodes");
    expect(out.format == 8u, "read_parameter_response.floating_point_value.format: format");
    expect(out.values_count == 1u, "read_parameter_response.floating_point_value.format: values count");
    expect(hiwin_e_bits_of(out.values.floating_point_value[0]) == 0x00000000u, "read_parameter_response.floating_point_value.format: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.floating_point_value.format short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.floating_point_value.format cut");
}

static void test_30(void)
{
    static const uint8_t wanted[] = {0x08, 0x01, 0xBF, 0xC0, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.format = 8u;
    in.values_count = 1u;
    in.values.floating_point_value[0] = hiwin_e_float_of(0xBFC00000u);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "read_parameter_response.floating_point_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_parameter_response.floating_point_value.values bytes");
    expect(hiwin_e_read_parameter_response_decode(bytes, length, &out) == HIWIN_E_OK, "read_parameter_response.floating_point_value.values decodes");
    expect(out.format == 8u, "read_parameter_response.floating_point_value.values: format");
    expect(out.values_count == 1u, "read_parameter_response.floating_point_value.values: values count");
    expect(hiwin_e_bits_of(out.values.floating_point_value[0]) == 0xBFC00000u, "read_parameter_response.floating_point_value.values: values");
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "read_parameter_response.floating_point_value.values short");
    expect(hiwin_e_read_parameter_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "read_parameter_response.floating_point_value.values cut");
}

static void test_31(void)
{
    static const uint8_t unknown[] = {0xFF, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_READ_PARAMETER_RESPONSE_SIZE];
    hiwin_e_read_parameter_response in;
    size_t length = 0;
    clear(&in, sizeof in);
    in.format = 255u;
    expect(hiwin_e_read_parameter_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_ERR_UNKNOWN_VALUE, "read_parameter_response chooses nothing");
    expect(hiwin_e_read_parameter_response_decode(unknown, sizeof unknown, &in) == HIWIN_E_ERR_UNKNOWN_VALUE, "read_parameter_response chooses nothing");
}

static void test_32(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x01, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 1u;
    in.values_count = 1u;
    in.values.boolean_value[0] = false;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.boolean_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.boolean_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.boolean_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.boolean_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.boolean_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.boolean_value.element_count: subindex");
    expect(out.format == 1u, "write_parameter_request.boolean_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.boolean_value.element_count: values count");
    expect(out.values.boolean_value[0] == false, "write_parameter_request.boolean_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.boolean_value.element_count short");
}

static void test_33(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x01, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 1u;
    in.values_count = 1u;
    in.values.boolean_value[0] = false;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.boolean_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.boolean_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.boolean_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.boolean_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.boolean_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.boolean_value.parameter_number: subindex");
    expect(out.format == 1u, "write_parameter_request.boolean_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.boolean_value.parameter_number: values count");
    expect(out.values.boolean_value[0] == false, "write_parameter_request.boolean_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.boolean_value.parameter_number short");
}

static void test_34(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x01, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 1u;
    in.values_count = 1u;
    in.values.boolean_value[0] = false;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.boolean_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.boolean_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.boolean_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.boolean_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.boolean_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.boolean_value.subindex: subindex");
    expect(out.format == 1u, "write_parameter_request.boolean_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.boolean_value.subindex: values count");
    expect(out.values.boolean_value[0] == false, "write_parameter_request.boolean_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.boolean_value.subindex short");
}

static void test_35(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 1u;
    in.values_count = 1u;
    in.values.boolean_value[0] = false;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.boolean_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.boolean_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.boolean_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.boolean_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.boolean_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.boolean_value.format: subindex");
    expect(out.format == 1u, "write_parameter_request.boolean_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.boolean_value.format: values count");
    expect(out.values.boolean_value[0] == false, "write_parameter_request.boolean_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.boolean_value.format short");
}

static void test_36(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x01, 0x01};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 1u;
    in.values_count = 1u;
    in.values.boolean_value[0] = true;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.boolean_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.boolean_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.boolean_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.boolean_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.boolean_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.boolean_value.values: subindex");
    expect(out.format == 1u, "write_parameter_request.boolean_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.boolean_value.values: values count");
    expect(out.values.boolean_value[0] == true, "write_parameter_request.boolean_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.boolean_value.values short");
}

static void test_37(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x02, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 2u;
    in.values_count = 1u;
    in.values.integer_8_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_8_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_8_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_8_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.integer_8_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_8_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_8_value.element_count: subindex");
    expect(out.format == 2u, "write_parameter_request.integer_8_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_8_value.element_count: values count");
    expect(out.values.integer_8_value[0] == 0, "write_parameter_request.integer_8_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_8_value.element_count short");
}

static void test_38(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x02, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 2u;
    in.values_count = 1u;
    in.values.integer_8_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_8_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_8_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_8_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_8_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.integer_8_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_8_value.parameter_number: subindex");
    expect(out.format == 2u, "write_parameter_request.integer_8_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_8_value.parameter_number: values count");
    expect(out.values.integer_8_value[0] == 0, "write_parameter_request.integer_8_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_8_value.parameter_number short");
}

static void test_39(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x02, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 2u;
    in.values_count = 1u;
    in.values.integer_8_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_8_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_8_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_8_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_8_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_8_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.integer_8_value.subindex: subindex");
    expect(out.format == 2u, "write_parameter_request.integer_8_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_8_value.subindex: values count");
    expect(out.values.integer_8_value[0] == 0, "write_parameter_request.integer_8_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_8_value.subindex short");
}

static void test_40(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x02, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 2u;
    in.values_count = 1u;
    in.values.integer_8_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_8_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_8_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_8_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_8_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_8_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_8_value.format: subindex");
    expect(out.format == 2u, "write_parameter_request.integer_8_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_8_value.format: values count");
    expect(out.values.integer_8_value[0] == 0, "write_parameter_request.integer_8_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_8_value.format short");
}

static void test_41(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x02, 0x01, 0x7F};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 2u;
    in.values_count = 1u;
    in.values.integer_8_value[0] = 127;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_8_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_8_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_8_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_8_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_8_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_8_value.values: subindex");
    expect(out.format == 2u, "write_parameter_request.integer_8_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_8_value.values: values count");
    expect(out.values.integer_8_value[0] == 127, "write_parameter_request.integer_8_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_8_value.values short");
}

static void test_42(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x03, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_16_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_16_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_16_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.integer_16_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_16_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_16_value.element_count: subindex");
    expect(out.format == 3u, "write_parameter_request.integer_16_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_16_value.element_count: values count");
    expect(out.values.integer_16_value[0] == 0, "write_parameter_request.integer_16_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_16_value.element_count short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.integer_16_value.element_count cut");
}

static void test_43(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x03, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_16_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_16_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_16_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_16_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.integer_16_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_16_value.parameter_number: subindex");
    expect(out.format == 3u, "write_parameter_request.integer_16_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_16_value.parameter_number: values count");
    expect(out.values.integer_16_value[0] == 0, "write_parameter_request.integer_16_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_16_value.parameter_number short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.integer_16_value.parameter_number cut");
}

static void test_44(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x03, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_16_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_16_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_16_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_16_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_16_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.integer_16_value.subindex: subindex");
    expect(out.format == 3u, "write_parameter_request.integer_16_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_16_value.subindex: values count");
    expect(out.values.integer_16_value[0] == 0, "write_parameter_request.integer_16_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_16_value.subindex short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.integer_16_value.subindex cut");
}

static void test_45(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x03, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_16_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_16_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_16_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_16_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_16_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_16_value.format: subindex");
    expect(out.format == 3u, "write_parameter_request.integer_16_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_16_value.format: values count");
    expect(out.values.integer_16_value[0] == 0, "write_parameter_request.integer_16_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_16_value.format short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.integer_16_value.format cut");
}

static void test_46(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x03, 0x01, 0x7F, 0xFF};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = 32767;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_16_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_16_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_16_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_16_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_16_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_16_value.values: subindex");
    expect(out.format == 3u, "write_parameter_request.integer_16_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_16_value.values: values count");
    expect(out.values.integer_16_value[0] == 32767, "write_parameter_request.integer_16_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_16_value.values short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.integer_16_value.values cut");
}

static void test_47(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x04, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_32_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_32_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_32_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.integer_32_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_32_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_32_value.element_count: subindex");
    expect(out.format == 4u, "write_parameter_request.integer_32_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_32_value.element_count: values count");
    expect(out.values.integer_32_value[0] == 0, "write_parameter_request.integer_32_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_32_value.element_count short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.integer_32_value.element_count cut");
}

static void test_48(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x04, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_32_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_32_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_32_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_32_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.integer_32_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_32_value.parameter_number: subindex");
    expect(out.format == 4u, "write_parameter_request.integer_32_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_32_value.parameter_number: values count");
    expect(out.values.integer_32_value[0] == 0, "write_parameter_request.integer_32_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_32_value.parameter_number short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.integer_32_value.parameter_number cut");
}

static void test_49(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x04, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_32_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_32_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_32_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_32_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_32_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.integer_32_value.subindex: subindex");
    expect(out.format == 4u, "write_parameter_request.integer_32_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_32_value.subindex: values count");
    expect(out.values.integer_32_value[0] == 0, "write_parameter_request.integer_32_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_32_value.subindex short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.integer_32_value.subindex cut");
}

static void test_50(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x04, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_32_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_32_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_32_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_32_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_32_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_32_value.format: subindex");
    expect(out.format == 4u, "write_parameter_request.integer_32_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_32_value.format: values count");
    expect(out.values.integer_32_value[0] == 0, "write_parameter_request.integer_32_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_32_value.format short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.integer_32_value.format cut");
}

static void test_51(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x04, 0x01, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 2147483647;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.integer_32_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.integer_32_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.integer_32_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.integer_32_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.integer_32_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.integer_32_value.values: subindex");
    expect(out.format == 4u, "write_parameter_request.integer_32_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.integer_32_value.values: values count");
    expect(out.values.integer_32_value[0] == 2147483647, "write_parameter_request.integer_32_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.integer_32_value.values short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.integer_32_value.values cut");
}

static void test_52(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x05, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 5u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_8_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.unsigned_8_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_8_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_8_value.element_count: subindex");
    expect(out.format == 5u, "write_parameter_request.unsigned_8_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_8_value.element_count: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "write_parameter_request.unsigned_8_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_8_value.element_count short");
}

static void test_53(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x05, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 5u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_8_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_8_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.unsigned_8_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_8_value.parameter_number: subindex");
    expect(out.format == 5u, "write_parameter_request.unsigned_8_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_8_value.parameter_number: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "write_parameter_request.unsigned_8_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_8_value.parameter_number short");
}

static void test_54(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x05, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 5u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_8_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_8_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_8_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.unsigned_8_value.subindex: subindex");
    expect(out.format == 5u, "write_parameter_request.unsigned_8_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_8_value.subindex: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "write_parameter_request.unsigned_8_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_8_value.subindex short");
}

static void test_55(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x05, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 5u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_8_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_8_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_8_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_8_value.format: subindex");
    expect(out.format == 5u, "write_parameter_request.unsigned_8_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_8_value.format: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "write_parameter_request.unsigned_8_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_8_value.format short");
}

static void test_56(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x05, 0x01, 0xFF};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 5u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 255u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_8_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_8_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_8_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_8_value.values: subindex");
    expect(out.format == 5u, "write_parameter_request.unsigned_8_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_8_value.values: values count");
    expect(out.values.unsigned_8_value[0] == 255u, "write_parameter_request.unsigned_8_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_8_value.values short");
}

static void test_57(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x41, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 65u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_8_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.unsigned_8_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_8_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_8_value.element_count: subindex");
    expect(out.format == 65u, "write_parameter_request.unsigned_8_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_8_value.element_count: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "write_parameter_request.unsigned_8_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_8_value.element_count short");
}

static void test_58(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x41, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 65u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_8_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_8_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.unsigned_8_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_8_value.parameter_number: subindex");
    expect(out.format == 65u, "write_parameter_request.unsigned_8_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_8_value.parameter_number: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "write_parameter_request.unsigned_8_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_8_value.parameter_number short");
}

static void test_59(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x41, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 65u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_8_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_8_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_8_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.unsigned_8_value.subindex: subindex");
    expect(out.format == 65u, "write_parameter_request.unsigned_8_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_8_value.subindex: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "write_parameter_request.unsigned_8_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_8_value.subindex short");
}

static void test_60(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x41, 0x01, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 65u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_8_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_8_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_8_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_8_value.format: subindex");
    expect(out.format == 65u, "write_parameter_request.unsigned_8_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_8_value.format: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "write_parameter_request.unsigned_8_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_8_value.format short");
}

static void test_61(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x41, 0x01, 0xFF};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 65u;
    in.values_count = 1u;
    in.values.unsigned_8_value[0] = 255u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_8_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_8_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_8_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_8_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_8_value.values: subindex");
    expect(out.format == 65u, "write_parameter_request.unsigned_8_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_8_value.values: values count");
    expect(out.values.unsigned_8_value[0] == 255u, "write_parameter_request.unsigned_8_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_8_value.values short");
}

static void test_62(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x06, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_16_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.unsigned_16_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_16_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_16_value.element_count: subindex");
    expect(out.format == 6u, "write_parameter_request.unsigned_16_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_16_value.element_count: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "write_parameter_request.unsigned_16_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_16_value.element_count short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_16_value.element_count cut");
}

static void test_63(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x06, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_16_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_16_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.unsigned_16_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_16_value.parameter_number: subindex");
    expect(out.format == 6u, "write_parameter_request.unsigned_16_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_16_value.parameter_number: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "write_parameter_request.unsigned_16_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_16_value.parameter_number short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_16_value.parameter_number cut");
}

static void test_64(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x06, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_16_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_16_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_16_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.unsigned_16_value.subindex: subindex");
    expect(out.format == 6u, "write_parameter_request.unsigned_16_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_16_value.subindex: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "write_parameter_request.unsigned_16_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_16_value.subindex short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_16_value.subindex cut");
}

static void test_65(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x06, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_16_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_16_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_16_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_16_value.format: subindex");
    expect(out.format == 6u, "write_parameter_request.unsigned_16_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_16_value.format: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "write_parameter_request.unsigned_16_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_16_value.format short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_16_value.format cut");
}

static void test_66(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x06, 0x01, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 65535u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_16_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_16_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_16_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_16_value.values: subindex");
    expect(out.format == 6u, "write_parameter_request.unsigned_16_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_16_value.values: values count");
    expect(out.values.unsigned_16_value[0] == 65535u, "write_parameter_request.unsigned_16_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_16_value.values short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_16_value.values cut");
}

static void test_67(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x42, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 66u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_16_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.unsigned_16_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_16_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_16_value.element_count: subindex");
    expect(out.format == 66u, "write_parameter_request.unsigned_16_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_16_value.element_count: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "write_parameter_request.unsigned_16_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_16_value.element_count short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_16_value.element_count cut");
}

static void test_68(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x42, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 66u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_16_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_16_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.unsigned_16_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_16_value.parameter_number: subindex");
    expect(out.format == 66u, "write_parameter_request.unsigned_16_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_16_value.parameter_number: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "write_parameter_request.unsigned_16_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_16_value.parameter_number short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_16_value.parameter_number cut");
}

static void test_69(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x42, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 66u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_16_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_16_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_16_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.unsigned_16_value.subindex: subindex");
    expect(out.format == 66u, "write_parameter_request.unsigned_16_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_16_value.subindex: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "write_parameter_request.unsigned_16_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_16_value.subindex short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_16_value.subindex cut");
}

static void test_70(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x42, 0x01, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 66u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_16_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_16_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_16_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_16_value.format: subindex");
    expect(out.format == 66u, "write_parameter_request.unsigned_16_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_16_value.format: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "write_parameter_request.unsigned_16_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_16_value.format short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_16_value.format cut");
}

static void test_71(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x42, 0x01, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 66u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 65535u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_16_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_16_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_16_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_16_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_16_value.values: subindex");
    expect(out.format == 66u, "write_parameter_request.unsigned_16_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_16_value.values: values count");
    expect(out.values.unsigned_16_value[0] == 65535u, "write_parameter_request.unsigned_16_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_16_value.values short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_16_value.values cut");
}

static void test_72(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x07, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 7u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_32_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.unsigned_32_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_32_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_32_value.element_count: subindex");
    expect(out.format == 7u, "write_parameter_request.unsigned_32_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_32_value.element_count: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "write_parameter_request.unsigned_32_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_32_value.element_count short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_32_value.element_count cut");
}

static void test_73(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x07, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 7u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_32_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_32_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.unsigned_32_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_32_value.parameter_number: subindex");
    expect(out.format == 7u, "write_parameter_request.unsigned_32_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_32_value.parameter_number: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "write_parameter_request.unsigned_32_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_32_value.parameter_number short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_32_value.parameter_number cut");
}

static void test_74(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x07, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 7u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_32_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_32_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_32_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.unsigned_32_value.subindex: subindex");
    expect(out.format == 7u, "write_parameter_request.unsigned_32_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_32_value.subindex: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "write_parameter_request.unsigned_32_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_32_value.subindex short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_32_value.subindex cut");
}

static void test_75(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x07, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 7u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_32_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_32_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_32_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_32_value.format: subindex");
    expect(out.format == 7u, "write_parameter_request.unsigned_32_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_32_value.format: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "write_parameter_request.unsigned_32_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_32_value.format short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_32_value.format cut");
}

static void test_76(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x07, 0x01, 0xFF, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 7u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 4294967295u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_32_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_32_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_32_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_32_value.values: subindex");
    expect(out.format == 7u, "write_parameter_request.unsigned_32_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_32_value.values: values count");
    expect(out.values.unsigned_32_value[0] == 4294967295u, "write_parameter_request.unsigned_32_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_32_value.values short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_32_value.values cut");
}

static void test_77(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x43, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 67u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_32_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.unsigned_32_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_32_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_32_value.element_count: subindex");
    expect(out.format == 67u, "write_parameter_request.unsigned_32_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_32_value.element_count: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "write_parameter_request.unsigned_32_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_32_value.element_count short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_32_value.element_count cut");
}

static void test_78(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x43, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 67u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_32_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_32_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.unsigned_32_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_32_value.parameter_number: subindex");
    expect(out.format == 67u, "write_parameter_request.unsigned_32_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_32_value.parameter_number: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "write_parameter_request.unsigned_32_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_32_value.parameter_number short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_32_value.parameter_number cut");
}

static void test_79(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x43, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 67u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_32_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_32_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_32_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.unsigned_32_value.subindex: subindex");
    expect(out.format == 67u, "write_parameter_request.unsigned_32_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_32_value.subindex: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "write_parameter_request.unsigned_32_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_32_value.subindex short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_32_value.subindex cut");
}

static void test_80(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x43, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 67u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_32_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_32_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_32_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_32_value.format: subindex");
    expect(out.format == 67u, "write_parameter_request.unsigned_32_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_32_value.format: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "write_parameter_request.unsigned_32_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_32_value.format short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_32_value.format cut");
}

static void test_81(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x43, 0x01, 0xFF, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 67u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 4294967295u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.unsigned_32_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.unsigned_32_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.unsigned_32_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.unsigned_32_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.unsigned_32_value.values: subindex");
    expect(out.format == 67u, "write_parameter_request.unsigned_32_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.unsigned_32_value.values: values count");
    expect(out.values.unsigned_32_value[0] == 4294967295u, "write_parameter_request.unsigned_32_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.unsigned_32_value.values short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.unsigned_32_value.values cut");
}

static void test_82(void)
{
    static const uint8_t wanted[] = {0x10, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x08, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 255u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 8u;
    in.values_count = 1u;
    in.values.floating_point_value[0] = hiwin_e_float_of(0x00000000u);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.floating_point_value.element_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.floating_point_value.element_count bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.floating_point_value.element_count decodes");
    expect(out.element_count == 255u, "write_parameter_request.floating_point_value.element_count: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.floating_point_value.element_count: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.floating_point_value.element_count: subindex");
    expect(out.format == 8u, "write_parameter_request.floating_point_value.element_count: format");
    expect(out.values_count == 1u, "write_parameter_request.floating_point_value.element_count: values count");
    expect(hiwin_e_bits_of(out.values.floating_point_value[0]) == 0x00000000u, "write_parameter_request.floating_point_value.element_count: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.floating_point_value.element_count short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.floating_point_value.element_count cut");
}

static void test_83(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x08, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 65535u;
    in.subindex = 0u;
    in.format = 8u;
    in.values_count = 1u;
    in.values.floating_point_value[0] = hiwin_e_float_of(0x00000000u);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.floating_point_value.parameter_number encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.floating_point_value.parameter_number bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.floating_point_value.parameter_number decodes");
    expect(out.element_count == 0u, "write_parameter_request.floating_point_value.parameter_number: element_count");
    expect(out.parameter_number == 65535u, "write_parameter_request.floating_point_value.parameter_number: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.floating_point_value.parameter_number: subindex");
    expect(out.format == 8u, "write_parameter_request.floating_point_value.parameter_number: format");
    expect(out.values_count == 1u, "write_parameter_request.floating_point_value.parameter_number: values count");
    expect(hiwin_e_bits_of(out.values.floating_point_value[0]) == 0x00000000u, "write_parameter_request.floating_point_value.parameter_number: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.floating_point_value.parameter_number short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.floating_point_value.parameter_number cut");
}

static void test_84(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x08, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 65535u;
    in.format = 8u;
    in.values_count = 1u;
    in.values.floating_point_value[0] = hiwin_e_float_of(0x00000000u);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.floating_point_value.subindex encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.floating_point_value.subindex bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.floating_point_value.subindex decodes");
    expect(out.element_count == 0u, "write_parameter_request.floating_point_value.subindex: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.floating_point_value.subindex: parameter_number");
    expect(out.subindex == 65535u, "write_parameter_request.floating_point_value.subindex: subindex");
    expect(out.format == 8u, "write_parameter_request.floating_point_value.subindex: format");
    expect(out.values_count == 1u, "write_parameter_request.floating_point_value.subindex: values count");
    expect(hiwin_e_bits_of(out.values.floating_point_value[0]) == 0x00000000u, "write_parameter_request.floating_point_value.subindex: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.floating_point_value.subindex short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.floating_point_value.subindex cut");
}

static void test_85(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x08, 0x01, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 8u;
    in.values_count = 1u;
    in.values.floating_point_value[0] = hiwin_e_float_of(0x00000000u);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.floating_point_value.format encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.floating_point_value.format bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.floating_point_value.format decodes");
    expect(out.element_count == 0u, "write_parameter_request.floating_point_value.format: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.floating_point_value.format: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.floating_point_value.format: subindex");
    expect(out.format == 8u, "write_parameter_request.floating_point_value.format: format");
    expect(out.values_count == 1u, "write_parameter_request.floating_point_value.format: values count");
    expect(hiwin_e_bits_of(out.values.floating_point_value[0]) == 0x00000000u, "write_parameter_request.floating_point_value.format: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.floating_point_value.format short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.floating_point_value.format cut");
}

static void test_86(void)
{
    static const uint8_t wanted[] = {0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x08, 0x01, 0xBF, 0xC0, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.element_count = 0u;
    in.parameter_number = 0u;
    in.subindex = 0u;
    in.format = 8u;
    in.values_count = 1u;
    in.values.floating_point_value[0] = hiwin_e_float_of(0xBFC00000u);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "write_parameter_request.floating_point_value.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_parameter_request.floating_point_value.values bytes");
    expect(hiwin_e_write_parameter_request_decode(bytes, length, &out) == HIWIN_E_OK, "write_parameter_request.floating_point_value.values decodes");
    expect(out.element_count == 0u, "write_parameter_request.floating_point_value.values: element_count");
    expect(out.parameter_number == 0u, "write_parameter_request.floating_point_value.values: parameter_number");
    expect(out.subindex == 0u, "write_parameter_request.floating_point_value.values: subindex");
    expect(out.format == 8u, "write_parameter_request.floating_point_value.values: format");
    expect(out.values_count == 1u, "write_parameter_request.floating_point_value.values: values count");
    expect(hiwin_e_bits_of(out.values.floating_point_value[0]) == 0xBFC00000u, "write_parameter_request.floating_point_value.values: values");
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "write_parameter_request.floating_point_value.values short");
    expect(hiwin_e_write_parameter_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "write_parameter_request.floating_point_value.values cut");
}

static void test_87(void)
{
    static const uint8_t unknown[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE];
    hiwin_e_write_parameter_request in;
    size_t length = 0;
    clear(&in, sizeof in);
    in.format = 255u;
    expect(hiwin_e_write_parameter_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_ERR_UNKNOWN_VALUE, "write_parameter_request chooses nothing");
    expect(hiwin_e_write_parameter_request_decode(unknown, sizeof unknown, &in) == HIWIN_E_ERR_UNKNOWN_VALUE, "write_parameter_request chooses nothing");
}

static void test_88(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_3_REQUEST_SIZE];
    hiwin_e_telegram_3_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 65535u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.encoder_1_control_word = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_3_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_3_request.control_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_3_request.control_word_1 bytes");
    expect(hiwin_e_telegram_3_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_3_request.control_word_1 decodes");
    expect(out.control_word_1 == 65535u, "telegram_3_request.control_word_1: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_3_request.control_word_1: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_3_request.control_word_1: control_word_2");
    expect(out.encoder_1_control_word == 0u, "telegram_3_request.control_word_1: encoder_1_control_word");
    expect(hiwin_e_telegram_3_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_3_request.control_word_1 short");
    expect(hiwin_e_telegram_3_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_3_request.control_word_1 cut");
}

static void test_89(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_3_REQUEST_SIZE];
    hiwin_e_telegram_3_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = 2147483647;
    in.control_word_2 = 0u;
    in.encoder_1_control_word = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_3_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_3_request.speed_setpoint_b encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_3_request.speed_setpoint_b bytes");
    expect(hiwin_e_telegram_3_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_3_request.speed_setpoint_b decodes");
    expect(out.control_word_1 == 0u, "telegram_3_request.speed_setpoint_b: control_word_1");
    expect(out.speed_setpoint_b == 2147483647, "telegram_3_request.speed_setpoint_b: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_3_request.speed_setpoint_b: control_word_2");
    expect(out.encoder_1_control_word == 0u, "telegram_3_request.speed_setpoint_b: encoder_1_control_word");
    expect(hiwin_e_telegram_3_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_3_request.speed_setpoint_b short");
    expect(hiwin_e_telegram_3_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_3_request.speed_setpoint_b cut");
}

static void test_90(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_3_REQUEST_SIZE];
    hiwin_e_telegram_3_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 65535u;
    in.encoder_1_control_word = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_3_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_3_request.control_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_3_request.control_word_2 bytes");
    expect(hiwin_e_telegram_3_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_3_request.control_word_2 decodes");
    expect(out.control_word_1 == 0u, "telegram_3_request.control_word_2: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_3_request.control_word_2: speed_setpoint_b");
    expect(out.control_word_2 == 65535u, "telegram_3_request.control_word_2: control_word_2");
    expect(out.encoder_1_control_word == 0u, "telegram_3_request.control_word_2: encoder_1_control_word");
    expect(hiwin_e_telegram_3_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_3_request.control_word_2 short");
    expect(hiwin_e_telegram_3_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_3_request.control_word_2 cut");
}

static void test_91(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_3_REQUEST_SIZE];
    hiwin_e_telegram_3_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.encoder_1_control_word = 65535u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_3_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_3_request.encoder_1_control_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_3_request.encoder_1_control_word bytes");
    expect(hiwin_e_telegram_3_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_3_request.encoder_1_control_word decodes");
    expect(out.control_word_1 == 0u, "telegram_3_request.encoder_1_control_word: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_3_request.encoder_1_control_word: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_3_request.encoder_1_control_word: control_word_2");
    expect(out.encoder_1_control_word == 65535u, "telegram_3_request.encoder_1_control_word: encoder_1_control_word");
    expect(hiwin_e_telegram_3_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_3_request.encoder_1_control_word short");
    expect(hiwin_e_telegram_3_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_3_request.encoder_1_control_word cut");
}

static void test_92(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_3_RESPONSE_SIZE];
    hiwin_e_telegram_3_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 65535u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_3_response.status_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_3_response.status_word_1 bytes");
    expect(hiwin_e_telegram_3_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_3_response.status_word_1 decodes");
    expect(out.status_word_1 == 65535u, "telegram_3_response.status_word_1: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_3_response.status_word_1: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_3_response.status_word_1: status_word_2");
    expect(out.encoder_1_status_word == 0u, "telegram_3_response.status_word_1: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_3_response.status_word_1: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_3_response.status_word_1: encoder_1_position_2");
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_3_response.status_word_1 short");
    expect(hiwin_e_telegram_3_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_3_response.status_word_1 cut");
}

static void test_93(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_3_RESPONSE_SIZE];
    hiwin_e_telegram_3_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = 2147483647;
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_3_response.speed_actual_b encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_3_response.speed_actual_b bytes");
    expect(hiwin_e_telegram_3_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_3_response.speed_actual_b decodes");
    expect(out.status_word_1 == 0u, "telegram_3_response.speed_actual_b: status_word_1");
    expect(out.speed_actual_b == 2147483647, "telegram_3_response.speed_actual_b: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_3_response.speed_actual_b: status_word_2");
    expect(out.encoder_1_status_word == 0u, "telegram_3_response.speed_actual_b: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_3_response.speed_actual_b: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_3_response.speed_actual_b: encoder_1_position_2");
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_3_response.speed_actual_b short");
    expect(hiwin_e_telegram_3_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_3_response.speed_actual_b cut");
}

static void test_94(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_3_RESPONSE_SIZE];
    hiwin_e_telegram_3_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 65535u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_3_response.status_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_3_response.status_word_2 bytes");
    expect(hiwin_e_telegram_3_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_3_response.status_word_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_3_response.status_word_2: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_3_response.status_word_2: speed_actual_b");
    expect(out.status_word_2 == 65535u, "telegram_3_response.status_word_2: status_word_2");
    expect(out.encoder_1_status_word == 0u, "telegram_3_response.status_word_2: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_3_response.status_word_2: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_3_response.status_word_2: encoder_1_position_2");
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_3_response.status_word_2 short");
    expect(hiwin_e_telegram_3_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_3_response.status_word_2 cut");
}

static void test_95(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_3_RESPONSE_SIZE];
    hiwin_e_telegram_3_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 65535u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_3_response.encoder_1_status_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_3_response.encoder_1_status_word bytes");
    expect(hiwin_e_telegram_3_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_3_response.encoder_1_status_word decodes");
    expect(out.status_word_1 == 0u, "telegram_3_response.encoder_1_status_word: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_3_response.encoder_1_status_word: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_3_response.encoder_1_status_word: status_word_2");
    expect(out.encoder_1_status_word == 65535u, "telegram_3_response.encoder_1_status_word: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_3_response.encoder_1_status_word: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_3_response.encoder_1_status_word: encoder_1_position_2");
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_3_response.encoder_1_status_word short");
    expect(hiwin_e_telegram_3_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_3_response.encoder_1_status_word cut");
}

static void test_96(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_3_RESPONSE_SIZE];
    hiwin_e_telegram_3_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = 2147483647;
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_3_response.encoder_1_position_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_3_response.encoder_1_position_1 bytes");
    expect(hiwin_e_telegram_3_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_3_response.encoder_1_position_1 decodes");
    expect(out.status_word_1 == 0u, "telegram_3_response.encoder_1_position_1: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_3_response.encoder_1_position_1: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_3_response.encoder_1_position_1: status_word_2");
    expect(out.encoder_1_status_word == 0u, "telegram_3_response.encoder_1_position_1: encoder_1_status_word");
    expect(out.encoder_1_position_1 == 2147483647, "telegram_3_response.encoder_1_position_1: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_3_response.encoder_1_position_1: encoder_1_position_2");
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_3_response.encoder_1_position_1 short");
    expect(hiwin_e_telegram_3_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_3_response.encoder_1_position_1 cut");
}

static void test_97(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_3_RESPONSE_SIZE];
    hiwin_e_telegram_3_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = 2147483647;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_3_response.encoder_1_position_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_3_response.encoder_1_position_2 bytes");
    expect(hiwin_e_telegram_3_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_3_response.encoder_1_position_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_3_response.encoder_1_position_2: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_3_response.encoder_1_position_2: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_3_response.encoder_1_position_2: status_word_2");
    expect(out.encoder_1_status_word == 0u, "telegram_3_response.encoder_1_position_2: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_3_response.encoder_1_position_2: encoder_1_position_1");
    expect(out.encoder_1_position_2 == 2147483647, "telegram_3_response.encoder_1_position_2: encoder_1_position_2");
    expect(hiwin_e_telegram_3_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_3_response.encoder_1_position_2 short");
    expect(hiwin_e_telegram_3_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_3_response.encoder_1_position_2 cut");
}

static void test_98(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_REQUEST_SIZE];
    hiwin_e_telegram_5_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 65535u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.encoder_1_control_word = 0u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_request.control_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_request.control_word_1 bytes");
    expect(hiwin_e_telegram_5_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_request.control_word_1 decodes");
    expect(out.control_word_1 == 65535u, "telegram_5_request.control_word_1: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_5_request.control_word_1: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_5_request.control_word_1: control_word_2");
    expect(out.encoder_1_control_word == 0u, "telegram_5_request.control_word_1: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_5_request.control_word_1: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_5_request.control_word_1: position_controller_gain");
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_request.control_word_1 short");
    expect(hiwin_e_telegram_5_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_request.control_word_1 cut");
}

static void test_99(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_REQUEST_SIZE];
    hiwin_e_telegram_5_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = 2147483647;
    in.control_word_2 = 0u;
    in.encoder_1_control_word = 0u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_request.speed_setpoint_b encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_request.speed_setpoint_b bytes");
    expect(hiwin_e_telegram_5_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_request.speed_setpoint_b decodes");
    expect(out.control_word_1 == 0u, "telegram_5_request.speed_setpoint_b: control_word_1");
    expect(out.speed_setpoint_b == 2147483647, "telegram_5_request.speed_setpoint_b: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_5_request.speed_setpoint_b: control_word_2");
    expect(out.encoder_1_control_word == 0u, "telegram_5_request.speed_setpoint_b: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_5_request.speed_setpoint_b: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_5_request.speed_setpoint_b: position_controller_gain");
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_request.speed_setpoint_b short");
    expect(hiwin_e_telegram_5_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_request.speed_setpoint_b cut");
}

static void test_100(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_REQUEST_SIZE];
    hiwin_e_telegram_5_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 65535u;
    in.encoder_1_control_word = 0u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_request.control_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_request.control_word_2 bytes");
    expect(hiwin_e_telegram_5_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_request.control_word_2 decodes");
    expect(out.control_word_1 == 0u, "telegram_5_request.control_word_2: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_5_request.control_word_2: speed_setpoint_b");
    expect(out.control_word_2 == 65535u, "telegram_5_request.control_word_2: control_word_2");
    expect(out.encoder_1_control_word == 0u, "telegram_5_request.control_word_2: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_5_request.control_word_2: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_5_request.control_word_2: position_controller_gain");
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_request.control_word_2 short");
    expect(hiwin_e_telegram_5_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_request.control_word_2 cut");
}

static void test_101(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_REQUEST_SIZE];
    hiwin_e_telegram_5_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.encoder_1_control_word = 65535u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_request.encoder_1_control_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_request.encoder_1_control_word bytes");
    expect(hiwin_e_telegram_5_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_request.encoder_1_control_word decodes");
    expect(out.control_word_1 == 0u, "telegram_5_request.encoder_1_control_word: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_5_request.encoder_1_control_word: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_5_request.encoder_1_control_word: control_word_2");
    expect(out.encoder_1_control_word == 65535u, "telegram_5_request.encoder_1_control_word: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_5_request.encoder_1_control_word: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_5_request.encoder_1_control_word: position_controller_gain");
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_request.encoder_1_control_word short");
    expect(hiwin_e_telegram_5_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_request.encoder_1_control_word cut");
}

static void test_102(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_REQUEST_SIZE];
    hiwin_e_telegram_5_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.encoder_1_control_word = 0u;
    in.position_error = 2147483647;
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_request.position_error encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_request.position_error bytes");
    expect(hiwin_e_telegram_5_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_request.position_error decodes");
    expect(out.control_word_1 == 0u, "telegram_5_request.position_error: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_5_request.position_error: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_5_request.position_error: control_word_2");
    expect(out.encoder_1_control_word == 0u, "telegram_5_request.position_error: encoder_1_control_word");
    expect(out.position_error == 2147483647, "telegram_5_request.position_error: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_5_request.position_error: position_controller_gain");
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_request.position_error short");
    expect(hiwin_e_telegram_5_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_request.position_error cut");
}

static void test_103(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_REQUEST_SIZE];
    hiwin_e_telegram_5_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.encoder_1_control_word = 0u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = 2147483647;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_request.position_controller_gain encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_request.position_controller_gain bytes");
    expect(hiwin_e_telegram_5_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_request.position_controller_gain decodes");
    expect(out.control_word_1 == 0u, "telegram_5_request.position_controller_gain: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_5_request.position_controller_gain: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_5_request.position_controller_gain: control_word_2");
    expect(out.encoder_1_control_word == 0u, "telegram_5_request.position_controller_gain: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_5_request.position_controller_gain: position_error");
    expect(out.position_controller_gain == 2147483647, "telegram_5_request.position_controller_gain: position_controller_gain");
    expect(hiwin_e_telegram_5_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_request.position_controller_gain short");
    expect(hiwin_e_telegram_5_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_request.position_controller_gain cut");
}

static void test_104(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_RESPONSE_SIZE];
    hiwin_e_telegram_5_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 65535u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_response.status_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_response.status_word_1 bytes");
    expect(hiwin_e_telegram_5_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_response.status_word_1 decodes");
    expect(out.status_word_1 == 65535u, "telegram_5_response.status_word_1: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_5_response.status_word_1: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_5_response.status_word_1: status_word_2");
    expect(out.encoder_1_status_word == 0u, "telegram_5_response.status_word_1: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_5_response.status_word_1: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_5_response.status_word_1: encoder_1_position_2");
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_response.status_word_1 short");
    expect(hiwin_e_telegram_5_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_response.status_word_1 cut");
}

static void test_105(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_RESPONSE_SIZE];
    hiwin_e_telegram_5_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = 2147483647;
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_response.speed_actual_b encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_response.speed_actual_b bytes");
    expect(hiwin_e_telegram_5_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_response.speed_actual_b decodes");
    expect(out.status_word_1 == 0u, "telegram_5_response.speed_actual_b: status_word_1");
    expect(out.speed_actual_b == 2147483647, "telegram_5_response.speed_actual_b: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_5_response.speed_actual_b: status_word_2");
    expect(out.encoder_1_status_word == 0u, "telegram_5_response.speed_actual_b: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_5_response.speed_actual_b: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_5_response.speed_actual_b: encoder_1_position_2");
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_response.speed_actual_b short");
    expect(hiwin_e_telegram_5_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_response.speed_actual_b cut");
}

static void test_106(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_RESPONSE_SIZE];
    hiwin_e_telegram_5_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 65535u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_response.status_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_response.status_word_2 bytes");
    expect(hiwin_e_telegram_5_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_response.status_word_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_5_response.status_word_2: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_5_response.status_word_2: speed_actual_b");
    expect(out.status_word_2 == 65535u, "telegram_5_response.status_word_2: status_word_2");
    expect(out.encoder_1_status_word == 0u, "telegram_5_response.status_word_2: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_5_response.status_word_2: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_5_response.status_word_2: encoder_1_position_2");
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_response.status_word_2 short");
    expect(hiwin_e_telegram_5_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_response.status_word_2 cut");
}

static void test_107(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_RESPONSE_SIZE];
    hiwin_e_telegram_5_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 65535u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_response.encoder_1_status_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_response.encoder_1_status_word bytes");
    expect(hiwin_e_telegram_5_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_response.encoder_1_status_word decodes");
    expect(out.status_word_1 == 0u, "telegram_5_response.encoder_1_status_word: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_5_response.encoder_1_status_word: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_5_response.encoder_1_status_word: status_word_2");
    expect(out.encoder_1_status_word == 65535u, "telegram_5_response.encoder_1_status_word: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_5_response.encoder_1_status_word: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_5_response.encoder_1_status_word: encoder_1_position_2");
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_response.encoder_1_status_word short");
    expect(hiwin_e_telegram_5_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_response.encoder_1_status_word cut");
}

static void test_108(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_RESPONSE_SIZE];
    hiwin_e_telegram_5_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = 2147483647;
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_response.encoder_1_position_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_response.encoder_1_position_1 bytes");
    expect(hiwin_e_telegram_5_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_response.encoder_1_position_1 decodes");
    expect(out.status_word_1 == 0u, "telegram_5_response.encoder_1_position_1: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_5_response.encoder_1_position_1: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_5_response.encoder_1_position_1: status_word_2");
    expect(out.encoder_1_status_word == 0u, "telegram_5_response.encoder_1_position_1: encoder_1_status_word");
    expect(out.encoder_1_position_1 == 2147483647, "telegram_5_response.encoder_1_position_1: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_5_response.encoder_1_position_1: encoder_1_position_2");
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_response.encoder_1_position_1 short");
    expect(hiwin_e_telegram_5_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_response.encoder_1_position_1 cut");
}

static void test_109(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_5_RESPONSE_SIZE];
    hiwin_e_telegram_5_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = 2147483647;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_5_response.encoder_1_position_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_5_response.encoder_1_position_2 bytes");
    expect(hiwin_e_telegram_5_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_5_response.encoder_1_position_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_5_response.encoder_1_position_2: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_5_response.encoder_1_position_2: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_5_response.encoder_1_position_2: status_word_2");
    expect(out.encoder_1_status_word == 0u, "telegram_5_response.encoder_1_position_2: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_5_response.encoder_1_position_2: encoder_1_position_1");
    expect(out.encoder_1_position_2 == 2147483647, "telegram_5_response.encoder_1_position_2: encoder_1_position_2");
    expect(hiwin_e_telegram_5_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_5_response.encoder_1_position_2 short");
    expect(hiwin_e_telegram_5_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_5_response.encoder_1_position_2 cut");
}

static void test_110(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_REQUEST_SIZE];
    hiwin_e_telegram_9_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 65535u;
    in.block_selection = 0u;
    in.control_word_2 = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    in.mdi_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_request.control_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_request.control_word_1 bytes");
    expect(hiwin_e_telegram_9_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_request.control_word_1 decodes");
    expect(out.control_word_1 == 65535u, "telegram_9_request.control_word_1: control_word_1");
    expect(out.block_selection == 0u, "telegram_9_request.control_word_1: block_selection");
    expect(out.control_word_2 == 0u, "telegram_9_request.control_word_1: control_word_2");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_9_request.control_word_1: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_9_request.control_word_1: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_9_request.control_word_1: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_9_request.control_word_1: mdi_deceleration");
    expect(out.mdi_mode == 0u, "telegram_9_request.control_word_1: mdi_mode");
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_request.control_word_1 short");
    expect(hiwin_e_telegram_9_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_request.control_word_1 cut");
}

static void test_111(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_REQUEST_SIZE];
    hiwin_e_telegram_9_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.block_selection = 65535u;
    in.control_word_2 = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    in.mdi_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_request.block_selection encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_request.block_selection bytes");
    expect(hiwin_e_telegram_9_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_request.block_selection decodes");
    expect(out.control_word_1 == 0u, "telegram_9_request.block_selection: control_word_1");
    expect(out.block_selection == 65535u, "telegram_9_request.block_selection: block_selection");
    expect(out.control_word_2 == 0u, "telegram_9_request.block_selection: control_word_2");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_9_request.block_selection: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_9_request.block_selection: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_9_request.block_selection: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_9_request.block_selection: mdi_deceleration");
    expect(out.mdi_mode == 0u, "telegram_9_request.block_selection: mdi_mode");
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_request.block_selection short");
    expect(hiwin_e_telegram_9_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_request.block_selection cut");
}

static void test_112(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_REQUEST_SIZE];
    hiwin_e_telegram_9_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.block_selection = 0u;
    in.control_word_2 = 65535u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    in.mdi_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_request.control_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_request.control_word_2 bytes");
    expect(hiwin_e_telegram_9_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_request.control_word_2 decodes");
    expect(out.control_word_1 == 0u, "telegram_9_request.control_word_2: control_word_1");
    expect(out.block_selection == 0u, "telegram_9_request.control_word_2: block_selection");
    expect(out.control_word_2 == 65535u, "telegram_9_request.control_word_2: control_word_2");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_9_request.control_word_2: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_9_request.control_word_2: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_9_request.control_word_2: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_9_request.control_word_2: mdi_deceleration");
    expect(out.mdi_mode == 0u, "telegram_9_request.control_word_2: mdi_mode");
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_request.control_word_2 short");
    expect(hiwin_e_telegram_9_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_request.control_word_2 cut");
}

static void test_113(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_REQUEST_SIZE];
    hiwin_e_telegram_9_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.block_selection = 0u;
    in.control_word_2 = 0u;
    in.mdi_target_position = 2147483647;
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    in.mdi_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_request.mdi_target_position encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_request.mdi_target_position bytes");
    expect(hiwin_e_telegram_9_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_request.mdi_target_position decodes");
    expect(out.control_word_1 == 0u, "telegram_9_request.mdi_target_position: control_word_1");
    expect(out.block_selection == 0u, "telegram_9_request.mdi_target_position: block_selection");
    expect(out.control_word_2 == 0u, "telegram_9_request.mdi_target_position: control_word_2");
    expect(out.mdi_target_position == 2147483647, "telegram_9_request.mdi_target_position: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_9_request.mdi_target_position: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_9_request.mdi_target_position: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_9_request.mdi_target_position: mdi_deceleration");
    expect(out.mdi_mode == 0u, "telegram_9_request.mdi_target_position: mdi_mode");
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_request.mdi_target_position short");
    expect(hiwin_e_telegram_9_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_request.mdi_target_position cut");
}

static void test_114(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_REQUEST_SIZE];
    hiwin_e_telegram_9_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.block_selection = 0u;
    in.control_word_2 = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 2147483647;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    in.mdi_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_request.mdi_velocity encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_request.mdi_velocity bytes");
    expect(hiwin_e_telegram_9_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_request.mdi_velocity decodes");
    expect(out.control_word_1 == 0u, "telegram_9_request.mdi_velocity: control_word_1");
    expect(out.block_selection == 0u, "telegram_9_request.mdi_velocity: block_selection");
    expect(out.control_word_2 == 0u, "telegram_9_request.mdi_velocity: control_word_2");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_9_request.mdi_velocity: mdi_target_position");
    expect(out.mdi_velocity == 2147483647, "telegram_9_request.mdi_velocity: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_9_request.mdi_velocity: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_9_request.mdi_velocity: mdi_deceleration");
    expect(out.mdi_mode == 0u, "telegram_9_request.mdi_velocity: mdi_mode");
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_request.mdi_velocity short");
    expect(hiwin_e_telegram_9_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_request.mdi_velocity cut");
}

static void test_115(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_REQUEST_SIZE];
    hiwin_e_telegram_9_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.block_selection = 0u;
    in.control_word_2 = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 16384u;
    in.mdi_deceleration = 0u;
    in.mdi_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_request.mdi_acceleration encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_request.mdi_acceleration bytes");
    expect(hiwin_e_telegram_9_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_request.mdi_acceleration decodes");
    expect(out.control_word_1 == 0u, "telegram_9_request.mdi_acceleration: control_word_1");
    expect(out.block_selection == 0u, "telegram_9_request.mdi_acceleration: block_selection");
    expect(out.control_word_2 == 0u, "telegram_9_request.mdi_acceleration: control_word_2");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_9_request.mdi_acceleration: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_9_request.mdi_acceleration: mdi_velocity");
    expect(out.mdi_acceleration == 16384u, "telegram_9_request.mdi_acceleration: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_9_request.mdi_acceleration: mdi_deceleration");
    expect(out.mdi_mode == 0u, "telegram_9_request.mdi_acceleration: mdi_mode");
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_request.mdi_acceleration short");
    expect(hiwin_e_telegram_9_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_request.mdi_acceleration cut");
}

static void test_116(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_REQUEST_SIZE];
    hiwin_e_telegram_9_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.block_selection = 0u;
    in.control_word_2 = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 16384u;
    in.mdi_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_request.mdi_deceleration encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_request.mdi_deceleration bytes");
    expect(hiwin_e_telegram_9_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_request.mdi_deceleration decodes");
    expect(out.control_word_1 == 0u, "telegram_9_request.mdi_deceleration: control_word_1");
    expect(out.block_selection == 0u, "telegram_9_request.mdi_deceleration: block_selection");
    expect(out.control_word_2 == 0u, "telegram_9_request.mdi_deceleration: control_word_2");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_9_request.mdi_deceleration: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_9_request.mdi_deceleration: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_9_request.mdi_deceleration: mdi_acceleration");
    expect(out.mdi_deceleration == 16384u, "telegram_9_request.mdi_deceleration: mdi_deceleration");
    expect(out.mdi_mode == 0u, "telegram_9_request.mdi_deceleration: mdi_mode");
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_request.mdi_deceleration short");
    expect(hiwin_e_telegram_9_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_request.mdi_deceleration cut");
}

static void test_117(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_REQUEST_SIZE];
    hiwin_e_telegram_9_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.block_selection = 0u;
    in.control_word_2 = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    in.mdi_mode = 65535u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_request.mdi_mode encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_request.mdi_mode bytes");
    expect(hiwin_e_telegram_9_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_request.mdi_mode decodes");
    expect(out.control_word_1 == 0u, "telegram_9_request.mdi_mode: control_word_1");
    expect(out.block_selection == 0u, "telegram_9_request.mdi_mode: block_selection");
    expect(out.control_word_2 == 0u, "telegram_9_request.mdi_mode: control_word_2");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_9_request.mdi_mode: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_9_request.mdi_mode: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_9_request.mdi_mode: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_9_request.mdi_mode: mdi_deceleration");
    expect(out.mdi_mode == 65535u, "telegram_9_request.mdi_mode: mdi_mode");
    expect(hiwin_e_telegram_9_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_request.mdi_mode short");
    expect(hiwin_e_telegram_9_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_request.mdi_mode cut");
}

static void test_118(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_RESPONSE_SIZE];
    hiwin_e_telegram_9_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 65535u;
    in.selected_block = 0u;
    in.status_word_2 = 0u;
    in.position_actual_a = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_response.status_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_response.status_word_1 bytes");
    expect(hiwin_e_telegram_9_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_response.status_word_1 decodes");
    expect(out.status_word_1 == 65535u, "telegram_9_response.status_word_1: status_word_1");
    expect(out.selected_block == 0u, "telegram_9_response.status_word_1: selected_block");
    expect(out.status_word_2 == 0u, "telegram_9_response.status_word_1: status_word_2");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_9_response.status_word_1: position_actual_a");
    expect(hiwin_e_telegram_9_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_response.status_word_1 short");
    expect(hiwin_e_telegram_9_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_response.status_word_1 cut");
}

static void test_119(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_RESPONSE_SIZE];
    hiwin_e_telegram_9_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.selected_block = 65535u;
    in.status_word_2 = 0u;
    in.position_actual_a = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_response.selected_block encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_response.selected_block bytes");
    expect(hiwin_e_telegram_9_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_response.selected_block decodes");
    expect(out.status_word_1 == 0u, "telegram_9_response.selected_block: status_word_1");
    expect(out.selected_block == 65535u, "telegram_9_response.selected_block: selected_block");
    expect(out.status_word_2 == 0u, "telegram_9_response.selected_block: status_word_2");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_9_response.selected_block: position_actual_a");
    expect(hiwin_e_telegram_9_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_response.selected_block short");
    expect(hiwin_e_telegram_9_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_response.selected_block cut");
}

static void test_120(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_RESPONSE_SIZE];
    hiwin_e_telegram_9_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.selected_block = 0u;
    in.status_word_2 = 65535u;
    in.position_actual_a = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_response.status_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_response.status_word_2 bytes");
    expect(hiwin_e_telegram_9_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_response.status_word_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_9_response.status_word_2: status_word_1");
    expect(out.selected_block == 0u, "telegram_9_response.status_word_2: selected_block");
    expect(out.status_word_2 == 65535u, "telegram_9_response.status_word_2: status_word_2");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_9_response.status_word_2: position_actual_a");
    expect(hiwin_e_telegram_9_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_response.status_word_2 short");
    expect(hiwin_e_telegram_9_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_response.status_word_2 cut");
}

static void test_121(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_9_RESPONSE_SIZE];
    hiwin_e_telegram_9_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.selected_block = 0u;
    in.status_word_2 = 0u;
    in.position_actual_a = 2147483647;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_9_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_9_response.position_actual_a encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_9_response.position_actual_a bytes");
    expect(hiwin_e_telegram_9_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_9_response.position_actual_a decodes");
    expect(out.status_word_1 == 0u, "telegram_9_response.position_actual_a: status_word_1");
    expect(out.selected_block == 0u, "telegram_9_response.position_actual_a: selected_block");
    expect(out.status_word_2 == 0u, "telegram_9_response.position_actual_a: status_word_2");
    expect(out.position_actual_a == 2147483647, "telegram_9_response.position_actual_a: position_actual_a");
    expect(hiwin_e_telegram_9_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_9_response.position_actual_a short");
    expect(hiwin_e_telegram_9_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_9_response.position_actual_a cut");
}

static void test_122(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_REQUEST_SIZE];
    hiwin_e_telegram_102_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 65535u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_request.control_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_request.control_word_1 bytes");
    expect(hiwin_e_telegram_102_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_request.control_word_1 decodes");
    expect(out.control_word_1 == 65535u, "telegram_102_request.control_word_1: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_102_request.control_word_1: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_102_request.control_word_1: control_word_2");
    expect(out.torque_reduction == 0u, "telegram_102_request.control_word_1: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "telegram_102_request.control_word_1: encoder_1_control_word");
    expect(hiwin_e_telegram_102_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_request.control_word_1 short");
    expect(hiwin_e_telegram_102_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_request.control_word_1 cut");
}

static void test_123(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_REQUEST_SIZE];
    hiwin_e_telegram_102_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = 2147483647;
    in.control_word_2 = 0u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_request.speed_setpoint_b encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_request.speed_setpoint_b bytes");
    expect(hiwin_e_telegram_102_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_request.speed_setpoint_b decodes");
    expect(out.control_word_1 == 0u, "telegram_102_request.speed_setpoint_b: control_word_1");
    expect(out.speed_setpoint_b == 2147483647, "telegram_102_request.speed_setpoint_b: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_102_request.speed_setpoint_b: control_word_2");
    expect(out.torque_reduction == 0u, "telegram_102_request.speed_setpoint_b: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "telegram_102_request.speed_setpoint_b: encoder_1_control_word");
    expect(hiwin_e_telegram_102_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_request.speed_setpoint_b short");
    expect(hiwin_e_telegram_102_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_request.speed_setpoint_b cut");
}

static void test_124(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_REQUEST_SIZE];
    hiwin_e_telegram_102_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 65535u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_request.control_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_request.control_word_2 bytes");
    expect(hiwin_e_telegram_102_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_request.control_word_2 decodes");
    expect(out.control_word_1 == 0u, "telegram_102_request.control_word_2: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_102_request.control_word_2: speed_setpoint_b");
    expect(out.control_word_2 == 65535u, "telegram_102_request.control_word_2: control_word_2");
    expect(out.torque_reduction == 0u, "telegram_102_request.control_word_2: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "telegram_102_request.control_word_2: encoder_1_control_word");
    expect(hiwin_e_telegram_102_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_request.control_word_2 short");
    expect(hiwin_e_telegram_102_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_request.control_word_2 cut");
}

static void test_125(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_REQUEST_SIZE];
    hiwin_e_telegram_102_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.torque_reduction = 16384u;
    in.encoder_1_control_word = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_request.torque_reduction encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_request.torque_reduction bytes");
    expect(hiwin_e_telegram_102_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_request.torque_reduction decodes");
    expect(out.control_word_1 == 0u, "telegram_102_request.torque_reduction: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_102_request.torque_reduction: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_102_request.torque_reduction: control_word_2");
    expect(out.torque_reduction == 16384u, "telegram_102_request.torque_reduction: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "telegram_102_request.torque_reduction: encoder_1_control_word");
    expect(hiwin_e_telegram_102_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_request.torque_reduction short");
    expect(hiwin_e_telegram_102_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_request.torque_reduction cut");
}

static void test_126(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_REQUEST_SIZE];
    hiwin_e_telegram_102_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 65535u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_request.encoder_1_control_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_request.encoder_1_control_word bytes");
    expect(hiwin_e_telegram_102_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_request.encoder_1_control_word decodes");
    expect(out.control_word_1 == 0u, "telegram_102_request.encoder_1_control_word: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_102_request.encoder_1_control_word: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_102_request.encoder_1_control_word: control_word_2");
    expect(out.torque_reduction == 0u, "telegram_102_request.encoder_1_control_word: torque_reduction");
    expect(out.encoder_1_control_word == 65535u, "telegram_102_request.encoder_1_control_word: encoder_1_control_word");
    expect(hiwin_e_telegram_102_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_request.encoder_1_control_word short");
    expect(hiwin_e_telegram_102_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_request.encoder_1_control_word cut");
}

static void test_127(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_RESPONSE_SIZE];
    hiwin_e_telegram_102_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 65535u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_response.status_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_response.status_word_1 bytes");
    expect(hiwin_e_telegram_102_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_response.status_word_1 decodes");
    expect(out.status_word_1 == 65535u, "telegram_102_response.status_word_1: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_102_response.status_word_1: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_102_response.status_word_1: status_word_2");
    expect(out.message_word == 0u, "telegram_102_response.status_word_1: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_102_response.status_word_1: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_102_response.status_word_1: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_102_response.status_word_1: encoder_1_position_2");
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_response.status_word_1 short");
    expect(hiwin_e_telegram_102_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_response.status_word_1 cut");
}

static void test_128(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_RESPONSE_SIZE];
    hiwin_e_telegram_102_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = 2147483647;
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_response.speed_actual_b encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_response.speed_actual_b bytes");
    expect(hiwin_e_telegram_102_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_response.speed_actual_b decodes");
    expect(out.status_word_1 == 0u, "telegram_102_response.speed_actual_b: status_word_1");
    expect(out.speed_actual_b == 2147483647, "telegram_102_response.speed_actual_b: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_102_response.speed_actual_b: status_word_2");
    expect(out.message_word == 0u, "telegram_102_response.speed_actual_b: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_102_response.speed_actual_b: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_102_response.speed_actual_b: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_102_response.speed_actual_b: encoder_1_position_2");
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_response.speed_actual_b short");
    expect(hiwin_e_telegram_102_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_response.speed_actual_b cut");
}

static void test_129(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_RESPONSE_SIZE];
    hiwin_e_telegram_102_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 65535u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_response.status_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_response.status_word_2 bytes");
    expect(hiwin_e_telegram_102_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_response.status_word_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_102_response.status_word_2: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_102_response.status_word_2: speed_actual_b");
    expect(out.status_word_2 == 65535u, "telegram_102_response.status_word_2: status_word_2");
    expect(out.message_word == 0u, "telegram_102_response.status_word_2: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_102_response.status_word_2: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_102_response.status_word_2: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_102_response.status_word_2: encoder_1_position_2");
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_response.status_word_2 short");
    expect(hiwin_e_telegram_102_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_response.status_word_2 cut");
}

static void test_130(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_RESPONSE_SIZE];
    hiwin_e_telegram_102_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.message_word = 65535u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_response.message_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_response.message_word bytes");
    expect(hiwin_e_telegram_102_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_response.message_word decodes");
    expect(out.status_word_1 == 0u, "telegram_102_response.message_word: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_102_response.message_word: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_102_response.message_word: status_word_2");
    expect(out.message_word == 65535u, "telegram_102_response.message_word: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_102_response.message_word: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_102_response.message_word: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_102_response.message_word: encoder_1_position_2");
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_response.message_word short");
    expect(hiwin_e_telegram_102_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_response.message_word cut");
}

static void test_131(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_RESPONSE_SIZE];
    hiwin_e_telegram_102_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.encoder_1_status_word = 65535u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_response.encoder_1_status_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_response.encoder_1_status_word bytes");
    expect(hiwin_e_telegram_102_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_response.encoder_1_status_word decodes");
    expect(out.status_word_1 == 0u, "telegram_102_response.encoder_1_status_word: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_102_response.encoder_1_status_word: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_102_response.encoder_1_status_word: status_word_2");
    expect(out.message_word == 0u, "telegram_102_response.encoder_1_status_word: message_word");
    expect(out.encoder_1_status_word == 65535u, "telegram_102_response.encoder_1_status_word: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_102_response.encoder_1_status_word: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_102_response.encoder_1_status_word: encoder_1_position_2");
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_response.encoder_1_status_word short");
    expect(hiwin_e_telegram_102_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_response.encoder_1_status_word cut");
}

static void test_132(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_RESPONSE_SIZE];
    hiwin_e_telegram_102_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = 2147483647;
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_response.encoder_1_position_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_response.encoder_1_position_1 bytes");
    expect(hiwin_e_telegram_102_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_response.encoder_1_position_1 decodes");
    expect(out.status_word_1 == 0u, "telegram_102_response.encoder_1_position_1: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_102_response.encoder_1_position_1: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_102_response.encoder_1_position_1: status_word_2");
    expect(out.message_word == 0u, "telegram_102_response.encoder_1_position_1: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_102_response.encoder_1_position_1: encoder_1_status_word");
    expect(out.encoder_1_position_1 == 2147483647, "telegram_102_response.encoder_1_position_1: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_102_response.encoder_1_position_1: encoder_1_position_2");
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_response.encoder_1_position_1 short");
    expect(hiwin_e_telegram_102_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_response.encoder_1_position_1 cut");
}

static void test_133(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_102_RESPONSE_SIZE];
    hiwin_e_telegram_102_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = 2147483647;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_102_response.encoder_1_position_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_102_response.encoder_1_position_2 bytes");
    expect(hiwin_e_telegram_102_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_102_response.encoder_1_position_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_102_response.encoder_1_position_2: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_102_response.encoder_1_position_2: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_102_response.encoder_1_position_2: status_word_2");
    expect(out.message_word == 0u, "telegram_102_response.encoder_1_position_2: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_102_response.encoder_1_position_2: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_102_response.encoder_1_position_2: encoder_1_position_1");
    expect(out.encoder_1_position_2 == 2147483647, "telegram_102_response.encoder_1_position_2: encoder_1_position_2");
    expect(hiwin_e_telegram_102_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_102_response.encoder_1_position_2 short");
    expect(hiwin_e_telegram_102_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_102_response.encoder_1_position_2 cut");
}

static void test_134(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_REQUEST_SIZE];
    hiwin_e_telegram_105_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 65535u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 0u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_request.control_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_request.control_word_1 bytes");
    expect(hiwin_e_telegram_105_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_request.control_word_1 decodes");
    expect(out.control_word_1 == 65535u, "telegram_105_request.control_word_1: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_105_request.control_word_1: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_105_request.control_word_1: control_word_2");
    expect(out.torque_reduction == 0u, "telegram_105_request.control_word_1: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "telegram_105_request.control_word_1: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_105_request.control_word_1: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_105_request.control_word_1: position_controller_gain");
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_request.control_word_1 short");
    expect(hiwin_e_telegram_105_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_request.control_word_1 cut");
}

static void test_135(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_REQUEST_SIZE];
    hiwin_e_telegram_105_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = 2147483647;
    in.control_word_2 = 0u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 0u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_request.speed_setpoint_b encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_request.speed_setpoint_b bytes");
    expect(hiwin_e_telegram_105_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_request.speed_setpoint_b decodes");
    expect(out.control_word_1 == 0u, "telegram_105_request.speed_setpoint_b: control_word_1");
    expect(out.speed_setpoint_b == 2147483647, "telegram_105_request.speed_setpoint_b: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_105_request.speed_setpoint_b: control_word_2");
    expect(out.torque_reduction == 0u, "telegram_105_request.speed_setpoint_b: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "telegram_105_request.speed_setpoint_b: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_105_request.speed_setpoint_b: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_105_request.speed_setpoint_b: position_controller_gain");
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_request.speed_setpoint_b short");
    expect(hiwin_e_telegram_105_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_request.speed_setpoint_b cut");
}

static void test_136(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_REQUEST_SIZE];
    hiwin_e_telegram_105_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 65535u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 0u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_request.control_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_request.control_word_2 bytes");
    expect(hiwin_e_telegram_105_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_request.control_word_2 decodes");
    expect(out.control_word_1 == 0u, "telegram_105_request.control_word_2: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_105_request.control_word_2: speed_setpoint_b");
    expect(out.control_word_2 == 65535u, "telegram_105_request.control_word_2: control_word_2");
    expect(out.torque_reduction == 0u, "telegram_105_request.control_word_2: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "telegram_105_request.control_word_2: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_105_request.control_word_2: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_105_request.control_word_2: position_controller_gain");
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_request.control_word_2 short");
    expect(hiwin_e_telegram_105_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_request.control_word_2 cut");
}

static void test_137(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_REQUEST_SIZE];
    hiwin_e_telegram_105_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.torque_reduction = 16384u;
    in.encoder_1_control_word = 0u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_request.torque_reduction encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_request.torque_reduction bytes");
    expect(hiwin_e_telegram_105_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_request.torque_reduction decodes");
    expect(out.control_word_1 == 0u, "telegram_105_request.torque_reduction: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_105_request.torque_reduction: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_105_request.torque_reduction: control_word_2");
    expect(out.torque_reduction == 16384u, "telegram_105_request.torque_reduction: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "telegram_105_request.torque_reduction: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_105_request.torque_reduction: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_105_request.torque_reduction: position_controller_gain");
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_request.torque_reduction short");
    expect(hiwin_e_telegram_105_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_request.torque_reduction cut");
}

static void test_138(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_REQUEST_SIZE];
    hiwin_e_telegram_105_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 65535u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_request.encoder_1_control_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_request.encoder_1_control_word bytes");
    expect(hiwin_e_telegram_105_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_request.encoder_1_control_word decodes");
    expect(out.control_word_1 == 0u, "telegram_105_request.encoder_1_control_word: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_105_request.encoder_1_control_word: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_105_request.encoder_1_control_word: control_word_2");
    expect(out.torque_reduction == 0u, "telegram_105_request.encoder_1_control_word: torque_reduction");
    expect(out.encoder_1_control_word == 65535u, "telegram_105_request.encoder_1_control_word: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_105_request.encoder_1_control_word: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_105_request.encoder_1_control_word: position_controller_gain");
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_request.encoder_1_control_word short");
    expect(hiwin_e_telegram_105_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_request.encoder_1_control_word cut");
}

static void test_139(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_REQUEST_SIZE];
    hiwin_e_telegram_105_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 0u;
    in.position_error = 2147483647;
    in.position_controller_gain = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_request.position_error encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_request.position_error bytes");
    expect(hiwin_e_telegram_105_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_request.position_error decodes");
    expect(out.control_word_1 == 0u, "telegram_105_request.position_error: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_105_request.position_error: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_105_request.position_error: control_word_2");
    expect(out.torque_reduction == 0u, "telegram_105_request.position_error: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "telegram_105_request.position_error: encoder_1_control_word");
    expect(out.position_error == 2147483647, "telegram_105_request.position_error: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "telegram_105_request.position_error: position_controller_gain");
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_request.position_error short");
    expect(hiwin_e_telegram_105_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_request.position_error cut");
}

static void test_140(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_REQUEST_SIZE];
    hiwin_e_telegram_105_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 0u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 0u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = 2147483647;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_request.position_controller_gain encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_request.position_controller_gain bytes");
    expect(hiwin_e_telegram_105_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_request.position_controller_gain decodes");
    expect(out.control_word_1 == 0u, "telegram_105_request.position_controller_gain: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "telegram_105_request.position_controller_gain: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "telegram_105_request.position_controller_gain: control_word_2");
    expect(out.torque_reduction == 0u, "telegram_105_request.position_controller_gain: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "telegram_105_request.position_controller_gain: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "telegram_105_request.position_controller_gain: position_error");
    expect(out.position_controller_gain == 2147483647, "telegram_105_request.position_controller_gain: position_controller_gain");
    expect(hiwin_e_telegram_105_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_request.position_controller_gain short");
    expect(hiwin_e_telegram_105_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_request.position_controller_gain cut");
}

static void test_141(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_RESPONSE_SIZE];
    hiwin_e_telegram_105_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 65535u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_response.status_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_response.status_word_1 bytes");
    expect(hiwin_e_telegram_105_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_response.status_word_1 decodes");
    expect(out.status_word_1 == 65535u, "telegram_105_response.status_word_1: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_105_response.status_word_1: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_105_response.status_word_1: status_word_2");
    expect(out.message_word == 0u, "telegram_105_response.status_word_1: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_105_response.status_word_1: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_105_response.status_word_1: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_105_response.status_word_1: encoder_1_position_2");
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_response.status_word_1 short");
    expect(hiwin_e_telegram_105_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_response.status_word_1 cut");
}

static void test_142(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_RESPONSE_SIZE];
    hiwin_e_telegram_105_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = 2147483647;
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_response.speed_actual_b encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_response.speed_actual_b bytes");
    expect(hiwin_e_telegram_105_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_response.speed_actual_b decodes");
    expect(out.status_word_1 == 0u, "telegram_105_response.speed_actual_b: status_word_1");
    expect(out.speed_actual_b == 2147483647, "telegram_105_response.speed_actual_b: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_105_response.speed_actual_b: status_word_2");
    expect(out.message_word == 0u, "telegram_105_response.speed_actual_b: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_105_response.speed_actual_b: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_105_response.speed_actual_b: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_105_response.speed_actual_b: encoder_1_position_2");
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_response.speed_actual_b short");
    expect(hiwin_e_telegram_105_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_response.speed_actual_b cut");
}

static void test_143(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_RESPONSE_SIZE];
    hiwin_e_telegram_105_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 65535u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_response.status_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_response.status_word_2 bytes");
    expect(hiwin_e_telegram_105_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_response.status_word_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_105_response.status_word_2: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_105_response.status_word_2: speed_actual_b");
    expect(out.status_word_2 == 65535u, "telegram_105_response.status_word_2: status_word_2");
    expect(out.message_word == 0u, "telegram_105_response.status_word_2: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_105_response.status_word_2: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_105_response.status_word_2: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_105_response.status_word_2: encoder_1_position_2");
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_response.status_word_2 short");
    expect(hiwin_e_telegram_105_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_response.status_word_2 cut");
}

static void test_144(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_RESPONSE_SIZE];
    hiwin_e_telegram_105_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.message_word = 65535u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_response.message_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_response.message_word bytes");
    expect(hiwin_e_telegram_105_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_response.message_word decodes");
    expect(out.status_word_1 == 0u, "telegram_105_response.message_word: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_105_response.message_word: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_105_response.message_word: status_word_2");
    expect(out.message_word == 65535u, "telegram_105_response.message_word: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_105_response.message_word: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_105_response.message_word: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_105_response.message_word: encoder_1_position_2");
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_response.message_word short");
    expect(hiwin_e_telegram_105_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_response.message_word cut");
}

static void test_145(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_RESPONSE_SIZE];
    hiwin_e_telegram_105_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.encoder_1_status_word = 65535u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_response.encoder_1_status_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_response.encoder_1_status_word bytes");
    expect(hiwin_e_telegram_105_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_response.encoder_1_status_word decodes");
    expect(out.status_word_1 == 0u, "telegram_105_response.encoder_1_status_word: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_105_response.encoder_1_status_word: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_105_response.encoder_1_status_word: status_word_2");
    expect(out.message_word == 0u, "telegram_105_response.encoder_1_status_word: message_word");
    expect(out.encoder_1_status_word == 65535u, "telegram_105_response.encoder_1_status_word: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_105_response.encoder_1_status_word: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_105_response.encoder_1_status_word: encoder_1_position_2");
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_response.encoder_1_status_word short");
    expect(hiwin_e_telegram_105_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_response.encoder_1_status_word cut");
}

static void test_146(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_RESPONSE_SIZE];
    hiwin_e_telegram_105_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = 2147483647;
    in.encoder_1_position_2 = (-2147483647 - 1);
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_response.encoder_1_position_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_response.encoder_1_position_1 bytes");
    expect(hiwin_e_telegram_105_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_response.encoder_1_position_1 decodes");
    expect(out.status_word_1 == 0u, "telegram_105_response.encoder_1_position_1: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_105_response.encoder_1_position_1: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_105_response.encoder_1_position_1: status_word_2");
    expect(out.message_word == 0u, "telegram_105_response.encoder_1_position_1: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_105_response.encoder_1_position_1: encoder_1_status_word");
    expect(out.encoder_1_position_1 == 2147483647, "telegram_105_response.encoder_1_position_1: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "telegram_105_response.encoder_1_position_1: encoder_1_position_2");
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_response.encoder_1_position_1 short");
    expect(hiwin_e_telegram_105_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_response.encoder_1_position_1 cut");
}

static void test_147(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_105_RESPONSE_SIZE];
    hiwin_e_telegram_105_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = 2147483647;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_105_response.encoder_1_position_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_105_response.encoder_1_position_2 bytes");
    expect(hiwin_e_telegram_105_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_105_response.encoder_1_position_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_105_response.encoder_1_position_2: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_105_response.encoder_1_position_2: speed_actual_b");
    expect(out.status_word_2 == 0u, "telegram_105_response.encoder_1_position_2: status_word_2");
    expect(out.message_word == 0u, "telegram_105_response.encoder_1_position_2: message_word");
    expect(out.encoder_1_status_word == 0u, "telegram_105_response.encoder_1_position_2: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "telegram_105_response.encoder_1_position_2: encoder_1_position_1");
    expect(out.encoder_1_position_2 == 2147483647, "telegram_105_response.encoder_1_position_2: encoder_1_position_2");
    expect(hiwin_e_telegram_105_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_105_response.encoder_1_position_2 short");
    expect(hiwin_e_telegram_105_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_105_response.encoder_1_position_2 cut");
}

static void test_148(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_REQUEST_SIZE];
    hiwin_e_telegram_111_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 65535u;
    in.positioning_control_word_1 = 0u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 0u;
    in.velocity_override = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_request.control_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_request.control_word_1 bytes");
    expect(hiwin_e_telegram_111_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_request.control_word_1 decodes");
    expect(out.control_word_1 == 65535u, "telegram_111_request.control_word_1: control_word_1");
    expect(out.positioning_control_word_1 == 0u, "telegram_111_request.control_word_1: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "telegram_111_request.control_word_1: positioning_control_word_2");
    expect(out.control_word_2 == 0u, "telegram_111_request.control_word_1: control_word_2");
    expect(out.velocity_override == 0u, "telegram_111_request.control_word_1: velocity_override");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_111_request.control_word_1: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_111_request.control_word_1: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_111_request.control_word_1: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_111_request.control_word_1: mdi_deceleration");
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_request.control_word_1 short");
    expect(hiwin_e_telegram_111_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_request.control_word_1 cut");
}

static void test_149(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_REQUEST_SIZE];
    hiwin_e_telegram_111_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.positioning_control_word_1 = 65535u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 0u;
    in.velocity_override = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_request.positioning_control_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_request.positioning_control_word_1 bytes");
    expect(hiwin_e_telegram_111_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_request.positioning_control_word_1 decodes");
    expect(out.control_word_1 == 0u, "telegram_111_request.positioning_control_word_1: control_word_1");
    expect(out.positioning_control_word_1 == 65535u, "telegram_111_request.positioning_control_word_1: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "telegram_111_request.positioning_control_word_1: positioning_control_word_2");
    expect(out.control_word_2 == 0u, "telegram_111_request.positioning_control_word_1: control_word_2");
    expect(out.velocity_override == 0u, "telegram_111_request.positioning_control_word_1: velocity_override");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_111_request.positioning_control_word_1: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_111_request.positioning_control_word_1: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_111_request.positioning_control_word_1: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_111_request.positioning_control_word_1: mdi_deceleration");
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_request.positioning_control_word_1 short");
    expect(hiwin_e_telegram_111_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_request.positioning_control_word_1 cut");
}

static void test_150(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_REQUEST_SIZE];
    hiwin_e_telegram_111_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.positioning_control_word_1 = 0u;
    in.positioning_control_word_2 = 65535u;
    in.control_word_2 = 0u;
    in.velocity_override = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_request.positioning_control_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_request.positioning_control_word_2 bytes");
    expect(hiwin_e_telegram_111_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_request.positioning_control_word_2 decodes");
    expect(out.control_word_1 == 0u, "telegram_111_request.positioning_control_word_2: control_word_1");
    expect(out.positioning_control_word_1 == 0u, "telegram_111_request.positioning_control_word_2: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 65535u, "telegram_111_request.positioning_control_word_2: positioning_control_word_2");
    expect(out.control_word_2 == 0u, "telegram_111_request.positioning_control_word_2: control_word_2");
    expect(out.velocity_override == 0u, "telegram_111_request.positioning_control_word_2: velocity_override");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_111_request.positioning_control_word_2: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_111_request.positioning_control_word_2: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_111_request.positioning_control_word_2: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_111_request.positioning_control_word_2: mdi_deceleration");
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_request.positioning_control_word_2 short");
    expect(hiwin_e_telegram_111_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_request.positioning_control_word_2 cut");
}

static void test_151(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_REQUEST_SIZE];
    hiwin_e_telegram_111_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.positioning_control_word_1 = 0u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 65535u;
    in.velocity_override = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_request.control_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_request.control_word_2 bytes");
    expect(hiwin_e_telegram_111_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_request.control_word_2 decodes");
    expect(out.control_word_1 == 0u, "telegram_111_request.control_word_2: control_word_1");
    expect(out.positioning_control_word_1 == 0u, "telegram_111_request.control_word_2: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "telegram_111_request.control_word_2: positioning_control_word_2");
    expect(out.control_word_2 == 65535u, "telegram_111_request.control_word_2: control_word_2");
    expect(out.velocity_override == 0u, "telegram_111_request.control_word_2: velocity_override");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_111_request.control_word_2: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_111_request.control_word_2: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_111_request.control_word_2: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_111_request.control_word_2: mdi_deceleration");
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_request.control_word_2 short");
    expect(hiwin_e_telegram_111_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_request.control_word_2 cut");
}

static void test_152(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_REQUEST_SIZE];
    hiwin_e_telegram_111_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.positioning_control_word_1 = 0u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 0u;
    in.velocity_override = 32767u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_request.velocity_override encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_request.velocity_override bytes");
    expect(hiwin_e_telegram_111_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_request.velocity_override decodes");
    expect(out.control_word_1 == 0u, "telegram_111_request.velocity_override: control_word_1");
    expect(out.positioning_control_word_1 == 0u, "telegram_111_request.velocity_override: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "telegram_111_request.velocity_override: positioning_control_word_2");
    expect(out.control_word_2 == 0u, "telegram_111_request.velocity_override: control_word_2");
    expect(out.velocity_override == 32767u, "telegram_111_request.velocity_override: velocity_override");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_111_request.velocity_override: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_111_request.velocity_override: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_111_request.velocity_override: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_111_request.velocity_override: mdi_deceleration");
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_request.velocity_override short");
    expect(hiwin_e_telegram_111_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_request.velocity_override cut");
}

static void test_153(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_REQUEST_SIZE];
    hiwin_e_telegram_111_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.positioning_control_word_1 = 0u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 0u;
    in.velocity_override = 0u;
    in.mdi_target_position = 2147483647;
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_request.mdi_target_position encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_request.mdi_target_position bytes");
    expect(hiwin_e_telegram_111_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_request.mdi_target_position decodes");
    expect(out.control_word_1 == 0u, "telegram_111_request.mdi_target_position: control_word_1");
    expect(out.positioning_control_word_1 == 0u, "telegram_111_request.mdi_target_position: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "telegram_111_request.mdi_target_position: positioning_control_word_2");
    expect(out.control_word_2 == 0u, "telegram_111_request.mdi_target_position: control_word_2");
    expect(out.velocity_override == 0u, "telegram_111_request.mdi_target_position: velocity_override");
    expect(out.mdi_target_position == 2147483647, "telegram_111_request.mdi_target_position: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_111_request.mdi_target_position: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_111_request.mdi_target_position: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_111_request.mdi_target_position: mdi_deceleration");
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_request.mdi_target_position short");
    expect(hiwin_e_telegram_111_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_request.mdi_target_position cut");
}

static void test_154(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_REQUEST_SIZE];
    hiwin_e_telegram_111_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.positioning_control_word_1 = 0u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 0u;
    in.velocity_override = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 2147483647;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_request.mdi_velocity encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_request.mdi_velocity bytes");
    expect(hiwin_e_telegram_111_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_request.mdi_velocity decodes");
    expect(out.control_word_1 == 0u, "telegram_111_request.mdi_velocity: control_word_1");
    expect(out.positioning_control_word_1 == 0u, "telegram_111_request.mdi_velocity: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "telegram_111_request.mdi_velocity: positioning_control_word_2");
    expect(out.control_word_2 == 0u, "telegram_111_request.mdi_velocity: control_word_2");
    expect(out.velocity_override == 0u, "telegram_111_request.mdi_velocity: velocity_override");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_111_request.mdi_velocity: mdi_target_position");
    expect(out.mdi_velocity == 2147483647, "telegram_111_request.mdi_velocity: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_111_request.mdi_velocity: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_111_request.mdi_velocity: mdi_deceleration");
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_request.mdi_velocity short");
    expect(hiwin_e_telegram_111_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_request.mdi_velocity cut");
}

static void test_155(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_REQUEST_SIZE];
    hiwin_e_telegram_111_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.positioning_control_word_1 = 0u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 0u;
    in.velocity_override = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 16384u;
    in.mdi_deceleration = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_request.mdi_acceleration encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_request.mdi_acceleration bytes");
    expect(hiwin_e_telegram_111_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_request.mdi_acceleration decodes");
    expect(out.control_word_1 == 0u, "telegram_111_request.mdi_acceleration: control_word_1");
    expect(out.positioning_control_word_1 == 0u, "telegram_111_request.mdi_acceleration: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "telegram_111_request.mdi_acceleration: positioning_control_word_2");
    expect(out.control_word_2 == 0u, "telegram_111_request.mdi_acceleration: control_word_2");
    expect(out.velocity_override == 0u, "telegram_111_request.mdi_acceleration: velocity_override");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_111_request.mdi_acceleration: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_111_request.mdi_acceleration: mdi_velocity");
    expect(out.mdi_acceleration == 16384u, "telegram_111_request.mdi_acceleration: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "telegram_111_request.mdi_acceleration: mdi_deceleration");
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_request.mdi_acceleration short");
    expect(hiwin_e_telegram_111_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_request.mdi_acceleration cut");
}

static void test_156(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_REQUEST_SIZE];
    hiwin_e_telegram_111_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.control_word_1 = 0u;
    in.positioning_control_word_1 = 0u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 0u;
    in.velocity_override = 0u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 16384u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_request.mdi_deceleration encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_request.mdi_deceleration bytes");
    expect(hiwin_e_telegram_111_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_request.mdi_deceleration decodes");
    expect(out.control_word_1 == 0u, "telegram_111_request.mdi_deceleration: control_word_1");
    expect(out.positioning_control_word_1 == 0u, "telegram_111_request.mdi_deceleration: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "telegram_111_request.mdi_deceleration: positioning_control_word_2");
    expect(out.control_word_2 == 0u, "telegram_111_request.mdi_deceleration: control_word_2");
    expect(out.velocity_override == 0u, "telegram_111_request.mdi_deceleration: velocity_override");
    expect(out.mdi_target_position == (-2147483647 - 1), "telegram_111_request.mdi_deceleration: mdi_target_position");
    expect(out.mdi_velocity == 0, "telegram_111_request.mdi_deceleration: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "telegram_111_request.mdi_deceleration: mdi_acceleration");
    expect(out.mdi_deceleration == 16384u, "telegram_111_request.mdi_deceleration: mdi_deceleration");
    expect(hiwin_e_telegram_111_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_request.mdi_deceleration short");
    expect(hiwin_e_telegram_111_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_request.mdi_deceleration cut");
}

static void test_157(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_RESPONSE_SIZE];
    hiwin_e_telegram_111_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 65535u;
    in.positioning_status_word_1 = 0u;
    in.positioning_status_word_2 = 0u;
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.position_actual_a = (-2147483647 - 1);
    in.speed_actual_b = (-2147483647 - 1);
    in.fault_code = 0u;
    in.warning_code = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_response.status_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_response.status_word_1 bytes");
    expect(hiwin_e_telegram_111_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_response.status_word_1 decodes");
    expect(out.status_word_1 == 65535u, "telegram_111_response.status_word_1: status_word_1");
    expect(out.positioning_status_word_1 == 0u, "telegram_111_response.status_word_1: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 0u, "telegram_111_response.status_word_1: positioning_status_word_2");
    expect(out.status_word_2 == 0u, "telegram_111_response.status_word_1: status_word_2");
    expect(out.message_word == 0u, "telegram_111_response.status_word_1: message_word");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_111_response.status_word_1: position_actual_a");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_111_response.status_word_1: speed_actual_b");
    expect(out.fault_code == 0u, "telegram_111_response.status_word_1: fault_code");
    expect(out.warning_code == 0u, "telegram_111_response.status_word_1: warning_code");
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_response.status_word_1 short");
    expect(hiwin_e_telegram_111_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_response.status_word_1 cut");
}

static void test_158(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_RESPONSE_SIZE];
    hiwin_e_telegram_111_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.positioning_status_word_1 = 65535u;
    in.positioning_status_word_2 = 0u;
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.position_actual_a = (-2147483647 - 1);
    in.speed_actual_b = (-2147483647 - 1);
    in.fault_code = 0u;
    in.warning_code = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_response.positioning_status_word_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_response.positioning_status_word_1 bytes");
    expect(hiwin_e_telegram_111_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_response.positioning_status_word_1 decodes");
    expect(out.status_word_1 == 0u, "telegram_111_response.positioning_status_word_1: status_word_1");
    expect(out.positioning_status_word_1 == 65535u, "telegram_111_response.positioning_status_word_1: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 0u, "telegram_111_response.positioning_status_word_1: positioning_status_word_2");
    expect(out.status_word_2 == 0u, "telegram_111_response.positioning_status_word_1: status_word_2");
    expect(out.message_word == 0u, "telegram_111_response.positioning_status_word_1: message_word");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_111_response.positioning_status_word_1: position_actual_a");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_111_response.positioning_status_word_1: speed_actual_b");
    expect(out.fault_code == 0u, "telegram_111_response.positioning_status_word_1: fault_code");
    expect(out.warning_code == 0u, "telegram_111_response.positioning_status_word_1: warning_code");
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_response.positioning_status_word_1 short");
    expect(hiwin_e_telegram_111_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_response.positioning_status_word_1 cut");
}

static void test_159(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_RESPONSE_SIZE];
    hiwin_e_telegram_111_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.positioning_status_word_1 = 0u;
    in.positioning_status_word_2 = 65535u;
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.position_actual_a = (-2147483647 - 1);
    in.speed_actual_b = (-2147483647 - 1);
    in.fault_code = 0u;
    in.warning_code = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_response.positioning_status_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_response.positioning_status_word_2 bytes");
    expect(hiwin_e_telegram_111_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_response.positioning_status_word_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_111_response.positioning_status_word_2: status_word_1");
    expect(out.positioning_status_word_1 == 0u, "telegram_111_response.positioning_status_word_2: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 65535u, "telegram_111_response.positioning_status_word_2: positioning_status_word_2");
    expect(out.status_word_2 == 0u, "telegram_111_response.positioning_status_word_2: status_word_2");
    expect(out.message_word == 0u, "telegram_111_response.positioning_status_word_2: message_word");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_111_response.positioning_status_word_2: position_actual_a");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_111_response.positioning_status_word_2: speed_actual_b");
    expect(out.fault_code == 0u, "telegram_111_response.positioning_status_word_2: fault_code");
    expect(out.warning_code == 0u, "telegram_111_response.positioning_status_word_2: warning_code");
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_response.positioning_status_word_2 short");
    expect(hiwin_e_telegram_111_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_response.positioning_status_word_2 cut");
}

static void test_160(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_RESPONSE_SIZE];
    hiwin_e_telegram_111_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.positioning_status_word_1 = 0u;
    in.positioning_status_word_2 = 0u;
    in.status_word_2 = 65535u;
    in.message_word = 0u;
    in.position_actual_a = (-2147483647 - 1);
    in.speed_actual_b = (-2147483647 - 1);
    in.fault_code = 0u;
    in.warning_code = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_response.status_word_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_response.status_word_2 bytes");
    expect(hiwin_e_telegram_111_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_response.status_word_2 decodes");
    expect(out.status_word_1 == 0u, "telegram_111_response.status_word_2: status_word_1");
    expect(out.positioning_status_word_1 == 0u, "telegram_111_response.status_word_2: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 0u, "telegram_111_response.status_word_2: positioning_status_word_2");
    expect(out.status_word_2 == 65535u, "telegram_111_response.status_word_2: status_word_2");
    expect(out.message_word == 0u, "telegram_111_response.status_word_2: message_word");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_111_response.status_word_2: position_actual_a");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_111_response.status_word_2: speed_actual_b");
    expect(out.fault_code == 0u, "telegram_111_response.status_word_2: fault_code");
    expect(out.warning_code == 0u, "telegram_111_response.status_word_2: warning_code");
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_response.status_word_2 short");
    expect(hiwin_e_telegram_111_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_response.status_word_2 cut");
}

static void test_161(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_RESPONSE_SIZE];
    hiwin_e_telegram_111_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.positioning_status_word_1 = 0u;
    in.positioning_status_word_2 = 0u;
    in.status_word_2 = 0u;
    in.message_word = 65535u;
    in.position_actual_a = (-2147483647 - 1);
    in.speed_actual_b = (-2147483647 - 1);
    in.fault_code = 0u;
    in.warning_code = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_response.message_word encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_response.message_word bytes");
    expect(hiwin_e_telegram_111_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_response.message_word decodes");
    expect(out.status_word_1 == 0u, "telegram_111_response.message_word: status_word_1");
    expect(out.positioning_status_word_1 == 0u, "telegram_111_response.message_word: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 0u, "telegram_111_response.message_word: positioning_status_word_2");
    expect(out.status_word_2 == 0u, "telegram_111_response.message_word: status_word_2");
    expect(out.message_word == 65535u, "telegram_111_response.message_word: message_word");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_111_response.message_word: position_actual_a");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_111_response.message_word: speed_actual_b");
    expect(out.fault_code == 0u, "telegram_111_response.message_word: fault_code");
    expect(out.warning_code == 0u, "telegram_111_response.message_word: warning_code");
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_response.message_word short");
    expect(hiwin_e_telegram_111_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_response.message_word cut");
}

static void test_162(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_RESPONSE_SIZE];
    hiwin_e_telegram_111_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.positioning_status_word_1 = 0u;
    in.positioning_status_word_2 = 0u;
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.position_actual_a = 2147483647;
    in.speed_actual_b = (-2147483647 - 1);
    in.fault_code = 0u;
    in.warning_code = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_response.position_actual_a encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_response.position_actual_a bytes");
    expect(hiwin_e_telegram_111_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_response.position_actual_a decodes");
    expect(out.status_word_1 == 0u, "telegram_111_response.position_actual_a: status_word_1");
    expect(out.positioning_status_word_1 == 0u, "telegram_111_response.position_actual_a: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 0u, "telegram_111_response.position_actual_a: positioning_status_word_2");
    expect(out.status_word_2 == 0u, "telegram_111_response.position_actual_a: status_word_2");
    expect(out.message_word == 0u, "telegram_111_response.position_actual_a: message_word");
    expect(out.position_actual_a == 2147483647, "telegram_111_response.position_actual_a: position_actual_a");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_111_response.position_actual_a: speed_actual_b");
    expect(out.fault_code == 0u, "telegram_111_response.position_actual_a: fault_code");
    expect(out.warning_code == 0u, "telegram_111_response.position_actual_a: warning_code");
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_response.position_actual_a short");
    expect(hiwin_e_telegram_111_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_response.position_actual_a cut");
}

static void test_163(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_RESPONSE_SIZE];
    hiwin_e_telegram_111_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.positioning_status_word_1 = 0u;
    in.positioning_status_word_2 = 0u;
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.position_actual_a = (-2147483647 - 1);
    in.speed_actual_b = 2147483647;
    in.fault_code = 0u;
    in.warning_code = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_response.speed_actual_b encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_response.speed_actual_b bytes");
    expect(hiwin_e_telegram_111_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_response.speed_actual_b decodes");
    expect(out.status_word_1 == 0u, "telegram_111_response.speed_actual_b: status_word_1");
    expect(out.positioning_status_word_1 == 0u, "telegram_111_response.speed_actual_b: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 0u, "telegram_111_response.speed_actual_b: positioning_status_word_2");
    expect(out.status_word_2 == 0u, "telegram_111_response.speed_actual_b: status_word_2");
    expect(out.message_word == 0u, "telegram_111_response.speed_actual_b: message_word");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_111_response.speed_actual_b: position_actual_a");
    expect(out.speed_actual_b == 2147483647, "telegram_111_response.speed_actual_b: speed_actual_b");
    expect(out.fault_code == 0u, "telegram_111_response.speed_actual_b: fault_code");
    expect(out.warning_code == 0u, "telegram_111_response.speed_actual_b: warning_code");
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_response.speed_actual_b short");
    expect(hiwin_e_telegram_111_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_response.speed_actual_b cut");
}

static void test_164(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_RESPONSE_SIZE];
    hiwin_e_telegram_111_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.positioning_status_word_1 = 0u;
    in.positioning_status_word_2 = 0u;
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.position_actual_a = (-2147483647 - 1);
    in.speed_actual_b = (-2147483647 - 1);
    in.fault_code = 65535u;
    in.warning_code = 0u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_response.fault_code encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_response.fault_code bytes");
    expect(hiwin_e_telegram_111_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_response.fault_code decodes");
    expect(out.status_word_1 == 0u, "telegram_111_response.fault_code: status_word_1");
    expect(out.positioning_status_word_1 == 0u, "telegram_111_response.fault_code: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 0u, "telegram_111_response.fault_code: positioning_status_word_2");
    expect(out.status_word_2 == 0u, "telegram_111_response.fault_code: status_word_2");
    expect(out.message_word == 0u, "telegram_111_response.fault_code: message_word");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_111_response.fault_code: position_actual_a");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_111_response.fault_code: speed_actual_b");
    expect(out.fault_code == 65535u, "telegram_111_response.fault_code: fault_code");
    expect(out.warning_code == 0u, "telegram_111_response.fault_code: warning_code");
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_response.fault_code short");
    expect(hiwin_e_telegram_111_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_response.fault_code cut");
}

static void test_165(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_111_RESPONSE_SIZE];
    hiwin_e_telegram_111_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.status_word_1 = 0u;
    in.positioning_status_word_1 = 0u;
    in.positioning_status_word_2 = 0u;
    in.status_word_2 = 0u;
    in.message_word = 0u;
    in.position_actual_a = (-2147483647 - 1);
    in.speed_actual_b = (-2147483647 - 1);
    in.fault_code = 0u;
    in.warning_code = 65535u;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_111_response.warning_code encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_111_response.warning_code bytes");
    expect(hiwin_e_telegram_111_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_111_response.warning_code decodes");
    expect(out.status_word_1 == 0u, "telegram_111_response.warning_code: status_word_1");
    expect(out.positioning_status_word_1 == 0u, "telegram_111_response.warning_code: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 0u, "telegram_111_response.warning_code: positioning_status_word_2");
    expect(out.status_word_2 == 0u, "telegram_111_response.warning_code: status_word_2");
    expect(out.message_word == 0u, "telegram_111_response.warning_code: message_word");
    expect(out.position_actual_a == (-2147483647 - 1), "telegram_111_response.warning_code: position_actual_a");
    expect(out.speed_actual_b == (-2147483647 - 1), "telegram_111_response.warning_code: speed_actual_b");
    expect(out.fault_code == 0u, "telegram_111_response.warning_code: fault_code");
    expect(out.warning_code == 65535u, "telegram_111_response.warning_code: warning_code");
    expect(hiwin_e_telegram_111_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_111_response.warning_code short");
    expect(hiwin_e_telegram_111_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_111_response.warning_code cut");
}

static void test_166(void)
{
    static const uint8_t wanted[] = {0x7F, 0xFF, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_750_REQUEST_SIZE];
    hiwin_e_telegram_750_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.additional_torque = 32767;
    in.positive_torque_limit = 0;
    in.negative_torque_limit = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_750_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_750_request.additional_torque encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_750_request.additional_torque bytes");
    expect(hiwin_e_telegram_750_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_750_request.additional_torque decodes");
    expect(out.additional_torque == 32767, "telegram_750_request.additional_torque: additional_torque");
    expect(out.positive_torque_limit == 0, "telegram_750_request.additional_torque: positive_torque_limit");
    expect(out.negative_torque_limit == 0, "telegram_750_request.additional_torque: negative_torque_limit");
    expect(hiwin_e_telegram_750_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_750_request.additional_torque short");
    expect(hiwin_e_telegram_750_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_750_request.additional_torque cut");
}

static void test_167(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x7F, 0xFF, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_750_REQUEST_SIZE];
    hiwin_e_telegram_750_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.additional_torque = (-32768);
    in.positive_torque_limit = 32767;
    in.negative_torque_limit = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_750_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_750_request.positive_torque_limit encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_750_request.positive_torque_limit bytes");
    expect(hiwin_e_telegram_750_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_750_request.positive_torque_limit decodes");
    expect(out.additional_torque == (-32768), "telegram_750_request.positive_torque_limit: additional_torque");
    expect(out.positive_torque_limit == 32767, "telegram_750_request.positive_torque_limit: positive_torque_limit");
    expect(out.negative_torque_limit == 0, "telegram_750_request.positive_torque_limit: negative_torque_limit");
    expect(hiwin_e_telegram_750_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_750_request.positive_torque_limit short");
    expect(hiwin_e_telegram_750_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_750_request.positive_torque_limit cut");
}

static void test_168(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[HIWIN_E_TELEGRAM_750_REQUEST_SIZE];
    hiwin_e_telegram_750_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.additional_torque = (-32768);
    in.positive_torque_limit = 0;
    in.negative_torque_limit = 0;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_750_request_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_750_request.negative_torque_limit encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_750_request.negative_torque_limit bytes");
    expect(hiwin_e_telegram_750_request_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_750_request.negative_torque_limit decodes");
    expect(out.additional_torque == (-32768), "telegram_750_request.negative_torque_limit: additional_torque");
    expect(out.positive_torque_limit == 0, "telegram_750_request.negative_torque_limit: positive_torque_limit");
    expect(out.negative_torque_limit == 0, "telegram_750_request.negative_torque_limit: negative_torque_limit");
    expect(hiwin_e_telegram_750_request_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_750_request.negative_torque_limit short");
    expect(hiwin_e_telegram_750_request_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_750_request.negative_torque_limit cut");
}

static void test_169(void)
{
    static const uint8_t wanted[] = {0x7F, 0xFF};
    uint8_t bytes[HIWIN_E_TELEGRAM_750_RESPONSE_SIZE];
    hiwin_e_telegram_750_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.torque_actual = 32767;
    copy(&in, &in, sizeof in);
    expect(hiwin_e_telegram_750_response_encode(&in, bytes, sizeof bytes, &length) == HIWIN_E_OK, "telegram_750_response.torque_actual encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "telegram_750_response.torque_actual bytes");
    expect(hiwin_e_telegram_750_response_decode(bytes, length, &out) == HIWIN_E_OK, "telegram_750_response.torque_actual decodes");
    expect(out.torque_actual == 32767, "telegram_750_response.torque_actual: torque_actual");
    expect(hiwin_e_telegram_750_response_encode(&in, bytes, sizeof wanted - 1, &length) == HIWIN_E_ERR_CAPACITY, "telegram_750_response.torque_actual short");
    expect(hiwin_e_telegram_750_response_decode(wanted, sizeof wanted - 1, &out) != HIWIN_E_OK, "telegram_750_response.torque_actual cut");
}

static void test_170(void)
{
    uint8_t bytes[2];
    hiwin_e_motor_type out = HIWIN_E_MOTOR_TYPE_ROTARY_SERVO;
    volatile hiwin_e_motor_type in = HIWIN_E_MOTOR_TYPE_LINEAR;
    in = HIWIN_E_MOTOR_TYPE_LINEAR;
    expect(hiwin_e_par_drive_parameters_motor_type_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.motor_type 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.motor_type 0 bytes");
    expect(hiwin_e_par_drive_parameters_motor_type_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.motor_type 0");
    expect(out == HIWIN_E_MOTOR_TYPE_LINEAR, "drive_parameters.motor_type 0");
    in = HIWIN_E_MOTOR_TYPE_DIRECT_DRIVE;
    expect(hiwin_e_par_drive_parameters_motor_type_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.motor_type 1");
    expect(same_bytes(bytes, "\000\001", 2u), "drive_parameters.motor_type 1 bytes");
    expect(hiwin_e_par_drive_parameters_motor_type_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.motor_type 1");
    expect(out == HIWIN_E_MOTOR_TYPE_DIRECT_DRIVE, "drive_parameters.motor_type 1");
    in = HIWIN_E_MOTOR_TYPE_ROTARY_SERVO;
    expect(hiwin_e_par_drive_parameters_motor_type_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.motor_type 2");
    expect(same_bytes(bytes, "\000\002", 2u), "drive_parameters.motor_type 2 bytes");
    expect(hiwin_e_par_drive_parameters_motor_type_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.motor_type 2");
    expect(out == HIWIN_E_MOTOR_TYPE_ROTARY_SERVO, "drive_parameters.motor_type 2");
}

static void test_171(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_inner_encoder_resolution_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.inner_encoder_resolution -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.inner_encoder_resolution -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_inner_encoder_resolution_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.inner_encoder_resolution -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.inner_encoder_resolution -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_inner_encoder_resolution_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.inner_encoder_resolution 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.inner_encoder_resolution 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_inner_encoder_resolution_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.inner_encoder_resolution 2147483647");
    expect(out == 2147483647, "drive_parameters.inner_encoder_resolution 2147483647");
}

static void test_172(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_digital_outputs_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.digital_outputs 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.digital_outputs 0 bytes");
    expect(hiwin_e_par_drive_parameters_digital_outputs_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.digital_outputs 0");
    expect(out == 0u, "drive_parameters.digital_outputs 0");
    in = 31u;
    expect(hiwin_e_par_drive_parameters_digital_outputs_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.digital_outputs 31");
    expect(same_bytes(bytes, "\000\037", 2u), "drive_parameters.digital_outputs 31 bytes");
    expect(hiwin_e_par_drive_parameters_digital_outputs_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.digital_outputs 31");
    expect(out == 31u, "drive_parameters.digital_outputs 31");
}

static void test_173(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_software_state_12_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.software_state_12 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.software_state_12 0 bytes");
    expect(hiwin_e_par_drive_parameters_software_state_12_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.software_state_12 0");
    expect(out == 0u, "drive_parameters.software_state_12 0");
    in = 65535u;
    expect(hiwin_e_par_drive_parameters_software_state_12_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.software_state_12 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "drive_parameters.software_state_12 65535 bytes");
    expect(hiwin_e_par_drive_parameters_software_state_12_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.software_state_12 65535");
    expect(out == 65535u, "drive_parameters.software_state_12 65535");
}

static void test_174(void)
{
    uint8_t bytes[2];
    hiwin_e_gantry_application_mode out = HIWIN_E_GANTRY_APPLICATION_MODE_CALIBRATE_YAW_AXIS;
    volatile hiwin_e_gantry_application_mode in = HIWIN_E_GANTRY_APPLICATION_MODE_START;
    in = HIWIN_E_GANTRY_APPLICATION_MODE_START;
    expect(hiwin_e_par_drive_parameters_gantry_application_mode_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_application_mode 1");
    expect(same_bytes(bytes, "\000\001", 2u), "drive_parameters.gantry_application_mode 1 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_application_mode_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_application_mode 1");
    expect(out == HIWIN_E_GANTRY_APPLICATION_MODE_START, "drive_parameters.gantry_application_mode 1");
    in = HIWIN_E_GANTRY_APPLICATION_MODE_STOP;
    expect(hiwin_e_par_drive_parameters_gantry_application_mode_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_application_mode 2");
    expect(same_bytes(bytes, "\000\002", 2u), "drive_parameters.gantry_application_mode 2 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_application_mode_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_application_mode 2");
    expect(out == HIWIN_E_GANTRY_APPLICATION_MODE_STOP, "drive_parameters.gantry_application_mode 2");
    in = HIWIN_E_GANTRY_APPLICATION_MODE_CALIBRATE_YAW_AXIS;
    expect(hiwin_e_par_drive_parameters_gantry_application_mode_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_application_mode 11");
    expect(same_bytes(bytes, "\000\013", 2u), "drive_parameters.gantry_application_mode 11 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_application_mode_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_application_mode 11");
    expect(out == HIWIN_E_GANTRY_APPLICATION_MODE_CALIBRATE_YAW_AXIS, "drive_parameters.gantry_application_mode 11");
}

static void test_175(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_yaw_target_position_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.yaw_target_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.yaw_target_position -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_yaw_target_position_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.yaw_target_position -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.yaw_target_position -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_yaw_target_position_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.yaw_target_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.yaw_target_position 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_yaw_target_position_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.yaw_target_position 2147483647");
    expect(out == 2147483647, "drive_parameters.yaw_target_position 2147483647");
}

static void test_176(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_yaw_feedback_position_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.yaw_feedback_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.yaw_feedback_position -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_yaw_feedback_position_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.yaw_feedback_position -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.yaw_feedback_position -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_yaw_feedback_position_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.yaw_feedback_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.yaw_feedback_position 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_yaw_feedback_position_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.yaw_feedback_position 2147483647");
    expect(out == 2147483647, "drive_parameters.yaw_feedback_position 2147483647");
}

static void test_177(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_master_feedback_position_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.master_feedback_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.master_feedback_position -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_master_feedback_position_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.master_feedback_position -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.master_feedback_position -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_master_feedback_position_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.master_feedback_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.master_feedback_position 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_master_feedback_position_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.master_feedback_position 2147483647");
    expect(out == 2147483647, "drive_parameters.master_feedback_position 2147483647");
}

static void test_178(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_slave_feedback_position_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.slave_feedback_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.slave_feedback_position -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_slave_feedback_position_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.slave_feedback_position -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.slave_feedback_position -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_slave_feedback_position_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.slave_feedback_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.slave_feedback_position 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_slave_feedback_position_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.slave_feedback_position 2147483647");
    expect(out == 2147483647, "drive_parameters.slave_feedback_position 2147483647");
}

static void test_179(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_reference_mark_functions_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.reference_mark_functions 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.reference_mark_functions 0 bytes");
    expect(hiwin_e_par_drive_parameters_reference_mark_functions_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.reference_mark_functions 0");
    expect(out == 0u, "drive_parameters.reference_mark_functions 0");
    in = 3u;
    expect(hiwin_e_par_drive_parameters_reference_mark_functions_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.reference_mark_functions 3");
    expect(same_bytes(bytes, "\000\003", 2u), "drive_parameters.reference_mark_functions 3 bytes");
    expect(hiwin_e_par_drive_parameters_reference_mark_functions_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.reference_mark_functions 3");
    expect(out == 3u, "drive_parameters.reference_mark_functions 3");
}

static void test_180(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-10000);
    expect(hiwin_e_par_drive_parameters_speed_analog_input_voltage_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.speed_analog_input_voltage -10000");
    expect(same_bytes(bytes, "\330\360", 2u), "drive_parameters.speed_analog_input_voltage -10000 bytes");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_voltage_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.speed_analog_input_voltage -10000");
    expect(out == (-10000), "drive_parameters.speed_analog_input_voltage -10000");
    in = 10000;
    expect(hiwin_e_par_drive_parameters_speed_analog_input_voltage_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.speed_analog_input_voltage 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "drive_parameters.speed_analog_input_voltage 10000 bytes");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_voltage_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.speed_analog_input_voltage 10000");
    expect(out == 10000, "drive_parameters.speed_analog_input_voltage 10000");
}

static void test_181(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-10000);
    expect(hiwin_e_par_drive_parameters_speed_analog_input_offset_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.speed_analog_input_offset -10000");
    expect(same_bytes(bytes, "\330\360", 2u), "drive_parameters.speed_analog_input_offset -10000 bytes");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_offset_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.speed_analog_input_offset -10000");
    expect(out == (-10000), "drive_parameters.speed_analog_input_offset -10000");
    in = 10000;
    expect(hiwin_e_par_drive_parameters_speed_analog_input_offset_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.speed_analog_input_offset 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "drive_parameters.speed_analog_input_offset 10000 bytes");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_offset_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.speed_analog_input_offset 10000");
    expect(out == 10000, "drive_parameters.speed_analog_input_offset 10000");
}

static void test_182(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-10000);
    expect(hiwin_e_par_drive_parameters_torque_analog_input_voltage_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.torque_analog_input_voltage -10000");
    expect(same_bytes(bytes, "\330\360", 2u), "drive_parameters.torque_analog_input_voltage -10000 bytes");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_voltage_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.torque_analog_input_voltage -10000");
    expect(out == (-10000), "drive_parameters.torque_analog_input_voltage -10000");
    in = 10000;
    expect(hiwin_e_par_drive_parameters_torque_analog_input_voltage_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.torque_analog_input_voltage 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "drive_parameters.torque_analog_input_voltage 10000 bytes");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_voltage_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.torque_analog_input_voltage 10000");
    expect(out == 10000, "drive_parameters.torque_analog_input_voltage 10000");
}

static void test_183(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-10000);
    expect(hiwin_e_par_drive_parameters_torque_analog_input_offset_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.torque_analog_input_offset -10000");
    expect(same_bytes(bytes, "\330\360", 2u), "drive_parameters.torque_analog_input_offset -10000 bytes");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_offset_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.torque_analog_input_offset -10000");
    expect(out == (-10000), "drive_parameters.torque_analog_input_offset -10000");
    in = 10000;
    expect(hiwin_e_par_drive_parameters_torque_analog_input_offset_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.torque_analog_input_offset 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "drive_parameters.torque_analog_input_offset 10000 bytes");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_offset_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.torque_analog_input_offset 10000");
    expect(out == 10000, "drive_parameters.torque_analog_input_offset 10000");
}

static void test_184(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-10000);
    expect(hiwin_e_par_drive_parameters_analog_output_1_voltage_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.analog_output_1_voltage -10000");
    expect(same_bytes(bytes, "\330\360", 2u), "drive_parameters.analog_output_1_voltage -10000 bytes");
    expect(hiwin_e_par_drive_parameters_analog_output_1_voltage_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.analog_output_1_voltage -10000");
    expect(out == (-10000), "drive_parameters.analog_output_1_voltage -10000");
    in = 10000;
    expect(hiwin_e_par_drive_parameters_analog_output_1_voltage_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.analog_output_1_voltage 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "drive_parameters.analog_output_1_voltage 10000 bytes");
    expect(hiwin_e_par_drive_parameters_analog_output_1_voltage_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.analog_output_1_voltage 10000");
    expect(out == 10000, "drive_parameters.analog_output_1_voltage 10000");
}

static void test_185(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-10000);
    expect(hiwin_e_par_drive_parameters_analog_output_2_voltage_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.analog_output_2_voltage -10000");
    expect(same_bytes(bytes, "\330\360", 2u), "drive_parameters.analog_output_2_voltage -10000 bytes");
    expect(hiwin_e_par_drive_parameters_analog_output_2_voltage_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.analog_output_2_voltage -10000");
    expect(out == (-10000), "drive_parameters.analog_output_2_voltage -10000");
    in = 10000;
    expect(hiwin_e_par_drive_parameters_analog_output_2_voltage_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.analog_output_2_voltage 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "drive_parameters.analog_output_2_voltage 10000 bytes");
    expect(hiwin_e_par_drive_parameters_analog_output_2_voltage_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.analog_output_2_voltage 10000");
    expect(out == 10000, "drive_parameters.analog_output_2_voltage 10000");
}

static void test_186(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_position_trigger_array_value_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_array_value -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.position_trigger_array_value -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_array_value_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_array_value -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.position_trigger_array_value -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_position_trigger_array_value_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_array_value 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.position_trigger_array_value 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_array_value_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_array_value 2147483647");
    expect(out == 2147483647, "drive_parameters.position_trigger_array_value 2147483647");
}

static void test_187(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_position_trigger_array_index_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_array_index 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.position_trigger_array_index 0 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_array_index_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_array_index 0");
    expect(out == 0u, "drive_parameters.position_trigger_array_index 0");
    in = 255u;
    expect(hiwin_e_par_drive_parameters_position_trigger_array_index_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_array_index 255");
    expect(same_bytes(bytes, "\000\377", 2u), "drive_parameters.position_trigger_array_index 255 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_array_index_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_array_index 255");
    expect(out == 255u, "drive_parameters.position_trigger_array_index 255");
}

static void test_188(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_position_trigger_array_control_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_array_control 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.position_trigger_array_control 0 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_array_control_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_array_control 0");
    expect(out == 0u, "drive_parameters.position_trigger_array_control 0");
    in = 65535u;
    expect(hiwin_e_par_drive_parameters_position_trigger_array_control_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_array_control 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "drive_parameters.position_trigger_array_control 65535 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_array_control_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_array_control 65535");
    expect(out == 65535u, "drive_parameters.position_trigger_array_control 65535");
}

static void test_189(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_position_trigger_error_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_error 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.position_trigger_error 0 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_error_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_error 0");
    expect(out == 0u, "drive_parameters.position_trigger_error 0");
    in = 65535u;
    expect(hiwin_e_par_drive_parameters_position_trigger_error_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_error 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "drive_parameters.position_trigger_error 65535 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_error_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_error 65535");
    expect(out == 65535u, "drive_parameters.position_trigger_error 65535");
}

static void test_190(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = 0;
    expect(hiwin_e_par_drive_parameters_position_trigger_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_status 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.position_trigger_status 0 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_status 0");
    expect(out == 0, "drive_parameters.position_trigger_status 0");
    in = 32767;
    expect(hiwin_e_par_drive_parameters_position_trigger_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_status 32767");
    expect(same_bytes(bytes, "\177\377", 2u), "drive_parameters.position_trigger_status 32767 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_status 32767");
    expect(out == 32767, "drive_parameters.position_trigger_status 32767");
}

static void test_191(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_expected_position_trigger_count_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.expected_position_trigger_count 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.expected_position_trigger_count 0 bytes");
    expect(hiwin_e_par_drive_parameters_expected_position_trigger_count_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.expected_position_trigger_count 0");
    expect(out == 0u, "drive_parameters.expected_position_trigger_count 0");
    in = 65535u;
    expect(hiwin_e_par_drive_parameters_expected_position_trigger_count_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.expected_position_trigger_count 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "drive_parameters.expected_position_trigger_count 65535 bytes");
    expect(hiwin_e_par_drive_parameters_expected_position_trigger_count_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.expected_position_trigger_count 65535");
    expect(out == 65535u, "drive_parameters.expected_position_trigger_count 65535");
}

static void test_192(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_position_trigger_count_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_count 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.position_trigger_count 0 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_count_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_count 0");
    expect(out == 0u, "drive_parameters.position_trigger_count 0");
    in = 65535u;
    expect(hiwin_e_par_drive_parameters_position_trigger_count_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.position_trigger_count 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "drive_parameters.position_trigger_count 65535 bytes");
    expect(hiwin_e_par_drive_parameters_position_trigger_count_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.position_trigger_count 65535");
    expect(out == 65535u, "drive_parameters.position_trigger_count 65535");
}

static void test_193(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_remaining_position_trigger_count_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.remaining_position_trigger_count 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.remaining_position_trigger_count 0 bytes");
    expect(hiwin_e_par_drive_parameters_remaining_position_trigger_count_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.remaining_position_trigger_count 0");
    expect(out == 0u, "drive_parameters.remaining_position_trigger_count 0");
    in = 65535u;
    expect(hiwin_e_par_drive_parameters_remaining_position_trigger_count_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.remaining_position_trigger_count 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "drive_parameters.remaining_position_trigger_count 65535 bytes");
    expect(hiwin_e_par_drive_parameters_remaining_position_trigger_count_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.remaining_position_trigger_count 65535");
    expect(out == 65535u, "drive_parameters.remaining_position_trigger_count 65535");
}

static void test_194(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 8192u;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_index_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_index 8192");
    expect(same_bytes(bytes, "\040\000", 2u), "drive_parameters.gantry_parameter_index 8192 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_index_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_index 8192");
    expect(out == 8192u, "drive_parameters.gantry_parameter_index 8192");
    in = 20479u;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_index_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_index 20479");
    expect(same_bytes(bytes, "\117\377", 2u), "drive_parameters.gantry_parameter_index 20479 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_index_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_index 20479");
    expect(out == 20479u, "drive_parameters.gantry_parameter_index 20479");
}

static void test_195(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_subindex_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_subindex 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.gantry_parameter_subindex 0 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_subindex_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_subindex 0");
    expect(out == 0u, "drive_parameters.gantry_parameter_subindex 0");
}

static void test_196(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile int16_t in = 0;
    in = (-3);
    expect(hiwin_e_par_drive_parameters_gantry_parameter_type_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_type -3");
    expect(same_bytes(bytes, "\377\375", 2u), "drive_parameters.gantry_parameter_type -3 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_type_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_type -3");
    expect(out == (-3), "drive_parameters.gantry_parameter_type -3");
    in = 8;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_type_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_type 8");
    expect(same_bytes(bytes, "\000\010", 2u), "drive_parameters.gantry_parameter_type 8 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_type_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_type 8");
    expect(out == 8, "drive_parameters.gantry_parameter_type 8");
}

static void test_197(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile hiwin_e_gantry_parameter_command in = HIWIN_E_GANTRY_PARAMETER_COMMAND_IDLE;
    in = HIWIN_E_GANTRY_PARAMETER_COMMAND_IDLE;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_command_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_command 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.gantry_parameter_command 0 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_command_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_command 0");
    expect(out == 0u, "drive_parameters.gantry_parameter_command 0");
    in = HIWIN_E_GANTRY_PARAMETER_COMMAND_WRITE;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_command_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_command 1");
    expect(same_bytes(bytes, "\000\001", 2u), "drive_parameters.gantry_parameter_command 1 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_command_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_command 1");
    expect(out == 1u, "drive_parameters.gantry_parameter_command 1");
    in = HIWIN_E_GANTRY_PARAMETER_COMMAND_READ_ONCE;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_command_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_command 2");
    expect(same_bytes(bytes, "\000\002", 2u), "drive_parameters.gantry_parameter_command 2 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_command_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_command 2");
    expect(out == 2u, "drive_parameters.gantry_parameter_command 2");
    in = HIWIN_E_GANTRY_PARAMETER_COMMAND_READ_CONTINUOUSLY;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_command_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_command 3");
    expect(same_bytes(bytes, "\000\003", 2u), "drive_parameters.gantry_parameter_command 3 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_command_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_command 3");
    expect(out == 3u, "drive_parameters.gantry_parameter_command 3");
}

static void test_198(void)
{
    uint8_t bytes[2];
    hiwin_e_gantry_parameter_status out = HIWIN_E_GANTRY_PARAMETER_STATUS_SUCCEEDED;
    volatile hiwin_e_gantry_parameter_status in = HIWIN_E_GANTRY_PARAMETER_STATUS_TIMEOUT;
    in = HIWIN_E_GANTRY_PARAMETER_STATUS_TIMEOUT;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -6");
    expect(same_bytes(bytes, "\377\372", 2u), "drive_parameters.gantry_parameter_status -6 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -6");
    expect(out == HIWIN_E_GANTRY_PARAMETER_STATUS_TIMEOUT, "drive_parameters.gantry_parameter_status -6");
    in = HIWIN_E_GANTRY_PARAMETER_STATUS_COMMAND_NOT_SUPPORTED;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -5");
    expect(same_bytes(bytes, "\377\373", 2u), "drive_parameters.gantry_parameter_status -5 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -5");
    expect(out == HIWIN_E_GANTRY_PARAMETER_STATUS_COMMAND_NOT_SUPPORTED, "drive_parameters.gantry_parameter_status -5");
    in = HIWIN_E_GANTRY_PARAMETER_STATUS_READ_ONLY;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -4");
    expect(same_bytes(bytes, "\377\374", 2u), "drive_parameters.gantry_parameter_status -4 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -4");
    expect(out == HIWIN_E_GANTRY_PARAMETER_STATUS_READ_ONLY, "drive_parameters.gantry_parameter_status -4");
    in = HIWIN_E_GANTRY_PARAMETER_STATUS_VALUE_TOO_LARGE;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -3");
    expect(same_bytes(bytes, "\377\375", 2u), "drive_parameters.gantry_parameter_status -3 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -3");
    expect(out == HIWIN_E_GANTRY_PARAMETER_STATUS_VALUE_TOO_LARGE, "drive_parameters.gantry_parameter_status -3");
    in = HIWIN_E_GANTRY_PARAMETER_STATUS_NOT_ACCESSIBLE;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -2");
    expect(same_bytes(bytes, "\377\376", 2u), "drive_parameters.gantry_parameter_status -2 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -2");
    expect(out == HIWIN_E_GANTRY_PARAMETER_STATUS_NOT_ACCESSIBLE, "drive_parameters.gantry_parameter_status -2");
    in = HIWIN_E_GANTRY_PARAMETER_STATUS_NOT_AVAILABLE;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -1");
    expect(same_bytes(bytes, "\377\377", 2u), "drive_parameters.gantry_parameter_status -1 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status -1");
    expect(out == HIWIN_E_GANTRY_PARAMETER_STATUS_NOT_AVAILABLE, "drive_parameters.gantry_parameter_status -1");
    in = HIWIN_E_GANTRY_PARAMETER_STATUS_IDLE;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.gantry_parameter_status 0 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status 0");
    expect(out == HIWIN_E_GANTRY_PARAMETER_STATUS_IDLE, "drive_parameters.gantry_parameter_status 0");
    in = HIWIN_E_GANTRY_PARAMETER_STATUS_PROCESSING;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status 1");
    expect(same_bytes(bytes, "\000\001", 2u), "drive_parameters.gantry_parameter_status 1 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status 1");
    expect(out == HIWIN_E_GANTRY_PARAMETER_STATUS_PROCESSING, "drive_parameters.gantry_parameter_status 1");
    in = HIWIN_E_GANTRY_PARAMETER_STATUS_SUCCEEDED;
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status 2");
    expect(same_bytes(bytes, "\000\002", 2u), "drive_parameters.gantry_parameter_status 2 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_status_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_parameter_status 2");
    expect(out == HIWIN_E_GANTRY_PARAMETER_STATUS_SUCCEEDED, "drive_parameters.gantry_parameter_status 2");
}

static void test_199(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_gantry_integer_input_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_integer_input -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.gantry_integer_input -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_integer_input_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_integer_input -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.gantry_integer_input -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_gantry_integer_input_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_integer_input 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.gantry_integer_input 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_integer_input_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_integer_input 2147483647");
    expect(out == 2147483647, "drive_parameters.gantry_integer_input 2147483647");
}

static void test_200(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_gantry_integer_output_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_integer_output -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.gantry_integer_output -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_integer_output_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_integer_output -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.gantry_integer_output -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_gantry_integer_output_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.gantry_integer_output 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.gantry_integer_output 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_gantry_integer_output_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.gantry_integer_output 2147483647");
    expect(out == 2147483647, "drive_parameters.gantry_integer_output 2147483647");
}

static void test_201(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_drive_warnings_1_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.drive_warnings_1 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.drive_warnings_1 0 bytes");
    expect(hiwin_e_par_drive_parameters_drive_warnings_1_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.drive_warnings_1 0");
    expect(out == 0u, "drive_parameters.drive_warnings_1 0");
    in = 65535u;
    expect(hiwin_e_par_drive_parameters_drive_warnings_1_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.drive_warnings_1 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "drive_parameters.drive_warnings_1 65535 bytes");
    expect(hiwin_e_par_drive_parameters_drive_warnings_1_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.drive_warnings_1 65535");
    expect(out == 65535u, "drive_parameters.drive_warnings_1 65535");
}

static void test_202(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_drive_warnings_2_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.drive_warnings_2 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.drive_warnings_2 0 bytes");
    expect(hiwin_e_par_drive_parameters_drive_warnings_2_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.drive_warnings_2 0");
    expect(out == 0u, "drive_parameters.drive_warnings_2 0");
    in = 65535u;
    expect(hiwin_e_par_drive_parameters_drive_warnings_2_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.drive_warnings_2 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "drive_parameters.drive_warnings_2 65535 bytes");
    expect(hiwin_e_par_drive_parameters_drive_warnings_2_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.drive_warnings_2 65535");
    expect(out == 65535u, "drive_parameters.drive_warnings_2 65535");
}

static void test_203(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_drive_parameters_operation_warnings_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.operation_warnings 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "drive_parameters.operation_warnings 0 bytes");
    expect(hiwin_e_par_drive_parameters_operation_warnings_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.operation_warnings 0");
    expect(out == 0u, "drive_parameters.operation_warnings 0");
    in = 4294967295u;
    expect(hiwin_e_par_drive_parameters_operation_warnings_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.operation_warnings 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "drive_parameters.operation_warnings 4294967295 bytes");
    expect(hiwin_e_par_drive_parameters_operation_warnings_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.operation_warnings 4294967295");
    expect(out == 4294967295u, "drive_parameters.operation_warnings 4294967295");
}

static void test_204(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile hiwin_e_absolute_encoder_initialization in = HIWIN_E_ABSOLUTE_ENCODER_INITIALIZATION_IDLE;
    in = HIWIN_E_ABSOLUTE_ENCODER_INITIALIZATION_IDLE;
    expect(hiwin_e_par_drive_parameters_absolute_encoder_initialization_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.absolute_encoder_initialization 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "drive_parameters.absolute_encoder_initialization 0 bytes");
    expect(hiwin_e_par_drive_parameters_absolute_encoder_initialization_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.absolute_encoder_initialization 0");
    expect(out == 0, "drive_parameters.absolute_encoder_initialization 0");
    in = HIWIN_E_ABSOLUTE_ENCODER_INITIALIZATION_START;
    expect(hiwin_e_par_drive_parameters_absolute_encoder_initialization_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.absolute_encoder_initialization 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "drive_parameters.absolute_encoder_initialization 1 bytes");
    expect(hiwin_e_par_drive_parameters_absolute_encoder_initialization_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.absolute_encoder_initialization 1");
    expect(out == 1, "drive_parameters.absolute_encoder_initialization 1");
}

static void test_205(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_general_integer_1_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_1 -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.general_integer_1 -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_1_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_1 -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.general_integer_1 -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_general_integer_1_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_1 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.general_integer_1 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_1_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_1 2147483647");
    expect(out == 2147483647, "drive_parameters.general_integer_1 2147483647");
}

static void test_206(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_general_integer_2_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_2 -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.general_integer_2 -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_2_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_2 -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.general_integer_2 -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_general_integer_2_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_2 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.general_integer_2 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_2_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_2 2147483647");
    expect(out == 2147483647, "drive_parameters.general_integer_2 2147483647");
}

static void test_207(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_general_integer_3_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_3 -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.general_integer_3 -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_3_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_3 -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.general_integer_3 -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_general_integer_3_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_3 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.general_integer_3 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_3_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_3 2147483647");
    expect(out == 2147483647, "drive_parameters.general_integer_3 2147483647");
}

static void test_208(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_general_integer_4_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_4 -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.general_integer_4 -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_4_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_4 -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.general_integer_4 -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_general_integer_4_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_4 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.general_integer_4 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_4_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_4 2147483647");
    expect(out == 2147483647, "drive_parameters.general_integer_4 2147483647");
}

static void test_209(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_general_integer_5_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_5 -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.general_integer_5 -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_5_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_5 -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.general_integer_5 -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_general_integer_5_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_5 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.general_integer_5 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_5_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_5 2147483647");
    expect(out == 2147483647, "drive_parameters.general_integer_5 2147483647");
}

static void test_210(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_general_integer_6_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_6 -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.general_integer_6 -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_6_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_6 -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.general_integer_6 -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_general_integer_6_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_6 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.general_integer_6 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_6_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_6 2147483647");
    expect(out == 2147483647, "drive_parameters.general_integer_6 2147483647");
}

static void test_211(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_general_integer_7_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_7 -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.general_integer_7 -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_7_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_7 -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.general_integer_7 -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_general_integer_7_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_7 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.general_integer_7 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_7_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_7 2147483647");
    expect(out == 2147483647, "drive_parameters.general_integer_7 2147483647");
}

static void test_212(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_general_integer_8_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_8 -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.general_integer_8 -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_8_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_8 -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.general_integer_8 -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_general_integer_8_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_8 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.general_integer_8 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_8_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_8 2147483647");
    expect(out == 2147483647, "drive_parameters.general_integer_8 2147483647");
}

static void test_213(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_drive_parameters_general_integer_9_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_9 -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "drive_parameters.general_integer_9 -2147483648 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_9_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_9 -2147483648");
    expect(out == (-2147483647 - 1), "drive_parameters.general_integer_9 -2147483648");
    in = 2147483647;
    expect(hiwin_e_par_drive_parameters_general_integer_9_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.general_integer_9 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "drive_parameters.general_integer_9 2147483647 bytes");
    expect(hiwin_e_par_drive_parameters_general_integer_9_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.general_integer_9 2147483647");
    expect(out == 2147483647, "drive_parameters.general_integer_9 2147483647");
}

static void test_214(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile hiwin_e_drive_reset in = HIWIN_E_DRIVE_RESET_FAILED;
    in = HIWIN_E_DRIVE_RESET_FAILED;
    expect(hiwin_e_par_drive_parameters_drive_reset_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.drive_reset -1");
    expect(same_bytes(bytes, "\377\377", 2u), "drive_parameters.drive_reset -1 bytes");
    expect(hiwin_e_par_drive_parameters_drive_reset_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.drive_reset -1");
    expect(out == (-1), "drive_parameters.drive_reset -1");
    in = HIWIN_E_DRIVE_RESET_IDLE;
    expect(hiwin_e_par_drive_parameters_drive_reset_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.drive_reset 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.drive_reset 0 bytes");
    expect(hiwin_e_par_drive_parameters_drive_reset_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.drive_reset 0");
    expect(out == 0, "drive_parameters.drive_reset 0");
    in = HIWIN_E_DRIVE_RESET_RESET;
    expect(hiwin_e_par_drive_parameters_drive_reset_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.drive_reset 1");
    expect(same_bytes(bytes, "\000\001", 2u), "drive_parameters.drive_reset 1 bytes");
    expect(hiwin_e_par_drive_parameters_drive_reset_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.drive_reset 1");
    expect(out == 1, "drive_parameters.drive_reset 1");
    in = HIWIN_E_DRIVE_RESET_RESET_GANTRY;
    expect(hiwin_e_par_drive_parameters_drive_reset_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.drive_reset 2");
    expect(same_bytes(bytes, "\000\002", 2u), "drive_parameters.drive_reset 2 bytes");
    expect(hiwin_e_par_drive_parameters_drive_reset_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.drive_reset 2");
    expect(out == 2, "drive_parameters.drive_reset 2");
}

static void test_215(void)
{
    uint8_t bytes[2];
    int16_t out = 0;
    volatile hiwin_e_parameter_save in = HIWIN_E_PARAMETER_SAVE_IDLE;
    in = HIWIN_E_PARAMETER_SAVE_IDLE;
    expect(hiwin_e_par_drive_parameters_parameter_save_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.parameter_save 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.parameter_save 0 bytes");
    expect(hiwin_e_par_drive_parameters_parameter_save_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.parameter_save 0");
    expect(out == 0, "drive_parameters.parameter_save 0");
    in = HIWIN_E_PARAMETER_SAVE_SAVE;
    expect(hiwin_e_par_drive_parameters_parameter_save_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.parameter_save 1");
    expect(same_bytes(bytes, "\000\001", 2u), "drive_parameters.parameter_save 1 bytes");
    expect(hiwin_e_par_drive_parameters_parameter_save_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.parameter_save 1");
    expect(out == 1, "drive_parameters.parameter_save 1");
}

static void test_216(void)
{
    uint8_t bytes[2];
    hiwin_e_mastership out = HIWIN_E_MASTERSHIP_HOST_CONTROLLER;
    volatile hiwin_e_mastership in = HIWIN_E_MASTERSHIP_THUNDER;
    in = HIWIN_E_MASTERSHIP_THUNDER;
    expect(hiwin_e_par_drive_parameters_mastership_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.mastership 0");
    expect(same_bytes(bytes, "\000\000", 2u), "drive_parameters.mastership 0 bytes");
    expect(hiwin_e_par_drive_parameters_mastership_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.mastership 0");
    expect(out == HIWIN_E_MASTERSHIP_THUNDER, "drive_parameters.mastership 0");
    in = HIWIN_E_MASTERSHIP_HOST_CONTROLLER;
    expect(hiwin_e_par_drive_parameters_mastership_encode(in, bytes) == HIWIN_E_OK, "drive_parameters.mastership 1");
    expect(same_bytes(bytes, "\000\001", 2u), "drive_parameters.mastership 1 bytes");
    expect(hiwin_e_par_drive_parameters_mastership_decode(bytes, &out) == HIWIN_E_OK, "drive_parameters.mastership 1");
    expect(out == HIWIN_E_MASTERSHIP_HOST_CONTROLLER, "drive_parameters.mastership 1");
}

static void test_217(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_monitoring_parameters_digital_output_states_encode(in, bytes) == HIWIN_E_OK, "monitoring_parameters.digital_output_states 0");
    expect(same_bytes(bytes, "\000\000", 2u), "monitoring_parameters.digital_output_states 0 bytes");
    expect(hiwin_e_par_monitoring_parameters_digital_output_states_decode(bytes, &out) == HIWIN_E_OK, "monitoring_parameters.digital_output_states 0");
    expect(out == 0u, "monitoring_parameters.digital_output_states 0");
    in = 65535u;
    expect(hiwin_e_par_monitoring_parameters_digital_output_states_encode(in, bytes) == HIWIN_E_OK, "monitoring_parameters.digital_output_states 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "monitoring_parameters.digital_output_states 65535 bytes");
    expect(hiwin_e_par_monitoring_parameters_digital_output_states_decode(bytes, &out) == HIWIN_E_OK, "monitoring_parameters.digital_output_states 65535");
    expect(out == 65535u, "monitoring_parameters.digital_output_states 65535");
}

static void test_218(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_monitoring_parameters_alarm_encode(in, bytes) == HIWIN_E_OK, "monitoring_parameters.alarm 0");
    expect(same_bytes(bytes, "\000\000", 2u), "monitoring_parameters.alarm 0 bytes");
    expect(hiwin_e_par_monitoring_parameters_alarm_decode(bytes, &out) == HIWIN_E_OK, "monitoring_parameters.alarm 0");
    expect(out == 0u, "monitoring_parameters.alarm 0");
    in = 65535u;
    expect(hiwin_e_par_monitoring_parameters_alarm_encode(in, bytes) == HIWIN_E_OK, "monitoring_parameters.alarm 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "monitoring_parameters.alarm 65535 bytes");
    expect(hiwin_e_par_monitoring_parameters_alarm_decode(bytes, &out) == HIWIN_E_OK, "monitoring_parameters.alarm 65535");
    expect(out == 65535u, "monitoring_parameters.alarm 65535");
}

static void test_219(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_monitoring_parameters_warning_encode(in, bytes) == HIWIN_E_OK, "monitoring_parameters.warning 0");
    expect(same_bytes(bytes, "\000\000", 2u), "monitoring_parameters.warning 0 bytes");
    expect(hiwin_e_par_monitoring_parameters_warning_decode(bytes, &out) == HIWIN_E_OK, "monitoring_parameters.warning 0");
    expect(out == 0u, "monitoring_parameters.warning 0");
    in = 65535u;
    expect(hiwin_e_par_monitoring_parameters_warning_encode(in, bytes) == HIWIN_E_OK, "monitoring_parameters.warning 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "monitoring_parameters.warning 65535 bytes");
    expect(hiwin_e_par_monitoring_parameters_warning_decode(bytes, &out) == HIWIN_E_OK, "monitoring_parameters.warning 65535");
    expect(out == 65535u, "monitoring_parameters.warning 65535");
}

static void test_220(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_telegram_selection_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.telegram_selection 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.telegram_selection 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_telegram_selection_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.telegram_selection 0");
    expect(out == 0u, "profidrive_parameters.telegram_selection 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_telegram_selection_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.telegram_selection 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.telegram_selection 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_telegram_selection_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.telegram_selection 65535");
    expect(out == 65535u, "profidrive_parameters.telegram_selection 65535");
}

static void test_221(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_sign_of_life_failure_tolerance_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.sign_of_life_failure_tolerance 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.sign_of_life_failure_tolerance 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_sign_of_life_failure_tolerance_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.sign_of_life_failure_tolerance 0");
    expect(out == 0u, "profidrive_parameters.sign_of_life_failure_tolerance 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_sign_of_life_failure_tolerance_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.sign_of_life_failure_tolerance 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.sign_of_life_failure_tolerance 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_sign_of_life_failure_tolerance_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.sign_of_life_failure_tolerance 65535");
    expect(out == 65535u, "profidrive_parameters.sign_of_life_failure_tolerance 65535");
}

static void test_222(void)
{
    uint8_t bytes[2];
    hiwin_e_operating_mode out = HIWIN_E_OPERATING_MODE_SPEED_WITHOUT_RAMP_GENERATOR;
    volatile hiwin_e_operating_mode in = HIWIN_E_OPERATING_MODE_SPEED_WITH_RAMP_GENERATOR;
    in = HIWIN_E_OPERATING_MODE_SPEED_WITH_RAMP_GENERATOR;
    expect(hiwin_e_par_profidrive_parameters_operating_mode_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.operating_mode 1");
    expect(same_bytes(bytes, "\000\001", 2u), "profidrive_parameters.operating_mode 1 bytes");
    expect(hiwin_e_par_profidrive_parameters_operating_mode_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.operating_mode 1");
    expect(out == HIWIN_E_OPERATING_MODE_SPEED_WITH_RAMP_GENERATOR, "profidrive_parameters.operating_mode 1");
    in = HIWIN_E_OPERATING_MODE_POSITION;
    expect(hiwin_e_par_profidrive_parameters_operating_mode_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.operating_mode 2");
    expect(same_bytes(bytes, "\000\002", 2u), "profidrive_parameters.operating_mode 2 bytes");
    expect(hiwin_e_par_profidrive_parameters_operating_mode_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.operating_mode 2");
    expect(out == HIWIN_E_OPERATING_MODE_POSITION, "profidrive_parameters.operating_mode 2");
    in = HIWIN_E_OPERATING_MODE_SPEED_WITHOUT_RAMP_GENERATOR;
    expect(hiwin_e_par_profidrive_parameters_operating_mode_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.operating_mode 3");
    expect(same_bytes(bytes, "\000\003", 2u), "profidrive_parameters.operating_mode 3 bytes");
    expect(hiwin_e_par_profidrive_parameters_operating_mode_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.operating_mode 3");
    expect(out == HIWIN_E_OPERATING_MODE_SPEED_WITHOUT_RAMP_GENERATOR, "profidrive_parameters.operating_mode 3");
}

static void test_223(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_alarm_counter_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_counter 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.alarm_counter 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_counter_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_counter 0");
    expect(out == 0u, "profidrive_parameters.alarm_counter 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_alarm_counter_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_counter 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.alarm_counter 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_counter_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_counter 65535");
    expect(out == 65535u, "profidrive_parameters.alarm_counter 65535");
}

static void test_224(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_alarm_codes_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_codes 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.alarm_codes 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_codes_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_codes 0");
    expect(out == 0u, "profidrive_parameters.alarm_codes 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_alarm_codes_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_codes 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.alarm_codes 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_codes_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_codes 65535");
    expect(out == 65535u, "profidrive_parameters.alarm_codes 65535");
}

static void test_225(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_internal_alarm_codes_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.internal_alarm_codes 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.internal_alarm_codes 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_internal_alarm_codes_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.internal_alarm_codes 0");
    expect(out == 0u, "profidrive_parameters.internal_alarm_codes 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_internal_alarm_codes_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.internal_alarm_codes 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.internal_alarm_codes 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_internal_alarm_codes_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.internal_alarm_codes 65535");
    expect(out == 65535u, "profidrive_parameters.internal_alarm_codes 65535");
}

static void test_226(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.alarm_buffer_capacity 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity 0");
    expect(out == 0u, "profidrive_parameters.alarm_buffer_capacity 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.alarm_buffer_capacity 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity 65535");
    expect(out == 65535u, "profidrive_parameters.alarm_buffer_capacity 65535");
}

static void test_227(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_block_count_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity.block_count 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.alarm_buffer_capacity.block_count 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_block_count_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity.block_count 0");
    expect(out == 0u, "profidrive_parameters.alarm_buffer_capacity.block_count 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_block_count_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity.block_count 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.alarm_buffer_capacity.block_count 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_block_count_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity.block_count 65535");
    expect(out == 65535u, "profidrive_parameters.alarm_buffer_capacity.block_count 65535");
}

static void test_228(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_alarms_per_block_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity.alarms_per_block 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.alarm_buffer_capacity.alarms_per_block 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_alarms_per_block_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity.alarms_per_block 0");
    expect(out == 0u, "profidrive_parameters.alarm_buffer_capacity.alarms_per_block 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_alarms_per_block_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity.alarms_per_block 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.alarm_buffer_capacity.alarms_per_block 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_alarms_per_block_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_buffer_capacity.alarms_per_block 65535");
    expect(out == 65535u, "profidrive_parameters.alarm_buffer_capacity.alarms_per_block 65535");
}

static void test_229(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_alarm_block_counter_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_block_counter 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.alarm_block_counter 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_block_counter_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_block_counter 0");
    expect(out == 0u, "profidrive_parameters.alarm_block_counter 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_alarm_block_counter_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.alarm_block_counter 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.alarm_block_counter 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_alarm_block_counter_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.alarm_block_counter 65535");
    expect(out == 65535u, "profidrive_parameters.alarm_block_counter 65535");
}

static void test_230(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_drive_identification_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.drive_identification 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification 0");
    expect(out == 0u, "profidrive_parameters.drive_identification 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_drive_identification_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.drive_identification 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification 65535");
    expect(out == 65535u, "profidrive_parameters.drive_identification 65535");
}

static void test_231(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(hiwin_e_par_profidrive_parameters_drive_identification_manufacturer_encode(bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.manufacturer");
    expect(same_bytes(bytes, "\012\252", 2u), "profidrive_parameters.drive_identification.manufacturer bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_manufacturer_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.manufacturer");
    expect(out == 2730u, "profidrive_parameters.drive_identification.manufacturer");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_manufacturer_decode(other, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.manufacturer 0");
    expect(out == 0u, "profidrive_parameters.drive_identification.manufacturer 0");
}

static void test_232(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(hiwin_e_par_profidrive_parameters_drive_identification_drive_unit_type_encode(bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.drive_unit_type");
    expect(same_bytes(bytes, "\000\005", 2u), "profidrive_parameters.drive_identification.drive_unit_type bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_drive_unit_type_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.drive_unit_type");
    expect(out == 5u, "profidrive_parameters.drive_identification.drive_unit_type");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_drive_unit_type_decode(other, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.drive_unit_type 0");
    expect(out == 0u, "profidrive_parameters.drive_identification.drive_unit_type 0");
}

static void test_233(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_version_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_version 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.drive_identification.firmware_version 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_version_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_version 0");
    expect(out == 0u, "profidrive_parameters.drive_identification.firmware_version 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_version_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_version 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.drive_identification.firmware_version 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_version_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_version 65535");
    expect(out == 65535u, "profidrive_parameters.drive_identification.firmware_version 65535");
}

static void test_234(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_year_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_year 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.drive_identification.firmware_year 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_year_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_year 0");
    expect(out == 0u, "profidrive_parameters.drive_identification.firmware_year 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_year_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_year 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.drive_identification.firmware_year 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_year_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_year 65535");
    expect(out == 65535u, "profidrive_parameters.drive_identification.firmware_year 65535");
}

static void test_235(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_day_and_month_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_day_and_month 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.drive_identification.firmware_day_and_month 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_day_and_month_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_day_and_month 0");
    expect(out == 0u, "profidrive_parameters.drive_identification.firmware_day_and_month 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_day_and_month_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_day_and_month 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.drive_identification.firmware_day_and_month 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_firmware_day_and_month_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.firmware_day_and_month 65535");
    expect(out == 65535u, "profidrive_parameters.drive_identification.firmware_day_and_month 65535");
}

static void test_236(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(hiwin_e_par_profidrive_parameters_drive_identification_drive_object_count_encode(bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.drive_object_count");
    expect(same_bytes(bytes, "\000\001", 2u), "profidrive_parameters.drive_identification.drive_object_count bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_drive_object_count_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.drive_object_count");
    expect(out == 1u, "profidrive_parameters.drive_identification.drive_object_count");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_drive_object_count_decode(other, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.drive_object_count 0");
    expect(out == 0u, "profidrive_parameters.drive_identification.drive_object_count 0");
}

static void test_237(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_drive_identification_minor_firmware_version_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.minor_firmware_version 0");
    expect(same_bytes(bytes, "\000\000", 2u), "profidrive_parameters.drive_identification.minor_firmware_version 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_minor_firmware_version_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.minor_firmware_version 0");
    expect(out == 0u, "profidrive_parameters.drive_identification.minor_firmware_version 0");
    in = 65535u;
    expect(hiwin_e_par_profidrive_parameters_drive_identification_minor_firmware_version_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.drive_identification.minor_firmware_version 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "profidrive_parameters.drive_identification.minor_firmware_version 65535 bytes");
    expect(hiwin_e_par_profidrive_parameters_drive_identification_minor_firmware_version_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.drive_identification.minor_firmware_version 65535");
    expect(out == 65535u, "profidrive_parameters.drive_identification.minor_firmware_version 65535");
}

static void test_238(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "profidrive_parameters.encoder_format 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format 0");
    expect(out == 0u, "profidrive_parameters.encoder_format 0");
    in = 4294967295u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "profidrive_parameters.encoder_format 4294967295 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format 4294967295");
    expect(out == 4294967295u, "profidrive_parameters.encoder_format 4294967295");
}

static void test_239(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_header_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.header 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "profidrive_parameters.encoder_format.header 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_header_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.header 0");
    expect(out == 0u, "profidrive_parameters.encoder_format.header 0");
    in = 4294967295u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_header_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.header 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "profidrive_parameters.encoder_format.header 4294967295 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_header_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.header 4294967295");
    expect(out == 4294967295u, "profidrive_parameters.encoder_format.header 4294967295");
}

static void test_240(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_encoder_type_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.encoder_type 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "profidrive_parameters.encoder_format.encoder_type 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_encoder_type_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.encoder_type 0");
    expect(out == 0u, "profidrive_parameters.encoder_format.encoder_type 0");
    in = 4294967295u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_encoder_type_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.encoder_type 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "profidrive_parameters.encoder_format.encoder_type 4294967295 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_encoder_type_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.encoder_type 4294967295");
    expect(out == 4294967295u, "profidrive_parameters.encoder_format.encoder_type 4294967295");
}

static void test_241(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_encoder_resolution_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.encoder_resolution 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "profidrive_parameters.encoder_format.encoder_resolution 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_encoder_resolution_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.encoder_resolution 0");
    expect(out == 0u, "profidrive_parameters.encoder_format.encoder_resolution 0");
    in = 4294967295u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_encoder_resolution_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.encoder_resolution 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "profidrive_parameters.encoder_format.encoder_resolution 4294967295 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_encoder_resolution_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.encoder_resolution 4294967295");
    expect(out == 4294967295u, "profidrive_parameters.encoder_format.encoder_resolution 4294967295");
}

static void test_242(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_actual_position_1_shift_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.actual_position_1_shift 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "profidrive_parameters.encoder_format.actual_position_1_shift 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_actual_position_1_shift_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.actual_position_1_shift 0");
    expect(out == 0u, "profidrive_parameters.encoder_format.actual_position_1_shift 0");
    in = 4294967295u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_actual_position_1_shift_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.actual_position_1_shift 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "profidrive_parameters.encoder_format.actual_position_1_shift 4294967295 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_actual_position_1_shift_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.actual_position_1_shift 4294967295");
    expect(out == 4294967295u, "profidrive_parameters.encoder_format.actual_position_1_shift 4294967295");
}

static void test_243(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_actual_position_2_shift_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.actual_position_2_shift 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "profidrive_parameters.encoder_format.actual_position_2_shift 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_actual_position_2_shift_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.actual_position_2_shift 0");
    expect(out == 0u, "profidrive_parameters.encoder_format.actual_position_2_shift 0");
    in = 4294967295u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_actual_position_2_shift_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.actual_position_2_shift 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "profidrive_parameters.encoder_format.actual_position_2_shift 4294967295 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_actual_position_2_shift_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.actual_position_2_shift 4294967295");
    expect(out == 4294967295u, "profidrive_parameters.encoder_format.actual_position_2_shift 4294967295");
}

static void test_244(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_maximum_turn_count_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.maximum_turn_count 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "profidrive_parameters.encoder_format.maximum_turn_count 0 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_maximum_turn_count_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.maximum_turn_count 0");
    expect(out == 0u, "profidrive_parameters.encoder_format.maximum_turn_count 0");
    in = 4294967295u;
    expect(hiwin_e_par_profidrive_parameters_encoder_format_maximum_turn_count_encode(in, bytes) == HIWIN_E_OK, "profidrive_parameters.encoder_format.maximum_turn_count 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "profidrive_parameters.encoder_format.maximum_turn_count 4294967295 bytes");
    expect(hiwin_e_par_profidrive_parameters_encoder_format_maximum_turn_count_decode(bytes, &out) == HIWIN_E_OK, "profidrive_parameters.encoder_format.maximum_turn_count 4294967295");
    expect(out == 4294967295u, "profidrive_parameters.encoder_format.maximum_turn_count 4294967295");
}

static void test_245(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_basic_function_switch_1_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.basic_function_switch_1 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo_parameters.basic_function_switch_1 0 bytes");
    expect(hiwin_e_par_servo_parameters_basic_function_switch_1_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.basic_function_switch_1 0");
    expect(out == 0u, "servo_parameters.basic_function_switch_1 0");
    in = 65535u;
    expect(hiwin_e_par_servo_parameters_basic_function_switch_1_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.basic_function_switch_1 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "servo_parameters.basic_function_switch_1 65535 bytes");
    expect(hiwin_e_par_servo_parameters_basic_function_switch_1_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.basic_function_switch_1 65535");
    expect(out == 65535u, "servo_parameters.basic_function_switch_1 65535");
}

static void test_246(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = 0;
    expect(hiwin_e_par_servo_parameters_modulo_range_upper_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.modulo_range_upper_limit 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "servo_parameters.modulo_range_upper_limit 0 bytes");
    expect(hiwin_e_par_servo_parameters_modulo_range_upper_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.modulo_range_upper_limit 0");
    expect(out == 0, "servo_parameters.modulo_range_upper_limit 0");
    in = 2147483647;
    expect(hiwin_e_par_servo_parameters_modulo_range_upper_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.modulo_range_upper_limit 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "servo_parameters.modulo_range_upper_limit 2147483647 bytes");
    expect(hiwin_e_par_servo_parameters_modulo_range_upper_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.modulo_range_upper_limit 2147483647");
    expect(out == 2147483647, "servo_parameters.modulo_range_upper_limit 2147483647");
}

static void test_247(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(hiwin_e_par_servo_parameters_modulo_range_lower_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.modulo_range_lower_limit -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "servo_parameters.modulo_range_lower_limit -2147483648 bytes");
    expect(hiwin_e_par_servo_parameters_modulo_range_lower_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.modulo_range_lower_limit -2147483648");
    expect(out == (-2147483647 - 1), "servo_parameters.modulo_range_lower_limit -2147483648");
    in = 0;
    expect(hiwin_e_par_servo_parameters_modulo_range_lower_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.modulo_range_lower_limit 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "servo_parameters.modulo_range_lower_limit 0 bytes");
    expect(hiwin_e_par_servo_parameters_modulo_range_lower_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.modulo_range_lower_limit 0");
    expect(out == 0, "servo_parameters.modulo_range_lower_limit 0");
}

static void test_248(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_quick_stop_deceleration_time_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.quick_stop_deceleration_time 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo_parameters.quick_stop_deceleration_time 0 bytes");
    expect(hiwin_e_par_servo_parameters_quick_stop_deceleration_time_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.quick_stop_deceleration_time 0");
    expect(out == 0u, "servo_parameters.quick_stop_deceleration_time 0");
    in = 10000u;
    expect(hiwin_e_par_servo_parameters_quick_stop_deceleration_time_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.quick_stop_deceleration_time 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "servo_parameters.quick_stop_deceleration_time 10000 bytes");
    expect(hiwin_e_par_servo_parameters_quick_stop_deceleration_time_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.quick_stop_deceleration_time 10000");
    expect(out == 10000u, "servo_parameters.quick_stop_deceleration_time 10000");
}

static void test_249(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_maximum_speed_rotary_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.maximum_speed_rotary 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo_parameters.maximum_speed_rotary 0 bytes");
    expect(hiwin_e_par_servo_parameters_maximum_speed_rotary_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.maximum_speed_rotary 0");
    expect(out == 0u, "servo_parameters.maximum_speed_rotary 0");
    in = 65535u;
    expect(hiwin_e_par_servo_parameters_maximum_speed_rotary_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.maximum_speed_rotary 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "servo_parameters.maximum_speed_rotary 65535 bytes");
    expect(hiwin_e_par_servo_parameters_maximum_speed_rotary_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.maximum_speed_rotary 65535");
    expect(out == 65535u, "servo_parameters.maximum_speed_rotary 65535");
}

static void test_250(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(hiwin_e_par_servo_parameters_reference_speed_rotary_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.reference_speed_rotary 1");
    expect(same_bytes(bytes, "\000\001", 2u), "servo_parameters.reference_speed_rotary 1 bytes");
    expect(hiwin_e_par_servo_parameters_reference_speed_rotary_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.reference_speed_rotary 1");
    expect(out == 1u, "servo_parameters.reference_speed_rotary 1");
    in = 65535u;
    expect(hiwin_e_par_servo_parameters_reference_speed_rotary_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.reference_speed_rotary 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "servo_parameters.reference_speed_rotary 65535 bytes");
    expect(hiwin_e_par_servo_parameters_reference_speed_rotary_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.reference_speed_rotary 65535");
    expect(out == 65535u, "servo_parameters.reference_speed_rotary 65535");
}

static void test_251(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_maximum_speed_linear_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.maximum_speed_linear 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo_parameters.maximum_speed_linear 0 bytes");
    expect(hiwin_e_par_servo_parameters_maximum_speed_linear_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.maximum_speed_linear 0");
    expect(out == 0u, "servo_parameters.maximum_speed_linear 0");
    in = 100u;
    expect(hiwin_e_par_servo_parameters_maximum_speed_linear_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.maximum_speed_linear 100");
    expect(same_bytes(bytes, "\000\144", 2u), "servo_parameters.maximum_speed_linear 100 bytes");
    expect(hiwin_e_par_servo_parameters_maximum_speed_linear_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.maximum_speed_linear 100");
    expect(out == 100u, "servo_parameters.maximum_speed_linear 100");
}

static void test_252(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(hiwin_e_par_servo_parameters_reference_speed_linear_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.reference_speed_linear 1");
    expect(same_bytes(bytes, "\000\001", 2u), "servo_parameters.reference_speed_linear 1 bytes");
    expect(hiwin_e_par_servo_parameters_reference_speed_linear_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.reference_speed_linear 1");
    expect(out == 1u, "servo_parameters.reference_speed_linear 1");
    in = 100u;
    expect(hiwin_e_par_servo_parameters_reference_speed_linear_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.reference_speed_linear 100");
    expect(same_bytes(bytes, "\000\144", 2u), "servo_parameters.reference_speed_linear 100 bytes");
    expect(hiwin_e_par_servo_parameters_reference_speed_linear_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.reference_speed_linear 100");
    expect(out == 100u, "servo_parameters.reference_speed_linear 100");
}

static void test_253(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_positive_torque_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.positive_torque_limit 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo_parameters.positive_torque_limit 0 bytes");
    expect(hiwin_e_par_servo_parameters_positive_torque_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.positive_torque_limit 0");
    expect(out == 0u, "servo_parameters.positive_torque_limit 0");
    in = 800u;
    expect(hiwin_e_par_servo_parameters_positive_torque_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.positive_torque_limit 800");
    expect(same_bytes(bytes, "\003\040", 2u), "servo_parameters.positive_torque_limit 800 bytes");
    expect(hiwin_e_par_servo_parameters_positive_torque_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.positive_torque_limit 800");
    expect(out == 800u, "servo_parameters.positive_torque_limit 800");
}

static void test_254(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_negative_torque_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.negative_torque_limit 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo_parameters.negative_torque_limit 0 bytes");
    expect(hiwin_e_par_servo_parameters_negative_torque_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.negative_torque_limit 0");
    expect(out == 0u, "servo_parameters.negative_torque_limit 0");
    in = 800u;
    expect(hiwin_e_par_servo_parameters_negative_torque_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.negative_torque_limit 800");
    expect(same_bytes(bytes, "\003\040", 2u), "servo_parameters.negative_torque_limit 800 bytes");
    expect(hiwin_e_par_servo_parameters_negative_torque_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.negative_torque_limit 800");
    expect(out == 800u, "servo_parameters.negative_torque_limit 800");
}

static void test_255(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_reference_torque_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.reference_torque 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "servo_parameters.reference_torque 0 bytes");
    expect(hiwin_e_par_servo_parameters_reference_torque_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.reference_torque 0");
    expect(out == 0u, "servo_parameters.reference_torque 0");
    in = 2147483647u;
    expect(hiwin_e_par_servo_parameters_reference_torque_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.reference_torque 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "servo_parameters.reference_torque 2147483647 bytes");
    expect(hiwin_e_par_servo_parameters_reference_torque_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.reference_torque 2147483647");
    expect(out == 2147483647u, "servo_parameters.reference_torque 2147483647");
}

static void test_256(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.positive_fixed_stop_tolerance 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "servo_parameters.positive_fixed_stop_tolerance 0 bytes");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.positive_fixed_stop_tolerance 0");
    expect(out == 0u, "servo_parameters.positive_fixed_stop_tolerance 0");
    in = 2147483647u;
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.positive_fixed_stop_tolerance 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "servo_parameters.positive_fixed_stop_tolerance 2147483647 bytes");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.positive_fixed_stop_tolerance 2147483647");
    expect(out == 2147483647u, "servo_parameters.positive_fixed_stop_tolerance 2147483647");
}

static void test_257(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.negative_fixed_stop_tolerance 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "servo_parameters.negative_fixed_stop_tolerance 0 bytes");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.negative_fixed_stop_tolerance 0");
    expect(out == 0u, "servo_parameters.negative_fixed_stop_tolerance 0");
    in = 2147483647u;
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.negative_fixed_stop_tolerance 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "servo_parameters.negative_fixed_stop_tolerance 2147483647 bytes");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.negative_fixed_stop_tolerance 2147483647");
    expect(out == 2147483647u, "servo_parameters.negative_fixed_stop_tolerance 2147483647");
}

static void test_258(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_torque_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.positive_fixed_stop_torque 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "servo_parameters.positive_fixed_stop_torque 0 bytes");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_torque_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.positive_fixed_stop_torque 0");
    expect(out == 0u, "servo_parameters.positive_fixed_stop_torque 0");
    in = 2147483647u;
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_torque_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.positive_fixed_stop_torque 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "servo_parameters.positive_fixed_stop_torque 2147483647 bytes");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_torque_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.positive_fixed_stop_torque 2147483647");
    expect(out == 2147483647u, "servo_parameters.positive_fixed_stop_torque 2147483647");
}

static void test_259(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.negative_fixed_stop_torque 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "servo_parameters.negative_fixed_stop_torque 0 bytes");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.negative_fixed_stop_torque 0");
    expect(out == 0u, "servo_parameters.negative_fixed_stop_torque 0");
    in = 2147483647u;
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.negative_fixed_stop_torque 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "servo_parameters.negative_fixed_stop_torque 2147483647 bytes");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.negative_fixed_stop_torque 2147483647");
    expect(out == 2147483647u, "servo_parameters.negative_fixed_stop_torque 2147483647");
}

static void test_260(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_fixed_stop_following_error_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.fixed_stop_following_error 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "servo_parameters.fixed_stop_following_error 0 bytes");
    expect(hiwin_e_par_servo_parameters_fixed_stop_following_error_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.fixed_stop_following_error 0");
    expect(out == 0u, "servo_parameters.fixed_stop_following_error 0");
    in = 2147483647u;
    expect(hiwin_e_par_servo_parameters_fixed_stop_following_error_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.fixed_stop_following_error 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "servo_parameters.fixed_stop_following_error 2147483647 bytes");
    expect(hiwin_e_par_servo_parameters_fixed_stop_following_error_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.fixed_stop_following_error 2147483647");
    expect(out == 2147483647u, "servo_parameters.fixed_stop_following_error 2147483647");
}

static void test_261(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_reference_force_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.reference_force 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "servo_parameters.reference_force 0 bytes");
    expect(hiwin_e_par_servo_parameters_reference_force_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.reference_force 0");
    expect(out == 0u, "servo_parameters.reference_force 0");
    in = 2147483647u;
    expect(hiwin_e_par_servo_parameters_reference_force_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.reference_force 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "servo_parameters.reference_force 2147483647 bytes");
    expect(hiwin_e_par_servo_parameters_reference_force_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.reference_force 2147483647");
    expect(out == 2147483647u, "servo_parameters.reference_force 2147483647");
}

static void test_262(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_positive_force_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.positive_force_limit 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo_parameters.positive_force_limit 0 bytes");
    expect(hiwin_e_par_servo_parameters_positive_force_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.positive_force_limit 0");
    expect(out == 0u, "servo_parameters.positive_force_limit 0");
    in = 800u;
    expect(hiwin_e_par_servo_parameters_positive_force_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.positive_force_limit 800");
    expect(same_bytes(bytes, "\003\040", 2u), "servo_parameters.positive_force_limit 800 bytes");
    expect(hiwin_e_par_servo_parameters_positive_force_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.positive_force_limit 800");
    expect(out == 800u, "servo_parameters.positive_force_limit 800");
}

static void test_263(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(hiwin_e_par_servo_parameters_negative_force_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.negative_force_limit 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo_parameters.negative_force_limit 0 bytes");
    expect(hiwin_e_par_servo_parameters_negative_force_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.negative_force_limit 0");
    expect(out == 0u, "servo_parameters.negative_force_limit 0");
    in = 800u;
    expect(hiwin_e_par_servo_parameters_negative_force_limit_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.negative_force_limit 800");
    expect(same_bytes(bytes, "\003\040", 2u), "servo_parameters.negative_force_limit 800 bytes");
    expect(hiwin_e_par_servo_parameters_negative_force_limit_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.negative_force_limit 800");
    expect(out == 800u, "servo_parameters.negative_force_limit 800");
}

static void test_264(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_rotary_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_speed_rotary 1");
    expect(same_bytes(bytes, "\000\001", 2u), "servo_parameters.point_to_point_speed_rotary 1 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_rotary_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_speed_rotary 1");
    expect(out == 1u, "servo_parameters.point_to_point_speed_rotary 1");
    in = 10000u;
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_rotary_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_speed_rotary 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "servo_parameters.point_to_point_speed_rotary 10000 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_rotary_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_speed_rotary 10000");
    expect(out == 10000u, "servo_parameters.point_to_point_speed_rotary 10000");
}

static void test_265(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 2u;
    expect(hiwin_e_par_servo_parameters_point_to_point_acceleration_time_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_acceleration_time 2");
    expect(same_bytes(bytes, "\000\002", 2u), "servo_parameters.point_to_point_acceleration_time 2 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_acceleration_time_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_acceleration_time 2");
    expect(out == 2u, "servo_parameters.point_to_point_acceleration_time 2");
    in = 10000u;
    expect(hiwin_e_par_servo_parameters_point_to_point_acceleration_time_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_acceleration_time 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "servo_parameters.point_to_point_acceleration_time 10000 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_acceleration_time_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_acceleration_time 10000");
    expect(out == 10000u, "servo_parameters.point_to_point_acceleration_time 10000");
}

static void test_266(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 2u;
    expect(hiwin_e_par_servo_parameters_point_to_point_deceleration_time_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_deceleration_time 2");
    expect(same_bytes(bytes, "\000\002", 2u), "servo_parameters.point_to_point_deceleration_time 2 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_deceleration_time_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_deceleration_time 2");
    expect(out == 2u, "servo_parameters.point_to_point_deceleration_time 2");
    in = 10000u;
    expect(hiwin_e_par_servo_parameters_point_to_point_deceleration_time_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_deceleration_time 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "servo_parameters.point_to_point_deceleration_time 10000 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_deceleration_time_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_deceleration_time 10000");
    expect(out == 10000u, "servo_parameters.point_to_point_deceleration_time 10000");
}

static void test_267(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 2u;
    expect(hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_emergency_deceleration_time 2");
    expect(same_bytes(bytes, "\000\002", 2u), "servo_parameters.point_to_point_emergency_deceleration_time 2 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_emergency_deceleration_time 2");
    expect(out == 2u, "servo_parameters.point_to_point_emergency_deceleration_time 2");
    in = 10000u;
    expect(hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_emergency_deceleration_time 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "servo_parameters.point_to_point_emergency_deceleration_time 10000 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_emergency_deceleration_time 10000");
    expect(out == 10000u, "servo_parameters.point_to_point_emergency_deceleration_time 10000");
}

static void test_268(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = 1;
    expect(hiwin_e_par_servo_parameters_point_to_point_distance_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_distance 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "servo_parameters.point_to_point_distance 1 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_distance_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_distance 1");
    expect(out == 1, "servo_parameters.point_to_point_distance 1");
    in = 1073741824;
    expect(hiwin_e_par_servo_parameters_point_to_point_distance_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_distance 1073741824");
    expect(same_bytes(bytes, "\100\000\000\000", 4u), "servo_parameters.point_to_point_distance 1073741824 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_distance_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_distance 1073741824");
    expect(out == 1073741824, "servo_parameters.point_to_point_distance 1073741824");
}

static void test_269(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_linear_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_speed_linear 1");
    expect(same_bytes(bytes, "\000\001", 2u), "servo_parameters.point_to_point_speed_linear 1 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_linear_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_speed_linear 1");
    expect(out == 1u, "servo_parameters.point_to_point_speed_linear 1");
    in = 10000u;
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_linear_encode(in, bytes) == HIWIN_E_OK, "servo_parameters.point_to_point_speed_linear 10000");
    expect(same_bytes(bytes, "\047\020", 2u), "servo_parameters.point_to_point_speed_linear 10000 bytes");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_linear_decode(bytes, &out) == HIWIN_E_OK, "servo_parameters.point_to_point_speed_linear 10000");
    expect(out == 10000u, "servo_parameters.point_to_point_speed_linear 10000");
}

static void test_270(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    int32_t raw = 0;
    expect(hiwin_e_commanded_speed_from_raw((-2147483647 - 1), 3000.0) >= -6000.000000006, "commanded_speed -2147483648");
    expect(hiwin_e_commanded_speed_from_raw((-2147483647 - 1), 3000.0) <= -5999.999999994, "commanded_speed -2147483648");
    expect(hiwin_e_commanded_speed_to_raw(hiwin_e_commanded_speed_from_raw((-2147483647 - 1), 3000.0), 3000.0, &raw) == HIWIN_E_OK, "commanded_speed -2147483648 back");
    expect(raw == (-2147483647 - 1), "commanded_speed -2147483648 back");
    expect(hiwin_e_commanded_speed_from_raw(0, 3000.0) >= -1e-12, "commanded_speed 0");
    expect(hiwin_e_commanded_speed_from_raw(0, 3000.0) <= 1e-12, "commanded_speed 0");
    expect(hiwin_e_commanded_speed_to_raw(hiwin_e_commanded_speed_from_raw(0, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "commanded_speed 0 back");
    expect(raw == 0, "commanded_speed 0 back");
    expect(hiwin_e_commanded_speed_from_raw(1, 3000.0) >= 2.7939667238464357e-06, "commanded_speed 1");
    expect(hiwin_e_commanded_speed_from_raw(1, 3000.0) <= 2.7939687238464354e-06, "commanded_speed 1");
    expect(hiwin_e_commanded_speed_to_raw(hiwin_e_commanded_speed_from_raw(1, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "commanded_speed 1 back");
    expect(raw == 1, "commanded_speed 1 back");
    expect(hiwin_e_commanded_speed_from_raw(1073741824, 3000.0) >= 2999.999999997, "commanded_speed 1073741824");
    expect(hiwin_e_commanded_speed_from_raw(1073741824, 3000.0) <= 3000.000000003, "commanded_speed 1073741824");
    expect(hiwin_e_commanded_speed_to_raw(hiwin_e_commanded_speed_from_raw(1073741824, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "commanded_speed 1073741824 back");
    expect(raw == 1073741824, "commanded_speed 1073741824 back");
    expect(hiwin_e_commanded_speed_from_raw(2147483647, 3000.0) >= 5999.999997200032, "commanded_speed 2147483647");
    expect(hiwin_e_commanded_speed_from_raw(2147483647, 3000.0) <= 5999.999997212032, "commanded_speed 2147483647");
    expect(hiwin_e_commanded_speed_to_raw(hiwin_e_commanded_speed_from_raw(2147483647, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "commanded_speed 2147483647 back");
    expect(raw == 2147483647, "commanded_speed 2147483647 back");
    expect(hiwin_e_commanded_speed_to_raw(0.5, 1073741824.0, &raw) == HIWIN_E_OK, "commanded_speed 1/2");
    expect(raw == 0, "commanded_speed 1/2");
    expect(hiwin_e_commanded_speed_to_raw(1.5, 1073741824.0, &raw) == HIWIN_E_OK, "commanded_speed 3/2");
    expect(raw == 2, "commanded_speed 3/2");
    expect(hiwin_e_commanded_speed_to_raw(2.5, 1073741824.0, &raw) == HIWIN_E_OK, "commanded_speed 5/2");
    expect(raw == 2, "commanded_speed 5/2");
    expect(hiwin_e_commanded_speed_to_raw(6.0, 1.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "commanded_speed beyond");
    expect(hiwin_e_commanded_speed_to_raw(1.0, 0.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "commanded_speed of nothing");
    (void)raw;
    #endif
}

static void test_271(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    int32_t raw = 0;
    expect(hiwin_e_actual_speed_from_raw((-2147483647 - 1), 3000.0) >= -6000.000000006, "actual_speed -2147483648");
    expect(hiwin_e_actual_speed_from_raw((-2147483647 - 1), 3000.0) <= -5999.999999994, "actual_speed -2147483648");
    expect(hiwin_e_actual_speed_to_raw(hiwin_e_actual_speed_from_raw((-2147483647 - 1), 3000.0), 3000.0, &raw) == HIWIN_E_OK, "actual_speed -2147483648 back");
    expect(raw == (-2147483647 - 1), "actual_speed -2147483648 back");
    expect(hiwin_e_actual_speed_from_raw(0, 3000.0) >= -1e-12, "actual_speed 0");
    expect(hiwin_e_actual_speed_from_raw(0, 3000.0) <= 1e-12, "actual_speed 0");
    expect(hiwin_e_actual_speed_to_raw(hiwin_e_actual_speed_from_raw(0, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "actual_speed 0 back");
    expect(raw == 0, "actual_speed 0 back");
    expect(hiwin_e_actual_speed_from_raw(1, 3000.0) >= 2.7939667238464357e-06, "actual_speed 1");
    expect(hiwin_e_actual_speed_from_raw(1, 3000.0) <= 2.7939687238464354e-06, "actual_speed 1");
    expect(hiwin_e_actual_speed_to_raw(hiwin_e_actual_speed_from_raw(1, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "actual_speed 1 back");
    expect(raw == 1, "actual_speed 1 back");
    expect(hiwin_e_actual_speed_from_raw(1073741824, 3000.0) >= 2999.999999997, "actual_speed 1073741824");
    expect(hiwin_e_actual_speed_from_raw(1073741824, 3000.0) <= 3000.000000003, "actual_speed 1073741824");
    expect(hiwin_e_actual_speed_to_raw(hiwin_e_actual_speed_from_raw(1073741824, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "actual_speed 1073741824 back");
    expect(raw == 1073741824, "actual_speed 1073741824 back");
    expect(hiwin_e_actual_speed_from_raw(2147483647, 3000.0) >= 5999.999997200032, "actual_speed 2147483647");
    expect(hiwin_e_actual_speed_from_raw(2147483647, 3000.0) <= 5999.999997212032, "actual_speed 2147483647");
    expect(hiwin_e_actual_speed_to_raw(hiwin_e_actual_speed_from_raw(2147483647, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "actual_speed 2147483647 back");
    expect(raw == 2147483647, "actual_speed 2147483647 back");
    expect(hiwin_e_actual_speed_to_raw(0.5, 1073741824.0, &raw) == HIWIN_E_OK, "actual_speed 1/2");
    expect(raw == 0, "actual_speed 1/2");
    expect(hiwin_e_actual_speed_to_raw(1.5, 1073741824.0, &raw) == HIWIN_E_OK, "actual_speed 3/2");
    expect(raw == 2, "actual_speed 3/2");
    expect(hiwin_e_actual_speed_to_raw(2.5, 1073741824.0, &raw) == HIWIN_E_OK, "actual_speed 5/2");
    expect(raw == 2, "actual_speed 5/2");
    expect(hiwin_e_actual_speed_to_raw(6.0, 1.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "actual_speed beyond");
    expect(hiwin_e_actual_speed_to_raw(1.0, 0.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "actual_speed of nothing");
    (void)raw;
    #endif
}

static void test_272(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    int16_t raw = 0;
    expect(hiwin_e_commanded_speed_a_from_raw((-32768), 3000.0) >= -6000.000000006, "commanded_speed_a -32768");
    expect(hiwin_e_commanded_speed_a_from_raw((-32768), 3000.0) <= -5999.999999994, "commanded_speed_a -32768");
    expect(hiwin_e_commanded_speed_a_to_raw(hiwin_e_commanded_speed_a_from_raw((-32768), 3000.0), 3000.0, &raw) == HIWIN_E_OK, "commanded_speed_a -32768 back");
    expect(raw == (-32768), "commanded_speed_a -32768 back");
    expect(hiwin_e_commanded_speed_a_from_raw(0, 3000.0) >= -1e-12, "commanded_speed_a 0");
    expect(hiwin_e_commanded_speed_a_from_raw(0, 3000.0) <= 1e-12, "commanded_speed_a 0");
    expect(hiwin_e_commanded_speed_a_to_raw(hiwin_e_commanded_speed_a_from_raw(0, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "commanded_speed_a 0 back");
    expect(raw == 0, "commanded_speed_a 0 back");
    expect(hiwin_e_commanded_speed_a_from_raw(1, 3000.0) >= 0.183105468749, "commanded_speed_a 1");
    expect(hiwin_e_commanded_speed_a_from_raw(1, 3000.0) <= 0.183105468751, "commanded_speed_a 1");
    expect(hiwin_e_commanded_speed_a_to_raw(hiwin_e_commanded_speed_a_from_raw(1, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "commanded_speed_a 1 back");
    expect(raw == 1, "commanded_speed_a 1 back");
    expect(hiwin_e_commanded_speed_a_from_raw(16384, 3000.0) >= 2999.999999997, "commanded_speed_a 16384");
    expect(hiwin_e_commanded_speed_a_from_raw(16384, 3000.0) <= 3000.000000003, "commanded_speed_a 16384");
    expect(hiwin_e_commanded_speed_a_to_raw(hiwin_e_commanded_speed_a_from_raw(16384, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "commanded_speed_a 16384 back");
    expect(raw == 16384, "commanded_speed_a 16384 back");
    expect(hiwin_e_commanded_speed_a_from_raw(32767, 3000.0) >= 5999.81689452525, "commanded_speed_a 32767");
    expect(hiwin_e_commanded_speed_a_from_raw(32767, 3000.0) <= 5999.81689453725, "commanded_speed_a 32767");
    expect(hiwin_e_commanded_speed_a_to_raw(hiwin_e_commanded_speed_a_from_raw(32767, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "commanded_speed_a 32767 back");
    expect(raw == 32767, "commanded_speed_a 32767 back");
    expect(hiwin_e_commanded_speed_a_to_raw(0.5, 16384.0, &raw) == HIWIN_E_OK, "commanded_speed_a 1/2");
    expect(raw == 0, "commanded_speed_a 1/2");
    expect(hiwin_e_commanded_speed_a_to_raw(1.5, 16384.0, &raw) == HIWIN_E_OK, "commanded_speed_a 3/2");
    expect(raw == 2, "commanded_speed_a 3/2");
    expect(hiwin_e_commanded_speed_a_to_raw(2.5, 16384.0, &raw) == HIWIN_E_OK, "commanded_speed_a 5/2");
    expect(raw == 2, "commanded_speed_a 5/2");
    expect(hiwin_e_commanded_speed_a_to_raw(6.0, 1.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "commanded_speed_a beyond");
    expect(hiwin_e_commanded_speed_a_to_raw(1.0, 0.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "commanded_speed_a of nothing");
    (void)raw;
    #endif
}

static void test_273(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    int16_t raw = 0;
    expect(hiwin_e_actual_speed_a_from_raw((-32768), 3000.0) >= -6000.000000006, "actual_speed_a -32768");
    expect(hiwin_e_actual_speed_a_from_raw((-32768), 3000.0) <= -5999.999999994, "actual_speed_a -32768");
    expect(hiwin_e_actual_speed_a_to_raw(hiwin_e_actual_speed_a_from_raw((-32768), 3000.0), 3000.0, &raw) == HIWIN_E_OK, "actual_speed_a -32768 back");
    expect(raw == (-32768), "actual_speed_a -32768 back");
    expect(hiwin_e_actual_speed_a_from_raw(0, 3000.0) >= -1e-12, "actual_speed_a 0");
    expect(hiwin_e_actual_speed_a_from_raw(0, 3000.0) <= 1e-12, "actual_speed_a 0");
    expect(hiwin_e_actual_speed_a_to_raw(hiwin_e_actual_speed_a_from_raw(0, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "actual_speed_a 0 back");
    expect(raw == 0, "actual_speed_a 0 back");
    expect(hiwin_e_actual_speed_a_from_raw(1, 3000.0) >= 0.183105468749, "actual_speed_a 1");
    expect(hiwin_e_actual_speed_a_from_raw(1, 3000.0) <= 0.183105468751, "actual_speed_a 1");
    expect(hiwin_e_actual_speed_a_to_raw(hiwin_e_actual_speed_a_from_raw(1, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "actual_speed_a 1 back");
    expect(raw == 1, "actual_speed_a 1 back");
    expect(hiwin_e_actual_speed_a_from_raw(16384, 3000.0) >= 2999.999999997, "actual_speed_a 16384");
    expect(hiwin_e_actual_speed_a_from_raw(16384, 3000.0) <= 3000.000000003, "actual_speed_a 16384");
    expect(hiwin_e_actual_speed_a_to_raw(hiwin_e_actual_speed_a_from_raw(16384, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "actual_speed_a 16384 back");
    expect(raw == 16384, "actual_speed_a 16384 back");
    expect(hiwin_e_actual_speed_a_from_raw(32767, 3000.0) >= 5999.81689452525, "actual_speed_a 32767");
    expect(hiwin_e_actual_speed_a_from_raw(32767, 3000.0) <= 5999.81689453725, "actual_speed_a 32767");
    expect(hiwin_e_actual_speed_a_to_raw(hiwin_e_actual_speed_a_from_raw(32767, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "actual_speed_a 32767 back");
    expect(raw == 32767, "actual_speed_a 32767 back");
    expect(hiwin_e_actual_speed_a_to_raw(0.5, 16384.0, &raw) == HIWIN_E_OK, "actual_speed_a 1/2");
    expect(raw == 0, "actual_speed_a 1/2");
    expect(hiwin_e_actual_speed_a_to_raw(1.5, 16384.0, &raw) == HIWIN_E_OK, "actual_speed_a 3/2");
    expect(raw == 2, "actual_speed_a 3/2");
    expect(hiwin_e_actual_speed_a_to_raw(2.5, 16384.0, &raw) == HIWIN_E_OK, "actual_speed_a 5/2");
    expect(raw == 2, "actual_speed_a 5/2");
    expect(hiwin_e_actual_speed_a_to_raw(6.0, 1.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "actual_speed_a beyond");
    expect(hiwin_e_actual_speed_a_to_raw(1.0, 0.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "actual_speed_a of nothing");
    (void)raw;
    #endif
}

static void test_274(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    uint16_t raw = 0;
    expect(hiwin_e_output_torque_from_raw(0u, 3000.0) >= 2999.999999997, "output_torque 0");
    expect(hiwin_e_output_torque_from_raw(0u, 3000.0) <= 3000.000000003, "output_torque 0");
    expect(hiwin_e_output_torque_to_raw(hiwin_e_output_torque_from_raw(0u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "output_torque 0 back");
    expect(raw == 0u, "output_torque 0 back");
    expect(hiwin_e_output_torque_from_raw(1u, 3000.0) >= 2999.81689452825, "output_torque 1");
    expect(hiwin_e_output_torque_from_raw(1u, 3000.0) <= 2999.81689453425, "output_torque 1");
    expect(hiwin_e_output_torque_to_raw(hiwin_e_output_torque_from_raw(1u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "output_torque 1 back");
    expect(raw == 1u, "output_torque 1 back");
    expect(hiwin_e_output_torque_from_raw(16384u, 3000.0) >= -1e-12, "output_torque 16384");
    expect(hiwin_e_output_torque_from_raw(16384u, 3000.0) <= 1e-12, "output_torque 16384");
    expect(hiwin_e_output_torque_to_raw(hiwin_e_output_torque_from_raw(16384u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "output_torque 16384 back");
    expect(raw == 16384u, "output_torque 16384 back");
    expect(hiwin_e_output_torque_to_raw(16383.5, 16384.0, &raw) == HIWIN_E_OK, "output_torque 1/2");
    expect(raw == 0u, "output_torque 1/2");
    expect(hiwin_e_output_torque_to_raw(16382.5, 16384.0, &raw) == HIWIN_E_OK, "output_torque 3/2");
    expect(raw == 2u, "output_torque 3/2");
    expect(hiwin_e_output_torque_to_raw(16381.5, 16384.0, &raw) == HIWIN_E_OK, "output_torque 5/2");
    expect(raw == 2u, "output_torque 5/2");
    expect(hiwin_e_output_torque_to_raw(-1.0001220703125, 1.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "output_torque beyond");
    expect(hiwin_e_output_torque_to_raw(1.0, 0.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "output_torque of nothing");
    (void)raw;
    #endif
}

static void test_275(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    uint16_t raw = 0;
    expect(hiwin_e_torque_reduced_by_from_raw(0u, 3000.0) >= -1e-12, "torque_reduced_by 0");
    expect(hiwin_e_torque_reduced_by_from_raw(0u, 3000.0) <= 1e-12, "torque_reduced_by 0");
    expect(hiwin_e_torque_reduced_by_to_raw(hiwin_e_torque_reduced_by_from_raw(0u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "torque_reduced_by 0 back");
    expect(raw == 0u, "torque_reduced_by 0 back");
    expect(hiwin_e_torque_reduced_by_from_raw(1u, 3000.0) >= 0.183105468749, "torque_reduced_by 1");
    expect(hiwin_e_torque_reduced_by_from_raw(1u, 3000.0) <= 0.183105468751, "torque_reduced_by 1");
    expect(hiwin_e_torque_reduced_by_to_raw(hiwin_e_torque_reduced_by_from_raw(1u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "torque_reduced_by 1 back");
    expect(raw == 1u, "torque_reduced_by 1 back");
    expect(hiwin_e_torque_reduced_by_from_raw(16384u, 3000.0) >= 2999.999999997, "torque_reduced_by 16384");
    expect(hiwin_e_torque_reduced_by_from_raw(16384u, 3000.0) <= 3000.000000003, "torque_reduced_by 16384");
    expect(hiwin_e_torque_reduced_by_to_raw(hiwin_e_torque_reduced_by_from_raw(16384u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "torque_reduced_by 16384 back");
    expect(raw == 16384u, "torque_reduced_by 16384 back");
    expect(hiwin_e_torque_reduced_by_to_raw(0.5, 16384.0, &raw) == HIWIN_E_OK, "torque_reduced_by 1/2");
    expect(raw == 0u, "torque_reduced_by 1/2");
    expect(hiwin_e_torque_reduced_by_to_raw(1.5, 16384.0, &raw) == HIWIN_E_OK, "torque_reduced_by 3/2");
    expect(raw == 2u, "torque_reduced_by 3/2");
    expect(hiwin_e_torque_reduced_by_to_raw(2.5, 16384.0, &raw) == HIWIN_E_OK, "torque_reduced_by 5/2");
    expect(raw == 2u, "torque_reduced_by 5/2");
    expect(hiwin_e_torque_reduced_by_to_raw(2.0001220703125, 1.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "torque_reduced_by beyond");
    expect(hiwin_e_torque_reduced_by_to_raw(1.0, 0.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "torque_reduced_by of nothing");
    (void)raw;
    #endif
}

static void test_276(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    int16_t raw = 0;
    expect(hiwin_e_motor_torque_from_raw((-32768), 3000.0) >= -6000.000000006, "motor_torque -32768");
    expect(hiwin_e_motor_torque_from_raw((-32768), 3000.0) <= -5999.999999994, "motor_torque -32768");
    expect(hiwin_e_motor_torque_to_raw(hiwin_e_motor_torque_from_raw((-32768), 3000.0), 3000.0, &raw) == HIWIN_E_OK, "motor_torque -32768 back");
    expect(raw == (-32768), "motor_torque -32768 back");
    expect(hiwin_e_motor_torque_from_raw(0, 3000.0) >= -1e-12, "motor_torque 0");
    expect(hiwin_e_motor_torque_from_raw(0, 3000.0) <= 1e-12, "motor_torque 0");
    expect(hiwin_e_motor_torque_to_raw(hiwin_e_motor_torque_from_raw(0, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "motor_torque 0 back");
    expect(raw == 0, "motor_torque 0 back");
    expect(hiwin_e_motor_torque_from_raw(1, 3000.0) >= 0.183105468749, "motor_torque 1");
    expect(hiwin_e_motor_torque_from_raw(1, 3000.0) <= 0.183105468751, "motor_torque 1");
    expect(hiwin_e_motor_torque_to_raw(hiwin_e_motor_torque_from_raw(1, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "motor_torque 1 back");
    expect(raw == 1, "motor_torque 1 back");
    expect(hiwin_e_motor_torque_from_raw(16384, 3000.0) >= 2999.999999997, "motor_torque 16384");
    expect(hiwin_e_motor_torque_from_raw(16384, 3000.0) <= 3000.000000003, "motor_torque 16384");
    expect(hiwin_e_motor_torque_to_raw(hiwin_e_motor_torque_from_raw(16384, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "motor_torque 16384 back");
    expect(raw == 16384, "motor_torque 16384 back");
    expect(hiwin_e_motor_torque_from_raw(32767, 3000.0) >= 5999.81689452525, "motor_torque 32767");
    expect(hiwin_e_motor_torque_from_raw(32767, 3000.0) <= 5999.81689453725, "motor_torque 32767");
    expect(hiwin_e_motor_torque_to_raw(hiwin_e_motor_torque_from_raw(32767, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "motor_torque 32767 back");
    expect(raw == 32767, "motor_torque 32767 back");
    expect(hiwin_e_motor_torque_to_raw(0.5, 16384.0, &raw) == HIWIN_E_OK, "motor_torque 1/2");
    expect(raw == 0, "motor_torque 1/2");
    expect(hiwin_e_motor_torque_to_raw(1.5, 16384.0, &raw) == HIWIN_E_OK, "motor_torque 3/2");
    expect(raw == 2, "motor_torque 3/2");
    expect(hiwin_e_motor_torque_to_raw(2.5, 16384.0, &raw) == HIWIN_E_OK, "motor_torque 5/2");
    expect(raw == 2, "motor_torque 5/2");
    expect(hiwin_e_motor_torque_to_raw(6.0, 1.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "motor_torque beyond");
    expect(hiwin_e_motor_torque_to_raw(1.0, 0.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "motor_torque of nothing");
    (void)raw;
    #endif
}

static void test_277(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    int16_t raw = 0;
    expect(hiwin_e_torque_value_from_raw((-32768), 3000.0) >= -6000.000000006, "torque_value -32768");
    expect(hiwin_e_torque_value_from_raw((-32768), 3000.0) <= -5999.999999994, "torque_value -32768");
    expect(hiwin_e_torque_value_to_raw(hiwin_e_torque_value_from_raw((-32768), 3000.0), 3000.0, &raw) == HIWIN_E_OK, "torque_value -32768 back");
    expect(raw == (-32768), "torque_value -32768 back");
    expect(hiwin_e_torque_value_from_raw(0, 3000.0) >= -1e-12, "torque_value 0");
    expect(hiwin_e_torque_value_from_raw(0, 3000.0) <= 1e-12, "torque_value 0");
    expect(hiwin_e_torque_value_to_raw(hiwin_e_torque_value_from_raw(0, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "torque_value 0 back");
    expect(raw == 0, "torque_value 0 back");
    expect(hiwin_e_torque_value_from_raw(1, 3000.0) >= 0.183105468749, "torque_value 1");
    expect(hiwin_e_torque_value_from_raw(1, 3000.0) <= 0.183105468751, "torque_value 1");
    expect(hiwin_e_torque_value_to_raw(hiwin_e_torque_value_from_raw(1, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "torque_value 1 back");
    expect(raw == 1, "torque_value 1 back");
    expect(hiwin_e_torque_value_from_raw(16384, 3000.0) >= 2999.999999997, "torque_value 16384");
    expect(hiwin_e_torque_value_from_raw(16384, 3000.0) <= 3000.000000003, "torque_value 16384");
    expect(hiwin_e_torque_value_to_raw(hiwin_e_torque_value_from_raw(16384, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "torque_value 16384 back");
    expect(raw == 16384, "torque_value 16384 back");
    expect(hiwin_e_torque_value_from_raw(32767, 3000.0) >= 5999.81689452525, "torque_value 32767");
    expect(hiwin_e_torque_value_from_raw(32767, 3000.0) <= 5999.81689453725, "torque_value 32767");
    expect(hiwin_e_torque_value_to_raw(hiwin_e_torque_value_from_raw(32767, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "torque_value 32767 back");
    expect(raw == 32767, "torque_value 32767 back");
    expect(hiwin_e_torque_value_to_raw(0.5, 16384.0, &raw) == HIWIN_E_OK, "torque_value 1/2");
    expect(raw == 0, "torque_value 1/2");
    expect(hiwin_e_torque_value_to_raw(1.5, 16384.0, &raw) == HIWIN_E_OK, "torque_value 3/2");
    expect(raw == 2, "torque_value 3/2");
    expect(hiwin_e_torque_value_to_raw(2.5, 16384.0, &raw) == HIWIN_E_OK, "torque_value 5/2");
    expect(raw == 2, "torque_value 5/2");
    expect(hiwin_e_torque_value_to_raw(6.0, 1.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "torque_value beyond");
    expect(hiwin_e_torque_value_to_raw(1.0, 0.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "torque_value of nothing");
    (void)raw;
    #endif
}

static void test_278(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    uint16_t raw = 0;
    expect(hiwin_e_share_of_acceleration_from_raw(0u, 3000.0) >= -1e-12, "share_of_acceleration 0");
    expect(hiwin_e_share_of_acceleration_from_raw(0u, 3000.0) <= 1e-12, "share_of_acceleration 0");
    expect(hiwin_e_share_of_acceleration_to_raw(hiwin_e_share_of_acceleration_from_raw(0u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "share_of_acceleration 0 back");
    expect(raw == 0u, "share_of_acceleration 0 back");
    expect(hiwin_e_share_of_acceleration_from_raw(1u, 3000.0) >= 0.183105468749, "share_of_acceleration 1");
    expect(hiwin_e_share_of_acceleration_from_raw(1u, 3000.0) <= 0.183105468751, "share_of_acceleration 1");
    expect(hiwin_e_share_of_acceleration_to_raw(hiwin_e_share_of_acceleration_from_raw(1u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "share_of_acceleration 1 back");
    expect(raw == 1u, "share_of_acceleration 1 back");
    expect(hiwin_e_share_of_acceleration_from_raw(16384u, 3000.0) >= 2999.999999997, "share_of_acceleration 16384");
    expect(hiwin_e_share_of_acceleration_from_raw(16384u, 3000.0) <= 3000.000000003, "share_of_acceleration 16384");
    expect(hiwin_e_share_of_acceleration_to_raw(hiwin_e_share_of_acceleration_from_raw(16384u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "share_of_acceleration 16384 back");
    expect(raw == 16384u, "share_of_acceleration 16384 back");
    expect(hiwin_e_share_of_acceleration_to_raw(0.5, 16384.0, &raw) == HIWIN_E_OK, "share_of_acceleration 1/2");
    expect(raw == 0u, "share_of_acceleration 1/2");
    expect(hiwin_e_share_of_acceleration_to_raw(1.5, 16384.0, &raw) == HIWIN_E_OK, "share_of_acceleration 3/2");
    expect(raw == 2u, "share_of_acceleration 3/2");
    expect(hiwin_e_share_of_acceleration_to_raw(2.5, 16384.0, &raw) == HIWIN_E_OK, "share_of_acceleration 5/2");
    expect(raw == 2u, "share_of_acceleration 5/2");
    expect(hiwin_e_share_of_acceleration_to_raw(2.0001220703125, 1.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "share_of_acceleration beyond");
    expect(hiwin_e_share_of_acceleration_to_raw(1.0, 0.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "share_of_acceleration of nothing");
    (void)raw;
    #endif
}

static void test_279(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    uint16_t raw = 0;
    expect(hiwin_e_overridden_velocity_from_raw(0u, 3000.0) >= -1e-12, "overridden_velocity 0");
    expect(hiwin_e_overridden_velocity_from_raw(0u, 3000.0) <= 1e-12, "overridden_velocity 0");
    expect(hiwin_e_overridden_velocity_to_raw(hiwin_e_overridden_velocity_from_raw(0u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "overridden_velocity 0 back");
    expect(raw == 0u, "overridden_velocity 0 back");
    expect(hiwin_e_overridden_velocity_from_raw(1u, 3000.0) >= 0.183105468749, "overridden_velocity 1");
    expect(hiwin_e_overridden_velocity_from_raw(1u, 3000.0) <= 0.183105468751, "overridden_velocity 1");
    expect(hiwin_e_overridden_velocity_to_raw(hiwin_e_overridden_velocity_from_raw(1u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "overridden_velocity 1 back");
    expect(raw == 1u, "overridden_velocity 1 back");
    expect(hiwin_e_overridden_velocity_from_raw(16384u, 3000.0) >= 2999.999999997, "overridden_velocity 16384");
    expect(hiwin_e_overridden_velocity_from_raw(16384u, 3000.0) <= 3000.000000003, "overridden_velocity 16384");
    expect(hiwin_e_overridden_velocity_to_raw(hiwin_e_overridden_velocity_from_raw(16384u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "overridden_velocity 16384 back");
    expect(raw == 16384u, "overridden_velocity 16384 back");
    expect(hiwin_e_overridden_velocity_from_raw(32767u, 3000.0) >= 5999.81689452525, "overridden_velocity 32767");
    expect(hiwin_e_overridden_velocity_from_raw(32767u, 3000.0) <= 5999.81689453725, "overridden_velocity 32767");
    expect(hiwin_e_overridden_velocity_to_raw(hiwin_e_overridden_velocity_from_raw(32767u, 3000.0), 3000.0, &raw) == HIWIN_E_OK, "overridden_velocity 32767 back");
    expect(raw == 32767u, "overridden_velocity 32767 back");
    expect(hiwin_e_overridden_velocity_to_raw(0.5, 16384.0, &raw) == HIWIN_E_OK, "overridden_velocity 1/2");
    expect(raw == 0u, "overridden_velocity 1/2");
    expect(hiwin_e_overridden_velocity_to_raw(1.5, 16384.0, &raw) == HIWIN_E_OK, "overridden_velocity 3/2");
    expect(raw == 2u, "overridden_velocity 3/2");
    expect(hiwin_e_overridden_velocity_to_raw(2.5, 16384.0, &raw) == HIWIN_E_OK, "overridden_velocity 5/2");
    expect(raw == 2u, "overridden_velocity 5/2");
    expect(hiwin_e_overridden_velocity_to_raw(4.0, 1.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "overridden_velocity beyond");
    expect(hiwin_e_overridden_velocity_to_raw(1.0, 0.0, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "overridden_velocity of nothing");
    (void)raw;
    #endif
}

static void test_280(void)
{
    static const uint8_t frame[] = {0x01, 0x01, 0x00, 0x01, 0x10, 0x00, 0x30, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-motor-type-request opens");
    expect(opened.request_reference == 1u, "example read-motor-type-request: request_reference");
    expect(opened.code == 1u, "example read-motor-type-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-motor-type-request decodes");
    expect(out.element_count == 0u, "example read-motor-type-request: element_count");
    expect(out.parameter_number == 12288u, "example read-motor-type-request: parameter_number");
    expect(out.subindex == 0u, "example read-motor-type-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 12288u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(1u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-motor-type-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-motor-type-request bytes");
}

static void test_281(void)
{
    static const uint8_t frame[] = {0x01, 0x01, 0x00, 0x01, 0x06, 0x01, 0x00, 0x02};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-motor-type-response opens");
    expect(opened.request_reference == 1u, "example read-motor-type-response: request_reference");
    expect(opened.code == 1u, "example read-motor-type-response: code");
    expect(opened.error == false, "example read-motor-type-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-motor-type-response decodes");
    expect(out.format == 6u, "example read-motor-type-response: format");
    expect(out.values_count == 1u, "example read-motor-type-response: values count");
    expect(out.values.unsigned_16_value[0] == 2u, "example read-motor-type-response: values");
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 2u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(1u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-motor-type-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-motor-type-response bytes");
}

static void test_282(void)
{
    static const uint8_t frame[] = {0x02, 0x01, 0x00, 0x01, 0x10, 0x00, 0x30, 0x59, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-yaw-position-request opens");
    expect(opened.request_reference == 2u, "example read-yaw-position-request: request_reference");
    expect(opened.code == 1u, "example read-yaw-position-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-yaw-position-request decodes");
    expect(out.element_count == 0u, "example read-yaw-position-request: element_count");
    expect(out.parameter_number == 12377u, "example read-yaw-position-request: parameter_number");
    expect(out.subindex == 0u, "example read-yaw-position-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 12377u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(2u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-yaw-position-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-yaw-position-request bytes");
}

static void test_283(void)
{
    static const uint8_t frame[] = {0x02, 0x01, 0x00, 0x01, 0x04, 0x01, 0x80, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-yaw-position-response opens");
    expect(opened.request_reference == 2u, "example read-yaw-position-response: request_reference");
    expect(opened.code == 1u, "example read-yaw-position-response: code");
    expect(opened.error == false, "example read-yaw-position-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-yaw-position-response decodes");
    expect(out.format == 4u, "example read-yaw-position-response: format");
    expect(out.values_count == 1u, "example read-yaw-position-response: values count");
    expect(out.values.integer_32_value[0] == (-2147483647 - 1), "example read-yaw-position-response: values");
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = (-2147483647 - 1);
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(2u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-yaw-position-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-yaw-position-response bytes");
}

static void test_284(void)
{
    static const uint8_t frame[] = {0x03, 0x01, 0x00, 0x01, 0x10, 0x00, 0x30, 0x63, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-analog-input-request opens");
    expect(opened.request_reference == 3u, "example read-analog-input-request: request_reference");
    expect(opened.code == 1u, "example read-analog-input-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-analog-input-request decodes");
    expect(out.element_count == 0u, "example read-analog-input-request: element_count");
    expect(out.parameter_number == 12387u, "example read-analog-input-request: parameter_number");
    expect(out.subindex == 0u, "example read-analog-input-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 12387u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(3u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-analog-input-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-analog-input-request bytes");
}

static void test_285(void)
{
    static const uint8_t frame[] = {0x03, 0x01, 0x00, 0x01, 0x03, 0x01, 0xD8, 0xF0};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-analog-input-response opens");
    expect(opened.request_reference == 3u, "example read-analog-input-response: request_reference");
    expect(opened.code == 1u, "example read-analog-input-response: code");
    expect(opened.error == false, "example read-analog-input-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-analog-input-response decodes");
    expect(out.format == 3u, "example read-analog-input-response: format");
    expect(out.values_count == 1u, "example read-analog-input-response: values count");
    expect(out.values.integer_16_value[0] == (-10000), "example read-analog-input-response: values");
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = (-10000);
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(3u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-analog-input-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-analog-input-response bytes");
}

static void test_286(void)
{
    static const uint8_t frame[] = {0x04, 0x01, 0x00, 0x01, 0x10, 0x00, 0x31, 0x20, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-operation-warnings-request opens");
    expect(opened.request_reference == 4u, "example read-operation-warnings-request: request_reference");
    expect(opened.code == 1u, "example read-operation-warnings-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-operation-warnings-request decodes");
    expect(out.element_count == 0u, "example read-operation-warnings-request: element_count");
    expect(out.parameter_number == 12576u, "example read-operation-warnings-request: parameter_number");
    expect(out.subindex == 0u, "example read-operation-warnings-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 12576u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(4u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-operation-warnings-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-operation-warnings-request bytes");
}

static void test_287(void)
{
    static const uint8_t frame[] = {0x04, 0x01, 0x00, 0x01, 0x07, 0x01, 0x00, 0x00, 0x80, 0xC0};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-operation-warnings-response opens");
    expect(opened.request_reference == 4u, "example read-operation-warnings-response: request_reference");
    expect(opened.code == 1u, "example read-operation-warnings-response: code");
    expect(opened.error == false, "example read-operation-warnings-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-operation-warnings-response decodes");
    expect(out.format == 7u, "example read-operation-warnings-response: format");
    expect(out.values_count == 1u, "example read-operation-warnings-response: values count");
    expect(out.values.unsigned_32_value[0] == 32960u, "example read-operation-warnings-response: values");
    in.format = 7u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 32960u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(4u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-operation-warnings-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-operation-warnings-response bytes");
}

static void test_288(void)
{
    static const uint8_t frame[] = {0x05, 0x01, 0x00, 0x01, 0x10, 0x00, 0x32, 0x14, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-general-float-request opens");
    expect(opened.request_reference == 5u, "example read-general-float-request: request_reference");
    expect(opened.code == 1u, "example read-general-float-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-general-float-request decodes");
    expect(out.element_count == 0u, "example read-general-float-request: element_count");
    expect(out.parameter_number == 12820u, "example read-general-float-request: parameter_number");
    expect(out.subindex == 0u, "example read-general-float-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 12820u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(5u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-general-float-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-general-float-request bytes");
}

static void test_289(void)
{
    static const uint8_t frame[] = {0x05, 0x01, 0x00, 0x01, 0x08, 0x01, 0xBE, 0x20, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-general-float-response opens");
    expect(opened.request_reference == 5u, "example read-general-float-response: request_reference");
    expect(opened.code == 1u, "example read-general-float-response: code");
    expect(opened.error == false, "example read-general-float-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-general-float-response decodes");
    expect(out.format == 8u, "example read-general-float-response: format");
    expect(out.values_count == 1u, "example read-general-float-response: values count");
    expect(hiwin_e_bits_of(out.values.floating_point_value[0]) == 0xBE200000u, "example read-general-float-response: values");
    in.format = 8u;
    in.values_count = 1u;
    in.values.floating_point_value[0] = hiwin_e_float_of(0xBE200000u);
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(5u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-general-float-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-general-float-response bytes");
}

static void test_290(void)
{
    static const uint8_t frame[] = {0x06, 0x01, 0x00, 0x01, 0x10, 0x00, 0x31, 0x10, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-warnings-as-word-request opens");
    expect(opened.request_reference == 6u, "example read-warnings-as-word-request: request_reference");
    expect(opened.code == 1u, "example read-warnings-as-word-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-warnings-as-word-request decodes");
    expect(out.element_count == 0u, "example read-warnings-as-word-request: element_count");
    expect(out.parameter_number == 12560u, "example read-warnings-as-word-request: parameter_number");
    expect(out.subindex == 0u, "example read-warnings-as-word-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 12560u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(6u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-warnings-as-word-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-warnings-as-word-request bytes");
}

static void test_291(void)
{
    static const uint8_t frame[] = {0x06, 0x01, 0x00, 0x01, 0x42, 0x01, 0x08, 0x04};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-warnings-as-word-response opens");
    expect(opened.request_reference == 6u, "example read-warnings-as-word-response: request_reference");
    expect(opened.code == 1u, "example read-warnings-as-word-response: code");
    expect(opened.error == false, "example read-warnings-as-word-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-warnings-as-word-response decodes");
    expect(out.format == 66u, "example read-warnings-as-word-response: format");
    expect(out.values_count == 1u, "example read-warnings-as-word-response: values count");
    expect(out.values.unsigned_16_value[0] == 2052u, "example read-warnings-as-word-response: values");
    in.format = 66u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 2052u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(6u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-warnings-as-word-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-warnings-as-word-response bytes");
}

static void test_292(void)
{
    static const uint8_t frame[] = {0x07, 0x01, 0x00, 0x01, 0x10, 0x00, 0x31, 0x20, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-operation-warnings-as-double-word-request opens");
    expect(opened.request_reference == 7u, "example read-operation-warnings-as-double-word-request: request_reference");
    expect(opened.code == 1u, "example read-operation-warnings-as-double-word-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-operation-warnings-as-double-word-request decodes");
    expect(out.element_count == 0u, "example read-operation-warnings-as-double-word-request: element_count");
    expect(out.parameter_number == 12576u, "example read-operation-warnings-as-double-word-request: parameter_number");
    expect(out.subindex == 0u, "example read-operation-warnings-as-double-word-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 12576u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(7u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-operation-warnings-as-double-word-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-operation-warnings-as-double-word-request bytes");
}

static void test_293(void)
{
    static const uint8_t frame[] = {0x07, 0x01, 0x00, 0x01, 0x43, 0x01, 0xFF, 0xFF, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-operation-warnings-as-double-word-response opens");
    expect(opened.request_reference == 7u, "example read-operation-warnings-as-double-word-response: request_reference");
    expect(opened.code == 1u, "example read-operation-warnings-as-double-word-response: code");
    expect(opened.error == false, "example read-operation-warnings-as-double-word-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-operation-warnings-as-double-word-response decodes");
    expect(out.format == 67u, "example read-operation-warnings-as-double-word-response: format");
    expect(out.values_count == 1u, "example read-operation-warnings-as-double-word-response: values count");
    expect(out.values.unsigned_32_value[0] == 4294967295u, "example read-operation-warnings-as-double-word-response: values");
    in.format = 67u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 4294967295u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(7u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-operation-warnings-as-double-word-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-operation-warnings-as-double-word-response bytes");
}

static void test_294(void)
{
    static const uint8_t frame[] = {0x08, 0x01, 0x00, 0x01, 0x10, 0x04, 0x03, 0xB1, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-alarm-codes-request opens");
    expect(opened.request_reference == 8u, "example read-alarm-codes-request: request_reference");
    expect(opened.code == 1u, "example read-alarm-codes-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-alarm-codes-request decodes");
    expect(out.element_count == 4u, "example read-alarm-codes-request: element_count");
    expect(out.parameter_number == 945u, "example read-alarm-codes-request: parameter_number");
    expect(out.subindex == 0u, "example read-alarm-codes-request: subindex");
    in.element_count = 4u;
    in.parameter_number = 945u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(8u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-alarm-codes-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-alarm-codes-request bytes");
}

static void test_295(void)
{
    static const uint8_t frame[] = {0x08, 0x01, 0x00, 0x01, 0x06, 0x04, 0x0E, 0xE0, 0x00, 0x24, 0x0F, 0xD0, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-alarm-codes-response opens");
    expect(opened.request_reference == 8u, "example read-alarm-codes-response: request_reference");
    expect(opened.code == 1u, "example read-alarm-codes-response: code");
    expect(opened.error == false, "example read-alarm-codes-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-alarm-codes-response decodes");
    expect(out.format == 6u, "example read-alarm-codes-response: format");
    expect(out.values_count == 4u, "example read-alarm-codes-response: values count");
    expect(out.values.unsigned_16_value[0] == 3808u, "example read-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[1] == 36u, "example read-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[2] == 4048u, "example read-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[3] == 0u, "example read-alarm-codes-response: values");
    in.format = 6u;
    in.values_count = 4u;
    in.values.unsigned_16_value[0] = 3808u;
    in.values.unsigned_16_value[1] = 36u;
    in.values.unsigned_16_value[2] = 4048u;
    in.values.unsigned_16_value[3] = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(8u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-alarm-codes-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-alarm-codes-response bytes");
}

static void test_296(void)
{
    static const uint8_t frame[] = {0x09, 0x01, 0x00, 0x01, 0x10, 0x07, 0x03, 0xC4, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-identification-request opens");
    expect(opened.request_reference == 9u, "example read-identification-request: request_reference");
    expect(opened.code == 1u, "example read-identification-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-identification-request decodes");
    expect(out.element_count == 7u, "example read-identification-request: element_count");
    expect(out.parameter_number == 964u, "example read-identification-request: parameter_number");
    expect(out.subindex == 0u, "example read-identification-request: subindex");
    in.element_count = 7u;
    in.parameter_number = 964u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(9u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-identification-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-identification-request bytes");
}

static void test_297(void)
{
    static const uint8_t frame[] = {0x09, 0x01, 0x00, 0x01, 0x06, 0x07, 0x0A, 0xAA, 0x00, 0x05, 0x00, 0xD0, 0x07, 0xE8, 0x0C, 0x28, 0x00, 0x01, 0x00, 0x10};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-identification-response opens");
    expect(opened.request_reference == 9u, "example read-identification-response: request_reference");
    expect(opened.code == 1u, "example read-identification-response: code");
    expect(opened.error == false, "example read-identification-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-identification-response decodes");
    expect(out.format == 6u, "example read-identification-response: format");
    expect(out.values_count == 7u, "example read-identification-response: values count");
    expect(out.values.unsigned_16_value[0] == 2730u, "example read-identification-response: values");
    expect(out.values.unsigned_16_value[1] == 5u, "example read-identification-response: values");
    expect(out.values.unsigned_16_value[2] == 208u, "example read-identification-response: values");
    expect(out.values.unsigned_16_value[3] == 2024u, "example read-identification-response: values");
    expect(out.values.unsigned_16_value[4] == 3112u, "example read-identification-response: values");
    expect(out.values.unsigned_16_value[5] == 1u, "example read-identification-response: values");
    expect(out.values.unsigned_16_value[6] == 16u, "example read-identification-response: values");
    in.format = 6u;
    in.values_count = 7u;
    in.values.unsigned_16_value[0] = 2730u;
    in.values.unsigned_16_value[1] = 5u;
    in.values.unsigned_16_value[2] = 208u;
    in.values.unsigned_16_value[3] = 2024u;
    in.values.unsigned_16_value[4] = 3112u;
    in.values.unsigned_16_value[5] = 1u;
    in.values.unsigned_16_value[6] = 16u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(9u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-identification-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-identification-response bytes");
}

static void test_298(void)
{
    static const uint8_t frame[] = {0x0A, 0x01, 0x00, 0x01, 0x10, 0x06, 0x03, 0xD3, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-encoder-format-request opens");
    expect(opened.request_reference == 10u, "example read-encoder-format-request: request_reference");
    expect(opened.code == 1u, "example read-encoder-format-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-encoder-format-request decodes");
    expect(out.element_count == 6u, "example read-encoder-format-request: element_count");
    expect(out.parameter_number == 979u, "example read-encoder-format-request: parameter_number");
    expect(out.subindex == 0u, "example read-encoder-format-request: subindex");
    in.element_count = 6u;
    in.parameter_number = 979u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(10u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-encoder-format-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-encoder-format-request bytes");
}

static void test_299(void)
{
    static const uint8_t frame[] = {0x0A, 0x01, 0x00, 0x01, 0x07, 0x06, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-encoder-format-response opens");
    expect(opened.request_reference == 10u, "example read-encoder-format-response: request_reference");
    expect(opened.code == 1u, "example read-encoder-format-response: code");
    expect(opened.error == false, "example read-encoder-format-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-encoder-format-response decodes");
    expect(out.format == 7u, "example read-encoder-format-response: format");
    expect(out.values_count == 6u, "example read-encoder-format-response: values count");
    expect(out.values.unsigned_32_value[0] == 0u, "example read-encoder-format-response: values");
    expect(out.values.unsigned_32_value[1] == 1u, "example read-encoder-format-response: values");
    expect(out.values.unsigned_32_value[2] == 8388608u, "example read-encoder-format-response: values");
    expect(out.values.unsigned_32_value[3] == 0u, "example read-encoder-format-response: values");
    expect(out.values.unsigned_32_value[4] == 0u, "example read-encoder-format-response: values");
    expect(out.values.unsigned_32_value[5] == 65536u, "example read-encoder-format-response: values");
    in.format = 7u;
    in.values_count = 6u;
    in.values.unsigned_32_value[0] = 0u;
    in.values.unsigned_32_value[1] = 1u;
    in.values.unsigned_32_value[2] = 8388608u;
    in.values.unsigned_32_value[3] = 0u;
    in.values.unsigned_32_value[4] = 0u;
    in.values.unsigned_32_value[5] = 65536u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(10u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-encoder-format-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-encoder-format-response bytes");
}

static void test_300(void)
{
    static const uint8_t frame[] = {0xFF, 0x01, 0x00, 0x01, 0x10, 0x40, 0x03, 0xB3, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-all-internal-alarm-codes-request opens");
    expect(opened.request_reference == 255u, "example read-all-internal-alarm-codes-request: request_reference");
    expect(opened.code == 1u, "example read-all-internal-alarm-codes-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-all-internal-alarm-codes-request decodes");
    expect(out.element_count == 64u, "example read-all-internal-alarm-codes-request: element_count");
    expect(out.parameter_number == 947u, "example read-all-internal-alarm-codes-request: parameter_number");
    expect(out.subindex == 0u, "example read-all-internal-alarm-codes-request: subindex");
    in.element_count = 64u;
    in.parameter_number = 947u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(255u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-all-internal-alarm-codes-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-all-internal-alarm-codes-request bytes");
}

static void test_301(void)
{
    static const uint8_t frame[] = {0xFF, 0x01, 0x00, 0x01, 0x06, 0x40, 0x00, 0x4E, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x50};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-all-internal-alarm-codes-response opens");
    expect(opened.request_reference == 255u, "example read-all-internal-alarm-codes-response: request_reference");
    expect(opened.code == 1u, "example read-all-internal-alarm-codes-response: code");
    expect(opened.error == false, "example read-all-internal-alarm-codes-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-all-internal-alarm-codes-response decodes");
    expect(out.format == 6u, "example read-all-internal-alarm-codes-response: format");
    expect(out.values_count == 64u, "example read-all-internal-alarm-codes-response: values count");
    expect(out.values.unsigned_16_value[0] == 78u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[1] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[2] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[3] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[4] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[5] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[6] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[7] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[8] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[9] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[10] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[11] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[12] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[13] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[14] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[15] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[16] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[17] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[18] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[19] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[20] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[21] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[22] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[23] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[24] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[25] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[26] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[27] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[28] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[29] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[30] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[31] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[32] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[33] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[34] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[35] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[36] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[37] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[38] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[39] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[40] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[41] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[42] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[43] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[44] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[45] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[46] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[47] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[48] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[49] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[50] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[51] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[52] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[53] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[54] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[55] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[56] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[57] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[58] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[59] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[60] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[61] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[62] == 0u, "example read-all-internal-alarm-codes-response: values");
    expect(out.values.unsigned_16_value[63] == 80u, "example read-all-internal-alarm-codes-response: values");
    in.format = 6u;
    in.values_count = 64u;
    in.values.unsigned_16_value[0] = 78u;
    in.values.unsigned_16_value[1] = 0u;
    in.values.unsigned_16_value[2] = 0u;
    in.values.unsigned_16_value[3] = 0u;
    in.values.unsigned_16_value[4] = 0u;
    in.values.unsigned_16_value[5] = 0u;
    in.values.unsigned_16_value[6] = 0u;
    in.values.unsigned_16_value[7] = 0u;
    in.values.unsigned_16_value[8] = 0u;
    in.values.unsigned_16_value[9] = 0u;
    in.values.unsigned_16_value[10] = 0u;
    in.values.unsigned_16_value[11] = 0u;
    in.values.unsigned_16_value[12] = 0u;
    in.values.unsigned_16_value[13] = 0u;
    in.values.unsigned_16_value[14] = 0u;
    in.values.unsigned_16_value[15] = 0u;
    in.values.unsigned_16_value[16] = 0u;
    in.values.unsigned_16_value[17] = 0u;
    in.values.unsigned_16_value[18] = 0u;
    in.values.unsigned_16_value[19] = 0u;
    in.values.unsigned_16_value[20] = 0u;
    in.values.unsigned_16_value[21] = 0u;
    in.values.unsigned_16_value[22] = 0u;
    in.values.unsigned_16_value[23] = 0u;
    in.values.unsigned_16_value[24] = 0u;
    in.values.unsigned_16_value[25] = 0u;
    in.values.unsigned_16_value[26] = 0u;
    in.values.unsigned_16_value[27] = 0u;
    in.values.unsigned_16_value[28] = 0u;
    in.values.unsigned_16_value[29] = 0u;
    in.values.unsigned_16_value[30] = 0u;
    in.values.unsigned_16_value[31] = 0u;
    in.values.unsigned_16_value[32] = 0u;
    in.values.unsigned_16_value[33] = 0u;
    in.values.unsigned_16_value[34] = 0u;
    in.values.unsigned_16_value[35] = 0u;
    in.values.unsigned_16_value[36] = 0u;
    in.values.unsigned_16_value[37] = 0u;
    in.values.unsigned_16_value[38] = 0u;
    in.values.unsigned_16_value[39] = 0u;
    in.values.unsigned_16_value[40] = 0u;
    in.values.unsigned_16_value[41] = 0u;
    in.values.unsigned_16_value[42] = 0u;
    in.values.unsigned_16_value[43] = 0u;
    in.values.unsigned_16_value[44] = 0u;
    in.values.unsigned_16_value[45] = 0u;
    in.values.unsigned_16_value[46] = 0u;
    in.values.unsigned_16_value[47] = 0u;
    in.values.unsigned_16_value[48] = 0u;
    in.values.unsigned_16_value[49] = 0u;
    in.values.unsigned_16_value[50] = 0u;
    in.values.unsigned_16_value[51] = 0u;
    in.values.unsigned_16_value[52] = 0u;
    in.values.unsigned_16_value[53] = 0u;
    in.values.unsigned_16_value[54] = 0u;
    in.values.unsigned_16_value[55] = 0u;
    in.values.unsigned_16_value[56] = 0u;
    in.values.unsigned_16_value[57] = 0u;
    in.values.unsigned_16_value[58] = 0u;
    in.values.unsigned_16_value[59] = 0u;
    in.values.unsigned_16_value[60] = 0u;
    in.values.unsigned_16_value[61] = 0u;
    in.values.unsigned_16_value[62] = 0u;
    in.values.unsigned_16_value[63] = 80u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(255u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-all-internal-alarm-codes-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-all-internal-alarm-codes-response bytes");
}

static void test_302(void)
{
    static const uint8_t frame[] = {0x0B, 0x01, 0x00, 0x01, 0x10, 0x02, 0x21, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-booleans-request opens");
    expect(opened.request_reference == 11u, "example read-booleans-request: request_reference");
    expect(opened.code == 1u, "example read-booleans-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-booleans-request decodes");
    expect(out.element_count == 2u, "example read-booleans-request: element_count");
    expect(out.parameter_number == 8448u, "example read-booleans-request: parameter_number");
    expect(out.subindex == 0u, "example read-booleans-request: subindex");
    in.element_count = 2u;
    in.parameter_number = 8448u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(11u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-booleans-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-booleans-request bytes");
}

static void test_303(void)
{
    static const uint8_t frame[] = {0x0B, 0x01, 0x00, 0x01, 0x01, 0x02, 0x01, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-booleans-response opens");
    expect(opened.request_reference == 11u, "example read-booleans-response: request_reference");
    expect(opened.code == 1u, "example read-booleans-response: code");
    expect(opened.error == false, "example read-booleans-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-booleans-response decodes");
    expect(out.format == 1u, "example read-booleans-response: format");
    expect(out.values_count == 2u, "example read-booleans-response: values count");
    expect(out.values.boolean_value[0] == true, "example read-booleans-response: values");
    expect(out.values.boolean_value[1] == false, "example read-booleans-response: values");
    in.format = 1u;
    in.values_count = 2u;
    in.values.boolean_value[0] = true;
    in.values.boolean_value[1] = false;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(11u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-booleans-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-booleans-response bytes");
}

static void test_304(void)
{
    static const uint8_t frame[] = {0x0C, 0x01, 0x00, 0x01, 0x10, 0x02, 0x21, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-integers-of-8-bits-request opens");
    expect(opened.request_reference == 12u, "example read-integers-of-8-bits-request: request_reference");
    expect(opened.code == 1u, "example read-integers-of-8-bits-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-integers-of-8-bits-request decodes");
    expect(out.element_count == 2u, "example read-integers-of-8-bits-request: element_count");
    expect(out.parameter_number == 8448u, "example read-integers-of-8-bits-request: parameter_number");
    expect(out.subindex == 0u, "example read-integers-of-8-bits-request: subindex");
    in.element_count = 2u;
    in.parameter_number = 8448u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(12u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-integers-of-8-bits-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-integers-of-8-bits-request bytes");
}

static void test_305(void)
{
    static const uint8_t frame[] = {0x0C, 0x01, 0x00, 0x01, 0x02, 0x02, 0x80, 0x7F};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-integers-of-8-bits-response opens");
    expect(opened.request_reference == 12u, "example read-integers-of-8-bits-response: request_reference");
    expect(opened.code == 1u, "example read-integers-of-8-bits-response: code");
    expect(opened.error == false, "example read-integers-of-8-bits-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-integers-of-8-bits-response decodes");
    expect(out.format == 2u, "example read-integers-of-8-bits-response: format");
    expect(out.values_count == 2u, "example read-integers-of-8-bits-response: values count");
    expect(out.values.integer_8_value[0] == (-128), "example read-integers-of-8-bits-response: values");
    expect(out.values.integer_8_value[1] == 127, "example read-integers-of-8-bits-response: values");
    in.format = 2u;
    in.values_count = 2u;
    in.values.integer_8_value[0] = (-128);
    in.values.integer_8_value[1] = 127;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(12u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-integers-of-8-bits-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-integers-of-8-bits-response bytes");
}

static void test_306(void)
{
    static const uint8_t frame[] = {0x0D, 0x01, 0x00, 0x01, 0x10, 0x02, 0x21, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-unsigned-8-request opens");
    expect(opened.request_reference == 13u, "example read-unsigned-8-request: request_reference");
    expect(opened.code == 1u, "example read-unsigned-8-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-unsigned-8-request decodes");
    expect(out.element_count == 2u, "example read-unsigned-8-request: element_count");
    expect(out.parameter_number == 8448u, "example read-unsigned-8-request: parameter_number");
    expect(out.subindex == 0u, "example read-unsigned-8-request: subindex");
    in.element_count = 2u;
    in.parameter_number = 8448u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(13u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-unsigned-8-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-unsigned-8-request bytes");
}

static void test_307(void)
{
    static const uint8_t frame[] = {0x0D, 0x01, 0x00, 0x01, 0x05, 0x02, 0x00, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-unsigned-8-response opens");
    expect(opened.request_reference == 13u, "example read-unsigned-8-response: request_reference");
    expect(opened.code == 1u, "example read-unsigned-8-response: code");
    expect(opened.error == false, "example read-unsigned-8-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-unsigned-8-response decodes");
    expect(out.format == 5u, "example read-unsigned-8-response: format");
    expect(out.values_count == 2u, "example read-unsigned-8-response: values count");
    expect(out.values.unsigned_8_value[0] == 0u, "example read-unsigned-8-response: values");
    expect(out.values.unsigned_8_value[1] == 255u, "example read-unsigned-8-response: values");
    in.format = 5u;
    in.values_count = 2u;
    in.values.unsigned_8_value[0] = 0u;
    in.values.unsigned_8_value[1] = 255u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(13u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-unsigned-8-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-unsigned-8-response bytes");
}

static void test_308(void)
{
    static const uint8_t frame[] = {0x0E, 0x01, 0x00, 0x01, 0x10, 0x04, 0x4F, 0xFF, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-bytes-request opens");
    expect(opened.request_reference == 14u, "example read-bytes-request: request_reference");
    expect(opened.code == 1u, "example read-bytes-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-bytes-request decodes");
    expect(out.element_count == 4u, "example read-bytes-request: element_count");
    expect(out.parameter_number == 20479u, "example read-bytes-request: parameter_number");
    expect(out.subindex == 0u, "example read-bytes-request: subindex");
    in.element_count = 4u;
    in.parameter_number = 20479u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(14u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-bytes-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-bytes-request bytes");
}

static void test_309(void)
{
    static const uint8_t frame[] = {0x0E, 0x01, 0x00, 0x01, 0x41, 0x04, 0x01, 0x02, 0x04, 0x80};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-bytes-response opens");
    expect(opened.request_reference == 14u, "example read-bytes-response: request_reference");
    expect(opened.code == 1u, "example read-bytes-response: code");
    expect(opened.error == false, "example read-bytes-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-bytes-response decodes");
    expect(out.format == 65u, "example read-bytes-response: format");
    expect(out.values_count == 4u, "example read-bytes-response: values count");
    expect(out.values.unsigned_8_value[0] == 1u, "example read-bytes-response: values");
    expect(out.values.unsigned_8_value[1] == 2u, "example read-bytes-response: values");
    expect(out.values.unsigned_8_value[2] == 4u, "example read-bytes-response: values");
    expect(out.values.unsigned_8_value[3] == 128u, "example read-bytes-response: values");
    in.format = 65u;
    in.values_count = 4u;
    in.values.unsigned_8_value[0] = 1u;
    in.values.unsigned_8_value[1] = 2u;
    in.values.unsigned_8_value[2] = 4u;
    in.values.unsigned_8_value[3] = 128u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(14u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-bytes-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-bytes-response bytes");
}

static void test_310(void)
{
    static const uint8_t frame[] = {0x0F, 0x01, 0x00, 0x01, 0x10, 0x00, 0x23, 0x17, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-reference-speed-request opens");
    expect(opened.request_reference == 15u, "example read-reference-speed-request: request_reference");
    expect(opened.code == 1u, "example read-reference-speed-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-reference-speed-request decodes");
    expect(out.element_count == 0u, "example read-reference-speed-request: element_count");
    expect(out.parameter_number == 8983u, "example read-reference-speed-request: parameter_number");
    expect(out.subindex == 0u, "example read-reference-speed-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 8983u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(15u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-reference-speed-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-reference-speed-request bytes");
}

static void test_311(void)
{
    static const uint8_t frame[] = {0x0F, 0x01, 0x00, 0x01, 0x06, 0x01, 0x0B, 0xB8};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-reference-speed-response opens");
    expect(opened.request_reference == 15u, "example read-reference-speed-response: request_reference");
    expect(opened.code == 1u, "example read-reference-speed-response: code");
    expect(opened.error == false, "example read-reference-speed-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-reference-speed-response decodes");
    expect(out.format == 6u, "example read-reference-speed-response: format");
    expect(out.values_count == 1u, "example read-reference-speed-response: values count");
    expect(out.values.unsigned_16_value[0] == 3000u, "example read-reference-speed-response: values");
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 3000u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(15u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-reference-speed-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-reference-speed-response bytes");
}

static void test_312(void)
{
    static const uint8_t frame[] = {0x10, 0x01, 0x00, 0x01, 0x10, 0x00, 0x40, 0x05, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-digital-output-states-request opens");
    expect(opened.request_reference == 16u, "example read-digital-output-states-request: request_reference");
    expect(opened.code == 1u, "example read-digital-output-states-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-digital-output-states-request decodes");
    expect(out.element_count == 0u, "example read-digital-output-states-request: element_count");
    expect(out.parameter_number == 16389u, "example read-digital-output-states-request: parameter_number");
    expect(out.subindex == 0u, "example read-digital-output-states-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 16389u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(16u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-digital-output-states-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-digital-output-states-request bytes");
}

static void test_313(void)
{
    static const uint8_t frame[] = {0x10, 0x01, 0x00, 0x01, 0x06, 0x01, 0x00, 0x1F};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-digital-output-states-response opens");
    expect(opened.request_reference == 16u, "example read-digital-output-states-response: request_reference");
    expect(opened.code == 1u, "example read-digital-output-states-response: code");
    expect(opened.error == false, "example read-digital-output-states-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-digital-output-states-response decodes");
    expect(out.format == 6u, "example read-digital-output-states-response: format");
    expect(out.values_count == 1u, "example read-digital-output-states-response: values count");
    expect(out.values.unsigned_16_value[0] == 31u, "example read-digital-output-states-response: values");
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 31u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(16u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-digital-output-states-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-digital-output-states-response bytes");
}

static void test_314(void)
{
    static const uint8_t frame[] = {0x11, 0x01, 0x00, 0x01, 0x10, 0x00, 0x40, 0x95, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-alarm-request opens");
    expect(opened.request_reference == 17u, "example read-alarm-request: request_reference");
    expect(opened.code == 1u, "example read-alarm-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-alarm-request decodes");
    expect(out.element_count == 0u, "example read-alarm-request: element_count");
    expect(out.parameter_number == 16533u, "example read-alarm-request: parameter_number");
    expect(out.subindex == 0u, "example read-alarm-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 16533u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(17u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-alarm-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-alarm-request bytes");
}

static void test_315(void)
{
    static const uint8_t frame[] = {0x11, 0x01, 0x00, 0x01, 0x06, 0x01, 0x07, 0x10};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_read_parameter_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-alarm-response opens");
    expect(opened.request_reference == 17u, "example read-alarm-response: request_reference");
    expect(opened.code == 1u, "example read-alarm-response: code");
    expect(opened.error == false, "example read-alarm-response: error");
    expect(hiwin_e_read_parameter_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-alarm-response decodes");
    expect(out.format == 6u, "example read-alarm-response: format");
    expect(out.values_count == 1u, "example read-alarm-response: values count");
    expect(out.values.unsigned_16_value[0] == 1808u, "example read-alarm-response: values");
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 1808u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_response(17u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-alarm-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-alarm-response bytes");
}

static void test_316(void)
{
    static const uint8_t frame[] = {0x21, 0x02, 0x00, 0x01, 0x10, 0x00, 0x30, 0x44, 0x00, 0x00, 0x06, 0x01, 0x00, 0x1F};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-digital-outputs-request opens");
    expect(opened.request_reference == 33u, "example write-digital-outputs-request: request_reference");
    expect(opened.code == 2u, "example write-digital-outputs-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-digital-outputs-request decodes");
    expect(out.element_count == 0u, "example write-digital-outputs-request: element_count");
    expect(out.parameter_number == 12356u, "example write-digital-outputs-request: parameter_number");
    expect(out.subindex == 0u, "example write-digital-outputs-request: subindex");
    expect(out.format == 6u, "example write-digital-outputs-request: format");
    expect(out.values_count == 1u, "example write-digital-outputs-request: values count");
    expect(out.values.unsigned_16_value[0] == 31u, "example write-digital-outputs-request: values");
    in.element_count = 0u;
    in.parameter_number = 12356u;
    in.subindex = 0u;
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 31u;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(33u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-digital-outputs-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-digital-outputs-request bytes");
}

static void test_317(void)
{
    static const uint8_t frame[] = {0x21, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-digital-outputs-response opens");
    expect(opened.request_reference == 33u, "example write-digital-outputs-response: request_reference");
    expect(opened.code == 2u, "example write-digital-outputs-response: code");
    expect(opened.error == false, "example write-digital-outputs-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-digital-outputs-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(33u, again, sizeof again, &length) == HIWIN_E_OK, "example write-digital-outputs-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-digital-outputs-response bytes");
}

static void test_318(void)
{
    static const uint8_t frame[] = {0x22, 0x02, 0x00, 0x01, 0x10, 0x00, 0x30, 0x58, 0x00, 0x00, 0x04, 0x01, 0xFF, 0xFF, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-yaw-target-request opens");
    expect(opened.request_reference == 34u, "example write-yaw-target-request: request_reference");
    expect(opened.code == 2u, "example write-yaw-target-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-yaw-target-request decodes");
    expect(out.element_count == 0u, "example write-yaw-target-request: element_count");
    expect(out.parameter_number == 12376u, "example write-yaw-target-request: parameter_number");
    expect(out.subindex == 0u, "example write-yaw-target-request: subindex");
    expect(out.format == 4u, "example write-yaw-target-request: format");
    expect(out.values_count == 1u, "example write-yaw-target-request: values count");
    expect(out.values.integer_32_value[0] == (-1), "example write-yaw-target-request: values");
    in.element_count = 0u;
    in.parameter_number = 12376u;
    in.subindex = 0u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = (-1);
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(34u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-yaw-target-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-yaw-target-request bytes");
}

static void test_319(void)
{
    static const uint8_t frame[] = {0x22, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-yaw-target-response opens");
    expect(opened.request_reference == 34u, "example write-yaw-target-response: request_reference");
    expect(opened.code == 2u, "example write-yaw-target-response: code");
    expect(opened.error == false, "example write-yaw-target-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-yaw-target-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(34u, again, sizeof again, &length) == HIWIN_E_OK, "example write-yaw-target-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-yaw-target-response bytes");
}

static void test_320(void)
{
    static const uint8_t frame[] = {0x23, 0x02, 0x00, 0x01, 0x10, 0x00, 0x32, 0x09, 0x00, 0x00, 0x04, 0x01, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-general-integer-request opens");
    expect(opened.request_reference == 35u, "example write-general-integer-request: request_reference");
    expect(opened.code == 2u, "example write-general-integer-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-general-integer-request decodes");
    expect(out.element_count == 0u, "example write-general-integer-request: element_count");
    expect(out.parameter_number == 12809u, "example write-general-integer-request: parameter_number");
    expect(out.subindex == 0u, "example write-general-integer-request: subindex");
    expect(out.format == 4u, "example write-general-integer-request: format");
    expect(out.values_count == 1u, "example write-general-integer-request: values count");
    expect(out.values.integer_32_value[0] == 2147483647, "example write-general-integer-request: values");
    in.element_count = 0u;
    in.parameter_number = 12809u;
    in.subindex = 0u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 2147483647;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(35u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-general-integer-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-general-integer-request bytes");
}

static void test_321(void)
{
    static const uint8_t frame[] = {0x23, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-general-integer-response opens");
    expect(opened.request_reference == 35u, "example write-general-integer-response: request_reference");
    expect(opened.code == 2u, "example write-general-integer-response: code");
    expect(opened.error == false, "example write-general-integer-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-general-integer-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(35u, again, sizeof again, &length) == HIWIN_E_OK, "example write-general-integer-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-general-integer-response bytes");
}

static void test_322(void)
{
    static const uint8_t frame[] = {0x24, 0x02, 0x00, 0x01, 0x10, 0x00, 0x32, 0x10, 0x00, 0x00, 0x08, 0x01, 0xBF, 0xC0, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-general-float-request opens");
    expect(opened.request_reference == 36u, "example write-general-float-request: request_reference");
    expect(opened.code == 2u, "example write-general-float-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-general-float-request decodes");
    expect(out.element_count == 0u, "example write-general-float-request: element_count");
    expect(out.parameter_number == 12816u, "example write-general-float-request: parameter_number");
    expect(out.subindex == 0u, "example write-general-float-request: subindex");
    expect(out.format == 8u, "example write-general-float-request: format");
    expect(out.values_count == 1u, "example write-general-float-request: values count");
    expect(hiwin_e_bits_of(out.values.floating_point_value[0]) == 0xBFC00000u, "example write-general-float-request: values");
    in.element_count = 0u;
    in.parameter_number = 12816u;
    in.subindex = 0u;
    in.format = 8u;
    in.values_count = 1u;
    in.values.floating_point_value[0] = hiwin_e_float_of(0xBFC00000u);
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(36u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-general-float-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-general-float-request bytes");
}

static void test_323(void)
{
    static const uint8_t frame[] = {0x24, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-general-float-response opens");
    expect(opened.request_reference == 36u, "example write-general-float-response: request_reference");
    expect(opened.code == 2u, "example write-general-float-response: code");
    expect(opened.error == false, "example write-general-float-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-general-float-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(36u, again, sizeof again, &length) == HIWIN_E_OK, "example write-general-float-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-general-float-response bytes");
}

static void test_324(void)
{
    static const uint8_t frame[] = {0x25, 0x02, 0x00, 0x01, 0x10, 0x00, 0x32, 0x13, 0x00, 0x00, 0x08, 0x01, 0x4B, 0x80, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-large-float-request opens");
    expect(opened.request_reference == 37u, "example write-large-float-request: request_reference");
    expect(opened.code == 2u, "example write-large-float-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-large-float-request decodes");
    expect(out.element_count == 0u, "example write-large-float-request: element_count");
    expect(out.parameter_number == 12819u, "example write-large-float-request: parameter_number");
    expect(out.subindex == 0u, "example write-large-float-request: subindex");
    expect(out.format == 8u, "example write-large-float-request: format");
    expect(out.values_count == 1u, "example write-large-float-request: values count");
    expect(hiwin_e_bits_of(out.values.floating_point_value[0]) == 0x4B800000u, "example write-large-float-request: values");
    in.element_count = 0u;
    in.parameter_number = 12819u;
    in.subindex = 0u;
    in.format = 8u;
    in.values_count = 1u;
    in.values.floating_point_value[0] = hiwin_e_float_of(0x4B800000u);
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(37u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-large-float-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-large-float-request bytes");
}

static void test_325(void)
{
    static const uint8_t frame[] = {0x25, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-large-float-response opens");
    expect(opened.request_reference == 37u, "example write-large-float-response: request_reference");
    expect(opened.code == 2u, "example write-large-float-response: code");
    expect(opened.error == false, "example write-large-float-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-large-float-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(37u, again, sizeof again, &length) == HIWIN_E_OK, "example write-large-float-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-large-float-response bytes");
}

static void test_326(void)
{
    static const uint8_t frame[] = {0x26, 0x02, 0x00, 0x01, 0x10, 0x00, 0x03, 0x9D, 0x00, 0x00, 0x06, 0x01, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-sign-of-life-tolerance-request opens");
    expect(opened.request_reference == 38u, "example write-sign-of-life-tolerance-request: request_reference");
    expect(opened.code == 2u, "example write-sign-of-life-tolerance-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-sign-of-life-tolerance-request decodes");
    expect(out.element_count == 0u, "example write-sign-of-life-tolerance-request: element_count");
    expect(out.parameter_number == 925u, "example write-sign-of-life-tolerance-request: parameter_number");
    expect(out.subindex == 0u, "example write-sign-of-life-tolerance-request: subindex");
    expect(out.format == 6u, "example write-sign-of-life-tolerance-request: format");
    expect(out.values_count == 1u, "example write-sign-of-life-tolerance-request: values count");
    expect(out.values.unsigned_16_value[0] == 65535u, "example write-sign-of-life-tolerance-request: values");
    in.element_count = 0u;
    in.parameter_number = 925u;
    in.subindex = 0u;
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 65535u;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(38u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-sign-of-life-tolerance-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-sign-of-life-tolerance-request bytes");
}

static void test_327(void)
{
    static const uint8_t frame[] = {0x26, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-sign-of-life-tolerance-response opens");
    expect(opened.request_reference == 38u, "example write-sign-of-life-tolerance-response: request_reference");
    expect(opened.code == 2u, "example write-sign-of-life-tolerance-response: code");
    expect(opened.error == false, "example write-sign-of-life-tolerance-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-sign-of-life-tolerance-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(38u, again, sizeof again, &length) == HIWIN_E_OK, "example write-sign-of-life-tolerance-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-sign-of-life-tolerance-response bytes");
}

static void test_328(void)
{
    static const uint8_t frame[] = {0x27, 0x02, 0x00, 0x01, 0x10, 0x00, 0x03, 0xB8, 0x00, 0x00, 0x06, 0x01, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-clear-alarm-buffer-request opens");
    expect(opened.request_reference == 39u, "example write-clear-alarm-buffer-request: request_reference");
    expect(opened.code == 2u, "example write-clear-alarm-buffer-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-clear-alarm-buffer-request decodes");
    expect(out.element_count == 0u, "example write-clear-alarm-buffer-request: element_count");
    expect(out.parameter_number == 952u, "example write-clear-alarm-buffer-request: parameter_number");
    expect(out.subindex == 0u, "example write-clear-alarm-buffer-request: subindex");
    expect(out.format == 6u, "example write-clear-alarm-buffer-request: format");
    expect(out.values_count == 1u, "example write-clear-alarm-buffer-request: values count");
    expect(out.values.unsigned_16_value[0] == 0u, "example write-clear-alarm-buffer-request: values");
    in.element_count = 0u;
    in.parameter_number = 952u;
    in.subindex = 0u;
    in.format = 6u;
    in.values_count = 1u;
    in.values.unsigned_16_value[0] = 0u;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(39u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-clear-alarm-buffer-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-clear-alarm-buffer-request bytes");
}

static void test_329(void)
{
    static const uint8_t frame[] = {0x27, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-clear-alarm-buffer-response opens");
    expect(opened.request_reference == 39u, "example write-clear-alarm-buffer-response: request_reference");
    expect(opened.code == 2u, "example write-clear-alarm-buffer-response: code");
    expect(opened.error == false, "example write-clear-alarm-buffer-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-clear-alarm-buffer-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(39u, again, sizeof again, &length) == HIWIN_E_OK, "example write-clear-alarm-buffer-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-clear-alarm-buffer-response bytes");
}

static void test_330(void)
{
    static const uint8_t frame[] = {0x28, 0x02, 0x00, 0x01, 0x10, 0x00, 0x30, 0x67, 0x00, 0x00, 0x03, 0x01, 0x27, 0x10};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-analog-output-request opens");
    expect(opened.request_reference == 40u, "example write-analog-output-request: request_reference");
    expect(opened.code == 2u, "example write-analog-output-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-analog-output-request decodes");
    expect(out.element_count == 0u, "example write-analog-output-request: element_count");
    expect(out.parameter_number == 12391u, "example write-analog-output-request: parameter_number");
    expect(out.subindex == 0u, "example write-analog-output-request: subindex");
    expect(out.format == 3u, "example write-analog-output-request: format");
    expect(out.values_count == 1u, "example write-analog-output-request: values count");
    expect(out.values.integer_16_value[0] == 10000, "example write-analog-output-request: values");
    in.element_count = 0u;
    in.parameter_number = 12391u;
    in.subindex = 0u;
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = 10000;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(40u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-analog-output-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-analog-output-request bytes");
}

static void test_331(void)
{
    static const uint8_t frame[] = {0x28, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-analog-output-response opens");
    expect(opened.request_reference == 40u, "example write-analog-output-response: request_reference");
    expect(opened.code == 2u, "example write-analog-output-response: code");
    expect(opened.error == false, "example write-analog-output-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-analog-output-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(40u, again, sizeof again, &length) == HIWIN_E_OK, "example write-analog-output-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-analog-output-response bytes");
}

static void test_332(void)
{
    static const uint8_t frame[] = {0x29, 0x02, 0x00, 0x01, 0x10, 0x00, 0x32, 0x00, 0x00, 0x00, 0x04, 0x01, 0x00, 0x00, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-encoder-initialization-request opens");
    expect(opened.request_reference == 41u, "example write-encoder-initialization-request: request_reference");
    expect(opened.code == 2u, "example write-encoder-initialization-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-encoder-initialization-request decodes");
    expect(out.element_count == 0u, "example write-encoder-initialization-request: element_count");
    expect(out.parameter_number == 12800u, "example write-encoder-initialization-request: parameter_number");
    expect(out.subindex == 0u, "example write-encoder-initialization-request: subindex");
    expect(out.format == 4u, "example write-encoder-initialization-request: format");
    expect(out.values_count == 1u, "example write-encoder-initialization-request: values count");
    expect(out.values.integer_32_value[0] == 1, "example write-encoder-initialization-request: values");
    in.element_count = 0u;
    in.parameter_number = 12800u;
    in.subindex = 0u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 1;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(41u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-encoder-initialization-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-encoder-initialization-request bytes");
}

static void test_333(void)
{
    static const uint8_t frame[] = {0x29, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-encoder-initialization-response opens");
    expect(opened.request_reference == 41u, "example write-encoder-initialization-response: request_reference");
    expect(opened.code == 2u, "example write-encoder-initialization-response: code");
    expect(opened.error == false, "example write-encoder-initialization-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-encoder-initialization-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(41u, again, sizeof again, &length) == HIWIN_E_OK, "example write-encoder-initialization-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-encoder-initialization-response bytes");
}

static void test_334(void)
{
    static const uint8_t frame[] = {0x2A, 0x02, 0x00, 0x01, 0x10, 0x00, 0x22, 0x5C, 0x00, 0x00, 0x04, 0x01, 0xFF, 0xFD, 0x40, 0xE0};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-modulo-lower-limit-request opens");
    expect(opened.request_reference == 42u, "example write-modulo-lower-limit-request: request_reference");
    expect(opened.code == 2u, "example write-modulo-lower-limit-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-modulo-lower-limit-request decodes");
    expect(out.element_count == 0u, "example write-modulo-lower-limit-request: element_count");
    expect(out.parameter_number == 8796u, "example write-modulo-lower-limit-request: parameter_number");
    expect(out.subindex == 0u, "example write-modulo-lower-limit-request: subindex");
    expect(out.format == 4u, "example write-modulo-lower-limit-request: format");
    expect(out.values_count == 1u, "example write-modulo-lower-limit-request: values count");
    expect(out.values.integer_32_value[0] == (-180000), "example write-modulo-lower-limit-request: values");
    in.element_count = 0u;
    in.parameter_number = 8796u;
    in.subindex = 0u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = (-180000);
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(42u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-modulo-lower-limit-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-modulo-lower-limit-request bytes");
}

static void test_335(void)
{
    static const uint8_t frame[] = {0x2A, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-modulo-lower-limit-response opens");
    expect(opened.request_reference == 42u, "example write-modulo-lower-limit-response: request_reference");
    expect(opened.code == 2u, "example write-modulo-lower-limit-response: code");
    expect(opened.error == false, "example write-modulo-lower-limit-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-modulo-lower-limit-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(42u, again, sizeof again, &length) == HIWIN_E_OK, "example write-modulo-lower-limit-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-modulo-lower-limit-response bytes");
}

static void test_336(void)
{
    static const uint8_t frame[] = {0x2B, 0x02, 0x00, 0x01, 0x10, 0x00, 0x24, 0x2A, 0x00, 0x00, 0x07, 0x01, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-reference-torque-request opens");
    expect(opened.request_reference == 43u, "example write-reference-torque-request: request_reference");
    expect(opened.code == 2u, "example write-reference-torque-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-reference-torque-request decodes");
    expect(out.element_count == 0u, "example write-reference-torque-request: element_count");
    expect(out.parameter_number == 9258u, "example write-reference-torque-request: parameter_number");
    expect(out.subindex == 0u, "example write-reference-torque-request: subindex");
    expect(out.format == 7u, "example write-reference-torque-request: format");
    expect(out.values_count == 1u, "example write-reference-torque-request: values count");
    expect(out.values.unsigned_32_value[0] == 2147483647u, "example write-reference-torque-request: values");
    in.element_count = 0u;
    in.parameter_number = 9258u;
    in.subindex = 0u;
    in.format = 7u;
    in.values_count = 1u;
    in.values.unsigned_32_value[0] = 2147483647u;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(43u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-reference-torque-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-reference-torque-request bytes");
}

static void test_337(void)
{
    static const uint8_t frame[] = {0x2B, 0x02, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-reference-torque-response opens");
    expect(opened.request_reference == 43u, "example write-reference-torque-response: request_reference");
    expect(opened.code == 2u, "example write-reference-torque-response: code");
    expect(opened.error == false, "example write-reference-torque-response: error");
    expect(hiwin_e_write_parameter_response_decode(opened.body, opened.body_length) == HIWIN_E_OK, "example write-reference-torque-response decodes");
    expect(hiwin_e_parameter_channel_encode_write_parameter_response(43u, again, sizeof again, &length) == HIWIN_E_OK, "example write-reference-torque-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-reference-torque-response bytes");
}

static void test_338(void)
{
    static const uint8_t frame[] = {0x2C, 0x02, 0x00, 0x01, 0x10, 0x02, 0x03, 0xD3, 0x00, 0x02, 0x43, 0x02, 0x12, 0x34, 0x56, 0x78, 0x9A, 0xBC, 0xDE, 0xF0};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-two-elements-request opens");
    expect(opened.request_reference == 44u, "example write-two-elements-request: request_reference");
    expect(opened.code == 2u, "example write-two-elements-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-two-elements-request decodes");
    expect(out.element_count == 2u, "example write-two-elements-request: element_count");
    expect(out.parameter_number == 979u, "example write-two-elements-request: parameter_number");
    expect(out.subindex == 2u, "example write-two-elements-request: subindex");
    expect(out.format == 67u, "example write-two-elements-request: format");
    expect(out.values_count == 2u, "example write-two-elements-request: values count");
    expect(out.values.unsigned_32_value[0] == 305419896u, "example write-two-elements-request: values");
    expect(out.values.unsigned_32_value[1] == 2596069104u, "example write-two-elements-request: values");
    in.element_count = 2u;
    in.parameter_number = 979u;
    in.subindex = 2u;
    in.format = 67u;
    in.values_count = 2u;
    in.values.unsigned_32_value[0] = 305419896u;
    in.values.unsigned_32_value[1] = 2596069104u;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(44u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-two-elements-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-two-elements-request bytes");
}

static void test_339(void)
{
    static const uint8_t frame[] = {0x2C, 0x82, 0x00, 0x01, 0x44, 0x01, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_parameter_error in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-two-elements-response opens");
    expect(opened.request_reference == 44u, "example write-two-elements-response: request_reference");
    expect(opened.code == 2u, "example write-two-elements-response: code");
    expect(opened.error == true, "example write-two-elements-response: error");
    expect(hiwin_e_parameter_error_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-two-elements-response decodes");
    expect(out.error_number == 1u, "example write-two-elements-response: error_number");
    in.error_number = 1u;
    expect(hiwin_e_parameter_channel_encode_exception_response(44u, 2u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-two-elements-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-two-elements-response bytes");
}

static void test_340(void)
{
    static const uint8_t frame[] = {0x31, 0x01, 0x00, 0x01, 0x10, 0x00, 0x30, 0x02, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-missing-parameter-request opens");
    expect(opened.request_reference == 49u, "example read-missing-parameter-request: request_reference");
    expect(opened.code == 1u, "example read-missing-parameter-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-missing-parameter-request decodes");
    expect(out.element_count == 0u, "example read-missing-parameter-request: element_count");
    expect(out.parameter_number == 12290u, "example read-missing-parameter-request: parameter_number");
    expect(out.subindex == 0u, "example read-missing-parameter-request: subindex");
    in.element_count = 0u;
    in.parameter_number = 12290u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(49u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-missing-parameter-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-missing-parameter-request bytes");
}

static void test_341(void)
{
    static const uint8_t frame[] = {0x31, 0x81, 0x00, 0x01, 0x44, 0x01, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_parameter_error in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-missing-parameter-response opens");
    expect(opened.request_reference == 49u, "example read-missing-parameter-response: request_reference");
    expect(opened.code == 1u, "example read-missing-parameter-response: code");
    expect(opened.error == true, "example read-missing-parameter-response: error");
    expect(hiwin_e_parameter_error_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-missing-parameter-response decodes");
    expect(out.error_number == 0u, "example read-missing-parameter-response: error_number");
    in.error_number = 0u;
    expect(hiwin_e_parameter_channel_encode_exception_response(49u, 1u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-missing-parameter-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-missing-parameter-response bytes");
}

static void test_342(void)
{
    static const uint8_t frame[] = {0x32, 0x02, 0x00, 0x01, 0x10, 0x00, 0x32, 0x17, 0x00, 0x00, 0x03, 0x01, 0x00, 0x02};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-mastership-out-of-range-request opens");
    expect(opened.request_reference == 50u, "example write-mastership-out-of-range-request: request_reference");
    expect(opened.code == 2u, "example write-mastership-out-of-range-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-mastership-out-of-range-request decodes");
    expect(out.element_count == 0u, "example write-mastership-out-of-range-request: element_count");
    expect(out.parameter_number == 12823u, "example write-mastership-out-of-range-request: parameter_number");
    expect(out.subindex == 0u, "example write-mastership-out-of-range-request: subindex");
    expect(out.format == 3u, "example write-mastership-out-of-range-request: format");
    expect(out.values_count == 1u, "example write-mastership-out-of-range-request: values count");
    expect(out.values.integer_16_value[0] == 2, "example write-mastership-out-of-range-request: values");
    in.element_count = 0u;
    in.parameter_number = 12823u;
    in.subindex = 0u;
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = 2;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(50u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-mastership-out-of-range-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-mastership-out-of-range-request bytes");
}

static void test_343(void)
{
    static const uint8_t frame[] = {0x32, 0x82, 0x00, 0x01, 0x44, 0x01, 0x00, 0x02};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_parameter_error in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-mastership-out-of-range-response opens");
    expect(opened.request_reference == 50u, "example write-mastership-out-of-range-response: request_reference");
    expect(opened.code == 2u, "example write-mastership-out-of-range-response: code");
    expect(opened.error == true, "example write-mastership-out-of-range-response: error");
    expect(hiwin_e_parameter_error_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-mastership-out-of-range-response decodes");
    expect(out.error_number == 2u, "example write-mastership-out-of-range-response: error_number");
    in.error_number = 2u;
    expect(hiwin_e_parameter_channel_encode_exception_response(50u, 2u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-mastership-out-of-range-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-mastership-out-of-range-response bytes");
}

static void test_344(void)
{
    static const uint8_t frame[] = {0x33, 0x01, 0x00, 0x01, 0x10, 0x01, 0x03, 0xD3, 0x00, 0x1F};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-element-31-request opens");
    expect(opened.request_reference == 51u, "example read-element-31-request: request_reference");
    expect(opened.code == 1u, "example read-element-31-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-element-31-request decodes");
    expect(out.element_count == 1u, "example read-element-31-request: element_count");
    expect(out.parameter_number == 979u, "example read-element-31-request: parameter_number");
    expect(out.subindex == 31u, "example read-element-31-request: subindex");
    in.element_count = 1u;
    in.parameter_number = 979u;
    in.subindex = 31u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(51u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-element-31-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-element-31-request bytes");
}

static void test_345(void)
{
    static const uint8_t frame[] = {0x33, 0x81, 0x00, 0x01, 0x44, 0x01, 0x00, 0x03};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_parameter_error in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-element-31-response opens");
    expect(opened.request_reference == 51u, "example read-element-31-response: request_reference");
    expect(opened.code == 1u, "example read-element-31-response: code");
    expect(opened.error == true, "example read-element-31-response: error");
    expect(hiwin_e_parameter_error_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-element-31-response decodes");
    expect(out.error_number == 3u, "example read-element-31-response: error_number");
    in.error_number = 3u;
    expect(hiwin_e_parameter_channel_encode_exception_response(51u, 1u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-element-31-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-element-31-response bytes");
}

static void test_346(void)
{
    static const uint8_t frame[] = {0x34, 0x01, 0x00, 0x01, 0x10, 0x02, 0x30, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-elements-of-single-value-request opens");
    expect(opened.request_reference == 52u, "example read-elements-of-single-value-request: request_reference");
    expect(opened.code == 1u, "example read-elements-of-single-value-request: code");
    expect(hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-elements-of-single-value-request decodes");
    expect(out.element_count == 2u, "example read-elements-of-single-value-request: element_count");
    expect(out.parameter_number == 12288u, "example read-elements-of-single-value-request: parameter_number");
    expect(out.subindex == 0u, "example read-elements-of-single-value-request: subindex");
    in.element_count = 2u;
    in.parameter_number = 12288u;
    in.subindex = 0u;
    expect(hiwin_e_parameter_channel_encode_read_parameter_request(52u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-elements-of-single-value-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-elements-of-single-value-request bytes");
}

static void test_347(void)
{
    static const uint8_t frame[] = {0x34, 0x81, 0x00, 0x01, 0x44, 0x01, 0x00, 0x04};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_parameter_error in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example read-elements-of-single-value-response opens");
    expect(opened.request_reference == 52u, "example read-elements-of-single-value-response: request_reference");
    expect(opened.code == 1u, "example read-elements-of-single-value-response: code");
    expect(opened.error == true, "example read-elements-of-single-value-response: error");
    expect(hiwin_e_parameter_error_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example read-elements-of-single-value-response decodes");
    expect(out.error_number == 4u, "example read-elements-of-single-value-response: error_number");
    in.error_number = 4u;
    expect(hiwin_e_parameter_channel_encode_exception_response(52u, 1u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example read-elements-of-single-value-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example read-elements-of-single-value-response bytes");
}

static void test_348(void)
{
    static const uint8_t frame[] = {0x35, 0x02, 0x00, 0x01, 0x10, 0x00, 0x32, 0x11, 0x00, 0x00, 0x04, 0x01, 0x00, 0x00, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-float-as-integer-request opens");
    expect(opened.request_reference == 53u, "example write-float-as-integer-request: request_reference");
    expect(opened.code == 2u, "example write-float-as-integer-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-float-as-integer-request decodes");
    expect(out.element_count == 0u, "example write-float-as-integer-request: element_count");
    expect(out.parameter_number == 12817u, "example write-float-as-integer-request: parameter_number");
    expect(out.subindex == 0u, "example write-float-as-integer-request: subindex");
    expect(out.format == 4u, "example write-float-as-integer-request: format");
    expect(out.values_count == 1u, "example write-float-as-integer-request: values count");
    expect(out.values.integer_32_value[0] == 1, "example write-float-as-integer-request: values");
    in.element_count = 0u;
    in.parameter_number = 12817u;
    in.subindex = 0u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 1;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(53u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-float-as-integer-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-float-as-integer-request bytes");
}

static void test_349(void)
{
    static const uint8_t frame[] = {0x35, 0x82, 0x00, 0x01, 0x44, 0x01, 0x00, 0x05};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_parameter_error in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-float-as-integer-response opens");
    expect(opened.request_reference == 53u, "example write-float-as-integer-response: request_reference");
    expect(opened.code == 2u, "example write-float-as-integer-response: code");
    expect(opened.error == true, "example write-float-as-integer-response: error");
    expect(hiwin_e_parameter_error_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-float-as-integer-response decodes");
    expect(out.error_number == 5u, "example write-float-as-integer-response: error_number");
    in.error_number = 5u;
    expect(hiwin_e_parameter_channel_encode_exception_response(53u, 2u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-float-as-integer-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-float-as-integer-response bytes");
}

static void test_350(void)
{
    static const uint8_t frame[] = {0x36, 0x02, 0x00, 0x01, 0x10, 0x00, 0x32, 0x17, 0x00, 0x00, 0x03, 0x01, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-mastership-while-excited-request opens");
    expect(opened.request_reference == 54u, "example write-mastership-while-excited-request: request_reference");
    expect(opened.code == 2u, "example write-mastership-while-excited-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-mastership-while-excited-request decodes");
    expect(out.element_count == 0u, "example write-mastership-while-excited-request: element_count");
    expect(out.parameter_number == 12823u, "example write-mastership-while-excited-request: parameter_number");
    expect(out.subindex == 0u, "example write-mastership-while-excited-request: subindex");
    expect(out.format == 3u, "example write-mastership-while-excited-request: format");
    expect(out.values_count == 1u, "example write-mastership-while-excited-request: values count");
    expect(out.values.integer_16_value[0] == 0, "example write-mastership-while-excited-request: values");
    in.element_count = 0u;
    in.parameter_number = 12823u;
    in.subindex = 0u;
    in.format = 3u;
    in.values_count = 1u;
    in.values.integer_16_value[0] = 0;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(54u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-mastership-while-excited-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-mastership-while-excited-request bytes");
}

static void test_351(void)
{
    static const uint8_t frame[] = {0x36, 0x82, 0x00, 0x01, 0x44, 0x01, 0x00, 0x11};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_parameter_error in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-mastership-while-excited-response opens");
    expect(opened.request_reference == 54u, "example write-mastership-while-excited-response: request_reference");
    expect(opened.code == 2u, "example write-mastership-while-excited-response: code");
    expect(opened.error == true, "example write-mastership-while-excited-response: error");
    expect(hiwin_e_parameter_error_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-mastership-while-excited-response decodes");
    expect(out.error_number == 17u, "example write-mastership-while-excited-response: error_number");
    in.error_number = 17u;
    expect(hiwin_e_parameter_channel_encode_exception_response(54u, 2u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-mastership-while-excited-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-mastership-while-excited-response bytes");
}

static void test_352(void)
{
    static const uint8_t frame[] = {0x37, 0x02, 0x00, 0x01, 0x10, 0x02, 0x32, 0x01, 0x00, 0x00, 0x04, 0x01, 0x00, 0x00, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-count-differs-request opens");
    expect(opened.request_reference == 55u, "example write-count-differs-request: request_reference");
    expect(opened.code == 2u, "example write-count-differs-request: code");
    expect(hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-count-differs-request decodes");
    expect(out.element_count == 2u, "example write-count-differs-request: element_count");
    expect(out.parameter_number == 12801u, "example write-count-differs-request: parameter_number");
    expect(out.subindex == 0u, "example write-count-differs-request: subindex");
    expect(out.format == 4u, "example write-count-differs-request: format");
    expect(out.values_count == 1u, "example write-count-differs-request: values count");
    expect(out.values.integer_32_value[0] == 1, "example write-count-differs-request: values");
    in.element_count = 2u;
    in.parameter_number = 12801u;
    in.subindex = 0u;
    in.format = 4u;
    in.values_count = 1u;
    in.values.integer_32_value[0] = 1;
    expect(hiwin_e_parameter_channel_encode_write_parameter_request(55u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-count-differs-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-count-differs-request bytes");
}

static void test_353(void)
{
    static const uint8_t frame[] = {0x37, 0x82, 0x00, 0x01, 0x44, 0x01, 0x00, 0x18};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_parameter_error in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example write-count-differs-response opens");
    expect(opened.request_reference == 55u, "example write-count-differs-response: request_reference");
    expect(opened.code == 2u, "example write-count-differs-response: code");
    expect(opened.error == true, "example write-count-differs-response: error");
    expect(hiwin_e_parameter_error_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example write-count-differs-response decodes");
    expect(out.error_number == 24u, "example write-count-differs-response: error_number");
    in.error_number = 24u;
    expect(hiwin_e_parameter_channel_encode_exception_response(55u, 2u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example write-count-differs-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example write-count-differs-response bytes");
}

static void test_354(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x00, 0x01, 0x10, 0x00, 0x30, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_request_open(received, sizeof received, &opened) == HIWIN_E_ERR_UNKNOWN_CODE, "example refused-request-id");
}

static void test_355(void)
{
    static const uint8_t frame[] = {0x01, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_read_parameter_request out;
    hiwin_e_codec_status status;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    clear(&out, sizeof out);
    status = hiwin_e_parameter_channel_request_open(received, sizeof received, &opened);
    if (status == HIWIN_E_OK) {
        status = hiwin_e_read_parameter_request_decode(opened.body, opened.body_length, &out);
    }
    expect(status == HIWIN_E_ERR_INCOMPLETE, "example refused-short-head");
}

static void test_356(void)
{
    static const uint8_t frame[] = {0x01, 0x02, 0x00, 0x01, 0x10, 0x00, 0x32, 0x01, 0x00, 0x00, 0x04, 0x01, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_request_frame opened;
    hiwin_e_write_parameter_request out;
    hiwin_e_codec_status status;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    clear(&out, sizeof out);
    status = hiwin_e_parameter_channel_request_open(received, sizeof received, &opened);
    if (status == HIWIN_E_OK) {
        status = hiwin_e_write_parameter_request_decode(opened.body, opened.body_length, &out);
    }
    expect(status == HIWIN_E_ERR_INCOMPLETE, "example refused-half-value");
}

static void test_357(void)
{
    static const uint8_t frame[] = {0x41, 0x80, 0x00, 0x01, 0x44, 0x01, 0x00, 0x21};
    uint8_t received[sizeof frame];
    hiwin_e_parameter_channel_response_frame opened;
    hiwin_e_parameter_error in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_parameter_channel_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example unknown-request-id-response opens");
    expect(opened.request_reference == 65u, "example unknown-request-id-response: request_reference");
    expect(opened.code == 0u, "example unknown-request-id-response: code");
    expect(opened.error == true, "example unknown-request-id-response: error");
    expect(hiwin_e_parameter_error_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example unknown-request-id-response decodes");
    expect(out.error_number == 33u, "example unknown-request-id-response: error_number");
    in.error_number = 33u;
    expect(hiwin_e_parameter_channel_encode_exception_response(65u, 0u, &in, again, sizeof again, &length) == HIWIN_E_OK, "example unknown-request-id-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example unknown-request-id-response bytes");
}

static void test_358(void)
{
    static const uint8_t frame[] = {0x04, 0x7F, 0x80, 0x00, 0x30, 0x00, 0xFF, 0xFE, 0x79, 0x60, 0x00, 0x00, 0x02, 0x58, 0x40, 0x00, 0x20, 0x00, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_9_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-9-received opens");
    expect(hiwin_e_telegram_9_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-9-received decodes");
    expect(out.control_word_1 == 1151u, "example telegram-9-received: control_word_1");
    expect(out.block_selection == 32768u, "example telegram-9-received: block_selection");
    expect(out.control_word_2 == 12288u, "example telegram-9-received: control_word_2");
    expect(out.mdi_target_position == (-100000), "example telegram-9-received: mdi_target_position");
    expect(out.mdi_velocity == 600, "example telegram-9-received: mdi_velocity");
    expect(out.mdi_acceleration == 16384u, "example telegram-9-received: mdi_acceleration");
    expect(out.mdi_deceleration == 8192u, "example telegram-9-received: mdi_deceleration");
    expect(out.mdi_mode == 1u, "example telegram-9-received: mdi_mode");
    in.control_word_1 = 1151u;
    in.block_selection = 32768u;
    in.control_word_2 = 12288u;
    in.mdi_target_position = (-100000);
    in.mdi_velocity = 600;
    in.mdi_acceleration = 16384u;
    in.mdi_deceleration = 8192u;
    in.mdi_mode = 1u;
    expect(hiwin_e_cyclic_encode_telegram_9_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-9-received encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-9-received bytes");
}

static void test_359(void)
{
    static const uint8_t frame[] = {0x04, 0x7F, 0x80, 0x00, 0xF0, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_9_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-9-received-relative opens");
    expect(hiwin_e_telegram_9_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-9-received-relative decodes");
    expect(out.control_word_1 == 1151u, "example telegram-9-received-relative: control_word_1");
    expect(out.block_selection == 32768u, "example telegram-9-received-relative: block_selection");
    expect(out.control_word_2 == 61440u, "example telegram-9-received-relative: control_word_2");
    expect(out.mdi_target_position == (-1), "example telegram-9-received-relative: mdi_target_position");
    expect(out.mdi_velocity == 2147483647, "example telegram-9-received-relative: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "example telegram-9-received-relative: mdi_acceleration");
    expect(out.mdi_deceleration == 16384u, "example telegram-9-received-relative: mdi_deceleration");
    expect(out.mdi_mode == 0u, "example telegram-9-received-relative: mdi_mode");
    in.control_word_1 = 1151u;
    in.block_selection = 32768u;
    in.control_word_2 = 61440u;
    in.mdi_target_position = (-1);
    in.mdi_velocity = 2147483647;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 16384u;
    in.mdi_mode = 0u;
    expect(hiwin_e_cyclic_encode_telegram_9_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-9-received-relative encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-9-received-relative bytes");
}

static void test_360(void)
{
    static const uint8_t frame[] = {0x0F, 0xFF, 0x80, 0x00, 0xF0, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x40, 0x00, 0x40, 0x00, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_9_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-9-received-all-bits opens");
    expect(hiwin_e_telegram_9_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-9-received-all-bits decodes");
    expect(out.control_word_1 == 4095u, "example telegram-9-received-all-bits: control_word_1");
    expect(out.block_selection == 32768u, "example telegram-9-received-all-bits: block_selection");
    expect(out.control_word_2 == 61440u, "example telegram-9-received-all-bits: control_word_2");
    expect(out.mdi_target_position == (-2147483647 - 1), "example telegram-9-received-all-bits: mdi_target_position");
    expect(out.mdi_velocity == 1, "example telegram-9-received-all-bits: mdi_velocity");
    expect(out.mdi_acceleration == 16384u, "example telegram-9-received-all-bits: mdi_acceleration");
    expect(out.mdi_deceleration == 16384u, "example telegram-9-received-all-bits: mdi_deceleration");
    expect(out.mdi_mode == 1u, "example telegram-9-received-all-bits: mdi_mode");
    in.control_word_1 = 4095u;
    in.block_selection = 32768u;
    in.control_word_2 = 61440u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 1;
    in.mdi_acceleration = 16384u;
    in.mdi_deceleration = 16384u;
    in.mdi_mode = 1u;
    expect(hiwin_e_cyclic_encode_telegram_9_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-9-received-all-bits encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-9-received-all-bits bytes");
}

static void test_361(void)
{
    static const uint8_t frame[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_9_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-9-received-off opens");
    expect(hiwin_e_telegram_9_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-9-received-off decodes");
    expect(out.control_word_1 == 0u, "example telegram-9-received-off: control_word_1");
    expect(out.block_selection == 0u, "example telegram-9-received-off: block_selection");
    expect(out.control_word_2 == 0u, "example telegram-9-received-off: control_word_2");
    expect(out.mdi_target_position == 0, "example telegram-9-received-off: mdi_target_position");
    expect(out.mdi_velocity == 0, "example telegram-9-received-off: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "example telegram-9-received-off: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "example telegram-9-received-off: mdi_deceleration");
    expect(out.mdi_mode == 0u, "example telegram-9-received-off: mdi_mode");
    in.control_word_1 = 0u;
    in.block_selection = 0u;
    in.control_word_2 = 0u;
    in.mdi_target_position = 0;
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    in.mdi_mode = 0u;
    expect(hiwin_e_cyclic_encode_telegram_9_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-9-received-off encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-9-received-off bytes");
}

static void test_362(void)
{
    static const uint8_t frame[] = {0x3F, 0x37, 0x80, 0x00, 0x38, 0x00, 0xFF, 0xFE, 0x79, 0x60};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_9_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-9-sent opens");
    expect(hiwin_e_telegram_9_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-9-sent decodes");
    expect(out.status_word_1 == 16183u, "example telegram-9-sent: status_word_1");
    expect(out.selected_block == 32768u, "example telegram-9-sent: selected_block");
    expect(out.status_word_2 == 14336u, "example telegram-9-sent: status_word_2");
    expect(out.position_actual_a == (-100000), "example telegram-9-sent: position_actual_a");
    in.status_word_1 = 16183u;
    in.selected_block = 32768u;
    in.status_word_2 = 14336u;
    in.position_actual_a = (-100000);
    expect(hiwin_e_cyclic_encode_telegram_9_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-9-sent encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-9-sent bytes");
}

static void test_363(void)
{
    static const uint8_t frame[] = {0x13, 0x37, 0x00, 0x00, 0xF8, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_9_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-9-sent-moving opens");
    expect(hiwin_e_telegram_9_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-9-sent-moving decodes");
    expect(out.status_word_1 == 4919u, "example telegram-9-sent-moving: status_word_1");
    expect(out.selected_block == 0u, "example telegram-9-sent-moving: selected_block");
    expect(out.status_word_2 == 63488u, "example telegram-9-sent-moving: status_word_2");
    expect(out.position_actual_a == (-2147483647 - 1), "example telegram-9-sent-moving: position_actual_a");
    in.status_word_1 = 4919u;
    in.selected_block = 0u;
    in.status_word_2 = 63488u;
    in.position_actual_a = (-2147483647 - 1);
    expect(hiwin_e_cyclic_encode_telegram_9_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-9-sent-moving encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-9-sent-moving bytes");
}

static void test_364(void)
{
    static const uint8_t frame[] = {0x04, 0xBF, 0x91, 0x00, 0x00, 0x00, 0x50, 0x00, 0x40, 0x00, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x40, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_111_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-received opens");
    expect(hiwin_e_telegram_111_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-received decodes");
    expect(out.control_word_1 == 1215u, "example telegram-111-received: control_word_1");
    expect(out.positioning_control_word_1 == 37120u, "example telegram-111-received: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "example telegram-111-received: positioning_control_word_2");
    expect(out.control_word_2 == 20480u, "example telegram-111-received: control_word_2");
    expect(out.velocity_override == 16384u, "example telegram-111-received: velocity_override");
    expect(out.mdi_target_position == (-2147483647 - 1), "example telegram-111-received: mdi_target_position");
    expect(out.mdi_velocity == 2147483647, "example telegram-111-received: mdi_velocity");
    expect(out.mdi_acceleration == 16384u, "example telegram-111-received: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "example telegram-111-received: mdi_deceleration");
    in.control_word_1 = 1215u;
    in.positioning_control_word_1 = 37120u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 20480u;
    in.velocity_override = 16384u;
    in.mdi_target_position = (-2147483647 - 1);
    in.mdi_velocity = 2147483647;
    in.mdi_acceleration = 16384u;
    in.mdi_deceleration = 0u;
    expect(hiwin_e_cyclic_encode_telegram_111_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-received encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-received bytes");
}

static void test_365(void)
{
    static const uint8_t frame[] = {0x0F, 0x7F, 0xC5, 0x00, 0x00, 0x22, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x3F, 0xFF, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_111_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-received-modulo opens");
    expect(hiwin_e_telegram_111_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-received-modulo decodes");
    expect(out.control_word_1 == 3967u, "example telegram-111-received-modulo: control_word_1");
    expect(out.positioning_control_word_1 == 50432u, "example telegram-111-received-modulo: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 34u, "example telegram-111-received-modulo: positioning_control_word_2");
    expect(out.control_word_2 == 0u, "example telegram-111-received-modulo: control_word_2");
    expect(out.velocity_override == 32767u, "example telegram-111-received-modulo: velocity_override");
    expect(out.mdi_target_position == (-1), "example telegram-111-received-modulo: mdi_target_position");
    expect(out.mdi_velocity == 0, "example telegram-111-received-modulo: mdi_velocity");
    expect(out.mdi_acceleration == 1u, "example telegram-111-received-modulo: mdi_acceleration");
    expect(out.mdi_deceleration == 16383u, "example telegram-111-received-modulo: mdi_deceleration");
    in.control_word_1 = 3967u;
    in.positioning_control_word_1 = 50432u;
    in.positioning_control_word_2 = 34u;
    in.control_word_2 = 0u;
    in.velocity_override = 32767u;
    in.mdi_target_position = (-1);
    in.mdi_velocity = 0;
    in.mdi_acceleration = 1u;
    in.mdi_deceleration = 16383u;
    expect(hiwin_e_cyclic_encode_telegram_111_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-received-modulo encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-received-modulo bytes");
}

static void test_366(void)
{
    static const uint8_t frame[] = {0x04, 0xBF, 0x91, 0x00, 0x00, 0x00, 0x70, 0x00, 0x40, 0x00, 0x00, 0x01, 0x86, 0xA0, 0x00, 0x00, 0x17, 0x70, 0x40, 0x00, 0x40, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_111_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-received-realistic opens");
    expect(hiwin_e_telegram_111_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-received-realistic decodes");
    expect(out.control_word_1 == 1215u, "example telegram-111-received-realistic: control_word_1");
    expect(out.positioning_control_word_1 == 37120u, "example telegram-111-received-realistic: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "example telegram-111-received-realistic: positioning_control_word_2");
    expect(out.control_word_2 == 28672u, "example telegram-111-received-realistic: control_word_2");
    expect(out.velocity_override == 16384u, "example telegram-111-received-realistic: velocity_override");
    expect(out.mdi_target_position == 100000, "example telegram-111-received-realistic: mdi_target_position");
    expect(out.mdi_velocity == 6000, "example telegram-111-received-realistic: mdi_velocity");
    expect(out.mdi_acceleration == 16384u, "example telegram-111-received-realistic: mdi_acceleration");
    expect(out.mdi_deceleration == 16384u, "example telegram-111-received-realistic: mdi_deceleration");
    in.control_word_1 = 1215u;
    in.positioning_control_word_1 = 37120u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 28672u;
    in.velocity_override = 16384u;
    in.mdi_target_position = 100000;
    in.mdi_velocity = 6000;
    in.mdi_acceleration = 16384u;
    in.mdi_deceleration = 16384u;
    expect(hiwin_e_cyclic_encode_telegram_111_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-received-realistic encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-received-realistic bytes");
}

static void test_367(void)
{
    static const uint8_t frame[] = {0x04, 0x7F, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x20, 0x00, 0xFF, 0xFE, 0x79, 0x60, 0x00, 0x00, 0x00, 0x01, 0x20, 0x00, 0x10, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_111_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-received-start opens");
    expect(hiwin_e_telegram_111_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-received-start decodes");
    expect(out.control_word_1 == 1151u, "example telegram-111-received-start: control_word_1");
    expect(out.positioning_control_word_1 == 32768u, "example telegram-111-received-start: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "example telegram-111-received-start: positioning_control_word_2");
    expect(out.control_word_2 == 32768u, "example telegram-111-received-start: control_word_2");
    expect(out.velocity_override == 8192u, "example telegram-111-received-start: velocity_override");
    expect(out.mdi_target_position == (-100000), "example telegram-111-received-start: mdi_target_position");
    expect(out.mdi_velocity == 1, "example telegram-111-received-start: mdi_velocity");
    expect(out.mdi_acceleration == 8192u, "example telegram-111-received-start: mdi_acceleration");
    expect(out.mdi_deceleration == 4096u, "example telegram-111-received-start: mdi_deceleration");
    in.control_word_1 = 1151u;
    in.positioning_control_word_1 = 32768u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 32768u;
    in.velocity_override = 8192u;
    in.mdi_target_position = (-100000);
    in.mdi_velocity = 1;
    in.mdi_acceleration = 8192u;
    in.mdi_deceleration = 4096u;
    expect(hiwin_e_cyclic_encode_telegram_111_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-received-start encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-received-start bytes");
}

static void test_368(void)
{
    static const uint8_t frame[] = {0x04, 0x3F, 0xC2, 0x00, 0x00, 0x00, 0x90, 0x00, 0x40, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x03, 0xE8, 0x40, 0x00, 0x40, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_111_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-received-setup-positive opens");
    expect(hiwin_e_telegram_111_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-received-setup-positive decodes");
    expect(out.control_word_1 == 1087u, "example telegram-111-received-setup-positive: control_word_1");
    expect(out.positioning_control_word_1 == 49664u, "example telegram-111-received-setup-positive: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "example telegram-111-received-setup-positive: positioning_control_word_2");
    expect(out.control_word_2 == 36864u, "example telegram-111-received-setup-positive: control_word_2");
    expect(out.velocity_override == 16384u, "example telegram-111-received-setup-positive: velocity_override");
    expect(out.mdi_target_position == 0, "example telegram-111-received-setup-positive: mdi_target_position");
    expect(out.mdi_velocity == 1000, "example telegram-111-received-setup-positive: mdi_velocity");
    expect(out.mdi_acceleration == 16384u, "example telegram-111-received-setup-positive: mdi_acceleration");
    expect(out.mdi_deceleration == 16384u, "example telegram-111-received-setup-positive: mdi_deceleration");
    in.control_word_1 = 1087u;
    in.positioning_control_word_1 = 49664u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 36864u;
    in.velocity_override = 16384u;
    in.mdi_target_position = 0;
    in.mdi_velocity = 1000;
    in.mdi_acceleration = 16384u;
    in.mdi_deceleration = 16384u;
    expect(hiwin_e_cyclic_encode_telegram_111_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-received-setup-positive encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-received-setup-positive bytes");
}

static void test_369(void)
{
    static const uint8_t frame[] = {0x04, 0x3F, 0x97, 0x00, 0x00, 0x00, 0xA0, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_111_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-received-shortest opens");
    expect(hiwin_e_telegram_111_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-received-shortest decodes");
    expect(out.control_word_1 == 1087u, "example telegram-111-received-shortest: control_word_1");
    expect(out.positioning_control_word_1 == 38656u, "example telegram-111-received-shortest: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "example telegram-111-received-shortest: positioning_control_word_2");
    expect(out.control_word_2 == 40960u, "example telegram-111-received-shortest: control_word_2");
    expect(out.velocity_override == 0u, "example telegram-111-received-shortest: velocity_override");
    expect(out.mdi_target_position == 2147483647, "example telegram-111-received-shortest: mdi_target_position");
    expect(out.mdi_velocity == 2147483647, "example telegram-111-received-shortest: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "example telegram-111-received-shortest: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "example telegram-111-received-shortest: mdi_deceleration");
    in.control_word_1 = 1087u;
    in.positioning_control_word_1 = 38656u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 40960u;
    in.velocity_override = 0u;
    in.mdi_target_position = 2147483647;
    in.mdi_velocity = 2147483647;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    expect(hiwin_e_cyclic_encode_telegram_111_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-received-shortest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-received-shortest bytes");
}

static void test_370(void)
{
    static const uint8_t frame[] = {0x04, 0x7F, 0x81, 0x00, 0x00, 0x00, 0xF1, 0x00, 0x0C, 0xCD, 0xFF, 0xFF, 0xFE, 0x0C, 0x00, 0x00, 0x00, 0x0A, 0x40, 0x00, 0x40, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_111_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-received-fixed-stop opens");
    expect(hiwin_e_telegram_111_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-received-fixed-stop decodes");
    expect(out.control_word_1 == 1151u, "example telegram-111-received-fixed-stop: control_word_1");
    expect(out.positioning_control_word_1 == 33024u, "example telegram-111-received-fixed-stop: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "example telegram-111-received-fixed-stop: positioning_control_word_2");
    expect(out.control_word_2 == 61696u, "example telegram-111-received-fixed-stop: control_word_2");
    expect(out.velocity_override == 3277u, "example telegram-111-received-fixed-stop: velocity_override");
    expect(out.mdi_target_position == (-500), "example telegram-111-received-fixed-stop: mdi_target_position");
    expect(out.mdi_velocity == 10, "example telegram-111-received-fixed-stop: mdi_velocity");
    expect(out.mdi_acceleration == 16384u, "example telegram-111-received-fixed-stop: mdi_acceleration");
    expect(out.mdi_deceleration == 16384u, "example telegram-111-received-fixed-stop: mdi_deceleration");
    in.control_word_1 = 1151u;
    in.positioning_control_word_1 = 33024u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 61696u;
    in.velocity_override = 3277u;
    in.mdi_target_position = (-500);
    in.mdi_velocity = 10;
    in.mdi_acceleration = 16384u;
    in.mdi_deceleration = 16384u;
    expect(hiwin_e_cyclic_encode_telegram_111_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-received-fixed-stop encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-received-fixed-stop bytes");
}

static void test_371(void)
{
    static const uint8_t frame[] = {0x0F, 0xFF, 0xD7, 0x00, 0x00, 0x22, 0xF1, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF, 0x40, 0x00, 0x40, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_111_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-received-all-bits opens");
    expect(hiwin_e_telegram_111_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-received-all-bits decodes");
    expect(out.control_word_1 == 4095u, "example telegram-111-received-all-bits: control_word_1");
    expect(out.positioning_control_word_1 == 55040u, "example telegram-111-received-all-bits: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 34u, "example telegram-111-received-all-bits: positioning_control_word_2");
    expect(out.control_word_2 == 61696u, "example telegram-111-received-all-bits: control_word_2");
    expect(out.velocity_override == 32767u, "example telegram-111-received-all-bits: velocity_override");
    expect(out.mdi_target_position == (-1), "example telegram-111-received-all-bits: mdi_target_position");
    expect(out.mdi_velocity == 2147483647, "example telegram-111-received-all-bits: mdi_velocity");
    expect(out.mdi_acceleration == 16384u, "example telegram-111-received-all-bits: mdi_acceleration");
    expect(out.mdi_deceleration == 16384u, "example telegram-111-received-all-bits: mdi_deceleration");
    in.control_word_1 = 4095u;
    in.positioning_control_word_1 = 55040u;
    in.positioning_control_word_2 = 34u;
    in.control_word_2 = 61696u;
    in.velocity_override = 32767u;
    in.mdi_target_position = (-1);
    in.mdi_velocity = 2147483647;
    in.mdi_acceleration = 16384u;
    in.mdi_deceleration = 16384u;
    expect(hiwin_e_cyclic_encode_telegram_111_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-received-all-bits encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-received-all-bits bytes");
}

static void test_372(void)
{
    static const uint8_t frame[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_111_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-received-off opens");
    expect(hiwin_e_telegram_111_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-received-off decodes");
    expect(out.control_word_1 == 0u, "example telegram-111-received-off: control_word_1");
    expect(out.positioning_control_word_1 == 0u, "example telegram-111-received-off: positioning_control_word_1");
    expect(out.positioning_control_word_2 == 0u, "example telegram-111-received-off: positioning_control_word_2");
    expect(out.control_word_2 == 0u, "example telegram-111-received-off: control_word_2");
    expect(out.velocity_override == 0u, "example telegram-111-received-off: velocity_override");
    expect(out.mdi_target_position == 0, "example telegram-111-received-off: mdi_target_position");
    expect(out.mdi_velocity == 0, "example telegram-111-received-off: mdi_velocity");
    expect(out.mdi_acceleration == 0u, "example telegram-111-received-off: mdi_acceleration");
    expect(out.mdi_deceleration == 0u, "example telegram-111-received-off: mdi_deceleration");
    in.control_word_1 = 0u;
    in.positioning_control_word_1 = 0u;
    in.positioning_control_word_2 = 0u;
    in.control_word_2 = 0u;
    in.velocity_override = 0u;
    in.mdi_target_position = 0;
    in.mdi_velocity = 0;
    in.mdi_acceleration = 0u;
    in.mdi_deceleration = 0u;
    expect(hiwin_e_cyclic_encode_telegram_111_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-received-off encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-received-off bytes");
}

static void test_373(void)
{
    static const uint8_t frame[] = {0x00, 0xC8, 0xCF, 0x00, 0x80, 0x34, 0xF8, 0x00, 0x01, 0x00, 0xFF, 0xFF, 0xFF, 0xFE, 0xC0, 0x00, 0x00, 0x00, 0x01, 0x00, 0x09, 0x80, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_111_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-sent opens");
    expect(hiwin_e_telegram_111_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-sent decodes");
    expect(out.status_word_1 == 200u, "example telegram-111-sent: status_word_1");
    expect(out.positioning_status_word_1 == 52992u, "example telegram-111-sent: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 32820u, "example telegram-111-sent: positioning_status_word_2");
    expect(out.status_word_2 == 63488u, "example telegram-111-sent: status_word_2");
    expect(out.message_word == 256u, "example telegram-111-sent: message_word");
    expect(out.position_actual_a == (-2), "example telegram-111-sent: position_actual_a");
    expect(out.speed_actual_b == (-1073741824), "example telegram-111-sent: speed_actual_b");
    expect(out.fault_code == 256u, "example telegram-111-sent: fault_code");
    expect(out.warning_code == 2432u, "example telegram-111-sent: warning_code");
    in.status_word_1 = 200u;
    in.positioning_status_word_1 = 52992u;
    in.positioning_status_word_2 = 32820u;
    in.status_word_2 = 63488u;
    in.message_word = 256u;
    in.position_actual_a = (-2);
    in.speed_actual_b = (-1073741824);
    in.fault_code = 256u;
    in.warning_code = 2432u;
    expect(hiwin_e_cyclic_encode_telegram_111_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-sent encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-sent bytes");
}

static void test_374(void)
{
    static const uint8_t frame[] = {0x1B, 0x37, 0x80, 0x00, 0x80, 0x24, 0x18, 0x00, 0x39, 0xC2, 0x80, 0x00, 0x00, 0x00, 0xE0, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_111_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-sent-moving opens");
    expect(hiwin_e_telegram_111_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-sent-moving decodes");
    expect(out.status_word_1 == 6967u, "example telegram-111-sent-moving: status_word_1");
    expect(out.positioning_status_word_1 == 32768u, "example telegram-111-sent-moving: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 32804u, "example telegram-111-sent-moving: positioning_status_word_2");
    expect(out.status_word_2 == 6144u, "example telegram-111-sent-moving: status_word_2");
    expect(out.message_word == 14786u, "example telegram-111-sent-moving: message_word");
    expect(out.position_actual_a == (-2147483647 - 1), "example telegram-111-sent-moving: position_actual_a");
    expect(out.speed_actual_b == (-536870912), "example telegram-111-sent-moving: speed_actual_b");
    expect(out.fault_code == 0u, "example telegram-111-sent-moving: fault_code");
    expect(out.warning_code == 0u, "example telegram-111-sent-moving: warning_code");
    in.status_word_1 = 6967u;
    in.positioning_status_word_1 = 32768u;
    in.positioning_status_word_2 = 32804u;
    in.status_word_2 = 6144u;
    in.message_word = 14786u;
    in.position_actual_a = (-2147483647 - 1);
    in.speed_actual_b = (-536870912);
    in.fault_code = 0u;
    in.warning_code = 0u;
    expect(hiwin_e_cyclic_encode_telegram_111_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-sent-moving encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-sent-moving bytes");
}

static void test_375(void)
{
    static const uint8_t frame[] = {0x2B, 0x37, 0x80, 0x00, 0x70, 0x04, 0xF9, 0x00, 0x39, 0xC0, 0xFF, 0xFF, 0xFE, 0x70, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x09, 0x80, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_111_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-sent-at-fixed-stop opens");
    expect(hiwin_e_telegram_111_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-sent-at-fixed-stop decodes");
    expect(out.status_word_1 == 11063u, "example telegram-111-sent-at-fixed-stop: status_word_1");
    expect(out.positioning_status_word_1 == 32768u, "example telegram-111-sent-at-fixed-stop: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 28676u, "example telegram-111-sent-at-fixed-stop: positioning_status_word_2");
    expect(out.status_word_2 == 63744u, "example telegram-111-sent-at-fixed-stop: status_word_2");
    expect(out.message_word == 14784u, "example telegram-111-sent-at-fixed-stop: message_word");
    expect(out.position_actual_a == (-400), "example telegram-111-sent-at-fixed-stop: position_actual_a");
    expect(out.speed_actual_b == 0, "example telegram-111-sent-at-fixed-stop: speed_actual_b");
    expect(out.fault_code == 0u, "example telegram-111-sent-at-fixed-stop: fault_code");
    expect(out.warning_code == 2432u, "example telegram-111-sent-at-fixed-stop: warning_code");
    in.status_word_1 = 11063u;
    in.positioning_status_word_1 = 32768u;
    in.positioning_status_word_2 = 28676u;
    in.status_word_2 = 63744u;
    in.message_word = 14784u;
    in.position_actual_a = (-400);
    in.speed_actual_b = 0;
    in.fault_code = 0u;
    in.warning_code = 2432u;
    expect(hiwin_e_cyclic_encode_telegram_111_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-sent-at-fixed-stop encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-sent-at-fixed-stop bytes");
}

static void test_376(void)
{
    static const uint8_t frame[] = {0x3F, 0xFF, 0xCF, 0x00, 0xF0, 0x34, 0xF9, 0x00, 0x39, 0xC2, 0x7F, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF, 0x0E, 0xE0, 0xFF, 0xFF, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_111_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-111-sent-all-bits opens");
    expect(hiwin_e_telegram_111_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-111-sent-all-bits decodes");
    expect(out.status_word_1 == 16383u, "example telegram-111-sent-all-bits: status_word_1");
    expect(out.positioning_status_word_1 == 52992u, "example telegram-111-sent-all-bits: positioning_status_word_1");
    expect(out.positioning_status_word_2 == 61492u, "example telegram-111-sent-all-bits: positioning_status_word_2");
    expect(out.status_word_2 == 63744u, "example telegram-111-sent-all-bits: status_word_2");
    expect(out.message_word == 14786u, "example telegram-111-sent-all-bits: message_word");
    expect(out.position_actual_a == 2147483647, "example telegram-111-sent-all-bits: position_actual_a");
    expect(out.speed_actual_b == 2147483647, "example telegram-111-sent-all-bits: speed_actual_b");
    expect(out.fault_code == 3808u, "example telegram-111-sent-all-bits: fault_code");
    expect(out.warning_code == 65535u, "example telegram-111-sent-all-bits: warning_code");
    in.status_word_1 = 16383u;
    in.positioning_status_word_1 = 52992u;
    in.positioning_status_word_2 = 61492u;
    in.status_word_2 = 63744u;
    in.message_word = 14786u;
    in.position_actual_a = 2147483647;
    in.speed_actual_b = 2147483647;
    in.fault_code = 3808u;
    in.warning_code = 65535u;
    expect(hiwin_e_cyclic_encode_telegram_111_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-111-sent-all-bits encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-111-sent-all-bits bytes");
}

static void test_377(void)
{
    static const uint8_t frame[] = {0x04, 0x0F, 0xE0, 0x00, 0x00, 0x00, 0xF0, 0x00, 0xC0, 0x9F};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_3_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-3-received opens");
    expect(hiwin_e_telegram_3_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-3-received decodes");
    expect(out.control_word_1 == 1039u, "example telegram-3-received: control_word_1");
    expect(out.speed_setpoint_b == (-536870912), "example telegram-3-received: speed_setpoint_b");
    expect(out.control_word_2 == 61440u, "example telegram-3-received: control_word_2");
    expect(out.encoder_1_control_word == 49311u, "example telegram-3-received: encoder_1_control_word");
    in.control_word_1 = 1039u;
    in.speed_setpoint_b = (-536870912);
    in.control_word_2 = 61440u;
    in.encoder_1_control_word = 49311u;
    expect(hiwin_e_cyclic_encode_telegram_3_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-3-received encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-3-received bytes");
}

static void test_378(void)
{
    static const uint8_t frame[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_3_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-3-received-off opens");
    expect(hiwin_e_telegram_3_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-3-received-off decodes");
    expect(out.control_word_1 == 0u, "example telegram-3-received-off: control_word_1");
    expect(out.speed_setpoint_b == 0, "example telegram-3-received-off: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "example telegram-3-received-off: control_word_2");
    expect(out.encoder_1_control_word == 0u, "example telegram-3-received-off: encoder_1_control_word");
    in.control_word_1 = 0u;
    in.speed_setpoint_b = 0;
    in.control_word_2 = 0u;
    in.encoder_1_control_word = 0u;
    expect(hiwin_e_cyclic_encode_telegram_3_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-3-received-off encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-3-received-off bytes");
}

static void test_379(void)
{
    static const uint8_t frame[] = {0x04, 0x8F, 0x80, 0x00, 0x00, 0x00, 0xF0, 0x00, 0xC0, 0xBF};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_3_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-3-received-all-bits opens");
    expect(hiwin_e_telegram_3_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-3-received-all-bits decodes");
    expect(out.control_word_1 == 1167u, "example telegram-3-received-all-bits: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "example telegram-3-received-all-bits: speed_setpoint_b");
    expect(out.control_word_2 == 61440u, "example telegram-3-received-all-bits: control_word_2");
    expect(out.encoder_1_control_word == 49343u, "example telegram-3-received-all-bits: encoder_1_control_word");
    in.control_word_1 = 1167u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 61440u;
    in.encoder_1_control_word = 49343u;
    expect(hiwin_e_cyclic_encode_telegram_3_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-3-received-all-bits encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-3-received-all-bits bytes");
}

static void test_380(void)
{
    static const uint8_t frame[] = {0x04, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x10, 0x00, 0x00, 0x71};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_3_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-3-received-reserved-command opens");
    expect(hiwin_e_telegram_3_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-3-received-reserved-command decodes");
    expect(out.control_word_1 == 1024u, "example telegram-3-received-reserved-command: control_word_1");
    expect(out.speed_setpoint_b == 2147483647, "example telegram-3-received-reserved-command: speed_setpoint_b");
    expect(out.control_word_2 == 4096u, "example telegram-3-received-reserved-command: control_word_2");
    expect(out.encoder_1_control_word == 113u, "example telegram-3-received-reserved-command: encoder_1_control_word");
    in.control_word_1 = 1024u;
    in.speed_setpoint_b = 2147483647;
    in.control_word_2 = 4096u;
    in.encoder_1_control_word = 113u;
    expect(hiwin_e_cyclic_encode_telegram_3_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-3-received-reserved-command encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-3-received-reserved-command bytes");
}

static void test_381(void)
{
    static const uint8_t frame[] = {0x07, 0x37, 0xE0, 0x00, 0x00, 0x00, 0x10, 0x00, 0xC8, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_3_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-3-sent opens");
    expect(hiwin_e_telegram_3_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-3-sent decodes");
    expect(out.status_word_1 == 1847u, "example telegram-3-sent: status_word_1");
    expect(out.speed_actual_b == (-536870912), "example telegram-3-sent: speed_actual_b");
    expect(out.status_word_2 == 4096u, "example telegram-3-sent: status_word_2");
    expect(out.encoder_1_status_word == 51455u, "example telegram-3-sent: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "example telegram-3-sent: encoder_1_position_1");
    expect(out.encoder_1_position_2 == 2147483647, "example telegram-3-sent: encoder_1_position_2");
    in.status_word_1 = 1847u;
    in.speed_actual_b = (-536870912);
    in.status_word_2 = 4096u;
    in.encoder_1_status_word = 51455u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = 2147483647;
    expect(hiwin_e_cyclic_encode_telegram_3_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-3-sent encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-3-sent bytes");
}

static void test_382(void)
{
    static const uint8_t frame[] = {0x00, 0xC8, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_3_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-3-sent-inhibited opens");
    expect(hiwin_e_telegram_3_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-3-sent-inhibited decodes");
    expect(out.status_word_1 == 200u, "example telegram-3-sent-inhibited: status_word_1");
    expect(out.speed_actual_b == 0, "example telegram-3-sent-inhibited: speed_actual_b");
    expect(out.status_word_2 == 0u, "example telegram-3-sent-inhibited: status_word_2");
    expect(out.encoder_1_status_word == 0u, "example telegram-3-sent-inhibited: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-1), "example telegram-3-sent-inhibited: encoder_1_position_1");
    expect(out.encoder_1_position_2 == 0, "example telegram-3-sent-inhibited: encoder_1_position_2");
    in.status_word_1 = 200u;
    in.speed_actual_b = 0;
    in.status_word_2 = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-1);
    in.encoder_1_position_2 = 0;
    expect(hiwin_e_cyclic_encode_telegram_3_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-3-sent-inhibited encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-3-sent-inhibited bytes");
}

static void test_383(void)
{
    static const uint8_t frame[] = {0x02, 0x31, 0x00, 0x00, 0x00, 0x00, 0x20, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_3_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-3-sent-ready opens");
    expect(hiwin_e_telegram_3_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-3-sent-ready decodes");
    expect(out.status_word_1 == 561u, "example telegram-3-sent-ready: status_word_1");
    expect(out.speed_actual_b == 0, "example telegram-3-sent-ready: speed_actual_b");
    expect(out.status_word_2 == 8192u, "example telegram-3-sent-ready: status_word_2");
    expect(out.encoder_1_status_word == 0u, "example telegram-3-sent-ready: encoder_1_status_word");
    expect(out.encoder_1_position_1 == 65536, "example telegram-3-sent-ready: encoder_1_position_1");
    expect(out.encoder_1_position_2 == 0, "example telegram-3-sent-ready: encoder_1_position_2");
    in.status_word_1 = 561u;
    in.speed_actual_b = 0;
    in.status_word_2 = 8192u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = 65536;
    in.encoder_1_position_2 = 0;
    expect(hiwin_e_cyclic_encode_telegram_3_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-3-sent-ready encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-3-sent-ready bytes");
}

static void test_384(void)
{
    static const uint8_t frame[] = {0x02, 0x33, 0xFF, 0xFF, 0xFF, 0xFF, 0x30, 0x00, 0x00, 0x11, 0xFF, 0xFF, 0x00, 0x00, 0xFF, 0xFE, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_3_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-3-sent-switched-on opens");
    expect(hiwin_e_telegram_3_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-3-sent-switched-on decodes");
    expect(out.status_word_1 == 563u, "example telegram-3-sent-switched-on: status_word_1");
    expect(out.speed_actual_b == (-1), "example telegram-3-sent-switched-on: speed_actual_b");
    expect(out.status_word_2 == 12288u, "example telegram-3-sent-switched-on: status_word_2");
    expect(out.encoder_1_status_word == 17u, "example telegram-3-sent-switched-on: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-65536), "example telegram-3-sent-switched-on: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-65537), "example telegram-3-sent-switched-on: encoder_1_position_2");
    in.status_word_1 = 563u;
    in.speed_actual_b = (-1);
    in.status_word_2 = 12288u;
    in.encoder_1_status_word = 17u;
    in.encoder_1_position_1 = (-65536);
    in.encoder_1_position_2 = (-65537);
    expect(hiwin_e_cyclic_encode_telegram_3_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-3-sent-switched-on encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-3-sent-switched-on bytes");
}

static void test_385(void)
{
    static const uint8_t frame[] = {0x07, 0xFF, 0xC0, 0x00, 0x00, 0x00, 0xF0, 0x00, 0xC8, 0xFF, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_3_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-3-sent-all-bits opens");
    expect(hiwin_e_telegram_3_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-3-sent-all-bits decodes");
    expect(out.status_word_1 == 2047u, "example telegram-3-sent-all-bits: status_word_1");
    expect(out.speed_actual_b == (-1073741824), "example telegram-3-sent-all-bits: speed_actual_b");
    expect(out.status_word_2 == 61440u, "example telegram-3-sent-all-bits: status_word_2");
    expect(out.encoder_1_status_word == 51455u, "example telegram-3-sent-all-bits: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2147483647 - 1), "example telegram-3-sent-all-bits: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-1), "example telegram-3-sent-all-bits: encoder_1_position_2");
    in.status_word_1 = 2047u;
    in.speed_actual_b = (-1073741824);
    in.status_word_2 = 61440u;
    in.encoder_1_status_word = 51455u;
    in.encoder_1_position_1 = (-2147483647 - 1);
    in.encoder_1_position_2 = (-1);
    expect(hiwin_e_cyclic_encode_telegram_3_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-3-sent-all-bits encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-3-sent-all-bits bytes");
}

static void test_386(void)
{
    static const uint8_t frame[] = {0x04, 0x8F, 0x40, 0x00, 0x00, 0x00, 0x70, 0x00, 0x00, 0x20, 0xFF, 0xFF, 0xCF, 0xC7, 0x00, 0x00, 0x05, 0xDC};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_5_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-5-received opens");
    expect(hiwin_e_telegram_5_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-5-received decodes");
    expect(out.control_word_1 == 1167u, "example telegram-5-received: control_word_1");
    expect(out.speed_setpoint_b == 1073741824, "example telegram-5-received: speed_setpoint_b");
    expect(out.control_word_2 == 28672u, "example telegram-5-received: control_word_2");
    expect(out.encoder_1_control_word == 32u, "example telegram-5-received: encoder_1_control_word");
    expect(out.position_error == (-12345), "example telegram-5-received: position_error");
    expect(out.position_controller_gain == 1500, "example telegram-5-received: position_controller_gain");
    in.control_word_1 = 1167u;
    in.speed_setpoint_b = 1073741824;
    in.control_word_2 = 28672u;
    in.encoder_1_control_word = 32u;
    in.position_error = (-12345);
    in.position_controller_gain = 1500;
    expect(hiwin_e_cyclic_encode_telegram_5_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-5-received encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-5-received bytes");
}

static void test_387(void)
{
    static const uint8_t frame[] = {0x04, 0x0F, 0xC0, 0x00, 0x00, 0x00, 0xF0, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_5_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-5-received-greatest opens");
    expect(hiwin_e_telegram_5_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-5-received-greatest decodes");
    expect(out.control_word_1 == 1039u, "example telegram-5-received-greatest: control_word_1");
    expect(out.speed_setpoint_b == (-1073741824), "example telegram-5-received-greatest: speed_setpoint_b");
    expect(out.control_word_2 == 61440u, "example telegram-5-received-greatest: control_word_2");
    expect(out.encoder_1_control_word == 0u, "example telegram-5-received-greatest: encoder_1_control_word");
    expect(out.position_error == 2147483647, "example telegram-5-received-greatest: position_error");
    expect(out.position_controller_gain == 2147483647, "example telegram-5-received-greatest: position_controller_gain");
    in.control_word_1 = 1039u;
    in.speed_setpoint_b = (-1073741824);
    in.control_word_2 = 61440u;
    in.encoder_1_control_word = 0u;
    in.position_error = 2147483647;
    in.position_controller_gain = 2147483647;
    expect(hiwin_e_cyclic_encode_telegram_5_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-5-received-greatest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-5-received-greatest bytes");
}

static void test_388(void)
{
    static const uint8_t frame[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_5_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-5-received-lowest opens");
    expect(hiwin_e_telegram_5_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-5-received-lowest decodes");
    expect(out.control_word_1 == 0u, "example telegram-5-received-lowest: control_word_1");
    expect(out.speed_setpoint_b == 0, "example telegram-5-received-lowest: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "example telegram-5-received-lowest: control_word_2");
    expect(out.encoder_1_control_word == 32768u, "example telegram-5-received-lowest: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "example telegram-5-received-lowest: position_error");
    expect(out.position_controller_gain == 0, "example telegram-5-received-lowest: position_controller_gain");
    in.control_word_1 = 0u;
    in.speed_setpoint_b = 0;
    in.control_word_2 = 0u;
    in.encoder_1_control_word = 32768u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = 0;
    expect(hiwin_e_cyclic_encode_telegram_5_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-5-received-lowest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-5-received-lowest bytes");
}

static void test_389(void)
{
    static const uint8_t frame[] = {0x00, 0x01, 0x7F, 0xFF, 0xFF, 0xFF, 0xF0, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0xFF, 0xFF, 0xFF, 0xFE};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_5_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-5-sent opens");
    expect(hiwin_e_telegram_5_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-5-sent decodes");
    expect(out.status_word_1 == 1u, "example telegram-5-sent: status_word_1");
    expect(out.speed_actual_b == 2147483647, "example telegram-5-sent: speed_actual_b");
    expect(out.status_word_2 == 61440u, "example telegram-5-sent: status_word_2");
    expect(out.encoder_1_status_word == 0u, "example telegram-5-sent: encoder_1_status_word");
    expect(out.encoder_1_position_1 == 1, "example telegram-5-sent: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2), "example telegram-5-sent: encoder_1_position_2");
    in.status_word_1 = 1u;
    in.speed_actual_b = 2147483647;
    in.status_word_2 = 61440u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = 1;
    in.encoder_1_position_2 = (-2);
    expect(hiwin_e_cyclic_encode_telegram_5_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-5-sent encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-5-sent bytes");
}

static void test_390(void)
{
    static const uint8_t frame[] = {0x07, 0x37, 0xF0, 0x00, 0x00, 0x00, 0x80, 0x00, 0x80, 0x00, 0xFF, 0xFF, 0xCF, 0xC7, 0x80, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_5_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-5-sent-backwards opens");
    expect(hiwin_e_telegram_5_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-5-sent-backwards decodes");
    expect(out.status_word_1 == 1847u, "example telegram-5-sent-backwards: status_word_1");
    expect(out.speed_actual_b == (-268435456), "example telegram-5-sent-backwards: speed_actual_b");
    expect(out.status_word_2 == 32768u, "example telegram-5-sent-backwards: status_word_2");
    expect(out.encoder_1_status_word == 32768u, "example telegram-5-sent-backwards: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-12345), "example telegram-5-sent-backwards: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "example telegram-5-sent-backwards: encoder_1_position_2");
    in.status_word_1 = 1847u;
    in.speed_actual_b = (-268435456);
    in.status_word_2 = 32768u;
    in.encoder_1_status_word = 32768u;
    in.encoder_1_position_1 = (-12345);
    in.encoder_1_position_2 = (-2147483647 - 1);
    expect(hiwin_e_cyclic_encode_telegram_5_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-5-sent-backwards encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-5-sent-backwards bytes");
}

static void test_391(void)
{
    static const uint8_t frame[] = {0x04, 0x0F, 0x00, 0x00, 0x00, 0x01, 0x10, 0x00, 0x10, 0x00, 0x00, 0x30};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_102_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-102-received opens");
    expect(hiwin_e_telegram_102_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-102-received decodes");
    expect(out.control_word_1 == 1039u, "example telegram-102-received: control_word_1");
    expect(out.speed_setpoint_b == 1, "example telegram-102-received: speed_setpoint_b");
    expect(out.control_word_2 == 4096u, "example telegram-102-received: control_word_2");
    expect(out.torque_reduction == 4096u, "example telegram-102-received: torque_reduction");
    expect(out.encoder_1_control_word == 48u, "example telegram-102-received: encoder_1_control_word");
    in.control_word_1 = 1039u;
    in.speed_setpoint_b = 1;
    in.control_word_2 = 4096u;
    in.torque_reduction = 4096u;
    in.encoder_1_control_word = 48u;
    expect(hiwin_e_cyclic_encode_telegram_102_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-102-received encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-102-received bytes");
}

static void test_392(void)
{
    static const uint8_t frame[] = {0x04, 0x0F, 0xF3, 0x33, 0x33, 0x33, 0xF1, 0x00, 0x40, 0x00, 0x00, 0x10};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_102_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-102-received-fixed-stop opens");
    expect(hiwin_e_telegram_102_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-102-received-fixed-stop decodes");
    expect(out.control_word_1 == 1039u, "example telegram-102-received-fixed-stop: control_word_1");
    expect(out.speed_setpoint_b == (-214748365), "example telegram-102-received-fixed-stop: speed_setpoint_b");
    expect(out.control_word_2 == 61696u, "example telegram-102-received-fixed-stop: control_word_2");
    expect(out.torque_reduction == 16384u, "example telegram-102-received-fixed-stop: torque_reduction");
    expect(out.encoder_1_control_word == 16u, "example telegram-102-received-fixed-stop: encoder_1_control_word");
    in.control_word_1 = 1039u;
    in.speed_setpoint_b = (-214748365);
    in.control_word_2 = 61696u;
    in.torque_reduction = 16384u;
    in.encoder_1_control_word = 16u;
    expect(hiwin_e_cyclic_encode_telegram_102_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-102-received-fixed-stop encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-102-received-fixed-stop bytes");
}

static void test_393(void)
{
    static const uint8_t frame[] = {0x04, 0x8F, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x40, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_102_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-102-received-full-torque opens");
    expect(hiwin_e_telegram_102_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-102-received-full-torque decodes");
    expect(out.control_word_1 == 1167u, "example telegram-102-received-full-torque: control_word_1");
    expect(out.speed_setpoint_b == 2147483647, "example telegram-102-received-full-torque: speed_setpoint_b");
    expect(out.control_word_2 == 0u, "example telegram-102-received-full-torque: control_word_2");
    expect(out.torque_reduction == 0u, "example telegram-102-received-full-torque: torque_reduction");
    expect(out.encoder_1_control_word == 16384u, "example telegram-102-received-full-torque: encoder_1_control_word");
    in.control_word_1 = 1167u;
    in.speed_setpoint_b = 2147483647;
    in.control_word_2 = 0u;
    in.torque_reduction = 0u;
    in.encoder_1_control_word = 16384u;
    expect(hiwin_e_cyclic_encode_telegram_102_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-102-received-full-torque encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-102-received-full-torque bytes");
}

static void test_394(void)
{
    static const uint8_t frame[] = {0x00, 0x03, 0x80, 0x00, 0x00, 0x00, 0x10, 0x00, 0x39, 0xC2, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_102_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-102-sent opens");
    expect(hiwin_e_telegram_102_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-102-sent decodes");
    expect(out.status_word_1 == 3u, "example telegram-102-sent: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "example telegram-102-sent: speed_actual_b");
    expect(out.status_word_2 == 4096u, "example telegram-102-sent: status_word_2");
    expect(out.message_word == 14786u, "example telegram-102-sent: message_word");
    expect(out.encoder_1_status_word == 0u, "example telegram-102-sent: encoder_1_status_word");
    expect(out.encoder_1_position_1 == 2147483647, "example telegram-102-sent: encoder_1_position_1");
    expect(out.encoder_1_position_2 == (-2147483647 - 1), "example telegram-102-sent: encoder_1_position_2");
    in.status_word_1 = 3u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 4096u;
    in.message_word = 14786u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = 2147483647;
    in.encoder_1_position_2 = (-2147483647 - 1);
    expect(hiwin_e_cyclic_encode_telegram_102_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-102-sent encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-102-sent bytes");
}

static void test_395(void)
{
    static const uint8_t frame[] = {0x03, 0x37, 0x00, 0x00, 0x00, 0x00, 0xF1, 0x00, 0x39, 0xC0, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0x9C, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_102_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-102-sent-fixed-stop opens");
    expect(hiwin_e_telegram_102_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-102-sent-fixed-stop decodes");
    expect(out.status_word_1 == 823u, "example telegram-102-sent-fixed-stop: status_word_1");
    expect(out.speed_actual_b == 0, "example telegram-102-sent-fixed-stop: speed_actual_b");
    expect(out.status_word_2 == 61696u, "example telegram-102-sent-fixed-stop: status_word_2");
    expect(out.message_word == 14784u, "example telegram-102-sent-fixed-stop: message_word");
    expect(out.encoder_1_status_word == 0u, "example telegram-102-sent-fixed-stop: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-100), "example telegram-102-sent-fixed-stop: encoder_1_position_1");
    expect(out.encoder_1_position_2 == 0, "example telegram-102-sent-fixed-stop: encoder_1_position_2");
    in.status_word_1 = 823u;
    in.speed_actual_b = 0;
    in.status_word_2 = 61696u;
    in.message_word = 14784u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = (-100);
    in.encoder_1_position_2 = 0;
    expect(hiwin_e_cyclic_encode_telegram_102_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-102-sent-fixed-stop encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-102-sent-fixed-stop bytes");
}

static void test_396(void)
{
    static const uint8_t frame[] = {0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x10, 0x00, 0x40, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_105_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-105-received opens");
    expect(hiwin_e_telegram_105_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-105-received decodes");
    expect(out.control_word_1 == 1u, "example telegram-105-received: control_word_1");
    expect(out.speed_setpoint_b == (-2147483647 - 1), "example telegram-105-received: speed_setpoint_b");
    expect(out.control_word_2 == 4096u, "example telegram-105-received: control_word_2");
    expect(out.torque_reduction == 16384u, "example telegram-105-received: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "example telegram-105-received: encoder_1_control_word");
    expect(out.position_error == (-2147483647 - 1), "example telegram-105-received: position_error");
    expect(out.position_controller_gain == (-2147483647 - 1), "example telegram-105-received: position_controller_gain");
    in.control_word_1 = 1u;
    in.speed_setpoint_b = (-2147483647 - 1);
    in.control_word_2 = 4096u;
    in.torque_reduction = 16384u;
    in.encoder_1_control_word = 0u;
    in.position_error = (-2147483647 - 1);
    in.position_controller_gain = (-2147483647 - 1);
    expect(hiwin_e_cyclic_encode_telegram_105_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-105-received encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-105-received bytes");
}

static void test_397(void)
{
    static const uint8_t frame[] = {0x04, 0x0F, 0x10, 0x00, 0x00, 0x00, 0x91, 0x00, 0x20, 0x00, 0x00, 0x21, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x01};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_105_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-105-received-fixed-stop opens");
    expect(hiwin_e_telegram_105_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-105-received-fixed-stop decodes");
    expect(out.control_word_1 == 1039u, "example telegram-105-received-fixed-stop: control_word_1");
    expect(out.speed_setpoint_b == 268435456, "example telegram-105-received-fixed-stop: speed_setpoint_b");
    expect(out.control_word_2 == 37120u, "example telegram-105-received-fixed-stop: control_word_2");
    expect(out.torque_reduction == 8192u, "example telegram-105-received-fixed-stop: torque_reduction");
    expect(out.encoder_1_control_word == 33u, "example telegram-105-received-fixed-stop: encoder_1_control_word");
    expect(out.position_error == (-1), "example telegram-105-received-fixed-stop: position_error");
    expect(out.position_controller_gain == 1, "example telegram-105-received-fixed-stop: position_controller_gain");
    in.control_word_1 = 1039u;
    in.speed_setpoint_b = 268435456;
    in.control_word_2 = 37120u;
    in.torque_reduction = 8192u;
    in.encoder_1_control_word = 33u;
    in.position_error = (-1);
    in.position_controller_gain = 1;
    expect(hiwin_e_cyclic_encode_telegram_105_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-105-received-fixed-stop encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-105-received-fixed-stop bytes");
}

static void test_398(void)
{
    static const uint8_t frame[] = {0x04, 0x0F, 0x7F, 0xFF, 0xFF, 0xFF, 0xF0, 0x00, 0x40, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_105_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-105-received-greatest opens");
    expect(hiwin_e_telegram_105_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-105-received-greatest decodes");
    expect(out.control_word_1 == 1039u, "example telegram-105-received-greatest: control_word_1");
    expect(out.speed_setpoint_b == 2147483647, "example telegram-105-received-greatest: speed_setpoint_b");
    expect(out.control_word_2 == 61440u, "example telegram-105-received-greatest: control_word_2");
    expect(out.torque_reduction == 16384u, "example telegram-105-received-greatest: torque_reduction");
    expect(out.encoder_1_control_word == 0u, "example telegram-105-received-greatest: encoder_1_control_word");
    expect(out.position_error == 2147483647, "example telegram-105-received-greatest: position_error");
    expect(out.position_controller_gain == 2147483647, "example telegram-105-received-greatest: position_controller_gain");
    in.control_word_1 = 1039u;
    in.speed_setpoint_b = 2147483647;
    in.control_word_2 = 61440u;
    in.torque_reduction = 16384u;
    in.encoder_1_control_word = 0u;
    in.position_error = 2147483647;
    in.position_controller_gain = 2147483647;
    expect(hiwin_e_cyclic_encode_telegram_105_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-105-received-greatest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-105-received-greatest bytes");
}

static void test_399(void)
{
    static const uint8_t frame[] = {0x00, 0x40, 0x00, 0x00, 0x00, 0x00, 0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_105_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-105-sent opens");
    expect(hiwin_e_telegram_105_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-105-sent decodes");
    expect(out.status_word_1 == 64u, "example telegram-105-sent: status_word_1");
    expect(out.speed_actual_b == 0, "example telegram-105-sent: speed_actual_b");
    expect(out.status_word_2 == 4096u, "example telegram-105-sent: status_word_2");
    expect(out.message_word == 0u, "example telegram-105-sent: message_word");
    expect(out.encoder_1_status_word == 0u, "example telegram-105-sent: encoder_1_status_word");
    expect(out.encoder_1_position_1 == 0, "example telegram-105-sent: encoder_1_position_1");
    expect(out.encoder_1_position_2 == 0, "example telegram-105-sent: encoder_1_position_2");
    in.status_word_1 = 64u;
    in.speed_actual_b = 0;
    in.status_word_2 = 4096u;
    in.message_word = 0u;
    in.encoder_1_status_word = 0u;
    in.encoder_1_position_1 = 0;
    in.encoder_1_position_2 = 0;
    expect(hiwin_e_cyclic_encode_telegram_105_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-105-sent encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-105-sent bytes");
}

static void test_400(void)
{
    static const uint8_t frame[] = {0x02, 0x48, 0x80, 0x00, 0x00, 0x00, 0xF0, 0x00, 0x01, 0x02, 0x88, 0x00, 0xFF, 0xFF, 0xFF, 0xFE, 0x7F, 0xFF, 0xFF, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_105_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-105-sent-alarm opens");
    expect(hiwin_e_telegram_105_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-105-sent-alarm decodes");
    expect(out.status_word_1 == 584u, "example telegram-105-sent-alarm: status_word_1");
    expect(out.speed_actual_b == (-2147483647 - 1), "example telegram-105-sent-alarm: speed_actual_b");
    expect(out.status_word_2 == 61440u, "example telegram-105-sent-alarm: status_word_2");
    expect(out.message_word == 258u, "example telegram-105-sent-alarm: message_word");
    expect(out.encoder_1_status_word == 34816u, "example telegram-105-sent-alarm: encoder_1_status_word");
    expect(out.encoder_1_position_1 == (-2), "example telegram-105-sent-alarm: encoder_1_position_1");
    expect(out.encoder_1_position_2 == 2147483647, "example telegram-105-sent-alarm: encoder_1_position_2");
    in.status_word_1 = 584u;
    in.speed_actual_b = (-2147483647 - 1);
    in.status_word_2 = 61440u;
    in.message_word = 258u;
    in.encoder_1_status_word = 34816u;
    in.encoder_1_position_1 = (-2);
    in.encoder_1_position_2 = 2147483647;
    expect(hiwin_e_cyclic_encode_telegram_105_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-105-sent-alarm encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-105-sent-alarm bytes");
}

static void test_401(void)
{
    static const uint8_t frame[] = {0x80, 0x00, 0x7F, 0xFF, 0x80, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_750_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-750-received opens");
    expect(hiwin_e_telegram_750_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-750-received decodes");
    expect(out.additional_torque == (-32768), "example telegram-750-received: additional_torque");
    expect(out.positive_torque_limit == 32767, "example telegram-750-received: positive_torque_limit");
    expect(out.negative_torque_limit == (-32768), "example telegram-750-received: negative_torque_limit");
    in.additional_torque = (-32768);
    in.positive_torque_limit = 32767;
    in.negative_torque_limit = (-32768);
    expect(hiwin_e_cyclic_encode_telegram_750_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-750-received encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-750-received bytes");
}

static void test_402(void)
{
    static const uint8_t frame[] = {0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_750_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-750-received-off opens");
    expect(hiwin_e_telegram_750_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-750-received-off decodes");
    expect(out.additional_torque == 0, "example telegram-750-received-off: additional_torque");
    expect(out.positive_torque_limit == 0, "example telegram-750-received-off: positive_torque_limit");
    expect(out.negative_torque_limit == 0, "example telegram-750-received-off: negative_torque_limit");
    in.additional_torque = 0;
    in.positive_torque_limit = 0;
    in.negative_torque_limit = 0;
    expect(hiwin_e_cyclic_encode_telegram_750_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-750-received-off encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-750-received-off bytes");
}

static void test_403(void)
{
    static const uint8_t frame[] = {0xFF, 0xFF, 0x20, 0x00, 0xE0, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_request_frame opened;
    hiwin_e_telegram_750_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_request_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-750-received-half opens");
    expect(hiwin_e_telegram_750_request_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-750-received-half decodes");
    expect(out.additional_torque == (-1), "example telegram-750-received-half: additional_torque");
    expect(out.positive_torque_limit == 8192, "example telegram-750-received-half: positive_torque_limit");
    expect(out.negative_torque_limit == (-8192), "example telegram-750-received-half: negative_torque_limit");
    in.additional_torque = (-1);
    in.positive_torque_limit = 8192;
    in.negative_torque_limit = (-8192);
    expect(hiwin_e_cyclic_encode_telegram_750_request(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-750-received-half encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-750-received-half bytes");
}

static void test_404(void)
{
    static const uint8_t frame[] = {0xE0, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_750_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-750-sent opens");
    expect(hiwin_e_telegram_750_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-750-sent decodes");
    expect(out.torque_actual == (-8192), "example telegram-750-sent: torque_actual");
    in.torque_actual = (-8192);
    expect(hiwin_e_cyclic_encode_telegram_750_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-750-sent encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-750-sent bytes");
}

static void test_405(void)
{
    static const uint8_t frame[] = {0x80, 0x00};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_750_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-750-sent-lowest opens");
    expect(hiwin_e_telegram_750_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-750-sent-lowest decodes");
    expect(out.torque_actual == (-32768), "example telegram-750-sent-lowest: torque_actual");
    in.torque_actual = (-32768);
    expect(hiwin_e_cyclic_encode_telegram_750_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-750-sent-lowest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-750-sent-lowest bytes");
}

static void test_406(void)
{
    static const uint8_t frame[] = {0x7F, 0xFF};
    uint8_t received[sizeof frame];
    hiwin_e_cyclic_response_frame opened;
    hiwin_e_telegram_750_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(hiwin_e_cyclic_response_open(received, sizeof received, &opened) == HIWIN_E_OK, "example telegram-750-sent-greatest opens");
    expect(hiwin_e_telegram_750_response_decode(opened.body, opened.body_length, &out) == HIWIN_E_OK, "example telegram-750-sent-greatest decodes");
    expect(out.torque_actual == 32767, "example telegram-750-sent-greatest: torque_actual");
    in.torque_actual = 32767;
    expect(hiwin_e_cyclic_encode_telegram_750_response(&in, again, sizeof again, &length) == HIWIN_E_OK, "example telegram-750-sent-greatest encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example telegram-750-sent-greatest bytes");
}

static void test_407(void)
{
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_absent(HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TOLERANCE_ABSENT_AS_POSITIVE) == true, "hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_absent as_positive");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_absent(1u) == false, "hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_absent 1");
}

static void test_408(void)
{
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_absent(HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TORQUE_ABSENT_AS_POSITIVE) == true, "hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_absent as_positive");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_absent(1u) == false, "hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_absent 1");
}

static void test_409(void)
{
    #ifndef HIWIN_E_WITHOUT_DOUBLE
    double quantity = 0.0;
    uint32_t raw = 0;
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_from_raw(0u, &quantity) == HIWIN_E_ERR_OUT_OF_RANGE, "servo_parameters.negative_fixed_stop_torque 0");
    quantity = 0.0;
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_to_raw(quantity, &raw) == HIWIN_E_ERR_OUT_OF_RANGE, "servo_parameters.negative_fixed_stop_torque 0 back");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_from_raw(2147483647u, &quantity) == HIWIN_E_OK, "servo_parameters.negative_fixed_stop_torque 2147483647");
    expect(quantity >= 2147483.6469978523, "servo_parameters.negative_fixed_stop_torque 2147483647");
    expect(quantity <= 2147483.6470021475, "servo_parameters.negative_fixed_stop_torque 2147483647");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_to_raw(quantity, &raw) == HIWIN_E_OK, "servo_parameters.negative_fixed_stop_torque 2147483647 back");
    expect(raw == 2147483647u, "servo_parameters.negative_fixed_stop_torque 2147483647 back");
    #endif
}

static void test_410(void)
{
    expect(hiwin_e_signal_mdi_velocity_is_out_of_range((-1)) == true, "hiwin_e_signal_mdi_velocity_is_out_of_range -1");
    expect(hiwin_e_signal_mdi_velocity_is_out_of_range(0) == false, "hiwin_e_signal_mdi_velocity_is_out_of_range 0");
    expect(hiwin_e_signal_mdi_velocity_is_out_of_range(1) == false, "hiwin_e_signal_mdi_velocity_is_out_of_range 1");
    expect(hiwin_e_signal_mdi_velocity_is_out_of_range(2147483646) == false, "hiwin_e_signal_mdi_velocity_is_out_of_range 2147483646");
    expect(hiwin_e_signal_mdi_velocity_is_out_of_range(2147483647) == false, "hiwin_e_signal_mdi_velocity_is_out_of_range 2147483647");
}

static void test_411(void)
{
    expect(hiwin_e_signal_mdi_acceleration_is_out_of_range(0u) == false, "hiwin_e_signal_mdi_acceleration_is_out_of_range 0");
    expect(hiwin_e_signal_mdi_acceleration_is_out_of_range(1u) == false, "hiwin_e_signal_mdi_acceleration_is_out_of_range 1");
    expect(hiwin_e_signal_mdi_acceleration_is_out_of_range(16383u) == false, "hiwin_e_signal_mdi_acceleration_is_out_of_range 16383");
    expect(hiwin_e_signal_mdi_acceleration_is_out_of_range(16384u) == false, "hiwin_e_signal_mdi_acceleration_is_out_of_range 16384");
    expect(hiwin_e_signal_mdi_acceleration_is_out_of_range(16385u) == true, "hiwin_e_signal_mdi_acceleration_is_out_of_range 16385");
}

static void test_412(void)
{
    expect(hiwin_e_signal_mdi_deceleration_is_out_of_range(0u) == false, "hiwin_e_signal_mdi_deceleration_is_out_of_range 0");
    expect(hiwin_e_signal_mdi_deceleration_is_out_of_range(1u) == false, "hiwin_e_signal_mdi_deceleration_is_out_of_range 1");
    expect(hiwin_e_signal_mdi_deceleration_is_out_of_range(16383u) == false, "hiwin_e_signal_mdi_deceleration_is_out_of_range 16383");
    expect(hiwin_e_signal_mdi_deceleration_is_out_of_range(16384u) == false, "hiwin_e_signal_mdi_deceleration_is_out_of_range 16384");
    expect(hiwin_e_signal_mdi_deceleration_is_out_of_range(16385u) == true, "hiwin_e_signal_mdi_deceleration_is_out_of_range 16385");
}

static void test_413(void)
{
    expect(hiwin_e_signal_velocity_override_is_out_of_range(0u) == false, "hiwin_e_signal_velocity_override_is_out_of_range 0");
    expect(hiwin_e_signal_velocity_override_is_out_of_range(1u) == false, "hiwin_e_signal_velocity_override_is_out_of_range 1");
    expect(hiwin_e_signal_velocity_override_is_out_of_range(32766u) == false, "hiwin_e_signal_velocity_override_is_out_of_range 32766");
    expect(hiwin_e_signal_velocity_override_is_out_of_range(32767u) == false, "hiwin_e_signal_velocity_override_is_out_of_range 32767");
    expect(hiwin_e_signal_velocity_override_is_out_of_range(32768u) == true, "hiwin_e_signal_velocity_override_is_out_of_range 32768");
}

static void test_414(void)
{
    expect(hiwin_e_signal_torque_reduction_is_out_of_range(0u) == false, "hiwin_e_signal_torque_reduction_is_out_of_range 0");
    expect(hiwin_e_signal_torque_reduction_is_out_of_range(1u) == false, "hiwin_e_signal_torque_reduction_is_out_of_range 1");
    expect(hiwin_e_signal_torque_reduction_is_out_of_range(16383u) == false, "hiwin_e_signal_torque_reduction_is_out_of_range 16383");
    expect(hiwin_e_signal_torque_reduction_is_out_of_range(16384u) == false, "hiwin_e_signal_torque_reduction_is_out_of_range 16384");
    expect(hiwin_e_signal_torque_reduction_is_out_of_range(16385u) == true, "hiwin_e_signal_torque_reduction_is_out_of_range 16385");
}

static void test_415(void)
{
    expect(hiwin_e_signal_positive_torque_limit_is_out_of_range((-1)) == true, "hiwin_e_signal_positive_torque_limit_is_out_of_range -1");
    expect(hiwin_e_signal_positive_torque_limit_is_out_of_range(0) == false, "hiwin_e_signal_positive_torque_limit_is_out_of_range 0");
    expect(hiwin_e_signal_positive_torque_limit_is_out_of_range(1) == false, "hiwin_e_signal_positive_torque_limit_is_out_of_range 1");
    expect(hiwin_e_signal_positive_torque_limit_is_out_of_range(32766) == false, "hiwin_e_signal_positive_torque_limit_is_out_of_range 32766");
    expect(hiwin_e_signal_positive_torque_limit_is_out_of_range(32767) == false, "hiwin_e_signal_positive_torque_limit_is_out_of_range 32767");
}

static void test_416(void)
{
    expect(hiwin_e_signal_negative_torque_limit_is_out_of_range((-32768)) == false, "hiwin_e_signal_negative_torque_limit_is_out_of_range -32768");
    expect(hiwin_e_signal_negative_torque_limit_is_out_of_range((-32767)) == false, "hiwin_e_signal_negative_torque_limit_is_out_of_range -32767");
    expect(hiwin_e_signal_negative_torque_limit_is_out_of_range((-1)) == false, "hiwin_e_signal_negative_torque_limit_is_out_of_range -1");
    expect(hiwin_e_signal_negative_torque_limit_is_out_of_range(0) == false, "hiwin_e_signal_negative_torque_limit_is_out_of_range 0");
    expect(hiwin_e_signal_negative_torque_limit_is_out_of_range(1) == true, "hiwin_e_signal_negative_torque_limit_is_out_of_range 1");
}

static void test_417(void)
{
    expect(hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range((-1)) == true, "hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range -1");
    expect(hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range(0) == false, "hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range 0");
    expect(hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range(1) == false, "hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range 1");
    expect(hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range(2147483646) == false, "hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range 2147483646");
    expect(hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range(2147483647) == false, "hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range 2147483647");
}

static void test_418(void)
{
    expect(hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range(0u) == false, "hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range 0");
    expect(hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range(1u) == false, "hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range 1");
    expect(hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range(16383u) == false, "hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range 16383");
    expect(hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range(16384u) == false, "hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range 16384");
    expect(hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range(16385u) == true, "hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range 16385");
}

static void test_419(void)
{
    expect(hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range(0u) == false, "hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range 0");
    expect(hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range(1u) == false, "hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range 1");
    expect(hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range(16383u) == false, "hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range 16383");
    expect(hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range(16384u) == false, "hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range 16384");
    expect(hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range(16385u) == true, "hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range 16385");
}

static void test_420(void)
{
    expect(hiwin_e_telegram_102_request_torque_reduction_is_out_of_range(0u) == false, "hiwin_e_telegram_102_request_torque_reduction_is_out_of_range 0");
    expect(hiwin_e_telegram_102_request_torque_reduction_is_out_of_range(1u) == false, "hiwin_e_telegram_102_request_torque_reduction_is_out_of_range 1");
    expect(hiwin_e_telegram_102_request_torque_reduction_is_out_of_range(16383u) == false, "hiwin_e_telegram_102_request_torque_reduction_is_out_of_range 16383");
    expect(hiwin_e_telegram_102_request_torque_reduction_is_out_of_range(16384u) == false, "hiwin_e_telegram_102_request_torque_reduction_is_out_of_range 16384");
    expect(hiwin_e_telegram_102_request_torque_reduction_is_out_of_range(16385u) == true, "hiwin_e_telegram_102_request_torque_reduction_is_out_of_range 16385");
}

static void test_421(void)
{
    expect(hiwin_e_telegram_105_request_torque_reduction_is_out_of_range(0u) == false, "hiwin_e_telegram_105_request_torque_reduction_is_out_of_range 0");
    expect(hiwin_e_telegram_105_request_torque_reduction_is_out_of_range(1u) == false, "hiwin_e_telegram_105_request_torque_reduction_is_out_of_range 1");
    expect(hiwin_e_telegram_105_request_torque_reduction_is_out_of_range(16383u) == false, "hiwin_e_telegram_105_request_torque_reduction_is_out_of_range 16383");
    expect(hiwin_e_telegram_105_request_torque_reduction_is_out_of_range(16384u) == false, "hiwin_e_telegram_105_request_torque_reduction_is_out_of_range 16384");
    expect(hiwin_e_telegram_105_request_torque_reduction_is_out_of_range(16385u) == true, "hiwin_e_telegram_105_request_torque_reduction_is_out_of_range 16385");
}

static void test_422(void)
{
    expect(hiwin_e_telegram_111_request_velocity_override_is_out_of_range(0u) == false, "hiwin_e_telegram_111_request_velocity_override_is_out_of_range 0");
    expect(hiwin_e_telegram_111_request_velocity_override_is_out_of_range(1u) == false, "hiwin_e_telegram_111_request_velocity_override_is_out_of_range 1");
    expect(hiwin_e_telegram_111_request_velocity_override_is_out_of_range(32766u) == false, "hiwin_e_telegram_111_request_velocity_override_is_out_of_range 32766");
    expect(hiwin_e_telegram_111_request_velocity_override_is_out_of_range(32767u) == false, "hiwin_e_telegram_111_request_velocity_override_is_out_of_range 32767");
    expect(hiwin_e_telegram_111_request_velocity_override_is_out_of_range(32768u) == true, "hiwin_e_telegram_111_request_velocity_override_is_out_of_range 32768");
}

static void test_423(void)
{
    expect(hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range((-1)) == true, "hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range -1");
    expect(hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range(0) == false, "hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range 0");
    expect(hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range(1) == false, "hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range 1");
    expect(hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range(2147483646) == false, "hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range 2147483646");
    expect(hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range(2147483647) == false, "hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range 2147483647");
}

static void test_424(void)
{
    expect(hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range(0u) == false, "hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range 0");
    expect(hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range(1u) == false, "hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range 1");
    expect(hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range(16383u) == false, "hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range 16383");
    expect(hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range(16384u) == false, "hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range 16384");
    expect(hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range(16385u) == true, "hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range 16385");
}

static void test_425(void)
{
    expect(hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range(0u) == false, "hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range 0");
    expect(hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range(1u) == false, "hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range 1");
    expect(hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range(16383u) == false, "hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range 16383");
    expect(hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range(16384u) == false, "hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range 16384");
    expect(hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range(16385u) == true, "hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range 16385");
}

static void test_426(void)
{
    expect(hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range((-1)) == true, "hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range -1");
    expect(hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range(0) == false, "hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range 0");
    expect(hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range(1) == false, "hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range 1");
    expect(hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range(32766) == false, "hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range 32766");
    expect(hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range(32767) == false, "hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range 32767");
}

static void test_427(void)
{
    expect(hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range((-32768)) == false, "hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range -32768");
    expect(hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range((-32767)) == false, "hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range -32767");
    expect(hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range((-1)) == false, "hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range -1");
    expect(hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range(0) == false, "hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range 0");
    expect(hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range(1) == true, "hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range 1");
}

static void test_428(void)
{
    expect(hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range(0u) == false, "hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range 0");
    expect(hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range(1u) == false, "hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range 1");
    expect(hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range(30u) == false, "hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range 30");
    expect(hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range(31u) == false, "hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range 31");
    expect(hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range(32u) == true, "hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range 32");
}

static void test_429(void)
{
    expect(hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range(0u) == false, "hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range 0");
    expect(hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range(1u) == false, "hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range 1");
    expect(hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range(2u) == false, "hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range 2");
    expect(hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range(3u) == false, "hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range 3");
    expect(hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range(4u) == true, "hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range 4");
}

static void test_430(void)
{
    expect(hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range((-10001)) == true, "hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range -10001");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range((-10000)) == false, "hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range -10000");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range((-9999)) == false, "hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range -9999");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range(9999) == false, "hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range 9999");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range(10000) == false, "hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range 10000");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range(10001) == true, "hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range 10001");
}

static void test_431(void)
{
    expect(hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range((-10001)) == true, "hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range -10001");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range((-10000)) == false, "hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range -10000");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range((-9999)) == false, "hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range -9999");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range(9999) == false, "hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range 9999");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range(10000) == false, "hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range 10000");
    expect(hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range(10001) == true, "hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range 10001");
}

static void test_432(void)
{
    expect(hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range((-10001)) == true, "hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range -10001");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range((-10000)) == false, "hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range -10000");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range((-9999)) == false, "hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range -9999");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range(9999) == false, "hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range 9999");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range(10000) == false, "hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range 10000");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range(10001) == true, "hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range 10001");
}

static void test_433(void)
{
    expect(hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range((-10001)) == true, "hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range -10001");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range((-10000)) == false, "hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range -10000");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range((-9999)) == false, "hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range -9999");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range(9999) == false, "hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range 9999");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range(10000) == false, "hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range 10000");
    expect(hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range(10001) == true, "hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range 10001");
}

static void test_434(void)
{
    expect(hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range((-10001)) == true, "hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range -10001");
    expect(hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range((-10000)) == false, "hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range -10000");
    expect(hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range((-9999)) == false, "hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range -9999");
    expect(hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range(9999) == false, "hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range 9999");
    expect(hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range(10000) == false, "hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range 10000");
    expect(hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range(10001) == true, "hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range 10001");
}

static void test_435(void)
{
    expect(hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range((-10001)) == true, "hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range -10001");
    expect(hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range((-10000)) == false, "hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range -10000");
    expect(hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range((-9999)) == false, "hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range -9999");
    expect(hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range(9999) == false, "hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range 9999");
    expect(hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range(10000) == false, "hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range 10000");
    expect(hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range(10001) == true, "hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range 10001");
}

static void test_436(void)
{
    expect(hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range(0u) == false, "hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range 0");
    expect(hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range(1u) == false, "hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range 1");
    expect(hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range(254u) == false, "hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range 254");
    expect(hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range(255u) == false, "hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range 255");
    expect(hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range(256u) == true, "hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range 256");
}

static void test_437(void)
{
    expect(hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range((-1)) == true, "hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range -1");
    expect(hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range(0) == false, "hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range 0");
    expect(hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range(1) == false, "hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range 1");
    expect(hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range(32766) == false, "hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range 32766");
    expect(hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range(32767) == false, "hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range 32767");
}

static void test_438(void)
{
    expect(hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range(8191u) == true, "hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range 8191");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range(8192u) == false, "hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range 8192");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range(8193u) == false, "hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range 8193");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range(20478u) == false, "hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range 20478");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range(20479u) == false, "hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range 20479");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range(20480u) == true, "hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range 20480");
}

static void test_439(void)
{
    expect(hiwin_e_par_drive_parameters_gantry_parameter_subindex_is_out_of_range(0u) == false, "hiwin_e_par_drive_parameters_gantry_parameter_subindex_is_out_of_range 0");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_subindex_is_out_of_range(1u) == true, "hiwin_e_par_drive_parameters_gantry_parameter_subindex_is_out_of_range 1");
}

static void test_440(void)
{
    expect(hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range((-4)) == true, "hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range -4");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range((-3)) == false, "hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range -3");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range((-2)) == false, "hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range -2");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range(7) == false, "hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range 7");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range(8) == false, "hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range 8");
    expect(hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range(9) == true, "hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range 9");
}

static void test_441(void)
{
    expect(hiwin_e_par_servo_parameters_modulo_range_upper_limit_is_out_of_range((-1)) == true, "hiwin_e_par_servo_parameters_modulo_range_upper_limit_is_out_of_range -1");
    expect(hiwin_e_par_servo_parameters_modulo_range_upper_limit_is_out_of_range(0) == false, "hiwin_e_par_servo_parameters_modulo_range_upper_limit_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_modulo_range_upper_limit_is_out_of_range(1) == false, "hiwin_e_par_servo_parameters_modulo_range_upper_limit_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_modulo_range_upper_limit_is_out_of_range(2147483646) == false, "hiwin_e_par_servo_parameters_modulo_range_upper_limit_is_out_of_range 2147483646");
    expect(hiwin_e_par_servo_parameters_modulo_range_upper_limit_is_out_of_range(2147483647) == false, "hiwin_e_par_servo_parameters_modulo_range_upper_limit_is_out_of_range 2147483647");
}

static void test_442(void)
{
    expect(hiwin_e_par_servo_parameters_modulo_range_lower_limit_is_out_of_range((-2147483647 - 1)) == false, "hiwin_e_par_servo_parameters_modulo_range_lower_limit_is_out_of_range -2147483648");
    expect(hiwin_e_par_servo_parameters_modulo_range_lower_limit_is_out_of_range((-2147483647)) == false, "hiwin_e_par_servo_parameters_modulo_range_lower_limit_is_out_of_range -2147483647");
    expect(hiwin_e_par_servo_parameters_modulo_range_lower_limit_is_out_of_range((-1)) == false, "hiwin_e_par_servo_parameters_modulo_range_lower_limit_is_out_of_range -1");
    expect(hiwin_e_par_servo_parameters_modulo_range_lower_limit_is_out_of_range(0) == false, "hiwin_e_par_servo_parameters_modulo_range_lower_limit_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_modulo_range_lower_limit_is_out_of_range(1) == true, "hiwin_e_par_servo_parameters_modulo_range_lower_limit_is_out_of_range 1");
}

static void test_443(void)
{
    expect(hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range(9999u) == false, "hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range 9999");
    expect(hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range(10000u) == false, "hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range 10000");
    expect(hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range(10001u) == true, "hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range 10001");
}

static void test_444(void)
{
    expect(hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range(0u) == true, "hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range(2u) == false, "hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range 2");
    expect(hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range(65534u) == false, "hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range 65534");
    expect(hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range(65535u) == false, "hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range 65535");
}

static void test_445(void)
{
    expect(hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range(99u) == false, "hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range 99");
    expect(hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range(100u) == false, "hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range 100");
    expect(hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range(101u) == true, "hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range 101");
}

static void test_446(void)
{
    expect(hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range(0u) == true, "hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range(2u) == false, "hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range 2");
    expect(hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range(99u) == false, "hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range 99");
    expect(hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range(100u) == false, "hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range 100");
    expect(hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range(101u) == true, "hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range 101");
}

static void test_447(void)
{
    expect(hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range(799u) == false, "hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range 799");
    expect(hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range(800u) == false, "hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range 800");
    expect(hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range(801u) == true, "hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range 801");
}

static void test_448(void)
{
    expect(hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range(799u) == false, "hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range 799");
    expect(hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range(800u) == false, "hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range 800");
    expect(hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range(801u) == true, "hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range 801");
}

static void test_449(void)
{
    expect(hiwin_e_par_servo_parameters_reference_torque_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_reference_torque_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_reference_torque_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_reference_torque_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_reference_torque_is_out_of_range(2147483646u) == false, "hiwin_e_par_servo_parameters_reference_torque_is_out_of_range 2147483646");
    expect(hiwin_e_par_servo_parameters_reference_torque_is_out_of_range(2147483647u) == false, "hiwin_e_par_servo_parameters_reference_torque_is_out_of_range 2147483647");
    expect(hiwin_e_par_servo_parameters_reference_torque_is_out_of_range(2147483648u) == true, "hiwin_e_par_servo_parameters_reference_torque_is_out_of_range 2147483648");
}

static void test_450(void)
{
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range(2147483646u) == false, "hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range 2147483646");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range(2147483647u) == false, "hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range 2147483647");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range(2147483648u) == true, "hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range 2147483648");
}

static void test_451(void)
{
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range(2147483646u) == false, "hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range 2147483646");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range(2147483647u) == false, "hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range 2147483647");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range(2147483648u) == true, "hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range 2147483648");
}

static void test_452(void)
{
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range(2147483646u) == false, "hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range 2147483646");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range(2147483647u) == false, "hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range 2147483647");
    expect(hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range(2147483648u) == true, "hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range 2147483648");
}

static void test_453(void)
{
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range(2147483646u) == false, "hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range 2147483646");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range(2147483647u) == false, "hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range 2147483647");
    expect(hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range(2147483648u) == true, "hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range 2147483648");
}

static void test_454(void)
{
    expect(hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range(2147483646u) == false, "hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range 2147483646");
    expect(hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range(2147483647u) == false, "hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range 2147483647");
    expect(hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range(2147483648u) == true, "hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range 2147483648");
}

static void test_455(void)
{
    expect(hiwin_e_par_servo_parameters_reference_force_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_reference_force_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_reference_force_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_reference_force_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_reference_force_is_out_of_range(2147483646u) == false, "hiwin_e_par_servo_parameters_reference_force_is_out_of_range 2147483646");
    expect(hiwin_e_par_servo_parameters_reference_force_is_out_of_range(2147483647u) == false, "hiwin_e_par_servo_parameters_reference_force_is_out_of_range 2147483647");
    expect(hiwin_e_par_servo_parameters_reference_force_is_out_of_range(2147483648u) == true, "hiwin_e_par_servo_parameters_reference_force_is_out_of_range 2147483648");
}

static void test_456(void)
{
    expect(hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range(799u) == false, "hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range 799");
    expect(hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range(800u) == false, "hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range 800");
    expect(hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range(801u) == true, "hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range 801");
}

static void test_457(void)
{
    expect(hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range(0u) == false, "hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range(799u) == false, "hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range 799");
    expect(hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range(800u) == false, "hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range 800");
    expect(hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range(801u) == true, "hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range 801");
}

static void test_458(void)
{
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range(0u) == true, "hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range(2u) == false, "hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range 2");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range(9999u) == false, "hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range 9999");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range(10000u) == false, "hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range 10000");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range(10001u) == true, "hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range 10001");
}

static void test_459(void)
{
    expect(hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range(1u) == true, "hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range(2u) == false, "hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range 2");
    expect(hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range(3u) == false, "hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range 3");
    expect(hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range(9999u) == false, "hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range 9999");
    expect(hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range(10000u) == false, "hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range 10000");
    expect(hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range(10001u) == true, "hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range 10001");
}

static void test_460(void)
{
    expect(hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range(1u) == true, "hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range(2u) == false, "hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range 2");
    expect(hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range(3u) == false, "hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range 3");
    expect(hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range(9999u) == false, "hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range 9999");
    expect(hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range(10000u) == false, "hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range 10000");
    expect(hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range(10001u) == true, "hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range 10001");
}

static void test_461(void)
{
    expect(hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range(1u) == true, "hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range(2u) == false, "hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range 2");
    expect(hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range(3u) == false, "hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range 3");
    expect(hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range(9999u) == false, "hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range 9999");
    expect(hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range(10000u) == false, "hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range 10000");
    expect(hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range(10001u) == true, "hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range 10001");
}

static void test_462(void)
{
    expect(hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range(0) == true, "hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range(1) == false, "hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range(2) == false, "hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range 2");
    expect(hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range(1073741823) == false, "hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range 1073741823");
    expect(hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range(1073741824) == false, "hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range 1073741824");
    expect(hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range(1073741825) == true, "hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range 1073741825");
}

static void test_463(void)
{
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range(0u) == true, "hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range 0");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range(1u) == false, "hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range 1");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range(2u) == false, "hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range 2");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range(9999u) == false, "hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range 9999");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range(10000u) == false, "hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range 10000");
    expect(hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range(10001u) == true, "hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range 10001");
}

unsigned long hiwin_e_selftest(void (*tell)(const char *what))
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
    test_256();
    test_257();
    test_258();
    test_259();
    test_260();
    test_261();
    test_262();
    test_263();
    test_264();
    test_265();
    test_266();
    test_267();
    test_268();
    test_269();
    test_270();
    test_271();
    test_272();
    test_273();
    test_274();
    test_275();
    test_276();
    test_277();
    test_278();
    test_279();
    test_280();
    test_281();
    test_282();
    test_283();
    test_284();
    test_285();
    test_286();
    test_287();
    test_288();
    test_289();
    test_290();
    test_291();
    test_292();
    test_293();
    test_294();
    test_295();
    test_296();
    test_297();
    test_298();
    test_299();
    test_300();
    test_301();
    test_302();
    test_303();
    test_304();
    test_305();
    test_306();
    test_307();
    test_308();
    test_309();
    test_310();
    test_311();
    test_312();
    test_313();
    test_314();
    test_315();
    test_316();
    test_317();
    test_318();
    test_319();
    test_320();
    test_321();
    test_322();
    test_323();
    test_324();
    test_325();
    test_326();
    test_327();
    test_328();
    test_329();
    test_330();
    test_331();
    test_332();
    test_333();
    test_334();
    test_335();
    test_336();
    test_337();
    test_338();
    test_339();
    test_340();
    test_341();
    test_342();
    test_343();
    test_344();
    test_345();
    test_346();
    test_347();
    test_348();
    test_349();
    test_350();
    test_351();
    test_352();
    test_353();
    test_354();
    test_355();
    test_356();
    test_357();
    test_358();
    test_359();
    test_360();
    test_361();
    test_362();
    test_363();
    test_364();
    test_365();
    test_366();
    test_367();
    test_368();
    test_369();
    test_370();
    test_371();
    test_372();
    test_373();
    test_374();
    test_375();
    test_376();
    test_377();
    test_378();
    test_379();
    test_380();
    test_381();
    test_382();
    test_383();
    test_384();
    test_385();
    test_386();
    test_387();
    test_388();
    test_389();
    test_390();
    test_391();
    test_392();
    test_393();
    test_394();
    test_395();
    test_396();
    test_397();
    test_398();
    test_399();
    test_400();
    test_401();
    test_402();
    test_403();
    test_404();
    test_405();
    test_406();
    test_407();
    test_408();
    test_409();
    test_410();
    test_411();
    test_412();
    test_413();
    test_414();
    test_415();
    test_416();
    test_417();
    test_418();
    test_419();
    test_420();
    test_421();
    test_422();
    test_423();
    test_424();
    test_425();
    test_426();
    test_427();
    test_428();
    test_429();
    test_430();
    test_431();
    test_432();
    test_433();
    test_434();
    test_435();
    test_436();
    test_437();
    test_438();
    test_439();
    test_440();
    test_441();
    test_442();
    test_443();
    test_444();
    test_445();
    test_446();
    test_447();
    test_448();
    test_449();
    test_450();
    test_451();
    test_452();
    test_453();
    test_454();
    test_455();
    test_456();
    test_457();
    test_458();
    test_459();
    test_460();
    test_461();
    test_462();
    test_463();
    return failed;
}

#ifdef HOSTED
static void print(const char *what)
{
    printf("failed: %s\n", what);
}

int main(void)
{
    (void)hiwin_e_selftest(print);
    printf("%lu passed, %lu failed\n", passed, failed);
    return failed ? 1 : 0;
}
#endif
