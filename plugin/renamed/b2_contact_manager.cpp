// SPDX-License-Identifier: MIT
// See b2_world.cpp.
#include "box2d/b2_body.h"
#include "box2d/b2_broad_phase.h"
#include "box2d/b2_contact.h"
#include "box2d/b2_fixture.h"
#include "box2d/b2_world_callbacks.h"

#define FindNewContacts BmrStockFindNewContacts
#define Destroy(parameter)                                                                                   \
    Destroy(parameter);                                                                                      \
    void BmrStockDestroy(parameter)
#include "box2d/b2_contact_manager.h"
#undef Destroy

// b2ContactManager::Destroy is called by Collide; b2Contact::Destroy(c, allocator) by it.
#define Destroy(...) BMR_DESTROY_##__VA_ARGS__)
#define BMR_DESTROY_b2Contact BmrStockDestroy(b2Contact
#define BMR_DESTROY_cNuke Destroy(cNuke
#define BMR_DESTROY_c Destroy(c
#include BMR_BOX2D_SOURCE
#undef FindNewContacts
#undef Destroy
