#pragma once

#include <cstdint>
#include <random>

namespace demos
{

/// Uniform numbers whose sequence the standard fixes, unlike that of its distributions.
class Uniform
{
public:
    explicit Uniform(std::uint32_t seed) : engine_(seed) {}

    double between(double low, double high)
    {
        const double share = static_cast<double>(engine_() >> 11) * 0x1p-53;
        return low + (high - low) * share;
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace demos
