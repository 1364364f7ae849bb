// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_RANDOM_H
#define BOOMERANG_TESTBED_RANDOM_H

#include <memory>

#include <box2d/b2_math.h>
#include <gsl/gsl_rng.h>

namespace testbed {

/// The scenes' only source of chance: the same seed gives the same scene on every machine (GSL's mt19937).
class Random {
public:
    explicit Random(unsigned long seed);

    /// In [low, high).
    float Uniform(float low, float high);
    /// In [0, count); count > 0.
    int Index(int count);
    /// True once in `times` calls on average.
    bool OnceIn(int times) { return Index(times) == 0; }
    /// Of length in [low, high) and any direction.
    b2Vec2 Direction(float low, float high);

private:
    struct Free {
        void operator()(gsl_rng *generator) const { gsl_rng_free(generator); }
    };
    std::unique_ptr<gsl_rng, Free> m_generator;
};

} // namespace testbed

#endif
