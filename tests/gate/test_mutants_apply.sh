#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_mutants_apply.sh ROOT
#
# The gate takes out some of the pieces that the lists of mutants name, a long run all of them. That each still finds its place
# in the sources, and is there once by its name, is looked at here, for all lists at once.
set -u
root=$1
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

# check ROOT: a line for each row that is amiss; at last how many rows there are
check() {
    perl - "$1" <(cd "$1" && find tests -name '*mutants*.txt' | LC_ALL=C sort) <<'PERL'
use strict;
my ($root, $lists) = @ARGV;
my ($rows, %text) = (0);
sub slurp { my $name = shift; local $/; open my $in, '<', $name or return undef; return scalar <$in> }
for my $list (split /\n/, slurp($lists)) {
    # Where the files of a list are, if it names no unit beside them.
    my $folder = $list =~ m{/(core|world)_mutants} ? 'core/' : 'box2d_glue/';
    my %names;
    for my $row (split /\n/, slurp("$root/$list")) {
        next if $row eq '' || $row =~ /^#/;
        ++$rows;
        my ($name, $file, @rest) = split /@/, $row;
        my $direct = $rest[0] =~ /^s\W/;
        my $substitution = $direct ? $rest[0] : $rest[1];
        $file = "$folder$file" if $direct;
        $text{$file} = slurp("$root/$file") unless exists $text{$file};
        print "$list: $name: there twice\n" if $names{$name}++;
        if (!defined $text{$file}) {
            print "$list: $name: no file $file\n";
            next;
        }
        local $_ = $text{$file};
        eval "$substitution; 1" or print "$list: $name: $@";
        print "$list: $name: finds nothing in $file\n" if $_ eq $text{$file};
    }
}
print "$rows rows\n";
PERL
}

found=$(check "$root")
echo "$found"
failed=0
[ "$(echo "$found" | wc -l)" -eq 1 ] || failed=1
[ "${found%% *}" -ge 200 ] || {
    echo "FAILED: these are not all lists"
    failed=1
}

# The controls: a copy in which one thing is wrong. control WHAT PATTERN FILE SUBSTITUTION
mkdir -p "$room/tests"
cp -r "$root/core" "$root/box2d_glue" "$root/plugin" "$room"
(cd "$root" && find tests -name '*mutants*.txt' -exec cp --parents {} "$room" \;)
control() {
    cp "$room/$3" "$room/kept"
    perl -0pi -e "$4" "$room/$3"
    if cmp -s "$room/kept" "$room/$3"; then
        echo "FAILED: the control '$1' changes nothing"
        failed=1
    elif ! check "$room" | grep -q -e "$2"; then
        echo "FAILED: not noticed: $1"
        failed=1
    fi
    cp "$room/kept" "$room/$3"
}
control 'a line that was written otherwise' 'hooks/mutants_long.txt: nothing moves: finds nothing' box2d_glue/ledger/movers.cpp \
    's/bmr_mover_look\(&mover/bmr_mover_look(\& mover/'
control 'a file that is elsewhere' 'no file box2d_glue/contacts/gone.cpp' tests/controls/mutants.txt 's/pair_registry.cpp/gone.cpp/'
# shellcheck disable=SC2016 # Perl's
control 'half a substitution' 'hooks/mutants.txt: .*not terminated' tests/hooks/mutants.txt 's/( HasNoImpact\(contact\);)\//$1/'
# shellcheck disable=SC2016
control 'a name that is there twice' 'core_mutants.txt: .*: there twice' tests/controls/core_mutants.txt 's/\n([a-z][^\n]*\n)/\n$1$1/'
[ "$failed" -eq 0 ] && echo "passed"
exit "$failed"
