// SPDX-License-Identifier: MIT
#include "workers.h"
#include "world_command.h"
namespace testbed {
nlohmann::json MeasurePeers(const WorldCommand & /*command*/, const Workers & /*workers*/) {
    return {};
}
} // namespace testbed
