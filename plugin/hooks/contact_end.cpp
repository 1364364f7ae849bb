// SPDX-License-Identifier: MIT
// What ends a contact or has it filtered anew, which nobody would see by looking at bodies and fixtures: told
// to the world's ledger.
//
//   b2ContactManager::Destroy                   the contact's record goes with it
//   b2Fixture::Refilter and SetFilterData,      contacts that are flagged for filtering are due
//   b2World::CreateJoint and DestroyJoint
//   b2World::DestroyBody                        the list of bodies is another one
//   b2World::~b2World                           the ledger goes with it
//
// b2Fixture::SetFilterData calls Refilter within its own object file: where Box2D is built so that such calls
// are bound (clang's way, -fno-semantic-interposition) or linked with --wrap, that one does not come by here.
#include <box2d/b2_contact.h>
#include <box2d/b2_contact_manager.h>
#include <box2d/b2_joint.h>
#include <box2d/b2_world.h>

#include "contacts/solid_contact.h"
#include "ledger/ledger.h"
#include "ledger/ledgers.h"
#include "reach/stock.h"
#include "start/settings.h"

namespace bmr::hooks {

namespace {

void NoteFiltering(const b2Body *body) {
    if (body == nullptr || body->GetWorld() == nullptr)
        return;
    Ledger *ledger = FindLedger(&body->GetWorld()->GetContactManager());
    if (ledger == nullptr)
        return;
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        if (SolidContact::WantsFiltering(*edge->contact))
            ledger->Flag(edge->contact, kToBeFiltered);
}

} // namespace

void NoteWorldEnds(b2World *world) {
    DropLedger(&world->GetContactManager());
}

} // namespace bmr::hooks

using namespace bmr;
using namespace bmr::hooks;

BMR_FOR_LOADERS("_ZN16b2ContactManager7DestroyEP9b2Contact");
BMR_FOR_LOADERS("_ZN9b2Fixture8RefilterEv");
BMR_FOR_LOADERS("_ZN9b2Fixture13SetFilterDataERK8b2Filter");
BMR_FOR_LOADERS("_ZN7b2World11CreateJointEPK10b2JointDef");
BMR_FOR_LOADERS("_ZN7b2World12DestroyJointEP7b2Joint");
BMR_FOR_LOADERS("_ZN7b2World11DestroyBodyEP6b2Body");

void b2ContactManager::Destroy(b2Contact *contact) {
    if (NothingIsInstalled())
        return stock::Destroy(this, contact);
    HookIsOn(Hook::Ledger); // reached
    Ledger *ledger = FindLedger(this);
    if (ledger == nullptr) {
        stock::Destroy(this, contact);
        return;
    }
    // The listener that is told of its end may step the world, or end other contacts: numbers stay. And it
    // may make others, which get the proxies of a body that is being put out of the world.
    Ledger::Ending pass(ledger);
    const uint32_t number = ledger->FindNumber(contact);
    ledger->NoteLostProxies(number, *contact);
    stock::Destroy(this, contact);
    ledger->Remove(number, contact);
    pass.Complete();
}

void b2Fixture::Refilter() {
    stock::Refilter(this);
    NoteFiltering(GetBody());
}

void b2Fixture::SetFilterData(const b2Filter &filter) {
    stock::SetFilterData(this, filter);
    NoteFiltering(GetBody());
}

b2Joint *b2World::CreateJoint(const b2JointDef *def) {
    b2Joint *joint = stock::CreateJoint(this, def);
    // Box2D goes by the definition: a gear joint's bodies are other ones.
    if (joint != nullptr)
        NoteFiltering(def->bodyB);
    return joint;
}

void b2World::DestroyJoint(b2Joint *joint) {
    b2Body *const body = joint != nullptr ? joint->GetBodyB() : nullptr;
    stock::DestroyJoint(this, joint);
    NoteFiltering(body);
}

void b2World::DestroyBody(b2Body *body) {
    if (Ledger *ledger = FindLedger(&m_contactManager))
        ledger->GetBodies().Forget();
    stock::DestroyBody(this, body);
}
