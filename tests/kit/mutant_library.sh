# SPDX-License-Identifier: MIT
# Sourced by scripts that take something out of the shared library and look who notices. They set root (of the
# sources), compiler, flags (of the compiler), linked (more flags, of the linker) and the arrays objects (those of the
# shared library) and link (what else it is linked from).
# shellcheck shell=bash disable=SC2154,SC2086

# mutate PLACE FILE UNIT SUBSTITUTION: makes PLACE/libmutant.so, with the (perl) substitution in FILE and UNIT compiled
# anew; says why where it cannot.
mutate() {
    local place=$1 file=$2 unit=$3 others=()
    mkdir "$place"
    for part in box2d_glue plugin core; do cp -r "$root/$part" "$place/$part"; done
    perl -0pi -e "$4" "$place/$file"
    if [ -n "$4" ] && cmp -s "$root/$file" "$place/$file"; then
        echo "the substitution finds nothing in $file"
        return 1
    fi
    for object in "${objects[@]}"; do
        case $object in */"$unit".o | */"$(basename "$unit")".o) ;; *) others+=("$object") ;; esac
    done
    $compiler $flags -I"$place/core/include" -I"$place/core" -I"$place/box2d_glue" -I"$place/box2d_glue/include" -I"$place/plugin" \
        -I"$place/plugin/include" -include "$place/plugin/reach/interposed/weak_box2d.h" -c "$place/$unit" -o "$place/mutant.o" &&
        $compiler -shared ${linked:-} -o "$place/libmutant.so" "$place/mutant.o" "${others[@]}" "${link[@]}" \
            -Wl,--version-script="$place/plugin/reach/interposed/exports.map"
}
