// SPDX-License-Identifier: MIT
// A control: locks that do not lock. Linked into a program of this room, they stand in front of libc's.
#include <pthread.h>

__attribute__((visibility("default"))) int pthread_mutex_lock(pthread_mutex_t *mutex) {
    (void)mutex;
    return 0;
}

__attribute__((visibility("default"))) int pthread_mutex_unlock(pthread_mutex_t *mutex) {
    (void)mutex;
    return 0;
}
