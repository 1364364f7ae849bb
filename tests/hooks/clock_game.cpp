// SPDX-License-Identifier: MIT
//
//   clock_game
//
// Is b2Timer right, and b2Profile filled? Any program of Box2D's; run with the plugin in front of it. Exit
// status 0: it is; else what is wrong is said.
#include <chrono>
#include <cstdio>
#include <thread>

#include <box2d/box2d.h>

namespace {

int failures = 0;

void Expect(bool holds, const char *claim) {
    if (!holds)
        std::printf("FAILED: %s\n", claim);
    failures += !holds;
}

double Milliseconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

/// A timer's reading lies between what the steady clock says inside and outside of it, up to a thousandth and
/// the microsecond that Box2D's own clock counts in. (However long the thread was interrupted in between.)
bool Agrees(double read, double inside, double outside) {
    return read >= 0.999 * inside - 0.001 && read <= 1.001 * outside + 0.001;
}

void StepAWhile(b2World &world, double milliseconds) {
    for (const double start = Milliseconds(); Milliseconds() - start < milliseconds;)
        world.Step(1.0f / 60.0f, 8, 3);
}

void CheckTimer(int milliseconds) {
    const double before = Milliseconds();
    b2Timer timer;
    const double inside = Milliseconds();
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    const double insideEnd = Milliseconds();
    const auto read = static_cast<double>(timer.GetMilliseconds());
    const double after = Milliseconds();
    Expect(Agrees(read, insideEnd - inside, after - before), "a timer reads what the steady clock does");
    Expect(!Agrees(1.01 * read, insideEnd - inside, after - before) ||
               after - before > 1.005 * (insideEnd - inside),
           "control: a hundredth more would be noticed");
    const double resetting = Milliseconds();
    timer.Reset();
    const auto anew = static_cast<double>(timer.GetMilliseconds());
    Expect(Agrees(anew, 0.0, Milliseconds() - resetting), "Reset starts anew");
    Expect(!Agrees(read + anew, 0.0, Milliseconds() - resetting) || Milliseconds() - resetting > 0.9 * read,
           "control: a timer that was not reset would be noticed");
}

} // namespace

int main() {
    const double before = Milliseconds();
    b2Timer oldest; // started before the plugin knows anything
    const double after = Milliseconds();
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    def.type = b2_dynamicBody;
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    for (int i = 0; i < 50; ++i) {
        def.position.Set(2.0f * static_cast<float>(i), 0.0f);
        world.CreateBody(&def)->CreateFixture(&box, 1.0f);
    }
    CheckTimer(5); // while the rate is not known
    StepAWhile(world, 60.0);
    CheckTimer(50);
    StepAWhile(world, 200.0);
    CheckTimer(50);
    b2Timer step;
    world.Step(1.0f / 60.0f, 8, 3);
    const float whole = step.GetMilliseconds();
    const b2Profile &profile = world.GetProfile();
    Expect(profile.step > 0.0f && profile.step <= 1.01f * whole + 0.002f,
           "the profile's step is inside the step");
    Expect(profile.solve > 0.0f && profile.collide + profile.solve <= 1.01f * profile.step + 0.002f,
           "and its parts are inside that");
    const double inside = Milliseconds() - after;
    const auto read = static_cast<double>(oldest.GetMilliseconds());
    Expect(Agrees(read, 0.99 * inside, 1.01 * (Milliseconds() - before)),
           "a timer that is older than the plugin's clock is read by its own");
    if (failures == 0)
        std::printf("passed\n");
    return failures != 0;
}
