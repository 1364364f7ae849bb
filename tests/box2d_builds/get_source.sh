#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   get_source.sh PLACE
#
# Leaves Debian's source of the Box2D that is installed here in PLACE/source. A second call finds it there and asks nobody.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/../../tools/debian_source.sh" libbox2d-dev box2d src/dynamics/b2_world.cpp "${1:?}"
