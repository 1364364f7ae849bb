// SPDX-License-Identifier: MIT
#include "scene.h"

namespace testbed {

void Scene::BeforeStep(Stage &, int) {}
void Scene::OnBegin(b2Contact &) {}
void Scene::OnEnd(b2Contact &) {}
void Scene::OnPreSolve(b2Contact &, const b2Manifold &) {}
void Scene::OnPostSolve(b2Contact &, const b2ContactImpulse &) {}
void Scene::OnGoodbye(b2Joint &) {}

} // namespace testbed
