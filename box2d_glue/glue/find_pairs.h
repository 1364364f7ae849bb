// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_FIND_PAIRS_H
#define BOOMERANG_GLUE_FIND_PAIRS_H

class b2ContactManager;

namespace bmr {

/// b2ContactManager::FindNewContacts: pairs of proxies whose fat boxes have come to overlap. The same
/// contacts are made in the same order, and the same filters asked. Pairs are found by tree/pair_descent.h;
/// contacts that exist already, in the ledger's table of pairs, where Box2D walks over the body's list.
void FindNewContacts(b2ContactManager *manager);

} // namespace bmr

#endif
