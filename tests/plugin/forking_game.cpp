// SPDX-License-Identifier: MIT
// A game that forks: forking_game EARLIER LATER. It steps EARLIER times, forks, and both go on for LATER
// steps. Each prints what happened; the child first.
#include <cstdlib>

#include <sys/wait.h>
#include <unistd.h>

#include "../kit/small_world.h"

int main(int argc, char **argv) {
    if (argc < 3)
        return 2;
    const int earlier = std::atoi(argv[1]), later = std::atoi(argv[2]);
    b2World world(b2Vec2(0.0f, -10.0f));
    FillWithBoxes(world);
    AddWheel(world, {0.0f, 16.0f}, 16, 1.0f);
    AddWheel(world, {0.4f, 18.5f}, 16, 1.0f);
    Hash hash;
    Step(world, earlier, &hash);
    const pid_t child = fork();
    if (child < 0)
        return 3;
    if (child == 0) {
        Step(world, 1, &hash); // one more than its parent
        Step(world, later, &hash);
        Print("child", hash);
        std::exit(0);
    }
    int status = 0;
    if (waitpid(child, &status, 0) != child || status != 0)
        return 4;
    Step(world, later, &hash);
    Print("parent", hash);
    if (argc > 3)
        _exit(0);
    return 0;
}
