/*
 * E1/E2 PROFINET (HIWIN), version 2.14.4
 * From: E series drives, PROFINET communication, command manual MD02UC01-2507_V1.7
 * Identity: 9bc9d8915a5c154a
 *
 * Generated; do not edit. The constants of hiwin_e_v2_14_4.h, which includes this file: a file that needs no functions compiles faster.
 */
#ifdef HIWIN_E_CONSTANTS_INCLUDED
#ifndef HIWIN_E_VERSION_IS_2_14_4
#error "another version of this device is already included"
#endif
#else
#define HIWIN_E_CONSTANTS_INCLUDED
#define HIWIN_E_VERSION_IS_2_14_4

#if defined(__cplusplus) && __cplusplus < 201103L && !defined(__STDC_CONSTANT_MACROS)
#define __STDC_CONSTANT_MACROS
#endif
#if defined(__cplusplus) && __cplusplus < 201103L && !defined(__STDC_LIMIT_MACROS)
#define __STDC_LIMIT_MACROS
#endif
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define HIWIN_E_VERSION "2.14.4"
#define HIWIN_E_IDENTITY "9bc9d8915a5c154a"

#ifdef __GNUC__
/** An enum has 16 bits, even where the compiler makes enums as short as they can be: a cast of 256 does not become 0. */
#define HIWIN_E_ENUM_16 __attribute__((__mode__(__HI__)))
#else
#define HIWIN_E_ENUM_16
#endif

/* ---- Enums and codes ---- */

/**
 * The alarm codes, which are printed in hexadecimal. The panel shows them behind AL.; `number` is the internal
 * alarm code, which is printed in decimal.
 * Printed as 警報代碼 (十六進制).
 * Other values may occur.
 * Note: The letters b and d are printed small in most codes, as on a display of seven segments, and large in
 * FB0, FB1 and FB2; the values are the same.
 * Note: The internal codes 8 to 10, 13, 21 to 23, 26 to 28, 31, 32, 51, 57, 61, 63 and 64 are left out.
 * Note: Causes and remedies are printed for AL.EE0 alone; for the others see the manuals of the drives.
 * Note: A code for no alarm is not printed.
 * Source: 5.1 L1460-1526
 */
typedef enum hiwin_e_alarm_code {
    HIWIN_E_ALARM_CODE_SYSTEM_ALARM_1 = 0x24, /**< AL.024 系統警報 1 Number 4. */
    HIWIN_E_ALARM_CODE_SYSTEM_ALARM_2 = 0x25, /**< AL.025 系統警報 2 Number 5. */
    HIWIN_E_ALARM_CODE_MAIN_CIRCUIT_FAULT = 0x30, /**< AL.030 主迴路故障 Number 6. */
    HIWIN_E_ALARM_CODE_PARAMETER_SETTING_ERROR = 0x40, /**< AL.040 參數設定錯誤 Number 7. */
    HIWIN_E_ALARM_CODE_COMBINATION_ERROR = 0x50, /**< AL.050 組合錯誤 Number 11. */
    HIWIN_E_ALARM_CODE_MOTOR_CHANGE_DETECTED = 0x70, /**< AL.070 馬達變更檢出 Number 12. */
    HIWIN_E_ALARM_CODE_SERVO_ON_COMMAND_INVALID = 0xB0, /**< AL.0b0 伺服 ON 命令無效警報 Number 14. */
    HIWIN_E_ALARM_CODE_OVERCURRENT = 0x100, /**< AL.100 過電流檢出 Number 15. */
    HIWIN_E_ALARM_CODE_REGENERATIVE_ENERGY_OVERLOAD = 0x320, /**< AL.320 回生能量過載 Number 16. */
    HIWIN_E_ALARM_CODE_OVERVOLTAGE = 0x400, /**< AL.400 過電壓 Number 17. */
    HIWIN_E_ALARM_CODE_UNDERVOLTAGE = 0x410, /**< AL.410 低電壓 Number 18. */
    HIWIN_E_ALARM_CODE_OVERSPEED = 0x510, /**< AL.510 過速度 Number 19. */
    HIWIN_E_ALARM_CODE_ENCODER_PULSE_OUTPUT_OVERSPEED = 0x511, /**< AL.511 編碼器脈波輸出過速 Number 20. */
    HIWIN_E_ALARM_CODE_MOMENTARY_OVERLOAD = 0x710, /**< AL.710 過載 (瞬間最大負載) Number 24. */
    HIWIN_E_ALARM_CODE_CONTINUOUS_OVERLOAD = 0x720, /**< AL.720 過載 (連續最大負載) Number 25. */
    HIWIN_E_ALARM_CODE_DRIVE_OVERLOAD = 0x7A1, /**< AL.7A1 驅動器過載 Number 29. */
    HIWIN_E_ALARM_CODE_POWER_BOARD_TEMPERATURE = 0x7A2, /**< AL.7A2 電源電路板溫度異常 Number 30. */
    HIWIN_E_ALARM_CODE_ENCODER_ABSOLUTE_POSITION_LOST = 0x800, /**< AL.800 編碼器絕對位置遺失 Number 33. */
    HIWIN_E_ALARM_CODE_ENCODER_BATTERY_VOLTAGE_LOW = 0x810, /**< AL.810 編碼器電池電壓過低 Number 34. */
    HIWIN_E_ALARM_CODE_ENCODER_COMMUNICATION_ERROR = 0x820, /**< AL.820 編碼器通訊錯誤 Number 35. */
    HIWIN_E_ALARM_CODE_ENCODER_DATA_ERROR = 0x830, /**< AL.830 編碼器資料錯誤 Number 36. */
    HIWIN_E_ALARM_CODE_ENCODER_COMMUNICATION_CHECK_ERROR = 0x840, /**< AL.840 編碼器通訊校驗錯誤 Number 37. */
    HIWIN_E_ALARM_CODE_ENCODER_COUNTING_ERROR = 0x850, /**< AL.850 編碼器計數錯誤 Number 38. */
    HIWIN_E_ALARM_CODE_ENCODER_WRITE_ERROR = 0x860, /**< AL.860 編碼器資料寫入錯誤 Number 39. */
    HIWIN_E_ALARM_CODE_ENCODER_OVERHEATED = 0x870, /**< AL.870 編碼器過溫 Number 40. */
    HIWIN_E_ALARM_CODE_INCREMENTAL_ENCODER_PHASE_SEQUENCE = 0x880, /**< AL.880 增量式編碼器訊號相序異常 Number 41. */
    HIWIN_E_ALARM_CODE_ADAPTER_INCREMENTAL_ENCODER_DISCONNECTED = 0x890, /**< AL.890 轉接盒增量式編碼器斷線 Number 42. */
    HIWIN_E_ALARM_CODE_ENCODER_1_SIGNAL_AT_ADAPTER = 0x8A0, /**< AL.8A0 第一組編碼器·轉接盒端訊號異常 Number 43. */
    HIWIN_E_ALARM_CODE_ENCODER_1_SIGNAL_AT_ENCODER = 0x8B0, /**< AL.8b0 第一組編碼器·編碼器端訊號異常 Number 44. */
    HIWIN_E_ALARM_CODE_ENCODER_2_SIGNAL_AT_ADAPTER = 0x8C0, /**< AL.8C0 第二組編碼器·轉接盒端訊號異常 Number 45. */
    HIWIN_E_ALARM_CODE_ENCODER_2_SIGNAL_AT_ENCODER = 0x8D0, /**< AL.8d0 第二組編碼器·編碼器端訊號異常 Number 46. */
    HIWIN_E_ALARM_CODE_DIGITAL_ENCODER_DISCONNECTED = 0x8E0, /**< AL.8E0 數位編碼器斷線 Number 47. */
    HIWIN_E_ALARM_CODE_ENCODER_ADAPTER_INTERNAL_ERROR = 0x8F0, /**< AL.8F0 編碼器轉接盒內部異常 Number 48. */
    HIWIN_E_ALARM_CODE_MOTOR_OVERHEATED = 0x861, /**< AL.861 馬達過熱 Number 49. */
    HIWIN_E_ALARM_CODE_SPEED_COMMAND_CONVERTER_ERROR = 0xB10, /**< AL.b10 速度命令 A/D 轉換器異常 Number 50. */
    HIWIN_E_ALARM_CODE_TORQUE_COMMAND_CONVERTER_ERROR = 0xB20, /**< AL.b20 轉矩命令 A/D 轉換器異常 Number 52. */
    HIWIN_E_ALARM_CODE_CURRENT_DETECTION_FAULT = 0xB33, /**< AL.b33 電流檢出故障 Number 53. */
    HIWIN_E_ALARM_CODE_MOTOR_RUNAWAY = 0xC10, /**< AL.C10 馬達失控檢出 Number 54. */
    HIWIN_E_ALARM_CODE_PHASE_DETECTION_ERROR = 0xC20, /**< AL.C20 相位檢出錯誤 Number 55. */
    HIWIN_E_ALARM_CODE_HALL_SENSOR_FAULT = 0xC21, /**< AL.C21 霍爾感測器故障 Number 56. */
    HIWIN_E_ALARM_CODE_ELECTRICAL_ANGLE_DETECTION_FAILED = 0xC50, /**< AL.C50 電機角檢出失敗 Number 58. */
    HIWIN_E_ALARM_CODE_ELECTRICAL_ANGLE_DETECTION_OVERTRAVEL = 0xC51, /**< AL.C51 電機角檢出時超程 Number 59. */
    HIWIN_E_ALARM_CODE_ELECTRICAL_ANGLE_DETECTION_INCOMPLETE = 0xC52, /**< AL.C52 電機角檢出未完成 Number 60. */
    HIWIN_E_ALARM_CODE_POSITION_DEVIATION_TOO_LARGE = 0xD00, /**< AL.d00 位置偏差過大 Number 62. */
    HIWIN_E_ALARM_CODE_LOAD_POSITION_DEVIATION_TOO_LARGE = 0xD10, /**< AL.d10 馬達與負載間位置偏差過大 Number 65. */
    HIWIN_E_ALARM_CODE_SAFETY_FUNCTION_ALARM = 0xEB0, /**< AL.Eb0 安全功能警報 Number 66. */
    HIWIN_E_ALARM_CODE_SAFETY_INPUT_TIMING = 0xEB1, /**< AL.Eb1 安全功能用訊號輸入時間異常 Number 67. */
    HIWIN_E_ALARM_CODE_SAFETY_MODULE_ERROR = 0xEB2, /**< AL.Eb2 安全功能模組異常 Number 68. */
    HIWIN_E_ALARM_CODE_POWER_LINE_PHASE_MISSING = 0xF10, /**< AL.F10 電源線缺相 Number 69. */
    HIWIN_E_ALARM_CODE_MOTOR_LINE_DISCONNECTED = 0xF50, /**< AL.F50 馬達主迴路接線斷線 Number 70. */
    HIWIN_E_ALARM_CODE_ENCODER_SUPPLY_ERROR = 0xFA0, /**< AL.FA0 編碼器電源異常 Number 71. */
    HIWIN_E_ALARM_CODE_FIELDBUS_HARDWARE_FAILURE = 0xFB0, /**< AL.FB0 總線通訊硬體失效 Number 72. */
    HIWIN_E_ALARM_CODE_FIELDBUS_COMMUNICATION_ERROR = 0xFB1, /**< AL.FB1 總線通訊錯誤 Number 73. */
    HIWIN_E_ALARM_CODE_DUAL_AXIS_COMMUNICATION_ERROR = 0xFC0, /**< AL.FC0 雙軸控制系統通訊錯誤 Number 74. */
    HIWIN_E_ALARM_CODE_DUAL_AXIS_SLAVE_ALARM = 0xFC1, /**< AL.FC1 雙軸控制系統從軸警報 Number 75. */
    HIWIN_E_ALARM_CODE_INCREMENTAL_ENCODER_SIGNAL_ERROR = 0x891, /**< AL.891 增量式編碼器訊號異常 Number 76. */
    HIWIN_E_ALARM_CODE_FIELDBUS_SETTING_ERROR = 0xFB2, /**< AL.FB2 總線通訊設定錯誤 Number 77. */
    HIWIN_E_ALARM_CODE_FIXED_STOP_ALARM = 0xEE0, /**< AL.EE0 Fixed stop 應用警報 Number 78. */
    HIWIN_E_ALARM_CODE_ELECTRONIC_CAM_ALARM = 0xFD0, /**< AL.Fd0 電子凸輪控制系統警報 Number 79. */
    HIWIN_E_ALARM_CODE_MULTI_STATION_ALARM = 0xEF9 /**< AL.EF9 多工位功能警報 Number 80. */
} HIWIN_E_ENUM_16 hiwin_e_alarm_code;

/**
 * The same alarms by their internal codes.
 * Printed as 內部警報代碼 (十進制).
 * Other values may occur.
 * Source: 5.1 L1460-1526
 */
typedef enum hiwin_e_internal_alarm_code {
    HIWIN_E_INTERNAL_ALARM_CODE_SYSTEM_ALARM_1 = 4, /**< AL.024 系統警報 1 */
    HIWIN_E_INTERNAL_ALARM_CODE_SYSTEM_ALARM_2 = 5, /**< AL.025 系統警報 2 */
    HIWIN_E_INTERNAL_ALARM_CODE_MAIN_CIRCUIT_FAULT = 6, /**< AL.030 主迴路故障 */
    HIWIN_E_INTERNAL_ALARM_CODE_PARAMETER_SETTING_ERROR = 7, /**< AL.040 參數設定錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_COMBINATION_ERROR = 11, /**< AL.050 組合錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_MOTOR_CHANGE_DETECTED = 12, /**< AL.070 馬達變更檢出 */
    HIWIN_E_INTERNAL_ALARM_CODE_SERVO_ON_COMMAND_INVALID = 14, /**< AL.0b0 伺服 ON 命令無效警報 */
    HIWIN_E_INTERNAL_ALARM_CODE_OVERCURRENT = 15, /**< AL.100 過電流檢出 */
    HIWIN_E_INTERNAL_ALARM_CODE_REGENERATIVE_ENERGY_OVERLOAD = 16, /**< AL.320 回生能量過載 */
    HIWIN_E_INTERNAL_ALARM_CODE_OVERVOLTAGE = 17, /**< AL.400 過電壓 */
    HIWIN_E_INTERNAL_ALARM_CODE_UNDERVOLTAGE = 18, /**< AL.410 低電壓 */
    HIWIN_E_INTERNAL_ALARM_CODE_OVERSPEED = 19, /**< AL.510 過速度 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_PULSE_OUTPUT_OVERSPEED = 20, /**< AL.511 編碼器脈波輸出過速 */
    HIWIN_E_INTERNAL_ALARM_CODE_MOMENTARY_OVERLOAD = 24, /**< AL.710 過載 (瞬間最大負載) */
    HIWIN_E_INTERNAL_ALARM_CODE_CONTINUOUS_OVERLOAD = 25, /**< AL.720 過載 (連續最大負載) */
    HIWIN_E_INTERNAL_ALARM_CODE_DRIVE_OVERLOAD = 29, /**< AL.7A1 驅動器過載 */
    HIWIN_E_INTERNAL_ALARM_CODE_POWER_BOARD_TEMPERATURE = 30, /**< AL.7A2 電源電路板溫度異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_ABSOLUTE_POSITION_LOST = 33, /**< AL.800 編碼器絕對位置遺失 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_BATTERY_VOLTAGE_LOW = 34, /**< AL.810 編碼器電池電壓過低 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_COMMUNICATION_ERROR = 35, /**< AL.820 編碼器通訊錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_DATA_ERROR = 36, /**< AL.830 編碼器資料錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_COMMUNICATION_CHECK_ERROR = 37, /**< AL.840 編碼器通訊校驗錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_COUNTING_ERROR = 38, /**< AL.850 編碼器計數錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_WRITE_ERROR = 39, /**< AL.860 編碼器資料寫入錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_OVERHEATED = 40, /**< AL.870 編碼器過溫 */
    HIWIN_E_INTERNAL_ALARM_CODE_INCREMENTAL_ENCODER_PHASE_SEQUENCE = 41, /**< AL.880 增量式編碼器訊號相序異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_ADAPTER_INCREMENTAL_ENCODER_DISCONNECTED = 42, /**< AL.890 轉接盒增量式編碼器斷線 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_1_SIGNAL_AT_ADAPTER = 43, /**< AL.8A0 第一組編碼器·轉接盒端訊號異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_1_SIGNAL_AT_ENCODER = 44, /**< AL.8b0 第一組編碼器·編碼器端訊號異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_2_SIGNAL_AT_ADAPTER = 45, /**< AL.8C0 第二組編碼器·轉接盒端訊號異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_2_SIGNAL_AT_ENCODER = 46, /**< AL.8d0 第二組編碼器·編碼器端訊號異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_DIGITAL_ENCODER_DISCONNECTED = 47, /**< AL.8E0 數位編碼器斷線 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_ADAPTER_INTERNAL_ERROR = 48, /**< AL.8F0 編碼器轉接盒內部異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_MOTOR_OVERHEATED = 49, /**< AL.861 馬達過熱 */
    HIWIN_E_INTERNAL_ALARM_CODE_SPEED_COMMAND_CONVERTER_ERROR = 50, /**< AL.b10 速度命令 A/D 轉換器異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_TORQUE_COMMAND_CONVERTER_ERROR = 52, /**< AL.b20 轉矩命令 A/D 轉換器異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_CURRENT_DETECTION_FAULT = 53, /**< AL.b33 電流檢出故障 */
    HIWIN_E_INTERNAL_ALARM_CODE_MOTOR_RUNAWAY = 54, /**< AL.C10 馬達失控檢出 */
    HIWIN_E_INTERNAL_ALARM_CODE_PHASE_DETECTION_ERROR = 55, /**< AL.C20 相位檢出錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_HALL_SENSOR_FAULT = 56, /**< AL.C21 霍爾感測器故障 */
    HIWIN_E_INTERNAL_ALARM_CODE_ELECTRICAL_ANGLE_DETECTION_FAILED = 58, /**< AL.C50 電機角檢出失敗 */
    HIWIN_E_INTERNAL_ALARM_CODE_ELECTRICAL_ANGLE_DETECTION_OVERTRAVEL = 59, /**< AL.C51 電機角檢出時超程 */
    HIWIN_E_INTERNAL_ALARM_CODE_ELECTRICAL_ANGLE_DETECTION_INCOMPLETE = 60, /**< AL.C52 電機角檢出未完成 */
    HIWIN_E_INTERNAL_ALARM_CODE_POSITION_DEVIATION_TOO_LARGE = 62, /**< AL.d00 位置偏差過大 */
    HIWIN_E_INTERNAL_ALARM_CODE_LOAD_POSITION_DEVIATION_TOO_LARGE = 65, /**< AL.d10 馬達與負載間位置偏差過大 */
    HIWIN_E_INTERNAL_ALARM_CODE_SAFETY_FUNCTION_ALARM = 66, /**< AL.Eb0 安全功能警報 */
    HIWIN_E_INTERNAL_ALARM_CODE_SAFETY_INPUT_TIMING = 67, /**< AL.Eb1 安全功能用訊號輸入時間異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_SAFETY_MODULE_ERROR = 68, /**< AL.Eb2 安全功能模組異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_POWER_LINE_PHASE_MISSING = 69, /**< AL.F10 電源線缺相 */
    HIWIN_E_INTERNAL_ALARM_CODE_MOTOR_LINE_DISCONNECTED = 70, /**< AL.F50 馬達主迴路接線斷線 */
    HIWIN_E_INTERNAL_ALARM_CODE_ENCODER_SUPPLY_ERROR = 71, /**< AL.FA0 編碼器電源異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_FIELDBUS_HARDWARE_FAILURE = 72, /**< AL.FB0 總線通訊硬體失效 */
    HIWIN_E_INTERNAL_ALARM_CODE_FIELDBUS_COMMUNICATION_ERROR = 73, /**< AL.FB1 總線通訊錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_DUAL_AXIS_COMMUNICATION_ERROR = 74, /**< AL.FC0 雙軸控制系統通訊錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_DUAL_AXIS_SLAVE_ALARM = 75, /**< AL.FC1 雙軸控制系統從軸警報 */
    HIWIN_E_INTERNAL_ALARM_CODE_INCREMENTAL_ENCODER_SIGNAL_ERROR = 76, /**< AL.891 增量式編碼器訊號異常 */
    HIWIN_E_INTERNAL_ALARM_CODE_FIELDBUS_SETTING_ERROR = 77, /**< AL.FB2 總線通訊設定錯誤 */
    HIWIN_E_INTERNAL_ALARM_CODE_FIXED_STOP_ALARM = 78, /**< AL.EE0 Fixed stop 應用警報 */
    HIWIN_E_INTERNAL_ALARM_CODE_ELECTRONIC_CAM_ALARM = 79, /**< AL.Fd0 電子凸輪控制系統警報 */
    HIWIN_E_INTERNAL_ALARM_CODE_MULTI_STATION_ALARM = 80 /**< AL.EF9 多工位功能警報 */
} HIWIN_E_ENUM_16 hiwin_e_internal_alarm_code;

/**
 * How the values of a request or a response lie on the wire.
 * Printed as 格式.
 * Source: 4.3.5 L1411
 */
typedef enum hiwin_e_parameter_format {
    HIWIN_E_PARAMETER_FORMAT_BOOLEAN = 1, /**< Boolean */
    HIWIN_E_PARAMETER_FORMAT_INTEGER_8 = 2, /**< int8 */
    HIWIN_E_PARAMETER_FORMAT_INTEGER_16 = 3, /**< int16 */
    HIWIN_E_PARAMETER_FORMAT_INTEGER_32 = 4, /**< int32 */
    HIWIN_E_PARAMETER_FORMAT_UNSIGNED_8 = 5, /**< UInt8 */
    HIWIN_E_PARAMETER_FORMAT_UNSIGNED_16 = 6, /**< UInt16 */
    HIWIN_E_PARAMETER_FORMAT_UNSIGNED_32 = 7, /**< UInt32 */
    HIWIN_E_PARAMETER_FORMAT_FLOATING_POINT_32 = 8, /**< Float point 32 */
    HIWIN_E_PARAMETER_FORMAT_BYTE = 65, /**< Byte Eight bits, as unsigned_8. */
    HIWIN_E_PARAMETER_FORMAT_WORD = 66, /**< Word 16 bits, as unsigned_16. */
    HIWIN_E_PARAMETER_FORMAT_DOUBLE_WORD = 67, /**< Double word 32 bits, as unsigned_32. */
    HIWIN_E_PARAMETER_FORMAT_ERROR = 68 /**< Error Not a value but an error number; only in the reply to a refused request. */
} HIWIN_E_ENUM_16 hiwin_e_parameter_format;

/**
 * Printed as 參數回應的錯誤號碼.
 * Other values may occur.
 * Note: 24h to FFh are printed as reserved too. The number has two bytes on the wire; nothing is printed
 * beyond FFh.
 * Note: As the drive takes one parameter per request, the errors of requests for several parameters (22h, 23h)
 * show that a request was built wrongly.
 * Source: 4.3.6 L1413-1451
 */
typedef enum hiwin_e_parameter_error_number {
    HIWIN_E_PARAMETER_ERROR_NUMBER_PARAMETER_NUMBER_NOT_ALLOWED = 0, /**< 不允許的參數號碼 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_VALUE_NOT_CHANGEABLE = 1, /**< 不可改變參數值 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_LIMIT_EXCEEDED = 2, /**< 超過最低或最高限制 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_WRONG_SUBINDEX = 3, /**< 錯誤的子索引 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_NO_ARRAY = 4, /**< 無陣列 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_WRONG_DATA_TYPE = 5, /**< 不正確的資料型態 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_SETTING_NOT_ALLOWED = 6, /**< 不被允許的設定 (可能只能重置) */
    HIWIN_E_PARAMETER_ERROR_NUMBER_DESCRIPTION_NOT_CHANGEABLE = 7, /**< 不可改變描述元素 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_DESCRIPTION_NOT_AVAILABLE = 9, /**< 無法取得的描述資料 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_NO_PRIORITY = 11, /**< 無優先存取權 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_TEXT_ARRAY_NOT_AVAILABLE = 15, /**< 無法取得的文字陣列 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_OPERATING_STATE_PREVENTS_ACCESS = 17, /**< 因運轉狀態而無法執行請求 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_VALUE_NOT_ALLOWED = 20, /**< 不允許的值 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_RESPONSE_TOO_LONG = 21, /**< 回應太長 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_PARAMETER_ADDRESS_NOT_ALLOWED = 22, /**< 不允許的參數位址 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_WRONG_FORMAT = 23, /**< 非法的格式 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_VALUE_COUNT_INCONSISTENT = 24, /**< 值數量不一致 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_AXIS_MISSING = 25, /**< 不存在的軸 / DO */
    HIWIN_E_PARAMETER_ERROR_NUMBER_TEXT_NOT_CHANGEABLE = 32, /**< 不可改變參數文字元素 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_SERVICE_NOT_SUPPORTED = 33, /**< 不支援此服務 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_TOO_MANY_PARAMETERS = 34, /**< 太多參數請求 */
    HIWIN_E_PARAMETER_ERROR_NUMBER_SEVERAL_PARAMETERS_NOT_SUPPORTED = 35 /**< 不支援多參數存取 */
} HIWIN_E_ENUM_16 hiwin_e_parameter_error_number;

/** Source: 4.2 L959 */
typedef enum hiwin_e_motor_type {
    HIWIN_E_MOTOR_TYPE_LINEAR = 0, /**< LM 線性馬達 */
    HIWIN_E_MOTOR_TYPE_DIRECT_DRIVE = 1, /**< DM / TM 直驅馬達 / 力矩馬達 Direct drive motor or torque motor. */
    HIWIN_E_MOTOR_TYPE_ROTARY_SERVO = 2 /**< AC 伺服馬達 */
} HIWIN_E_ENUM_16 hiwin_e_motor_type;

/** Source: 4.2 L986 */
typedef enum hiwin_e_gantry_application_mode {
    HIWIN_E_GANTRY_APPLICATION_MODE_START = 1, /**< 啟動龍門控制系統 Starts the gantry control. */
    HIWIN_E_GANTRY_APPLICATION_MODE_STOP = 2, /**< 解除龍門控制系統 Ends the gantry control. */
    HIWIN_E_GANTRY_APPLICATION_MODE_CALIBRATE_YAW_AXIS = 11 /**< 執行旋轉軸校正 Calibrates the yaw axis. */
} HIWIN_E_ENUM_16 hiwin_e_gantry_application_mode;

/**
 * 0001h to 0080h are commands; 1000h and 2000h are results.
 * Other values may occur.
 * Source: 4.2 L1026-1033
 */
typedef enum hiwin_e_position_trigger_array_control {
    HIWIN_E_POSITION_TRIGGER_ARRAY_CONTROL_WRITE_POSITION = 1, /**< Command: writes the value in 3069h to the element 306Ah of the array of positions. The index is at most 255. */
    HIWIN_E_POSITION_TRIGGER_ARRAY_CONTROL_CLEAR_POSITIONS = 8, /**< Command: sets the whole array of positions to 0. */
    HIWIN_E_POSITION_TRIGGER_ARRAY_CONTROL_WRITE_STATE = 16, /**< Command: writes the value in 3069h to the element 306Ah of the array of states. The index is at most 7. */
    HIWIN_E_POSITION_TRIGGER_ARRAY_CONTROL_CLEAR_STATES = 128, /**< Command: sets the whole array of states to 0. */
    HIWIN_E_POSITION_TRIGGER_ARRAY_CONTROL_SUCCEEDED = 4096, /**< 寫入成功 Result: written. */
    HIWIN_E_POSITION_TRIGGER_ARRAY_CONTROL_FAILED = 8192 /**< 寫入失敗 Result: not written; 306Ch says why. */
} HIWIN_E_ENUM_16 hiwin_e_position_trigger_array_control;

/**
 * Other values may occur.
 * Source: 4.2 L1051-1059
 */
typedef enum hiwin_e_position_trigger_status {
    HIWIN_E_POSITION_TRIGGER_STATUS_INACTIVE = 0, /**< 位置觸發功能未啟動 */
    HIWIN_E_POSITION_TRIGGER_STATUS_EQUAL_DISTANCES_DESCENDING = 3, /**< 等間距位置觸發功能執行中 (觸發方向：位置遞減) Triggers at equal distances while the position falls. */
    HIWIN_E_POSITION_TRIGGER_STATUS_EQUAL_DISTANCES_ASCENDING = 4, /**< 等間距位置觸發功能執行中 (觸發方向：位置遞增) Triggers at equal distances while the position rises. */
    HIWIN_E_POSITION_TRIGGER_STATUS_ARRAY_DESCENDING = 13, /**< 非等間距位置觸發功能執行中 (觸發方向：索引值遞減) Triggers at the positions of the array while the index falls. */
    HIWIN_E_POSITION_TRIGGER_STATUS_ARRAY_ASCENDING = 14, /**< 非等間距位置觸發功能執行中 (觸發方向：索引值遞增) Triggers at the positions of the array while the index rises. */
    HIWIN_E_POSITION_TRIGGER_STATUS_WAITING_FOR_FIRST_POSITION = 20, /**< 等待回到第一個設定的觸發位置 Waits until the motor is back at the first position; only when repetition is on (Pt012 = t.□□□1). */
    HIWIN_E_POSITION_TRIGGER_STATUS_DISABLED = 99 /**< 位置觸發功能無效 The position trigger is switched off (Pt00E = t.□□□0). */
} HIWIN_E_ENUM_16 hiwin_e_position_trigger_status;

/**
 * Other values may occur.
 * Note: The column with the registers is one cell for the types 1 to 7 (3085h, 3086h), one for the type 8
 * (3087h, 3088h) and one for -1 to -3 (none), as 3085h to 3088h say of themselves; in the text of the manual
 * the cells stand beside other rows.
 * Source: 4.2 L1071-1074, 1077-1085
 */
typedef enum hiwin_e_gantry_parameter_type {
    HIWIN_E_GANTRY_PARAMETER_TYPE_SUBINDEX_MISSING = (-3), /**< There is no such sub-index. */
    HIWIN_E_GANTRY_PARAMETER_TYPE_PARAMETER_MISSING = (-2), /**< There is no such parameter. */
    HIWIN_E_GANTRY_PARAMETER_TYPE_NOT_ACCESSIBLE = (-1), /**< This parameter cannot be accessed so. */
    HIWIN_E_GANTRY_PARAMETER_TYPE_BOOLEAN = 1, /**< BOOL */
    HIWIN_E_GANTRY_PARAMETER_TYPE_INTEGER_8 = 2, /**< I8 */
    HIWIN_E_GANTRY_PARAMETER_TYPE_INTEGER_16 = 3, /**< I16 */
    HIWIN_E_GANTRY_PARAMETER_TYPE_INTEGER_32 = 4, /**< I32 */
    HIWIN_E_GANTRY_PARAMETER_TYPE_UNSIGNED_8 = 5, /**< U8 */
    HIWIN_E_GANTRY_PARAMETER_TYPE_UNSIGNED_16 = 6, /**< U16 */
    HIWIN_E_GANTRY_PARAMETER_TYPE_UNSIGNED_32 = 7, /**< U32 */
    HIWIN_E_GANTRY_PARAMETER_TYPE_FLOATING_POINT_32 = 8 /**< F32 Read and written through 3087h and 3088h. */
} HIWIN_E_ENUM_16 hiwin_e_gantry_parameter_type;

/**
 * Note: The commands 1 and 2 act when the value changes from 0 to them; while 3084h says that data are being
 * processed they are lost.
 * Source: 4.2 L1088-1094
 */
typedef enum hiwin_e_gantry_parameter_command {
    HIWIN_E_GANTRY_PARAMETER_COMMAND_IDLE = 0, /**< 閒置 / 復歸狀態 */
    HIWIN_E_GANTRY_PARAMETER_COMMAND_WRITE = 1, /**< 寫入命令 Writes the value in the input register. */
    HIWIN_E_GANTRY_PARAMETER_COMMAND_READ_ONCE = 2, /**< 單次讀取命令 Reads the value into the output register. */
    HIWIN_E_GANTRY_PARAMETER_COMMAND_READ_CONTINUOUSLY = 3 /**< 持續讀取命令 Reads the value again and again, in no fixed cycle. */
} HIWIN_E_ENUM_16 hiwin_e_gantry_parameter_command;

/** Source: 4.2 L1096-1107 */
typedef enum hiwin_e_gantry_parameter_status {
    HIWIN_E_GANTRY_PARAMETER_STATUS_TIMEOUT = (-6), /**< 資料處理超時 The access took too long. */
    HIWIN_E_GANTRY_PARAMETER_STATUS_COMMAND_NOT_SUPPORTED = (-5), /**< 3083h holds a command that does not exist. */
    HIWIN_E_GANTRY_PARAMETER_STATUS_READ_ONLY = (-4), /**< A parameter that can only be read was to be written. */
    HIWIN_E_GANTRY_PARAMETER_STATUS_VALUE_TOO_LARGE = (-3), /**< The value in the input register exceeds what the parameter's type can hold. */
    HIWIN_E_GANTRY_PARAMETER_STATUS_NOT_ACCESSIBLE = (-2), /**< The parameter that 3080h names cannot be accessed so. */
    HIWIN_E_GANTRY_PARAMETER_STATUS_NOT_AVAILABLE = (-1), /**< The gantry is not running, or its two drives have different firmware. */
    HIWIN_E_GANTRY_PARAMETER_STATUS_IDLE = 0, /**< 未操作狀態 */
    HIWIN_E_GANTRY_PARAMETER_STATUS_PROCESSING = 1, /**< 資料處理中 */
    HIWIN_E_GANTRY_PARAMETER_STATUS_SUCCEEDED = 2 /**< 資料處理成功 */
} HIWIN_E_ENUM_16 hiwin_e_gantry_parameter_status;

/** Source: 4.2 L1168-1175 */
typedef enum hiwin_e_absolute_encoder_initialization {
    HIWIN_E_ABSOLUTE_ENCODER_INITIALIZATION_IDLE = 0, /**< 未操作狀態 */
    HIWIN_E_ABSOLUTE_ENCODER_INITIALIZATION_START = 1, /**< 發送清除多圈數據命令 Command to clear the turns. */
    HIWIN_E_ABSOLUTE_ENCODER_INITIALIZATION_CLEARING = 2, /**< 清除多圈數據命令正在執行中 */
    HIWIN_E_ABSOLUTE_ENCODER_INITIALIZATION_SUCCEEDED = 4, /**< 清除多圈數據命令執行成功 */
    HIWIN_E_ABSOLUTE_ENCODER_INITIALIZATION_MOTOR_EXCITED = 16, /**< Refused because the motor is excited; switch it off and try again. */
    HIWIN_E_ABSOLUTE_ENCODER_INITIALIZATION_FAILED = 32 /**< 清除多圈數據命令執行失敗 */
} HIWIN_E_ENUM_16 hiwin_e_absolute_encoder_initialization;

/** Source: 4.2 L1208-1213 */
typedef enum hiwin_e_drive_reset {
    HIWIN_E_DRIVE_RESET_FAILED = (-1), /**< 重置失敗 The reset failed: do the drives of the gantry communicate, and have they the same firmware? */
    HIWIN_E_DRIVE_RESET_IDLE = 0, /**< 未操作狀態 */
    HIWIN_E_DRIVE_RESET_RESET = 1, /**< 重置驅動器 Resets the drive. */
    HIWIN_E_DRIVE_RESET_RESET_GANTRY = 2 /**< 重置龍門雙軸驅動器 Resets both drives of the gantry. */
} HIWIN_E_ENUM_16 hiwin_e_drive_reset;

/** Source: 4.2 L1217 */
typedef enum hiwin_e_parameter_save {
    HIWIN_E_PARAMETER_SAVE_IDLE = 0, /**< Nothing to do, or done. */
    HIWIN_E_PARAMETER_SAVE_SAVE = 1 /**< Store the parameters. */
} HIWIN_E_ENUM_16 hiwin_e_parameter_save;

/** Source: 4.2 L1219 */
typedef enum hiwin_e_mastership {
    HIWIN_E_MASTERSHIP_THUNDER = 0, /**< 設定給Thunder使用 The configuration software. */
    HIWIN_E_MASTERSHIP_HOST_CONTROLLER = 1 /**< 設定給上位控制器使用 The controller on the network. */
} HIWIN_E_ENUM_16 hiwin_e_mastership;

/**
 * Printed as 運轉模式.
 * Source: 4.1 L915
 */
typedef enum hiwin_e_operating_mode {
    HIWIN_E_OPERATING_MODE_SPEED_WITH_RAMP_GENERATOR = 1, /**< 有RFG功能的速度模式 Speed mode whose setpoint goes through a ramp function generator (RFG). */
    HIWIN_E_OPERATING_MODE_POSITION = 2, /**< 位置模式 */
    HIWIN_E_OPERATING_MODE_SPEED_WITHOUT_RAMP_GENERATOR = 3 /**< 無RFG功能的速度模式 Speed mode without a ramp function generator. */
} HIWIN_E_ENUM_16 hiwin_e_operating_mode;

/**
 * Note: The first one is the default.
 * Source: 6.5 L1632-1635
 */
typedef enum hiwin_e_coast_stop_method {
    HIWIN_E_COAST_STOP_METHOD_DYNAMIC_BRAKE = 0, /**< t.□□□0 動態制動器 Stops by the dynamic brake, and stays braked. */
    HIWIN_E_COAST_STOP_METHOD_DYNAMIC_BRAKE_THEN_FREE = 1, /**< t.□□□1 Stops by the dynamic brake, and runs free then. */
    HIWIN_E_COAST_STOP_METHOD_FREE_RUN = 2 /**< t.□□□2 Free run Runs out freely. */
} HIWIN_E_ENUM_16 hiwin_e_coast_stop_method;

/**
 * Other values may occur.
 * Note: Causes and remedies are printed for AL.980 alone, in parameter 3120h. AL.980 has no bit in 3110h and
 * 3111h.
 * Source: 4.2 L1119-1153, 1155
 */
typedef enum hiwin_e_warning_code {
    HIWIN_E_WARNING_CODE_POSITION_DEVIATION_TOO_LARGE = 0x900, /**< AL.900 位置偏差過大 */
    HIWIN_E_WARNING_CODE_OVERLOAD = 0x910, /**< AL.910 過載 */
    HIWIN_E_WARNING_CODE_INTERNAL_FAN_STOPPED = 0x923, /**< AL.923 內部風扇停止運轉 */
    HIWIN_E_WARNING_CODE_I2T = 0x924, /**< AL.924 I²T The square of the current over time is too large. */
    HIWIN_E_WARNING_CODE_ENCODER_BATTERY_FAULT = 0x930, /**< AL.930 編碼器電池故障警告 */
    HIWIN_E_WARNING_CODE_RESTART_REQUIRED = 0x941, /**< AL.941 變更了需儲存並重新接通電源才可生效的參數或功能 Something was changed that must be stored and takes effect after power has been off and on. */
    HIWIN_E_WARNING_CODE_FIELDBUS_SYNCHRONIZATION_TIME = 0x943, /**< AL.943 總線通訊同步時間警告 */
    HIWIN_E_WARNING_CODE_SYSTEM_WARNING = 0x944, /**< AL.944 系統警告 */
    HIWIN_E_WARNING_CODE_TORQUE_LIMIT = 0x945, /**< AL.945 轉矩限制警告 */
    HIWIN_E_WARNING_CODE_ENCODER_COMMUNICATION = 0x946, /**< AL.946 編碼器通訊警告 */
    HIWIN_E_WARNING_CODE_MULTI_STATION_FUNCTION_DISABLED = 0x947, /**< AL.947 多工位功能失效警告 */
    HIWIN_E_WARNING_CODE_UNDERVOLTAGE = 0x971, /**< AL.971 低電壓 */
    HIWIN_E_WARNING_CODE_OPERATION = 0x980, /**< AL.980 */
    HIWIN_E_WARNING_CODE_OVERTRAVEL_SERVO_ON = 0x9A0, /**< AL.9A0 超程 (伺服ON時檢出任一超程訊號) An overtravel signal while the servo is on. */
    HIWIN_E_WARNING_CODE_POSITIVE_OVERTRAVEL_SERVO_OFF = 0x9A1, /**< AL.9A1 超程 (伺服OFF時檢出P-OT訊號) The signal P-OT while the servo is off. */
    HIWIN_E_WARNING_CODE_NEGATIVE_OVERTRAVEL_SERVO_OFF = 0x9A2, /**< AL.9A2 超程 (伺服OFF時檢出N-OT訊號) The signal N-OT while the servo is off. */
    HIWIN_E_WARNING_CODE_OVERVOLTAGE = 0x9F0 /**< AL.9F0 伺服電壓過高 */
} HIWIN_E_ENUM_16 hiwin_e_warning_code;

/**
 * Other values may occur.
 * Note: The values 4 to 7 are printed as reserved.
 * Source: 3.7 L737
 */
typedef enum hiwin_e_encoder_command {
    HIWIN_E_ENCODER_COMMAND_NONE = 0, /**< 無功能 */
    HIWIN_E_ENCODER_COMMAND_ACTIVATE = 1, /**< 啟用功能 */
    HIWIN_E_ENCODER_COMMAND_READ = 2, /**< 讀值 */
    HIWIN_E_ENCODER_COMMAND_CANCEL = 3 /**< 取消功能 */
} HIWIN_E_ENUM_16 hiwin_e_encoder_command;

/**
 * The direction in the setup mode, and the path to an absolute position in the positioning mode.
 * Source: 3.12 L806-809
 */
typedef enum hiwin_e_positioning_path {
    HIWIN_E_POSITIONING_PATH_SHORTEST = 0, /**< 最短距離絕對定位 / MDI 調整模式靜止 Positioning: the shorter way; of two equal ones the positive one. Setup mode: standstill. */
    HIWIN_E_POSITIONING_PATH_POSITIVE = 1, /**< 絕對定位 / MDI 調整模式的方向選擇，正方向 In the positive direction. */
    HIWIN_E_POSITIONING_PATH_NEGATIVE = 2, /**< 絕對定位 / MDI 調整模式的方向選擇，負方向 In the negative direction. */
    HIWIN_E_POSITIONING_PATH_SHORTEST_WITH_BOTH_BITS = 3 /**< The same as 0. */
} HIWIN_E_ENUM_16 hiwin_e_positioning_path;

/* ---- Bit fields ---- */

/**
 * Parameter 3044h. A bit switches its output on; 0 leaves it to the output's own condition.
 * A word of 16 bits.
 * Source: 6.10 L1766-1772
 */
typedef uint16_t hiwin_e_digital_output_control;

/**
 * Printed as O1.
 * 0: on while its condition holds. 1: always on.
 * Source: 6.10 L1770-1772
 */
#define HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_1_MASK 0x0001u
#define HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_1_SHIFT 0u

/**
 * Printed as O2.
 * 0: on while its condition holds. 1: always on.
 * Source: 6.10 L1770-1772
 */
#define HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_2_MASK 0x0002u
#define HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_2_SHIFT 1u

/**
 * Printed as O3.
 * 0: on while its condition holds. 1: always on.
 * Source: 6.10 L1770-1772
 */
#define HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_3_MASK 0x0004u
#define HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_3_SHIFT 2u

/**
 * Printed as O4.
 * 0: on while its condition holds. 1: always on.
 * Source: 6.10 L1770-1772
 */
#define HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_4_MASK 0x0008u
#define HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_4_SHIFT 3u

/**
 * Printed as O5.
 * 0: on while its condition holds. 1: always on.
 * Source: 6.10 L1770-1772
 */
#define HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_5_MASK 0x0010u
#define HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_5_SHIFT 4u

/**
 * Parameter 4005h. Whether current flows at the pins for a signal that is on depends on the polarity that is
 * set for the output.
 * A word of 16 bits.
 * Source: 6.10 L1774-1781
 */
typedef uint16_t hiwin_e_digital_output_states;

/**
 * Pins CN6-11/12.
 * Printed as O1.
 * 0: off. 1: on.
 * Source: 6.10 L1778-1781
 */
#define HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_1_MASK 0x0001u
#define HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_1_SHIFT 0u

/**
 * Pins CN6-13/14.
 * Printed as O2.
 * 0: off. 1: on.
 * Source: 6.10 L1778-1781
 */
#define HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_2_MASK 0x0002u
#define HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_2_SHIFT 1u

/**
 * Pins CN6-15/16.
 * Printed as O3.
 * 0: off. 1: on.
 * Source: 6.10 L1778-1781
 */
#define HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_3_MASK 0x0004u
#define HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_3_SHIFT 2u

/**
 * Pins CN6-17/18.
 * Printed as O4.
 * 0: off. 1: on.
 * Source: 6.10 L1778-1781
 */
#define HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_4_MASK 0x0008u
#define HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_4_SHIFT 3u

/**
 * Pins CN6-19/20.
 * Printed as O5.
 * 0: off. 1: on.
 * Source: 6.10 L1778-1781
 */
#define HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_5_MASK 0x0010u
#define HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_5_SHIFT 4u

/**
 * Printed as Software state[12] 軟體狀態表.
 * A word of 16 bits.
 * Source: 4.2 L964-982
 */
typedef uint16_t hiwin_e_software_state;

/**
 * Printed as 歸原點狀態.
 * 0: not homing. 1: homing.
 * Source: 4.2 L970
 */
#define HIWIN_E_SOFTWARE_STATE_HOMING_MASK 0x0008u
#define HIWIN_E_SOFTWARE_STATE_HOMING_SHIFT 3u

/**
 * Printed as 位置觸發功能狀態.
 * 0: position trigger not started. 1: position trigger started.
 * Source: 4.2 L971
 */
#define HIWIN_E_SOFTWARE_STATE_POSITION_TRIGGER_ACTIVE_MASK 0x0010u
#define HIWIN_E_SOFTWARE_STATE_POSITION_TRIGGER_ACTIVE_SHIFT 4u

/**
 * Printed as 龍門控制系統通訊狀態.
 * 0: the gantry's axes do not communicate. 1: they communicate.
 * Source: 4.2 L972
 */
#define HIWIN_E_SOFTWARE_STATE_GANTRY_COMMUNICATING_MASK 0x0020u
#define HIWIN_E_SOFTWARE_STATE_GANTRY_COMMUNICATING_SHIFT 5u

/**
 * Printed as 龍門旋轉軸馬達通電狀態.
 * 0: no current in the motor of the yaw axis. 1: current in it.
 * Source: 4.2 L973
 */
#define HIWIN_E_SOFTWARE_STATE_YAW_MOTOR_ENERGIZED_MASK 0x0040u
#define HIWIN_E_SOFTWARE_STATE_YAW_MOTOR_ENERGIZED_SHIFT 6u

/**
 * Printed as 龍門旋轉軸警報狀態.
 * 0: no alarm of the yaw axis. 1: alarm.
 * Source: 4.2 L974
 */
#define HIWIN_E_SOFTWARE_STATE_YAW_ALARM_MASK 0x0080u
#define HIWIN_E_SOFTWARE_STATE_YAW_ALARM_SHIFT 7u

/**
 * Printed as 龍門控制系統啟動狀態.
 * 0: gantry control not started. 1: started.
 * Source: 4.2 L975
 */
#define HIWIN_E_SOFTWARE_STATE_GANTRY_ACTIVE_MASK 0x0100u
#define HIWIN_E_SOFTWARE_STATE_GANTRY_ACTIVE_SHIFT 8u

/**
 * Printed as 龍門旋轉軸歸原點狀態.
 * 0: homing of the yaw axis not completed. 1: completed.
 * Source: 4.2 L976
 */
#define HIWIN_E_SOFTWARE_STATE_YAW_HOMED_MASK 0x0200u
#define HIWIN_E_SOFTWARE_STATE_YAW_HOMED_SHIFT 9u

/**
 * Printed as 龍門旋轉軸近原點開關狀態.
 * 0: the yaw axis is outside of the near home switch. 1: within it.
 * Source: 4.2 L977
 */
#define HIWIN_E_SOFTWARE_STATE_YAW_NEAR_HOME_MASK 0x0400u
#define HIWIN_E_SOFTWARE_STATE_YAW_NEAR_HOME_SHIFT 10u

/**
 * Printed as 龍門旋轉軸校正狀態.
 * 0: calibration of the yaw axis not completed. 1: completed.
 * Source: 4.2 L978
 */
#define HIWIN_E_SOFTWARE_STATE_YAW_CALIBRATED_MASK 0x0800u
#define HIWIN_E_SOFTWARE_STATE_YAW_CALIBRATED_SHIFT 11u

/**
 * Printed as 龍門旋轉軸到位狀態.
 * 0: the yaw axis is not in position. 1: in position.
 * Source: 4.2 L979
 */
#define HIWIN_E_SOFTWARE_STATE_YAW_IN_POSITION_MASK 0x1000u
#define HIWIN_E_SOFTWARE_STATE_YAW_IN_POSITION_SHIFT 12u

/**
 * Printed as 龍門旋轉軸就緒狀態.
 * 0: the drive of the yaw axis is not ready. 1: it is ready and STO is not triggered.
 * Source: 4.2 L980
 */
#define HIWIN_E_SOFTWARE_STATE_YAW_READY_MASK 0x2000u
#define HIWIN_E_SOFTWARE_STATE_YAW_READY_SHIFT 13u

/**
 * Functions that start at a reference mark.
 * A word of 16 bits.
 * Source: 4.2 L996-1002
 */
typedef uint16_t hiwin_e_reference_mark_functions;

/**
 * Printed as 誤差補償表.
 * 0: not started by the reference mark. 1: started by it.
 * Source: 4.2 L999
 */
#define HIWIN_E_REFERENCE_MARK_FUNCTIONS_ERROR_COMPENSATION_TABLE_MASK 0x0001u
#define HIWIN_E_REFERENCE_MARK_FUNCTIONS_ERROR_COMPENSATION_TABLE_SHIFT 0u

/**
 * Printed as 位置觸發功能.
 * 0: not started by the reference mark. 1: started by it.
 * Note: Pt00E = t.1□□□ must be set before.
 * Source: 4.2 L1000
 */
#define HIWIN_E_REFERENCE_MARK_FUNCTIONS_POSITION_TRIGGER_MASK 0x0002u
#define HIWIN_E_REFERENCE_MARK_FUNCTIONS_POSITION_TRIGGER_SHIFT 1u

/**
 * Bits 0 to 2: why an array could not be written. Bits 8 to 11: why the position trigger could not be started.
 * Printed as Position trigger function error code.
 * A word of 16 bits.
 * Source: 4.2 L1034-1040, 1043-1049
 */
typedef uint16_t hiwin_e_position_trigger_error;

/**
 * The arrays cannot be written in the mode of equal distances.
 * Printed as 等間距PT模式不支援位置觸發陣列的寫入.
 * Source: 4.2 L1038
 */
#define HIWIN_E_POSITION_TRIGGER_ERROR_MODE_WITHOUT_ARRAYS_MASK 0x0001u
#define HIWIN_E_POSITION_TRIGGER_ERROR_MODE_WITHOUT_ARRAYS_SHIFT 0u

/**
 * The index in 306Ah is wrong.
 * Printed as 錯誤的陣列索引值.
 * Source: 4.2 L1039
 */
#define HIWIN_E_POSITION_TRIGGER_ERROR_WRONG_ARRAY_INDEX_MASK 0x0002u
#define HIWIN_E_POSITION_TRIGGER_ERROR_WRONG_ARRAY_INDEX_SHIFT 1u

/**
 * 306Bh was given a command that does not exist.
 * Printed as 未定義的命令.
 * Source: 4.2 L1040
 */
#define HIWIN_E_POSITION_TRIGGER_ERROR_UNDEFINED_COMMAND_MASK 0x0004u
#define HIWIN_E_POSITION_TRIGGER_ERROR_UNDEFINED_COMMAND_SHIFT 2u

/**
 * The position trigger does not work with this encoder.
 * Printed as 編碼器不支援位置觸發功能.
 * Source: 4.2 L1045
 */
#define HIWIN_E_POSITION_TRIGGER_ERROR_ENCODER_NOT_SUPPORTED_MASK 0x0100u
#define HIWIN_E_POSITION_TRIGGER_ERROR_ENCODER_NOT_SUPPORTED_SHIFT 8u

/**
 * The drive has not been homed.
 * Printed as 未執行歸原點.
 * Source: 4.2 L1046
 */
#define HIWIN_E_POSITION_TRIGGER_ERROR_NOT_HOMED_MASK 0x0200u
#define HIWIN_E_POSITION_TRIGGER_ERROR_NOT_HOMED_SHIFT 9u

/**
 * Pt00E, or one of Pt230 to Pt232, is wrong.
 * Printed as Pt00E或Pt230~Pt232參數設定錯誤.
 * Source: 4.2 L1047
 */
#define HIWIN_E_POSITION_TRIGGER_ERROR_WRONG_PARAMETER_MASK 0x0400u
#define HIWIN_E_POSITION_TRIGGER_ERROR_WRONG_PARAMETER_SHIFT 10u

/**
 * The motor is beyond the end position in Pt232.
 * Printed as 馬達當前位置超過Pt232設定的終點位置.
 * When the mode of equal distances (Pt00E = t.□□1□).
 * Source: 4.2 L1048
 */
#define HIWIN_E_POSITION_TRIGGER_ERROR_END_POSITION_PASSED_MASK 0x0800u
#define HIWIN_E_POSITION_TRIGGER_ERROR_END_POSITION_PASSED_SHIFT 11u

/**
 * Printed as Pt001.
 * A word of 16 bits.
 * Source: 6.5 L1630-1635
 */
typedef uint16_t hiwin_e_basic_function_switch_1;

/**
 * Printed as t.□□□X.
 * See coast_stop_method.
 * Source: 6.5 L1630, 1633-1635
 */
#define HIWIN_E_BASIC_FUNCTION_SWITCH_1_COAST_STOP_METHOD_MASK 0x000Fu
#define HIWIN_E_BASIC_FUNCTION_SWITCH_1_COAST_STOP_METHOD_SHIFT 0u

/**
 * A bit is 1 while its warning is present. The same warnings have codes in warning_code.
 * Printed as Drive warning events 1 警告狀態表1.
 * A word of 16 bits.
 * Source: 4.2 L1119-1120, 1123-1139
 */
typedef uint16_t hiwin_e_drive_warnings_1;

/**
 * Printed as AL.900 位置偏差過大.
 * Source: 4.2 L1123
 */
#define HIWIN_E_DRIVE_WARNINGS_1_POSITION_DEVIATION_TOO_LARGE_MASK 0x0001u
#define HIWIN_E_DRIVE_WARNINGS_1_POSITION_DEVIATION_TOO_LARGE_SHIFT 0u

/**
 * Printed as AL.910 過載.
 * Source: 4.2 L1125
 */
#define HIWIN_E_DRIVE_WARNINGS_1_OVERLOAD_MASK 0x0004u
#define HIWIN_E_DRIVE_WARNINGS_1_OVERLOAD_SHIFT 2u

/**
 * Printed as AL.923 內部風扇停止運轉.
 * Source: 4.2 L1130
 */
#define HIWIN_E_DRIVE_WARNINGS_1_INTERNAL_FAN_STOPPED_MASK 0x0080u
#define HIWIN_E_DRIVE_WARNINGS_1_INTERNAL_FAN_STOPPED_SHIFT 7u

/**
 * Printed as AL.930 編碼器電池故障警告.
 * Source: 4.2 L1131
 */
#define HIWIN_E_DRIVE_WARNINGS_1_ENCODER_BATTERY_FAULT_MASK 0x0100u
#define HIWIN_E_DRIVE_WARNINGS_1_ENCODER_BATTERY_FAULT_SHIFT 8u

/**
 * Printed as AL.941 變更了需儲存並重新接通電源才可生效的參數或功能.
 * Source: 4.2 L1132
 */
#define HIWIN_E_DRIVE_WARNINGS_1_RESTART_REQUIRED_MASK 0x0200u
#define HIWIN_E_DRIVE_WARNINGS_1_RESTART_REQUIRED_SHIFT 9u

/**
 * Printed as AL.971 低電壓.
 * Source: 4.2 L1133
 */
#define HIWIN_E_DRIVE_WARNINGS_1_UNDERVOLTAGE_MASK 0x0400u
#define HIWIN_E_DRIVE_WARNINGS_1_UNDERVOLTAGE_SHIFT 10u

/**
 * Printed as AL.9A0 超程 (伺服ON時檢出任一超程訊號).
 * Source: 4.2 L1134
 */
#define HIWIN_E_DRIVE_WARNINGS_1_OVERTRAVEL_SERVO_ON_MASK 0x0800u
#define HIWIN_E_DRIVE_WARNINGS_1_OVERTRAVEL_SERVO_ON_SHIFT 11u

/**
 * Printed as AL.9A1 超程 (伺服OFF時檢出P-OT訊號).
 * Source: 4.2 L1135
 */
#define HIWIN_E_DRIVE_WARNINGS_1_POSITIVE_OVERTRAVEL_SERVO_OFF_MASK 0x1000u
#define HIWIN_E_DRIVE_WARNINGS_1_POSITIVE_OVERTRAVEL_SERVO_OFF_SHIFT 12u

/**
 * Printed as AL.9A2 超程 (伺服OFF時檢出N-OT訊號).
 * Source: 4.2 L1136
 */
#define HIWIN_E_DRIVE_WARNINGS_1_NEGATIVE_OVERTRAVEL_SERVO_OFF_MASK 0x2000u
#define HIWIN_E_DRIVE_WARNINGS_1_NEGATIVE_OVERTRAVEL_SERVO_OFF_SHIFT 13u

/**
 * A bit is 1 while its warning is present. The same warnings have codes in warning_code.
 * Printed as Drive warning events 2 警告狀態表2.
 * A word of 16 bits.
 * Note: The bits are not in the order of the numbers.
 * Source: 4.2 L1140-1141, 1144-1147, 1150-1153
 */
typedef uint16_t hiwin_e_drive_warnings_2;

/**
 * Printed as AL.9F0 伺服電壓過高.
 * Source: 4.2 L1144
 */
#define HIWIN_E_DRIVE_WARNINGS_2_OVERVOLTAGE_MASK 0x0001u
#define HIWIN_E_DRIVE_WARNINGS_2_OVERVOLTAGE_SHIFT 0u

/**
 * Printed as AL.943 總線通訊同步時間警告.
 * Source: 4.2 L1145
 */
#define HIWIN_E_DRIVE_WARNINGS_2_FIELDBUS_SYNCHRONIZATION_TIME_MASK 0x0002u
#define HIWIN_E_DRIVE_WARNINGS_2_FIELDBUS_SYNCHRONIZATION_TIME_SHIFT 1u

/**
 * Printed as AL.944 系統警告.
 * Source: 4.2 L1146
 */
#define HIWIN_E_DRIVE_WARNINGS_2_SYSTEM_WARNING_MASK 0x0004u
#define HIWIN_E_DRIVE_WARNINGS_2_SYSTEM_WARNING_SHIFT 2u

/**
 * Printed as AL.945 轉矩限制警告.
 * Source: 4.2 L1147
 */
#define HIWIN_E_DRIVE_WARNINGS_2_TORQUE_LIMIT_MASK 0x0008u
#define HIWIN_E_DRIVE_WARNINGS_2_TORQUE_LIMIT_SHIFT 3u

/**
 * Printed as AL.946 編碼器通訊警告.
 * Source: 4.2 L1150
 */
#define HIWIN_E_DRIVE_WARNINGS_2_ENCODER_COMMUNICATION_MASK 0x0010u
#define HIWIN_E_DRIVE_WARNINGS_2_ENCODER_COMMUNICATION_SHIFT 4u

/**
 * Printed as AL.947 多工位功能失效警告.
 * Source: 4.2 L1151
 */
#define HIWIN_E_DRIVE_WARNINGS_2_MULTI_STATION_FUNCTION_DISABLED_MASK 0x0020u
#define HIWIN_E_DRIVE_WARNINGS_2_MULTI_STATION_FUNCTION_DISABLED_SHIFT 5u

/**
 * Printed as AL.924 I²T.
 * Source: 4.2 L1152
 */
#define HIWIN_E_DRIVE_WARNINGS_2_I2T_MASK 0x0040u
#define HIWIN_E_DRIVE_WARNINGS_2_I2T_SHIFT 6u

/**
 * Why the drive has the warning AL.980. A bit is 1 while its reason holds.
 * Printed as Host controller's operation warning events.
 * A word of 32 bits.
 * Source: 4.2 L1154-1166
 */
typedef uint32_t hiwin_e_operation_warnings;

/**
 * A relative movement was refused. Remedy: send a valid command, or end the traversing task.
 * Printed as 運動命令無效，相對定位已被拒絕.
 * Source: 4.2 L1158
 */
#define HIWIN_E_OPERATION_WARNINGS_RELATIVE_MOVE_REJECTED_MASK 0x00000040u
#define HIWIN_E_OPERATION_WARNINGS_RELATIVE_MOVE_REJECTED_SHIFT 6u

/**
 * An absolute movement was refused. Remedy: send a valid command, or end the traversing task.
 * Printed as 運動命令無效，絕對定位已被拒絕.
 * Source: 4.2 L1159
 */
#define HIWIN_E_OPERATION_WARNINGS_ABSOLUTE_MOVE_REJECTED_MASK 0x00000080u
#define HIWIN_E_OPERATION_WARNINGS_ABSOLUTE_MOVE_REJECTED_SHIFT 7u

/**
 * The lower limit of the position range is above 0. Remedy: set Pt25C within -2147483648 to 0.
 * Printed as 位置範圍的下限大於0.
 * Source: 4.2 L1161
 */
#define HIWIN_E_OPERATION_WARNINGS_LOWER_LIMIT_POSITIVE_MASK 0x00001000u
#define HIWIN_E_OPERATION_WARNINGS_LOWER_LIMIT_POSITIVE_SHIFT 12u

/**
 * The upper limit of the position range is below 0. Remedy: set Pt25B within 0 to 2147483647.
 * Printed as 位置範圍的上限小於0.
 * Source: 4.2 L1162
 */
#define HIWIN_E_OPERATION_WARNINGS_UPPER_LIMIT_NEGATIVE_MASK 0x00002000u
#define HIWIN_E_OPERATION_WARNINGS_UPPER_LIMIT_NEGATIVE_SHIFT 13u

/**
 * The position range is too large. Remedy: keep Pt25B less Pt25C at 7FFFFFFFh or below.
 * Printed as 位置範圍超過容許值.
 * Source: 4.2 L1163
 */
#define HIWIN_E_OPERATION_WARNINGS_RANGE_TOO_LARGE_MASK 0x00004000u
#define HIWIN_E_OPERATION_WARNINGS_RANGE_TOO_LARGE_SHIFT 14u

/**
 * The position range is in use and cannot be changed. Remedy: set Pt25B or Pt25C back to what it was, or
 * switch the motor off.
 * Printed as 位置範圍運作鎖定中.
 * Source: 4.2 L1164
 */
#define HIWIN_E_OPERATION_WARNINGS_RANGE_LOCKED_MASK 0x00008000u
#define HIWIN_E_OPERATION_WARNINGS_RANGE_LOCKED_SHIFT 15u

/**
 * Switches the drive on and off. For telegrams 3, 5, 102 and 105.
 * Printed as STW1 Control word 1.
 * A word of 16 bits.
 * Source: 3.3.1 L577-596
 */
typedef uint16_t hiwin_e_control_word_1;

/**
 * Printed as ON.
 * 0: Switch off.. 1: Switch on..
 * Note: How the motor stops when it is switched off by this bit is not printed here.
 * Source: 3.3.1 L584
 */
#define HIWIN_E_CONTROL_WORD_1_ON_MASK 0x0001u
#define HIWIN_E_CONTROL_WORD_1_ON_SHIFT 0u

/**
 * How a coast stop ends is set in Pt001 (6.5).
 * Printed as No OFF2 解除 Coast stop.
 * 0: Coast stop (OFF2).. 1: No coast stop..
 * Source: 3.3.1 L585
 */
#define HIWIN_E_CONTROL_WORD_1_NO_OFF2_MASK 0x0002u
#define HIWIN_E_CONTROL_WORD_1_NO_OFF2_SHIFT 1u

/**
 * How long a quick stop takes is set in Pt30A in speed mode and in Pt538 in position mode (6.4).
 * Printed as No OFF3 解除 Quick stop.
 * 0: Quick stop (OFF3).. 1: No quick stop..
 * Source: 3.3.1 L586
 */
#define HIWIN_E_CONTROL_WORD_1_NO_OFF3_MASK 0x0004u
#define HIWIN_E_CONTROL_WORD_1_NO_OFF3_SHIFT 2u

/**
 * Printed as Enable operation 啟動運轉.
 * 0: End operation.. 1: Start operation..
 * Source: 3.3.1 L587
 */
#define HIWIN_E_CONTROL_WORD_1_ENABLE_OPERATION_MASK 0x0008u
#define HIWIN_E_CONTROL_WORD_1_ENABLE_OPERATION_SHIFT 3u

/**
 * Resets an alarm.
 * Printed as 警報已確認.
 * It acts on its rising edge.
 * Source: 3.3.1 L591
 */
#define HIWIN_E_CONTROL_WORD_1_ACKNOWLEDGE_ALARM_MASK 0x0080u
#define HIWIN_E_CONTROL_WORD_1_ACKNOWLEDGE_ALARM_SHIFT 7u

/**
 * Printed as 由 PLC 控制.
 * 0: The drive is controlled from its own side.. 1: The PLC controls the drive..
 * Source: 3.3.1 L594
 */
#define HIWIN_E_CONTROL_WORD_1_CONTROL_BY_PLC_MASK 0x0400u
#define HIWIN_E_CONTROL_WORD_1_CONTROL_BY_PLC_SHIFT 10u

/**
 * Switches the drive on and off and starts movements. For telegrams 9 and 111.
 * Printed as STW1 Control word 1.
 * A word of 16 bits.
 * Source: 3.3.2 L598-615; 3.3 L577
 */
typedef uint16_t hiwin_e_control_word_1_positioning;

/**
 * Printed as ON.
 * 0: Switch off.. 1: Switch on..
 * Note: How the motor stops when it is switched off by this bit is not printed here.
 * Source: 3.3.2 L603
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_ON_MASK 0x0001u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_ON_SHIFT 0u

/**
 * How a coast stop ends is set in Pt001 (6.5).
 * Printed as No OFF2 解除 Coast stop.
 * 0: Coast stop (OFF2).. 1: No coast stop..
 * Source: 3.3.2 L604
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_OFF2_MASK 0x0002u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_OFF2_SHIFT 1u

/**
 * How long a quick stop takes is set in Pt538 (6.4).
 * Printed as No OFF3 解除 Quick stop.
 * 0: Quick stop (OFF3).. 1: No quick stop..
 * Source: 3.3.2 L605
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_OFF3_MASK 0x0004u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_OFF3_SHIFT 2u

/**
 * Printed as Enable operation 啟動運轉.
 * 0: End operation.. 1: Start operation..
 * Source: 3.3.2 L606
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_ENABLE_OPERATION_MASK 0x0008u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_ENABLE_OPERATION_SHIFT 3u

/**
 * Printed as 啟用 Traversing Task.
 * 0: The traversing task is ended.. 1: Traversing tasks may run..
 * Source: 3.3.2 L607
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_ENABLE_TRAVERSING_TASK_MASK 0x0010u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_ENABLE_TRAVERSING_TASK_SHIFT 4u

/**
 * Printed as 解除中途停止.
 * 0: Intermediate stop.. 1: No intermediate stop..
 * Source: 3.3.2 L608
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_INTERMEDIATE_STOP_MASK 0x0020u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_INTERMEDIATE_STOP_SHIFT 5u

/**
 * Starts a traversing task.
 * It acts on its rising edge.
 * Note: Not needed while POS_STW1.12, continuous transfer, is 1 (3.12 L822).
 * Source: 3.3.2 L609
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_START_TRAVERSING_TASK_MASK 0x0040u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_START_TRAVERSING_TASK_SHIFT 6u

/**
 * Resets an alarm.
 * Printed as 警報已確認.
 * It acts on its rising edge.
 * Source: 3.3.2 L610
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_ACKNOWLEDGE_ALARM_MASK 0x0080u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_ACKNOWLEDGE_ALARM_SHIFT 7u

/**
 * Printed as JOG 1 JOG 1 ON (正方向吋動).
 * 0: No jog 1.. 1: Jog in the positive direction..
 * Note: Pt53A = 1 turns the direction round (L619).
 * Source: 3.3.2 L611
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_JOG_1_MASK 0x0100u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_JOG_1_SHIFT 8u

/**
 * Printed as JOG 2 JOG 2 ON (負方向吋動).
 * 0: No jog 2.. 1: Jog in the negative direction..
 * Note: Pt53A = 1 turns the direction round (L619).
 * Source: 3.3.2 L612
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_JOG_2_MASK 0x0200u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_JOG_2_SHIFT 9u

/**
 * Printed as 由 PLC 控制.
 * 0: The drive is controlled from its own side.. 1: The PLC controls the drive..
 * Source: 3.3.2 L613
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_CONTROL_BY_PLC_MASK 0x0400u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_CONTROL_BY_PLC_SHIFT 10u

/**
 * Printed as 開始歸原點程序.
 * 0: Stop homing.. 1: Start homing..
 * Source: 3.3.2 L614
 */
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_START_HOMING_MASK 0x0800u
#define HIWIN_E_CONTROL_WORD_1_POSITIONING_START_HOMING_SHIFT 11u

/**
 * The sign of life of the controller. For telegrams 3, 5 and 9.
 * Printed as STW2 Control word 2.
 * A word of 16 bits.
 * Source: 3.4.1 L628-634; 3.4 L626
 */
typedef uint16_t hiwin_e_control_word_2;

/**
 * A counter by which the drive sees that the controller is alive.
 * Printed as 控制器 Sign-of-Life.
 * Note: The steps and the range of the counter are not printed. Parameter 925 says how often it may fail.
 * Source: 3.4.1 L634
 */
#define HIWIN_E_CONTROL_WORD_2_SIGN_OF_LIFE_MASK 0xF000u
#define HIWIN_E_CONTROL_WORD_2_SIGN_OF_LIFE_SHIFT 12u

/**
 * The sign of life of the controller, and the command to traverse to a fixed stop. For telegrams 102, 105 and
 * 111.
 * Printed as STW2 Control word 2.
 * A word of 16 bits.
 * Source: 3.4.2 L636-644; 3.4 L626
 */
typedef uint16_t hiwin_e_control_word_2_fixed_stop;

/**
 * Printed as 啟用 Traverse to fixed stop.
 * 1: Traverse to a fixed stop..
 * Note: 6.12, which names the firmware, is about telegram 111 and does not speak of 102 and 105.
 * Note: While it is 1 the torque limits of telegram 750 do not count; MOMRED does instead (6.11.2 L1860),
 * which telegram 111 does not have.
 * Source: 3.4.2 L642
 */
#define HIWIN_E_CONTROL_WORD_2_FIXED_STOP_TRAVERSE_TO_FIXED_STOP_MASK 0x0100u
#define HIWIN_E_CONTROL_WORD_2_FIXED_STOP_TRAVERSE_TO_FIXED_STOP_SHIFT 8u

/**
 * A counter by which the drive sees that the controller is alive.
 * Printed as 控制器 Sign-of-Life.
 * Note: The steps and the range of the counter are not printed. Parameter 925 says how often it may fail.
 * Source: 3.4.2 L644
 */
#define HIWIN_E_CONTROL_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK 0xF000u
#define HIWIN_E_CONTROL_WORD_2_FIXED_STOP_SIGN_OF_LIFE_SHIFT 12u

/**
 * The state of the drive. For telegrams 3, 5, 102 and 105.
 * Printed as ZSW1 Status word 1.
 * A word of 16 bits.
 * Source: 3.5.1 L648-665; 3.5 L646
 */
typedef uint16_t hiwin_e_status_word_1;

/**
 * Printed as Ready to switch on Ready to switch on 狀態.
 * 0: Not ready to be switched on.. 1: Ready to be switched on..
 * Source: 3.5.1 L653
 */
#define HIWIN_E_STATUS_WORD_1_READY_TO_SWITCH_ON_MASK 0x0001u
#define HIWIN_E_STATUS_WORD_1_READY_TO_SWITCH_ON_SHIFT 0u

/**
 * Printed as Ready to operation Ready to operation 狀態.
 * 0: Not ready to operate.. 1: Ready to operate..
 * Source: 3.5.1 L654
 */
#define HIWIN_E_STATUS_WORD_1_READY_TO_OPERATE_MASK 0x0002u
#define HIWIN_E_STATUS_WORD_1_READY_TO_OPERATE_SHIFT 1u

/**
 * Printed as Operation enable Operation enable 狀態.
 * 0: Operation is disabled.. 1: Operation is enabled..
 * Source: 3.5.1 L655
 */
#define HIWIN_E_STATUS_WORD_1_OPERATION_ENABLED_MASK 0x0004u
#define HIWIN_E_STATUS_WORD_1_OPERATION_ENABLED_SHIFT 2u

/**
 * Printed as 有警報.
 * 0: There is no alarm.. 1: There is an alarm..
 * Source: 3.5.1 L656
 */
#define HIWIN_E_STATUS_WORD_1_ALARM_MASK 0x0008u
#define HIWIN_E_STATUS_WORD_1_ALARM_SHIFT 3u

/**
 * Printed as No OFF2 Coast stop 無作動.
 * 0: A coast stop acts (OFF2).. 1: No coast stop acts..
 * Source: 3.5.1 L657
 */
#define HIWIN_E_STATUS_WORD_1_NO_OFF2_MASK 0x0010u
#define HIWIN_E_STATUS_WORD_1_NO_OFF2_SHIFT 4u

/**
 * Printed as No OFF3 Quick stop 無作動.
 * 0: A quick stop acts (OFF3).. 1: No quick stop acts..
 * Source: 3.5.1 L658
 */
#define HIWIN_E_STATUS_WORD_1_NO_OFF3_MASK 0x0020u
#define HIWIN_E_STATUS_WORD_1_NO_OFF3_SHIFT 5u

/**
 * Printed as Switch on inhibited Switch on inhibited 狀態.
 * 0: The drive can be switched on.. 1: The drive cannot be switched on..
 * Source: 3.5.1 L659
 */
#define HIWIN_E_STATUS_WORD_1_SWITCHING_ON_INHIBITED_MASK 0x0040u
#define HIWIN_E_STATUS_WORD_1_SWITCHING_ON_INHIBITED_SHIFT 6u

/**
 * Printed as 有警告.
 * 0: There is no warning.. 1: There is a warning..
 * Source: 3.5.1 L660
 */
#define HIWIN_E_STATUS_WORD_1_WARNING_MASK 0x0080u
#define HIWIN_E_STATUS_WORD_1_WARNING_SHIFT 7u

/**
 * Printed as 速度偏差在容許範圍內.
 * 0: The speed deviation is too large.. 1: The speed deviation is within its tolerance..
 * Source: 3.5.1 L661
 */
#define HIWIN_E_STATUS_WORD_1_SPEED_WITHIN_TOLERANCE_MASK 0x0100u
#define HIWIN_E_STATUS_WORD_1_SPEED_WITHIN_TOLERANCE_SHIFT 8u

/**
 * PROFIdrive calls the bit control requested.
 * Printed as 允許控制器控制.
 * 0: The controller may not control the drive.. 1: The controller may control the drive..
 * Source: 3.5.1 L662
 */
#define HIWIN_E_STATUS_WORD_1_CONTROL_REQUESTED_MASK 0x0200u
#define HIWIN_E_STATUS_WORD_1_CONTROL_REQUESTED_SHIFT 9u

/**
 * Printed as 已達到命令速度.
 * 0: The commanded speed is not reached.. 1: The commanded speed is reached..
 * Source: 3.5.1 L663
 */
#define HIWIN_E_STATUS_WORD_1_SPEED_REACHED_MASK 0x0400u
#define HIWIN_E_STATUS_WORD_1_SPEED_REACHED_SHIFT 10u

/**
 * Printed as S1 Switching On Inhibited.
 * Source: 7.2.3 L2053
 */
#define HIWIN_E_STATUS_WORD_1_STATE_SWITCHING_ON_INHIBITED_MASK 0x0047u
#define HIWIN_E_STATUS_WORD_1_STATE_SWITCHING_ON_INHIBITED_VALUE 0x0040u
/**
 * Printed as S2 Ready For Switching On.
 * Source: 7.2.3 L2054
 */
#define HIWIN_E_STATUS_WORD_1_STATE_READY_FOR_SWITCHING_ON_MASK 0x0047u
#define HIWIN_E_STATUS_WORD_1_STATE_READY_FOR_SWITCHING_ON_VALUE 0x0001u
/**
 * Printed as S3 Switched On.
 * Source: 7.2.3 L2055
 */
#define HIWIN_E_STATUS_WORD_1_STATE_SWITCHED_ON_MASK 0x0047u
#define HIWIN_E_STATUS_WORD_1_STATE_SWITCHED_ON_VALUE 0x0003u
/**
 * Printed as S4 Operation.
 * Source: 7.2.3 L2056
 */
#define HIWIN_E_STATUS_WORD_1_STATE_OPERATION_MASK 0x0047u
#define HIWIN_E_STATUS_WORD_1_STATE_OPERATION_VALUE 0x0007u
/** The states that the word can show. */
typedef enum hiwin_e_status_word_1_state {
    HIWIN_E_STATUS_WORD_1_NO_STATE = 0,
    HIWIN_E_STATUS_WORD_1_STATE_SWITCHING_ON_INHIBITED = 1,
    HIWIN_E_STATUS_WORD_1_STATE_READY_FOR_SWITCHING_ON = 2,
    HIWIN_E_STATUS_WORD_1_STATE_SWITCHED_ON = 3,
    HIWIN_E_STATUS_WORD_1_STATE_OPERATION = 4
} hiwin_e_status_word_1_state;

/**
 * The state of the drive and of its movements. For telegrams 9 and 111.
 * Printed as ZSW1 Status word 1.
 * A word of 16 bits.
 * Source: 3.5.2 L667-686; 3.5 L646
 */
typedef uint16_t hiwin_e_status_word_1_positioning;

/**
 * Printed as Ready to switch on Ready to switch on 狀態.
 * 0: Not ready to be switched on.. 1: Ready to be switched on..
 * Source: 3.5.2 L672
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_READY_TO_SWITCH_ON_MASK 0x0001u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_READY_TO_SWITCH_ON_SHIFT 0u

/**
 * Printed as Ready to operation Ready to operation 狀態.
 * 0: Not ready to operate.. 1: Ready to operate..
 * Source: 3.5.2 L673
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_READY_TO_OPERATE_MASK 0x0002u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_READY_TO_OPERATE_SHIFT 1u

/**
 * Printed as Operation enable Operation enable 狀態.
 * 0: Operation is disabled.. 1: Operation is enabled..
 * Source: 3.5.2 L674
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_OPERATION_ENABLED_MASK 0x0004u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_OPERATION_ENABLED_SHIFT 2u

/**
 * Printed as 有警報.
 * 0: There is no alarm.. 1: There is an alarm..
 * Source: 3.5.2 L675
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_ALARM_MASK 0x0008u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_ALARM_SHIFT 3u

/**
 * Printed as No OFF2 Coast stop 無作動.
 * 0: A coast stop acts (OFF2).. 1: No coast stop acts..
 * Source: 3.5.2 L676
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_NO_OFF2_MASK 0x0010u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_NO_OFF2_SHIFT 4u

/**
 * Printed as No OFF3 Quick stop 無作動.
 * 0: A quick stop acts (OFF3).. 1: No quick stop acts..
 * Source: 3.5.2 L677
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_NO_OFF3_MASK 0x0020u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_NO_OFF3_SHIFT 5u

/**
 * Printed as Switch on inhibited Switch on inhibited 狀態.
 * 0: The drive can be switched on.. 1: The drive cannot be switched on..
 * Source: 3.5.2 L678
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_SWITCHING_ON_INHIBITED_MASK 0x0040u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_SWITCHING_ON_INHIBITED_SHIFT 6u

/**
 * Printed as 有警告.
 * 0: There is no warning.. 1: There is a warning..
 * Source: 3.5.2 L679
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_WARNING_MASK 0x0080u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_WARNING_SHIFT 7u

/**
 * Printed as 位置偏差在容許範圍內.
 * 0: The position deviation is too large.. 1: The position deviation is within its tolerance..
 * Source: 3.5.2 L680
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_POSITION_WITHIN_TOLERANCE_MASK 0x0100u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_POSITION_WITHIN_TOLERANCE_SHIFT 8u

/**
 * PROFIdrive calls the bit control requested.
 * Printed as 允許控制器控制.
 * 0: The controller may not control the drive.. 1: The controller may control the drive..
 * Source: 3.5.2 L681
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_CONTROL_REQUESTED_MASK 0x0200u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_CONTROL_REQUESTED_SHIFT 9u

/**
 * Printed as 已到達目標位置.
 * 0: The target position is not reached.. 1: The target position is reached..
 * Source: 3.5.2 L682
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_TARGET_REACHED_MASK 0x0400u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_TARGET_REACHED_SHIFT 10u

/**
 * Printed as 歸原點完成.
 * 0: Homing is not completed yet.. 1: Homing is completed..
 * Note: Absolute positioning is refused while it is 0 (3.12 L820).
 * Source: 3.5.2 L683
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_HOMING_COMPLETE_MASK 0x0800u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_HOMING_COMPLETE_SHIFT 11u

/**
 * The rising edge tells the controller that its traversing task was taken.
 * Printed as Traversing task 已確認.
 * It acts on its rising edge.
 * Source: 3.5.2 L684
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_TRAVERSING_TASK_ACKNOWLEDGED_MASK 0x1000u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_TRAVERSING_TASK_ACKNOWLEDGED_SHIFT 12u

/**
 * Printed as 馬達已停止.
 * 0: The motor moves.. 1: The motor stands still..
 * Source: 3.5.2 L685
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_MOTOR_STOPPED_MASK 0x2000u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_MOTOR_STOPPED_SHIFT 13u

/**
 * Printed as S1 Switching On Inhibited.
 * Source: 7.2.3 L2053
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHING_ON_INHIBITED_MASK 0x0047u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHING_ON_INHIBITED_VALUE 0x0040u
/**
 * Printed as S2 Ready For Switching On.
 * Source: 7.2.3 L2054
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_READY_FOR_SWITCHING_ON_MASK 0x0047u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_READY_FOR_SWITCHING_ON_VALUE 0x0001u
/**
 * Printed as S3 Switched On.
 * Source: 7.2.3 L2055
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHED_ON_MASK 0x0047u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHED_ON_VALUE 0x0003u
/**
 * Printed as S4 Operation.
 * Source: 7.2.3 L2056
 */
#define HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_OPERATION_MASK 0x0047u
#define HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_OPERATION_VALUE 0x0007u
/** The states that the word can show. */
typedef enum hiwin_e_status_word_1_positioning_state {
    HIWIN_E_STATUS_WORD_1_POSITIONING_NO_STATE = 0,
    HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHING_ON_INHIBITED = 1,
    HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_READY_FOR_SWITCHING_ON = 2,
    HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHED_ON = 3,
    HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_OPERATION = 4
} hiwin_e_status_word_1_positioning_state;

/**
 * The sign of life of the drive. For telegrams 3 and 5.
 * Printed as ZSW2 Status word 2.
 * A word of 16 bits.
 * Source: 3.6.1 L690-696; 3.6 L688
 */
typedef uint16_t hiwin_e_status_word_2;

/**
 * A counter by which the controller sees that the drive is alive.
 * Printed as 驅動器 Sign-of-Life.
 * Note: The steps and the range of the counter are not printed.
 * Source: 3.6.1 L696
 */
#define HIWIN_E_STATUS_WORD_2_SIGN_OF_LIFE_MASK 0xF000u
#define HIWIN_E_STATUS_WORD_2_SIGN_OF_LIFE_SHIFT 12u

/**
 * The sign of life of the drive, and whether pulses are enabled. For telegram 9.
 * Printed as ZSW2 Status word 2.
 * A word of 16 bits.
 * Source: 3.6.2 L698-705; 3.6 L688
 */
typedef uint16_t hiwin_e_status_word_2_pulse_command;

/**
 * Printed as 脈波命令啟用.
 * 0: Pulses are disabled.. 1: Pulses are enabled..
 * Note: The manual speaks of pulse commands, of which there are none on PROFINET. PROFIdrive has the pulses of
 * the power stage in this bit.
 * Source: 3.6.2 L704
 */
#define HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_PULSES_ENABLED_MASK 0x0800u
#define HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_PULSES_ENABLED_SHIFT 11u

/**
 * A counter by which the controller sees that the drive is alive.
 * Printed as 驅動器 Sign-of-Life.
 * Note: The steps and the range of the counter are not printed.
 * Source: 3.6.2 L705
 */
#define HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_SIGN_OF_LIFE_MASK 0xF000u
#define HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_SIGN_OF_LIFE_SHIFT 12u

/**
 * The sign of life of the drive, and whether it traverses to a fixed stop. For telegrams 102 and 105.
 * Printed as ZSW2 Status word 2.
 * A word of 16 bits.
 * Source: 3.6.3 L707-715; 3.6 L688
 */
typedef uint16_t hiwin_e_status_word_2_fixed_stop;

/**
 * Printed as Traverse to fixed stop 已啟用.
 * 1: Traversing to a fixed stop is enabled..
 * Source: 3.6.3 L713
 */
#define HIWIN_E_STATUS_WORD_2_FIXED_STOP_TRAVERSE_TO_FIXED_STOP_ACTIVE_MASK 0x0100u
#define HIWIN_E_STATUS_WORD_2_FIXED_STOP_TRAVERSE_TO_FIXED_STOP_ACTIVE_SHIFT 8u

/**
 * A counter by which the controller sees that the drive is alive.
 * Printed as 驅動器 Sign-of-Life.
 * Note: The steps and the range of the counter are not printed.
 * Source: 3.6.3 L715
 */
#define HIWIN_E_STATUS_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK 0xF000u
#define HIWIN_E_STATUS_WORD_2_FIXED_STOP_SIGN_OF_LIFE_SHIFT 12u

/**
 * The sign of life of the drive, whether it traverses to a fixed stop, and whether pulses are enabled. For
 * telegram 111.
 * Printed as ZSW2 Status word 2.
 * A word of 16 bits.
 * Source: 3.6.4 L717-726; 3.6 L688
 */
typedef uint16_t hiwin_e_status_word_2_positioning;

/**
 * Printed as Traverse to fixed stop 已啟用.
 * 1: Traversing to a fixed stop is enabled..
 * Source: 3.6.4 L723
 */
#define HIWIN_E_STATUS_WORD_2_POSITIONING_TRAVERSE_TO_FIXED_STOP_ACTIVE_MASK 0x0100u
#define HIWIN_E_STATUS_WORD_2_POSITIONING_TRAVERSE_TO_FIXED_STOP_ACTIVE_SHIFT 8u

/**
 * Printed as 脈波命令啟用.
 * 0: Pulses are disabled.. 1: Pulses are enabled..
 * Note: The manual speaks of pulse commands, of which there are none on PROFINET. PROFIdrive has the pulses of
 * the power stage in this bit.
 * Source: 3.6.4 L725
 */
#define HIWIN_E_STATUS_WORD_2_POSITIONING_PULSES_ENABLED_MASK 0x0800u
#define HIWIN_E_STATUS_WORD_2_POSITIONING_PULSES_ENABLED_SHIFT 11u

/**
 * A counter by which the controller sees that the drive is alive.
 * Printed as 驅動器 Sign-of-Life.
 * Note: The steps and the range of the counter are not printed.
 * Source: 3.6.4 L726
 */
#define HIWIN_E_STATUS_WORD_2_POSITIONING_SIGN_OF_LIFE_MASK 0xF000u
#define HIWIN_E_STATUS_WORD_2_POSITIONING_SIGN_OF_LIFE_SHIFT 12u

/**
 * Starts and ends functions of encoder 1, such as the search for reference marks.
 * Printed as G1_STW 編碼器 1 control word.
 * A word of 16 bits.
 * Note: The manual prints the bits without explaining how a function runs.
 * Source: 3.7 L728-748
 */
typedef uint16_t hiwin_e_encoder_1_control_word;

/**
 * The command is for function 1, that is reference mark 1.
 * Printed as 功能 1 (參考標記 1).
 * Source: 3.7 L733
 */
#define HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_1_MASK 0x0001u
#define HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_1_SHIFT 0u

/**
 * The command is for function 2, that is reference mark 2.
 * Printed as 功能 2 (參考標記 2).
 * Source: 3.7 L734
 */
#define HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_2_MASK 0x0002u
#define HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_2_SHIFT 1u

/**
 * The command is for function 3, that is reference mark 3.
 * Printed as 功能 3 (參考標記 3).
 * Source: 3.7 L735
 */
#define HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_3_MASK 0x0004u
#define HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_3_SHIFT 2u

/**
 * The command is for function 4, that is reference mark 4.
 * Printed as 功能 4 (參考標記 4).
 * Source: 3.7 L736
 */
#define HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_4_MASK 0x0008u
#define HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_4_SHIFT 3u

/**
 * What is to be done with the functions that are chosen.
 * See encoder_command.
 * Source: 3.7 L737-739
 */
#define HIWIN_E_ENCODER_1_CONTROL_WORD_COMMAND_MASK 0x0070u
#define HIWIN_E_ENCODER_1_CONTROL_WORD_COMMAND_SHIFT 4u

/**
 * 0: The functions search reference marks.. 1: Reserved..
 * Note: The bit must be 0; 1 is printed as reserved.
 * Source: 3.7 L740
 */
#define HIWIN_E_ENCODER_1_CONTROL_WORD_NO_REFERENCE_MARK_SEARCH_MASK 0x0080u
#define HIWIN_E_ENCODER_1_CONTROL_WORD_NO_REFERENCE_MARK_SEARCH_SHIFT 7u

/**
 * Printed as Parking sensor 作動.
 * 1: Park the encoder..
 * Source: 3.7 L747
 */
#define HIWIN_E_ENCODER_1_CONTROL_WORD_PARKING_SENSOR_MASK 0x4000u
#define HIWIN_E_ENCODER_1_CONTROL_WORD_PARKING_SENSOR_SHIFT 14u

/**
 * Printed as 編碼器警報已確認.
 * 1: Reset an alarm of the encoder..
 * Source: 3.7 L748
 */
#define HIWIN_E_ENCODER_1_CONTROL_WORD_ACKNOWLEDGE_ALARM_MASK 0x8000u
#define HIWIN_E_ENCODER_1_CONTROL_WORD_ACKNOWLEDGE_ALARM_SHIFT 15u

/**
 * The state of the functions of encoder 1.
 * Printed as G1_ZSW 編碼器 1 status word.
 * A word of 16 bits.
 * Note: The manual names functions and values and does not say what 1 means; that a function is active and a
 * value can be read, is how PROFIdrive has it.
 * Source: 3.8 L750-770
 */
typedef uint16_t hiwin_e_encoder_1_status_word;

/**
 * Function 1, that is reference mark 1.
 * Printed as 功能 1 (參考標記 1).
 * Source: 3.8 L755
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_1_ACTIVE_MASK 0x0001u
#define HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_1_ACTIVE_SHIFT 0u

/**
 * Function 2, that is reference mark 2.
 * Printed as 功能 2 (參考標記 2).
 * Source: 3.8 L756
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_2_ACTIVE_MASK 0x0002u
#define HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_2_ACTIVE_SHIFT 1u

/**
 * Function 3, that is reference mark 3.
 * Printed as 功能 3 (參考標記 3).
 * Source: 3.8 L757
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_3_ACTIVE_MASK 0x0004u
#define HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_3_ACTIVE_SHIFT 2u

/**
 * Function 4, that is reference mark 4.
 * Printed as 功能 4 (參考標記 4).
 * Source: 3.8 L758
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_4_ACTIVE_MASK 0x0008u
#define HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_4_ACTIVE_SHIFT 3u

/**
 * The value of reference mark 1.
 * Printed as 值 1 (參考標記 1).
 * Source: 3.8 L759
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_1_AVAILABLE_MASK 0x0010u
#define HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_1_AVAILABLE_SHIFT 4u

/**
 * The value of reference mark 2.
 * Printed as 值 2 (參考標記 2).
 * Source: 3.8 L760
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_2_AVAILABLE_MASK 0x0020u
#define HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_2_AVAILABLE_SHIFT 5u

/**
 * The value of reference mark 3.
 * Printed as 值 3 (參考標記 3).
 * Source: 3.8 L761
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_3_AVAILABLE_MASK 0x0040u
#define HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_3_AVAILABLE_SHIFT 6u

/**
 * The value of reference mark 4.
 * Printed as 值 4 (參考標記 4).
 * Source: 3.8 L762
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_4_AVAILABLE_MASK 0x0080u
#define HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_4_AVAILABLE_SHIFT 7u

/**
 * An alarm of the encoder is being reset.
 * Printed as 警報確認程序處理中.
 * Source: 3.8 L766
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_ACKNOWLEDGING_ALARM_MASK 0x0800u
#define HIWIN_E_ENCODER_1_STATUS_WORD_ACKNOWLEDGING_ALARM_SHIFT 11u

/**
 * Printed as Parking sensor 已作動.
 * 1: The encoder is parked..
 * Source: 3.8 L769
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_SENSOR_PARKED_MASK 0x4000u
#define HIWIN_E_ENCODER_1_STATUS_WORD_SENSOR_PARKED_SHIFT 14u

/**
 * Printed as 發生編碼器警報.
 * 1: The encoder has an alarm..
 * Source: 3.8 L770
 */
#define HIWIN_E_ENCODER_1_STATUS_WORD_ALARM_MASK 0x8000u
#define HIWIN_E_ENCODER_1_STATUS_WORD_ALARM_SHIFT 15u

/**
 * Chooses what positions the axis. For telegram 9; only the MDI submode has an effect (3.2 L575).
 * Printed as SATZANW 位置模塊選擇.
 * A word of 16 bits.
 * Source: 3.9 L772-779
 */
typedef uint16_t hiwin_e_block_selection;

/**
 * Printed as 啟用 MDI 子模式.
 * 0: The MDI submode is switched off.. 1: The MDI submode is switched on..
 * Source: 3.9 L779
 */
#define HIWIN_E_BLOCK_SELECTION_MDI_MASK 0x8000u
#define HIWIN_E_BLOCK_SELECTION_MDI_SHIFT 15u

/**
 * What positions the axis. For telegram 9.
 * Printed as AKTSATZ 已選擇的位置模塊.
 * A word of 16 bits.
 * Source: 3.10 L781-787
 */
typedef uint16_t hiwin_e_selected_block;

/**
 * 0: The MDI submode is off.. 1: The MDI submode is on..
 * Source: 3.10 L787
 */
#define HIWIN_E_SELECTED_BLOCK_MDI_MASK 0x8000u
#define HIWIN_E_SELECTED_BLOCK_MDI_SHIFT 15u

/**
 * How MDI_TARPOS counts. For telegram 9.
 * Printed as MDI_MODE MDI 位置模式.
 * A word of 16 bits.
 * Source: 3.11 L789-797
 */
typedef uint16_t hiwin_e_mdi_mode;

/**
 * Printed as 絕對定位.
 * 0: Relative positioning.. 1: Absolute positioning..
 * Source: 3.11 L794
 */
#define HIWIN_E_MDI_MODE_ABSOLUTE_MASK 0x0001u
#define HIWIN_E_MDI_MODE_ABSOLUTE_SHIFT 0u

/**
 * How an MDI command is run. For telegram 111.
 * Printed as POS_STW1 定位 control word 1.
 * A word of 16 bits.
 * Source: 3.12 L799-814
 */
typedef uint16_t hiwin_e_positioning_control_word_1;

/**
 * How MDI_TARPOS counts. It has an effect in the positioning mode.
 * Printed as 絕對定位.
 * 0: Relative positioning.. 1: Absolute positioning..
 * Note: Before homing is completed (ZSW1.11 = 0) absolute commands are ignored, and AL.980 is raised with bit
 * 7 of 3120h (L820).
 * Note: With continuous transfer (bit 12) relative commands are ignored, and AL.980 is raised with bit 6 of
 * 3120h (L822).
 * Note: On a modulo axis absolute commands beyond its range are ignored, and AL.980 is raised with bit 7 of
 * 3120h (6.12 L1881).
 * Source: 3.12 L805
 */
#define HIWIN_E_POSITIONING_CONTROL_WORD_1_ABSOLUTE_MASK 0x0100u
#define HIWIN_E_POSITIONING_CONTROL_WORD_1_ABSOLUTE_SHIFT 8u

/**
 * In the setup mode the direction, in the positioning mode the path to an absolute position.
 * See positioning_path.
 * Note: The four values of the two bits are printed in four rows, two beside bit 9 and two beside bit 10. Bit
 * 10 is the higher one (6.13).
 * Note: 6.13 explains the path for modulo axes, which need firmware 2.14.4, 3.14.4 or 4.14.4. What it does on
 * other axes is not printed.
 * Source: 3.12 L806-809
 */
#define HIWIN_E_POSITIONING_CONTROL_WORD_1_PATH_MASK 0x0600u
#define HIWIN_E_POSITIONING_CONTROL_WORD_1_PATH_SHIFT 9u

/**
 * MDI commands are run as they come and need no edge of STW1.6. They must be absolute.
 * Printed as 啟用連續傳輸.
 * 1: Commands take effect without STW1.6..
 * Source: 3.12 L811
 */
#define HIWIN_E_POSITIONING_CONTROL_WORD_1_CONTINUOUS_MASK 0x1000u
#define HIWIN_E_POSITIONING_CONTROL_WORD_1_CONTINUOUS_SHIFT 12u

/**
 * In the setup mode the axis runs at MDI_VELOCITY in the direction of the bits 9 and 10 (L818); in the
 * positioning mode it goes to MDI_TARPOS (L820).
 * Printed as 選擇 MDI 調整模式.
 * 0: Positioning mode.. 1: Setup mode..
 * Source: 3.12 L813
 */
#define HIWIN_E_POSITIONING_CONTROL_WORD_1_MDI_SETUP_MASK 0x4000u
#define HIWIN_E_POSITIONING_CONTROL_WORD_1_MDI_SETUP_SHIFT 14u

/**
 * Printed as 啟用 MDI 子模式.
 * 0: The MDI submode is switched off.. 1: The MDI submode is switched on..
 * Source: 3.12 L814
 */
#define HIWIN_E_POSITIONING_CONTROL_WORD_1_MDI_MASK 0x8000u
#define HIWIN_E_POSITIONING_CONTROL_WORD_1_MDI_SHIFT 15u

/**
 * The reference point, and how jogging runs. For telegram 111.
 * Printed as POS_STW2 定位 control word 2.
 * A word of 16 bits.
 * Source: 3.13 L824-833
 */
typedef uint16_t hiwin_e_positioning_control_word_2;

/**
 * Printed as 將目前的位置設為參考點.
 * 1: The present position becomes the reference point..
 * Note: Whether the level or an edge has the effect is not printed.
 * Source: 3.13 L830
 */
#define HIWIN_E_POSITIONING_CONTROL_WORD_2_SET_REFERENCE_POINT_MASK 0x0002u
#define HIWIN_E_POSITIONING_CONTROL_WORD_2_SET_REFERENCE_POINT_SHIFT 1u

/**
 * Both run at Pt533 for rotary and Pt585 for linear motors (L837, 839).
 * Printed as 選擇 JOG 增量模式.
 * 0: A jog goes on at the speed of Pt533 or Pt585.. 1: A jog goes the distance of Pt539..
 * Source: 3.13 L832
 */
#define HIWIN_E_POSITIONING_CONTROL_WORD_2_JOG_INCREMENTAL_MASK 0x0020u
#define HIWIN_E_POSITIONING_CONTROL_WORD_2_JOG_INCREMENTAL_SHIFT 5u

/**
 * What the axis does. For telegram 111.
 * Printed as POS_ZSW1 定位 status word 1.
 * A word of 16 bits.
 * Source: 3.14 L841-853
 */
typedef uint16_t hiwin_e_positioning_status_word_1;

/**
 * Printed as 負方向超程生效.
 * 1: Overtravel in the negative direction..
 * Source: 3.14 L847
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_1_NEGATIVE_OVERTRAVEL_MASK 0x0100u
#define HIWIN_E_POSITIONING_STATUS_WORD_1_NEGATIVE_OVERTRAVEL_SHIFT 8u

/**
 * Printed as 正方向超程生效.
 * 1: Overtravel in the positive direction..
 * Source: 3.14 L848
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_1_POSITIVE_OVERTRAVEL_MASK 0x0200u
#define HIWIN_E_POSITIONING_STATUS_WORD_1_POSITIVE_OVERTRAVEL_SHIFT 9u

/**
 * Printed as 吋動生效.
 * 1: The axis jogs..
 * Source: 3.14 L849
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_1_JOGGING_MASK 0x0400u
#define HIWIN_E_POSITIONING_STATUS_WORD_1_JOGGING_SHIFT 10u

/**
 * Printed as 歸原點程序執行中.
 * 1: Homing runs..
 * Source: 3.14 L850
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_1_HOMING_MASK 0x0800u
#define HIWIN_E_POSITIONING_STATUS_WORD_1_HOMING_SHIFT 11u

/**
 * Printed as MDI 調整模式已選擇.
 * 1: The setup mode is chosen..
 * Source: 3.14 L852
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_1_MDI_SETUP_MASK 0x4000u
#define HIWIN_E_POSITIONING_STATUS_WORD_1_MDI_SETUP_SHIFT 14u

/**
 * Printed as MDI 子模式啟用.
 * 1: The MDI submode is on..
 * Source: 3.14 L853
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_1_MDI_MASK 0x8000u
#define HIWIN_E_POSITIONING_STATUS_WORD_1_MDI_SHIFT 15u

/**
 * What the axis does, and how traversing to a fixed stop goes. For telegram 111.
 * Printed as POS_ZSW2 定位 status word 2.
 * A word of 16 bits.
 * Source: 3.15 L855-869
 */
typedef uint16_t hiwin_e_positioning_status_word_2;

/**
 * Printed as 可接收控制命令.
 * 1: The drive can take commands..
 * Source: 3.15 L861
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_2_READY_FOR_COMMAND_MASK 0x0004u
#define HIWIN_E_POSITIONING_STATUS_WORD_2_READY_FOR_COMMAND_SHIFT 2u

/**
 * Printed as 軸向前移動.
 * 1: The axis moves forward..
 * Source: 3.15 L863
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_2_MOVING_FORWARD_MASK 0x0010u
#define HIWIN_E_POSITIONING_STATUS_WORD_2_MOVING_FORWARD_SHIFT 4u

/**
 * Printed as 軸向後移動.
 * 1: The axis moves backward..
 * Source: 3.15 L864
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_2_MOVING_BACKWARD_MASK 0x0020u
#define HIWIN_E_POSITIONING_STATUS_WORD_2_MOVING_BACKWARD_SHIFT 5u

/**
 * Printed as 已到達 Fixed stop.
 * 1: The fixed stop is reached..
 * Source: 3.15 L866
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_2_FIXED_STOP_REACHED_MASK 0x1000u
#define HIWIN_E_POSITIONING_STATUS_WORD_2_FIXED_STOP_REACHED_SHIFT 12u

/**
 * The clamping torque is set in Pt42D and Pt42E.
 * Printed as 轉矩已到達 Fixed stop 夾緊轉矩.
 * 1: The clamping torque is reached..
 * Source: 3.15 L867
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_2_FIXED_STOP_TORQUE_REACHED_MASK 0x2000u
#define HIWIN_E_POSITIONING_STATUS_WORD_2_FIXED_STOP_TORQUE_REACHED_SHIFT 13u

/**
 * The function works once this bit has followed STW2.8.
 * Printed as Traverse to fixed stop 已啟用.
 * 1: Traversing to a fixed stop is enabled..
 * Source: 3.15 L868
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_2_TRAVERSE_TO_FIXED_STOP_ENABLED_MASK 0x4000u
#define HIWIN_E_POSITIONING_STATUS_WORD_2_TRAVERSE_TO_FIXED_STOP_ENABLED_SHIFT 14u

/**
 * Printed as Traversing 命令生效.
 * 1: A traversing command is running..
 * Source: 3.15 L869
 */
#define HIWIN_E_POSITIONING_STATUS_WORD_2_TRAVERSING_COMMAND_ACTIVE_MASK 0x8000u
#define HIWIN_E_POSITIONING_STATUS_WORD_2_TRAVERSING_COMMAND_ACTIVE_SHIFT 15u

/**
 * Messages of the drive. For telegrams 102, 105 and 111.
 * Printed as MELDW Message word.
 * A word of 16 bits.
 * Note: Several bits are 1 in the good case: no limit, no warning.
 * Source: 3.16 L871-887
 */
typedef uint16_t hiwin_e_message_word;

/**
 * Printed as 轉矩限制未生效.
 * 1: No torque limit acts..
 * Source: 3.16 L877
 */
#define HIWIN_E_MESSAGE_WORD_TORQUE_LIMIT_NOT_ACTIVE_MASK 0x0002u
#define HIWIN_E_MESSAGE_WORD_TORQUE_LIMIT_NOT_ACTIVE_SHIFT 1u

/**
 * Printed as 無馬達過載警告.
 * 1: There is no warning of a motor overload..
 * Source: 3.16 L879
 */
#define HIWIN_E_MESSAGE_WORD_NO_MOTOR_OVERLOAD_WARNING_MASK 0x0040u
#define HIWIN_E_MESSAGE_WORD_NO_MOTOR_OVERLOAD_WARNING_SHIFT 6u

/**
 * Printed as 無 I²T 警告.
 * 1: There is no I²T warning..
 * Source: 3.16 L880
 */
#define HIWIN_E_MESSAGE_WORD_NO_I2T_WARNING_MASK 0x0080u
#define HIWIN_E_MESSAGE_WORD_NO_I2T_WARNING_SHIFT 7u

/**
 * Printed as 速度偏差在容許範圍內.
 * 1: The speed deviation is within its tolerance..
 * Note: It has no function and is always 1; ZSW1.8 of telegrams 102 and 105 says it.
 * Source: 3.16 L881
 */
#define HIWIN_E_MESSAGE_WORD_SPEED_WITHIN_TOLERANCE_MASK 0x0100u
#define HIWIN_E_MESSAGE_WORD_SPEED_WITHIN_TOLERANCE_SHIFT 8u

/**
 * Printed as 由 PLC 控制.
 * 1: The PLC controls the drive..
 * Source: 3.16 L883
 */
#define HIWIN_E_MESSAGE_WORD_CONTROLLED_BY_PLC_MASK 0x0800u
#define HIWIN_E_MESSAGE_WORD_CONTROLLED_BY_PLC_SHIFT 11u

/**
 * Printed as 驅動器就緒.
 * 1: The drive is ready..
 * Source: 3.16 L884
 */
#define HIWIN_E_MESSAGE_WORD_DRIVE_READY_MASK 0x1000u
#define HIWIN_E_MESSAGE_WORD_DRIVE_READY_SHIFT 12u

/**
 * Printed as 脈波命令啟用.
 * 1: Pulses are enabled..
 * Note: The manual speaks of pulse commands, of which there are none on PROFINET. PROFIdrive has the pulses of
 * the power stage in this bit.
 * Source: 3.16 L885
 */
#define HIWIN_E_MESSAGE_WORD_PULSES_ENABLED_MASK 0x2000u
#define HIWIN_E_MESSAGE_WORD_PULSES_ENABLED_SHIFT 13u

/* ---- Signals ---- */

/**
 * Switches the drive on and off and, with telegrams 9 and 111, moves it.
 * Printed as STW1 Control word 1.
 * Range: 0..65535.
 * Note: Its bits differ by telegram (3.3.1 and 3.3.2).
 * Source: 3.1 L468
 */
#define HIWIN_E_SIGNAL_CONTROL_WORD_1_MIN 0u
#define HIWIN_E_SIGNAL_CONTROL_WORD_1_MAX 65535u

/**
 * The sign of life of the controller.
 * Printed as STW2 Control word 2.
 * Range: 0..65535.
 * Note: Its bits differ by telegram (3.4.1 and 3.4.2).
 * Source: 3.1 L469
 */
#define HIWIN_E_SIGNAL_CONTROL_WORD_2_MIN 0u
#define HIWIN_E_SIGNAL_CONTROL_WORD_2_MAX 65535u

/**
 * The state of the drive and, with telegrams 9 and 111, of its movements.
 * Printed as ZSW1 Status word 1.
 * Range: 0..65535.
 * Note: Its bits differ by telegram (3.5.1 and 3.5.2).
 * Source: 3.1 L470
 */
#define HIWIN_E_SIGNAL_STATUS_WORD_1_MIN 0u
#define HIWIN_E_SIGNAL_STATUS_WORD_1_MAX 65535u

/**
 * The sign of life of the drive.
 * Printed as ZSW2 Status word 2.
 * Range: 0..65535.
 * Note: Its bits differ by telegram (3.6.1 to 3.6.4).
 * Source: 3.1 L471
 */
#define HIWIN_E_SIGNAL_STATUS_WORD_2_MIN 0u
#define HIWIN_E_SIGNAL_STATUS_WORD_2_MAX 65535u

/**
 * The commanded speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
 * Printed as NSOLL_B 速度控制命令 B (32 位元).
 * One count is 100/2^30 %. Range: -2147483648..2147483647.
 * Source: 3.1 L472, 506
 */
#define HIWIN_E_SIGNAL_SPEED_SETPOINT_B_MIN (-2147483647 - 1)
#define HIWIN_E_SIGNAL_SPEED_SETPOINT_B_MAX 2147483647
#define HIWIN_E_SIGNAL_SPEED_SETPOINT_B_SCALE_NUMERATOR INT64_C(25)
#define HIWIN_E_SIGNAL_SPEED_SETPOINT_B_SCALE_DENOMINATOR INT64_C(268435456)

/**
 * The actual speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
 * Printed as NIST_B 速度實際值 B (32 位元).
 * One count is 100/2^30 %. Range: -2147483648..2147483647.
 * Source: 3.1 L473, 506
 */
#define HIWIN_E_SIGNAL_SPEED_ACTUAL_B_MIN (-2147483647 - 1)
#define HIWIN_E_SIGNAL_SPEED_ACTUAL_B_MAX 2147483647
#define HIWIN_E_SIGNAL_SPEED_ACTUAL_B_SCALE_NUMERATOR INT64_C(25)
#define HIWIN_E_SIGNAL_SPEED_ACTUAL_B_SCALE_DENOMINATOR INT64_C(268435456)

/**
 * Printed as G1_STW 編碼器 1 control word.
 * Range: 0..65535.
 * Source: 3.1 L474
 */
#define HIWIN_E_SIGNAL_ENCODER_1_CONTROL_WORD_MIN 0u
#define HIWIN_E_SIGNAL_ENCODER_1_CONTROL_WORD_MAX 65535u

/**
 * Printed as G1_ZSW 編碼器 1 status word.
 * Range: 0..65535.
 * Source: 3.1 L475
 */
#define HIWIN_E_SIGNAL_ENCODER_1_STATUS_WORD_MIN 0u
#define HIWIN_E_SIGNAL_ENCODER_1_STATUS_WORD_MAX 65535u

/**
 * Printed as G1_XIST1 編碼器 1 實際位置 1.
 * One count is 1 control unit. Range: -2147483648..2147483647.
 * Note: Element 3 of parameter 979 is the constant by which it is shifted (4.1 L947).
 * Source: 3.1 L476
 */
#define HIWIN_E_SIGNAL_ENCODER_1_POSITION_1_MIN (-2147483647 - 1)
#define HIWIN_E_SIGNAL_ENCODER_1_POSITION_1_MAX 2147483647

/**
 * Printed as G1_XIST2 編碼器 1 實際位置 2.
 * One count is 1 control unit. Range: -2147483648..2147483647.
 * Note: Element 4 of parameter 979 is the constant by which it is shifted (4.1 L948).
 * Note: What it holds while G1_ZSW shows an alarm or a value is not printed.
 * Source: 3.1 L477
 */
#define HIWIN_E_SIGNAL_ENCODER_1_POSITION_2_MIN (-2147483647 - 1)
#define HIWIN_E_SIGNAL_ENCODER_1_POSITION_2_MAX 2147483647

/**
 * Printed as SATZANW 位置模塊選擇.
 * Range: 0..65535.
 * Source: 3.1 L478
 */
#define HIWIN_E_SIGNAL_BLOCK_SELECTION_MIN 0u
#define HIWIN_E_SIGNAL_BLOCK_SELECTION_MAX 65535u

/**
 * Printed as AKTSATZ 已選擇的位置模塊.
 * Range: 0..65535.
 * Source: 3.1 L479
 */
#define HIWIN_E_SIGNAL_SELECTED_BLOCK_MIN 0u
#define HIWIN_E_SIGNAL_SELECTED_BLOCK_MAX 65535u

/**
 * Printed as XIST_A 位置實際值 A.
 * One count is 1 control unit. Range: -2147483648..2147483647.
 * Note: On a modulo axis it goes round within the range that Pt25B and Pt25C make (6.13 L1944).
 * Source: 3.1 L480
 */
#define HIWIN_E_SIGNAL_POSITION_ACTUAL_A_MIN (-2147483647 - 1)
#define HIWIN_E_SIGNAL_POSITION_ACTUAL_A_MAX 2147483647

/**
 * The position, or in relative positioning the distance, of an MDI command.
 * Printed as MDI_TARPOS MDI 位置命令.
 * One count is 1 control unit. Range: -2147483648..2147483647.
 * Source: 3.1 L481
 */
#define HIWIN_E_SIGNAL_MDI_TARGET_POSITION_MIN (-2147483647 - 1)
#define HIWIN_E_SIGNAL_MDI_TARGET_POSITION_MAX 2147483647

/**
 * The speed of an MDI command; OVERRIDE scales it. In the setup mode its direction is chosen in POS_STW1.
 * Printed as MDI_VELOCITY MDI 速度命令.
 * One count is 1000 control unit/min. Range: 0..2147483647.
 * Source: 3.1 L482
 */
#define HIWIN_E_SIGNAL_MDI_VELOCITY_MIN 0
#define HIWIN_E_SIGNAL_MDI_VELOCITY_MAX 2147483647
#define HIWIN_E_SIGNAL_MDI_VELOCITY_SCALE_NUMERATOR INT64_C(1000)
#define HIWIN_E_SIGNAL_MDI_VELOCITY_SCALE_DENOMINATOR INT64_C(1)

/**
 * The share of the acceleration that Pt534 sets.
 * Printed as MDI_ACC MDI 加速度命令 Override.
 * One count is 100/2^14 %. Range: 0..16384.
 * Note: Pt534 holds a time, and the word a share of the acceleration: a smaller share takes longer. The manual
 * prints no formula.
 * Source: 3.1 L483, 508
 */
#define HIWIN_E_SIGNAL_MDI_ACCELERATION_MIN 0u
#define HIWIN_E_SIGNAL_MDI_ACCELERATION_MAX 16384u
#define HIWIN_E_SIGNAL_MDI_ACCELERATION_SCALE_NUMERATOR INT64_C(25)
#define HIWIN_E_SIGNAL_MDI_ACCELERATION_SCALE_DENOMINATOR INT64_C(4096)

/**
 * The share of the deceleration that Pt537 sets.
 * Printed as MDI_DEC MDI 減速度命令 Override.
 * One count is 100/2^14 %. Range: 0..16384.
 * Note: Pt537 holds a time, and the word a share of the deceleration: a smaller share takes longer. The manual
 * prints no formula.
 * Source: 3.1 L484, 508
 */
#define HIWIN_E_SIGNAL_MDI_DECELERATION_MIN 0u
#define HIWIN_E_SIGNAL_MDI_DECELERATION_MAX 16384u
#define HIWIN_E_SIGNAL_MDI_DECELERATION_SCALE_NUMERATOR INT64_C(25)
#define HIWIN_E_SIGNAL_MDI_DECELERATION_SCALE_DENOMINATOR INT64_C(4096)

/**
 * Printed as MDI_MODE MDI 位置模式.
 * Range: 0..65535.
 * Source: 3.1 L485
 */
#define HIWIN_E_SIGNAL_MDI_MODE_MIN 0u
#define HIWIN_E_SIGNAL_MDI_MODE_MAX 65535u

/**
 * Printed as POS_STW1 定位 control word 1.
 * Range: 0..65535.
 * Source: 3.1 L486
 */
#define HIWIN_E_SIGNAL_POSITIONING_CONTROL_WORD_1_MIN 0u
#define HIWIN_E_SIGNAL_POSITIONING_CONTROL_WORD_1_MAX 65535u

/**
 * Printed as POS_STW2 定位 control word 2.
 * Range: 0..65535.
 * Source: 3.1 L487
 */
#define HIWIN_E_SIGNAL_POSITIONING_CONTROL_WORD_2_MIN 0u
#define HIWIN_E_SIGNAL_POSITIONING_CONTROL_WORD_2_MAX 65535u

/**
 * Printed as POS_ZSW1 定位 status word 1.
 * Range: 0..65535.
 * Source: 3.1 L488
 */
#define HIWIN_E_SIGNAL_POSITIONING_STATUS_WORD_1_MIN 0u
#define HIWIN_E_SIGNAL_POSITIONING_STATUS_WORD_1_MAX 65535u

/**
 * Printed as POS_ZSW2 定位 status word 2.
 * Range: 0..65535.
 * Source: 3.1 L489
 */
#define HIWIN_E_SIGNAL_POSITIONING_STATUS_WORD_2_MIN 0u
#define HIWIN_E_SIGNAL_POSITIONING_STATUS_WORD_2_MAX 65535u

/**
 * Printed as MELDW Message word.
 * Range: 0..65535.
 * Source: 3.1 L490
 */
#define HIWIN_E_SIGNAL_MESSAGE_WORD_MIN 0u
#define HIWIN_E_SIGNAL_MESSAGE_WORD_MAX 65535u

/**
 * The share of the MDI velocity and, with telegram 111, of the jog speed that is run (6.8 L1670). The greatest
 * is one count less than 200 %.
 * Printed as OVERRIDE 速度命令 Override.
 * One count is 100/2^14 %. Range: 0..32767.
 * Note: 4000h is the whole speed. A word that is left at 0 is 0 %.
 * Source: 3.1 L491, 510
 */
#define HIWIN_E_SIGNAL_VELOCITY_OVERRIDE_MIN 0u
#define HIWIN_E_SIGNAL_VELOCITY_OVERRIDE_MAX 32767u
#define HIWIN_E_SIGNAL_VELOCITY_OVERRIDE_SCALE_NUMERATOR INT64_C(25)
#define HIWIN_E_SIGNAL_VELOCITY_OVERRIDE_SCALE_DENOMINATOR INT64_C(4096)

/**
 * The alarm that the drive has.
 * Printed as FAULT_CODE 警報代碼.
 * Range: 0..65535. See alarm_code.
 * Note: What it holds when there is no alarm is not printed; ZSW1.3 says whether there is one.
 * Source: 3.1 L492
 */
#define HIWIN_E_SIGNAL_FAULT_CODE_MIN 0u
#define HIWIN_E_SIGNAL_FAULT_CODE_MAX 65535u

/**
 * The warning that the drive has.
 * Printed as WARN_CODE 警告代碼.
 * Range: 0..65535. See warning_code.
 * Note: What it holds when there is no warning is not printed; ZSW1.7 says whether there is one.
 * Source: 3.1 L495
 */
#define HIWIN_E_SIGNAL_WARNING_CODE_MIN 0u
#define HIWIN_E_SIGNAL_WARNING_CODE_MAX 65535u

/**
 * What is taken off the torque, as a share of the reference torque: Pt42A for rotary motors, the force Pt43A
 * for linear ones.
 * Printed as MOMRED 轉矩調節值.
 * One count is 100/2^14 %. Range: 0..16384.
 * Note: 0 leaves the whole reference torque, 4000h leaves none.
 * Source: 3.1 L496, 512
 */
#define HIWIN_E_SIGNAL_TORQUE_REDUCTION_MIN 0u
#define HIWIN_E_SIGNAL_TORQUE_REDUCTION_MAX 16384u
#define HIWIN_E_SIGNAL_TORQUE_REDUCTION_SCALE_NUMERATOR INT64_C(25)
#define HIWIN_E_SIGNAL_TORQUE_REDUCTION_SCALE_DENOMINATOR INT64_C(4096)

/**
 * The torque that the motor gives, as a share of the reference torque: Pt42A for rotary motors, the force
 * Pt43A for linear ones.
 * Printed as M_ACT 實際轉矩值.
 * One count is 100/2^14 %. Range: -32768..32767.
 * Source: 3.1 L497
 */
#define HIWIN_E_SIGNAL_TORQUE_ACTUAL_MIN (-32768)
#define HIWIN_E_SIGNAL_TORQUE_ACTUAL_MAX 32767
#define HIWIN_E_SIGNAL_TORQUE_ACTUAL_SCALE_NUMERATOR INT64_C(25)
#define HIWIN_E_SIGNAL_TORQUE_ACTUAL_SCALE_DENOMINATOR INT64_C(4096)

/**
 * A torque that is added, as a share of the reference torque: it holds a vertical axis when the motor is
 * excited.
 * Printed as M_ADD1 附加轉矩值.
 * One count is 100/2^14 %. Range: -32768..32767.
 * Note: It has an effect from firmware 2.12.5 or 3.12.5 on (6.11.1 L1842).
 * Source: 3.1 L498
 */
#define HIWIN_E_SIGNAL_ADDITIONAL_TORQUE_MIN (-32768)
#define HIWIN_E_SIGNAL_ADDITIONAL_TORQUE_MAX 32767
#define HIWIN_E_SIGNAL_ADDITIONAL_TORQUE_SCALE_NUMERATOR INT64_C(25)
#define HIWIN_E_SIGNAL_ADDITIONAL_TORQUE_SCALE_DENOMINATOR INT64_C(4096)

/**
 * The limit in the positive direction, as a share of the reference torque. The lesser of this and Pt402 or
 * Pt483 counts.
 * Printed as M_LIMIT_POS 轉矩上限值.
 * One count is 100/2^14 %. Range: 0..32767.
 * Note: It has an effect from firmware 2.12.5 or 3.12.5 on (6.11.2 L1856).
 * Note: With both limits 0 this function is off, and so it is while STW2.8 is 1 (6.11.2 L1858-1860); the
 * limits of 6.3 go on to count.
 * Source: 3.1 L499
 */
#define HIWIN_E_SIGNAL_POSITIVE_TORQUE_LIMIT_MIN 0
#define HIWIN_E_SIGNAL_POSITIVE_TORQUE_LIMIT_MAX 32767
#define HIWIN_E_SIGNAL_POSITIVE_TORQUE_LIMIT_SCALE_NUMERATOR INT64_C(25)
#define HIWIN_E_SIGNAL_POSITIVE_TORQUE_LIMIT_SCALE_DENOMINATOR INT64_C(4096)

/**
 * The limit in the negative direction, a negative share of the reference torque. The lesser of this and Pt403
 * or Pt484 counts.
 * Printed as M_LIMIT_NEG 轉矩下限值.
 * One count is 100/2^14 %. Range: -32768..0.
 * Note: It has an effect from firmware 2.12.5 or 3.12.5 on (6.11.2 L1856).
 * Note: With both limits 0 this function is off, and so it is while STW2.8 is 1 (6.11.2 L1858-1860); the
 * limits of 6.3 go on to count.
 * Note: Pt403 and Pt484 hold the limit of that direction as a positive number.
 * Source: 3.1 L500
 */
#define HIWIN_E_SIGNAL_NEGATIVE_TORQUE_LIMIT_MIN (-32768)
#define HIWIN_E_SIGNAL_NEGATIVE_TORQUE_LIMIT_MAX 0
#define HIWIN_E_SIGNAL_NEGATIVE_TORQUE_LIMIT_SCALE_NUMERATOR INT64_C(25)
#define HIWIN_E_SIGNAL_NEGATIVE_TORQUE_LIMIT_SCALE_DENOMINATOR INT64_C(4096)

/**
 * The gain of the position controller.
 * Printed as KPC 位置控制器增益係數.
 * One count is 1/1000 1/s. Range: -2147483648..2147483647.
 * Note: What negative gains mean is not printed.
 * Source: 3.1 L501
 */
#define HIWIN_E_SIGNAL_POSITION_CONTROLLER_GAIN_MIN (-2147483647 - 1)
#define HIWIN_E_SIGNAL_POSITION_CONTROLLER_GAIN_MAX 2147483647
#define HIWIN_E_SIGNAL_POSITION_CONTROLLER_GAIN_SCALE_NUMERATOR INT64_C(1)
#define HIWIN_E_SIGNAL_POSITION_CONTROLLER_GAIN_SCALE_DENOMINATOR INT64_C(1000)

/**
 * The position deviation, which the controller sends.
 * Printed as XERR 位置偏差值.
 * One count is 1 control unit. Range: -2147483648..2147483647.
 * Source: 3.1 L502
 */
#define HIWIN_E_SIGNAL_POSITION_ERROR_MIN (-2147483647 - 1)
#define HIWIN_E_SIGNAL_POSITION_ERROR_MAX 2147483647

/* ---- Records ---- */

#define HIWIN_E_PARAMETER_ERROR_SIZE 4u

/* ---- Data of requests and responses ---- */

/**
 * Reads one value (4.3.1) or several elements of an array (4.3.3): the two differ in the number of elements
 * only, which is 0 for one value.
 * Printed as 讀取一個值的結構.
 * Read a parameter. On parameter_channel.
 * Note: The tables draw four bytes for a value. How many it has follows from the format: one, two or four.
 * Source: 4.3.1 L1237-1265
 */
#define HIWIN_E_READ_PARAMETER_CODE 1u

#define HIWIN_E_READ_PARAMETER_REQUEST_SIZE 6u

#define HIWIN_E_READ_PARAMETER_RESPONSE_SIZE 1022u

/**
 * Writes one value (4.3.2) or several elements of an array (4.3.4): the two differ in the number of elements
 * only, which is 0 for one value. The response has no data.
 * Printed as 寫入一個值的結構.
 * Write a parameter. On parameter_channel.
 * Note: Both tables draw one byte for the parameter number and so show the sub-index, the format and the
 * number of values a byte too early, and five bytes of values; the last byte is right again. The number has
 * two bytes, as when reading.
 * Note: The number of values must be the number of elements of the address (error 18h, 4.3.6 L1442).
 * Note: The format must suit the parameter (errors 05h and 17h, 4.3.6 L1423, 1441).
 * Source: 4.3.2 L1279-1307
 */
#define HIWIN_E_WRITE_PARAMETER_CODE 2u

#define HIWIN_E_WRITE_PARAMETER_REQUEST_SIZE 1028u

#define HIWIN_E_WRITE_PARAMETER_RESPONSE_SIZE 0u

/**
 * Printed as 標準報文 3.
 * Speed and encoder (standard telegram 3). On cyclic.
 * Source: 3.2 L522, 536-546
 */
#define HIWIN_E_TELEGRAM_3_NUMBER 3u

#define HIWIN_E_TELEGRAM_3_REQUEST_SIZE 10u

#define HIWIN_E_TELEGRAM_3_RESPONSE_SIZE 18u

/**
 * Printed as 標準報文 5.
 * Speed, encoder and position controller (standard telegram 5). On cyclic.
 * Note: Which firmware has it, is in the release notes of the GSD files (3.2 L532).
 * Source: 3.2 L523, 536-546
 */
#define HIWIN_E_TELEGRAM_5_NUMBER 5u

#define HIWIN_E_TELEGRAM_5_REQUEST_SIZE 18u

#define HIWIN_E_TELEGRAM_5_RESPONSE_SIZE 18u

/**
 * Printed as 標準報文 9.
 * Positioning by MDI commands (standard telegram 9). On cyclic.
 * Source: 3.2 L524, 549-560
 */
#define HIWIN_E_TELEGRAM_9_NUMBER 9u

#define HIWIN_E_TELEGRAM_9_REQUEST_SIZE 20u

#define HIWIN_E_TELEGRAM_9_RESPONSE_SIZE 10u

/**
 * Printed as HIWIN 報文 102.
 * Speed with torque reduction (HIWIN telegram 102). On cyclic.
 * Note: Which firmware has it, is in the release notes of the GSD files (3.2 L532).
 * Source: 3.2 L525, 536-547
 */
#define HIWIN_E_TELEGRAM_102_NUMBER 102u

#define HIWIN_E_TELEGRAM_102_REQUEST_SIZE 12u

#define HIWIN_E_TELEGRAM_102_RESPONSE_SIZE 20u

/**
 * Printed as HIWIN 報文 105.
 * Speed with torque reduction and position controller (HIWIN telegram 105). On cyclic.
 * Note: Which firmware has it, is in the release notes of the GSD files (3.2 L532).
 * Source: 3.2 L526, 536-547
 */
#define HIWIN_E_TELEGRAM_105_NUMBER 105u

#define HIWIN_E_TELEGRAM_105_REQUEST_SIZE 20u

#define HIWIN_E_TELEGRAM_105_RESPONSE_SIZE 20u

/**
 * Printed as HIWIN 報文 111.
 * Positioning with all control words (HIWIN telegram 111). On cyclic.
 * Note: The names behind MDI_VELOCITY and NIST_B are printed one row too high, because a signal of 32 bits
 * takes two rows.
 * Source: 3.2 L527, 549-562
 */
#define HIWIN_E_TELEGRAM_111_NUMBER 111u

#define HIWIN_E_TELEGRAM_111_REQUEST_SIZE 24u

#define HIWIN_E_TELEGRAM_111_RESPONSE_SIZE 24u

/**
 * Printed as HIWIN 報文 750.
 * Torque beside another telegram (HIWIN telegram 750). On cyclic. Sent only together with telegram_3,
 * telegram_5, telegram_9, telegram_102, telegram_105, telegram_111.
 * Note: All that it carries to the drive has an effect from firmware 2.12.5 or 3.12.5 on (6.11.1 L1842, 6.11.2
 * L1856).
 * Note: Which firmware has the telegram itself, is in the release notes of the GSD files (L532).
 * Source: 3.2 L516, 528, 566-570
 */
#define HIWIN_E_TELEGRAM_750_NUMBER 750u

#define HIWIN_E_TELEGRAM_750_REQUEST_SIZE 6u

#define HIWIN_E_TELEGRAM_750_RESPONSE_SIZE 2u

/* ---- Parameters ---- */

/**
 * The kind of motor that the drive has.
 * Printed as 3000h Motor type.
 * 3000h of drive_parameters. Read only.
 * Range: 0..2. See motor_type.
 * Source: 4.2 L958-959
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_MOTOR_TYPE_NUMBER 0x3000u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_MOTOR_TYPE_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_MOTOR_TYPE_MAX 2u

/**
 * The resolution of the encoder of the inner loop.
 * Printed as 3001h Inner encoder resolution.
 * 3001h of drive_parameters. Read only.
 * Range: -2147483648..2147483647.
 * Note: A unit is not printed.
 * Source: 4.2 L960-961
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_INNER_ENCODER_RESOLUTION_NUMBER 0x3001u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_INNER_ENCODER_RESOLUTION_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_INNER_ENCODER_RESOLUTION_MAX 2147483647

/**
 * Switches digital outputs on. An output is on when its own condition holds or when its bit here is 1; an
 * output without a condition (Not configure) follows its bit alone.
 * Printed as 3044h Digital outputs (one-way).
 * 3044h of drive_parameters. Read and write.
 * Range: 0..31. See digital_output_control.
 * Source: 4.2 L962-963
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DIGITAL_OUTPUTS_NUMBER 0x3044u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DIGITAL_OUTPUTS_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DIGITAL_OUTPUTS_MAX 31u

/**
 * States of homing, the position trigger and the gantry control.
 * Printed as 3056h Software state[12].
 * 3056h of drive_parameters. Read only.
 * Range: 0..65535. See software_state.
 * Source: 4.2 L964-982
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SOFTWARE_STATE_12_NUMBER 0x3056u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SOFTWARE_STATE_12_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SOFTWARE_STATE_12_MAX 65535u

/**
 * Starts and stops the gantry control.
 * Printed as 3057h Application mode of gantry system.
 * 3057h of drive_parameters. Read and write.
 * Range: 1, 2, 11. See gantry_application_mode.
 * Source: 4.2 L985-986
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_APPLICATION_MODE_NUMBER 0x3057u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_APPLICATION_MODE_MIN 1u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_APPLICATION_MODE_MAX 11u

/**
 * Where the yaw axis of the gantry is to go.
 * Printed as 3058h Yaw target position.
 * 3058h of drive_parameters. Read and write.
 * One count is 1 control unit. Range: -2147483648..2147483647.
 * Source: 4.2 L987-988
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_YAW_TARGET_POSITION_NUMBER 0x3058u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_YAW_TARGET_POSITION_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_YAW_TARGET_POSITION_MAX 2147483647

/**
 * Where the yaw axis of the gantry is.
 * Printed as 3059h Yaw feedback position.
 * 3059h of drive_parameters. Read only.
 * One count is 1 control unit. Range: -2147483648..2147483647.
 * Source: 4.2 L989-990
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_YAW_FEEDBACK_POSITION_NUMBER 0x3059u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_YAW_FEEDBACK_POSITION_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_YAW_FEEDBACK_POSITION_MAX 2147483647

/**
 * Where the master axis of the gantry is.
 * Printed as 305Ah Master feedback position.
 * 305Ah of drive_parameters. Read only.
 * One count is 1 control unit. Range: -2147483648..2147483647.
 * Source: 4.2 L991-992
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_MASTER_FEEDBACK_POSITION_NUMBER 0x305Au
#define HIWIN_E_PAR_DRIVE_PARAMETERS_MASTER_FEEDBACK_POSITION_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_MASTER_FEEDBACK_POSITION_MAX 2147483647

/**
 * Where the slave axis of the gantry is.
 * Printed as 305Bh Slave feedback position.
 * 305Bh of drive_parameters. Read only.
 * One count is 1 control unit. Range: -2147483648..2147483647.
 * Source: 4.2 L993-994
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SLAVE_FEEDBACK_POSITION_NUMBER 0x305Bu
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SLAVE_FEEDBACK_POSITION_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SLAVE_FEEDBACK_POSITION_MAX 2147483647

/**
 * Which functions a reference mark starts.
 * Printed as 3060h Use reference mark enable specific function.
 * 3060h of drive_parameters. Read and write.
 * Range: 0..3. See reference_mark_functions.
 * Note: What is called a reference mark here is the touch probe of the drives' own manuals.
 * Source: 4.2 L995-1002
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_REFERENCE_MARK_FUNCTIONS_NUMBER 0x3060u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_REFERENCE_MARK_FUNCTIONS_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_REFERENCE_MARK_FUNCTIONS_MAX 3u

/**
 * Starts the position trigger.
 * Printed as 3061h Enable position trigger function.
 * 3061h of drive_parameters. Read and write.
 * Range: 0..1.
 * Note: The printed type is U16.
 * Source: 4.2 L1003-1004
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ENABLED_NUMBER 0x3061u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ENABLED_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ENABLED_MAX 1u

/**
 * Reserved.
 * Printed as 3062h Overtravel stop mode selection.
 * Reserved. 3062h of drive_parameters. Read and write.
 * Range: 0..1.
 * Source: 4.2 L1005-1006
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_OVERTRAVEL_STOP_MODE_NUMBER 0x3062u

/**
 * The analog speed command (V_REF): the voltage at the input less parameter 3064h.
 * Printed as 3063h Velocity analog input voltage.
 * 3063h of drive_parameters. Read only.
 * One count is 1 mV. Range: -10000..10000.
 * Source: 4.2 L1007-1008, 1226
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SPEED_ANALOG_INPUT_VOLTAGE_NUMBER 0x3063u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SPEED_ANALOG_INPUT_VOLTAGE_MIN (-10000)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SPEED_ANALOG_INPUT_VOLTAGE_MAX 10000

/**
 * What is taken away from the analog speed command.
 * Printed as 3064h Velocity analog input voltage offset.
 * 3064h of drive_parameters. Read and write.
 * One count is 1 mV. Range: -10000..10000.
 * Source: 4.2 L1011-1012, 1226
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SPEED_ANALOG_INPUT_OFFSET_NUMBER 0x3064u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SPEED_ANALOG_INPUT_OFFSET_MIN (-10000)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_SPEED_ANALOG_INPUT_OFFSET_MAX 10000

/**
 * The analog torque command (T_REF): the voltage at the input less parameter 3066h.
 * Printed as 3065h Torque analog input voltage.
 * 3065h of drive_parameters. Read only.
 * One count is 1 mV. Range: -10000..10000.
 * Source: 4.2 L1013-1014, 1226
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_TORQUE_ANALOG_INPUT_VOLTAGE_NUMBER 0x3065u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_TORQUE_ANALOG_INPUT_VOLTAGE_MIN (-10000)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_TORQUE_ANALOG_INPUT_VOLTAGE_MAX 10000

/**
 * What is taken away from the analog torque command.
 * Printed as 3066h Torque analog input voltage offset.
 * 3066h of drive_parameters. Read and write.
 * One count is 1 mV. Range: -10000..10000.
 * Source: 4.2 L1015-1016, 1226
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_TORQUE_ANALOG_INPUT_OFFSET_NUMBER 0x3066u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_TORQUE_ANALOG_INPUT_OFFSET_MIN (-10000)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_TORQUE_ANALOG_INPUT_OFFSET_MAX 10000

/**
 * The voltage at the analog output 1 (AO1).
 * Printed as 3067h Analog output 1 voltage.
 * 3067h of drive_parameters. Read and write.
 * One count is 1 mV. Range: -10000..10000.
 * Note: Has an effect with Pt006 = t.□□17.
 * Source: 4.2 L1017-1018
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ANALOG_OUTPUT_1_VOLTAGE_NUMBER 0x3067u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ANALOG_OUTPUT_1_VOLTAGE_MIN (-10000)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ANALOG_OUTPUT_1_VOLTAGE_MAX 10000

/**
 * The voltage at the analog output 2 (AO2).
 * Printed as 3068h Analog output 2 voltage.
 * 3068h of drive_parameters. Read and write.
 * One count is 1 mV. Range: -10000..10000.
 * Note: Has an effect with Pt007 = t.□□17.
 * Source: 4.2 L1019-1020
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ANALOG_OUTPUT_2_VOLTAGE_NUMBER 0x3068u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ANALOG_OUTPUT_2_VOLTAGE_MIN (-10000)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ANALOG_OUTPUT_2_VOLTAGE_MAX 10000

/**
 * The value that is written to one of the two arrays of the position trigger.
 * Printed as 3069h Position trigger array value.
 * 3069h of drive_parameters. Read and write.
 * One count is 1 increment. Range: -2147483648..2147483647.
 * Source: 4.2 L1021-1022
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_VALUE_NUMBER 0x3069u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_VALUE_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_VALUE_MAX 2147483647

/**
 * Which element is written.
 * Printed as 306Ah Position trigger array index.
 * 306Ah of drive_parameters. Read and write.
 * Range: 0..255.
 * Note: The array of positions has the elements 0 to 255, that of states 0 to 7 (L1028, 1030).
 * Source: 4.2 L1023-1024
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_INDEX_NUMBER 0x306Au
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_INDEX_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_INDEX_MAX 255u

/**
 * Writing a command starts the writing of an array of the position trigger; the result is read here.
 * Printed as 306Bh Position trigger array control object.
 * 306Bh of drive_parameters. Read and write.
 * Range: 0..65535. See position_trigger_array_control.
 * Source: 4.2 L1025-1033
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_CONTROL_NUMBER 0x306Bu
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_CONTROL_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ARRAY_CONTROL_MAX 65535u

/**
 * Why an array could not be written, or why the position trigger could not be started.
 * Printed as 306Ch Position trigger function error code.
 * 306Ch of drive_parameters. Read only.
 * Range: 0..65535. See position_trigger_error.
 * Source: 4.2 L1034-1040, 1043-1049
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ERROR_NUMBER 0x306Cu
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ERROR_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_ERROR_MAX 65535u

/**
 * Printed as 306Dh Position trigger function status.
 * 306Dh of drive_parameters. Read only.
 * Range: 0..32767. See position_trigger_status.
 * Source: 4.2 L1050-1059
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_STATUS_NUMBER 0x306Du
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_STATUS_MIN 0
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_STATUS_MAX 32767

/**
 * How many triggers there should be in all.
 * Printed as 306Eh Expected total number of position trigger.
 * 306Eh of drive_parameters. Read only.
 * Range: 0..65535.
 * Source: 4.2 L1060-1061
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_EXPECTED_POSITION_TRIGGER_COUNT_NUMBER 0x306Eu
#define HIWIN_E_PAR_DRIVE_PARAMETERS_EXPECTED_POSITION_TRIGGER_COUNT_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_EXPECTED_POSITION_TRIGGER_COUNT_MAX 65535u

/**
 * How many triggers there have been.
 * Printed as 306Fh Triggered number of position trigger.
 * 306Fh of drive_parameters. Read only.
 * Range: 0..65535.
 * Source: 4.2 L1062-1063
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_COUNT_NUMBER 0x306Fu
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_COUNT_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_POSITION_TRIGGER_COUNT_MAX 65535u

/**
 * How many triggers are still to come.
 * Printed as 3070h Remaining number of position trigger.
 * 3070h of drive_parameters. Read only.
 * Range: 0..65535.
 * Source: 4.2 L1064-1065
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_REMAINING_POSITION_TRIGGER_COUNT_NUMBER 0x3070u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_REMAINING_POSITION_TRIGGER_COUNT_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_REMAINING_POSITION_TRIGGER_COUNT_MAX 65535u

/**
 * The number of a parameter of the gantry's slave axis: 2100h is parameter 2100h of that axis.
 * Printed as 3080h Gantry control: index.
 * 3080h of drive_parameters. Read and write.
 * Range: 8192..20479.
 * Source: 4.2 L1066-1067
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_INDEX_NUMBER 0x3080u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_INDEX_MIN 8192u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_INDEX_MAX 20479u

/**
 * The sub-index of that parameter. Only 0 is supported at present.
 * Printed as 3081h Gantry control: subindex.
 * 3081h of drive_parameters. Read and write.
 * Range: 0.
 * Source: 4.2 L1068-1069
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_SUBINDEX_NUMBER 0x3081u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_SUBINDEX_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_SUBINDEX_MAX 0u

/**
 * The type of the parameter that 3080h names, which says in which registers its value is: 3085h and 3086h, or,
 * for F32, 3087h and 3088h. Not to be used while 3084h is -1.
 * Printed as 3082h Gantry control: data type of selected object.
 * 3082h of drive_parameters. Read only.
 * Range: -3..8. See gantry_parameter_type.
 * Source: 4.2 L1070-1074, 1077-1086
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_TYPE_NUMBER 0x3082u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_TYPE_MIN (-3)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_TYPE_MAX 8

/**
 * Reads or writes the parameter that 3080h names.
 * Printed as 3083h Gantry control: command.
 * 3083h of drive_parameters. Read and write.
 * Range: 0..3. See gantry_parameter_command.
 * Source: 4.2 L1087-1094
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_COMMAND_NUMBER 0x3083u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_COMMAND_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_COMMAND_MAX 3u

/**
 * How far the access is.
 * Printed as 3084h Gantry control: status.
 * 3084h of drive_parameters. Read only.
 * Range: -6..2. See gantry_parameter_status.
 * Source: 4.2 L1095-1107
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_STATUS_NUMBER 0x3084u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_STATUS_MIN (-6)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_PARAMETER_STATUS_MAX 2

/**
 * The value to be written, for all types but F32.
 * Printed as 3085h Gantry control: input register of DINT.
 * 3085h of drive_parameters. Read and write.
 * Range: -2147483648..2147483647.
 * Note: It takes the values of U32 parameters too. How those above 2147483647 are given is not printed.
 * Source: 4.2 L1108-1109
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_INTEGER_INPUT_NUMBER 0x3085u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_INTEGER_INPUT_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_INTEGER_INPUT_MAX 2147483647

/**
 * The value that was read, for all types but F32.
 * Printed as 3086h Gantry control: output register of DINT.
 * 3086h of drive_parameters. Read only.
 * Range: -2147483648..2147483647.
 * Note: It gives the values of U32 parameters too. How those above 2147483647 are given is not printed.
 * Source: 4.2 L1112-1113
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_INTEGER_OUTPUT_NUMBER 0x3086u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_INTEGER_OUTPUT_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_INTEGER_OUTPUT_MAX 2147483647

/**
 * The value to be written, for the type F32.
 * Printed as 3087h Gantry control: input register of REAL.
 * 3087h of drive_parameters. Read and write.
 * Source: 4.2 L1114-1115
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_FLOAT_INPUT_NUMBER 0x3087u

/**
 * The value that was read, for the type F32.
 * Printed as 3088h Gantry control: output register of REAL.
 * 3088h of drive_parameters. Read only.
 * Source: 4.2 L1116-1117
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GANTRY_FLOAT_OUTPUT_NUMBER 0x3088u

/**
 * Tables of alarms that are not supported at present; 4095h tells the alarm.
 * Printed as 3100h.
 * Reserved. 3100h of drive_parameters.
 * Source: 4.2 L1118
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ALARM_STATES_NUMBER 0x3100u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ALARM_STATES_COUNT 5u

/**
 * Warnings. 4096h should be used instead.
 * Printed as 3110h Drive warning events 1.
 * 3110h of drive_parameters. Read only.
 * Range: 0..65535. See drive_warnings_1.
 * Source: 4.2 L1119-1120, 1123-1139
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_WARNINGS_1_NUMBER 0x3110u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_WARNINGS_1_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_WARNINGS_1_MAX 65535u

/**
 * More warnings. 4096h should be used instead.
 * Printed as 3111h Drive warning events 2.
 * 3111h of drive_parameters. Read only.
 * Range: 0..65535. See drive_warnings_2.
 * Source: 4.2 L1140-1141, 1144-1147, 1150-1153
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_WARNINGS_2_NUMBER 0x3111u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_WARNINGS_2_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_WARNINGS_2_MAX 65535u

/**
 * What has caused the warning AL.980.
 * Printed as 3120h Host controller's operation warning events.
 * 3120h of drive_parameters. Read only.
 * Range: 0..4294967295. See operation_warnings.
 * Source: 4.2 L1154-1166
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_OPERATION_WARNINGS_NUMBER 0x3120u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_OPERATION_WARNINGS_MIN 0u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_OPERATION_WARNINGS_MAX 4294967295u

/**
 * Writing 1 clears the turns of a multi-turn encoder; the drive then shows here how far it is. The servo must
 * be off.
 * Printed as 3200h Absolute encoder initialization.
 * 3200h of drive_parameters. Read and write.
 * Range: 0..2, 4, 16, 32. Writable: 0..1. See absolute_encoder_initialization.
 * Note: Only 0 and 1 may be written (L1167); the others are states that the drive sets.
 * Source: 4.2 L1167-1175, 1228
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ABSOLUTE_ENCODER_INITIALIZATION_NUMBER 0x3200u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ABSOLUTE_ENCODER_INITIALIZATION_MIN 0
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ABSOLUTE_ENCODER_INITIALIZATION_MAX 32
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ABSOLUTE_ENCODER_INITIALIZATION_WRITE_MIN 0
#define HIWIN_E_PAR_DRIVE_PARAMETERS_ABSOLUTE_ENCODER_INITIALIZATION_WRITE_MAX 1

/**
 * For the user's own use.
 * Printed as 3201h General object i1.
 * 3201h of drive_parameters. Read and write.
 * Range: -2147483648..2147483647.
 * Source: 4.2 L1176-1177
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_1_NUMBER 0x3201u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_1_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_1_MAX 2147483647

/**
 * For the user's own use.
 * Printed as 3202h General object i2.
 * 3202h of drive_parameters. Read and write.
 * Range: -2147483648..2147483647.
 * Source: 4.2 L1178-1179
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_2_NUMBER 0x3202u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_2_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_2_MAX 2147483647

/**
 * For the user's own use.
 * Printed as 3203h General object i3.
 * 3203h of drive_parameters. Read and write.
 * Range: -2147483648..2147483647.
 * Source: 4.2 L1180-1181
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_3_NUMBER 0x3203u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_3_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_3_MAX 2147483647

/**
 * For the user's own use.
 * Printed as 3204h General object i4.
 * 3204h of drive_parameters. Read and write.
 * Range: -2147483648..2147483647.
 * Source: 4.2 L1182-1183
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_4_NUMBER 0x3204u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_4_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_4_MAX 2147483647

/**
 * For the user's own use.
 * Printed as 3205h General object i5.
 * 3205h of drive_parameters. Read and write.
 * Range: -2147483648..2147483647.
 * Source: 4.2 L1186-1187
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_5_NUMBER 0x3205u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_5_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_5_MAX 2147483647

/**
 * For the user's own use.
 * Printed as 3206h General object i6.
 * 3206h of drive_parameters. Read and write.
 * Range: -2147483648..2147483647.
 * Source: 4.2 L1188-1189
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_6_NUMBER 0x3206u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_6_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_6_MAX 2147483647

/**
 * For the user's own use.
 * Printed as 3207h General object i7.
 * 3207h of drive_parameters. Read and write.
 * Range: -2147483648..2147483647.
 * Source: 4.2 L1190-1191
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_7_NUMBER 0x3207u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_7_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_7_MAX 2147483647

/**
 * For the user's own use.
 * Printed as 3208h General object i8.
 * 3208h of drive_parameters. Read and write.
 * Range: -2147483648..2147483647.
 * Source: 4.2 L1192-1193
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_8_NUMBER 0x3208u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_8_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_8_MAX 2147483647

/**
 * For the user's own use.
 * Printed as 3209h General object i9.
 * 3209h of drive_parameters. Read and write.
 * Range: -2147483648..2147483647.
 * Source: 4.2 L1194-1195
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_9_NUMBER 0x3209u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_9_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_INTEGER_9_MAX 2147483647

/**
 * A floating-point number for the user's own use.
 * Printed as 3210h General object f0.
 * 3210h of drive_parameters. Read and write.
 * Note: The integers are counted from 1, the floating point numbers from 0.
 * Source: 4.2 L1196-1197
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_0_NUMBER 0x3210u

/**
 * A floating-point number for the user's own use.
 * Printed as 3211h General object f1.
 * 3211h of drive_parameters. Read and write.
 * Source: 4.2 L1198-1199
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_1_NUMBER 0x3211u

/**
 * A floating-point number for the user's own use.
 * Printed as 3212h General object f2.
 * 3212h of drive_parameters. Read and write.
 * Source: 4.2 L1200-1201
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_2_NUMBER 0x3212u

/**
 * A floating-point number for the user's own use.
 * Printed as 3213h General object f3.
 * 3213h of drive_parameters. Read and write.
 * Source: 4.2 L1202-1203
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_3_NUMBER 0x3213u

/**
 * A floating-point number for the user's own use.
 * Printed as 3214h General object f4.
 * 3214h of drive_parameters. Read and write.
 * Source: 4.2 L1204-1205
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_GENERAL_FLOAT_4_NUMBER 0x3214u

/**
 * Writing 1 or 2 resets the drive, or both drives of a gantry; it becomes 0 when that is done, or -1 if it
 * fails.
 * Printed as 3215h Reset drive.
 * 3215h of drive_parameters. Read and write.
 * Range: -1..2. See drive_reset.
 * Note: The connection is lost, and the controller must set it up again. -1 is for reading only, though the
 * printed range of this rw parameter includes it.
 * Source: 4.2 L1206-1213
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_RESET_NUMBER 0x3215u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_RESET_MIN (-1)
#define HIWIN_E_PAR_DRIVE_PARAMETERS_DRIVE_RESET_MAX 2

/**
 * Writing 1 stores the drive's parameters for good; it becomes 0 when that is done.
 * Printed as 3216h Send parameter to flash.
 * 3216h of drive_parameters. Read and write.
 * Range: 0..1. See parameter_save.
 * Source: 4.2 L1216-1217
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_PARAMETER_SAVE_NUMBER 0x3216u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_PARAMETER_SAVE_MIN 0
#define HIWIN_E_PAR_DRIVE_PARAMETERS_PARAMETER_SAVE_MAX 1

/**
 * Who controls the drive.
 * Printed as 3217h Mastership setting for Fieldbus servo drive.
 * 3217h of drive_parameters. Read and write.
 * Range: 0..1. See mastership.
 * Note: The drive of a gantry's slave axis always has 0.
 * Note: It cannot be changed while the motor is excited.
 * Source: 4.2 L1218-1219
 */
#define HIWIN_E_PAR_DRIVE_PARAMETERS_MASTERSHIP_NUMBER 0x3217u
#define HIWIN_E_PAR_DRIVE_PARAMETERS_MASTERSHIP_MIN 0
#define HIWIN_E_PAR_DRIVE_PARAMETERS_MASTERSHIP_MAX 1

/**
 * The Ut parameters of the drive's panel, to be read under the number 4000h + Ut with sub-index 00h. Only
 * three of them are told here; the others, and their types, are in the manuals of the drives.
 * Printed as 4XXXh 伺服Ut參數.
 * On the wire, 0x4000 is added to the numbers of the set.
 * Source: 4.2 L1220
 */
#define HIWIN_E_PAR_MONITORING_PARAMETERS_BASE 0x4000u
#define HIWIN_E_PAR_MONITORING_PARAMETERS_FIRST 0x0000u
#define HIWIN_E_PAR_MONITORING_PARAMETERS_LAST 0x0FFFu

/**
 * The states of the digital outputs.
 * Ut005 of monitoring_parameters. Read only.
 * See digital_output_states.
 * Source: 6.10 L1764, 1774-1781
 */
#define HIWIN_E_PAR_MONITORING_PARAMETERS_DIGITAL_OUTPUT_STATES_NUMBER 0x4005u

/**
 * The alarm of the drive.
 * Printed as Ut095 error code.
 * Ut095 of monitoring_parameters. Read only.
 * See alarm_code.
 * Source: 4.2 L1118, 1220
 */
#define HIWIN_E_PAR_MONITORING_PARAMETERS_ALARM_NUMBER 0x4095u

/**
 * The warning of the drive.
 * Printed as warning code.
 * Ut096 of monitoring_parameters. Read only.
 * See warning_code.
 * Source: 4.2 L1120, 1141
 */
#define HIWIN_E_PAR_MONITORING_PARAMETERS_WARNING_NUMBER 0x4096u

/**
 * The number of the telegram that is in effect.
 * Printed as 報文選擇.
 * Read only.
 * Note: The default, 0, is the number of none of the telegrams of 3.2; what it means is not printed.
 * Source: 4.1 L911-912
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_TELEGRAM_SELECTION_NUMBER 922u
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_TELEGRAM_SELECTION_DEFAULT 0u

/**
 * How many times the controller's sign of life may fail.
 * Printed as 控制器 Sign-of-Life 失效次數的容許值.
 * Read and write.
 * Source: 4.1 L913-914
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_SIGN_OF_LIFE_FAILURE_TOLERANCE_NUMBER 925u
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_SIGN_OF_LIFE_FAILURE_TOLERANCE_DEFAULT 5u

/**
 * Printed as 運轉模式.
 * Read only.
 * See operating_mode.
 * Source: 4.1 L915-919
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_OPERATING_MODE_NUMBER 930u

/**
 * Goes up by one whenever the alarm buffer changes.
 * Printed as 警報計數器.
 * Read only.
 * Source: 4.1 L920-921
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_COUNTER_NUMBER 944u

/**
 * The alarm buffer, as the alarm codes that are printed in hexadecimal.
 * Printed as 警報代碼.
 * Read only.
 * See alarm_code.
 * Note: How the 64 elements are divided into blocks is said by parameter 950. In which order the blocks and
 * their elements lie is not printed.
 * Source: 4.1 L922-923
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_CODES_NUMBER 945u
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_CODES_ELEMENTS 64u

/**
 * The alarm buffer, as the internal alarm codes that are printed in decimal.
 * Printed as 內部警報代碼.
 * Read only.
 * See internal_alarm_code.
 * Source: 4.1 L924-925
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_INTERNAL_ALARM_CODES_NUMBER 947u
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_INTERNAL_ALARM_CODES_ELEMENTS 64u

/**
 * How the alarm buffer is divided.
 * Printed as 警報緩衝器容量資訊.
 * Read only.
 * Source: 4.1 L926-927
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BUFFER_CAPACITY_NUMBER 950u
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BUFFER_CAPACITY_ELEMENTS 2u

/**
 * The number of blocks.
 * Printed as 警報儲存區塊的數量.
 * Of alarm_buffer_capacity.
 * Source: 4.1 L927
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BUFFER_CAPACITY_BLOCK_COUNT_SUBINDEX 0u

/**
 * How many alarms one block can hold.
 * Printed as 一個警報儲存區塊裡可記錄的警報訊息的數量.
 * Of alarm_buffer_capacity.
 * Source: 4.1 L927
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BUFFER_CAPACITY_ALARMS_PER_BLOCK_SUBINDEX 1u

/**
 * The number of blocks of the alarm buffer that have been used. Writing 0 clears the whole buffer.
 * Printed as 警報儲存區塊計數器.
 * Read and write.
 * Source: 4.1 L928-929
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ALARM_BLOCK_COUNTER_NUMBER 952u

/**
 * What the drive is.
 * Printed as 驅動器單元識別.
 * Read only.
 * Source: 4.1 L930-933
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_NUMBER 964u
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_ELEMENTS 7u

/**
 * Printed as 製造商.
 * Of drive_identification.
 * Source: 4.1 L935
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_MANUFACTURER_SUBINDEX 0u
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_MANUFACTURER_VALUE 2730u

/**
 * Printed as 驅動器單元類型.
 * Of drive_identification.
 * Source: 4.1 L936
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_DRIVE_UNIT_TYPE_SUBINDEX 1u
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_DRIVE_UNIT_TYPE_VALUE 5u

/**
 * Four decimal digits xxyy: 201 for version 2.1.
 * Printed as 韌體版本.
 * Of drive_identification.
 * Note: The manual names firmware with three numbers, such as 2.8.16; this holds the first two of them. The
 * third may be in the last element (minor version), which is not explained.
 * Source: 4.1 L937
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_FIRMWARE_VERSION_SUBINDEX 2u

/**
 * Four decimal digits yyyy.
 * Printed as 韌體日期 (年).
 * Of drive_identification.
 * Source: 4.1 L938
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_FIRMWARE_YEAR_SUBINDEX 3u

/**
 * Four decimal digits ddmm: the day times 100 plus the month.
 * Printed as 韌體日期 (日 / 月).
 * Of drive_identification.
 * Source: 4.1 L939
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_FIRMWARE_DAY_AND_MONTH_SUBINDEX 4u

/**
 * Printed as DO數量.
 * Of drive_identification.
 * Source: 4.1 L940
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_DRIVE_OBJECT_COUNT_SUBINDEX 5u
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_DRIVE_OBJECT_COUNT_VALUE 1u

/**
 * Printed as 次要韌體版本.
 * Of drive_identification.
 * Source: 4.1 L941
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_DRIVE_IDENTIFICATION_MINOR_FIRMWARE_VERSION_SUBINDEX 6u

/**
 * How the encoder's positions are built.
 * Printed as 編碼器格式.
 * Read only.
 * Note: The manual does not explain the header, the values of the type or the units.
 * Source: 4.1 L942-950
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_NUMBER 979u
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ELEMENTS 31u

/**
 * Printed as 標頭.
 * Of encoder_format.
 * Source: 4.1 L944
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_HEADER_SUBINDEX 0u

/**
 * Printed as 編碼器類型.
 * Of encoder_format.
 * Source: 4.1 L945
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ENCODER_TYPE_SUBINDEX 1u

/**
 * Printed as 編碼器解析度.
 * Of encoder_format.
 * Source: 4.1 L946
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ENCODER_RESOLUTION_SUBINDEX 2u

/**
 * The constant by which the position in G1_XIST1 is shifted.
 * Printed as G1_XIST1的平移常數.
 * Of encoder_format.
 * Source: 4.1 L947
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ACTUAL_POSITION_1_SHIFT_SUBINDEX 3u

/**
 * The constant by which the position in G1_XIST2 is shifted.
 * Printed as G1_XIST2的平移常數.
 * Of encoder_format.
 * Source: 4.1 L948
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_ACTUAL_POSITION_2_SHIFT_SUBINDEX 4u

/**
 * The greatest number of turns.
 * Printed as 最大圈數.
 * Of encoder_format.
 * Source: 4.1 L949
 */
#define HIWIN_E_PAR_PROFIDRIVE_PARAMETERS_ENCODER_FORMAT_MAXIMUM_TURN_COUNT_SUBINDEX 5u

/**
 * The Pt parameters of the drive under the number 2000h + Pt with sub-index 00h: the gain of the speed loop,
 * Pt100, has the number 2100h. The manual details those that matter for PROFINET; the others are in the
 * manuals of the drives.
 * Printed as 2XXXh 伺服Pt參數.
 * On the wire, 0x2000 is added to the numbers of the set.
 * Note: Some others are mentioned without their types: Pt006 and Pt007 (what the analog outputs show), Pt00E
 * and Pt230 to Pt232 (position trigger, its end position in Pt232), Pt012 (its repetition), Pt205 (endless
 * rotation), Pt502 and Pt581 (above which speed TGON is on: by default 20 rpm for rotary motors, 20 mm/s for
 * linear ones; 2.3 L264).
 * Note: An attribute is printed for each but Pt001: setting for Pt53A, value for all others. What the
 * difference is, is not told.
 * Note: Access is not printed. All of them can be set, as the text says.
 * Note: A write takes effect at once unless a restart is printed. Those that take effect when the motor is
 * switched off say so.
 * Source: 4.2 L957
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_BASE 0x2000u
#define HIWIN_E_PAR_SERVO_PARAMETERS_FIRST 0x0000u
#define HIWIN_E_PAR_SERVO_PARAMETERS_LAST 0x0FFFu

/**
 * How a coast stop ends, in the last hexadecimal digit.
 * Printed as Pt001.
 * Pt001 of servo_parameters. A change takes effect after a restart.
 * See basic_function_switch_1.
 * Note: Only the last digit is explained; the others must be kept as they are when it is written.
 * Source: 6.5 L1630-1635
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_BASIC_FUNCTION_SWITCH_1_NUMBER 0x2001u

/**
 * The upper limit of the range in which the position of a modulo axis goes around. The axis is one while this
 * or Pt25C is not 0.
 * Printed as Pt25B 位置 modulo 範圍上限.
 * Pt25B of servo_parameters. With telegram_111.
 * One count is 1 control unit. Range: 0..2147483647.
 * Note: A change while the motor is excited has no effect until it is switched off (L1963).
 * Note: Pt25B less Pt25C may be 2147483647 (7FFFFFFFh) at most; beyond that they have no effect, and AL.980 is
 * raised with one of the bits 12 to 15 of 3120h (L1964-1965).
 * Source: 6.13 L1949-1952
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_UPPER_LIMIT_NUMBER 0x225Bu
#define HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_UPPER_LIMIT_MIN 0
#define HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_UPPER_LIMIT_MAX 2147483647
#define HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_UPPER_LIMIT_DEFAULT 0

/**
 * The lower limit of the range in which the position of a modulo axis goes around.
 * Printed as Pt25C 位置 modulo 範圍下限.
 * Pt25C of servo_parameters. With telegram_111.
 * One count is 1 control unit. Range: -2147483648..0.
 * Note: A change while the motor is excited has no effect until it is switched off (L1963).
 * Note: How the limits count depends on whether this is 0; the two drawings that say it are not in the text
 * (L1967-1978).
 * Note: The least value, -2147483648, makes the range too large for any upper limit (L1964).
 * Source: 6.13 L1954-1957
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_LOWER_LIMIT_NUMBER 0x225Cu
#define HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_LOWER_LIMIT_MIN (-2147483647 - 1)
#define HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_LOWER_LIMIT_MAX 0
#define HIWIN_E_PAR_SERVO_PARAMETERS_MODULO_RANGE_LOWER_LIMIT_DEFAULT 0

/**
 * In speed mode: how long a quick stop, or a stop when the servo is switched off, takes.
 * Printed as Pt30A 伺服 OFF 及強制停止時的減速時間.
 * Pt30A of servo_parameters. With telegram_3, telegram_5, telegram_102, telegram_105.
 * One count is 1 ms. Range: 0..10000.
 * Source: 6.4 L1618-1621
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_QUICK_STOP_DECELERATION_TIME_NUMBER 0x230Au
#define HIWIN_E_PAR_SERVO_PARAMETERS_QUICK_STOP_DECELERATION_TIME_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_QUICK_STOP_DECELERATION_TIME_MAX 10000u
#define HIWIN_E_PAR_SERVO_PARAMETERS_QUICK_STOP_DECELERATION_TIME_DEFAULT 0u

/**
 * The speed that a rotary motor may have at most.
 * Printed as Pt316 馬達最高速度 (旋轉式伺服馬達).
 * Pt316 of servo_parameters. A change takes effect after a restart. For rotary only. With telegram_3,
 * telegram_5, telegram_9, telegram_102, telegram_105, telegram_111.
 * One count is 1 rpm. Range: 0..65535.
 * Source: 6.2 L1580-1583
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_ROTARY_NUMBER 0x2316u
#define HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_ROTARY_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_ROTARY_MAX 65535u
#define HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_ROTARY_DEFAULT 10000u

/**
 * The speed of a rotary motor that a speed setpoint or an actual speed of 100 % stands for.
 * Printed as Pt317 馬達參考速度 (旋轉式伺服馬達).
 * Pt317 of servo_parameters. For rotary only. With telegram_3, telegram_5, telegram_9, telegram_102,
 * telegram_105, telegram_111.
 * One count is 1 rpm. Range: 1..65535.
 * Note: Telegram 9 is in the printed list, though no signal of it is scaled by this parameter.
 * Source: 6.1 L1564-1567
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_ROTARY_NUMBER 0x2317u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_ROTARY_MIN 1u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_ROTARY_MAX 65535u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_ROTARY_DEFAULT 3000u

/**
 * The speed that a linear motor may have at most.
 * Printed as Pt385 馬達最高速度 (直線式伺服馬達).
 * Pt385 of servo_parameters. A change takes effect after a restart. For linear only. With telegram_3,
 * telegram_5, telegram_9, telegram_102, telegram_105, telegram_111.
 * One count is 100 mm/s. Range: 0..100.
 * Source: 6.2 L1585-1588
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_LINEAR_NUMBER 0x2385u
#define HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_LINEAR_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_LINEAR_MAX 100u
#define HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_LINEAR_DEFAULT 50u
#define HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_LINEAR_SCALE_NUMERATOR INT64_C(100)
#define HIWIN_E_PAR_SERVO_PARAMETERS_MAXIMUM_SPEED_LINEAR_SCALE_DENOMINATOR INT64_C(1)

/**
 * The speed of a linear motor that a speed setpoint or an actual speed of 100 % stands for.
 * Printed as Pt386 馬達參考速度 (直線式伺服馬達).
 * Pt386 of servo_parameters. For linear only. With telegram_3, telegram_5, telegram_9, telegram_102,
 * telegram_105, telegram_111.
 * One count is 100 mm/s. Range: 1..100.
 * Note: Telegram 9 is in the printed list, though no signal of it is scaled by this parameter.
 * Source: 6.1 L1569-1572
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_LINEAR_NUMBER 0x2386u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_LINEAR_MIN 1u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_LINEAR_MAX 100u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_LINEAR_DEFAULT 20u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_LINEAR_SCALE_NUMERATOR INT64_C(100)
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_SPEED_LINEAR_SCALE_DENOMINATOR INT64_C(1)

/**
 * The torque that a rotary motor may give at most in the positive direction.
 * Printed as Pt402 正轉轉矩限制.
 * Pt402 of servo_parameters. For rotary only. With telegram_3, telegram_5, telegram_9, telegram_102,
 * telegram_105, telegram_111.
 * One count is 1 %. Range: 0..800.
 * Note: Where telegram 750 gives a limit too, the smaller one counts (6.11.2 L1848).
 * Source: 6.3 L1594-1597
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_TORQUE_LIMIT_NUMBER 0x2402u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_TORQUE_LIMIT_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_TORQUE_LIMIT_MAX 800u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_TORQUE_LIMIT_DEFAULT 800u

/**
 * The torque that a rotary motor may give at most in the negative direction.
 * Printed as Pt403 反轉轉矩限制.
 * Pt403 of servo_parameters. For rotary only. With telegram_3, telegram_5, telegram_9, telegram_102,
 * telegram_105, telegram_111.
 * One count is 1 %. Range: 0..800.
 * Note: Where telegram 750 gives a limit too, the smaller one counts (6.11.2 L1848).
 * Source: 6.3 L1599-1602
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_TORQUE_LIMIT_NUMBER 0x2403u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_TORQUE_LIMIT_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_TORQUE_LIMIT_MAX 800u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_TORQUE_LIMIT_DEFAULT 800u

/**
 * The torque of a rotary motor that a torque value of 100 % stands for.
 * Printed as Pt42A 馬達參考轉矩.
 * Pt42A of servo_parameters. For rotary only. With telegram_102, telegram_105, telegram_750.
 * One count is 0.001 Nm. Range: 0..2147483647.
 * Note: The wizard that sets up the drive replaces the default, 0, by the motor's rated torque (L1824).
 * Note: A change while the motor is excited has no effect until it is switched off (L1826).
 * Source: 6.11 L1812-1815
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_TORQUE_NUMBER 0x242Au
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_TORQUE_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_TORQUE_MAX 2147483647u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_TORQUE_DEFAULT 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_TORQUE_SCALE_NUMERATOR INT64_C(1)
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_TORQUE_SCALE_DENOMINATOR INT64_C(1000)

/**
 * How far the position may move on after the fixed stop was reached in the positive direction; further is
 * AL.EE0.
 * Printed as Pt42B 正轉 fixed stop 監控容許範圍.
 * Pt42B of servo_parameters. With telegram_111.
 * One count is 1 control unit. Range: 0..2147483647.
 * Note: Pt42F must not be less than this.
 * Source: 6.12 L1907-1910
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TOLERANCE_NUMBER 0x242Bu
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TOLERANCE_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TOLERANCE_MAX 2147483647u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TOLERANCE_DEFAULT 100u

/**
 * How far the position may move on after the fixed stop was reached in the negative direction; further is
 * AL.EE0.
 * Printed as Pt42C 反轉 fixed stop 監控容許範圍.
 * Pt42C of servo_parameters. With telegram_111.
 * One count is 1 control unit. Range: 0..2147483647. 0 means as_positive.
 * Note: Pt42F must not be less than this.
 * Source: 6.12 L1912-1915
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TOLERANCE_NUMBER 0x242Cu
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TOLERANCE_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TOLERANCE_MAX 2147483647u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TOLERANCE_DEFAULT 0u

/**
 * The clamping torque, or force, at a fixed stop in the positive direction.
 * Printed as Pt42D 正轉 fixed stop 夾緊轉矩 (推力).
 * Pt42D of servo_parameters. With telegram_111.
 * One count is 0.001 Nm or N. Range: 0..2147483647.
 * Note: The wizard that sets up the drive replaces the default by a tenth of the motor's rated torque (L1936).
 * Source: 6.12 L1917-1920
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TORQUE_NUMBER 0x242Du
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TORQUE_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TORQUE_MAX 2147483647u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TORQUE_DEFAULT 1000000u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TORQUE_SCALE_NUMERATOR INT64_C(1)
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FIXED_STOP_TORQUE_SCALE_DENOMINATOR INT64_C(1000)

/**
 * The clamping torque, or force, at a fixed stop in the negative direction.
 * Printed as Pt42E 反轉 fixed stop 夾緊轉矩 (推力).
 * Pt42E of servo_parameters. With telegram_111.
 * One count is 0.001 Nm or N. Range: 0..2147483647. 0 means as_positive.
 * Source: 6.12 L1922-1925
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TORQUE_NUMBER 0x242Eu
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TORQUE_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TORQUE_MAX 2147483647u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TORQUE_DEFAULT 1000000u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TORQUE_SCALE_NUMERATOR INT64_C(1)
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TORQUE_SCALE_DENOMINATOR INT64_C(1000)

/**
 * The greatest following error of traversing to a fixed stop.
 * Printed as Pt42F Fixed stop 最大追隨誤差值.
 * Pt42F of servo_parameters. With telegram_111.
 * One count is 1 control unit. Range: 0..2147483647.
 * Note: If it is less than Pt42B or Pt42C, the range after the stop is not monitored rightly (L1938).
 * Source: 6.12 L1927-1930
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_FIXED_STOP_FOLLOWING_ERROR_NUMBER 0x242Fu
#define HIWIN_E_PAR_SERVO_PARAMETERS_FIXED_STOP_FOLLOWING_ERROR_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_FIXED_STOP_FOLLOWING_ERROR_MAX 2147483647u
#define HIWIN_E_PAR_SERVO_PARAMETERS_FIXED_STOP_FOLLOWING_ERROR_DEFAULT 1000u

/**
 * The force of a linear motor that a torque value of 100 % stands for.
 * Printed as Pt43A 馬達參考推力.
 * Pt43A of servo_parameters. For linear only. With telegram_102, telegram_105, telegram_750.
 * One count is 0.001 N. Range: 0..2147483647.
 * Note: The wizard that sets up the drive replaces the default, 0, by the motor's rated value; the print says
 * torque for both motors (L1824).
 * Note: A change while the motor is excited has no effect until it is switched off (L1826).
 * Source: 6.11 L1817-1820
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_FORCE_NUMBER 0x243Au
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_FORCE_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_FORCE_MAX 2147483647u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_FORCE_DEFAULT 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_FORCE_SCALE_NUMERATOR INT64_C(1)
#define HIWIN_E_PAR_SERVO_PARAMETERS_REFERENCE_FORCE_SCALE_DENOMINATOR INT64_C(1000)

/**
 * The force that a linear motor may give at most in the positive direction while the internal force limit is
 * in use.
 * Printed as Pt483 正方向的推力限制值（直線式伺服馬達）.
 * Pt483 of servo_parameters. For linear only. With telegram_3, telegram_5, telegram_9, telegram_102,
 * telegram_105, telegram_111.
 * One count is 1 %. Range: 0..800.
 * Note: Where telegram 750 gives a limit too, the smaller one counts (6.11.2 L1848).
 * Source: 6.3 L1604-1607
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FORCE_LIMIT_NUMBER 0x2483u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FORCE_LIMIT_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FORCE_LIMIT_MAX 800u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POSITIVE_FORCE_LIMIT_DEFAULT 30u

/**
 * The force that a linear motor may give at most in the negative direction while the internal force limit is
 * in use.
 * Printed as Pt484 反方向的推力限制值（直線式伺服馬達）.
 * Pt484 of servo_parameters. For linear only. With telegram_3, telegram_5, telegram_9, telegram_102,
 * telegram_105, telegram_111.
 * One count is 1 %. Range: 0..800.
 * Note: Where telegram 750 gives a limit too, the smaller one counts (6.11.2 L1848).
 * Source: 6.3 L1609-1612
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FORCE_LIMIT_NUMBER 0x2484u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FORCE_LIMIT_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FORCE_LIMIT_MAX 800u
#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FORCE_LIMIT_DEFAULT 30u

/**
 * The jog speed of a rotary motor.
 * Printed as Pt533 程式 P2P 移動速度.
 * Pt533 of servo_parameters. For rotary only. With telegram_9, telegram_111.
 * One count is 1 rpm. Range: 1..10000.
 * Note: With a direct drive motor the default is 60 rpm (L1677).
 * Note: With telegram 111 the signal OVERRIDE acts on it too (L1670).
 * Source: 6.8 L1672-1675
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_ROTARY_NUMBER 0x2533u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_ROTARY_MIN 1u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_ROTARY_MAX 10000u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_ROTARY_DEFAULT 600u

/**
 * The acceleration that MDI_ACC refers to; it is given as a time.
 * Printed as Pt534 程式 P2P 加速時間.
 * Pt534 of servo_parameters. With telegram_9, telegram_111.
 * One count is 1 ms. Range: 2..10000.
 * Source: 6.6.1 L1652-1655
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_ACCELERATION_TIME_NUMBER 0x2534u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_ACCELERATION_TIME_MIN 2u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_ACCELERATION_TIME_MAX 10000u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_ACCELERATION_TIME_DEFAULT 100u

/**
 * The deceleration that MDI_DEC refers to; it is given as a time.
 * Printed as Pt537 程式 P2P 減速時間.
 * Pt537 of servo_parameters. With telegram_9, telegram_111.
 * One count is 1 ms. Range: 2..10000.
 * Source: 6.6.1 L1659-1662
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DECELERATION_TIME_NUMBER 0x2537u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DECELERATION_TIME_MIN 2u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DECELERATION_TIME_MAX 10000u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DECELERATION_TIME_DEFAULT 100u

/**
 * In position mode: how long a quick stop takes.
 * Printed as Pt538 程式 P2P 緊急減速時間.
 * Pt538 of servo_parameters. With telegram_9, telegram_111.
 * One count is 1 ms. Range: 2..10000.
 * Source: 6.4 L1623-1626
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_EMERGENCY_DECELERATION_TIME_NUMBER 0x2538u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_EMERGENCY_DECELERATION_TIME_MIN 2u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_EMERGENCY_DECELERATION_TIME_MAX 10000u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_EMERGENCY_DECELERATION_TIME_DEFAULT 10u

/**
 * How far one jog goes in the incremental jog mode.
 * Printed as Pt539 程式 P2P 相對移動距離.
 * Pt539 of servo_parameters. With telegram_9, telegram_111.
 * One count is 1 control unit. Range: 1..1073741824.
 * Source: 6.8 L1700-1703
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DISTANCE_NUMBER 0x2539u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DISTANCE_MIN 1
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DISTANCE_MAX 1073741824
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_DISTANCE_DEFAULT 32768

/**
 * Exchanges the directions of JOG 1 and JOG 2: JOG 1 (STW1.8) then goes in the negative direction.
 * Printed as Pt53A PROFIdrive JOG 模式吋動 方向反轉設定.
 * Pt53A of servo_parameters. With telegram_9, telegram_111.
 * Range: 0..1.
 * Note: The printed type is Uint16.
 * Source: 3.3.2 L621-624
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_JOG_DIRECTION_REVERSED_NUMBER 0x253Au
#define HIWIN_E_PAR_SERVO_PARAMETERS_JOG_DIRECTION_REVERSED_MIN 0u
#define HIWIN_E_PAR_SERVO_PARAMETERS_JOG_DIRECTION_REVERSED_MAX 1u
#define HIWIN_E_PAR_SERVO_PARAMETERS_JOG_DIRECTION_REVERSED_DEFAULT 0u

/**
 * The jog speed of a linear motor.
 * Printed as Pt585 程式 P2P 移動速度 (直線式伺服馬達).
 * Pt585 of servo_parameters. For linear only. With telegram_9, telegram_111.
 * One count is 1 mm/s. Range: 1..10000.
 * Note: With telegram 111 the signal OVERRIDE acts on it too (L1670).
 * Source: 6.8 L1679-1682
 */
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_LINEAR_NUMBER 0x2585u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_LINEAR_MIN 1u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_LINEAR_MAX 10000u
#define HIWIN_E_PAR_SERVO_PARAMETERS_POINT_TO_POINT_SPEED_LINEAR_DEFAULT 50u

/* ---- Values that stand for a state ---- */

#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TOLERANCE_ABSENT_AS_POSITIVE 0u /**< servo_parameters.negative_fixed_stop_tolerance: as_positive. Pt42B counts for both directions. */

#define HIWIN_E_PAR_SERVO_PARAMETERS_NEGATIVE_FIXED_STOP_TORQUE_ABSENT_AS_POSITIVE 0u /**< servo_parameters.negative_fixed_stop_torque: as_positive. Pt42D counts for both directions. */

#endif
