/** The texts of a code. Several causes, or remedies, are parted by line ends.
 * The number is the other one under which the manual knows the code, or -1; printed is how the manual writes it. */
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
