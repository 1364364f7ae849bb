// SPDX-License-Identifier: MIT
// Why a world stopped, and because of whom.
#include "world/parts.h"

const char *bmr_trouble_describe(bmr_trouble trouble) {
    switch (trouble) {
    case BMR_TROUBLE_NONE:
        return "nothing is wrong";
    case BMR_TROUBLE_CONTACTS:
        return "the two have contact after contact, each nearer than the last, and no answer takes them "
               "apart: they rest on each other, or others keep pushing them together, or the answer ends "
               "nothing; BMR_ZENO_ELASTIC ends most of it, and so do a restitution nearer to 1 and a larger "
               "margin";
    case BMR_TROUBLE_REPAIRS:
        return "the structure of the two fails again as soon as it is repaired: take a larger margin, or "
               "another structure";
    case BMR_TROUBLE_PROOF:
        return "the two are apart by less than their structure can prove: take a larger margin, or another "
               "structure";
    case BMR_TROUBLE_SPEED:
        return "it moves farther within a rounding of the time than can be told apart, and might pass "
               "through another one unseen: take a slower one, a larger margin, or times nearer to 0";
    case BMR_TROUBLE_PLACE:
        return "it has come so far that there are no larger cells, or no digits left in its place: remove "
               "it, or put it back";
    case BMR_TROUBLE_ANSWER:
        return "the answer to the contact of the two makes no sense: a restitution is from 0 to 1, and a "
               "response one of bmr_response_kind";
    case BMR_TROUBLE_EVENTS:
        return "so many events as most_events allows have been in this call: call again to go on";
    case BMR_TROUBLE_OTHER:
        return "the error says what";
    case BMR_TROUBLE_COUNT:
        break;
    }
    return "not a trouble of this library";
}

bmr_error bmr_world_stop(bmr_world *w, bmr_error error, bmr_trouble kind, bmr_body a, bmr_body b) {
    w->trouble.error = error;
    w->trouble.kind = kind;
    w->trouble.a = a;
    w->trouble.b = b;
    w->trouble.time = w->time;
    return error;
}

bmr_world_trouble bmr_world_get_trouble(const bmr_world *w) {
    return w->trouble;
}
