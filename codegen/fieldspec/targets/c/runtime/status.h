/** The result of a codec call. */
typedef enum device_codec_status {
    DEVICE_OK = 0, /**< No error. */
    DEVICE_ERR_INCOMPLETE = 1, /**< There are too few bytes. */
    DEVICE_ERR_WRONG_LENGTH = 2, /**< The number of bytes or elements is wrong. */
    DEVICE_ERR_WRONG_MARK = 3, /**< A delimiter of the frame is missing or wrong. */
    DEVICE_ERR_NOT_HEX = 4, /**< A character is not a hexadecimal digit. */
    DEVICE_ERR_WRONG_CHECKSUM = 5, /**< The checksum does not match. */
    DEVICE_ERR_UNKNOWN_CODE = 6, /**< No message has this code. */
    DEVICE_ERR_UNKNOWN_VALUE = 7, /**< The value is not a member of its enum, or the text is not ASCII. */
    DEVICE_ERR_WRONG_CONST = 8, /**< A constant field has another value. */
    DEVICE_ERR_WRONG_MEASURE = 9, /**< A length or count field does not match the data. */
    DEVICE_ERR_OUT_OF_RANGE = 10, /**< A value is out of range. */
    DEVICE_ERR_CAPACITY = 11 /**< The buffer is too small. */
} device_codec_status;
