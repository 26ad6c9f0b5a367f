#!/bin/sh
# Runs the installed program from the folder / without any environment variable, and expects of it
# what the built program prints: installed_test.sh INSTALLED BUILT SCRATCH
set -eu
installed=$1 built=$2 scratch=$3

printf 'wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n0,0,1,0,0,1\n0.6,0,0.8,-0.6,0,0.8\n' >"$scratch/queries.csv"
cd /
env -i "$installed" doctor >"$scratch/doctor.txt"
for backend in reference cpp vulkan; do
    evaluate="eval --material lacquered_wood --queries $scratch/queries.csv --backend $backend"
    env -i "$installed" $evaluate >"$scratch/installed.csv"
    "$built" $evaluate >"$scratch/built.csv"
    cat "$scratch/installed.csv"
    cmp "$scratch/installed.csv" "$scratch/built.csv"
    test "$(wc -l <"$scratch/installed.csv")" = 3
done
