// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_FIELDS_H
#define BOOMERANG_TESTBED_FIELDS_H

#include "recording/recording.h"

/// @file
/// Each kind of object in a recording lists its fields once: for text and for bytes, for writing and for
/// reading.

namespace testbed::recording {

template <typename Visit> void Fields(const Head *, Visit visit) {
    visit("version", &Head::version);
    visit("scene", &Head::scene);
    visit("program", &Head::program);
    visit("structure", &Head::structure);
    visit("size", &Head::size);
    visit("seed", &Head::seed);
    visit("time_step", &Head::time_step);
    visit("first", &Head::first);
    visit("last", &Head::last);
    visit("every", &Head::every);
    visit("counts_calls", &Head::counts_calls);
    visit("period", &Head::period);
}

template <typename Visit> void Fields(const Fixture *, Visit visit) {
    visit("body", &Fixture::body);
    visit("number", &Fixture::number);
    visit("shape", &Fixture::shape);
    visit("points", &Fixture::points);
    visit("radius", &Fixture::radius);
    visit("inner", &Fixture::inner);
    visit("sensor", &Fixture::sensor);
}

template <typename Visit> void Fields(const Body *, Visit visit) {
    visit("number", &Body::number);
    visit("type", &Body::type);
    visit("pose", &Body::pose);
    visit("asleep", &Body::asleep);
    visit("disabled", &Body::disabled);
    visit("bullet", &Body::bullet);
}

template <typename Visit> void Fields(const Joint *, Visit visit) {
    visit("number", &Joint::number);
    visit("type", &Joint::type);
    visit("bodies", &Joint::bodies);
    visit("anchors", &Joint::anchors);
    visit("segments", &Joint::segments);
}

template <typename Visit> void Fields(const ContactPoint *, Visit visit) {
    visit("at", &ContactPoint::at);
    visit("impulse", &ContactPoint::impulse);
}

template <typename Visit> void Fields(const Contact *, Visit visit) {
    visit("bodies", &Contact::bodies);
    visit("fixtures", &Contact::fixtures);
    visit("normal", &Contact::normal);
    visit("points", &Contact::points);
}

template <typename Visit> void Fields(const Outline *, Visit visit) {
    visit("id", &Outline::id);
    visit("body", &Outline::body);
    visit("points", &Outline::points);
}

template <typename Visit> void Fields(const Proof *, Visit visit) {
    visit("kind", &Proof::kind);
    visit("fixtures", &Proof::fixtures);
    visit("contacts", &Proof::contacts);
    visit("slack", &Proof::slack);
    visit("owner", &Proof::owner);
    visit("level", &Proof::level);
    visit("normal", &Proof::normal);
    visit("edge", &Proof::edge);
    visit("opposite", &Proof::opposite);
    visit("supports", &Proof::supports);
    visit("centres", &Proof::centres);
    visit("radii", &Proof::radii);
    visit("hulls", &Proof::hulls);
    visit("envelopes", &Proof::envelopes);
}

template <typename Visit> void Fields(const Calls *, Visit visit) {
    visit("polygon_tests", &Calls::polygon_tests);
    visit("toi", &Calls::toi);
    visit("distance", &Calls::distance);
    visit("overlap", &Calls::overlap);
}

template <typename Visit> void Fields(const Pair *, Visit visit) {
    visit("a", &Pair::a);
    visit("b", &Pair::b);
    visit("contacts", &Pair::contacts);
    visit("polygon_contacts", &Pair::polygon_contacts);
    visit("touching", &Pair::touching);
    visit("closest", &Pair::closest);
    visit("distance", &Pair::distance);
    visit("slack", &Pair::slack);
    visit("proofs", &Pair::proofs);
    visit("proofs_kept", &Pair::proofs_kept);
    visit("asked", &Pair::asked);
    visit("handed_over", &Pair::handed_over);
    visit("calls", &Pair::calls);
}

template <typename Visit> void Fields(const Event *, Visit visit) {
    visit("step", &Event::step);
    visit("kind", &Event::kind);
    visit("a", &Event::a);
    visit("b", &Event::b);
    visit("level_before", &Event::level_before);
    visit("level_after", &Event::level_after);
    visit("gap", &Event::gap);
}

template <typename Visit> void Fields(const Frame *, Visit visit) {
    visit("step", &Frame::step);
    visit("bodies", &Frame::bodies);
    visit("fixtures", &Frame::fixtures);
    visit("gone", &Frame::gone);
    visit("boxes", &Frame::boxes);
    visit("joints", &Frame::joints);
    visit("touching", &Frame::touching);
    visit("outlines", &Frame::outlines);
    visit("pairs", &Frame::pairs);
    visit("events", &Frame::events);
    visit("calls", &Frame::calls);
}

} // namespace testbed::recording

#endif
