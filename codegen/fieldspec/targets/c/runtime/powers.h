/** 10^0 to 10^22, the powers of ten that a double has exactly. */
static inline double device_power_of_ten(int32_t exponent)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    return powers[exponent];
}

/** number * 10^exponent, with an exponent from -22 to 22. */
static inline double device_times_power(double number, int32_t exponent)
{
    return exponent < 0 ? number / device_power_of_ten(-exponent) : number * device_power_of_ten(exponent);
}

/** number / 10^exponent, with an exponent from -22 to 22. */
static inline double device_over_power(double number, int32_t exponent)
{
    return exponent < 0 ? number * device_power_of_ten(-exponent) : number / device_power_of_ten(exponent);
}
