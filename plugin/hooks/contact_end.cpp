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
#include "reach/real.h"
#include "start/settings.h"

namespace bmr::hooks {

namespace {

Real<void(b2ContactManager *, b2Contact *)> realDestroy("_ZN16b2ContactManager7DestroyEP9b2Contact");
Real<void(b2Fixture *)> realRefilter("_ZN9b2Fixture8RefilterEv");
Real<void(b2Fixture *, const b2Filter &)> realSetFilterData("_ZN9b2Fixture13SetFilterDataERK8b2Filter");
Real<b2Joint *(b2World *, const b2JointDef *)> realCreateJoint("_ZN7b2World11CreateJointEPK10b2JointDef");
Real<void(b2World *, b2Joint *)> realDestroyJoint("_ZN7b2World12DestroyJointEP7b2Joint");
Real<void(b2World *, b2Body *)> realDestroyBody("_ZN7b2World11DestroyBodyEP6b2Body");
Real<void(b2World *)> realEndWorld("_ZN7b2WorldD1Ev");
Real<void(b2World *)> realEndBaseWorld("_ZN7b2WorldD2Ev");

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

void Destroy(b2ContactManager *manager, b2Contact *contact)
    BMR_STANDS_FOR("_ZN16b2ContactManager7DestroyEP9b2Contact");

void Destroy(b2ContactManager *manager, b2Contact *contact) {
    if (NothingIsInstalled())
        return realDestroy(manager, contact);
    HookIsOn(Hook::Ledger); // reached
    Ledger *ledger = FindLedger(manager);
    if (ledger == nullptr) {
        realDestroy(manager, contact);
        return;
    }
    // The listener that is told of its end may step the world, or end other contacts: numbers stay.
    Ledger::Pass pass(ledger);
    const uint32_t number = ledger->FindNumber(contact);
    realDestroy(manager, contact);
    ledger->Remove(number, contact);
    pass.Complete();
}

void Refilter(b2Fixture *fixture) BMR_STANDS_FOR("_ZN9b2Fixture8RefilterEv");

void Refilter(b2Fixture *fixture) {
    realRefilter(fixture);
    NoteFiltering(fixture->GetBody());
}

void SetFilterData(b2Fixture *fixture, const b2Filter &filter)
    BMR_STANDS_FOR("_ZN9b2Fixture13SetFilterDataERK8b2Filter");

void SetFilterData(b2Fixture *fixture, const b2Filter &filter) {
    realSetFilterData(fixture, filter);
    NoteFiltering(fixture->GetBody());
}

b2Joint *CreateJoint(b2World *world, const b2JointDef *def)
    BMR_STANDS_FOR("_ZN7b2World11CreateJointEPK10b2JointDef");

b2Joint *CreateJoint(b2World *world, const b2JointDef *def) {
    b2Joint *joint = realCreateJoint(world, def);
    if (joint != nullptr)
        NoteFiltering(joint->GetBodyB());
    return joint;
}

void DestroyJoint(b2World *world, b2Joint *joint) BMR_STANDS_FOR("_ZN7b2World12DestroyJointEP7b2Joint");

void DestroyJoint(b2World *world, b2Joint *joint) {
    b2Body *const body = joint != nullptr ? joint->GetBodyB() : nullptr;
    realDestroyJoint(world, joint);
    NoteFiltering(body);
}

void DestroyBody(b2World *world, b2Body *body) BMR_STANDS_FOR("_ZN7b2World11DestroyBodyEP6b2Body");

void DestroyBody(b2World *world, b2Body *body) {
    if (Ledger *ledger = FindLedger(&world->GetContactManager())) {
        ledger->GetBodies().Forget();
        ledger->SetAwakeAlone(0);
    }
    realDestroyBody(world, body);
}

void EndWorld(b2World *world) BMR_STANDS_FOR("_ZN7b2WorldD1Ev");

void EndWorld(b2World *world) {
    DropLedger(&world->GetContactManager());
    realEndWorld(world);
}

void EndBaseWorld(b2World *world) BMR_STANDS_FOR("_ZN7b2WorldD2Ev");

void EndBaseWorld(b2World *world) {
    DropLedger(&world->GetContactManager());
    realEndBaseWorld(world);
}

} // namespace bmr::hooks
