// SPDX-License-Identifier: MIT
#ifndef BMR_OUTLINE_SIMPLIFY_H
#define BMR_OUTLINE_SIMPLIFY_H

#include "outline/rings.h"

/// The work of bmr_outline_simplify, of rings that are linked. Errors: those of bmr_sweep (a fault, which
/// goes to *fault; NO_MEMORY).
bmr_error bmr_simplify(const bmr_ring_links *links, double tolerance, const bmr_allocator *allocator,
                       uint32_t *kept, uint32_t *counts, bmr_outline_fault *fault);

#endif
