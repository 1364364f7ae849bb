// SPDX-License-Identifier: MIT
// What the stage of a scene is to the testbed, the actor's world is here. (Not in programs that have both.)
#include "state/snapshot.h"

namespace testbed {

namespace {
template <typename Object> uint32_t ReadNumber(const Object &object) {
    return static_cast<uint32_t>(const_cast<Object &>(object).GetUserData().pointer);
}
} // namespace

uint32_t NumberOf(const b2Body &body) {
    return ReadNumber(body);
}
uint32_t NumberOf(const b2Fixture &fixture) {
    return ReadNumber(fixture);
}
uint32_t NumberOf(const b2Joint &joint) {
    return ReadNumber(joint);
}

} // namespace testbed
