// SPDX-License-Identifier: MIT
#include "scenes/gas.h"

#include <fstream>
#include <stdexcept>

#include "shapes.h"

namespace testbed {
namespace {

struct Molecule {
    Outline outline;
    b2Vec2 position, velocity;
    float angle, spin;
};

struct GasFile {
    int steps = 0;
    float timeStep = 0.0f;
    bool hasBox = false;
    b2Vec2 low, high;
    std::vector<Molecule> bodies;
};

/// The scene is made by a function without arguments.
GasFile loadedGas;

std::istream &operator>>(std::istream &stream, b2Vec2 &v) {
    return stream >> v.x >> v.y;
}

GasFile ReadGas(const std::string &file) {
    std::ifstream stream(file);
    const auto require = [&](bool good, const char *what) {
        if (!good || !stream)
            throw std::runtime_error(file + ": " + what);
    };
    GasFile gas;
    std::string word;
    size_t count = 0;
    stream >> word >> gas.steps >> gas.timeStep >> count;
    require(word == "gas" && gas.steps > 0 && gas.timeStep > 0.0f,
            "does not begin with \"gas STEPS TIMESTEP COUNT\"");
    stream >> word;
    gas.hasBox = word == "box";
    if (gas.hasBox)
        stream >> gas.low >> gas.high;
    require(gas.hasBox || word == "open", "has neither a box nor \"open\"");
    gas.bodies.resize(count);
    for (Molecule &body : gas.bodies) {
        size_t vertices = 0;
        stream >> word >> vertices;
        require(word == "body" && vertices >= 3, "a body is missing");
        body.outline.resize(vertices);
        for (b2Vec2 &vertex : body.outline)
            stream >> vertex;
        stream >> body.position >> body.angle >> body.velocity >> body.spin;
        require(true, "a body ends too early");
    }
    return gas;
}

class Gas final : public Scene {
    void Build(Stage &stage, int /*size*/) override {
        stage.World().SetGravity({0.0f, 0.0f});
        for (const Molecule &body : loadedGas.bodies) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.bullet = true;
            def.allowSleep = false;
            def.position = body.position;
            def.angle = body.angle;
            def.linearVelocity = body.velocity;
            def.angularVelocity = body.spin;
            AddConvex(stage, stage.AddBody(def), body.outline, Material(1.0f, 0.0f, 1.0f));
        }
        if (!loadedGas.hasBox)
            return;
        b2Body *box = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        const b2Vec2 corners[] = {loadedGas.low,
                                  {loadedGas.high.x, loadedGas.low.y},
                                  loadedGas.high,
                                  {loadedGas.low.x, loadedGas.high.y}};
        for (int i = 0; i < 4; ++i)
            stage.AddFixture(box, Material(0.0f, 0.0f, 1.0f), MakeEdge(corners[i], corners[(i + 1) % 4]));
    }
};

} // namespace

SceneInfo GasScene(const std::string &file) {
    loadedGas = ReadGas(file);
    return SceneOfAFile("gas", "elastic bullets in a box", loadedGas.steps, loadedGas.timeStep,
                        CreateScene<Gas>);
}

} // namespace testbed
