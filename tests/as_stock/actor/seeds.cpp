// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <string>

#include "../../kit/random.h"
#include "actor.h"

namespace actor {

uint8_t ReactionOf(const char *name) {
    for (uint32_t i = 0; i < kReactionCount; ++i)
        if (std::strcmp(kReactions[i].name, name) == 0)
            return static_cast<uint8_t>(i);
    return 0;
}

namespace {

enum Flag : uint8_t { kWeightless = 2, kSubStepping = 4, kBin = 8, kAnySize = 32, kLarge = 64 };

class Writer {
public:
    explicit Writer(uint32_t seed) : m_random{seed} {}
    std::vector<uint8_t> bytes;

    uint32_t Below(uint32_t n) { return test_random_below(&m_random, n); }
    bool OnceIn(uint32_t n) { return Below(n) == 0; }
    void Put(std::initializer_list<int> more) {
        for (const int byte : more)
            bytes.push_back(static_cast<uint8_t>(byte));
    }
    void PutAny(int count) {
        for (; count > 0; --count)
            bytes.push_back(static_cast<uint8_t>(Below(256)));
    }
    /// An action, what it reads first, and the rest of it by chance.
    void Act(const char *name, std::initializer_list<int> first = {}) {
        for (int i = 0; i < Actor::kActionCount; ++i) {
            if (std::strcmp(Actor::kActions[i].name, name) != 0)
                continue;
            Put({i});
            Put(first);
            PutAny(Actor::kActions[i].bytes - static_cast<int>(first.size()));
            return;
        }
    }
    /// Names have bars between them.
    void ActAny(const char *names) { Act(OneOf(names).c_str()); }
    void Steps(uint32_t count) {
        for (; count > 0; --count)
            Put({160 + (OnceIn(3) ? 4 : 0)});
    }
    /// What listeners do: one thing of these at every call, or some of them at half of all, or at few.
    void Listen(const char *names) {
        Put({IndexOf("SetReactions"), World::kReactionsHeld - 1});
        const uint32_t way = Below(3);
        const uint8_t always = AnyOf(names);
        for (int i = 0; i < World::kReactionsHeld; ++i) {
            const uint8_t reaction = AnyOf(names);
            Put({way == 0 ? always : OnceIn(way == 1 ? 2 : 8) ? reaction : 0});
        }
    }
    uint8_t AnyOf(const char *names) { return ReactionOf(OneOf(names).c_str()); }
    std::string OneOf(const char *names) {
        const char *const end = names + std::strlen(names);
        for (auto skip = Below(1 + static_cast<uint32_t>(std::count(names, end, '|'))); skip > 0; --skip)
            names = std::find(names, end, '|') + 1;
        return std::string(names, std::find(names, end, '|'));
    }
    static int IndexOf(const char *name) {
        int i = 0;
        while (std::strcmp(Actor::kActions[i].name, name) != 0)
            ++i;
        return i;
    }

private:
    test_random m_random;
};

/// Any script: a few bodies, then steps with actions between them.
void WriteSmall(Writer &w) {
    for (uint32_t i = 3 + w.Below(11); i > 0; --i) {
        w.Put({static_cast<int>(w.Below(5)),
               w.OnceIn(2) ? 8 * static_cast<int>(w.Below(4)) : static_cast<int>(w.Below(256))});
        w.PutAny(2);
        w.Put({w.OnceIn(3) ? static_cast<int>(w.Below(256)) : 0});
        w.PutAny(2 + static_cast<int>(w.Below(4)));
    }
    for (uint32_t i = 4 + w.Below(12); i > 0; --i) {
        w.Put({160 + static_cast<int>(w.Below(96))});
        for (uint32_t k = w.Below(4); k > 0; --k) {
            const uint32_t code = w.Below(78);
            w.Put({static_cast<int>(code)});
            w.PutAny(w.OnceIn(4) ? static_cast<int>(w.Below(5)) : Actor::kActions[code].bytes);
        }
    }
}

/// Two bodies of seven upright boxes in a diagonal row beside each other, whose vertices are pulled about.
void WriteRows(Writer &w) {
    const int aside = 15 + static_cast<int>(w.Below(3));
    for (const int at : {0, aside}) {
        w.Put({0, 192, -at & 255, at, 0, 5});
        for (int i = -3; i <= 3; ++i) {
            w.Put({8, 0, 4, 2, 1});
            for (const int corner : {0, 1, 2, 3})
                w.Put({(26 * i + (corner == 1 || corner == 2 ? 24 : -24)) & 255,
                       (26 * i + (corner < 2 ? -24 : 24)) & 255});
        }
    }
    w.Put({160});
    for (int step = 0; step < 24; ++step) {
        for (int body = 0; body < 2; ++body) {
            w.Put({26, body, static_cast<int>(w.Below(7)), 0xE1, 0x0F});
            for (int i = 0; i < 4; ++i)
                w.Put({static_cast<int>(w.Below(7)), static_cast<int>(w.Below(4)),
                       static_cast<int>(w.Below(256))});
        }
        w.Put({160});
    }
}

/// An arena in which anything happens between any two steps.
void WriteArena(Writer &w) {
    w.Act("BuildLevel", {static_cast<int>(w.Below(128)) & ~2});
    for (uint32_t i = 4 + w.Below(8); i > 0; --i)
        w.Act("CreateCompound");
    w.Act("Throng", {static_cast<int>(w.Below(16)) & ~2, 4 + static_cast<int>(w.Below(12)), 30});
    w.Listen("disables|sets friction|sets restitution|sets tangent speed|refilters|switches bullet|switches "
             "another bullet|puts to sleep|wakes another or not|makes a sensor or solid, with care|reads "
             "contacts|reads edges|exchanges itself|draws|edits a shape|sets filter data");
    for (uint32_t i = 40 + w.Below(40); i > 0; --i) {
        for (uint32_t k = w.Below(4); k > 0; --k)
            w.ActAny("DestroyBody|Teleport|Carry|SwapPoses|SetType|SetEnabled|SetAwake|SetBullet|Throw|Push|"
                     "AddFixtureToSome|DestroyFixture|ReplaceFixture|ExchangeFixtures|SetFilter|SetMaterial|"
                     "ChangeRadiusInPlace|ResizeInPlace|NudgeShapeInPlace|SetMass|CreateCompound|CreateJoint|"
                     "DestroyJoint|ProbeContact|ReplaceBody|NudgePose");
        if (w.OnceIn(12))
            w.ActAny("ShiftOrigin|SetGravity|SetSolver|SetTimeStep|SetReactions|SetRounding");
        w.Steps(1);
    }
}

/// Fast, off their centres, turned often, asleep or filtered; the world is stepped in the midst of its steps.
void WriteWild(Writer &w) {
    const bool sleepy = w.OnceIn(3);
    w.Act("BuildLevel", {2 + 4 + 16 * static_cast<int>(w.Below(8))});
    w.Act("CreateDrums");
    w.Act("Throng", {static_cast<int>(w.Below(16)) | (sleepy ? 2 : 0),
                     sleepy ? 250 : 40 + static_cast<int>(w.Below(60)), sleepy ? 200 : 80});
    w.Act("CreateDrums");
    if (!w.OnceIn(4))
        w.Listen("steps its own world|steps its own world|steps the other world|switches bullet|shoots "
                 "another|throws it|wakes another or not|moves the centre of mass|masks all of another|sets "
                 "radius|sets filter data|disables another contact|disables|edits another shape");
    else
        w.Act("ChangeHands", {10});
    if (w.OnceIn(3))
        w.Act("SetFilterReactions");
    w.Act("SetTicks");
    for (uint32_t i = 30 + w.Below(30); i > 0; --i) {
        for (uint32_t k = w.Below(4); k > 0; --k)
            w.ActAny("DestroyBody|ReplaceBody|JoinContact|JoinContact|TurnOften|MoveCentre|Teleport|"
                     "SetEnabled|Throw|Throw|SetDensities|SetAwake|MaskBody|RestSome|SetBullet|"
                     "DisableContacts|CreateJoint|DestroyJoint");
        if (w.OnceIn(20))
            w.Act("SetTimeStep");
        w.Steps(1);
    }
}

/// Crowds that fly out and in across the places where numbers lose a bit of a millimetre.
void WriteStraying(Writer &w) {
    w.Act("Throng", {4 * static_cast<int>(w.Below(2)), 50 + static_cast<int>(w.Below(30)), 200});
    w.Act("BuildLevel", {3 + 4 + 64});
    for (int i = 0; i < 30; ++i) {
        if (i % 6 == 0)
            w.Act("Drive");
        if (w.OnceIn(6))
            w.ActAny("ShiftOrigin|MoveElsewhere|ShiftThereAndBack|SetBullet|SetSensor|Teleport");
        w.Steps(2);
    }
}

/// Sleepers on a level, shot at; they wake and rest, many of their contacts end at once and others begin.
void WriteSleepers(Writer &w) {
    w.Act("BuildLevel", {static_cast<int>(w.Below(128)) & ~2});
    for (uint32_t i = 2 + w.Below(6); i > 0; --i)
        w.Act("CreateCompound");
    w.Act("Throng", {4 + 2 * static_cast<int>(w.Below(2)), 10 + static_cast<int>(w.Below(60)),
                     static_cast<int>(w.Below(60))});
    w.Listen("puts to sleep|puts to sleep|puts to sleep|wakes another or not|shoots another|disables|masks "
             "all of another|reads contacts|switches another bullet|refilters");
    for (int i = 0; i < 60; ++i) {
        for (uint32_t k = w.Below(4); k > 0; --k)
            w.ActAny("Throw|Throw|Throw|SetAwake|SetAwake|SetBullet|Carry|MaskBody|DestroyBody|ReplaceBody|"
                     "SetType|SetSensor");
        if (w.OnceIn(6))
            w.ActAny("RestSome|RestSome|Scatter|WakeAll|SetGravity");
        w.Steps(1);
    }
}

void WriteFar(Writer &w) {
    if (w.OnceIn(2))
        WriteStraying(w);
    else
        WriteSleepers(w);
}

/// What becomes a bullet or ceases to be; in half of them nobody listens, so that most pairs may be left out.
void WriteBullets(Writer &w) {
    const char *const heard = "switches bullet|switches another bullet|shoots another|throws it|wakes "
                              "another or not|puts to sleep|pushes another|edits a shape|moves the centre of "
                              "mass|sets filter data|disables another contact|exchanges itself";
    w.Act("BuildLevel", {2 + 4 * static_cast<int>(w.Below(2)) + 16 * static_cast<int>(1 + w.Below(3))});
    w.Act("Throng", {4 * static_cast<int>(w.Below(2)), 60 + static_cast<int>(w.Below(140)),
                     70 + static_cast<int>(w.Below(50))});
    const bool listens = !w.OnceIn(3);
    if (listens)
        w.Listen(heard);
    else
        w.Act("ChangeHands", {2 + 8 * static_cast<int>(w.Below(2))});
    if (w.OnceIn(3))
        w.Act("SetFilterReactions");
    for (uint32_t i = 40 + w.Below(30); i > 0; --i) {
        for (uint32_t k = w.Below(4); k > 0; --k)
            w.ActAny("SetBullet|SetBullet|Throw|Throw|SetType|SetAwake|Teleport|SetEnabled|DestroyBody|"
                     "ReplaceBody|DisableContacts|Carry");
        if (listens && w.OnceIn(8))
            w.Listen(heard);
        if (w.OnceIn(16))
            w.Act("ChangeHands");
        if (w.OnceIn(16))
            w.Act("SetThrowing");
        if (w.OnceIn(15))
            w.ActAny("SetTimeStep|SetSolver|SetRounding");
        if (w.OnceIn(60))
            w.Act("FillAgain", {4, 100});
        w.Steps(1);
    }
}

/// Pairs that have long been apart, and what changes the answer that they are known to have: at any place.
void WriteSurprises(Writer &w) {
    w.Act("CreateDrums", {3 + 4 * static_cast<int>(w.Below(8))});
    w.Steps(1);
    w.Act("CreatePairs", {27});
    w.Steps(1);
    w.Act("CreateDrums", {2 + 32 + 4 * static_cast<int>(w.Below(8))});
    w.Act("SetTicks", {static_cast<int>(w.Below(8)) + 8 * static_cast<int>(w.Below(4))});
    w.Steps(10 + w.Below(4));
    if (w.OnceIn(2))
        w.Act("RestSome");
    for (uint32_t i = 24 + w.Below(24); i > 0; --i) {
        if (w.OnceIn(3))
            w.ActAny("Carry|Carry|ThereAndBack|SetVelocity|Throw|Push|MoveCentre|SetDensities|SetAwake|"
                     "SetSensor|MaskBody|SetFilter|SetRefusals|DisableContacts|SetBullet|EditAllInPlace|"
                     "EditAllInPlace|ResizeInPlace|ChangeRadiusInPlace|SetSolver|SetGravity|SetTimeStep|"
                     "ShiftOrigin|ShiftThereAndBack|JoinContact|AddFixtureToSome|ReplaceFixture|"
                     "ExchangeFixtures|DestroyFixture|DestroyBody|ReplaceBody|SetType|SetEnabled|SetFreedoms|"
                     "ChangeHands|RestSome|WakeAll");
        if (w.OnceIn(6))
            w.Listen("steps its own world|throws it|shoots another|pushes another|wakes another or not|puts "
                     "to sleep|makes a sensor or solid, with care|masks all of "
                     "another|refilters|disables|disables all of another|switches another bullet|edits "
                     "another shape|edits a shape|makes a box of it|sets radius|shifts another's "
                     "shapes|shifts another's shapes|shifts its shapes|moves the centre of mass|sets the "
                     "world's solver|reads contacts|reads edges|exchanges itself|ends, makes, moves between "
                     "steps|puts bodies out of the world|tries what is refused|evaluates|asks for distances");
        w.Steps(1);
    }
}

/// Bodies that are sent where numbers are none, among others, and put back.
void WriteNowhere(Writer &w) {
    w.Act("BuildLevel", {2 + 4 + 16 * static_cast<int>(w.Below(3))});
    w.Act("Throng", {0, 10 + static_cast<int>(w.Below(60)), 30 + static_cast<int>(w.Below(60))});
    w.Act("CreatePairs", {27});
    if (w.OnceIn(2))
        w.Act("ChangeHands", {10});
    else
        w.Listen("disables|reads contacts|throws it|edits a shape|wakes another or not");
    w.Steps(4);
    for (uint32_t i = 30 + w.Below(20); i > 0; --i) {
        if (w.OnceIn(4))
            w.Act("SendNowhere");
        for (uint32_t k = w.Below(3); k > 0; --k)
            w.ActAny("SendNowhere|PutBack|Teleport|Throw|Carry|SetType|SetEnabled|SetAwake|DestroyBody|"
                     "ReplaceBody|AddFixtureToSome|DestroyFixture|ResizeInPlace|AskWorld|ProbeContact|"
                     "ShiftOrigin|Scatter");
        w.Steps(1 + w.Below(2));
    }
}

} // namespace

std::vector<uint8_t> BytesOf(uint32_t seed) {
    struct Kind {
        uint8_t flags;
        void (*write)(Writer &);
    };
    static constexpr Kind kNowhere = {kLarge | kWeightless, WriteNowhere};
    static constexpr Kind kKinds[] = {
        {0, WriteSmall},
        {kLarge, WriteArena},
        {kLarge | kWeightless, WriteWild},
        {kLarge, WriteBullets},
        {kLarge | kWeightless, WriteSurprises},
        {kLarge | kWeightless, WriteArena},
        {kBin, WriteSmall},
        {kLarge, WriteFar},
        {kLarge, WriteSurprises},
        {kLarge | kWeightless, WriteBullets},
        {kWeightless, WriteRows},
        {kLarge | kWeightless, WriteWild},
    };
    constexpr uint32_t kKindCount = sizeof kKinds / sizeof *kKinds;
    const Kind &kind = seed % 25 == 24 ? kNowhere : kKinds[seed % kKindCount];
    Writer w(seed);
    int flags = kind.flags;
    if (w.OnceIn(8))
        flags ^= kWeightless;
    if (w.OnceIn(12))
        flags |= kSubStepping;
    if (kind.write == WriteSmall && w.OnceIn(8))
        flags |= kAnySize;
    // How far away; the spread of 1 m is for arenas.
    const int far = w.OnceIn(3) || kind.write == WriteFar ? static_cast<int>(w.Below(16)) : 0;
    w.Put({flags, kind.write == WriteSmall  ? far + 64 * static_cast<int>(w.Below(4))
                  : kind.write == WriteRows ? 0
                                            : far + 64});
    kind.write(w);
    return w.bytes;
}

} // namespace actor
