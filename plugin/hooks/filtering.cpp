// SPDX-License-Identifier: MIT
// b2Fixture::Refilter and SetFilterData, b2World::CreateJoint and DestroyJoint: contacts that these flag for
// filtering are due. (SetFilterData's own call of Refilter does not reach this hook where Box2D's compiler
// binds it within its object file, as clang does, or where it is linked with --wrap.)
#include <box2d/b2_fixture.h>
#include <box2d/b2_joint.h>
#include <box2d/b2_world.h>

#include "contacts/solid_contact.h"
#include "reach/stock.h"
#include "world/ledger.h"
#include "world/ledgers.h"

using namespace bmr;

namespace {

void NoteFiltering(const b2Body *body) {
    const b2World *const world = body != nullptr ? body->GetWorld() : nullptr;
    Ledger *ledger = world != nullptr ? FindLedger(&world->GetContactManager()) : nullptr;
    if (ledger == nullptr)
        return;
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        if (SolidContact::WantsFiltering(*edge->contact))
            ledger->Flag(edge->contact, kToBeFiltered);
}

} // namespace

BMR_FOR_LOADERS("_ZN9b2Fixture8RefilterEv");
BMR_FOR_LOADERS("_ZN9b2Fixture13SetFilterDataERK8b2Filter");
BMR_FOR_LOADERS("_ZN7b2World11CreateJointEPK10b2JointDef");
BMR_FOR_LOADERS("_ZN7b2World12DestroyJointEP7b2Joint");

void b2Fixture::Refilter() {
    if (!AnyLedger())
        return stock::Refilter(this);
    stock::Refilter(this);
    NoteFiltering(GetBody());
}

void b2Fixture::SetFilterData(const b2Filter &filter) {
    if (!AnyLedger())
        return stock::SetFilterData(this, filter);
    stock::SetFilterData(this, filter);
    NoteFiltering(GetBody());
}

b2Joint *b2World::CreateJoint(const b2JointDef *def) {
    b2Joint *joint = stock::CreateJoint(this, def);
    if (!AnyLedger()) // whose user data may have any size in a Box2D that is not known
        return joint;
    // Box2D reads the definition: a gear joint's own bodies are other ones.
    NoteFiltering(joint != nullptr ? def->bodyB : nullptr);
    return joint;
}

void b2World::DestroyJoint(b2Joint *joint) {
    b2Body *const body = joint != nullptr ? joint->GetBodyB() : nullptr;
    stock::DestroyJoint(this, joint);
    NoteFiltering(body);
}
