// SPDX-License-Identifier: MIT
#include "stage.h"

#include <cmath>

namespace testbed {

Random::Random(unsigned long seed) : m_generator(gsl_rng_alloc(gsl_rng_mt19937)) {
    gsl_rng_set(m_generator.get(), seed);
}

float Random::Uniform(float low, float high) {
    return low + (high - low) * static_cast<float>(gsl_rng_uniform(m_generator.get()));
}

int Random::Index(int count) {
    return static_cast<int>(gsl_rng_uniform_int(m_generator.get(), static_cast<unsigned long>(count)));
}

b2Vec2 Random::Direction(float low, float high) {
    // Two statements: the order in which a compiler evaluates arguments must not decide the scene.
    const float length = Uniform(low, high);
    const float angle = Uniform(-b2_pi, b2_pi);
    return {length * std::cos(angle), length * std::sin(angle)};
}

} // namespace testbed
