// SPDX-License-Identifier: MIT
#include "tell/verify.h"

#include <atomic>
#include <cinttypes>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include <box2d/b2_body.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_time_of_impact.h>

#include "start/settings.h"
#include "start/this_process.h"
#include "tell/exit_line.h"

namespace bmr {

namespace {

std::atomic<bool> reported{false};

/// Where a fixture is, for a reader who looks for it in his own program: Box2D gives bodies no names.
struct Place {
    char text[160];
};

Place PlaceOf(const b2Fixture *fixture) {
    Place place;
    if (fixture == nullptr) {
        std::snprintf(place.text, sizeof place.text, "an unknown fixture");
        return place;
    }
    const b2Body *body = fixture->GetBody();
    const b2Vec2 &at = body->GetPosition();
    std::snprintf(place.text, sizeof place.text, "fixture %p of body %p (at %.9g, %.9g, angle %.9g)",
                  static_cast<const void *>(fixture), static_cast<const void *>(body),
                  static_cast<double>(at.x), static_cast<double>(at.y),
                  static_cast<double>(body->GetAngle()));
    return place;
}

/// Equal, or neither is a number.
bool Same(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

bool Same(const b2Vec2 &a, const b2Vec2 &b) {
    return Same(a.x, b.x) && Same(a.y, b.y);
}

const char *NameOf(b2TOIOutput::State state) {
    switch (state) {
    case b2TOIOutput::e_unknown:
        return "unknown";
    case b2TOIOutput::e_failed:
        return "failed";
    case b2TOIOutput::e_overlapped:
        return "overlapped";
    case b2TOIOutput::e_touching:
        return "touching";
    case b2TOIOutput::e_separated:
        break;
    }
    return "separated";
}

/// The first field that differs and has a meaning, or nullptr.
const char *FieldThatDiffers(const b2Manifold &a, const b2Manifold &b) {
    if (a.pointCount != b.pointCount)
        return "pointCount";
    if (a.pointCount == 0)
        return nullptr; // stock leaves the rest as it was
    if (a.type != b.type)
        return "type";
    if (!Same(a.localNormal, b.localNormal))
        return "localNormal";
    if (!Same(a.localPoint, b.localPoint))
        return "localPoint";
    for (int32 i = 0; i < a.pointCount; ++i) {
        if (!Same(a.points[i].localPoint, b.points[i].localPoint))
            return "points.localPoint";
        if (a.points[i].id.key != b.points[i].id.key)
            return "points.id";
    }
    return nullptr;
}

// Counts that a forked process has from its parent.
std::atomic<uint64_t> verifiedBefore{0}, differencesBefore{0};
long installedIn;

/// A number as it is read: 498,299.
struct Grouped {
    explicit Grouped(uint64_t number) {
        char *at = text + sizeof text - 1;
        *at = '\0';
        for (int digits = 0; digits == 0 || number != 0; ++digits, number /= 10) {
            if (digits != 0 && digits % 3 == 0)
                *--at = ',';
            *--at = static_cast<char>('0' + number % 10);
        }
        first = at;
    }
    Grouped(const Grouped &) = delete;
    Grouped &operator=(const Grouped &) = delete;

    char text[32];
    const char *first;
};

void SayVerified() {
    const uint64_t verified = GetCounts().verified - verifiedBefore;
    if (verified == 0 && ThisProcess() != installedIn)
        return;
    std::fprintf(stderr, "boomerang: verified %s answers, %s differ\n", Grouped(verified).first,
                 Grouped(GetCounts().differences - differencesBefore).first);
}

} // namespace

void SayVerifiedAtExit() {
    installedIn = ThisProcess();
    CallWhenForked([] {
        verifiedBefore = GetCounts().verified.load();
        differencesBefore = GetCounts().differences.load();
    });
    CallAtEnd(SayVerified);
}

void CountVerified() {
    GetCounts().verified.fetch_add(1, std::memory_order_relaxed);
}

void ReportDifference(const char *door, const b2Fixture *fixtureA, const b2Fixture *fixtureB,
                      const char *format, ...) {
    GetCounts().differences.fetch_add(1, std::memory_order_relaxed);
    if (reported.exchange(true))
        return;
    char what[200];
    va_list arguments;
    va_start(arguments, format);
    // NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized): va_start is one line above
    std::vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    std::fprintf(stderr, "boomerang: first difference from Box2D, step %" PRIu64 ", %s: %s; %s against %s\n",
                 GetCounts().steps.load(), door, what, PlaceOf(fixtureA).text, PlaceOf(fixtureB).text);
}

void VerifyManifold(const b2Fixture *fixtureA, const b2Fixture *fixtureB, const b2Manifold &ours,
                    const b2Manifold &box2d) {
    CountVerified();
    if (const char *field = FieldThatDiffers(ours, box2d))
        ReportDifference("polygon manifold", fixtureA, fixtureB, "%s (%d points here, %d in Box2D)", field,
                         ours.pointCount, box2d.pointCount);
}

void VerifyImpact(const b2Fixture *fixtureA, const b2Fixture *fixtureB, const b2TOIOutput &ours,
                  const b2TOIOutput &box2d) {
    CountVerified();
    const bool touches = box2d.state == b2TOIOutput::e_touching;
    if ((ours.state == b2TOIOutput::e_touching) != touches || (touches && !Same(ours.t, box2d.t)))
        ReportDifference("time of impact", fixtureA, fixtureB, "%s at %.9g here, %s at %.9g in Box2D",
                         NameOf(ours.state), static_cast<double>(ours.t), NameOf(box2d.state),
                         static_cast<double>(box2d.t));
}

void VerifyOverlap(const b2Fixture *fixtureA, const b2Fixture *fixtureB, bool ours, bool box2d) {
    CountVerified();
    if (ours != box2d)
        ReportDifference("sensor overlap", fixtureA, fixtureB, "%s here, %s in Box2D",
                         ours ? "overlap" : "apart", box2d ? "overlap" : "apart");
}

} // namespace bmr
