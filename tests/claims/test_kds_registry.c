// SPDX-License-Identifier: MIT
#include "boomerang/kds.h"
#include "checks.h"

TEST(every_structure_is_found_by_its_name_alone) {
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = NULL;
        assert_int_equal(bmr_kds_find(bmr_kds_at(i)->name, &info), BMR_OK);
        assert_ptr_equal(info, bmr_kds_at(i));
        for (size_t j = 0; j < i; ++j)
            assert_string_not_equal(bmr_kds_at(j)->name, bmr_kds_at(i)->name);
    }
    assert_null(bmr_kds_at(bmr_kds_count()));
}

TEST(a_wrong_name_is_told_with_the_names_there_are) {
    static const char *const wrong[] = {"", "lazy", "lazy-dk", "Lazy-Dudley", "lazy-dudley ", "predict-"};
    const bmr_kds_info *const untouched = bmr_kds_at(3);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        const bmr_kds_info *info = untouched;
        assert_int_equal(bmr_kds_find(wrong[i], &info), BMR_ERROR_UNKNOWN_NAME);
        assert_ptr_equal(info, untouched);
        char text[1024];
        assert_true(bmr_kds_describe_unknown(wrong[i], text, sizeof text) < sizeof text);
        char quoted[32] = "\"";
        strcat(strcat(quoted, wrong[i]), "\"");
        assert_non_null(strstr(text, quoted));
        for (size_t k = 0; k < bmr_kds_count(); ++k)
            assert_non_null(strstr(text, bmr_kds_at(k)->name));
    }
    const bmr_kds_info *info = untouched;
    assert_int_equal(bmr_kds_find(NULL, &info), BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_kds_find("hybrid", NULL), BMR_ERROR_NULL_ARGUMENT);
    assert_ptr_equal(info, untouched);
}

TEST(the_sentence_fits_what_it_is_given) {
    char whole[1024], part[64];
    const size_t length = bmr_kds_describe_unknown("x", whole, sizeof whole);
    assert_int_equal(length, strlen(whole));
    assert_int_equal(bmr_kds_describe_unknown("x", NULL, 0), length);
    assert_int_equal(bmr_kds_describe_unknown("x", NULL, 64), length);
    for (size_t size = 0; size <= sizeof part; ++size) {
        memset(part, '#', sizeof part);
        assert_int_equal(bmr_kds_describe_unknown("x", part, size), length);
        if (size > 0) {
            assert_memory_equal(part, whole, size - 1);
            assert_int_equal(part[size - 1], 0);
        }
        for (size_t i = size; i < sizeof part; ++i)
            assert_int_equal(part[i], '#');
    }
    char longer[200];
    memset(longer, 'y', sizeof longer - 1);
    longer[sizeof longer - 1] = 0;
    assert_int_equal(bmr_kds_describe_unknown(longer, NULL, 0), length + 63); // 64 bytes of it, in place of 1
    assert_true(bmr_kds_describe_unknown(NULL, whole, sizeof whole) == length - 1);
}
