// SPDX-License-Identifier: MIT
// In an object file of its own, which a linker takes out of an archive only where nobody else has the
// function.
#include "strange_box2d.h"

void b2TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input) {
    output->t = input->tMax;
}
