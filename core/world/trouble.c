// SPDX-License-Identifier: MIT
// Why a world stopped, and because of whom.
#include "world/parts.h"

const char *bmr_trouble_describe(bmr_trouble trouble) {
    switch (trouble) {
    case BMR_TROUBLE_NONE:
        return "nothing is wrong";
    case BMR_TROUBLE_CONTACTS:
        return "contact after contact, each nearer than the last, and no answer takes them apart: they rest "
               "on each other, or others push them together, or the answer ends nothing; BMR_ZENO_ELASTIC, "
               "more restitution or a larger margin helps";
    case BMR_TROUBLE_REPAIRS:
        return "their structure fails again as soon as it is repaired: take a larger margin, or another "
               "structure";
    case BMR_TROUBLE_PROOF:
        return "they are apart by less than their structure can prove: take a larger margin, or another "
               "structure";
    case BMR_TROUBLE_SPEED:
        return "so much way in one rounding of the time that contacts could be missed: take slower bodies, a "
               "larger margin, or times nearer to 0";
    case BMR_TROUBLE_PLACE:
        return "so far away that there are no larger cells, or no digits left in its place: remove it, or "
               "put "
               "it back";
    case BMR_TROUBLE_ANSWER:
        return "the answer to their contact makes no sense: a restitution is from 0 to 1, and a response one "
               "of bmr_response_kind";
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
