// SPDX-License-Identifier: MIT
// What a library does to a program with Box2D inside when linkers see its function: they take it for Box2D's
// own.
struct b2TOIInput;
struct b2TOIOutput;
void b2TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input);

void b2TimeOfImpact(b2TOIOutput *, const b2TOIInput *) {}
