/** What a function has to say. */
typedef enum device_codec_status {
    DEVICE_OK = 0, /**< It is done. */
    DEVICE_ERR_INCOMPLETE = 1, /**< There are too few bytes. */
    DEVICE_ERR_WRONG_LENGTH = 2, /**< The bytes, or elements, are not as many as they must be. */
    DEVICE_ERR_WRONG_MARK = 3, /**< The frame does not start or end with its mark. */
    DEVICE_ERR_NOT_HEX = 4, /**< A character is no hexadecimal digit. */
    DEVICE_ERR_WRONG_CHECK = 5, /**< The check does not fit the bytes. */
    DEVICE_ERR_UNKNOWN_CODE = 6, /**< No message has this code. */
    DEVICE_ERR_UNKNOWN_VALUE = 7, /**< The value is none of those that there are. */
    DEVICE_ERR_WRONG_CONST = 8, /**< A constant has another value. */
    DEVICE_ERR_WRONG_MEASURE = 9, /**< A field that holds a size does not fit what it measures. */
    DEVICE_ERR_OUT_OF_RANGE = 10, /**< A value is out of its range. */
    DEVICE_ERR_CAPACITY = 11 /**< The buffer is too small. */
} device_codec_status;
