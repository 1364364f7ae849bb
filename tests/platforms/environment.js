// SPDX-License-Identifier: MIT
// A program in node finds the variables of Boomerang's that node was started with.
var Module = {
    preRun: [function() {
        for (const name in process.env)
            if (name.startsWith('BOOMERANG'))
                ENV[name] = process.env[name];
    }]
};
