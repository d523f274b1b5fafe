/** The texts of a code. Line ends separate several causes or remedies. `printed` is the code as the manual writes it;
 * `number` is the second number that the manual gives the code, or -1. */
typedef struct device_code_text {
    int64_t code;
    int64_t number;
    const char *printed;
    const char *name;
    const char *label;
    const char *problem;
    const char *causes;
    const char *remedies;
} device_code_text;
