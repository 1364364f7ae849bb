// SPDX-License-Identifier: MIT
// A program in node finds the variables of Boomerang's that node was started with. (One that asks for none has no ENV.)
var Module = {
    preRun: [function() {
        for (const name in process.env)
            if (name.startsWith('BOOMERANG') && typeof ENV !== 'undefined')
                ENV[name] = process.env[name];
    }]
};
