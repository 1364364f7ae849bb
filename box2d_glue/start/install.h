// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_INSTALL_H
#define BOOMERANG_GLUE_INSTALL_H

namespace bmr {

/// Has anybody called Install, whatever came of it? Then whoever starts by himself leaves it at that.
bool InstallWasCalled();

} // namespace bmr

#endif
